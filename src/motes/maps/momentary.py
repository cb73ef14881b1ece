"""`moment`: the parameters of every texel of a fitted map at one moment, read block by block."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.errors import ParameterError
from motes.files import reading
from motes.maps.fitted import FittedMap
from motes.maps.layout import VERDICT_FLAGS
from motes.parameters import Parameter
from motes.trends import KINDS, evaluate

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]
Where = tuple[slice, slice]
LOST = VERDICT_FLAGS["unidentifiable"]


class Moment(NamedTuple):
    """The parameters of every texel at a time.

    Attributes
    ----------
    hours
        The time [h].
    values
        By quantity: float32 (y, x), or (y, x, C); NaN where `fitted` says that there is no fit.
    fitted
        Where a texel has all of its parameters, (y, x).
    bridged
        Where a scan next to this time has no fit, and the texel's own scans before and after it stand for it, (y, x).
    undetermined
        By quantity: where the data do not determine it, (y, x); nothing in stores without verdicts.
    """

    hours: float
    values: dict[str, NDArray[np.float32]]
    fitted: Bools
    bridged: Bools
    undetermined: dict[str, Bools]


def moment(fitted: FittedMap, hours: float) -> Moment:
    """The parameters at a time, as `FittedMap.material` has them at every single texel.

    With trends, each texel's trend at that time.  Where every time was fitted alone, on the straight line between the texel's last scan before and
    its first after it that has a fit; before its first and after its last they are held.  A block of the map is read at a time, and the results
    are float32: 4 bytes a texel, parameter and channel.

    Parameters
    ----------
    fitted
        The map.
    hours
        The time [h].

    Raises
    ------
    ParameterError
        For a time that is not finite.
    FormatError
        When a part of the store cannot be read.
    """
    if not np.isfinite(hours):
        raise ParameterError(f"a time of {hours} h is not finite", "Give hours as a number")
    wide = {v.quantity for v in fitted.variables.values() if v.per_channel}
    channels = len(fitted.channels)
    values = {
        q: np.full((*fitted.shape, channels) if q in wide else fitted.shape, np.nan, np.float32)
        for q in fitted.quantities
    }
    known = fitted.version > 1 and all(fitted.holds(f"{name}_verdict") for name in fitted.variables)
    found = Moment(
        float(hours),
        values,
        np.ones(fitted.shape, bool),
        np.zeros(fitted.shape, bool),
        {q: np.zeros(fitted.shape, bool) for q in fitted.quantities} if known else {},
    )
    for block in fitted.blocks:
        where = fitted.blocks.slices(block)
        for quantity in fitted.quantities:
            (_together if fitted.joint else _alone)(fitted, quantity, where, found)
    for array in found.values.values():
        array[~found.fitted] = np.nan
    return found


def _together(fitted: FittedMap, quantity: str, where: Where, found: Moment) -> None:
    """A block of a parameter from its trend."""
    colour = found.values[quantity].ndim == 3
    coefficients: dict[str, Floats] = {}
    for v in fitted.variables.values():
        if v.quantity == quantity:
            c = reading.doubles(fitted.read_map(v.name, where))
            coefficients[str(v.coefficient)] = c[..., None] if colour and not v.per_channel else c
    kind = fitted.kinds[quantity]
    basis = KINDS[kind].basis(np.asarray(found.hours), *fitted.interval)
    with np.errstate(invalid="ignore"):
        value, _ = evaluate(kind, basis, coefficients)
    _put(fitted, quantity, where, found, value)
    if found.undetermined:
        found.undetermined[quantity][where] = fitted.verdicts(quantity, where) == LOST


def _alone(fitted: FittedMap, quantity: str, where: Where, found: Moment) -> None:
    """A block of a parameter from the scans around the moment."""
    over_time = fitted.values(quantity, where)
    hours, t = fitted.hours, found.hours
    colour = over_time.ndim == 4
    good: Bools = np.asarray(np.isfinite(over_time).reshape(*over_time.shape[:3], -1).all(axis=3))
    before, after = neighbours(good, hours, t)
    shape = good.shape[:2]
    first, last = (np.take_along_axis(over_time, _index(k, colour), 2)[:, :, 0] for k in (before, after))
    span = hours[after] - hours[before]
    share = np.divide(t - hours[before], span, out=np.zeros(shape), where=span > 0)
    value = first + (share[..., None] if colour else share) * (last - first)
    _put(fitted, quantity, where, found, value)
    usual = neighbours(np.ones((1, 1, len(hours)), bool), hours, t)
    found.bridged[where] |= good.any(axis=2) & ((before != usual[0]) | (after != usual[1]))
    if found.undetermined:
        codes = fitted.verdicts(quantity, where)
        worst = [np.take_along_axis(codes, _index(k, colour), 2)[:, :, 0] == LOST for k in (before, after)]
        lost: Bools = np.asarray(worst[0] | worst[1])
        found.undetermined[quantity][where] = lost.any(axis=-1) if colour else lost


def neighbours(good: Bools, hours: Floats, t: float) -> tuple[NDArray[Any], NDArray[Any]]:
    """Positions of the last good time at or before `t` and of the first at or after it, (y, x) each; one for both where there is but one side.

    `good` is (y, x, T); where nothing is good, the result means nothing.
    """
    k = np.arange(len(hours))
    before = np.where(good & (hours <= t), k, -1).max(axis=2)
    after = np.where(good & (hours >= t), k, len(k)).min(axis=2)
    both = np.where(before < 0, after, before), np.where(after >= len(k), before, after)
    return np.clip(both[0], 0, len(k) - 1), np.clip(both[1], 0, len(k) - 1)


def _index(k: NDArray[Any], colour: bool) -> NDArray[Any]:
    """Positions in time (y, x) as `numpy.take_along_axis` wants them."""
    return k[:, :, None, None] if colour else k[:, :, None]


def _put(fitted: FittedMap, quantity: str, where: Where, found: Moment, value: Floats) -> None:
    """A block of a parameter into the whole, kept within the range that the model accepts."""
    (parameter,) = (slot.parameter for slot in fitted.brdf.slots() if slot.name == quantity)
    whole = np.isfinite(value)
    found.fitted[where] &= whole.all(axis=-1) if found.values[quantity].ndim == 3 else whole
    found.values[quantity][where] = np.clip(value.astype(np.float32), *_singles(parameter))


def _singles(parameter: Parameter) -> tuple[np.float32, np.float32]:
    """The lowest and the highest float32 that a parameter may have: pi/2 in float32 is more than pi/2."""
    low, high = (np.float32(bound) for bound in parameter.bounds)
    if float(low) < parameter.bounds[0] or parameter.open:
        low = np.nextafter(low, np.float32(np.inf))
    if float(high) > parameter.bounds[1] or (parameter.open and np.isfinite(high)):
        high = np.nextafter(high, np.float32(-np.inf))
    return low, high
