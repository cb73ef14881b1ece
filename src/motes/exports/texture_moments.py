"""A fitted map at the moments that are exported: parameters in the order of colours, and which texels have a fit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motes.errors import ParameterError
from motes.exports.subject import identifier
from motes.exports.targets import MOST_MOMENTS
from motes.maps import FittedMap, Moment, moment
from motes.models import BRDF
from motes.rendering.map_textures import channel_order, known_at

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]


@dataclass(frozen=True)
class Then:
    """A map at a moment.

    Attributes
    ----------
    name
        Of its material.
    hours
        The moment; None for a map of one.
    values
        Parameters by name, (N,) or (N, C) for colours, texels row by row; NaN where there is no fit.
    known
        Which texels have one, (y, x).
    doubtful
        Which have a parameter that the data do not determine, (y, x).
    bridged
        Which have no fit at a scan next to the moment, so that their own before and after it stand for it, (y, x).
    """

    name: str
    hours: float | None
    values: dict[str, Floats]
    known: Bools
    doubtful: Bools
    bridged: Bools


def moments_of(fitted: FittedMap, name: str, hours: float | Sequence[float] | None) -> list[Then]:
    """The moments that are asked for."""
    asked = [float(fitted.hours[0])] if hours is None else [float(x) for x in np.atleast_1d(np.asarray(hours, float))]
    if not 1 <= len(asked) <= MOST_MOMENTS or sorted(set(asked)) != asked:
        raise ParameterError(f"the moments {', '.join(f'{x:g}' for x in asked)} h do not increase", "Give each once")
    if len(fitted.hours) == 1 and hours is not None and asked != [float(fitted.hours[0])]:
        raise ParameterError(
            f"{fitted.path} holds one moment, {fitted.hours[0]:g} h, so {asked[0]:g} h means nothing",
            "Leave the hours out",
        )
    order = channel_order(fitted)
    found = []
    for t in asked:
        now: Moment = moment(fitted, t)
        values = {
            q: np.asarray(v[:, :, order] if v.ndim == 3 else v, np.float64).reshape(
                -1, *([len(order)] if v.ndim == 3 else [])
            )
            for q, v in now.values.items()
        }
        doubtful = np.zeros(fitted.shape, bool)
        for lost in now.undetermined.values():
            doubtful |= lost
        called = name if len(asked) == 1 else f"{name}_{identifier(f'at_{t:g}_h')}"
        changes = len(fitted.hours) > 1
        found.append(Then(called, t if changes else None, values, known_at(fitted, now, False), doubtful, now.bridged))
    return found


def model_of(fitted: FittedMap) -> BRDF:
    """The model with what was held, channels in the order of colours."""
    order = channel_order(fitted)
    held = {
        s.name: np.asarray(s.value)[order] for s in fitted.brdf.slots() if np.ndim(s.value) == 1 and len(s.value) > 1
    }
    return fitted.brdf.with_parameters(held)
