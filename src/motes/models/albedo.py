"""The directional albedo of a BRDF, by quadrature in the coordinates of its own lobes."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from motes.arrays import NUMPY, Array
from motes.directions import Geometry, Vector
from motes.models.components import Reflecting
from motes.models.lifting import averaged, broadcast, leading, lifted, matching, sliced

Floats = NDArray[np.float64]
#: Values (directions of light x nodes x channels) that are integrated at a time.
AT_ONCE = 1 << 21


def directional_albedo(model: Reflecting, channels: int, xp: Array, wi: Array, nodes: tuple[int, int]) -> Array:
    """See `motes.models.BRDF.directional_albedo`; `wi` (..., 3) is an array of the library whose namespace is `xp`."""
    shape = np.broadcast_shapes(tuple(wi.shape[:-1]), *leading(model))
    step = max(1, AT_ONCE // (nodes[0] * nodes[1] * channels))
    if xp is NUMPY and np.prod(shape) > step:  # bounded memory
        flat = np.broadcast_to(wi, (*shape, 3)).reshape(-1, 3)
        parts = [
            directional_albedo(sliced(model, shape, k, k + step), channels, xp, flat[k : k + step], nodes)
            for k in range(0, len(flat), step)
        ]
        return np.concatenate(parts).reshape(*shape, -1)
    wi = broadcast(wi[..., None, :], (*wi.shape[:-1], nodes[0] * nodes[1], 3))
    with np.errstate(all="ignore"):
        # The same parts twice: with channels for their formulas, without for their lobes.
        formulas = [part.formula for part in lifted(model, xp, wi, extra_axes=1).components(xp, 1.0)]
        lobes = [part.lobe for part in averaged(model, wi, extra_axes=1).components(xp, 1.0)]
        total: Array = 0.0
        for formula, lobe in zip(formulas, lobes, strict=True):
            u, weights = (matching(x, wi) for x in _grid(nodes, lobe.turns))
            wo = lobe.sample(xp, wi, broadcast(u, (*wi.shape[:-1], 2)))
            geometry = Geometry(xp, Vector.of(wi), Vector.of(wo))
            value = geometry.above_horizon(formula(xp, geometry))
            pdf = lobe.pdf(xp, wi, wo)[..., None]
            cosine = xp.maximum(wo[..., 2:3], 0.0)
            ratio = xp.where(pdf > 0, value * cosine / xp.maximum(pdf, 1e-30), 0.0)
            total = total + (ratio * weights[:, None]).sum(-2)
    return total


@lru_cache(maxsize=16)
def _grid(nodes: tuple[int, int], turns: bool) -> tuple[Floats, Floats]:
    """Points (n, 2) in the unit square and their weights (n,): Gauss-Legendre, but equal steps along an axis that is an angle."""
    first, weights = _gauss(nodes[0])
    second, others = _gauss(nodes[1])
    if turns:
        second, others = (np.arange(nodes[1]) + 0.5) / nodes[1], np.full(nodes[1], 1 / nodes[1])
    grid = np.stack(np.meshgrid(first, second, indexing="ij"), -1).reshape(-1, 2)
    return grid, np.outer(weights, others).ravel()


def _gauss(count: int) -> tuple[Floats, Floats]:
    """Nodes and weights on [0, 1]."""
    x, weights = np.polynomial.legendre.leggauss(count)
    return 0.5 * (x + 1), 0.5 * weights
