"""What the files of fitted surfaces share: names of materials, sentences at the head, and the JSON beside them."""

from __future__ import annotations

import json
from collections.abc import Sequence

from motes.exports.shaders import plain
from motes.exports.subject import identifier
from motes.exports.surface_fit import LIGHTINGS, SurfaceFit
from motes.models import describe
from motes.version import __version__

#: The category of each surface's node.
NODES = {"OpenPBR": "open_pbr_surface", "StandardSurface": "standard_surface", "GltfSurface": "gltf_pbr"}


def names(fits: Sequence[SurfaceFit]) -> list[str]:
    """A name for each moment: the material's, with the time where there are several."""
    if len(fits) == 1:
        return [fits[0].what.identifier]
    return [f"{fit.what.identifier}_{identifier(f'at_{fit.what.hours:g}_h')}" for fit in fits]


def notes(fits: Sequence[SurfaceFit]) -> list[str]:
    """What a file must say: the moment, where the material is from, the error, what is left out."""
    first = fits[0]
    said = list(first.what.notes if len(fits) == 1 else first.what.origin)
    return [*said, *(fit.said() for fit in fits), first.surface.left_out]


def comment(fits: Sequence[SurfaceFit]) -> list[str]:
    """The lines at the head of a file."""
    first = fits[0]
    return [
        plain(f"{first.what.name}: {describe(first.what.brdf)}"),
        f"as {first.surface.program}, by Motes {__version__}. Colour is linear sRGB.",
        *map(plain, notes(fits)),
    ]


def record(fits: Sequence[SurfaceFit]) -> str:
    """The parameters and errors of all moments as JSON."""
    first = fits[0]
    about = {
        "motes": __version__,
        "name": first.what.name,
        "model": describe(first.what.brdf),
        "surface": first.surface.program,
        "colour": "linear sRGB",
        "loss": "cube roots of f cos(theta_i), over lights from everywhere and over what an orthographic picture shows of the surface",
        "lights": list(LIGHTINGS),
        "notes": notes(fits),
    }
    return json.dumps({**about, "moments": [fit.record() for fit in fits]}, indent=2, ensure_ascii=False) + "\n"


def rounded(values: Sequence[float]) -> tuple[float, ...]:
    """Five digits: more than any fit tells."""
    return tuple(float(f"{value:.5g}") for value in values)
