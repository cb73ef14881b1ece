"""Long tables, a row a value, made into arrays (times, directions, channels)."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError

Array = NDArray[np.float64]
ROUNDED = 9  # decimals [rad] beyond which two angles are one direction, printed twice
SPARSE = 16  # how much larger than its rows an array may be


def pivot(
    angles: Array, others: Sequence[NDArray[np.generic]], columns: Sequence[Array], path: Path
) -> tuple[Array, list[NDArray[Any]], list[Array], NDArray[np.bool_]]:
    """Rows as an array over directions and the distinct values of other variables.

    A direction that is measured more than once, under the same other variables, stays as many directions.

    Parameters
    ----------
    angles
        (M, K) [rad]: what tells directions apart.
    others
        Variables (M,) such as the wavelength.
    columns
        Values (M,), such as f_r and its uncertainty.
    path
        The file, for errors.

    Returns
    -------
    angles
        (N, K), in the order of first appearance.
    levels
        The distinct values of each of the others, sorted.
    arrays
        Each of the columns as (N, *levels), NaN where there is no row.
    present
        (N, *levels), where there is one.

    Raises
    ------
    FormatError
        Where the array would be mostly empty.
    """
    levels, places = [], []
    for other in others:
        level, place = np.unique(other, return_inverse=True)
        levels.append(level)
        places.append(place.reshape(-1))
    shape = tuple(len(level) for level in levels)
    inner = np.ravel_multi_index(places, shape) if places else np.zeros(len(angles), np.intp)
    _, first, which = np.unique(np.round(angles, ROUNDED) + 0.0, axis=0, return_index=True, return_inverse=True)
    which = which.reshape(-1)
    # the how-manieth row of its direction and variables each row is
    order = np.lexsort((np.arange(len(angles)), inner, which))
    same = np.zeros(len(angles), bool)
    same[1:] = (which[order][1:] == which[order][:-1]) & (inner[order][1:] == inner[order][:-1])
    position = np.arange(len(angles))
    start = np.maximum.accumulate(np.where(same, 0, position))
    repeat = np.empty(len(angles), np.intp)
    repeat[order] = position - start
    keys = first[which].astype(np.int64) * (int(repeat.max(initial=0)) + 1) + repeat
    # Directions in the order of first appearance, the repeats of one after it.
    distinct, index, rows = np.unique(keys, return_index=True, return_inverse=True)
    size = len(distinct) * int(np.prod(shape, dtype=np.int64))
    if size > SPARSE * len(angles) + 1000:
        raise FormatError(
            f"{path}: {len(distinct):,} directions x {' x '.join(map(str, shape))} make {size:,} values of {len(angles):,} rows",
            "Wavelengths and times must share their directions; split the file",
        )
    flat = rows.reshape(-1) * int(np.prod(shape, dtype=np.int64)) + inner
    arrays = []
    for column in columns:
        array = np.full(size, np.nan)
        array[flat] = column
        arrays.append(array.reshape(len(distinct), *shape))
    present = np.zeros(size, bool)
    present[flat] = True
    return angles[index], levels, arrays, present.reshape(len(distinct), *shape)
