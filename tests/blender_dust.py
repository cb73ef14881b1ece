"""Install Blender's extension and let dust settle; executed by a Python that has the package bpy, not imported by the tests.

    python blender_dust.py EXTENSION.zip RESULT.npz SIDE

A table over a plane gathers dust (its shares are compared with Motes').  A sphere of one known share is drawn under a sun by each
kind of shader, over a plain diffuse material and a Principled one, in Cycles; the day is animated.
"""

from __future__ import annotations

import sys
from pathlib import Path

import bpy
import numpy as np

from cycles_support import drawn_by_cycles

EXTENSION, RESULT, SIDE = Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3])
SUN = np.array([0.5, 0.0, 0.8]) / np.linalg.norm([0.5, 0.0, 0.8])
found: dict[str, np.ndarray] = {}


def install() -> None:
    bpy.ops.preferences.addon_enable(module="bl_pkg")
    done = bpy.ops.extensions.package_install_files(
        filepath=str(EXTENSION), repo="user_default", enable_on_install=True
    )
    assert done == {"FINISHED"}, done


def empty() -> bpy.types.Scene:
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    return bpy.context.scene


def shares(thing: bpy.types.Object) -> np.ndarray:
    values = np.empty(len(thing.data.vertices), np.float32)
    thing.data.attributes["motes_share"].data.foreach_get("value", values)
    return values


def settle_on_a_plane_under_a_table() -> None:
    empty()
    bpy.ops.mesh.primitive_plane_add(size=2, location=(0, 0, 0.6))
    bpy.context.object.scale = (0.3, 0.3, 1)
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=12, y_subdivisions=12, size=3)
    ground = bpy.context.object
    bpy.context.view_layer.update()
    assert bpy.ops.object.motes_dust(rays=48) == {"FINISHED"}
    found["sheltered"] = shares(ground)
    assert bpy.ops.object.motes_dust(rays=48, shelter=False) == {"FINISHED"}
    found["open"] = shares(ground)
    found["points"] = np.array([ground.matrix_world @ v.co for v in ground.data.vertices])
    found["triangles"] = np.array([k for p in ground.data.polygons for k in p.vertices]).reshape(-1, 4)
    bpy.ops.mesh.primitive_uv_sphere_add(segments=16, ring_count=12)
    ball = bpy.context.object
    ball.scale, ball.rotation_euler = (1, 2, 0.5), (0.3, 0.2, 0.1)
    bpy.context.view_layer.update()
    assert bpy.ops.object.motes_dust(rays=64, shelter=False, up=(0, 1, 1), slipperiness=0.5) == {"FINISHED"}
    found["ball"] = shares(ball)
    found["ball_points"] = np.array([ball.matrix_world @ v.co for v in ball.data.vertices])
    turn = ball.matrix_world.to_3x3().inverted().transposed()
    found["ball_normals"] = np.array([(turn @ v.normal).normalized() for v in ball.data.vertices])
    ball.data.calc_loop_triangles()
    found["ball_triangles"] = np.array([[*t.vertices] for t in ball.data.loop_triangles])


def stage() -> bpy.types.Object:
    scene = empty()
    drawn_by_cycles(scene, SIDE)
    scene.world = bpy.data.worlds.new("dark")
    scene.world.use_nodes = True
    background = scene.world.node_tree.nodes["Background"].inputs
    background["Color"].default_value, background["Strength"].default_value = (1, 1, 1, 1), 0
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy, sun.data.angle = 1.0, 0.0  # Blender's sun: irradiance in W/m^2
    sun.rotation_euler = (0, np.arctan2(SUN[0], SUN[2]), 0)
    scene.collection.objects.link(sun)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type, camera.data.ortho_scale, camera.location = "ORTHO", 2.0, (0, 0, 5)
    scene.collection.objects.link(camera)
    scene.camera = camera
    bpy.ops.mesh.primitive_uv_sphere_add(segments=128, ring_count=64)
    bpy.ops.object.shade_smooth()
    return bpy.context.object


