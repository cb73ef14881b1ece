"""Fits over time: known truths come back, with errors that hold; bad scans, missing scans, and what can't be known are said."""

from __future__ import annotations

import csv
import json
import re
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from scipy.optimize import least_squares

import motes
from fitting_oracle import Formulas
from motes.ageing import Rig, simulate
from motes.errors import DataError, MotesError
from motes.fitting.joint import Joint, Part
from motes.fitting.result import Fit
from motes.fitting.scans import fit_scans, single
from motes.fitting.setup import Wishes, prepare
from motes.fitting.time_result import TimeFit
from motes.fitting.trend_choice import CANDIDATE_KINDS, Profile, determined, survey
from motes.fitting.uncertainty import uncertainty
from motes.fitting.verdicts import Verdict
from motes.material import Material
from motes.measurements import Measurement
from motes.models import BRDF, DustLayer, OrenNayar, TorranceSparrow, parse
from motes.trends import KINDS, Trend

MODEL = "oren_nayar + torrance_sparrow"
DUSTY = "dust_layer(oren_nayar + torrance_sparrow)"
LAST = 4.0
TIMES = np.linspace(0, LAST, 8)
UNEVEN = np.array([0.0, 0.2, 0.5, 1.1, 1.4, 2.6, 3.7, 4.0])
TRUTH = Material(
    OrenNayar(K_d=(0.3, 0.25, 0.2), sigma_d=0.3) + TorranceSparrow(K_s=0.5, sigma_s=0.15),
    "paint",
    ("R", "G", "B"),
    trends={
        "K_d": Trend("linear", {"start": (0.3, 0.25, 0.2), "end": (0.6, 0.5, 0.45)}, (0, LAST)),
        "K_s": Trend("exponential", {"start": 0.5, "end": 0.1, "time_constant": 1.0}, (0, LAST)),
    },
)
TRUE_KINDS = {"K_d": "linear", "sigma_d": "constant", "K_s": "exponential", "sigma_s": "constant"}


def directions() -> tuple[np.ndarray, np.ndarray]:
    """The rig's four cameras, the lamp in steps of 4 degrees: 160 pairs of directions."""
    rig = Rig(step_deg=4.0)
    wi, wo = np.tile(rig.wi, (4, 1)), np.repeat(rig.wo, len(rig.wi), axis=0)
    up = wi[:, 2] > 0.2
    return wi[up], wo[up]


WI, WO = directions()


def series(
    at: Callable[[float], BRDF], times: Any = TIMES, seed: int = 0, noise: float = 0.02, channels: int = 3
) -> Measurement:
    """Scans of a surface with relative noise."""
    rng = np.random.default_rng(seed)
    exact = np.stack([np.broadcast_to(at(float(t)).eval(WI, WO), (len(WI), channels)) for t in times])
    names = ("R", "G", "B") if channels == 3 else ("grey",)
    return measurement(exact * (1 + noise * rng.standard_normal(exact.shape)), times, names)


def measurement(values: np.ndarray, times: Any = TIMES, channels: tuple[str, ...] = ("R", "G", "B")) -> Measurement:
    return Measurement.from_arrays(WI, WO, values, times=times, channels=channels)


@cache
def painted(seed: int = 0) -> TimeFit:
    """The fit of the truth at uneven times."""
    return fitted(series(TRUTH.at, UNEVEN, seed))


def fitted(data: Measurement, model: Any = MODEL, **options: Any) -> TimeFit:
    found = motes.fit(data, model, **options)
    assert isinstance(found, TimeFit)
    assert found.status.ok
    return found


def true_values(name: str, hours: np.ndarray) -> np.ndarray:
    value = TRUTH.trends[name](hours) if name in TRUTH.trends else np.full(len(hours), TRUTH.brdf.parameters[name])
    return value.reshape(len(hours), -1)


def kinds(fit: TimeFit) -> dict[str, str]:
    return {name: t.trend.kind for name, t in fit.trends.items()}


