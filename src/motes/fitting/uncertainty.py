"""Standard errors, correlations, and what the data say about each parameter: `motes.fitting.covariance` over NumPy."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.fitting import covariance as steps
from motes.fitting.algebra import ARRAYS, outer
from motes.fitting.clusters import Middle, middle_over
from motes.fitting.columns import columns_of
from motes.fitting.direction_blocks import Labels
from motes.fitting.losses import Floats
from motes.fitting.objective import Objective
from motes.fitting.second_look import REFIT_ITERATIONS, REFIT_REDUCTION, Rows, Solved, look_again
from motes.fitting.solver import Normal
from motes.fitting.verdicts import Verdict
from motes.parameters import Parameter


class Uncertainty(NamedTuple):
    """Of a parameter vector, in the parameters' own units.

    Attributes
    ----------
    stderr
        Standard errors (P,), NaN where there is none.
    covariance
        (P, P); NaN rows where undetermined or at a bound.
    verdicts
        What the data say about each.
    steps
        Standard errors in the coordinates of the fit (P,).
    freedom
        The degrees of freedom behind them (P,).
    """

    stderr: Floats
    covariance: Floats
    verdicts: list[Verdict]
    steps: Floats
    freedom: Floats

    @property
    def correlations(self) -> Floats:
        """(P, P), NaN where undefined."""
        with np.errstate(all="ignore"):
            root = np.sqrt(np.diag(self.covariance))
            return np.asarray(self.covariance / np.outer(root, root))


def unseen(objective: Objective, x: Floats) -> NDArray[np.bool_]:
    """Which parameters the data do not see at `x` (P,)."""
    return np.asarray(_unseen(objective, x, objective.normal(x[None]))[:, 0] > 0)


def _unseen(objective: Objective, x: Floats, at: Normal) -> Floats:
    matrix, bright = np.moveaxis(at.matrix, 0, 2), np.atleast_1d(objective.brightness().sum())
    with np.errstate(all="ignore"):
        return np.asarray(steps.standing(ARRAYS, x[:, None], matrix, objective.columns, bright).unseen)


def at_rest(objective: Objective, x: Floats) -> Floats:
    """The solution `x` (P,) with what the data do not see at its default, where the others fit as well beside that."""
    at = objective.normal(x[None])
    with np.errstate(all="ignore"):
        rested = steps.rested(ARRAYS, x[:, None], _unseen(objective, x, at), objective.columns)[:, 0]
        if np.array_equal(rested, x):
            return x
        alike = steps.alike(ARRAYS, at.objective, objective.normal(rested[None]).objective)
    return rested if alike[0] > 0 else x


def uncertainty(objective: Objective, x: Floats, blocks: Labels | None = None) -> Uncertainty:
    """The uncertainty of the solution `x` (P,), with what is not seen `at_rest`; see `motes.fitting.covariance`.

    `blocks` (N,) are labels of the directions whose residuals go together (`motes.fitting.clusters`); None where samples are independent.
    """
    algebra = objective.algebra
    columns, bright = objective.columns, np.atleast_1d(objective.brightness().sum())
    at = objective.normal(x[None])
    gradient = at.gradient.T
    matrix = objective.curvature(x)[..., None]
    if np.any(np.diagonal(matrix[..., 0]) < 0):  # a robust function amid outliers: no minimum to speak of
        matrix = np.moveaxis(at.matrix, 0, 2)
    point = x[:, None]
    with np.errstate(all="ignore"):
        stand = steps.standing(algebra, point, matrix, columns, bright)
        if objective.samples <= int(stand.free.sum()):
            stand = stand._replace(unseen=1.0 - stand.at_low - stand.at_high, free=0.0 * stand.free)
        inverse = steps.inverted(algebra, matrix, stand.free)
        blurred = inverse.blurred
        if blurred.any():  # the others as if what is only seen in sums were known
            inverse = steps.inverted(algebra, matrix, stand.free * (1 - blurred))
            blurred = np.maximum(blurred, inverse.blurred)
        middle, freedom = _middle(objective, x, inverse.matrix[..., 0], blocks)
        middle = middle[..., None]
        covariance = algebra.sandwich(inverse.matrix, middle)
        free = stand.free * (1 - blurred)
        noise = steps.noise_of(algebra, matrix, middle, free)
        bounded = np.maximum(stand.at_low, stand.at_high)
        loose = steps.loose(algebra, gradient, matrix, inverse.matrix, middle, free, bounded)
        relaxed, blurred_wider = 0.0 * loose, 0.0 * loose
        if loose.any():
            wider = steps.inverted(algebra, matrix, np.maximum(free, loose))
            relaxed, blurred_wider = steps.diagonal_of(wider.matrix, middle), wider.blurred
        errors = steps.errors(algebra, covariance, relaxed, blurred_wider, stand, blurred, columns, loose)
        if objective.common:  # a scale that is uncertain moves all parameters together, however well each is known
            way = (inverse.matrix[..., 0] @ objective.pull(x))[:, None]
            covariance = covariance + outer(way)
            errors = errors._replace(stderr=np.hypot(errors.stderr, way))
        value = steps.own_value(algebra, point, columns.squared)
        stderr = np.where(errors.known > 0, steps.own_error(algebra, point, errors.stderr, columns.squared), np.nan)
        codes = steps.judged(algebra, value, stderr, columns, errors.verdicts)
    verdicts = np.round(codes.T).astype(np.uint8)
    solved = Solved(x[None], value.T, stderr.T, at.objective, noise, bright, verdicts)

    def refit(points: Floats, held: NDArray[np.bool_], fits: Rows) -> Floats:
        return objective.refitted(x, points, held, max_iterations=REFIT_ITERATIONS, reduction=REFIT_REDUCTION)

    def diagonal(points: Floats, fits: Rows) -> Floats:
        return np.stack([np.diag(objective.curvature(p)) for p in points])

    look_again(solved, columns, objective.groups, refit, diagonal)
    own = np.where(errors.known[:, 0] > 0, errors.stderr[:, 0], np.nan)
    full = _own_covariance(covariance[..., 0], own, stderr[:, 0])
    return Uncertainty(stderr[:, 0], full, [steps.VERDICTS[code] for code in verdicts[0]], own, freedom)


def _middle(objective: Objective, x: Floats, inverse: Floats, blocks: Labels | None) -> Middle:
    """The middle of the sandwich: over blocks of directions where there are any, else over samples."""
    if blocks is not None:
        return middle_over(objective, x, inverse, blocks)
    left = max(1.0, float(objective.samples - np.count_nonzero(np.diag(inverse))))
    return Middle(objective.spread(x, inverse), np.full(len(x), left))


def _own_covariance(covariance: Floats, coordinate: Floats, own: Floats) -> Floats:
    """The covariance of the parameters themselves; NaN rows for what has no error."""
    with np.errstate(all="ignore"):
        factor = own / np.sqrt(np.diag(covariance))
        return covariance * np.outer(factor, factor) + 0.0 * np.add.outer(coordinate, coordinate)


def verdict_of(parameter: Parameter, value: float, stderr: float, unit: float = 1.0) -> Verdict:
    """The verdict on one value by its standard error alone; `unit` is that of the data."""
    low, high = (np.full(1, bound) for bound in parameter.fit_bounds)
    columns = columns_of([parameter], low, high, unit=unit)
    one = np.ones((1, 1))
    code = steps.judged(ARRAYS, value * one, stderr * one, columns, 0 * one)
    return steps.VERDICTS[int(code[0, 0])]
