"""Files of other programs that refer to the pictures of a map: MaterialX, and a script for Blender."""

from __future__ import annotations

import pprint
import xml.etree.ElementTree as ElementTree
from collections.abc import Sequence

from motes.exports.materialx import VERSION
from motes.exports.surface_blender import PRINCIPLED, SOCKETS
from motes.exports.surface_files import NODES, rounded
from motes.exports.texture_sets import TextureSet
from motes.models import Surface

#: The input for normals of each node.
NORMALS = {"open_pbr_surface": "geometry_normal", "standard_surface": "normal"}

BODY = (
    '''
from pathlib import Path

import bpy

MATERIALS = {materials}


def folder():
    """Where the pictures are: beside this file, opened as a text in Blender or not."""
    text = bpy.data.texts.get(Path(__file__).name)
    path = bpy.path.abspath(text.filepath) if text is not None and text.filepath else __file__
    return Path(path).resolve().parent


'''
    + PRINCIPLED
    + '''

def picture(nodes, file, colour):
    """A node of a picture; colours are of sRGB where it is a PNG, all else is numbers."""
    node = nodes.new("ShaderNodeTexImage")
    node.image = bpy.data.images.load(str(folder() / file), check_existing=True)
    node.image.colorspace_settings.name = "sRGB" if colour and file.endswith(".png") else "Non-Color"
    node.interpolation = "Linear"
    return node


for name, (values, pictures, normal) in MATERIALS.items():
    node = principled(name)
    nodes, links = node.id_data.nodes, node.id_data.links
    for socket, value in values.items():
        node.inputs[socket].default_value = (*value, 1.0) if isinstance(value, list) else value
    for k, (socket, (file, colour)) in enumerate(pictures.items()):
        source = picture(nodes, file, colour)
        source.location = (-700, 300 - 300 * k)
        links.new(source.outputs["Color"], node.inputs[socket])
    if normal:
        source, turn = picture(nodes, normal, False), nodes.new("ShaderNodeNormalMap")
        source.location, turn.location = (-700, 600), (-500, 600)
        links.new(source.outputs["Color"], turn.inputs["Color"])
        links.new(turn.outputs["Normal"], node.inputs["Normal"])
'''
)


def materialx(sets: Sequence[TextureSet], kind: type[Surface], head: Sequence[str], normal: str | None) -> str:
    """A document with a material for each moment."""
    root = ElementTree.Element("materialx", version=VERSION, colorspace="lin_rec709")
    root.append(ElementTree.Comment("\n" + "\n".join(f"  {line}" for line in head).replace("--", "- -") + "\n"))
    node = NODES[kind.__name__]
    if normal is not None:
        picture = ElementTree.SubElement(root, "image", name="normal_picture", type="vector3")
        ElementTree.SubElement(picture, "input", name="file", type="filename", value=normal)
        turn = ElementTree.SubElement(root, "normalmap", name="normal_map", type="vector3")
        ElementTree.SubElement(turn, "input", name="in", type="vector3", nodename="normal_picture")
    for each in sets:
        for key, texture in each.textures.items():
            type_ = "color3" if texture.values.shape[2] == 3 else "float"
            picture = ElementTree.SubElement(root, "image", name=f"{each.name}_{key}", type=type_)
            file = ElementTree.SubElement(picture, "input", name="file", type="filename", value=each.file(key))
            if texture.srgb and texture.suffix == ".png":
                file.set("colorspace", "srgb_texture")
        shader = ElementTree.SubElement(root, node, name=f"{each.name}_surface", type="surfaceshader")
        for parameter, value in each.constants.items():
            many = isinstance(value, tuple)
            text = ", ".join(map(repr, rounded(value))) if isinstance(value, tuple) else repr(rounded((value,))[0])
            ElementTree.SubElement(shader, "input", name=parameter, type="color3" if many else "float", value=text)
        for key, texture in each.textures.items():
            type_ = "color3" if texture.values.shape[2] == 3 else "float"
            ElementTree.SubElement(shader, "input", name=key, type=type_, nodename=f"{each.name}_{key}")
        if normal is not None:
            ElementTree.SubElement(shader, "input", name=NORMALS[node], type="vector3", nodename="normal_map")
        material = ElementTree.SubElement(root, "surfacematerial", name=each.name, type="material")
        ElementTree.SubElement(
            material, "input", name="surfaceshader", type="surfaceshader", nodename=f"{each.name}_surface"
        )
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="utf-8"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"


def blender(sets: Sequence[TextureSet], head: Sequence[str], normal: str | None) -> str:
    """A script that makes a material for each moment."""
    materials = {}
    for each in sets:
        values = {
            SOCKETS[parameter]: list(rounded(value)) if isinstance(value, tuple) else rounded((value,))[0]
            for parameter, value in each.constants.items()
        }
        pictures = {SOCKETS[key]: [each.file(key), texture.srgb] for key, texture in each.textures.items()}
        materials[each.name] = [values, pictures, normal or ""]
    lines = [f"# {line}" for line in head]
    run = "# Run it in Blender's text editor, or: blender FILE.blend --python THIS.py"
    body = BODY.replace("{materials}", pprint.pformat(materials, width=100, sort_dicts=False))
    return "\n".join([*lines, run]) + "\n" + body
