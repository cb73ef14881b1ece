"""Sampling: `sample` follows `pdf` (chi-square), weights are eval cos / pdf, and integrals by sampling are the integrals."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose
from numpy.typing import NDArray
from scipy.stats import chi2

from catalogue import COAT, ENTRIES, Entry, direction, upper_directions
from motes.certification.chi_square import Bins, chi_square, sidak
from motes.kernels import engine
from motes.models import BRDF, Lambert, Sampled, TorranceSparrow

ANGLES = (0.0, 0.9, 1.4)
SAMPLES = 40_000
# All the tests together fail by chance in one of a hundred worlds (Sidak); the seeds are fixed, so that this is not a thing of luck.
SIGNIFICANCE = sidak(0.01, len(ENTRIES) * len(ANGLES))

every_entry = pytest.mark.parametrize("entry", ENTRIES, ids=str)
every_angle = pytest.mark.parametrize("theta_i", ANGLES)


@pytest.fixture(autouse=True)
def by_the_equations(monkeypatch: pytest.MonkeyPatch) -> None:
    """The tests of the engine compare it with NumPy; here nothing is compiled."""
    monkeypatch.setattr(engine, "THRESHOLD", 10**18)


def draw(model: BRDF, wi: NDArray[np.float64], seed: int, n: int = SAMPLES) -> Sampled:
    return model.sample(wi, np.random.default_rng(seed).random((n, 2)))


# ---------------------------------------------------------------- The chi-square test


@every_angle
@every_entry
def test_samples_follow_the_density(entry: Entry, theta_i: float) -> None:
    """Over the hemisphere, with the samples lost below the horizon as a bin of their own: what the density lacks to 1."""
    wi = direction(theta_i, 0.5)
    bins = Bins.of(draw(entry.model, wi, 1).wo)
    wo = draw(entry.model, wi, 2).wo
    share = bins.integrate(lambda directions: entry.model.pdf(wi, directions))
    counts = bins.count(wo)
    lost = SAMPLES - counts.sum()
    assert share.sum() <= 1 + 2e-5
    statistic, freedom = chi_square(
        np.append(counts, lost), SAMPLES * np.append(share, max(1 - share.sum(), 1e-6 / SAMPLES))
    )
    assert freedom >= 30
    assert chi2.sf(statistic, freedom) > SIGNIFICANCE, f"chi-square {statistic:.0f} for {freedom} degrees of freedom"


def test_the_chi_square_test_sees_a_density_that_is_2_percent_off() -> None:
    """The test itself can fail: a highlight 2 % wider than its density."""
    wi = direction(0.9, 0.5)
    narrow, wide = TorranceSparrow(0.3, 0.15), TorranceSparrow(0.3, 0.153)
    bins, wo = Bins.of(draw(narrow, wi, 1).wo), draw(wide, wi, 2).wo
    share = bins.integrate(lambda directions: narrow.pdf(wi, directions))
    statistic, freedom = chi_square(bins.count(wo), SAMPLES * share)
    assert chi2.sf(statistic, freedom) < SIGNIFICANCE


# ---------------------------------------------------------------- Weights


@every_angle
@every_entry
def test_weight_is_eval_cos_over_pdf(entry: Entry, theta_i: float) -> None:
    wi = direction(theta_i, 0.5)
    wo, pdf, weight = draw(entry.model, wi, 3, 500)
    assert_allclose(np.linalg.norm(wo, axis=-1), 1, rtol=1e-12)
    assert_allclose(pdf, entry.model.pdf(wi, wo), rtol=1e-12)
    kept = wo[:, 2] > 0
    assert np.all(pdf[kept] > 0)
    expected = entry.model.eval(wi, wo[kept]) * wo[kept, 2:] / pdf[kept, None]
    assert_allclose(weight[kept], expected, rtol=1e-12)
    assert np.all(pdf[~kept] == 0)
    assert np.all(weight[~kept] == 0)


@every_angle
@every_entry
def test_the_mean_weight_is_the_directional_albedo(entry: Entry, theta_i: float) -> None:
    wi = direction(theta_i, 0.5)
    weight = draw(entry.model, wi, 4).weight
    standard_error = weight.std(axis=0) / np.sqrt(SAMPLES)
    unit = 4 * np.pi if not entry.reciprocal else 1.0
    # 1.1e-4 is the largest error of the quadrature at these angles (docs/accuracy.md).
    assert np.all(np.abs(weight.mean(axis=0) - entry.model.directional_albedo(wi)) < 4 * standard_error + 1.1e-4 * unit)
    assert np.all(standard_error < 0.02 * unit)


@every_entry
def test_many_lights_at_once(entry: Entry) -> None:
    wi, u = upper_directions(6, 5), np.random.default_rng(6).random((4, 6, 2))
    many = entry.model.sample(wi, u)
    assert many.wo.shape == (4, 6, 3)
    assert many.pdf.shape == (4, 6)
    assert many.weight.shape == (4, 6, entry.model.channels)
    for j, k in ((0, 0), (3, 5), (2, 1)):
        for a, b in zip(many, entry.model.sample(wi[k], u[j, k]), strict=True):
            assert_allclose(a[j, k], b, rtol=1e-9, atol=1e-12)


def test_a_narrow_highlight_is_found_where_cosine_sampling_misses_it() -> None:
    wi = direction(0.6)
    highlight = TorranceSparrow(1.0, 0.03, normalization="facets")
    own = draw(highlight, wi, 7).weight
    wo = draw(Lambert(1.0), wi, 7).wo
    by_cosine = highlight.eval(wi, wo) * np.pi
    assert by_cosine.var() > 100 * own.var()


def test_a_mixture_spends_its_samples_on_what_reflects() -> None:
    """A dim surface under a bright coat, and the reverse."""
    wi = direction(0.6)
    near = direction(0.6, np.pi)
    for K_d, K_s, more in ((0.001, 1.0, True), (0.9, 1e-3, False)):
        wo = draw(Lambert(K_d) + COAT.with_parameters({"K_s": K_s}), wi, 8).wo
        assert bool(np.mean(wo @ near > np.cos(0.5)) > 0.7) is more


def test_samples_in_the_dark_are_numbers() -> None:
    black = Lambert(0.0) + TorranceSparrow(0.0, 0.1)
    wo, pdf, weight = draw(black, direction(0.5), 9, 100)
    assert np.isfinite(wo).all()
    assert np.all((pdf > 0) == (wo[:, 2] > 0))
    assert np.all(weight == 0)
