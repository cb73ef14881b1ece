"""Import materials of Motes by Blender's extension, beside the script of the export; executed by a Python that has the package bpy.

    python blender_import.py EXTENSION.zip SCRIPT.py FIT.json BAD.json RESULT.json

RESULT has the sockets of both nodes over frames 1 and 25, what the active object wears, and what a bad file is told.
"""

from __future__ import annotations

import json
import runpy
import sys

import bpy

EXTENSION, SCRIPT, FIT, BAD, RESULT = sys.argv[1:]


def sockets(tree: bpy.types.NodeTree) -> dict[str, list]:
    """Values of a Principled BSDF by socket, at both frames."""
    (node,) = [each for each in tree.nodes if each.type == "BSDF_PRINCIPLED"]
    found: dict[str, list] = {}
    for frame in (1, 25):
        bpy.context.scene.frame_set(frame)
        for each in node.inputs:
            if hasattr(each, "default_value"):
                value = each.default_value
                found.setdefault(each.name, []).append(list(value) if hasattr(value, "__len__") else value)
    return found


bpy.ops.preferences.addon_enable(module="bl_pkg")
bpy.ops.extensions.package_install_files(filepath=EXTENSION, repo="user_default", enable_on_install=True)
bpy.ops.mesh.primitive_plane_add()
assert bpy.ops.import_scene.motes_material(filepath=FIT) == {"FINISHED"}
worn = bpy.context.object.active_material
(shown,) = [node for node in worn.node_tree.nodes if node.type == "GROUP"]
ends = [link.to_node.type for link in shown.outputs["BSDF"].links]
runpy.run_path(SCRIPT)
bpy.ops.mesh.primitive_plane_add()  # what nothing wears is not animated
bpy.context.object.active_material = changing = bpy.data.materials["wet_rock"]
refused = ""
try:
    bpy.ops.import_scene.motes_material(filepath=BAD)
except RuntimeError as error:
    refused = str(error)
told = {
    "material": worn.name,
    "group": shown.node_tree.name,
    "ends": ends,
    "imported": sockets(shown.node_tree),
    "scripted": sockets(changing.node_tree),
    "refused": refused,
}
with open(RESULT, "w") as file:
    json.dump(told, file)