# ---------------------------------------------------------------- A known truth


def test_the_right_trends_are_chosen_and_hold_the_truth() -> None:
    """Of 32 choices one in ten may be wrong, for the noise can look like a change; the band must hold the truth all the same."""
    right = 0
    for seed in range(8):
        fit = painted(seed)
        assert not fit.outliers
        assert not fit.findings
        for name, found in fit.trends.items():
            assert found.verdict == Verdict.IDENTIFIED
            value, error = found.band(UNEVEN)
            assert (np.abs(value - true_values(name, UNEVEN)) < 4 * error).all(), (seed, name)
            if found.trend.kind != TRUE_KINDS[name]:
                assert found.alternatives[1].kind == TRUE_KINDS[name]
                continue
            right += 1
            truth = TRUTH.trends.get(name) or Trend("constant", {"value": TRUTH.brdf.parameters[name]}, (0, LAST))
            errors, start = np.sqrt(np.diag(found.trend.covariance)), 0
            for coefficient in KINDS[truth.kind].coefficients:
                got = np.atleast_1d(found.trend.coefficients[coefficient.name])
                own = errors[start : start + len(got)]
                assert (own > 0).all()
                assert (np.abs(got - truth.coefficients[coefficient.name]) < 4 * own).all(), (
                    seed,
                    name,
                    coefficient.name,
                )
                start += len(got)
    assert right >= 29


def test_together_the_scans_say_more_than_each() -> None:
    joint, separate = [], []
    for seed in range(4):
        for name, found in painted(seed).trends.items():
            truth = true_values(name, UNEVEN)
            joint.append(np.abs(found.trend(UNEVEN).reshape(len(UNEVEN), -1) - truth).mean() / truth.mean())
            separate.append(np.abs(found.scan_values - truth).mean() / truth.mean())
    assert np.mean(joint) < 0.5 * np.mean(separate)


def test_scan_errors_are_about_those_made() -> None:
    scores = [
        (t.scan_values - true_values(name, UNEVEN)) / t.scan_stderr
        for seed in range(4)
        for name, t in painted(seed).trends.items()
    ]
    assert 0.8 < np.sqrt(np.mean(np.concatenate([s.ravel() for s in scores]) ** 2)) < 1.25


def test_a_fit_comes_out_the_same_again() -> None:
    first, again = painted(1), fitted(series(TRUTH.at, UNEVEN, 1))
    for name, t in first.trends.items():
        for coefficient, value in t.trend.coefficients.items():
            assert_array_equal(again.trends[name].trend.coefficients[coefficient], value)
    assert again.metrics == first.metrics


def test_what_does_not_change_is_constant() -> None:
    fit = fitted(series(lambda t: TRUTH.at(1.0), seed=5))
    assert set(kinds(fit).values()) == {"constant"}
    for name, found in fit.trends.items():
        assert (np.abs(found.trend(0.0) - true_values(name, np.array([1.0]))[0]) < 4 * found.trend.stderr(0.0)[0]).all()


def test_a_front_passing_is_logistic_and_dust_straight() -> None:
    layer = parse(DUSTY).model.with_parameters(
        {"K_d": 0.4, "sigma_d": 0.3, "K_s": 0.5, "sigma_s": 0.15, "w": 0.7, "g": -0.2, "tau": 0.1}
    )
    truth = Material(
        layer,
        trends={
            "K_d": Trend("logistic", {"start": 0.3, "end": 0.6, "middle": 1.8, "width": 0.3}, (0, LAST)),
            "tau": Trend("linear", {"start": 0.1, "end": 0.5}, (0, LAST)),
        },
    )
    fit = fitted(series(truth.at, np.linspace(0, LAST, 10), channels=1, noise=0.01), DUSTY)
    assert kinds(fit) == {
        name: truth.trends[name].kind if name in truth.trends else "constant" for name in layer.parameters
    }
    assert fit.trends["K_d"].trend.coefficients["middle"] == pytest.approx(1.8, abs=0.05)
    assert_allclose(fit.trends["tau"].trend([0, LAST]), [0.1, 0.5], atol=0.03)


