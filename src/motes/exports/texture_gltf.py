"""glTF 2.0 as text (.gltf) with pictures beside it: a flat patch for each moment, in a row."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from motes.drawing.colour import data_uri
from motes.exports.surface_files import rounded
from motes.exports.texture_sets import TextureSet
from motes.meshes.glb import INDICES, VERTICES, Blob
from motes.version import __version__

#: From the middle of one patch to that of the next, in widths.
APART = 1.1
#: Of a sampler: LINEAR, LINEAR_MIPMAP_LINEAR, REPEAT.
SAMPLER = {"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497}


def document(
    sets: Sequence[TextureSet], notes: Sequence[str], error: dict[str, Any], normal: str | None
) -> dict[str, Any]:
    """The document; its buffer, a patch, is within."""
    height, width = next(iter(sets[0].textures.values())).values.shape[:2]
    half = 0.5 * height / width
    corners = np.array([[-0.5, half, 0], [0.5, half, 0], [-0.5, -half, 0], [0.5, -half, 0]], np.float32)
    blob = Blob()
    attributes = {
        "POSITION": blob.add(corners, VERTICES),
        "NORMAL": blob.add(np.tile(np.array([0, 0, 1], np.float32), (4, 1)), VERTICES),
        # v grows downwards, as the rows of a picture do.
        "TEXCOORD_0": blob.add(np.array([[0, 0], [1, 0], [0, 1], [1, 1]], np.float32), VERTICES),
    }
    if normal is not None:  # along u; green is along the other one, up
        attributes["TANGENT"] = blob.add(np.tile(np.array([1, 0, 0, 1], np.float32), (4, 1)), VERTICES)
    indices = blob.add(np.array([[0], [2], [1], [1], [2], [3]], np.uint32), INDICES)
    images: list[dict[str, str]] = []

    def picture(file: str) -> dict[str, int]:
        if (entry := {"uri": file}) not in images:
            images.append(entry)
        return {"index": images.index(entry)}

    materials = [_material(each, picture, error, normal) for each in sets]
    used = sorted({name for each in materials for name in each.get("extensions", ())})
    found: dict[str, Any] = {
        "asset": {"version": "2.0", "generator": f"Motes {__version__}", "extras": {"notes": list(notes)}},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(sets)))}],
        "nodes": [{"mesh": k, "name": each.name, "translation": [APART * k, 0.0, 0.0]} for k, each in enumerate(sets)],
        "meshes": [
            {"primitives": [{"attributes": attributes, "indices": indices, "material": k}], "name": each.name}
            for k, each in enumerate(sets)
        ],
        "materials": materials,
        "textures": [{"source": k, "sampler": 0} for k in range(len(images))],
        "images": images,
        "samplers": [SAMPLER],
        "accessors": blob.accessors,
        "bufferViews": blob.views,
        "buffers": [{"byteLength": len(blob.data), "uri": data_uri(bytes(blob.data), "application/octet-stream")}],
    }
    return {**found, "extensionsUsed": used} if used else found


def _material(each: TextureSet, picture: Any, error: dict[str, Any], normal: str | None) -> dict[str, Any]:
    extensions: dict[str, Any] = {}
    if "specular" in each.textures:
        shown = picture(each.file("specular"))
        factor = rounded([each.textures["specular"].factor] * 3)
        extensions["KHR_materials_specular"] = {
            "specularTexture": shown,
            "specularColorTexture": shown,
            "specularColorFactor": list(factor),
        }
    if "sheen" in each.textures:
        shown = picture(each.file("sheen"))
        extensions["KHR_materials_sheen"] = {
            "sheenColorFactor": [1.0, 1.0, 1.0],
            "sheenColorTexture": shown,
            "sheenRoughnessFactor": 1.0,
            "sheenRoughnessTexture": shown,
        }
    material: dict[str, Any] = {
        "name": each.name,
        "pbrMetallicRoughness": {
            "baseColorTexture": picture(each.file("base_color")),
            "metallicRoughnessTexture": picture(each.file("packed")),
        },
        "extras": {"fit": error},
    }
    if normal is not None:
        material["normalTexture"] = picture(normal)
    return {**material, "extensions": extensions} if extensions else material
