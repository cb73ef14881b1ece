"""How far a fit is from the data, in one number each."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.arrays import dot
from motes.fitting.data_passes import in_slices
from motes.fitting.losses import LOSSES, Floats

# Samples, or directions, that are worked on at a time.
BLOCK = 8192
# The median of the size of normal noise is its standard deviation over this.
MEDIAN_TO_DEVIATION = 1.4826
# Rows of more numbers are partitioned rather than sorted.
LONG = 1024


def rms(x: Floats) -> float:
    """The root mean square; NaN of nothing."""
    return math.sqrt(dot(x, x) / x.size) if x.size else math.nan


def relative_rms(fitted: Floats, measured: Floats) -> float:
    """RMS(f - r) / RMS(r)."""
    return rms(fitted - measured) / max(rms(measured), 1e-300)


def distances(fitted: Floats, measured: Floats, cosines: Floats) -> dict[str, float]:
    """The relative RMS, and the root mean square of the residuals of each loss, over samples (n,) or (n, C) that are not masked.

    NaN for a loss that has no value at a sample: the logarithm of large negative noise.
    """

    # In blocks that stay in cache: each transform makes several arrays.
    def squares(rows: slice) -> list[float]:
        f, m, c = (part[rows] for part in (fitted, measured, cosines))
        with np.errstate(invalid="ignore", divide="ignore"):
            apart = [loss.transform(f, c) - loss.transform(m, c) for loss in LOSSES.values()]
            return [dot(away, away) for away in apart]

    parts = in_slices(squares, len(fitted), BLOCK)
    sums = dict(zip(LOSSES, map(sum, zip(*parts, strict=True)), strict=True)) if parts else dict.fromkeys(LOSSES, 0.0)
    found = {f"rms_{name}": math.sqrt(total / fitted.size) if fitted.size else math.nan for name, total in sums.items()}
    return {"relative_rms": found["rms_plain"] / max(rms(measured), 1e-300)} | found


def deviation(residuals: NDArray[np.floating[Any]], unit: float = 1.0) -> Floats:
    """The standard deviation of normal noise, by the median distance from the median, over the last axis; NaN counts for nothing.

    What is far off hardly moves it: the scale of robust functions.  At least 1e-12 of
    the data's `unit`, since they divide by it.
    """
    measured = np.isfinite(residuals).any(axis=-1)  # the median of nothing is a warning
    found = residuals if measured.all() else residuals[measured]
    spread = np.zeros(residuals.shape[:-1])
    spread[measured] = _medians(np.abs(found - _medians(found)[..., None]))
    return np.maximum(MEDIAN_TO_DEVIATION * spread, 1e-12 * unit)


def _medians(values: NDArray[np.floating[Any]]) -> NDArray[np.floating[Any]]:
    """Those of `numpy.nanmedian` over the last axis, of which each row holds a number: of many short rows, as texels have, in a tenth of the time."""
    if values.ndim < 2 or values.shape[-1] > LONG:
        return np.asarray(np.nanmedian(values, axis=-1))
    ordered = np.sort(values, axis=-1)  # NaN comes last
    count = values.shape[-1] - np.count_nonzero(np.isnan(values), axis=-1)[..., None]
    middle = [np.take_along_axis(ordered, at, axis=-1)[..., 0] for at in ((count - 1) // 2, count // 2)]
    return np.asarray((middle[0] + middle[1]) / 2)


def chi_square(objective: float, factor: float | None, freedom: int) -> dict[str, float]:
    """Chi-square and the reduced one, where the weights are inverse variances times `factor`; nothing elsewhere."""
    if factor is None:
        return {}
    total = 2 * objective / factor
    return {"chi_square": total, "reduced_chi_square": total / max(freedom, 1)}
