"""`motes.fit` as users call it: options, odd data, errors of one sentence, and what comes back."""

from __future__ import annotations

import json
import math
import os

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import motes
from fitting_oracle import Oracle, scattered
from motes.errors import DataError, MotesError, ParameterError
from motes.fitting import Status, Verdict
from motes.fitting.formatting import with_error
from motes.measurements import Measurement

ON, TS = "oren_nayar", "oren_nayar + torrance_sparrow"
GLOSSY = motes.OrenNayar(K_d=(0.6, 0.4, 0.25), sigma_d=0.4) + motes.TorranceSparrow(K_s=0.25, sigma_s=0.15)
WI, WO = scattered(150, 0)
F = GLOSSY.eval(WI, WO) * (1 + 0.02 * np.random.default_rng(0).standard_normal((150, 3)))


def data(values=F, wi=WI, wo=WO, **options) -> Measurement:
    return Measurement.from_arrays(wi, wo, values, **options)


def values_of(fit: motes.Fit) -> np.ndarray:
    return np.concatenate([np.atleast_1d(p.value) for p in fit.parameters.values()])


# ---------------------------------------------------------------- options


def test_fixed_by_name_mapping_and_text_are_the_same() -> None:
    in_text = motes.fit(data(), "oren_nayar(sigma_d=0.35) + torrance_sparrow")
    by_mapping = motes.fit(data(), TS, fixed={"sigma_d": 0.35})
    start = motes.OrenNayar(sigma_d=0.35) + motes.TorranceSparrow()
    by_name = motes.fit(data(), start, fixed=["sigma_d"])
    one_name = motes.fit(data(), start, fixed="sigma_d")
    for fit in (in_text, by_mapping, by_name, one_name):
        p = fit.parameters["sigma_d"]
        assert p.value == 0.35
        assert math.isnan(p.stderr)
        assert p.verdicts == (Verdict.FIXED,)
        assert p.verdict == Verdict.FIXED
        assert fit.labels == ("K_d[R]", "K_d[G]", "K_d[B]", "K_s", "sigma_s")
        np.testing.assert_allclose(values_of(fit), values_of(in_text), rtol=1e-4)
    oracle = Oracle(WI, WO, F, TS, held={"sigma_d": 0.35})
    assert in_text.metrics["objective"] <= 1.001 * oracle.best(5).cost


def test_a_color_can_be_held() -> None:
    fit = motes.fit(data(), TS, fixed={"K_d": [0.5, 0.4, 0.3]})
    assert fit.parameters["K_d"].value.tolist() == [0.5, 0.4, 0.3]
    assert fit.parameters["K_d"].verdicts == (Verdict.FIXED,) * 3
    assert fit.metrics["n_parameters"] == 3


def test_a_highlight_for_each_channel() -> None:
    metal = motes.OrenNayar(K_d=0.1, sigma_d=0.3) + motes.TorranceSparrow(K_s=(0.9, 0.7, 0.3), sigma_s=0.15)
    measured = data(metal.eval(WI, WO) * (1 + 0.01 * np.random.default_rng(1).standard_normal((150, 3))))
    shared, own = motes.fit(measured, TS), motes.fit(measured, TS, per_channel=["K_s"])
    np.testing.assert_allclose(own.parameters["K_s"].value, [0.9, 0.7, 0.3], rtol=0.02)
    assert own.parameters["K_s"].stderr.shape == (3,)
    assert np.ndim(shared.parameters["K_s"].value) == 0
    assert own.metrics["objective"] < 0.1 * shared.metrics["objective"]
    np.testing.assert_array_equal(
        motes.fit(measured, TS, per_channel="K_s").parameters["K_s"].value, own.parameters["K_s"].value
    )


def test_a_brdf_as_the_model_is_a_start() -> None:
    fit = motes.fit(data(), GLOSSY)
    assert fit.model_text == TS
    np.testing.assert_allclose(values_of(fit), values_of(motes.fit(data(), TS)), rtol=1e-4)
    # of other channels: its mean is the start
    grey = motes.fit(data(F[:, :1]), GLOSSY)
    assert np.ndim(grey.parameters["K_d"].value) == 0
    assert grey.parameters["K_d"].value == pytest.approx(0.6, rel=0.02)


