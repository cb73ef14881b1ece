"""Where the processor time of the batched solver goes: the kernel with parts of it switched off.

usage: NUMBA_NUM_THREADS=1 python benchmarks/texel_parts.py [--trends] [--texels 16384] [--rounds 25]

The texels are those of texels.py with noise, at one time or, with --trends, an eighth as many at 12 times.
Prints the least and the median processor time of a thread, µs a texel, parts in turn: the least hardly depends on what else the machine does.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable

import numpy as np

from motes.fitting.texel_forms import Forms
from texel_cases import Case, Series
from texels import solver


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--texels", type=int, default=16384)
    parser.add_argument("--rounds", type=int, default=25)
    parser.add_argument("--trends", action="store_true")
    a = parser.parse_args()
    count, fitter = a.texels, solver()
    if a.trends:
        count = a.texels // 8
        series = Series.of(count)
        fitter, values, starts = series.solver, series.values, series.starts
    else:
        case = Case.of(count)
        values, starts = case.noisy, case.starts
    forms = fitter.kernel("cheapest")
    kernel = forms.quick if isinstance(forms, Forms) else forms
    points = fitter.coordinates(np.clip(starts, *fitter.bounds))
    parts: dict[str, Callable[[], object]] = {
        "all of a call": lambda: fitter.fit(values, starts, own_starts=True),
        "the kernel": lambda: kernel.fit(values, points),
        "without the last pass": lambda: kernel.fit(values, points, close=False),
        "sums and the first normal equations": lambda: kernel.fit(values, points, limit=0, close=False),
    }
    taken: dict[str, list[float]] = {name: [] for name in parts}
    for _ in range(a.rounds + 1):  # the first compiles
        for name, call in parts.items():
            start = time.thread_time()
            call()
            taken[name].append(time.thread_time() - start)
    for name, seconds in taken.items():
        least, middle = (1e6 / count * f(seconds[1:]) for f in (np.min, np.median))
        print(f"{name:36s} least {least:.3f}, median {middle:.3f} µs")


if __name__ == "__main__":
    main()
