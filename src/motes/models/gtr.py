r"""GTR, the generalised Trowbridge-Reitz distribution: a highlight whose tail is a parameter.

.. math::  D = \frac{c}{(\alpha^2 \cos^2\theta_h + \sin^2\theta_h)^\gamma}

gamma = 2 is GGX, less has longer tails, more goes towards Gaussian facets.

Source: B. Burley, "Physically based shading at Disney", SIGGRAPH 2012 course notes, appendix B, normalised as there. Its masking is
ours: Smith's for GGX of the roughness whose facets fill as much of a grazing view."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import ClassVar, Self, final

from motes import equations
from motes.arrays import Array
from motes.directions import Geometry, Vector
from motes.models.facet_albedo import GGX_ALBEDO
from motes.models.fresnel import Fresnel
from motes.models.ggx import ggx_masked
from motes.models.lobes import TWO_PI, Lobe, Reflection, mirrored
from motes.models.microfacet import Microfacet, fresnel_term
from motes.models.naming import register
from motes.models.standard import StandardLobe
from motes.parameters import Role, parameter

#: Nodes of the integral for the masking, and how far it reaches in ln(tan(theta_h)): from ln(alpha) - 3 to 2.5, and the rest in closed form.
_NODES, _BELOW, _ABOVE = 14, 3.0, 2.5


def _ratio(xp: Array, x: Array) -> Array:
    """(exp(x) - 1) / x, 1 at 0."""
    small = 1 + 0.5 * x * (1 + x * (1 / 3) * (1 + 0.25 * x))
    near = xp.maximum(x, -x) < 2e-3
    return xp.where(near, small, xp.expm1(x) / xp.where(near, 1.0, x))


def _narrowness(xp: Array, alpha: Array) -> Array:
    """L = -2 ln(alpha), with all digits near alpha = 1."""
    return xp.log1p((1 - alpha) * (1 + alpha) / (alpha * alpha))


def gtr_peak(xp: Array, alpha: Array, gamma: Array) -> Array:
    """D at theta_h = 0.  With y = (gamma - 1) L the paper's constant is that of gamma = 1 divided by (1 - exp(-y)) / y."""
    L = _narrowness(xp, alpha)
    return equations.INV_PI * _ratio(xp, L) / _ratio(xp, -(gamma - 1) * L)


def _fall(xp: Array, sine2: Array, alpha: Array, gamma: Array) -> Array:
    """D over its peak, (1 + sin^2(theta_h) (1/alpha^2 - 1))^-gamma."""
    return xp.exp(-gamma * xp.log1p(sine2 * ((1 - alpha) * (1 + alpha) / (alpha * alpha))))


def gtr_grazing_roughness(xp: Array, alpha: Array, gamma: Array) -> Array:
    """The alpha of the GGX whose facets fill as much of a grazing view, 4 times the integral of D sin^2 over theta_h in [0, pi/2].

    The trapezoidal rule in x = ln(tan(theta_h)) is right to 1 %, to 4 % for alpha = 0.001; of the rest, above x = 2.5, D is as at pi/2.
    """
    start = -0.5 * _narrowness(xp, alpha) - _BELOW
    step = (_ABOVE - start) * (1 / (_NODES - 1))
    total: Array = 0.0
    for k in range(_NODES):
        tan = xp.exp(start + k * step)
        cos2 = 1 / (1 + tan * tan)
        sine2 = tan * tan * cos2
        weight = 0.5 if k in (0, _NODES - 1) else 1.0
        # d(theta) = sin cos dx
        total = total + weight * (_fall(xp, sine2, alpha, gamma) * sine2 * (tan * cos2))
    rest = _fall(xp, 1.0, alpha, gamma) * math.atan(math.exp(-_ABOVE))
    return 4 * gtr_peak(xp, alpha, gamma) * (total * step + rest)


