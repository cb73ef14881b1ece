"""Texels with gross outliers under the squared loss: no fit ends above SciPy's best by more than 0.1 %."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import least_squares

import motes
from fitting_oracle import Oracle
from motes.fitting import texels as module
from motes.fitting.metrics import MEDIAN_TO_DEVIATION, deviation
from motes.fitting.printed import driver
from motes.fitting.texels import Raw, TexelSolver

Floats = NDArray[np.float64]
PAINT = "oren_nayar + torrance_sparrow"
COUNT, DIRECTIONS = 600, 24


def _directions() -> tuple[Floats, Floats]:
    """Every other pair near the mirror direction."""
    rng = np.random.default_rng(3)
    z, phi = rng.uniform(0.3, 0.98, 8 * DIRECTIONS), rng.uniform(0, 2 * np.pi, 8 * DIRECTIONS)
    w = np.stack([np.sqrt(1 - z * z) * np.cos(phi), np.sqrt(1 - z * z) * np.sin(phi), z], axis=1)
    wi, wo = w[: 4 * DIRECTIONS], w[4 * DIRECTIONS :].copy()
    near = wi[::2] * [-1, -1, 1] + rng.normal(0, 0.25, (2 * DIRECTIONS, 3))
    wo[::2] = near / np.linalg.norm(near, axis=1, keepdims=True)
    good = wo[:, 2] > 0.2
    return wi[good][:DIRECTIONS], wo[good][:DIRECTIONS]


WI, WO = _directions()


@cache
def _texels() -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """The same texels with 2 % noise, and with 5 % of the samples far off besides."""
    rng = np.random.default_rng(31)
    x = rng.uniform([0.1, 0.1, 0.1, 0.1, 0.05, 0.1], [0.9, 0.9, 0.9, 0.8, 0.5, 0.4], (COUNT, 6))
    values = {"K_d": x[:, None, :3], "sigma_d": x[:, 3:4], "K_s": x[:, 4][:, None, None], "sigma_s": x[:, 5:6]}
    surface = (motes.OrenNayar() + motes.TorranceSparrow()).with_parameters(values)
    clean = surface.eval(WI, WO) * (1 + 0.02 * rng.standard_normal((COUNT, DIRECTIONS, 3)))
    spoilt, bad = clean.copy(), rng.random(clean.shape) < 0.05
    spoilt[bad] *= rng.choice([0.1, 3.0, 5.0], bad.sum())
    return clean.astype(np.float32), spoilt.astype(np.float32)


@cache
def _solver() -> tuple[TexelSolver, Floats]:
    solver = TexelSolver(PAINT, WI, WO, 3)
    return solver, solver.starts(_texels()[1][::20])


def _without(
    solver: TexelSolver, values: NDArray[np.float32], starts: Floats, monkeypatch: pytest.MonkeyPatch
) -> Floats:
    """The residual of each texel where outliers are given no second try."""
    with monkeypatch.context() as patch:
        patch.setattr(module, "MISFIT", np.inf)
        return solver.fit(values, starts).relative_rms.astype(float) ** 2


def test_no_fit_ends_above_the_best_that_scipy_finds(monkeypatch: pytest.MonkeyPatch) -> None:
    """SciPy starts where the map does; texels that one start alone leaves in another valley are among those compared."""
    solver, starts = _solver()
    values = _texels()[1]
    fit = solver.fit(values, starts)
    squares = fit.relative_rms.astype(float) ** 2
    helped = np.flatnonzero(_without(solver, values, starts, monkeypatch) > 1.001 * squares)
    assert len(helped) >= 2
    low, high = solver.bounds
    for texel in [*helped, *range(0, COUNT, 60)]:
        oracle = Oracle(WI, WO, values[texel].astype(float), PAINT, "linear")
        ours = 0.5 * np.sum(oracle.residuals(np.clip(fit.x[texel].astype(float), low, high)) ** 2)
        scale = [0.3, 0.3, 0.3, 0.3, 0.3, 0.1]
        best = min(
            least_squares(oracle.residuals, np.clip(s, low + 1e-6, high - 1e-6), bounds=(low, high), x_scale=scale).cost
            for s in starts
        )
        assert ours <= 1.001 * best, f"texel {texel}: SciPy finds {best:.6g}, we {ours:.6g}"


def _share_tried_again(values: NDArray[np.float32], monkeypatch: pytest.MonkeyPatch) -> float:
    """Of the texels, those that are tried from all starts because of outliers."""
    solver, starts = _solver()
    found, tried = module._with_outliers, list[NDArray[np.bool_]]()

    def watched(raw: Raw) -> NDArray[np.bool_]:
        tried.append(found(raw))
        return tried[-1]

    with monkeypatch.context() as patch:
        patch.setattr(module, "_with_outliers", watched)
        solver.fit(values, starts)
    return float(np.mean(np.concatenate(tried)))


def test_texels_without_outliers_are_fitted_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """They cost nothing: noise alone, even of 5 % of the values, hardly ever looks like outliers."""
    clean, spoilt = _texels()
    noisier = clean * (1 + 0.045 * np.random.default_rng(4).standard_normal(clean.shape))
    assert _share_tried_again(clean, monkeypatch) == 0
    assert _share_tried_again(noisier.astype(np.float32), monkeypatch) < 0.01
    assert _share_tried_again(spoilt, monkeypatch) > 0.7


def test_what_a_texel_gets_does_not_depend_on_its_neighbours() -> None:
    solver, starts = _solver()
    clean, spoilt = _texels()
    alone = solver.fit(spoilt[10:20], starts)
    mixed = solver.fit(np.concatenate([clean[:7], spoilt[10:20]]), starts)
    np.testing.assert_array_equal(mixed.x[7:], alone.x)
    np.testing.assert_array_equal(mixed.stderr[7:], alone.stderr)


def test_pieces_that_threads_take_give_the_bits_of_one_call(monkeypatch: pytest.MonkeyPatch) -> None:
    solver, starts = _solver()
    values = _texels()[1]
    whole = solver.fit(values, starts, covariance=True)
    monkeypatch.setattr(module, "MOST_TOGETHER", 64)
    monkeypatch.setattr(module, "LEAST_TOGETHER", 1)
    monkeypatch.setenv("NUMBA_NUM_THREADS", "3")
    for name, part in solver.fit(values, starts, covariance=True)._asdict().items():
        np.testing.assert_array_equal(part, getattr(whole, name), err_msg=name)
    own = np.repeat(starts[:1], COUNT, axis=0)
    own[::2] = starts[1]
    apart = solver.fit(values, own, own_starts=True)
    monkeypatch.undo()
    np.testing.assert_array_equal(apart.x, solver.fit(values, own, own_starts=True).x)


def test_other_valleys_are_found_from_starts_that_do_not_know_them(monkeypatch: pytest.MonkeyPatch) -> None:
    """Beside a map's starts, here one of its six twice, texels with outliers begin where bands of widths suit them best."""
    solver, starts = _solver()
    values, best = _texels()[1], np.full(COUNT, np.inf)
    rng, (low, high) = np.random.default_rng(12), solver.bounds
    for _ in range(30):
        own = rng.uniform([0.05, 0.05, 0.05, 0, 0.02, 0.02], [1, 1, 1, 1.2, 1.5, 0.8], (COUNT, 6))
        fit = solver.fit(values, np.clip(own, low, high), own_starts=True)
        best = np.fmin(best, fit.relative_rms.astype(float) ** 2)

    def missed() -> int:
        return int(np.sum(solver.fit(values, starts[[0, 0]]).relative_rms.astype(float) ** 2 > 1.001 * best))

    found = missed()
    monkeypatch.setitem(vars(solver), "_bands", ())
    assert missed() >= 10
    assert found == 0


