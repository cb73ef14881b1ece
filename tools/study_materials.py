"""Materials that no candidate of `auto` can follow, clean and dusty: what its verdicts on dust are judged by.

Their bases are of models that `auto` does not try: Burley's diffuse term, Minnaert's, Ashikhmin and Shirley's coupled one, powders of
Hapke with all their parameters, Beckmann's facets, two highlights at once.  A clean one is besides multiplied by a smooth, reciprocal
field of a few per cent, for what no formula has.  Dust is laid on by the photon Monte Carlo of the tests, which shares no formula with
the models of dust.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import final

import numpy as np
from numpy.typing import NDArray

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

import photons
from motes import OrenNayar, TorranceSparrow
from motes.arrays import Array
from motes.directions import Geometry, half_difference
from motes.equations import INV_PI
from motes.measurements import Measurement
from motes.models import BRDF, GGX, Beckmann, CoatedDiffuse, Conductor, Dielectric, Hapke, Schlick, register
from motes.models.components import Component
from motes.models.lobes import CosineLobe
from motes.parameters import Role, parameter

Floats = NDArray[np.float64]
NOISE = 0.02  # relative, of each sample
PHOTONS = 4096  # for each pair of directions: about 1 % of grain
DEPTHS, ALBEDOS, MEAN_COSINES = (0.1, 1.0), (0.5, 0.97), (0.0, 0.8)


@dataclass(frozen=True, eq=False)
class _Body(BRDF):
    """A diffuse reflectance with one number of shape."""

    rho: Array = parameter(0.5, bounds=(0, 1), symbol="\\rho", doc="colour", per_channel=True, role=Role.DIFFUSE_COLOUR)
    shape: Array = parameter(0.5, bounds=(0, 2), symbol="s", doc="shape")

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return [Component(self.formula, CosineLobe(), self.rho)]


def _fifth(x: Array) -> Array:
    return x * x * x * x * x


@register("study_burley")
@final
@dataclass(frozen=True, eq=False)
class Burley(_Body):
    """B. Burley, Physically based shading at Disney, SIGGRAPH 2012 course: retro-reflective towards grazing; `shape` is its roughness."""

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        d, i, r = geometry.cos_theta_d, geometry.cos_theta_i, geometry.cos_theta_r
        rise = 0.5 + 2 * d * d * self.shape - 1
        return INV_PI * self.rho * (1 + rise * _fifth(1 - i)) * (1 + rise * _fifth(1 - r))


@register("study_minnaert")
@final
@dataclass(frozen=True, eq=False)
class Minnaert(_Body):
    """M. Minnaert, The reciprocity principle in lunar photometry, 1941: (cos cos)^(k - 1) with k = 1 + `shape`, dark limbs."""

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return INV_PI * self.rho * xp.exp(self.shape * xp.log1p(geometry.cos_theta_i * geometry.cos_theta_r - 1))


@register("study_ashikhmin")
@final
@dataclass(frozen=True, eq=False)
class Ashikhmin(_Body):
    """The diffuse term of Ashikhmin and Shirley, An anisotropic Phong BRDF model, 2000; `shape` is its reflectance at normal incidence."""

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        i, r = 1 - _fifth(1 - 0.5 * geometry.cos_theta_i), 1 - _fifth(1 - 0.5 * geometry.cos_theta_r)
        return 28 / 23 * INV_PI * self.rho * (1 - self.shape) * i * r


def base(rng: np.random.Generator, kind: int) -> BRDF:
    """A clean material of one of eight kinds, with random parameters and a highlight that is neither a mirror nor absent."""
    rho, strength = rng.uniform(0.1, 0.7), rng.uniform(0.02, 0.3)
    alpha, wide = rng.uniform(0.2, 0.45), rng.uniform(0.45, 0.9)
    n, f0 = rng.uniform(1.3, 1.7), rng.uniform(0.03, 0.1)
    made: list[BRDF] = [
        Burley(rho, rng.uniform(0.3, 1)) + Beckmann(strength, alpha),
        Minnaert(0.8 * rho, rng.uniform(0.02, 0.2)) + Beckmann(2 * strength / f0 * 0.1, alpha, fresnel=Schlick(f0)),
        Ashikhmin(rho, f0) + Beckmann(1.0, alpha, fresnel=Dielectric(n)) + GGX(0.3 * strength, wide),
        Hapke(rng.uniform(0.4, 0.95), rng.uniform(-0.3, 0.1), rng.uniform(0.2, 0.8), rng.uniform(0.05, 0.2))
        + TorranceSparrow(0.5 * strength, alpha),
        OrenNayar(rho, rng.uniform(0.1, 0.6)) + Beckmann(strength, alpha) + Beckmann(strength, wide),
        CoatedDiffuse(rho, n) + Beckmann(1.0, alpha, fresnel=Dielectric(n)) + Beckmann(0.3 * strength, wide),
        Burley(0.3 * rho, 0.5) + Beckmann(rng.uniform(0.3, 0.8), wide, fresnel=Conductor(rng.uniform(0.3, 2), 3.0)),
        Ashikhmin(rho, f0) + TorranceSparrow(strength, alpha) + TorranceSparrow(strength, wide),
    ]  # fmt: skip
    return made[kind % len(made)]


#: The kinds of bases, in the order of `base`.
KINDS = (
    "Burley's body",
    "Minnaert's body",
    "Ashikhmin and Shirley's body with a wide highlight",
    "Hapke's powder",
    "a rough body with two highlights",
    "a coated body",
    "rough metal",
    "Ashikhmin and Shirley's body with two highlights",
)


def field(rng: np.random.Generator, wi: Floats, wo: Floats, size: float) -> Floats:
    """A smooth, reciprocal, isotropic field (N,) about 1: a random sum of six waves in Rusinkiewicz's angles, of relative deviation `size`."""
    theta_h, theta_d, phi_d = half_difference(wi, wo)
    at = np.stack([theta_h, theta_d, np.sin(theta_h) * np.sin(theta_d) * np.cos(2 * phi_d)], -1)
    waves = np.cos(at @ (rng.normal(size=(3, 6)) * 3.0) + rng.uniform(0, 2 * np.pi, 6)) @ rng.normal(size=6)
    return np.exp(size * waves / max(float(np.std(waves)), 1e-6))


def clean(seed: int, wi: Floats, wo: Floats) -> Measurement:
    """A clean material with misfit at the pairs (N, 3), of one channel."""
    rng = np.random.default_rng([1, seed])
    f = base(rng, seed).eval(wi, wo)[:, 0] * field(rng, wi, wo, rng.uniform(0.02, 0.1))
    f *= 1 + NOISE * rng.normal(size=len(f))
    return Measurement.from_arrays(wi, wo, f[:, None])


def layer(seed: int) -> tuple[float, float, float]:
    """tau (evenly in its logarithm), w and g of the dust on a material."""
    rng = np.random.default_rng([3, seed])
    return float(np.exp(rng.uniform(*np.log(DEPTHS)))), float(rng.uniform(*ALBEDOS)), float(rng.uniform(*MEAN_COSINES))


def dusty(seed: int, wi: Floats, wo: Floats) -> Measurement:
    """A material under the `layer` of its seed, at the pairs (N, 3), of one channel, by photons."""
    rng = np.random.default_rng([2, seed])
    f = photons.pairs(photons.Layer(base(rng, seed), *layer(seed)), wi, wo, PHOTONS, seed=seed + 1)
    return Measurement.from_arrays(wi, wo, (f * (1 + NOISE * rng.normal(size=len(f))))[:, None])
