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
        Arrays (M_t, D) of directions, a row a sample; M_t = 0 for a scan that is missing.  Rows of one scan are never merged, so a
        direction measured twice in each scan stays two directions.

    Returns
    -------
    rows
        (N, D), in the order of first appearance.
    indices
        For each scan, the rows (M_t,) that its samples belong to.
    """
    rows: NDArray[np.float64] = np.empty((0, scans[0].shape[1]))
    where: dict[bytes, list[int]] | None = None
    indices: list[NDArray[np.intp]] = []
    for scan in scans:
        if len(rows) == 0:
            rows = scan
            indices.append(np.arange(len(scan)))
            continue
        n = min(len(scan), len(rows))
        index = np.full(len(scan), -1)
        same = np.all(np.abs(scan[:n] - rows[:n]) <= SAME_DIRECTION, axis=1)
        index[:n][same] = np.flatnonzero(same)
        if np.any(index < 0):
            if where is None:
                where = defaultdict(list)
                for i, key in enumerate(_keys(rows)):
                    where[key].append(i)
            taken = set(index[index >= 0].tolist())
            new: list[int] = []
            keys = _keys(scan)
            for i in np.flatnonzero(index < 0):
                free = [j for j in where[keys[i]] if j not in taken]
                index[i] = free[0] if free else len(rows) + len(new)
                if not free:
                    new.append(i)
                    where[keys[i]].append(int(index[i]))
                taken.add(int(index[i]))
            rows = np.concatenate([rows, scan[new]])
        indices.append(index)
    return rows, indices


def spread(
    n_rows: int, indices: Sequence[NDArray[np.intp]], values: Sequence[NDArray[np.float64]], n_channels: int, where: str
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Values (T, N, C) over the union, NaN where a scan has no sample, and which (T, N) it has."""
    n_samples = n_channels * sum(len(i) for i in indices)
    size = len(indices) * n_rows * n_channels
    if size > max(SPARSE_LIMIT, 16 * n_samples):
        raise FormatError(
            f"{where}: {len(indices)} scans of {n_rows} different directions would fill an array of {size:,} with {n_samples:,} values",
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
