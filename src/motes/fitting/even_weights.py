"""Weights that are one number everywhere, as where nothing is masked and directions count alike: the number is held once, and nothing is multiplied by 1."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motes.fitting.data_passes import directions_last
from motes.fitting.losses import Floats


def everywhere(number: float, shape: tuple[int, ...]) -> Floats:
    """An array that holds a number once; not to be written to."""
    return np.broadcast_to(np.float64(number), shape)


def one_number(array: Floats) -> bool:
    """Whether an array is one number everywhere, held once."""
    return array.size > 0 and not any(array.strides)


def roots_of(weights: Floats) -> Floats:
    """Square roots of weights (..., N, C) as (..., C, N)."""
    if one_number(weights):
        return everywhere(np.sqrt(weights.flat[0]), np.swapaxes(weights, -1, -2).shape)
    return np.asarray(np.sqrt(directions_last(weights)))


def taken(array: Floats, rows: NDArray[np.intp], axis: int) -> Floats:
    """Some rows of an array along an axis."""
    if one_number(array):
        shape = list(array.shape)
        shape[axis] = len(rows)
        return everywhere(array.flat[0], tuple(shape))
    return array.take(rows, axis=axis)


def rooted(roots: Floats, differences: Floats) -> Floats:
    """Differences (C, N) times the roots of their weights."""
    return differences if one_number(roots) and roots.flat[0] == 1.0 else np.multiply(roots, differences)


def count(weights: Floats) -> int:
    """How many are not 0."""
    return weights.size * int(weights.flat[0] != 0) if one_number(weights) else int(np.count_nonzero(weights))


def same_in_channels(roots: Floats) -> bool:
    """Whether all channels (C, N) have the same."""
    return one_number(roots) or bool((roots[1:] == roots[0]).all())
