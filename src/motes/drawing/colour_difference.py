"""How different two colours look: Delta E ITP of ITU-R BT.2124, which holds for dim and bright colours alike.

About 1 is a difference that an eye which is adapted to these colours just sees.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]

#: The luminance of a white diffuser [cd/m^2], ITU-R BT.2408.
WHITE = 203.0
# Linear sRGB to linear BT.2020, ITU-R BT.2087; that to cones' responses, and those encoded to I, T, P: ITU-R BT.2100 and BT.2124.
TO_2020 = np.array([[0.6274, 0.3293, 0.0433], [0.0691, 0.9195, 0.0114], [0.0164, 0.0880, 0.8956]])
TO_LMS = np.array([[1688, 2146, 262], [683, 2951, 462], [99, 309, 3688]]) / 4096
TO_ITP = np.array([[2048, 2048, 0], [0.5 * 6610, -0.5 * 13613, 0.5 * 7003], [17933, -17390, -543]]) / 4096
# Constants of the perceptual quantiser, BT.2100 table 4; its peak [cd/m^2].
M1, M2 = 2610 / 16384, 2523 / 4096 * 128
C1, C2, C3 = 3424 / 4096, 2413 / 4096 * 32, 2392 / 4096 * 32
PEAK = 10_000.0


def perceptual_quantiser(luminance: ArrayLike) -> Floats:
    """The code in [0, 1] of a luminance [cd/m^2], clipped to 0 and 10,000.

    Examples
    --------
    >>> perceptual_quantiser([0.0, 100.0, 203.0, 10_000.0]).round(3)
    array([0.   , 0.508, 0.581, 1.   ])
    """
    y = np.clip(np.asarray(luminance, float) / PEAK, 0, 1) ** M1
    return np.asarray(((C1 + C2 * y) / (1 + C3 * y)) ** M2)


def itp(linear: ArrayLike) -> Floats:
    """I, T and P (..., 3) of linear sRGB (..., 3), of which 1 is the luminance of a white diffuser."""
    lms = WHITE * np.asarray(linear, float) @ (TO_LMS @ TO_2020).T
    return np.asarray(perceptual_quantiser(lms) @ TO_ITP.T)


def delta_e_itp(a: ArrayLike, b: ArrayLike) -> Floats:
    """The difference of two colours in linear sRGB (..., 3), of which 1 is a white diffuser; shape (...).

    Examples
    --------
    >>> float(delta_e_itp([0.5, 0.5, 0.5], [0.5, 0.5, 0.5]))
    0.0
    """
    return np.asarray(720 * np.linalg.norm(itp(a) - itp(b), axis=-1))
