"""`Parametrised`: a frozen dataclass of parameters, options and further parts, and its walk through the tree of parts.

A class that has parameters derives from it and declares them as dataclass fields::

    @final
    @dataclass(frozen=True, eq=False)
    class Lambert(BRDF):
        K_d: Array = parameter(0.5, bounds=(0, 1), symbol="K_d", doc="diffuse reflectance", per_channel=True,
                               role=Role.DIFFUSE_COLOUR)
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from functools import cache, cached_property
from typing import Any, Self

import numpy as np

from motes.arrays import Array, is_foreign
from motes.errors import ParameterError
from motes.parameters.fields import Option, Parameter, PartField, Place, Role


def _same(a: Array, b: Array) -> bool:
    return a is b if is_foreign(a) or is_foreign(b) else np.array_equal(a, b)


def _hashable(value: Array) -> tuple[object, ...]:
    """Equal for values that are `_same`: float32 or float64, 0.0 or -0.0; a tensor is equal to itself only."""
    if is_foreign(value):
        return (id(value),)
    array = np.asarray(value, np.float64) + 0.0
    return (array.shape, array.tobytes())


@cache
def _declared(cls: Any) -> tuple[Parameter, ...]:
    return tuple(Parameter(name=f.name, **f.metadata["parameter"]) for f in fields(cls) if "parameter" in f.metadata)


@cache
def _members(cls: Any) -> tuple[tuple[str, Parameter | None], ...]:
    """All fields in order, with the parameters that they are."""
    declared = {p.name: p for p in _declared(cls)}
    return tuple((f.name, declared.get(f.name)) for f in fields(cls))


@cache
def _options(cls: Any) -> tuple[Option, ...]:
    return tuple(Option(name=f.name, **f.metadata["option"]) for f in fields(cls) if "option" in f.metadata)


@cache
def _part_fields(cls: Any) -> tuple[PartField, ...]:
    return tuple(PartField(name=f.name, **f.metadata["part"]) for f in fields(cls) if "part" in f.metadata)


@dataclass(frozen=True)
class Slot:
    """A parameter in its place in a tree of models: ``slot.name`` is unique in the tree."""

    name: str
    path: tuple[str, ...]
    parameter: Parameter
    value: Array


@dataclass(frozen=True, eq=False)
class Parametrised:
    """A frozen dataclass whose fields are parameters, options (strings) or further `Parametrised` objects."""

    def __post_init__(self) -> None:
        owner = type(self).__name__
        for option in self.declared_options():
            option.check(owner, getattr(self, option.name))
        for place in self.declared_parts():
            place.check(owner, getattr(self, place.name))
        for declared in self.declared():
            object.__setattr__(self, declared.name, declared.check(owner, getattr(self, declared.name)))

    @classmethod
    def declared(cls) -> tuple[Parameter, ...]:
        """The parameters that this class itself declares, in order."""
        return _declared(cls)  # type: ignore[arg-type]

    @classmethod
    def declared_options(cls) -> tuple[Option, ...]:
        """The choices of words that this class itself declares, in order."""
        return _options(cls)  # type: ignore[arg-type]

    @classmethod
    def declared_parts(cls) -> tuple[PartField, ...]:
        """The fields of further parts that this class itself declares, in order."""
        return _part_fields(cls)  # type: ignore[arg-type]

    def children(self) -> dict[str, Parametrised]:
        """The parts of this object that have parameters of their own, by field."""
        return {f.name: value for f in fields(self) if isinstance(value := getattr(self, f.name), Parametrised)}

    def options(self) -> dict[str, str]:
        """The fields that choose a variant: ``{"form": "brdf"}``."""
        others = (f.name for f in fields(self) if not {"parameter", "part"} & f.metadata.keys())
        return {name: value for name in others if not isinstance(value := getattr(self, name), Parametrised)}

    def _walk(self, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Parameter, Array]]:
        """Parameters in the order of the fields, depth first."""
        for name, declared in _members(type(self)):  # type: ignore[arg-type]
            value = getattr(self, name)
            if declared is not None:
                yield (*path, name), declared, value
            elif isinstance(value, Parametrised):
                yield from value._walk((*path, name))

    def at_place(self, place: Place) -> tuple[Any, ...]:
        """The parts of this object itself that have such a place, in order; absent ones are left out."""
        found = (getattr(self, p.name) for p in self.declared_parts() if p.place is place)
        return tuple(part for part in found if part is not None)

    def walk(self) -> Iterator[Parametrised]:
        """This object and all parts below it, depth first."""
        yield self
        for child in self.children().values():
            yield from child.walk()

    def slots(self, *roles: Role) -> tuple[Slot, ...]:
        """All parameters of the tree in order, or those with one of `roles`.

        A name met a second time gets the suffix ``_2``.
        """
        return tuple(slot for slot in self._slots if slot.parameter.role in roles) if roles else self._slots

    @cached_property
    def _slots(self) -> tuple[Slot, ...]:
        """All of them, found once: a fit asks for them dozens of times."""
        seen: dict[str, int] = {}
        slots = []
        for path, declared, value in self._walk():
            count = seen[declared.name] = seen.get(declared.name, 0) + 1
            name = declared.name if count == 1 else f"{declared.name}_{count}"
            slots.append(Slot(name, path, declared, value))
        return tuple(slots)

    def beside(self, slot: Slot, role: Role) -> Slot | None:
        """The parameter of that role in the same part as `slot`: the width of the highlight whose strength it is."""
        return next((other for other in self.slots(role) if other.path[:-1] == slot.path[:-1]), None)

    @property
    def parameters(self) -> dict[str, Array]:
        """Values by name, for the whole tree."""
        return {slot.name: slot.value for slot in self.slots()}

    def with_parameters(self, values: Mapping[str, Array]) -> Self:
        """A copy with some parameters replaced, by the names of `slots`; values are checked."""
        slots = {slot.name: slot for slot in self.slots()}
        unknown = [name for name in values if name not in slots]
        if unknown:
            raise ParameterError(f"{type(self).__name__} has no parameter {unknown[0]!r}", f"It has {', '.join(slots)}")
        return self._replaced({slots[name].path: value for name, value in values.items()})

    def _replaced(self, by_path: Mapping[tuple[str, ...], Array]) -> Self:
        changes: dict[str, Any] = {path[0]: value for path, value in by_path.items() if len(path) == 1}
        for name, child in self.children().items():
            inner = {path[1:]: value for path, value in by_path.items() if len(path) > 1 and path[0] == name}
            if inner:
                changes[name] = child._replaced(inner)
        return replace(self, **changes) if changes else self

    def __eq__(self, other: object) -> bool:
        if type(self) is not type(other) or not isinstance(other, Parametrised):
            return NotImplemented
        return (
            self.options() == other.options()
            and all(_same(getattr(self, p.name), getattr(other, p.name)) for p in self.declared())
            and self.children() == other.children()
        )

    def __hash__(self) -> int:
        values = (_hashable(getattr(self, p.name)) for p in self.declared())
        return hash((type(self).__name__, *self.options().items(), *values, *self.children().items()))
