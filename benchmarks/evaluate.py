"""How fast the engine evaluates the whole dusty RGB surface and its gradient.

One process takes the candidates in turn, and the best of several rounds counts.

    python benchmarks/evaluate.py [--directions 10_000_000] [--rounds 7]

Machines differ and are busy, so look at the ratios: to copying as many bytes as an evaluation reads and writes, to plain NumPy,
and of the gradient to the evaluation.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes import Dust, DustLayer, OrenNayar, TorranceSparrow, engine
from motes.arrays import NUMPY
from motes.directions import Geometry, Vector

SURFACE = DustLayer(
    OrenNayar(K_d=(0.8, 0.7, 0.6), sigma_d=0.4) + TorranceSparrow(K_s=0.3, sigma_s=0.15),
    Dust(w=(0.7, 0.6, 0.5), g=0.3),
    tau=0.2,
)
FIRST_CALL = """
import time
import numba
import numpy as np
from motes import engine
from evaluate import SURFACE  # this file
up = np.array([[0, 0, 1]], np.float32)
start = time.perf_counter()
engine.evaluate(SURFACE, up, up)
print(time.perf_counter() - start)
"""


def directions(n: int, seed: int) -> NDArray[np.float32]:
    """Uniform over the upper hemisphere, as a (3, n) array."""
    rng = np.random.default_rng(seed)
    z, phi = rng.random(n, np.float32), rng.random(n, np.float32) * np.float32(2 * np.pi)
    r = np.sqrt((1 - z) * (1 + z))
    return np.stack([r * np.cos(phi), r * np.sin(phi), z])


def by_numpy(wi: NDArray[Any], wo: NDArray[Any]) -> NDArray[Any]:
    with np.errstate(all="ignore"):
        return SURFACE.value(NUMPY, Geometry(NUMPY, Vector.of(wi), Vector.of(wo)))


def first_calls() -> tuple[float, float]:
    """Seconds of the first evaluation with an empty cache folder, and of the first one of the next process."""
    here = os.path.dirname(os.path.abspath(__file__))
    with tempfile.TemporaryDirectory() as folder:
        environment = os.environ | {"MOTES_CACHE": folder, "PYTHONPATH": here}
        run = [sys.executable, "-c", FIRST_CALL]
        cold, warm = (float(subprocess.check_output(run, env=environment, text=True)) for _ in range(2))
    return cold, warm


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--directions", type=int, default=10_000_000)
    parser.add_argument("--rounds", type=int, default=7)
    options = parser.parse_args()
    n = options.directions

    rows = directions(n, 1), directions(n, 2)
    pieces = tuple(np.ascontiguousarray(w.T) for w in rows)
    out_rows, out_pieces = np.empty((3, n), np.float32), np.empty((n, 3), np.float32)
    part = min(n, 1_000_000)  # less memory for float64, and for NumPy, which is slow
    few = min(n, 100_000)
    double = tuple(w[:, :part].astype(np.float64) for w in rows)
    seed = np.ones((3, n), np.float32)
    source, target = np.zeros((9 * n) // 2, np.float32), np.zeros((9 * n) // 2, np.float32)
    numpy_pieces = tuple(w[:few] for w in pieces)

    candidates: dict[str, tuple[Callable[[], Any], int]] = {
        "copying, one thread": (lambda: np.copyto(target, source), n),  # 36 bytes, as for 6 float32 in and 3 out
        "float32, (3, N) rows": (lambda: engine.evaluate(SURFACE, rows[0].T, rows[1].T, out=out_rows.T), n),
        "float32, (N, 3)": (lambda: engine.evaluate(SURFACE, *pieces, out=out_pieces), n),
        "float32, gradient in 11": (lambda: engine.vjp(SURFACE, rows[0].T, rows[1].T, seed.T), n),
        "float64, (3, N) rows": (lambda: engine.evaluate(SURFACE, double[0].T, double[1].T), part),
        "NumPy float32": (lambda: by_numpy(*numpy_pieces), few),
    }
    best = dict.fromkeys(candidates, np.inf)
    for _ in range(options.rounds + 1):  # the first round compiles
        for name, (call, count) in candidates.items():
            start = time.perf_counter()
            call()
            best[name] = min(best[name], (time.perf_counter() - start) / count)

    evaluation, plain = best["float32, (3, N) rows"], best["NumPy float32"]
    print(f"{n} directions, {engine._threads()} threads; best of {options.rounds} rounds\n")
    print(f"{'':26} {'M/s':>8} {'x evaluation':>14} {'x NumPy':>10}")
    for name, seconds in best.items():
        print(f"{name:26} {1e-6 / seconds:8.1f} {seconds / evaluation:14.2f} {plain / seconds:10.1f}")
    cold, warm = first_calls()
    print(f"\nfirst call {cold:.2f} s compiled, {warm:.2f} s from the cache (after import numba)")


if __name__ == "__main__":
    main()