def drawn() -> np.ndarray:
    scene, picture = bpy.context.scene, RESULT.with_suffix(".exr")
    scene.render.filepath = str(picture)
    bpy.ops.render.render(write_still=True)
    loaded = bpy.data.images.load(str(picture))
    pixels = np.empty(4 * SIDE * SIDE, np.float32)
    loaded.pixels.foreach_get(pixels)
    bpy.data.images.remove(loaded)
    return pixels.reshape(SIDE, SIDE, 4)[..., :3]


def material(kind: str) -> bpy.types.Material:
    made = bpy.data.materials.new(kind)
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    if kind == "diffuse":
        nodes.clear()
        end, base = nodes.new("ShaderNodeOutputMaterial"), nodes.new("ShaderNodeBsdfDiffuse")
        links.new(base.outputs[0], end.inputs["Surface"])
        base.inputs["Color"].default_value = (0.6, 0.3, 0.1, 1)
    else:
        base = nodes["Principled BSDF"]
        base.inputs["Base Color"].default_value = (0.6, 0.3, 0.1, 1)
        base.inputs["Metallic"].default_value = 0.4
    return made


def draw() -> None:
    ball = stage()
    for base in ("diffuse", "principled"):
        ball.data.materials.clear()
        ball.data.materials.append(material(base))
        bpy.context.scene.cycles.shading_system = False
        found[f"{base}_clean"] = drawn()
        for kind in ("NODES", "OSL"):
            bpy.context.scene.cycles.shading_system = kind == "OSL"
            assert bpy.ops.object.motes_dust(days=100, tau=0.5, dust="sahara", rays=4) == {"FINISHED"}
            groups = [n for n in ball.material_slots[0].material.node_tree.nodes if n.type == "GROUP"]
            assert [n.node_tree.name for n in groups] == [f"Motes Dust, sahara ({kind})"], groups
            level = ball.data.attributes["motes_share"]
            level.data.foreach_set("value", np.ones(len(ball.data.vertices), np.float32))
            found[f"{base}_{kind}"] = drawn()
            ball["motes_days"] = 0.0
            ball.update_tag()
            found[f"{base}_{kind}_day_0"] = drawn()
            ball["motes_days"] = 100.0
        if base == "diffuse":
            found["sky"] = under_the_sky()
    bpy.context.scene.frame_end = 11
    assert bpy.ops.object.motes_animate() == {"FINISHED"}
    days = []
    for frame in (1, 6, 11):
        bpy.context.scene.frame_set(frame)
        days.append(ball["motes_days"])
    found["days"] = np.array(days)
    bpy.context.scene.frame_set(1)
    found["first_frame"] = drawn()
    ball.animation_data_clear()
    assert bpy.ops.object.motes_clean() == {"FINISHED"}
    found["cleaned"] = drawn()
    left = ["motes_share" in ball.data.attributes, "motes_days" in ball]
    left += [n.type == "GROUP" for n in ball.material_slots[0].material.node_tree.nodes]
    found["left"] = np.array(left)


def under_the_sky() -> np.ndarray:
    """White light from everywhere: the picture is the directional albedo."""
    scene = bpy.context.scene
    light, background = bpy.data.lights["sun"], scene.world.node_tree.nodes["Background"].inputs["Strength"]
    light.energy, background.default_value, scene.cycles.samples, scene.cycles.max_bounces = 0.0, 1.0, 256, 1
    picture = drawn()
    light.energy, background.default_value, scene.cycles.samples, scene.cycles.max_bounces = 1.0, 0.0, 4, 0
    return picture


def refuse() -> None:
    said = ""
    try:
        bpy.ops.object.motes_dust(up=(0, 0, 0))
    except RuntimeError as error:
        said = str(error)
    assert "has no length" in said


install()
settle_on_a_plane_under_a_table()
draw()
refuse()
np.savez(RESULT, sun=SUN, **found)
