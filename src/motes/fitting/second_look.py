"""Verdicts that need another fit: standard errors look at the neighbourhood of a solution only.

A fit, or many of one kind, says how it is refitted; what is asked is the same for all.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from motes.arrays import Array
from motes.fitting.algebra import Algebra, flag
from motes.fitting.columns import Columns
from motes.fitting.covariance import FIRM, IDENTIFIED, UNSEEN, WEAK, own_value
from motes.fitting.losses import Floats

# With a standard error beyond this share of its typical range, a parameter is tried half the range away as well.
DOUBTFUL = 0.1
# A parameter may as well be absent when it is within so many standard errors of its lower bound.
NEAR = 4.0
# What a refit needs no more than: a rough end is enough to tell.
REFIT_ITERATIONS, REFIT_REDUCTION = 30, 1e-5

Rows = NDArray[np.intp]


class Refit(Protocol):
    """Fits again, with parameters held: points (L, P), what is held (L, P), and which of M fits each is (L,); objectives (L,)."""

    def __call__(self, points: Floats, held: NDArray[np.bool_], fits: Rows) -> Floats: ...


class Solved(NamedTuple):
    """M solutions of one kind.

    Attributes
    ----------
    x
        Parameters (M, P) in the coordinates of the fit.
    value, stderr
        In their own units (M, P).
    objective, noise, brightness
        Half the sum of squares, the variance of a residual and the data's sum of squares (M,).
    verdicts
        Codes (M, P), changed in place.
    """

    x: Floats
    value: Floats
    stderr: Floats
    objective: Floats
    noise: Floats
    brightness: Floats
    verdicts: NDArray[np.uint8]


def look_again(
    solved: Solved,
    columns: Columns,
    groups: list[slice],
    refit: Refit,
    diagonal: Callable[[Floats, Rows], Floats],
) -> None:
    """Call weak what is identified by its error alone.

    Parameters
    ----------
    groups
        Columns that belong to one parameter: its channels.
    refit
        See `Refit`.
    diagonal
        The diagonals (L, P) of the curvature at points (L, P) of some of the fits (L,).
    """
    _as_good_elsewhere(solved, columns, refit)
    _borne_by_doubt(solved, columns, groups, refit, diagonal)


def asks(algebra: Algebra, value: Array, stderr: Array, columns: Columns) -> Array:
    """1 where `look_again` may change a verdict (B,): an error is large, or a parameter may as well be absent; values in their own units."""
    absent = own_value(algebra, columns.low, columns.squared)
    span = columns.most - columns.least
    doubtful = flag(algebra, algebra.less(DOUBTFUL * span + 0.0 * stderr, stderr))
    near = 1.0 - flag(algebra, algebra.less(NEAR * stderr, value - absent))  # also where there is no error
    return algebra.largest(algebra.maximum(doubtful, near))


def _as_good_elsewhere(solved: Solved, columns: Columns, refit: Refit) -> None:
    """What the data allow to be half its typical range away, when all others are fitted again there.

    The optical thickness of a nearly opaque layer has a steep side and a flat one.
    """
    span = (columns.most - columns.least)[:, 0]
    squared = columns.squared[:, 0] > 0
    doubtful = (solved.verdicts == int(IDENTIFIED)) & (solved.stderr > DOUBTFUL * span)
    fits, which = np.nonzero(doubtful)
    lanes: list[tuple[Rows, Rows, Floats]] = []
    for sign in (-1, 1):
        moved = solved.value[fits, which] + sign * 0.5 * span[which]
        moved = np.where(squared[which], np.sign(moved) * moved**2, moved)
        inside = (moved >= columns.low[which, 0]) & (moved <= columns.high[which, 0])
        lanes.append((fits[inside], which[inside], moved[inside]))
    at, column, to = (np.concatenate([lane[k] for lane in lanes]) for k in range(3))
    if not len(at):
        return
    points, held = solved.x[at], np.zeros((len(at), len(span)), bool)
    rows = np.arange(len(at))
    points[rows, column], held[rows, column] = to, True
    rise = refit(points, held, at) - solved.objective[at]
    fine = 2 * rise / np.maximum(solved.noise[at], 1e-300) < FIRM**2
    solved.verdicts[at[fine], column[fine]] = int(WEAK)


def _borne_by_doubt(
    solved: Solved, columns: Columns, groups: list[slice], refit: Refit, diagonal: Callable[[Floats, Rows], Floats]
) -> None:
    """Identified parameters that act only through others which may as well be absent.

    Where K_s may be 0, noise lends its highlight a width, and a small error of that width.
    """
    span, low = columns.span[:, 0], columns.low[:, 0]
    for group in groups:
        absent = np.where(columns.squared[group, 0] > 0, np.sqrt(np.maximum(low[group], 0)), low[group])
        near = ~(solved.value[:, group] - absent > NEAR * solved.stderr[:, group])  # also where there is no error
        identified = solved.verdicts == int(IDENTIFIED)
        fits = np.flatnonzero(
            near.any(axis=1) & ~(solved.x[:, group] <= low[group]).all(axis=1) & identified.any(axis=1)
        )
        if not len(fits):
            continue
        points, held = solved.x[fits], np.zeros((len(fits), len(span)), bool)
        points[:, group], held[:, group] = low[group], True
        unseen = diagonal(points, fits) * span**2 <= UNSEEN**2 * np.maximum(solved.brightness[fits], 1e-300)[:, None]
        borne = identified[fits] & unseen
        asked = borne.any(axis=1)
        if not asked.any():
            continue
        fits, points, held, borne = fits[asked], points[asked], held[asked], borne[asked]
        rise = refit(points, held, fits) - solved.objective[fits]
        fine = 2 * rise / np.maximum(solved.noise[fits], 1e-300) < FIRM**2
        rows, columns_ = np.nonzero(borne & fine[:, None])
        solved.verdicts[fits[rows], columns_] = int(WEAK)
