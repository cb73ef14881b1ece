"""Blender: a Python script that makes the materials, each a Principled BSDF with fitted parameters; of several moments one, keyed over frames, besides."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from motes.exports.surface_files import comment, names, rounded
from motes.exports.surface_fit import SurfaceFit
from motes.files import write_text

#: What the sockets of the node are called, by parameter.
SOCKETS = {
    "base_color": "Base Color",
    "diffuse_roughness": "Diffuse Roughness",
    "metallic": "Metallic",
    "roughness": "Roughness",
    "ior": "IOR",
    "specular_ior_level": "Specular IOR Level",
    "specular_tint": "Specular Tint",
    "sheen_weight": "Sheen Weight",
    "sheen_tint": "Sheen Tint",
    "sheen_roughness": "Sheen Roughness",
}
#: Frames from one moment to the next of the material that changes.
STEP = 24

#: How scripts make the node that they fill.
PRINCIPLED = '''def principled(name):
    """The node of a material of that name, which is made where there is none."""
    material = bpy.data.materials.get(name) or bpy.data.materials.new(name)
    if bpy.app.version < (5, 0):  # later all materials have nodes
        material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    node, end = nodes.new("ShaderNodeBsdfPrincipled"), nodes.new("ShaderNodeOutputMaterial")
    node.location = (-300, 0)
    links.new(node.outputs["BSDF"], end.inputs["Surface"])
    return node
'''

BODY = (
    """
import bpy

MATERIALS = {materials}
CHANGING = {changing}


"""
    + PRINCIPLED
    + '''

def give(node, values, frame=None):
    """Set the sockets; at a frame, key them."""
    for socket, value in values.items():
        node.inputs[socket].default_value = (*value, 1.0) if isinstance(value, list) else value
        if frame is not None:
            node.inputs[socket].keyframe_insert("default_value", frame=frame)


for name, values in MATERIALS.items():
    give(principled(name), values)
if CHANGING:
    node = principled(CHANGING)
    for k, values in enumerate(MATERIALS.values()):
        give(node, values, 1 + {step} * k)
'''
)


def script(fits: Sequence[SurfaceFit]) -> str:
    """The text of the script."""
    materials = {name: sockets(fit) for name, fit in zip(names(fits), fits, strict=True)}
    if len(fits) > 1:  # a socket that one moment has is keyed at all
        shared = {socket: value for values in materials.values() for socket, value in values.items()}
        materials = {name: {**shared, **values} for name, values in materials.items()}
    head = [f"# {line}" for line in comment(fits)]
    run = "# Run it in Blender's text editor, or: blender FILE.blend --python THIS.py"
    body = BODY.format(
        materials=json.dumps(materials, indent=4),
        changing=repr(fits[0].what.identifier if len(fits) > 1 else ""),
        step=STEP,
    )
    return "\n".join([*head, run]) + "\n" + body


def sockets(fit: SurfaceFit) -> dict[str, float | list[float]]:
    """Values by the name of the socket."""
    return {
        SOCKETS[parameter]: list(rounded(value)) if isinstance(value, tuple) else rounded((value,))[0]
        for parameter, value in fit.surface.written().items()
    }


def write(fits: Sequence[SurfaceFit], path: Path) -> Path:
    """Write the script."""
    return write_text(path, script(fits))
