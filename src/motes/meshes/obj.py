"""Wavefront OBJ files: positions, texture coordinates, normals and faces; materials, groups, lines and curves are passed over.

Nothing that a file points to is opened.  Lines of one kind go through NumPy's reader at once where they are all alike, which most are; what is not,
such as faces that count backwards, is read line by line, and so is a file with a mistake, to say in which line it is.
"""

from __future__ import annotations

import codecs
from array import array
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError
from motes.files import budget
from motes.meshes.mesh import Mesh

#: What the numbers of a corner are, by `_way`: of `_SIZES` the first, second, third.
WRITTEN = {(0, False, False): (0,), (1, False, False): (0, 1), (2, False, False): (0, 1, 2), (2, True, False): (0, 2)}
#: Bytes that a line takes, with its own numbers, and a corner of a face, as measured.
LINE, CORNER = 120, 60
FACES = 20_000  # that are split into words at a time
Corner = tuple[int, int, int]
_SIZES = {"v": 3, "vt": 2, "vn": 3}
_MARKS = ((codecs.BOM_UTF8, "utf-8-sig"), (codecs.BOM_UTF16_LE, "utf-16"), (codecs.BOM_UTF16_BE, "utf-16"))


def read_obj(path: Path) -> Mesh:
    """The mesh as it stands in the file, polygons as fans of triangles; raises `FormatError` with the line that is wrong."""
    data = path.read_bytes()
    encoding = next((name for mark, name in _MARKS if data.startswith(mark)), "utf-8")
    lines = data.decode(encoding, "replace").replace("\r\n", "\n").replace("\r", "\n").replace("\\\n", " ").split("\n")
    _check(path, data, lines)
    del data
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


def _check(path: Path, data: bytes, lines: list[str]) -> None:
    """Refuse what would take more memory than a file may."""
    corners = sum(len(line.split()) - 1 for line in lines if line.lstrip()[:1] == "f")
    needed = 2 * len(data) + LINE * len(lines) + CORNER * corners
    budget.check(path, needed, f"its {len(lines):,} lines and {corners:,} corners", len(data))


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
    places = WRITTEN.get(_way(faces[0].split()[0])) if faces[0].strip() else None
    if places is None or counts.min() < 3:
        return None
    sizes = [len(arrays[kind]) for kind in _SIZES]
    if np.prod([float(n + 1) for n in sizes]) > 2**62:
        return None
    key = np.empty(
        int(counts.sum()), np.int64
    )  # of a corner: its position, texture coordinate and normal in one number
    at = 0
    for some in range(0, len(faces), FACES):
        words = " ".join(faces[some : some + FACES]).split()
        if any(WRITTEN.get(_way(word)) != places for word in words):
            return None
        words = " ".join(words).replace("/", " ").split()
        given = np.array(words, np.int64).reshape(-1, len(places)) - 1
        if (given < 0).any() or any((column >= sizes[k]).any() for k, column in zip(places, given.T, strict=True)):
            raise IndexError
        key[at : at + len(given)] = 0
        for k, n in enumerate(sizes):
            column = given[:, places.index(k)] if k in places else -1
            key[at : at + len(given)] = key[at : at + len(given)] * (n + 1) + column + 1
        at += len(given)
    _, first, inverse = np.unique(key, return_index=True, return_inverse=True)
    order = np.argsort(first, kind="stable")  # vertices in the order in which faces name them
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    rest, found = key[first[order]], []
    for n in reversed(sizes):
        found.append(rest % (n + 1) - 1)
        rest = rest // (n + 1)
    del key, first
    return arrays, np.stack(found[::-1], axis=1), fans(counts, rank[inverse.reshape(-1)])


def _way(corner: str) -> tuple[int, bool, bool]:
    """How a corner is written: with how many slashes, with two in a row, counting backwards."""
    return corner.count("/"), "//" in corner, "-" in corner


def fans(counts: NDArray[np.int64], corners: NDArray[np.int64]) -> NDArray[np.int64]:
    """Triangles (F, 3) of polygons with so many corners each, which follow one another in `corners`."""
    start = np.cumsum(counts) - counts
    each = np.maximum(counts - 2, 0)
    polygon = np.repeat(np.arange(len(counts)), each)
    step = np.arange(each.sum()) - np.repeat(np.cumsum(each) - each, each)
    at = start[polygon]
    return np.stack([corners[at], corners[at + step + 1], corners[at + step + 2]], axis=1)


def _line_by_line(path: Path, lines: list[str]) -> Parsed:
    tables = {kind: array("d") for kind in _SIZES}
    found: dict[Corner, int] = {}
    triangles = array("q")
    for number, line in enumerate(lines, 1):
        words = line.partition("#")[0].split()
        if not words:
            continue
        kind = words[0]
        try:
            if kind in tables:
                given = [float(w) for w in words[1 : 1 + _SIZES[kind]]]
                if len(given) != _SIZES[kind]:
                    raise ValueError
                tables[kind].extend(given)
            elif kind == "f":
                sizes = [len(tables[each]) // n for each, n in _SIZES.items()]
                corners = [found.setdefault(_corner(w, sizes), len(found)) for w in words[1:]]
                if len(corners) < 3:
                    raise ValueError
                for k in range(1, len(corners) - 1):
                    triangles.extend((corners[0], corners[k], corners[k + 1]))
        except (ValueError, IndexError):
            raise FormatError(
                f"{path} has in line {number} {line.strip()[:60]!r}", "That is not OBJ; export it again"
            ) from None
    index = np.array(list(found), np.int64).reshape(-1, 3)  # position, texture, normal; -1 where there is none
    arrays = {kind: np.array(rows).reshape(-1, _SIZES[kind]) for kind, rows in tables.items()}
    return arrays, index, np.array(triangles, np.int64).reshape(-1, 3)


def _corner(word: str, sizes: list[int]) -> Corner:
    """``7``, ``7/3``, ``7//5`` or ``7/3/5`` as indices from 0; negative ones count from the last line so far."""
    parts = (*word.split("/"), "", "")[:3]
    indices = []
    for k, (part, n) in enumerate(zip(parts, sizes, strict=True)):
        if not part and k > 0:
            indices.append(-1)
            continue
        given = int(part)
        at = given - 1 if given > 0 else n + given
        if not 0 <= at < n or given == 0:
            raise IndexError
        indices.append(at)
    return indices[0], indices[1], indices[2]
