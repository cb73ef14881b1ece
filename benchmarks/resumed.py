"""A large map that is fitted, killed midway by SIGKILL, and fitted to its end by the same command; its bits beside those of fits that nobody interrupted.

usage: python benchmarks/resumed.py [--size 2048] [--times 8] [--lights 12] [--work out/bench] [--map MAP.zarr]

The map is simulated unless one is given: at 2048 x 2048 x 8 it takes 10 GB of disk, and the fits 2 GB.  Prints Markdown.
"""

from __future__ import annotations

import argparse
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

import numpy as np

from motes import maps
from motes.fitting.texels import TexelFit
from motes.maps.chunks import there
from motes.maps.fitted import FittedMap, open_fitted
from motes.maps.work import fit_block, read_block
from motes.maps.zarrs import size_on_disk

MIDWAY = 0.4  # of the blocks
COMPARED = 24  # blocks, from all over the map; and all that were at work when the process was killed
COMMAND = "from motes.cli.main import main; main()"


class Run(NamedTuple):
    """A process from start to end: wall and processor seconds, peak memory [bytes], exit code."""

    seconds: float
    processor: float
    peak: float
    code: int


def run(arguments: list[str], done: Path, counts: tuple[int, int] | None, stop: int) -> Run:
    """Run the command; kill it once so many blocks are done, never for 0."""
    began = time.perf_counter()
    child = subprocess.Popen([sys.executable, "-c", COMMAND, *arguments], stdout=subprocess.DEVNULL)
    while stop:
        time.sleep(0.05)
        if counts is not None and there(done, counts).sum() >= stop:
            os.kill(child.pid, signal.SIGKILL)
            break
        if child.poll() is not None:
            raise SystemExit("the fit ended before it was killed: take a larger map")
    _, code, used = os.wait4(child.pid, 0)
    child.returncode = code
    return Run(
        time.perf_counter() - began,
        used.ru_utime + used.ru_stime,
        1024.0 * used.ru_maxrss,
        os.waitstatus_to_exitcode(code),
    )


def same(fitted: FittedMap, block: tuple[int, int], fit: TexelFit) -> bool:
    """Whether the store holds a block's fits, bit for bit."""
    where = fitted.blocks.slices(block)
    for name, v in fitted.variables.items():
        for stored, part in ((name, fit.x), (f"{name}_stderr", fit.stderr), (f"{name}_verdict", fit.verdicts)):
            expected = part[:, list(v.columns)]
            if np.asarray(fitted.read_map(stored, where)).tobytes() != np.ascontiguousarray(expected).tobytes():
                return False
    return np.asarray(fitted.read_map("status", where)).tobytes() == fit.status.tobytes()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--size", type=int, default=2048)
    parser.add_argument("--times", type=int, default=8)
    parser.add_argument("--lights", type=int, default=12)
    parser.add_argument("--work", type=Path, default=Path(__file__).resolve().parents[1] / "out" / "bench")
    parser.add_argument("--map", type=Path)
    a = parser.parse_args()
    a.work.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=a.work) as folder:
        source = a.map or Path(folder) / "map.zarr"
        if a.map is None:
            began = time.perf_counter()
            maps.simulate_map(source, (a.size, a.size), times=a.times, lights=a.lights)
            peak = 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
            print(f"- simulated in {time.perf_counter() - began:.0f} s, peak memory {peak / 1e9:.2f} GB")
        measured(source, Path(folder) / "fit.zarr")


def measured(source: Path, out: Path) -> None:
    """Fit, kill, fit on, compare; print what was found."""
    stack = maps.open_map(source)
    counts = stack.blocks.counts
    arguments, done = ["fit", str(source), "-o", str(out), "--quiet"], out / "run" / "done"
    killed = run(arguments, done, counts, max(1, int(MIDWAY * counts[0] * counts[1])))
    kept = there(done, counts)
    rest = run(arguments, done, counts, 0)
    fitted = open_fitted(out)
    late = [block for block in fitted.blocks if not kept[block]][:3]  # at work when the process was killed
    blocks = list(dict.fromkeys([*fitted.blocks.spread(COMPARED), *late]))
    alike = sum(same(fitted, block, fit_block(fitted, read_block(fitted, block))) for block in blocks)
    ended = fitted.counts()
    fits = sum(ended.values())
    partial = len(list(out.rglob("*.partial")))
    y, x = stack.shape
    times, directions, channels = stack.sizes
    print(
        f"- {y} x {x} texels, {times} times, {directions} directions x {channels}: {size_on_disk(source) / 1e9:.1f} GB on the disk, {fits:,} fits"
    )
    for words, one, share in (("killed", killed, kept.mean()), ("the same command again", rest, 1 - kept.mean())):
        print(
            f"- {words} (exit {one.code}): {100 * share:.0f} % of {kept.size} blocks in {one.seconds:.0f} s, {one.processor:.0f} s of processor, "
            f"{1e6 * one.processor / (share * fits):.2f} µs a fit; peak memory {one.peak / 1e9:.2f} GB"
        )
    print(
        f"- {alike} of {len(blocks)} blocks are bit for bit what fits that nobody interrupted give, the {len(late)} at work at the kill among them"
    )
    print(
        f"- fits: {', '.join(f'{n:,} {name}' for name, n in ended.items() if n)}; "
        f"{size_on_disk(out) / 1e9:.2f} GB written; {partial} files half written are left"
    )
    if alike != len(blocks) or partial:
        raise SystemExit(1)


if __name__ == "__main__":
    main()
