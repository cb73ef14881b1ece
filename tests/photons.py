"""A photon Monte Carlo of a layer of dust over any base: what judges the models of dust, and shares no formula with them.

A plane-parallel layer of optical thickness tau, single-scattering albedo w and the Henyey-Greenstein phase function of mean cosine g
lies on a base, which may be any BRDF of Motes, highlights included.  Photons enter from ``wi``; at each scattering, and at each
reflection by the base, the power that would leave towards each viewer without another event is added up (local estimation), and
those that leave are counted (the directional albedo).  Everything is unbiased: how far a result may be from the truth is told by its
standard error alone.

* In the layer photons are followed one by one by a compiled kernel; at the base all at once, by the base's own `eval` and `sample`.
* Absorption is in the weight.  Light photons play Russian roulette, and so do old ones, so that w = 1 in an infinite layer ends, too.
* How many photons reach the base untouched is not estimated but known, exp(-tau/mu_i), and so is what they show; they and those
  that are scattered first are followed apart, so that thin layers are seen, too.
* A pair of directions is followed from the more grazing one, where few photons say most (reciprocity), unless told otherwise.
* Each photon has random numbers of its own, made from its number and the seed, and sums are taken in batches whose borders do not
  move: results are the same to the bit whatever the number of threads.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numba
import numpy as np
from numpy.typing import NDArray

from motes.models import BRDF

Floats = NDArray[np.float64]

BATCHES = 64  # from whose scatter the standard errors come
LIGHT = 0.1  # a weight below which a photon plays roulette
OLD = 64  # scatterings after which a photon plays roulette whatever its weight
FLYING, FORCED, AT_BASE, GONE = 0, 1, 2, 3  # a forced photon is scattered in the layer next, for certain


@dataclass(frozen=True)
class Layer:
    """A layer of dust on a base of one channel; an infinite `tau` is the half space, whose base nobody sees."""

    base: BRDF
    tau: float
    w: float
    g: float


@dataclass(frozen=True)
class Estimate:
    """A mean, and its standard error."""

    value: Floats
    error: Floats

    def apart(self, expected: Any) -> Floats:
        """How many standard errors this is from the expected value, which is rounded: an error is 1e-9 at least."""
        return (self.value - np.asarray(expected)) / np.maximum(self.error, 1e-9)


def brdf(
    layer: Layer, wi: Any, wo: Any, photons: int = 2**16, *, seed: int = 1, swap: bool = True, orders: int = 2**60
) -> Estimate:
    """The BRDF [1/sr] from ``wi`` (3,) towards each of ``wo`` (K, 3).

    Parameters
    ----------
    photons
        Followed from each direction, rounded up to whole batches.
    swap
        Follow a pair from its more grazing direction; False follows all from `wi`.
    orders
        The number of scatterings and reflections after which photons are given up: 1 is single scattering, exactly.
    """
    wi, wo = np.asarray(wi, np.float64), np.atleast_2d(np.asarray(wo, np.float64))
    other = (wo[:, 2] < wi[2]) if swap else np.zeros(len(wo), bool)
    value, error = np.empty(len(wo)), np.empty(len(wo))
    groups = [(wi, np.flatnonzero(~other))] + [(wo[k], np.array([k])) for k in np.flatnonzero(other)]
    for number, (start, indices) in enumerate(groups):
        if len(indices):
            towards = wo[indices] if number == 0 else wi[None]
            seen, _ = _estimated(layer, start, towards, photons, seed + 7919 * number, orders, 1)  # other photons each
            value[indices], error[indices] = seen.value, seen.error
    return Estimate(value, error)


def albedo(layer: Layer, wi: Any, photons: int = 2**16, *, seed: int = 1, orders: int = 2**60) -> Estimate:
    """The directional albedo: the share of the light from ``wi`` that leaves the layer at its top."""
    return both(layer, wi, np.empty((0, 3)), photons, seed=seed, orders=orders)[1]


def both(
    layer: Layer, wi: Any, wo: Any, photons: int = 2**16, *, seed: int = 1, orders: int = 2**60, threads: int = 1
) -> tuple[Estimate, Estimate]:
    """The BRDF towards each of ``wo`` and the directional albedo, of the same photons, all of which start at ``wi``."""
    return _estimated(layer, np.asarray(wi, np.float64), np.asarray(wo, np.float64), photons, seed, orders, threads)


def pairs(layer: Layer, wi: Any, wo: Any, photons: int = 256, *, seed: int = 1) -> Floats:
    """The BRDF [1/sr] of many pairs of directions (N, 3), with few photons each: a picture, grainy and unbiased."""
    wi, wo = np.asarray(wi, np.float64), np.asarray(wo, np.float64)
    if not len(wi):
        return np.zeros(0)
    grazing = (wo[:, 2] < wi[:, 2])[:, None]
    start, towards = np.where(grazing, wo, wi), np.where(grazing, wi, wo)
    return _followed(layer, start, towards[:, None], photons, seed, 2**60, 1)[0][:, 0]


# ---------------------------------------------------------------- The photons


def _estimated(
    layer: Layer, wi: Floats, wo: Floats, photons: int, seed: int, orders: int, threads: int
) -> tuple[Estimate, Estimate]:
    """From one direction (3,) to some (K, 3), the errors from batches that are all alike."""
    starts = np.broadcast_to(wi, (BATCHES, 3))
    towards = np.broadcast_to(wo, (BATCHES, *wo.shape))
    seen, left = _followed(layer, starts, towards, -(-photons // BATCHES), seed, orders, threads)
    return _mean(seen), _mean(left)


def _mean(batches: Floats) -> Estimate:
    return Estimate(batches.mean(0), batches.std(0, ddof=1) / np.sqrt(len(batches)))


def _followed(
    layer: Layer, wi: Floats, wo: Floats, photons: int, seed: int, orders: int, threads: int
) -> tuple[Floats, Floats]:
    """What each of B batches of photons, which starts at ``wi`` (B, 3), shows its viewers ``wo`` (B, K, 3), and what leaves of it.

    Those that are scattered in the layer first, and those that reach the base untouched: each by photons of their own.
    """
    wo = np.ascontiguousarray(wo)
    direct = np.exp(-layer.tau / wi[:, 2])
    through = np.exp(-layer.tau / wo[..., 2])
    seen = direct[:, None] * through * _seen_by_base(layer.base, wi, wo)
    left = np.zeros(len(wi))
    roots = np.sqrt([1 - direct.mean(), direct.mean()])
    for where, share, root in ((FORCED, -np.expm1(-layer.tau / wi[:, 2]), roots[0]), (AT_BASE, direct, roots[1])):
        if share.any():
            size = int(np.ceil(photons * root / roots.sum()))
            begun = _begun(wi, size, where, layer.tau, 2 * seed + where)
            shown, out = _ended(layer, begun, size, wo, through, orders, threads)
            seen += share[:, None] * shown / size
            left += share * out / size
    return seen, left


def _ended(
    layer: Layer, flock: _Flock, size: int, wo: Floats, through: Floats, orders: int, threads: int
) -> tuple[Floats, Floats]:
    """Follow all photons to their ends: what each batch of so many shows (B, K), and what leaves of it (B,)."""
    seen, left = np.zeros(wo.shape[:2]), np.zeros(len(wo))
    borders = np.linspace(0, len(wo), threads + 1).astype(int)

    def crossed(first: int, last: int) -> None:
        for b in range(first, last):
            chosen = slice(b * size, (b + 1) * size)
            left[b] += _cross(*flock.arrays(chosen), layer.tau, layer.w, layer.g, wo[b], seen[b], orders)

    with ThreadPoolExecutor(threads) as pool:
        while True:
            list(pool.map(crossed, borders[:-1], borders[1:]))
            here = np.flatnonzero(flock.where == AT_BASE)
            if not len(here):
                return seen, left
            # What the untouched ones show the viewers is known exactly, so only what they are scattered into is estimated.
            touched = here[flock.age[here] > 0]
            batch = touched // size
            shown = _seen_by_base(layer.base, -flock.along[touched], wo[batch]) * flock.weight[touched, None]
            np.add.at(seen, batch, shown * through[batch])
            flock.age[here] += 1
            here, out = here[flock.age[here] < orders], here[flock.age[here] >= orders]
            flock.where[out] = GONE
            u, drawn = np.empty((len(here), 2)), flock.state[here]
            _draw(drawn, u)
            flock.state[here] = drawn
            sampled = layer.base.sample(-flock.along[here], u)
            flock.along[here] = sampled.wo
            flock.weight[here] *= sampled.weight[:, 0]
            flock.depth[here] = layer.tau
            flock.where[here] = np.where((sampled.weight[:, 0] > 0) & (sampled.wo[:, 2] > 0), FLYING, GONE)


def _seen_by_base(base: BRDF, wi: Floats, wo: Floats) -> Floats:
    """The base's BRDF from each of ``wi`` (N, 3) to viewers of its own ``wo`` (N, K, 3)."""
    if not wo.size:
        return np.zeros(wo.shape[:2])
    return np.asarray(base.eval(wi[:, None], wo)[..., 0], np.float64)


