"""Autodesk Standard Surface without coat, transmission, subsurface scattering, thin film and anisotropy.

A mix of a metal and of a dielectric of GGX facets over sheen over Oren and Nayar's qualitative model.

Source: I. Georgiev et al., "Autodesk Standard Surface" 1.0.1, 2019.  Layers are combined by the albedo towards the viewer, as in its implementation
in MaterialX 1.39; so the surface is not reciprocal."""

from __future__ import annotations

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
from motes.models.surfaces.program import NEGLIGIBLE, Numbers, Surface, number
from motes.parameters import Role, parameter


def qualitative(xp: Array, geometry: Geometry, sigma: Array) -> Array:
    """pi f of Oren and Nayar's qualitative model (SIGGRAPH 1994, equation 30, without the term that is left out there)."""
    s2 = sigma * sigma
    rise = xp.maximum(geometry.cos_dphi, 0.0) * geometry.sin_alpha * geometry.tan_beta
    return 1 - 0.5 * s2 / (s2 + 0.33) + 0.45 * s2 / (s2 + 0.09) * rise


@register("standard_surface", listed=False)
@final
@dataclass(frozen=True, eq=False)
class StandardSurface(Surface):
    """The opaque part of Standard Surface, with the parameters of its nodes in MaterialX."""

    words: ClassVar[str] = "Standard Surface"
    program: ClassVar[str] = "Autodesk Standard Surface 1.0.1"
    candidates: ClassVar[tuple[str, ...]] = (
        "standard_surface(metalness=0, sheen=0, sheen_color=1, sheen_roughness=0.3)",
        "standard_surface(metalness=0)",
        "standard_surface(specular=1, specular_IOR=1.5, sheen=0, sheen_color=1, sheen_roughness=0.3)",
    )
    left_out: ClassVar[str] = "Coat, transmission, subsurface scattering, thin film and anisotropy are left out."

    base_color: Array = glossy.colour("colour of the diffuse part, or of the metal", Role.DIFFUSE_COLOUR)
    diffuse_roughness: Array = glossy.share(
        "standard deviation of the diffuse facets' slope angle", starts=(0.1, 0.4, 0.9), role=Role.DIFFUSE_ROUGHNESS
    )
    metalness: Array = glossy.share("share of metal", starts=(0.1, 0.9))
    specular: Array = glossy.share("weight of the highlight", default=1.0, starts=(0.2, 0.9))
    specular_color: Array = glossy.tint("factor of the highlight; of metals, their edge", Role.HIGHLIGHT_STRENGTH)
    specular_roughness: Array = glossy.roughness("roughness of the highlight, the root of alpha", default=0.2)
    specular_IOR: Array = parameter(
        1.5,
        bounds=(1, 50),
        fit_bounds=(1.02, 20),
        typical=(1.2, 3),
        starts=(1.4, 2.5),
        symbol="n",
        doc="refractive index",
        role=Role.REFRACTIVE_INDEX,
    )
    sheen: Array = glossy.share("weight of the sheen, such as of dust", starts=(0.1, 0.6))
    sheen_color: Array = glossy.colour("colour of the sheen")
    sheen_roughness: Array = glossy.share("roughness of the sheen", default=0.3, starts=(0.3, 0.7))

    def written(self) -> Numbers:
        found = {"base": 1.0, **super().written()}
        if number(self.sheen) < NEGLIGIBLE:
            found["sheen"] = 0.0
            del found["sheen_color"], found["sheen_roughness"]
        if number(self.specular) < NEGLIGIBLE and not number(self.metalness):
            found["specular"] = 0.0
            del found["specular_color"], found["specular_roughness"]
        return found

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return self._matte(xp, geometry) + self._glossy(xp, geometry)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        shine = equations.fresnel_dielectric(xp, cos_theta_i, self.specular_IOR) * self.specular_color * self.specular
        shine = glossy.mixed(shine, self.base_color, self.metalness)
        matte = self.base_color * (1 - self.metalness) + 0.1 * self.sheen * self.sheen_color
        return [
            Component(self._matte, CosineLobe(), matte),
            Component(self._glossy, glossy.visible(self._alpha(xp)), shine),
        ]

    def _alpha(self, xp: Array) -> Array:
        return glossy.alpha_of(xp, self.specular_roughness)

    def _gain(self, xp: Array, geometry: Geometry, reflected: Array) -> Array:
        return 1 + reflected * glossy.regained(xp, geometry.cos_theta_r, self._alpha(xp))

    def _dielectric(self, xp: Array, geometry: Geometry) -> Array:
        return equations.fresnel_dielectric(xp, geometry.cos_theta_d, self.specular_IOR)

    def _matte(self, xp: Array, geometry: Geometry) -> Array:
        """The sheen and the diffuse part, below the facets."""
        gain = self._gain(xp, geometry, self._dielectric(xp, geometry))
        once = glossy.reflected_once(xp, geometry.cos_theta_r, self._alpha(xp), self.specular_IOR)
        through = xp.maximum(1 - self.specular * (once * gain), 0.0) * (1 - self.metalness)
        uncovered = 1 - self.sheen * sheen_albedo(xp, geometry.cos_theta_r, self.sheen_roughness)
        body = equations.INV_PI * self.base_color * qualitative(xp, geometry, self.diffuse_roughness)
        return through * (uncovered * body + self.sheen * self.sheen_color * sheen(xp, geometry, self.sheen_roughness))

    def _glossy(self, xp: Array, geometry: Geometry) -> Array:
        """The facets of the dielectric and of the metal."""
        found = self._dielectric(xp, geometry)
        shine = self.specular * self.specular_color * found * self._gain(xp, geometry, found)
        n, k = self._metal(xp)
        metal = equations.fresnel_conductor(xp, geometry.cos_theta_d, n, k)
        metal = metal * self._gain(xp, geometry, metal)
        return glossy.mixed(shine, metal, self.metalness) * glossy.facets(xp, geometry, self._alpha(xp))

    def _metal(self, xp: Array) -> tuple[Array, Array]:
        """Refractive index and extinction of a metal by its colours: O. Gulbrandsen, "Artist friendly metallic Fresnel", JCGT 3(4), 2014."""
        r = xp.minimum(xp.maximum(self.base_color, 1e-4), 0.99)
        root = xp.sqrt(r)
        least, most = (1 - r) / (1 + r), (1 + root) / (1 - root)
        n = glossy.mixed(most, least, self.specular * self.specular_color)
        k2 = ((n + 1) * (n + 1) * r - (n - 1) * (n - 1)) / (1 - r)
        return n, xp.sqrt(xp.maximum(k2, 1e-8))
