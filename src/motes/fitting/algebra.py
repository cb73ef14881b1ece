"""What the steps of a fit are written in, so that the same text runs over NumPy and is printed into kernels.

Many fits of one kind advance side by side, a *lane* each.  A vector has the parameters on its first axis and the lanes on
the last: (P, B) for NumPy, (P,) formulas where a kernel is printed, whose lanes are the vector registers.  What is one
number a lane is (B,), or (1,) formulas.  Nothing branches from lane to lane: conditions are values (1.0 for true), chosen
with `where`.  Arithmetic is written with operators; the rest goes through an `Algebra`.
"""

from __future__ import annotations

import math
from typing import Any, Protocol

import numpy as np

from motes import workers
from motes.arrays import Array

# Pivots of a correlation matrix below this are rounding.
LEAST_PIVOT = 1e-13


class Algebra(Protocol):
    """Operations over lanes; matrices are (P, P, B), or (P, P) formulas, and symmetric."""

    def less(self, a: Array, b: Array) -> Array:
        """Conditions a < b, for `where`; false where either is NaN."""

    def where(self, condition: Array, a: Array, b: Array) -> Array: ...

    def maximum(self, a: Array, b: Array) -> Array: ...

    def minimum(self, a: Array, b: Array) -> Array: ...

    def sqrt(self, a: Array) -> Array: ...

    def total(self, vector: Array) -> Array:
        """The sum over the parameters: (P, B) to (B,)."""

    def largest(self, vector: Array) -> Array:
        """The largest over the parameters."""

    def diagonal(self, matrix: Array) -> Array:
        """(P, P, B) to (P, B)."""

    def times(self, matrix: Array, vector: Array) -> Array:
        """The product of a matrix and a vector."""

    def solve(self, matrix: Array, right: Array) -> Array:
        """The solution of matrix solution = right, for a positive matrix with a diagonal of about 1."""

    def scale(self, diagonal: Array) -> Array:
        """What `damped` takes of a diagonal."""

    def damped(self, matrix: Array, right: Array, free: Array, damping: Array, scale: Array) -> Array:
        """The solution of (matrix + damping diagonal) solution = right for what is free (1 or 0), 0 elsewhere; the diagonal is that which `scale` was given."""

    def inverse(self, matrix: Array) -> Array:
        """The inverse of a positive matrix with a diagonal of 1; where it is singular, of size 1/`LEAST_PIVOT` along what is missing."""

    def sandwich(self, inverse: Array, middle: Array) -> Array:
        """inverse middle inverse."""


def absolute(algebra: Algebra, a: Array) -> Array:
    """|a|."""
    return np.abs(a) if _is_numbers(a) else algebra.maximum(a, -a)


def flag(algebra: Algebra, condition: Array) -> Array:
    """A condition as a number, 1 or 0: of arrays as it is, since truth values multiply and compare as numbers do."""
    return condition if _is_numbers(condition) else algebra.where(condition, 1.0, 0.0)


def chosen(algebra: Algebra, among: Array, a: Array, b: Array) -> Array:
    """`a` where a flag is 1, else `b`."""
    truths = _is_numbers(among) and among.dtype == np.bool_
    return algebra.where(among if truths else algebra.less(0.5, among), a, b)


def _is_numbers(a: Array) -> bool:
    """Whether operations run at once, over arrays; formulas are arrays of objects."""
    return isinstance(a, np.ndarray) and a.dtype != np.object_


def outer(vector: Array) -> Array:
    """The matrix of all products of two entries."""
    return vector[:, None] * vector[None, :]


def with_diagonal(matrix: Array, diagonal: Array) -> Array:
    """A copy of the matrix with another diagonal."""
    result = matrix.copy()
    if _is_numbers(matrix):
        result.reshape(-1, result.shape[2])[:: len(result) + 1] = diagonal
        return result
    for k in range(len(result)):
        result[k, k] = diagonal[k]
    return result


class Arrays:
    """The algebra of NumPy arrays; LAPACK solves."""

    less = staticmethod(np.less)
    where = staticmethod(np.where)
    maximum = staticmethod(np.maximum)
    minimum = staticmethod(np.minimum)
    sqrt = staticmethod(np.sqrt)

    def total(self, vector: Array) -> Array:
        return np.add.reduce(vector, axis=0)

    def largest(self, vector: Array) -> Array:
        return np.maximum.reduce(vector, axis=0, initial=0.0)

    def diagonal(self, matrix: Array) -> Array:
        return matrix.diagonal().T

    def times(self, matrix: Array, vector: Array) -> Array:
        return np.einsum("pqb,qb->pb", matrix, vector)

    def solve(self, matrix: Array, right: Array) -> Array:
        matrices, rights = matrix.transpose(2, 0, 1), right.T
        try:
            solved: Any = np.linalg.solve(matrices, rights[..., None])[..., 0]
        except np.linalg.LinAlgError:  # exactly singular, or not finite: the smallest solution
            solved = np.stack([_smallest(a, b) for a, b in zip(matrices, rights, strict=True)])
        if not math.isfinite(np.add.reduce(solved, axis=None)):
            solved = np.where(np.isfinite(solved), solved, rights)
        return solved.T

    def scale(self, diagonal: Array) -> Array:
        """Parameters at which the matrix has a diagonal of 1."""
        return np.asarray(1.0 / np.sqrt(diagonal))

    def damped(self, matrix: Array, right: Array, free: Array, damping: Array, scale: Array) -> Array:
        scaling = scale * free
        scaled = with_diagonal(matrix * outer(scaling), 1.0 + free * damping)
        return self.solve(scaled, right * scaling) * scale

    def inverse(self, matrix: Array) -> Array:
        size = len(matrix)
        ridge = LEAST_PIVOT * np.eye(size)
        finite = np.nan_to_num(np.moveaxis(matrix, 2, 0), posinf=0.0, neginf=0.0) + ridge
        with workers.alone():
            return np.moveaxis(np.linalg.pinv(finite, rcond=1e-16, hermitian=True), 0, 2)

    def sandwich(self, inverse: Array, middle: Array) -> Array:
        i, m = np.moveaxis(inverse, 2, 0), np.moveaxis(middle, 2, 0)
        return np.moveaxis(i @ m @ i, 0, 2)


def pseudo_inverse(matrix: Array, unit: Array, rcond: float) -> Array:
    """The pseudo-inverse of symmetric matrices (..., P, P), whose eigenvalues are compared in units (P,) of the parameters."""
    square = np.outer(unit, unit)
    with workers.alone():
        return np.asarray(np.linalg.pinv(matrix * square, rcond=rcond, hermitian=True) * square)


def _smallest(matrix: Array, right: Array) -> Array:
    if not (np.isfinite(matrix).all() and np.isfinite(right).all()):
        return np.full(len(right), np.nan)
    return np.linalg.lstsq(matrix, right, rcond=1e-12)[0]


ARRAYS = Arrays()