def test_the_start_that_was_given_is_tried() -> None:
    """A highlight of 0.006 rad that three samples see: the grid begins at 0.02, the user knows better."""
    truth = motes.Lambert(K_d=0.3) + motes.TorranceSparrow(K_s=3.0, sigma_s=0.006)
    wi, wo = scattered(60, 2)
    near = wi[:12] * [-1, -1, 1]
    wo[:12] = near + 0.004 * np.random.default_rng(3).standard_normal((12, 3))
    wo /= np.linalg.norm(wo, axis=1, keepdims=True)
    fit = motes.fit(data(truth.eval(wi, wo), wi, wo), truth)
    assert fit.parameters["sigma_s"].value == pytest.approx(0.006, rel=1e-3)


def test_weights() -> None:
    rng = np.random.default_rng(4)
    odd = F.copy()
    odd[::3] *= 1.5
    weights = rng.uniform(0.5, 2, 150)
    measured = data(odd, weights=weights)
    as_measured, given_, uniform = (motes.fit(measured, TS, weights=w) for w in ("measurement", weights, "uniform"))
    np.testing.assert_array_equal(values_of(as_measured), values_of(given_))
    np.testing.assert_array_equal(values_of(as_measured), values_of(motes.fit(measured, TS, weights=list(weights))))
    assert np.abs(values_of(uniform) / values_of(as_measured) - 1).max() > 1e-3
    # only ratios mean anything
    np.testing.assert_allclose(values_of(motes.fit(measured, TS, weights=7e5 * weights)), values_of(given_), rtol=1e-6)
    # 0 leaves a sample out; a column for each channel
    drop = np.ones((150, 3))
    drop[::3] = 0
    kept = motes.fit(measured, TS, weights=drop)
    masked = motes.fit(data(odd, mask=drop[None] > 0), TS)
    np.testing.assert_allclose(values_of(kept), values_of(masked), rtol=1e-9)
    assert kept.metrics["n_samples"] == 300
    each = Oracle(WI, WO, odd, TS, weights=np.repeat(weights[:, None] / weights.mean(), 3, axis=1))
    assert given_.metrics["objective"] == pytest.approx(0.5 * np.sum(each.residuals(values_of(given_)) ** 2), rel=1e-9)


def test_max_theta_leaves_grazing_samples_out() -> None:
    fit = motes.fit(data(), TS, max_theta=1.0)
    within = (np.arccos(WI[:, 2]) <= 1.0) & (np.arccos(WO[:, 2]) <= 1.0)
    assert fit.metrics["n_samples"] == 3 * within.sum()
    assert dict(fit.measurement.masked) == {"theta beyond 57.3 degrees": int(3 * (~within).sum())}
    by_hand = motes.fit(data(F[within], WI[within], WO[within]), TS)
    np.testing.assert_allclose(values_of(fit), values_of(by_hand), rtol=1e-6)
    np.testing.assert_allclose(fit.predicted, fit.brdf.eval(WI, WO), rtol=1e-9)  # also where nothing was used


def test_one_time_of_several() -> None:
    series = data(np.stack([F, 0.5 * F]), times=[0.0, 1.0])
    one = motes.fit(series, TS, time=1)
    np.testing.assert_allclose(values_of(one), values_of(motes.fit(data(0.5 * F), TS)), rtol=1e-9)
    with pytest.raises(DataError, match=r"time 2 is outside 0\.\.1"):
        motes.fit(series, TS, time=2)


def test_progress_is_told() -> None:
    said = []
    motes.fit(data(), "auto", progress=lambda *args: said.append(args))
    assert [done for done, _, _ in said] == sorted(done for done, _, _ in said)
    assert said[-1][0] == said[-1][1]
    assert [what for _, _, what in said[:2]] == ["lambert", ON]


def test_the_same_fit_twice_is_the_same_to_the_last_bit() -> None:
    for model in (TS, "auto"):
        a, b = motes.fit(data(), model), motes.fit(data(), model)
        assert values_of(a).tobytes() == values_of(b).tobytes()
        assert a.correlations.tobytes() == b.correlations.tobytes()


def test_units_do_not_matter() -> None:
    """Data a thousand times as bright: the amplitudes follow. (Oren-Nayar is not linear in K_d, Lambert is.)"""
    truth = motes.Lambert(K_d=0.5) + motes.TorranceSparrow(K_s=0.3, sigma_s=0.2)
    noisy = truth.eval(WI, WO) * (1 + 0.01 * np.random.default_rng(1).standard_normal((150, 1)))
    base = motes.fit(data(noisy), "lambert + torrance_sparrow")
    for factor in (1e-6, 1e3, 1e7):
        fit = motes.fit(data(factor * noisy), "lambert + torrance_sparrow")
        assert fit.status.ok
        np.testing.assert_allclose(values_of(fit), values_of(base) * [factor, factor, 1], rtol=1e-4)
        assert fit.metrics["relative_rms"] == pytest.approx(base.metrics["relative_rms"], rel=1e-4)


