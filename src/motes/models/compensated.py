r"""Light that facets pass on to each other, given back: a second part of GGX and of Beckmann's model with ``scattering="multiple"``.

.. math::  f = f_1 + K_s \frac{C}{\pi} \frac{M(\theta_i) M(\theta_r)}{\langle M \rangle}, \quad
           C = \frac{\bar F^2 (1 - q)}{1 - \bar F q}

M is the share of light that facets of F = 1 do not reflect at once, <M> its mean over uniform light, and the mean of F is over uniform light, too. C is the
series of light that is reflected twice, and a share q of it once more, and so on; where others take <M> for q, the numbers here are those of a random
walk among facets, which is lighter by up to 0.03.  With F = 1 and K_s = 1 all light comes back.

Source: C. Kelemen, L. Szirmay-Kalos, "A microfacet based coupled specular-matte BRDF model with importance sampling", Eurographics 2001; C. Kulla,
A. Conty, "Revisiting physically based shading at Imageworks", SIGGRAPH 2017; the walk: E. Heitz, J. Hanika, E. d'Eon, C. Dachsbacher,
"Multiple-scattering microfacet BSDFs with the Smith model", SIGGRAPH 2016."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar, Self

from motes import equations
from motes.arrays import Array
from motes.directions import Geometry
from motes.models.base import BRDF
from motes.models.components import Component, Piece
from motes.models.fresnel import Fresnel
from motes.models.lobes import TWO_PI, Lobe, Reflection
from motes.models.microfacet import Microfacet, fresnel_term
from motes.models.missing_energy import MissingEnergy
from motes.models.particles import MULTIPLE, SCATTERING, SINGLE
from motes.models.standard import StandardLobe
from motes.parameters import Place, option


@dataclass(frozen=True)
class RegainedLobe(Lobe):
    """Density proportional to mu/(mu^2 + c), c = (3 alpha)^2: the cosine for rough facets, towards the horizon for narrow ones, where light is missing."""

    reflection: ClassVar[Reflection] = Reflection.DIFFUSE

    alpha: Array

    def _inside(self, xp: Array) -> tuple[Array, Array]:
        """c, and the integral of 2 mu/(mu^2 + c) over cosines."""
        c = 9 * (self.alpha * self.alpha)
        return c, xp.log1p(1 / c)

    def sample(self, xp: Array, wi: Array, u: Array) -> Array:
        c, inside = self._inside(xp)
        # 1 - u >= 2^-53 for u < 1, so the sample is never below the horizon.
        square = xp.minimum(c * xp.expm1((1 - u[..., 0]) * inside), 1.0)
        sine, azimuth = xp.sqrt(1 - square), TWO_PI * u[..., 1]
        return xp.stack([sine * xp.cos(azimuth), sine * xp.sin(azimuth), xp.sqrt(square)])

    def pdf(self, xp: Array, wi: Array, wo: Array) -> Array:
        c, inside = self._inside(xp)
        cosine = xp.maximum(wo[..., 2], 0.0)
        return equations.INV_PI * cosine / ((cosine * cosine + c) * inside)


@dataclass(frozen=True, eq=False)
class Compensated(Microfacet):
    """Mirror-like facets whose light comes back after any number of reflections, if that is asked for."""

    fresnel: Fresnel | None = fresnel_term()
    scattering: str = option("single", words=SCATTERING, doc="how often light is reflected among facets")

    #: The share of light that its facets do not reflect at once.
    missing: ClassVar[MissingEnergy]

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        once = self.once(xp, geometry)
        return once if self.scattering == SINGLE else once + self.again(xp, geometry)

    def once(self, xp: Array, geometry: Geometry) -> Array:
        """The BRDF [1/sr] of light reflected once."""
        return super().formula(xp, geometry)

    def again(self, xp: Array, geometry: Geometry) -> Array:
        """The BRDF [1/sr] of light reflected more than once."""
        i, r = (self.missing(xp, cosine, self.alpha) for cosine in (geometry.cos_theta_i, geometry.cos_theta_r))
        return self._regained(xp) * (equations.INV_PI / self.missing.mean(xp, self.alpha)) * (i * r)

    def _regained(self, xp: Array) -> Array:
        """K_s C: the share of the missing light that comes back."""
        terms = self.at_place(Place.FRESNEL)
        if not terms:
            return self.K_s
        F, q = terms[0].mean(xp), self.missing.staying(xp, self.alpha)
        return self.K_s * (F * F * (1 - q) / (1 - F * q))

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        found = super().components(xp, cos_theta_i)
        return found if self.scattering == SINGLE else [*self._first(xp, cos_theta_i), *self._further(xp, cos_theta_i)]

    def _first(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return [Component(self.once, self.lobe(), self.K_s * self.fresnel_reflectance(xp, cos_theta_i))]

    def _further(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return [Component(self.again, RegainedLobe(self.alpha), self._reflected_again(xp)(cos_theta_i))]

    def reflected(self, xp: Array, cos_theta_i: Array) -> Array:
        if self.scattering == SINGLE:
            return super().reflected(xp, cos_theta_i)
        return self._reflected_once(xp)(cos_theta_i) + self._reflected_again(xp)(cos_theta_i)

    def _reflected_once(self, xp: Array) -> Callable[[Array], Array]:
        def of(cosine: Array) -> Array:
            met = self.facet_albedo.met(xp, cosine, self.alpha)
            return self.K_s * self.fresnel_reflectance(xp, met) * (1 - self.missing(xp, cosine, self.alpha))

        return of

    def _reflected_again(self, xp: Array) -> Callable[[Array], Array]:
        regained = self._regained(xp)
        return lambda cosine: regained * self.missing(xp, cosine, self.alpha)

    def pieces(self) -> tuple[BRDF | Piece, ...]:
        if self.scattering == SINGLE:
            return (self,)
        once = Piece(self.once, self._reflected_once, self._first, self.spread())
        return once, Piece(self.again, self._reflected_again, self._further, None, leaning=False)

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        mirrors = self._mirrors(values)
        if self.scattering == SINGLE:
            return mirrors
        # As much of uniform light as comes back: a mean of what is missing towards each direction.
        share = values._regained(xp) * self.missing.mean(xp, values.alpha)
        return [*mirrors, StandardLobe(Reflection.DIFFUSE, share, regained=True)]

    def in_words(self) -> str:
        said = super().in_words()
        return f"compensated {said}" if self.scattering == MULTIPLE else said
