"""How much dust lies at each vertex: F H of Motes (its docs/deposition.md), the shelter found with rays through the scene."""

import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from .gathering import falling, hold
from .numbers import ADHESION, GROWTH_PER_DAY, SLIPPERINESS, SPREAD_DEG

__all__ = ["ADHESION", "GROWTH_PER_DAY", "SLIPPERINESS", "SPREAD_DEG", "forget", "settle"]

SHARE = "motes_share"
#: Rays start so far above the surface, as a share of the object's extent.
OFFSET = 1e-4


def settle(context, thing, *, up, shelter, rays, adhesion, slipperiness, spread_deg):
    """Write the share of dust at the vertices of an object, over that of a level, open surface; returns it (V,)."""
    length = np.linalg.norm(up)
    if not length > 0:
        raise ValueError("the direction Up has no length; give one such as 0, 0, 1")
    if not len(thing.data.vertices):
        raise ValueError(f"{thing.name} has no vertices for dust to lie on")
    above = np.asarray(up, float) / length
    points, normals = _vertices(thing)
    tree = _surroundings(context, [thing, *_others(context, thing)] if shelter else [thing])
    directions = falling(above, spread_deg, rays)
    extent = float(np.ptp(points, axis=0).max()) or 1.0
    fall = np.zeros(len(points))
    starts = points + OFFSET * extent * normals
    for direction in directions:
        towards, cosine = Vector(direction), normals @ direction
        for k in np.nonzero(cosine > 0)[0]:
            if tree.ray_cast(Vector(starts[k]), towards)[0] is None:
                fall[k] += cosine[k]
    fall /= (directions @ above).sum()
    share = fall * hold(normals @ above, adhesion, slipperiness)
    forget(thing)
    attribute = thing.data.attributes.new(SHARE, "FLOAT", "POINT")
    attribute.data.foreach_set("value", share.astype(np.float32))
    return share


def forget(thing):
    """Take the shares off an object."""
    old = thing.data.attributes.get(SHARE)
    if old is not None:
        thing.data.attributes.remove(old)


def _vertices(thing):
    """Positions and unit normals in the world, (V, 3) each."""
    mesh, count = thing.data, len(thing.data.vertices)
    points, normals = np.empty(3 * count, np.float32), np.empty(3 * count, np.float32)
    mesh.vertices.foreach_get("co", points)
    mesh.vertex_normals.foreach_get("vector", normals)
    world = np.array(thing.matrix_world, float)
    placed = points.reshape(-1, 3) @ world[:3, :3].T + world[:3, 3]
    turned = normals.reshape(-1, 3) @ np.linalg.inv(world[:3, :3])
    return placed, turned / np.maximum(np.linalg.norm(turned, axis=1, keepdims=True), 1e-12)


def _others(context, thing):
    """The other meshes that a render of the scene shows."""
    return [o for o in context.scene.objects if o is not thing and o.type == "MESH" and not o.hide_render]


def _surroundings(context, things):
    """A tree of the triangles of objects, as their modifiers leave them."""
    depsgraph = context.evaluated_depsgraph_get()
    points, triangles, first = [], [], 0
    for thing in things:
        shown = thing.evaluated_get(depsgraph)
        mesh = shown.to_mesh()
        mesh.calc_loop_triangles()
        points += [shown.matrix_world @ vertex.co for vertex in mesh.vertices]
        triangles += [[first + k for k in triangle.vertices] for triangle in mesh.loop_triangles]
        first = len(points)
        shown.to_mesh_clear()
    return BVHTree.FromPolygons(points, triangles, all_triangles=True)
