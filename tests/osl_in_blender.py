"""Run an exported OSL shader in Blender's Cycles; executed by a Python that has the package bpy, not imported by the tests.

    python osl_in_blender.py SHADER.osl OUTPUT DIRECTIONS.npz RESULT.npy LIGHT,VIEW

A plane emits the shader's OUTPUT, a pixel a pair of directions, which come from two float images for the inputs
LIGHT and VIEW.  OUTPUT ``BSDF`` is looked at under a
white sky instead: the mean of the pixels is the albedo towards a viewer at the normal.
"""

from __future__ import annotations

import sys
from pathlib import Path

import bpy
import numpy as np


def image(name: str, w: np.ndarray, side: int) -> bpy.types.Image:
    made = bpy.data.images.new(name, side, side, float_buffer=True, is_data=True)
    made.use_half_precision = False
    made.pixels.foreach_set(np.pad(w.astype("f4"), ((0, 0), (0, 1)), constant_values=1.0).ravel())
    made.update()
    made.pack()
    return made


def main(shader: Path, output: str, directions: Path, result: Path, inputs: list[str]) -> None:
    import _cycles  # there once bpy is

    data = np.load(directions)
    side = int(np.sqrt(len(data["wi"])))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.shading_system = "CPU", True
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
    scene.cycles.pixel_filter_type, scene.cycles.filter_width = "BOX", 1.0
    scene.render.resolution_x = scene.render.resolution_y = side
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.threads_mode, scene.render.threads = "FIXED", 2

    bpy.ops.mesh.primitive_plane_add(size=2)
    plane = bpy.context.object
    material = bpy.data.materials.new("motes")
    material.use_nodes = True
    plane.data.materials.append(material)
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    script = nodes.new("ShaderNodeScript")
    compiled = shader.with_suffix(".oso")
    if not _cycles.osl_compile(str(shader), str(compiled)):
        sys.exit("the shader does not compile")
    # The package has no oslquery, with which Blender makes the sockets.
    script.mode, script.filepath = "EXTERNAL", str(compiled)
    for name in () if output == "BSDF" else inputs:  # an empty socket would be (0, 0, 0)
        script.inputs.new("NodeSocketVector", name)
    script.outputs.new("NodeSocketShader" if output == "BSDF" else "NodeSocketColor", output)
    end = nodes.new("ShaderNodeOutputMaterial")
    if output == "BSDF":
        scene.cycles.samples = 64
        world = bpy.data.worlds.new("white")
        world.use_nodes = True
        world.node_tree.nodes["Background"].inputs["Color"].default_value = (1, 1, 1, 1)
        scene.world = world
        links.new(script.outputs[output], end.inputs["Surface"])
    else:
        scene.cycles.samples = 1
        for name, w in zip(inputs, (data["wi"], data["wo"]), strict=True):
            node = nodes.new("ShaderNodeTexImage")
            node.image, node.interpolation = image(name, w, side), "Closest"
            links.new(node.outputs["Color"], script.inputs[name])
        emission = nodes.new("ShaderNodeEmission")
        links.new(script.outputs[output], emission.inputs["Color"])
        links.new(emission.outputs["Emission"], end.inputs["Surface"])

    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type, camera.data.ortho_scale = "ORTHO", 2.0
    camera.location = (0, 0, 1)
    scene.collection.objects.link(camera)
    scene.camera = camera
    picture = result.with_suffix(".exr")
    scene.render.filepath = str(picture)
    bpy.ops.render.render(write_still=True)
    loaded = bpy.data.images.load(str(picture))
    pixels = np.empty(4 * side * side, "f4")
    loaded.pixels.foreach_get(pixels)
    np.save(result, pixels.reshape(-1, 4)[:, :3])


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2], Path(sys.argv[3]), Path(sys.argv[4]), sys.argv[5].split(","))
