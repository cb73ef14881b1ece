"""GGX as the surfaces of other programs have it: with what light gains that facets send to each other, and Fresnel terms that are set by a colour."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from motes import equations
from motes.arrays import Array
from motes.directions import Geometry
from motes.models.facet_albedo import GGX_ALBEDO
from motes.models.ggx import GGX
from motes.models.lobes import Lobe
from motes.parameters import Role, parameter

Floats = NDArray[np.float64]
#: The smallest alpha that the lobes take; programs clamp theirs, too.
SMALLEST_ALPHA = 0.001
#: The cosine at which F82 is given, and the factor of the term that bends Schlick's curve through it.
COS_82 = 1 / 7
BEND = 1 / (COS_82 * (1 - COS_82) ** 6)


def alpha_of(xp: Array, roughness: Array) -> Array:
    """alpha = roughness^2, kept from 0."""
    return xp.maximum(roughness * roughness, SMALLEST_ALPHA)


def facets(xp: Array, geometry: Geometry, alpha: Array) -> Array:
    """D G_2 / (4 cos cos) [1/sr]: GGX with F = 1."""
    return GGX(1.0, alpha).formula(xp, geometry)


def visible(alpha: Array) -> Lobe:
    """What chooses directions of `facets`."""
    return GGX(1.0, alpha).lobe()


def regained(xp: Array, cos_theta: Array, alpha: Array) -> Array:
    """(1 - E)/E, for E the share that facets of F = 1 reflect at once: times F it is what light gains by further reflections.

    Source: E. Turquin, "Practical multiple scattering compensation for microfacet models", 2019.
    """
    once = GGX_ALBEDO(xp, cos_theta, alpha, lambda xp, cosine: 1.0)
    return (1 - once) / once


def reflected_once(xp: Array, cos_theta: Array, alpha: Array, n: Array) -> Array:
    """The share of light that facets of the refractive index n reflect at once."""
    return GGX_ALBEDO(xp, cos_theta, alpha, lambda xp, cosine: equations.fresnel_dielectric(xp, cosine, n))


def normal_reflectance(n: Array) -> Array:
    """F at normal incidence of a refractive index."""
    root = (n - 1) / (n + 1)
    return root * root


def index_of(xp: Array, normal: Array) -> Array:
    """The refractive index >= 1 with that reflectance at normal incidence, which is kept inside (0, 1)."""
    root = xp.sqrt(xp.minimum(xp.maximum(normal, 1e-10), 0.99999))
    return (1 + root) / (1 - root)


def bent_schlick(xp: Array, cos_theta: Array, f0: Array, f82: Array) -> Array:
    """Schlick's curve from f0 to 1, bent so that at 82 degrees it is its value there times f82.

    Source: N. Hoffman, "Generalization of Adobe's Fresnel model", 2023.
    """
    there = f0 + (1 - f0) * (1 - COS_82) ** 5
    m = 1 - cos_theta
    m2 = m * m
    return equations.fresnel_schlick(xp, cos_theta, f0) - there * (1 - f82) * BEND * (cos_theta * (m2 * m2 * m2))


def brightest_apart(values: Mapping[str, Floats], weight: str, tint: str) -> dict[str, Floats]:
    """A weight (...) and a colour (..., C) whose product stays what it is, the colour's largest component 1; one that is black as it is, without weight."""
    most = np.max(values[tint], axis=-1)
    black = most == 0
    scale = np.where(black, 1.0, most)
    return {weight: values[weight] * most, tint: np.minimum(values[tint] / scale[..., None], 1.0)}


def mixed(a: Array, b: Array, share: Array) -> Array:
    """`a` where the share is 0, `b` where it is 1."""
    return a + share * (b - a)


def colour(doc: str, role: Role | None = None, default: float = 0.8) -> Array:
    """A colour of a surface, a number per channel in [0, 1]."""
    return parameter(default, bounds=(0, 1), symbol="c", doc=doc, per_channel=True, role=role)


def tint(doc: str, role: Role | None = None) -> Array:
    """A colour that is white unless asked for: a fit holds it equal over the channels."""
    return parameter(1.0, bounds=(0, 1), symbol="c", doc=doc, per_channel=True, shared_in_fit=True, role=role)


def share(doc: str, default: float = 0.0, starts: tuple[float, ...] = (), role: Role | None = None) -> Array:
    """A number in [0, 1]."""
    return parameter(default, bounds=(0, 1), symbol="x", doc=doc, starts=starts, role=role)


def roughness(doc: str, default: float = 0.3) -> Array:
    """The roughness of a highlight, whose square is alpha."""
    return parameter(
        default,
        bounds=(0, 1),
        fit_bounds=(0.07, 1),
        symbol="r",
        doc=doc,
        starts=(0.2, 0.4, 0.7),
        role=Role.HIGHLIGHT_WIDTH,
    )
