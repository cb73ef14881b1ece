"""What the printed shaders share: the checked model, its uniforms, and the words at the head of a file."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from motes import equations
from motes.errors import ParameterError
from motes.graph import tracing
from motes.material import CONVENTIONS
from motes.models import BRDF, describe
from motes.parameters import Parameter, Slot
from motes.printing.language import Language, comment
from motes.printing.names import Recording, record
from motes.printing.shading import define

LONGEST_NAME = 80
#: More channels than this are no shader: a table serves better.
MOST_CHANNELS = 256


@dataclass(frozen=True)
class Uniform:
    """A parameter of a shader.

    Attributes
    ----------
    name
        In the shader: ``motes_K_d``.
    glsl_type
        ``float``, ``vec3``, or ``float[31]``; other languages write their own.
    value
        The model's: a number, or a tuple with one for each channel.
    slot
        The parameter in the model, as `Parametrised.with_parameters` knows it: ``K_d``, ``K_d_2``.
    parameter
        Its declaration: bounds, unit, symbol, meaning.
    """

    name: str
    glsl_type: str
    value: float | tuple[float, ...]
    slot: str
    parameter: Parameter


@dataclass(frozen=True)
class Shader:
    """A printed shader.

    Attributes
    ----------
    source
        The text.
    uniforms
        Its parameters, in the order of the model.
    name
        Of the function that evaluates the model.
    language
        For people.
    channels
        1 (grey, returned three times), 3 (RGB), or the length of the array that the function fills.
    """

    source: str
    uniforms: tuple[Uniform, ...]
    name: str
    language: str
    channels: int


@dataclass(frozen=True)
class Prepared:
    """A model that can be printed."""

    model: BRDF
    recording: Recording
    channels: int
    split: tuple[str, ...]
    slots: tuple[Slot, ...]

    @property
    def arrays(self) -> bool:
        """Whether the channels are entries of arrays, because they are neither one nor three."""
        return self.channels not in (1, 3)

    def value(self, slot: Slot) -> float | tuple[float, ...]:
        """The value of a parameter as plain numbers."""
        values = tuple(float(x) for x in np.ravel(slot.value))
        return values if slot.name in self.split else values[0]

    def definition(self, language: Language, name: str, prefix: str) -> list[str]:
        """Lines that define a function of ``wi, wo`` and the parameters; see `motes.printing.shading.define`."""
        return define(self.recording, language, name=name, prefix=prefix, split=self.split, channels=self.channels)


def prepare(model: BRDF) -> Prepared:
    """Check that a model can be printed, and record it.

    Raises
    ------
    ParameterError
        When it is not a BRDF of numbers, or a parameter has axes beside the channels.
    """
    if not isinstance(model, BRDF):
        raise ParameterError(
            f"a {type(model).__name__} is not a BRDF",
            "Give a model such as OrenNayar(...), or material.at(hours=...) of a material",
        )
    channels = model.channels
    if channels > MOST_CHANNELS:
        raise ParameterError(f"{channels} channels are more than the {MOST_CHANNELS} of a shader", "Export a table")
    slots = model.slots()
    for slot in slots:
        try:
            shape = np.shape(np.asarray(slot.value, np.float64))
        except (TypeError, ValueError, RuntimeError):
            raise ParameterError(f"{slot.name} is not made of plain numbers", "Give floats or NumPy arrays") from None
        if np.prod(shape[:-1] if slot.parameter.per_channel else shape) != 1:
            raise ParameterError(
                f"{slot.name} has shape {shape}: a shader takes one material, not one for every direction or texel",
                "Choose one entry, or give the values to the shader as textures",
            )
    return Prepared(model, record(model), channels, tracing.split_slots(model, channels), slots)


def uniforms_of(prepared: Prepared, prefix: str) -> tuple[Uniform, ...]:
    """The parameters of a model under names that begin with `prefix`."""
    many = f"float[{prepared.channels}]" if prepared.arrays else "vec3"
    return tuple(
        Uniform(
            f"{prefix}{slot.name}",
            many if slot.name in prepared.split else "float",
            prepared.value(slot),
            slot.name,
            slot.parameter,
        )
        for slot in prepared.slots
    )


def packed(prepared: Prepared, offsets: Sequence[int], size: int, stride: int = 4) -> bytes:
    """A buffer of float32 values: each parameter at its offset, entries of arrays `stride` bytes apart."""
    buffer = bytearray(size)
    for slot, offset in zip(prepared.slots, offsets, strict=True):
        for k, value in enumerate(np.ravel(prepared.value(slot)).astype("<f4")):
            start = offset + k * (stride if prepared.arrays else 4)
            buffer[start : start + 4] = value.tobytes()
    return bytes(buffer)


def checked_name(name: str) -> str:
    """`name`, which must be an identifier in all shading languages.

    Raises
    ------
    ParameterError
        When it is not.
    """
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", name) or "__" in name or name.startswith("gl_"):
        raise ParameterError(
            f"{name[:LONGEST_NAME]!r} is not the name of a shader function",
            "Use letters, digits and single underscores, a letter first",
        )
    if len(name) > LONGEST_NAME:
        raise ParameterError(f"a name of {len(name)} letters is longer than {LONGEST_NAME}", "Shorten it")
    return name


def prefix_of(name: str) -> str:
    """What the other names of a shader begin with: ``motes`` for ``motes_eval``."""
    return name.rpartition("_")[0] or name


def plain(text: object) -> str:
    """A text that a comment can hold: no control characters, no line continuation, no end of a comment."""
    cleaned = "".join(c if c.isprintable() else " " for c in str(text))
    return (
        cleaned.replace("\\", "/").replace("*/", "* /").replace("</", "< /").replace("--", "- -").replace("??", "? ?")
    )


def source_of_equations() -> str:
    """The sentence of `motes.equations` that says where they come from."""
    text = " ".join((equations.__doc__ or "").split())
    match = re.search(r"The source is (.*?\(https?://\S+\))", text)
    return match[1] if match else ""


def heading(prepared: Prepared, title: str, language: str, notes: Sequence[str] = ()) -> list[str]:
    """The lines of comment at the top of a shader."""
    from motes.version import __version__

    model = describe(prepared.model)
    lines = [
        f"{plain(title)}: {model}" if title else model,
        f"{language}, printed by Motes {__version__} from its equations.",
    ]
    lines += [f"Equation numbers are those of {source_of_equations()}.", f"BRDF in {CONVENTIONS['brdf']}."]
    lines += ["Directions are of unit length. Below the horizon the value is 0.", channel_note(prepared)]
    lines += [f"Colour is {CONVENTIONS['color']}; angles are in {CONVENTIONS['angles']}.", *map(plain, notes)]
    return [line for text in lines for line in comment(text)]


def channel_note(prepared: Prepared) -> str:
    """What the channels of the result are."""
    if prepared.channels == 3:
        return "Three channels: RGB."
    if prepared.channels == 1:
        return "One channel: the three components of the result are equal."
    return f"{prepared.channels} channels, in arrays: three of them are a colour only after a conversion that is the caller's."


def about(slot: Slot, value: float | tuple[float, ...]) -> str:
    """A parameter in a line of comment: meaning, unit, range."""
    return f"{slot.parameter.doc}, {slot.parameter.range()}; here {numbers(value)}"


def numbers(value: float | tuple[float, ...]) -> str:
    """One number, or several with commas; of many the ends."""
    values: tuple[Any, ...] = value if isinstance(value, tuple) else (value,)
    return ", ".join(f"{x:.6g}" for x in values) if len(values) <= 4 else f"{values[0]:.6g} ... {values[-1]:.6g}"
