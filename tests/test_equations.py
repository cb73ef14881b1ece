"""Equations (1)-(13), each given its own arguments, against 50-digit arithmetic; and what the appendices leave to their readers."""

from __future__ import annotations

import inspect

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import quad

import golden
from catalogue import facet_area, fresnel
from golden import Rows
from golden.equations import EQUATIONS
from motes import equations
from motes.arrays import NUMPY as xp
from motes.directions import Geometry, Vector


@pytest.fixture(scope="module", params=golden.SOURCES)
def rows(request: pytest.FixtureRequest) -> Rows:
    return golden.appendices(request.param)


@pytest.mark.parametrize("name", [name for name, equation in EQUATIONS.items() if equation.column])
def test_each_equation_given_its_own_arguments(rows: Rows, name: str) -> None:
    # 1e-307: below it float64 is subnormal; the narrowest highlights of the table are e^-22500.
    assert_allclose(EQUATIONS[name].evaluate(xp, rows), rows[EQUATIONS[name].column], rtol=1e-12, atol=1e-307)


def test_what_feeds_theta_h(rows: Rows) -> None:
    """theta_h is ill-conditioned near 0: there it is the difference of rounded vectors, right to about an ulp of 1, not of itself.

    So its absolute error is tested here, and equation (10), which it feeds, with 1e-9 relative in the models end to end.
    """
    geometry = Geometry(xp, Vector.of(rows["wi"]), Vector.of(rows["wo"]))
    theta_h = geometry.theta_h[:, 0]
    # Two grazing vectors, cos_theta_d = 0.01, magnify an ulp by 1 / (2 cos_theta_d).
    assert np.all(np.abs(theta_h - rows["theta_h"]) <= 3e-16 * (1 + 1 / rows["cos_theta_d"]))


def test_the_table_holds_the_edges(rows: Rows) -> None:
    assert {0.0, 1e-6, 1.55, 1.5607} <= set(rows["theta_i"])
    assert {0.0, 0.001, 1.5} <= set(rows["sigma_d"])
    assert {-0.95, 0.0, 0.95} <= set(rows["g"])


def test_rho_d1_is_negative_where_the_source_says() -> None:
    """Grazing forward scatter from a very rough surface: equations return what is printed."""
    rho_d1 = equations.rho_d1(
        xp,
        equations.C1(xp, 1.5),
        equations.C2(xp, np.sin(1.55), np.sin(1.55) - (2 * 1.5 / np.pi) ** 3, -1.0, 1.5),
        equations.C3(xp, 1.55, 1.5, 1.5),
        -1.0,
        0.0,
        np.tan(1.5),
        np.tan(1.525),
        1.0,
    )
    # K_d/pi (C1 - C2 tan(beta)), by hand: C1 = 0.563953, C2 = 0.432692 (0.999784 - 0.870792) = 0.055814, tan(1.5) = 14.10142
    assert_allclose(rho_d1, (0.563953 - 0.055814 * 14.10142) / np.pi, rtol=1e-4)
    assert rho_d1 < 0


# ---------------------------------------------------------------- Henyey-Greenstein


@pytest.mark.parametrize("g", [-0.99, -0.5, 0.0, 0.3, 0.9])
def test_phase_function_integrates_to_4_pi_with_mean_cosine_g(g: float) -> None:
    def Phi(c: float) -> float:
        return float(equations.Phi(xp, (1 - c) / 2, (1 + c) / 2, g))

    points = [-0.999, -0.9, 0.9, 0.999]
    norm, _ = quad(lambda c: 2 * np.pi * Phi(c), -1, 1, points=points, epsabs=1e-12, limit=200)
    mean, _ = quad(lambda c: 2 * np.pi * c * Phi(c), -1, 1, points=points, epsabs=1e-12, limit=200)
    assert_allclose(norm, 4 * np.pi, rtol=1e-10)
    assert_allclose(mean / (4 * np.pi), g, atol=1e-10)


def test_g_above_0_is_forward_and_gamma_is_the_deviation() -> None:
    straight_on, back = equations.Phi(xp, 0.0, 1.0, 0.5), equations.Phi(xp, 1.0, 0.0, 0.5)
    assert_allclose([straight_on, back], [0.75 / 0.5**3, 0.75 / 1.5**3], rtol=1e-15)


# ---------------------------------------------------------------- Facets


@pytest.mark.parametrize("sigma_s", [0.001, 0.01, 0.1, 0.2, 0.2499, 0.25, 0.2501, 0.4, 0.8, 1.2, np.pi / 2])
def test_facet_area_is_the_integral_of_D_cos(sigma_s: float) -> None:
    assert_allclose(equations.facet_area(xp, sigma_s), facet_area(sigma_s), rtol=2e-14)


