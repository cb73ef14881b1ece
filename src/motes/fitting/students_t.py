"""Quantiles of Student's t, for intervals behind which few independent parts stand."""

from __future__ import annotations

import math
from functools import lru_cache
from statistics import NormalDist

import numpy as np

# From so many degrees of freedom on it is the normal distribution, to a part in a million.
MANY = 1e6
# Points of the quadrature: the integrand is smooth, and this is exact to rounding for 1 degree of freedom and more.
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(400)


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
    # With t = sqrt(freedom) tan(a) the density is cos(a)^(freedom - 1), over a in [0, pi/2).
    whole = 0.5 * math.sqrt(math.pi) * math.exp(math.lgamma(0.5 * freedom) - math.lgamma(0.5 * (freedom + 1)))

    def inside(angle: float) -> float:
        at = 0.5 * angle * (_NODES + 1)
        return 0.5 * angle * float(_WEIGHTS @ np.cos(at) ** (freedom - 1)) / whole

    low, high = 0.0, 0.5 * math.pi
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if inside(middle) < level else (low, middle)
    return math.sqrt(freedom) * math.tan(0.5 * (low + high))
