r"""Equations (1)-(13), each once: Oren-Nayar, Torrance-Sparrow, and Blinn's dust with the Henyey-Greenstein phase
function.

The source is the three appendices of B. Sun, K. Sunkavalli, R. Ramamoorthi, P. Belhumeur, S. Nayar, "Time-Varying
BRDFs", IEEE TVCG 13(3), 2007 (https://doi.org/10.1109/TVCG.2007.1013).  A function has the name of the symbol it
computes and stands in the order of the source. Nothing here clamps, masks or normalises: what is printed is what is
returned, and the models in `motes.models` say what they add.

Every function takes a namespace ``xp`` first (see `motes.arrays`) and broadcasts its arguments.  Angles are in radians.
They are passed as the functions of them that stay accurate: sines and cosines rather than tangents (tan(acos(0)) is
-2e7 in float32), ``sin2_half_gamma`` rather than cos(gamma) (whose difference from 1 float32 cannot hold)."""

from __future__ import annotations

import math

import numpy as np

from motes.arrays import Array

INV_PI = 0.3183098861837907

# ---------------------------------------------------------------- Appendix A: Oren-Nayar, equations (1)-(8)


def rho_d1(
    xp: Array,
    C1: Array,
    C2: Array,
    C3: Array,
    cos_dphi: Array,
    one_less_abs_cos_dphi: Array,
    tan_beta: Array,
    tan_half: Array,
    K_d: Array,
) -> Array:
    """Equation (1): the direct component [1/sr]; `tan_half` is tan((alpha + beta)/2).

    `one_less_abs_cos_dphi` is its 1 - |cos(phi_r - phi_i)|, which cancels near the plane of incidence.

    It goes negative near grazing forward scatter for sigma_d >= 0.7 (the models clamp it at 0).
    """
    return K_d * INV_PI * (C1 + cos_dphi * C2 * tan_beta + one_less_abs_cos_dphi * C3 * tan_half)


def alpha(xp: Array, theta_r: Array, theta_i: Array) -> Array:
    """Equation (2): the larger polar angle [rad]."""
    return xp.maximum(theta_r, theta_i)


def beta(xp: Array, theta_r: Array, theta_i: Array) -> Array:
    """Equation (3): the smaller polar angle [rad]."""
    return xp.minimum(theta_r, theta_i)


def C1(xp: Array, sigma_d: Array) -> Array:
    """Equation (4)."""
    s2 = sigma_d * sigma_d
    return 1 - 0.5 * (s2 / (s2 + 0.33))


def C2(xp: Array, sin_alpha: Array, sin_alpha_less_cube: Array, cos_dphi: Array, sigma_d: Array) -> Array:
    """Equation (5): switches at cos(phi_r - phi_i) = 0, where its factor in (1) is 0, so that (1) is continuous.

    `sin_alpha_less_cube` is its sin(alpha) - (2 beta/pi)^3, which cancels where both directions graze, and is multiplied by
    tan(beta) there.
    """
    s2 = sigma_d * sigma_d
    return 0.45 * (s2 / (s2 + 0.09)) * xp.where(cos_dphi >= 0, sin_alpha, sin_alpha_less_cube)


def C3(xp: Array, alpha: Array, beta: Array, sigma_d: Array) -> Array:
    """Equation (6)."""
    s2 = sigma_d * sigma_d
    q = (4 * INV_PI * INV_PI) * alpha * beta
    return 0.125 * (s2 / (s2 + 0.09)) * (q * q)


def rho_d2(xp: Array, beta: Array, cos_dphi: Array, sigma_d: Array, K_d: Array) -> Array:
    """Equation (7): the inter-reflection component [1/sr]."""
    s2 = sigma_d * sigma_d
    b = (2 * INV_PI) * beta
    return K_d * K_d * (0.17 * INV_PI) * (s2 / (s2 + 0.13)) * (1 - cos_dphi * (b * b))


def rho_d(xp: Array, rho_d1: Array, rho_d2: Array) -> Array:
    """Equation (8): the total diffuse reflectance [1/sr]."""
    return rho_d1 + rho_d2


# ---------------------------------------------------------------- Appendix B: Torrance-Sparrow, equations (9)-(11)


def rho_s(xp: Array, D: Array, G: Array, F: Array, cos_theta_i: Array, cos_theta_r: Array) -> Array:
    """Equation (9): specular reflectance [1/sr], before the factor K_s."""
    return D * G * F / (4 * cos_theta_i * cos_theta_r)


def D(xp: Array, theta_h: Array, sigma_s: Array) -> Array:
    """Equation (10): the distribution of facet normals; 1 at theta_h = 0, not normalised."""
    t = theta_h / sigma_s
    return xp.exp(-(t * t))


def G(
    xp: Array, cos_theta_i: Array, cos_theta_r: Array, cos_theta_h: Array, wi_dot_wh: Array, wo_dot_wh: Array
) -> Array:
    """Equation (11): shadowing and masking of V-shaped grooves.

    The printed denominators cos(theta_i) cos(theta_h) + sin(theta_i) sin(theta_h) cos(phi_i - phi_h) are wi . wh, and
    likewise for r."""
    shadowing = 2 * cos_theta_i * cos_theta_h / wi_dot_wh
    masking = 2 * cos_theta_r * cos_theta_h / wo_dot_wh
    return xp.maximum(xp.minimum(xp.minimum(shadowing, masking), 1.0), 0.0)


# ---------------------------------------------------------------- Appendix C: top-lit dust, equations (12)-(13)


def rho_dust(xp: Array, Phi: Array, cos_theta_i: Array, cos_theta_r: Array, w: Array) -> Array:
    """Equation (12): the brightness of top-lit dust; with cos(theta_i), so not reciprocal, and without 1/(4 pi)."""
    return w * Phi * (cos_theta_i / (cos_theta_i + cos_theta_r))


