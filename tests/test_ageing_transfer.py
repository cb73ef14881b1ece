"""Transfer: a source carried onto itself is itself; onto others by the rules that are stated."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import motes
from motes.ageing import PHENOMENA, age
from motes.errors import ParameterError
from motes.material import Material, load
from motes.trends import KINDS, Tabulated, Trend

TIMES = np.array([-3.0, 0.0, 2.0, 7.0, 12.0, 20.0])
EACH = pytest.mark.parametrize("name", PHENOMENA)
GIVEN = pytest.mark.parametrize("given", ["start", "end"])
TARGET = motes.OrenNayar(K_d=(0.2, 0.4, 0.6), sigma_d=0.5) + motes.TorranceSparrow(K_s=0.25, sigma_s=0.2)
VALUES = {
    "value": 0.3,
    "start": 0.2,
    "end": 0.5,
    "c0": 0.2,
    "c1": 0.4,
    "c2": 0.3,
    "c3": 0.5,
    "time_constant": 3.0,
    "middle": 5.0,
    "width": 1.0,
}


def of_kind(kind: str) -> Trend:
    c = {c.name: VALUES.get(c.name, 0.4) for c in KINDS[kind].coefficients}
    return Trend(
        kind, {k: np.array([v, 0.5 * v, 0.8 * v]) if KINDS_VALUE(kind, k) else v for k, v in c.items()}, (0.0, 12.0)
    )


def KINDS_VALUE(kind: str, name: str) -> bool:
    return next(c for c in KINDS[kind].coefficients if c.name == name).bounds is None


@EACH
@GIVEN
def test_a_source_carried_onto_itself_is_itself(name: str, given: str, tmp_path: Path) -> None:
    source = PHENOMENA[name].example(12.0)
    again = load(age(source, name, source=source, given=given).save(tmp_path / "m.json"))
    for t in TIMES:
        for key, value in source.at(t).parameters.items():
            np.testing.assert_allclose(again.at(t).parameters[key], value, rtol=1e-12, atol=1e-14)


@pytest.mark.parametrize("kind", [k for k in KINDS if k != "constant"])
@GIVEN
def test_every_kind_of_trend_is_carried(kind: str, given: str) -> None:
    source = Material(motes.Lambert((0.2, 0.1, 0.16)), channels=("R", "G", "B"), trends={"K_d": of_kind(kind)})
    target = motes.Lambert((0.3, 0.6, 0.1))
    aged = age(target, "drying_surface", source=source, hours=(1, 4), given=given)
    moment = {"start": 0.0, "end": 12.0}[given]
    reference = source.at(moment).parameters["K_d"]
    for u in np.linspace(0, 1, 9):
        expected = np.array([0.3, 0.6, 0.1]) * source.at(12 * u).parameters["K_d"] / reference
        np.testing.assert_allclose(aged.at(1 + 3 * u).parameters["K_d"], expected, rtol=1e-12)


@EACH
@GIVEN
def test_the_target_is_itself_at_the_moment_given(name: str, given: str) -> None:
    source = PHENOMENA[name].example(12.0)
    aged = age(TARGET, name, source=source, hours=(1, 5), given=given)
    now = aged.at({"start": 1.0, "end": 5.0}[given]).parameters
    for key, value in TARGET.parameters.items():
        if (name, given, key) == ("rusting", "end", "sigma_s"):  # 0.2 rad cannot have been 0.207 rad less
            continue
        np.testing.assert_allclose(now[key], value, rtol=1e-9, atol=1e-12, err_msg=key)
    assert aged.at(3.0).parameters["sigma_d"] == 0.5
    assert all(np.all(np.isnan(t.stderr(2.0))) for t in aged.trends.values() if isinstance(t, Trend))


def test_ratios_and_differences() -> None:
    source = PHENOMENA["drying_paint"].example(12.0)
    start, end = age(TARGET, "drying_paint", source=source, given="start"), age(TARGET, "drying_paint", source=source)
    a, b = source.at(0.0).parameters, source.at(12.0).parameters
    for t in TIMES:
        s = source.at(t).parameters
        np.testing.assert_allclose(start.at(t).parameters["K_s"], 0.25 * s["K_s"] / a["K_s"], rtol=1e-12)
        np.testing.assert_allclose(end.at(t).parameters["K_s"], 0.25 + s["K_s"] - b["K_s"], rtol=1e-12)
        np.testing.assert_allclose(
            end.at(t).parameters["sigma_s"], max(0.2 * s["sigma_s"] / b["sigma_s"], 0.001), rtol=1e-12
        )
        np.testing.assert_allclose(
            end.at(t).parameters["K_d"], np.array([0.2, 0.4, 0.6]) * s["K_d"] / b["K_d"], rtol=1e-12
        )


def test_dust_is_absolute_and_brings_its_layer() -> None:
    layer = motes.DustLayer(motes.Lambert((0.3, 0.3, 0.3)), motes.Dust(w=(0.9, 0.8, 0.6), g=0.25), tau=0.05)
    tau = Trend("exponential", {"start": 0.05, "end": 0.6, "time_constant": 30.0}, (0.0, 48.0), (0.0, 30.0))
    source = Material(layer, "bench", ("R", "G", "B"), trends={"tau": tau})
    aged = age(TARGET, "dust", source=source)
    now = aged.at(24.0).parameters
    assert now["tau"] == pytest.approx(0.6 - 0.55 * np.exp(-0.8), rel=1e-12)
    assert now["g"] == 0.25
    np.testing.assert_allclose(now["w"], (0.9, 0.8, 0.6))
    np.testing.assert_allclose(now["K_d"], (0.2, 0.4, 0.6))
    assert age(TARGET, "dust", source=source, w=0.5).at(0).parameters["w"] == 0.5
    assert aged.about["ageing"][-1]["source"] == "bench"
    spectral = age(motes.Lambert(np.linspace(0.1, 0.9, 31)), "dust", source=source)
    assert spectral.at(0).parameters["w"] == pytest.approx(2.3 / 3)
    assert any("mean" in note for note in spectral.about["ageing"][-1]["notes"])


def test_other_channels_get_the_mean_and_a_note() -> None:
    source = PHENOMENA["drying_surface"].example(12.0)
    names = tuple(f"{w} nm" for w in range(400, 710, 10))
    target = Material(
        motes.Lambert(np.linspace(0.1, 0.9, 31)), "leaf", names, tuple(float(w) for w in range(400, 710, 10))
    )
    aged = age(target, "drying_surface", source=source, given="start")
    ratio = source.at(12.0).parameters["K_d"].mean() / source.at(0.0).parameters["K_d"].mean()
    np.testing.assert_allclose(aged.at(12.0).parameters["K_d"], np.linspace(0.1, 0.9, 31) * ratio, rtol=1e-12)
    assert aged.wavelengths == target.wavelengths
    assert any("mean over the source's channels (R, G, B)" in note for note in aged.about["ageing"][-1]["notes"])


def test_a_ratio_to_nothing_becomes_a_difference() -> None:
    brdf = motes.Lambert((0.0, 0.1, 0.1)) + motes.TorranceSparrow(0.2, 0.1)
    K_d = Tabulated(np.array([0.0, 4.0]), np.array([[0.0, 0.1, 0.1], [0.2, 0.2, 0.2]]))
    source = Material(brdf, channels=("R", "G", "B"), trends={"K_d": K_d})
    aged = age(motes.Lambert((0.5, 0.5, 0.5)), "drying_surface", source=source, given="start")
    np.testing.assert_allclose(aged.at(4.0).parameters["K_d"], (0.7, 0.6, 0.6), rtol=1e-12)
    assert any("difference" in note and "vanishes" in note for note in aged.about["ageing"][-1]["notes"])


def test_without_a_source_it_is_the_phenomenon() -> None:
    a, b = age(TARGET, "dust", hours=5, tau_growth=0.3), PHENOMENA["dust"](TARGET, hours=5, tau_growth=0.3)
    assert a.to_dict() == b.to_dict()


STATIC = Material(TARGET, "stone", ("R", "G", "B"))
DRYING = PHENOMENA["drying_paint"].example(12.0)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: age(TARGET, "melting", hours=3), "not a phenomenon"),
        (lambda: age(TARGET, "dust"), "no time is given"),
        (lambda: age(TARGET, "dust", source=STATIC), "stone does not change with time"),
        (lambda: age(TARGET, "dust", source=DRYING), "nothing of dust follows time"),
        (lambda: age(TARGET, "dust", source=TARGET), "not a material"),
        (lambda: age(TARGET, "drying_paint", source=DRYING, K_s_left=0.3), "K_s_left comes from the source"),
        (lambda: age(TARGET, "drying_paint", source=DRYING, hours=(2, 1)), "do not go forward"),
        (lambda: age(motes.Lambert(np.full((2, 2, 3), 0.5)), "drying_paint", source=DRYING), "varies over the surface"),
    ],
)
def test_bad_input_is_named(call: object, message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        call()  # type: ignore[operator]
