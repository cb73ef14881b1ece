"""What a composed model is made of, asked for by roles and places: whoever asks needs no class by name."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from motes.errors import ParameterError
from motes.models.base import BRDF
from motes.parameters import Place, Role, Slot


@dataclass(frozen=True)
class Layer:
    """A model that is a layer over another one.

    Parameters
    ----------
    whole
        The model.
    depth
        The parameter of its optical thickness.
    base
        What lies below.
    """

    whole: BRDF
    depth: Slot
    base: BRDF

    @property
    def own(self) -> tuple[Slot, ...]:
        """The parameters of the layer itself: its thickness, and what it is made of."""
        return tuple(slot for slot in self.whole.slots() if slot.path[0] != self._field)

    @property
    def below(self) -> tuple[Slot, ...]:
        """The parameters of what lies below."""
        return tuple(slot for slot in self.whole.slots() if slot.path[0] == self._field)

    def slot(self, role: Role) -> Slot | None:
        """The parameter of the layer itself that has this role."""
        return next((slot for slot in self.own if slot.parameter.role is role), None)

    def over(self, base: BRDF) -> BRDF:
        """The same layer over another base."""
        return replace(self.whole, **{self._field: base})

    def with_values(self, values: dict[Role, Any]) -> BRDF:
        """The model with other values of the layer's own parameters, by their roles.

        Raises
        ------
        ParameterError
            Where the layer has no parameter of such a role.
        """
        changes = {}
        for role, value in values.items():
            slot = self.slot(role)
            if slot is None:
                raise ParameterError(
                    f"{self.whole.in_words()}: the layer has no {role.value}",
                    f"It has {', '.join(s.name for s in self.own)}",
                )
            changes[slot.name] = value
        return self.whole.with_parameters(changes)

    @property
    def _field(self) -> str:
        return next(p.name for p in self.whole.declared_parts() if p.place is Place.BASE)


def layer_of(model: BRDF) -> Layer | None:
    """The layer on top of a model; None for one that is not covered."""
    bases = model.at_place(Place.BASE)
    depth = next((slot for slot in model.slots(Role.DEPTH) if len(slot.path) == 1), None)
    return Layer(model, depth, bases[0]) if bases and depth is not None else None


def in_words(model: BRDF, *, dusty: bool | None) -> str:
    """A model as reports name it: a layer is called what it is made of where that was found, and else what it does."""
    layer = layer_of(model)
    return model.in_words() if layer is None or dusty else f"{layer.base.in_words()}, with a grazing roll-off"


def on_base(model: BRDF, change: Callable[[BRDF], BRDF]) -> BRDF:
    """The model with what lies below all its layers changed; itself changed where it has none."""
    layer = layer_of(model)
    return change(model) if layer is None else layer.over(on_base(layer.base, change))
