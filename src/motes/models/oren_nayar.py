r"""The full Oren-Nayar model of rough diffuse surfaces, equations (1)-(8): direct light and one inter-reflection.

.. math::  f = \max(0, \rho_d^1 + \rho_d^2)

Source: M. Oren, S. K. Nayar, "Generalization of Lambert's reflectance model", SIGGRAPH 1994, as printed in appendix A
of "Time-Varying BRDFs"."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self, final

from motes import equations
from motes.arrays import Array
from motes.directions import HALF_PI, Geometry
from motes.models.base import BRDF
from motes.models.components import Component
from motes.models.lobes import CosineLobe, Reflection
from motes.models.multiple_scattering import polynomial
from motes.models.naming import register
from motes.models.standard import StandardLobe
from motes.parameters import Role, parameter

#: The integrals over the hemisphere, with the cosine and over pi, of cos(dphi) C2 tan(beta) and of the term with C3 in (1), without
#: their factors of sigma_d: in mu, within 3e-5, and in mu / (mu + 0.4), within 6e-3.
SECOND = [0.215358, -0.317163, -0.009602, 0.108667, 0.002762]
THIRD = [0.62725, -1.793234, 3.26972, -4.736881, 2.732529]


@register("oren_nayar")
@final
@dataclass(frozen=True, eq=False)
class OrenNayar(BRDF):
    """V-shaped grooves of Lambertian facets: plaster, clay, cloth, the dry side of paint.

    Notes
    -----
    Equation (1) goes negative near grazing forward scatter for sigma_d >= 0.7; this model clamps the sum at 0.  It
    grows without bound where both directions graze (eval times cos(theta_i) stays finite: fit on that).  It is not
    linear in K_d, and its albedo is not K_d: the spherical albedo for K_d = 1 is 1.0002 at sigma_d = 0.1 and 0.80 at
    1.0, and the directional one reaches 1.05."""

    words: ClassVar[str] = "Oren-Nayar"
    approximation: ClassVar[str] = (
        "Oren-Nayar: roughness is sigma_d in radians; C3, the side cos(phi_r - phi_i) < 0 of (1) and the inter-reflection (7) "
        "are left out."
    )

    K_d: Array = parameter(
        0.5,
        bounds=(0, float("inf")),
        typical=(0, 1),
        symbol="K_d",
        doc="diffuse reflectance of a facet",
        per_channel=True,
        role=Role.DIFFUSE_COLOUR,
    )
    sigma_d: Array = parameter(
        0.3,
        bounds=(0, HALF_PI),
        starts=(0.1, 0.35, 0.9),
        symbol="\\sigma_d",
        unit="rad",
        doc="standard deviation of the facets' slope angle",
        squared=True,
        role=Role.DIFFUSE_ROUGHNESS,
        simpler=0.0,
    )

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        alpha = equations.alpha(xp, geometry.theta_r, geometry.theta_i)
        beta = equations.beta(xp, geometry.theta_r, geometry.theta_i)
        C1 = equations.C1(xp, self.sigma_d)
        C2 = equations.C2(xp, geometry.sin_alpha, geometry.sin_alpha_less_cube, geometry.cos_dphi, self.sigma_d)
        C3 = equations.C3(xp, alpha, beta, self.sigma_d)
        rho_d1 = equations.rho_d1(
            xp,
            C1,
            C2,
            C3,
            geometry.cos_dphi,
            geometry.one_less_abs_cos_dphi,
            geometry.tan_beta,
            geometry.tan_half,
            self.K_d,
        )
        rho_d2 = equations.rho_d2(xp, beta, geometry.cos_dphi, self.sigma_d, self.K_d)
        return xp.maximum(equations.rho_d(xp, rho_d1, rho_d2), 0.0)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return [Component(self.formula, CosineLobe(), self.K_d)]

    def reflected(self, xp: Array, cos_theta_i: Array) -> Array:
        # (1) and (7) are linear in functions of sigma_d; their factors, integrated over the hemisphere, are functions of theta_i alone,
        # here as polynomials.  The integral over (7) is exact.  Where (8) is negative, which the model clamps, this is too small.
        s2 = self.sigma_d * self.sigma_d
        bend = cos_theta_i / (cos_theta_i + 0.4)
        second, third = polynomial(SECOND, cos_theta_i), polynomial(THIRD, bend)
        single = equations.C1(xp, self.sigma_d) + s2 / (s2 + 0.09) * (0.45 * second + 0.125 * third)
        return self.K_d * (single + self.K_d * 0.17 * (s2 / (s2 + 0.13)))

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        # These are (1)-(5) without C3, without the side cos(phi_r - phi_i) < 0 and without the inter-reflection (7).
        return [StandardLobe(Reflection.DIFFUSE, values.K_d, roughness=values.sigma_d)]
