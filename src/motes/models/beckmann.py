r"""Beckmann: facets with Gaussian slopes, normalised, with Smith's height-correlated masking.

.. math::  D = \frac{\exp(-\tan^2\theta_h / \alpha^2)}{\pi \alpha^2 \cos^4\theta_h}, \quad
           \Lambda(\theta) = \frac{1}{2} \left(\frac{e^{-a^2}}{a \sqrt\pi} - \mathrm{erfc}(a)\right), \quad a = \frac{1}{\alpha \tan\theta}

Source: Walter, Marschner, Li, Torrance, EGSR 2007, equation (25); Beckmann, Spizzichino 1963; Smith, IEEE TAP 15(5), 1967; Heitz, JCGT
3(2), 2014."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar, final

from motes import equations
from motes.arrays import Array
from motes.directions import Geometry, Vector
from motes.models.compensated import Compensated
from motes.models.facet_albedo import BECKMANN_ALBEDO, GAUSSIAN_SPREAD, FacetAlbedo
from motes.models.lobes import Lobe, Reflection, mirrored
from motes.models.missing_energy import BECKMANN_MISSING, MissingEnergy
from motes.models.naming import register

#: 1/sqrt(pi) - a exp(a^2) erfc(a) as a polynomial of (a - 2)/(a + 2) on 0 <= a <= 6, lowest power first; its error times exp(-a^2) is
#: below 1.5e-15.  Printed by ``tools/minimax.py``.
_MASKED = (
    0.0533982309267692,
    -0.1672110104162475,
    0.20384429587750885,
    -0.12151493064264962,
    0.02897645093946466,
    0.007515777216490018,
    -0.0047847989933795625,
    -0.0011270156485050481,
    0.000746616959073672,
    0.0003011502588216751,
    -0.00011890853797843126,
    -0.00013306438514634818,
    -5.003310056350267e-05,
    -9.338381300613282e-06,
    -7.025216746271187e-07,
)
_ROOT_PI = math.sqrt(math.pi)
# No unit vector above the horizon has a smaller squared cosine to the half vector; it keeps 1/cos^4 finite in float32.
_LEAST_SQUARE = 1e-13


def beckmann_distribution(xp: Array, geometry: Geometry, alpha: Array) -> Array:
    """D [1/sr]."""
    a2, sine = alpha * alpha, geometry.sin_theta_h
    square = xp.maximum(geometry.cos_theta_h * geometry.cos_theta_h, _LEAST_SQUARE)
    return equations.INV_PI * (xp.exp(-(sine * sine) / (a2 * square)) / (a2 * square * square))


def beckmann_masked(xp: Array, cos_theta: Array, sin_theta: Array, alpha: Array) -> Array:
    """cos(theta) Lambda(theta) = alpha sin(theta) a Lambda; beyond a = 6 it is below 1e-17 of cos(theta)."""
    slope = alpha * sin_theta
    a = cos_theta / xp.maximum(slope, cos_theta * (1 / 6))
    t = (a - 2) / (a + 2)
    p: Array = _MASKED[-1]
    for c in _MASKED[-2::-1]:
        p = p * t + c
    return slope * (0.5 * xp.exp(-(a * a)) * p)


def _erf(xp: Array, x: Array) -> Array:
    """The error function to 1.5e-7 (Hastings 1955; Abramowitz, Stegun, 7.1.26): what a sample is chosen with, never a value."""
    size = xp.maximum(x, -x)
    t = 1 / (1 + 0.3275911 * size)
    p = ((((1.061405429 * t - 1.453152027) * t + 1.421413741) * t - 0.284496736) * t + 0.254829592) * t
    positive = 1 - p * xp.exp(-(size * size))
    return xp.where(x >= 0, positive, -positive)


def _inverse_erf(xp: Array, x: Array) -> Array:
    """The inverse error function in single precision (M. Giles, "Approximating the erfinv function", GPU Computing Gems 2, 2011)."""
    w = -xp.log(xp.maximum((1 - x) * (1 + x), 1e-30))
    near, far = w - 2.5, xp.sqrt(xp.maximum(w, 1e-6)) - 3
    p, q = 2.81022636e-08, -0.000200214257
    for c in (
        3.43273939e-07,
        -3.5233877e-06,
        -4.39150654e-06,
        0.00021858087,
        -0.00125372503,
        -0.00417768164,
        0.246640727,
        1.50140941,
    ):
        p = p * near + c
    for c in (
        0.000100950558,
        0.00134934322,
        -0.00367342844,
        0.00573950773,
        -0.0076224613,
        0.00943887047,
        1.00167406,
        2.83297682,
    ):
        q = q * far + c
    return x * xp.where(w < 5, p, q)


@dataclass(frozen=True)
class VisibleBeckmannLobe(Lobe):
    """Mirror at a facet that the given direction sees.

    Slopes are scaled to alpha = 1. There the slope across the plane of incidence is Gaussian; of the one along it the distribution function is
    inverted by three steps of Newton's method in erf(slope), where it is nearly straight (W. Jakob, "An improved visible normal sampling
    routine for the Beckmann distribution", 2014)."""

    reflection: ClassVar[Reflection] = Reflection.GLOSSY
    turns: ClassVar[bool] = False  # the numbers choose two slopes

    alpha: Array

    def sample(self, xp: Array, wi: Array, u: Array) -> Array:
        i = Vector.split(wi)
        flat = xp.sqrt(i.x * i.x + i.y * i.y)
        length = xp.sqrt(self.alpha * self.alpha * flat * flat + i.z * i.z)
        cosine = xp.maximum(i.z / length, 1e-6)
        sine = self.alpha * flat / length
        # Slopes s towards the given direction are seen where s > -cot(theta); the density is (cos + s sin) exp(-s^2).
        end = cosine / xp.maximum(sine, 1e-6)
        most, tail = _erf(xp, end), sine * (1 / _ROOT_PI)
        edge = tail * xp.exp(-xp.minimum(end * end, 80.0))
        chosen = xp.maximum(u[..., 0], 1e-7)
        wanted = chosen * (cosine * (1 + most) + edge)
        # x = erf of minus the slope, from -1 to `most`.
        x = most - (most + 1) * _erf(xp, xp.sqrt(-xp.log(chosen)))
        for _ in range(3):
            x = xp.maximum(xp.minimum(x, most), -1 + 1e-7)
            s = _inverse_erf(xp, x)
            reached = cosine * (1 + x) + tail * xp.exp(-(s * s))
            x = x - (reached - wanted) / xp.maximum(cosine - s * sine, 1e-6)
        along = -_inverse_erf(xp, xp.maximum(xp.minimum(x, most), -1 + 1e-7))
        across = _inverse_erf(xp, 2 * xp.maximum(xp.minimum(u[..., 1], 1 - 1e-7), 1e-7) - 1)
        # Back to the frame of the surface; at normal incidence any azimuth will do.
        away = flat > 1e-12
        size = xp.maximum(flat, 1e-12)
        c, s = xp.where(away, i.x / size, 1 + 0 * flat), xp.where(away, i.y / size, 0 * flat)
        x, y = self.alpha * (along * c - across * s), self.alpha * (along * s + across * c)
        return mirrored(xp, i, x, y, 1 + 0 * x)

    def pdf(self, xp: Array, wi: Array, wo: Array) -> Array:
        geometry = Geometry(xp, Vector.split(wi), Vector.split(wo))
        seen = geometry.cos_theta_i + beckmann_masked(xp, geometry.cos_theta_i, geometry.sin_theta_i, self.alpha)
        return 0.25 * beckmann_distribution(xp, geometry, self.alpha) / seen


