r"""Sheen: fibres whose normals lie about the surface: velvet, felt, peach fuzz, the down of leaves; Standard Surface and glTF have it, too.

.. math::  f = K_f \frac{D}{4 (\cos\theta_i + \cos\theta_r - \cos\theta_i \cos\theta_r)}, \quad D = \frac{(2 + 1/a) \sin^{1/a}\theta_h}{2 \pi}

Source: A. Conty Estevez, C. Kulla, "Production friendly microfacet sheen BRDF", SIGGRAPH 2017 courses, equation (2); the denominator: D. Neubelt,
M. Pettineo, "Crafting a next-gen material pipeline for The Order: 1886", 2013; its albedo by the rational fit of MaterialX 1.39."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar, Self, final

from motes.arrays import Array
from motes.directions import Geometry
from motes.models.base import BRDF
from motes.models.components import Component
from motes.models.lobes import TWO_PI, Lobe, Reflection
from motes.models.naming import register
from motes.models.standard import MEAN_COSINE, StandardLobe
from motes.parameters import Role, parameter

#: Of the formula as other programs have it.
SMALLEST_ROUGHNESS = 0.02
#: Of the model: below, more light leaves than arrives where light grazes (102 % at 0.2, twice as much at 0.04).
LEAST_ROUGHNESS = 0.22


def sheen(xp: Array, geometry: Geometry, roughness: Array) -> Array:
    """f [1/sr] of white fibres; `roughness` is the a above."""
    inverse = 1 / xp.maximum(roughness, SMALLEST_ROUGHNESS)
    sine = geometry.sin_theta_h
    # sin^(1/a), as the sine times a power that is finite at 0; the logarithm of 1/sin keeps all digits at both ends.
    power = sine * xp.exp((1 - inverse) * xp.log1p((1 - sine) / xp.maximum(sine, 1e-30)))
    i, r = geometry.cos_theta_i, geometry.cos_theta_r
    return (2 + inverse) * power / (8 * math.pi * (i + r - i * r))


def sheen_albedo(xp: Array, cosine: Array, roughness: Array) -> Array:
    """The share of light from a direction that white fibres reflect."""
    x, y = cosine, xp.maximum(roughness, SMALLEST_ROUGHNESS)
    above = 13.673 - 68.78018 * x + 799.08825 * y - 905.00061 * (x * y) + 60.28956 * (x * x) + 1086.96473 * (y * y)
    below = 1 + 61.57746 * x + 442.78211 * y + 2597.49308 * (x * y) + 121.81241 * (x * x) + 3045.55075 * (y * y)
    return xp.minimum(xp.maximum(above / below, 0.0), 1.0)


@dataclass(frozen=True)
class HemisphereLobe(Lobe):
    """All directions alike: sheen is brightest where the cosine is least."""

    reflection: ClassVar[Reflection] = Reflection.DIFFUSE

    def sample(self, xp: Array, wi: Array, u: Array) -> Array:
        # 1 - u > 0 for u < 1, so the sample is never below the horizon.
        z, azimuth = 1 - u[..., 0], TWO_PI * u[..., 1]
        sine = xp.sqrt(u[..., 0] * (1 + z))
        return xp.stack([sine * xp.cos(azimuth), sine * xp.sin(azimuth), z])

    def pdf(self, xp: Array, wi: Array, wo: Array) -> Array:
        return 1 / TWO_PI + 0 * wo[..., 2]


@register("sheen")
@final
@dataclass(frozen=True, eq=False)
class Sheen(BRDF):
    """What velvet, felt and downy surfaces add towards grazing, where they are brightest: a term beside others, ``EON(...) + Sheen(...)``.

    Notes
    -----
    It is reciprocal, and for K_f = 1 returns no more light than arrives: 94 % from the horizon at a = 0.25, 64 % at a = 1; from above 3 %
    and 14 %.  It takes nothing from what lies below it; programs that layer sheen darken that by the albedo of the sheen."""

    words: ClassVar[str] = "sheen"
    approximation: ClassVar[str] = (
        "Sheen: a diffuse lobe that reflects as much of light from 53 degrees; the rise towards grazing is left out."
    )

    K_f: Array = parameter(
        0.2,
        bounds=(0, float("inf")),
        typical=(0, 1),
        symbol="K_f",
        doc="strength of the fibres; with 1 they return at most as much light as arrives",
        per_channel=True,
        role=Role.FURTHER_STRENGTH,
        simpler=0.0,
    )
    a: Array = parameter(
        0.5,
        bounds=(LEAST_ROUGHNESS, 1),
        starts=(0.3, 0.7),
        symbol="a",
        doc="roughness of the fibres: small where they stand upright and shine at grazing angles alone",
        advice="Other programs allow less, with more light than arrives",
        role=Role.FURTHER_WIDTH,
    )

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return self.K_f * sheen(xp, geometry, self.a)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return [Component(self.formula, HemisphereLobe(), self.K_f * sheen_albedo(xp, cos_theta_i, self.a))]

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        return [StandardLobe(Reflection.DIFFUSE, values.K_f * sheen_albedo(xp, MEAN_COSINE, values.a))]
