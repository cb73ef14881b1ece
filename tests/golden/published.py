"""Models in 50-digit arithmetic, written from their papers in angles: they share no code, and no rearrangement, with Motes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath as mp
import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def _rows(one: Callable[..., Any]) -> Callable[..., Floats]:
    """The function of numbers, of columns."""

    def of_columns(*columns: Floats) -> Floats:
        with mp.workdps(50):
            rows = zip(*(np.ravel(x).tolist() for x in np.broadcast_arrays(*columns)), strict=True)
            return np.array([float(one(*map(mp.mpf, row))) for row in rows])

    return of_columns


def _fujii(r: Any) -> tuple[Any, Any]:
    """A and B of Fujii's lobe."""
    A = 1 / (1 + (mp.mpf(1) / 2 - 2 / (3 * mp.pi)) * r)
    return A, r * A


def _fujii_albedo(theta: Any, r: Any) -> Any:
    """Its directional albedo for a white surface."""
    A, B = _fujii(r)
    sine, cosine = mp.sin(theta), mp.cos(theta)
    G = sine * (theta - sine * cosine) + mp.mpf(2) / 3 * (sine / cosine * (1 - sine**3) - sine)
    return A + B / mp.pi * G


def _coloured(rho: Any, r: Any) -> tuple[Any, Any]:
    """The mean albedo of a white surface, and the colour of what is reflected more than once."""
    A, B = _fujii(r)
    average = A + B * (mp.mpf(2) / 3 - 28 / (15 * mp.pi))
    return average, rho**2 * average / (1 - rho * (1 - average))


@_rows
def eon(theta_i: Any, theta_r: Any, dphi: Any, rho: Any, r: Any) -> Any:
    """Portsmouth, Kutz, Hill 2024: Fujii's lobe, and the term that gives back what it loses."""
    s = mp.sin(theta_i) * mp.sin(theta_r) * mp.cos(dphi)
    t = max(mp.cos(theta_i), mp.cos(theta_r)) if s > 0 else mp.mpf(1)
    single = rho / mp.pi * _fujii(r)[0] * (1 + r * s / t)
    average, colour = _coloured(rho, r)
    if average == 1:
        return single
    lost = (1 - _fujii_albedo(theta_i, r)) * (1 - _fujii_albedo(theta_r, r))
    return single + colour / mp.pi * lost / (1 - average)


@_rows
def eon_albedo(theta: Any, rho: Any, r: Any) -> Any:
    """The directional albedo of `eon`, exactly."""
    albedo = _fujii_albedo(theta, r)
    return rho * albedo + _coloured(rho, r)[1] * (1 - albedo)
