"""Blender's Principled BSDF (version 2, of Blender 4 and 5) without coat, transmission, subsurface scattering, thin film and anisotropy.

Sheen over a mix of a metal and of a dielectric of GGX facets over EON.

Source: the manual of Blender 5.0, "Principled BSDF", and what Cycles of 5.0 to 5.3 computes: M. Burley, "Extending the Disney BRDF to a BSDF", 2015, layers
by the albedo towards the viewer; light reflected several times after C. Kulla, A. Conty, "Revisiting physically based shading at Imageworks", 2017."""

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
from motes.models.facet_albedo import GGX_ALBEDO
from motes.models.lobes import CosineLobe
from motes.models.naming import register
from motes.models.surfaces import glossy
from motes.models.surfaces.fuzz import fuzz, fuzz_albedo
from motes.models.surfaces.program import NEGLIGIBLE, Floats, Numbers, Surface, number
from motes.parameters import Role, option, parameter

#: The cosine whose albedo stands for the mean over all, weighted by the cosine.
MEAN_COSINE = 2 / 3


@register("principled", listed=False)
@final
@dataclass(frozen=True, eq=False)
class Principled(Surface):
    """The opaque part of the Principled BSDF, with its parameters as Python names."""

    words: ClassVar[str] = "Principled BSDF"
    program: ClassVar[str] = "Blender's Principled BSDF (4.3 and later)"
    candidates: ClassVar[tuple[str, ...]] = (
        "principled(metallic=0, ior=1.5, sheen_weight=0, sheen_tint=1, sheen_roughness=0.5)",
        "principled(metallic=0, ior=1.5)",
        "principled(ior=1.5, specular_ior_level=0.5, sheen_weight=0, sheen_tint=1, sheen_roughness=0.5)",
    )
    left_out: ClassVar[str] = (
        "Coat, transmission, subsurface scattering, thin film and anisotropy are left out; diffuse roughness is that of Blender 5.3, "
        "and 5.0 to 5.2 draw it darker, by 4 % for middling colours at 0.4."
    )

    base_color: Array = glossy.colour("colour of the diffuse part, or of the metal", Role.DIFFUSE_COLOUR)
    diffuse_roughness: Array = glossy.share("roughness r of EON", starts=(0.1, 0.5, 0.9), role=Role.DIFFUSE_ROUGHNESS)
    metallic: Array = glossy.share("share of metal", starts=(0.1, 0.9))
    roughness: Array = glossy.roughness("roughness of the highlight, the root of alpha", default=0.5)
    ior: Array = parameter(
        1.5, bounds=(1, 10), fit_bounds=(1.02, 4), symbol="n", doc="refractive index", role=Role.REFRACTIVE_INDEX
    )
    specular_ior_level: Array = parameter(
        0.5,
        bounds=(0, 12.4),
        fit_bounds=(0, 8),
        typical=(0, 1),
        starts=(0.2, 2.0),
        symbol="x",
        doc="half the factor of the reflectance at normal incidence",
        role=Role.HIGHLIGHT_STRENGTH,
    )
    specular_tint: Array = glossy.tint(
        "factor of the reflectance at normal incidence; of metals, at 82 degrees", Role.NORMAL_REFLECTANCE
    )
    sheen_weight: Array = glossy.share("weight of the sheen, such as of dust", starts=(0.1, 0.6))
    sheen_tint: Array = glossy.colour("colour of the sheen")
    sheen_roughness: Array = glossy.share("roughness of the sheen", default=0.5, starts=(0.3, 0.7))
    #: EON's in Cycles of Blender 5.3; 5.0 to 5.2 multiply it by the colour once more, of which rough surfaces are darker.
    interreflection: str = option(
        "eon", words=("eon", "coloured"), doc="light that rough diffuse facets send each other"
    )

    @classmethod
    def admissible(cls, values: Mapping[str, Floats]) -> dict[str, Floats]:
        level, ior = values["specular_ior_level"], values["ior"]
        found = {
            **values,
            **glossy.brightest_apart(values, "sheen_weight", "sheen_tint"),
        }  # the sheen covers by its brightest channel
        over = level > 0.5  # the same by an index, which the slider's end does not stop
        if not np.any(over):
            return found
        # Blender's index ends at 1000, ours at 10.
        root = np.sqrt(np.minimum(2 * level * glossy.normal_reflectance(ior), 0.66))
        index = np.where(over, (1 + root) / (1 - root), ior)
        return {**found, "ior": index, "specular_ior_level": np.minimum(level, 0.5)}

    def written(self) -> Numbers:
        found = super().written()
        if number(self.sheen_weight) < NEGLIGIBLE:
            found["sheen_weight"] = 0.0
            del found["sheen_tint"], found["sheen_roughness"]
        return found

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return self._matte(xp, geometry) + self._glossy(xp, geometry)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        shine = glossy.mixed(self._dielectric(xp, cos_theta_i), self.base_color, self.metallic)
        matte = self.base_color * (1 - self.metallic) + 0.5 * self.sheen_weight * self.sheen_tint
        return [
            Component(self._matte, CosineLobe(), matte),
            Component(self._glossy, glossy.visible(self._alpha(xp)), shine),
        ]

    def _alpha(self, xp: Array) -> Array:
        return glossy.alpha_of(xp, self.roughness)

    def _normal(self) -> Array:
        """The reflectance at normal incidence before the tint."""
        return 2 * self.specular_ior_level * glossy.normal_reflectance(self.ior)

    def _dielectric(self, xp: Array, cosine: Array) -> Array:
        """F of the dielectric, moved so that it starts at the tinted reflectance and ends at 1."""
        n = glossy.index_of(xp, self._normal())
        normal = glossy.normal_reflectance(n)
        rise = (equations.fresnel_dielectric(xp, cosine, n) - normal) / (1 - normal)
        start = normal * self.specular_tint
        return start + (1 - start) * xp.maximum(rise, 0.0)

    def _gain(self, xp: Array, geometry: Geometry, mean: Array) -> Array:
        """What facets gain by light reflected several times, whose mean Fresnel reflectance is `mean`."""
        alpha = self._alpha(xp)
        all_of_it = GGX_ALBEDO(xp, MEAN_COSINE, alpha, lambda xp, cosine: 1.0)
        again = mean * all_of_it / (1 - mean * (1 - all_of_it))
        return 1 + again * glossy.regained(xp, geometry.cos_theta_r, alpha)

    def _dielectric_gain(self, xp: Array, geometry: Geometry) -> Array:
        # The mean of Fresnel reflectance over the cosine, near that at 2/3.
        return self._gain(xp, geometry, self._dielectric(xp, MEAN_COSINE))

    def _uncovered(self, xp: Array, geometry: Geometry) -> Array:
        """What the sheen lets through."""
        return 1 - self.sheen_weight * fuzz_albedo(xp, geometry.cos_theta_r, self.sheen_roughness)

    def _matte(self, xp: Array, geometry: Geometry) -> Array:
        """The diffuse part below the facets, and the sheen."""
        mirrored = GGX_ALBEDO(xp, geometry.cos_theta_r, self._alpha(xp), self._dielectric)
        below = xp.maximum(1 - mirrored * self._dielectric_gain(xp, geometry), 0.0)
        rough = EON(self.base_color, self.diffuse_roughness)
        once = equations.INV_PI * rough.once(xp, geometry)
        again = rough.formula(xp, geometry) - once
        body = once + (self.base_color * again if self.interreflection == "coloured" else again)
        through = self._uncovered(xp, geometry) * (1 - self.metallic)
        return through * below * body + self.sheen_weight * self.sheen_tint * fuzz(xp, geometry, self.sheen_roughness)

    def _glossy(self, xp: Array, geometry: Geometry) -> Array:
        """The facets of the dielectric and of the metal."""
        shine = self._dielectric(xp, geometry.cos_theta_d) * self._dielectric_gain(xp, geometry)
        metal = glossy.bent_schlick(xp, geometry.cos_theta_d, self.base_color, self.specular_tint)
        # The mean of Schlick's curve over the cosine, and of what bends it.
        there = self.base_color + (1 - self.base_color) * (1 - glossy.COS_82) ** 5
        mean = self.base_color + (1 - self.base_color) / 21 - there * (1 - self.specular_tint) * glossy.BEND / 126
        metal = metal * self._gain(xp, geometry, mean)
        either = glossy.mixed(shine, metal, self.metallic)
        return self._uncovered(xp, geometry) * either * glossy.facets(xp, geometry, self._alpha(xp))
