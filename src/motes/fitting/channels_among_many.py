"""Some of thousands of channels that stand for all of them, where many fits are asked for."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.fitting.losses import Floats
from motes.fitting.quantities import Quantity

#: With more than twice as many channels, what asks for many fits is asked of this many, evenly spaced.
CHANNELS = 64


def even_channels(used: NDArray[Any]) -> NDArray[np.intp] | None:
    """Channels that stand for all of those with samples, `used` (..., C) being true for a sample; None where all are taken."""
    if used.shape[-1] <= 2 * CHANNELS:
        return None
    usable = np.flatnonzero(used.any(axis=tuple(range(used.ndim - 1))))
    if len(usable) <= 2 * CHANNELS:
        return None
    return usable[np.linspace(0, len(usable) - 1, CHANNELS).round().astype(np.intp)]


def rise_among_channels(
    problem: Any, x: Floats, points: Floats, held: NDArray[np.bool_], max_iterations: int, reduction: float
) -> Floats | None:
    """By how much the objective of fits to a `Problem` from `points` (L, P) with some `held` (L, P) is above that at `x`: (L,); None where channels are few.

    What is held is fitted again among the channels that it belongs to and some others, evenly spaced, which weigh as much as
    all: what all share would move too far for one channel alone, and not at all if it were held.  Good to a factor of two.
    """
    even = even_channels(problem.weights)
    if even is None:
        return None
    touched = np.zeros((len(points), problem.channels), bool)
    quantities: tuple[Quantity, ...] = problem.quantities
    for q in quantities:
        if q.per_channel:
            touched |= held[:, q.where] | (points[:, q.where] != x[q.where])
    few = touched.sum(axis=1) <= 1
    rise = np.empty(len(points))
    alone = np.flatnonzero(few)
    for rows in (np.flatnonzero(~few), *(alone[k : k + CHANNELS] for k in range(0, len(alone), CHANNELS))):
        if not len(rows):
            continue
        own = np.flatnonzero(touched[rows].any(axis=0) & few[rows[0]])
        others = np.setdiff1d(even, own)
        among = np.union1d(others, own)
        share = np.count_nonzero(problem.weights) / np.count_nonzero(problem.weights[..., others])
        part = problem.some_channels(among)
        part = replace(part, weights=part.weights * np.where(np.isin(among, own), 1.0, share))
        ends = part.solve(
            np.stack([problem.at_channels(row, among) for row in (x, *points[rows])]),
            held=np.stack([problem.at_channels(row, among) for row in (np.zeros(problem.size, bool), *held[rows])]),
            max_iterations=max_iterations,
            reduction=reduction,
        ).normal.objective
        rise[rows] = ends[1:] - ends[0]
    return rise
