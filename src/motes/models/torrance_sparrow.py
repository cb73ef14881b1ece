r"""The Torrance-Sparrow specular model, equations (9)-(11).

.. math::  f = K_s \rho_s, \quad \rho_s = \frac{D G F}{4 \cos\theta_i \cos\theta_r}

Source: K. E. Torrance, E. M. Sparrow, "Theory for off-specular reflection from roughened surfaces", JOSA 57(9), 1967,
as printed in appendix B of "Time-Varying BRDFs"."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar, Self, final

from motes import equations
from motes.arrays import NUMPY, Array
from motes.directions import HALF_PI, Geometry
from motes.models.base import BRDF
from motes.models.components import Component
from motes.models.facet_albedo import GAUSSIAN_SPREAD, TORRANCE_SPARROW_ALBEDO
from motes.models.fresnel import Fresnel
from motes.models.lobes import FacetLobe, Reflection
from motes.models.naming import register
from motes.models.standard import StandardLobe
from motes.parameters import Place, Role, option, parameter, part


@register("torrance_sparrow")
@final
@dataclass(frozen=True, eq=False)
class TorranceSparrow(BRDF):
    """Mirror-like facets whose tilt theta_h is distributed as exp(-(theta_h/sigma_s)^2).

    Parameters
    ----------
    K_s, sigma_s
        Strength, and width [rad], of the highlight.
    normalization
        ``"printed"``: D(0) = 1 as in equation (10), so that the energy goes with sigma_s^2 and K_s is the height of the
        highlight.  ``"facets"``: D is divided by the facets' projected area (exactly, not by pi sigma_s^2), so that K_s
        is about the energy.
    fresnel
        None for F = 1 as in the source, or `Dielectric`, `Conductor`, `Schlick`.
    """

    words: ClassVar[str] = "Torrance-Sparrow"
    approximation: ClassVar[str] = (
        "Torrance-Sparrow: GGX of alpha = sigma_s whose height and energy agree (K_s pi sigma_s^2, or K_s where D is "
        "normalised); its tails are longer, and the shadowing is Smith's."
    )

    K_s: Array = parameter(
        0.3,
        bounds=(0, float("inf")),
        typical=(0, 1),
        symbol="K_s",
        doc="strength of the highlight",
        per_channel=True,
        shared_in_fit=True,
        role=Role.HIGHLIGHT_STRENGTH,
        simpler=0.0,
    )
    sigma_s: Array = parameter(
        0.15,
        bounds=(0.001, HALF_PI),
        fit_bounds=(0.005, HALF_PI),
        typical=(0.02, 0.8),
        starts=(0.02, 0.04, 0.08, 0.15, 0.25, 0.4, 0.65, 1.0),
        symbol="\\sigma_s",
        unit="rad",
        doc="width of the distribution of facet normals",
        role=Role.HIGHLIGHT_WIDTH,
    )
    normalization: str = option("printed", words=("printed", "facets"), doc="what D is normalised to")
    fresnel: Fresnel | None = part(
        Fresnel,
        place=Place.FRESNEL,
        default=None,
        what="a Fresnel term",
        advice="Give Dielectric(n), Conductor(n, k), Schlick(f0) or None",
    )

    def _distribution(self, xp: Array, theta_h: Array) -> Array:
        D = equations.D(xp, theta_h, self.sigma_s)
        return D / equations.facet_area(xp, self.sigma_s) if self.normalization == "facets" else D

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        cos_i, cos_r, cos_d = geometry.cos_theta_i, geometry.cos_theta_r, geometry.cos_theta_d
        G = equations.G(xp, cos_i, cos_r, geometry.cos_theta_h, cos_d, cos_d)
        F = self._fresnel(xp, cos_d)
        return self.K_s * equations.rho_s(xp, self._distribution(xp, geometry.theta_h), G, F, cos_i, cos_r)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        # With narrow facets the reflected share is K_s F(theta_i) times their projected area, 1 once normalised.
        F = self._fresnel(xp, cos_theta_i)
        area = 1.0 if self.normalization == "facets" else xp.minimum(3.14 * self.sigma_s * self.sigma_s, 1.0)
        return [Component(self.formula, FacetLobe(self.sigma_s), self.K_s * F * area)]

    def reflected(self, xp: Array, cos_theta_i: Array) -> Array:
        area = 1.0 if self.normalization == "facets" else equations.facet_area(xp, self.sigma_s)
        return self.K_s * area * TORRANCE_SPARROW_ALBEDO(xp, cos_theta_i, self.sigma_s, self._fresnel)

    def spread(self) -> Array | None:
        return GAUSSIAN_SPREAD * self.sigma_s

    def _fresnel(self, xp: Array, cosine: Array) -> Array:
        return 1.0 if self.fresnel is None else self.fresnel.reflectance(xp, cosine)

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        # GGX has D(0) = 1/(pi alpha^2): with that area the height at the mirror direction and the energy stay.  F follows Schlick's
        # curve from its value at normal incidence.
        area = 1.0 if self.normalization == "facets" else math.pi * values.sigma_s * values.sigma_s
        normal = 1.0 if values.fresnel is None else values.fresnel.at_normal()
        return [StandardLobe(Reflection.GLOSSY, values.K_s * area, normal, values.sigma_s)]

    def printed_highlight(self, strength: Array, width: Array) -> tuple[Array, Array] | None:
        if self.fresnel is not None:
            return None
        return (strength / equations.facet_area(NUMPY, width) if self.normalization == "facets" else strength), width
