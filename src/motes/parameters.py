"""`Parameter`: one declaration (default, bounds, symbol, unit, meaning) that drives everything which needs to know a
parameter.

Validation, the bounds of a fit, the strategies of the property tests, sliders, uniforms and the tables of the
documentation are all derived from it.  A class that has parameters derives from `Parametrised` and declares them as
dataclass fields::

    @final
    @dataclass(frozen=True, eq=False)
    class Lambert(BRDF):
        K_d: Array = parameter(0.5, bounds=(0, 1), unit="", symbol="K_d", doc="diffuse reflectance", per_channel=True)
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from functools import cache
from typing import Any, Self

import numpy as np

from motes.arrays import Array, is_foreign
from motes.errors import ParameterError


@dataclass(frozen=True)
class Parameter:
    """The declaration of a parameter.

    Parameters
    ----------
    name
        As in code: ``sigma_d``.
    default
        A value to start from.
    bounds
        Smallest and largest value that the model accepts.
    open
        True when the bounds themselves are not accepted.
    fit_bounds
        The range that a fit searches, inside `bounds`.
    typical
        A finite range, inside `bounds`, that real materials span: for sliders and tests.
    starts
        Values from which a fit starts, for parameters in which the objective has several valleys; empty for those that
        enter (almost) linearly.
    symbol
        In TeX.
    unit
        ``rad``, ``1/sr``; empty for a ratio.
    doc
        The meaning, in words.
    per_channel
        True when the last axis of a value is the channels; False when one value holds for all channels.
    shared_in_fit
        True for a `per_channel` parameter that a fit holds equal over the channels unless asked otherwise.
    advice
        A sentence for those who go out of bounds.
    squared
        True where a model depends on the square of the parameter alone: its slope at 0 is 0, and a fit moves in the square.
    """

    name: str
    default: float
    bounds: tuple[float, float]
    open: bool
    fit_bounds: tuple[float, float]
    typical: tuple[float, float]
    starts: tuple[float, ...]
    symbol: str
    unit: str
    doc: str
    per_channel: bool
    shared_in_fit: bool
    advice: str
    squared: bool

    def check(self, owner: str, value: Array) -> Array:
        """`value` as a float or a read-only float array, within bounds; tensors and symbols pass as they are."""
        if is_foreign(value):
            return value
        try:
            array = np.asarray(value)
        except (TypeError, ValueError):  # ragged lists
            array = np.asarray(None)
        if array.dtype.kind not in "fiu" or not array.size:
            raise ParameterError(
                f"{owner}: {self.name} = {_shown(value)} is not a number or an array of numbers", self.hint()
            )
        if not (isinstance(value, np.ndarray) and array.dtype.kind == "f"):
            array = array.astype(np.float64)
        low, high = self.bounds
        inside = (array > low) & (array < high) if self.open else (array >= low) & (array <= high)
        inside &= np.isfinite(array)
        if not inside.all():
            worst = float(array[~inside].flat[0]) if array.ndim else float(array)
            raise ParameterError(
                f"{owner}: {self.name} = {worst:.6g} is outside {self.range()} ({self.doc})", self.hint(worst)
            )
        if array.ndim == 0:
            return float(array)
        if array.flags.writeable or not array.flags.owndata:  # what others hold, they can change
            array = array.copy()
            array.setflags(write=False)
        return array

    def range(self) -> str:
        """The accepted range as text: ``[0, 1.571] rad``."""
        left, right = "(" if self.open else "[", ")" if self.open or np.isinf(self.bounds[1]) else "]"
        return f"{left}{self.bounds[0]:.4g}, {self.bounds[1]:.4g}{right}" + (f" {self.unit}" if self.unit else "")

    def hint(self, value: float | None = None) -> str:
        """The next step for somebody who gave `value`."""
        if self.unit == "rad" and value is not None and abs(value) > self.bounds[1]:
            return f"Angles are in radians: {value:.4g} degrees is {np.deg2rad(value):.3f}"
        return self.advice or f"Choose a value in {self.range()}"


def _shown(value: object) -> str:
    """`value` as text of bounded length."""
    try:
        text = repr(value)
    except ValueError:  # Python declines to print integers of thousands of digits
        text = f"{type(value).__name__} too long to print"
    return text if len(text) <= 80 else f"{text[:77]}..."


def _same(a: Array, b: Array) -> bool:
    return a is b if is_foreign(a) or is_foreign(b) else np.array_equal(a, b)


def _hashable(value: Array) -> tuple[object, ...]:
    """Equal for values that are `_same`: float32 or float64, 0.0 or -0.0; a tensor is equal to itself only."""
    if is_foreign(value):
        return (id(value),)
    array = np.asarray(value, np.float64) + 0.0
    return (array.shape, array.tobytes())


def parameter(
    default: float,
    *,
    bounds: tuple[float, float],
    symbol: str,
    doc: str,
    unit: str = "",
    open: bool = False,
    fit_bounds: tuple[float, float] | None = None,
    typical: tuple[float, float] | None = None,
    starts: tuple[float, ...] = (),
    per_channel: bool = False,
    shared_in_fit: bool = False,
    advice: str = "",
    squared: bool = False,
) -> Any:
    """Declare a parameter as a dataclass field; see `Parameter`."""
    declared = {
        "default": default,
        "bounds": bounds,
        "open": open,
        "fit_bounds": fit_bounds or bounds,
        "typical": typical or fit_bounds or bounds,
        "starts": starts,
        "symbol": symbol,
        "unit": unit,
        "doc": doc,
        "per_channel": per_channel,
        "shared_in_fit": shared_in_fit,
        "advice": advice,
        "squared": squared,
    }
    return field(default=default, metadata={"parameter": declared})


@cache
def _declared(cls: Any) -> tuple[Parameter, ...]:
    return tuple(Parameter(name=f.name, **f.metadata["parameter"]) for f in fields(cls) if "parameter" in f.metadata)


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
        for declared in self.declared():
            object.__setattr__(self, declared.name, declared.check(type(self).__name__, getattr(self, declared.name)))

    @classmethod
    def declared(cls) -> tuple[Parameter, ...]:
        """The parameters that this class itself declares, in order."""
        return _declared(cls)  # type: ignore[arg-type]

    def children(self) -> dict[str, Parametrised]:
        """The parts of this object that have parameters of their own, by field."""
        return {f.name: value for f in fields(self) if isinstance(value := getattr(self, f.name), Parametrised)}

    def options(self) -> dict[str, str]:
        """The fields that choose a variant: ``{"form": "brdf"}``."""
        return {
            f.name: getattr(self, f.name)
            for f in fields(self)
            if "parameter" not in f.metadata and not isinstance(getattr(self, f.name), Parametrised)
        }

    def _walk(self, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Parameter, Array]]:
        """Parameters in the order of the fields, depth first."""
        declared = {p.name: p for p in self.declared()}
        for f in fields(self):
            value = getattr(self, f.name)
            if f.name in declared:
                yield (*path, f.name), declared[f.name], value
            elif isinstance(value, Parametrised):
                yield from value._walk((*path, f.name))

    def slots(self) -> tuple[Slot, ...]:
        """All parameters of the tree in order; a name met a second time gets the suffix ``_2``."""
        seen: dict[str, int] = {}
        slots = []
        for path, declared, value in self._walk():
            count = seen[declared.name] = seen.get(declared.name, 0) + 1
            name = declared.name if count == 1 else f"{declared.name}_{count}"
            slots.append(Slot(name, path, declared, value))
        return tuple(slots)

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
