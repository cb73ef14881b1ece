"""From the normal equations at a solution to a covariance, standard errors and verdicts, in named steps over an algebra.

The covariance is the sandwich L M L: L the inverse of the curvature H of the objective, M the sum of squared residuals times
J'J with leverages (HC3 of MacKinnon and White, 1985; `motes.fitting.problem.Problem.spread`).  It holds where the noise
differs from sample to sample, and where weights are solid angles rather than inverse variances.

A parameter at a bound has no standard error.  Those of the others are the larger of two: with it held there and, where
noise may have put it there, with it free: half of all repeats then find it off its bound, and move the others by what it takes up.
Both are sandwiches, in which each parameter meets the scatter of the samples that tell of it and no other's: a highlight
that is badly followed widens nothing but what trades with it.  As in `motes.fitting.levenberg`, NumPy runs these steps and kernels print them;
what differs from lane to lane is a value, never a branch.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from motes.arrays import Array
from motes.fitting.algebra import Algebra, absolute, flag, outer, with_diagonal
from motes.fitting.columns import Columns
from motes.fitting.verdicts import Verdict

# A parameter that, moved by the whole of its typical range, changes the residuals by less than this share of the data is
# not seen.
UNSEEN = 1e-6
# What leaves an objective alone changes it by no more than this share.
SAME = 1e-6
# The data see only sums of parameters where the variance of one grows by more than this for not knowing the others.
MOST_INFLATION = 1e6
# A parameter at a bound is held there by the data when they push it out by more than so many standard errors.
FIRM = 3.0
# No leverage leaves less than this of a residual.
LEAST_REMAINDER = 0.05

#: Verdicts as numbers: the position in this tuple.
VERDICTS = tuple(Verdict)
IDENTIFIED, WEAK, UNIDENTIFIABLE, AT_LOWER, AT_UPPER, FIXED = (float(k) for k in range(len(VERDICTS)))


class Standing(NamedTuple):
    """Where a solution stands, 1 or 0 each (P, B): at a bound, without effect on the residuals, and neither of both."""

    at_low: Array
    at_high: Array
    unseen: Array
    free: Array


class Inverse(NamedTuple):
    """The inverse of a matrix among some parameters, 0 elsewhere; 1 for those of them that the data see only sums of."""

    matrix: Array
    blurred: Array


class Errors(NamedTuple):
    """Standard errors in the coordinate of the fit, where there are any (1 or 0); and the verdicts so far (both (P, B))."""

    stderr: Array
    known: Array
    verdicts: Array


def standing(algebra: Algebra, x: Array, matrix: Array, columns: Columns, brightness: Array) -> Standing:
    """Which parameters of a solution are at a bound, and which the data do not see.

    `matrix` is H, `brightness` the weighted sum of squares of the data.
    """
    margin = 1e-9 * (columns.unit + absolute(algebra, x))
    zero, one = 0.0 * x, 0.0 * x + 1.0
    at_low = algebra.where(algebra.less(columns.low + margin, x), zero, one) * (1.0 - columns.fixed)
    at_high = algebra.where(algebra.less(x, columns.high - margin), zero, one) * (1.0 - columns.fixed) * (1.0 - at_low)
    effect = algebra.diagonal(matrix) * columns.span * columns.span
    unseen = algebra.where(algebra.less(UNSEEN**2 * brightness + 1e-300, effect), zero, one)
    return Standing(at_low, at_high, unseen, (1.0 - at_low) * (1.0 - at_high) * (1.0 - unseen) * (1.0 - columns.fixed))


def rested(algebra: Algebra, x: Array, unseen: Array, columns: Columns) -> Array:
    """The solution with what the data do not see at its default: the errors of the others may depend on where it stands."""
    return algebra.where(algebra.less(0.5 + 0.0 * x, unseen * (1.0 - columns.fixed)), columns.rest + 0.0 * x, x)


def alike(algebra: Algebra, objective: Array, trial: Array) -> Array:
    """1 where an objective is no larger at another point."""
    return flag(algebra, algebra.less(trial, objective * (1.0 + SAME) + 1e-300))


def correlation(algebra: Algebra, matrix: Array, among: Array) -> tuple[Array, Array]:
    """The matrix scaled to a diagonal of 1 among some parameters, rows of the unit matrix elsewhere; and the scale (P, B)."""
    scale = among / algebra.sqrt(algebra.maximum(algebra.diagonal(matrix), 1e-300))
    return with_diagonal(matrix * outer(scale), 0.0 * scale + 1.0), scale


def inverted(algebra: Algebra, matrix: Array, among: Array) -> Inverse:
    """The inverse of the matrix among some parameters."""
    scaled, scale = correlation(algebra, matrix, among)
    inverse = algebra.inverse(scaled)
    inflation = algebra.diagonal(inverse)
    seen = flag(algebra, algebra.less(inflation, MOST_INFLATION + 0.0 * inflation))  # NaN is not seen
    return Inverse(inverse * outer(scale), among * (1.0 - seen))


def noise_of(algebra: Algebra, matrix: Array, middle: Array, free: Array) -> Array:
    """The variance of a weighted residual (B,): the mean of M/H over the free parameters."""
    ratio = algebra.diagonal(middle) / algebra.maximum(algebra.diagonal(matrix), 1e-300)
    return algebra.total(free * ratio) / algebra.maximum(algebra.total(free), 1.0)


def loose(
    algebra: Algebra, gradient: Array, matrix: Array, inverse: Array, middle: Array, free: Array, bounded: Array
) -> Array:
    """1 for those of the parameters at a bound that noise may have put there (P, B).

    The errors of the others must hold for any value that such a parameter may have: at n = 4 the height of a highlight
    seems known, and yet n and the height are not, where F hardly changes over the data.  The push against the bound is a sum
    over the data, whose variance M tells.  Kernels make this loop of their own.
    """
    found = []
    for k in range(len(gradient)):
        if not np.any(bounded[k]):
            found.append(bounded[k])
            continue
        unit = 0.0 * gradient
        unit[k] = unit[k] + 1.0
        firm = pushed_out(algebra, unit, gradient, matrix[k], inverse, middle, free)
        found.append(bounded[k] * (1.0 - firm))
    return np.stack(found)


def pushed_out(
    algebra: Algebra, which: Array, gradient: Array, column: Array, inverse: Array, middle: Array, free: Array
) -> Array:
    """1 where the data push a parameter by more than noise would (B,): the parameter that is 1 in `which`, and its column of H (P, B)."""
    projected = -algebra.times(inverse, column) * free * (1.0 - which) + which  # the others give way
    push = algebra.total(projected * gradient)
    variance = algebra.total(projected * algebra.times(middle, projected))
    most = FIRM * algebra.sqrt(algebra.maximum(variance, 0.0))
    return flag(algebra, algebra.less(most, absolute(algebra, push)))


def diagonal_of(inverse: Array, middle: Array) -> Array:
    """The diagonal (P, B) of inverse middle inverse, for arrays; kernels go row by row."""
    i, m = np.moveaxis(inverse, 2, 0), np.moveaxis(middle, 2, 0)
    return np.asarray(np.sum((i @ m) * i, axis=2).T)


def errors(
    algebra: Algebra,
    covariance: Array,
    relaxed: Array,
    blurred_wider: Array,
    stand: Standing,
    blurred: Array,
    columns: Columns,
    loose: Array,
) -> Errors:
    """Standard errors of the sandwich with parameters at a bound held or, where that is larger, with the loose ones free.

    `relaxed` are the variances with those free (P, B), `blurred_wider` what is blurred then.
    """
    own = algebra.sqrt(algebra.maximum(algebra.diagonal(covariance), 0.0))
    zero = 0.0 * own
    some = flag(algebra, algebra.less(0.5, algebra.total(loose)))
    wide = some * algebra.sqrt(algebra.maximum(relaxed, 0.0))
    stderr = algebra.where(algebra.less(own, wide), wide, own)
    known = stand.free * (1.0 - blurred) * (1.0 - blurred_wider)
    verdicts = algebra.where(algebra.less(0.5 + zero, known), zero + IDENTIFIED, zero + UNIDENTIFIABLE)
    adrift = loose * algebra.maximum(flag(algebra, algebra.less(0.5 * columns.span, wide)), blurred_wider)
    for code, condition in (
        (AT_LOWER, stand.at_low * (1.0 - adrift)),
        (AT_UPPER, stand.at_high * (1.0 - adrift)),
        (FIXED, columns.fixed + zero),
    ):
        verdicts = algebra.where(algebra.less(0.5 + zero, condition), zero + code, verdicts)
    return Errors(stderr, known, verdicts)


def own_error(algebra: Algebra, x: Array, stderr: Array, squared: Array) -> Array:
    """A standard error in the parameter's own units: half the width of what the coordinate's interval becomes."""
    up, down = algebra.maximum(x + stderr, 0.0), algebra.maximum(x - stderr, 0.0)
    half = 0.5 * (algebra.sqrt(up) - algebra.sqrt(down))
    return algebra.where(algebra.less(0.5 + 0.0 * x, squared + 0.0 * x), half, stderr)


def own_value(algebra: Algebra, x: Array, squared: Array) -> Array:
    """A value in the parameter's own units."""
    root = algebra.sqrt(algebra.maximum(x, 0.0))
    return algebra.where(algebra.less(0.5 + 0.0 * x, squared + 0.0 * x), root, x)


