"""Dust that bends light blurs the highlight below it: judged by direction, against photons."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from numpy.typing import NDArray

import photons
from catalogue import dense_albedo, upper_directions
from motes.arrays import NUMPY
from motes.directions import from_spherical
from motes.models import (
    BRDF,
    EON,
    GGX,
    GTR,
    Beckmann,
    CoatedDiffuse,
    Conductor,
    Dielectric,
    Dust,
    DustLayer,
    Lambert,
    OrenNayar,
    Schlick,
    TorranceSparrow,
)  # fmt: skip

Floats = NDArray[np.float64]
AROUND = np.radians([-10.0, -5.0, 0.0, 5.0, 10.0])
BODY = Lambert(0.1)
BASES = {
    "GGX": lambda alpha: BODY + GGX(0.5, alpha),
    "Torrance-Sparrow": lambda alpha: BODY + TorranceSparrow(0.5, alpha, "facets"),
}
LAYERS = tuple(product((0.0, 0.6, 0.85), (0.1, 0.5, 1.0)))  # g and tau


def dusty(base: BRDF, tau: float, g: float, w: float = 0.9) -> DustLayer:
    return DustLayer(base, Dust(w, g), tau, "multiple")


def about_mirror(theta: float) -> tuple[Floats, Floats]:
    """A direction of light, and viewers about its mirror direction, in the plane of incidence and out of it."""
    beside = from_spherical(theta, np.pi + AROUND[:2])
    return from_spherical(theta, 0.0), np.concatenate([from_spherical(theta + AROUND, np.pi), beside])


@pytest.mark.parametrize(("g", "tau"), LAYERS)
@pytest.mark.parametrize("alpha", [0.1, 0.3])
@pytest.mark.parametrize("name", BASES)
def test_highlights_under_dust_are_those_of_photons(name: str, alpha: float, g: float, tau: float) -> None:
    """Within 10 %, and the reference's noise, up to 10 degrees from the mirror direction; albedos within 2 %."""
    model = dusty(BASES[name](alpha), tau, g)
    for theta in np.radians([25.0, 55.0]):
        wi, wo = about_mirror(theta)
        seen, albedo = photons.both(photons.Layer(model.base, tau, 0.9, g), wi, wo, 2**14)
        off = np.abs(model.eval(wi, wo)[:, 0] - seen.value)
        assert (off < 0.1 * seen.value + 3 * seen.error).all()
        shift = abs(float(model.directional_albedo(wi, nodes=(32, 32))[0]) - float(albedo.value))
        assert shift < 0.02 * albedo.value + 3 * albedo.error


def test_forward_scattering_dust_roughens_a_highlight_and_does_not_only_dim_it() -> None:
    """What is added is highest in the mirror direction, and beside a narrow highlight it is nearly all that is seen."""
    base = GGX(0.5, 0.05)
    wi, wo = about_mirror(0.4)
    sharp = DustLayer(base, Dust(0.9, 0.85), 0.5).eval(wi, wo)[:, 0]
    gained = dusty(base, 0.5, 0.85).eval(wi, wo)[:, 0] - sharp
    even = dusty(base, 0.5, 0.0).eval(wi, wo)[:, 0] - DustLayer(base, Dust(0.9, 0.0), 0.5).eval(wi, wo)[:, 0]
    assert gained[2] == gained.max()
    assert gained[2] > 1.5 * max(gained[0], gained[4])
    assert gained[0] > sharp[0]
    assert even.max() < 1.3 * even.min()  # dust that scatters evenly spreads its light evenly


@pytest.mark.parametrize("g", [-0.5, 0.0, 0.6, 0.9])
@pytest.mark.parametrize("tau", [1e-4, 0.3, 3.0, np.inf])
def test_blur_is_reciprocal_never_negative_and_finite(g: float, tau: float) -> None:
    model = dusty(BODY + Beckmann(0.5, 0.15, Schlick(0.04)) + GTR(0.3, 0.3, 1.5), tau, g, 1.0)
    wi, wo = upper_directions(400, 1), upper_directions(400, 2)
    value = model.eval(wi, wo)
    assert np.isfinite(value).all()
    assert (value >= 0).all()
    np.testing.assert_allclose(value, model.eval(wo, wi), rtol=1e-12)
    narrow = model.eval(wi.astype(np.float32), wo.astype(np.float32))
    np.testing.assert_allclose(narrow, value, rtol=2e-3, atol=1e-5)


def test_without_dust_nothing_changes_and_a_thin_layer_changes_what_photons_say() -> None:
    base = BODY + GGX(0.5, 0.2)
    wi, wo = upper_directions(300, 3), upper_directions(300, 4)
    np.testing.assert_array_equal(dusty(base, 0.0, 0.8).eval(wi, wo), base.eval(wi, wo))
    # Over dust that scatters nothing the base is dimmed and no more.
    black = DustLayer(base, Dust(0.0, 0.8), 0.4, "multiple").eval(wi, wo)
    np.testing.assert_allclose(black, DustLayer(base, Dust(0.0, 0.8), 0.4).eval(wi, wo), rtol=1e-12, atol=1e-14)


