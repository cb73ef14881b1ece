"""Losses, robust functions, and the normal equations: derivatives against finite differences and a dense Jacobian."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import motes
from fitting_oracle import LOSSES as ORACLE_LOSSES
from fitting_oracle import MODELS, Formulas, scattered
from motes import workers
from motes.errors import MotesError
from motes.fitting import problem as problem_module
from motes.fitting.chord import Chord
from motes.fitting.losses import LOSSES, ROBUST, SMALLEST, loss_named, robust_named
from motes.fitting.problem import Problem
from motes.fitting.quantities import layout
from motes.models import parse

DUSTY = "dust_layer(oren_nayar + torrance_sparrow)"
VALUES = {
    "K_d": (0.6, 0.4, 0.25),
    "sigma_d": 0.4,
    "K_s": 0.25,
    "sigma_s": 0.15,
    "w": (0.9, 0.8, 0.7),
    "g": 0.3,
    "tau": 0.3,
}


def make(
    text: str = DUSTY,
    n: int = 150,
    channels: int = 3,
    loss: str = "linear",
    robust: str = "none",
    per_channel: frozenset[str] = frozenset(),
    held: dict[str, float] | None = None,
    seed: int = 0,
) -> tuple[Problem, np.ndarray]:
    """A problem with noise, outliers, uneven weights and masked samples; and a parameter vector that is no optimum."""
    held = held or {}
    wi, wo = scattered(n, seed)
    rng = np.random.default_rng(seed)
    model = parse(text).model
    f = model.with_parameters({s.name: VALUES[s.name] for s in model.slots()}).eval(wi, wo)[:, :channels]
    values = np.broadcast_to(f, (n, channels)) * rng.uniform(0.8, 1.3, (n, channels))
    values[::17] *= 3
    weights = rng.uniform(0.2, 2.0, (n, channels)) * (rng.uniform(size=(n, channels)) > 0.1)
    quantities = layout(model, channels, frozenset(held), per_channel)
    built = Problem(
        model=model,
        quantities=quantities,
        fixed=held,
        wi=wi,
        wo=wo,
        values=values,
        weights=weights,
        loss=LOSSES[loss],
        robust=ROBUST[robust],
        scale=0.02,
    )
    x = np.concatenate(
        [
            q.coordinate(np.resize(VALUES[q.name], q.where.stop - q.where.start) * rng.uniform(0.8, 1.2))
            for q in quantities
        ]
    )
    return built, x


def dense(built: Problem, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Weighted residuals (N C,) and Jacobian (N C, P) by central differences of the formulas typed by hand."""
    at = Formulas(built.wi, built.wo)
    names, formula = MODELS[
        {"Lambert": "lambert", "OrenNayar": "oren_nayar", "Sum": "oren_nayar + torrance_sparrow", "DustLayer": DUSTY}[
            type(built.model).__name__
        ]
    ]
    transform = ORACLE_LOSSES[built.loss.name]

    def residuals(x):
        given = {q.name: q.value(x[q.where]) for q in built.quantities} | dict(built.fixed)
        f = formula(at, *(given[name] for name in names))
        return (np.sqrt(built.weights) * (transform(f, at.mu_i) - transform(built.values, at.mu_i))).ravel()

    columns = []
    for k in range(len(x)):
        h = 1e-5 * max(abs(x[k]), 1e-2)
        e = np.eye(len(x))[k] * h
        columns.append(
            (8 * (residuals(x + e) - residuals(x - e)) - residuals(x + 2 * e) + residuals(x - 2 * e)) / (12 * h)
        )
    return residuals(x), np.stack(columns, axis=1)


# ---------------------------------------------------------------- losses


@pytest.mark.parametrize("name", LOSSES)
@given(f=st.floats(2 * SMALLEST, 1e4), cosine=st.floats(0.01, 1))
def test_slope_of_a_loss(name: str, f: float, cosine: float) -> None:
    loss, f, cosine = LOSSES[name], np.array([max(f, 2 * SMALLEST / cosine)]), np.array([cosine])
    h = 1e-4 * f
    numeric = (loss.transform(f + h, cosine) - loss.transform(f - h, cosine)) / (2 * h)
    np.testing.assert_allclose(loss.slope(f, cosine), numeric, rtol=1e-6)
    np.testing.assert_allclose(loss.transform(f, cosine), ORACLE_LOSSES[name](f, cosine), rtol=1e-12, atol=1e-15)


