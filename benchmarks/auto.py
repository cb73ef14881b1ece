"""Processor time of `model="auto"`, now and in another version: the clean CUReT samples, and two materials in MERL's format.

usage: python benchmarks/auto.py CHECKOUT [--rounds 3] [--data ../shared/data]

CHECKOUT is a checkout of the other version (`git worktree add --detach CHECKOUT 8b2a6d6`).  Each version has a process of its own, with one
thread of linear algebra; they take turns, measurement by measurement, and the least of all rounds counts.  The report is left out.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median

ROOT = Path(__file__).resolve().parents[1]
MATERIALS = ("pink-felt", "blue-acrylic")
# What each version runs: one line in, the path and the sample of a measurement; one line out, seconds.
SERVER = """
import sys, time
import motes
for line in sys.stdin:
    path, sample = line.split()
    data = motes.read(path, **({} if sample == "-" else {"sample": int(sample)}))
    began = time.process_time()
    motes.fit(data, model="auto")
    print(time.process_time() - began, flush=True)
"""


class Version:
    """A process that fits with the code of a checkout."""

    def __init__(self, checkout: Path, cache: str) -> None:
        one = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "NUMBA_CACHE_DIR": cache}
        environment = os.environ | one | {"PYTHONPATH": str(checkout / "src")}
        self.process = subprocess.Popen(
            [sys.executable, "-W", "ignore", "-c", SERVER],
            env=environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )

    def seconds(self, path: Path, sample: str) -> float:
        """Processor time of a fit."""
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        print(path, sample, file=self.process.stdin, flush=True)
        return float(self.process.stdout.readline())


def raced(versions: list[Version], measurements: list[tuple[Path, str]], rounds: int) -> list[list[float]]:
    """Of each version and each measurement the least of all rounds, after one that counts for nothing."""
    for version in versions:
        version.seconds(*measurements[0])
    least = [[float("inf")] * len(measurements) for _ in versions]
    for _ in range(rounds):
        for k, measurement in enumerate(measurements):
            for times, version in zip(least, versions, strict=True):
                times[k] = min(times[k], version.seconds(*measurement))
    return least


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("checkout", type=Path)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--data", type=Path, default=ROOT.parent / "shared" / "data")
    given = parser.parse_args()
    # Imported here: what the processes import is that of their checkouts.
    from motes.measurements import list_samples

    with tempfile.TemporaryDirectory() as folder:
        versions = [Version(where, str(Path(folder) / str(k))) for k, where in enumerate((given.checkout, ROOT))]
        writer = given.data.parent / "tools" / "write_merl.py"
        subprocess.run([sys.executable, writer, folder, *MATERIALS], check=True, capture_output=True)
        for title, measurements, rounds in (
            ("CUReT", [(given.data / "curet", str(k)) for k in list_samples(given.data / "curet")], given.rounds),
            ("MERL format", [(Path(folder) / f"{name}.binary", "-") for name in MATERIALS], 1),
        ):
            then, now = raced(versions, measurements, rounds)
            each = [a / b for a, b in zip(now, then, strict=True)]
            print(
                f"{title}, {len(now)} measurements: {sum(now):.1f} s against {sum(then):.1f} s in sum "
                f"({sum(now) / sum(then):.2f} times), {median(now):.2f} s against {median(then):.2f} s in the median; "
                f"{median(each):.2f} times in the median of ratios, {max(now):.2f} s at most",
                flush=True,
            )


if __name__ == "__main__":
    main()
