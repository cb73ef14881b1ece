"""Numbers and directions in sentences."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.certification.specimen import Floats


def plain(array: Floats | Sequence[float] | float, digits: int = 6) -> object:
    """Floats as JSON takes them: rounded to so many digits, None for what is no finite number."""
    if isinstance(array, (float, int, np.floating)):
        return float(f"{array:.{digits}g}") if np.isfinite(array) else None
    return [plain(part, digits) for part in np.asarray(array)]


def typical(values: NDArray[np.floating[Any]]) -> float:
    """The median size of what is finite; 0 where nothing is."""
    finite = np.abs(values[np.isfinite(values)])
    return float(np.median(finite)) if finite.size else 0.0


def degrees(wi: Floats, wo: Floats) -> str:
    """A pair of directions as angles: ``theta_i = 40°, theta_r = 40°, 180° apart in azimuth``."""
    polar = np.degrees([np.arctan2(np.hypot(w[0], w[1]), w[2]) for w in (wi, wo)])
    apart = np.degrees(np.arctan2(wi[0] * wo[1] - wi[1] * wo[0], wi[0] * wo[0] + wi[1] * wo[1])) % 360
    return f"theta_i = {polar[0]:.4g}°, theta_r = {polar[1]:.4g}°, {apart:.3g}° apart in azimuth"


def share(part: float) -> str:
    """``12 %``, ``0.3 %``."""
    return f"{100 * part:.2g} %" if part < 0.095 else f"{100 * part:.0f} %"
