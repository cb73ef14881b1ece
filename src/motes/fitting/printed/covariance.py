"""The covariance of a fit, for kernels: the diagonal of the sandwich H^-1 M H^-1, a lane for each texel.

A plain function over addresses; generated modules compile it (see `motes.fitting.printed.lanes`).  Its innermost loops run over the lanes.
"""

from __future__ import annotations

import numpy as np
from numpy import float64 as D

from motes.kernels.intrinsics import load, sqrt, store


def sandwich(lanes, size, x, matrix, middle, box, room):
    """Standard errors, without the factor for the degrees of freedom, into the first rows of `room`; NaN for what is at a bound, or not seen.

    Parameters
    ----------
    x, matrix, middle
        Rows of lanes: the point, and packed lower triangles of H and M.
    box
        Lower bounds, upper bounds and what is fixed.
    room
        3 size^2 + 2 size + 1 rows.
    """
    square = 8 * lanes * size * size
    scales = room + 8 * lanes * size
    total = scales + 8 * lanes * size
    factor = total + 8 * lanes
    inverse = factor + square
    left = inverse + square
    for i in range(size):
        low, high = load(D, box, i, "other", 1), load(D, box, size + i, "other", 1)
        fixed = load(D, box, 2 * size + i, "other", 1)
        for n in range(lanes):
            value = load(D, x, i * lanes + n, "other", 1)
            diagonal = load(D, matrix, (i * (i + 1) // 2 + i) * lanes + n, "other", 1)
            span = 1e-9 + 1e-6 * abs(value)
            free = value > low + span and value < high - span and diagonal > 0.0 and fixed == 0.0
            # The scale of a parameter that is not free is 0, which keeps it out of everything below.
            store(D, scales, i * lanes + n, 1.0 / sqrt(diagonal) if free else 0.0, "plain", 0, 1)
    # Cholesky's L of the matrix scaled to a diagonal of 1, with unit rows for what is not free.
    for i in range(size):
        for j in range(i + 1):
            for n in range(lanes):
                a = load(D, matrix, (i * (i + 1) // 2 + j) * lanes + n, "a", 1)
                a *= load(D, scales, i * lanes + n, "a", 1) * load(D, scales, j * lanes + n, "a", 1)
                store(D, total, n, a, "a", 0, 1)
            for k in range(j):
                for n in range(lanes):
                    product = load(D, factor, (i * size + k) * lanes + n, "b", 1) * load(
                        D, factor, (j * size + k) * lanes + n, "b", 1
                    )
                    store(D, total, n, load(D, total, n, "other", 1) - product, "b", 0, 1)
            if i == j:
                for n in range(lanes):
                    a = sqrt(max(load(D, total, n, "c", 1), 1e-12))
                    scale = load(D, scales, i * lanes + n, "c", 1)
                    store(D, factor, (i * size + i) * lanes + n, a if scale > 0.0 else 1.0, "c", 0, 1)
            else:
                for n in range(lanes):
                    a = load(D, total, n, "d", 1) / load(D, factor, (j * size + j) * lanes + n, "other", 1)
                    store(D, factor, (i * size + j) * lanes + n, a, "d", 0, 1)
    # Columns of L^-1.
    for c in range(size):
        for i in range(c, size):
            for n in range(lanes):
                store(D, total, n, 1.0 if i == c else 0.0, "e", 0, 1)
            for k in range(c, i):
                for n in range(lanes):
                    product = load(D, factor, (i * size + k) * lanes + n, "f", 1) * load(
                        D, inverse, (k * size + c) * lanes + n, "f", 1
                    )
                    store(D, total, n, load(D, total, n, "other", 1) - product, "f", 0, 1)
            for n in range(lanes):
                a = load(D, total, n, "g", 1) / load(D, factor, (i * size + i) * lanes + n, "g", 1)
                store(D, inverse, (i * size + c) * lanes + n, a, "g", 0, 1)
    # H^-1 = S L^-T L^-1 S.
    for i in range(size):
        for j in range(i + 1):
            for n in range(lanes):
                store(D, total, n, 0.0, "e", 0, 1)
            for k in range(i, size):
                for n in range(lanes):
                    product = load(D, inverse, (k * size + i) * lanes + n, "h", 1) * load(
                        D, inverse, (k * size + j) * lanes + n, "h", 1
                    )
                    store(D, total, n, load(D, total, n, "other", 1) + product, "h", 0, 1)
            for n in range(lanes):
                a = load(D, total, n, "i", 1)
                a *= load(D, scales, i * lanes + n, "i", 1) * load(D, scales, j * lanes + n, "i", 1)
                store(D, left, (i * size + j) * lanes + n, a, "i", 0, 1)
                store(D, left, (j * size + i) * lanes + n, a, "i", 0, 1)
    for i in range(size):
        for n in range(lanes):
            store(D, total, n, 0.0, "e", 0, 1)
        for j in range(size):
            for k in range(j + 1):
                twice = 1.0 if k == j else 2.0
                for n in range(lanes):
                    product = load(D, left, (i * size + j) * lanes + n, "j", 1) * load(
                        D, left, (i * size + k) * lanes + n, "j", 1
                    )
                    product *= twice * load(D, middle, (j * (j + 1) // 2 + k) * lanes + n, "j", 1)
                    store(D, total, n, load(D, total, n, "other", 1) + product, "j", 0, 1)
        for n in range(lanes):
            error = sqrt(max(load(D, total, n, "k", 1), 0.0))
            known = load(D, scales, i * lanes + n, "k", 1) > 0.0 and error > 0.0
            store(D, room, i * lanes + n, error if known else np.nan, "k", 0, 1)
