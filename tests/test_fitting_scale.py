"""Data whose scale nobody knows: it is a parameter of its own, and the material does not depend on it."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from motes import Lambert, Measurement, OrenNayar, TorranceSparrow, fit
from motes.directions import from_spherical
from motes.errors import DataError
from motes.fitting import Verdict
from motes.fitting.result import Fit
from motes.fitting.scaled import Scaled
from motes.fitting.time_result import TimeFit
from motes.models import BRDF

Run = Callable[..., tuple[int, str, str]]
MODEL = "oren_nayar + torrance_sparrow"
ROCK = OrenNayar(K_d=(0.6, 0.5, 0.4), sigma_d=0.3) + TorranceSparrow(K_s=0.2, sigma_s=0.15)


def directions(n: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(seed)
    wi, wo = (from_spherical(random.uniform(0, 1.3, n), random.uniform(0, 6.28, n)) for _ in range(2))
    return wi, wo


def measured(scale: float, noise: float, seed: int = 1, brdf: BRDF = ROCK, n: int = 300) -> Measurement:
    wi, wo = directions(n, seed)
    values = brdf.eval(wi, wo)
    random = np.random.default_rng(100 + seed)
    return Measurement.from_arrays(wi, wo, scale * values * (1 + noise * random.standard_normal(values.shape)))


def fitted(data: Measurement, **options: object) -> Fit:
    found = fit(data, MODEL, **options)  # type: ignore[arg-type]
    assert isinstance(found, Fit)
    return found


def test_a_wrong_scale_is_a_wrong_roughness_and_a_fitted_one_is_not() -> None:
    wrong = fitted(measured(3, 0.005)).parameters["sigma_d"]
    assert abs(wrong.value - 0.3) > 20 * wrong.stderr  # what happens without
    right = fitted(measured(3, 0.005), scale="fit").parameters
    assert abs(right["sigma_d"].value - 0.3) < 3 * right["sigma_d"].stderr < 0.01
    assert abs(right["scale"].value - 3) < 3 * right["scale"].stderr < 1
    assert np.all(np.abs(right["K_d"].value - [0.6, 0.5, 0.4]) < 3 * right["K_d"].stderr)


@pytest.mark.parametrize("scale", [1e-6, 0.1, 7.0, 1e5])
def test_the_material_does_not_depend_on_the_scale(scale: float) -> None:
    one, other = (fitted(measured(s, 0.005), scale="fit") for s in (1.0, scale))
    for name, parameter in one.parameters.items():
        factor = scale if name == "scale" else 1.0
        np.testing.assert_allclose(other.parameters[name].value, factor * np.asarray(parameter.value), rtol=1e-6)
        np.testing.assert_allclose(other.parameters[name].stderr, factor * np.asarray(parameter.stderr), rtol=1e-4)
    np.testing.assert_allclose(other.measurement.values, one.measurement.values, rtol=1e-6)
    np.testing.assert_allclose(other.predicted, other.brdf.eval(other.measurement.wi, other.measurement.wo), rtol=1e-9)
    assert np.isclose(other.metrics["relative_rms"], one.metrics["relative_rms"], rtol=1e-6)
    np.testing.assert_allclose(np.sqrt(np.diag(other.covariance))[-1], other.parameters["scale"].stderr, rtol=1e-6)


def test_errors_hold_what_is_not_known_of_the_scale() -> None:
    """Over repeats, the distances from the truth are as large as the errors say."""
    distances: dict[str, list[float]] = {"sigma_d": [], "scale": [], "K_s": []}
    for seed in range(12):
        found = fitted(measured(2.0, 0.004, seed), scale="fit").parameters
        for name, truth in (("sigma_d", 0.3), ("scale", 2.0), ("K_s", 0.2)):
            distances[name].append((found[name].value - truth) / found[name].stderr)
    for name, several in distances.items():
        assert 0.4 < np.sqrt(np.mean(np.square(several))) < 1.8, name


def test_a_scale_that_is_known_divides_the_data() -> None:
    data = measured(3.0, 0.01)
    uncertain = data.with_uncertainties(relative=0.01)
    by_hand = Measurement.from_arrays(data.wi, data.wo, data.values / 3.0).with_uncertainties(relative=0.01)
    held, direct = fitted(uncertain, scale=3.0), fitted(by_hand)
    for name, parameter in direct.parameters.items():
        np.testing.assert_allclose(held.parameters[name].value, parameter.value, rtol=1e-9)
        np.testing.assert_allclose(held.parameters[name].stderr, parameter.stderr, rtol=1e-7)
    assert held.measurement.provenance["scale"] == 3.0
    assert "scale" not in held.parameters
    assert np.isclose(held.metrics["reduced_chi_square"], direct.metrics["reduced_chi_square"])


def test_where_nothing_tells_the_scale_it_is_said() -> None:
    data = measured(3.0, 0.01, brdf=Lambert((0.6, 0.5, 0.4)))
    found = fit(data, "lambert", scale="fit")
    assert isinstance(found, Fit)
    assert found.parameters["scale"].verdict is found.parameters["K_d"].verdict is Verdict.UNIDENTIFIABLE
    assert any("do not tell their scale" in finding for finding in found.findings)
    assert (np.asarray(found.parameters["K_d"].value) <= 1).all()


def test_no_facet_returns_more_than_it_receives() -> None:
    found = fitted(measured(1.0, 0.01, brdf=OrenNayar(K_d=(1.0, 0.9, 0.8), sigma_d=0.4)), scale="fit")
    assert np.max(found.parameters["K_d"].value) <= 1
    assert found.parameters["K_d"].bounds == (0, 1)
    assert fitted(measured(1.0, 0.01)).parameters["K_d"].bounds[1] == np.inf


def test_a_colour_above_1_names_the_option() -> None:
    assert any("--scale fit" in finding for finding in fitted(measured(3.0, 0.01)).findings)
    for options in ({"scale": 3.0}, {"scale": "fit"}):
        assert not fitted(measured(3.0, 0.01), **options).findings


def test_one_scale_for_all_times() -> None:
    wi, wo = directions(250, 3)
    hours = np.arange(5.0)
    random = np.random.default_rng(5)
    values = np.stack([ROCK.with_parameters({"K_d": np.array([0.4, 0.3, 0.2]) + 0.05 * h}).eval(wi, wo) for h in hours])
    data = Measurement.from_arrays(wi, wo, 3 * values * (1 + 0.003 * random.standard_normal(values.shape)), times=hours)
    found, wrong = (fit(data, MODEL, scale=s, trends={"K_d": "linear"}) for s in ("fit", 1.0))
    assert isinstance(found, TimeFit)
    assert isinstance(wrong, TimeFit)
    scale, error = (found.measurement.provenance[name] for name in ("scale", "scale_stderr"))
    assert abs(scale - 3) < 3 * error < 1.5
    assert found.measurement.common_uncertainty == pytest.approx(error / scale)
    (value,), (stderr,) = (x.ravel()[:1] for x in found.trends["sigma_d"].band([2.0]))
    assert abs(value - 0.3) < 0.01
    assert abs(value - 0.3) < 4 * stderr
    assert abs(float(wrong.trends["sigma_d"].trend(2.0)) - 0.3) > 0.03
    K_d, K_d_error = found.trends["K_d"].band([2.0])
    assert np.all(np.abs(K_d - [0.5, 0.4, 0.3]) < 3 * K_d_error)
    grey = Measurement.from_arrays(
        wi, wo, 3 * np.stack([Lambert(0.2 + 0.1 * h).eval(wi, wo) for h in hours]), times=hours
    )
    with pytest.raises(DataError, match="no scan tells the scale"):
        fit(grey, "lambert", scale="fit")


@pytest.mark.parametrize("scale", [0.0, -1.0, np.nan, np.inf, 1e300, "free"])
def test_scales_that_are_none(scale: float | str) -> None:
    with pytest.raises(DataError, match="scale"):
        fit(measured(1.0, 0.01), MODEL, scale=scale)


def test_data_without_light_tell_no_scale() -> None:
    wi, wo = directions(50, 1)
    with pytest.raises(DataError, match="tells no scale"):
        fit(Measurement.from_arrays(wi, wo, np.zeros(50)), MODEL, scale="fit")


def test_rescaling_adds_up() -> None:
    data = measured(6.0, 0.01).with_uncertainties(relative=0.02)
    twice = data.rescaled(2.0).rescaled(3.0, stderr=0.1)
    np.testing.assert_allclose(twice.values, data.values / 6)
    assert data.uncertainties is not None
    assert twice.uncertainties is not None
    np.testing.assert_allclose(twice.uncertainties, data.uncertainties / 6)
    assert (twice.provenance["scale"], twice.provenance["scale_stderr"]) == (6.0, pytest.approx(0.2))
    np.testing.assert_array_equal(twice.mask, data.mask)


def test_what_an_instrument_reads_is_the_base_times_the_scale() -> None:
    wi, wo = directions(20, 1)
    seen = Scaled(ROCK, 2.5)
    np.testing.assert_allclose(seen.eval(wi, wo), 2.5 * ROCK.eval(wi, wo), rtol=1e-14)
    np.testing.assert_allclose(seen.pdf(wi, wo), ROCK.pdf(wi, wo), rtol=1e-14)
    assert seen.reciprocal


def test_the_command_says_the_scale_everywhere(motes: Run) -> None:
    data = measured(3.0, 0.005)
    names = ("wi_x", "wi_y", "wi_z", "wo_x", "wo_y", "wo_z", "R", "G", "B")
    table = np.concatenate([data.wi, data.wo, data.values[0]], axis=1)
    np.savetxt("t.csv", table, delimiter=",", header=",".join(names), comments="", fmt="%.9g")
    status, out, err = motes("fit", "t.csv", "-m", MODEL, "--scale", "fit", "-o", "fit")
    assert (status, err) == (0, "")
    assert "which was fitted" in out
    written = json.loads(Path("fit/fit.json").read_text())
    scale = written["parameters"]["scale"]["value"]
    assert written["measurement"]["scale"] == pytest.approx(scale)
    assert "scale" not in json.loads(Path("fit/material.json").read_text())["model"]
    assert f"divided by {scale:.4g}" in Path("fit/report.html").read_text()
    assert "scale," in Path("fit/parameters.csv").read_text()
    assert motes("view", "fit", "--json")[0] == 0  # shows the data over the material, in its units
    status, out, _ = motes("fit", "t.csv", "-m", MODEL, "--scale", "3", "-o", "held")
    assert "divided by 3\n" in out
    for wrong in ("three", "0", "nan"):
        assert motes("fit", "t.csv", "--scale", wrong)[0] == 2
    assert motes("simulate", "m.zarr", "--size", "4", "--scans", "1")[0] == 0
    assert "--scale" in motes("fit", "m.zarr", "--scale", "fit")[2]
