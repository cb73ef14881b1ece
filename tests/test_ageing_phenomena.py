"""Phenomena: what moves, that it stays physical, and that it survives a file."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import motes
from motes.ageing import PHENOMENA, age, simulate
from motes.ageing.drying import wet_and_dry
from motes.ageing.rig import Rig
from motes.directions import from_spherical
from motes.errors import ParameterError
from motes.material import Material, load
from motes.parameters import Role

TIMES = np.array([-2.0, 0.0, 1.0, 5.0, 12.0, 40.0])
TARGETS = {
    "lambert": motes.Lambert(0.4),
    "clay": motes.OrenNayar(K_d=(0.7, 0.6, 0.5), sigma_d=0.4),
    "gloss": motes.OrenNayar(K_d=(0.3, 0.2, 0.1), sigma_d=0.2) + motes.TorranceSparrow(K_s=0.3, sigma_s=0.2),
    "two lobes": motes.Lambert((0.2, 0.1, 0.1)) + (motes.TorranceSparrow(0.2, 0.1) + motes.TorranceSparrow(0.1, 0.3)),
    "dusty": motes.DustLayer(motes.Lambert((0.5, 0.4, 0.3)), motes.Dust(w=0.6, g=0.2), tau=0.1),
    "spectral": motes.Lambert(np.linspace(0.1, 0.8, 31)) + motes.TorranceSparrow(0.1, 0.2),
}
EACH = pytest.mark.parametrize("name", PHENOMENA)


def directions(count: int = 40, seed: int = 3) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    theta, phi = rng.uniform(0, 1.4, (2, count)), rng.uniform(-np.pi, np.pi, (2, count))
    return from_spherical(theta[0], phi[0]), from_spherical(theta[1], phi[1])


@EACH
@pytest.mark.parametrize("target", TARGETS)
def test_aged_materials_are_physical(name: str, target: str) -> None:
    aged = PHENOMENA[name](TARGETS[target], hours=12)
    wi, wo = directions()
    at_once = aged.at(TIMES).eval(wi, wo)
    for k, t in enumerate(TIMES):
        brdf = aged.at(t)
        for slot in brdf.slots():
            low, high = slot.parameter.bounds
            assert np.all((np.asarray(slot.value) >= low) & (np.asarray(slot.value) <= high))
        value = brdf.eval(wi, wo)
        assert np.isfinite(value).all()
        assert value.min() >= 0
        np.testing.assert_allclose(value, brdf.eval(wo, wi), rtol=1e-9, atol=1e-15)
        np.testing.assert_allclose(at_once[k], value, rtol=1e-12)
        assert brdf.directional_albedo(np.array([0, 0, 1.0]), nodes=(24, 24)).max() < 1


@EACH
def test_examples_move_what_they_say_and_nothing_else(name: str) -> None:
    phenomenon = PHENOMENA[name]
    aged = phenomenon.example(12.0)
    before, after = aged.at(0).parameters, aged.at(12).parameters
    changed = {key for key in before if not np.allclose(before[key], after[key], rtol=1e-6)}
    assert changed == set(aged.trends)
    roles = {slot.parameter.role for slot in aged.brdf.slots() if slot.name in changed}
    assert roles <= set(phenomenon.moves)
    assert roles >= set(phenomenon.moves) - {Role.SINGLE_SCATTERING_ALBEDO, Role.ASYMMETRY}


@EACH
def test_survives_a_file(name: str, tmp_path: Path) -> None:
    aged = PHENOMENA[name].example(7.0)
    again = load(aged.save(tmp_path / "aged.json"))
    assert again.about == aged.about
    for t in TIMES:
        assert again.at(t) == aged.at(t)


@EACH
def test_can_be_simulated(name: str, tmp_path: Path) -> None:
    aged = PHENOMENA[name].example(3.0)
    data = motes.read(simulate(tmp_path / "s", aged, scans=3, hours=3, noise=0.0, rig=Rig(step_deg=12)))
    for k, t in enumerate(data.times):
        np.testing.assert_allclose(data.values[k], aged.at(float(t)).eval(data.wi, data.wo), rtol=2e-4, atol=2e-5)


@EACH
@pytest.mark.parametrize("given", ["start", "end"])
def test_is_what_it_was_at_the_moment_given(name: str, given: str) -> None:
    target = TARGETS["dusty"] if name == "dust" else TARGETS["gloss"]
    options = {"tau_growth": 0.05} if name == "dust" else {}
    if name == "rusting" and given == "end":
        target = motes.Lambert((0.3, 0.3, 0.3)) + motes.TorranceSparrow(0.3, 0.4)
    aged = PHENOMENA[name](target, hours=(2, 8), given=given, **options)
    far = {"start": 2.0, "end": 8.0}[given]
    if name.startswith("drying"):  # the wet state is that of the first moment, the dry one that long after
        far = 2.0 if given == "start" else 1e4
    for key, value in target.parameters.items():
        np.testing.assert_allclose(
            aged.at(far).parameters[key], value, rtol=0.02 if name == "drying_surface" else 1e-9, err_msg=key
        )


def test_paint_follows_the_paper() -> None:
    aged = PHENOMENA["drying_paint"](TARGETS["gloss"], hours=8, time_constant=1.5, K_s_left=0.25, sigma_s_growth=2)
    t = np.linspace(0, 8, 30)
    K_s, sigma_s, K_d = (np.array([aged.at(x).parameters[name] for x in t]) for name in ("K_s", "sigma_s", "K_d"))
    np.testing.assert_allclose(K_s, 0.3 + (1.2 - 0.3) * np.exp(-t / 1.5), rtol=1e-12)
    np.testing.assert_allclose(sigma_s, 0.2 + (0.1 - 0.2) * np.exp(-t / 1.5), rtol=1e-12)
    assert np.all(np.diff(sigma_s) > 0)
    steps = np.diff(K_d, axis=0)
    np.testing.assert_allclose(np.cross(steps, K_d[-1] - K_d[0]), 0, atol=1e-15)  # on a line
    assert np.all(K_d[0] < K_d[-1])
    assert K_d[0, 0] / K_d[0, 2] > K_d[-1, 0] / K_d[-1, 2]  # wet colours are more saturated


def test_surface_follows_the_paper() -> None:
    aged = PHENOMENA["drying_surface"](
        TARGETS["clay"], hours=10, middle=4, width=0.5, film_K_s=0.2, film_time_constant=1
    )
    dry = np.array(TARGETS["clay"].parameters["K_d"])
    wet = 0.53 * dry / (1 - 0.47 * dry)
    for t in (0.0, 3.0, 4.0, 6.0):
        now = aged.at(t).parameters
        np.testing.assert_allclose(now["K_d"], wet + (dry - wet) / (1 + np.exp((4 - t) / 0.5)), rtol=1e-12)
        assert now["K_s"] == pytest.approx(0.2 * np.exp(-t), rel=1e-12)
        assert now["sigma_d"] == 0.4


def test_wet_and_dry_are_inverse_and_keep_black_and_white() -> None:
    K = np.array([0.0, 0.1, 0.5, 0.9, 1.0, 3.0])
    wet, _ = wet_and_dry(K, "end", 0.47)
    _, dry = wet_and_dry(wet, "start", 0.47)
    np.testing.assert_allclose(dry, K, rtol=1e-12)
    np.testing.assert_allclose(wet[[0, 4, 5]], K[[0, 4, 5]])
    assert np.all(wet[1:4] < K[1:4])
    # The series behind the formula: out at once, or back n times onto the pigment.
    series = sum(0.5 * 0.53 * (0.47 * 0.5) ** n for n in range(60))
    assert wet[2] == pytest.approx(series, rel=1e-12)


@pytest.mark.parametrize("theta", [0.0, 0.6, 1.2])
def test_dust_hides_the_highlight_by_the_law_of_attenuation(theta: float) -> None:
    base = motes.TorranceSparrow(K_s=0.8, sigma_s=0.1)
    aged = PHENOMENA["dust"](base, hours=10, tau_growth=1.0, w=0.0)  # black dust: nothing but attenuation
    wi, wo = from_spherical(theta, 0.0), from_spherical(theta, np.pi)
    for t in (0.0, 2.5, 10.0):
        law = np.exp(-0.1 * t * 2 / np.cos(theta))
        np.testing.assert_allclose(aged.at(t).eval(wi, wo), base.eval(wi, wo) * law, rtol=1e-12)
    assert set(aged.trends) == {"tau"}
    bright = {"hours": 10, "tau_growth": 1.0, "w": 0.8, "g": 0.3}
    once = PHENOMENA["dust"](base, scattering="single", **bright).at(10.0).eval(wi, wo)
    law = np.exp(-2 / np.cos(theta))
    expected = base.eval(wi, wo) * law + motes.Dust(w=0.8, g=0.3).eval(wi, wo) * (1 - law)
    np.testing.assert_allclose(once, expected, rtol=1e-12)
    assert (
        PHENOMENA["dust"](base, **bright).at(10.0).eval(wi, wo) > expected
    ).all()  # what is scattered again comes on top


def test_the_form_of_scattering_stays_and_is_carried_over() -> None:
    dusty = PHENOMENA["dust"](TARGETS["clay"], hours=10)
    assert dusty.brdf.options()["scattering"] == "multiple"
    assert PHENOMENA["dust"](TARGETS["dusty"], hours=10).brdf.options()["scattering"] == "single"  # its own
    changed = PHENOMENA["dust"](TARGETS["dusty"], hours=10, scattering="multiple")
    assert changed.brdf.options()["scattering"] == "multiple"
    for form in ("single", "multiple"):
        source = PHENOMENA["dust"](TARGETS["clay"], hours=10, scattering=form)
        for target in ("clay", "dusty"):  # w and g are those of the source, and mean what they mean in its form
            assert age(TARGETS[target], "dust", source=source).brdf.options()["scattering"] == form
        assert any(
            form in note or (form == "single" and "once" in note) for note in source.about["ageing"][-1]["notes"]
        )
    with pytest.raises(ParameterError, match="scattering = 'twice' is not one of single, multiple"):
        PHENOMENA["dust"](TARGETS["clay"], hours=10, scattering="twice")
    too_bright = motes.DustLayer(motes.Lambert(0.3), motes.Dust(w=1.4), tau=0.1)
    with pytest.raises(ParameterError, match=r"w = 1.4 is outside \[0, 1\]"):
        PHENOMENA["dust"](too_bright, hours=10, scattering="multiple")


def test_dust_gathers_on_dust_and_on_drying() -> None:
    drying = PHENOMENA["drying_surface"](TARGETS["clay"], hours=10)
    dusty = PHENOMENA["dust"](drying, hours=10, tau_growth=0.2)
    assert set(dusty.trends) == {"K_d", "K_s", "tau"}
    np.testing.assert_allclose(dusty.at(4).parameters["K_d"], drying.at(4).parameters["K_d"])
    assert [step["phenomenon"] for step in dusty.about["ageing"]] == ["drying_surface", "dust"]
    more = PHENOMENA["dust"](TARGETS["dusty"], hours=10, tau_growth=0.2)
    assert more.at(10).parameters["tau"] == pytest.approx(0.3)
    assert more.at(10).parameters["w"] == 0.6


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: PHENOMENA["dust"](motes.Lambert(0.5), hours=0), "do not go forward"),
        (lambda: PHENOMENA["dust"](motes.Lambert(0.5), hours=(3, 2)), "do not go forward"),
        (lambda: PHENOMENA["dust"](motes.Lambert(0.5), hours=float("nan")), "do not go forward"),
        (lambda: PHENOMENA["dust"](motes.Lambert(0.5), hours=(1, 2, 3)), "shape"),
        (lambda: PHENOMENA["dust"](motes.Lambert(0.5), hours=3, w=1.5), r"w = 1.5 is outside \[0, 1\]"),
        (
            lambda: PHENOMENA["dust"](motes.Lambert((0.5, 0.4)), hours=3, w=(0.1, 0.2, 0.3)),
            "3 channels and the surface 2",
        ),
        (lambda: PHENOMENA["dust"](motes.Lambert(0.5), hours=3, color=1), "has no option 'color'"),
        (lambda: PHENOMENA["dust"]("gold", hours=3), "str is not a material"),
        (lambda: PHENOMENA["drying_paint"](motes.Lambert(0.5), hours=3, time_constant=-1), "time_constant = -1"),
        (lambda: PHENOMENA["drying_paint"](motes.Lambert(0.5), hours=3, time_constant="x"), "not a number"),
        (lambda: PHENOMENA["drying_paint"](motes.Lambert(0.5), hours=3, K_s_left=(0.1, 0.2)), "shape"),
        (lambda: PHENOMENA["drying_paint"](motes.Lambert(0.5), hours=3, given="middle"), "not start or end"),
        (lambda: PHENOMENA["drying_paint"](motes.Lambert(np.full((4, 1, 3), 0.5)), hours=3), "varies over the surface"),
        (lambda: PHENOMENA["rusting"](motes.Dust(0.5), hours=3), "neither a diffuse colour nor a highlight"),
    ],
)
def test_bad_input_is_named(call: object, message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        call()  # type: ignore[operator]


def test_channels_get_names() -> None:
    aged = PHENOMENA["dust"](Material(motes.Lambert((0.1, 0.2, 0.3))), hours=1)
    assert aged.channels == ("R", "G", "B")
    assert PHENOMENA["dust"](motes.Lambert(0.1), hours=1).channels == ("grey",)
    assert len(PHENOMENA["dust"](TARGETS["spectral"], hours=1).channels) == 31


@pytest.mark.parametrize("name", ["drying_paint", "drying_surface", "rusting"])
def test_a_strength_that_is_an_energy_ages_as_one_that_is_a_height(name: str) -> None:
    """The same surface, its highlight normalised to the facets' area or not, is the same surface at all times (narrow facets)."""
    width, height = 0.03, 0.4
    printed = motes.Lambert(0.4) + motes.TorranceSparrow(K_s=height, sigma_s=width)
    energy = height * np.pi * width**2
    facets = motes.Lambert(0.4) + motes.TorranceSparrow(K_s=energy, sigma_s=width, normalization="facets")
    given = {"rusting": "start"}.get(name, "end")
    one, other = (PHENOMENA[name](brdf, hours=10, given=given) for brdf in (printed, facets))
    mirror = np.array([[0.0, 0.0, 1.0]])
    moments = (0, 10) if name != "rusting" else (0, 2, 4, 6, 8, 10)
    for t in moments:
        np.testing.assert_allclose(
            one.at(t).eval(mirror, mirror), other.at(t).eval(mirror, mirror), rtol=0.06, err_msg=str(t)
        )
    assert one.at(0).eval(mirror, mirror) > 1.1 * one.at(10).eval(mirror, mirror)
