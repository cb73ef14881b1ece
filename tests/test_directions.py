"""Angles, half vectors, frames: accuracy against 40-digit arithmetic, round trips, and the geometry that the equations are given."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from numpy.typing import NDArray

from catalogue import direction, upper_directions
from motes import directions
from motes.arrays import NUMPY
from motes.directions import Geometry, Vector, polar_angle

angles = st.floats(0, np.pi)
azimuths = st.floats(-3.14, 3.14)


def sphere(n: int, seed: int) -> NDArray[np.float64]:
    w = np.random.default_rng(seed).normal(size=(n, 3))
    return w / np.linalg.norm(w, axis=-1, keepdims=True)


# ---------------------------------------------------------------- polar_angle


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_polar_angle_is_right_to_3_ulp_everywhere(dtype: type) -> None:
    """Given rounded sine and cosine; at 1e-3 rad acos would be wrong by 1e-1 in float32 and 1e-10 in float64."""
    theta = np.concatenate([np.geomspace(1e-6, np.pi / 2, 1500), np.pi / 2 - np.geomspace(1e-6, 1, 500), [np.pi / 4]])
    with mp.workdps(40):
        exact = [(mp.cos(t), mp.sin(t)) for t in theta]
        cos, sin = (np.array([float(v) for v in column], dtype) for column in zip(*exact, strict=True))
        got = polar_angle(NUMPY, cos, sin)
        assert got.dtype == dtype
        # The angle of the rounded pair, through the smaller of the two, is what can be asked for.
        asked = [mp.asin(float(s)) if s < c else mp.acos(float(c)) for c, s in zip(cos, sin, strict=True)]
        error = [abs(mp.mpf(float(g)) - a) for g, a in zip(got, asked, strict=True)]
        ulp = np.spacing(np.array([float(a) for a in asked], dtype))
    assert max(float(e) / float(u) for e, u in zip(error, ulp, strict=True)) <= 3
    assert_allclose(got, theta, rtol=3 * np.finfo(dtype).eps)


def test_acos_would_not_do() -> None:
    cos, sin = np.float32(np.cos(1e-3)), np.float32(np.sin(1e-3))
    assert abs(np.arccos(cos) / 1e-3 - 1) > 0.02
    assert abs(polar_angle(NUMPY, cos, sin) / 1e-3 - 1) < 1e-6


def test_polar_angle_at_the_ends() -> None:
    assert polar_angle(NUMPY, 1.0, 0.0) == 0
    assert polar_angle(NUMPY, 0.0, 1.0) == np.pi / 2


# ---------------------------------------------------------------- Spherical coordinates


def test_spherical_coordinates_return() -> None:
    w = sphere(2000, 1)
    assert_allclose(directions.from_spherical(directions.theta(w), directions.phi(w)), w, rtol=0, atol=5e-16)


@given(theta=angles, phi=azimuths)
def test_angles_return(theta: float, phi: float) -> None:
    w = directions.from_spherical(theta, phi)
    assert_allclose(np.linalg.norm(w), 1, rtol=4e-16)
    assert_allclose(directions.theta(w), theta, rtol=0, atol=4e-16)
    if 1e-6 < theta < np.pi - 1e-6:
        assert_allclose(directions.phi(w), phi, rtol=0, atol=1e-9)


def test_axes() -> None:
    assert_allclose(directions.from_spherical(0.0, 1.0), [0, 0, 1])
    assert_allclose(directions.from_spherical(np.pi / 2, [0, np.pi / 2]), [[1, 0, 0], [0, 1, 0]], atol=1e-16)
    assert directions.theta([0, 0, -1]) == np.pi
    assert_allclose(directions.phi([[0, -1, 0], [-1, 0, 0]]), [-np.pi / 2, np.pi])


def test_spherical_coordinates_broadcast() -> None:
    assert directions.from_spherical(np.zeros((4, 1)), np.zeros(5)).shape == (4, 5, 3)


# ---------------------------------------------------------------- Half and difference angles


def test_half_difference_returns() -> None:
    wi, wo = upper_directions(2000, 1), upper_directions(2000, 2)
    theta_h, theta_d, phi_d = directions.half_difference(wi, wo)
    phi_h = directions.phi(wi + wo)
    i, o = directions.from_half_difference(theta_h, theta_d, phi_d, phi_h)
    assert_allclose(i, wi, rtol=0, atol=2e-14)
    assert_allclose(o, wo, rtol=0, atol=2e-14)


@given(theta_h=st.floats(1e-3, 1.5), theta_d=st.floats(1e-3, 1.5), phi_d=azimuths, phi_h=azimuths)
def test_half_difference_angles_return(theta_h: float, theta_d: float, phi_d: float, phi_h: float) -> None:
    wi, wo = directions.from_half_difference(theta_h, theta_d, phi_d, phi_h)
    assert_allclose(np.linalg.norm([wi, wo], axis=-1), 1, rtol=1e-15)
    assert_allclose(directions.half_difference(wi, wo), [theta_h, theta_d, phi_d], rtol=0, atol=1e-11)


def test_half_difference_by_definition() -> None:
    """cos(theta_h) = wh . n, cos(theta_d) = wi . wh; phi_d = 0 where wi lies on the far side of wh from the normal."""
    wi, wo = upper_directions(500, 1), upper_directions(500, 2)
    wh = wi + wo
    wh /= np.linalg.norm(wh, axis=-1, keepdims=True)
    theta_h, theta_d, _ = directions.half_difference(wi, wo)
    assert_allclose(np.cos(theta_h), wh[:, 2], rtol=1e-12)
    assert_allclose(np.cos(theta_d), np.sum(wi * wh, axis=-1), rtol=1e-9)
    _, _, phi_d = directions.half_difference(direction(0.9, 0.3), direction(0.1, 0.3))
    assert_allclose(phi_d, 0, atol=1e-12)


def test_half_difference_of_a_direction_with_itself_and_at_the_pole() -> None:
    w = direction(0.7, 0.4)
    theta_h, theta_d, _ = directions.half_difference(w, w)
    assert_allclose([theta_h, theta_d], [0.7, 0], atol=1e-15)
    theta_h, theta_d, _ = directions.half_difference(direction(0.4, 1.0), direction(0.4, 1.0 + np.pi))
    assert_allclose([theta_h, theta_d], [0, 0.4], atol=1e-15)
    assert np.isfinite(directions.half_difference(w, -w)).all()


# ---------------------------------------------------------------- Frames


def test_frames_are_orthonormal_and_right_handed() -> None:
    n = np.concatenate(
        [sphere(2000, 3), [[0, 0, 1], [0, 0, -1], [0, 0, 1.0]], sphere(5, 4) * [1e-9, 1e-9, 0] - [0, 0, 1]]
    )
    frames = directions.frame(n)
    assert_allclose(
        np.einsum("nij,nkj->nik", frames, frames), np.broadcast_to(np.eye(3), frames.shape), rtol=0, atol=1e-14
    )
    assert_allclose(np.linalg.det(frames), 1, rtol=1e-14)
    assert_allclose(frames[:, 2], n, rtol=0)


# ---------------------------------------------------------------- Geometry


def geometry(wi: NDArray[np.float64], wo: NDArray[np.float64]) -> Geometry:
    return Geometry(NUMPY, Vector.of(wi), Vector.of(wo))


def test_geometry_by_definition() -> None:
    wi, wo = upper_directions(3000, 1), upper_directions(3000, 2)
    g = geometry(wi, wo)
    theta_i, theta_r = (np.arctan2(np.hypot(w[:, 0], w[:, 1]), w[:, 2]) for w in (wi, wo))
    dphi = np.arctan2(wo[:, 1], wo[:, 0]) - np.arctan2(wi[:, 1], wi[:, 0])
    wh = (wi + wo) / np.linalg.norm(wi + wo, axis=-1, keepdims=True)
    dot = np.sum(wi * wo, axis=-1)
    alpha, beta = np.maximum(theta_i, theta_r), np.minimum(theta_i, theta_r)
    expected = {
        "theta_i": theta_i,
        "theta_r": theta_r,
        "sin_alpha": np.sin(alpha),
        "tan_beta": np.tan(beta),
        "tan_half": np.tan((alpha + beta) / 2),
        "cos_dphi": np.cos(dphi),
        "one_less_abs_cos_dphi": 1 - np.abs(np.cos(dphi)),
        "sin_alpha_less_cube": np.sin(alpha) - (2 * beta / np.pi) ** 3,
        "sin2_half_gamma": (1 + dot) / 2,
        "cos2_half_gamma": (1 - dot) / 2,
        "cos_theta_d": np.sum(wi * wh, axis=-1),
        "cos_theta_h": wh[:, 2],
        "sin_theta_h": np.hypot(wh[:, 0], wh[:, 1]),
        "theta_h": np.arctan2(np.hypot(wh[:, 0], wh[:, 1]), wh[:, 2]),
    }
    for name, value in expected.items():
        assert_allclose(getattr(g, name)[:, 0], value, rtol=1e-11, atol=1e-12, err_msg=name)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_differences_that_cancel_keep_their_digits(dtype: type) -> None:
    """Near the plane of incidence, 1 - |cos(dphi)|; at mutual grazing, sin(alpha) - (2 beta/pi)^3: given the rounded directions."""
    rng = np.random.default_rng(5)
    theta = np.pi / 2 - np.geomspace(1e-3, 1, 200)
    dphi = np.where(rng.random(200) < 0.5, 0, np.pi) + rng.choice([-1, 1], 200) * np.geomspace(1e-3, 1, 200)
    wi = directions.from_spherical(theta, 0.7).astype(dtype)
    wo = directions.from_spherical(np.flip(theta) ** 0.5 * theta**0.5, 0.7 + dphi).astype(dtype)
    g = geometry(wi, wo)
    with mp.workdps(30):
        for k in range(200):
            (xi, yi, zi), (xo, yo, zo) = ([mp.mpf(float(v)) for v in w[k]] for w in (wi, wo))
            si, so = mp.hypot(xi, yi), mp.hypot(xo, yo)
            beta = min(mp.atan2(si, zi), mp.atan2(so, zo))
            alpha = max(mp.atan2(si, zi), mp.atan2(so, zo))
            # In ulp; the cross product of nearly parallel vectors loses some, its square all that the cosine has.
            expected = {
                "one_less_abs_cos_dphi": (1 - abs((xi * xo + yi * yo) / (si * so)), 1000),
                "sin_alpha_less_cube": (mp.sin(alpha) - (2 * beta / mp.pi) ** 3, 30),
            }
            for name, (value, ulp) in expected.items():
                got = float(getattr(g, name)[k, 0])
                assert_allclose(got, float(value), rtol=ulp * np.finfo(dtype).eps, err_msg=f"{name} {k}")


def test_azimuth_means_nothing_at_normal_incidence() -> None:
    up = np.array([[0.0, 0.0, 1.0]])
    assert geometry(up, up).cos_dphi == 0
    assert geometry(up, direction(0.5)[None]).cos_dphi == 0


def test_grazing_tangents_are_finite_in_float32() -> None:
    """tan(acos(0)) is -2e7 in float32; sin / cos of clamped cosines is positive and finite."""
    flat = np.array([[1.0, 0.0, 0.0]], np.float32)
    g = geometry(flat, flat)
    assert np.isfinite(g.tan_beta).all()
    assert (g.tan_beta > 0).all()
    assert (g.tan_half > 0).all()


def test_what_is_below_the_horizon_is_0_and_nan_is_kept() -> None:
    up, down, nan = direction(0.3), direction(2.0), np.full(3, np.nan)
    for a, b, expected in ((up, up, 7.0), (up, down, 0.0), (down, up, 0.0), (nan, up, np.nan), (up, nan, np.nan)):
        assert_allclose(geometry(a, b).above_horizon(7.0), [expected])


@pytest.mark.parametrize("scale", [1e-300, 1.0, 1e308])
def test_a_vector_has_a_direction_whatever_its_length(scale: float) -> None:
    found = directions.unit(scale * np.array([0.0, -0.6, 0.8]))
    assert found is not None
    assert_allclose(found, [0, -0.6, 0.8], rtol=1e-12)


@pytest.mark.parametrize("vector", [(0, 0, 0), (np.nan, 0, 1), (0, -np.inf, 1)])
def test_some_vectors_have_no_direction(vector: tuple[float, ...]) -> None:
    assert directions.unit(vector) is None


@pytest.mark.parametrize("angle", [0.05, 0.4, 1.5])
def test_half_vectors_near_the_normal_are_those_of_half_difference(angle: float) -> None:
    rng = np.random.default_rng(5)
    count = directions.AT_ONCE + 100  # more than are looked at together
    wi, wo = (directions.from_spherical(rng.uniform(0, 1.57, count), rng.uniform(-3, 3, count)) for _ in range(2))
    wo[:500] = wi[:500] * (-1, -1, 1)  # near the mirror
    found = directions.half_vectors_within(angle, wi, wo)
    assert np.array_equal(found, directions.half_difference(wi, wo)[0] < angle)
    assert found.any()
    assert not found.all()
