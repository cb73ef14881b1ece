"""Sums over samples by the functions that a model separates into, against those by its derivatives at each sample."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import motes
from motes.directions import from_spherical
from motes.fitting.problem import Problem
from motes.fitting.setup import Wishes, prepare
from motes.kernels.separated import separated
from motes.measurements import Measurement

MODELS = (
    "lambert",
    "oren_nayar",
    "oren_nayar + torrance_sparrow",
    "oren_nayar + torrance_sparrow(fresnel=schlick)",
    "eon + ggx",
    "lambert + beckmann",
    "oren_nayar + torrance_sparrow + retro",
    "coated_diffuse + torrance_sparrow",
)


def measured(count: int = 200, channels: int = 3) -> Measurement:
    """A fifth of it towards the mirror direction near grazing, where Oren and Nayar's equation (1) is negative for rough surfaces."""
    rng = np.random.default_rng(11)
    theta_i, theta_r, phi_i, phi_r = rng.uniform([0, 0, -3, -3], [1.55, 1.55, 3, 3], (count, 4)).T
    far = slice(0, count // 5)
    theta_i[far], theta_r[far], phi_r[far] = 1.3 + theta_i[far] / 7, 1.3 + theta_r[far] / 7, phi_i[far] + np.pi
    wi, wo = from_spherical(theta_i, phi_i), from_spherical(theta_r, phi_r)
    return Measurement.from_arrays(wi, wo, rng.uniform(0.05, 0.4, (count, channels)))


def both_ways(problem: Problem) -> tuple[Problem, Problem]:
    assert problem._by_functions is not None
    other = problem.at_directions(np.arange(len(problem.wi)))
    other.__dict__["_by_functions"] = None
    return problem, other


def points(problem: Problem, count: int) -> NDArray[np.float64]:
    rng = np.random.default_rng(5)
    low, high = problem.bounds
    return np.clip(rng.uniform(0.05, 1.5, (count, problem.size)), low, high)


@pytest.mark.parametrize("loss", ["linear", "plain"])
@pytest.mark.parametrize("model", MODELS)
def test_normal_equations_values_and_errors_are_the_same(model: str, loss: str) -> None:
    given = Wishes(loss, "none", "measurement", {}, ())
    ours, other = both_ways(prepare(measured(), model, given).problem)
    x = points(ours, 7)
    for mine, its in zip(ours.normal(x), other.normal(x), strict=True):
        np.testing.assert_allclose(mine, its, rtol=1e-9, atol=1e-11 * np.abs(its).max())
    np.testing.assert_allclose(ours.predicted(x[0]), other.predicted(x[0]), rtol=1e-12, atol=1e-14)
    inverse = np.linalg.pinv(other.normal(x[:1]).matrix[0], rcond=1e-9, hermitian=True)
    spread = other.spread(x[0], inverse)
    np.testing.assert_allclose(ours.spread(x[0], inverse), spread, rtol=1e-6, atol=1e-8 * np.abs(spread).max())


def test_where_the_model_clamps_its_functions_count_for_nothing() -> None:
    problem, other = both_ways(
        prepare(measured(), "oren_nayar", Wishes("linear", "none", "measurement", {}, ())).problem
    )
    x = np.array([[0.1, 0.2, 0.3, 1.5]])
    clamped = (problem.predicted(x[0]) == 0).mean(axis=0)
    assert (clamped > 0.005).all()
    assert (clamped < 0.5).all()
    np.testing.assert_allclose(problem.normal(x).matrix, other.normal(x).matrix, rtol=1e-11)


def test_held_values_of_channels_weights_and_parts() -> None:
    data = measured()
    weights = np.random.default_rng(2).uniform(0.2, 2.0, data.n_directions)
    wishes = Wishes("linear", "none", weights, {"K_d": [0.2, 0.4, 0.6], "sigma_s": 0.3}, ("K_s",))
    ours, other = both_ways(prepare(data, "oren_nayar + torrance_sparrow", wishes).problem)
    rows = np.arange(0, 200, 3)
    for mine, its in ((ours, other), (ours.at_directions(rows), other.at_directions(rows))):
        its.__dict__["_by_functions"] = None
        x = points(mine, 3)
        for a, b in zip(mine.normal(x), its.normal(x), strict=True):
            np.testing.assert_allclose(a, b, rtol=1e-10, atol=1e-12 * np.abs(b).max())


def test_bits_do_not_depend_on_threads(monkeypatch: pytest.MonkeyPatch) -> None:
    wishes = Wishes("linear", "none", "measurement", {}, ())
    found = []
    for threads in ("1", "3"):
        monkeypatch.setenv("NUMBA_NUM_THREADS", threads)
        problem = prepare(measured(60_000), "oren_nayar + torrance_sparrow", wishes).problem
        x = points(problem, 1)
        found.append([*problem.normal(x), problem.predicted(x[0]), problem.spread(x[0], np.eye(problem.size) * 1e-6)])
    for one, three in zip(*found, strict=True):
        assert one.tobytes() == three.tobytes()


def test_other_weights_in_each_channel_and_losses_that_bend_go_by_the_derivatives() -> None:
    data = measured()
    uneven = np.random.default_rng(2).uniform(0.2, 2.0, (data.n_directions, 3))
    for wishes in (
        Wishes("linear", "none", uneven, {}, ()),
        Wishes("log", "none", "measurement", {}, ()),
    ):
        assert prepare(data, "oren_nayar", wishes).problem._by_functions is None
    assert prepare(data, "hapke", Wishes("linear", "none", "measurement", {}, ())).problem._by_functions is None


def test_functions_are_not_so_small_that_their_products_are_below_normal_numbers() -> None:
    """Where a highlight is narrow, its exponential is; processors take a hundred cycles for each such number."""
    model = motes.OrenNayar(0.4, 0.3) + motes.TorranceSparrow(0.2, 0.1)
    made = separated(model, ["K_d", "sigma_d", "K_s", "sigma_s"])
    assert made is not None
    data = measured(500)
    columns = made.geometry(data.wi, data.wo).columns
    for sigma_s in (0.01, 0.03, 0.1):
        for b in made.functions(columns, {"sigma_s": np.array([[sigma_s]])}):
            size = np.abs(b[b != 0])
            assert size.min() ** 2 > 1e-290
