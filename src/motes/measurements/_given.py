"""What callers give for a measurement, checked: numbers, samples, uncertainties, masks, names of channels."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.errors import DataError


def numbers(array: ArrayLike, label: str) -> NDArray[np.float64]:
    """A copy as float64; raises `DataError` for what is no numbers."""
    try:
        return np.array(array, np.float64)
    except (TypeError, ValueError, OverflowError) as error:
        raise DataError(f"{label} are not numbers: {error}", "Give an array of real numbers") from None


def samples(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """(N,) or (N, C) as (1, N, C)."""
    if values.ndim == 1:
        values = values[:, None]
    return values[None] if values.ndim == 2 else values


def deviations(given: ArrayLike, values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Standard deviations (T, N, C), checked."""
    array = numbers(given, "uncertainties")
    try:
        array = np.array(np.broadcast_to(samples(array) if array.ndim else array, values.shape))
    except ValueError:
        raise DataError(
            f"uncertainties have shape {array.shape}, which does not fit the values {values.shape}",
            "Give one standard deviation [1/sr] a sample, in the shape of the values",
        ) from None
    bad = (array <= 0) | np.isinf(array)
    if bad.any():
        t, n, c = (int(i) for i in np.argwhere(bad)[0])
        raise DataError(
            f"the uncertainty of direction {n}, channel {c}, time {t} is {array[t, n, c]:g}; "
            f"{int(bad.sum())} of {bad.size} are not above 0 and finite",
            "An uncertainty is one standard deviation [1/sr]; give NaN where it is not known",
        )
    return array


def share(common_uncertainty: float) -> float:
    """The uncertainty of a scale that all samples share, relative, checked."""
    if not 0 < common_uncertainty < 1:
        raise DataError(
            f"common_uncertainty = {common_uncertainty:g} is outside (0, 1)",
            "It is relative: 0.02 is 2 % of the scale; leave it out where none is known",
        )
    return float(common_uncertainty)


def broadcast_mask(mask: ArrayLike | None, shape: tuple[int, ...]) -> NDArray[np.bool_] | None:
    """A mask in the shape of the values."""
    if mask is None:
        return None
    mask = np.asarray(mask, bool)
    try:
        return np.broadcast_to(mask, shape)
    except ValueError:
        raise DataError(
            f"The mask has shape {mask.shape}, which does not broadcast to {shape}", "Give (T, N, C)"
        ) from None


def channel_names(
    channels: Sequence[str] | None, wavelengths: NDArray[np.float64] | None, n_channels: int
) -> tuple[str, ...]:
    """The names that are given, or those that go without saying: of wavelengths, grey, R, G and B."""
    if channels is None:
        if wavelengths is not None:
            return tuple(f"{w:g} nm" for w in wavelengths)
        return {1: ("grey",), 3: ("R", "G", "B")}.get(n_channels) or tuple(
            f"channel {i + 1}" for i in range(n_channels)
        )
    names = (channels,) if isinstance(channels, str) else tuple(str(c) for c in channels)
    if len(names) != n_channels or len(set(names)) != n_channels:
        raise DataError(
            f"The channels are named {list(names)[:8]} for {n_channels} channels",
            "Give as many different names as channels",
        )
    return names


def some(array: NDArray[Any]) -> str:
    """The first numbers of an array, for a message."""
    array = array.reshape(-1)
    shown = ", ".join(f"{x:g}" for x in array[:5])
    return f"({shown}{', ...' if len(array) > 5 else ''})"
