"""Wavefront OBJ files: positions, texture coordinates, normals and faces; materials, groups, lines and curves are passed over."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError
from motes.meshes.mesh import Mesh

Corner = tuple[int, int, int]
_SIZES = {"v": 3, "vt": 2, "vn": 3}


def read(path: Path) -> Mesh:
    """The mesh as it stands in the file, polygons as fans of triangles; raises `FormatError` with the line that is wrong."""
    tables: dict[str, list[list[float]]] = {"v": [], "vt": [], "vn": []}
    found: dict[Corner, int] = {}
    triangles: list[tuple[int, int, int]] = []
    text = path.read_text(encoding="utf-8", errors="replace").replace("\\\n", " ")
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split()
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
    if not triangles:
        raise FormatError(f"{path} holds no faces", "Export the mesh with its faces as an OBJ file")
    index = np.array(list(found), np.int64)  # (corners, 3): position, texture, normal; -1 where there is none
    arrays = {kind: np.array(rows, np.float64).reshape(-1, _SIZES[kind]) for kind, rows in tables.items()}

    def picked(kind: str, column: int) -> NDArray[np.float64] | None:
        return arrays[kind][index[:, column]] if (index[:, column] >= 0).all() else None

    positions = picked("v", 0)
    assert positions is not None  # `_corner` has seen to it
    return Mesh(positions, np.array(triangles, np.int32), picked("vn", 2), picked("vt", 1), name=path.stem)


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
