"""Fit the formulas of `motes.models.missing_energy` to quadrature over facets and to walks among them, and print their numbers and errors.

usage: python tools/missing_fit.py
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from facet_walk import walk, white
from motes.arrays import NUMPY
from motes.directions import Geometry, Vector
from motes.models import GGX, Beckmann
from motes.models.microfacet import Microfacet
from motes.models.missing_energy import GaussianTails, LongTails, MissingEnergy

Floats = NDArray[np.float64]
ROUGH = np.concatenate([[0.001, 0.002, 0.005, 0.01, 0.02, 0.035, 0.05, 0.075, 0.1], np.linspace(0.15, 1, 18)])
#: The kind, its form, s, the number of powers of alpha and of X, and the weight of small numbers: what was found best among some hundred.
KINDS: dict[str, tuple[type[Microfacet], type[MissingEnergy], float, tuple[int, int], float]] = {
    "GGX": (GGX, LongTails, 2.0, (5, 6), 1e-3),
    "BECKMANN": (Beckmann, GaussianTails, 3.0, (6, 5), 1e-4),
}
ROUNDS = 60
MEAN_POWERS = 8
EVERY = np.geomspace(0.001, 1, 100)
#: Where next to nothing is missing the formula may err by as small a share of its largest error.
STRICT = 0.1
#: Roughnesses and rays of the walks.
WALKED = (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0)
RAYS = 400_000


def cosines(alpha: float) -> Floats:
    """Where the formula is fitted: towards the horizon, about alpha, where most is missing, and above."""
    low = np.geomspace(1e-3, 1, 13) * min(2 * alpha, 1)
    high = np.geomspace(2 * alpha, 1, 14) if alpha < 0.5 else np.linspace(0.05, 1, 14)
    return np.minimum(np.unique(np.concatenate([low, high, roots(24)[0]])), 1.0)


def roots(count: int) -> tuple[Floats, Floats]:
    """Nodes over mu = x^2 in [0, 1], and weights of the mean 2 times the integral of mu."""
    x, w = np.polynomial.legendre.leggauss(count)
    x = 0.5 * (x + 1)
    return x * x, 2 * w * x**3


def missing(model: Microfacet, cosine: float, steps: int = 500, turns: int = 300) -> float:
    """1 less the directional albedo for F = 1: over all facets in sight, the share of what they mirror that does not leave.

    It is summed as it stands, not as 1 less a sum: where facets are narrow nearly nothing is missing.
    """
    alpha, mu = float(model.alpha), np.float64(cosine)
    # tan(theta_h) = alpha e^t: facets of every size of slope, however long the tail.
    t = np.linspace(-9, 16 if isinstance(model, GGX) else 1.85, steps)
    tan = alpha * np.exp(t)
    cos_h = 1 / np.sqrt(1 + tan * tan)
    half = np.stack([tan * cos_h, 0 * t, cos_h], -1)
    D = model.distribution(NUMPY, Geometry(NUMPY, Vector.split(half), Vector.split(half)))
    weight = D * cos_h**4 * tan * tan * (t[1] - t[0])  # D cos(theta_h) over solid angles, by slopes
    phi = np.pi * (np.arange(turns) + 0.5) / turns
    sine = np.sqrt((1 - mu) * (1 + mu))
    facing = mu + sine * tan[:, None] * np.cos(phi)  # wi . wh over cos(theta_h)
    up = 2 * facing * (cos_h * cos_h)[:, None] - mu  # the cosine of the mirrored direction
    out = np.clip(up, 1e-300, 1)
    masked_i = model.masked(NUMPY, mu, sine)
    masked_r = model.masked(NUMPY, out, np.sqrt((1 - out) * (1 + out)))
    stays = np.where(up > 0, masked_r * mu / (mu * out + masked_i * out + masked_r * mu), 1.0)
    seen = np.maximum(facing, 0) * weight[:, None] * (2 * np.pi / turns)
    return float(np.sum(seen * stays) / (mu + masked_i))


def fitted(
    found: tuple[Floats, Floats, Floats], bare: MissingEnergy, powers: tuple[int, int], ridge: float
) -> MissingEnergy:
    """Q by least squares, whose weights are raised where it errs most, until the largest error is small."""
    alpha, mu, wanted = found
    x, base = bare.frame(NUMPY, mu, alpha)
    y = np.sqrt(wanted / base)
    terms = np.stack([(2 * alpha - 1) ** j * (2 * x - 1) ** k for j in range(powers[0]) for k in range(powers[1])], -1)
    may = STRICT + (1 - STRICT) * np.minimum(1, 2 * alpha / mu)
    each = base * (2 * np.minimum(y, 20) + 0.05) / may  # errors of Q as errors of its square
    few = ridge * np.eye(terms.shape[1])

    def solved(weight: Floats) -> tuple[Floats, Floats]:
        rows = np.vstack([terms * (weight * each)[:, None], few])
        c = np.linalg.lstsq(rows, np.append(y * weight * each, np.zeros(len(few))), rcond=None)[0].round(4)
        return c, np.abs(base * (terms @ c) ** 2 - wanted) / may

    c = sharpened(solved, len(mu))
    return replace(bare, shape=tuple(tuple(row) for row in c.reshape(powers).tolist()))


def averages(formula: MissingEnergy, most: Floats) -> MissingEnergy:
    """The formula with P, whose error counts by as much as is missing anywhere at its roughness."""
    exact, at_risk = averaged(formula, EVERY), np.interp(EVERY, ROUGH, most)
    terms = np.stack([EVERY**2 * (2 * formula.pace(NUMPY, EVERY) - 1) ** k for k in range(MEAN_POWERS)], -1)

    def solved(weight: Floats) -> tuple[Floats, Floats]:
        each = weight * at_risk / exact
        c = np.linalg.lstsq(terms * each[:, None], exact * each, rcond=None)[0].round(5)
        return c, np.abs(terms @ c / exact - 1) * at_risk

    return replace(formula, average=tuple(sharpened(solved, len(EVERY)).tolist()))


def sharpened(solved: Callable[[Floats], tuple[Floats, Floats]], count: int) -> Floats:
    """The coefficients of the smallest largest error, by Lawson's weights."""
    weight, best = np.ones(count), (np.inf, np.zeros(0))
    for _ in range(ROUNDS):
        c, off = solved(np.sqrt(weight))
        best = min(best, (float(off.max()), c), key=lambda one: one[0])
        weight = weight * (off + 0.02 * off.max())
        weight /= weight.mean()
    return best[1]


