"""Draw a plane with a Principled BSDF in Blender's Cycles; executed by a Python that has the package bpy, not imported by the tests.

    python principled_in_blender.py SCRIPT.py MATERIAL RESULT.npz X,Y,Z

SCRIPT.py is one that `motes export --to blender` wrote: it makes the materials.  The plane z = 0 is seen from (0, 0, 1) with a half angle of 60
degrees; the sun stands towards (X, Y, Z), with strength pi, so that a white diffuser that faces it is 1.
"""

from __future__ import annotations

import math
import runpy
import sys
from pathlib import Path

import bpy
import mathutils
import numpy as np

SIDE = 48


def main(script: Path, material: str, result: Path, towards: list[float]) -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine, scene.cycles.device, scene.cycles.samples = "CYCLES", "CPU", 1
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
    scene.cycles.pixel_filter_type, scene.cycles.filter_width = "BOX", 0.01
    scene.cycles.max_bounces = 0
    scene.render.resolution_x = scene.render.resolution_y = SIDE
    scene.render.image_settings.file_format, scene.render.image_settings.color_depth = "OPEN_EXR", "32"
    scene.render.threads_mode, scene.render.threads = "FIXED", 2
    runpy.run_path(str(script))

    bpy.ops.mesh.primitive_plane_add(size=20)
    bpy.context.object.data.materials.append(bpy.data.materials[material])
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy, sun.data.angle = math.pi, 0.0
    sun.rotation_euler = mathutils.Vector(towards).to_track_quat("Z", "Y").to_euler()
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.angle = math.radians(120)
    camera.location = (0, 0, 1)
    for thing in (sun, camera):
        scene.collection.objects.link(thing)
    scene.camera = camera
    picture = result.with_suffix(".exr")
    scene.render.filepath = str(picture)
    bpy.ops.render.render(write_still=True)
    loaded = bpy.data.images.load(str(picture))
    pixels = np.empty(4 * SIDE * SIDE, "f4")
    loaded.pixels.foreach_get(pixels)
    np.savez(result, colors=pixels.reshape(SIDE, SIDE, 4)[..., :3])


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2], Path(sys.argv[3]), [float(x) for x in sys.argv[4].split(",")])
