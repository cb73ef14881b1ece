"""One fit by two ways: `motes.fit` and the texels' kernel give the same values, the same standard errors and the same verdicts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import motes
from motes.fitting.covariance import VERDICTS
from motes.fitting.texels import TexelSolver, TexelStatus
from motes.fitting.verdicts import Verdict
from motes.trends import KINDS, flat

Floats = NDArray[np.float64]
PAINT = "oren_nayar + torrance_sparrow"
HOURS = np.array([0.0, 1.0, 2.5, 4.0, 7.0, 9.0])


def directions(count: int, seed: int) -> tuple[Floats, Floats]:
    """Pairs of directions, every other one near the mirror direction, none close to grazing."""
    rng = np.random.default_rng(seed)
    pairs: list[tuple[Floats, Floats]] = []
    while len(pairs) < count:
        wi, wo = (_direction(rng) for _ in range(2))
        if len(pairs) % 2:
            wo = np.array([-wi[0], -wi[1], wi[2]]) + rng.normal(0, 0.2, 3)
            wo /= np.linalg.norm(wo)
        if wo[2] > 0.2:
            pairs.append((wi, wo))
    both = np.array(pairs)
    return both[:, 0], both[:, 1]


def _direction(rng: np.random.Generator) -> Floats:
    z, phi = rng.uniform(0.25, 0.98), rng.uniform(0, 2 * np.pi)
    return np.array([np.sqrt(1 - z * z) * np.cos(phi), np.sqrt(1 - z * z) * np.sin(phi), z])


@dataclass(frozen=True)
class Case:
    """A surface, what is measured of it, and how it is fitted."""

    surface: motes.BRDF
    model: str = PAINT
    count: int = 100
    options: Mapping[str, Any] = field(default_factory=dict)
    trends: Mapping[str, str] | None = None
    noise: float = 0.02
    outliers: int = 0
    masked: bool = False
    dent: motes.BRDF | None = None
    texels: int = 3

    def data(self) -> tuple[Floats, Floats, NDArray[np.float32]]:
        """Directions, and values (M, [T,] D, C)."""
        wi, wo = directions(self.count, 3)
        rng = np.random.default_rng(17)
        clean = np.atleast_3d(self.surface.eval(wi, wo) * np.ones(3)) if self.trends is None else self._series(wi, wo)
        clean = clean.reshape(*([] if self.trends is None else [len(HOURS)]), self.count, 3)
        if self.dent is not None:
            clean = clean - self.dent.eval(wi, wo)
        values = clean * (1 + self.noise * rng.standard_normal((self.texels, *clean.shape)))
        if self.outliers:
            for texel in values:
                texel[rng.choice(self.count, self.outliers, replace=False)] *= 3
        if self.masked:
            values[:, ::5, 1] = np.nan
            values[:, 1::7, 2] = np.nan
        return wi, wo, values.astype(np.float32)

    def _series(self, wi: Floats, wo: Floats) -> Floats:
        rows = []
        for hour in HOURS:
            K_d = 0.3 + np.array([0.3, 0.25, 0.2]) * (1 - np.exp(-hour / 3))
            rows.append(self.surface.with_parameters({"K_d": K_d}).eval(wi, wo))
        return np.stack(rows)


WHITE = (0.6, 0.5, 0.4)
CASES = {
    "a parameter at a bound": Case(motes.Lambert(K_d=WHITE), "oren_nayar"),
    # Less light than the diffuse part where a highlight would be: K_s ends at 0, and nothing tells of a width.
    "an invisible highlight": Case(
        motes.OrenNayar(K_d=WHITE, sigma_d=0.4), dent=motes.TorranceSparrow(K_s=0.003, sigma_s=0.25)
    ),
    "few directions": Case(
        motes.OrenNayar(K_d=WHITE, sigma_d=0.4) + motes.TorranceSparrow(K_s=0.3, sigma_s=0.25), count=9
    ),
    "two channels masked in places": Case(
        motes.OrenNayar(K_d=WHITE, sigma_d=0.4) + motes.TorranceSparrow(K_s=0.3, sigma_s=0.25), masked=True
    ),
    "robust": Case(
        motes.OrenNayar(K_d=WHITE, sigma_d=0.4) + motes.TorranceSparrow(K_s=0.3, sigma_s=0.25),
        options={"robust": "huber"},
        outliers=6,
    ),
    "log": Case(
        motes.OrenNayar(K_d=WHITE, sigma_d=0.4) + motes.TorranceSparrow(K_s=0.3, sigma_s=0.25), options={"loss": "log"}
    ),
    "trends": Case(
        motes.OrenNayar(K_d=WHITE, sigma_d=0.4) + motes.TorranceSparrow(K_s=0.3, sigma_s=0.25),
        trends={"K_d": "exponential", "sigma_d": "constant", "K_s": "constant", "sigma_s": "constant"},
        texels=1,
    ),
    "dust": Case(
        motes.DustLayer(
            motes.OrenNayar(K_d=WHITE, sigma_d=0.4) + motes.TorranceSparrow(K_s=0.3, sigma_s=0.25),
            motes.Dust(w=(0.7, 0.6, 0.5), g=0.3),
            tau=0.4,
        ),
        "dust_layer(oren_nayar + torrance_sparrow)",
        options={"fixed": {"g": 0.3}},
        noise=0.005,
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_a_texel_is_fitted_as_a_measurement_is(name: str) -> None:
    case = CASES[name]
    wi, wo, values = case.data()
    hours = None if case.trends is None else HOURS
    solver = TexelSolver(case.model, wi, wo, 3, hours=hours, trends=case.trends, **case.options)
    fast = solver.fit(values, solver.starts(values))
    assert (fast.status == TexelStatus.CONVERGED).all()
    for k, texel in enumerate(values):
        value, stderr, verdicts = _single(case, solver, wi, wo, texel)
        codes = [VERDICTS.index(v) for v in verdicts]
        assert fast.verdicts[k].tolist() == codes
        known = np.isfinite(stderr)
        assert (np.isfinite(fast.stderr[k]) == known).all()
        assert known.any()
        # What cannot be identified has no value to speak of.
        seen = known & (fast.verdicts[k] < VERDICTS.index(Verdict.UNIDENTIFIABLE))
        np.testing.assert_allclose(fast.stderr[k][seen], stderr[seen], rtol=0.01)
        assert (np.abs(fast.x[k] - value)[seen] < 1e-3 * stderr[seen] + 1e-7).all()
        bound = np.isin(fast.verdicts[k], [VERDICTS.index(v) for v in verdicts if v.name.startswith("AT_")])
        np.testing.assert_allclose(fast.x[k][bound], value[bound], atol=1e-6)


def _single(
    case: Case, solver: TexelSolver, wi: Floats, wo: Floats, texel: NDArray[np.float32]
) -> tuple[Floats, Floats, list[Any]]:
    """The values, standard errors and verdicts of `motes.fit`, in the order of the solver's columns."""
    values = texel.astype(float)
    if case.trends is None:
        fit = motes.fit(motes.Measurement.from_arrays(wi, wo, values), case.model, **case.options)
    else:
        series = motes.Measurement.from_arrays(wi, wo, values, times=HOURS, time_unit="h")
        fit = motes.fit(series, case.model, trends=case.trends, **case.options)
    found: list[tuple[float, float, Any]] = []
    for column in solver.columns:
        c = column.channel or 0
        if case.trends is None:
            p = fit.parameters[column.quantity]
            found.append((np.atleast_1d(p.value)[c], np.atleast_1d(p.stderr)[c], p.verdicts[c]))
            continue
        t = fit.trends[column.quantity]
        names = [k.name for k in KINDS[t.trend.kind].coefficients for _ in np.atleast_1d(t.trend.coefficients[k.name])]
        at = names.index(column.coefficient) + c
        found.append((flat(t.trend)[at], np.sqrt(t.trend.covariance[at, at]), t.verdict))
    value, stderr, verdicts = zip(*found, strict=True)
    return np.array(value, float), np.array(stderr, float), list(verdicts)
