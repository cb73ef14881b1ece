"""Compute layers of dust exactly, and fit the numbers of `motes.models.multiple_scattering` to them.

    python tools/dust_fit.py --sets 10000 --evaluations 20000 --output src/motes/models/data/multiple_scattering.json

Adding and doubling (van de Hulst 1963) with 16 cosines and delta-M (Wiscombe 1977) gives a layer's reflection and transmission in
its first two azimuth modes for random tau, w and g.  To each the form of `multiple_scattering` is fitted by linear least squares;
then a network from (tau, w, g) to what those found, each weighted by what it changes in albedos and BRDFs.  Needs PyTorch; with
the numbers above about a quarter of an hour on two cores.
"""

from __future__ import annotations

import argparse
import json
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
N = 16  # cosines of the exact computation
TERMS = 6  # coefficients of E and of t
AZIMUTHS = (np.arange(128) + 0.5) / 128 * np.pi
# The optical thickness that doubling starts from: what it neglects, its half, is lost as often as it is doubled.
THINNEST = 1e-9

_x, _w = np.polynomial.legendre.leggauss(N)
MU, WEIGHTS = 0.5 * (_x + 1), 0.5 * _w
FLUX = 2 * MU * WEIGHTS


class Exact(NamedTuple):
    """Shares of light reflected and arriving below (N,); azimuth modes 0 and 1 of the BRDF (2, N, N), and without the first order."""

    reflected: Floats
    arriving: Floats
    modes: Floats
    higher: Floats


def legendre(degree: int, m: int, x: Floats) -> Floats:
    """P_l^m sqrt((l - m)! / (l + m)!) for l = 0..degree, (degree + 1, len(x))."""
    P = np.zeros((degree + 1, len(x)))
    P[m] = np.prod([np.sqrt((1 - x * x) * (2 * k - 1) / (2 * k)) for k in range(1, m + 1)], axis=0) if m else 1.0
    if m < degree:
        P[m + 1] = np.sqrt(2 * m + 1) * x * P[m]
    for l in range(m + 2, degree + 1):
        P[l] = ((2 * l - 1) * x * P[l - 1] - np.sqrt((l - 1) ** 2 - m * m) * P[l - 2]) / np.sqrt(l * l - m * m)
    return P


def once(w: float, g: float, tau: float, m: int) -> Floats:
    """A mode of the BRDF of light scattered once (N, N)."""
    sine = np.sqrt(1 - MU**2)
    cosine = -MU[:, None, None] * MU[:, None] + sine[:, None, None] * sine[:, None] * np.cos(AZIMUTHS)
    phase = ((1 - g * g) / (1 + g * g - 2 * g * cosine) ** 1.5 * np.cos(m * AZIMUTHS)).mean(axis=2)
    both = MU[:, None] + MU
    return w / (4 * np.pi) * phase / both * -np.expm1(-tau * both / (MU[:, None] * MU))


def exact(w: float, g: float, tau: float) -> Exact:
    """A layer by adding and doubling; what delta-M cuts off the first order is put back (Nakajima and Tanaka 1988)."""
    degree, cut = 2 * N - 1, g ** (2 * N)
    moments = (g ** np.arange(degree + 1.0) - cut) / (1 - cut) * (2 * np.arange(degree + 1) + 1)
    albedo, depth = w * (1 - cut) / (1 - w * cut), (1 - w * cut) * tau
    doublings = max(0, int(np.ceil(np.log2(depth / THINNEST))))
    start = depth / 2**doublings
    shares: list[Floats] = []
    modes, higher = np.empty((2, N, N)), np.empty((2, N, N))
    both, apart = MU[:, None] + MU, MU[:, None] - MU
    fade = np.exp(-start / MU)
    with np.errstate(all="ignore"):
        passed = np.where(apart == 0, (start / MU**2 * fade)[:, None], (fade[:, None] - fade) / apart)
    for m in range(2):
        P = legendre(degree, m, MU)
        signs = (-1.0) ** (np.arange(degree + 1) + m)
        forward, backward = (np.einsum("l,li,lj->ij", c, P, P) for c in (moments, moments * signs))
        up = albedo / 4 * backward / both * -np.expm1(-start * both / (MU[:, None] * MU)) * FLUX
        down = albedo / 4 * forward * passed * FLUX + np.diag(fade)
        for _ in range(doublings):
            between = np.linalg.solve(np.eye(N) - up @ up, np.concatenate([up @ down, down], axis=1))
            up, down = up + down @ between[:, :N], down @ between[:, N:]
        if m == 0:
            shares = [(FLUX[:, None] * matrix / FLUX).sum(axis=0) for matrix in (up, down)]
        first = albedo / 4 * backward / both * -np.expm1(-depth * both / (MU[:, None] * MU)) / np.pi
        modes[m] = up / FLUX / np.pi - first + once(w / (1 - w * cut), g, depth, m)
        higher[m] = modes[m] - once(w, g, tau, m)
    return Exact(shares[0], shares[1], modes, higher)


