"""Wavefront OBJ files: positions, texture coordinates, normals and faces; materials, groups, lines and curves are passed over.

Nothing that a file points to is opened.  Lines of one kind go through NumPy's reader at once where they are all alike, which most are; what is not,
such as faces that count backwards, is read line by line, and so is a file with a mistake, to say in which line it is.
"""

from __future__ import annotations

import codecs
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError
from motes.meshes.mesh import Mesh

Corner = tuple[int, int, int]
_SIZES = {"v": 3, "vt": 2, "vn": 3}
_MARKS = ((codecs.BOM_UTF8, "utf-8-sig"), (codecs.BOM_UTF16_LE, "utf-16"), (codecs.BOM_UTF16_BE, "utf-16"))


def read_obj(path: Path) -> Mesh:
    """The mesh as it stands in the file, polygons as fans of triangles; raises `FormatError` with the line that is wrong."""
    data = path.read_bytes()
    encoding = next((name for mark, name in _MARKS if data.startswith(mark)), "utf-8")
    lines = data.decode(encoding, "replace").replace("\r\n", "\n").replace("\r", "\n").replace("\\\n", " ").split("\n")
    try:
        found = _at_once(lines)
    except (ValueError, IndexError, OverflowError):
        found = None
    arrays, index, triangles = found or _line_by_line(path, lines)
    if not len(triangles):
        raise FormatError(f"{path} holds no faces", "Export the mesh with its faces as an OBJ file")

    def picked(kind: str, column: int) -> NDArray[np.float64] | None:
        return arrays[kind][index[:, column]] if (index[:, column] >= 0).all() else None

    positions = picked("v", 0)
    assert positions is not None  # both readers have seen to it
    return Mesh(positions, triangles.astype(np.int32), picked("vn", 2), picked("vt", 1), name=path.stem)


Parsed = tuple[dict[str, NDArray[np.float64]], NDArray[np.int64], NDArray[np.int64]]


def _at_once(lines: list[str]) -> Parsed | None:
    """Tables, corners (K, 3) and triangles (F, 3) of a file whose faces are all written alike; None for others, ValueError for mistakes."""
    arrays = {}
    for kind, size in _SIZES.items():
        own = [line for line in lines if line.startswith(f"{kind} ")]
        columns = tuple(range(1, size + 1))
        arrays[kind] = np.loadtxt(own, usecols=columns, ndmin=2) if own else np.zeros((0, size))
    faces = [line.partition("#")[0][2:] for line in lines if line.startswith("f ")]
    # Indented lines, tabs and what else splits differently: not alike.
    kinds = tuple(f"{kind} " for kind in (*_SIZES, "f"))
    others = (line.split() for line in lines if line[:1] in ("\t", " ", "v", "f") and not line.startswith(kinds))
    unlike = any(words and words[0] in ("v", "vt", "vn", "f") for words in others)
    if not faces or unlike:
        return None
    counts = np.array([len(face.split()) for face in faces])
    text = " ".join(faces)
    corners, slashes, doubled = int(counts.sum()), text.count("/"), text.count("//")
    shape = {(0, 0): (0,), (corners, 0): (0, 1), (2 * corners, 0): (0, 1, 2), (2 * corners, corners): (0, 2)}
    places = shape.get((slashes, doubled))
    if "-" in text or places is None or counts.min() < 3:
        return None
    numbers = np.array(text.replace("/", " ").split(), np.int64)
    given = numbers.reshape(corners, len(places)) - 1
    index = np.full((corners, 3), -1, np.int64)
    index[:, places] = given
    sizes = [len(arrays[kind]) for kind in _SIZES]
    if (given < 0).any() or any((index[:, k] >= sizes[k]).any() for k in places):
        raise IndexError
    key = index[:, 0]
    for k in (1, 2):
        key = key * (sizes[k] + 1) + index[:, k] + 1
    if np.prod([float(n + 1) for n in sizes]) > 2**62:
        return None
    _, first, inverse = np.unique(key, return_index=True, return_inverse=True)
    order = np.argsort(first, kind="stable")  # vertices in the order in which faces name them
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return arrays, index[first[order]], fans(counts, rank[inverse.reshape(-1)])


def fans(counts: NDArray[np.int64], corners: NDArray[np.int64]) -> NDArray[np.int64]:
    """Triangles (F, 3) of polygons with so many corners each, which follow one another in `corners`."""
    start = np.cumsum(counts) - counts
    each = np.maximum(counts - 2, 0)
    polygon = np.repeat(np.arange(len(counts)), each)
    step = np.arange(each.sum()) - np.repeat(np.cumsum(each) - each, each)
    at = start[polygon]
    return np.stack([corners[at], corners[at + step + 1], corners[at + step + 2]], axis=1)


def _line_by_line(path: Path, lines: list[str]) -> Parsed:
    tables: dict[str, list[list[float]]] = {"v": [], "vt": [], "vn": []}
    found: dict[Corner, int] = {}
    triangles: list[tuple[int, int, int]] = []
    for number, line in enumerate(lines, 1):
        words = line.partition("#")[0].split()
        if not words:
            continue
        kind = words[0]
        try:
            if kind in tables:
                tables[kind].append([float(w) for w in words[1 : 1 + _SIZES[kind]]])
                if len(tables[kind][-1]) != _SIZES[kind]:
                    raise ValueError
            elif kind == "f":
                corners = [found.setdefault(_corner(w, tables), len(found)) for w in words[1:]]
                if len(corners) < 3:
                    raise ValueError
                triangles += [(corners[0], corners[k], corners[k + 1]) for k in range(1, len(corners) - 1)]
        except (ValueError, IndexError):
            raise FormatError(
                f"{path} has in line {number} {line.strip()[:60]!r}", "That is not OBJ; export it again"
            ) from None
    index = np.array(list(found), np.int64).reshape(-1, 3)  # position, texture, normal; -1 where there is none
    arrays = {kind: np.array(rows, np.float64).reshape(-1, _SIZES[kind]) for kind, rows in tables.items()}
    return arrays, index, np.array(triangles, np.int64).reshape(-1, 3)


def _corner(word: str, tables: dict[str, list[list[float]]]) -> Corner:
    """``7``, ``7/3``, ``7//5`` or ``7/3/5`` as indices from 0; negative ones count from the last line so far."""
    parts = (*word.split("/"), "", "")[:3]
    indices = []
    for part, kind in zip(parts, tables, strict=True):
        if not part and kind != "v":
            indices.append(-1)
            continue
        n, given = len(tables[kind]), int(part)
        k = given - 1 if given > 0 else n + given
        if not 0 <= k < n or given == 0:
            raise IndexError
        indices.append(k)
    return indices[0], indices[1], indices[2]
