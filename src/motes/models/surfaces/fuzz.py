r"""Fuzz: what fibres or grains on a surface scatter towards grazing directions, as a cosine lobe that is transformed linearly.

.. math::  f = \frac{R}{\pi} \left(\frac{a}{\ell}\right)^2, \quad \ell = (a x + b z)^2 + a^2 y^2 + z^2

for the direction to the light (x, y, z), x along the view.  a and b are inverse coefficients of the transform, R the share that is reflected, all of
the cosine towards the viewer and of the roughness.

Source: T. Zeltner, B. Burley, M. J.-Y. Chiang, "Practical multiple-scattering sheen using linearly transformed cosines", SIGGRAPH 2022 talks; the
rational fits to their tables are those with which MaterialX 1.39 draws OpenPBR's fuzz."""

from __future__ import annotations

import math

from motes import equations
from motes.arrays import Array
from motes.directions import Geometry

SMALLEST_ROUGHNESS = 0.01


def fuzz_albedo(xp: Array, cos_view: Array, roughness: Array) -> Array:
    """R: the share of light that the fuzz reflects towards the viewer, for white fibres."""
    x, y = cos_view, xp.maximum(roughness, SMALLEST_ROUGHNESS)
    spread = y * (0.0206607 + 1.58491 * y) / (0.0379424 + y * (1.32227 + y))
    middle = y * (-0.193854 + y * (-1.14885 + y * (1.7932 - 0.95943 * (y * y)))) / (0.046391 + y)
    floor = y * (0.000654023 + (-0.0207818 + 0.119681 * y) * y) / (1.26264 + y * (-1.92021 + y))
    t = (x - middle) / spread
    return xp.exp(-0.5 * (t * t)) / (spread * math.sqrt(2 * math.pi)) + floor


def fuzz(xp: Array, geometry: Geometry, roughness: Array) -> Array:
    """f [1/sr] for white fibres."""
    x, y = geometry.cos_theta_r, xp.maximum(roughness, SMALLEST_ROUGHNESS)
    a = (2.58126 * x + 0.813703 * y) * y / (1 + 0.310327 * (x * x) + 2.60994 * (x * y))
    below = 0.0000254053 + 1.71228 * x - 1.71506 * (x * y) + 1.34174 * (y * y)
    # sqrt(1 - x) from the sine, whose square is (1 - x)(1 + x).
    b = geometry.sin_theta_r / xp.sqrt(1 + x) * ((y - 1) * (y * y * y)) / below
    z, sine = geometry.cos_theta_i, geometry.sin_theta_i
    length = a * a * (sine * sine) + (2 * a * b) * (z * sine * geometry.cos_dphi) + (b * b + 1) * (z * z)
    return equations.INV_PI * fuzz_albedo(xp, x, roughness) * ((a * a) / (length * length))
