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


def _facets(theta_i: Any, theta_r: Any, dphi: Any) -> tuple[Any, Any]:
    """cos(theta_i) cos(theta_r), and the angle theta_h of the half vector."""
    i = (mp.sin(theta_i), 0, mp.cos(theta_i))
    r = (mp.sin(theta_r) * mp.cos(dphi), mp.sin(theta_r) * mp.sin(dphi), mp.cos(theta_r))
    h = [a + b for a, b in zip(i, r, strict=True)]
    return i[2] * r[2], mp.atan2(mp.hypot(h[0], h[1]), h[2])


@_rows
def ggx(theta_i: Any, theta_r: Any, dphi: Any, alpha: Any) -> Any:
    """Walter et al. 2007, (33), with Heitz' Lambda, (72), and his height-correlated masking, (99); F = 1."""
    cosines, theta_h = _facets(theta_i, theta_r, dphi)
    D = alpha**2 / (mp.pi * mp.cos(theta_h) ** 4 * (alpha**2 + mp.tan(theta_h) ** 2) ** 2)
    Lambda = [(mp.sqrt(1 + (alpha * mp.tan(t)) ** 2) - 1) / 2 for t in (theta_i, theta_r)]
    return D / (1 + sum(Lambda)) / (4 * cosines)


@_rows
def beckmann(theta_i: Any, theta_r: Any, dphi: Any, alpha: Any) -> Any:
    """Walter et al. 2007, (25), with Heitz' Lambda, (66), and his height-correlated masking, (99); F = 1."""
    cosines, theta_h = _facets(theta_i, theta_r, dphi)
    D = mp.exp(-((mp.tan(theta_h) / alpha) ** 2)) / (mp.pi * alpha**2 * mp.cos(theta_h) ** 4)

    def Lambda(theta: Any) -> Any:
        if theta == 0:
            return mp.mpf(0)
        a = 1 / (alpha * mp.tan(theta))
        return (mp.exp(-(a**2)) / (a * mp.sqrt(mp.pi)) - mp.erfc(a)) / 2

    return D / (1 + Lambda(theta_i) + Lambda(theta_r)) / (4 * cosines)


@_rows
def given_back(missing_i: Any, missing_r: Any, mean: Any, fresnel: Any, stays: Any) -> Any:
    """Kulla, Conty 2017, by the series: reflected twice at least, and at each facet from the second on a share 1 - `stays` leaves."""
    series = sum(fresnel**2 * (1 - stays) * (fresnel * stays) ** k for k in range(45))
    return missing_i * missing_r / (mp.pi * mean) * series


@_rows
def gtr(theta_i: Any, theta_r: Any, dphi: Any, alpha: Any, gamma: Any, masking: Any) -> Any:
    """Burley 2012, appendix B: D of any gamma with its constant; masked as GGX of roughness `masking`; F = 1."""
    cosines, theta_h = _facets(theta_i, theta_r, dphi)
    a2 = alpha**2
    if gamma == 1:
        constant = (a2 - 1) / (mp.pi * mp.log(a2))
    else:
        constant = (gamma - 1) * (a2 - 1) / (mp.pi * (1 - a2 ** (1 - gamma)))
    D = constant / (a2 * mp.cos(theta_h) ** 2 + mp.sin(theta_h) ** 2) ** gamma
    Lambda = [(mp.sqrt(1 + (masking * mp.tan(t)) ** 2) - 1) / 2 for t in (theta_i, theta_r)]
    return D / (1 + sum(Lambda)) / (4 * cosines)


@_rows
def sheen(theta_i: Any, theta_r: Any, dphi: Any, a: Any) -> Any:
    """Conty Estevez, Kulla 2017, (2), over Neubelt and Pettineo's denominator."""
    cosines, theta_h = _facets(theta_i, theta_r, dphi)
    D = (2 + 1 / a) * mp.sin(theta_h) ** (1 / a) / (2 * mp.pi)
    return D / (4 * (mp.cos(theta_i) + mp.cos(theta_r) - cosines))


@_rows
def hapke(theta_i: Any, theta_r: Any, dphi: Any, w: Any, g: Any, B_0: Any, h: Any) -> Any:
    """Hapke 1981, (16) with (22), by the phase angle; BRDF: his reflectance over the cosine of incidence."""
    mu_0, mu = mp.cos(theta_i), mp.cos(theta_r)
    cos_phase = mu_0 * mu + mp.sin(theta_i) * mp.sin(theta_r) * mp.cos(dphi)
    phase = mp.acos(max(min(cos_phase, 1), -1))
    P = (1 - g**2) / (1 + 2 * g * cos_phase + g**2) ** mp.mpf(1.5)
    B = B_0 / (1 + mp.tan(phase / 2) / h)
    H = [(1 + 2 * x) / (1 + 2 * x * mp.sqrt(1 - w)) for x in (mu_0, mu)]
    return w / (4 * mp.pi) / (mu_0 + mu) * ((1 + B) * P + H[0] * H[1] - 1)


def _fresnel(cosine: Any, n: Any) -> Any:
    """By Snell's law and the angles."""
    theta = mp.acos(cosine)
    inside = mp.asin(mp.sin(theta) / n)
    if theta == 0:
        return ((n - 1) / (n + 1)) ** 2
    s, p = mp.sin(theta - inside) / mp.sin(theta + inside), mp.tan(theta - inside) / mp.tan(theta + inside)
    return (s**2 + p**2) / 2


@_rows
def mean_fresnel(n: Any) -> Any:
    """The mean of F for diffuse light from outside, by quadrature."""
    return mp.quad(lambda mu: 2 * mu * _fresnel(mu, n), [0, 0.01, 0.1, 0.5, 1])


@_rows
def coated_diffuse(theta_i: Any, theta_r: Any, dphi: Any, rho: Any, n: Any, mean: Any) -> Any:
    """Transmitted, reflected by the body, transmitted; and what the interface sends back inside, again."""
    inside = 1 - (1 - mean) / n**2
    through = (1 - _fresnel(mp.cos(theta_i), n)) * (1 - _fresnel(mp.cos(theta_r), n)) / n**2
    return rho / mp.pi * through / (1 - rho * inside)


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