def test_a_robust_fit_is_tried_from_the_plain_one_only_where_that_is_far(monkeypatch: pytest.MonkeyPatch) -> None:
    clean, spoilt = _texels()
    fit = TexelSolver(PAINT, WI, WO, 3, robust="huber")
    starts = fit.starts(clean[::30])
    found = {}
    for apart in (module.APART, -1.0):  # -1: everywhere
        monkeypatch.setattr(module, "APART", apart)
        found[apart] = [fit.fit(data, starts) for data in (clean, spoilt)]
    for one, every in zip(*found.values(), strict=True):
        with np.errstate(invalid="ignore"):
            moved = np.nan_to_num(np.abs(one.x - every.x) / every.stderr)
        assert np.mean(moved.max(axis=1) > 0.01) <= 0.003


def test_steps_by_the_curvature_of_a_robust_function_end_where_those_by_its_weights_do(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    data, fits = _texels()[0][:200], []
    for least in (driver.LEAST_BENDING, 1.0):  # 1: a residual counts by its weight alone
        monkeypatch.setattr(driver, "LEAST_BENDING", least)
        fits.append(TexelSolver(PAINT, WI, WO, 3, robust="cauchy").fit(data, _solver()[1]))
    by_curvature, by_weights = fits
    moved = np.nan_to_num(np.abs(by_curvature.x - by_weights.x) / by_weights.stderr)
    assert np.quantile(moved.max(axis=1), 0.98) < 3e-3
    assert 1.5 * by_curvature.iterations.mean() < by_weights.iterations.mean()


@pytest.mark.parametrize("count", [1, 2, 71, 72, 2000])
def test_medians_of_short_rows_are_those_of_numpy(count: int) -> None:
    rows = np.random.default_rng(7).normal(size=(300, count)).astype(np.float32)
    rows[np.random.default_rng(8).random(rows.shape) < 0.1] = np.nan
    seen = np.isfinite(rows).any(axis=1)
    middle = np.nanmedian(rows[seen], axis=1, keepdims=True)
    spread = np.zeros(len(rows))
    spread[seen] = np.nanmedian(np.abs(rows[seen] - middle), axis=1)
    np.testing.assert_array_equal(deviation(rows), np.maximum(MEDIAN_TO_DEVIATION * spread, 1e-12))
