"""Where fits of the texels of a map start: a full search on some of them, and what is left of the ends when likes are put together.

An objective has several valleys along sigma_s, sigma_d, g and tau.  Searching them at every texel would cost a hundred times the fit; the
materials of a map are few, and a texel close to a start finds its own valley.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from motes.errors import DataError
from motes.fitting.losses import Floats
from motes.fitting.scans import fit_scans, single
from motes.fitting.starts import starting_points
from motes.fitting.texel_kernel import Singles
from motes.fitting.texel_setup import TexelSetup
from motes.fitting.texels_slow import problem_of

MOST_SEARCHED = 24  # texels
MOST_STARTS = 6
# Starts are distinct when they differ by this share of a parameter's typical range.
DISTINCT = 0.15


def representative_starts(
    solver: TexelSetup, data: Singles, fit: Callable[[NDArray[np.intp], Floats], Singles]
) -> Floats:
    """Starts (K, P) for texels like those of `data`; `fit` fits some of its rows from starts."""
    usable = np.isfinite(data)
    bright = np.where(usable, data, 0).reshape(len(data), -1).any(axis=1)
    enough = usable.reshape(len(data), -1).sum(axis=1) > solver.size
    rows = np.flatnonzero(bright & enough)
    if not len(rows):
        raise DataError(
            f"none of {len(data)} texels has values other than 0 at enough directions for {solver.size} parameters",
            "Check the mask and the units of the map",
        )
    rows = rows[np.linspace(0, len(rows) - 1, min(len(rows), MOST_SEARCHED)).astype(int)]
    ends = [end for row in rows for end in _searched(solver, data[row])]
    best = fit(rows, _distinct(solver, np.array(ends), 4 * MOST_STARTS)).astype(float)
    best = best[np.isfinite(best).all(axis=1)]
    return _distinct(solver, best if len(best) else np.array(ends), MOST_STARTS)


def _searched(solver: TexelSetup, texel: Singles) -> list[Floats]:
    """Ends of a full search on one texel."""
    if not solver.parts:
        problem = problem_of(solver, texel[None])
        alone = single(problem, 0)
        solution = alone.solve(starting_points(alone, None, most=4), max_iterations=60)
        return [solver.values(solution.x[solution.best()])]
    problem = problem_of(solver, texel)
    assert solver.hours is not None
    scans = np.flatnonzero((problem.weights > 0).any(axis=(1, 2)) & problem.values.any(axis=(1, 2)))
    values = fit_scans(problem, scans).x
    choices = [part.starts(solver.hours[scans], values[:, part.quantity.where]) for part in solver.parts]
    few = [choice[: 4 if len(choice) > 1 else 1] for choice in choices]
    return [solver.values(np.concatenate(choice)) for choice in itertools.islice(itertools.product(*few), 16)]


def _distinct(solver: TexelSetup, points: Floats, most: int) -> Floats:
    """Of many points those farthest from each other, the one in the middle first."""
    low, high = solver.bounds
    points = np.clip(points, low, high)
    span = (solver.facts.most - solver.facts.least)[:, 0]
    scaled = points / np.maximum(span, 1e-12)
    chosen = [int(np.argmin(np.abs(scaled - np.median(scaled, axis=0)).sum(axis=1)))]
    while len(chosen) < min(most, len(points)):
        distance = np.min([np.abs(scaled - scaled[k]).max(axis=1) for k in chosen], axis=0)
        farthest = int(np.argmax(distance))
        if distance[farthest] < DISTINCT:
            break
        chosen.append(farthest)
    return points[chosen]
