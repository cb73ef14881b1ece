"""Which of some starts suits a texel best, found by matrix products: the fits themselves are made from that start alone.

At a start the columns along which an objective has several valleys are held.  In the others a model is nearly linear, so that what a fit from
there would leave of the data is a quadratic form in sums of the data times known columns, for all texels and all starts one product of two
matrices.  A kernel that goes over the data for each start takes three to five times as long, and twice as long as the fit that follows.
"""

from __future__ import annotations

import itertools
import math
from typing import Any

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
TASK = 2048
# What is left out of columns, as a share of the strongest direction among them; sums in float32 are rounded by as much.
LEFT_OUT = 1e-7
# Bands, and the most starts in all of them.
BANDS, MOST_IN_BANDS = 3, 64
# Rounds over the columns of a fit that would leave its bounds.
ROUNDS = 3


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
        self._floor, self._ceiling = self.low[self.free, None], self.high[self.free, None]
        onto, wanted, rests, shifts, solved, alone, grams = (list[Any]() for _ in range(7))
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
            found_here = (own, own @ inverse, rest[:, None], shift, inverse @ shift, rest @ rest, gram)
            for kept, value in zip((onto, wanted, rests, shifts, solved, alone, grams), found_here, strict=True):
                kept.append(value)
        # What a start leaves of data, sums of these with the columns tell: products of the data and the free columns less `shift`, those times the
        # inverse of their own products less `solved`, those of the data and the rest of the model, and half of what is left where the data are 0.
        self._shift, self._solved, self._alone = (
            np.array(shifts)[..., None],
            np.array(solved)[..., None],
            np.array(alone),
        )
        self._grams = np.array(grams)
        columns = np.concatenate([*onto, *wanted, *rests], axis=1) * np.repeat(factor, fit.channels)[:, None]
        self._basis, self._weights = _few(columns)
        # Always as many texels to a product, so that the library sums in one order whatever else is in a call.
        self._together = 8
        while self._together < 256 and 2 * self._together * self._basis.size <= PRODUCT:
            self._together *= 2

    def points(self, data: Singles) -> tuple[Floats, NDArray[np.bool_]]:
        """For each texel (M, D, C) the best start (M, P), with what is free moved to where it is best.

        And which texels miss a sample (M,): for these it means nothing.
        """
        count = len(data)
        best, missing = np.empty((count, len(self.low))), np.empty(count, bool)
        rows = data.reshape(count, data.shape[1] * data.shape[2])

        def work(task: int, room: Any) -> None:
            first, last = task * TASK, min(count, (task + 1) * TASK)
            with np.errstate(invalid="ignore", over="ignore"):
                best[first:last], missing[first:last] = self._best(rows[first:last])

        workers.spread(-(-count // TASK), work, lambda: None)
        return best, missing

    def _best(self, rows: Singles) -> tuple[Floats, NDArray[np.bool_]]:
        sums, missing = self._sums(rows)
        k, r, count = len(self.starts), len(self.free), len(rows)
        onto = sums[: k * r].reshape(k, r, count) - self._shift
        wanted = sums[k * r : 2 * k * r].reshape(k, r, count) - self._solved
        left = self._alone[:, None] - 2 * sums[2 * k * r :]
        free = np.minimum(np.maximum(wanted, self._floor), self._ceiling)
        gain = _dot(onto.swapaxes(0, 1), wanted.swapaxes(0, 1))
        start, texel = np.nonzero((free != wanted).any(axis=1))
        if len(start):
            grams = self._grams[start].transpose(1, 2, 0)
            within, more = self._within(grams, free[start, :, texel].T, onto[start, :, texel].T)
            free[start, :, texel], gain[start, texel] = within.T, -more
        which = (left - gain).argmin(axis=0)
        best: Floats = self.starts[which]
        best[:, self.free] = free[which, :, np.arange(count)]
        return best, missing

    def _sums(self, rows: Singles) -> tuple[Floats, NDArray[np.bool_]]:
        """Sums of the data of texels (M, D C) times the columns: (columns, M); and which hold what is no number."""
        count, width = rows.shape
        whole = count // self._together * self._together
        sums = np.empty((-(-count // self._together), self._together, self._basis.shape[1]), np.float32)
        np.matmul(rows[:whole].reshape(-1, self._together, width), self._basis, out=sums[: whole // self._together])
        if whole < count:
            last = np.zeros((self._together, width), np.float32)
            last[: count - whole] = rows[whole:]
            sums[-1] = last @ self._basis
        missing = ~np.isfinite(sums.sum(axis=2)).ravel()[:count]
        turned = self._weights @ sums.transpose(0, 2, 1).astype(float)
        return np.ascontiguousarray(turned.transpose(1, 0, 2).reshape(len(self._weights), -1)[:, :count]), missing

    def _within(self, grams: Floats, free: Floats, onto: Floats) -> tuple[Floats, Floats]:
        """The free columns (r, M) that leave least within their bounds, and what they add to what is left: where one stops, the others make up for it."""
        for _ in range(ROUNDS):
            for j, row in enumerate(grams):
                push = onto[j] - _dot(row, free)
                free[j] = np.clip(free[j] + push / np.maximum(row[j], 1e-300), self._floor[j], self._ceiling[j])
        return free, sum(free[j] * (_dot(row, free) - 2 * onto[j]) for j, row in enumerate(grams))


def bands(fit: TexelSetup, held: NDArray[np.bool_]) -> list[Floats]:
    """Starts (K, P) from all over the columns that are held, in bands of the parameter with the most places to start from.

    The best of each band is where another valley of a texel may begin.  Columns of one parameter start alike.
    """
    given = {c.quantity: c.parameter.starts for k, c in enumerate(fit.columns) if held[k] and c.parameter.starts}
    if not given:
        return []
    widest = max(given, key=lambda name: len(given[name]))
    if math.prod(map(len, given.values())) > MOST_IN_BANDS:
        given = {name: all if name == widest else all[len(all) // 2 :][:1] for name, all in given.items()}
    found = []
    for band in np.array_split(np.sort(given[widest]), min(BANDS, len(given[widest]))):
        rows = list(itertools.product(*(band if name == widest else all for name, all in given.items())))
        points = np.repeat(fit.values(fit.facts.rest[:, 0])[None], len(rows), axis=0)
        for name, column in zip(given, np.array(rows).T, strict=True):
            points[:, [k for k, c in enumerate(fit.columns) if c.quantity == name]] = column[:, None]
        found.append(np.clip(fit.coordinates(points), fit.facts.low[:, 0], fit.facts.high[:, 0]))
    return found


def _few(columns: Floats) -> tuple[Singles, Floats]:
    """Columns (N, n) as the product of few orthogonal ones (N, m), float32, and their weights (n, m).

    Starts share most of what their columns are made of: the functions that linear parameters weigh, in which each channel is a part of its own.
    Of what is left of all columns the strongest is the next orthogonal one, until nothing is.  Singular values would give as few; but a library of
    linear algebra takes a thread of its own for them, which then waits busily for more: twenty times the work itself.
    """
    size = np.maximum(np.linalg.norm(columns, axis=0), 1e-300)
    scaled = columns / size
    left, basis = scaled.copy(), np.empty((len(columns), 0))
    for _ in range(min(columns.shape)):
        strength = np.einsum("ij,ij->j", left, left)
        strongest = int(strength.argmax())
        if strength[strongest] <= LEFT_OUT**2:
            break
        new = left[:, strongest]
        new = new - np.einsum("ik,k->i", basis, np.einsum("ik,i->k", basis, new))  # again, for it was rounded
        new /= np.sqrt(np.einsum("i,i->", new, new))
        left -= np.einsum("i,j->ij", new, np.einsum("i,ij->j", new, left))
        basis = np.column_stack([basis, new])
    weights = np.einsum("ik,ij->jk", basis, scaled) * size[:, None]
    return np.ascontiguousarray(basis, np.float32), np.ascontiguousarray(weights)


def _dot(row: Floats, columns: Floats) -> Floats:
    """The products (..., M) of a row (r,), or of columns (r, ..., M), and columns (r, ..., M); each column for itself, in one order."""
    total: Floats = row[0] * columns[0]
    for k in range(1, len(row)):
        total = total + row[k] * columns[k]
    return total
