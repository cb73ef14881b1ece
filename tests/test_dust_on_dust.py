"""Dust over dust, judged by discrete ordinates of two layers, by one layer of the same dust, and by photons."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from numpy.typing import NDArray

import photons
from catalogue import upper_directions
from motes.arrays import NUMPY
from motes.directions import from_spherical
from motes.models import BRDF, GGX, Dust, DustLayer, Lambert, OrenNayar

Floats = NDArray[np.float64]
Layer = tuple[float, float, float]  # tau, w, g
AZIMUTHS = np.radians([0.0, 60.0, 120.0, 180.0])
SOOT_ON_FLOUR = ((0.3, 0.4, 0.6), (20.0, 0.995, 0.5))
FLOUR_ON_SOOT = ((0.3, 0.97, 0.6), (2.0, 0.5, 0.5))
THIN_ON_THIN = ((0.1, 0.97, 0.6), (0.3, 0.9, 0.85))


def stacked(base: BRDF, *layers: Layer) -> BRDF:
    """The topmost layer first."""
    for tau, w, g in reversed(layers):
        base = DustLayer(base, Dust(w, g), tau, "multiple")
    return base


@pytest.mark.parametrize(
    ("layers", "albedo", "brdf"), [(SOOT_ON_FLOUR, 0.015, 0.04), (FLOUR_ON_SOOT, 0.025, 0.05), (THIN_ON_THIN, 0.03, 0.1)], ids=str
)  # fmt: skip
@pytest.mark.parametrize("degrees", [20.0, 50.0, 75.0])
def test_two_dusts_are_as_bright_as_discrete_ordinates_of_two_layers_say(
    layers: tuple[Layer, Layer], albedo: float, brdf: float, degrees: float
) -> None:
    """Without directional albedos of layers the first were 12 % off, and the last 40 %."""
    discrete_ordinates = pytest.importorskip("discrete_ordinates")
    base, wi = Lambert(0.3), from_spherical(np.radians(degrees), 0.0)
    truth = discrete_ordinates.layers(base, layers, np.radians(degrees), 32)
    seen = truth.cosines > np.cos(np.radians(80))
    wo = from_spherical(np.arccos(truth.cosines[seen])[:, None], AZIMUTHS)
    model = stacked(base, *layers)
    np.testing.assert_allclose(model.eval(wi, wo)[..., 0], truth.brdf(AZIMUTHS)[seen], rtol=brdf)
    np.testing.assert_allclose(model.directional_albedo(wi)[0], truth.albedo, rtol=albedo)


@pytest.mark.parametrize(("w", "g"), [(0.97, 0.6), (0.8, 0.0), (0.6, -0.4)])
def test_two_layers_of_one_dust_are_one_thicker_layer(w: float, g: float) -> None:
    base = OrenNayar(0.3, 0.3)
    wi, wo = upper_directions(400, 1), upper_directions(400, 2)
    steep = (wi[:, 2] > 0.17) & (wo[:, 2] > 0.17)
    two, one = stacked(base, (0.1, w, g), (0.3, w, g)), stacked(base, (0.4, w, g))
    off = np.abs(two.eval(wi, wo) / one.eval(wi, wo) - 1)[steep]
    assert np.median(off) < 0.016
    assert off.max() < 0.1


def test_a_bed_without_an_end_is_a_base_like_an_infinite_layer() -> None:
    wi, wo = upper_directions(100, 3), upper_directions(100, 4)
    bed = DustLayer(Dust(0.9, 0.5, scattering="multiple"), Dust(0.5, 0.2), 0.4, "multiple")
    np.testing.assert_allclose(
        bed.eval(wi, wo), stacked(Lambert(0.5), (0.4, 0.5, 0.2), (np.inf, 0.9, 0.5)).eval(wi, wo), rtol=1e-9
    )


@pytest.mark.parametrize(
    "model",
    [
        Dust(0.9, 0.6), Dust((0.9, 0.5), -0.4), Dust(0.9, 0.6, scattering="multiple"),
        DustLayer(Lambert(0.6), Dust(0.9, 0.6), 0.3), stacked(Lambert(0.6), (0.3, 0.95, 0.6)),
        stacked(Lambert(0.8), (0.2, 0.5, 0.6), (0.5, 0.97, 0.3)), DustLayer(GGX(0.5, 0.2), Dust(0.5, 0.6), 0.3),
        stacked(Lambert(0.1) + GGX(0.5, 0.2), (0.5, 0.9, 0.6)), stacked(OrenNayar(0.8, 0.4), (0.5, 0.9, 0.6)),
    ],
    ids=str,
)  # fmt: skip
def test_dust_knows_its_albedo(model: BRDF) -> None:
    """Within 0.02 of quadrature (over a highlight, and towards the horizon, 0.06): what a layer above needs."""
    cosines = np.array([0.2, 0.4, 0.7, 1.0])
    wi = from_spherical(np.arccos(cosines), 0 * cosines)
    glossy = any(
        term.spread() is not None for layer in [model] if isinstance(layer, DustLayer) for term in layer.base.terms()
    )
    told = np.stack([np.broadcast_to(np.asarray(model.reflected(NUMPY, mu)), (model.channels,)) for mu in cosines])
    np.testing.assert_allclose(told, model.directional_albedo(wi), atol=0.06 if glossy else 0.02)


def test_stacks_are_reciprocal_and_end_as_they_should() -> None:
    wi, wo = upper_directions(300, 5), upper_directions(300, 6)
    base = Lambert(0.1) + GGX(0.5, 0.2)
    lower = stacked(base, (0.3, 0.9, 0.6))
    both = stacked(base, (0.4, 0.5, 0.85), (0.3, 0.9, 0.6))
    value = both.eval(wi, wo)
    np.testing.assert_allclose(value, both.eval(wo, wi), rtol=1e-12)
    assert (value >= 0).all()
    np.testing.assert_array_equal(stacked(base, (0.0, 0.5, 0.6), (0.3, 0.9, 0.6)).eval(wi, wo), lower.eval(wi, wo))
    for layers in (((0.4, 0.5, 0.85), (0.0, 0.9, 0.6)), ((0.0, 0.9, 0.6), (0.4, 0.5, 0.85))):
        np.testing.assert_allclose(
            stacked(base, *layers).eval(wi, wo), stacked(base, (0.4, 0.5, 0.85)).eval(wi, wo), rtol=1e-9
        )
    black = DustLayer(lower, Dust(0.0, 0.6), 0.4)
    np.testing.assert_allclose(
        stacked(base, (0.4, 0.0, 0.6), (0.3, 0.9, 0.6)).eval(wi, wo), black.eval(wi, wo), rtol=1e-12, atol=1e-14
    )


def test_white_dusts_over_white_keep_their_light() -> None:
    """Within 1.2 % up to 60 degrees, 4 % beyond: what the lower dust sends up is not quite uniform."""
    wi = from_spherical(np.radians([0.0, 30.0, 60.0, 75.0, 88.0]), np.zeros(5))
    for (tau, g), (depth, lower) in product(((0.1, 0.6), (2.0, 0.3)), ((0.1, 0.6), (2.0, 0.85))):
        kept = stacked(Lambert(1.0), (tau, 1.0, g), (depth, 1.0, lower)).directional_albedo(wi)[:, 0]
        np.testing.assert_allclose(kept[:3], 1, atol=0.012)
        np.testing.assert_allclose(kept, 1, atol=0.04)


@pytest.mark.parametrize("degrees", [25.0, 55.0])
@pytest.mark.parametrize(
    ("w", "g", "upper", "lower"), [(0.9, 0.6, 0.3, 0.3), (0.9, 0.85, 0.1, 0.4), (0.7, 0.0, 0.5, 0.2)]
)
def test_highlights_are_blurred_by_both_dusts(w: float, g: float, upper: float, lower: float, degrees: float) -> None:
    """Of one dust in two layers, so that photons know nothing of layers; with the lower highlight taken for even light the first was 11 % off."""
    base, theta = Lambert(0.1) + GGX(0.5, 0.2), np.radians(degrees)
    wi = from_spherical(theta, 0.0)
    wo = from_spherical(theta + np.radians([-10.0, -5.0, 0.0, 5.0, 10.0]), np.pi)
    model = stacked(base, (upper, w, g), (lower, w, g))
    seen, albedo = photons.both(photons.Layer(base, upper + lower, w, g), wi, wo, 2**14)
    assert (np.abs(model.eval(wi, wo)[:, 0] - seen.value) < 0.1 * seen.value + 3 * seen.error).all()
    assert abs(float(model.directional_albedo(wi)[0]) - float(albedo.value)) < 0.02 * albedo.value + 3 * albedo.error


def test_three_dusts_over_a_highlight_are_near_what_photons_say() -> None:
    """Photons in the topmost layer over the two others, whose own model they take for granted."""
    lower = stacked(Lambert(0.1) + GGX(0.5, 0.2), (0.2, 0.6, 0.3), (0.3, 0.95, 0.6))
    model, theta = stacked(lower, (0.2, 0.7, 0.0)), np.radians(40.0)
    wi = from_spherical(theta, 0.0)
    wo = from_spherical(theta + np.radians([-40.0, -20.0, -5.0, 0.0, 5.0, 20.0]), np.pi)
    seen, albedo = photons.both(photons.Layer(lower, 0.2, 0.7, 0.0), wi, wo, 2**13)
    assert (np.abs(model.eval(wi, wo)[:, 0] - seen.value) < 0.03 * seen.value + 3 * seen.error).all()
    assert abs(float(model.directional_albedo(wi)[0]) - float(albedo.value)) < 0.02 * albedo.value + 3 * albedo.error


def test_samples_of_a_stack_weigh_what_it_reflects() -> None:
    model = stacked(Lambert(0.2) + GGX(0.4, 0.2), (0.3, 0.6, 0.4), (0.3, 0.95, 0.6))
    wi = from_spherical(0.7, 0.0)
    weight = model.sample(np.broadcast_to(wi, (40000, 3)), np.random.default_rng(1).random((40000, 2))).weight[:, 0]
    assert abs(weight.mean() - float(model.directional_albedo(wi)[0])) < 4 * weight.std() / 200