def judged(algebra: Algebra, value: Array, stderr: Array, columns: Columns, verdicts: Array) -> Array:
    """The verdicts of what is identified so far: by its error against its value, and against the range that real materials span.

    Values and errors are in the parameters' own units.
    """
    zero = 0.0 * value
    span = columns.most - columns.least
    size = absolute(algebra, value)
    lost = algebra.less(algebra.maximum(0.5 * span, 2.0 * size), stderr)
    limit = algebra.where(algebra.less(0.5 + zero, columns.signed + zero), 0.25 * span, 0.5 * size)
    inside = algebra.where(
        algebra.less(value, columns.least), zero, algebra.where(algebra.less(columns.most, value), zero, zero + 1.0)
    )
    weak = algebra.maximum(
        flag(algebra, algebra.less(limit, stderr)), inside * flag(algebra, algebra.less(0.25 * span, stderr))
    )
    finite = algebra.less(stderr, 1e300 + zero)  # false for NaN
    code = algebra.where(lost, zero + UNIDENTIFIABLE, algebra.where(algebra.less(0.5 + zero, weak), zero + WEAK, zero))
    code = algebra.where(finite, code, zero + UNIDENTIFIABLE)
    return algebra.where(algebra.less(verdicts, 0.5 + zero), code, verdicts)
