"""Standard errors, correlations, and what the data say about each parameter."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.fitting.losses import Floats
from motes.fitting.problem import Problem
from motes.fitting.result import Verdict
from motes.fitting.solver import minimize
from motes.parameters import Parameter

# An eigenvalue of the normal matrix (scaled to a diagonal of 1) below this: along its vector the data see nothing.
NULL_EIGENVALUE = 1e-9
# A parameter that, moved by the whole of its typical range, changes the residuals by less than this share of the data
# is not seen.
UNSEEN = 1e-6
# A parameter at a bound is held there by the data when they push it out by more than so many standard errors.
FIRM = 3.0
# Where a parameter at its bound has no effect to first order (sigma_d at 0), its effect is looked at this share of its
# typical range inside.
SHIFT = 0.1
# With a standard error beyond this share of its typical range, a parameter is tried half the range away as well.
DOUBTFUL = 0.1


class Uncertainty(NamedTuple):
    """Standard errors (P,), correlations (P, P) (NaN where undefined) and verdicts, for a parameter vector."""

    stderr: Floats
    correlations: Floats
    verdicts: list[Verdict]


def uncertainty(problem: Problem, x: Floats) -> Uncertainty:
    """The uncertainty of the solution `x` (P,).

    The covariance is the sandwich H^-1 M H^-1 with H the curvature of the objective (`Problem.curvature`) and M the sum
    of squared residuals times J'J (HC3, see `Problem.spread`): it holds where the noise differs from sample to sample, and where the weights are solid
    angles rather than inverse variances. A parameter at a bound has no standard error; those of the others are the
    larger of two, with it held there and, where noise may have put it there, with it free."""
    size = len(x)
    matrix = problem.curvature(x)
    if problem.robust.name == "cauchy" and np.any(np.diag(matrix) <= 0):  # mostly outliers: no minimum to speak of
        matrix = problem.normal(x[None]).matrix[0]
    low, high = problem.bounds
    declared = [q.parameter for q in problem.quantities for _ in range(q.where.stop - q.where.start)]
    margin = 1e-9 * (1 + np.abs(x))
    verdicts = [Verdict.IDENTIFIED] * size
    for k in range(size):
        if x[k] <= low[k] + margin[k]:
            verdicts[k] = Verdict.AT_LOWER
        elif x[k] >= high[k] - margin[k]:
            verdicts[k] = Verdict.AT_UPPER

    span = np.array([p.typical[1] - p.typical[0] for p in declared])
    data = float(np.sum((problem._roots * problem._targets) ** 2))
    diagonal = np.diag(matrix)
    unseen = diagonal * span**2 <= UNSEEN**2 * max(data, 1e-300)
    inside = np.array([v == Verdict.IDENTIFIED for v in verdicts])
    for k in np.flatnonzero(unseen & inside).tolist():
        verdicts[k] = Verdict.UNIDENTIFIABLE
    free = np.flatnonzero(inside & ~unseen)

    stderr, correlations = np.full(size, np.nan), np.full((size, size), np.nan)
    if len(free) and problem.samples > len(free):
        inverse, unseen_together = _inverted(matrix, free)
        middle = problem.spread(x, inverse)
        covariance = inverse @ middle @ inverse
        stderr[free] = np.sqrt(np.diag(covariance)[free])
        stderr[unseen_together] = np.nan
        known = np.flatnonzero(np.isfinite(stderr) & (stderr > 0))
        correlations[np.ix_(known, known)] = covariance[np.ix_(known, known)] / np.outer(stderr[known], stderr[known])
        variance = float(np.mean(np.diag(middle)[free] / np.diag(matrix)[free]))
        loose = _loose(problem, x, matrix, inverse, middle, np.flatnonzero(~inside))
        if len(loose):
            shifted = x.copy()
            into = np.where(x <= low + margin, 1, -1) * np.minimum(SHIFT * span, 0.5 * (high - low))
            flat = loose[unseen[loose]]
            shifted[flat] += into[flat]
            wider, blurred = _inverted(problem.curvature(shifted) if len(flat) else matrix, np.union1d(free, loose))
            relaxed = np.sqrt(variance * np.diag(wider))
            relaxed[blurred] = np.inf
            stderr[free] = np.maximum(stderr[free], relaxed[free])
            for k in loose[relaxed[loose] > 0.5 * span[loose]].tolist():
                verdicts[k] = Verdict.UNIDENTIFIABLE
        stderr[~np.isfinite(stderr)] = np.nan
        for k in free.tolist():
            verdicts[k] = judged(declared[k], x[k], stderr[k])
        doubtful = np.flatnonzero([v == Verdict.IDENTIFIED for v in verdicts] & (stderr > DOUBTFUL * span))
        for k in _as_good_elsewhere(problem, x, doubtful, 0.5 * span, variance):
            verdicts[k] = Verdict.WEAK
        for k in _borne_by_doubt(problem, x, verdicts, stderr, span, variance):
            verdicts[k] = Verdict.WEAK
    else:
        for k in free.tolist():
            verdicts[k] = Verdict.UNIDENTIFIABLE
    return Uncertainty(stderr, correlations, verdicts)


def _inverted(matrix: Floats, among: NDArray[np.intp]) -> tuple[Floats, NDArray[np.intp]]:
    """The inverse (P, P) of the rows and columns `among`, 0 elsewhere, and those of `among` that only sums of are seen."""
    scale = 1 / np.sqrt(np.maximum(np.diag(matrix)[among], 1e-300))
    eigenvalues, vectors = np.linalg.eigh(matrix[np.ix_(among, among)] * np.outer(scale, scale))
    null = eigenvalues < NULL_EIGENVALUE
    inverted = np.where(null, 0, 1 / np.where(null, 1, eigenvalues))
    inverse = np.zeros_like(matrix)
    inverse[np.ix_(among, among)] = (vectors * inverted) @ vectors.T * np.outer(scale, scale)
    return inverse, among[np.any(np.abs(vectors[:, null]) > 0.1, axis=1)]


def _loose(
    problem: Problem, x: Floats, matrix: Floats, inverse: Floats, middle: Floats, bounded: NDArray[np.intp]
) -> NDArray[np.intp]:
    """Those of the parameters at a bound that noise may have put there.

    The errors of the others must hold for any value that such a parameter may have: at n = 4 the height of a highlight
    seems known, and yet n and the height are not, where F hardly changes over the data. The push against the bound is a
    sum over the data, whose variance `middle` tells."""
    gradient = problem.normal(x[None]).gradient[0]
    loose = []
    for k in bounded.tolist():
        projected = -inverse @ matrix[:, k]  # the others give way
        projected[k] = 1.0
        noise = float(np.sqrt(np.maximum(projected @ middle @ projected, 0.0)))
        if abs(float(projected @ gradient)) <= FIRM * noise:
            loose.append(k)
    return np.array(loose, np.intp)


def _as_good_elsewhere(
    problem: Problem, x: Floats, which: NDArray[np.intp], distance: Floats, variance: float
) -> list[int]:
    """Those of `which` that the data allow to be `distance` away, when all others are fitted again there.

    Standard errors look at the neighbourhood of the solution only; the optical thickness of a nearly opaque layer has a
    steep side and a flat one."""
    low, high = problem.bounds
    lanes = [(k, x[k] + s * distance[k]) for k in which.tolist() for s in (-1, 1)]
    lanes = [(k, value) for k, value in lanes if low[k] <= value <= high[k]]
    if not lanes:
        return []
    starts, held = np.tile(x, (len(lanes), 1)), np.zeros((len(lanes), len(x)), bool)
    for row, (k, value) in enumerate(lanes):
        starts[row, k], held[row, k] = value, True
    ends = minimize(problem.normal, starts, low, high, held=held, max_iterations=30, reduction=1e-5)
    worse = 2 * (ends.normal.objective - problem.normal(x[None]).objective) / max(variance, 1e-300)
    return [k for (k, _), rise in zip(lanes, worse, strict=True) if rise < FIRM**2]


def _borne_by_doubt(
    problem: Problem, x: Floats, verdicts: list[Verdict], stderr: Floats, span: Floats, variance: float
) -> list[int]:
    """Identified parameters that act only through others which may as well be absent.

    Where K_s may be 0, noise lends its highlight a width, and a small error of that width."""
    identified = np.array([v == Verdict.IDENTIFIED for v in verdicts])
    data = float(np.sum((problem._roots * problem._targets) ** 2))
    doubted: list[int] = []
    for q in problem.quantities:
        low = q.parameter.fit_bounds[0]
        near = ~(x[q.where] - low > 4 * stderr[q.where])  # also where there is no error
        if not near.all() or np.all(x[q.where] <= low):
            continue
        without, held = x[None].copy(), np.zeros(len(x), bool)
        without[0, q.where], held[q.where] = low, True
        unseen = np.diag(problem.curvature(without[0])) * span**2 <= UNSEEN**2 * max(data, 1e-300)
        if not np.any(identified & unseen):
            continue
        low_x, high_x = problem.bounds
        end = minimize(problem.normal, without, low_x, high_x, held=held, max_iterations=30, reduction=1e-5)
        rise = 2 * (end.normal.objective - problem.normal(x[None]).objective) / max(variance, 1e-300)
        if rise[0] < FIRM**2:
            doubted += np.flatnonzero(identified & unseen).tolist()
    return doubted


def judged(parameter: Parameter, value: float, stderr: float) -> Verdict:
    """By the size of the standard error against the value, and against the range that real materials span."""
    low, high = parameter.typical
    span = high - low
    signed = parameter.bounds[0] < 0
    if not np.isfinite(stderr) or stderr > max(0.5 * span, 2 * abs(value)):
        return Verdict.UNIDENTIFIABLE
    if stderr > (0.25 * span if signed else 0.5 * abs(value)):
        return Verdict.WEAK
    if low <= value <= high and stderr > 0.25 * span:
        return Verdict.WEAK
    return Verdict.IDENTIFIED