def test_facet_area_is_about_pi_sigma_squared_when_narrow_and_less_when_wide() -> None:
    narrow, wide = equations.facet_area(xp, 0.001), equations.facet_area(xp, 1.0)
    assert_allclose(narrow, np.pi * 0.001**2, rtol=1e-6)
    assert wide < 0.65 * np.pi


# ---------------------------------------------------------------- Fresnel

COSINES = np.concatenate([np.linspace(0.001, 1, 200), [1e-9]])


@pytest.mark.parametrize("n", [1.0001, 1.33, 1.5, 2.4, 10.0])
def test_dielectric_is_fresnel_in_complex_arithmetic(n: float) -> None:
    assert_allclose(equations.fresnel_dielectric(xp, COSINES, n), fresnel(COSINES, n), rtol=1e-11, atol=1e-15)


@pytest.mark.parametrize(
    ("n", "k"), [(0.05, 4.0), (0.14, 3.9), (1.4, 7.5), (2.9, 3.1), (10.0, 0.1), (0.01, 30.0), (0.4, 0.0), (2.0, 1e-3)]
)
def test_conductor_is_fresnel_in_complex_arithmetic(n: float, k: float) -> None:
    assert_allclose(equations.fresnel_conductor(xp, COSINES, n, k), fresnel(COSINES, n + 1j * k), rtol=0, atol=1e-11)


@pytest.mark.parametrize("n", [1.0, 1.2, 1.5, 4.0])
def test_conductor_without_absorption_is_a_dielectric(n: float) -> None:
    c = COSINES[COSINES > 1e-3]
    assert_allclose(
        equations.fresnel_conductor(xp, c, n, 0.0), equations.fresnel_dielectric(xp, c, n), rtol=0, atol=1e-12
    )


def test_equal_indices_reflect_nothing() -> None:
    c = np.linspace(0.001, 1, 100)
    assert_allclose(equations.fresnel_dielectric(xp, c, 1.0), 0, atol=1e-20)
    assert_allclose(equations.fresnel_conductor(xp, c, 1.0, 0.0), 0, atol=1e-12)


@pytest.mark.parametrize("n", [1.33, 1.5, 2.4])
def test_at_brewster_s_angle_only_s_polarisation_reflects(n: float) -> None:
    """tan(theta_B) = n; there p vanishes, and s is ((n^2 - 1)/(n^2 + 1))^2."""
    s = ((n * n - 1) / (n * n + 1)) ** 2
    assert_allclose(equations.fresnel_dielectric(xp, np.cos(np.arctan(n)), n), s / 2, rtol=1e-13)


@pytest.mark.parametrize(
    ("reflectance", "at_normal"),
    [
        (lambda c: equations.fresnel_dielectric(xp, c, 1.5), 0.04),
        (lambda c: equations.fresnel_conductor(xp, c, 1.5, 2.0), (0.25 + 4) / (6.25 + 4)),
        (lambda c: equations.fresnel_schlick(xp, c, 0.04), 0.04),
    ],
)
def test_reflectance_at_normal_and_at_grazing_incidence(reflectance, at_normal: float) -> None:  # type: ignore[no-untyped-def]
    assert_allclose(reflectance(np.array([1.0])), at_normal, rtol=1e-14)
    assert_allclose(reflectance(np.array([1e-9])), 1.0, rtol=1e-7)


@pytest.mark.parametrize(("n", "k"), [(1.5, 0.0), (0.2, 3.9), (1.0, 0.0)])
def test_the_reflectance_at_normal_incidence_is_that_of_the_conductor(n: float, k: float) -> None:
    assert_allclose(
        equations.fresnel_normal(n, k), equations.fresnel_conductor(xp, np.array([1.0]), n, k)[0], atol=1e-14
    )


def test_schlick_is_a_fifth_power() -> None:
    assert_allclose(equations.fresnel_schlick(xp, np.array([0.4]), 0.1), 0.1 + 0.9 * 0.6**5, rtol=1e-15)


# ---------------------------------------------------------------- The dust layer


def test_thin_layers_keep_their_digits() -> None:
    """1 - exp(-1e-18) is 0 in float64; expm1 keeps it."""
    assert_allclose(equations.dust_layer(xp, 0.0, 1.0, 1e-18), 1e-18, rtol=1e-15)


def test_every_equation_is_in_the_table_of_the_tests() -> None:
    functions = inspect.getmembers(equations, inspect.isfunction)
    assert {name for name, f in functions if f.__module__ == equations.__name__ and name[0] != "_"} == set(EQUATIONS)
