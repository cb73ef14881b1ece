r"""Retro-reflection: a highlight about the direction back to the light, as of beads, prisms, the tapetum of eyes, and very rough grains.

.. math::  f(\omega_i, \omega_r) = K_r \, f_{GGX}(\omega_i', \omega_r; \alpha_r)

with :math:`\omega_i'` the direction to the light turned by half a circle about the normal: where a mirror would send light, this sends it back.

Source: L. Belcour, R. Pacanowski, M. Delahaie, A. Laville-Geay, L. Eupherte, "Bidirectional reflectance distribution function measurements and
analysis of retroreflecting materials", JOSA A 31(12), 2014: the half vector of the light's mirror image; the facets are those of `motes.models.ggx`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self, final

from motes.arrays import Array
from motes.directions import Geometry, Vector
from motes.models.base import BRDF
from motes.models.components import Component
from motes.models.facet_albedo import GGX_ALBEDO
from motes.models.ggx import GGX, VisibleGGXLobe
from motes.models.lobes import Lobe, Reflection
from motes.models.naming import register
from motes.models.standard import MEAN_COSINE, StandardLobe
from motes.parameters import Role, parameter


@dataclass(frozen=True)
class BackwardLobe(Lobe):
    """Another lobe, given the direction turned by half a circle about the normal."""

    reflection: ClassVar[Reflection] = Reflection.GLOSSY

    of: Lobe

    def sample(self, xp: Array, wi: Array, u: Array) -> Array:
        return self.of.sample(xp, _turned(xp, wi), u)

    def pdf(self, xp: Array, wi: Array, wo: Array) -> Array:
        return self.of.pdf(xp, _turned(xp, wi), wo)


def _turned(xp: Array, w: Array) -> Array:
    return xp.stack([-w[..., 0], -w[..., 1], w[..., 2]])


def _all(xp: Array, cosine: Array) -> Array:
    """What facets with F = 1 reflect."""
    return 1.0


@register("retro")
@final
@dataclass(frozen=True, eq=False)
class Retro(BRDF):
    """Light that goes back to where it came from: a term beside others, ``EON(...) + Retro(...)``, for cloth, road signs and rough minerals.

    Notes
    -----
    It is reciprocal, and returns as much light as `GGX` with the same numbers and F = 1: 97 % of uniform light at alpha_r = 0.1, 70 % at 0.5.
    Under dust with multiple scattering it is taken for diffuse, and not blurred."""

    words: ClassVar[str] = "retro-reflection"
    approximation: ClassVar[str] = (
        "Retro-reflection: a diffuse lobe that reflects as much of light from 53 degrees; the peak towards the light is left out."
    )

    K_r: Array = parameter(
        0.1,
        bounds=(0, float("inf")),
        typical=(0, 1),
        symbol="K_r",
        doc="share of light that is sent back",
        per_channel=True,
        shared_in_fit=True,
        role=Role.FURTHER_STRENGTH,
        simpler=0.0,
    )
    alpha_r: Array = parameter(
        0.3,
        bounds=(0.001, 1),
        fit_bounds=(0.005, 1),
        typical=(0.02, 0.8),
        starts=(0.05, 0.2, 0.6),
        symbol="\\alpha_r",
        doc="width of what is sent back, the roughness alpha of the GGX that would mirror it",
        role=Role.FURTHER_WIDTH,
    )

    def _mirror(self) -> GGX:
        return GGX(self.K_r, self.alpha_r)

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        i = geometry.wi
        return self._mirror().formula(xp, Geometry(xp, Vector(-i.x, -i.y, i.z), geometry.wo))

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return [Component(self.formula, BackwardLobe(VisibleGGXLobe(self.alpha_r)), self.K_r)]

    def reflected(self, xp: Array, cos_theta_i: Array) -> Array:
        return self._mirror().reflected(xp, cos_theta_i)

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        return [StandardLobe(Reflection.DIFFUSE, values.K_r * GGX_ALBEDO(xp, MEAN_COSINE, values.alpha_r, _all))]
