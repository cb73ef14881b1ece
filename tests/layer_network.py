"""The fitted form of multiple scattering, written out a second time with matrices: what tests compare the models with."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import motes

Floats = NDArray[np.float64]
NUMBERS = json.loads((Path(motes.__file__).parent / "models/data/multiple_scattering.json").read_text())


def stretched(mu: Floats) -> Floats:
    return np.sqrt(6 * mu / (0.5 + mu)) - 1


def columns(mu: Floats, tau: Floats) -> Floats:
    """What the coefficients of E, t and the first order are multiplied by (..., 8): powers of v, and what comes straight through."""
    return np.concatenate([np.vander(stretched(mu), 7, increasing=True), np.exp(-tau / mu)[:, None]], axis=1)


def network(features: list[Floats], numbers: dict[str, list[list[float]]]) -> Floats:
    h = (np.stack(features, -1) - numbers["mean"]) / numbers["deviation"]
    for weights, offsets in zip(numbers["weights"], numbers["offsets"], strict=True):
        last = weights is numbers["weights"][-1]
        h = h @ np.array(weights) + offsets
        h = h if last else h / np.hypot(1, h)
    return h


def outputs(tau: Floats, w: Floats, g: Floats) -> tuple[Floats, Floats, Floats, Floats, Floats]:
    """Coefficients of E, of t and of the first order (N, 8), c and d (N, 3)."""
    loss, opacity = 1 - w, 1 - w * g

    def tangent(k2: Floats) -> Floats:
        k = np.sqrt(np.maximum(k2, 1e-10))
        return np.tanh(0.5 * k * tau) / k

    q = tangent(3 * loss * opacity)
    k2q2 = np.maximum(3 * loss * opacity, 1e-10) * q**2
    below = 1 + k2q2 + np.sqrt(3) * (loss + opacity) * q
    through, lost = (1 - k2q2) / below, 2 * q * (3 * opacity * q + np.sqrt(3)) / below
    features = [np.sqrt(np.maximum(loss / opacity, 1e-10)), w, g, tau / (1 + tau), tau * opacity / (1 + tau * opacity)]
    features += [through, 1 - through - loss * lost, np.exp(-tau)]
    h = network(features, NUMBERS)
    s = w[:, None] * network([g, np.exp(-tau), 1 / (1 + tau), 1 / (1 + 8 * tau), 1 / (1 + 64 * tau)], NUMBERS["once"])
    k2 = 3 * loss * opacity / (1 + 2 * loss)
    q = tangent(k2)
    k2q2 = np.maximum(k2, 1e-10) * q**2
    deep = w * (1 - k2q2) / (1 + k2q2 + 0.5 * np.sqrt(3) * opacity * q)
    thick = (tau * opacity / (1 + tau * opacity))[:, None]
    scattered = w[:, None]
    e, t, n = (np.zeros((len(tau), 8)) for _ in range(3))
    e[:, :6], t[:, :6], n[:, :4] = scattered**2 * thick * h[:, :6], deep[:, None] * h[:, 6:12], h[:, 12:16]
    unity = np.eye(8)[0]
    unsaid = unity - s - e - t - loss[:, None] * (unity + scattered * lost[:, None] * n)
    return e + scattered * thick * unsaid, t + (1 - thick) * unsaid, s, h[:, 16:19], h[:, 19:22]


def functions(mu: Floats, tau: Floats, w: Floats, g: Floats, least: float = 0.0) -> tuple[Floats, Floats]:
    """E and t."""
    e, t, _, _, _ = outputs(tau, w, g)
    hit = 1 - np.exp(-tau / mu)
    up, down = (np.maximum(np.sum(c * columns(mu, tau), -1), least) for c in (e, t))
    return hit * up, 1 - hit + hit * down


def rule() -> tuple[Floats, Floats]:
    """Cosines and weights of means over uniform light."""
    x, weights = np.polynomial.legendre.leggauss(12)
    nodes = (0.5 * (x + 1)) ** 2
    return nodes, 2 * nodes * 0.5 * weights * 2 * np.sqrt(nodes)


def returned(tau: Floats, w: Floats, g: Floats) -> Floats:
    """The share of uniform light that leaves on its own side."""
    e, _, s, _, _ = outputs(tau, w, g)
    nodes, measure = rule()
    hit = np.stack([1 - np.exp(-tau / node) for node in nodes], -1)
    shape = np.stack([columns(np.full_like(tau, node), tau) for node in nodes], 1)
    up = np.einsum("nk,nmk->nm", e + s, shape) * hit
    back: Floats = np.clip(up @ measure, 0, w * (hit @ measure))
    return back


def brdf(theta_i: Floats, theta_r: Floats, dphi: Floats, tau: Floats, w: Floats, g: Floats, base: Floats) -> Floats:
    """A layer over a Lambertian base (N,) [1/sr], without what is scattered once."""
    _, _, _, c, d = outputs(tau, w, g)
    nodes, measure = rule()
    E = np.stack([functions(np.full_like(tau, node), tau, w, g, -np.inf)[0] for node in nodes], -1)
    v = stretched(nodes)
    mean_e = E @ measure
    means = [(E * (p * measure)).sum(-1) / mean_e for p in (v, v**2)]
    (e_i, t_i), (e_r, t_r) = (functions(np.cos(theta), tau, w, g) for theta in (theta_i, theta_r))
    v_i, v_r = stretched(np.cos(theta_i)), stretched(np.cos(theta_r))
    p_i, p_r = ([v - means[0], v**2 - means[1]] for v in (v_i, v_r))
    bracket = 1 + c[:, 0] * p_i[0] * p_r[0] + c[:, 1] * (p_i[0] * p_r[1] + p_i[1] * p_r[0]) + c[:, 2] * p_i[1] * p_r[1]
    bracket = np.maximum(bracket, 0.05)
    waves = np.sin(theta_i) * np.sin(theta_r) * (d[:, 0] + d[:, 1] * (v_i + v_r) + d[:, 2] * v_i * v_r)
    rho = np.clip(waves / (1.15 * bracket), -0.76, 0.76)
    z = rho * np.exp(1j * (np.pi - dphi))  # the geometric series of the waves
    higher = e_i * e_r / (np.pi * mean_e) * bracket * (1 + 1.15 * 2 * (z / (1 - z)).real)
    return higher + base * t_i * t_r / (np.pi * (1 - base * returned(tau, w, g)))
