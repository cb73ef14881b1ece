"""Fit the formulas of `motes.models.facet_albedo` to quadrature, and print their numbers and errors.

usage: python tools/albedo_fit.py
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from itertools import product

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from motes.arrays import NUMPY
from motes.directions import from_spherical
from motes.models import BRDF, GGX, Beckmann, Dielectric, Fresnel, Schlick, TorranceSparrow
from motes.models.facet_albedo import FacetAlbedo

Floats = NDArray[np.float64]
Make = Callable[[float, Fresnel | None], BRDF]
COSINES = np.array([0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0])
ROUGH = np.array([0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0])
COMMON = 0.7  # the roughness up to which errors are said first
TERMS = 4
KINDS: dict[str, tuple[Make, Floats]] = {
    "GGX": (lambda width, fresnel: GGX(1.0, width, fresnel), ROUGH),
    "Beckmann": (lambda width, fresnel: Beckmann(1.0, width, fresnel), ROUGH),
    "Torrance-Sparrow": (
        lambda width, fresnel: TorranceSparrow(1.0, width, "facets", fresnel),
        np.append(ROUGH, [1.2, 1.4, 1.57]),
    ),
}


def seen(model: BRDF) -> Floats:
    """The albedo at all cosines."""
    return np.asarray(model.directional_albedo(from_spherical(np.arccos(COSINES), 0.0))[:, 0])


def lost(widths: Floats, table: Floats, scale: float, power: int) -> tuple[Floats, float, float]:
    """c by least squares, which are linear, and the errors up to the common roughness and of all."""
    width, mu = (x.ravel() for x in np.meshgrid(widths, COSINES, indexing="ij"))
    x = mu / (mu + scale * width)
    terms = np.stack([(1 - x) ** power * width**j * x**k for j, k in product(range(TERMS), repeat=2)], -1)
    # Near the horizon and for the roughest less is asked for.
    weight = np.where(mu < 0.04, 0.3, 1.0) * np.where(width > 0.85, 0.5, 1.0)
    c = np.linalg.lstsq(terms * weight[:, None], (1 - table.ravel()) * weight, rcond=None)[0]
    off = np.abs(terms @ c - (1 - table.ravel()))
    return c.reshape(TERMS, TERMS), float(off[width <= COMMON].max()), float(off.max())


def main() -> None:
    for name, (make, widths) in KINDS.items():
        table = np.array([seen(make(width, None)) for width in widths])
        tried = [
            (lost(widths, table, scale, power), scale, power) for scale in (0.7, 1.0, 1.4, 1.7, 2.0) for power in (1, 2)
        ]
        (c, common, every), scale, power = min(tried, key=lambda found: found[0][1])
        bare = FacetAlbedo(scale, power, tuple(map(tuple, c)), (0.0, 0.0, 0.0))
        chosen = [width for width in widths if 0.05 <= width <= COMMON]
        glassy = [
            (width, term, seen(make(width, term))) for width, term in product(chosen, (Dielectric(1.5), Schlick(0.04)))
        ]
        off = partial(missed, bare, glassy)
        grazing = least_squares(off, [1.0, -0.5, -0.5]).x
        print(f"{name}: FacetAlbedo({scale}, {power}, {np.round(c, 4).tolist()}, {np.round(grazing, 3).tolist()})")
        print(
            f"  errors {common:.3f} up to {COMMON}, {every:.3f} of all; with a dielectric {np.abs(off(grazing)).max():.3f}"
        )


def missed(bare: FacetAlbedo, glassy: list[tuple[float, Fresnel, Floats]], grazing: Floats) -> Floats:
    """Errors with Fresnel terms for the numbers of the cosine at the facets."""
    told = FacetAlbedo(bare.scale, bare.power, bare.lost, (grazing[0], grazing[1], grazing[2]))
    return np.concatenate([told(NUMPY, COSINES, width, term.reflectance) - value for width, term, value in glassy])


if __name__ == "__main__":
    main()
