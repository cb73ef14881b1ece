r"""What the models of mirror-like facets with Smith's shadowing share: strength, roughness, the Fresnel term, and the height-correlated masking.

.. math::  f = K_s \frac{F D G_2}{4 \cos\theta_i \cos\theta_r}, \quad G_2 = \frac{1}{1 + \Lambda(\theta_i) + \Lambda(\theta_r)}

Source: B. Walter, S. Marschner, H. Li, K. Torrance, "Microfacet models for refraction through rough surfaces", EGSR 2007; the
masking by which heights of facets are the same towards light and viewer: E. Heitz, "Understanding the masking-shadowing function in
microfacet-based BRDFs", JCGT 3(2), 2014, equation (99)."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import Any, ClassVar, Self

from motes.arrays import Array
from motes.directions import Geometry
from motes.models.base import BRDF
from motes.models.components import Component
from motes.models.facet_albedo import FacetAlbedo
from motes.models.fresnel import Fresnel
from motes.models.lobes import Lobe, Reflection
from motes.models.standard import StandardLobe
from motes.parameters import Place, Role, parameter, part


def fresnel_term() -> Any:
    """The field for a Fresnel term, or none for F = 1."""
    return part(
        Fresnel,
        place=Place.FRESNEL,
        default=None,
        what="a Fresnel term",
        advice="Give Dielectric(n), Conductor(n, k), Schlick(f0) or None",
    )


@dataclass(frozen=True, eq=False)
class Microfacet(BRDF):
    """Mirror-like facets whose distribution is normalised: K_s is the share of light that a facet reflects where F = 1."""

    K_s: Array = parameter(
        0.3,
        bounds=(0, float("inf")),
        typical=(0, 1),
        symbol="K_s",
        doc="share of light that facets reflect, or its factor where there is a Fresnel term",
        per_channel=True,
        shared_in_fit=True,
        role=Role.HIGHLIGHT_STRENGTH,
        simpler=0.0,
    )
    alpha: Array = parameter(
        0.2,
        bounds=(0.001, 1),
        fit_bounds=(0.005, 1),
        typical=(0.02, 0.8),
        starts=(0.02, 0.05, 0.1, 0.2, 0.4, 0.7),
        symbol="\\alpha",
        doc="roughness alpha of Walter et al.: a typical slope of the facets; neither its square nor its root",
        role=Role.HIGHLIGHT_WIDTH,
    )

    #: What programs call exactly this distribution, ``ggx`` or ``beckmann``; empty where they have none such.
    kind: ClassVar[str] = ""
    #: The share of light that its facets reflect.
    facet_albedo: ClassVar[FacetAlbedo]

    @abstractmethod
    def distribution(self, xp: Array, geometry: Geometry) -> Array:
        """D(theta_h) [1/sr]: the integral of D cos(theta_h) over the hemisphere is 1."""

    @abstractmethod
    def masked(self, xp: Array, cos_theta: Array, sin_theta: Array) -> Array:
        """cos(theta) Lambda(theta), which is finite up to the horizon."""

    @abstractmethod
    def lobe(self) -> Lobe:
        """What chooses its directions."""

    def fresnel_reflectance(self, xp: Array, cosine: Array) -> Array:
        """F at a facet, 1 without a Fresnel term."""
        terms = self.at_place(Place.FRESNEL)
        return terms[0].reflectance(xp, cosine) if terms else 1.0

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        i, r = geometry.cos_theta_i, geometry.cos_theta_r
        # 4 cos cos / G_2, multiplied out so that nothing is divided by a cosine.
        masked_i = self.masked(xp, i, geometry.sin_theta_i)
        masked_r = self.masked(xp, r, geometry.sin_theta_r)
        below = 4 * (i * r + masked_i * r + i * masked_r)
        return self.K_s * self.fresnel_reflectance(xp, geometry.cos_theta_d) * self.distribution(xp, geometry) / below

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return [Component(self.formula, self.lobe(), self.K_s * self.fresnel_reflectance(xp, cos_theta_i))]

    def reflected(self, xp: Array, cos_theta_i: Array) -> Array:
        return self.K_s * self.facet_albedo(xp, cos_theta_i, self.alpha, self.fresnel_reflectance)

    def spread(self) -> Array | None:
        return self.alpha

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        return self._mirrors(values)

    def _mirrors(self, values: Microfacet) -> list[StandardLobe]:
        """The standard lobe with the strength, roughness and Fresnel term of `values`."""
        terms = values.at_place(Place.FRESNEL)
        normal = terms[0].at_normal() if terms else 1.0
        index = terms[0].index() if terms else None
        return [StandardLobe(Reflection.GLOSSY, values.K_s, normal, values.alpha, distribution=self.kind, index=index)]