# ---------------------------------------------------------------- odd data


def test_nan_and_masked_samples_count_for_nothing() -> None:
    spoiled = F.copy()
    spoiled[::7, 1] = np.nan
    spoiled[3::11, 0] = -1
    spoiled[5::13, 2] = np.inf
    fit = motes.fit(data(spoiled), TS)
    good = np.isfinite(spoiled) & (spoiled >= 0)
    assert fit.metrics["n_samples"] == good.sum()
    clean = motes.fit(data(np.where(good, F, 9.0), mask=good[None]), TS)
    np.testing.assert_allclose(values_of(fit), values_of(clean), rtol=1e-9)
    assert np.array_equal(np.isnan(fit.residuals), ~good)
    assert sum(fit.measurement.masked.values()) == (~good).sum()


def test_directions_below_the_horizon_are_masked_and_predicted_as_0() -> None:
    wi = WI.copy()
    wi[::10, 2] *= -1
    fit = motes.fit(data(F, wi), TS)
    assert np.all(fit.predicted[::10] == 0)
    assert np.all(np.isfinite(fit.predicted))
    assert fit.metrics["n_samples"] == 3 * 135


@settings(max_examples=40)
@given(seed=st.integers(0, 2**32 - 1), share=st.floats(0, 1), n=st.integers(1, 25))
def test_any_mask_gives_a_fit_or_an_error_of_ours(seed: int, share: float, n: int) -> None:
    rng = np.random.default_rng(seed)
    values = F[:n] * np.where(rng.uniform(size=(n, 3)) < 0.1, rng.choice([0.0, np.nan, -1, 1e12]), 1)
    mask = rng.uniform(size=(1, n, 3)) < share
    model = ("auto", "lambert", ON, TS, "dust")[seed % 5]
    error = None
    try:
        fit = motes.fit(data(values, WI[:n], WO[:n], mask=mask), model)
    except MotesError as caught:
        error = caught
    if error is not None:
        assert error.message
        assert "\n" not in str(error)
        return
    assert np.all(np.isfinite(values_of(fit)))
    assert np.all(np.isfinite(fit.predicted))
    json.dumps(fit.to_dict(), allow_nan=False)


ERRORS = {
    "one sample": (lambda: motes.fit(data(F[:1], WI[:1], WO[:1]), ON), DataError, "3 usable sample.* 4 parameters"),
    "one for auto": (lambda: motes.fit(data(F[:1, :1], WI[:1], WO[:1])), DataError, "the 1 parameters of lambert"),
    "all masked": (lambda: motes.fit(data(-F), ON), DataError, "no sample of 450 is left to fit: 450 negative"),
    "all 0": (lambda: motes.fit(data(0 * F), ON), DataError, "all 450 usable samples are 0"),
    "no measurement": (lambda: motes.fit(F, ON), DataError, "a ndarray cannot be fitted"),
    "a number as model": (lambda: motes.fit(data(), 3), DataError, "a model of type int"),
    "a class as model": (lambda: motes.fit(data(), motes.OrenNayar), DataError, "cannot be fitted"),
    "no such model": (lambda: motes.fit(data(), "phong"), ParameterError, "'phong' is not a model"),
    "empty model": (lambda: motes.fit(data(), ""), ParameterError, "is not a sum of models"),
    "no such loss": (lambda: motes.fit(data(), ON, loss="l2"), MotesError, "loss 'l2' is not one of linear"),
    "loss of a wrong type": (lambda: motes.fit(data(), ON, loss=["log"]), MotesError, "is not one of"),
    "no such robust": (lambda: motes.fit(data(), ON, robust="tukey"), MotesError, "robust 'tukey' is not one of"),
    "no such weights": (lambda: motes.fit(data(), ON, weights="solid"), MotesError, "weights 'solid' is not"),
    "weights too few": (lambda: motes.fit(data(), ON, weights=np.ones(3)), DataError, r"weights of shape \(3,\)"),
    "weights of text": (lambda: motes.fit(data(), ON, weights=["a"] * 150), DataError, "weights are not numbers"),
    "weights ragged": (lambda: motes.fit(data(), ON, weights=[[1], [1, 2]]), DataError, "weights are not numbers"),
    "weights negative": (lambda: motes.fit(data(), ON, weights=-np.ones(150)), DataError, "negative or non-finite"),
    "weights 0": (lambda: motes.fit(data(), ON, weights=np.zeros(150)), DataError, "no sample of 450 is left"),
    "fixed unknown": (lambda: motes.fit(data(), ON, fixed=["K_s"]), MotesError, "oren_nayar has no parameter 'K_s'"),
    "fixed unknown to auto": (lambda: motes.fit(data(), fixed={"sgma_d": 1}), MotesError, "no model that auto tries"),
    "per channel unknown": (lambda: motes.fit(data(), ON, per_channel="x"), MotesError, "has no parameter 'x'"),
    "all fixed": (lambda: motes.fit(data(), ON, fixed=["K_d", "sigma_d"]), MotesError, "nothing to fit"),
    "fixed out of range": (lambda: motes.fit(data(), ON, fixed={"sigma_d": 20}), ParameterError, "sigma_d = 20 is out"),
    "fixed of 2 channels": (lambda: motes.fit(data(), ON, fixed={"K_d": [1, 2]}), DataError, r"shape \(2,\) does not"),
    "degrees": (lambda: motes.fit(data(), ON, max_theta=80), DataError, "80 degrees is 1.396 rad"),
    "nothing within": (lambda: motes.fit(data(), ON, max_theta=1e-9), DataError, "no sample of 450 is left"),
    "no such time": (lambda: motes.fit(data(), ON, time=1), DataError, "time 1 is outside"),
}


