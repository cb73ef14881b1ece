"""Where a fit starts: a grid over what has several valleys, thinned on a small grey version of the data.

The objective is nearly quadratic in K_d, K_s and w, and has several valleys along sigma_s, sigma_d, g, tau and the
refractive index; each of those declares values to start from (`Parameter.starts`).  At every point of their grid the
others are fitted to a few hundred grey samples; the best points are fitted in full there, and the best distinct ends
are where the real fit starts.  Nothing is random from run to run."""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np

from motes.fitting.losses import Floats
from motes.fitting.problem import Problem
from motes.fitting.quantities import Quantity
from motes.fitting.verdicts import Status
from motes.parameters import Role

SEARCH_SAMPLES = 600
SEARCH_LANES = 24
LARGEST_GRID = 1000
#: A fit that goes on after so many iterations is given up if its sum of squares is so many times the best one's.
PATIENCE, HOPELESS = 12, 9.0


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
    coarse = grey.solve(grid, held=gridded, max_iterations=6)
    order = np.argsort(coarse.normal.objective, kind="stable")
    chosen = coarse.x[_spread_out(coarse.x, order, gridded)]
    ends = _ends(grey, chosen)
    distinct = [ends[0]]
    for end in ends[1:]:
        if len(distinct) < most and all(np.any(np.abs(end - d) > 0.02 * np.abs(d) + 1e-3) for d in distinct):
            distinct.append(end)
    starts = np.stack([_expand(problem, grey, x, brightness) for x in distinct])
    return starts if given is None else np.concatenate([given[None], starts])


def _ends(grey: Problem, chosen: Floats) -> Floats:
    """Where fits from the chosen points end (B, P), the best first.

    All of them advance together, and what is left of them at last is one that creeps: it is given up where it is far above the others' ends.
    """
    fine = grey.solve(chosen, max_iterations=PATIENCE, reduction=1e-6)
    objective, x = fine.normal.objective.copy(), fine.x
    late = np.array([status is Status.MAX_ITERATIONS for status in fine.status])
    hopeless = late & (objective > HOPELESS * objective.min())
    late &= ~hopeless
    if late.any():
        more = grey.solve(x[late], max_iterations=60 - PATIENCE, reduction=1e-6)
        objective[late], x[late] = more.normal.objective, more.x
    order = np.argsort(objective, kind="stable")
    return np.asarray(x[order[~hopeless[order]]])


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
    for q in grey.quantities:
        starts = q.parameter.starts
        axes.append(tuple(float(q.coordinate(np.array(s))) for s in starts) or (_bright_start(grey, q),))
    # Many Fresnel and dust parameters at once: take every second start of the longest axis until the grid is
    # affordable.
    while np.prod([len(a) for a in axes]) > LARGEST_GRID:
        longest = max(range(len(axes)), key=lambda k: len(axes[k]))
        axes[longest] = axes[longest][::2]
    return np.array(list(itertools.product(*axes)), float)


def _bright_start(grey: Problem, q: Quantity) -> float:
    """A first value for a parameter that enters almost linearly: about the brightness of the data."""
    mean = float(np.average(grey.values, weights=grey.weights))
    low, high = q.bounds
    default = float(q.coordinate(np.array(q.parameter.default)))
    return float(np.clip(np.pi * mean if q.parameter.role is Role.DIFFUSE_COLOUR else default, low, min(high, 1e6)))


def _grey(problem: Problem) -> tuple[Problem, Floats]:
    """The mean over channels at a few hundred directions, half of them bright; the channels' brightness."""
    weights = problem.weights
    count = np.maximum((weights > 0).sum(axis=1), 1)
    values = np.where(weights > 0, problem.values, 0).sum(axis=1) / count
    mean = np.array(
        [np.average(v, weights=w) if w.any() else 1.0 for v, w in zip(problem.values.T, weights.T, strict=True)]
    )
    brightness = np.maximum(mean, 1e-12) / max(float(mean.mean()), 1e-12)
    total = weights.mean(axis=1)
    usable = np.flatnonzero(total > 0)
    if len(usable) > SEARCH_SAMPLES:
        rng = np.random.default_rng(20070101)
        size = SEARCH_SAMPLES // 2
        energy = np.abs(values[usable]) * problem.wi[usable, 2] + 1e-12
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
    return grey, brightness


def _expand(problem: Problem, grey: Problem, x: Floats, brightness: Floats) -> Floats:
    """A grey parameter vector for all channels: what is a colour goes with the channels' brightness."""
    full = np.empty(problem.size)
    for q, value in zip(problem.quantities, x, strict=True):
        colour = q.per_channel and not q.parameter.shared_in_fit
        full[q.where] = value * brightness if colour else value
    return full
