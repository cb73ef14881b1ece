"""Standard errors, correlations, and what the data say about each parameter."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from motes.fitting.losses import Floats
from motes.fitting.problem import Problem
from motes.fitting.result import Verdict
from motes.parameters import Parameter

# An eigenvalue of the normal matrix (scaled to a diagonal of 1) below this: along its vector the data see nothing.
NULL_EIGENVALUE = 1e-9
# A parameter that, moved by the whole of its typical range, changes the residuals by less than this share of the data
# is not seen.
UNSEEN = 1e-6


class Uncertainty(NamedTuple):
    """Standard errors (P,), correlations (P, P) (NaN where undefined) and verdicts, for a parameter vector."""

    stderr: Floats
    correlations: Floats
    verdicts: list[Verdict]


def uncertainty(problem: Problem, x: Floats) -> Uncertainty:
    """The uncertainty of the solution `x` (P,).

    The covariance is the sandwich H^-1 M H^-1 with H the curvature of the objective (`Problem.curvature`) and M the sum
    of squared residuals times J'J (HC3, see `Problem.spread`): it holds where the noise differs from sample to sample, and where the weights are solid
    angles rather than inverse variances."""
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
        scale = 1 / np.sqrt(diagonal[free])
        eigenvalues, vectors = np.linalg.eigh(matrix[np.ix_(free, free)] * np.outer(scale, scale))
        null = eigenvalues < NULL_EIGENVALUE
        inverted = np.where(null, 0, 1 / np.where(null, 1, eigenvalues))
        inverse = np.zeros((size, size))
        inverse[np.ix_(free, free)] = (vectors * inverted) @ vectors.T * np.outer(scale, scale)
        covariance = inverse @ problem.spread(x, inverse) @ inverse
        stderr[free] = np.sqrt(np.diag(covariance)[free])
        for k in free[np.any(np.abs(vectors[:, null]) > 0.1, axis=1)].tolist():
            verdicts[k], stderr[k] = Verdict.UNIDENTIFIABLE, np.nan
        for k in free.tolist():
            if verdicts[k] == Verdict.IDENTIFIED:
                verdicts[k] = judged(declared[k], x[k], stderr[k])
        known = np.flatnonzero(np.isfinite(stderr) & (stderr > 0))
        correlations[np.ix_(known, known)] = covariance[np.ix_(known, known)] / np.outer(stderr[known], stderr[known])
    else:
        for k in free.tolist():
            verdicts[k] = Verdict.UNIDENTIFIABLE
    return Uncertainty(stderr, correlations, verdicts)


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
