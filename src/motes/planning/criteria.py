r"""What a plan is to be good for, as a sum that adding or removing a shot changes by small matrices.

Each term is a mean over the materials of the prior of a logarithm: so each material counts the same, whatever its errors are.

- *parameters*: :math:`\log\det M`, the volume of the error ellipsoid (D-optimality).
- *curve*, one parameter: :math:`-\log\operatorname{tr}(W M^{-1})`: with W the sum of g g' over directions the mean variance of the predicted
  curve there (I-optimality), with W = e e' that of one parameter (D_s).

M begins with the prior: one over the square of the range that real materials span, so that the determinant exists even where no
direction sees a parameter.  With R the rows of a shot, det(M + R'R) = det(M) det(1 + R M^-1 R').
(Atkinson, Donev, Tobias, Optimum Experimental Designs, with SAS, 2007.)
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass
class Term:
    """One term of a criterion, with the information that it has of what was taken so far.

    Parameters
    ----------
    rows
        Of all shots (B, U, m, P); rows of 0 where a shot has fewer directions.
    start
        The information (B, P, P) before any of them.
    weight
        Of the term.
    aim
        W (B, P, P), or None for the determinant.
    """

    rows: Floats
    start: Floats
    weight: float = 1.0
    aim: Floats | None = None
    matrix: Floats = field(init=False)

    def __post_init__(self) -> None:
        self.matrix = self.start.copy()

    def change(self, shot: int, sign: int) -> None:
        """Take a shot, or give it back."""
        rows = self.rows[:, shot]
        self.matrix = self.matrix + sign * np.swapaxes(rows, 1, 2) @ rows

    def gains(self) -> Floats:
        """By how much each shot (U,) would raise the term."""
        inverse = np.linalg.inv(self.matrix)
        batch, shots, m, size = self.rows.shape
        flat = self.rows.reshape(batch, shots * m, size)
        seen = (flat @ inverse).reshape(self.rows.shape)
        if self.aim is None:
            if m == 1:
                grown_by = np.sum(seen * self.rows, axis=-1)[..., 0]
                return np.asarray(self.weight * np.log1p(grown_by).mean(axis=0))
            grown = seen @ np.swapaxes(self.rows, 2, 3) + np.eye(m)
            return np.asarray(self.weight * np.linalg.slogdet(grown)[1].mean(axis=0))
        trace = np.einsum("bpq,bqp->b", self.aim, inverse)[:, None]
        aimed = (seen.reshape(batch, shots * m, size) @ self.aim).reshape(self.rows.shape)
        if m == 1:
            less = (np.sum(aimed * seen, axis=-1) / (1 + np.sum(seen * self.rows, axis=-1)))[..., 0]
        else:
            grown = seen @ np.swapaxes(self.rows, 2, 3) + np.eye(m)
            less = np.einsum("bukl,bulk->bu", np.linalg.inv(grown), aimed @ np.swapaxes(seen, 2, 3))
        return np.asarray(-self.weight * np.log(np.maximum(1 - less / trace, 1e-12)).mean(axis=0))

    def value(self) -> float:
        """The term as it stands."""
        if self.aim is None:
            return float(self.weight * np.linalg.slogdet(self.matrix)[1].mean())
        trace = np.einsum("bpq,bqp->b", self.aim, np.linalg.inv(self.matrix))
        return float(-self.weight * np.log(trace).mean())

    def slopes(self, taken: list[int], exposure: Floats) -> Floats:
        """How fast the exposure (K,) of each of the shots `taken` raises the term: its derivative."""
        rows = self.rows[:, taken]
        matrix = self.start + np.einsum("u,bump,bumq->bpq", exposure, rows, rows, optimize=True)
        inverse = np.linalg.inv(matrix)
        seen = rows @ inverse[:, None]
        if self.aim is None:
            return np.asarray(self.weight * np.sum(seen * rows, axis=(2, 3)).mean(axis=0))
        trace = np.einsum("bpq,bqp->b", self.aim, inverse)[:, None]
        return np.asarray(self.weight * (np.sum((seen @ self.aim[:, None]) * seen, axis=(2, 3)) / trace).mean(axis=0))


@dataclass
class Criterion:
    """A sum of terms over the same shots."""

    terms: list[Term]

    def gains(self) -> Floats:
        return np.asarray(sum(term.gains() for term in self.terms))

    def value(self) -> float:
        return sum(term.value() for term in self.terms)

    def take(self, shot: int) -> None:
        for term in self.terms:
            term.change(shot, 1)

    def give_back(self, shot: int) -> None:
        for term in self.terms:
            term.change(shot, -1)
