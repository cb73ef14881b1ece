"""Which way the faces of a mesh look: whether neighbours agree, whether a closed surface is inside out, and how both are mended.

Dust falls on what looks up, so a mesh whose faces look inwards gets none, without anything being wrong with its shape.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple, final

import numpy as np
from numpy.typing import NDArray

from motes.meshes.mesh import Floats, Integers, Mesh

HOLES = 0.01  # of the edges of a surface that may lack a face for it still to have an inside
SAME = 1e-6  # of the extent; seams are often computed twice


@final
class Winding(NamedTuple):
    """What is found of a mesh whose vertices are welded where they share a place.

    Parameters
    ----------
    disagreeing
        Edges whose two faces look to different sides.
    edges
        Edges with two faces.
    closed
        Whether nearly every edge has two faces: scans have small holes.
    volume
        By the divergence theorem about the middle; below 0 where faces look inwards.
    """

    disagreeing: int
    edges: int
    closed: bool
    volume: float


def examined(positions: Floats, triangles: Integers) -> Winding:
    """What can be said of the faces' sides."""
    pairs = _Pairs(positions, triangles)
    centred = positions - 0.5 * (positions.min(axis=0) + positions.max(axis=0))
    return Winding(int((~pairs.agree).sum()), len(pairs.first), pairs.closed, float(_volumes(centred, triangles).sum()))


def turned_outwards(mesh: Mesh) -> Mesh:
    """The mesh with faces turned so that neighbours agree, closed pieces look outwards, and open ones to where most of their area looked before.

    Normals that then look to the other side than the faces around them are turned as well.
    """
    triangles = mesh.triangles
    pairs = _Pairs(mesh.positions, triangles)
    n = len(triangles)
    # Each face stands for two nodes, as it is and turned; what may not be together is linked crosswise.
    cross = np.where(pairs.agree, 0, n)
    a = np.concatenate([pairs.first, pairs.first + n])
    b = np.concatenate([pairs.second + cross, pairs.second + (n - cross)])
    label = _least_labels(a, b, 2 * n)
    flip = label[:n] > label[n:]
    piece = np.minimum(label[:n], label[n:])
    middle = 0.5 * (mesh.positions.min(axis=0) + mesh.positions.max(axis=0))
    signs = np.where(flip, -1.0, 1.0)
    volume = np.bincount(piece, _volumes(mesh.positions - middle, triangles) * signs, 2 * n)
    area = np.linalg.norm(_crosses(mesh.positions, triangles), axis=1)
    kept = np.bincount(piece, area * signs, 2 * n)
    edges, lonely = (np.bincount(piece[faces], minlength=2 * n) for faces in (np.arange(3 * n) // 3, pairs.lonely))
    inside_out = np.where(lonely > HOLES * edges, kept < 0, volume < 0)
    flip ^= inside_out[piece]
    turned = triangles.copy()
    turned[flip] = turned[flip][:, [0, 2, 1]]
    normals = mesh.normals
    if normals is not None:
        around = np.zeros_like(mesh.positions)
        crosses = _crosses(mesh.positions, turned)
        for k in range(3):
            for axis in range(3):
                around[:, axis] += np.bincount(turned[:, k], crosses[:, axis], len(around))
        normals = np.where((around * normals).sum(1, keepdims=True) < 0, -normals, normals)
    words = f"{int(flip.sum())} of {n} faces were turned to look outwards"
    return replace(mesh, triangles=turned, normals=normals, notes=(*mesh.notes, words) if flip.any() else mesh.notes)


class _Pairs:
    """Faces that meet in an edge, (E,) each, whether they agree on its sides, and the faces of edges that have one face or more than two."""

    def __init__(self, positions: Floats, triangles: Integers) -> None:
        place = welded(positions, SAME)[triangles]
        start, end = place.ravel(), np.roll(place, -1, axis=1).ravel()
        key = np.minimum(start, end).astype(np.int64) * (len(positions) + 1) + np.maximum(start, end)
        order = np.argsort(key, kind="stable")
        key = key[order]
        new = np.concatenate([[True], key[1:] != key[:-1]])
        count = np.diff(np.concatenate([np.flatnonzero(new), [len(key)]]))
        at = np.flatnonzero(new)[count == 2]
        half, other = order[at], order[at + 1]
        self.first, self.second = half // 3, other // 3
        self.agree = start[half] != start[other]
        self.lonely = order[np.repeat(count != 2, count)] // 3
        self.closed = len(self.lonely) <= HOLES * len(key)


def welded(positions: Floats, tolerance: float = 0.0) -> NDArray[np.int64]:
    """For each vertex (V,) the index of its place; vertices at the same place have the same.

    With a tolerance, as a share of the extent, the places are cells of a grid.  Its lines lie where hardly a vertex does: off the middle by an odd share.
    """
    if tolerance:
        low, high = positions.min(axis=0), positions.max(axis=0)
        size = tolerance * max(float(np.linalg.norm(high - low)), 1e-300)
        positions = np.floor((positions - 0.5 * (low + high)) / size + 0.3819660113)
    _, place = np.unique(positions, axis=0, return_inverse=True)
    return place.reshape(-1)


def _crosses(positions: Floats, triangles: Integers) -> Floats:
    a, b, c = (positions[triangles[:, k]] for k in range(3))
    return np.cross(b - a, c - a)


def _volumes(positions: Floats, triangles: Integers) -> Floats:
    """Signed volumes (F,) of the tetrahedra of the faces and the origin."""
    a, b, c = (positions[triangles[:, k]] for k in range(3))
    return np.asarray(np.einsum("ij,ij->i", a, np.cross(b, c)) / 6)


def _least_labels(a: NDArray[np.int64], b: NDArray[np.int64], n: int) -> NDArray[np.int64]:
    """The smallest node among those that links (a, b) connect with each of n nodes."""
    label = np.arange(n)
    while True:
        least = np.minimum(label[a], label[b])
        before = label.copy()
        np.minimum.at(label, label[a], least)  # at the root, so that whole pieces follow at once
        np.minimum.at(label, label[b], least)
        np.minimum.at(label, a, least)
        np.minimum.at(label, b, least)
        while True:
            shorter = label[label]
            if np.array_equal(shorter, label):
                break
            label = shorter
        if np.array_equal(label, before):
            return label
