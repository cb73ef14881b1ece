"""Texels to fit, with their truth: at one time, and at several under trends."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.fitting.texels import TexelSolver
from results import Number
from rivals import SURFACE

Floats = NDArray[np.float64]
HELD = ("w", "g", "tau")
FITTED = ("K_d", "sigma_d", "K_s", "sigma_s")
LOW = np.array([0.1, 0.1, 0.1, 0.1, 0.05, 0.1])
HIGH = np.array([0.9, 0.9, 0.9, 0.8, 0.5, 0.4])
NEAR, NOISE, WITHIN = 0.3, 0.02, 0.01
DIRECTIONS, CHANNELS, TIMES = 100, 3, 12
TRENDS = {"K_d": "exponential", "sigma_s": "linear"}


def pairs(count: int, seed: int) -> tuple[Floats, Floats]:
    """Pairs of directions, every other one near the mirror direction, none close to grazing."""
    rng = np.random.default_rng(seed)
    found: list[tuple[Floats, Floats]] = []
    while len(found) < count:
        wi, wo = (_direction(rng) for _ in range(2))
        if len(found) % 2:
            wo = np.array([-wi[0], -wi[1], wi[2]]) + rng.normal(0, 0.25, 3)
            wo /= np.linalg.norm(wo)
        if wo[2] > 0.2:
            found.append((wi, wo))
    both = np.array(found)
    return both[:, 0], both[:, 1]


def _direction(rng: np.random.Generator) -> Floats:
    z, phi = rng.uniform(0.25, 0.98), rng.uniform(0, 2 * np.pi)
    s = np.sqrt(1 - z * z)
    return np.array([s * np.cos(phi), s * np.sin(phi), z])


WI, WO = pairs(DIRECTIONS, 3)


def rendered(x: Floats) -> NDArray[Any]:
    """The surface for parameter vectors (M, 6): (M, D, 3), float32, some at a time."""
    out = np.empty((len(x), DIRECTIONS, CHANNELS), np.float32)
    for k in range(0, len(x), 20_000):
        part = x[k : k + 20_000]
        values = {
            "K_d": part[:, None, :3],
            "sigma_d": part[:, 3:4],
            "K_s": part[:, 4][:, None, None],
            "sigma_s": part[:, 5:6],
        }
        model = SURFACE.with_parameters(values)
        out[k : k + 20_000] = (
            model.eval(WI.astype(np.float32), WO.astype(np.float32)) if len(part) > 64 else model.eval(WI, WO)
        )
    return out


@dataclass
class Case:
    """Texels: what is true, where fits start, and what was measured."""

    truth: Floats
    starts: Floats
    clean: NDArray[Any]
    noisy: NDArray[Any]

    @classmethod
    def of(cls, count: int) -> Case:
        """So many texels."""
        rng = np.random.default_rng(5)
        truth = rng.uniform(LOW, HIGH, (count, len(LOW)))
        starts = truth * rng.uniform(1 - NEAR, 1 + NEAR, truth.shape)
        clean = rendered(truth)
        noisy = clean.copy()
        for k in range(0, count, 20_000):  # random numbers of all texels would double the memory
            part = noisy[k : k + 20_000]
            part *= 1 + np.float32(NOISE) * rng.standard_normal(part.shape, np.float32)
        return cls(truth, starts, clean, noisy)

    def near_truth(self, x: NDArray[Any]) -> Number:
        """The percentage of texels all of whose parameters are within 1 % of the truth."""
        off = np.abs(x / self.truth[: len(x)] - 1).max(axis=1)
        return Number.of([100 * np.mean(off < WITHIN)])


@dataclass
class Series:
    """Texels at several times under trends."""

    solver: TexelSolver
    truth: Floats
    starts: Floats
    values: NDArray[Any]

    @classmethod
    def of(cls, count: int) -> Series:
        """So many texels at `TIMES` times: K_d goes exponentially to another colour, the highlight widens linearly."""
        hours = np.linspace(0, 8, TIMES)
        fitter = TexelSolver(SURFACE, WI, WO, CHANNELS, fixed=HELD, hours=hours, trends=TRENDS)
        rng = np.random.default_rng(8)
        low, high = fitter.bounds
        truth = np.empty((count, fitter.size))
        for k, column in enumerate(fitter.columns):
            place = ("K_d", "sigma_d", "K_s", "sigma_s").index(column.quantity) + (2 if column.quantity != "K_d" else 0)
            span = (2.0, 5.0) if high[k] > 3 and column.coefficient == "time_constant" else (LOW[place], HIGH[place])
            truth[:, k] = np.clip(rng.uniform(*span, count), low[k], high[k])
        starts = truth * rng.uniform(1 - NEAR, 1 + NEAR, truth.shape)
        values = np.empty((count, TIMES, DIRECTIONS, CHANNELS), np.float32)
        for k, hour in enumerate(hours):
            values[:, k] = rendered(_at(fitter, truth, float(hour)))
        values *= 1 + np.float32(NOISE) * rng.standard_normal(values.shape, np.float32)
        return cls(fitter, truth, starts, values)


def _at(fitter: TexelSolver, coefficients: Floats, hour: float) -> Floats:
    """Parameter vectors (M, 6) at a time, by the trends themselves."""
    columns, first = [], 0
    coefficients = fitter.coordinates(coefficients)
    for part in fitter.parts:
        own = coefficients[:, first : first + part.size]
        trends = [part.trend(row)(hour) for row in own]
        columns.append(np.array(trends, float).reshape(len(own), -1))
        first += part.size
    return np.concatenate(columns, axis=1)