def averaged(formula: MissingEnergy, alpha: Floats) -> Floats:
    """The mean of a formula by quadrature, in pieces about alpha."""
    x, w = np.polynomial.legendre.leggauss(60)
    total = 0 * alpha
    for low, high in (
        (0 * alpha, alpha),
        (alpha, np.minimum(10 * alpha, 1)),
        (np.minimum(10 * alpha, 1), 0 * alpha + 1),
    ):
        mu = low[:, None] + 0.5 * (high - low)[:, None] * (x + 1)
        total += np.sum(formula(NUMPY, mu, alpha[:, None]) * mu * (high - low)[:, None] * w, -1)
    return total


def lingering(formula: MissingEnergy, kind: type[Microfacet]) -> tuple[MissingEnergy, float]:
    """The formula with q, from rays of uniform light: how many facets those meet that meet two; and the error of that for one alpha."""
    rng, rows, shares = np.random.default_rng(1), [], []
    for alpha in WALKED:
        found = walk(kind.kind, alpha, np.sqrt(rng.random(RAYS)), white, rng)
        further = found.met[found.met >= 2] - 1  # 1/(1 - q) on average, of the geometric series
        q, error = 1 - 1 / further.mean(), further.std() / further.mean() ** 2 / np.sqrt(len(further))
        rows.append([1 / error, alpha / error, alpha * alpha / error, q / error])
        shares.append((alpha, q))
    a = np.array(rows)
    c = np.linalg.lstsq(a[:, :3], a[:, 3], rcond=None)[0].round(4)
    off = max(abs(float(np.polyval(c[::-1], alpha)) - q) for alpha, q in shares)
    return replace(formula, stays=tuple(c.tolist())), off


def main() -> None:
    for name, (kind, form, scale, powers, ridge) in KINDS.items():
        rows = [(alpha, mu, missing(kind(1.0, alpha), mu)) for alpha in ROUGH for mu in cosines(alpha)]
        alpha, mu, wanted = np.array(rows).T
        most = np.array([wanted[alpha == each].max() for each in ROUGH])
        formula = averages(fitted((alpha, mu, wanted), form(scale, ((1.0,),), (1.0,), ()), powers, ridge), most)
        returned = formula(NUMPY, mu, alpha) * averaged(formula, alpha) / formula.mean(NUMPY, alpha)
        for said, values in (("the formula", formula(NUMPY, mu, alpha)), ("with its mean", returned)):
            off = np.abs(values - wanted)
            print(f"#: {said}: {off.max():.5f}, {off[alpha < 0.1].max():.5f} below alpha = 0.1")
        formula, off = lingering(formula, kind)
        print(f"#: q: {off:.3f}")
        print(f"{name}_MISSING = {formula}")


if __name__ == "__main__":
    main()
