"""Shapes to look at materials on, y up, standing on y = 0, about 2 units across: a sphere, a plane, the Utah teapot, the Stanford bunny.

Sources
-------
teapot
    The 32 Bezier patches that Martin Newell made at the University of Utah in 1975, in Blinn's height; public domain.  Control points as in three.js
    (MIT licence), whose lid, wider by 7.7 %, closes the gap to the body.
bunny
    Stanford Computer Graphics Laboratory, Stanford 3D Scanning Repository, scanned by Greg Turk and Marc Levoy in 1994; the decimated version of the npm
    package ``bunny`` 1.0.1 (Mikola Lysenko, marked public domain), smoothed here by Loop's subdivision.

``tools/make_shapes.py`` wrote the files of numbers in ``data``.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from importlib.resources import as_file, files
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.meshes.mesh import Mesh, with_normals
from motes.meshes.subdivision import loop

LID = slice(20, 28)  # patches of the teapot
LID_SCALE = 1.077  # widens the lid until it meets the rim; found by Eric Haines for three.js


def _stored(name: str) -> dict[str, NDArray[Any]]:
    with as_file(files("motes.meshes") / "data" / f"{name}.npz") as path, np.load(path, allow_pickle=False) as data:
        return dict(data)


def sphere(rings: int = 96) -> Mesh:
    """A sphere of radius 1 with `rings` steps from pole to pole and twice as many around; u along the equator, v up."""
    u, v = np.meshgrid(np.linspace(0, 1, 2 * rings + 1), np.linspace(0, 1, rings + 1), indexing="ij")
    phi, theta = 2 * np.pi * u.ravel(), np.pi * (1 - v.ravel())
    # Exactly 0 at the poles, where the sine of pi is not.
    sine = np.where((v.ravel() == 0) | (v.ravel() == 1), 0.0, np.sin(theta))
    normals = np.stack([sine * np.sin(phi), np.cos(theta), sine * np.cos(phi)], -1)
    triangles = _grid(2 * rings, rings)
    # At the poles one triangle of each pair has no area.
    row = np.tile(np.repeat(np.arange(rings), 2), 2 * rings)
    second = np.tile([False, True], 2 * rings * rings)
    keep = ~((row == 0) & ~second) & ~((row == rings - 1) & second)
    uv = np.stack([u.ravel(), v.ravel()], -1)
    return Mesh(normals + np.array([0.0, 1.0, 0.0]), triangles[keep], normals, uv, name="sphere")


def plane(steps: int = 64, size: float = 4.0) -> Mesh:
    """A level square around the origin, facing up."""
    u, v = np.meshgrid(np.linspace(0, 1, steps + 1), np.linspace(0, 1, steps + 1), indexing="ij")
    positions = np.stack([(u.ravel() - 0.5) * size, 0 * u.ravel(), (0.5 - v.ravel()) * size], -1)
    normals = np.tile([0.0, 1.0, 0.0], (len(positions), 1))
    return Mesh(positions, _grid(steps, steps), normals, np.stack([u.ravel(), v.ravel()], -1), name="plane")


def _grid(columns: int, rows: int) -> NDArray[np.int32]:
    """Two triangles for each cell of a grid whose vertices are numbered along v first; counter-clockwise in (u, v)."""
    i, j = (a.ravel() for a in np.meshgrid(np.arange(columns), np.arange(rows), indexing="ij"))
    a, b = i * (rows + 1) + j, (i + 1) * (rows + 1) + j
    cells = np.stack([np.stack([a, b, b + 1], -1), np.stack([a, b + 1, a + 1], -1)], axis=1)
    return cells.reshape(-1, 3).astype(np.int32)


@cache
def bunny(levels: int = 2) -> Mesh:
    """The Stanford bunny, decimated, then smoothed `levels` times (14,696 triangles for 1, 58,784 for 2)."""
    data = _stored("bunny")
    mesh = Mesh(data["positions"].astype(float), data["triangles"].astype(np.int32), name="bunny")
    for _ in range(levels):
        mesh = loop(mesh)
    mesh = with_normals(mesh, crease_deg=180)
    return _standing(mesh, width=2.0)


@cache
def teapot(steps: int = 16) -> Mesh:
    """The Utah teapot, `steps` along each side of a patch; each patch has a square of its own in the texture."""
    data = _stored("teapot")
    control = data["points"].astype(float)[data["patches"].astype(int)].reshape(32, 4, 4, 3)
    control[LID, :, :, :2] *= LID_SCALE
    t = np.linspace(0, 1, steps + 1)
    basis = np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3], -1)
    slope = np.stack([-3 * (1 - t) ** 2, 3 * (1 - t) * (1 - 3 * t), 3 * t * (2 - 3 * t), 3 * t * t], -1)
    points = np.einsum("ur,vc,prcx->puvx", basis, basis, control)
    across = np.cross(
        np.einsum("ur,vc,prcx->puvx", basis, slope, control), np.einsum("ur,vc,prcx->puvx", slope, basis, control)
    )
    # A patch that shrinks to a point has no tangents there; its neighbours along the meridian have.
    length = np.linalg.norm(across, axis=-1, keepdims=True)
    normals = across / np.maximum(length, 1e-12)
    poles = (length[..., 0] < 1e-9) & (np.abs(points[..., :2]).max(-1) < 1e-9)
    # The bottom points down, the tip of the knob up.
    normals[poles] = np.where(points[poles][:, 2:] > 1, [0.0, 0.0, 1.0], [0.0, 0.0, -1.0])
    n = steps + 1
    triangles = (_grid(steps, steps)[None] + (np.arange(32) * n * n)[:, None, None]).reshape(-1, 3)[:, ::-1]
    cell, gap = 1 / 6, 1 / 128  # a 6 x 6 atlas; the gap keeps texels of neighbours apart
    u, v = np.meshgrid(t, t, indexing="ij")
    within = np.stack([u, v], -1) * (cell - 2 * gap) + gap
    corner = np.stack([np.arange(32) % 6, np.arange(32) // 6], -1)[:, None, None, :] * cell
    turned = [0, 2, 1]  # z up becomes y up; the sign keeps the handedness
    sign = np.array([1.0, 1.0, -1.0])
    mesh = Mesh(
        points.reshape(-1, 3)[:, turned] * sign,
        np.ascontiguousarray(triangles).astype(np.int32),
        normals.reshape(-1, 3)[:, turned] * sign,
        (corner + within).reshape(-1, 2),
        name="teapot",
    )
    a, b, c = (mesh.positions[mesh.triangles[:, k]] for k in range(3))
    keep = np.linalg.norm(np.cross(b - a, c - a), axis=1) > 1e-12
    return _standing(Mesh(mesh.positions, mesh.triangles[keep], mesh.normals, mesh.uv, name="teapot"), width=3.0)


def _standing(mesh: Mesh, width: float) -> Mesh:
    """The mesh scaled to a width along x, its middle over the origin, its lowest point on y = 0."""
    low, high = mesh.bounds
    scale = width / (high[0] - low[0])
    middle = 0.5 * (low + high)
    return mesh.moved(scale, scale * np.array([-middle[0], -low[1], -middle[2]]))


SHAPES: dict[str, Callable[[], Mesh]] = {"sphere": sphere, "plane": plane, "bunny": bunny, "teapot": teapot}
