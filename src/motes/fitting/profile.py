"""Intervals by the profile likelihood: how far a parameter can be moved, all others fitted again, before the fit gets too bad.

They follow valleys that bend and end at bounds, where errors only see a parabola.  How bad is too bad is set by the standard errors: twice the
rise of the objective is measured in units in which a parabola would give the interval of the sandwich (Pace, Salvan and Sartori,
Statistica Sinica 21, 2011), so that residuals need not be independent.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from motes.fitting.algebra import pseudo_inverse
from motes.fitting.losses import Floats
from motes.fitting.objective import Objective
from motes.fitting.result import Progress
from motes.fitting.students_t import half_width

# The end of an interval is looked for as far out as so many times its guess, in so many steps of a false position.
FARTHEST, STEPS = 64.0, 9
# Ends of refits that are as good as these to a hundredth of a standard error.
REDUCTION, ITERATIONS = 1e-9, 60


def profiled(
    objective: Objective,
    x: Floats,
    errors: Floats,
    freedom: Floats,
    levels: Mapping[str, float],
    progress: Progress | None = None,
) -> dict[str, Floats]:
    """Intervals (2, P) in the coordinates of the fit, by the names of `levels`; NaN where the data tell nothing.

    Parameters
    ----------
    x, errors, freedom
        The solution, its standard errors and their degrees of freedom (P,), in the coordinates of the fit.  A parameter at a bound, which has no
        error, gets the interval that begins there.
    """
    low, high = objective.bounds
    least = float(objective.normal(x[None]).objective[0])
    matrix = objective.curvature(x)
    free = np.isfinite(errors) & (errors > 0)
    at_bound = ~free & ((x <= low) | (x >= high)) & (low < high)
    ordinary = objective.columns.unit[:, 0]
    inverse = _inverse(matrix, free, ordinary)
    units = np.full(len(x), np.nan)
    units[free] = errors[free] ** 2 / np.maximum(np.diag(inverse)[free], 1e-300)
    found = {name: np.full((2, len(x)), np.nan) for name in levels}
    asked = np.flatnonzero(free | at_bound) if free.any() else np.array([], np.intp)
    for done, p in enumerate(asked):
        if progress:
            progress(done, len(asked), "profile likelihood")
        among = free.copy()
        among[p] = True
        own = inverse if free[p] else _inverse(matrix, among, ordinary)
        unit = units[p] if free[p] else float(np.median(units[free]))
        step = np.sqrt(unit * max(float(own[p, p]), 0.0))
        if not step > 0:
            continue
        way = own[:, p] / own[p, p]
        width = {name: half_width(level, float(freedom[p])) for name, level in levels.items()}
        ends = _ends(
            objective, x, int(p), way, least, unit, step, np.array([s * w for w in width.values() for s in (-1, 1)])
        )
        for k, name in enumerate(levels):
            found[name][:, p] = ends[2 * k : 2 * k + 2]
    if progress:
        progress(len(asked), len(asked), "profile likelihood")
    return found


def _inverse(matrix: Floats, among: np.ndarray[tuple[int], np.dtype[np.bool_]], unit: Floats) -> Floats:
    full = np.zeros_like(matrix)
    at = np.flatnonzero(among)
    full[np.ix_(at, at)] = pseudo_inverse(matrix[np.ix_(at, at)], unit[at], 1e-15)
    return full


def _ends(
    objective: Objective, x: Floats, p: int, way: Floats, least: float, unit: float, step: float, wanted: Floats
) -> Floats:
    """Where parameter `p` is so far off, on either side, that the square root of twice the rise over `unit` is |wanted| (L,)."""
    low, high = objective.bounds
    side, target = np.sign(wanted), np.abs(wanted)
    bound = np.where(side < 0, low[p], high[p])

    def rise(to: Floats) -> Floats:
        points = np.clip(x + (to - x[p])[:, None] * way, low, high)
        points[:, p] = to
        held = np.zeros(points.shape, bool)
        held[:, p] = True
        ends = objective.refitted(x, points, held, max_iterations=ITERATIONS, reduction=REDUCTION)
        return np.asarray(np.sqrt(2 * np.maximum(ends - least, 0.0) / unit))

    def inside(to: Floats) -> Floats:
        return np.asarray(np.where(side < 0, np.maximum(to, bound), np.minimum(to, bound)))

    inner, at_inner = np.full(len(side), x[p]), np.zeros(len(side))
    outer = inside(x[p] + side * target * step)
    at_outer = rise(outer)
    factor = 1.0
    while factor < FARTHEST and np.any((at_outer < target) & (outer != bound)):
        factor *= 2
        short = (at_outer < target) & (outer != bound)
        inner, at_inner = np.where(short, outer, inner), np.where(short, at_outer, at_inner)
        outer = np.where(short, inside(x[p] + side * target * step * factor), outer)
        at_outer = np.where(short, rise(outer), at_outer)
    reached = at_outer >= target
    for _ in range(STEPS):
        open_ = reached & (np.abs(outer - inner) > 1e-4 * step)
        if not open_.any():
            break
        # The root of the rise is a straight line where the valley is a parabola; kept off the ends, so that both move.
        share = np.clip((target - at_inner) / np.maximum(at_outer - at_inner, 1e-300), 0.02, 0.98)
        middle = np.where(open_, inner + share * (outer - inner), outer)
        at_middle = rise(middle)
        beyond = at_middle >= target
        outer, at_outer = np.where(open_ & beyond, middle, outer), np.where(open_ & beyond, at_middle, at_outer)
        inner, at_inner = np.where(open_ & ~beyond, middle, inner), np.where(open_ & ~beyond, at_middle, at_inner)
    share = np.clip((target - at_inner) / np.maximum(at_outer - at_inner, 1e-300), 0.0, 1.0)
    return np.where(reached, inner + share * (outer - inner), np.where(outer == bound, bound, side * np.inf))