@dataclass(frozen=True)
class _Flock:
    """The photons: their random state, where they fly, their weight, their optical depth, events so far, and where they are."""

    state: NDArray[np.uint64]
    along: Floats
    weight: Floats
    depth: Floats
    age: NDArray[np.int64]
    where: NDArray[np.int64]

    def arrays(self, chosen: slice) -> tuple[Any, ...]:
        return tuple(x[chosen] for x in (self.state, self.along, self.weight, self.depth, self.age, self.where))


def _begun(wi: Floats, size: int, where: int, tau: float, seed: int) -> _Flock:
    n = size * len(wi)
    numbers = np.arange(n, dtype=np.uint64) + np.uint64(seed) * np.uint64(2**40)
    depth = np.full(n, tau if where == AT_BASE else 0.0)
    along = np.repeat(-wi, size, axis=0)
    return _Flock(numbers, along, np.ones(n), depth, np.zeros(n, np.int64), np.full(n, where, np.int64))


# ---------------------------------------------------------------- Compiled


@numba.njit(nogil=True, cache=True)
def _uniform(state: Any, k: int) -> float:
    """The next number in (0, 1) of photon k: SplitMix64 (Steele, Lea, Flood 2014) on a counter that starts at a place of its own."""
    state[k] += np.uint64(0x9E3779B97F4A7C15)
    z = state[k]
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return (np.float64((z ^ (z >> np.uint64(31))) >> np.uint64(11)) + 0.5) * 2.0**-53


