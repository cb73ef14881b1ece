"""From radiance to a picture: exposure, tone mapping, sRGB.

``neutral``, the default, is the Khronos PBR Neutral Tone Mapper (specification of 2024; for showing materials): colours below 0.76 stay as they are, but for
the small offset by which it takes off the 4 % of grey that a dielectric's surface adds; above, highlights roll off towards white instead of clipping.
``clip`` cuts at 1: what is below is shown exactly.  Files of radiance (EXR, PFM) are never tone mapped.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.errors import MotesError

Floats = NDArray[np.floating[Any]]
F90, START, DESATURATION = 0.04, 0.8 - 0.04, 0.15  # of the specification


def neutral(linear: ArrayLike) -> Floats:
    """Khronos PBR Neutral: linear RGB (..., 3) to linear RGB within [0, 1]."""
    x = np.maximum(np.asarray(linear, np.float64), 0)
    least = x.min(axis=-1, keepdims=True)
    x = x - np.where(least < 2 * F90, least - least**2 / (4 * F90), F90)
    peak = x.max(axis=-1, keepdims=True)
    room = 1 - START
    new = 1 - room**2 / (np.maximum(peak, START) + room - START)
    rolled = x * new / np.maximum(peak, START)
    grey = 1 - 1 / (DESATURATION * (np.maximum(peak, START) - new) + 1)
    return np.where(peak < START, x, rolled + grey * (new - rolled))


def clip(linear: ArrayLike) -> Floats:
    """Cut at 0 and 1."""
    return np.clip(np.asarray(linear, np.float64), 0, 1)


OPERATORS: dict[str, Callable[[ArrayLike], Floats]] = {"neutral": neutral, "clip": clip}


def stated(tone: str, exposure: float) -> str:
    """A sentence that says what was done."""
    how = {"neutral": "Khronos PBR Neutral", "clip": "clipped at 1"}[tone]
    return f"{how}, exposure {exposure:+g} EV, sRGB"


def picture(linear: ArrayLike, tone: str = "neutral", exposure: float = 0.0) -> NDArray[np.uint8]:
    """Radiance (H, W, 3) as 8-bit sRGB.

    Parameters
    ----------
    linear
        Radiance in linear sRGB; what is not a number becomes black.
    tone
        A name of `OPERATORS`.
    exposure
        In stops: the radiance is multiplied by 2**exposure.

    Raises
    ------
    MotesError
        For an unknown operator or an exposure that is not a number.
    """
    from motes.rendering import load_mitsuba

    if tone not in OPERATORS:
        raise MotesError(f"{str(tone)[:80]!r} is not a tone mapping", f"Choose one of {', '.join(OPERATORS)}")
    if not (np.isfinite(exposure) and abs(exposure) <= 64):
        raise MotesError(f"an exposure of {exposure:g} EV", "Give stops, such as 1 for twice as bright")
    mi = load_mitsuba()
    values = np.nan_to_num(np.asarray(linear, np.float64), nan=0.0, posinf=1e6, neginf=0.0)
    shown = OPERATORS[tone](values * 2.0**exposure)
    bitmap = mi.Bitmap(np.ascontiguousarray(shown, np.float32))
    encoded = np.array(bitmap.convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, True))
    return np.round(255 * encoded).astype(np.uint8)  # straight to 8 bits Mitsuba would cut off
