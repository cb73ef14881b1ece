"""Samples and densities without compiling and through the engine, against the equations over NumPy as they stand."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.stats import chi2

from catalogue import ENTRIES, Entry, direction, upper_directions
from engine_support import risky_pairs
from motes.arrays import NUMPY, Array
from motes.certification.chi_square import Bins, chi_square
from motes.graph import recording
from motes.graph.recording import Kind
from motes.kernels import engine, immediate
from motes.models import BRDF, Lambert, OrenNayar, TorranceSparrow
from motes.models.base import Sampled
from motes.models.lifting import averaged, broadcast

entries = pytest.mark.parametrize("entry", ENTRIES, ids=str)
BY_NAME = {entry.name: entry.model for entry in ENTRIES}
DUSTY = BY_NAME["dust_layer"]
COMPILED = {name: BY_NAME[name] for name in ("rough_and_shiny", "beckmann", "dust_layer")}
compiled = pytest.mark.parametrize("model", COMPILED.values(), ids=COMPILED)


def density_as_printed(model: BRDF, wi: Array, wo: Array) -> NDArray[Any]:
    """The density by the lobes as they stand, over NumPy."""
    with np.errstate(all="ignore"):
        return np.asarray(averaged(model, wi).density(NUMPY, wi, wo))


def sample_as_printed(model: BRDF, wi: Array, u: Array) -> Sampled:
    """A sample by the lobes as they stand, over NumPy."""
    wi = broadcast(wi, (*np.broadcast_shapes(wi.shape[:-1], u.shape[:-1]), 3))
    mean = averaged(model, wi)
    with np.errstate(all="ignore"):
        wo = mean.drawn(NUMPY, wi, u)
        density = mean.density(NUMPY, wi, wo)
        return Sampled(wo, density, model.eval(wi, wo) * mean.weighing(NUMPY, wo, density)[..., None])


def numbers(n: int, seed: int) -> NDArray[np.float64]:
    return np.random.default_rng(seed).random((n, 2))


# ---------------------------------------------------------------- Without compiling


@entries
def test_samples_and_densities_are_those_of_the_lobes_as_they_stand(entry: Entry) -> None:
    wi, u = upper_directions(500, 1), numbers(500, 2)
    found = immediate.call(Kind.SAMPLE, entry.model, wi, u)
    assert found is not None
    for one, other in zip(found, sample_as_printed(entry.model, wi, u), strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-12, atol=1e-14)
    for name, (a, b) in risky_pairs(200, 3).items():
        densities = immediate.call(Kind.DENSITY, entry.model, a, b)
        assert densities is not None
        np.testing.assert_allclose(densities[0], density_as_printed(entry.model, a, b), rtol=1e-12, err_msg=name)


@entries
@pytest.mark.parametrize("scalar", [np.float32, np.float64])
def test_a_sample_is_the_same_bits_in_any_company(entry: Entry, scalar: type) -> None:
    n = immediate.BLOCK + 5
    wi, u = upper_directions(n, 4).astype(scalar), numbers(n, 5).astype(scalar)
    many = entry.model.sample(wi, u)
    assert {x.dtype for x in many} == {np.dtype(scalar)}
    densities = entry.model.pdf(wi, many.wo)
    for k in (0, 3, n - 1):
        for one, all_ in zip(entry.model.sample(wi[k], u[k]), many, strict=True):
            np.testing.assert_array_equal(one, all_[k])
        np.testing.assert_array_equal(entry.model.pdf(wi[k], many.wo[k]), densities[k])


def test_what_symbols_cannot_follow_is_sampled_as_it_stands(monkeypatch: pytest.MonkeyPatch) -> None:
    wi, u = upper_directions(30, 6), numbers(30, 7)
    paint = OrenNayar((0.2, 0.3, 0.4), 0.3) + TorranceSparrow(0.4, 0.2)
    expected, density = paint.sample(wi, u), paint.pdf(wi, wi)
    monkeypatch.setattr(immediate, "_ready", lambda kind, model: None)
    monkeypatch.setattr(recording, "_recorded", {})
    monkeypatch.setattr(recording, "_RECORDERS", {})
    monkeypatch.setattr(engine, "THRESHOLD", 1)
    for one, other in zip(paint.sample(wi, u), expected, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(paint.pdf(wi, wi), density, rtol=1e-12)


# ---------------------------------------------------------------- Through the engine


@pytest.fixture
def llvm() -> None:
    pytest.importorskip("llvmlite")


@compiled
@pytest.mark.usefixtures("llvm")
def test_densities_of_the_engine_are_those_of_numpy(model: BRDF) -> None:
    for name, (wi, wo) in risky_pairs(2000, 8).items():
        found, expected = engine.density(model, wi, wo), density_as_printed(model, wi, wo)
        assert found.shape == (2000,)
        assert (np.abs(found - expected) <= 1e-12 * np.maximum(np.abs(expected), 0.01)).all(), name


@compiled
@pytest.mark.usefixtures("llvm")
def test_samples_of_the_engine_are_those_of_numpy(model: BRDF) -> None:
    n = 70_000  # several chunks
    wi, u = upper_directions(n, 9), numbers(n, 10)
    wo, density, weight = engine.sample(model, wi, u)
    expected = sample_as_printed(model, wi, u)
    # A number that is close to 1 where a lobe's tail begins moves a sample by more than it is rounded by itself.
    assert np.abs(wo - expected.wo).max() < 1e-8
    assert np.quantile(np.abs(wo - expected.wo).max(axis=1), 0.99) < 1e-12
    np.testing.assert_allclose(np.sum(wo * wo, axis=-1), 1, atol=1e-7 if model is COMPILED["beckmann"] else 1e-12)
    # What goes with a direction belongs to that direction.
    again, value = engine.density(model, wi, wo), model.eval(wi, wo)
    np.testing.assert_allclose(density, again, rtol=1e-9, atol=1e-12)
    scale = np.where(density > 0, np.maximum(wo[:, 2], 0) / np.maximum(density, 1e-30), 0)
    np.testing.assert_allclose(weight, value * scale[:, None], rtol=1e-9, atol=1e-12)


@pytest.mark.usefixtures("llvm")
def test_float32_is_near_float64() -> None:
    wi, u = upper_directions(20_000, 11).astype(np.float32), numbers(20_000, 12).astype(np.float32)
    wo, density, weight = engine.sample(DUSTY, wi, u)
    assert wo.dtype == density.dtype == weight.dtype == np.float32
    exact = engine.sample(DUSTY, wi.astype(float), u.astype(float))
    assert np.quantile(np.abs(wo - exact[0]).max(axis=1), 0.99) < 1e-5
    inside = density > 0
    np.testing.assert_allclose(density[inside], engine.density(DUSTY, wi, wo)[inside], rtol=2e-4)


@compiled
@pytest.mark.usefixtures("llvm")
def test_the_engines_samples_have_their_density(model: BRDF) -> None:
    wi, n = direction(0.7, 0.4), 40_000
    bins = Bins.of(engine.sample(model, wi, numbers(n, 13))[0])
    counts = bins.count(engine.sample(model, wi, numbers(n, 14))[0])
    share = bins.integrate(lambda directions: density_as_printed(model, wi, directions))
    observed = np.append(counts, n - counts.sum())
    statistic, freedom = chi_square(observed, n * np.append(share, max(1 - share.sum(), 1e-6 / n)))
    assert freedom >= 30
    assert chi2.sf(statistic, freedom) > 1e-4


@pytest.mark.usefixtures("llvm")
def test_layouts_threads_and_company_change_no_bit(monkeypatch: pytest.MonkeyPatch) -> None:
    n = 70_000
    wi, u = upper_directions(n, 14), numbers(n, 15)
    first = engine.sample(DUSTY, wi, u)
    rows = engine.sample(DUSTY, np.ascontiguousarray(wi.T).T, np.ascontiguousarray(u.T).T)
    assert rows[0].strides[0] == 8, "rows in, rows out"
    part = engine.sample(DUSTY, wi[40_000:40_003], u[40_000:40_003])
    monkeypatch.setenv("NUMBA_NUM_THREADS", "1")
    alone = engine.sample(DUSTY, wi, u)
    for x, *others, y in zip(first, rows, alone, part, strict=True):
        for other in others:
            np.testing.assert_array_equal(x, other)
        np.testing.assert_array_equal(x[40_000:40_003], y)
    one = engine.sample(DUSTY, wi[0], u[:100].reshape(4, 25, 2))
    assert [x.shape for x in one] == [(4, 25, 3), (4, 25), (4, 25, DUSTY.channels)]
    for x, y in zip(one, engine.sample(DUSTY, np.tile(wi[0], (100, 1)), u[:100]), strict=True):
        np.testing.assert_array_equal(x.reshape(y.shape), y)


@pytest.mark.usefixtures("llvm")
def test_parameters_that_vary_and_no_directions() -> None:
    colours = np.random.default_rng(16).uniform(0.1, 0.9, (50, 3))
    model = OrenNayar(K_d=colours, sigma_d=0.3) + TorranceSparrow(K_s=0.3, sigma_s=np.linspace(0.1, 0.4, 50))
    wi, u = upper_directions(50, 17), numbers(50, 18)
    for x, y in zip(engine.sample(model, wi, u), sample_as_printed(model, wi, u), strict=True):
        np.testing.assert_allclose(x, y, rtol=1e-9, atol=1e-11)
    wo = upper_directions(50, 19)
    np.testing.assert_allclose(engine.density(model, wi, wo), density_as_printed(model, wi, wo), rtol=1e-12)
    assert [x.shape for x in engine.sample(DUSTY, wi[:0], u[:0])] == [(0, 3), (0,), (0, DUSTY.channels)]
    assert engine.density(DUSTY, wi[:0], wo[:0]).shape == (0,)


@pytest.mark.usefixtures("llvm")
def test_nan_comes_out_where_numpy_has_it() -> None:
    wi, wo = upper_directions(6, 20), upper_directions(6, 21)
    for k in range(6):
        (wi if k < 3 else wo)[k, k % 3] = np.nan
    np.testing.assert_array_equal(np.isnan(engine.density(DUSTY, wi, wo)), np.isnan(density_as_printed(DUSTY, wi, wo)))


@pytest.mark.usefixtures("llvm")
def test_many_samples_go_through_the_engine(monkeypatch: pytest.MonkeyPatch) -> None:
    seen = []
    monkeypatch.setattr(engine, "THRESHOLD", 4)
    monkeypatch.setattr(engine, "sample", lambda *given: seen.append("sample") or (1, 2, 3))
    monkeypatch.setattr(engine, "density", lambda *given: seen.append("density"))
    wi, u = upper_directions(20, 22), numbers(20, 23)
    assert Lambert(0.5).sample(wi, u) == (1, 2, 3)
    Lambert(0.5).pdf(wi, wi)
    assert seen == ["sample", "density"]
    Lambert(0.5).pdf(wi[:19], wi[:19])
    assert len(seen) == 2, "it takes five times as many as for values"