def scales(tau: Floats, w: Floats, g: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """The features (n, 8) and the scales of E, t and the loss, of the model itself."""
    from motes.arrays import NUMPY
    from motes.models.multiple_scattering import Diffused

    features, deep, lost = Diffused(NUMPY, tau, w, g)._two_streams()
    return np.stack(features, axis=1), w * w * (1 - 1 / (1 + tau * (1 - w * g))), deep, lost


def least_squares(columns: Floats, values: Floats) -> tuple[Floats, Floats]:
    """The solution, and the Cholesky factor of the metric in which to judge another."""
    metric = columns.T @ columns + 1e-10 * np.eye(columns.shape[1])
    return np.linalg.lstsq(columns, values, rcond=1e-9)[0], np.linalg.cholesky(metric)


def coefficients(
    found: Exact, tau: float, w: float, scale_e: float, scale_t: float, lost: float
) -> tuple[Floats, list[Floats]]:
    """What the network is to give for one layer (19,), E and t by their values at nodes; and the metrics of its four parts."""
    powers = np.vander(2.8 * MU / (MU + 0.4) - 1, TERMS, increasing=True) @ AT_NODES
    hit = -np.expm1(-tau / MU)
    escaping = np.pi * (found.higher[0] * FLUX).sum(axis=1)
    root = np.sqrt(FLUX) + 0.01
    light = found.reflected + 0.5 * found.arriving**2 + 1e-4
    ways = [root / light, 0.25 * root / (escaping + 0.02 * light)]  # absolutely, and by its shape
    e, metric_e = least_squares(
        np.concatenate([powers * (hit * way)[:, None] * scale_e for way in ways]),
        np.concatenate([escaping * way for way in ways]),
    )
    way = root / (found.arriving + 0.05)
    t, metric_t = least_squares(powers * (hit * way)[:, None] * scale_t, (found.arriving - np.exp(-tau / MU)) * way)
    mean = float((escaping * FLUX).sum())
    kernel = np.outer(escaping, escaping) / (np.pi * mean)
    zero, one = found.modes
    darkest = np.maximum(np.minimum(zero + 2 * one, zero - 2 * one), 0.15 * np.abs(zero)) + 1e-9
    steep = np.where(np.cos(np.radians(82)) < MU, 1.0, 0.15) * root
    judged = kernel * np.outer(steep, steep) / darkest
    v = 2.8 * MU / (MU + 0.4) - 1
    a, b = (p - (p * escaping * FLUX).sum() / mean for p in (v, v * v))
    even = np.stack([np.outer(a, a), np.outer(a, b) + np.outer(b, a), np.outer(b, b)], axis=-1)
    c, metric_c = least_squares(
        (even * judged[..., None]).reshape(-1, 3), ((found.higher[0] / kernel - 1) * judged).ravel()
    )
    sine = np.sqrt(1 - MU * MU)
    odd = np.stack([np.ones((N, N)), v[:, None] + v, np.outer(v, v)], axis=-1) * np.outer(sine, sine)[..., None]
    d, metric_d = least_squares(
        2 * (odd * judged[..., None]).reshape(-1, 3), (2 * found.higher[1] / kernel * judged).ravel()
    )
    share = 1 - float((found.reflected * FLUX).sum() + (found.arriving * FLUX).sum())
    loss = share / ((1 - w) * lost) if 1 - w > 1e-4 else np.nan
    return np.concatenate([e, t, c, d, [loss]]), [metric_e, metric_t, metric_c, metric_d]


NODES = -np.cos((np.arange(TERMS) + 0.5) / TERMS * np.pi)
AT_NODES = np.linalg.inv(np.vander(NODES, TERMS, increasing=True))  # coefficients out of values at nodes


def layers(count: int, seed: int) -> tuple[Floats, Floats, list[Floats]]:
    """Random layers (count, 3), what was fitted to each (count, 19), and the metrics."""
    rng = np.random.default_rng(seed)
    tau = np.where(rng.uniform(size=count) < 0.08, 1e4, 10 ** rng.uniform(-2.6, 2.3, count))  # and half spaces
    kind = rng.uniform(size=count)
    w = np.where(kind < 0.6, 1 - rng.uniform(size=count) ** 3, np.where(kind < 0.9, 1.0, rng.uniform(size=count)))
    g = rng.uniform(-0.75, 0.9, count)
    _, scale_e, scale_t, lost = scales(tau, w, g)
    values, metrics = np.empty((count, 2 * TERMS + 7)), [np.empty((count, k, k)) for k in (TERMS, TERMS, 3, 3)]
    for k in range(count):
        found, own = coefficients(exact(w[k], g[k], tau[k]), tau[k], w[k], scale_e[k], scale_t[k], lost[k])
        values[k] = found
        for metric, part in zip(metrics, own, strict=True):
            metric[k] = part
        if k % 500 == 499:
            print(f"{k + 1} of {count} layers", flush=True)
    return np.stack([tau, w, g], axis=1), values, metrics


def network(
    where: Floats, values: Floats, metrics: list[Floats], hidden: list[int], evaluations: int
) -> dict[str, Any]:
    """The numbers of the model: weights and offsets of the network, the last ones for powers of v."""
    import torch

    torch.set_default_dtype(torch.float64)
    torch.manual_seed(0)
    features, scale_e, scale_t, _ = scales(*where.T)
    mean, deviation = features.mean(axis=0), features.std(axis=0)
    known = np.isfinite(values[:, -1])
    values = np.where(np.isnan(values), 1.0, values)
    middle, spread = np.median(values, axis=0), 0.5 * np.ptp(np.quantile(values, [0.1, 0.9], axis=0), axis=0) + 1e-3
    inputs, wanted = torch.tensor((features - mean) / deviation), torch.tensor(values)
    factors = [torch.tensor(metric) for metric in metrics]
    sizes = [features.shape[1], *hidden, values.shape[1]]
    weights = [torch.randn(a, b) / np.sqrt(a) for a, b in pairwise(sizes)]
    offsets = [0.3 * torch.randn(b) for b in sizes[1:]]
    for tensor in (*weights, *offsets):
        tensor.requires_grad_(True)
    parts = [slice(0, TERMS), slice(TERMS, 2 * TERMS), slice(2 * TERMS, 2 * TERMS + 3), slice(2 * TERMS + 3, -1)]
    powers = torch.tensor(np.vander(2.8 * MU / (MU + 0.4) - 1, TERMS, increasing=True) @ AT_NODES)
    white = torch.tensor((where[:, 1:2] > 0.995) * -np.expm1(-where[:, :1] / MU))
    scale_e, scale_t = (torch.tensor(scale)[:, None] for scale in (scale_e, scale_t))

    def loss() -> Any:
        layer = inputs
        for weight, offset in zip(weights[:-1], offsets[:-1], strict=True):
            layer = layer @ weight + offset
            layer = layer / torch.sqrt(1 + layer * layer)
        error = torch.tensor(middle) + torch.tensor(spread) * (layer @ weights[-1] + offsets[-1]) - wanted
        total = 4 * (torch.tensor(known) * error[:, -1] / wanted[:, -1]) ** 2
        for part, factor, importance in zip(parts, factors, (25, 25, 1, 1), strict=True):
            total = total + importance * (torch.einsum("nab,na->nb", factor, error[:, part]) ** 2).sum(axis=1)
        # White dust keeps all light: errors of E and t must cancel there.
        energy = white * ((error[:, parts[0]] @ powers.T) * scale_e + (error[:, parts[1]] @ powers.T) * scale_t)
        total = total + 625 * (energy**2).sum(axis=1)
        return (total / (1 + 0.5 * total)).mean() + 0.05 * torch.sqrt(total + 1e-8).mean()

    done = 0

    def step() -> Any:
        nonlocal done
        optimizer.zero_grad()
        value = loss()
        value.backward()
        done += 1
        if done % 1000 == 0:
            print(f"{done} evaluations: {value.item():.5f}", flush=True)
        return value

    optimizer = torch.optim.LBFGS(
        [*weights, *offsets], max_iter=evaluations, max_eval=evaluations, history_size=100, line_search_fn="strong_wolfe",
        tolerance_grad=1e-14, tolerance_change=1e-16,
    )  # fmt: skip
    optimizer.step(step)
    matrices, vectors = ([t.detach().numpy() for t in tensors] for tensors in (weights, offsets))
    powers_of_v = np.eye(values.shape[1])
    for part in parts[:2]:
        powers_of_v[part, part] = AT_NODES.T
    matrices[-1], vectors[-1] = matrices[-1] * spread @ powers_of_v, (vectors[-1] * spread + middle) @ powers_of_v
    short = np.vectorize(lambda x: float(f"{x:.7g}"))
    return {
        "mean": short(mean).tolist(),
        "deviation": short(deviation).tolist(),
        "weights": [short(matrix).tolist() for matrix in matrices],
        "offsets": [short(vector).tolist() for vector in vectors],
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sets", type=int, default=10_000, help="layers that are computed")
    parser.add_argument("--evaluations", type=int, default=20_000, help="of the network's fit")
    parser.add_argument("--hidden", type=int, nargs="+", default=[24, 20])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--output", type=Path, required=True)
    given = parser.parse_args()
    numbers = network(*layers(given.sets, given.seed), given.hidden, given.evaluations)
    given.output.write_text(json.dumps(numbers) + "\n", encoding="utf-8")
    print(given.output)


if __name__ == "__main__":
    main()
