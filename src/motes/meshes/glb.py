"""glTF 2.0 as one binary file (.glb): a mesh with a colour at each vertex, which may change with time."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
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
#: How long an animation of colours runs, whatever it stands for.
SECONDS = 4.0


def write_glb(
    path: str | os.PathLike[str],
    mesh: Mesh,
    colours: ArrayLike,
    material: Mapping[str, Any],
    generator: str,
    *,
    later: Sequence[tuple[float, ArrayLike]] = (),
    first: float = 0.0,
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
    later
        Further days, increasing, with the colours (V, 3) then: morph targets, which an animation named ``days`` goes through in `SECONDS`, in
        proportion to the days, and between two of them linearly.
    first
        The day of `colours`.

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
    primitive: dict[str, Any] = {"attributes": attributes, "indices": indices, "material": 0}
    shape: dict[str, Any] = {"primitives": [primitive], "name": mesh.name}
    document: dict[str, Any] = {
        "asset": {"version": "2.0", "generator": generator},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": mesh.name}],
        "meshes": [shape],
        "materials": [dict(material)],
        "accessors": blob.accessors,
        "bufferViews": blob.views,
    }
    if later:
        changes = [np.asarray(then, np.float64) - columns["COLOR_0"] for _, then in later]
        still = blob.zeros(len(used))  # three.js counts the vertices of a target by its positions
        primitive["targets"] = [
            {"POSITION": still, "COLOR_0": blob.add(change[used].astype(np.float32), VERTICES)} for change in changes
        ]
        document["animations"] = [_through([first, *(day for day, _ in later)], blob)]
        shape["weights"] = [0.0] * len(later)
        shape["extras"] = {"targetNames": [f"{day:g} days" for day, _ in later]}  # where programs look for names
    document["buffers"] = [{"byteLength": len(blob.data)}]
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


def _through(days: Sequence[float], blob: Blob) -> dict[str, Any]:
    """An animation in which the colours of each day have their moment: every target alone, after none of them."""
    moments = SECONDS * (np.asarray(days) - days[0]) / (days[-1] - days[0])
    weights = np.eye(len(days))[:, 1:].reshape(-1, 1)
    sampler = {
        "input": blob.add(moments[:, None].astype(np.float32)),
        "output": blob.add(weights.astype(np.float32)),
        "interpolation": "LINEAR",
    }
    channel = {"sampler": 0, "target": {"node": 0, "path": "weights"}}
    return {"name": "days", "samplers": [sampler], "channels": [channel], "extras": {"days": list(days)}}


class Blob:
    """The binary chunk in the making, with the accessors that say what is where."""

    def __init__(self) -> None:
        self.data = bytearray()
        self.views: list[dict[str, int]] = []
        self.accessors: list[dict[str, Any]] = []

    def add(self, values: NDArray[Any], target: int | None = None) -> int:
        """Append numbers (N, K) of four bytes each; returns the index of their accessor.  An animation's have no target."""
        kind = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}[values.shape[1]]
        component = COMPONENTS[values.dtype.name]
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": values.nbytes}
        self.views.append(view if target is None else {**view, "target": target})
        self.data += values.astype(values.dtype.newbyteorder("<")).tobytes()
        accessor = {"bufferView": len(self.views) - 1, "componentType": component, "count": len(values), "type": kind}
        bounds = {"min": values.min(axis=0).tolist(), "max": values.max(axis=0).tolist()}
        self.accessors.append({**accessor, **bounds})
        return len(self.accessors) - 1

    def zeros(self, count: int) -> int:
        """The index of an accessor of so many vectors of 0, which take no bytes: what has no view is 0."""
        accessor = {"componentType": FLOAT, "count": count, "type": "VEC3", "min": [0.0] * 3, "max": [0.0] * 3}
        self.accessors.append(accessor)
        return len(self.accessors) - 1
