"""STL and glTF (.glb, .gltf) by trimesh; what a glTF file claims is looked at before.

glTF files are scenes: all meshes that the scene shows become one, where it puts them.  Materials, pictures and texture coordinates are passed over.
Buffers of a ``.gltf`` stand inside it or in files of its folder.
"""

from __future__ import annotations

import base64
import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError, MissingExtraError, MotesError
from motes.files import budget
from motes.meshes.mesh import Mesh
from motes.meshes.winding import welded

MAGIC = b"glTF"
DEEPEST = 64
#: Bytes that a vertex and a triangle take once they are read, with what is made on the way.
VERTEX, TRIANGLE = 250, 100
_BYTES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
_NUMBERS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
_KNOWN = {"KHR_mesh_quantization", "KHR_texture_transform", "KHR_materials_unlit"}


def _trimesh() -> Any:
    try:
        import trimesh
    except ImportError:
        raise MissingExtraError("trimesh", "meshes", "Reading STL and glTF files") from None
    return trimesh


def read_stl(path: Path) -> Mesh:
    """A binary or ASCII STL file, its corners welded where they share a place."""
    library = _trimesh()
    size = path.stat().st_size
    with path.open("rb") as file:
        head = file.read(84)
    count = struct.unpack_from("<I", head, 80)[0] if len(head) == 84 else -1
    binary = 84 + 50 * count == size
    if not binary and not head.lstrip().lower().startswith(b"solid"):
        raise FormatError(f"{path} is not an STL file, or is cut short", "Export it again")
    budget.check(path, (count if binary else size // 80) * (3 * VERTEX + TRIANGLE), "its triangles")
    try:
        with path.open("rb") as file:
            found = library.load_mesh(file, file_type="stl", process=False)
        corners, faces = np.asarray(found.vertices, np.float64), np.asarray(found.faces, np.int64)
    except MotesError:
        raise
    except Exception as error:  # HeaderError, ValueError, IndexError: what damaged files make of the library
        raise _damaged(path, error) from None
    if not len(faces):
        raise FormatError(f"{path} holds no faces", "Export the mesh with its faces")
    place = welded(corners)
    positions = np.zeros((place.max() + 1, 3))
    positions[place] = corners
    return Mesh(positions, place[faces].astype(np.int32), name=path.stem)


def read_gltf(path: Path) -> Mesh:
    """All meshes of the scene of a glTF 2.0 file as one."""
    library = _trimesh()
    data = path.read_bytes()
    document = _document(path, data)
    triangles = _checked(path, document, len(data))
    if not triangles:
        raise FormatError(f"{path} shows no triangles", "Export the mesh with its faces, in the scene")
    try:
        with path.open("rb") as file:
            scene = library.load_scene(
                file,
                file_type="glb" if data.startswith(MAGIC) else "gltf",
                resolver=_Folder(path),
                process=False,
                skip_materials=True,
                merge_primitives=False,
            )
        parts = []
        for node in scene.graph.nodes_geometry:
            transform, name = scene.graph[node]
            if len(getattr(scene.geometry[name], "faces", ())):
                parts.append(_placed(scene.geometry[name], np.asarray(transform, np.float64)))
        return _together(path, parts)
    except MotesError:
        raise
    except Exception as error:  # KeyError, ValueError, IndexError, TypeError: what damaged files make of the library
        raise _damaged(path, error) from None


def _placed(part: Any, transform: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.int64], Any]:
    """Positions, faces and normals (None where the file has none) of a mesh at its node; a mirror turns its faces."""
    turn = transform[:3, :3]
    faces = np.asarray(part.faces, np.int64)
    mirrored = np.linalg.det(turn) < 0
    # The library computes normals of its own where one asks for them; those of the file are what it holds without asking.
    given = part._cache.cache.get("vertex_normals")
    with np.errstate(all="ignore"):  # a flat transform has no inverse: its normals are computed anew
        normals = None if given is None else np.asarray(given, np.float64) @ np.linalg.pinv(turn)
    positions = np.asarray(part.vertices, np.float64) @ turn.T + transform[:3, 3]
    return positions, faces[:, ::-1] if mirrored else faces, normals


def _together(path: Path, parts: list[tuple[NDArray[np.float64], NDArray[np.int64], Any]]) -> Mesh:
    if not parts:
        raise FormatError(f"{path} shows no triangles", "Export the mesh with its faces, in the scene")
    shifts = np.cumsum([0, *(len(positions) for positions, _, _ in parts)])
    normals = [own for _, _, own in parts]
    return Mesh(
        np.concatenate([positions for positions, _, _ in parts]),
        np.concatenate([faces + shift for (_, faces, _), shift in zip(parts, shifts, strict=False)]).astype(np.int32),
        None if any(own is None for own in normals) else np.concatenate(normals),
        name=path.stem,
    )


class _Folder:
    """Files that a document may name: those of its own folder."""

    def __init__(self, path: Path) -> None:
        self.path, self.folder = path, path.resolve().parent
        self.file_name = path.name

    def get(self, name: str) -> bytes:
        file = (self.folder / str(name)).resolve()
        if "://" in str(name) or not file.is_relative_to(self.folder):
            raise FormatError(
                f"{self.path} names {str(name)[:60]!r}, outside its folder", "Export it as .glb, in one file"
            )
        if not file.is_file():
            raise FormatError(
                f"{self.path} needs {str(name)[:60]!r}, which is not there", "Copy it beside, or export .glb"
            )
        return file.read_bytes()

    def __getitem__(self, name: str) -> bytes:
        return self.get(name)


def _document(path: Path, data: bytes) -> dict[str, Any]:
    """The JSON of a .glb or .gltf file."""
    text = data
    if data.startswith(MAGIC):
        if len(data) < 20:
            raise FormatError(f"{path} is cut short", "Export it again")
        version, total, length, kind = struct.unpack_from("<IIII", data, 4)
        if version != 2 or kind != 0x4E4F534A or total > len(data) or 20 + length > len(data):
            raise FormatError(f"{path} is no whole GLB file of version 2", "Export it again as glTF binary (.glb)")
        text = data[20 : 20 + length]
    try:
        document = json.loads(text)
    except (ValueError, RecursionError):
        document = None
    if not isinstance(document, dict):
        raise FormatError(f"{path} is no glTF file: it holds no description", "Export it again")
    return document


def _checked(path: Path, document: dict[str, Any], size: int) -> int:
    """The number of triangles that the scene shows, once all indices, sizes and the tree of nodes are known to be sane."""
    required = set(map(str, _list(document, "extensionsRequired"))) - _KNOWN
    if required:
        raise FormatError(
            f"{path} needs {', '.join(sorted(required))[:100]}", "Export it without compression or extensions"
        )
    buffers = [_length(path, each) for each in _records(path, document, "buffers")]
    views = []
    for view in _records(path, document, "bufferViews"):
        at, n, stride = (_whole(path, view, key) for key in ("byteOffset", "byteLength", "byteStride"))
        buffer = _whole(path, view, "buffer")
        if buffer >= len(buffers) or at + n > buffers[buffer] or stride > 252:
            raise _impossible(path, "bufferViews")
        views.append((n, stride))
    counts = []
    for accessor in _records(path, document, "accessors"):
        count, at = _whole(path, accessor, "count"), _whole(path, accessor, "byteOffset")
        width = _BYTES.get(accessor.get("componentType", 0), 0) * _NUMBERS.get(str(accessor.get("type")), 0)
        if not width or "sparse" in accessor:
            raise FormatError(f"{path} holds numbers in a way that is not read", "Export it without sparse accessors")
        if "bufferView" in accessor:
            at_view = _whole(path, accessor, "bufferView")
            if (
                at_view >= len(views)
                or at + max(count - 1, 0) * (views[at_view][1] or width) + width * (count > 0) > views[at_view][0]
            ):
                raise _impossible(path, "accessors")
        else:  # zeros, which cost a file nothing
            budget.check(path, count * width * 8, f"{count} numbers that are not in the file", size)
        counts.append(count)
    meshes = []
    for mesh in _records(path, document, "meshes"):
        vertices = triangles = 0
        for primitive in _records(path, mesh, "primitives"):
            attributes = primitive.get("attributes")
            places = attributes.get("POSITION") if isinstance(attributes, dict) else None
            if primitive.get("mode", 4) not in (4, 5, 6) or places is None:
                continue
            chosen = [places, primitive.get("indices", places)]
            if not all(type(k) is int and 0 <= k < len(counts) for k in chosen):
                raise _impossible(path, "meshes")
            vertices += counts[chosen[0]]
            triangles += counts[chosen[1]] // (3 if primitive.get("mode", 4) == 4 else 1)
        meshes.append((vertices, triangles))
    vertices, triangles = _shown(path, document, meshes)
    budget.check(path, vertices * VERTEX + triangles * TRIANGLE, f"{triangles} triangles", max(size, sum(buffers)))
    return triangles


def _shown(path: Path, document: dict[str, Any], meshes: list[tuple[int, int]]) -> tuple[int, int]:
    """Vertices and triangles of all nodes; a node has one parent at most, and none is its own ancestor."""
    nodes = _records(path, document, "nodes")
    parent: dict[int, int] = {}
    vertices = triangles = 0
    for k, node in enumerate(nodes):
        for child in _list(node, "children"):
            if type(child) is not int or not 0 <= child < len(nodes) or child in parent:
                raise _impossible(path, "nodes")
            parent[child] = k
        mesh = node.get("mesh")
        if mesh is not None:
            if type(mesh) is not int or not 0 <= mesh < len(meshes):
                raise _impossible(path, "nodes")
            vertices, triangles = vertices + meshes[mesh][0], triangles + meshes[mesh][1]
    depth: dict[int, int] = {}
    for k in range(len(nodes)):
        chain = []
        at: int | None = k
        while at is not None and at not in depth:
            chain.append(at)
            if len(chain) > DEEPEST:
                raise FormatError(
                    f"{path} has nodes that are their own ancestors, or {DEEPEST} deep", "Export it again"
                )
            at = parent.get(at)
        base = -1 if at is None else depth[at]
        for step, node_ in enumerate(reversed(chain)):
            depth[node_] = base + 1 + step
        if depth[k] > DEEPEST:
            raise FormatError(f"{path} has nodes that are {DEEPEST} deep", "Export it again")
    return vertices, triangles


def _length(path: Path, buffer: dict[str, Any]) -> int:
    """Bytes of a buffer; those of a file or a data address are counted, not believed."""
    claimed = _whole(path, buffer, "byteLength")
    uri = buffer.get("uri")
    if uri is None:
        held = path.stat().st_size
    elif str(uri).startswith("data:"):
        try:
            held = len(base64.b64decode(str(uri).partition(",")[2], validate=False))
        except ValueError:
            held = -1
    else:
        held = len(_Folder(path).get(str(uri)))
    if claimed > held:
        raise FormatError(f"{path} claims {claimed} bytes of numbers, and {max(held, 0)} are there", "Export it again")
    return claimed


def _records(path: Path, owner: dict[str, Any], key: str) -> list[dict[str, Any]]:
    found = _list(owner, key)
    if not all(isinstance(each, dict) for each in found):
        raise _impossible(path, key)
    return found


def _list(owner: dict[str, Any], key: str) -> list[Any]:
    found = owner.get(key, [])
    return found if isinstance(found, list) else [None]


def _whole(path: Path, owner: dict[str, Any], key: str) -> int:
    value = owner.get(key, 0)
    if type(value) is not int or not 0 <= value < 2**40:
        raise FormatError(f"{path}: {key} = {str(value)[:40]} is no size", "The file is damaged; export it again")
    return value


def _impossible(path: Path, key: str) -> FormatError:
    return FormatError(
        f"{path} has {key} that lead nowhere, or beyond the file", "The file is damaged; export it again"
    )


def _damaged(path: Path, error: Exception) -> FormatError:
    said = " ".join(str(error).split())[:100] or type(error).__name__
    return FormatError(f"{path} cannot be read as a mesh: {said}", "Export it again")
