"""Pairs of directions all over the hemisphere, the horizon left out."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def scattered(count: int, seed: int = 4) -> tuple[Floats, Floats]:
    """wi and wo (N, 3), evenly in the cosine."""
    rng = np.random.default_rng(seed)
    z, phi = rng.uniform(0.1, 1, (2, count)), rng.uniform(0, 2 * np.pi, (2, count))
    root = np.sqrt(1 - z * z)
    return tuple(np.stack([root * np.cos(phi), root * np.sin(phi), z], axis=-1))  # type: ignore[return-value]
