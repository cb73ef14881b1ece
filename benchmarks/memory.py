"""The peak memory of fits of whole maps: bounded by blocks, not by the map.

usage: python benchmarks/memory.py [--effort quick|normal|full] [--json FILE]

Each map is written by one process and fitted by another, whose peak the system tells.  ``--effort full`` takes the map of 2048 x 2048 texels
at 8 times: 9.7 GB on the disk, and a while.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from motes import MotesError
from results import Effort, Goal, Number, Section, Table, command

LIGHTS, VIEWS, CHANNELS, TIMES = 12, 2, 3, 8  # two views of every light
GOAL = 2.0  # GB
SMALLEST = 16  # texels on a side
FOLDER = (
    Path(__file__).resolve().parents[1] / "out" / "bench"
)  # not the system's for temporary files, which may be memory
SIMULATE = """
import sys
from motes.maps import simulate_map
path, size, times, lights = sys.argv[1], *map(int, sys.argv[2:])
simulate_map(path, (size, size), times=times, lights=lights)
"""
FIT = """
import json, resource, sys, time
from motes.maps import fit_map
from motes.fitting.texels import TexelStatus
start = time.perf_counter()
fitted = fit_map(sys.argv[1], out=sys.argv[2])
seconds = time.perf_counter() - start
peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * (1 if sys.platform == "darwin" else 1024)
counts = fitted.counts()
print(json.dumps({"peak": peak, "seconds": seconds, "fits": sum(counts.values()), "converged": counts["converged"]}))
"""


def stored(size: int, times: int) -> int:
    """Bytes of a map on the disk; the results take at most as much as a third of it."""
    return size * size * times * LIGHTS * VIEWS * CHANNELS * 4


def fitted(size: int, times: int, folder: Path) -> dict[str, float]:
    """Peak memory [bytes] and seconds of a fit of a simulated map.

    Raises
    ------
    MotesError
        Where the disk has no room, or a process fails.
    """
    need = stored(size, times) * 4 // 3
    if shutil.disk_usage(folder).free < 1.1 * need:
        raise MotesError(f"the disk has less than {1.1e-9 * need:.1f} GB free")
    measured, out = folder / f"{size}.zarr", folder / f"{size}-fitted.zarr"
    try:
        for code, arguments in ((SIMULATE, (measured, size, times, LIGHTS)), (FIT, (measured, out))):
            done = subprocess.run(
                [sys.executable, "-c", code, *map(str, arguments)], capture_output=True, text=True, check=False
            )
            if done.returncode != 0:
                raise MotesError(f"a process ended with code {done.returncode}: {done.stderr.strip()[-300:]}")
        return dict(json.loads(done.stdout))
    finally:
        for store in (measured, out):
            shutil.rmtree(store, ignore_errors=True)


def map_memory(effort: Effort) -> Section:
    """Maps of growing size, each in processes of its own."""
    sizes, times = effort.pick([16], [256, 512], [256, 512, 2048]), effort.pick(2, TIMES)
    figures: dict[str, Number] = {"times": Number.of([times])}
    rows: list[list[str]] = []
    skipped: list[str] = []
    FOLDER.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=FOLDER) as folder:
        if effort.name != "quick":
            fitted(SMALLEST, times, Path(folder))  # compiles the kernel, which the next processes find
        for size in sizes:
            try:
                found = fitted(size, times, Path(folder))
            except MotesError as error:
                skipped.append(f"map of {size} x {size} texels: {error.message}")
                continue
            figures |= {
                f"stored_{size}": Number.of([stored(size, times) * 1e-9]),
                f"peak_{size}": Number.of([found["peak"] * 1e-9]),
                f"seconds_{size}": Number.of([found["seconds"]]),
                f"rate_{size}": Number.of([found["fits"] / found["seconds"]]),
                f"converged_{size}": Number.of([100 * found["converged"] / found["fits"]]),
                f"share_{size}": Number.of([found["peak"] / stored(size, times)]),
            }
            names = ("stored", "peak", "share", "seconds", "rate", "converged")
            rows.append([f"{size} x {size}", *(f"{{{name}_{size}}}" for name in names)])
    done = [size for size in sizes if f"peak_{size}" in figures]
    reading = []
    if len(done) > 1:
        first, last = done[0], done[-1]
        figures["growth"] = Number.of([figures[f"peak_{last}"].median / figures[f"peak_{first}"].median])
        reading.append(
            f"From {first} x {first} to {last} x {last} texels, {(last // first) ** 2:,} times as many, the peak changes by a factor of "
            "{growth}: the memory is that of a few blocks, and of the libraries."
        )
    if 2048 not in sizes:
        reading.append(
            f"The map of 2048 x 2048 x {TIMES} takes {stored(2048, TIMES) * 1e-9:.1f} GB of disk and is made only by "
            "`make bench EFFORT=full`; the goal is checked on the largest one here."
        )
    goals = []
    if done:
        goals = [
            Goal(
                f"peak memory, map of {done[-1]} x {done[-1]} x {times}",
                f"peak_{done[-1]}",
                GOAL,
                at_least=False,
                unit=" GB",
            )
        ]
    return Section(
        title="Memory of map fits",
        made_by="benchmarks/memory.py, map_memory()",
        intro=(
            f"Simulated maps of {{times:count}} times x {LIGHTS * VIEWS} pairs of directions x {CHANNELS} channels as Zarr stores, "
            "`oren_nayar + torrance_sparrow` at every texel and time by `motes.maps.fit_map`; one run each. "
            "Peak is the largest resident set of the process, libraries and all."
        ),
        figures=figures,
        tables=[
            Table(["texels", "map on disk [GB]", "peak [GB]", "peak / map", "fit [s]", "fits/s", "converged [%]"], rows)
        ]
        if rows
        else [],
        goals=goals,
        reading=reading,
        skipped=skipped,
    )


if __name__ == "__main__":
    command(map_memory, __doc__)