def test_a_folder_of_the_rig_is_fitted(tmp_path: Path) -> None:
    simulate(tmp_path / "s", TRUTH, scans=6, hours=LAST, seed=3, rig=Rig(step_deg=5.0))
    fit = fitted(motes.read(tmp_path / "s"))
    assert kinds(fit)["K_s"] == "exponential"
    assert_allclose(fit.hours, np.linspace(0, LAST, 6), atol=1e-3)
    assert_allclose(fit.trends["K_d"].trend(LAST), [0.6, 0.5, 0.45], rtol=0.02)


# ---------------------------------------------------------------- The minimum


def wild_joint() -> tuple[Joint, np.ndarray]:
    """Every nonlinear kind at once, away from the minimum."""
    problem = prepare(series(TRUTH.at), MODEL, Wishes("linear", "none", "measurement", (), ())).problem
    chosen = {"K_d": "logistic", "sigma_d": "cubic", "K_s": "exponential", "sigma_s": "monotone_spline"}
    parts = tuple(Part(q, chosen[q.name], (0.0, LAST)) for q in problem.quantities)
    c = [0.3, 0.2, 0.15, 0.6, 0.5, 0.4, 1.7, 0.6, 0.3, 0.25, 0.35, 0.3, 0.45, 0.12, 1.2, 0.14, 0.2, 0.3, 0.2, 0.6]
    return Joint(problem, TIMES, np.array([0, 1, 2, 4, 5, 7]), parts), np.array(c)


def stacked_residuals(joint: Joint, c: np.ndarray) -> np.ndarray:
    x, _ = joint.vectors(c)
    return np.concatenate([single(joint.problem, int(t)).residuals(x[k]).ravel() for k, t in enumerate(joint.scans)])


def test_gradient_and_matrix_against_finite_differences() -> None:
    joint, c = wild_joint()
    assert joint.size == len(c)
    at = joint.normal(c[None])
    columns = []
    for k in range(len(c)):
        step = np.eye(len(c))[k] * 1e-6
        columns.append((stacked_residuals(joint, c + step) - stacked_residuals(joint, c - step)) / 2e-6)
    jacobian, residual = np.stack(columns, axis=1), stacked_residuals(joint, c)
    assert_allclose(at.objective[0], 0.5 * residual @ residual, rtol=1e-12)
    scale = np.sqrt(np.diag(jacobian.T @ jacobian))
    assert_allclose(at.gradient[0] / scale, jacobian.T @ residual / scale, rtol=1e-5, atol=1e-8)
    assert_allclose(at.matrix[0] / np.outer(scale, scale), jacobian.T @ jacobian / np.outer(scale, scale), atol=1e-7)


def test_the_profile_is_the_quadratic_with_the_others_eliminated() -> None:
    """Its promised objective for a kind is what a joint quadratic step of all coefficients gives."""
    joint, c = wild_joint()
    joint = replace(joint, parts=tuple(replace(p, kind="linear") for p in joint.parts))
    c = np.array([0.31, 0.26, 0.2, 0.59, 0.49, 0.44, 0.3, 0.31, 0.45, 0.12, 0.15, 0.151])
    at = survey(joint, c)
    profile = Profile(joint, c, 0, at)
    normal = joint.normal(c[None])
    step = -np.linalg.solve(normal.matrix[0], normal.gradient[0])
    promised = normal.objective[0] + normal.gradient[0] @ step + 0.5 * step @ normal.matrix[0] @ step
    objective, found = profile.fitted("linear")
    assert objective == pytest.approx(promised, rel=1e-6)
    assert_allclose(found, (c + step)[:6], rtol=1e-4)
    assert profile.least <= objective


