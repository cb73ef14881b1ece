"""The photon Monte Carlo that judges dust is right itself: discrete ordinates, closed forms, and another program's volume paths."""

from __future__ import annotations

import csv
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import photons
from catalogue import direction
from motes import Lambert, OrenNayar, TorranceSparrow
from motes.directions import from_spherical
from motes.rendering import load_mitsuba
from photons import Layer
from plugin_support import needs_llvm, slab

Floats = NDArray[np.float64]
BLACK = Lambert(0.0)
GLOSSY = Lambert(0.2) + TorranceSparrow(K_s=0.15, sigma_s=0.3)
MIRRORWARDS = from_spherical(np.array([0.3, 0.6, 0.9, 0.5]), np.array([np.pi, np.pi, 2.5, 0.3]))


def agrees(estimate: photons.Estimate, expected: Any, rounding: float = 0.0) -> None:
    """Within 4 standard errors, and `rounding` of the expected value; errors that are too large would hide anything."""
    expected = np.asarray(expected)
    allowed = 4 * estimate.error + rounding * abs(expected) + 1e-9
    assert np.all(abs(estimate.value - expected) < allowed), f"{estimate} instead of {expected}"


# ---------------------------------------------------------------- Against discrete ordinates


def test_discrete_ordinates(shared: Callable[[str], Path]) -> None:
    """Rows of the reference table: each within 4 standard errors, and all together scattered as standard errors say."""
    with shared("golden/dust_layer_exact.csv").open(encoding="utf-8") as file:
        rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)][3::19]
    apart, relative = [], []
    for row in rows:
        layer = Layer(Lambert(row["base"]), row["tau"], row["w"], row["g"])
        wi, wo = from_spherical(row["theta_i"], 0.0), from_spherical(row["theta_r"], row["dphi"])
        brdf, albedo = photons.brdf(layer, wi, wo, 2**14), photons.albedo(layer, wi, 2**14, seed=2)
        agrees(brdf, row["brdf"], rounding=2e-3)  # of the table, on purpose: see its README
        agrees(albedo, row["albedo"], rounding=1e-5)
        apart += [brdf.apart(row["brdf"])[0], albedo.apart(row["albedo"])]
        relative.append(brdf.error[0] / row["brdf"])
    assert len(rows) == 42
    assert 0.8 < np.sqrt(np.mean(np.square(apart))) < 1.25
    assert np.median(relative) < 0.01


@pytest.mark.parametrize("g", [-0.4, 0.6])
def test_discrete_ordinates_over_a_glossy_base(g: float) -> None:
    """The highlight by Fourier modes of its BRDF, which is what that program calls a base; viewers at its own nodes."""
    pytest.importorskip("PythonicDISORT")
    from discrete_ordinates import layer

    tau, w, theta_i = 0.5, 0.9, 0.6
    solution = layer(GLOSSY, tau, w, g, theta_i)
    chosen = np.flatnonzero((solution.cosines > 0.3) & (solution.cosines < 0.97))[::4]
    azimuths = np.pi - np.array([0.0, 0.4, 2.0])
    viewers = from_spherical(np.arccos(solution.cosines[chosen])[:, None], azimuths).reshape(-1, 3)
    brdf, albedo = photons.both(Layer(GLOSSY, tau, w, g), from_spherical(theta_i, 0.0), viewers, 2**16)
    agrees(brdf, solution.brdf(azimuths)[chosen].ravel(), rounding=5e-3)
    agrees(albedo, solution.albedo, rounding=1e-3)


# ---------------------------------------------------------------- Against closed forms


@pytest.mark.parametrize("g", [-0.5, 0.0, 0.85])
@pytest.mark.parametrize("tau", [0.3, 4.0, np.inf])
def test_one_scattering(tau: float, g: float) -> None:
    """Photons that are given up after one event have scattered once: w P/(4 (mu_i + mu_r)) (1 - exp(-tau (1/mu_i + 1/mu_r)))."""
    wi, wo, w = from_spherical(0.7, 0.0), MIRRORWARDS, 0.8
    phase = (1 - g**2) / (4 * np.pi * (1 + g**2 + 2 * g * (wo @ wi)) ** 1.5)
    expected = w * phase / (wi[2] + wo[:, 2]) * -np.expm1(-tau * (1 / wi[2] + 1 / wo[:, 2]))
    agrees(photons.brdf(Layer(BLACK, tau, w, g), wi, wo, orders=1), expected)


