"""A fitted map at a moment as pictures for Mitsuba: colours in their order, and what stands where nothing was fitted."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.channels import colours_of
from motes.errors import DataError
from motes.maps import FittedMap, Moment, moment

Bools = NDArray[np.bool_]


class Pictures(NamedTuple):
    """What the plugin looks up.

    Attributes
    ----------
    values
        By parameter: float32 (y, x, 1) or (y, x, 3), finite everywhere.
    gaps
        Where a texel has the parameters of another, (y, x).
    """

    values: dict[str, NDArray[np.float32]]
    gaps: Bools


def pictures(fitted: FittedMap, hours: float, strict: bool = False) -> Pictures:
    """The parameters of a map at a time [h], texels without a fit filled with all parameters of the nearest texel that has one.

    Parameters
    ----------
    fitted
        The map.
    hours
        The time.
    strict
        Texels with a parameter that the data do not determine count as texels without a fit.

    Raises
    ------
    DataError
        When no texel has a fit, or when the channels are no colours.
    """
    order = channel_order(fitted)
    now = moment(fitted, hours)
    known = known_at(fitted, now, strict)
    source = nearest(known)
    found = {}
    for name, value in now.values.items():
        ordered = value[:, :, None] if value.ndim == 2 else value[:, :, order]
        found[name] = np.ascontiguousarray(ordered if source is None else ordered[source])
    return Pictures(found, ~known)


def known_at(fitted: FittedMap, now: Moment, strict: bool) -> Bools:
    """Where texels show their own parameters; raises `DataError` where none does."""
    known = now.fitted.copy()
    if strict:
        if not now.undetermined:
            raise DataError(f"{fitted.path} holds no verdicts: an earlier Motes wrote it", "Fit the map again")
        for lost in now.undetermined.values():
            known &= ~lost
    if not known.any():
        what = "has a fit of which the data determine every parameter" if strict and now.fitted.any() else "has a fit"
        raise DataError(
            f"none of the {known.size:,} texels of {fitted.path} {what}",
            "Leave out --strict" if strict and now.fitted.any() else "motes info says how its fits ended",
        )
    return known


def channel_order(fitted: FittedMap) -> list[int]:
    """Positions of red, green and blue among the channels, or of the only one.

    Raises
    ------
    DataError
        When a parameter differs among channels that are no colours.
    """
    channels = fitted.channels
    wide = [v.quantity for v in fitted.variables.values() if v.per_channel]
    if len(channels) == 1 or not wide:
        return [0]
    colours = colours_of(channels)
    if colours is None:
        shown = ", ".join(channels[:4]) + (", .." if len(channels) > 4 else "")
        raise DataError(
            f"{fitted.path}: {wide[0]} has the channels {shown}, and textures are grey or red, green and blue",
            "Name the channels R, G and B where they are, in the measured map",
        )
    return [colours.index(k) for k in range(3)]


def nearest(known: Bools) -> tuple[NDArray[np.int32], NDArray[np.int32]] | None:
    """Row and column (y, x) of the nearest texel that is known, by the distance between centres; None where all are.

    Of several at one distance the one in the nearest row is taken, above before below, left before right.
    """
    if known.all():
        return None
    height, width = known.shape
    grid = np.indices(known.shape).astype(np.int32)
    rows, columns = grid[0], grid[1]
    holes = np.nonzero(~known)
    # In each row, how far to the left and to the right the next one that is known is.
    far = np.int32(height + width)
    left = np.maximum.accumulate(np.where(known, columns, -far), axis=1)
    right = np.minimum.accumulate(np.where(known, columns, 2 * far)[:, ::-1], axis=1)[:, ::-1]
    column = np.where(columns - left <= right - columns, left, right)
    best = np.full(len(holes[0]), 2 * float(far) ** 2)
    for distance in range(height):
        open_ = best > distance**2
        if not open_.any():
            break
        for step in (-distance, distance) if distance else (0,):
            row = holes[0] + step
            at = np.nonzero(open_ & (row >= 0) & (row < height))[0]
            candidate = column[row[at], holes[1][at]].astype(float)
            total = distance**2 + (candidate - holes[1][at]) ** 2
            nearer = total < best[at]
            chosen = at[nearer]
            best[chosen] = total[nearer]
            rows[holes[0][chosen], holes[1][chosen]] = row[chosen]
            columns[holes[0][chosen], holes[1][chosen]] = candidate[nearer].astype(np.int32)
    return rows, columns
