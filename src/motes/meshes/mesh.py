"""Triangle meshes: what reading, dust and pictures need to know of a shape, with NumPy alone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes import directions
from motes.errors import MotesError

Floats = NDArray[np.float64]
Integers = NDArray[np.int32]
CREASE_DEG = 50.0  # edges sharper than this stay sharp where a file has no normals


@final
@dataclass(frozen=True, eq=False)
class Mesh:
    """A triangle mesh with smooth normals.

    Parameters
    ----------
    positions
        (V, 3).
    triangles
        (F, 3) indices into the vertices, counter-clockwise seen from outside.
    normals
        (V, 3) unit vectors; 0 at a vertex that no triangle uses.  None until `with_normals`.
    uv
        (V, 2) texture coordinates, or None.
    attributes
        Further numbers of the vertices, (V,) each, such as ``tau``.
    name
        For people.
    notes
        What was mended, a sentence each.
    """

    positions: Floats
    triangles: Integers
    normals: Floats | None = None
    uv: Floats | None = None
    attributes: Mapping[str, Floats] = field(default_factory=dict)
    name: str = "mesh"
    notes: tuple[str, ...] = ()

    @property
    def extent(self) -> float:
        """The diagonal of the bounding box of what the triangles use."""
        used = self.positions[np.unique(self.triangles)]
        return float(np.linalg.norm(np.ptp(used, axis=0)))

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """The lowest and the highest corner of the bounding box, (3,) each."""
        used = self.positions[np.unique(self.triangles)]
        return used.min(axis=0), used.max(axis=0)

    def with_attribute(self, name: str, values: ArrayLike) -> Mesh:
        """A copy with an attribute (V,) added or replaced."""
        array = np.asarray(values, np.float64)
        if array.shape != (len(self.positions),):
            raise MotesError(
                f"the attribute {name} has the shape {array.shape} and the mesh {len(self.positions)} vertices",
                "Give one number for each vertex",
            )
        return replace(self, attributes={**self.attributes, name: array})

    def moved(self, scale: float = 1.0, shift: ArrayLike = (0.0, 0.0, 0.0), up: ArrayLike = (0.0, 1.0, 0.0)) -> Mesh:
        """A copy turned so that the direction `up` becomes y, then scaled, then shifted."""
        turn = turn_to_y(up)
        normals = None if self.normals is None else self.normals @ turn.T
        return replace(self, positions=self.positions @ turn.T * scale + np.asarray(shift, float), normals=normals)


def turn_to_y(up: ArrayLike) -> Floats:
    """The rotation matrix (3, 3) that turns the unit vector `up` into y, the shortest way."""
    u = unit(up, "up")
    y = np.array([0.0, 1.0, 0.0])
    if np.allclose(u, -y):
        return np.diag([1.0, -1.0, -1.0])
    v = u + y
    # A half turn about u, which leaves u, and one about the middle of u and y, which takes it to y.
    middle = np.outer(v, v) * (2 / (v @ v)) - np.eye(3)
    return np.asarray(middle @ (2 * np.outer(u, u) - np.eye(3)))


def unit(vector: ArrayLike, name: str) -> Floats:
    """A vector (3,) at unit length; raises `MotesError` when it has no direction."""
    v = np.asarray(vector, np.float64)
    found = directions.unit(v) if v.shape == (3,) else None
    if found is None:
        raise MotesError(f"{name} = {np.ravel(v).tolist()} is not a direction", "Give three numbers, such as 0,1,0")
    return found


def cross_products(mesh: Mesh) -> Floats:
    """The cross product of two edges of each triangle, (F, 3): its normal times twice its area."""
    a, b, c = (mesh.positions[mesh.triangles[:, k]] for k in range(3))
    return np.cross(b - a, c - a)


def face_normals(mesh: Mesh) -> Floats:
    """Unit normals (F, 3) of the triangles."""
    cross = cross_products(mesh)
    return np.asarray(cross / np.maximum(np.linalg.norm(cross, axis=1, keepdims=True), 1e-300))


def with_normals(mesh: Mesh, crease_deg: float = CREASE_DEG) -> Mesh:
    """The mesh with normals computed: means of the faces around a vertex, weighted by their angles there.

    Vertices on edges sharper than `crease_deg` are split, so that each side keeps its own normal: the sides of a box without normals stay flat, and dust on
    its top does not run over onto them.  Vertices that no triangle uses are dropped; the order of the others stays.
    """
    split = _split_creases(mesh, crease_deg)
    corners = split.positions[split.triangles]
    flat = face_normals(split)
    normals = np.zeros_like(split.positions)
    for k in range(3):
        a, b = (corners[:, (k + j) % 3] - corners[:, k] for j in (1, 2))
        sine = np.linalg.norm(np.cross(a, b), axis=1)
        angle = np.arctan2(sine, (a * b).sum(1))
        for axis in range(3):
            normals[:, axis] += np.bincount(split.triangles[:, k], angle * flat[:, axis], len(normals))
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    # Faces that fold back onto one another leave nothing; one of them then stands for all.
    lost = length[:, 0] < 1e-9
    if lost.any():
        for k in range(3):
            at = lost[split.triangles[:, k]]
            normals[split.triangles[at, k]] = flat[at]
        length = np.linalg.norm(normals, axis=1, keepdims=True)
    return replace(split, normals=normals / np.where(length > 0, length, 1))


def _split_creases(mesh: Mesh, crease_deg: float) -> Mesh:
    """A copy in which corners of triangles share a vertex only when they are connected by edges that are not sharp."""
    triangles = mesh.triangles
    # A file may hold a vertex several times (for each texture coordinate, say); the surface is connected there all the same.
    _, place = np.unique(mesh.positions, axis=0, return_inverse=True)
    welded = place.reshape(-1)[triangles]
    n = len(triangles)
    start, end = welded.ravel(), np.roll(welded, -1, axis=1).ravel()
    order = np.lexsort((np.maximum(start, end), np.minimum(start, end)))
    low, high = np.minimum(start, end)[order], np.maximum(start, end)[order]
    same = np.flatnonzero((low[1:] == low[:-1]) & (high[1:] == high[:-1]))
    first, second = order[same], order[same + 1]  # half edges 3 f + k, from corner k to corner k + 1
    flat = face_normals(mesh)
    smooth = (flat[first // 3] * flat[second // 3]).sum(1) >= np.cos(np.deg2rad(crease_deg))
    first, second = first[smooth], second[smooth]

    def following(half: NDArray[np.int64]) -> NDArray[np.int64]:
        return half - half % 3 + (half + 1) % 3

    # Two faces that meet in a smooth edge share their corners at both of its ends.
    along = start[first] == start[second]
    links = [
        (first, np.where(along, second, following(second))),
        (following(first), np.where(along, following(second), second)),
    ]
    a, b = (np.concatenate(side) for side in zip(*links, strict=True))
    label = np.arange(3 * n)
    while True:  # connected corners take the smallest label among them; a fan of faces needs few passes
        least = np.minimum(label[a], label[b])
        before = label.copy()
        np.minimum.at(label, a, least)
        np.minimum.at(label, b, least)
        label = label[label]
        if np.array_equal(label, before):
            break
    keys = np.stack([triangles.ravel(), label], axis=1)
    unique, corner = np.unique(keys, axis=0, return_inverse=True)
    return taken(mesh, unique[:, 0], corner.reshape(-1, 3).astype(np.int32))


def taken(mesh: Mesh, vertices: NDArray[Any], triangles: Integers) -> Mesh:
    """A mesh of copies of the given vertices (indices, with repetition) and new triangles."""
    return replace(
        mesh,
        positions=mesh.positions[vertices],
        triangles=triangles,
        normals=None if mesh.normals is None else mesh.normals[vertices],
        uv=None if mesh.uv is None else mesh.uv[vertices],
        attributes={name: values[vertices] for name, values in mesh.attributes.items()},
    )
