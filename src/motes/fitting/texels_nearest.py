"""Which of some starts suits a texel best, found by matrix products: the fits themselves are made from that start alone.

At a start the columns along which an objective has several valleys are held.  In the others a model is nearly linear, so that what a fit from
there would leave of the data is a quadratic form in sums of the data times known columns, for all texels and all starts one product of two
matrices.  A kernel that goes over the data for each start takes three to five times as long, and twice as long as the fit that follows.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes import workers
from motes.fitting.losses import Floats
from motes.fitting.texel_kernel import Singles
from motes.fitting.texel_setup import TexelSetup
from motes.fitting.texels_slow import problem_of

# Multiplications of one matrix product: fewer than those from which on the library shares them among threads of its own, which would wait for each other.
PRODUCT = 1 << 18
# Texels that a thread takes at a time: a whole number of such products.
TASK = 4096
# Rounds over the columns of a fit that would leave its bounds.
ROUNDS = 3


class _Start(NamedTuple):
    """What a start leaves of data, as sums of them tell: products G (r, r) of the free columns; what is to be taken off the products of the data
    and the columns (r,), and off those times the inverse of G (r,); and half of what is left where the data are 0."""

    gram: Floats
    shift: Floats
    solved: Floats
    rest: float


class Nearest:
    """The starts of a fit, ready to be compared.

    Parameters
    ----------
    fit
        Without trends, of a loss that is linear in the BRDF.
    points
        Starts (K, P), in the coordinates of the fit.
    held
        The columns (P,) that are held.
    """

    def __init__(self, fit: TexelSetup, points: Floats, held: NDArray[np.bool_]) -> None:
        facts = fit.facts
        self.low, self.high = facts.low[:, 0], facts.high[:, 0]
        empty = np.zeros((1, len(fit.wi), fit.channels), np.float32)
        problem = problem_of(fit, empty)
        factor = np.sqrt(fit.weights) * fit.loss.slope(np.ones(1), fit.wi[:, 2])  # (D,): of a value in a residual
        self.starts, self.free = points.copy(), np.flatnonzero(~held)
        self._known: list[_Start] = []
        columns = []
        for point in points:
            found, slopes = problem.linearised(point[None], slice(0, len(fit.wi)), None)
            dense = np.zeros((len(fit.wi), fit.channels, fit.size))
            for c, index in enumerate(problem.layout.index):
                dense[:, c, index] = slopes[0, c]
            own = dense.reshape(-1, fit.size)[:, self.free]
            rest = found[0].T.ravel() - own @ point[self.free]  # what the model has beside these columns
            gram = own.T @ own
            inverse = np.linalg.pinv(gram, rcond=1e-12, hermitian=True)
            shift = own.T @ rest
            self._known.append(_Start(gram, shift, inverse @ shift, float(rest @ rest)))
            columns += [own, own @ inverse, rest[:, None]]
        self._columns = (np.concatenate(columns, axis=1) * np.repeat(factor, fit.channels)[:, None]).astype(np.float32)
        # Always as many texels to a product, so that the library sums in one order whatever else is in a call.
        self._together = 8
        while self._together < 256 and 2 * self._together * self._columns.size <= PRODUCT:
            self._together *= 2

    def points(self, data: Singles) -> Floats:
        """For each texel (M, D, C), all of whose samples are numbers, the best start (M, P), with what is free moved to where it is best."""
        count = len(data)
        best = np.empty((count, len(self.low)))
        rows = data.reshape(count, data.shape[1] * data.shape[2])

        def work(task: int, room: Any) -> None:
            first, last = task * TASK, min(count, (task + 1) * TASK)
            best[first:last] = self._best(rows[first:last])

        workers.spread(-(-count // TASK), work, lambda: None)
        return best

    def _best(self, rows: Singles) -> Floats:
        count = len(rows)
        padded = np.zeros((-(-count // self._together), self._together, rows.shape[1]), np.float32)
        padded.reshape(-1, rows.shape[1])[:count] = rows
        sums = np.ascontiguousarray((padded @ self._columns).reshape(-1, self._columns.shape[1])[:count].T)
        r = len(self.free)
        which, least = np.zeros(count, np.intp), np.full(count, np.inf)
        values = np.zeros((r, count))
        for k, start in enumerate(self._known):
            own = sums[k * (2 * r + 1) :]
            onto, wanted = own[:r] - start.shift[:, None], own[r : 2 * r] - start.solved[:, None]
            left = start.rest - 2 * own[2 * r] - _dot(onto, wanted)
            free = np.clip(wanted, self.low[self.free, None], self.high[self.free, None])
            out = np.flatnonzero((free != wanted).any(axis=0))
            if len(out):
                within, more = self._within(start, free[:, out], onto[:, out])
                free[:, out] = within
                left[out] = start.rest - 2 * own[2 * r, out] + more
            better = left < least
            which[better] = k
            least = np.where(better, left, least)
            values = np.where(better, free, values)
        best: Floats = self.starts[which]
        best[:, self.free] = values.T
        return best

    def _within(self, start: _Start, free: Floats, onto: Floats) -> tuple[Floats, Floats]:
        """The free columns (r, M) that leave least within their bounds, and what they add to what is left: where one stops, the others make up for it."""
        low, high = self.low[self.free], self.high[self.free]
        for _ in range(ROUNDS):
            for j, row in enumerate(start.gram):
                push = onto[j] - _dot(row, free)
                free[j] = np.clip(free[j] + push / max(row[j], 1e-300), low[j], high[j])
        return free, sum(free[j] * (_dot(row, free) - 2 * onto[j]) for j, row in enumerate(start.gram))


def _dot(row: Floats, columns: Floats) -> Floats:
    """The products (M,) of a row (r,), or of columns (r, M), and columns (r, M); each column for itself, in one order."""
    total: Floats = row[0] * columns[0]
    for k in range(1, len(row)):
        total = total + row[k] * columns[k]
    return total
