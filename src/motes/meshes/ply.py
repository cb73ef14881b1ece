"""PLY files (Turk 1994): ASCII and binary, vertices with any scalar properties, faces with any number of corners."""

from __future__ import annotations

import contextlib
import os
import re
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError
from motes.files import reading, replacing
from motes.meshes.mesh import Mesh

TYPES = {
    **dict.fromkeys(("char", "int8"), "i1"),
    **dict.fromkeys(("uchar", "uint8"), "u1"),
    **dict.fromkeys(("short", "int16"), "i2"),
    **dict.fromkeys(("ushort", "uint16"), "u2"),
    **dict.fromkeys(("int", "int32"), "i4"),
    **dict.fromkeys(("uint", "uint32"), "u4"),
    **dict.fromkeys(("float", "float32"), "f4"),
    **dict.fromkeys(("double", "float64"), "f8"),
}
HEADER = 65536
#: Of the extent: rounding beyond which a file is said to be coarse, and beyond which positions are written as doubles.
COARSE, FINE = 1e-4, 1e-6
KNOWN = {"x", "y", "z", "nx", "ny", "nz"}
UV = (("u", "v"), ("s", "t"), ("texture_u", "texture_v"))


class Element(NamedTuple):
    """A kind of thing in the file: how many, and name -> type, a list's type as (count's type, items' type)."""

    name: str
    n: int
    properties: dict[str, str | tuple[str, str]]

    @property
    def smallest(self) -> int:
        """Bytes of the smallest binary row."""
        types = [t if isinstance(t, str) else t[0] for t in self.properties.values()]
        return sum(int(t[-1]) for t in types)


def read_ply(path: Path) -> Mesh:
    """The mesh as it stands in the file; raises `FormatError` for anything that does not hold together."""
    data = path.read_bytes()
    end = re.search(rb"end_header[ \t]*\r?\n", data[:HEADER])
    if not data.startswith(b"ply") or end is None:
        raise FormatError(f"{path} is not a PLY file: it has no header of one", "Export it again")
    kind, elements = _header(path, data[: end.start()].decode("ascii", "replace"))
    body = data[end.end() :]
    named = {element.name: element for element in elements}
    if not {"vertex", "face"} <= set(named):
        raise FormatError(
            f"{path} holds {', '.join(named) or 'nothing'}", "A mesh needs the elements vertex and face, in a PLY file"
        )
    for element in elements:  # before anything is allocated
        least = element.smallest if kind != "ascii" else 2 * len(element.properties)
        if element.n * max(least, 1) > len(body) + 1:
            raise FormatError(
                f"{path} claims {element.n} of {element.name}, more than its {len(body)} bytes hold",
                "The file is truncated; fetch it again",
            )
    rows = (_ascii if kind == "ascii" else _binary)(path, body, elements, ">" if "big" in kind else "<")
    vertex, faces = rows["vertex"], rows["face"]
    if not all(axis in vertex for axis in "xyz"):
        raise FormatError(f"{path} has no x, y, z", f"Its vertices have {', '.join(vertex)[:100]}")
    names = set(vertex)
    uv_names = next((pair for pair in UV if set(pair) <= names), None)
    used = KNOWN | set(uv_names or ())

    def together(*columns: str) -> NDArray[np.float64]:
        return np.stack([reading.doubles(np.asarray(vertex[c])) for c in columns], axis=-1)

    return Mesh(
        positions=together("x", "y", "z"),
        triangles=faces["triangles"],
        normals=together("nx", "ny", "nz") if {"nx", "ny", "nz"} <= names else None,
        uv=together(*uv_names) if uv_names else None,
        attributes={name: reading.doubles(np.asarray(vertex[name])) for name in vertex if name not in used},
        name=path.stem,
        notes=_rounded(path, vertex),
    )


def _rounded(path: Path, vertex: dict[str, Any]) -> tuple[str, ...]:
    """Coordinates far from the origin in single precision have lost their digits already where the file was written."""
    if any(np.asarray(vertex[axis]).dtype.itemsize > 4 for axis in "xyz") or not len(vertex["x"]):
        return ()
    low, high = (reading.doubles(np.array([f(vertex[axis]) for axis in "xyz"])) for f in (np.min, np.max))
    far, extent = np.abs([low, high]).max(), np.linalg.norm(high - low)
    if not np.isfinite(far) or np.spacing(np.float32(far)) < COARSE * extent:
        return ()
    return (
        f"the file's coordinates reach {far:.6g} in single precision, which tells places apart only from {np.spacing(np.float32(far)):.2g} on "
        f"(the mesh is {extent:.3g} large); export double precision, or move the mesh to the origin first",
    )


