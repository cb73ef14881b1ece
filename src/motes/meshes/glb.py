"""glTF 2.0 as one binary file (.glb): a mesh with a colour at each vertex."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.errors import MotesError
from motes.files.writing import replacing
from motes.meshes.mesh import Mesh

MAGIC, VERSION = b"glTF", 2
# Numbers of the specification: component types, buffer targets.
FLOAT, UNSIGNED_INT = 5126, 5125
VERTICES, INDICES = 34962, 34963
COMPONENTS = {"float32": FLOAT, "uint32": UNSIGNED_INT}


def write_glb(
    path: str | os.PathLike[str], mesh: Mesh, colours: ArrayLike, material: Mapping[str, Any], generator: str
) -> Path:
    """Write a mesh as glTF 2.0, whole or not at all.

    Parameters
    ----------
    path
        Of the file.
    mesh
        With normals; its attributes go along as ``_NAME``, which programs pass to shaders.
    colours
        (V, 3) linear, in [0, 1]: what the material's base colour is multiplied by.
    material
        A material as glTF has it.
    generator
        Who made it.

    Raises
    ------
    MotesError
        When the mesh has no normals, or the file cannot be written.
    """
    if mesh.normals is None:
        raise MotesError(f"{mesh.name} has no normals", "motes.meshes.mesh.with_normals computes them")
    used = np.unique(mesh.triangles)  # others have no normal, which must be a unit vector
    index = np.zeros(len(mesh.positions), np.uint32)
    index[used] = np.arange(len(used))
    columns = {"POSITION": mesh.positions, "NORMAL": mesh.normals, "COLOR_0": np.asarray(colours, np.float64)}
    if mesh.uv is not None:
        columns["TEXCOORD_0"] = np.stack([mesh.uv[:, 0], 1 - mesh.uv[:, 1]], axis=1)  # its v grows downwards
    columns |= {f"_{name.upper()}": values[:, None] for name, values in mesh.attributes.items()}
    blob = Blob()
    attributes = {name: blob.add(values[used].astype(np.float32), VERTICES) for name, values in columns.items()}
    indices = blob.add(index[mesh.triangles].reshape(-1, 1), INDICES)
    primitive = {"attributes": attributes, "indices": indices, "material": 0}
    document: dict[str, Any] = {
        "asset": {"version": "2.0", "generator": generator},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": mesh.name}],
        "meshes": [{"primitives": [primitive], "name": mesh.name}],
        "materials": [dict(material)],
        "accessors": blob.accessors,
        "bufferViews": blob.views,
        "buffers": [{"byteLength": len(blob.data)}],
    }
    if material.get("extensions"):
        document["extensionsUsed"] = sorted(material["extensions"])
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    header = MAGIC + np.array([VERSION, 28 + len(text) + len(blob.data)], "<u4").tobytes()
    chunks = np.array([len(text)], "<u4").tobytes() + b"JSON" + text
    chunks += np.array([len(blob.data)], "<u4").tobytes() + b"BIN\0" + bytes(blob.data)
    with replacing(path) as staging:
        Path(staging).write_bytes(header + chunks)
    return Path(path)


class Blob:
    """The binary chunk in the making, with the accessors that say what is where."""

    def __init__(self) -> None:
        self.data = bytearray()
        self.views: list[dict[str, int]] = []
        self.accessors: list[dict[str, Any]] = []

    def add(self, values: NDArray[Any], target: int) -> int:
        """Append numbers (N, K) of four bytes each; returns the index of their accessor."""
        kind = {1: "SCALAR", 2: "VEC2", 3: "VEC3"}[values.shape[1]]
        component = COMPONENTS[values.dtype.name]
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": values.nbytes, "target": target})
        self.data += values.astype(values.dtype.newbyteorder("<")).tobytes()
        accessor = {"bufferView": len(self.views) - 1, "componentType": component, "count": len(values), "type": kind}
        bounds = {"min": values.min(axis=0).tolist(), "max": values.max(axis=0).tolist()}
        self.accessors.append({**accessor, **bounds})
        return len(self.accessors) - 1
