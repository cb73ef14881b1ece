"""What can be seen from a point: rays through Mitsuba's own tracer, for any number of points at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.meshes.mesh import Mesh

Floats = NDArray[np.float64]
Progress = Callable[[int, int, str], None]
OFFSET = 1e-4  # of the extent, by which rays start above the surface
RAYS_AT_ONCE = 1 << 20  # bounds the memory


def mitsuba_mesh(mi: Any, mesh: Mesh, properties: Any = None) -> Any:
    """The mesh as one of Mitsuba's, with normals, texture coordinates and attributes (``tau`` as ``vertex_tau``).

    Parameters
    ----------
    mi
        The module mitsuba with its variant set.
    mesh
        Its texture coordinates are passed on as they are.
    properties
        A `mi.Properties`, which may hold a BSDF.
    """
    made = mi.Mesh(
        mesh.name,
        len(mesh.positions),
        len(mesh.triangles),
        has_vertex_normals=mesh.normals is not None,
        has_vertex_texcoords=mesh.uv is not None,
        **({} if properties is None else {"props": properties}),
    )
    parameters = mi.traverse(made)
    parameters["vertex_positions"] = np.ravel(mesh.positions).astype(np.float32)
    parameters["faces"] = np.ravel(mesh.triangles).astype(np.uint32)
    if mesh.normals is not None:
        parameters["vertex_normals"] = np.ravel(mesh.normals).astype(np.float32)
    if mesh.uv is not None:
        parameters["vertex_texcoords"] = np.ravel(mesh.uv).astype(np.float32)
    parameters.update()
    for name, values in mesh.attributes.items():
        made.add_attribute(f"vertex_{name}", 1, values.astype(np.float32))
    return made


class Surroundings:
    """Meshes that stand in the way of rays.

    Positions are brought to the unit scale in double precision before they become Mitsuba's floats, so meshes may lie far from the origin.

    Parameters
    ----------
    meshes
        The first one sets the scale.
    """

    def __init__(self, meshes: Sequence[Mesh]) -> None:
        from motes.rendering import load_mitsuba

        self.mi = load_mitsuba()
        low, high = meshes[0].bounds
        self._middle, self._scale = 0.5 * (low + high), 1 / max(meshes[0].extent, 1e-300)
        near = [mesh.moved(self._scale, -self._scale * self._middle) for mesh in meshes]
        parts = {f"mesh{k}": mitsuba_mesh(self.mi, mesh) for k, mesh in enumerate(near)}
        self._scene = self.mi.load_dict({"type": "scene", **parts})
        self.slow = "scalar" in self.mi.variant()

    def visible_share(
        self, points: Floats, normals: Floats, directions: Floats, weight: str, progress: Progress | None = None
    ) -> Floats:
        """The mean over `directions` (K, 3) of what is open, for each point (N,).

        Parameters
        ----------
        points, normals
            (N, 3).
        directions
            (K, 3) unit vectors, the same for all points: shadows then have steps of 1/K rather than noise.
        weight
            ``"cosine"``: an open direction counts max(0, n . omega); ``"one"``: 1 if it is above the surface.
        progress
            Called with (done, total, what).
        """
        origins = (points - self._middle) * self._scale + OFFSET * normals
        total = np.zeros(len(points))
        step = max(RAYS_AT_ONCE // max(len(points), 1), 1)
        for start in range(0, len(directions), step):
            some = directions[start : start + step]
            cosine = normals @ some.T
            point, direction = np.nonzero(cosine > 0)
            if len(point):
                seen = ~self._blocked(origins[point], some[direction])
                value = cosine[point, direction] if weight == "cosine" else 1.0
                total += np.bincount(point, seen * value, len(points))
            if progress is not None:
                progress(min(start + step, len(directions)), len(directions), "tracing rays")
        return total / len(directions)

    def touched(self, points: Floats, normals: Floats, distance: float) -> NDArray[np.bool_]:
        """Whether something lies within a distance along the normal, on either side, (N,)."""
        origins = (points - self._middle) * self._scale
        reach = distance * self._scale
        above = self._blocked(origins, normals, reach)
        return above | self._blocked(origins, -normals, reach)

    def _blocked(self, origins: Floats, direction: Floats, reach: float | None = None) -> NDArray[np.bool_]:
        """Whether rays (N,) hit something; `direction` is (N, 3)."""
        mi = self.mi
        if self.slow:
            rays = (mi.Ray3f(o.tolist(), d.tolist()) for o, d in zip(origins, direction, strict=True))
            hits = []
            for ray in rays:
                if reach is not None:
                    ray.maxt = reach
                hits.append(bool(self._scene.ray_test(ray)))
            return np.array(hits)
        ray = mi.Ray3f(mi.Point3f(origins.T.astype(np.float32)), mi.Vector3f(direction.T.astype(np.float32)))
        if reach is not None:
            ray.maxt = reach
        return np.asarray(self._scene.ray_test(ray)).astype(bool)

    def crossings(self, origins: Floats, direction: Floats) -> tuple[NDArray[np.int64], Floats]:
        """The triangle that each ray meets first, -1 for none, (N,), and the barycentric weights of its corners, (N, 3).

        Origins are in the units of the mesh; for baking, where the mesh is its own texture coordinates.
        """
        mi = self.mi
        start = (origins - self._middle) * self._scale
        if self.slow:
            found = [
                self._scene.ray_intersect_preliminary(mi.Ray3f(o.tolist(), direction.tolist()), True) for o in start
            ]
            index = np.array([f.prim_index if f.is_valid() else -1 for f in found], np.int64)
            b = np.array([list(f.prim_uv) for f in found], np.float64).reshape(-1, 2)
        else:
            ray = mi.Ray3f(mi.Point3f(start.T.astype(np.float32)), mi.Vector3f(direction.tolist()))
            hit = self._scene.ray_intersect_preliminary(ray, coherent=True)
            index = np.where(np.asarray(hit.is_valid()).astype(bool), np.asarray(hit.prim_index, np.int64), -1)
            b = np.asarray(hit.prim_uv, np.float64).T
        return index, np.stack([1 - b.sum(1), b[:, 0], b[:, 1]], -1)
