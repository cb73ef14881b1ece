"""Quantiles of Student's t, for intervals behind which few independent parts stand."""

from __future__ import annotations

import math
from functools import lru_cache
from statistics import NormalDist

# From so many degrees of freedom on it is the normal distribution, to a part in a million.
MANY = 1e6
# Terms and steps: 60 are enough for all degrees of freedom; what takes more is wrong.
MOST = 500
TINY = 1e-300


@lru_cache(maxsize=4096)
def half_width(level: float, freedom: float) -> float:
    """Within how many standard errors a share `level` of all estimates lies of the truth.

    Parameters
    ----------
    level
        Between 0 and 1.
    freedom
        Degrees of freedom, at least 1.

    Examples
    --------
    >>> round(half_width(0.95, 3.0), 4), round(half_width(0.95, math.inf), 4)
    (3.1824, 1.96)
    """
    if freedom >= MANY:
        return NormalDist().inv_cdf(0.5 + 0.5 * level)
    # With t = sqrt(freedom) tan(a) the density is cos(a)^(freedom - 1) / whole, over a in [0, pi/2): Newton's steps, and halves where they lead out.
    whole = 0.5 * math.sqrt(math.pi) * math.exp(math.lgamma(0.5 * freedom) - math.lgamma(0.5 * (freedom + 1)))
    low, high = 0.0, 0.5 * math.pi
    angle = math.atan(NormalDist().inv_cdf(0.5 + 0.5 * level) / math.sqrt(freedom))
    for _ in range(MOST):
        density = math.cos(angle) ** (freedom - 1) / whole
        missing = level - _inside(angle, freedom, density)
        low, high = (angle, high) if missing > 0 else (low, angle)
        before, angle = angle, angle + missing / density if density > 0 else high
        if not low < angle < high:
            angle = 0.5 * (low + high)
        if abs(angle - before) <= 1e-15 * angle:
            break
    return math.sqrt(freedom) * math.tan(angle)


def _inside(angle: float, freedom: float, density: float) -> float:
    """The share between -t and t: a regularised incomplete beta function, by its continued fraction from the end that is nearer (DLMF 8.17.22)."""
    a, b = 0.5, 0.5 * freedom
    sine, cosine = math.sin(angle), math.cos(angle)
    if sine**2 < (a + 1) / (a + b + 2):
        return density * sine * cosine * _fraction(a, b, sine**2) / a / 2
    return 1 - density * sine * cosine * _fraction(b, a, cosine**2) / b / 2


def _fraction(a: float, b: float, x: float) -> float:
    """The continued fraction 1 / (1 + d1 / (1 + d2 / (1 + ...))) of DLMF 8.17.22, by Lentz's rule."""
    value, up, down = 1.0, 1.0, 0.0
    for k in range(1, MOST):
        m = k // 2
        if k % 2:
            d = -(a + m) * (a + b + m) * x / ((a + k - 1) * (a + k))
        else:
            d = m * (b - m) * x / ((a + k - 1) * (a + k))
        down = 1 / (1 + d * down or TINY)
        up = 1 + d / up or TINY
        value *= up * down
        if abs(up * down - 1) < 1e-16:
            break
    return 1 / value
