"""Compute layers of dust exactly, and fit the numbers of `motes.models.multiple_scattering` to them.

    python tools/dust_fit.py --sets 2600 --steps 100 --output src/motes/models/data/multiple_scattering.json

Adding and doubling (van de Hulst 1963) with 16 cosines and delta-M (Wiscombe 1977) gives a layer's reflection and transmission in
its first two azimuth modes for random tau, w and g.  To each the form of `multiple_scattering` is fitted by linear least squares;
then a network from (tau, w, g) to what those found, each weighted by what it changes in albedos and BRDFs.  A smaller one, from
(tau, g), gives the albedo of the first order, by quadrature, and comes first: what is left is shared by the others.  A few
minutes with the numbers above; --start goes on from numbers there are.
"""

from __future__ import annotations

import argparse
import json
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from small_network import Network

from motes.arrays import NUMPY
from motes.models.multiple_scattering import LOST_TERMS, OWN_TERMS, POWERS, Diffused, once_features
from motes.models.slants import stretched

Floats = NDArray[np.float64]
N = 16  # cosines of the exact computation
TERMS = POWERS + 1  # coefficients of E, t and the first order: of powers of v, and of what comes straight through
AZIMUTHS = (np.arange(128) + 0.5) / 128 * np.pi
# The optical thickness that doubling starts from: what it neglects, its half, is lost as often as it is doubled.
THINNEST = 1e-9

_x, _w = np.polynomial.legendre.leggauss(N)
MU, WEIGHTS = 0.5 * (_x + 1), 0.5 * _w
FLUX = 2 * MU * WEIGHTS
V = stretched(NUMPY, MU)
#: Where the first order is fitted: closer towards the horizon, and at the vertical, too.
COSINES = ((np.arange(20) + 0.5) / 19.5) ** 2


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


def first_order(g: Floats, tau: Floats) -> Floats:
    """The share of light that leaves above after one scattering by white dust, over that which meets a particle (n, 20)."""
    nodes, weights = np.polynomial.legendre.leggauss(64)
    root = 0.5 * (nodes + 1)
    out, measure = (
        root**2,
        root * weights,
    )  # an even rule in the root of the cosine: thin layers are met at grazing angles
    sine, sines = np.sqrt(1 - COSINES**2), np.sqrt(1 - out**2)
    cosine = -COSINES[:, None, None] * out[:, None] + sine[:, None, None] * sines[:, None] * np.cos(AZIMUTHS)
    both = COSINES[:, None] + out
    found = np.empty((len(g), len(COSINES)))
    for k, (mean_cosine, depth) in enumerate(zip(g.tolist(), tau.tolist(), strict=True)):
        square = mean_cosine * mean_cosine
        phase = ((1 - square) / (1 + square - 2 * mean_cosine * cosine) ** 1.5).mean(axis=2)
        up = 0.5 * phase * out / both * -np.expm1(-depth * both / (COSINES[:, None] * out))
        found[k] = up @ measure / -np.expm1(-depth / COSINES)
    return found


class Scales(NamedTuple):
    """What the network of the model is fed with, and what its numbers are multiplied with (n,)."""

    features: Floats
    met: Floats
    deep: Floats
    lost: Floats
    upward: Floats


def scales(tau: Floats, w: Floats, g: Floats) -> Scales:
    """Those of the model itself."""
    layer = Diffused(NUMPY, tau, w, g)
    features, deep, lost = layer._two_streams()
    return Scales(np.stack(features, axis=1), layer._met, deep, lost, layer._upward)


def powers(count: int, v: Floats = V) -> Floats:
    """What values at `count` nodes of v are at the cosines, (N, count)."""
    return np.vander(v, count, increasing=True) @ at_nodes(count)


def shares(v: Floats, straight: Floats) -> Floats:
    """What the coefficients of E, t or the first order are at the cosines, (N, TERMS)."""
    return np.concatenate([powers(POWERS, v), straight[:, None]], axis=1)


def nodes_of(count: int) -> Floats:
    """Where polynomials in v are told by their values."""
    found: Floats = -np.cos((np.arange(count) + 0.5) / count * np.pi)
    return found


def at_nodes(count: int) -> Floats:
    """Coefficients of powers of v out of values at nodes."""
    return np.linalg.inv(np.vander(nodes_of(count), count, increasing=True))


def least_squares(columns: Floats, values: Floats) -> tuple[Floats, Floats]:
    """The solution, and the Cholesky factor of the metric in which to judge another; what data do not tell is 0."""
    metric = columns.T @ columns + 1e-10 * np.eye(columns.shape[1])
    return np.linalg.solve(metric, columns.T @ values), np.linalg.cholesky(metric)