def test_the_minimum_is_that_of_scipy() -> None:
    """The same trends typed here, the appendices' formulas typed in the oracle, SciPy's minimiser started from the truth."""
    data, fit = series(TRUTH.at, UNEVEN, 0), painted(0)
    at, cosine = Formulas(WI, WO), WI[:, 2:3]

    def residuals(c: np.ndarray) -> np.ndarray:
        rows = []
        for t, values in zip(UNEVEN, data.values, strict=True):
            K_d = c[0:3] + (c[3:6] - c[0:3]) * t / LAST
            K_s = c[8] + (c[7] - c[8]) * np.exp(-t / c[9])
            rows.append((at.oren_nayar(K_d, c[6]) + at.torrance_sparrow(K_s, c[10]) - values) * cosine)
        return np.concatenate(rows).ravel()

    truth = np.array([0.3, 0.25, 0.2, 0.6, 0.5, 0.45, 0.3, 0.5, 0.1, 1.0, 0.15])
    found = least_squares(residuals, truth, x_scale=truth, xtol=1e-12, ftol=1e-12, gtol=1e-12)
    assert fit.metrics["objective"] <= 1.001 * found.cost
    assert fit.metrics["objective"] == pytest.approx(found.cost, rel=1e-6)
    K_s = fit.trends["K_s"].trend.coefficients
    assert_allclose([K_s["start"], K_s["end"], K_s["time_constant"]], found.x[7:10], rtol=1e-3)


def test_the_covariance_is_the_sandwich() -> None:
    """Against the sandwich from a dense Jacobian by finite differences."""
    fit = painted(0)
    problem = prepare(fit.measurement, MODEL, Wishes("linear", "none", "measurement", (), ())).problem
    parts = tuple(Part(q, TRUE_KINDS[q.name], (0.0, LAST)) for q in problem.quantities)
    joint = Joint(problem, UNEVEN, np.arange(8), parts)
    c = np.concatenate(
        [
            np.ravel(part.quantity.coordinate(v) if part.squared else v)
            for part in parts
            for v in fit.trends[part.quantity.name].trend.coefficients.values()
        ]
    )
    columns = []
    for k in range(len(c)):
        step = np.eye(len(c))[k] * 1e-6
        columns.append((stacked_residuals(joint, c + step) - stacked_residuals(joint, c - step)) / 2e-6)
    jacobian, residual = np.stack(columns, axis=1), stacked_residuals(joint, c)
    inverse = np.linalg.inv(jacobian.T @ jacobian)
    leverage = np.einsum("nk,kl,nl->n", jacobian, inverse, jacobian)
    middle = (jacobian * (residual**2 / (1 - leverage) ** 2)[:, None]).T @ jacobian
    assert_allclose(uncertainty(joint, c).steps, np.sqrt(np.diag(inverse @ middle @ inverse)), rtol=0.02)


# ---------------------------------------------------------------- Choosing


def test_bright_noise_does_not_make_trends() -> None:
    """A highlight is noisier than the rest: plain BIC takes its noise for change; with the inflation a constant stays one."""
    gloss = parse(MODEL).model.with_parameters({"K_d": 0.1, "sigma_d": 0.2, "K_s": 0.8, "sigma_s": 0.12})
    for seed in range(4):
        fit = fitted(series(lambda t: gloss, seed=seed, channels=1, noise=0.03))
        assert set(kinds(fit).values()) == {"constant"}


def test_settled_trends_are_taken() -> None:
    wanted = {"K_d": "logistic", "K_s": "monotone_spline", "sigma_d": "linear"}
    fit = fitted(series(TRUTH.at, seed=2), trends=wanted)
    assert kinds(fit) == {**wanted, "sigma_s": "constant"}
    assert [a.kind for a in fit.trends["K_d"].alternatives] == ["logistic"]
    assert len(fit.trends["sigma_s"].alternatives) > 1
    assert_allclose(fit.trends["K_d"].trend(LAST), [0.6, 0.5, 0.45], rtol=0.02)
    right = fitted(series(TRUTH.at, seed=2), trends={"K_s": "exponential"})
    assert right.trends["K_s"].trend.coefficients["time_constant"] == pytest.approx(1.0, abs=0.06)


