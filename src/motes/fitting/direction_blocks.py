"""Blocks of neighbouring directions, whose residuals go together where a model does not fit.

What a model misses of a material it misses alike at neighbouring pairs of directions, and in all channels of one.  So what has
to be independent (errors summed over parts of the data, or parts that are left out and predicted) is taken by blocks.
"""

from __future__ import annotations

import math
import weakref

import numpy as np
from numpy.typing import NDArray

from motes import workers
from motes.arrays import sorted_part
from motes.fitting.data_passes import in_slices
from motes.fitting.losses import Floats

Labels = NDArray[np.intp]
#: How many blocks, where nothing else is asked for, and the fewest pairs of directions in one.
BLOCKS, LEAST_DIRECTIONS = 24, 4
# Pairs whose coordinates differ by less are at one place [rad]: directions in files of single precision.
SAME = 1e-6
# How far from where a cut should be it is looked for first [pairs].
WINDOW = 32
# Fewer pairs are sorted in as little time as their part.
SORTED_WHOLE = 4096
# Pairs that are worked on at a time, and from how many on threads share the work.
AT_ONCE = 8192
# Of directions that do not change, as those of a measurement, until they go: many fits ask for their blocks.
_known: dict[tuple[int, int, int], Labels] = {}


def blocks_of(wi: Floats, wo: Floats, count: int = BLOCKS) -> Labels:
    """The block that each pair of directions is in, from 0: compact in Rusinkiewicz's coordinates, of about as many pairs each.

    The pairs are cut in two across the coordinate that they are widest in, and so is each part, until there are `count`.  The
    coordinates are theta_h, theta_d and, for the azimuth, sin(theta_h) sin(theta_d) |phi_d| with phi_d folded into a quarter.
    Pairs that a reciprocal, isotropic surface cannot tell apart (light and viewer swapped, mirrored, turned about the normal)
    are at one place, and places are never cut.  Nothing is random: the same pairs give the same blocks, in any order.

    Parameters
    ----------
    wi, wo
        Unit vectors (N, 3) to the light and to the viewer, above the surface.
    count
        How many blocks are wanted, at least 1.

    Returns
    -------
    labels (N,), all of 0 to G - 1, where G is `count`, or less where a block would have fewer than `LEAST_DIRECTIONS` pairs or
    the pairs are at too few places.

    Examples
    --------
    >>> from motes.directions import from_spherical
    >>> theta = np.linspace(0.1, 1.4, 12)
    >>> blocks_of(from_spherical(theta, 0.0), from_spherical(theta, np.pi), 3).tolist()
    [0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2]
    """
    key = (id(wi), id(wo), count)
    if key in _known:
        return _known[key]
    at = np.empty((3, len(wi)))

    def placed(rows: slice) -> None:
        at[:, rows] = coordinates(wi[rows], wo[rows]).T

    in_slices(placed, len(wi), AT_ONCE)
    labels = np.zeros(len(wi), np.intp)
    for k, part in enumerate(_cut(at, np.arange(len(wi)), count)):
        labels[part] = k
    labels.setflags(write=False)
    if not (wi.flags.writeable or wo.flags.writeable):
        _known[key] = labels
        for w in (wi, wo):
            weakref.finalize(w, _known.pop, key, None).atexit = False
    return labels


def _cut(at: Floats, part: Labels, count: int) -> list[Labels]:
    """A part, with the coordinates (3, n) of its pairs, cut into `count` blocks, or as many as there can be."""
    count = min(count, len(part) // LEAST_DIRECTIONS)
    if count < 2:
        return [part]
    first = count // 2
    for axis in (np.minimum.reduce(at, axis=1) - np.maximum.reduce(at, axis=1)).argsort(kind="stable"):
        beyond = end_of_first(at[axis], first / count)
        if beyond is not None:
            before = at[axis] < beyond
            sides = (before.nonzero()[0], first), ((~before).nonzero()[0], count - first)
            return _both(at, part, sides)
    return [part]


def _both(at: Floats, part: Labels, sides: tuple[tuple[Labels, int], tuple[Labels, int]]) -> list[Labels]:
    """Both sides of a part, each the rows and into how many blocks they are cut; by two threads where they are many."""
    found: dict[int, list[Labels]] = {}

    def cut(side: int, _: None) -> None:
        rows, count = sides[side]
        found[side] = _cut(at.take(rows, axis=1), part.take(rows), count)

    if len(part) > AT_ONCE:
        workers.spread(2, cut, lambda: None)
    else:
        cut(0, None)
        cut(1, None)
    return found[0] + found[1]


def end_of_first(along: Floats, share: float) -> float | None:
    """The coordinate of the first pair of the second part, where pairs are cut in two along a coordinate (n,); None where they cannot be cut."""
    count = len(along)
    middle = round(share * count)
    near, far = middle - WINDOW, middle + WINDOW
    if near > LEAST_DIRECTIONS and far < count - LEAST_DIRECTIONS:
        # A cut lies here as a rule, and what is farther off need not be sorted for that: a quarter of the time.
        part = np.sort(along)[near : far + 1] if count < SORTED_WHOLE else np.sort(sorted_part(along, near, far))
        found = _nearest_cut(part, share * count - near, 1)
        if found is not None:
            return found
    return _nearest_cut(np.sort(along), share * count, LEAST_DIRECTIONS)


def _nearest_cut(sorted_: Floats, target: float, least: int) -> float | None:
    """The number that begins the second part, of two places, with at least so many numbers in each; the parts as close to `target` as can be."""
    nearest = math.ceil(target - 0.5)
    if least <= nearest <= len(sorted_) - least and sorted_[nearest] - sorted_[nearest - 1] > SAME:  # as a rule
        return float(sorted_[nearest])
    apart = sorted_[least:] - sorted_[least - 1 : -1] > SAME
    cuts = apart[: len(apart) - least + 1].nonzero()[0] + least
    return float(sorted_[cuts[np.abs(cuts - target).argmin()]]) if len(cuts) else None


def coordinates(wi: Floats, wo: Floats) -> Floats:
    """Coordinates (N, 3) [rad] of what a reciprocal, isotropic surface can tell apart."""
    # As `motes.directions.half_difference` has them, without the frame of the half vector: by the sum of the two, by their difference, and
    # by sin(theta_h) sin(theta_d) times the cosine and the sine of the azimuth, which are half the difference of heights and a triple product.
    (ix, iy, iz), (ox, oy, oz) = (np.ascontiguousarray(np.asarray(w, float).T) for w in (wi, wo))
    across = (ix + ox) ** 2 + (iy + oy) ** 2
    total = np.maximum(across + (iz + oz) ** 2, 1e-300)
    apart = (ix - ox) ** 2 + (iy - oy) ** 2 + (iz - oz) ** 2
    along, aside = 0.5 * np.abs(iz - oz), np.abs(ix * oy - iy * ox) / np.sqrt(total)
    folded = np.sqrt(along * along + aside * aside) * np.arctan2(aside, along)
    return np.stack([np.arctan2(np.sqrt(across), iz + oz), np.arctan2(np.sqrt(apart), np.sqrt(total)), folded]).T
