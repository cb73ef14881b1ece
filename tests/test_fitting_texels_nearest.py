"""The start that suits a texel best, by matrix products: what a fit of the free columns would leave, and the same bits in any company."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import motes
from motes.fitting.scans import single
from motes.fitting.texels import TexelSolver, TexelStatus
from motes.fitting.texels_nearest import TASK, Nearest
from motes.fitting.texels_slow import problem_of

MODEL = "oren_nayar + torrance_sparrow"
# In the order of the columns: K_d of three channels, sigma_d squared, K_s, sigma_s.
STARTS = np.array([[0.3, 0.3, 0.3, 0.04, 0.2, 0.15], [0.5, 0.4, 0.3, 0.25, 0.05, 0.5], [0.2, 0.2, 0.6, 0.0, 0.6, 0.08]])
HELD = np.array([False, False, False, True, False, True])


def solver(count: int = 20, weights: NDArray[np.float64] | None = None, loss: str = "linear") -> TexelSolver:
    rng = np.random.default_rng(3)
    z, phi = rng.uniform(0.25, 1, (2, count)), rng.uniform(-np.pi, np.pi, (2, count))
    wi, wo = np.stack([np.sqrt(1 - z**2) * np.cos(phi), np.sqrt(1 - z**2) * np.sin(phi), z], axis=-1)
    return TexelSolver(MODEL, wi, wo, 3, weights=weights, loss=loss)


def texels(fit: TexelSolver, count: int, noise: float = 0.02) -> NDArray[np.float32]:
    """Of surfaces like the starts, and of some whose highlight is darker than none."""
    rng = np.random.default_rng(5)
    K_d, K_s = rng.uniform(0.05, 0.7, (count, 1, 3)), rng.uniform(-0.02, 0.6, (count, 1))
    which = rng.integers(0, len(STARTS), (count, 1))
    diffuse = motes.OrenNayar(K_d, np.sqrt(STARTS[which, 3])).eval(fit.wi, fit.wo)
    shine = motes.TorranceSparrow(1.0, STARTS[which, 5]).eval(fit.wi, fit.wo)
    f = diffuse + K_s[..., None] * shine
    return np.asarray(f * (1 + noise * rng.standard_normal(f.shape)), np.float32)


@pytest.mark.parametrize("loss", ["linear", "plain"])
def test_the_start_is_the_one_from_which_a_fit_with_its_width_and_roughness_held_leaves_least(loss: str) -> None:
    fit = solver(weights=np.linspace(0.5, 2.0, 20), loss=loss)
    data = texels(fit, 40)
    found, _ = Nearest(fit, STARTS, HELD).points(data)
    for texel, point in zip(data, found, strict=True):
        problem = single(problem_of(fit, texel[None]), 0)
        left = problem.solve(STARTS, held=HELD).normal.objective  # by the solver of `motes.fit`
        at = problem.normal(point[None]).objective[0]
        # In K_d the model is not quite linear: light between facets goes with its square.
        assert at <= 1.1 * left.min() + 1e-3 * problem.brightness().sum()
        assert ((point >= fit.facts.low[:, 0]) & (point <= fit.facts.high[:, 0])).all()
        assert any((point[HELD] == start[HELD]).all() for start in STARTS)


@pytest.mark.parametrize("loss", ["log", "cube_root"])
def test_losses_that_bend_find_the_same_valley_by_the_linear_one(loss: str) -> None:
    fit = solver(60, loss=loss)
    data, starts = texels(fit, 60), fit.values(STARTS)
    found = fit.fit(data, starts)
    each = [fit.fit(data, np.repeat(start[None], len(data), axis=0), own_starts=True) for start in starts]
    kernel = fit.kernel("direct")

    def left(x: NDArray[np.float32]) -> NDArray[np.float64]:
        points = fit.coordinates(np.clip(x.astype(float), *fit.bounds))
        return kernel.fit(data, points, limit=0, close=False).state("objective")  # type: ignore[union-attr]

    least = np.min([left(one.x) for one in each], axis=0)
    assert np.mean(left(found.x) <= least * (1 + 1e-4)) > 0.97
    assert fit.linear.loss.name == "linear"
    assert fit.in_units(4.0).linear.unit == 4.0
    assert solver(loss="plain").linear.loss.name == "plain"


def test_without_noise_a_texel_takes_the_start_that_has_its_width() -> None:
    fit = solver(60)
    K_d = np.array([0.3, 0.2, 0.5])
    for k, start in enumerate(STARTS):
        brdf = motes.OrenNayar(K_d, float(np.sqrt(start[3]))) + motes.TorranceSparrow(0.4, float(start[5]))
        found, _ = Nearest(fit, STARTS, HELD).points(brdf.eval(fit.wi, fit.wo)[None].astype(np.float32))
        np.testing.assert_array_equal(found[0][HELD], STARTS[k][HELD])
        np.testing.assert_allclose(found[0][[0, 1, 2, 4]], [*K_d, 0.4], rtol=0.03)


def test_bits_do_not_depend_on_what_else_is_in_the_call(monkeypatch: pytest.MonkeyPatch) -> None:
    fit = solver()
    data = texels(fit, 2 * TASK + 777)
    nearest = Nearest(fit, STARTS, HELD)
    whole, _ = nearest.points(data)
    np.testing.assert_array_equal(nearest.points(data[100:101])[0], whole[100:101])
    np.testing.assert_array_equal(nearest.points(data[3:4500])[0], whole[3:4500])
    data[7, 3, 1], data[4400, 0, 0] = np.nan, -np.inf
    spoilt, missing = nearest.points(data)
    assert np.flatnonzero(missing).tolist() == [7, 4400]
    np.testing.assert_array_equal(spoilt[~missing], whole[~missing])
    monkeypatch.setenv("NUMBA_NUM_THREADS", "1")
    np.testing.assert_array_equal(nearest.points(data)[0][~missing], whole[~missing])


def test_a_texel_that_misses_a_sample_takes_its_start_as_before() -> None:
    fit = solver()
    data = texels(fit, 6)
    starts = fit.values(STARTS)
    alone = fit.fit(data[:1], starts)
    data[1:, 4, 1] = np.nan
    together = fit.fit(data, starts)
    np.testing.assert_array_equal(together.x[:1], alone.x)
    assert (together.status == 0).all()


def test_where_no_texel_is_whole_there_is_nothing_to_compare() -> None:
    """A block of a map without data, or no texels at all."""
    fit = solver()
    empty = fit.fit(np.full((5, 20, 3), np.nan, np.float32), STARTS)
    assert empty.status.tolist() == [TexelStatus.NO_DATA] * 5
    assert Nearest(fit, STARTS, HELD).points(np.zeros((0, 20, 3), np.float32))[0].shape == (0, 6)
