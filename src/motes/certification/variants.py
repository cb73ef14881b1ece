"""A reference with one of its parameters, options, terms or parts taken otherwise, in the ways that programs do."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from motes.certification.specimen import Evaluation, Floats, Specimen
from motes.drawing.colour import srgb_curve
from motes.errors import MotesError
from motes.images.transfer_functions import srgb_decode
from motes.models import BRDF, Fresnel, describe
from motes.parameters import Parametrised, Role
from motes.parameters.parametrised import Slot


class Change(NamedTuple):
    """One way in which conventions differ: a word, and what it means as a question."""

    name: str
    asks: str


SAME = Change("", "")
_ROUGHNESS = (Role.HIGHLIGHT_WIDTH, Role.DIFFUSE_ROUGHNESS)


def variants(reference: Specimen) -> Iterator[tuple[Change, Evaluation]]:
    """The reference as it is, and where it is a model of Motes, each variant."""
    yield SAME, reference.eval
    model = reference.model
    if model is None:
        return
    for slot in model.slots():
        for change, value in _otherwise(slot):
            if not np.allclose(value, slot.value) and (changed := _with(model, slot.name, value)) is not None:
                yield change, _by(changed)
    if len(model.terms()) > 1:
        yield from _terms(model)
    for part in model.walk():
        for change, name, other in _parts(part):
            try:
                changed = _exchanged(model, part, replace(part, **{name: other}))
            except MotesError:  # options that do not go together
                continue
            yield change, _by(changed)


def _by(model: BRDF) -> Evaluation:
    return lambda wi, wo: np.asarray(model.eval(wi, wo), np.float64)


def _with(model: BRDF, name: str, value: Floats) -> BRDF | None:
    try:
        return model.with_parameters({name: value})
    except MotesError:  # out of its bounds
        return None


def _otherwise(slot: Slot) -> Iterator[tuple[Change, Floats]]:
    """Other values of a parameter, and why a program would take them."""
    value, role, name = np.asarray(slot.value, np.float64), slot.parameter.role, slot.name
    if slot.parameter.unit == "rad":
        why = f"Is {name} given in radians and taken for degrees?"
        yield Change("radians-taken-for-degrees", why), value * np.pi / 180
        why = f"Is {name} turned into degrees, where radians are taken?"
        yield Change("degrees-taken-for-radians", why), value * 180 / np.pi
    if role in _ROUGHNESS:
        why = f'Is {name} squared, as a slider "roughness" is, of which alpha is the square?'
        yield Change("alpha-squared", why), value**2
        yield Change("alpha-root", f"Is {name} used where its square belongs (alpha squared in D)?"), np.sqrt(value)
        why = f"Is {name} a root of 2 too wide: Beckmann's m where the deviation of a Gaussian of slopes is meant?"
        yield Change("width-times-root-2", why), value * np.sqrt(2)
        why = f"Is {name} a root of 2 too narrow: the deviation of a Gaussian of slopes where Beckmann's m is meant?"
        yield Change("width-over-root-2", why), value / np.sqrt(2)
    if role is Role.ASYMMETRY:
        why = f"Is the sign of {name} wrong: is the angle between wi and wo taken for that of the deviation?"
        yield Change("sign-of-g", why), -value
    if slot.parameter.per_channel and value.ndim and np.ptp(value) > 0 and np.all((value >= 0) & (value <= 1)):
        yield Change("srgb-encoded", f"Is {name} sRGB-encoded, where it is to be linear?"), srgb_curve(value)
        yield Change("srgb-decoded", f"Is {name} decoded from sRGB, where it is linear already?"), srgb_decode(value)


def _terms(model: BRDF) -> Iterator[tuple[Change, Evaluation]]:
    """A sum with one of its terms times a constant, or left out."""
    for k, term in enumerate(model.terms()):
        words = describe(term)
        for factor, name, asks in (
            (np.pi, "term-times-pi", f"Is the term {words} pi times too large: is its 1/pi missing?"),
            (1 / np.pi, "term-over-pi", f"Is the term {words} pi times too small: is its 1/pi taken twice?"),
            (4.0, "term-times-4", f"Is the term {words} 4 times too large: is a 4 in its denominator missing?"),
            (2.0, "term-twice", f"Is the term {words} taken twice?"),
            (0.0, "term-missing", f"Is the term {words} missing?"),
        ):
            yield Change(name, asks), _weighted(model, k, factor)


def _weighted(model: BRDF, k: int, factor: float) -> Evaluation:
    def value(wi: Floats, wo: Floats) -> Floats:
        parts = [np.asarray(term.eval(wi, wo)) for term in model.terms()]
        parts[k] = factor * parts[k]
        return np.asarray(sum(parts), np.float64)

    return value


def _parts(part: Parametrised) -> Iterator[tuple[Change, str, str | None]]:
    """Another word for an option of a part, or nothing in the place of a part that it can do without: the field, and what it becomes."""
    kind = type(part).__name__
    for option in part.declared_options():
        for word in option.words:
            if word != getattr(part, option.name):
                yield Change(f"{option.name}-{word}", f"Is it {kind} with {option.name}={word}?"), option.name, word
    for place in part.declared_parts():
        if not place.required and getattr(part, place.name) is not None:
            word = "fresnel" if issubclass(place.accepts, Fresnel) else place.name
            yield Change(f"{word}-missing", f"Is the {word} term of {kind} missing?"), place.name, None


def _exchanged(whole: BRDF, old: Parametrised, new: Parametrised) -> BRDF:
    """The model with one of its parts, known by identity, exchanged."""

    def walk(node: Parametrised) -> Parametrised:
        if node is old:
            return new
        changed = {name: walk(child) for name, child in node.children().items()}
        return replace(node, **changed) if any(changed[n] is not c for n, c in node.children().items()) else node

    found = walk(whole)
    assert isinstance(found, BRDF)
    return found
