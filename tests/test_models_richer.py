"""The models beside those of the appendices: values of independent origin, white furnaces, limits, and how well they sample."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import quad

import golden
import motes
from catalogue import column, dense_albedo, direction, upper_directions
from golden import published
from motes import equations
from motes.arrays import NUMPY
from motes.directions import Geometry, Vector
from motes.models import (
    BRDF,
    EON,
    GGX,
    GTR,
    Beckmann,
    CoatedDiffuse,
    Dust,
    Hapke,
    Lambert,
    Retro,
    Sheen,
    TorranceSparrow,
)
from motes.models.coated_diffuse import diffuse_reflectance
from motes.models.gtr import gtr_grazing_roughness
from motes.models.sheen import LEAST_ROUGHNESS, sheen, sheen_albedo

# ---------------------------------------------------------------- EON


def test_eon_of_the_table() -> None:
    """50-digit values that others computed, at edges of the domain as well."""
    rows = golden.extended()
    value = EON(column(rows["rho"]), rows["r"]).eval(rows["wi"], rows["wo"])[:, 0]
    assert_allclose(value, rows["f_eon"], rtol=1e-10)


@pytest.mark.parametrize("r", [0.0, 0.1, 0.5, 1.0])
@pytest.mark.parametrize("theta_i", [0.0, 0.6, 1.2, 1.5, 1.56])
def test_a_white_eon_is_a_white_furnace(r: float, theta_i: float) -> None:
    """All light comes back, from every direction, at every roughness; 2e-6 is the quadrature's at 1.56 rad."""
    assert_allclose(dense_albedo(EON(1.0, r), direction(theta_i)), 1.0, rtol=4e-6)


def test_a_smooth_eon_is_lambert() -> None:
    wi, wo = upper_directions(500, 1), upper_directions(500, 2)
    assert_allclose(EON((0.9, 0.2), 0.0).eval(wi, wo), Lambert((0.9, 0.2)).eval(wi, wo), rtol=1e-14)


def test_eon_is_continuous_where_its_two_forms_meet() -> None:
    wi = direction(0.7)
    one, other = (EON(0.8, 1.0).eval(wi, direction(0.9, np.pi / 2 + d)) for d in (-1e-9, 1e-9))
    assert_allclose(one, other, rtol=1e-8)


# ---------------------------------------------------------------- GGX and Beckmann

FACETS = {"ggx": GGX, "beckmann": Beckmann}


@pytest.mark.parametrize("name", FACETS)
def test_facets_of_the_table(name: str) -> None:
    """50-digit values that others computed; float64 ends at 1e-308, and a tail exp(-q) is good to q times the precision of q."""
    rows = golden.extended()
    value = FACETS[name](1.0, rows["alpha"]).eval(rows["wi"], rows["wo"])[:, 0]
    expected = rows[f"f_{name}"]
    tail = np.maximum(1.0, -np.log(np.maximum(rows["D_beckmann"], 1e-300))) if name == "beckmann" else 1.0
    assert np.all(np.abs(value - expected) <= 2e-12 * tail * expected + 1e-300)
    assert np.sum(expected > 1e-6) > 200


@pytest.mark.parametrize("name", FACETS)
def test_narrow_facets_lose_nothing(name: str) -> None:
    """The masking is that of the distribution: seen from anywhere, the facets in sight fill the view (Heitz 2014, equation (35))."""
    for theta_i in (0.0, 0.8, 1.3):
        assert_allclose(FACETS[name](1.0, 0.003).directional_albedo(direction(theta_i)), 1.0, atol=1e-3)


