"""How far from one another directions are whose residuals are alike, and how many blocks of them that asks for.

Blocks that are smaller than what goes together tell too little of an error, and larger ones leave few of them to tell it from.  So a block's side is
made twice the distance over which the residuals of a fit stay alike, as an empirical correlogram has it (Cressie, Statistics for Spatial Data, 1993,
section 2.4).  `docs/uncertainty.md` has what fixed numbers of blocks do beside that.
"""

from __future__ import annotations

import numpy as np

from motes.fitting.direction_blocks import BLOCKS, coordinates
from motes.fitting.losses import Floats

#: The fewest and the most blocks: fewer tell too little of a variance, and more are smaller than anything that is seen to go together.
FEWEST, MOST = 8, 2 * BLOCKS
#: Residuals whose correlation has sunk below this are apart.
APART = 0.2
# The width of the steps of distance in which correlations are averaged [rad].
STEP = 0.06
# Of more directions than these an even part tells the distance as well: their pairs grow with the square.
MOST_DIRECTIONS = 600
# Factors of no meaning: the fraction of a sum over them is as good as drawn.
LOT = 1e4 * np.sqrt([2.0, 3.0, 5.0, 7.0, 11.0, 13.0])


def count_of_blocks(wi: Floats, wo: Floats, misses: Floats) -> int:
    """How many blocks there are whose sides are twice the distance over which residuals stay alike: `FEWEST` to `MOST`.

    Parameters
    ----------
    wi, wo
        Unit vectors (N, 3) to the light and to the viewer, N at least 2.
    misses
        Weighted residuals (T, N, C); what goes together are their sums over channels, within each scan.
    """
    sums = misses.sum(axis=2)
    if len(wi) > MOST_DIRECTIONS:
        # Drawn by where they are, and so the same in any order and any unit of the data.
        lot = np.modf(np.abs(wi @ LOT[:3] + wo @ LOT[3:]))[0]
        some = np.argpartition(lot, MOST_DIRECTIONS)[:MOST_DIRECTIONS]
        wi, wo, sums = wi[some], wo[some], sums[:, some]
    at = coordinates(wi, wo)
    sides = np.ptp(at, axis=0)
    across = 2 * distance_alike(at, sums)
    # Of directions in one plane, one coordinate is the same in all.
    return int(np.clip(np.prod(np.maximum(sides / across, 1.0)), FEWEST, MOST))


def distance_alike(at: Floats, sums: Floats) -> float:
    """The distance [rad], in steps of `STEP`, at which the correlation of residuals (T, N) at places (N, 3) first is below `APART`.

    Steps in which no pair of places lies say nothing; where residuals are alike at all distances, it is the largest.
    """
    first, second = np.triu_indices(len(at), 1)
    steps = (np.linalg.norm(at[first] - at[second], axis=1) / STEP).astype(int)
    pairs = np.bincount(steps)
    products = np.bincount(steps, np.einsum("tp,tp->p", sums[:, first], sums[:, second]))
    seen = np.flatnonzero(pairs)
    alike = products[seen] >= APART * pairs[seen] * np.mean(np.sum(sums**2, axis=0))
    return STEP * (0.5 + float(seen[-1] if alike.all() else seen[np.argmin(alike)]))
