"""A pass over the data of a fit, in slices of the directions that stay in cache, on all processors where there is much to do."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from motes import workers
from motes.fitting.losses import Floats, Loss
from motes.measurements import Measurement

Part = TypeVar("Part")
# Of so many elements a pass is worth sharing.
SHARED = 1 << 15
# Of fewer values what a pass over them finds out is there before another thread has begun with it.
MANY = 30_000
# Directions that are worked on at a time where arrays are turned.
AT_ONCE = 16_384


def in_passes(work: Callable[[slice], Part], directions: int, each: int, chunk: int) -> list[Part]:
    """`work` on slices of the directions, in their order; `each` is the number of elements at one of them, `chunk` how many are worked on at a time."""
    step = max(64, chunk // max(1, each))
    if each * directions >= SHARED:  # the same slices on any machine
        step = min(step, -(-directions // 4))
    elif directions <= 2 * step:
        step = max(1, directions)
    return in_slices(work, directions, step)


def in_slices(work: Callable[[slice], Part], directions: int, step: int) -> list[Part]:
    """`work` on slices of so many directions, in their order; shared by threads where they are several."""
    slices = [slice(k, min(k + step, directions)) for k in range(0, directions, step)]
    if len(slices) < 4:
        return [work(rows) for rows in slices]
    results: dict[int, Part] = {}

    def one(k: int, _: None) -> None:
        results[k] = work(slices[k])

    workers.spread(len(slices), one, lambda: None)
    return [results[k] for k in range(len(slices))]


def beside(data: Measurement, work: Callable[[], Part]) -> workers.Beside[Part]:
    """What `work` finds out about a measurement, by another thread where it is large."""
    return workers.Beside(work, data.values.size >= MANY)


def directions_last(array: Floats) -> Floats:
    """An array (..., N, C) as (..., C, N), in memory as well."""
    return np.ascontiguousarray(np.swapaxes(array, -2, -1))


def directions_first(array: Floats) -> Floats:
    """An array (C, N) as (N, C), in memory as well."""
    found = np.empty(array.shape[::-1])

    def turned(rows: slice) -> None:
        found[rows] = array[:, rows].T

    in_slices(turned, len(found), AT_ONCE)
    return found


def transformed(loss: Loss, values: Floats, cosines: Floats) -> Floats:
    """The transform of a loss of values (..., N, C) as (..., C, N)."""
    if values.ndim > 2:
        return loss.transform(directions_last(values), cosines)
    found = np.empty(values.shape[::-1])

    def part(rows: slice) -> None:
        found[:, rows] = loss.transform(np.ascontiguousarray(values[rows].T), cosines[rows])

    in_slices(part, len(values), AT_ONCE)
    return found


def rows_of(array: Floats, rows: slice, sets: NDArray[np.intp] | None) -> Floats:
    """Rows of (C, N), or of the data sets (B, C, N) of each vector."""
    return array[:, rows] if array.ndim == 2 else array[slice(None) if sets is None else sets, :, rows]
