"""Bilinear interpolants on the unit square that depend on the incident direction, and the marginal-conditional warp
that they define.

Dupuy and Jakob 2018, section 3 and supplement: the density is bilinear between the nodes of a grid; the warp maps
uniform s onto it by inverting the marginal distribution of rows (y), then the conditional one within the row (x).
Between nodes of the incident direction, densities and distribution functions are interpolated linearly.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
# Incident nodes and their weights: (index of phi_i, index of theta_i, weight), each (N,); the weights add up to 1.
Nodes = Sequence[tuple[NDArray[np.intp], NDArray[np.intp], Array]]


def bracket(nodes: Array, x: Array) -> tuple[NDArray[np.intp], NDArray[np.intp], Array]:
    """The two nodes around x, clamped to the ends, and the weight of the second."""
    if len(nodes) == 1:
        zero = np.zeros(x.shape, np.intp)
        return zero, zero, np.zeros(x.shape)
    i = np.clip(np.searchsorted(nodes, x, side="right") - 1, 0, len(nodes) - 2)
    return i, i + 1, np.clip((x - nodes[i]) / (nodes[i + 1] - nodes[i]), 0, 1)


def _cell(x: Array, n: int) -> tuple[NDArray[np.intp], Array]:
    """The cell of n nodes over [0, 1] that x lies in, and where in it, 0..1."""
    x = np.clip(x, 0, 1) * (n - 1)
    i = np.minimum(x.astype(np.intp), n - 2)
    return i, x - i


class Grid:
    """Values (n_phi_i, n_theta_i, ny, nx, C) on the nodes of the unit square."""

    def __init__(self, values: Array) -> None:
        self.values = values

    def eval(self, u: Array, nodes: Nodes | None = None) -> Array:
        """Bilinear in u = (x, y) (N, 2), linear between the incident nodes: (N, C)."""
        ny, nx = self.values.shape[2:4]
        (x, fx), (y, fy) = _cell(u[:, 0], nx), _cell(u[:, 1], ny)
        fx, fy = fx[:, None], fy[:, None]
        if nodes is None:
            zero = np.zeros(len(u), np.intp)
            nodes = [(zero, zero, np.ones(len(u)))]
        v, result = self.values, np.zeros((len(u), self.values.shape[4]))
        for p, t, weight in nodes:
            low = (1 - fx) * v[p, t, y, x] + fx * v[p, t, y, x + 1]
            high = (1 - fx) * v[p, t, y + 1, x] + fx * v[p, t, y + 1, x + 1]
            result += weight[:, None] * ((1 - fy) * low + fy * high)
        return result


class Warp:
    """The warp of densities (n_phi_i, n_theta_i, ny, nx), each normalised to integrate to 1 over the unit square."""

    def __init__(self, density: Array) -> None:
        ny, nx = density.shape[2:]
        # running integrals: along x within each row of nodes, and of whole rows along y
        along_x = np.zeros_like(density)
        np.cumsum((density[..., 1:] + density[..., :-1]) / (2 * (nx - 1)), axis=-1, out=along_x[..., 1:])
        rows = along_x[..., -1]
        along_y = np.zeros_like(rows)
        np.cumsum((rows[..., 1:] + rows[..., :-1]) / (2 * (ny - 1)), axis=-1, out=along_y[..., 1:])
        total = along_y[..., -1]
        self.density = density / total[..., None, None]
        self.along_x = along_x / total[..., None, None]
        self.along_y = along_y / total[..., None]

    def invert(self, u: Array, nodes: Nodes) -> Array:
        """The s (N, 2) that the warp maps onto u (N, 2)."""
        ny, nx = self.density.shape[2:]
        (x, fx), (y, fy) = _cell(u[:, 0], nx), _cell(u[:, 1], ny)
        left, right, before, row0, row1, below = (np.zeros(len(u)) for _ in range(6))
        for p, t, weight in nodes:
            d, c = self.density, self.along_x
            left += weight * ((1 - fy) * d[p, t, y, x] + fy * d[p, t, y + 1, x])
            right += weight * ((1 - fy) * d[p, t, y, x + 1] + fy * d[p, t, y + 1, x + 1])
            before += weight * ((1 - fy) * c[p, t, y, x] + fy * c[p, t, y + 1, x])
            row0 += weight * c[p, t, y, nx - 1]
            row1 += weight * c[p, t, y + 1, nx - 1]
            below += weight * self.along_y[p, t, y]
        # integrals of the linear functions within the cell, over the cell's width
        part_x = before + fx * (left + fx / 2 * (right - left)) / (nx - 1)
        whole_x = (1 - fy) * row0 + fy * row1
        part_y = below + fy * (row0 + fy / 2 * (row1 - row0)) / (ny - 1)
        with np.errstate(divide="ignore", invalid="ignore"):
            s_x = np.where(whole_x > 0, part_x / whole_x, 0.0)
        return np.stack([s_x, part_y], axis=-1)

    def sample(self, s: Array, p: int, t: int) -> tuple[Array, Array]:
        """Map s (N, 2) by the warp of one incident node: u (N, 2) and the density there (N,)."""
        density, along_x, along_y = self.density[p, t], self.along_x[p, t], self.along_y[p, t]
        ny, nx = density.shape
        rows = along_x[:, -1]
        y = np.clip(np.searchsorted(along_y, s[:, 1], side="right") - 1, 0, ny - 2)
        fy = _solve(rows[y], rows[y + 1], (s[:, 1] - along_y[y]) * (ny - 1))
        distribution = (1 - fy)[:, None] * along_x[y] + fy[:, None] * along_x[y + 1]
        target = s[:, 0] * distribution[:, -1]
        x = np.clip(np.sum(distribution <= target[:, None], axis=1) - 1, 0, nx - 2)
        left = (1 - fy) * density[y, x] + fy * density[y + 1, x]
        right = (1 - fy) * density[y, x + 1] + fy * density[y + 1, x + 1]
        fx = _solve(left, right, (target - distribution[np.arange(len(s)), x]) * (nx - 1))
        u = np.stack([(x + fx) / (nx - 1), (y + fy) / (ny - 1)], axis=-1)
        return u, (1 - fx) * left + fx * right


def _solve(a: Array, b: Array, area: Array) -> Array:
    """The f in [0, 1] with f a + f^2 (b - a)/2 = `area`, the integral of the linear function from a to b.

    In the form of the root that never cancels.
    """
    root = np.sqrt(np.maximum(a * a + 2 * (b - a) * area, 0))
    with np.errstate(divide="ignore", invalid="ignore"):
        f = 2 * area / (a + root)
    return np.clip(np.where(np.isfinite(f), f, 0.0), 0, 1)