def coefficients(found: Exact, tau: float, w: float, lost: float) -> tuple[Floats, list[Floats]]:
    """What the network is to give for one layer, E, t and the light lost by their values at nodes; and the metrics of its five parts."""
    hit, straight = -np.expm1(-tau / MU), np.exp(-tau / MU)
    columns = shares(V, straight)
    escaping = np.pi * (found.higher[0] * FLUX).sum(axis=1)
    root = np.sqrt(FLUX) + 0.03
    light = found.reflected + 0.02 * found.arriving**2 + 1e-4
    ways = [root / light, 0.25 * root / (escaping + 0.02 * light)]  # absolutely, and by its shape
    e, metric_e = least_squares(
        np.concatenate([columns * (hit * way)[:, None] for way in ways]),
        np.concatenate([escaping * way for way in ways]),
    )
    way = root / (found.arriving + 0.05)
    t, metric_t = least_squares(columns * (hit * way)[:, None], (found.arriving - straight) * way)
    if 1 - w > 1e-4 and w > 1e-3:
        way = (1 - w) * w * lost * hit * root
        more = (1 - found.reflected - found.arriving) / ((1 - w) * hit) - 1
        n, metric_n = least_squares(powers(LOST_TERMS) * way[:, None], more / (w * lost) * way)
    else:
        n, metric_n = np.zeros(LOST_TERMS), np.zeros((LOST_TERMS, LOST_TERMS))
    mean = float((escaping * FLUX).sum())
    kernel = np.outer(escaping, escaping) / (np.pi * mean)
    zero, one = found.modes
    darkest = np.maximum(np.minimum(zero + 2 * one, zero - 2 * one), 0.15 * np.abs(zero)) + 1e-9
    steep = np.where(np.cos(np.radians(82)) < MU, 1.0, 0.15) * (np.sqrt(FLUX) + 0.01)
    judged = kernel * np.outer(steep, steep) / darkest
    a, b = (p - (p * escaping * FLUX).sum() / mean for p in (V, V * V))
    even = np.stack([np.outer(a, a), np.outer(a, b) + np.outer(b, a), np.outer(b, b)], axis=-1)
    c, metric_c = least_squares(
        (even * judged[..., None]).reshape(-1, 3), ((found.higher[0] / kernel - 1) * judged).ravel()
    )
    sine = np.sqrt(1 - MU * MU)
    odd = np.stack([np.ones((N, N)), V[:, None] + V, np.outer(V, V)], axis=-1) * np.outer(sine, sine)[..., None]
    d, metric_d = least_squares(
        2 * (odd * judged[..., None]).reshape(-1, 3), (2 * found.higher[1] / kernel * judged).ravel()
    )
    return np.concatenate([e, t, n, c, d]), [metric_e, metric_t, metric_n, metric_c, metric_d]


def sample(count: int, seed: int) -> Floats:
    """tau, w, g of random layers (count, 3)."""
    rng = np.random.default_rng(seed)
    tau = np.where(rng.uniform(size=count) < 0.08, 1e4, 10 ** rng.uniform(-2.6, 2.3, count))  # and half spaces
    kind = rng.uniform(size=count)
    w = np.where(kind < 0.5, 1 - rng.uniform(size=count) ** 3, np.where(kind < 0.7, 1.0, rng.uniform(size=count)))
    # A little beyond what the model takes, so that no end of it is an end here.
    g = np.where(rng.uniform(size=count) < 0.7, rng.uniform(-0.77, 0.91, count), rng.uniform(0.5, 0.91, count))
    return np.stack([tau, w, g], axis=1)


def layers(where: Floats) -> tuple[Floats, list[Floats]]:
    """What was fitted to each layer, and the metrics."""
    lost = scales(*where.T).lost
    found = []
    for k, (tau, w, g) in enumerate(where.tolist()):
        found.append(coefficients(exact(w, g, tau), tau, w, lost[k]))
        if k % 500 == 499:
            print(f"{k + 1} of {len(where)} layers", flush=True)
    return np.stack([values for values, _ in found]), [
        np.stack(part) for part in zip(*(metrics for _, metrics in found), strict=True)
    ]


def powers_of_v(counts: list[int], total: int) -> Floats:
    """What makes powers of v of outputs that are values at nodes, so many each from the first on (total, total)."""
    basis, at = np.eye(total), 0
    for count in counts:
        basis[at : at + count, at : at + count] = at_nodes(count).T
        at += count
    return basis