@pytest.mark.parametrize("name", FACETS)
@pytest.mark.parametrize("alpha", [0.1, 0.5, 1.0])
def test_facets_in_sight_fill_the_view(name: str, alpha: float) -> None:
    """The integral of D max(0, wi . wh) is the view's area cos + cos Lambda: by quadrature over facets, which `masked` knows nothing of."""
    model = FACETS[name](1.0, alpha)
    x, w = np.polynomial.legendre.leggauss(200)
    tan = alpha * np.tan(0.25 * np.pi * (x + 1))  # dense where the facets are
    theta, phi = np.arctan(tan), np.pi * np.linspace(0, 2, 721)[:-1]
    measure = 0.25 * np.pi * w * alpha * (1 + (tan / alpha) ** 2) / (1 + tan**2) * np.sin(theta) * 2 * np.pi / len(phi)
    wh = np.stack(
        [
            np.outer(np.sin(theta), np.cos(phi)),
            np.outer(np.sin(theta), np.sin(phi)),
            np.outer(np.cos(theta), 1 + 0 * phi),
        ],
        -1,
    )
    D = model.distribution(NUMPY, Geometry(NUMPY, Vector.split(wh), Vector.split(wh)))
    for theta_i in (0.0, 0.7, 1.4, 1.57):
        seen = np.sum(D * measure[:, None] * np.maximum(wh @ direction(theta_i), 0))
        assert_allclose(seen, np.cos(theta_i) + model.masked(NUMPY, np.cos(theta_i), np.sin(theta_i)), rtol=2e-4)


@pytest.mark.parametrize("name", FACETS)
@pytest.mark.parametrize("theta_i", [0.3, 1.2, 1.5])
def test_visible_facets_waste_no_samples(name: str, theta_i: float) -> None:
    """No weight exceeds K_s (that of all facets grows without bound), and few samples are lost below the horizon."""
    model = FACETS[name](1.0, 0.4)
    wo, _, weight = model.sample(direction(theta_i), np.random.default_rng(1).random((20_000, 2)))
    assert weight.max() <= 1 + 1e-6
    assert np.mean(wo[:, 2] <= 0) < (0.05 if name == "ggx" else 0.35)
    assert weight.std() < 0.5


@pytest.mark.parametrize("alpha", [0.2, 0.4, 1.0])
def test_the_albedo_of_beckmann_is_the_integral(alpha: float) -> None:
    """Its numbers choose two slopes; equal steps, as along an angle, would err by 0.002."""
    for theta_i in (0.0, 1.0, 1.45):
        wi = direction(theta_i, 0.4)
        assert_allclose(Beckmann(1.0, alpha).directional_albedo(wi), dense_albedo(Beckmann(1.0, alpha), wi), atol=2e-4)


def test_a_narrow_beckmann_is_torrance_sparrow_with_normalised_facets() -> None:
    """Near the mirror direction, where tan(theta_h) is theta_h and no facet hides another."""
    for theta_r in (0.39, 0.4, 0.42):
        wi, wo = direction(0.4), direction(theta_r, np.pi)
        facets = TorranceSparrow(1.0, 0.01, "facets").eval(wi, wo)
        assert_allclose(Beckmann(1.0, 0.01).eval(wi, wo), facets, rtol=5e-4)


# ---------------------------------------------------------------- GTR


def grazing(alpha: float, gamma: float) -> float:
    """4 times the integral of Burley's D sin^2 over theta_h, by SciPy in pieces."""
    a2 = alpha * alpha
    constant = (a2 - 1) / np.log(a2) if gamma == 1 else (gamma - 1) * (a2 - 1) / (1 - a2 ** (1 - gamma))
    ends = [0, *(min(k * alpha, 0.5) for k in (0.3, 1, 3, 10)), np.pi / 2]
    pieces = [(a, b) for a, b in pairwise(ends) if b > a]
    D = lambda t: constant / np.pi / (a2 * np.cos(t) ** 2 + np.sin(t) ** 2) ** gamma  # noqa: E731
    return 4 * sum(quad(lambda t: D(t) * np.sin(t) ** 2, a, b, epsrel=1e-9)[0] for a, b in pieces)


@pytest.mark.parametrize("gamma", [1.0, 1.3, 1.7, 2.0, 3.0, 6.0, 10.0])
@pytest.mark.parametrize("alpha", [0.005, 0.03, 0.2, 0.6, 0.95])
def test_the_masking_of_gtr_is_that_of_facets_that_fill_as_much_of_a_grazing_view(alpha: float, gamma: float) -> None:
    assert_allclose(gtr_grazing_roughness(NUMPY, alpha, gamma), grazing(alpha, gamma), rtol=1e-2)


def test_grazing_roughness_in_closed_form() -> None:
    assert_allclose(grazing(0.3, 2.0), 0.3, rtol=1e-8)  # GGX itself
    assert_allclose(grazing(0.3, 1.0), 0.7 / -np.log(0.3), rtol=1e-8)
    assert_allclose(grazing(0.3, 3.0), 0.3 * (1 + 3 * 0.09) / (2 * (1 + 0.09)), rtol=1e-8)