def test_thin_layers() -> None:
    """All orders together differ from one scattering by what is of the order of tau log tau."""
    wi, wo = from_spherical(0.5, 0.0), MIRRORWARDS
    for tau in (1e-3, 1e-2):
        every = photons.brdf(Layer(BLACK, tau, 0.9, 0.3), wi, wo)
        once = photons.brdf(Layer(BLACK, tau, 0.9, 0.3), wi, wo, orders=1)
        more = every.value / once.value - 1
        assert np.all((more > 0) & (more < 6 * tau * np.log(1 / tau))), f"tau = {tau}: {more}"


def h_function(w: float, mu: Floats) -> Floats:
    """Chandrasekhar's H for isotropic scattering: 1/H(mu) = sqrt(1 - w) + w/2 int x H(x)/(x + mu) dx, by iteration."""
    x, weights = np.polynomial.legendre.leggauss(64)
    x, weights = 0.5 * (x + 1), 0.5 * weights
    h = np.ones(64)
    for _ in range(2000):
        h = 0.5 * h + 0.5 / (np.sqrt(1 - w) + 0.5 * w * ((x * h * weights) / (x[:, None] + x)).sum(1))
    return 1 / (np.sqrt(1 - w) + 0.5 * w * ((x * h * weights) / (x + np.atleast_1d(mu)[:, None])).sum(1))


@pytest.mark.parametrize("w", [0.5, 0.95, 1.0])
def test_isotropic_half_space(w: float) -> None:
    """f = w/(4 pi) H(mu_i) H(mu_r)/(mu_i + mu_r), albedo 1 - H(mu_i) sqrt(1 - w) (Chandrasekhar 1950)."""
    if w == 1:
        np.testing.assert_allclose(h_function(1.0, np.array([1.0])), 2.9078, atol=5e-5)  # his table
    wi, wo = from_spherical(0.8, 0.0), MIRRORWARDS
    seen, albedo = photons.both(Layer(BLACK, np.inf, w, 0.0), wi, wo, 2**15)
    h = h_function(w, np.append(wo[:, 2], wi[2]))
    agrees(seen, w / (4 * np.pi) * h[:-1] * h[-1] / (wo[:, 2] + wi[2]))
    agrees(albedo, 1 - h[-1] * np.sqrt(1 - w))


@pytest.mark.parametrize("base", [OrenNayar(0.6, 0.5), GLOSSY], ids=["rough", "glossy"])
def test_no_dust_is_the_base(base: Any) -> None:
    wi = from_spherical(0.6, 0.0)
    for w in (0.0, 1.0):
        seen, albedo = photons.both(Layer(base, 0.0, w, 0.3), wi, MIRRORWARDS, 2**15)
        np.testing.assert_allclose(seen.value, base.eval(wi, MIRRORWARDS)[:, 0], rtol=1e-13)
        agrees(albedo, base.directional_albedo(wi)[0], rounding=1e-4)
        assert albedo.error < 0.005


@pytest.mark.parametrize("tau", [0.05, 1.0, 8.0, np.inf])
@pytest.mark.parametrize("g", [0.0, 0.7])
def test_white_furnace(tau: float, g: float) -> None:
    """Nothing is lost where nothing absorbs: dust with w = 1 over white, at any angle."""
    for theta in (0.1, 1.4):
        albedo = photons.albedo(Layer(Lambert(1.0), tau, 1.0, g), from_spherical(theta, 0.0), 2**13)
        agrees(albedo, 1.0)
        assert albedo.error < 0.02


@pytest.mark.parametrize("tau", [0.2, 2.0])
def test_reciprocity(tau: float) -> None:
    """The same from both ends, of photons that have nothing in common: the swap of `brdf` is allowed."""
    layer, wi = Layer(GLOSSY, tau, 0.9, 0.6), from_spherical(0.9, 0.0)
    there = photons.brdf(layer, wi, MIRRORWARDS, swap=False)
    for k, wo in enumerate(MIRRORWARDS):
        back = photons.brdf(layer, wo, wi, swap=False, seed=100 + k)
        apart = (there.value[k] - back.value[0]) / np.hypot(there.error[k], back.error[0])
        assert abs(apart) < 4