def _header(path: Path, text: str) -> tuple[str, list[Element]]:
    kind, elements = "", []
    for line in text.splitlines()[1:]:
        words = line.split()
        try:
            match words:
                case ["format", kind, _] if kind in ("ascii", "binary_little_endian", "binary_big_endian"):
                    pass
                case ["element", name, count] if int(count) >= 0:
                    elements.append(Element(name, int(count), {}))
                case ["property", "list", counts, items, name]:
                    whole = TYPES[counts][0] != "f" and (name not in _FACE_LISTS or TYPES[items][0] != "f")
                    if not whole or name in elements[-1].properties:
                        raise ValueError
                    elements[-1].properties[name] = (TYPES[counts], TYPES[items])
                case ["property", type_, name]:
                    if name in elements[-1].properties:
                        raise ValueError
                    elements[-1].properties[name] = TYPES[type_]
                case [] | ["comment", *_] | ["obj_info", *_]:
                    pass
                case _:
                    raise ValueError
        except (ValueError, KeyError, IndexError):
            raise FormatError(
                f"{path} has a header with the line {line[:60]!r}", "It is not one of a PLY file"
            ) from None
    if not kind:
        raise FormatError(f"{path} does not say its format", "ascii, binary_little_endian and binary_big_endian exist")
    return kind, elements


def _damaged(path: Path, what: str) -> FormatError:
    return FormatError(f"{path} ends or breaks off within its {what}", "The file is damaged; fetch it again")


def _fan(polygon: NDArray[Any]) -> NDArray[np.int64]:
    """Triangles (n - 2, 3) of a polygon with n corners; none for two or fewer."""
    corners = np.asarray(polygon, np.int64)
    middle = np.arange(1, max(len(corners) - 1, 1))
    return (
        np.stack([np.full_like(middle, corners[0]), corners[middle], corners[middle + 1]], 1) if len(middle) else _NONE
    )


_NONE = np.zeros((0, 3), np.int64)
#: What whole numbers and the gaps between them are written with.
_WHOLE = frozenset("0123456789+- \t")
_FACE_LISTS = ("vertex_indices", "vertex_index")


def _as_triangles(path: Path, polygons: list[NDArray[Any]]) -> NDArray[np.int32]:
    triangles = np.concatenate([_NONE, *(_fan(p) for p in polygons)])
    return _in_int32(path, triangles)


def _in_int32(path: Path, triangles: NDArray[Any]) -> NDArray[np.int32]:
    if triangles.size and (triangles.max() > 2**31 - 1 or triangles.min() < 0):
        raise FormatError(f"{path} has a face with vertex {triangles.max()}", "The file is damaged; fetch it again")
    return triangles.astype(np.int32)


def _ascii(path: Path, body: bytes, elements: list[Element], _: str) -> dict[str, dict[str, Any]]:
    lines = [line for line in body.decode("ascii", "replace").splitlines() if line.strip()]
    rows: dict[str, dict[str, Any]] = {}
    at = 0
    for element in elements:
        own, at = lines[at : at + element.n], at + element.n
        lists = any(not isinstance(t, str) for t in element.properties.values())
        try:
            if len(own) < element.n:
                raise ValueError
            if not lists:
                table = np.loadtxt(own, comments=None, ndmin=2) if own else np.zeros((0, len(element.properties)))
                columns = zip(element.properties, table.T, strict=True)
                rows[element.name] = dict(columns)
            elif element.name == "face":
                rows["face"] = {"triangles": _ascii_faces(path, element, own)}
        except (ValueError, IndexError, OverflowError):
            raise _damaged(path, f"{element.name}s") from None
    return rows


def _ascii_faces(path: Path, element: Element, lines: list[str]) -> NDArray[np.int32]:
    """Nearly all files have triangles alone, and nothing else in a face: read at once."""
    if len(element.properties) == 1 and next(iter(element.properties)) in _FACE_LISTS and lines:
        table = np.zeros((0, 0), np.int64)
        # Older versions of NumPy read 0.2 as the vertex 0, with a warning.
        if set("".join(lines)) <= _WHOLE:
            with contextlib.suppress(ValueError):  # polygons of several sizes, or a mistake
                table = np.loadtxt(lines, np.int64, comments=None, ndmin=2)
        if table.shape == (len(lines), 4) and (table[:, 0] == 3).all():
            return _in_int32(path, table[:, 1:])
    return _as_triangles(path, [_ascii_polygon(element, line) for line in lines])


def _ascii_polygon(element: Element, line: str) -> NDArray[np.int64]:
    words, at = line.split(), 0
    polygon: NDArray[np.int64] | None = None
    for name, type_ in element.properties.items():
        if isinstance(type_, str):
            at += 1
            continue
        count = int(words[at])
        if name in _FACE_LISTS:
            polygon = np.array([int(w) for w in words[at + 1 : at + 1 + count]], np.int64)
            if len(polygon) != count:
                raise ValueError
        at += 1 + count
    if polygon is None:
        raise ValueError
    return polygon