def test_alternatives_are_sorted_and_the_chosen_is_first() -> None:
    for t in painted(0).trends.values():
        distances = [a.delta_bic for a in t.alternatives]
        assert t.alternatives[0].kind == t.trend.kind
        assert distances[0] == 0
        assert distances == sorted(distances)
        assert {a.kind for a in t.alternatives} == set(CANDIDATE_KINDS)


@pytest.mark.parametrize(
    ("kind", "scans", "enough"),
    [
        ("constant", 1, True),
        ("linear", 2, True),
        ("linear", 1, False),
        ("exponential", 3, False),
        ("exponential", 4, True),
        ("quadratic", 3, True),
        ("cubic", 3, False),
        ("logistic", 4, False),
        ("logistic", 5, True),
    ],
)
def test_how_many_scans_a_trend_needs(kind: str, scans: int, enough: bool) -> None:
    assert determined(kind, scans) is enough


def test_a_model_is_chosen() -> None:
    fit = fitted(series(TRUTH.at), "auto")
    assert fit.model_text == MODEL
    assert [t.model for t in fit.tried if t.chosen] == [MODEL]
    assert min(fit.tried, key=lambda t: t.bic).chosen


# ---------------------------------------------------------------- Bands


def test_bands_open_beyond_the_data() -> None:
    fit = painted(0)
    for name in ("K_d", "K_s", "sigma_d"):
        at = fit.trends[name].band([0.5 * LAST, LAST, 2 * LAST, 4 * LAST])[1]
        assert (at[2] > at[1]).all(), name
        assert (at[3] > at[2]).all(), name
    straight = fit.trends["K_d"].trend.stderr([LAST, 2 * LAST])
    assert (straight[1] > 1.5 * straight[0]).all()


@pytest.mark.parametrize("kind", ["linear", "quadratic", "cubic", "monotone_spline"])
def test_extrapolated_errors_grow_for_every_open_kind(kind: str) -> None:
    fit = fitted(series(TRUTH.at, seed=4), trends={"K_d": kind, "sigma_d": "constant", "sigma_s": "constant"})
    errors = fit.trends["K_d"].trend.stderr([LAST, 2 * LAST])
    assert (errors[1] > errors[0]).all()


def test_a_band_holds_the_kinds_that_the_data_allow() -> None:
    t = painted(0).trends["K_d"]
    value, error = t.band([3 * LAST])
    assert_allclose(value, t.trend([3 * LAST]).reshape(1, -1))
    weights = np.exp(-0.5 * np.array([a.delta_bic for a in t.alternatives]))
    spread = sum(
        w * (a.trend([3 * LAST]) - value) ** 2 for w, a in zip(weights / weights.sum(), t.alternatives, strict=True)
    )
    assert_allclose(error, np.sqrt(t.trend.stderr([3 * LAST]) ** 2 + spread), rtol=1e-9)


# ---------------------------------------------------------------- Bad, missing, few


@pytest.mark.parametrize(
    ("spoil", "reason"),
    [(lambda v: v * 1.3, "standard errors from the trends"), (lambda v: v[::-1], "noise is .* times the others'")],
    ids=["scaled", "swapped"],
)
def test_a_bad_scan_is_left_out(spoil: Callable[[np.ndarray], np.ndarray], reason: str) -> None:
    good = series(TRUTH.at)
    values = good.values.copy()
    values[3] = spoil(values[3])
    fit = fitted(measurement(values))
    assert [o.index for o in fit.outliers] == [3]
    assert fit.outliers[0].hours == TIMES[3]
    assert any(s.startswith("Scan 3 at 1.71 h was left out") for s in fit.findings)
    assert re.search(reason, fit.outliers[0].reason)
    assert kinds(fit) == TRUE_KINDS
    values[3] = np.nan
    without = fitted(measurement(values))
    for name, t in fit.trends.items():
        assert_allclose(t.trend(TIMES), without.trends[name].trend(TIMES), rtol=1e-4)
    assert fit.trends["K_d"].scan_values.shape == (8, 3)  # the bad scan's own values are there to see


