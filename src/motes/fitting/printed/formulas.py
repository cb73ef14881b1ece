"""The algebra of fits (`motes.fitting.algebra`) over formulas: its steps, recorded, become functions of rows.

Vectors are object arrays of symbols (P,), matrices (P, P), what is one number a lane (1,).  Everything is written out: for the dozen coefficients of a
texel that is shorter to compile than loops, and several times as fast.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.fitting.algebra import LEAST_PIVOT, outer, with_diagonal
from motes.graph.symbols import Graph, Symbol

Formula = NDArray[np.object_]
# Pivots of a damped correlation matrix below this are rounding, in sums that are made in float32.
LEAST_DAMPED_PIVOT = 1e-9


def packed(row: int, column: int) -> int:
    """Where an element of a symmetric matrix stands among the rows of its lower triangle."""
    row, column = max(row, column), min(row, column)
    return row * (row + 1) // 2 + column


class Formulas:
    """The algebra over symbols of a graph."""

    def __init__(self) -> None:
        self.graph = graph = Graph()
        self.less = self._each(lambda a, b: a < b, 2)
        self.where = self._each(graph.where, 3)
        self.maximum = self._each(graph.maximum, 2)
        self.minimum = self._each(graph.minimum, 2)
        self.sqrt = self._each(graph.sqrt, 1)

    def _each(self, function: Callable[..., Symbol], arguments: int) -> Callable[..., Any]:
        lift = self.graph.lift
        each: Callable[..., Any] = np.frompyfunc(lambda *items: function(*map(lift, items)), arguments, 1)
        return each

    # ------------------------------------------------------------ leaves

    def vector(self, name: str, count: int) -> Formula:
        """Leaves (count,)."""
        return np.array([self.graph.leaf(f"{name}[{k}]") for k in range(count)] or [], object)

    def number(self, name: str) -> Formula:
        """One leaf (1,)."""
        return np.array([self.graph.leaf(name)], object)

    def matrix(self, name: str, size: int, apart: Collection[int] = ()) -> Formula:
        """A symmetric matrix of leaves, which stand packed in rows; it is 0 where parameters are `apart` (packed)."""
        triangle = self.vector(name, size * (size + 1) // 2)
        triangle[list(apart)] = self.graph.constant(0.0)
        return np.array([[triangle[packed(i, j)] for j in range(size)] for i in range(size)], object)

    def numbers(self, values: NDArray[Any]) -> Formula:
        """Constants (P,)."""
        return np.array([self.graph.constant(float(v)) for v in values], object)

    def lifted(self, formula: Any) -> list[Symbol]:
        """The entries of a vector as symbols."""
        return [self.graph.lift(item) for item in np.atleast_1d(formula)]

    # ------------------------------------------------------------ the algebra

    def total(self, vector: Formula) -> Formula:
        result = vector[0]
        for item in vector[1:]:
            result = result + item
        return np.array([result], object)

    def largest(self, vector: Formula) -> Formula:
        result = self.graph.lift(vector[0])
        for item in vector[1:]:
            result = self.graph.maximum(result, item)
        return np.array([result], object)

    def diagonal(self, matrix: Formula) -> Formula:
        return np.array([matrix[k, k] for k in range(len(matrix))], object)

    def times(self, matrix: Formula, vector: Formula) -> Formula:
        return np.array([self.total(row * vector)[0] for row in matrix], object)

    def scale(self, diagonal: Formula) -> Formula:
        """The diagonal itself: roots of it, and products with them, would take half as long as the solution."""
        return diagonal

    def damped(self, matrix: Formula, right: Formula, free: Formula, damping: Formula, scale: Formula) -> Formula:
        within = with_diagonal(matrix * outer(free), scale * (1.0 + free * damping))
        return self._solved(within, right * free, LEAST_DAMPED_PIVOT * scale)

    def solve(self, matrix: Formula, right: Formula) -> Formula:
        return self._solved(matrix, right, np.array([self.graph.constant(LEAST_DAMPED_PIVOT)] * len(right), object))

    def _solved(self, matrix: Formula, right: Formula, least: Formula) -> Formula:
        """By L D L', with pivots of at least `least`."""
        size = len(right)
        rows: list[list[Any]] = []
        inverse: list[Any] = []
        z: list[Any] = []
        for i in range(size):
            row: list[Any] = []
            for j in range(i):
                a = matrix[i, j]
                for k in range(j):
                    a = a - row[k] * rows[j][k]
                row.append(a)
            pivot = matrix[i, i]
            unit = [a * inverse[k] for k, a in enumerate(row)]
            for a, u in zip(row, unit, strict=True):
                pivot = pivot - a * u
            rows.append(unit)
            inverse.append(1 / self.graph.maximum(pivot, least[i]))
            a = right[i]
            for k in range(i):
                a = a - unit[k] * z[k]
            z.append(a)
        solved: list[Any] = [0.0] * size
        for i in reversed(range(size)):
            a = z[i] * inverse[i]
            for k in range(i + 1, size):
                a = a - rows[k][i] * solved[k]
            solved[i] = a
        return np.array(solved, object)

    def inverse(self, matrix: Formula) -> Formula:
        """By Cholesky's L, whose pivots are at least `motes.fitting.algebra.LEAST_PIVOT`."""
        graph, size = self.graph, len(matrix)
        factor: list[list[Any]] = []  # L, and the inverse of its diagonal
        columns: list[list[Any]] = []  # L^-1
        for i in range(size):
            row: list[Any] = []
            for j in range(i):
                a = matrix[i, j]
                for k in range(j):
                    a = a - row[k] * factor[j][k]
                row.append(a * factor[j][j])
            pivot = matrix[i, i]
            for a in row:
                pivot = pivot - a * a
            unit = 1.0 / graph.sqrt(graph.maximum(pivot, LEAST_PIVOT))
            factor.append([*row, unit])
            inverse = []
            for c in range(i):
                a = row[c] * columns[c][c]
                for k in range(c + 1, i):
                    a = a + row[k] * columns[k][c]
                inverse.append(-(a * unit))
            columns.append([*inverse, unit])
        triangle = []
        for i in range(size):
            for j in range(i + 1):
                a = columns[i][i] * columns[i][j]
                for k in range(i + 1, size):
                    a = a + columns[k][i] * columns[k][j]
                triangle.append(a)
        return np.array([[triangle[packed(i, j)] for j in range(size)] for i in range(size)], object)

    def sandwich(self, inverse: Formula, middle: Formula) -> Formula:
        size = len(inverse)
        rows = [self.times(middle, row) for row in inverse]
        triangle = [self.total(rows[i] * inverse[j])[0] for i in range(size) for j in range(i + 1)]
        return np.array([[triangle[packed(i, j)] for j in range(size)] for i in range(size)], object)


def triangle_of(matrix: Formula) -> list[Any]:
    """The packed lower triangle of a matrix."""
    return [matrix[i, j] for i in range(len(matrix)) for j in range(i + 1)]
