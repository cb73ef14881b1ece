"""How far a fit is from the data, in one number each."""

from __future__ import annotations

import math

import numpy as np

from motes.fitting.losses import LOSSES, Floats


def rms(x: Floats) -> float:
    """The root mean square; NaN of nothing."""
    return float(np.sqrt(np.mean(np.square(x)))) if x.size else math.nan


def relative_rms(fitted: Floats, measured: Floats) -> float:
    """RMS(f - r) / RMS(r)."""
    return rms(fitted - measured) / max(rms(measured), 1e-300)


def distances(fitted: Floats, measured: Floats, cosines: Floats) -> dict[str, float]:
    """The relative RMS, and the root mean square of the residuals of each loss, over samples (n,) that are not masked."""
    found = {"relative_rms": relative_rms(fitted, measured)}
    for name, loss in LOSSES.items():
        found[f"rms_{name}"] = rms(loss.transform(fitted, cosines) - loss.transform(measured, cosines))
    return found


def chi_square(objective: float, factor: float | None, freedom: int) -> dict[str, float]:
    """Chi-square and the reduced one, where the weights are inverse variances times `factor`; nothing elsewhere."""
    if factor is None:
        return {}
    total = 2 * objective / factor
    return {"chi_square": total, "reduced_chi_square": total / max(freedom, 1)}
