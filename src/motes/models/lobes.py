"""Warps of the unit square onto the hemisphere, each with its exact density: what the models sample with.

What belongs to a lobe stands with it: how it is sampled, its density, and what kind of reflection it is.  ``wi, wo`` are arrays
(..., 3), ``u`` is (..., 2) in [0, 1), densities are per solid angle [1/sr] with shape (...).  A sample may fall below the horizon
(`FacetLobe`): its energy is lost, and the density stays exact above."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from enum import Enum
from typing import ClassVar

from motes import equations
from motes.arrays import Array
from motes.directions import HALF_PI, SMALLEST_COSINE, Geometry, Vector

TWO_PI = 6.283185307179586


class Reflection(Enum):
    """What kind of reflection something is: what Mitsuba's ``BSDFFlags`` are made of.

    All models reflect, none has a Dirac peak.  One that mirrors or transmits gets a kind of its own here."""

    DIFFUSE = "diffuse"
    GLOSSY = "glossy"


class Lobe(ABC):
    """A way to choose an outgoing direction."""

    #: What kind of reflection it is made for.
    reflection: ClassVar[Reflection]
    #: Whether the second random number is an angle, over whose full turn equal steps integrate best.
    turns: ClassVar[bool] = True

    @abstractmethod
    def sample(self, xp: Array, wi: Array, u: Array) -> Array:
        """Directions ``wo`` (..., 3) from random numbers."""

    @abstractmethod
    def pdf(self, xp: Array, wi: Array, wo: Array) -> Array:
        """The density of `sample` (...) [1/sr]; what it says below the horizon is not looked at."""

    def shared(self, xp: Array, cos_theta: Array) -> list[tuple[Lobe, Array]]:
        """The lobes among which a renderer chooses in the place of this one, with their shares.

        ``cos_theta`` is the cosine of the direction that is given.  This lobe alone, unless another one finds light that it misses.
        """
        return [(self, 1.0)]


def mirrored(xp: Array, i: Vector, x: Array, y: Array, z: Array) -> Array:
    """Directions (..., 3): `i` mirrored at facets along (x, y, z), of any length."""
    scale = 1 / xp.sqrt(xp.maximum(x * x + y * y + z * z, 1e-30))
    x, y, z = x * scale, y * scale, z * scale
    twice = 2 * (i.x * x + i.y * y + i.z * z)
    return xp.stack([twice * x - i.x, twice * y - i.y, twice * z - i.z])


@dataclass(frozen=True)
class CosineLobe(Lobe):
    """Proportional to cos(theta_r): for diffuse surfaces."""

    reflection: ClassVar[Reflection] = Reflection.DIFFUSE

    def sample(self, xp: Array, wi: Array, u: Array) -> Array:
        radius, azimuth = xp.sqrt(u[..., 0]), TWO_PI * u[..., 1]
        # 1 - u >= 2^-53 for u < 1, so the sample is never below the horizon.
        return xp.stack([radius * xp.cos(azimuth), radius * xp.sin(azimuth), xp.sqrt(1 - u[..., 0])])

    def pdf(self, xp: Array, wi: Array, wo: Array) -> Array:
        return equations.INV_PI * xp.maximum(wo[..., 2], 0.0)


@dataclass(frozen=True)
class FacetLobe(Lobe):
    """Mirror at a facet whose theta_h has the density proportional to theta_h exp(-(theta_h/sigma_s)^2) on [0, pi/2].

    That is D of equation (10) but for theta_h / (sin(theta_h) cos(theta_h)), and its distribution inverts in closed
    form."""

    reflection: ClassVar[Reflection] = Reflection.GLOSSY

    sigma_s: Array

    def _inside(self, xp: Array) -> Array:
        """The share of the untruncated density on [0, pi/2], 1 - exp(-(pi/2 / sigma_s)^2)."""
        t = HALF_PI / self.sigma_s
        return -xp.expm1(-(t * t))

    def sample(self, xp: Array, wi: Array, u: Array) -> Array:
        theta_h = self.sigma_s * xp.sqrt(-xp.log(1 - u[..., 0] * self._inside(xp)))
        theta_h, azimuth = xp.minimum(theta_h, HALF_PI), TWO_PI * u[..., 1]
        sin_theta_h = xp.sin(theta_h)
        x, y, z = sin_theta_h * xp.cos(azimuth), sin_theta_h * xp.sin(azimuth), xp.cos(theta_h)
        i = Vector.split(wi)
        twice = 2 * (i.x * x + i.y * y + i.z * z)
        return xp.stack([twice * x - i.x, twice * y - i.y, twice * z - i.z])

    def pdf(self, xp: Array, wi: Array, wo: Array) -> Array:
        # A sample below the horizon, or from behind its facet, has wo.z <= 0 and no density: `BRDF.pdf` masks it.
        geometry = Geometry(xp, Vector.split(wi), Vector.split(wo))
        theta_h, sin_theta_h = geometry.theta_h, geometry.sin_theta_h
        ratio = xp.where(sin_theta_h > 1e-6, theta_h / xp.maximum(sin_theta_h, 1e-6), 1.0)
        normaliser = 4 * 0.5 * TWO_PI * self.sigma_s * self.sigma_s * self._inside(xp)
        return ratio * equations.D(xp, theta_h, self.sigma_s) / (normaliser * geometry.cos_theta_d)


@dataclass(frozen=True)
class PhaseLobe(Lobe):
    """The Henyey-Greenstein phase function, its lower half folded up onto the hemisphere."""

    reflection: ClassVar[Reflection] = Reflection.DIFFUSE

    g: Array

    def shared(self, xp: Array, cos_theta: Array) -> list[tuple[Lobe, Array]]:
        """The phase function, and for viewers away from the horizon the cosine of the light, which it leaves out.

        With it the variance of g = 0 under a uniform sky falls to a tenth.  The share was found by minimising that variance; for
        strongly directed dust it goes to 0.
        """
        share = 0.85 * xp.sqrt(cos_theta) * (1 - xp.maximum(self.g, -self.g))
        return [(self, 1 - share), (CosineLobe(), share)]

    def sample(self, xp: Array, wi: Array, u: Array) -> Array:
        g, s = self.g, 2 * u[..., 0] - 1
        # The usual inversion, multiplied out so that it holds at g = 0 as well.
        cos_gamma = (s * (1 + g * g) + 0.5 * g * (s * s * (1 + g * g) + 3 - g * g)) / ((1 + g * s) * (1 + g * s))
        cos_gamma = xp.maximum(xp.minimum(cos_gamma, 1.0), -1.0)
        sin_gamma, azimuth = xp.sqrt(1 - cos_gamma * cos_gamma), TWO_PI * u[..., 1]
        a, b = sin_gamma * xp.cos(azimuth), sin_gamma * xp.sin(azimuth)
        # A frame about -wi, for light going straight on (Duff et al. 2017, JCGT 6(1)).
        n = Vector(-wi[..., 0], -wi[..., 1], -wi[..., 2])
        one = 0 * n.z + 1  # in the type of wi
        sign = xp.where(n.z >= 0, one, -one)
        q = -1 / (sign + n.z)
        r = n.x * n.y * q
        x = a * (1 + sign * n.x * n.x * q) + b * r + cos_gamma * n.x
        y = a * sign * r + b * (sign + n.y * n.y * q) + cos_gamma * n.y
        z = -a * sign * n.x - b * n.y + cos_gamma * n.z
        return xp.stack([x, y, xp.maximum(xp.maximum(z, -z), SMALLEST_COSINE)])

    def pdf(self, xp: Array, wi: Array, wo: Array) -> Array:
        i, o = Vector.split(wi), Vector.split(wo)

        def density(z: Array) -> Array:
            add = Vector(i.x + o.x, i.y + o.y, i.z + z)
            subtract = Vector(i.x - o.x, i.y - o.y, i.z - z)
            s2, c2 = (0.25 * (v.x * v.x + v.y * v.y + v.z * v.z) for v in (add, subtract))
            return 0.25 * equations.INV_PI * equations.Phi(xp, s2, c2, self.g)

        return density(o.z) + density(-o.z)
