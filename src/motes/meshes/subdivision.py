"""Finer triangles: where dust is kept at the vertices, its pattern cannot be finer than they are."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import MotesError
from motes.meshes.mesh import Mesh

MOST_TRIANGLES = 20_000_000


class _Edges:
    """The edges of a mesh: their ends (E, 2), and for each side of each triangle which edge it is (F, 3)."""

    def __init__(self, triangles: NDArray[np.int32]) -> None:
        sides = np.stack([triangles, np.roll(triangles, -1, axis=1)], -1).reshape(-1, 2)
        self.ends, inverse, self.uses = np.unique(
            np.sort(sides, axis=1), axis=0, return_inverse=True, return_counts=True
        )
        self.of_side = inverse.reshape(-1, 3)


def _quartered(triangles: NDArray[np.int32], edges: _Edges, n: int) -> NDArray[np.int32]:
    a, b, c = triangles.T
    ab, bc, ca = (edges.of_side + n).T
    parts = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return np.stack([np.stack(p, -1) for p in parts], axis=1).reshape(-1, 3).astype(np.int32)


def _checked(mesh: Mesh, levels: int) -> None:
    total = len(mesh.triangles) * 4**levels
    if total > MOST_TRIANGLES:
        raise MotesError(
            f"{mesh.name} has {len(mesh.triangles)} triangles; refined {levels} times it would have {total}",
            f"At most {MOST_TRIANGLES} are made; refine it fewer times",
        )


def refine(mesh: Mesh, levels: int = 1) -> Mesh:
    """Cut each triangle into four at the middles of its edges, `levels` times; the shape stays as it is.

    Raises
    ------
    MotesError
        When there would be more than `MOST_TRIANGLES`.
    """
    _checked(mesh, levels)
    for _ in range(levels):
        edges = _Edges(mesh.triangles)
        n = len(mesh.positions)

        def extended(values: NDArray[Any], edges: _Edges = edges) -> NDArray[np.float64]:
            return np.concatenate([values, values[edges.ends].mean(axis=1)])

        normals = None if mesh.normals is None else extended(mesh.normals)
        if normals is not None:
            length = np.linalg.norm(normals, axis=1, keepdims=True)
            normals = normals / np.where(length > 0, length, 1)
        mesh = replace(
            mesh,
            positions=extended(mesh.positions),
            triangles=_quartered(mesh.triangles, edges, n),
            normals=normals,
            uv=None if mesh.uv is None else extended(mesh.uv),
            attributes={name: extended(values) for name, values in mesh.attributes.items()},
        )
    return mesh


def loop(mesh: Mesh) -> Mesh:
    """One step of Loop's subdivision: four times the triangles, and smoother.  Positions only: `with_normals` comes after it.

    Source: C. Loop, "Smooth subdivision surfaces based on triangles", 1987, with Warren's weights; borders become cubic splines.
    """
    _checked(mesh, 1)
    edges = _Edges(mesh.triangles)
    n, x = len(mesh.positions), mesh.positions
    a, b = edges.ends.T
    border = edges.uses != 2
    # New vertices: 3/8 of the ends and 1/8 of the two opposite corners; the middle on a border.
    opposite = np.zeros((len(edges.ends), 3))
    np.add.at(opposite, edges.of_side.ravel(), x[np.roll(mesh.triangles, 1, axis=1).ravel()])
    middle = np.where(border[:, None], 0.5 * (x[a] + x[b]), 0.375 * (x[a] + x[b]) + 0.125 * opposite)
    # Old vertices move towards the mean of their neighbours; on a border towards those along it.
    inner = ~border
    valence, ring = _neighbours(edges.ends, x, n)
    weight = np.where(valence == 3, 3 / 16, 3 / (8 * np.maximum(valence, 1)))[:, None]
    moved = np.where(valence[:, None] > 0, (1 - valence[:, None] * weight) * x + weight * ring, x)
    on_border = np.zeros(n, bool)
    on_border[edges.ends[~inner].ravel()] = True
    count, along = _neighbours(edges.ends[~inner], x, n)
    simple = on_border & (count == 2)
    moved[on_border] = x[on_border]  # corners where several borders meet stay
    moved[simple] = 0.75 * x[simple] + 0.125 * along[simple]
    return Mesh(np.concatenate([moved, middle]), _quartered(mesh.triangles, edges, n), name=mesh.name, notes=mesh.notes)


def _neighbours(ends: NDArray[Any], x: NDArray[np.float64], n: int) -> tuple[NDArray[Any], NDArray[np.float64]]:
    """How many neighbours each vertex has along the given edges, and the sum of their positions."""
    a, b = ends.T
    total = np.zeros((n, 3))
    np.add.at(total, a, x[b])
    np.add.at(total, b, x[a])
    return np.bincount(ends.ravel(), minlength=n), total