def once_network(where: Floats, start: dict[str, Any] | None, given: argparse.Namespace) -> Network:
    """The network for the first order, from tau and g."""
    tau, _, g = where.T
    wanted, straight = first_order(g, tau), np.exp(-tau[:, None] / COSINES)
    # Between what errs of the light and what errs of its share that meets a particle.
    way = np.sqrt(1 - straight)
    columns = np.stack([shares(stretched(NUMPY, COSINES), row) for row in straight])
    features = np.stack(once_features(NUMPY, tau, g), axis=1)
    if start is None:
        middle, spread = np.full(TERMS, 0.3), np.full(TERMS, 0.2)
        net = Network.random(features, given.once, middle, spread, given.seed)
    else:
        net = Network.read(start, np.linalg.inv(powers_of_v([POWERS, 1], TERMS)))
    for power in (0.0, 1.0, 2.0):
        net.fit(features, 1e3 * way[:, :, None] * columns, 1e3 * way * wanted, given.steps, power)
    error = np.abs(way * way * (np.einsum("nct,nt->nc", columns, net.outputs(features)) - wanted)).max(axis=1)
    print(f"first order, of all light: median {np.median(error):.2g}, worst {error.max():.2g}")
    return net


def network(where: Floats, once: Floats, start: dict[str, Any] | None, given: argparse.Namespace) -> Network:
    """The network for the rest; `once` has what the one for the first order gives, its values at nodes and its share of 1 - x (n, TERMS)."""
    values, metrics = layers(where)
    scale, w = scales(*where.T), where[:, 1]
    sizes = [OWN_TERMS, OWN_TERMS, LOST_TERMS]
    total = sum(sizes) + 6

    def wide(factor: Floats, at: int, count: int) -> Floats:
        """Values at all nodes, times a factor, out of `count` of the outputs (n, TERMS, total)."""
        matrix = np.zeros((len(where), TERMS, total))
        matrix[:, :POWERS, at : at + count] = factor[:, None, None] * powers(count, nodes_of(POWERS))
        return matrix

    # As the model has them: what E, t and the light lost leave unsaid is added to E and to t.
    up, down = (x[:, None] for x in (w * scale.upward, 1 - scale.upward))
    e, t = wide(scale.met, 0, OWN_TERMS), wide(scale.deep, OWN_TERMS, OWN_TERMS)
    unsaid = -wide(w * (1 - w) * scale.lost, 2 * OWN_TERMS, LOST_TERMS) - e - t
    known = w[:, None] * (np.append(np.ones(POWERS), 0.0) - once)
    found = [(e + up[..., None] * unsaid, up * known), (t + down[..., None] * unsaid, down * known)]
    ends = np.cumsum([2 * OWN_TERMS, LOST_TERMS, 3, 3])
    unit = np.eye(total)
    found += [(np.broadcast_to(unit[a:b], (len(where), b - a, total)), np.zeros(1)) for a, b in pairwise(ends)]
    matrices, goals, at = [], [], 0
    for (matrix, constant), metric, importance in zip(found, metrics, (25, 25, 50, 1, 1), strict=True):
        wanted = values[:, at : at + matrix.shape[1]] - constant
        at += matrix.shape[1]
        matrices.append(np.sqrt(importance) * np.einsum("nab,nao->nbo", metric, matrix))
        goals.append(np.sqrt(importance) * np.einsum("nab,na->nb", metric, wanted))
    if start is None:
        net = Network.random(scale.features, given.hidden, np.full(total, 0.3), np.full(total, 0.3), given.seed)
    else:
        net = Network.read(start, np.linalg.inv(powers_of_v(sizes, total)))
    net.fit(scale.features, np.concatenate(matrices, axis=1), np.concatenate(goals, axis=1), given.steps, -0.5)
    return net


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sets", type=int, default=2600, help="layers that are computed")
    parser.add_argument("--steps", type=int, default=100, help="of the fits of the networks")
    parser.add_argument("--hidden", type=int, nargs="+", default=[24, 20])
    parser.add_argument("--once", type=int, nargs="+", default=[16, 12], help="hidden ones, for the first order")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--start", type=Path, help="numbers to go on from")
    parser.add_argument("--output", type=Path, required=True)
    given = parser.parse_args()
    start = json.loads(given.start.read_text(encoding="utf-8")) if given.start else None
    where = sample(given.sets, given.seed)
    first = once_network(where, start and start["once"], given)
    once = first.outputs(np.stack(once_features(NUMPY, where[:, 0], where[:, 2]), axis=1))
    net = network(where, once, start, given)
    numbers = net.numbers(powers_of_v([OWN_TERMS, OWN_TERMS, LOST_TERMS], 2 * OWN_TERMS + LOST_TERMS + 6))
    numbers["once"] = first.numbers(powers_of_v([POWERS, 1], TERMS))
    given.output.write_text(json.dumps(numbers) + "\n", encoding="utf-8")
    print(given.output)


if __name__ == "__main__":
    main()