@pytest.mark.parametrize("case", ERRORS)
def test_errors_are_one_sentence(case: str) -> None:
    action, kind, text = ERRORS[case]
    with pytest.raises(kind, match=text) as caught:
        action()
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 400


# ---------------------------------------------------------------- what comes back


@pytest.fixture(scope="module")
def fitted() -> motes.Fit:
    return motes.fit(data(channels=("R", "G", "B"), provenance={"name": "test card", "format": "none"}))


def test_a_fit_says_what_it_is(fitted: motes.Fit) -> None:
    assert fitted.status in (Status.CONVERGED, Status.SMALL_STEP, Status.IDLE)
    assert fitted.model_text == TS
    np.testing.assert_allclose(fitted.predicted, fitted.brdf.eval(WI, WO), rtol=1e-10)
    np.testing.assert_allclose(fitted.residuals, fitted.predicted - F, rtol=1e-12)
    assert fitted.material.name == "test card"
    assert fitted.correlations.shape == (6, 6)
    assert fitted.n_starts >= 1
    for name in ("relative_rms", "rms_plain", "rms_linear", "rms_log", "rms_cube_root", "objective", "bic"):
        assert math.isfinite(fitted.metrics[name])
    mu = WI[:, 2:3]
    expected = {
        "rms_plain": fitted.predicted - F,
        "rms_linear": (fitted.predicted - F) * mu,
        "rms_log": np.log1p(fitted.predicted * mu) - np.log1p(F * mu),
        "rms_cube_root": np.cbrt(fitted.predicted * mu) - np.cbrt(F * mu),
    }
    for name, difference in expected.items():
        assert fitted.metrics[name] == pytest.approx(np.sqrt(np.mean(difference**2)), rel=1e-9)


def test_table(fitted: motes.Fit) -> None:
    rows = fitted.table()
    assert [(row["name"], row["channel"]) for row in rows] == [
        *(("K_d", "R"), ("K_d", "G"), ("K_d", "B")),
        *(("sigma_d", ""), ("K_s", ""), ("sigma_s", "")),
    ]
    for row in rows:
        p = fitted.parameters[row["name"]]
        index = "RGB".index(row["channel"]) if row["channel"] else 0
        value, stderr = np.atleast_1d(p.value)[index], np.atleast_1d(p.stderr)[index]
        assert abs(float(row["value"]) - value) <= 0.06 * stderr
        assert float(row["stderr"]) == pytest.approx(stderr, rel=0.06)
        assert row["verdict"] == "identified"
        assert row["unit"] == ("rad" if "sigma" in row["name"] else "")


def test_to_dict_is_json_without_nan(fitted: motes.Fit) -> None:
    for fit in (fitted, motes.fit(data(), TS, fixed={"sigma_d": 0.4}), motes.fit(data(F[:, :1] * 0 + 0.2), TS)):
        text = json.dumps(fit.to_dict(), allow_nan=False)
        back = json.loads(text)
        assert back["model"] == fit.model_text
        assert back["metrics"]["n_samples"] == fit.metrics["n_samples"]
        assert set(back["parameters"]) == set(fit.parameters)
        for name, p in fit.parameters.items():
            np.testing.assert_allclose(back["parameters"][name]["value"], p.value, rtol=1e-15)
    held = motes.fit(data(), TS, fixed={"sigma_d": 0.4}).to_dict()
    assert held["parameters"]["sigma_d"]["stderr"] is None


