"""What is known of the columns of a parameter vector before any data: bounds, ranges, and the coordinate a fit moves in."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from motes.arrays import Array
from motes.fitting.losses import Floats
from motes.parameters import Parameter


class Columns(NamedTuple):
    """What is known of the columns of a parameter vector beforehand; each (P, 1), or (P,) formulas.

    Attributes
    ----------
    low, high
        Bounds, in the coordinate that a fit moves in.
    span
        The width of the typical range, in that coordinate.
    least, most
        The typical range of the parameter itself.
    signed
        1 where the parameter may be negative: then an error is not judged against the value.
    squared
        1 where the coordinate is the square of the parameter.
    rest
        Where a parameter stands that the data do not see: its default, in that coordinate.
    fixed
        1 for what is held in all lanes.
    """

    low: Array
    high: Array
    span: Array
    least: Array
    most: Array
    signed: Array
    squared: Array
    rest: Array
    fixed: Array


def columns_of(
    declared: Sequence[Parameter | None],
    low: Floats,
    high: Floats,
    *,
    squared: Sequence[bool] | None = None,
    fixed: Floats | None = None,
) -> Columns:
    """The columns of a parameter vector (P,), as arrays (P, 1).

    Parameters
    ----------
    declared
        The parameter that a column is a value of; None for what is judged by its bounds alone (a time, a share).
    low, high
        Bounds (P,), in the coordinate.
    squared
        Whether the coordinate is the square of the parameter; where the parameter says so by default.
    fixed
        1 for what is held (P,).
    """
    typical = [p.typical if p else (a, b) for p, a, b in zip(declared, low, high, strict=True)]
    least, most = (np.array([t[k] for t in typical], float) for k in (0, 1))
    square = np.array([bool(p and p.squared) for p in declared] if squared is None else squared)
    span = np.where(square, most**2 - least**2, most - least)
    signed = [float(p is None or p.bounds[0] < 0) for p in declared]
    default = np.array([p.default if p else 0.5 * (a + b) for p, a, b in zip(declared, low, high, strict=True)], float)
    rest = np.clip(np.where(square, default**2, default), low, high)
    held = np.zeros(len(low)) if fixed is None else fixed
    rows = (low, high, span, least, most, signed, square, rest, held)
    return Columns(*(np.asarray(row, float)[:, None] for row in rows))


def in_own_units(x: Floats, columns: Columns) -> Floats:
    """Parameters (..., P) in their own units, from the coordinates of the fit."""
    return np.where(columns.squared[:, 0] > 0, np.sqrt(np.maximum(x, 0.0)), x)