def Phi(xp: Array, sin2_half_gamma: Array, cos2_half_gamma: Array, g: Array) -> Array:
    """Equation (13), Henyey-Greenstein; gamma is the deviation: 0 is straight on.  It integrates to 4 pi over the
    sphere.

    The printed 1 + g^2 - 2 g cos(gamma) cancels towards the peak.  It equals (1 - g)^2 + 4 g sin^2(gamma/2) and
    (1 + g)^2 - 4 g cos^2(gamma/2); all terms of the first are positive for g >= 0, all of the second for g <= 0.
    """
    ellipse = xp.where(
        g >= 0,
        (1 - g) * (1 - g) + 4 * g * sin2_half_gamma,
        (1 + g) * (1 + g) - 4 * g * cos2_half_gamma,
    )
    return (1 - g) * (1 + g) / (ellipse * xp.sqrt(ellipse))


# ---------------------------------------------------------------- What the appendices leave to their readers


def fresnel_dielectric(xp: Array, cos_theta: Array, n: Array) -> Array:
    """F of (9) at an interface of relative refractive index n >= 1, unpolarised (Born & Wolf, section 1.5).

    ``q`` is n cos(theta_t) from n^2 - sin^2(theta) = (n - 1)(n + 1) + cos^2(theta), which does not cancel near n = 1.
    """
    q = xp.sqrt((n - 1) * (n + 1) + cos_theta * cos_theta)
    s = (cos_theta - q) / (cos_theta + q)
    p = (n * n * cos_theta - q) / (n * n * cos_theta + q)
    return 0.5 * (s * s + p * p)


def fresnel_conductor(xp: Array, cos_theta: Array, n: Array, k: Array) -> Array:
    """F of (9) for a conductor of complex index n + ik, unpolarised (Born & Wolf, section 14.2).

    a + ib is the root of (n + ik)^2 - sin^2(theta); sums of squares, so never negative.
    """
    c2 = cos_theta * cos_theta
    s2 = 1 - c2
    t = (n - 1) * (n + 1) - k * k + c2
    m = xp.sqrt(t * t + 4 * (n * k) * (n * k))
    a, b2 = xp.sqrt(xp.maximum(0.5 * (m + t), 0.0)), xp.maximum(0.5 * (m - t), 0.0)
    less, more = a - cos_theta, a + cos_theta
    s = (less * less + b2) / (more * more + b2)
    less, more = a * cos_theta - s2, a * cos_theta + s2
    p = s * (less * less + b2 * c2) / (more * more + b2 * c2)
    return 0.5 * (s + p)


def fresnel_normal(n: Array, k: Array) -> Array:
    """F at normal incidence on an interface of index n + ik, where both polarisations agree (Born & Wolf, section 14.2)."""
    less, more = n - 1, n + 1
    return (less * less + k * k) / (more * more + k * k)


def fresnel_schlick(xp: Array, cos_theta: Array, f0: Array) -> Array:
    """F of (9) by Schlick's approximation (1994) from the reflectance at normal incidence f0."""
    m = 1 - cos_theta
    m2 = m * m
    return f0 + (1 - f0) * (m2 * m2 * m)


def dust_brdf(xp: Array, Phi: Array, cos_theta_i: Array, cos_theta_r: Array, w: Array) -> Array:
    """The BRDF of top-lit dust, (12) / (4 pi cos(theta_i)) [1/sr]: reciprocal, and what renders (Blinn 1982)."""
    return w * (0.25 * INV_PI) * (Phi / (cos_theta_i + cos_theta_r))


def slant_depth(xp: Array, cos_theta_i: Array, cos_theta_r: Array, tau: Array) -> Array:
    """Optical thickness along the path in and out of a layer, tau (1/cos(theta_i) + 1/cos(theta_r)) (Blinn 1982)."""
    return tau * (1 / cos_theta_i + 1 / cos_theta_r)


def dust_layer(xp: Array, base: Array, dust: Array, depth: Array) -> Array:
    """A base seen through dust, T f_base + (1 - T) f_dust, T = exp(-depth) (Blinn 1982); expm1 serves thin layers."""
    return xp.exp(-depth) * base - xp.expm1(-depth) * dust


def facet_area(xp: Array, sigma_s: Array) -> Array:
    """Projected area of the facets of (10), the integral of D cos(theta_h) over the hemisphere; about pi sigma_s^2 when
    small.

    It is pi times the integral of exp(-(theta/sigma_s)^2) sin(2 theta) over [0, pi/2].  Up to sigma_s = 0.25 the
    integral to infinity is Dawson's function, a power series, and what lies beyond pi/2 is under 1e-17; above,
    Gauss-Legendre quadrature.  Within 1e-14 of the integral on (0, pi/2]."""
    m = -2 * sigma_s * sigma_s
    series = 1.0
    for k in range(10, 0, -1):
        series = 1 + series * m * (1 / (2 * k + 1))
    narrow = 0.5 * math.pi * -m * series
    wide = 0.0
    for theta, weight in _WIDE_RULE:
        t = theta / sigma_s
        wide = wide + weight * xp.exp(-(t * t))
    return xp.where(sigma_s < 0.25, narrow, wide)


def _wide_rule(n: int) -> list[tuple[float, float]]:
    """Gauss-Legendre nodes theta [rad] on [0, pi/2] and their weights times pi sin(2 theta)."""
    nodes, weights = np.polynomial.legendre.leggauss(n)
    theta = 0.25 * np.pi * (nodes + 1)
    return list(zip(theta.tolist(), (0.25 * np.pi * weights * np.pi * np.sin(2 * theta)).tolist(), strict=True))


_WIDE_RULE = _wide_rule(24)