def test_gtr_of_gamma_2_is_ggx() -> None:
    wi, wo = upper_directions(500, 1), upper_directions(500, 2)
    for alpha in (0.03, 0.3, 1.0):
        assert_allclose(GTR(0.7, alpha, 2.0).eval(wi, wo), GGX(0.7, alpha).eval(wi, wo), rtol=2e-3)


@pytest.mark.parametrize("gamma", [1.0, 1.25, 3.0, 10.0])
@pytest.mark.parametrize("alpha", [0.05, 0.3, 1.0])
def test_gtr_returns_no_more_than_all_light_from_anywhere(alpha: float, gamma: float) -> None:
    for theta_i in (0.0, 0.8, 1.3, 1.5):
        assert GTR(1.0, alpha, gamma).directional_albedo(direction(theta_i), nodes=(120, 90))[0] <= 1 + 1e-4


def test_gtr_is_continuous_at_the_ends_of_its_parameters() -> None:
    wi, wo = upper_directions(200, 1), upper_directions(200, 2)
    for at, near in (((0.3, 1.0), (0.3, 1 + 1e-7)), ((1.0, 1.4), (1 - 1e-7, 1.4)), ((1.0, 1.0), (1 - 1e-7, 1 + 1e-7))):
        assert_allclose(GTR(0.7, *at).eval(wi, wo), GTR(0.7, *near).eval(wi, wo), rtol=1e-5)


# ---------------------------------------------------------------- Hapke, and a body under an interface


def test_hapke_without_surge_and_seen_once_is_dust() -> None:
    wi, wo = upper_directions(500, 1), upper_directions(500, 2)
    w = 1e-6  # H is 1 then, and nothing is scattered twice
    assert_allclose(Hapke(w, 0.3, 0.0, 0.1).eval(wi, wo), Dust(w, 0.3).eval(wi, wo), rtol=1e-5)


def test_the_surge_doubles_what_is_scattered_back() -> None:
    """At opposition B is B_0, at tan(phase/2) = h half of it."""
    w, at = direction(0.5), [direction(0.5 - 2 * np.arctan(x)) for x in (0.0, 0.08)]
    once = [Dust(1e-6, -0.2).eval(w, wo)[0] for wo in at]
    found = [Hapke(1e-6, -0.2, 1.0, 0.08).eval(w, wo)[0] for wo in at]
    assert_allclose(np.divide(found, once), [2.0, 1.5], rtol=1e-5)


@pytest.mark.parametrize("theta_i", [0.0, 0.7, 1.2])
def test_white_particles_return_nearly_all_light(theta_i: float) -> None:
    """H is an approximation; Chandrasekhar's own would return 1."""
    assert_allclose(Hapke(1.0, 0.0, 0.0, 0.1).directional_albedo(direction(theta_i)), 1.0, atol=0.05)


def test_the_mean_reflectance_of_an_interface() -> None:
    n = np.array([1.0, 1.05, 1.2, 1.33, 1.5, 2.0, 3.0, 4.0])
    assert_allclose(diffuse_reflectance(NUMPY, n), published.mean_fresnel(n), atol=2e-5)
    assert_allclose(diffuse_reflectance(NUMPY, 1.5), 0.0918, atol=5e-5)  # Judd 1942, and every handbook since


@pytest.mark.parametrize("n", [1.0, 1.33, 1.8])
def test_a_white_body_under_an_interface_and_its_mirror_return_all_light(n: float) -> None:
    for theta_i in (0.0, 0.8, 1.4):
        mirror = equations.fresnel_dielectric(NUMPY, np.cos(theta_i), n)
        assert_allclose(dense_albedo(CoatedDiffuse(1.0, n), direction(theta_i)), 1 - mirror, atol=1e-4)


def test_without_an_interface_a_body_is_lambert() -> None:
    wi, wo = upper_directions(100, 1), upper_directions(100, 2)
    assert_allclose(CoatedDiffuse((0.7, 0.2), 1.0).eval(wi, wo), Lambert((0.7, 0.2)).eval(wi, wo), rtol=1e-13)


# ---------------------------------------------------------------- Terms beside others: retro-reflection and sheen