def _binary(path: Path, body: bytes, elements: list[Element], order: str) -> dict[str, dict[str, Any]]:
    rows: dict[str, dict[str, Any]] = {}
    at = 0
    for element in elements:
        scalars = {name: order + t for name, t in element.properties.items() if isinstance(t, str)}
        if len(scalars) == len(element.properties):
            dtype = np.dtype(list(scalars.items()))
            if at + element.n * dtype.itemsize > len(body):
                raise _damaged(path, f"{element.name}s")
            table = np.frombuffer(body, dtype, element.n, at) if element.n else np.zeros(0, dtype)
            rows[element.name] = {name: table[name] for name in scalars}
            at += element.n * dtype.itemsize
        else:
            polygons, at = _binary_lists(path, body, element, order, at)
            if element.name == "face":
                rows["face"] = {"triangles": polygons}
        if {"vertex", "face"} <= set(rows):
            break  # what follows is of no use here
    return rows


def _binary_lists(path: Path, body: bytes, element: Element, order: str, at: int) -> tuple[NDArray[np.int32], int]:
    """The triangles of an element with lists, and where it ends."""
    if element.name == "face" and not any(name in _FACE_LISTS for name in element.properties):
        raise FormatError(f"{path} has faces without vertex_indices", "Export it again")
    # Nearly all files have triangles alone: rows of one size, read at once.
    fields: list[tuple[str, Any]] = []
    for name, t in element.properties.items():
        fields += [(name, order + t)] if isinstance(t, str) else [("#" + name, order + t[0]), (name, (order + t[1], 3))]
    dtype = np.dtype(fields)
    if at + element.n * dtype.itemsize <= len(body):
        table = np.frombuffer(body, dtype, element.n, at) if element.n else np.zeros(0, dtype)
        if all((table["#" + name] == 3).all() for name, t in element.properties.items() if not isinstance(t, str)):
            wanted = next((name for name in _FACE_LISTS if name in element.properties), None)
            indices = table[wanted].astype(np.int64) if wanted else _NONE
            return _in_int32(path, indices), at + element.n * dtype.itemsize
    polygons: list[NDArray[Any]] = []
    for _ in range(element.n):
        for name, t in element.properties.items():
            if isinstance(t, str):
                at += int(t[-1])
                continue
            if at + int(t[0][-1]) > len(body):
                raise _damaged(path, f"{element.name}s")
            count = int(np.frombuffer(body, order + t[0], 1, at)[0])
            at += int(t[0][-1])
            if count < 0 or at + count * int(t[1][-1]) > len(body):
                raise _damaged(path, f"{element.name}s")
            if name in _FACE_LISTS:
                polygons.append(np.frombuffer(body, order + t[1], count, at))
            at += count * int(t[1][-1])
    return _as_triangles(path, polygons), at


def write_ply(path: str | os.PathLike[str], mesh: Mesh, comments: tuple[str, ...] = ()) -> Path:
    """Write a mesh as binary little-endian PLY, whole or not at all.

    Numbers are float32; positions are doubles where float32 would lose digits that matter, far from the origin.

    Texture coordinates are called u and v, as Mitsuba and Blender read them; attributes keep their names.

    Raises
    ------
    MotesError
        When the file cannot be written.
    """
    columns: dict[str, NDArray[Any]] = dict(zip("xyz", mesh.positions.T, strict=True))
    if mesh.normals is not None:
        columns.update(zip(("nx", "ny", "nz"), mesh.normals.T, strict=True))
    if mesh.uv is not None:
        columns.update(zip("uv", mesh.uv.T, strict=True))
    columns.update({re.sub(r"\W", "_", name, flags=re.ASCII): v for name, v in mesh.attributes.items()})
    far = np.abs(mesh.positions).max(initial=0.0)
    double = far > 0 and 2.0**-24 * far > FINE * np.linalg.norm(np.ptp(mesh.positions, axis=0))
    wide = set("xyz") if double else set()
    table = np.zeros(len(mesh.positions), [(name, "<f8" if name in wide else "<f4") for name in columns])
    for name, values in columns.items():
        table[name] = values
    faces = np.zeros(len(mesh.triangles), [("n", "u1"), ("corners", "<i4", 3)])
    faces["n"], faces["corners"] = 3, mesh.triangles
    header = [
        "ply",
        "format binary_little_endian 1.0",
        *(f"comment {c.encode('ascii', 'replace').decode()}" for text in comments for c in text.splitlines()),
        f"element vertex {len(table)}",
        *(f"property {'double' if name in wide else 'float'} {name}" for name in columns),
        f"element face {len(faces)}",
        "property list uchar int vertex_indices",
        "end_header\n",
    ]
    with replacing(path) as temporary:
        temporary.write_bytes("\n".join(header).encode("ascii") + table.tobytes() + faces.tobytes())
    return Path(path)
