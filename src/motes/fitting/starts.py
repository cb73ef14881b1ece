"""Where a fit starts: a grid over what has several valleys, thinned on a small grey version of the data.

The objective is nearly quadratic in K_d, K_s and w, and has several valleys along sigma_s, sigma_d, g, tau and the
refractive index; each of those declares values to start from (`Parameter.starts`).  At every point of their grid the
others are fitted to a few hundred grey samples; the best points are fitted in full there, and the best distinct ends
are where the real fit starts.  Nothing is random from run to run."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from motes.fitting.losses import Floats
from motes.fitting.problem import Problem
from motes.fitting.quantities import Quantity
from motes.fitting.verdicts import Status
from motes.parameters import Role

SEARCH_SAMPLES = 600
SEARCH_LANES = 24
LARGEST_GRID = 1000
#: A fit that goes on after so many iterations is given up if its sum of squares is so many times the best one's.
PATIENCE, HOPELESS = 8, 9.0
# One that is where the best one is, after so many iterations, is not followed to the same end.
SETTLED = 3
ITERATIONS = 60


def starting_points(problem: Problem, given: Floats | None, most: int) -> Floats:
    """Up to `most` distinct parameter vectors (B, P), the most promising first.

    Parameters
    ----------
    problem
        The fit.
    given
        A vector (P,) of the user's, tried as well.
    """
    grey, brightness = _grey(problem)
    grid = _grid(grey)
    gridded = np.array([bool(q.parameter.starts) for q in grey.quantities])
    coarse = grey.solve(grid, held=gridded, max_iterations=6, reduction=1e-3)
    order = np.argsort(coarse.normal.objective, kind="stable")
    chosen = coarse.x[_spread_out(coarse.x, order, gridded)]
    ends = _ends(grey, chosen)
    unit = grey.columns.unit[:, 0]
    distinct = [ends[0]]
    for end in ends[1:]:
        if len(distinct) < most and all(_apart(end, d, unit) for d in distinct):
            distinct.append(end)
    starts = np.stack([_expand(problem, grey, x, brightness) for x in distinct])
    return starts if given is None else np.concatenate([given[None], starts])


def _ends(grey: Problem, chosen: Floats) -> Floats:
    """Where fits from the chosen points end (B, P), the best first; without those that were given up."""
    fine = grey.solve(chosen, max_iterations=ITERATIONS, reduction=1e-6, spare=_Superfluous(grey.columns.unit[:, 0]))
    late = np.array([status is Status.MAX_ITERATIONS for status in fine.status])
    given_up = late & (fine.iterations < ITERATIONS)
    order = np.argsort(fine.normal.objective, kind="stable")
    given_up[order[0]] = False  # the best one stays, whoever stopped it
    return np.asarray(fine.x[order[~given_up[order]]])


class _Superfluous:
    """Of fits that advance together: those that need not be followed, where the best one has been or far above it.

    What is left of them at last is one that creeps, and a step of one takes as long as a step of all.
    """

    def __init__(self, unit: Floats) -> None:
        self.unit = unit
        self.least, self.best = np.inf, np.empty(0)

    def __call__(self, x: Floats, objective: Floats, iterations: NDArray[np.int64]) -> NDArray[np.bool_]:
        first = int(np.argmin(objective))  # a NaN, whose fit is about to end, passes for once
        if objective[first] < self.least:
            self.least, self.best = float(objective[first]), x[first].copy()
        if not len(self.best) or iterations[0] < SETTLED:
            return np.zeros(len(x), bool)
        there = (objective > self.least) & ~_apart(x, self.best, self.unit)
        return np.asarray(there | ((iterations >= PATIENCE) & (objective > HOPELESS * self.least)))


def _apart(x: Floats, other: Floats, unit: Floats) -> NDArray[np.bool_]:
    """Whether points (..., P) are elsewhere than another one (P,), in units (P,) of the parameters."""
    return np.asarray(np.any(np.abs(x - other) > 0.02 * np.abs(other) + 1e-3 * unit, axis=-1))


def _spread_out(x: Floats, order: np.ndarray, gridded: np.ndarray) -> np.ndarray:
    """The best lanes, and besides them the best lane for each value of each gridded parameter."""
    keep = list(order[: SEARCH_LANES // 2])
    for column in x[:, gridded].T:
        for value in np.unique(column):
            lane = order[column[order] == value][0]
            if lane not in keep:
                keep.append(lane)
    return np.array(keep)


def _grid(grey: Problem) -> Floats:
    axes = []
    mean = float(np.average(grey.values, weights=grey.weights))
    for q in grey.quantities:
        starts = q.parameter.starts
        axes.append(tuple(float(q.coordinate(s)) for s in starts) or (_bright_start(grey, q, mean),))
    # Many Fresnel and dust parameters at once: take every second start of the longest axis until the grid is
    # affordable.
    while math.prod(len(a) for a in axes) > LARGEST_GRID:
        longest = max(range(len(axes)), key=lambda k: len(axes[k]))
        axes[longest] = axes[longest][::2]
    return np.array(list(itertools.product(*axes)), float)


def _bright_start(grey: Problem, q: Quantity, mean: float) -> float:
    """A first value for a parameter that enters almost linearly: about the brightness of the data, of which this is the mean."""
    low, high = q.bounds
    default = float(grey.columns.rest[q.where.start, 0])
    most = min(high, 1e6 * grey.unit)
    return min(max(np.pi * mean if q.parameter.role is Role.DIFFUSE_COLOUR else default, low), most)


def _grey(problem: Problem) -> tuple[Problem, Floats]:
    """The mean over channels at a few hundred directions, half of them bright; the channels' brightness."""
    # Sums over few channels, the last axis, would take five times as long.
    measured, weights = (np.ascontiguousarray(x.T) for x in (problem.values, problem.weights))
    count = np.maximum((weights > 0).sum(axis=0), 1)
    values = np.where(weights > 0, measured, 0).sum(axis=0) / count
    mean = np.array([np.average(v, weights=w) if w.any() else 1.0 for v, w in zip(measured, weights, strict=True)])
    least = 1e-12 * problem.unit
    brightness = np.maximum(mean, least) / max(float(mean.mean()), least)
    total = weights.mean(axis=0)
    usable = np.flatnonzero(total > 0)
    if len(usable) > SEARCH_SAMPLES:
        rng = np.random.default_rng(20070101)
        size = SEARCH_SAMPLES // 2
        energy = np.abs(values[usable]) * problem.wi[usable, 2] + least
        bright = rng.choice(usable, size, replace=False, p=energy / energy.sum())
        usable = np.union1d(rng.choice(usable, size, replace=False), bright)
    quantities = tuple(Quantity(q.name, q.parameter, False, slice(k, k + 1)) for k, q in enumerate(problem.quantities))
    fixed = {name: float(np.mean(value)) for name, value in problem.fixed.items()}
    grey = replace(
        problem,
        quantities=quantities,
        fixed=fixed,
        wi=problem.wi[usable],
        wo=problem.wo[usable],
        values=values[usable, None],
        weights=total[usable, None],
    )
    grey.seen_from(problem, usable)
    return grey, brightness


def _expand(problem: Problem, grey: Problem, x: Floats, brightness: Floats) -> Floats:
    """A grey parameter vector for all channels: what is a colour goes with the channels' brightness."""
    full = np.empty(problem.size)
    for q, value in zip(problem.quantities, x, strict=True):
        colour = q.per_channel and not q.parameter.shared_in_fit
        full[q.where] = value * brightness if colour else value
    return full
