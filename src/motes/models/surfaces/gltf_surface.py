"""The material of glTF 2.0: metallic-roughness with KHR_materials_specular and KHR_materials_sheen.

Sheen over a mix of a metal and of a dielectric of GGX facets over Lambert, by Schlick's curve at the facet.

Source: glTF 2.0 specification, appendix B, and the two extensions, Khronos, 2021."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar, final

from motes import equations
from motes.arrays import Array
from motes.directions import Geometry
from motes.models.components import Component
from motes.models.lobes import CosineLobe
from motes.models.naming import register
from motes.models.sheen import sheen, sheen_albedo
from motes.models.surfaces import glossy
from motes.models.surfaces.program import NEGLIGIBLE, Floats, Numbers, Surface, number
from motes.parameters import Role, parameter

#: The reflectance at normal incidence of glTF's dielectrics.
NORMAL = 0.04


@register("gltf", listed=False)
@final
@dataclass(frozen=True, eq=False)
class GltfSurface(Surface):
    """glTF's material; the colour of its sheen is `sheen_weight` times `sheen_tint`."""

    words: ClassVar[str] = "glTF"
    program: ClassVar[str] = "glTF 2.0 with KHR_materials_specular and KHR_materials_sheen"
    reciprocal: ClassVar[bool] = True
    candidates: ClassVar[tuple[str, ...]] = (
        "gltf(metallic=0, sheen_weight=0, sheen_tint=1, sheen_roughness=0.5)",
        "gltf(metallic=0)",
        "gltf(specular=1, specular_color=1, sheen_weight=0, sheen_tint=1, sheen_roughness=0.5)",
    )
    left_out: ClassVar[str] = (
        "Its diffuse part is Lambert's, so that rough surfaces darken towards their rims; coat, transmission, iridescence and anisotropy are left out."
    )

    base_color: Array = glossy.colour("colour of the diffuse part, or of the metal", Role.DIFFUSE_COLOUR)
    metallic: Array = glossy.share("share of metal", starts=(0.1, 0.9))
    roughness: Array = glossy.roughness("roughness of the highlight, the root of alpha", default=0.5)
    specular: Array = glossy.share("weight of the highlight", default=1.0, starts=(0.2, 0.9))
    specular_color: Array = parameter(
        1.0,
        bounds=(0, 25),
        typical=(0, 1),
        symbol="c",
        doc="factor of the reflectance at normal incidence",
        starts=(1.0, 8.0),
        per_channel=True,
        shared_in_fit=True,
        role=Role.HIGHLIGHT_STRENGTH,
    )
    sheen_weight: Array = glossy.share("the largest component of the sheen's colour", starts=(0.1, 0.6))
    sheen_tint: Array = glossy.colour("colour of the sheen relative to its largest component")
    sheen_roughness: Array = glossy.share("roughness of the sheen, the root of alpha", default=0.5, starts=(0.4, 0.8))

    @classmethod
    def admissible(cls, values: Mapping[str, Floats]) -> dict[str, Floats]:
        return {**values, **glossy.brightest_apart(values, "sheen_weight", "sheen_tint")}

    def written(self) -> Numbers:
        found = super().written()
        weight, shade = number(self.sheen_weight), found.pop("sheen_tint")
        del found["sheen_weight"]
        if weight < NEGLIGIBLE:
            del found["sheen_roughness"]
        else:
            assert isinstance(shade, tuple)
            found["sheen_color"] = tuple(weight * x for x in shade)
        return found

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return self._matte(xp, geometry) + self._glossy(xp, geometry)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        shine = glossy.mixed(self._dielectric(xp, cos_theta_i), self.base_color, self.metallic)
        matte = self.base_color * (1 - self.metallic) + 0.1 * self.sheen_weight * self.sheen_tint
        return [
            Component(self._matte, CosineLobe(), matte),
            Component(self._glossy, glossy.visible(self._alpha(xp)), shine),
        ]

    def _alpha(self, xp: Array) -> Array:
        return glossy.alpha_of(xp, self.roughness)

    def _dielectric(self, xp: Array, cosine: Array) -> Array:
        """F of the dielectric: Schlick's curve from the normal reflectance times the weight to the weight."""
        normal = xp.minimum(NORMAL * self.specular_color, 1.0)
        return self.specular * equations.fresnel_schlick(xp, cosine, normal)

    def _uncovered(self, xp: Array, geometry: Geometry) -> Array:
        """What the sheen lets through, the less of the two directions."""
        a = self._sheen_alpha()
        i, r = (sheen_albedo(xp, cosine, a) for cosine in (geometry.cos_theta_i, geometry.cos_theta_r))
        return 1 - self.sheen_weight * xp.maximum(i, r)

    def _sheen_alpha(self) -> Array:
        return self.sheen_roughness * self.sheen_roughness

    def _matte(self, xp: Array, geometry: Geometry) -> Array:
        """The diffuse part below the facets, and the sheen."""
        below = (1 - self._dielectric(xp, geometry.cos_theta_d)) * (equations.INV_PI * self.base_color)
        fibres = self.sheen_weight * self.sheen_tint * sheen(xp, geometry, self._sheen_alpha())
        return self._uncovered(xp, geometry) * (1 - self.metallic) * below + fibres

    def _glossy(self, xp: Array, geometry: Geometry) -> Array:
        """The facets of the dielectric and of the metal."""
        metal = equations.fresnel_schlick(xp, geometry.cos_theta_d, self.base_color)
        either = glossy.mixed(self._dielectric(xp, geometry.cos_theta_d), metal, self.metallic)
        return self._uncovered(xp, geometry) * either * glossy.facets(xp, geometry, self._alpha(xp))
