"""Numbers about whole maps, block by block: quartiles of each parameter, and the distance from the truth where it is known."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motes.maps.fitted import FittedMap
from motes.maps.stack import MapStack

MOST = 400_000  # values of a map that quantiles are taken of


def quartiles(fitted: FittedMap) -> dict[str, tuple[float, float, float, float]]:
    """By map: lower quartile, median, upper quartile, and the median standard error; NaN where nothing is fitted.

    Of evenly spaced texels where there are many.
    """
    step = stride(fitted, MOST)
    where = (slice(step // 2, None, step), slice(step // 2, None, step))
    found = {}
    for name in fitted.variables:
        values, errors = (_finite(fitted.read_map(n, where)) for n in (name, f"{name}_stderr"))
        low, middle, high = np.quantile(values, (0.25, 0.5, 0.75)) if len(values) else (np.nan,) * 3
        found[name] = (float(low), float(middle), float(high), float(np.median(errors)) if len(errors) else np.nan)
    return found


def stride(fitted: FittedMap, most: int) -> int:
    """Every how many-th row and column to take so that a map gives at most so many values."""
    times = 1 if fitted.joint else len(fitted.hours)
    total = fitted.shape[0] * fitted.shape[1] * times * len(fitted.channels)
    step = max(1, int(np.ceil(np.sqrt(total / most))))
    return min(step, *(max(1, n) for n in fitted.shape))


def compare(
    fitted: FittedMap, stack: MapStack, names: tuple[str, ...] | None = None
) -> dict[str, dict[str, float | None]]:
    """How far the parameters are from a map's `truth`.

    Parameters
    ----------
    fitted, stack
        A fit of the map.
    names
        Parameters; those that are both fitted and known when not given.

    Returns
    -------
    dict
        By parameter: ``median_truth``, ``median_error`` (of the absolute errors), ``p90_error``, ``rms_error``, ``bias`` (mean error),
        ``within_2_stderr`` (the share; None where trends were fitted) and ``texels`` (values compared).
    """
    step = stride(fitted, 4 * MOST)
    where = (slice(step // 2, None, step), slice(step // 2, None, step))
    result: dict[str, dict[str, float | None]] = {}
    for name in names or [q for q in fitted.quantities if q in stack.truth]:
        value, true = fitted.values(name, where), np.asarray(stack.truth[name][where], float)
        time = fitted.plan.settings.time
        true = true if time is None else true[:, :, time : time + 1]
        good = np.isfinite(value) & np.isfinite(true)
        if not good.any():
            continue
        error = value[good] - true[good]
        size = np.abs(error)
        inside = None
        if not fitted.joint:
            stderr = np.broadcast_to(fitted.read_map(f"{name}_stderr", where), value.shape)[good]
            known = np.isfinite(stderr)
            inside = float(np.mean(size[known] <= 2 * stderr[known])) if known.any() else None
        result[name] = {
            "median_truth": float(np.median(true[good])),
            "median_error": float(np.median(size)),
            "p90_error": float(np.quantile(size, 0.9)),
            "rms_error": float(np.sqrt(np.mean(error**2))),
            "bias": float(error.mean()),
            "within_2_stderr": inside,
            "texels": int(good.sum()),
        }
    return result


def _finite(values: NDArray[np.float32]) -> NDArray[np.float64]:
    flat = values.astype(float).ravel()
    return np.asarray(flat[np.isfinite(flat)])
