"""The surface of another program that is most like a material at a moment, with how far it is from it: over the hemisphere, and by light."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from motes.drawing.sphere import sphere_radiances
from motes.exports.subject import Subject
from motes.fitting.conversion import Conversion, convert
from motes.models import BRDF, Surface

Floats = NDArray[np.float64]
S = TypeVar("S", bound=Surface)

#: A surface with more parameters is taken where it is nearer than this share of the simpler one's distance.
CLEARLY = 0.95
#: Of a sphere under each light: the share of the sky, and where the lamp stands (`motes.drawing.sphere.LIGHTS`).
LIGHTINGS = {"sky": (1.0, "front"), "45 degrees": (0.0, "three-quarter"), "backlit": (0.0, "back")}
#: Pixels of the spheres that errors are counted on.
SIDE = 64


@dataclass(frozen=True)
class UnderLight:
    """How a sphere of the surface differs from one of the material.

    Attributes
    ----------
    light
        A key of `LIGHTINGS`.
    energy
        The light from the whole sphere, relative to that from the material's.
    difference
        The mean of the absolute differences of pixels, relative to the mean of the material's.
    """

    light: str
    energy: float
    difference: float

    def said(self) -> str:
        """In a few words."""
        return f"{self.light} {100 * self.difference:.2g} % (energy {self.energy:.3g})"


@dataclass(frozen=True)
class SurfaceFit:
    """A surface in the place of a material.

    Attributes
    ----------
    what
        The material at its moment.
    surface
        What was found.
    conversion
        Its distance over the hemisphere.
    lights
        Its distance under lights.
    """

    what: Subject
    surface: Surface
    conversion: Conversion
    lights: tuple[UnderLight, ...]

    def said(self) -> str:
        """Its error, in a sentence."""
        found = self.conversion
        moment = "" if self.what.hours is None else f" at {self.what.hours:g} h"
        return (
            f"Parameters of {self.surface.program} fitted{moment}: over the hemisphere {100 * found.relative_rms:.2g} % relative RMS "
            f"({100 * found.seen:.2g} % of cube roots), albedos within {found.albedo:.2g}; "
            f"spheres differ by {', '.join(light.said() for light in self.lights)}."
        )

    def record(self) -> dict[str, Any]:
        """All of it for JSON."""
        found = self.conversion
        return {
            "hours": self.what.hours,
            "parameters": self.surface.written(),
            "error": {
                "relative_rms": found.relative_rms,
                "relative_rms_of_cube_roots": found.seen,
                "largest_albedo_difference": found.albedo,
                "by_light": {
                    light.light: {"energy": light.energy, "mean_relative_difference": light.difference}
                    for light in self.lights
                },
            },
        }


def fit_surface(
    what: Subject,
    surface: type[S],
    texts: tuple[str, ...] = (),
    made: Callable[[S], S] | None = None,
    clearly: float = CLEARLY,
) -> SurfaceFit:
    """The parameters of a surface with which it looks most like a material.

    The cube root of what a light makes visible is compared, over lights from everywhere and over what a picture shows of the surface.

    Parameters
    ----------
    what
        A material at a moment, of one or three channels.
    surface
        The kind of surface.
    texts
        What of it is fitted, the simplest first; its `candidates` when not given.
    made
        What becomes of a fitted surface where a program has less.
    clearly
        A later text is taken where it is nearer than this share of the earlier one's distance.

    Raises
    ------
    DataError
        For other than one or three channels.
    MotesError
        For a material that is not reciprocal, or black.
    """
    what.colored(surface.program)
    best: Conversion | None = None
    before: BRDF | None = None
    for text in texts or surface.candidates:
        fitted = before = convert(what.brdf, text, loss="cube_root", start=before).brdf
        assert isinstance(fitted, surface)
        found = Conversion.between(what.brdf, made(fitted) if made else fitted.canonical())
        if best is None or found.seen < clearly * best.seen:
            best = found
    assert best is not None
    assert isinstance(best.brdf, surface)
    return SurfaceFit(what, best.brdf, best, by_light(what.brdf, best.brdf))


def by_light(exact: BRDF, other: BRDF) -> tuple[UnderLight, ...]:
    """How spheres of two models differ under each light."""
    found = []
    for light in LIGHTINGS:
        (wanted, covered), (got, _) = (lit(model, light, SIDE) for model in (exact, other))
        part = covered[..., None]
        whole = np.sum(part * wanted)
        found.append(
            UnderLight(light, float(np.sum(part * got) / whole), float(np.sum(part * np.abs(got - wanted)) / whole))
        )
    return tuple(found)


def lit(model: BRDF, light: str, side: int, samples: int = 1) -> tuple[Floats, Floats]:
    """A sphere under a light: its radiance (side, side, C), relative to a white diffuser that faces the light, and its coverage (side, side)."""
    sky, lamp = LIGHTINGS[light]
    (radiance,), covered = sphere_radiances(model, side, [lamp], dome=sky, samples=samples)
    return np.asarray(radiance, np.float64), np.asarray(covered, np.float64)