def test_albedo_is_the_integral_of_the_brdf() -> None:
    """Two estimators of one thing: photons that leave, and the quadrature over the hemisphere of what viewers are shown."""
    layer, wi = Layer(GLOSSY, 0.7, 0.9, 0.4), from_spherical(0.5, 0.0)
    x, weights = np.polynomial.legendre.leggauss(12)
    mu, azimuth = 0.5 * (x + 1), (np.arange(16) + 0.5) * np.pi / 16
    wo = from_spherical(np.arccos(mu)[:, None], azimuth).reshape(-1, 3)
    seen, albedo = photons.both(layer, wi, wo, 2**15)
    integral = float(seen.value.reshape(12, 16).mean(1) @ (weights * mu) * np.pi)
    np.testing.assert_allclose(integral, albedo.value, atol=0.004)


# ---------------------------------------------------------------- What it promises of itself


def test_the_same_from_any_number_of_threads() -> None:
    layer, wi = Layer(GLOSSY, 0.5, 0.9, 0.6), direction(0.8)
    one, two, three = (photons.both(layer, wi, MIRRORWARDS, 2**12, threads=n) for n in (1, 2, 3))
    other = photons.both(layer, wi, MIRRORWARDS, 2**12, seed=2)
    for a, b, c, d in zip(one, two, three, other, strict=True):
        np.testing.assert_array_equal([b.value, c.value], [a.value, a.value])
        assert np.all(d.value != a.value)


def test_pairs_are_the_same_brdf() -> None:
    """The mean over many pairs of the same directions, of few photons each; the light comes from either side of the pair."""
    layer, wi = Layer(GLOSSY, 0.5, 0.9, 0.6), from_spherical(0.6, 0.0)
    for wo in MIRRORWARDS[:3]:
        for a, b in ((wi, wo), (wo, wi)):
            values = photons.pairs(layer, np.tile(a, (512, 1)), np.tile(b, (512, 1)), 64)
            found = photons.Estimate(values.mean(), values.std(ddof=1) / np.sqrt(512))
            agrees(found, photons.brdf(layer, wi, wo, 2**17).value[0], rounding=2e-3)


def test_errors_are_what_they_say() -> None:
    """The scatter of many small runs is the error that each of them states."""
    layer, wi = Layer(GLOSSY, 0.5, 0.9, 0.6), from_spherical(0.6, 0.0)
    runs = [photons.brdf(layer, wi, MIRRORWARDS, 2**9, seed=10 + k) for k in range(100)]
    scatter = np.std([run.value for run in runs], axis=0, ddof=1)
    stated = np.sqrt(np.mean([run.error**2 for run in runs], axis=0))
    np.testing.assert_allclose(scatter, stated, rtol=0.3)


# ---------------------------------------------------------------- Against another renderer


@needs_llvm
@pytest.mark.parametrize(("g", "tau"), [(0.6, 1.0), (-0.3, 0.3)])
def test_volume_paths(g: float, tau: float) -> None:
    """Mitsuba's `volpath` in a slab so wide that nothing leaves at its sides; every pixel sees the same."""
    load_mitsuba("llvm_ad_rgb")
    w, albedo = 0.9, 0.5
    theta_i, theta_r, dphi = 0.6, 0.9, 2.6
    wi, wo = from_spherical(theta_i, 0.0), from_spherical(theta_r, dphi)
    base = {"type": "diffuse", "reflectance": {"type": "rgb", "value": albedo}}
    phase = {"type": "hg", "g": g}
    dust = {"type": "homogeneous", "sigma_t": tau, "albedo": {"type": "rgb", "value": w}, "phase": phase}
    pixels = slab(base, dust, wi, wo, 512)[:, 0]
    theirs, error = pixels.mean(), pixels.std(ddof=1) / np.sqrt(pixels.size)
    ours = photons.brdf(Layer(Lambert(albedo), tau, w, g), wi, wo)
    assert error < 0.01 * theirs
    assert abs(ours.value[0] - theirs) < 4 * np.hypot(error, ours.error[0])
