"""What a class declares of its fields: a `Parameter`, an `Option` (a choice of words), or the `Place` of a further part.

One declaration (default, bounds, symbol, unit, meaning, role) drives everything which needs to know a parameter: validation,
the bounds of a fit, the strategies of the property tests, sliders, uniforms, the tables of the documentation, ageing and
exports.  Who wants "the strength of the highlight" asks for its `Role`, never for a name.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from typing import Any

import numpy as np

from motes.arrays import Array, is_foreign
from motes.errors import ParameterError


class Role(Enum):
    """What a parameter is to those who do not know its model; the value says it in words.

    A model whose parameter is none of these leaves it without a role: everything works, but no phenomenon moves it and no
    finding speaks of it."""

    DIFFUSE_COLOUR = "diffuse colour"
    DIFFUSE_ROUGHNESS = "roughness of the diffuse part"
    HIGHLIGHT_STRENGTH = "strength of the highlight"
    HIGHLIGHT_WIDTH = "width of the highlight"
    HIGHLIGHT_TAIL = "tail of the highlight"
    REFRACTIVE_INDEX = "refractive index"
    EXTINCTION = "extinction coefficient"
    NORMAL_REFLECTANCE = "reflectance at normal incidence"
    DEPTH = "optical thickness of a layer"
    SINGLE_SCATTERING_ALBEDO = "single-scattering albedo"
    ASYMMETRY = "mean cosine of the scattering angle"
    SURGE_STRENGTH = "height of the opposition surge"
    SURGE_WIDTH = "width of the opposition surge"
    FURTHER_STRENGTH = "strength of a further lobe"
    FURTHER_WIDTH = "width of a further lobe"


class Place(Enum):
    """What a part is to the whole it belongs to."""

    TERM = "a term of a sum"
    BASE = "what lies below a layer"
    COVER = "what a layer is made of"
    FRESNEL = "the Fresnel term of a highlight"


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
    role
        What it is to those who do not know the model, or None.
    simpler
        The value at which its model is a simpler one, or the part that it belongs to is not there: 0 of a strength or a depth, 2 of GTR's
        gamma, at which it is GGX.  None where there is no such value.
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
    role: Role | None = None
    simpler: float | None = None

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


@dataclass(frozen=True)
class Option:
    """A field that chooses a variant by a word.

    Parameters
    ----------
    name
        Of the field.
    default
        One of `words`.
    words
        Those that are accepted.
    doc
        The meaning.
    """

    name: str
    default: str
    words: tuple[str, ...]
    doc: str

    def check(self, owner: str, value: object) -> None:
        """Raise `ParameterError` unless `value` is one of the words."""
        if value not in self.words:
            raise ParameterError(
                f"{owner}: {self.name} = {_shown(value)} is not one of {', '.join(self.words)}", "Name one of them"
            )


@dataclass(frozen=True)
class PartField:
    """A field that holds a further part with parameters of its own.

    Parameters
    ----------
    name
        Of the field.
    accepts
        The class that the part must be of.
    place
        What it is to the whole.
    required
        True where there is no default.
    optional
        True where None, no such part, is accepted.
    default
        The part, or None, where nothing is said.
    what, advice
        For messages: ``"a Fresnel term"``, and a sentence for those who gave something else.
    """

    name: str
    accepts: type[Any]
    place: Place
    required: bool
    optional: bool
    default: Any
    what: str
    advice: str

    def check(self, owner: str, value: object) -> None:
        """Raise `ParameterError` unless `value` may stand here."""
        if not (isinstance(value, self.accepts) or (self.optional and value is None)):
            raise ParameterError(
                f"{owner}: {self.name} = {_shown(value)} is not {self.what}", self.advice or f"Give {self.what}"
            )


def _shown(value: object) -> str:
    """`value` as text of bounded length."""
    try:
        text = repr(value)
    except ValueError:  # Python declines to print integers of thousands of digits
        text = f"{type(value).__name__} too long to print"
    return text if len(text) <= 80 else f"{text[:77]}..."


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
    role: Role | None = None,
    simpler: float | None = None,
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
        "role": role,
        "simpler": simpler,
    }
    return field(default=default, metadata={"parameter": declared})


def option(default: str, *, words: tuple[str, ...], doc: str = "") -> Any:
    """Declare a choice of words as a dataclass field; see `Option`."""
    return field(default=default, metadata={"option": {"default": default, "words": words, "doc": doc}})


_REQUIRED = object()


def part(
    accepts: type[Any],
    *,
    place: Place,
    default: Any = _REQUIRED,
    what: str = "",
    advice: str = "",
) -> Any:
    """Declare a further part as a dataclass field; see `PartField`.  With ``default=None`` it may be absent."""
    required = default is _REQUIRED
    declared = {
        "accepts": accepts,
        "place": place,
        "required": required,
        "optional": default is None,
        "default": None if required else default,
        "what": what or f"a {accepts.__name__}",
        "advice": advice,
    }
    metadata = {"part": declared}
    return field(metadata=metadata) if required else field(default=default, metadata=metadata)