def test_two_bad_scans_are_left_out() -> None:
    times = np.linspace(0, LAST, 12)
    values = series(TRUTH.at, times).values[:, :, :1].copy()  # one channel, for speed
    values[4] *= 1.3
    values[8] *= 0.8
    fit = fitted(measurement(values, times, ("R",)))
    assert [o.index for o in fit.outliers] == [4, 8]
    assert kinds(fit) == TRUE_KINDS


def test_good_scans_are_not_left_out() -> None:
    assert not any(painted(seed).outliers for seed in range(4))


def test_a_missing_scan_is_done_without() -> None:
    values = series(TRUTH.at).values.copy()
    values[2] = np.nan
    fit = fitted(measurement(values))
    assert "1 of 8 scans has no usable sample." in fit.findings
    assert kinds(fit) == TRUE_KINDS
    assert fit.trends["K_d"].scan_values.shape == (7, 3)
    assert fit.predicted.shape == (8, len(WI), 3)
    assert np.isfinite(fit.predicted).all()
    assert_allclose(fit.trends["K_d"].trend(TIMES[2]), TRUTH.trends["K_d"](TIMES[2]), rtol=0.01)


@pytest.mark.parametrize("scans", [2, 3])
def test_few_scans(scans: int) -> None:
    times = np.linspace(0, LAST, scans)
    fit = fitted(series(TRUTH.at, times))
    assert f"With {scans} scans the shape of a trend is a guess: they tell only whether it changes." in fit.findings
    assert set(kinds(fit).values()) <= {"constant", "linear", "quadratic"}
    assert kinds(fit)["sigma_d"] == "constant"
    assert kinds(fit)["K_d"] == "linear"
    for name, t in fit.trends.items():
        value, error = t.band(times)
        assert (np.abs(value - true_values(name, times)) < 4 * error).all(), name


def test_one_scan_is_a_plain_fit() -> None:
    assert isinstance(motes.fit(series(TRUTH.at, [0.0]), MODEL), Fit)


def test_one_usable_scan_is_refused() -> None:
    values = series(TRUTH.at, [0.0, 1.0]).values.copy()
    values[1] = np.nan
    with pytest.raises(DataError, match="1 of 2 scans has usable samples, and a trend needs two"):
        motes.fit(measurement(values, [0.0, 1.0]), MODEL)


@pytest.mark.parametrize("seed", range(3))
def test_no_highlight_is_said(seed: int) -> None:
    matte = parse("oren_nayar").model.with_parameters({"K_d": (0.5, 0.4, 0.3), "sigma_d": 0.3})
    fit = fitted(series(lambda t: matte, seed=seed))
    assert any(s.startswith("No highlight is seen: K_s is 0 within its errors") for s in fit.findings)
    assert fit.trends["sigma_s"].verdict == Verdict.UNIDENTIFIABLE
    assert fit.trends["K_s"].verdict in (Verdict.AT_LOWER, Verdict.WEAK, Verdict.UNIDENTIFIABLE)
    assert fit.trends["K_d"].verdict == Verdict.IDENTIFIED
    assert_allclose(fit.trends["K_d"].trend(1.0), (0.5, 0.4, 0.3), rtol=0.01)


