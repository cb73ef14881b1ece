"""Smooth noise in space, so that dust is not as even as a coat of paint."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# The middles of a cube's edges: directions without a bias towards the axes (Perlin 2002).
_GRADIENTS = np.array(
    [[a, b, 0] for a in (-1, 1) for b in (-1, 1)]
    + [[a, 0, b] for a in (-1, 1) for b in (-1, 1)]
    + [[0, a, b] for a in (-1, 1) for b in (-1, 1)],
    np.float64,
)


def gradient_noise(points: Floats, seed: int = 0) -> Floats:
    """Noise (N,) at points (N, 3) in units of its cells: mean 0, within [-1, 1], twice continuously differentiable.

    Source: K. Perlin, "Improving noise", SIGGRAPH 2002, with a permutation of 256 drawn from `seed`.
    """
    permutation = np.random.default_rng(seed).permutation(256)
    cell = np.floor(points)
    within = points - cell
    cell = cell.astype(np.int64) & 255
    fade = within**3 * (within * (within * 6 - 15) + 10)
    total = np.zeros(len(points))
    for corner in np.ndindex(2, 2, 2):
        step = np.array(corner)
        x, y, z = ((cell + step) & 255).T
        gradient = _GRADIENTS[permutation[(permutation[(permutation[x] + y) & 255] + z) & 255] % 12]
        weight = np.where(step == 1, fade, 1 - fade).prod(axis=1)
        total += weight * (gradient * (within - step)).sum(axis=1)
    return total


def cloudy(points: Floats, seed: int = 0, octaves: int = 3) -> Floats:
    """Three octaves of `gradient_noise`, each twice as fine and half as strong; within [-1, 1]."""
    weights = 0.5 ** np.arange(octaves)
    parts = (w * gradient_noise(points * 2**k, seed + k) for k, w in enumerate(weights))
    return np.asarray(sum(parts) / weights.sum())
