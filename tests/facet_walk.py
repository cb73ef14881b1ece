"""Light on mirror-like facets of random heights, ray by ray, from E. Heitz, J. Hanika, E. d'Eon, C. Dachsbacher, "Multiple-scattering microfacet BSDFs
with the Smith model", SIGGRAPH 2016: written from the paper, it shares no code with Motes."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import erfc

Floats = NDArray[np.float64]
Rng = np.random.Generator


class Walked(NamedTuple):
    """Where rays leave (N, 3), what is left of each for each F (N, T), and how many facets it met (N,)."""

    out: Floats
    left: Floats
    met: NDArray[np.int64]


def ggx_lambda(a: Floats) -> Floats:
    return (-1 + np.sqrt(1 + 1 / (a * a))) / 2


def beckmann_lambda(a: Floats) -> Floats:
    return (np.exp(-a * a) / (a * np.sqrt(np.pi)) - erfc(a)) / 2


def ggx_normals(w: Floats, alpha: float, rng: Rng) -> Floats:
    """Normals (N, 3) of facets that directions w (N, 3), up or down, see: the half disc of Heitz, JCGT 7(4), 2018."""
    v = w * (alpha, alpha, 1)
    v /= np.linalg.norm(v, axis=-1, keepdims=True)
    flat = np.maximum(np.hypot(v[:, 0], v[:, 1]), 1e-12)
    one = np.stack([-v[:, 1] / flat, v[:, 0] / flat, 0 * flat], -1)
    other = np.cross(v, one)
    r, phi = np.sqrt(rng.random(len(w))), 2 * np.pi * rng.random(len(w))
    x, s = r * np.cos(phi), 0.5 * (1 + v[:, 2])
    y = (1 - s) * np.sqrt(1 - x * x) + s * (r * np.sin(phi))
    z = np.sqrt(np.maximum(1 - x * x - y * y, 0))
    normal = x[:, None] * one + y[:, None] * other + z[:, None] * v
    return _unit(np.stack([alpha * normal[:, 0], alpha * normal[:, 1], np.maximum(normal[:, 2], 1e-12)], -1))


def beckmann_normals(w: Floats, alpha: float, rng: Rng) -> Floats:
    """The same of Gaussian slopes: across w they are Gaussian, along it a root of what lies beyond, found by halving."""
    sine = np.maximum(np.hypot(w[:, 0], w[:, 1]), 1e-12)

    def beyond(s: Floats) -> Floats:
        """The integral of (cos + sin t) exp(-(t/alpha)^2) from s = alpha x on, over alpha sqrt(pi)."""
        return 0.5 * w[:, 2] * erfc(s) + alpha * sine / (2 * np.sqrt(np.pi)) * np.exp(-s * s)

    low = np.maximum(-w[:, 2] / (alpha * sine), -6.0)
    high, wanted = np.maximum(low, 0) + 6.0, rng.random(len(w)) * beyond(low)
    for _ in range(40):
        middle = 0.5 * (low + high)
        more = beyond(middle) > wanted
        low, high = np.where(more, middle, low), np.where(more, high, middle)
    along, across = alpha * low, alpha * np.sqrt(0.5) * rng.normal(size=len(w))
    c, s = w[:, 0] / sine, w[:, 1] / sine
    return _unit(np.stack([along * c - across * s, along * s + across * c, np.ones(len(w))], -1))


FACETS = {"ggx": (ggx_lambda, ggx_normals), "beckmann": (beckmann_lambda, beckmann_normals)}


def walk(kind: str, alpha: float, cosine: Floats, F: Callable[[Floats], Floats], rng: Rng, most: int = 300) -> Walked:
    """Rays from directions of these cosines (N,).

    Heights are uniform in (-1, 1). A ray gets from height h to h' without meeting a facet with the chance (C(h)/C(h'))^Lambda, C = (1 + h)/2; going
    down Lambda is below -1.  At a facet it is mirrored, and a share F of it is left: ``F(cosine)`` (N, T), for T kinds of facets at once.
    """
    Lambda_of, normals = FACETS[kind]
    count = len(cosine)
    w = np.stack([np.sqrt(1 - cosine * cosine), 0 * cosine, -cosine], -1)  # on its way down
    C, left, at = np.full(count, 1.0), np.ones((count, F(cosine).shape[1])), np.arange(count)
    done = Walked(np.zeros((count, 3)), 0 * left, np.zeros(count, int))
    for _ in range(most):
        up = w[:, 2] > 0
        size = np.clip(np.abs(w[:, 2]), 1e-9, 1 - 1e-12)
        Lambda = Lambda_of(size / (alpha * np.sqrt(1 - size * size)))
        Lambda = np.where(up, np.maximum(Lambda, 1e-12), -1 - Lambda)
        u = np.maximum(rng.random(len(at)), 1e-12)
        leaves = up & (u < C ** np.where(up, Lambda, 0))
        done.out[at[leaves]], done.left[at[leaves]] = w[leaves], left[leaves]
        at, w, C, left, u, Lambda = (x[~leaves] for x in (at, w, C, left, u, Lambda))
        if not len(at):
            break
        C = np.clip(C / u ** (1 / Lambda), 1e-12, 1)
        normal = normals(-w, alpha, rng)
        facing = np.einsum("nk,nk->n", -w, normal)
        left = left * F(np.clip(facing, 0, 1))
        done.met[at] += 1
        w = w + 2 * facing[:, None] * normal
    return done


def white(cosine: Floats) -> Floats:
    """F = 1."""
    return np.ones((len(cosine), 1))


def _unit(v: Floats) -> Floats:
    return v / np.linalg.norm(v, axis=-1, keepdims=True)