def test_all_dust_is_said() -> None:
    buried = parse(DUSTY).model.with_parameters(
        {"K_d": 0.5, "sigma_d": 0.3, "K_s": 0.5, "sigma_s": 0.15, "w": (0.8, 0.7, 0.6), "g": 0.1, "tau": 10.0}
    )
    fit = fitted(series(lambda t: buried), DUSTY)
    (sentence,) = [s for s in fit.findings if s.startswith("The dust hides the surface at all times")]
    assert "K_d, sigma_d, K_s, sigma_s, tau" in sentence
    for name in ("K_d", "sigma_d", "K_s", "sigma_s", "tau"):
        assert fit.trends[name].verdict == Verdict.UNIDENTIFIABLE
    for name, truth in (("w", (0.8, 0.7, 0.6)), ("g", 0.1)):
        assert fit.trends[name].verdict == Verdict.IDENTIFIED
        assert_allclose(fit.trends[name].trend(1.0), truth, rtol=0.02)


def test_dust_that_lets_the_surface_through_is_not_said_to_hide_it() -> None:
    thin = parse(DUSTY).model.with_parameters(
        {"K_d": 0.5, "sigma_d": 0.3, "K_s": 0.5, "sigma_s": 0.15, "w": 0.7, "g": 0.1, "tau": 0.5}
    )
    assert isinstance(thin, DustLayer)
    fit = fitted(series(lambda t: thin, channels=1, noise=0.01), DUSTY)
    assert not any("hides" in s or "No highlight" in s for s in fit.findings)
    assert fit.trends["tau"].trend(1.0) == pytest.approx(0.5, abs=0.1)


# ---------------------------------------------------------------- Options


def test_held_parameters_and_per_channel() -> None:
    fit = fitted(series(TRUTH.at), fixed={"sigma_d": 0.3, "sigma_s": 0.15}, per_channel=["K_s"])
    assert list(fit.trends) == ["K_d", "K_s"]
    assert fit.material.at(2.0).parameters["sigma_d"] == 0.3
    assert fit.trends["K_s"].trend.kind == "exponential"
    assert fit.trends["K_s"].trend.channels == 3
    value, error = fit.trends["K_s"].band(TIMES)
    assert value.shape == (8, 3)
    assert (np.abs(value - true_values("K_s", TIMES)) < 4 * error).all()


def test_robust_loss_suffers_wild_samples() -> None:
    values = series(TRUTH.at).values.copy()
    wild = np.random.default_rng(3).random(values.shape) < 0.03
    values[wild] *= 3
    robust = fitted(measurement(values), robust="cauchy")
    plain = motes.fit(measurement(values), MODEL)

    def off(fit: TimeFit) -> float:
        return float(np.abs(fit.trends["K_d"].trend(TIMES) - true_values("K_d", TIMES)).mean())

    assert off(robust) < 0.005 < 2 * off(plain)
    assert off(robust) < 0.5 * off(plain)
    assert kinds(robust) == TRUE_KINDS


@pytest.mark.parametrize("loss", ["log", "cube_root"])
def test_other_losses(loss: str) -> None:
    fit = fitted(series(TRUTH.at), loss=loss)
    assert_allclose(fit.trends["K_d"].trend(TIMES), true_values("K_d", TIMES), rtol=0.01)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"trends": "linear"}, "trends 'linear' is not 'auto' or a mapping"),
        ({"trends": {"K_d": "parabola"}}, "trend 'parabola' of K_d is not one of"),
        ({"trends": {"tau": "linear"}}, "no parameter 'tau' is fitted, so it has no trend. Fitted are K_d"),
        ({"trends": {"K_d": "cubic"}}, "3 scans cannot determine a cubic trend of K_d"),
    ],
)
def test_bad_wishes_are_refused(options: dict[str, Any], message: str) -> None:
    with pytest.raises(MotesError, match=message):
        motes.fit(series(TRUTH.at, [0.0, 1.0, 2.0]), MODEL, **options)


def test_too_few_samples_are_refused() -> None:
    data = Measurement.from_arrays(WI[:2], WO[:2], np.full((3, 2, 1), 0.1), times=[0, 1, 2], channels=("grey",))
    with pytest.raises(DataError, match=r"2 usable sample.* cannot determine the 4 parameters of oren_nayar"):
        motes.fit(data, MODEL)