def test_a_sum_of_highlights_is_blurred_term_by_term_wherever_it_stands() -> None:
    a, b, c = GGX(0.2, 0.1), OrenNayar(0.3, 0.4), TorranceSparrow(0.2, 0.2, "facets")
    wi, wo = upper_directions(100, 5), upper_directions(100, 6)
    values = [dusty(base, 0.5, 0.7).eval(wi, wo) for base in ((a + b) + c, c + (a + b), b + (c + a))]
    for value in values[1:]:
        np.testing.assert_allclose(value, values[0], rtol=1e-12)
    halves = dusty(GGX(0.1, 0.1) + (b + GGX(0.1, 0.1)) + c, 0.5, 0.7).eval(wi, wo)
    np.testing.assert_allclose(halves, values[0], rtol=1e-12)


@pytest.mark.parametrize("tau", [0.2, 1.0])
@pytest.mark.parametrize("g", [0.6, 0.85])
def test_white_dust_over_a_mirror_of_facets_keeps_its_light(tau: float, g: float) -> None:
    """What facets do not lose themselves: within 4 %, as everything here is fitted."""
    base = GGX(1.0, 0.1)
    for theta in (0.1, 0.8):
        wi = from_spherical(theta, 0.0)
        lost = 1 - float(base.spherical_albedo()[0])
        returned = float(dusty(base, tau, g, 1.0).directional_albedo(wi)[0])
        assert 1 - 2 * lost - 0.04 < returned < 1.04


@pytest.mark.parametrize(
    ("model", "within"),
    [
        (GGX(0.8, 0.1), 0.006), (GGX(0.8, 0.5), 0.006), (GGX(0.8, 1.0), 0.008),
        (Beckmann(0.8, 0.1), 0.02), (Beckmann(0.8, 0.5), 0.025), (GTR(0.8, 0.2, 1.3), 0.03), (GTR(0.8, 0.2, 4.0), 0.04),
        (TorranceSparrow(0.8, 0.1, "facets"), 0.025), (TorranceSparrow(0.8, 0.5), 0.02), (TorranceSparrow(0.8, 1.2, "facets"), 0.04),
        (GGX(1.0, 0.1, Dielectric(1.5)), 0.03), (GGX(1.0, 0.4, Schlick(0.04)), 0.04), (GGX(1.0, 0.3, Conductor(0.3, 3.0)), 0.02),
        (Beckmann(1.0, 0.3, Dielectric(1.5)), 0.03), (TorranceSparrow(1.0, 0.2, "facets", Dielectric(1.5)), 0.05),
        (EON(0.8, 0.7), 1e-4), (EON(1.0, 1.0), 1e-4), (CoatedDiffuse(0.8, 1.5), 1e-4), (OrenNayar(0.8, 0.3), 0.002), (Lambert(0.8), 1e-12),
    ],
    ids=str,
)  # fmt: skip
def test_models_know_their_albedo(model: BRDF, within: float) -> None:
    """Against dense quadrature, from the vertical to 84 degrees."""
    for cosine in (0.1, 0.3, 0.6, 0.85, 1.0):
        wi = from_spherical(np.arccos(cosine), 0.0)
        told = np.broadcast_to(np.asarray(model.reflected(NUMPY, cosine)), (1,))
        np.testing.assert_allclose(told, dense_albedo(model, wi), atol=within)


def test_a_model_without_a_highlight_says_so() -> None:
    assert all(model.spread() is None for model in (BODY, OrenNayar(0.5), Dust(0.5), BODY + GGX(0.5, 0.1)))
    assert GGX(0.5, 0.1).spread() == 0.1


@pytest.mark.parametrize("base", [GGX(1.0, 0.1), GGX(1.0, 0.3), TorranceSparrow(1.0, 0.3, "facets")])
def test_light_that_grazes_is_not_multiplied(base: BRDF) -> None:
    """White dust over facets that reflect all: at most 3 % too much up to 70 degrees, and 11 % at the horizon."""
    wi = from_spherical(np.radians([25.0, 50.0, 70.0, 80.0, 84.0, 88.0, 89.0]), np.zeros(7))
    for g, tau in ((0.3, 0.1), (0.6, 0.3), (0.85, 0.5), (0.85, 2.0)):
        layer = DustLayer(base, Dust(w=1.0, g=g), tau, scattering="multiple")
        albedo = np.asarray(layer.directional_albedo(wi, nodes=(48, 64)))[:, 0]
        assert albedo[:3].max() < 1.03
        assert albedo.max() < 1.11
