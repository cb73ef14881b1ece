"""glTF 2.0 as text (.gltf): a material of fitted parameters for each moment, each on a sphere, in a row."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from motes.drawing.colour import data_uri
from motes.exports.surface_files import comment, names, rounded
from motes.exports.surface_fit import SurfaceFit
from motes.files import write_text
from motes.meshes.glb import INDICES, VERTICES, Blob
from motes.meshes.shapes import sphere
from motes.version import __version__

RINGS = 48
#: From the middle of one sphere to that of the next, in radii.
APART = 2.4


def material(fit: SurfaceFit, name: str) -> dict[str, Any]:
    """A material as glTF has it."""
    given = {
        key: list(rounded(value)) if isinstance(value, tuple) else rounded((value,))[0]
        for key, value in fit.surface.written().items()
    }
    extensions = {
        "KHR_materials_specular": {
            "specularFactor": given["specular"],
            "specularColorFactor": given["specular_color"],
        }
    }
    if "sheen_color" in given:
        extensions["KHR_materials_sheen"] = {
            "sheenColorFactor": given["sheen_color"],
            "sheenRoughnessFactor": given["sheen_roughness"],
        }
    base = given["base_color"]
    assert isinstance(base, list)
    return {
        "name": name,
        "pbrMetallicRoughness": {
            "baseColorFactor": [*base, 1.0],
            "metallicFactor": given["metallic"],
            "roughnessFactor": given["roughness"],
        },
        "extensions": extensions,
        "extras": {"fit": fit.record()["error"]},
    }


def document(fits: Sequence[SurfaceFit]) -> dict[str, Any]:
    """The document, its buffer within."""
    ball, blob = sphere(RINGS), Blob()
    centred = ball.positions - np.array([0.0, 1.0, 0.0])
    assert ball.normals is not None
    used = np.unique(ball.triangles)
    index = np.zeros(len(centred), np.uint32)
    index[used] = np.arange(len(used))
    attributes = {
        name: blob.add(values[used].astype(np.float32), VERTICES)
        for name, values in (("POSITION", centred), ("NORMAL", ball.normals))
    }
    indices = blob.add(index[ball.triangles].reshape(-1, 1), INDICES)
    called = names(fits)
    materials = [material(fit, name) for fit, name in zip(fits, called, strict=True)]
    return {
        "asset": {"version": "2.0", "generator": f"Motes {__version__}", "extras": {"notes": comment(fits)}},
        "extensionsUsed": sorted({name for each in materials for name in each["extensions"]}),
        "scene": 0,
        "scenes": [{"nodes": list(range(len(fits)))}],
        "nodes": [{"mesh": k, "name": name, "translation": [APART * k, 0.0, 0.0]} for k, name in enumerate(called)],
        "meshes": [
            {"primitives": [{"attributes": attributes, "indices": indices, "material": k}], "name": name}
            for k, name in enumerate(called)
        ],
        "materials": materials,
        "accessors": blob.accessors,
        "bufferViews": blob.views,
        "buffers": [{"byteLength": len(blob.data), "uri": data_uri(bytes(blob.data), "application/octet-stream")}],
    }


def write(fits: Sequence[SurfaceFit], path: Path) -> Path:
    """Write the document."""
    return write_text(path, json.dumps(document(fits), indent=1, ensure_ascii=False) + "\n")