@pytest.mark.parametrize("theta_i", [0.0, 0.5, 1.2])
def test_what_is_sent_back_is_brightest_near_the_light(theta_i: float) -> None:
    """And as bright there as GGX is about the mirror direction; the mirror direction of light from the side has nothing."""
    back, mirror = Retro(0.8, 0.05), GGX(0.8, 0.05)
    wi = direction(theta_i, 0.7)
    around = [direction(theta_i + d, 0.7 + e) for d in (-0.1, 0.0, 0.1) for e in (-0.4, 0.0, 0.4) if theta_i + d >= 0]
    values = back.eval(wi, np.array(around))[:, 0]
    assert np.argmax(values) == next(k for k, w in enumerate(around) if np.allclose(w, wi))
    assert_allclose(back.eval(wi, wi), mirror.eval(wi, direction(theta_i, 0.7 + np.pi)), rtol=1e-12)
    if theta_i:
        assert back.eval(wi, direction(theta_i, 0.7 + np.pi))[0] < 1e-2 * values.max()


@pytest.mark.parametrize("theta_i", [0.0, 0.8, 1.4])
def test_as_much_is_sent_back_as_mirrored(theta_i: float) -> None:
    wi = direction(theta_i)
    assert_allclose(dense_albedo(Retro(0.8, 0.3), wi), GGX(0.8, 0.3).directional_albedo(wi), rtol=2e-3)


def test_sampling_what_is_sent_back_wastes_nothing() -> None:
    model = Retro(1.0, 0.4)
    wo, _, weight = model.sample(direction(1.2, 0.4), np.random.default_rng(1).random((20_000, 2)))
    assert weight.max() <= 1 + 1e-6
    assert np.mean(wo[:, 2] <= 0) < 0.05
    assert np.mean(wo @ direction(1.2, 0.4) > 0.5) > 0.5  # about the light


def upright(a: float, cosine: float) -> float:
    """The albedo of white fibres by Gauss-Legendre over the root of the cosine, dense at the horizon."""
    x, w = np.polynomial.legendre.leggauss(120)
    root, phi = 0.5 * (x + 1), np.pi * (np.arange(240) + 0.5) / 240
    z = root**2
    wo = np.stack([np.outer(np.sqrt(1 - z * z), f(phi)) for f in (np.cos, np.sin)] + [np.outer(z, 1 + 0 * phi)], -1)
    wi = direction(np.arccos(cosine))
    value = sheen(NUMPY, Geometry(NUMPY, Vector.split(wi), Vector.split(wo)), a)
    return float(np.sum(value * (w * root * z)[:, None]) * 2 * np.pi / len(phi))


def test_sheen_keeps_within_the_light_that_arrives() -> None:
    """From its least roughness on, even where light grazes; at 0.2, which other programs allow, it does not."""
    for a in (LEAST_ROUGHNESS, 0.4, 1.0):
        assert all(upright(a, cosine) < 1 for cosine in (1e-5, 0.01, 0.1, 0.5))
    assert upright(0.2, 1e-5) > 1.01
    assert_allclose([upright(a, c) for a in (0.25, 1.0) for c in (1e-5, 1.0)], [0.94, 0.03, 0.64, 0.14], atol=6e-3)


@pytest.mark.parametrize("a", [0.25, 0.6, 1.0])
def test_the_albedo_of_sheen_is_near_its_rational_fit(a: float) -> None:
    """The fit is others'; short of the horizon it is 0.05 off at most, at the horizon 0.09."""
    for cosine in (0.15, 0.4, 0.8, 1.0):
        assert abs(upright(a, cosine) - sheen_albedo(NUMPY, cosine, a)) < 0.05


@pytest.mark.parametrize(
    ("model", "text"),
    [
        (EON(0.4, 0.3) + Retro(0.15, 0.25), "eon + retro"),
        (EON(0.4, 0.3) + Sheen(0.15, 0.4), "eon + sheen"),
    ],
)
def test_a_fit_finds_the_term_again(model: BRDF, text: str) -> None:
    wi, wo = upper_directions(400, 5), upper_directions(400, 6)
    data = motes.Measurement.from_arrays(wi, wo, model.eval(wi, wo))
    fit = motes.fit(data, text)
    for name, value in model.parameters.items():
        assert_allclose(fit.parameters[name].value, value, rtol=1e-4)