@pytest.mark.parametrize("name", LOSSES)
def test_a_loss_is_finite_and_increasing_from_zero(name: str) -> None:
    loss, f = LOSSES[name], np.concatenate([[0.0], np.logspace(-12, 6, 200)])
    cosine = np.full_like(f, 0.3)
    assert np.all(np.isfinite(loss.transform(f, cosine)))
    assert np.all(np.diff(loss.transform(f, cosine)) > 0)
    slope = loss.slope(f, cosine)
    assert np.all(np.isfinite(slope))
    assert np.all(slope > 0)


@pytest.mark.parametrize("name", ROBUST)
@given(r=st.floats(-50, 50))
def test_slope_and_bend_of_a_robust_function(name: str, r: float) -> None:
    robust = ROBUST[name]
    r = np.array([r])
    h = 1e-5 * np.maximum(np.abs(r), 1)

    def half_rho(r):
        return 0.5 * robust.rho(r * r)

    def psi(r):
        return r * robust.slope(r * r)

    numeric = (half_rho(r + h) - half_rho(r - h)) / (2 * h)
    np.testing.assert_allclose(psi(r), numeric, rtol=1e-5, atol=1e-8)
    if name != "huber" or abs(abs(r[0]) - 1) > 1e-3:  # whose second derivative jumps
        numeric = (psi(r + h) - psi(r - h)) / (2 * h)
        np.testing.assert_allclose(robust.bend(r * r), numeric, rtol=1e-4, atol=1e-6)


@pytest.mark.parametrize("name", [name for name in ROBUST if name != "none"])
def test_a_robust_function_is_scipys(name: str) -> None:
    """`scipy.optimize.least_squares` gives its cost for one residual and no parameter to move."""
    from scipy.optimize import least_squares

    for r in (-7.0, -0.9, 0.0, 0.3, 1.0, 2.5, 40.0):
        end = least_squares(lambda x, r=r: np.array([r]) + 0 * x, [0.0], loss=name, f_scale=0.7, max_nfev=1)
        ours = 0.5 * 0.7**2 * ROBUST[name].rho(np.array((r / 0.7) ** 2))
        np.testing.assert_allclose(ours, end.cost, rtol=1e-12)


@pytest.mark.parametrize("wrong", ["", "Linear", "l2", None, 3, ["linear"]])
def test_unknown_names(wrong: object) -> None:
    for lookup in (loss_named, robust_named):
        with pytest.raises(MotesError, match="is not one of"):
            lookup(wrong)


# ---------------------------------------------------------------- normal equations

LAYOUTS = {
    "shared": {"channels": 1},
    "one color": {},
    "highlight a channel": {"per_channel": frozenset({"K_s"})},
    "held": {"held": {"sigma_d": 0.35, "g": 0.2}},
    "lambert": {"text": "lambert"},
    "oren_nayar": {"text": "oren_nayar"},
    "sum": {"text": "oren_nayar + torrance_sparrow"},
}


