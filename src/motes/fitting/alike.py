"""How far from one another directions are whose residuals are alike, and how many blocks of them that asks for.

Blocks that are smaller than what goes together tell too little of an error, and larger ones leave few of them to tell it from.  So a block's side
goes with the distance over which the residuals of a fit stay alike, as an empirical correlogram has it (Cressie, Statistics for Spatial Data, 1993,
section 2.4).  `docs/uncertainty.md` has what other sides and fixed numbers of blocks do beside that.
"""

from __future__ import annotations

import numpy as np

from motes.fitting.direction_blocks import BLOCKS, coordinates
from motes.fitting.losses import Floats

#: The fewest and the most blocks: fewer tell too little of a variance, and more are smaller than anything that is seen to go together.
FEWEST, MOST = 8, 2 * BLOCKS
#: Residuals whose correlation has sunk below this are apart.
APART = 0.2
#: The side of a block, in distances over which residuals stay alike.
SIDE = 1.5
# The width of the steps of distance in which correlations are averaged [rad].
STEP = 0.06
# Of more directions than these an even part tells the distance as well: their pairs grow with the square.
MOST_DIRECTIONS = 400
# Factors of no meaning: the fraction of a sum over them is as good as drawn.
LOT = 1e4 * np.sqrt([2.0, 3.0, 5.0, 7.0, 11.0, 13.0])


def count_of_blocks(wi: Floats, wo: Floats, misses: Floats, side: float = SIDE) -> int:
    """How many blocks there are whose sides are so many times the distance over which residuals stay alike: `FEWEST` to `MOST`.

    Parameters
    ----------
    wi, wo
        Unit vectors (N, 3) to the light and to the viewer, N at least 2.
    misses
        Weighted residuals (T, N, C); what goes together are their sums over channels, within each scan.
    side
        Of a block, in such distances.
    """
    sums = misses.sum(axis=2)
    if len(wi) > MOST_DIRECTIONS:
        # Drawn by where they are, and so the same in any order and any unit of the data.
        lot = np.modf(np.abs(wi @ LOT[:3] + wo @ LOT[3:]))[0]
        some = np.argpartition(lot, MOST_DIRECTIONS)[:MOST_DIRECTIONS]
        wi, wo, sums = wi[some], wo[some], sums[:, some]
    at = coordinates(wi, wo)
    sides = np.ptp(at, axis=0)
    across = side * distance_alike(at, sums)
    # Of directions in one plane, one coordinate is the same in all.
    return int(np.clip(np.prod(np.maximum(sides / across, 1.0)), FEWEST, MOST))


def distance_alike(at: Floats, sums: Floats) -> float:
    """The distance [rad], in steps of `STEP`, at which the correlation of residuals (T, N) at places (N, 3) first is below `APART`.

    Steps in which no pair of places lies say nothing; where residuals are alike at all distances, it is the largest.
    """
    square = np.einsum("nk,nk->n", at, at)
    # Distances by the products of all places with each other: three times as fast as pair by pair.  Each pair is there twice, and each place with itself.
    apart = np.sqrt(np.maximum(np.add.outer(square, square) - 2 * (at @ at.T), 0.0))
    steps = (apart.ravel() / STEP).astype(np.intp)
    pairs = np.bincount(steps)
    products = np.bincount(steps, (sums.T @ sums).ravel())
    total = float(np.sum(sums**2))
    pairs[0] -= len(at)
    products[0] -= total
    seen = np.flatnonzero(pairs)
    alike = products[seen] >= APART * pairs[seen] * total / len(at)
    return STEP * (0.5 + float(seen[-1] if alike.all() else seen[np.argmin(alike)]))
