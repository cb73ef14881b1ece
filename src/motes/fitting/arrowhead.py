"""The algebra of a fit of many channels, whose matrices are arrows: nothing of one channel meets another's.

Without its border of shared parameters such a matrix falls into a small block for each channel; the border is taken out by
its Schur complement.  A system of C channels costs C small ones, where a dense solver's work goes with C cubed.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motes.arrays import Array
from motes.fitting.algebra import LEAST_PIVOT, Arrays


@dataclass(frozen=True)
class Arrowhead(Arrays):
    """`Arrays` where a matrix (P, P, B) is an arrow; products are those of dense matrices.

    Parameters
    ----------
    own
        Positions (C, K) in the parameter vector of what belongs to each channel alone.
    shared
        Positions (S,) of the others.
    """

    own: NDArray[np.intp]
    shared: NDArray[np.intp]

    def solve(self, matrix: Array, right: Array) -> Array:
        own, shared = self.own, self.shared
        blocks, border, corner = self._parts(matrix)
        rights = np.moveaxis(right, 1, 0)  # (B, P)
        try:
            reduced = np.linalg.solve(blocks, np.concatenate([border, rights[:, own, None]], axis=3))
            back, forward = reduced[..., :-1], reduced[..., -1]
            complement = corner - np.einsum("bckr,bcks->brs", border, back)
            rest = rights[:, shared] - np.einsum("bckr,bck->br", border, forward)
            ends = np.linalg.solve(complement, rest[..., None])[..., 0]
        except np.linalg.LinAlgError:
            return super().solve(matrix, right)
        solved = np.empty_like(rights)
        solved[:, shared] = ends
        solved[:, own] = forward - np.einsum("bcks,bs->bck", back, ends)
        if not np.isfinite(solved).all():
            return super().solve(matrix, right)
        return np.moveaxis(solved, 0, 1)

    def inverse(self, matrix: Array) -> Array:
        own, shared = self.own, self.shared
        blocks, border, corner = self._parts(np.nan_to_num(matrix, posinf=0.0, neginf=0.0))
        inner = _inverse(blocks)
        back = inner @ border
        outer = _inverse(corner - np.einsum("bckr,bcks->brs", border, back))
        wide = np.zeros((matrix.shape[2], len(matrix), len(shared)))
        wide[:, own] = -back
        wide[:, shared] = np.eye(len(shared))
        full = wide @ outer @ np.swapaxes(wide, 1, 2)
        full[:, own[:, :, None], own[:, None, :]] += inner
        return np.moveaxis(full, 0, 2)

    def _parts(self, matrix: Array) -> tuple[Array, Array, Array]:
        """Blocks (B, C, K, K), border (B, C, K, S) and corner (B, S, S)."""
        own, shared = self.own, self.shared
        places = (
            (own[:, :, None], own[:, None, :]),
            (own[:, :, None], shared[None, None, :]),
            (shared[:, None], shared[None, :]),
        )
        blocks, border, corner = (np.moveaxis(matrix[place], -1, 0) for place in places)
        return blocks, border, corner


def _inverse(matrices: Array) -> Array:
    """Inverses of positive matrices (..., K, K), of size 1/`LEAST_PIVOT` along what is missing."""
    values, vectors = np.linalg.eigh(matrices)
    return (vectors / np.maximum(values, LEAST_PIVOT)[..., None, :]) @ np.swapaxes(vectors, -1, -2)
