r"""Hapke's model of powders and regolith: single scattering with an opposition surge, and multiple scattering.

.. math::  f = \frac{w}{4 \pi (\cos\theta_i + \cos\theta_r)} \left[(1 + B) \Phi + H(\cos\theta_i) H(\cos\theta_r) - 1\right], \quad
           B = \frac{B_0}{1 + \tan(\pi/2 - \gamma/2) / h}, \quad H(x) = \frac{1 + 2 x}{1 + 2 x \sqrt{1 - w}}

Source: B. Hapke, "Bidirectional reflectance spectroscopy 1: theory", JGR 86(B4), 1981, equations (16), (22), and "3: correction for
macroscopic roughness", 1984; the phase function Phi is that of equation (13). pi - gamma is the angle between light and viewer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self, final

from motes import equations
from motes.arrays import Array
from motes.directions import Geometry
from motes.models.base import BRDF
from motes.models.components import Component
from motes.models.lobes import CosineLobe, PhaseLobe, Reflection
from motes.models.naming import register
from motes.models.standard import StandardLobe
from motes.parameters import Role, parameter


def hapke_gain(xp: Array, cosine: Array, w: Array) -> Array:
    """H - 1, which does not cancel for dark particles; H is Hapke's approximation of Chandrasekhar's function (1981, equation (8))."""
    root, twice = xp.sqrt(xp.maximum(1 - w, 0.0)), 2 * cosine
    return twice * w / ((1 + root) * (1 + twice * root))


def hapke_surge(xp: Array, sin2_half_gamma: Array, cos2_half_gamma: Array, B_0: Array, h: Array) -> Array:
    """B, multiplied out so that it is B_0 where light and viewer meet and 0 where they are opposite."""
    ahead, back = xp.sqrt(cos2_half_gamma), h * xp.sqrt(sin2_half_gamma)
    return B_0 * back / xp.maximum(back + ahead, 1e-30)


@register("hapke")
@final
@dataclass(frozen=True, eq=False)
class Hapke(BRDF):
    """An opaque bed of particles: powders, soil, pigments, the surfaces of the Moon and of asteroids.

    Notes
    -----
    `Dust` is its single scattering without the surge (B_0 = 0).  The formula is Hapke's of 1981 without the large-scale roughness of 1984; as
    everywhere there, light that is scattered more than once is scattered evenly.  It is reciprocal, but keeps no account of energy: with w = 1
    and without a surge it returns 97 to 104 % of light for g = 0, 91 to 95 % for g = 0.4 and 98 to 117 % for g = -0.4; a surge adds up to 8 %."""

    words: ClassVar[str] = "Hapke"
    approximation: ClassVar[str] = (
        "Hapke: a diffuse lobe that reflects as much uniform light; its phase function, its surge and the darkening of its limb are left out."
    )

    w: Array = parameter(
        0.6,
        bounds=(0, 1),
        symbol="w",
        doc="single-scattering albedo of the particles",
        per_channel=True,
        role=Role.SINGLE_SCATTERING_ALBEDO,
        simpler=0.0,
    )
    g: Array = parameter(
        -0.2,
        bounds=(-1, 1),
        open=True,
        fit_bounds=(-0.9, 0.9),
        typical=(-0.6, 0.6),
        starts=(-0.3, 0.2),
        symbol="g",
        doc="mean cosine of the deviation angle",
        advice="g > 0 scatters forward, g < 0 backward, 0 evenly",
        role=Role.ASYMMETRY,
    )
    B_0: Array = parameter(
        0.5,
        bounds=(0, 1),
        starts=(0.2, 0.8),
        symbol="B_0",
        doc="height of the opposition surge, of what particles scatter back",
        role=Role.SURGE_STRENGTH,
        simpler=0.0,
    )
    h: Array = parameter(
        0.06,
        bounds=(0.001, 1),
        fit_bounds=(0.005, 1),
        typical=(0.01, 0.3),
        starts=(0.03, 0.2),
        symbol="h",
        doc="angular half width of the opposition surge, tan of half the angle between light and viewer",
        role=Role.SURGE_WIDTH,
    )

    def _single(self, xp: Array, geometry: Geometry) -> Array:
        s2, c2 = geometry.sin2_half_gamma, geometry.cos2_half_gamma
        surge = 1 + hapke_surge(xp, s2, c2, self.B_0, self.h)
        Phi = equations.Phi(xp, s2, c2, self.g)
        return equations.dust_brdf(xp, surge * Phi, geometry.cos_theta_i, geometry.cos_theta_r, self.w)

    def _multiple(self, xp: Array, geometry: Geometry) -> Array:
        i, r = geometry.cos_theta_i, geometry.cos_theta_r
        gain_i, gain_r = hapke_gain(xp, i, self.w), hapke_gain(xp, r, self.w)
        return equations.dust_brdf(xp, gain_i + gain_r + gain_i * gain_r, i, r, self.w)

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return self._single(xp, geometry) + self._multiple(xp, geometry)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        # Of isotropic particles: Hapke's hemispherical reflectance less what is scattered once.
        root = xp.sqrt(xp.maximum(1 - self.w, 0.0))
        once = 0.15 * self.w
        whole = (1 - root) / (1 + 2 * root * cos_theta_i)
        return [
            Component(self._single, PhaseLobe(self.g), once),
            Component(self._multiple, CosineLobe(), xp.maximum(whole - once, 0.01 * once)),
        ]

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        # Two lobes, as there are components: the spherical albedo of isotropic particles (Hapke 1981, equation (43)), nearly.
        root = xp.sqrt(1 - values.w)
        once = values.w * (2 / 3 * (1 - 0.6931471805599453))
        whole = (1 - root) / (1 + root) * (1 - root / (3 + 3 * root))
        return [StandardLobe(Reflection.DIFFUSE, once), StandardLobe(Reflection.DIFFUSE, whole - once)]
