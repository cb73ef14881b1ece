"""What `auto` takes, and whether it is dust: the rules by hand, what is left out against a closed form, and dust by photons."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import motes
import photons
from fitting_oracle import scattered
from motes.fitting.climbing import climb
from motes.fitting.direction_blocks import blocks_of
from motes.fitting.judgement import DARKEST, Contender, judged, reduced_albedo, simplest, standard_errors
from motes.fitting.ladder import FOLDS
from motes.fitting.setup import Wishes
from motes.measurements import Measurement
from motes.models import Beckmann, CoatedDiffuse, Dielectric
from motes.models.composition import in_words
from motes.models.dust_optics import DUSTS
from motes.parameters import Role

WISHES = Wishes("linear", "none", "measurement", (), ())
DUST = {Role.DEPTH: 0.3, Role.SINGLE_SCATTERING_ALBEDO: 0.8, Role.ASYMMETRY: 0.3}


def contender(
    text: str, each: float, bic: float, layer: dict[Role, float] | None = None, bumpy: float = 0.0
) -> Contender:
    """24 blocks that leave `each`, every second one `bumpy` more and the others less."""
    left = each + bumpy * (-1.0) ** np.arange(24)
    return Contender(text, (), left, 24_000.0, bic, () if layer is None else (layer,))


def test_the_simplest_is_taken_than_which_the_best_is_not_clearly_better() -> None:
    small, large = contender("small", 1.1, 10), contender("large", 1.0, 0, bumpy=0.3)
    gain = small.left_out - large.left_out
    assert standard_errors(large, small) == pytest.approx(gain.sum() / (gain.std(ddof=1) * np.sqrt(24)))
    assert simplest([small, large]).text == "large"  # 1.6 standard errors
    assert simplest([small, contender("large", 1.0, 0, bumpy=0.6)]).text == "small"  # 0.8
    assert simplest([small, contender("large", 1.0, 11, bumpy=0.3)]).text == "small"  # the BIC is larger
    few = [Contender(c.text, (), c.left_out[:3], c.brightness, c.bic, ()) for c in (small, large)]
    assert simplest(few).text == "large"


@pytest.mark.parametrize(
    ("each", "layer", "brightness", "dusty"),
    [
        (0.5, {}, 24_000.0, True),
        (0.8, {}, 24_000.0, None),
        (0.95, {}, 24_000.0, False),
        (1.2, {}, 24_000.0, False),
        (0.5, {Role.DEPTH: 0.03}, 24_000.0, None),
        (0.8, {Role.DEPTH: 0.03}, 24_000.0, False),
        (0.5, {Role.SINGLE_SCATTERING_ALBEDO: 1.4}, 24_000.0, None),
        (0.5, {Role.SINGLE_SCATTERING_ALBEDO: 0.1}, 24_000.0, None),
        (
            0.5,
            {Role.SINGLE_SCATTERING_ALBEDO: 0.4, Role.ASYMMETRY: 0.85},
            24_000.0,
            None,
        ),  # nearly all goes straight on
        (0.5, {Role.ASYMMETRY: -0.6}, 24_000.0, None),
        (0.5, {}, 1_000.0, None),  # 15 % of the data are left
    ],
)
def test_dust_is_called_dust_where_it_is_decisive_possible_and_close(
    each: float, layer: dict[Role, float], brightness: float, dusty: bool | None
) -> None:
    clean = contender("clean", 1.0, 10)
    dust = Contender("dust", (), np.full(24, each), brightness, 0, (DUST | layer,))
    found = judged([clean, dust])
    assert found.dusty is dusty
    assert found.chosen.text == ("dust" if dusty else "clean")
    assert found.share == pytest.approx(each)


def test_a_heap_of_any_known_dust_but_soot_is_bright_enough() -> None:
    """The thresholds stand between soot and coarse desert dust; grains that absorb nothing, or scatter evenly, stay what they are."""
    assert reduced_albedo(1.0, 0.7) == pytest.approx(1.0)
    assert reduced_albedo(0.6, 0.0) == pytest.approx(0.6)
    found = {}
    for name, dust in DUSTS.items():
        w, g = (float(np.mean(number)) for number in dust.at([450, 550, 650]))
        found[name] = reduced_albedo(w, g)
    assert {name for name, albedo in found.items() if albedo < DARKEST} == {"soot"}
    assert found["desert_coarse"] < 1.2 * DARKEST, "the next one is not far above"


def test_layers_that_scatter_once_are_no_evidence_beside_those_that_scatter_often() -> None:
    clean, once = contender("clean", 1.0, 10), contender("once", 0.3, 0, DUST)
    often = replace(contender("often", 0.95, 0, DUST), whole=True)
    assert judged([clean, once]).dusty is True
    assert judged([clean, once, often]).dusty is False
    assert judged([clean, once, replace(often, left_out=0.5 * often.left_out)]).dusty is True


def test_dust_over_a_coat_is_found_and_a_coat_is_none() -> None:
    """By photons, over a varnished body."""
    base = CoatedDiffuse(0.4, 1.5) + Beckmann(1.0, 0.3, fresnel=Dielectric(1.5))
    wi, wo = scattered(200, 5)
    noise = 1 + 0.02 * np.random.default_rng(7).standard_normal((200, 1))
    f = photons.pairs(photons.Layer(base, 0.2, 0.8, 0.6), wi, wo, 4096)[:, None]
    assert motes.fit(Measurement.from_arrays(wi, wo, f * noise)).dusty is True
    assert motes.fit(Measurement.from_arrays(wi, wo, base.eval(wi, wo) * noise)).dusty is False


def test_nothing_is_said_of_dust_without_something_to_compare() -> None:
    assert judged([contender("clean", 1.0, 0)]).dusty is None
    assert judged([contender("dust", 1.0, 0, DUST)]).dusty is None


def test_what_is_left_out_is_predicted_by_fits_that_did_not_see_it() -> None:
    """Of Lambert's K_d least squares is a quotient of two sums."""
    wi, wo = scattered(150, 1)
    f = np.random.default_rng(3).uniform(0.1, 0.3, (150, 1))
    rung = climb(Measurement.from_arrays(wi, wo, f), WISHES)[0]
    assert rung.text == "lambert"
    blocks, cosine = blocks_of(wi, wo), wi[:, 2]
    expected = np.zeros(blocks.max() + 1)
    for turn in range(FOLDS):
        out = blocks % FOLDS == turn
        K_d = np.sum((f[:, 0] * cosine**2)[~out]) / np.sum((cosine**2 / np.pi)[~out])
        residual = (K_d / np.pi - f[:, 0]) * cosine
        np.add.at(expected, blocks[out], 0.5 * residual[out] ** 2)
    np.testing.assert_allclose(rung.left_out, expected, rtol=1e-6)
    bright = np.sum((f[:, 0] * cosine) ** 2)
    assert rung.trial().left_out == pytest.approx(np.sqrt(2 * expected.sum() / bright), rel=1e-6)


