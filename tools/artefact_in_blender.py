"""Draw a sphere with what Motes exported, by Cycles; run by a Python that has the package bpy.

    python artefact_in_blender.py SCRIPT.py|SHADER.osl MATERIAL RESULT.npz SIDE X,Y,Z

A camera far above looks down the axis z at the unit sphere, under a sun of irradiance 1 towards (X, Y, Z).  SCRIPT.py makes MATERIAL; of SHADER.osl the
closure is worn.
"""

from __future__ import annotations

import runpy
import sys
from pathlib import Path

import bpy
import mathutils
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from cycles_support import drawn_by_cycles

FILE, NAME, RESULT, SIDE = Path(sys.argv[1]), sys.argv[2], Path(sys.argv[3]), int(sys.argv[4])
SUN = [float(x) for x in sys.argv[5].split(",")]


def with_osl() -> bpy.types.Material:
    import _cycles  # there once bpy is

    compiled = FILE.with_suffix(".oso")
    if not _cycles.osl_compile(str(FILE), str(compiled)):
        sys.exit("the shader does not compile")
    material = bpy.data.materials.new("motes")
    if bpy.app.version < (5, 0):  # later all materials have nodes
        material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    script, end = nodes.new("ShaderNodeScript"), nodes.new("ShaderNodeOutputMaterial")
    script.mode, script.filepath = "EXTERNAL", str(compiled)
    script.outputs.new("NodeSocketShader", "BSDF")
    links.new(script.outputs["BSDF"], end.inputs["Surface"])
    return material


bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
drawn_by_cycles(scene, SIDE)
scene.cycles.shading_system = FILE.suffix == ".osl"
bpy.ops.mesh.primitive_uv_sphere_add(segments=256, ring_count=128)
bpy.ops.object.shade_smooth()
ball = bpy.context.object
if FILE.suffix == ".osl":
    ball.data.materials.append(with_osl())
else:
    runpy.run_path(str(FILE))
    ball.data.materials.append(bpy.data.materials[NAME])
sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
sun.data.energy, sun.data.angle = 1.0, 0.0
sun.rotation_euler = mathutils.Vector(SUN).to_track_quat("Z", "Y").to_euler()
camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
camera.data.type, camera.data.ortho_scale, camera.location = "ORTHO", 2.0, (0, 0, 5)
for thing in (sun, camera):
    scene.collection.objects.link(thing)
scene.camera = camera
scene.render.filepath = str(RESULT.with_suffix(".exr"))
bpy.ops.render.render(write_still=True)
loaded = bpy.data.images.load(scene.render.filepath)
values = np.empty(4 * SIDE * SIDE, "f4")
loaded.pixels.foreach_get(values)
np.savez(RESULT, colors=values.reshape(SIDE, SIDE, 4)[..., :3])
