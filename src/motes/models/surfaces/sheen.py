r"""Sheen: fibres whose normals lie about the surface, as Standard Surface and glTF have it.

.. math::  f = \frac{D}{4 (\cos\theta_i + \cos\theta_r - \cos\theta_i \cos\theta_r)}, \quad D = \frac{(2 + 1/a) \sin^{1/a}\theta_h}{2 \pi}

Source: A. Conty Estevez, C. Kulla, "Production friendly microfacet sheen BRDF", SIGGRAPH 2017 courses, equation (2); the denominator: D. Neubelt,
M. Pettineo, "Crafting a next-gen material pipeline for The Order: 1886", 2013; its albedo by the rational fit of MaterialX 1.39."""

from __future__ import annotations

import math

from motes.arrays import Array
from motes.directions import Geometry

SMALLEST_ROUGHNESS = 0.02


def sheen(xp: Array, geometry: Geometry, roughness: Array) -> Array:
    """f [1/sr] of white fibres; `roughness` is the a above."""
    inverse = 1 / xp.maximum(roughness, SMALLEST_ROUGHNESS)
    sine = geometry.sin_theta_h
    # sin^(1/a) through the logarithm of the square, which is kept from 0.
    power = xp.exp(0.5 * inverse * xp.log1p(xp.maximum(sine * sine, 1e-12) - 1))
    i, r = geometry.cos_theta_i, geometry.cos_theta_r
    return (2 + inverse) * power / (8 * math.pi * (i + r - i * r))


def sheen_albedo(xp: Array, cosine: Array, roughness: Array) -> Array:
    """The share of light from a direction that white fibres reflect."""
    x, y = cosine, xp.maximum(roughness, SMALLEST_ROUGHNESS)
    above = 13.673 - 68.78018 * x + 799.08825 * y - 905.00061 * (x * y) + 60.28956 * (x * x) + 1086.96473 * (y * y)
    below = 1 + 61.57746 * x + 442.78211 * y + 2597.49308 * (x * y) + 121.81241 * (x * x) + 3045.55075 * (y * y)
    return xp.minimum(xp.maximum(above / below, 0.0), 1.0)