def test_saved_files_hold_the_same_material(fitted: motes.Fit, tmp_path) -> None:
    folder = fitted.save(tmp_path / "new" / "out")
    assert sorted(f.name for f in folder.iterdir()) == ["fit.json", "material.json", "parameters.csv"]
    material = motes.load(folder / "material.json")
    assert material.brdf == fitted.brdf
    assert material.channels == ("R", "G", "B")
    assert np.array_equal(material.brdf.eval(WI, WO), fitted.brdf.eval(WI, WO))
    assert json.loads((folder / "fit.json").read_text())["model"] == TS
    lines = (folder / "parameters.csv").read_text().splitlines()
    assert lines[0] == "parameter,channel,value,stderr,unit,verdict,source"
    assert float(lines[1].split(",")[2]) == fitted.parameters["K_d"].value[0]
    assert len(lines) == 7
    fitted.save(folder)  # over the old ones


@pytest.mark.parametrize("call", ["replace", "open"])
def test_a_full_disk_leaves_nothing_half_written(call: str, fitted: motes.Fit, tmp_path, monkeypatch) -> None:
    real = getattr(os, call)

    def full(path, *args, **kwargs):
        if call == "open" and not (args and args[0] & os.O_CREAT):  # what is there can be read and removed
            return real(path, *args, **kwargs)
        raise OSError(28, os.strerror(28))

    monkeypatch.setattr(os, call, full)
    with pytest.raises(MotesError, match="No space left on device"):
        fitted.save(tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_a_file_where_the_folder_should_be(fitted: motes.Fit, tmp_path) -> None:
    (tmp_path / "out").write_text("I was here")
    with pytest.raises(MotesError, match="cannot be written"):
        fitted.save(tmp_path / "out")
    assert (tmp_path / "out").read_text() == "I was here"


@pytest.mark.parametrize(
    ("value", "stderr", "expected"),
    [
        (0.84839, 0.00374, ("0.8484", "0.0037")),
        (0.5, 0.123, ("0.50", "0.12")),
        (66.09, 8.0, ("66.1", "8.0")),
        (4655.1, 312.0, ("4655", "312")),
        (0.3, math.nan, ("0.3", "")),
        (0.0, 0.0, ("0", "")),
        (1.23456789e-7, 1e-12, ("1.23457e-07", "1e-12")),
        (5e8, 1.2e6, ("5e+08", "1.2e+06")),
        (-0.31, 0.02, ("-0.310", "0.020")),
    ],
)
def test_digits_follow_the_error(value: float, stderr: float, expected: tuple[str, str]) -> None:
    assert with_error(value, stderr) == expected


# ---------------------------------------------------------------- a MERL table from a known material


def test_a_merl_table_gives_back_its_material(tmp_path) -> None:
    """A small table in the MERL layout (30 x 30 x 60), filled bin by bin: read, weighted by solid angle, fitted."""
    n = 30
    theta_h, theta_d, phi_d = np.meshgrid(
        ((np.arange(n) + 0.5) / n) ** 2 * np.pi / 2,
        (np.arange(n) + 0.5) / n * np.pi / 2,
        (np.arange(2 * n) + 0.5) / (2 * n) * np.pi,
        indexing="ij",
    )
    # d about the half vector, then the half vector tilted by theta_h about y: the format's definition, by hand.
    d = np.stack([np.sin(theta_d) * np.cos(phi_d), np.sin(theta_d) * np.sin(phi_d), np.cos(theta_d)], axis=-1)

    def tilted(v):
        c, s = np.cos(theta_h), np.sin(theta_h)
        return np.stack([c * v[..., 0] + s * v[..., 2], v[..., 1], -s * v[..., 0] + c * v[..., 2]], axis=-1)

    wi, wo = tilted(d), tilted(d * [-1, -1, 1])
    f = GLOSSY.eval(wi, wo)
    above = (wi[..., 2] > 0) & (wo[..., 2] > 0)
    stored = np.where(above[..., None], f * 1500 / np.array([1, 1.15, 1.66]), -1)
    path = tmp_path / "card.binary"
    with path.open("wb") as file:
        np.array([n, n, 2 * n], "<i4").tofile(file)
        np.moveaxis(stored, -1, 0).astype("<f8").tofile(file)
    measured = motes.read(path)
    assert np.ptp(measured.weights) > 0
    fit = motes.fit(measured, TS)
    assert fit.status.ok
    for name, truth in GLOSSY.parameters.items():
        np.testing.assert_allclose(fit.parameters[name].value, truth, rtol=1e-5)
