"""How time grows with the number of directions, and of texels: no worse than linearly.

usage: python benchmarks/growth.py [--effort quick|normal|full] [--json FILE]
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

import machine
import texels
from motes.kernels import engine
from results import Effort, Goal, Number, Section, Table, command
from rivals import SURFACE, directions
from timing import Timing, interleaved

EVALUATION, FITS = "evaluations", "fits of texels"
BYTES_DIRECTION, BYTES_TEXEL = 3 * 36, texels.DIRECTIONS * texels.CHANNELS * 4 + 1000
# Below these a call's own cost shows, and growth is slower than linear.
FROM = {EVALUATION: 10**5, FITS: 10**4}
BOUND = 1.02
SMALL = 10**6  # directions, and a tenth as many texels, that are made; more are copies of these


def sizes(first: int, last: int, bytes_each: int) -> list[int]:
    """Powers of ten, as far as three quarters of the free memory reach."""
    most = 0.75 * machine.memory_available() / bytes_each
    return [10**k for k in range(first, last + 1) if k == first or 10**k <= most]


def repeated(array: NDArray[Any], count: int, axis: int) -> NDArray[Any]:
    """The first `count` along an axis of an array that begins anew where it ends."""
    times = -(-count // array.shape[axis])
    whole = np.concatenate([array] * times, axis=axis) if times > 1 else array
    return np.ascontiguousarray(whole[:count] if axis == 0 else whole[:, :count])


def evaluation_times(counts: list[int], rounds: int) -> dict[int, Timing]:
    """Seconds of evaluations at so many directions, float32 rows, arrays in and out."""
    a, b = (repeated(directions(min(SMALL, counts[-1]), seed), counts[-1], 1) for seed in (1, 2))
    out = np.empty_like(a)
    candidates: dict[str, tuple[Callable[[], Any], float]] = {
        str(n): (lambda n=n: engine.evaluate(SURFACE, a[:, :n].T, b[:, :n].T, out=out[:, :n].T), 1) for n in counts
    }
    return {int(name): timing for name, timing in interleaved(candidates, rounds).items()}


def fit_times(counts: list[int], rounds: int) -> dict[int, Timing]:
    """Seconds of fits of so many texels, 2 % noise."""
    case = texels.Case.of(min(SMALL // 10, counts[-1]))
    values, starts = (repeated(x, counts[-1], 0) for x in (case.noisy, case.starts))
    fitter = texels.solver()
    candidates: dict[str, tuple[Callable[[], Any], float]] = {
        str(n): (lambda n=n: fitter.fit(values[:n], starts[:n], own_starts=True), 1) for n in counts
    }
    return {int(name): timing for name, timing in interleaved(candidates, rounds).items()}


def fitted(counts: list[int], first: int) -> list[int]:
    """The sizes from `first` on; all of them, if these are fewer than two."""
    chosen = [n for n in counts if n >= first]
    return chosen if len(chosen) > 1 else counts


def slope(times: dict[int, Timing], first: int) -> Number:
    """The exponent of N in the processor time, one fit a round."""
    chosen = fitted(list(times), first)
    rounds = len(times[chosen[0]].cpu)
    logs = np.log([times[n].cpu for n in chosen])
    return Number.of([np.polyfit(np.log(chosen), logs[:, k], 1)[0] for k in range(rounds)])


def growth(effort: Effort) -> Section:
    """Both curves and their slopes."""
    runs = {
        EVALUATION: evaluation_times(sizes(3, effort.pick(4, 8), BYTES_DIRECTION), effort.pick(3, 5)),
        FITS: fit_times(sizes(2, effort.pick(3, 6), BYTES_TEXEL), effort.pick(2, 3)),
    }
    figures: dict[str, Number] = {}
    rows, goals, reading, curves = [], [], [], {}
    for key, (what, times) in zip(("evaluation", "fits"), runs.items(), strict=True):
        counts = list(times)
        figures |= {
            f"{key}_slope": slope(times, FROM[what]),
            f"{key}_rounds": Number.of([len(times[counts[0]].wall)]),
            f"{key}_largest": Number.of([counts[-1]]),
        }
        for n in counts:
            figures[f"{key}_{n}"] = times[n].seconds.times(1e3)
            figures[f"{key}_{n}_each"] = times[n].seconds.times(1e9 / n)
            figures[f"{key}_{n}_cpu"] = times[n].processor.times(1e9 / n)
            rows.append([f"{n:,} {what}", f"{{{key}_{n}}}", f"{{{key}_{n}_each}}", f"{{{key}_{n}_cpu}}"])
        goals.append(Goal(f"exponent of N, {what}", f"{key}_slope", BOUND, at_least=False))
        reading.append(
            f"The processor time of {what} grows as N to the power {{{key}_slope}}, from N = {fitted(counts, FROM[what])[0]:,} to {{{key}_largest:count}}."
        )
        curves[what] = [[n, times[n].seconds.median] for n in counts]
    reading.append("Below that a call's own cost is a part of the time, so that it grows more slowly.")
    return Section(
        title="Growth",
        made_by="benchmarks/growth.py, growth()",
        intro=(
            "The same evaluation and the same fits for ever larger N, all sizes in turn, {evaluation_rounds:count} and {fits_rounds:count} rounds; above a "
            "million directions and a hundred thousand texels the inputs repeat. "
            "The exponent is fitted to processor time in each round; the plot shows wall time."
        ),
        figures=figures,
        tables=[Table(["", "ms, wall", "ns each, wall", "ns each of processor"], rows)],
        goals=goals,
        reading=reading,
        curves=curves,
    )


if __name__ == "__main__":
    command(growth, __doc__)