def test_dust_of_photons_is_found_and_its_base_is_clean() -> None:
    """A base that is no candidate, with 2 % of noise; and what is called what."""
    base = motes.OrenNayar(0.4, 0.3) + Beckmann(0.1, 0.3) + Beckmann(0.1, 0.7)
    wi, wo = scattered(200, 5)
    noise = 1 + 0.02 * np.random.default_rng(7).standard_normal((200, 1))
    bare = motes.fit(Measurement.from_arrays(wi, wo, base.eval(wi, wo) * noise))
    assert bare.dusty is False
    assert "dust" not in bare.model_text
    f = photons.pairs(photons.Layer(base, 0.3, 0.8, 0.3), wi, wo, 2048)[:, None]
    dusty = motes.fit(Measurement.from_arrays(wi, wo, f * noise))
    assert dusty.dusty is True
    assert "dust" in dusty.model_text
    assert any("layer of dust" in text for text in dusty.findings)
    assert dusty.to_dict()["dusty"] is True
    assert "under a layer of dust" not in in_words(dusty.brdf, dusty=None)
    assert "grazing roll-off" in in_words(dusty.brdf, dusty=None)
    assert in_words(dusty.brdf, dusty=True) == dusty.brdf.in_words()


def test_the_strength_of_a_coloured_highlight_is_fitted_for_each_channel() -> None:
    metal = motes.Lambert((0.1, 0.1, 0.1)) + motes.TorranceSparrow(K_s=(0.6, 0.4, 0.2), sigma_s=0.25)
    wi, wo = scattered(200, 5)
    noise = 1 + 0.02 * np.random.default_rng(7).standard_normal((200, 3))
    fit = motes.fit(Measurement.from_arrays(wi, wo, metal.eval(wi, wo) * noise))
    assert fit.model_text == "lambert + torrance_sparrow"
    assert next(trial.per_channel for trial in fit.tried if trial.chosen) == ("K_s",)
    np.testing.assert_allclose(fit.parameters["K_s"].value, (0.6, 0.4, 0.2), rtol=0.05)
