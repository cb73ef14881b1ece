"""A highlight of GGX and a Lambertian body under dust of several scatterings, written out a second time: what tests compare with."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

import layer_network
from golden import published
from motes.models.bending import FITTED
from motes.models.facet_albedo import GGX_ALBEDO

Floats = NDArray[np.float64]
F = FITTED


def share(mu: Floats, alpha: Floats) -> Floats:
    """What GGX reflects of light from a direction, F = 1."""
    x = mu / (mu + GGX_ALBEDO.scale * alpha)
    terms = [c * alpha**j * x**k for j, row in enumerate(GGX_ALBEDO.lost) for k, c in enumerate(row)]
    return 1 - (1 - x) ** GGX_ALBEDO.power * np.sum(terms, axis=0)


def nodes(count: int) -> list[tuple[float, float]]:
    x, weights = np.polynomial.legendre.leggauss(count)
    return [(float(0.5 * (a + 1)), float(0.5 * (a + 1) * b)) for a, b in zip(x, weights, strict=True)]


def added(
    theta_i: Floats,
    theta_r: Floats,
    dphi: Floats,
    tau: Floats,
    w: Floats,
    g: Floats,
    body: Floats,
    K_s: Floats,
    alpha: Floats,
) -> Floats:
    """The BRDF [1/sr] without light scattered once by dust alone and without what goes straight through."""
    mu_i, mu_r = np.cos(theta_i), np.cos(theta_r)
    ahead, back = np.maximum(g, 1e-3), np.minimum(g, 0)
    widths = [(1 - q) / np.sqrt(q) for q in (ahead, np.maximum(ahead**1.5, 0.01))]
    tail = [1 + F["far"] * (1 - q) + F["far_2"] * (1 - q) ** 2 for q in (ahead, ahead**1.5)]
    height = [np.ones_like(g), F["height"] + F["height_g"] * ahead]
    kept = [(1 + back) / (1 - back) ** 2 * h / t for h, t in zip(height, tail, strict=True)]
    own = [alpha**2 / (alpha**2 + F[name] * width**2) for name, width in zip(("own", "own_again"), widths, strict=True)]

    def shares(mu: Floats) -> tuple[Floats, Floats, Floats, Floats, Floats, Floats]:
        """Straight, arriving, once, again, and what counts as diffuse."""
        _, arriving = layer_network.functions(mu, tau, w, g)
        straight = np.exp(-tau / mu)
        diffuse = arriving - straight
        x = w * tau / (mu + F["horizon"])
        several = x * (F["once"] + F["once_g"] * ahead + F["once_g2"] * ahead**2) + x**2 * (
            F["twice"] + F["twice_g"] * ahead
        )
        once = diffuse / (1 + several)
        bent = (1 - F["bent"] * ahead**2) * (1 + (F["level"] + F["level_g"] * (ahead - 0.7)) * (mu - 0.7))
        again = (diffuse - once) * np.minimum(bent / (1 + F["deep"] * w * tau / (mu + 0.3)), 1)
        near = sum(part * (o + (1 - o) * k) for part, o, k in zip((once, again), own, kept, strict=True))
        return straight, diffuse, once, again, np.maximum(diffuse - near, 0), K_s * share(mu, alpha)

    s_i, d_i, once_i, again_i, rest_i, a_i = shares(mu_i)
    s_r, d_r, once_r, again_r, rest_r, a_r = shares(mu_r)
    # Scattered once, and more often.
    x = np.abs(tau / mu_i - tau / mu_r)
    single = w * tau / (mu_i * mu_r) * np.maximum(s_i, s_r) * (1 + x / 6) / (1 + 2 * x / 3 + x**2 / 6)
    several = s_i * again_r + s_r * again_i + (once_i + again_i) * (once_r + again_r)
    uneven = np.minimum((mu_i + mu_r) ** 2 / (4 * mu_i * mu_r), F["uneven"])
    steep = (1 + F["steep"] * (mu_i * mu_r - 0.5)) * uneven / (mu_i + mu_r)
    weights = [single * (s_i * a_i + s_r * a_r), several * steep * (a_i + a_r)]
    # The lobe, from the angles.
    cos_gamma = np.sin(theta_i) * np.sin(theta_r) * np.cos(dphi) + mu_i * mu_r
    cos_d = np.sqrt((1 + cos_gamma) / 2)
    tilt = 1 - ((mu_i + mu_r) / (2 * cos_d)) ** 2
    deviation = 4 * tilt * cos_d**2 + (mu_i - mu_r) ** 2
    lobes = []
    for width, again in zip(widths, ("", "_again"), strict=True):
        bend = F["bend" + again] / (1 + F["narrower" + again] * alpha) * width
        along, across = 2 * F["width"] * alpha + bend, 2 * F["width"] * alpha * cos_d + bend
        # (1/across^2 - 1/along^2) cos_d^2 / (1 - cos_d^2), of which the sine cancels.
        turned = 2 * F["width"] * alpha * (along + across) / (along * across) ** 2 * cos_d**2 / (1 + cos_d)
        fall = 1 + (1 / along**2 - turned) * deviation + turned * 4 * tilt
        lobes.append((1 / 4 + 1 / (along * across)) / np.pi / fall**2)
    blurred = sum((1 - o) * k * q * lobe for o, k, q, lobe in zip(own, kept, weights, lobes, strict=True))
    own_weight = own[0] * single * (s_i + s_r) * (mu_i + mu_r) / 2 + own[1] * several
    sharp = own_weight * K_s * published.ggx(theta_i, theta_r, dphi, alpha)
    # Diffuse exchange.
    mean = K_s * sum(share(np.full_like(tau, node), alpha) * weight for node, weight in nodes(6))
    mean_rest = sum(shares(np.full_like(tau, node))[4] * weight for node, weight in nodes(3))
    lit_i, lit_r = (s_i + once_i + again_i) * a_i, (s_r + once_r + again_r) * a_r
    first = (lit_i + lit_r) * rest_i * rest_r / np.maximum(mean_rest, 1e-9) + mean * rest_i * rest_r
    first += 0.5 * F["lost"] * alpha**2 * w * tau * (s_i**2 * a_i / mu_i + s_r**2 * a_r / mu_r)
    first += body * (s_i * d_r + d_i * s_r + d_i * d_r)
    up_i, up_r = body * (s_i + d_i) + lit_i + mean * rest_i, body * (s_r + d_r) + lit_r + mean * rest_r
    returned = layer_network.returned(tau, w, g)
    first += returned * up_i * up_r / np.maximum(1 - returned * (body + mean), 1e-3)
    higher = layer_network.brdf(theta_i, theta_r, dphi, tau, w, g, np.zeros_like(tau))
    return higher + blurred + sharp + first / np.pi
