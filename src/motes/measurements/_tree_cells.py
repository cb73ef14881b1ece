"""Tensor trees of Radiance: a BRDF over the unit cube (isotropic) or hypercube, in cells whose size follows it.

A tree is ``{`` values ``}`` for an even grid of 2^(k d) cells, the first coordinate slowest, or ``{`` 2^d trees ``}``,
whose number has bit j set for the upper half of coordinate j.

The coordinates of a direction are those of the square that Shirley and Chiu map onto the unit disk, equal areas to
equal areas, where a direction lies at its (x, y): cells of one size have one projected solid angle.  With d = 3 the
first coordinate is (1 - sin theta_i)/2, of which only the lower half is used, and the outgoing direction is turned so
that the mirror direction lies at +x; with d = 4 it is preceded by that of -wi.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError
from motes.files.structured import number_list

Array = NDArray[np.float64]
DEEPEST = 16  # halvings of an edge: Radiance's own limit
_PART = re.compile(r"[{}]|[^{}]+")


@dataclass(frozen=True, eq=False)
class Leaves:
    """The cells of a tree: their lower corners (n, d), edges (n,), and values (n,)."""

    corner: Array
    edge: Array
    value: Array

    def lookup(self, at: Array) -> Array:
        """The values (m,) of the cells that points (m, d) of the unit cube lie in."""
        result = np.full(len(at), np.nan)
        for edge in np.unique(self.edge):
            cells = np.flatnonzero(self.edge == edge)
            key = _keys(np.floor(self.corner[cells] / edge + 0.5), edge)
            order = np.argsort(key)
            wanted = _keys(np.floor(np.minimum(at, np.nextafter(1, 0)) / edge), edge)
            place = np.minimum(np.searchsorted(key[order], wanted), len(key) - 1)
            found = key[order][place] == wanted
            result[found] = self.value[cells][order][place[found]]
        return result


def _keys(index: Array, edge: float) -> NDArray[np.int64]:
    """One integer a cell of a grid."""
    n = round(1 / edge)
    key = np.zeros(len(index), np.int64)
    for column in index.T:
        key = key * n + column.astype(np.int64)
    return key


def parse(text: str, d: int, where: str) -> Leaves:
    """The leaves of a tree.

    Raises
    ------
    FormatError
        Where braces do not match, a grid has no 2^(k d) values, or halvings go on for more than `DEEPEST`.
    """
    corners: list[Array] = []
    edges: list[Array] = []
    values: list[Array] = []
    # of each open branch: its corner, its edge, the number of its next child
    open_branches: list[tuple[tuple[float, ...], float, int]] = []
    root: tuple[tuple[float, ...], float] | None = ((0.0,) * d, 1.0)
    numbers: Array | None = None
    kind: list[str] = []  # "?" until it is known, then "grid" or "branch"

    def child() -> tuple[tuple[float, ...], float]:
        nonlocal root
        if not open_branches:
            if root is None:
                raise FormatError(f"{where}: there is more than one tree", "Check the file")
            whole, root = root, None
            return whole
        corner, edge, number = open_branches[-1]
        if number >= 2**d:
            raise FormatError(f"{where}: a branch has more than {2**d} parts", "Check the file")
        open_branches[-1] = (corner, edge, number + 1)
        half = edge / 2
        return tuple(c + half * (number >> j & 1) for j, c in enumerate(corner)), half

    for match in _PART.finditer(text):
        part = match[0]
        if part == "{":
            if kind and kind[-1] == "grid":
                raise FormatError(f"{where}: a tree within the values of a grid", "Check the file")
            if kind:
                kind[-1] = "branch"
            if len(kind) > DEEPEST:
                raise FormatError(f"{where}: its cells are halved more than {DEEPEST} times", "The file is damaged")
            corner, edge = child()
            open_branches.append((corner, edge, 0))
            kind.append("?")
            numbers = None
        elif part == "}":
            if not kind:
                raise FormatError(f"{where}: a }} without its {{", "Check the file")
            corner, edge, count = open_branches.pop()
            if kind.pop() == "branch":
                if count != 2**d:
                    raise FormatError(f"{where}: a branch has {count} parts instead of {2**d}", "The file is damaged")
                continue
            n = 0 if numbers is None else len(numbers)
            k = round(np.log2(n) / d) if n else 0
            if n == 0 or n != 2 ** (k * d):
                raise FormatError(
                    f"{where}: a grid of {n} values; a power of {2**d} is needed", "It is truncated or damaged"
                )
            assert numbers is not None
            step = edge / 2**k
            index = np.indices((2**k,) * d).reshape(d, -1).T
            corners.append(np.array(corner) + step * index)
            edges.append(np.full(n, step))
            values.append(numbers)
            numbers = None
        elif part.strip(" \t\r\n,"):
            if not kind or kind[-1] != "?":
                raise FormatError(f"{where}: {part.strip()[:30]!r} outside of a grid", "Check the file")
            kind[-1] = "grid"
            numbers = number_list(part, where)
    if kind or not values:
        raise FormatError(f"{where} is truncated: {len(kind)} {{ are not closed", "Fetch the file again")
    return Leaves(np.concatenate(corners), np.concatenate(edges), np.concatenate(values))


def serialize(grid: Array, tolerance: float) -> str:
    """A tree of an even grid (2^k, ..., 2^k), parts of which are joined where their values differ by little.

    Parameters
    ----------
    grid
        One value a cell.
    tolerance
        Cells are joined into their mean where they all lie within this relative distance of it.
    """
    n = grid.shape[0]
    if n == 1:
        return f"{{{_number(grid.item())}}}"
    mean = float(grid.mean())
    if np.max(np.abs(grid - mean)) <= tolerance * abs(mean):
        return f"{{{_number(mean)}}}"
    if n == 2:
        return "{" + " ".join(_number(value) for value in grid.ravel().tolist()) + "}"
    d, half = grid.ndim, n // 2
    parts = []
    for number in range(2**d):
        where = tuple(slice(half, None) if number >> j & 1 else slice(None, half) for j in range(d))
        parts.append(serialize(grid[where], tolerance))
    return "{\n" + "\n".join(parts) + "\n}"


def _number(value: float) -> str:
    return f"{value:.7g}"


def to_disk(square: Array) -> tuple[Array, Array]:
    """Points x, y of the unit disk from the coordinates (..., 2) of a square (Shirley and Chiu 1997)."""
    a, b = 2 * square[..., 0] - 1, 2 * square[..., 1] - 1
    wide = np.abs(a) > np.abs(b)
    r = np.where(wide, a, b)  # signed: the quarter opposite is the same with both signs turned
    with np.errstate(divide="ignore", invalid="ignore"):
        phi = np.where(wide, np.pi / 4 * b / a, np.pi / 2 - np.pi / 4 * a / b)
    phi = np.where(r == 0, 0.0, phi)
    return r * np.cos(phi), r * np.sin(phi)
