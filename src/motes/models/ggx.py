r"""GGX: a highlight with long tails, normalised, with Smith's height-correlated masking.

.. math::  D = \frac{\alpha^2}{\pi (\alpha^2 \cos^2\theta_h + \sin^2\theta_h)^2}, \quad
           \Lambda(\theta) = \frac{\sqrt{1 + \alpha^2 \tan^2\theta} - 1}{2}

Source: Walter, Marschner, Li, Torrance, EGSR 2007, equation (33); Trowbridge, Reitz, JOSA 65(5), 1975; Heitz, JCGT 3(2), 2014."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, final

from motes import equations
from motes.arrays import Array
from motes.directions import Geometry, Vector
from motes.models.compensated import Compensated
from motes.models.facet_albedo import GGX_ALBEDO, FacetAlbedo
from motes.models.lobes import TWO_PI, Lobe, Reflection, mirrored
from motes.models.missing_energy import GGX_MISSING, MissingEnergy
from motes.models.naming import register


def ggx_distribution(xp: Array, geometry: Geometry, alpha: Array) -> Array:
    """D [1/sr]."""
    a2, cosine, sine = alpha * alpha, geometry.cos_theta_h, geometry.sin_theta_h
    t = a2 * cosine * cosine + sine * sine
    return equations.INV_PI * (a2 / (t * t))


def ggx_masked(xp: Array, cos_theta: Array, sin_theta: Array, alpha: Array) -> Array:
    """cos(theta) Lambda(theta); the difference of the root and the cosine is taken by their squares."""
    slope = alpha * sin_theta
    return 0.5 * (slope * slope) / (xp.sqrt(cos_theta * cos_theta + slope * slope) + cos_theta)


@dataclass(frozen=True)
class VisibleGGXLobe(Lobe):
    """Mirror at a facet that the given direction sees, of those that reflect above the horizon (mostly).

    Facets are chosen by a spherical cap (Dupuy, Benyoub, "Sampling visible GGX normals with spherical caps", 2023), cut where it
    would reflect below the horizon (Eto, Tokuyoshi, "Bounded VNDF sampling for Smith-GGX reflections", SIGGRAPH Asia 2023)."""

    reflection: ClassVar[Reflection] = Reflection.GLOSSY

    alpha: Array

    def _cut(self, xp: Array, i: Vector) -> tuple[Array, Array]:
        """The length of (alpha x, alpha y, z), and the share k of its cosine at which the cap ends."""
        a2, flat = self.alpha * self.alpha, i.x * i.x + i.y * i.y
        reach = 1 + xp.sqrt(flat)
        reach = reach * reach
        return xp.sqrt(a2 * flat + i.z * i.z), (1 - a2) * reach / (reach + a2 * i.z * i.z)

    def sample(self, xp: Array, wi: Array, u: Array) -> Array:
        i = Vector.split(wi)
        length, k = self._cut(xp, i)
        scale = self.alpha / length
        x, y, z = i.x * scale, i.y * scale, i.z / length
        end = k * xp.maximum(z, 0.0)
        cosine = (1 - u[..., 0]) * (1 + end) - end
        sine, azimuth = xp.sqrt(xp.maximum(1 - cosine * cosine, 0.0)), TWO_PI * u[..., 1]
        return mirrored(
            xp,
            i,
            self.alpha * (sine * xp.cos(azimuth) + x),
            self.alpha * (sine * xp.sin(azimuth) + y),
            xp.maximum(cosine + z, 0.0),
        )

    def pdf(self, xp: Array, wi: Array, wo: Array) -> Array:
        i = Vector.split(wi)
        length, k = self._cut(xp, i)
        geometry = Geometry(xp, i, Vector.split(wo))
        return ggx_distribution(xp, geometry, self.alpha) / (2 * (k * geometry.cos_theta_i + length))


@register("ggx")
@final
@dataclass(frozen=True, eq=False)
class GGX(Compensated):
    """Mirror-like facets with the long tails of ground glass: most polished, lacquered and metallic surfaces, better than Gaussian ones.

    Parameters
    ----------
    K_s
        The share of light that facets reflect. With a Fresnel term its factor: with ``Schlick(f0)`` facets reflect ``K_s f0`` at normal and
        ``K_s``, which others call f90, at grazing incidence.
    alpha
        Roughness. Programs that show a slider "roughness" square it: alpha = roughness^2.
    fresnel
        None for F = 1, or `Dielectric`, `Conductor`, `Schlick`.
    scattering
        ``"single"``: light that facets send to each other is lost.  ``"multiple"``: it comes back, coloured by each further reflection
        (`motes.models.compensated`).

    Notes
    -----
    The masking is height-correlated, as in Filament, MaterialX and Cycles; Mitsuba's `roughconductor` multiplies the masking of both
    directions, which is darker by 18 % where alpha = 0.4 and both are at 80 degrees.  Light that facets send to each other is lost: with
    K_s = 1 and F = 1, 2.8 % of uniform light at alpha = 0.1, 30 % at 0.5 and 59 % at 1."""

    words: ClassVar[str] = "GGX"
    kind: ClassVar[str] = "ggx"
    facet_albedo: ClassVar[FacetAlbedo] = GGX_ALBEDO
    missing: ClassVar[MissingEnergy] = GGX_MISSING
    approximation: ClassVar[str] = (
        "GGX: the same facets; where a program multiplies the masking of both directions (Mitsuba) it is darker "
        "towards grazing, and where it gives back light reflected several times (MaterialX) rough ones are brighter; with "
        "scattering=multiple that light is a diffuse lobe, in MaterialX the program's own, in Mitsuba nothing where a blend has no room."
    )

    def distribution(self, xp: Array, geometry: Geometry) -> Array:
        return ggx_distribution(xp, geometry, self.alpha)

    def masked(self, xp: Array, cos_theta: Array, sin_theta: Array) -> Array:
        return ggx_masked(xp, cos_theta, sin_theta, self.alpha)

    def lobe(self) -> Lobe:
        return VisibleGGXLobe(self.alpha)
