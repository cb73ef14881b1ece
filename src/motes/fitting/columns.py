"""What is known of the columns of a parameter vector before any data: bounds, ranges, and the coordinate a fit moves in."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.arrays import Array
from motes.fitting.losses import Floats
from motes.parameters import Parameter, Role

#: What a fit of data that are so many times as bright finds so many times as large.
STRENGTHS = (Role.DIFFUSE_COLOUR, Role.HIGHLIGHT_STRENGTH, Role.FURTHER_STRENGTH)
# Means of pi times the BRDF: data that are darker as a whole, or brighter by half, are in units of their own.
DARKEST, BRIGHTEST = 1e-3, 3.0


class Columns(NamedTuple):
    """What is known of the columns of a parameter vector beforehand; each (P, 1), or (P,) formulas.

    Attributes
    ----------
    low, high
        Bounds, in the coordinate that a fit moves in.
    unit
        How large an ordinary value is: 1, and where the data are far from what surfaces reflect that of `unit_of` for what goes with them.
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
    unit: Array
    span: Array
    least: Array
    most: Array
    signed: Array
    squared: Array
    rest: Array
    fixed: Array


def unit_of(values: NDArray[np.floating[Any]], used: NDArray[np.bool_]) -> float:
    """In what units data of a BRDF are, of which some are `used` (arrays of one shape): 1 for those of surfaces.

    Raw counts, or values in other units, are far from what a surface reflects; ranges, margins and defaults that are made for surfaces go
    with them.  It is the mean that says that data are dark, and the median that they are bright, since highlights are bright and few.
    """
    sizes = np.abs(values if used.all() else values[used])
    mean = np.pi * float(sizes.mean()) if sizes.size else 0.0
    if mean <= 0.5 * BRIGHTEST:  # and so is the median
        return unit_between(mean, mean)
    return unit_between(mean, np.pi * float(np.median(sizes)))


def unit_between(most: float, middle: float) -> float:
    """The unit of data whose brightness is `most` in all and `middle` by half."""
    if 0 < most < DARKEST:
        return max(most / DARKEST, 1e-30)
    return max(1.0, middle / BRIGHTEST)


def columns_of(
    declared: Sequence[Parameter | None],
    low: Floats,
    high: Floats,
    *,
    squared: Sequence[bool] | None = None,
    fixed: Floats | None = None,
    unit: float = 1.0,
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
    unit
        Of the data, as `unit_of` says.
    """
    typical = [p.typical if p else (a, b) for p, a, b in zip(declared, low, high, strict=True)]
    strength = np.array([bool(p and p.role in STRENGTHS) for p in declared], bool)
    # What has no upper bound has no scale of its own either: its range and its default go with the data.
    own = np.where(strength & np.isinf(high), unit, 1.0)
    least, most = (np.array([t[k] for t in typical], float) * own for k in (0, 1))
    square = np.array([bool(p and p.squared) for p in declared] if squared is None else squared)
    span = np.where(square, most**2 - least**2, most - least)
    signed = [float(p is None or p.bounds[0] < 0) for p in declared]
    default = np.array([p.default if p else 0.5 * (a + b) for p, a, b in zip(declared, low, high, strict=True)], float)
    default = default * own
    rest = np.clip(np.where(square, default**2, default), low, high)
    held = np.zeros(len(low)) if fixed is None else fixed
    rows = (
        low,
        high,
        np.where(strength, np.minimum(unit, high - low), 1.0),
        span,
        least,
        most,
        signed,
        square,
        rest,
        held,
    )
    return Columns(*(np.asarray(row, float)[:, None] for row in rows))


def in_own_units(x: Floats, columns: Columns) -> Floats:
    """Parameters (..., P) in their own units, from the coordinates of the fit."""
    return np.where(columns.squared[:, 0] > 0, np.sqrt(np.maximum(x, 0.0)), x)
