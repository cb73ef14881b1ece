"""What is fitted of a model, and where it stands in a parameter vector."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from motes.fitting.columns import Columns, columns_of
from motes.fitting.losses import Floats
from motes.models import BRDF
from motes.parameters import Parameter


class Quantity(NamedTuple):
    """A parameter that is fitted, and where its values stand in a parameter vector."""

    name: str
    parameter: Parameter
    per_channel: bool
    where: slice

    @property
    def bounds(self) -> tuple[float, float]:
        """What a fit searches, in the coordinate that it moves in."""
        low, high = self.parameter.fit_bounds
        return (low * low, high * high) if self.parameter.squared else (low, high)

    def coordinate(self, value: ArrayLike) -> Floats:
        """What a fit moves in: the parameter, or its square where the model depends on nothing else."""
        return np.asarray(np.square(value) if self.parameter.squared else value, float)

    def value(self, coordinate: Floats) -> Floats:
        """The parameter back from its coordinate."""
        return np.sqrt(np.maximum(coordinate, 0.0)) if self.parameter.squared else np.asarray(coordinate, float)


def columns_for(quantities: Sequence[Quantity], unit: float = 1.0) -> Columns:
    """What is known of a parameter vector beforehand; `unit` is that of the data."""
    each = [q for q in quantities for _ in range(q.where.stop - q.where.start)]
    low, high = (np.array([q.bounds[k] for q in each], float) for k in (0, 1))
    return columns_of([q.parameter for q in each], low, high, unit=unit)


def layout(model: BRDF, channels: int, fixed: frozenset[str], per_channel: frozenset[str]) -> tuple[Quantity, ...]:
    """What is fitted: every slot but those `fixed`; for each channel where declared or named in `per_channel`."""
    held, quantities, start = fixed, [], 0
    for slot in model.slots():
        if slot.name in held:
            continue
        own = (
            channels > 1
            and slot.parameter.per_channel
            and (not slot.parameter.shared_in_fit or slot.name in per_channel)
        )
        stop = start + (channels if own else 1)
        quantities.append(Quantity(slot.name, slot.parameter, own, slice(start, stop)))
        start = stop
    return tuple(quantities)