@register("beckmann")
@final
@dataclass(frozen=True, eq=False)
class Beckmann(Compensated):
    """Mirror-like facets whose slopes are Gaussian: the highlight falls off faster than that of `GGX`.

    Parameters
    ----------
    K_s
        The share of light that facets reflect. With a Fresnel term its factor: with ``Schlick(f0)`` facets reflect ``K_s f0`` at normal and
        ``K_s``, which others call f90, at grazing incidence.
    alpha
        Roughness, sqrt(2) times the standard deviation of the slope in any direction.
    fresnel
        None for F = 1, or `Dielectric`, `Conductor`, `Schlick`.
    scattering
        ``"single"``: light that facets send to each other is lost.  ``"multiple"``: it comes back, coloured by each further reflection
        (`motes.models.compensated`).

    Notes
    -----
    Smith's masking is exact (many programs have Walter's rational approximation, off by up to 0.3 %) and height-correlated. For small alpha,
    D is that of `TorranceSparrow` with ``normalization="facets"`` and sigma_s = alpha."""

    words: ClassVar[str] = "Beckmann"
    kind: ClassVar[str] = "beckmann"
    facet_albedo: ClassVar[FacetAlbedo] = BECKMANN_ALBEDO
    missing: ClassVar[MissingEnergy] = BECKMANN_MISSING
    approximation: ClassVar[str] = (
        "Beckmann: the same facets in Mitsuba, whose masking multiplies that of both directions; elsewhere GGX of the same alpha, whose tails "
        "are longer; with scattering=multiple light reflected several times is a diffuse lobe, in MaterialX the program's own, in Mitsuba "
        "nothing where a blend has no room."
    )

    def distribution(self, xp: Array, geometry: Geometry) -> Array:
        return beckmann_distribution(xp, geometry, self.alpha)

    def masked(self, xp: Array, cos_theta: Array, sin_theta: Array) -> Array:
        return beckmann_masked(xp, cos_theta, sin_theta, self.alpha)

    def spread(self) -> Array | None:
        return GAUSSIAN_SPREAD * self.alpha

    def lobe(self) -> Lobe:
        return VisibleBeckmannLobe(self.alpha)
