r"""EON, the energy-preserving Oren-Nayar model of rough diffuse surfaces, with its exact albedos.

.. math::  f = \frac{\rho}{\pi} A_F \left(1 + r \frac{s}{t}\right)
               + \frac{\rho_{ms}}{\pi} \frac{(1 - \hat E_F(\theta_i)) (1 - \hat E_F(\theta_r))}{1 - \langle\hat E_F\rangle}

with s = wi . wo - cos(theta_i) cos(theta_r), t = max(cos(theta_i), cos(theta_r)) where s > 0 and 1 elsewhere.

Source: J. Portsmouth, P. Kutz, S. Hill, "EON: A practical energy-preserving rough diffuse BRDF", JCGT 14(1), 2025 (arXiv
2410.18026, 2024), equations (6)-(21); the diffuse lobe of OpenPBR."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar, Self, final

from motes import equations
from motes.arrays import Array
from motes.directions import HALF_PI, Geometry, elevation
from motes.models.base import BRDF
from motes.models.components import Component
from motes.models.lobes import CosineLobe, Reflection
from motes.models.naming import register
from motes.models.standard import StandardLobe
from motes.parameters import Role, parameter

#: A_F = 1 / (1 + C_1 r): Fujii's normalisation.
C_1 = 0.5 - 2 / (3 * math.pi)
#: The mean directional albedo of the single-scattering lobe is A_F (1 + C_2 r).
C_2 = 2 / 3 - 28 / (15 * math.pi)


def _lost(xp: Array, cos_theta: Array, sin_theta: Array) -> Array:
    """What 1 - E_F(theta) is but for the factor r A_F: C_1 - G(theta)/pi, with the paper's G.

    Near grazing G is close to pi C_1.  Put together as powers of the cosine, with pi/2 - theta for the angle, nothing cancels.
    """
    more, z = 1 + sin_theta, cos_theta
    squared = (HALF_PI - 2 / 3) * z * z / more
    cubed = sin_theta * z * z * z * (sin_theta + 2) / (3 * more * more)
    return equations.INV_PI * (squared + sin_theta * elevation(xp, cos_theta, sin_theta) - cubed)


def _swing(xp: Array, g: Geometry, r: Array) -> Array:
    """1 + r s/t.  Forward (s < 0) it is (1 - r) + r (1 - |s|), whose last difference would cancel at grazing angles."""
    sines, i, o = g.sin_theta_i * g.sin_theta_r, g.cos_theta_i, g.cos_theta_r
    # 1 - sin(theta_i) sin(theta_r), from the cosines.
    less = (i * i + o * o - (i * o) * (i * o)) / (1 + sines)
    forward = (1 - r) + r * (less + sines * g.one_less_abs_cos_dphi)
    return xp.where(g.cos_dphi > 0, 1 + r * (g.cos_dphi * g.tan_beta * g.sin_alpha), forward)


@register("eon")
@final
@dataclass(frozen=True, eq=False)
class EON(BRDF):
    """A rough diffuse surface that loses no light: with rho = 1 it reflects all of it at every roughness and angle.

    Notes
    -----
    Its single-scattering part is Fujii's form of Oren and Nayar's model, whose lost light the second term gives back, coloured by
    further reflections.  Unlike `OrenNayar` it never needs a clamp.  Like that it grows without bound where both directions graze
    on the light's side (eval times cos(theta_i) stays finite).  It is reciprocal."""

    words: ClassVar[str] = "EON"
    approximation: ClassVar[str] = (
        "EON: the energy-preserving Oren-Nayar lobe with roughness r where a program has it (MaterialX 1.39), else Oren and Nayar's "
        "qualitative model with sigma = r in radians, which is darker when rough."
    )

    rho: Array = parameter(
        0.5,
        bounds=(0, 1),
        symbol="\\rho",
        doc="colour that the surface has after one reflection; 1 loses no light",
        per_channel=True,
        role=Role.DIFFUSE_COLOUR,
        advice="EON is an albedo: scale radiances to at most 1, or take oren_nayar, which allows any K_d",
    )
    r: Array = parameter(
        0.3,
        bounds=(0, 1),
        starts=(0.1, 0.5, 0.9),
        symbol="r",
        doc="roughness of the diffuse part; 0 is Lambert",
        role=Role.DIFFUSE_ROUGHNESS,
        simpler=0.0,
    )

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        r = self.r
        A_F = 1 / (1 + C_1 * r)
        single = self.once(xp, geometry)
        rho_ms = self._again(A_F)
        lost_i = _lost(xp, geometry.cos_theta_i, geometry.sin_theta_i)
        lost_r = _lost(xp, geometry.cos_theta_r, geometry.sin_theta_r)
        # Of the three factors r A_F of the second term two cancel.
        return equations.INV_PI * (single + rho_ms * (r * A_F) * (lost_i * lost_r) * (1 / (C_1 - C_2)))

    def once(self, xp: Array, geometry: Geometry) -> Array:
        """pi f of what is reflected once."""
        return self.rho * (1 / (1 + C_1 * self.r)) * _swing(xp, geometry, self.r)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return [Component(self.formula, CosineLobe(), self.rho)]

    def reflected(self, xp: Array, cos_theta_i: Array) -> Array:
        # Exact: the integrals that the second term was made of.
        rho, r = self.rho, self.r
        A_F = 1 / (1 + C_1 * r)
        lost = r * A_F * _lost(xp, cos_theta_i, xp.sqrt(xp.maximum(1 - cos_theta_i * cos_theta_i, 0.0)))
        return rho * (1 - lost) + self._again(A_F) * lost

    def _again(self, A_F: Array) -> Array:
        """rho_ms: the colour of light that is reflected several times.

        1 - E_F is r A_F times what is lost, and so is its mean, C_1 - C_2.
        """
        rho, r = self.rho, self.r
        return rho * rho * (A_F * (1 + C_2 * r)) / (1 - rho * ((C_1 - C_2) * r * A_F))

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        return [StandardLobe(Reflection.DIFFUSE, values.rho, roughness=values.r, preserving=True)]