def test_progress_is_told() -> None:
    told: list[tuple[int, int, str]] = []
    motes.fit(series(TRUTH.at), MODEL, progress=lambda *a: told.append(a))
    assert all(0 <= done <= total for done, total, _ in told)
    assert "fitting 8 scans" in [what for _, _, what in told]


# ---------------------------------------------------------------- Scans alone


def test_scans_fitted_together_are_those_fitted_alone() -> None:
    data = series(TRUTH.at, UNEVEN, 0)
    together = painted(0)
    for k in (0, 4, 7):
        alone = motes.fit(data, MODEL, time=k)
        for name, parameter in alone.parameters.items():
            assert_allclose(together.trends[name].scan_values[k], parameter.value, rtol=1e-4)
            assert_allclose(together.trends[name].scan_stderr[k], parameter.stderr, rtol=1e-2)


def test_some_scans_of_the_fits() -> None:
    problem = prepare(series(TRUTH.at), MODEL, Wishes("linear", "none", "measurement", (), ())).problem
    fits = fit_scans(problem, np.array([0, 3, 5]))
    some = fits.select(np.array([0, 2]))
    assert_array_equal(some.x, fits.x[[0, 2]])
    assert_array_equal(some.normal.matrix, fits.normal.matrix[[0, 2]])
    assert [len(some.verdicts), len(some.status)] == [2, 2]


# ---------------------------------------------------------------- What is kept


def test_the_predicted_values_are_the_materials() -> None:
    fit = painted(0)
    assert_allclose(fit.predicted, fit.material.at(UNEVEN).eval(WI, WO), rtol=1e-12)
    assert fit.brdf == fit.material.at(0.0)
    assert fit.metrics["relative_rms"] == pytest.approx(0.02, rel=0.25)
    assert fit.metrics["n_samples"] == 8 * len(WI) * 3
    assert fit.metrics["n_coefficients"] == 11


def test_the_table_has_a_row_for_each_channel() -> None:
    rows = painted(0).table()
    assert [(r["name"], r["channel"], r["trend"]) for r in rows[:4]] == [
        ("K_d", "R", "linear"),
        ("K_d", "G", "linear"),
        ("K_d", "B", "linear"),
        ("sigma_d", "", "constant"),
    ]
    assert all("±" in r["first"] and "±" in r["last"] for r in rows)


def test_files(tmp_path: Path) -> None:
    values = series(TRUTH.at).values.copy()
    values[2] = np.nan
    fit = fitted(measurement(values))
    assert fit.save(tmp_path / "out") == tmp_path / "out"
    assert sorted(p.name for p in (tmp_path / "out").iterdir()) == ["fit.json", "material.json", "parameters.csv"]
    material = motes.load(tmp_path / "out" / "material.json")
    for t in (0.0, 2.2, 9.0):
        assert material.at(t) == fit.material.at(t)
    data = json.loads((tmp_path / "out" / "fit.json").read_text())
    assert data["format"] == "motes time fit"
    assert data["findings"] == list(fit.findings)
    assert data["trends"]["K_s"]["kind"] == "exponential"
    with (tmp_path / "out" / "parameters.csv").open(newline="") as handle:
        rows = list(csv.DictReader(handle))
    assert len(rows) == 8 * 6  # scans, and three channels of K_d and three more
    missing = [r for r in rows if r["hours"] == repr(float(TIMES[2]))]
    assert all(r["scan_value"] == "nan" for r in missing)
    first = next(r for r in rows if r["parameter"] == "K_s" and float(r["hours"]) == TIMES[3])
    assert float(first["scan_value"]) == fit.trends["K_s"].scan_values[2, 0]
    assert float(first["value"]) == pytest.approx(float(fit.trends["K_s"].trend(TIMES[3])), rel=1e-12)