@pytest.mark.parametrize("robust", ROBUST)
@pytest.mark.parametrize("loss", LOSSES)
def test_normal_equations_are_those_of_a_dense_jacobian(loss: str, robust: str) -> None:
    for case in LAYOUTS.values():
        built, x = make(loss=loss, robust=robust, **case)
        residual, jacobian = dense(built, x)
        z = (residual / built.scale) ** 2
        rho = ROBUST[robust]
        at = built.normal(x[None])
        np.testing.assert_allclose(at.objective[0], 0.5 * built.scale**2 * rho.rho(z).sum(), rtol=1e-10)
        expected = jacobian.T @ (residual * rho.slope(z))
        np.testing.assert_allclose(at.gradient[0], expected, rtol=1e-6, atol=1e-7 * np.abs(expected).max())
        weighted = jacobian * rho.slope(z)[:, None]
        matrix = jacobian.T @ weighted
        np.testing.assert_allclose(at.matrix[0], matrix, rtol=1e-6, atol=1e-8 * np.abs(matrix).max())
        bent = jacobian.T @ (jacobian * rho.bend(z)[:, None])
        np.testing.assert_allclose(built.curvature(x), bent, rtol=1e-6, atol=1e-8 * np.abs(bent).max())
        np.testing.assert_allclose(built.residuals(x).ravel(), residual, rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("robust", ROBUST)
def test_the_gradient_is_that_of_the_objective(robust: str) -> None:
    built, x = make(robust=robust, loss="log")
    gradient = built.normal(x[None]).gradient[0]
    for k in range(len(x)):
        e = np.eye(len(x))[k] * 1e-6 * max(abs(x[k]), 1e-2)
        above, below = built.normal(np.stack([x + e, x - e])).objective
        np.testing.assert_allclose(gradient[k], (above - below) / (2 * e[k]), rtol=2e-5, atol=1e-7)


@pytest.mark.parametrize("robust", ROBUST)
def test_the_middle_of_the_sandwich_is_hc3(robust: str) -> None:
    """By the book: (psi / (1 - h))^2 J'J, h the diagonal of the hat matrix."""
    for case in ({}, {"channels": 1}, {"per_channel": frozenset({"K_s"})}):
        built, x = make(robust=robust, **case)
        residual, jacobian = dense(built, x)
        z = (residual / built.scale) ** 2
        rho = ROBUST[robust]
        inverse = np.linalg.inv(built.normal(x[None]).matrix[0])
        leverage = rho.bend(z) * np.einsum("np,pq,nq->n", jacobian, inverse, jacobian)
        psi = residual * rho.slope(z) / np.maximum(1 - leverage, 0.05)
        expected = jacobian.T @ (jacobian * (psi**2)[:, None])
        np.testing.assert_allclose(built.spread(x, inverse), expected, rtol=1e-5, atol=1e-6 * np.abs(expected).max())


def test_a_batch_is_its_rows() -> None:
    built, x = make()
    batch = x * np.random.default_rng(1).uniform(0.5, 1.5, (5, len(x)))
    together = built.normal(batch)
    for k, row in enumerate(batch):
        for whole, alone in zip(together, built.normal(row[None]), strict=True):
            np.testing.assert_allclose(whole[k], alone[0], rtol=1e-11, atol=1e-13)


@pytest.mark.parametrize("chunk", [1, 1000, 4000, 1 << 17])
def test_results_do_not_depend_on_the_size_of_a_chunk(chunk: int, monkeypatch: pytest.MonkeyPatch) -> None:
    built, x = make(n=1000)
    monkeypatch.setattr(problem_module, "CHUNK", 1 << 30)
    whole, all_predicted = built.normal(x[None]), built.predicted(x)
    spread = built.spread(x, np.linalg.inv(whole.matrix[0]))
    monkeypatch.setattr(problem_module, "CHUNK", chunk)
    for a, b in zip(built.normal(x[None]), whole, strict=True):
        np.testing.assert_allclose(a, b, rtol=1e-11, atol=1e-11 * np.abs(b).max())
    np.testing.assert_allclose(built.predicted(x), all_predicted, rtol=1e-14)
    np.testing.assert_allclose(
        built.spread(x, np.linalg.inv(whole.matrix[0])), spread, rtol=1e-9, atol=1e-12 * np.abs(spread).max()
    )


def test_bits_do_not_depend_on_the_number_of_threads(monkeypatch: pytest.MonkeyPatch) -> None:
    built, x = make(n=40_000)
    results = []
    for count in (1, 2, 5):
        monkeypatch.setattr(workers, "threads", lambda count=count: count)
        monkeypatch.setattr(workers, "_pool", None)
        results.append([part.tobytes() for part in built.normal(np.stack([x, 0.9 * x]))])
    assert results[0] == results[1] == results[2]


def test_a_part_is_the_problem_of_its_directions() -> None:
    problem, x = make(loss="cube_root")
    times = np.random.default_rng(2).integers(0, 3, 150).astype(float)
    rows = np.flatnonzero(times)[::2]
    problem.normal(x[None]), problem.brightness()  # what is kept of the whole is not that of a part
    part = problem.counting(times).at_directions(rows).with_scale(ROBUST["cauchy"], 0.02)
    anew = replace(
        problem,
        robust=ROBUST["cauchy"],
        scale=0.02,
        **{name: getattr(problem, name)[rows] for name in ("wi", "wo", "values")},
        weights=(problem.weights * times[:, None])[rows],
    )
    for found, expected in zip(part.normal(x[None]), anew.normal(x[None]), strict=True):
        np.testing.assert_allclose(found, expected, rtol=1e-12)
    np.testing.assert_allclose(part.brightness(), anew.brightness(), rtol=1e-12)


def test_data_sets_of_their_own() -> None:
    """(T, N, C) data with the set of each row, as joint fits over time use it."""
    built, x = make()
    other = built.values * 0.7
    both = replace(
        built, values=np.stack([built.values, other]), weights=np.stack([built.weights, 0.5 * built.weights])
    )
    rows = np.stack([x, 0.9 * x, 1.1 * x])
    at = both.normal(rows, np.array([1, 0, 1]))
    second = replace(built, values=other, weights=0.5 * built.weights)
    for k, single in ((0, second), (1, built), (2, second)):
        for whole, alone in zip(at, single.normal(rows[k : k + 1]), strict=True):
            np.testing.assert_allclose(whole[k], alone[0], rtol=1e-11, atol=1e-13)


def test_masked_samples_count_for_nothing() -> None:
    built, x = make()
    values = built.values.copy()
    values[built.weights == 0] = 1e6
    changed = replace(built, values=values)
    for a, b in zip(built.normal(x[None]), changed.normal(x[None]), strict=True):
        assert np.array_equal(a, b)
    assert built.samples == np.count_nonzero(built.weights)
    assert np.all(built.residuals(x)[built.weights == 0] == 0)


def test_layout_labels_and_bounds() -> None:
    built, x = make()
    assert built.labels(("R", "G", "B")) == (
        *("K_d[R]", "K_d[G]", "K_d[B]", "sigma_d", "K_s", "sigma_s"),
        *("w[R]", "w[G]", "w[B]", "g", "tau"),
    )
    assert built.size == len(x) == 11
    low, high = built.bounds
    assert low[3] == 0
    assert high[3] == pytest.approx((np.pi / 2) ** 2)  # a fit moves in sigma_d^2
    assert np.all(low < high)
    metal, _ = make(per_channel=frozenset({"K_s"}))
    assert metal.labels(("R", "G", "B"))[4:8] == ("K_s[R]", "K_s[G]", "K_s[B]", "sigma_s")
    grey, _ = make(channels=1, per_channel=frozenset({"K_s"}))
    assert grey.labels(("grey",)) == ("K_d", "sigma_d", "K_s", "sigma_s", "w", "g", "tau")


def test_predicted_is_eval() -> None:
    built, x = make()
    values = {q.name: q.value(x[q.where]) if q.per_channel else float(q.value(x[q.where])[0]) for q in built.quantities}
    brdf = built.model.with_parameters(values)
    np.testing.assert_allclose(built.predicted(x), brdf.eval(built.wi, built.wo), rtol=1e-10)
    assert isinstance(brdf, motes.DustLayer)


# ---------------------------------------------------------------- chords


@pytest.mark.parametrize("robust", ["none", "cauchy"])
def test_a_chord_is_exact_where_it_starts_and_in_its_objective_everywhere(robust: str) -> None:
    """Two data sets, each with weights and a point of its own."""
    problem, x = make(robust=robust, per_channel=frozenset({"K_s"}))
    rng = np.random.default_rng(4)
    weights = problem.weights * (rng.uniform(size=(2, 150, 1)) > 0.2)
    both = replace(problem, values=np.stack([problem.values] * 2), weights=weights)
    at, sets = np.stack([x, 1.05 * x]), np.arange(2)
    chord = Chord(both, at)
    for found, exact in zip(chord.normal(at, sets), both.normal(at, sets), strict=True):
        np.testing.assert_allclose(found, exact, rtol=1e-12, atol=1e-12 * np.abs(exact).max())
    moved = np.stack([0.97 * at[1], 1.1 * at[0]])
    found, exact = chord.normal(moved, sets[::-1]), both.normal(moved, sets[::-1])
    np.testing.assert_allclose(found.objective, exact.objective, rtol=1e-12)
    np.testing.assert_array_equal(found.matrix, chord.normal(at, sets).matrix[::-1])
    # The gradient has the residuals of where it is asked and the derivatives of where the chord starts: by a dense Jacobian.
    one = replace(both, values=both.values[1], weights=both.weights[1])
    step = 1e-6
    columns = []
    for k in range(problem.size):
        ends = []
        for sign in (1, -1):
            point = at[1].copy()
            point[k] += sign * step
            ends.append(one.residuals(point))
        columns.append((ends[0] - ends[1]) / (2 * step))
    residual = one.residuals(moved[0])
    slope = residual * one.robust.slope((residual / one.scale) ** 2)
    expected = [float(np.sum(column * slope)) for column in columns]
    np.testing.assert_allclose(found.gradient[0], expected, rtol=1e-5, atol=1e-7 * np.abs(expected).max())
