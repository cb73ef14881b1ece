"""Where dust comes from and what of it stays: F and H of `motes.rendering.deposition`, over NumPy alone.

Blender's add-on has a copy of this file: it imports nothing of Motes.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]

EDGE_DEG = 15.0  # w: over how much of an angle dust begins to slide, on either side


def hold(cos_theta: Floats, adhesion: float, slipperiness: float) -> Floats:
    """H of the module: the share of fallen dust that stays on a surface whose normal makes an angle with `up`, (N,)."""
    theta_deg = np.rad2deg(np.arccos(np.clip(cos_theta, -1, 1)))
    slides = smooth_step((theta_deg - 90 * (1 - slipperiness)) / EDGE_DEG)
    drops = smooth_step((theta_deg - 90) / EDGE_DEG)
    return (adhesion + (1 - adhesion) * (1 - slides)) * (1 - drops)


def falling(towards: Floats, spread_deg: float, n: int) -> Floats:
    """Directions (n, 3) with density ~ (towards . omega)^m, m = 1/spread^2, evenly laid out on a spiral."""
    exponent = 1 / np.deg2rad(spread_deg) ** 2
    k = np.arange(n) + 0.5
    cosine = (k / n) ** (1 / (exponent + 1))
    azimuth = k * np.pi * (3 - np.sqrt(5))  # the golden angle
    return _about(towards, cosine, azimuth)


def _about(axis: Floats, cosine: Floats, azimuth: Floats) -> Floats:
    """Unit vectors (n, 3) at angles about an axis."""
    other = np.eye(3)[np.argmin(np.abs(axis))]
    x = np.cross(axis, other)
    x /= np.linalg.norm(x)
    y = np.cross(axis, x)
    sine = np.sqrt(1 - cosine**2)
    around = (sine * np.cos(azimuth))[:, None] * x + (sine * np.sin(azimuth))[:, None] * y
    return np.asarray(around + cosine[:, None] * axis)


def smooth_step(x: ArrayLike) -> Floats:
    """From 0 at -1 to 1 at 1 with level ends: 3 t^2 - 2 t^3 of t = (1 + x)/2."""
    t = np.clip(0.5 * (1 + np.asarray(x, np.float64)), 0, 1)
    return t * t * (3 - 2 * t)
