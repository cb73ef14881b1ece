"""Uncertainties of the data in a fit: weights, chi-square, errors that hold, and a scale that all samples share."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import motes
from fitting_oracle import scattered
from motes.errors import DataError
from motes.fitting import Fit, Verdict, setup
from motes.fitting.losses import LOSSES
from motes.fitting.metrics import deviation
from motes.measurements import Measurement

TS = "oren_nayar + torrance_sparrow"
GLOSSY = motes.OrenNayar(K_d=(0.6, 0.4), sigma_d=0.4) + motes.TorranceSparrow(K_s=0.25, sigma_s=0.15)
WI, WO = scattered(200, 3)
TRUE = GLOSSY.eval(WI, WO)
# A few samples are ten times better than the rest, as where a detector changes its range.
SPREAD = np.where(np.arange(len(WI)) % 4 == 0, 0.002, 0.02)[:, None] * np.ones(2)


def fitted(seed: int, **options: object) -> Fit:
    values = TRUE + SPREAD * np.random.default_rng(seed).standard_normal(TRUE.shape)
    data = Measurement.from_arrays(WI, WO, values, uncertainties=SPREAD)
    return motes.fit(data, TS, **options)


def flat(fit: Fit, what: str) -> np.ndarray:
    return np.concatenate([np.atleast_1d(getattr(p, what)) for p in fit.parameters.values()])


@pytest.mark.parametrize("loss", ["linear", "plain", "log"])
def test_reduced_chi_square_is_one_whatever_the_loss(loss: str) -> None:
    """396 degrees of freedom: one standard deviation of the mean of ten is 0.022."""
    found = [fitted(seed, loss=loss).metrics["reduced_chi_square"] for seed in range(10)]
    assert np.mean(found) == pytest.approx(1.0, abs=0.07)


def test_errors_are_smaller_with_the_uncertainties_and_hold() -> None:
    fits = [fitted(seed) for seed in range(60)]
    values, errors = (np.array([flat(fit, what) for fit in fits]) for what in ("value", "stderr"))
    truth = np.array([0.6, 0.4, 0.4, 0.25, 0.15])
    pull = (values - truth) / errors
    # The mean square of 60 pulls is 1 +- 0.18 where errors are right.
    assert np.all(np.abs(np.mean(pull**2, axis=0) - 1) < 0.55), np.mean(pull**2, axis=0)
    plain = np.array([flat(fitted(seed, weights="uniform"), "stderr") for seed in range(10)])
    assert np.all(np.median(errors, axis=0) < 0.6 * np.median(plain, axis=0))
    assert "chi_square" not in fitted(0, weights="uniform").metrics


def test_a_sample_of_unknown_uncertainty_is_left_out_and_said() -> None:
    spread = SPREAD.copy()
    spread[7, 1] = np.nan
    data = Measurement.from_arrays(WI, WO, TRUE, uncertainties=spread)
    fit = motes.fit(data, TS)
    assert fit.metrics["n_samples"] == TRUE.size - 1
    assert fit.measurement.masked["uncertainty unknown"] == 1


def test_a_scale_that_all_samples_share_moves_what_is_proportional_to_it() -> None:
    """Two per cent of the scale are two per cent of K_s and nothing of a width; equation (7) bends K_d a little."""
    values = TRUE * (1 + 0.001 * np.random.default_rng(1).standard_normal(TRUE.shape))
    alone = motes.fit(Measurement.from_arrays(WI, WO, values), TS)
    shared = motes.fit(Measurement.from_arrays(WI, WO, values, common_uncertainty=0.02), TS)
    np.testing.assert_array_equal(flat(alone, "value"), flat(shared, "value"))
    K_s, sigma_s, K_d = (shared.parameters[name] for name in ("K_s", "sigma_s", "K_d"))
    assert K_s.stderr / K_s.value == pytest.approx(0.02, rel=0.05)
    assert sigma_s.stderr == pytest.approx(alone.parameters["sigma_s"].stderr, rel=0.2)
    # What a fit to data 2 % brighter says is the same.
    brighter = motes.fit(Measurement.from_arrays(WI, WO, 1.02 * values), TS)
    move = np.abs(flat(brighter, "value") - flat(alone, "value"))
    expected = np.sqrt(flat(alone, "stderr") ** 2 + move**2)
    np.testing.assert_allclose(flat(shared, "stderr"), expected, rtol=0.1)
    assert K_d.stderr[0] / K_d.value[0] == pytest.approx(0.02, rel=0.2)


def test_the_deviation_of_noise_hardly_moves_with_what_is_far_off() -> None:
    rng = np.random.default_rng(4)
    noise = 0.3 * rng.standard_normal((3, 4001))
    far = noise.copy()
    far[:, :200] = 50.0
    far[1, 300:500] = np.nan
    np.testing.assert_allclose(deviation(noise), 0.3, rtol=0.05)
    np.testing.assert_allclose(deviation(far), 0.3, rtol=0.15)
    assert float(deviation(noise[0])) == deviation(noise)[0]
    assert deviation(np.full((2, 5), np.nan)).tolist() == [1e-12, 1e-12]


def test_a_loss_without_a_value_is_refused() -> None:
    values = TRUE + 3.0 * np.random.default_rng(2).standard_normal(TRUE.shape)  # some 1 + f cos theta_i below 0
    data = Measurement.from_arrays(WI, WO, values)
    lost = int(np.count_nonzero((1 + data.values[0] * WI[:, 2:3] <= 0) & data.mask[0]))
    assert lost > 5
    with pytest.raises(DataError, match=rf"loss log has no value at {lost} sample"):
        motes.fit(data, TS, loss="log")
    fit = motes.fit(data, TS, loss="cube_root")
    assert np.isnan(fit.metrics["rms_log"])
    assert fit.to_dict()["metrics"]["rms_log"] is None


def test_a_common_uncertainty_counts_beside_a_bound_that_is_loose() -> None:
    """A Lambertian surface: noise puts sigma_d at 0 half of the time; K_d has the error of the scale all the same."""
    flat_ = motes.Lambert(K_d=0.5).eval(WI, WO) * np.ones((1, 1))
    bounded = 0
    for seed in range(12):
        values = flat_ * (1 + 0.02 * np.random.default_rng(seed).standard_normal(flat_.shape))
        alone = motes.fit(Measurement.from_arrays(WI, WO, values), "oren_nayar").parameters
        shared = motes.fit(Measurement.from_arrays(WI, WO, values, common_uncertainty=0.05), "oren_nayar").parameters
        bounded += alone["sigma_d"].verdict == Verdict.AT_LOWER
        wider = np.hypot(alone["K_d"].stderr, 0.05 * alone["K_d"].value)
        assert shared["K_d"].stderr == pytest.approx(wider, rel=0.05)
    assert bounded >= 3


@pytest.mark.parametrize("model", ["oren_nayar + torrance_sparrow", "hapke"])
@pytest.mark.parametrize("options", [{}, {"weights": "uniform", "robust": "huber"}, {"loss": "cube_root"}], ids=str)
def test_weights_that_are_alike_are_held_once_and_change_nothing(
    model: str, options: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    data = Measurement.from_arrays(WI, WO, TRUE + 0.3 * SPREAD, weights=np.full(len(WI), 3.0))
    held = setup.sample_weights(data, "measurement", LOSSES["linear"]).values
    assert held.strides == (0, 0, 0)
    once = motes.fit(data, model, **options)
    monkeypatch.setattr(setup, "everywhere", lambda number, shape: np.full(shape, number))
    each = motes.fit(data, model, **options)
    assert once.metrics == each.metrics
    np.testing.assert_array_equal(once.covariance, each.covariance)
    assert once.to_dict()["parameters"] == each.to_dict()["parameters"]
