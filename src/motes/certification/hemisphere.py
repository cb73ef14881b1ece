"""Directions to ask a subject at, and a rule that integrates whatever it answers, narrow highlights too.

Everything is fixed: the same subject is asked the same, always.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from motes.certification.specimen import Evaluation, Floats
from motes.directions import from_spherical
from motes.fitting.conversion import even
from motes.models import GGX, Lambert

#: Polar angles [degrees] at which albedos are taken.
ANGLES = (0.0, 15.0, 30.0, 45.0, 60.0, 70.0, 75.0, 80.0, 85.0, 88.0)
#: Widths of the lobes about the mirror direction whose samples the rule joins to those after the cosine.
WIDTHS = (0.003, 0.02, 0.1, 0.4)
SHIFTS, POINTS = 8, 256


def upper(count: int, seed: int) -> Floats:
    """Directions (count, 3), uniform over the upper hemisphere."""
    rng = np.random.default_rng(seed)
    z, phi = rng.uniform(0, 1, count), rng.uniform(-np.pi, np.pi, count)
    r = np.sqrt((1 - z) * (1 + z))
    return np.stack([r * np.cos(phi), r * np.sin(phi), z], -1)


def turned(w: Floats) -> Floats:
    """Directions turned about the normal by half a circle."""
    return np.asarray(w * np.array([-1.0, -1.0, 1.0]))


def special() -> dict[str, tuple[Floats, Floats]]:
    """Pairs above the horizon at which formulas are at risk, by name."""

    def pair(a: float, b: float, phi: float, at: float = 0.3) -> tuple[Floats, Floats]:
        return from_spherical(np.radians(a), at), from_spherical(np.radians(b), at + np.radians(phi))

    return {
        "both along the normal": pair(0, 0, 0),
        "the light along the normal": pair(0, 50, 40),
        "the viewer along the normal": pair(50, 0, 40),
        "both almost along the normal": pair(1e-7, 1e-7, 60),
        "the mirror direction": pair(40, 40, 180),
        "the mirror direction, the light along x": (
            from_spherical(np.radians(40), 0.0),
            from_spherical(np.radians(40), np.pi),
        ),
        "the direction of the light": pair(40, 40, 0),
        "the mirror direction at grazing": pair(89.9, 89.9, 180),
        "the direction of the light at grazing": pair(89.9, 89.9, 0),
        "the light at grazing": pair(89.99, 30, 120),
        "the viewer at grazing": pair(30, 89.99, 120),
    }


def grazing(count: int, seed: int) -> tuple[Floats, Floats]:
    """Pairs of which one or both directions lie within 10 degrees of the horizon, the nearer the more."""
    rng = np.random.default_rng(seed)
    up = np.radians(10) * rng.random((2, count)) ** 3 + 1e-4
    phi = rng.uniform(-np.pi, np.pi, (2, count))
    low = from_spherical(np.pi / 2 - up[0], phi[0])
    other = from_spherical(np.pi / 2 - up[1], phi[1])
    third = upper(count, seed + 1)
    steep = np.arange(count)[:, None] % 3
    return np.where(steep == 1, third, low), np.where(steep == 2, third, other)


class Rule(NamedTuple):
    """Directions (S, N, 3) and weights (S, N): each of S sums of values times weights is the integral over the solid angle."""

    wo: Floats
    weights: Floats

    def integrals(self, value: Callable[[Floats], Floats]) -> Floats:
        """The S sums (S, C) of values (S N, C); a value that is no number counts as 0."""
        shifts, points = self.weights.shape
        values = np.nan_to_num(value(self.wo.reshape(-1, 3)), nan=0.0, posinf=0.0, neginf=0.0)
        return np.asarray(np.sum(values.reshape(shifts, points, -1) * self.weights[..., None], axis=1))


def rule(wi: Floats) -> Rule:
    """For one direction (3,): samples after the cosine, of highlights of four widths, and about the direction itself, weighted by the density
    of all of them together, so that no peak is missed that one of them finds."""
    samplers = [(Lambert(1.0), False), *((GGX(1.0, a), False) for a in WIDTHS), (GGX(1.0, 0.1), True)]
    rng = np.random.default_rng(20)
    sums = []
    for _ in range(SHIFTS):
        a, b = rng.random(2)
        drawn = []
        for model, back in samplers:
            wo = np.asarray(model.sample(wi, even(POINTS, (a, b))).wo)
            drawn.append(turned(wo) if back else wo)
        wo = np.concatenate(drawn)
        density = np.mean([np.asarray(model.pdf(wi, turned(wo) if back else wo)) for model, back in samplers], axis=0)
        weights = np.where(density > 0, 1 / np.maximum(density, 1e-300), 0.0) / len(wo)
        sums.append((np.where(density[:, None] > 0, wo, [0.0, 0.0, 1.0]), weights))
    wo, weights = (np.stack(parts) for parts in zip(*sums, strict=True))
    return Rule(wo, weights)


def albedo(evaluate: Evaluation, wi: Floats) -> tuple[Floats, Floats]:
    """The directional albedo (C,) for one direction (3,), and its standard error (C,) from the scatter of the shifts."""
    nodes = rule(wi)
    sums = nodes.integrals(lambda wo: evaluate(np.broadcast_to(wi, wo.shape), wo) * wo[:, 2:])
    return sums.mean(0), sums.std(0, ddof=1) / np.sqrt(len(sums))