@dataclass(frozen=True)
class GTRLobe(Lobe):
    """Mirror at a facet whose normal has the density D cos(theta_h), of those less steep than any that reflects above the horizon.

    That is theta_h <= (theta_i + pi/2) / 2, so sin^2(theta_h) <= (1 + sin(theta_i)) / 2."""

    reflection: ClassVar[Reflection] = Reflection.GLOSSY

    alpha: Array
    gamma: Array

    def _inside(self, xp: Array, i: Vector) -> tuple[Array, Array, Array]:
        """L and gamma - 1, kept from 0, where the inversion would be 0/0; and the share of all facets that is not too steep."""
        L = xp.maximum(_narrowness(xp, self.alpha), 1e-4)
        more = xp.maximum(self.gamma - 1, 1e-4)
        steepest = 0.5 + 0.5 * xp.minimum(xp.sqrt(i.x * i.x + i.y * i.y), 1.0)
        return L, more, xp.expm1(-more * xp.log1p(steepest * xp.expm1(L))) / xp.expm1(-more * L)

    def sample(self, xp: Array, wi: Array, u: Array) -> Array:
        i = Vector.split(wi)
        L, more, inside = self._inside(xp, i)
        v = xp.expm1(-xp.log1p(u[..., 0] * inside * xp.expm1(-more * L)) / more)
        sine2 = xp.maximum(xp.minimum(v / xp.expm1(L), 1.0), 0.0)
        sine, azimuth = xp.sqrt(sine2), TWO_PI * u[..., 1]
        return mirrored(xp, i, sine * xp.cos(azimuth), sine * xp.sin(azimuth), xp.sqrt(1 - sine2) + 0 * azimuth)

    def pdf(self, xp: Array, wi: Array, wo: Array) -> Array:
        i = Vector.split(wi)
        geometry = Geometry(xp, i, Vector.split(wo))
        sine2 = geometry.sin_theta_h * geometry.sin_theta_h
        D = gtr_peak(xp, self.alpha, self.gamma) * _fall(xp, sine2, self.alpha, self.gamma)
        return 0.25 * D * geometry.cos_theta_h / (geometry.cos_theta_d * self._inside(xp, i)[2])


@register("gtr")
@final
@dataclass(frozen=True, eq=False)
class GTR(Microfacet):
    """Mirror-like facets with a tail that the data choose: enamel, metallic paint, worn metal.

    Parameters
    ----------
    K_s, alpha
        As of `GGX`.
    gamma
        Exponent: 2 is GGX, towards 1 ever longer tails, above ever shorter ones.
    fresnel
        None for F = 1, or `Dielectric`, `Conductor`, `Schlick`.

    Notes
    -----
    Smith's masking has no closed form for it. It is that of GGX, height-correlated, of the roughness with which the facets fill as much
    of a grazing view: alpha = 0.19 for alpha = 0.05 and gamma = 1.25. With it no more light leaves than arrives, from any
    direction. Samples are drawn from all facets, not from those in sight."""

    words: ClassVar[str] = "GTR"
    approximation: ClassVar[str] = (
        "GTR: GGX of the same width at half the height of D; its tails are shorter where gamma < 2, longer where it is above."
    )

    gamma: Array = parameter(
        2.0,
        bounds=(1, 10),
        typical=(1, 4),
        starts=(1.3, 2.0, 4.0),
        symbol="\\gamma",
        doc="exponent of the tail of the highlight: 2 is GGX, 1 the longest",
        role=Role.HIGHLIGHT_TAIL,
        simpler=2.0,
    )
    fresnel: Fresnel | None = fresnel_term()

    def distribution(self, xp: Array, geometry: Geometry) -> Array:
        sine2 = geometry.sin_theta_h * geometry.sin_theta_h
        return gtr_peak(xp, self.alpha, self.gamma) * _fall(xp, sine2, self.alpha, self.gamma)

    def masked(self, xp: Array, cos_theta: Array, sin_theta: Array) -> Array:
        return ggx_masked(xp, cos_theta, sin_theta, gtr_grazing_roughness(xp, self.alpha, self.gamma))

    def reflected(self, xp: Array, cos_theta_i: Array) -> Array:
        # As much light is lost as of the GGX that has the same masking, within 0.045.
        rough = gtr_grazing_roughness(xp, self.alpha, self.gamma)
        return self.K_s * GGX_ALBEDO(xp, cos_theta_i, rough, self.fresnel_reflectance)

    def lobe(self) -> Lobe:
        return GTRLobe(self.alpha, self.gamma)

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        # D falls to half its height where tan^2 is alpha^2 (2^(1/gamma) - 1), for small alpha.
        wider = xp.sqrt(xp.expm1(math.log(2) / values.gamma) * (1 / (math.sqrt(2) - 1)))
        return [replace(lobe, roughness=lobe.roughness * wider) for lobe in self._mirrors(values)]
