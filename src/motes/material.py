"""`Material`: a BRDF whose parameters may follow time, saved as JSON that says its own conventions."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Self, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.channels import default_names, spectral_names
from motes.errors import FormatError, MotesError, ParameterError
from motes.files import structured, write_json
from motes.models import BRDF, describe, parse
from motes.parameters import Parameter
from motes.trends import AnyTrend, Tabulated, trend_from_dict

VERSION = 1
LARGEST_FILE = 64 * 2**20
CONVENTIONS = {
    "angles": "radians",
    "brdf": "1/sr, without the cosine; wi to the light, wo to the viewer, local frame, z = normal",
    "color": "linear",
}


@final
@dataclass(frozen=True)
class Material:
    """A named BRDF, of which some parameters may be functions of time.

    Parameters
    ----------
    brdf
        The model with its parameters; for those that follow time, their values at the first moment.
    name
        For people.
    channels
        Names of the channels, as many as the BRDF has (one name serves a grey BRDF); by default those of the wavelengths, else grey, or
        R, G, B, or numbers.
    wavelengths
        Of the channels [nm]; empty when they are not spectral.
    trends
        By the names of the BRDF's parameters; what is not named does not change.
    about
        Where it comes from: data, loss, residuals; plain JSON values.
    """

    brdf: BRDF
    name: str = "material"
    channels: tuple[str, ...] = ()
    wavelengths: tuple[float, ...] = ()
    trends: Mapping[str, AnyTrend] = field(default_factory=dict)
    about: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        slots = [slot.name for slot in self.brdf.slots()]
        unknown = [name for name in self.trends if name not in slots]
        if unknown:
            raise ParameterError(
                f"{describe(self.brdf)} has no parameter {unknown[0]!r} to follow a trend", f"It has {', '.join(slots)}"
            )
        every = (self.brdf.channels, *(_width(trend) for trend in self.trends.values()))
        widths = {width for width in every if width is not None and width > 1}
        if not self.channels:
            names = spectral_names(self.wavelengths) or default_names(max(widths, default=1))
            object.__setattr__(self, "channels", names)
        count = len(self.channels)
        if self.wavelengths and (len(self.wavelengths) != count or not all(0 < w < np.inf for w in self.wavelengths)):
            raise ParameterError(
                f"{len(self.wavelengths)} wavelengths do not fit {count} channels, or are no lengths",
                "Give one above 0 [nm] for each channel, or none",
            )
        widths -= {count}
        if widths and count > 1:
            raise ParameterError(
                f"{count} channels are named, and a parameter has {widths.pop()} values", "Give as many names as values"
            )

    def at(self, hours: ArrayLike = 0.0) -> BRDF:
        """The BRDF at a time, or at many.

        Parameters
        ----------
        hours
            A time [h], or times (T,): then the parameters that change have a leading axis T, and ``eval`` of directions (N, 3) gives (T, N, C).

        Raises
        ------
        ParameterError
            When a time is not finite.
        """
        t = np.asarray(hours, float)
        if not np.isfinite(t).all():
            raise ParameterError(
                f"a time of {t.ravel()[~np.isfinite(t.ravel())][0]} h is not finite", "Give hours as numbers"
            )
        values = {}
        for slot in self.brdf.slots():
            if slot.name in self.trends:
                value = _inside(self.trends[slot.name](t), slot.parameter)
                if t.ndim:  # an axis for the directions, between the times and the channels
                    value = (
                        value[..., None, :]
                        if value.ndim > t.ndim
                        else (value[..., None, None] if slot.parameter.per_channel else value[..., None])
                    )
                values[slot.name] = value
        return self.brdf.with_parameters(values) if values else self.brdf

    @property
    def interval(self) -> tuple[float, float] | None:
        """The times [h] over which its trends were observed; None for a material that does not change."""
        intervals = [trend.interval for trend in self.trends.values()]
        return (min(a for a, _ in intervals), max(b for _, b in intervals)) if intervals else None

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON values; see `save`."""
        parameters = {
            slot.name: {
                "value": np.asarray(slot.value).tolist(),
                "unit": slot.parameter.unit,
                "meaning": slot.parameter.doc,
            }
            for slot in self.brdf.slots()
        }
        return {
            "format": "motes material",
            "version": VERSION,
            "name": self.name,
            "model": describe(self.brdf),
            "parameters": parameters,
            "channels": list(self.channels),
            "wavelengths_nm": list(self.wavelengths),
            "trends": {name: trend.to_dict() for name, trend in self.trends.items()},
            "time_unit": "h",
            "conventions": CONVENTIONS,
            "about": dict(self.about),
        }

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Self:
        """Back from `to_dict`; raises `FormatError` when something is missing or out of range."""
        if not isinstance(data, Mapping) or data.get("format") != "motes material":
            raise FormatError(
                "this JSON is not a Motes material: its 'format' is not 'motes material'",
                "motes fit DATA -o OUT writes one",
            )
        if not isinstance(data.get("version"), int) or data["version"] > VERSION:
            raise FormatError(
                f"material version {data.get('version')!r} is newer than {VERSION}, which this Motes reads",
                "Install a newer Motes",
            )
        try:
            values = {str(name): entry["value"] for name, entry in data["parameters"].items()}
            brdf = parse(str(data["model"])).model.with_parameters(values)
            return cls(
                brdf=brdf,
                name=str(data.get("name", "material")),
                channels=tuple(str(c) for c in data.get("channels", ())),
                wavelengths=tuple(float(w) for w in data.get("wavelengths_nm", ())),
                trends={str(name): trend_from_dict(t) for name, t in dict(data.get("trends", {})).items()},
                about=dict(data.get("about", {})),
            )
        except (KeyError, TypeError, AttributeError, ValueError, IndexError, OverflowError) as error:
            if isinstance(error, MotesError):
                raise
            raise FormatError(
                f"the material is incomplete or damaged: {error}", "Write it again with motes fit"
            ) from error

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write the material as JSON, whole or not at all."""
        return write_json(path, self.to_dict())


def _width(trend: AnyTrend) -> int | None:
    """Channels of a trend's values; None when they have none."""
    if isinstance(trend, Tabulated):
        return None if trend.values.ndim == 1 else trend.values.shape[1]
    return trend.channels


def _finite(value: Any, where: str) -> None:
    """Refuse JSON with numbers that are not: Python reads Infinity, and 1e400 as one."""
    if isinstance(value, float) and not np.isfinite(value):
        raise FormatError(f"{where} is {value}, not a finite number", "Write the material again with motes fit")
    members = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, member in members:
        _finite(member, f"{where}.{str(key)[:40]}")


def _inside(value: NDArray[np.float64], parameter: Parameter) -> NDArray[np.float64]:
    """Within the range that the model accepts; an open bound is kept off by a hair."""
    low, high = parameter.bounds
    hair = 1e-9 * (high - low) if parameter.open else 0.0
    return np.clip(value, low + hair, high - hair)


def load(path: str | os.PathLike[str]) -> Material:
    """Read a material that `Material.save` wrote.

    Raises
    ------
    FormatError
        When the file is not there, too large, not JSON, or not a material.
    """
    file = Path(path)
    try:
        if file.stat().st_size > LARGEST_FILE:
            raise FormatError(
                f"{file} has {file.stat().st_size} bytes, more than the {LARGEST_FILE} that a material may have",
                "Give the path of a material that motes fit wrote",
            )
        data = structured.json_object(file)
    except OSError as error:
        raise FormatError(
            f"{file} cannot be read: {error.strerror or error}", "Give the path of a material that motes fit wrote"
        ) from error
    _finite(data, str(file))
    return Material.from_dict(data)
