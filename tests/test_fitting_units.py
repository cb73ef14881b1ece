"""Data in units of nobody: a fit of c times the data gives c times the strengths, and the same of everything else."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

import motes
from motes.directions import from_spherical
from motes.fitting.columns import BRIGHTEST, DARKEST, unit_of
from motes.fitting.texels import TexelSolver
from motes.measurements import Measurement

Floats = NDArray[np.float64]
STRENGTHS = ("K_d", "K_s")
#: From the brightness of raw counts, beyond which values are masked, down to what is left of a BRDF in other units.
FACTORS = (1e-12, 3e-8, 1e-4, 1e3, 1e6, 1e9)
GGX = motes.Lambert(K_d=(0.12, 0.08, 0.05)) + motes.GGX(K_s=0.02, alpha=0.3)
GTR = motes.Lambert(K_d=(0.12, 0.08, 0.05)) + motes.GTR(K_s=0.02, alpha=0.3, gamma=1.6)
GLOSS = motes.Lambert(K_d=(0.12, 0.08, 0.05)) + motes.TorranceSparrow(K_s=0.02, sigma_s=0.2)


def directions(count: int = 90) -> tuple[Floats, Floats]:
    rng = np.random.default_rng(3)
    theta, phi = rng.uniform(0, 1.1, (2, count)), rng.uniform(0, 2 * np.pi, (2, count))
    phi[1, : count // 2] = phi[0, : count // 2] + np.pi + rng.normal(0, 0.2, count // 2)
    theta[1, : count // 2] = np.clip(theta[0, : count // 2] + rng.normal(0, 0.2, count // 2), 0, 1.1)
    return from_spherical(theta[0], phi[0]), from_spherical(theta[1], phi[1])


def noisy(brdf: motes.BRDF, noise: float = 0.02) -> Floats:
    values = brdf.eval(*directions())
    return np.asarray(values * (1 + noise * np.random.default_rng(8).standard_normal(values.shape)))


def measured(values: Floats, **more: Any) -> Measurement:
    data = Measurement.from_arrays(*directions(), values, **more)
    assert data.mask.all()
    return data


def found(fit: motes.Fit, factor: float) -> tuple[Floats, Floats, Floats, list[object]]:
    """Values, errors and ends of intervals, over the factor where they go with it; and what is said in words."""
    over = {name: factor if name in STRENGTHS else 1.0 for name in fit.parameters}
    parts = [
        np.concatenate([np.ravel(part) / over[name] for name, part in parts.items()])
        for parts in (
            {name: p.value for name, p in fit.parameters.items()},
            {name: p.stderr for name, p in fit.parameters.items()},
            {name: p.intervals["95"] for name, p in fit.parameters.items()},
        )
    ]
    words = [fit.status, *(v for p in fit.parameters.values() for v in p.verdicts), fit.errors.kind]
    return parts[0], parts[1], parts[2], words


@pytest.mark.parametrize("errors", ["independent", "blocks"])
@pytest.mark.parametrize("robust", ["none", "soft_l1", "cauchy"])
@pytest.mark.parametrize("loss", ["linear", "plain", "cube_root"])
@pytest.mark.parametrize("model", ["lambert + ggx", "lambert + gtr", "lambert + torrance_sparrow"])
def test_a_fit_goes_with_the_scale_of_its_data(model: str, loss: str, robust: str, errors: str) -> None:
    values = noisy({"lambert + ggx": GGX, "lambert + gtr": GTR, "lambert + torrance_sparrow": GLOSS}[model])

    def fitted(factor: float) -> tuple[Floats, Floats, Floats, list[object]]:
        return found(motes.fit(measured(values * factor), model, loss=loss, robust=robust, errors=errors), factor)

    one = fitted(1.0)
    for factor in FACTORS:
        other = fitted(factor)
        for a, b in zip(one[:3], other[:3], strict=True):
            np.testing.assert_allclose(b, a, rtol=1e-5, atol=1e-9)
        assert other[3] == one[3]


@settings(max_examples=12, deadline=None, derandomize=True)
@given(exponent=st.floats(-12, 9), noise=st.sampled_from([0.02, 0.3, 1.0]), seed=st.integers(0, 99))
def test_verdicts_do_not_depend_on_units(exponent: float, noise: float, seed: int) -> None:
    # Noise of the size of the data leaves much that is weak or not determined at all.
    clean = GGX.eval(*directions())
    values = clean * (1 + noise * np.random.default_rng(seed).standard_normal(clean.shape))
    factor = 10.0**exponent
    one, other = (
        found(motes.fit(Measurement.from_arrays(*directions(), values * c), "lambert + ggx"), c) for c in (1.0, factor)
    )
    np.testing.assert_allclose(other[0], one[0], rtol=1e-4, atol=1e-6)
    assert other[3][0] == one[3][0]


@pytest.mark.parametrize("factor", [1e-12, 1e-6])
def test_the_logarithm_of_little_is_linear(factor: float) -> None:
    values = noisy(GGX) * factor
    log, linear = (found(motes.fit(measured(values), "lambert + ggx", loss=loss), factor) for loss in ("log", "linear"))
    np.testing.assert_allclose(log[0], linear[0], rtol=1e-4)
    assert log[3] == linear[3]


@pytest.mark.parametrize("factor", [1e-12, 1e-5, 1e8])
def test_auto_takes_the_same_model(factor: float) -> None:
    values = noisy(motes.Lambert(K_d=(0.12, 0.08, 0.05)))
    one, other = (motes.fit(measured(values * c), "auto") for c in (1.0, factor))
    # Models whose parameters are shares of light cannot follow: what is linear is fitted alike.
    assert one.model_text == other.model_text == "lambert"
    assert one.dusty == other.dusty
    np.testing.assert_allclose(other.parameters["K_d"].value / factor, one.parameters["K_d"].value, rtol=1e-6)


@pytest.mark.parametrize("factor", [1e-12, 1e-5, 1e6])
def test_trends_go_with_the_scale_of_their_data(factor: float) -> None:
    hours = np.array([0.0, 1.0, 2.0, 3.0, 5.0])
    rng = np.random.default_rng(4)
    scans = np.stack(
        [
            (motes.Lambert(K_d=(0.05 + 0.02 * t, 0.04, 0.03)) + motes.GGX(K_s=0.03 - 0.004 * t, alpha=0.3)).eval(
                *directions()
            )
            for t in hours
        ]
    )
    scans = scans * (1 + 0.02 * rng.standard_normal(scans.shape))
    one, other = (motes.fit(measured(scans * c, times=hours), "lambert + ggx") for c in (1.0, factor))
    for name, trend in one.trends.items():
        over = factor if name in STRENGTHS else 1.0
        assert other.trends[name].trend.kind == trend.trend.kind, name
        assert other.trends[name].verdict == trend.verdict, name
        np.testing.assert_allclose(other.trends[name].trend(hours) / over, trend.trend(hours), rtol=1e-4)
        np.testing.assert_allclose(other.trends[name].trend.stderr(hours) / over, trend.trend.stderr(hours), rtol=1e-3)
    assert other.status == one.status


@pytest.mark.parametrize("factor", [1e-12, 1e-5, 1e3, 1e8])
@pytest.mark.parametrize("robust", ["none", "soft_l1"])
def test_texels_go_with_the_scale_of_their_data(robust: str, factor: float) -> None:
    clean = GGX.eval(*directions())
    texels = clean * (1 + 0.05 * np.random.default_rng(2).standard_normal((40, *clean.shape)))
    solver = TexelSolver("lambert + ggx", *directions(), 3, robust=robust)

    def fitted(c: float) -> tuple[Floats, Floats, NDArray[np.uint8], NDArray[np.uint8]]:
        data = (texels * c).astype(np.float32)
        fit = solver.fit(data, solver.starts(data[:20]))
        over = np.array([c if column.quantity in STRENGTHS else 1.0 for column in solver.columns])
        return fit.x / over, fit.stderr / over, fit.verdicts, fit.status

    one, other = fitted(1.0), fitted(factor)
    np.testing.assert_allclose(other[0], one[0], rtol=2e-3)
    np.testing.assert_allclose(other[1], one[1], rtol=5e-3)
    np.testing.assert_array_equal(other[2], one[2])
    np.testing.assert_array_equal(other[3], one[3])


def test_ordinary_data_have_no_units_of_their_own() -> None:
    used = np.ones((4, 1), bool)
    for mean in (DARKEST * 1.01, 0.3, BRIGHTEST * 0.99):
        assert unit_of(np.full((4, 1), mean / np.pi), used) == 1.0
    assert unit_of(np.full((4, 1), 1e-12 / np.pi), used) == pytest.approx(1e-12 / DARKEST)
    assert unit_of(np.full((4, 1), 1e9 / np.pi), used) == pytest.approx(1e9 / BRIGHTEST)
    # A highlight is no reason, nor is what is masked.
    assert unit_of(np.array([[0.1], [0.1], [0.1], [1e6]]), used) == 1.0
    assert unit_of(np.array([[0.1], [np.nan]]), np.array([[True], [False]])) == 1.0
    assert unit_of(np.zeros((2, 1)), np.zeros((2, 1), bool)) == 1.0
