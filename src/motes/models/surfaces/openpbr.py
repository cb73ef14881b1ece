"""OpenPBR without coat, transmission, subsurface scattering, thin film and anisotropy: what it has for opaque surfaces and the dust on them.

Fuzz over a mix of a metal and of a glossy-diffuse slab: EON below a dielectric of GGX facets.

Source: OpenPBR Surface 1.1, Academy Software Foundation, 2024.  Layers are combined by the albedo towards the viewer, as in its reference
implementation in MaterialX 1.39; so the surface is not reciprocal."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar, final

import numpy as np

from motes import equations
from motes.arrays import Array
from motes.directions import Geometry
from motes.models.components import Component
from motes.models.eon import EON
from motes.models.lobes import CosineLobe
from motes.models.naming import register
from motes.models.surfaces import glossy
from motes.models.surfaces.fuzz import fuzz, fuzz_albedo
from motes.models.surfaces.program import NEGLIGIBLE, Floats, Numbers, Surface, number
from motes.parameters import Role, parameter


@register("openpbr", listed=False)
@final
@dataclass(frozen=True, eq=False)
class OpenPBR(Surface):
    """The opaque part of OpenPBR Surface, with the parameters of its nodes in MaterialX.

    Notes
    -----
    ``specular_weight`` scales the reflectance at normal incidence, so that a weight and an index tell the same thing twice: a fit holds one
    of them."""

    words: ClassVar[str] = "OpenPBR"
    program: ClassVar[str] = "OpenPBR Surface 1.1"
    candidates: ClassVar[tuple[str, ...]] = (
        "openpbr(base_metalness=0, specular_ior=1.5, fuzz_weight=0, fuzz_color=1, fuzz_roughness=0.5)",
        "openpbr(base_metalness=0, specular_ior=1.5)",
        "openpbr(specular_ior=1.5, fuzz_weight=0, fuzz_color=1, fuzz_roughness=0.5)",
    )
    left_out: ClassVar[str] = "Coat, transmission, subsurface scattering, thin film and anisotropy are left out."

    base_color: Array = glossy.colour("colour of the diffuse part, or of the metal", Role.DIFFUSE_COLOUR)
    base_diffuse_roughness: Array = glossy.share(
        "roughness r of EON", starts=(0.1, 0.5, 0.9), role=Role.DIFFUSE_ROUGHNESS
    )
    base_metalness: Array = glossy.share("share of metal", starts=(0.1, 0.9))
    specular_weight: Array = parameter(
        1.0,
        bounds=(0, 24.9),
        fit_bounds=(0, 16),
        typical=(0, 1),
        symbol="x",
        doc="factor of the reflectance at normal incidence",
        starts=(0.3, 4.0),
        role=Role.HIGHLIGHT_STRENGTH,
    )
    specular_color: Array = glossy.tint(
        "factor of the highlight; of metals, that at 82 degrees", Role.HIGHLIGHT_STRENGTH
    )
    specular_roughness: Array = glossy.roughness("roughness of the highlight, the root of alpha")
    specular_ior: Array = parameter(
        1.5, bounds=(1, 10), fit_bounds=(1.02, 4), symbol="n", doc="refractive index", role=Role.REFRACTIVE_INDEX
    )
    fuzz_weight: Array = glossy.share("share of the surface under fuzz, such as dust", starts=(0.1, 0.6))
    fuzz_color: Array = glossy.colour("colour of the fuzz")
    fuzz_roughness: Array = glossy.share("roughness of the fuzz", default=0.5, starts=(0.3, 0.7))

    @classmethod
    def admissible(cls, values: Mapping[str, Floats]) -> dict[str, Floats]:
        weight, ior = values["specular_weight"], values["specular_ior"]
        over = weight > 1
        if not np.any(over):
            return dict(values)
        # The same by an index, of which 10 is the largest.
        root = np.sqrt(np.minimum(weight * glossy.normal_reflectance(ior), 0.66))
        index = np.where(over, (1 + root) / (1 - root), ior)
        return {**values, "specular_weight": np.minimum(weight, 1.0), "specular_ior": index}

    def written(self) -> Numbers:
        found = super().written()
        weight = number(self.specular_weight)
        if weight < NEGLIGIBLE and not number(self.base_metalness):
            found["specular_weight"] = 0.0
            del found["specular_color"], found["specular_roughness"]
        if number(self.fuzz_weight) < NEGLIGIBLE:
            found["fuzz_weight"] = 0.0
            del found["fuzz_color"], found["fuzz_roughness"]
        return found

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return self._matte(xp, geometry) + self._glossy(xp, geometry)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        shine = equations.fresnel_dielectric(xp, cos_theta_i, self._index(xp)) * self.specular_color
        shine = glossy.mixed(shine, glossy.bent_schlick(xp, cos_theta_i, self.base_color, 1.0), self.base_metalness)
        matte = glossy.mixed(self.base_color * (1 - self.base_metalness), self.fuzz_color, 0.5 * self.fuzz_weight)
        return [
            Component(self._matte, CosineLobe(), matte),
            Component(self._glossy, glossy.visible(self._alpha(xp)), shine),
        ]

    def _alpha(self, xp: Array) -> Array:
        return glossy.alpha_of(xp, self.specular_roughness)

    def _index(self, xp: Array) -> Array:
        """The refractive index that the weight makes."""
        return glossy.index_of(xp, self.specular_weight * glossy.normal_reflectance(self.specular_ior))

    def _fresnel(self, xp: Array, geometry: Geometry) -> tuple[Array, Array]:
        """F of the dielectric at the facet, and its gain by further reflections."""
        found = equations.fresnel_dielectric(xp, geometry.cos_theta_d, self._index(xp))
        return found, 1 + found * glossy.regained(xp, geometry.cos_theta_r, self._alpha(xp))

    def _uncovered(self, xp: Array, geometry: Geometry) -> Array:
        """What the fuzz lets through."""
        return 1 - self.fuzz_weight * fuzz_albedo(xp, geometry.cos_theta_r, self.fuzz_roughness)

    def _matte(self, xp: Array, geometry: Geometry) -> Array:
        """The diffuse part below the facets, and the fuzz."""
        _, gain = self._fresnel(xp, geometry)
        once = glossy.reflected_once(xp, geometry.cos_theta_r, self._alpha(xp), self._index(xp))
        below = xp.maximum(1 - once * gain, 0.0) * EON(self.base_color, self.base_diffuse_roughness).formula(
            xp, geometry
        )
        through = self._uncovered(xp, geometry) * (1 - self.base_metalness)
        return through * below + self.fuzz_weight * self.fuzz_color * fuzz(xp, geometry, self.fuzz_roughness)

    def _glossy(self, xp: Array, geometry: Geometry) -> Array:
        """The facets of the dielectric and of the metal."""
        found, gain = self._fresnel(xp, geometry)
        metal = glossy.bent_schlick(xp, geometry.cos_theta_d, self.base_color, self.specular_color)
        again = glossy.regained(xp, geometry.cos_theta_r, self._alpha(xp))
        # A weight above 1 is no share of a metal.
        metal = xp.minimum(self.specular_weight, 1.0) * metal * (1 + metal * again)
        either = glossy.mixed(self.specular_color * found * gain, metal, self.base_metalness)
        return self._uncovered(xp, geometry) * either * glossy.facets(xp, geometry, self._alpha(xp))
