"""Choosing among models, and robust losses: the right candidate is found, and outliers do no harm."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest

import motes
from fitting_oracle import Oracle, scattered
from motes.fitting.choice import CANDIDATES, LADDER
from motes.measurements import Measurement

TS = "oren_nayar + torrance_sparrow"
BASE = motes.OrenNayar(K_d=(0.6, 0.4, 0.25), sigma_d=0.4)
TRUTH = {
    "lambert": motes.Lambert(K_d=(0.6, 0.4, 0.25)),
    "oren_nayar": BASE,
    TS: BASE + motes.TorranceSparrow(K_s=0.25, sigma_s=0.15),
    "dust_layer(oren_nayar + torrance_sparrow)": motes.DustLayer(
        BASE + motes.TorranceSparrow(K_s=0.25, sigma_s=0.15), motes.Dust(w=(0.9, 0.8, 0.7), g=0.3), tau=0.3
    ),
}


@pytest.mark.parametrize("model", TRUTH)
def test_the_model_that_made_the_data_is_chosen(model: str) -> None:
    """2 % noise, 4 seeds: at least 3 right (of 12 at least 11 were), and of dust what is true.

    Slow candidates are left out where a layer that scatters once does not look worth it.
    """
    wi, wo = scattered(250, 3)
    f = TRUTH[model].eval(wi, wo)
    chosen = Counter()
    for seed in range(4):
        rng = np.random.default_rng([5, seed])
        fit = motes.fit(Measurement.from_arrays(wi, wo, f * (1 + 0.02 * rng.standard_normal(f.shape))))
        tried = list(dict.fromkeys(trial.model for trial in fit.tried))
        assert tried == [text for text in CANDIDATES if text in tried]
        assert set(tried) >= {candidate.text for candidate in LADDER if not candidate.slow}
        assert [trial.model for trial in fit.tried if trial.chosen] == [fit.model_text]
        assert all(trial.left_out > 0 for trial in fit.tried)
        assert fit.dusty is ("dust" in model)
        chosen[fit.model_text] += 1
    assert chosen[model] >= 3, chosen


@pytest.mark.parametrize("model", TRUTH)
def test_data_without_noise_choose_it_too(model: str) -> None:
    """Residuals are rounding then: a larger model has smaller ones by chance, which must not count."""
    wi, wo = scattered(250, 3)
    fit = motes.fit(Measurement.from_arrays(wi, wo, TRUTH[model].eval(wi, wo)))
    assert fit.model_text == model
    assert fit.status.ok
    for name, truth in TRUTH[model].parameters.items():
        np.testing.assert_allclose(fit.parameters[name].value, truth, rtol=2e-3)


def test_bic_by_hand() -> None:
    wi, wo = scattered(100, 1)
    rng = np.random.default_rng(1)
    f = BASE.eval(wi, wo)
    data = Measurement.from_arrays(wi, wo, f * (1 + 0.02 * rng.standard_normal(f.shape)))
    fit = motes.fit(data, "oren_nayar")
    squares = np.sum((fit.residuals * wi[:, 2:3]) ** 2)
    assert fit.metrics["objective"] == pytest.approx(squares / 2, rel=1e-9)
    assert fit.metrics["bic"] == pytest.approx(300 * np.log(squares / 300) + 4 * np.log(300), rel=1e-9)


def test_large_data_are_compared_on_a_part_and_fitted_to_all() -> None:
    wi, wo = scattered(210_000, 1)
    rng = np.random.default_rng(1)
    f = TRUTH[TS].eval(wi, wo)
    fit = motes.fit(Measurement.from_arrays(wi, wo, f * (1 + 0.05 * rng.standard_normal(f.shape))))
    assert fit.model_text == TS
    assert fit.metrics["n_samples"] == 630_000
    assert {trial.n_samples for trial in fit.tried} == {12_000}
    for name, p in fit.parameters.items():
        assert np.all(np.abs(p.value - np.asarray(TRUTH[TS].parameters[name])) < 4 * p.stderr), name
        assert np.all(p.stderr < 2e-3)


# ---------------------------------------------------------------- outliers


def spoiled(seed: int) -> Measurement:
    """2 % noise, and 5 % of the samples 3 to 8 times too bright."""
    wi, wo = scattered(300, 6)
    rng = np.random.default_rng(seed)
    f = TRUTH[TS].eval(wi, wo)
    f = f * (1 + 0.02 * rng.standard_normal(f.shape))
    return Measurement.from_arrays(
        wi, wo, f * np.where(rng.uniform(size=f.shape) < 0.05, rng.uniform(3, 8, f.shape), 1)
    )


def off(fit: motes.Fit) -> float:
    """How far off the parameters are, relative, in the mean."""
    truth = TRUTH[TS].parameters
    return float(np.mean([np.mean(np.abs(p.value / np.asarray(truth[n]) - 1)) for n, p in fit.parameters.items()]))


@pytest.mark.parametrize("robust", ["soft_l1", "huber", "cauchy"])
def test_outliers_do_little_harm(robust: str) -> None:
    plain, mended = [], []
    for seed in range(10):
        data = spoiled(seed)
        plain.append(off(motes.fit(data, TS)))
        mended.append(off(motes.fit(data, TS, robust=robust)))
    assert np.median(mended) < np.median(plain) / 4
    assert np.max(mended) < np.min(plain)


@pytest.mark.parametrize("loss", ["linear", "log"])
@pytest.mark.parametrize("robust", ["soft_l1", "huber", "cauchy"])
def test_robust_objectives_are_scipys(robust: str, loss: str) -> None:
    """With the same scale (the median residual of the plain fit), SciPy's ``loss=`` and ``f_scale=`` find no better."""
    data = spoiled(3)
    usable = np.flatnonzero(data.mask[0].all(axis=1))
    values = data.values[0][usable]
    fit = motes.fit(data, TS, loss=loss, robust=robust)
    oracle = Oracle(data.wi[usable], data.wo[usable], values, TS, loss)
    plain = motes.fit(data, TS, loss=loss)
    residual = oracle.residuals(np.concatenate([np.atleast_1d(p.value) for p in plain.parameters.values()]))
    scale = 1.4826 * np.median(np.abs(residual - np.median(residual)))
    best = oracle.best(6, seed=2, loss=robust, f_scale=scale)
    assert fit.metrics["objective"] <= 1.001 * best.cost
    assert fit.metrics["objective"] >= 0.99 * best.cost  # the same function, not a smaller one


def test_robust_is_plain_where_there_is_no_outlier() -> None:
    wi, wo = scattered(300, 6)
    rng = np.random.default_rng(2)
    f = TRUTH[TS].eval(wi, wo)
    data = Measurement.from_arrays(wi, wo, f * (1 + 0.02 * rng.standard_normal(f.shape)))
    plain, robust = motes.fit(data, TS), motes.fit(data, TS, robust="huber")
    for name, p in plain.parameters.items():
        assert np.all(np.abs(p.value - robust.parameters[name].value) < 3 * p.stderr), name
