"""What is exported: one BRDF with its name, its channels, and the sentences that a file must say about it."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass
from typing import Any

import numpy as np

from motes.channels import default_names, names_or_default
from motes.errors import DataError, ParameterError
from motes.material import Material
from motes.measurements.origin import not_measured
from motes.models import BRDF, describe, layer_of

LONGEST_NAME = 48


@dataclass(frozen=True)
class Subject:
    """A BRDF to export.

    Attributes
    ----------
    name
        Of the material, for people.
    brdf
        At the moment that is exported.
    channels, wavelengths
        Names, and wavelengths [nm] where they are spectral.
    notes
        What a file must say besides its formula: the moment of a material that changes, and that data were simulated.
    material, hours
        The whole of it, and the moment; None where it does not change.
    """

    name: str
    brdf: BRDF
    channels: tuple[str, ...]
    wavelengths: tuple[float, ...]
    notes: tuple[str, ...]
    material: Material
    hours: float | None = None

    @property
    def identifier(self) -> str:
        """The name as one that all languages accept: lower-case letters, digits and single underscores."""
        return identifier(self.name)

    @property
    def origin(self) -> tuple[str, ...]:
        """What a file of any moments must say: that the material was fitted to simulated data."""
        return _origin(self.material)

    @property
    def title(self) -> str:
        """The name with the model, for the head of a file."""
        return f"{self.name}: {describe(self.brdf)}"

    def colored(self, target: str) -> None:
        """Check that a format whose colours have three components can hold it.

        Raises
        ------
        DataError
            When it has other than one or three channels.
        """
        if self.brdf.channels not in (1, 3):
            raise DataError(
                f"{self.name} has {self.brdf.channels} channels, and {target} holds one or three",
                "glsl, wgsl, hlsl, osl, c and csv take any number",
            )


def identifier(name: str) -> str:
    """A name as one that all languages accept: lower-case letters, digits and single underscores."""
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode()
    words = re.sub(r"[^a-z0-9]+", "_", plain.lower()).strip("_")[:LONGEST_NAME].strip("_")
    return words if words[:1].isalpha() else f"material_{words}".strip("_")


def subject(material: Any, hours: float | None = None) -> Subject:
    """A material, at a moment, or a BRDF as it is.

    Parameters
    ----------
    material
        A `Material` or a BRDF.
    hours
        The moment [h] of a material that follows time; its first one when not given.

    Raises
    ------
    ParameterError
        When `material` is neither, or a moment is given for one that does not change.
    """
    if isinstance(material, BRDF):
        material = Material(material, channels=default_names(material.channels))
    if not isinstance(material, Material):
        raise ParameterError(
            f"a {type(material).__name__} is neither a material nor a BRDF", "motes.load reads a material from its file"
        )
    interval = material.interval
    if interval is None:
        if hours is not None:
            raise ParameterError(
                f"{material.name} does not change, so {hours:g} h means nothing", "Leave the hours out"
            )
        return Subject(
            material.name, material.brdf, _channels(material), material.wavelengths, _origin(material), material
        )
    moment = interval[0] if hours is None else hours
    notes = [
        *_origin(material),
        f"The material follows time ({interval[0]:g} to {interval[1]:g} h); this is how it is at {moment:g} h.",
    ]
    if not interval[0] <= moment <= interval[1]:
        notes.append(f"{moment:g} h is outside the times that were observed.")
    if hours is None:
        notes.append("No time was asked for, so the first was taken.")
    return Subject(
        material.name,
        material.at(moment),
        _channels(material),
        material.wavelengths,
        tuple(notes),
        material,
        float(moment),
    )


def _origin(material: Material) -> tuple[str, ...]:
    said = not_measured(material.about.get("data"))
    converted = str(material.about.get("converted", ""))
    return tuple(text for text in (said, converted) if text)


def _channels(material: Material) -> tuple[str, ...]:
    return names_or_default(material.channels, material.brdf.channels)


def as_rgb(values: Any) -> np.ndarray:
    """Values (..., 1) or (..., 3) with three channels."""
    return np.broadcast_to(values, (*np.shape(values)[:-1], 3))


def depth_of(model: BRDF, program: str) -> str:
    """The name of the optical thickness of the dust on a model, for the vertices of a mesh that a program shows.

    Raises
    ------
    ParameterError
        For a model without dust on top.
    DataError
        For other than one or three channels.
    """
    layer = layer_of(model)
    if layer is None:
        raise ParameterError(
            f"{describe(model)} has no layer of dust on top", "motes age MATERIAL --phenomenon dust lays one over it"
        )
    if model.channels not in (1, 3):
        raise DataError(
            f"the material has {model.channels} channels ({', '.join(default_names(model.channels)[:3])}, ...), and {program} holds one or three",
            "Write -o NAME.ply, which holds tau alone",
        )
    return layer.depth.name
