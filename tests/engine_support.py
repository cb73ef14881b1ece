"""What the engine's tests share: directions where formulas are at risk."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Directions = NDArray[np.float64]


def spherical(theta: Directions, phi: Directions) -> Directions:
    return np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1)


def risky_pairs(n: int, seed: int) -> dict[str, tuple[Directions, Directions]]:
    """Pairs (n, 3) of every kind that rounding could spoil, by name."""
    rng = np.random.default_rng(seed)

    def phi() -> Directions:
        return rng.uniform(-np.pi, np.pi, n)

    def small(low: float, high: float) -> Directions:
        return 10 ** rng.uniform(low, high, n) * rng.choice([-1, 1], n)

    def anywhere() -> Directions:
        return spherical(np.arccos(rng.uniform(0, 1, n)), phi())

    def grazing() -> Directions:
        return np.pi / 2 - 10 ** rng.uniform(-4, -1.5, n)

    theta, azimuth, edge = rng.uniform(0, 1.55, n), phi(), grazing()
    wi, flat = spherical(theta, azimuth), spherical(edge, azimuth)

    def near(t: Directions, p: Directions) -> Directions:
        """Directions a little off theta = t, phi = p."""
        return spherical(np.clip(t + small(-7, -2), 0, 1.5707), p + small(-7, -2))

    return {
        "anywhere": (anywhere(), anywhere()),
        "near the mirror direction": (wi, near(theta, azimuth + np.pi)),
        "near retro-reflection": (wi, near(theta, azimuth)),
        "wi = wo": (wi, wi),
        "near perpendicular planes": (wi, spherical(rng.uniform(0, 1.55, n), azimuth + np.pi / 2 + small(-8, -3))),
        "normal incidence": (np.broadcast_to([0.0, 0.0, 1.0], (n, 3)), anywhere()),
        "near the normal": (spherical(np.abs(small(-8, -2)), phi()), spherical(np.abs(small(-8, -2)), phi())),
        "one grazing": (flat, anywhere()),
        "both grazing": (flat, spherical(grazing(), phi())),
        "both grazing, opposite": (flat, near(edge, azimuth + np.pi)),
        "both grazing, in one plane": (flat, spherical(grazing(), azimuth + np.pi)),
        "both grazing, together": (flat, near(edge, azimuth)),
        "at and below the horizon": (spherical(rng.uniform(1.5, np.pi, n), phi()), anywhere()),
    }