@numba.njit(nogil=True, cache=True)
def _draw(state: Any, u: Any) -> None:
    for k in range(len(u)):
        for j in range(u.shape[1]):
            u[k, j] = _uniform(state, k)


@numba.njit(nogil=True, cache=True)
def _turned(along: Any, k: int, cosine: float, azimuth: float) -> None:
    """Turn photon k by a deviation angle, about itself by an azimuth."""
    x, y, z = along[k, 0], along[k, 1], along[k, 2]
    sine = np.sqrt(max(0.0, 1.0 - cosine * cosine))
    a, b = sine * np.cos(azimuth), sine * np.sin(azimuth)
    across = np.sqrt(x * x + y * y)
    if across < 1e-8:
        along[k, 0], along[k, 1], along[k, 2] = a, b, cosine if z > 0 else -cosine
        return
    # The two axes across: one level, one in the upright plane of the flight.
    along[k, 0] = cosine * x + (a * x * z - b * y) / across
    along[k, 1] = cosine * y + (a * y * z + b * x) / across
    along[k, 2] = cosine * z - a * across
    length = np.sqrt(along[k, 0] ** 2 + along[k, 1] ** 2 + along[k, 2] ** 2)
    for j in range(3):
        along[k, j] /= length


@numba.njit(nogil=True, cache=True)
def _deviation(g: float, u: float) -> float:
    """The cosine of a deviation angle: uniform for g = 0, else the inverse of the cumulated Henyey-Greenstein function."""
    if abs(g) < 1e-4:
        return 1.0 - 2.0 * u
    part = (1.0 - g * g) / (1.0 - g + 2.0 * g * u)
    return min(1.0, max(-1.0, (1.0 + g * g - part * part) / (2.0 * g)))


@numba.njit(nogil=True, cache=True)
def _cross(
    state: Any,
    along: Any,
    weight: Any,
    depth: Any,
    age: Any,
    where: Any,
    tau: float,
    w: float,
    g: float,
    wo: Any,
    seen: Any,
    orders: int,
) -> float:
    """Follow each photon in the layer until it leaves, reaches the base or ends; return the weight that left at the top."""
    left = 0.0
    for k in range(len(state)):
        while where[k] <= FORCED:
            if where[k] == FORCED:
                depth[k] = along[k, 2] * np.log1p(_uniform(state, k) * np.expm1(tau / along[k, 2]))
                where[k] = FLYING
            else:
                depth[k] += along[k, 2] * np.log(_uniform(state, k))
            if depth[k] < 0.0:
                left += weight[k]
                where[k] = GONE
                break
            if depth[k] > tau:
                where[k] = AT_BASE
                break
            weight[k] *= w
            if weight[k] == 0.0:
                where[k] = GONE
                break
            for j in range(len(wo)):
                out = depth[k] / wo[j, 2]
                if out < 60.0:
                    cosine = along[k, 0] * wo[j, 0] + along[k, 1] * wo[j, 1] + along[k, 2] * wo[j, 2]
                    phase = (1.0 - g * g) / (4.0 * np.pi * (1.0 + g * g - 2.0 * g * cosine) ** 1.5)
                    seen[j] += weight[k] * phase * np.exp(-out) / wo[j, 2]
            age[k] += 1
            if age[k] >= orders:
                where[k] = GONE
                break
            # Roulette: survivors carry the weight of those that end.
            survival = min(1.0, weight[k] / LIGHT)
            if age[k] > OLD:
                survival *= (age[k] / (age[k] + 1.0)) ** 0.25
            if survival < 1.0:
                if _uniform(state, k) >= survival:
                    where[k] = GONE
                    break
                weight[k] /= survival
            _turned(along, k, _deviation(g, _uniform(state, k)), 2.0 * np.pi * _uniform(state, k))
    return left
