"""Bringing scans of different times onto one set of directions."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError

SAME_DIRECTION = 1e-6  # components closer than this are the same direction, printed twice
SPARSE_LIMIT = 2**22  # samples; below it a mostly empty array is cheap enough not to argue about


def union(scans: Sequence[NDArray[np.float64]]) -> tuple[NDArray[np.float64], list[NDArray[np.intp]]]:
    """The directions of several scans, those that they share once.

    Parameters
    ----------
    scans
        Arrays (M_t, D) of directions, a row a sample; M_t = 0 for a scan that is missing.  Rows of one scan are never
        merged, so a direction measured twice in each scan stays two directions.

    Returns
    -------
    rows
        (N, D), in the order of first appearance.
    indices
        For each scan, the rows (M_t,) that its samples belong to.
    """
    first = next((scan for scan in scans if len(scan)), scans[0])
    parts, n_rows = [first], len(first)
    where: dict[bytes, list[int]] | None = None
    indices: list[NDArray[np.intp]] = []
    for scan in scans:
        # Scans of one rig list their directions in one order, so most are found in their place ...
        n = min(len(scan), len(first))
        index = np.full(len(scan), -1)
        same = np.all(np.abs(scan[:n] - first[:n]) <= SAME_DIRECTION, axis=1)
        index[:n][same] = np.flatnonzero(same)
        missing = np.flatnonzero(index < 0)
        if len(missing):  # ... and the others by what they are
            if where is None:
                where = defaultdict(list)
                for i, key in enumerate(_keys(first)):
                    where[key].append(i)
            taken = set(index[index >= 0].tolist())
            looked_at: dict[bytes, int] = defaultdict(
                int
            )  # how many of the places of a direction are known to be taken
            new: list[int] = []
            for i, key in zip(missing.tolist(), _keys(scan[missing]), strict=True):
                places, k = where[key], looked_at[key]
                while k < len(places) and places[k] in taken:
                    k += 1
                looked_at[key] = k + 1
                if k == len(places):
                    places.append(n_rows + len(new))
                    new.append(i)
                free = places[k]
                index[i] = free
                taken.add(free)
            parts.append(scan[new])
            n_rows += len(new)
        indices.append(index)
    return np.concatenate(parts), indices


def spread(
    n_rows: int, indices: Sequence[NDArray[np.intp]], values: Sequence[NDArray[np.float64]], n_channels: int, where: str
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Values (T, N, C) over the union, NaN where a scan has no sample, and which (T, N) it has."""
    n_samples = n_channels * sum(len(i) for i in indices)
    size = len(indices) * n_rows * n_channels
    if size > max(SPARSE_LIMIT, 16 * n_samples):
        raise FormatError(
            f"{where}: {len(indices)} scans of {n_rows} different directions make an array of {size:,} "
            f"for {n_samples:,} values",
            "Scans at different times must share most of their directions; check the time stamps and the directions",
        )
    spread_values = np.full((len(indices), n_rows, n_channels), np.nan)
    present = np.zeros((len(indices), n_rows), bool)
    for t, (index, scan) in enumerate(zip(indices, values, strict=True)):
        spread_values[t, index] = scan
        present[t, index] = True
    return spread_values, present


def _keys(rows: NDArray[np.float64]) -> list[bytes]:
    # adding 0 turns -0 into 0
    return [row.tobytes() for row in np.round(rows, 6) + 0.0]
