"""The solver on its own: bounds, and lanes that do not know of each other."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import least_squares

from fitting_nist import SETS, Dataset, normal_equations
from motes.fitting.solver import Normal, minimize
from motes.fitting.verdicts import Status


def of(data: Dataset):
    return normal_equations(data.formula, data.x, data.y)


def free(size: int):
    return np.full(size, -np.inf), np.full(size, np.inf)


def rosenbrock(_, b):
    return np.concatenate([10 * (b[1] - b[0] ** 2), 1 - b[0]], axis=1)


@pytest.mark.parametrize(
    ("low", "high"),
    [
        ((-np.inf, -np.inf), (np.inf, np.inf)),
        ((-2, -2), (0.5, 2)),  # one bound active at the end
        ((1.5, -2), (3, 1.2)),  # two
        ((-3, 1.5), (0.2, 3)),
        ((-1.2, 1.0), (-1.0, 4.0)),
    ],
)
def test_bounded_solutions_equal_scipys(low, high) -> None:
    low, high = np.array(low, float), np.array(high, float)
    rng = np.random.default_rng(3)
    starts = rng.uniform(np.maximum(low, -2), np.minimum(high, 2), (6, 2))
    normal = normal_equations(rosenbrock, np.zeros(2), np.zeros(2))
    ours = minimize(normal, starts, low, high, max_iterations=500)
    ends = [
        least_squares(
            lambda b: rosenbrock(None, [b[None, :1], b[None, 1:]])[0],
            np.clip(start, low + 1e-9, high - 1e-9),
            bounds=(low, high),
            xtol=1e-14,
            ftol=1e-14,
            gtol=1e-14,
        )
        for start in starts
    ]
    best = min(ends, key=lambda end: end.cost)
    assert all(status.ok for status in ours.status)
    np.testing.assert_allclose(ours.x[ours.best()], best.x, atol=1e-6)
    np.testing.assert_allclose(ours.normal.objective[ours.best()], best.cost, rtol=1e-7, atol=1e-15)
    assert np.all((ours.x >= low) & (ours.x <= high))


def test_random_bounded_linear_problems_equal_nnls_like_solutions() -> None:
    """Linear problems with random boxes: the solution satisfies the optimality conditions, which leave no doubt."""
    rng = np.random.default_rng(11)
    for _ in range(25):
        n, size = 30, 6
        matrix, y = rng.normal(size=(n, size)), rng.normal(size=n)
        low = rng.uniform(-0.3, 0.0, size)
        high = low + rng.uniform(0.05, 0.5, size)

        def normal(points, matrix=matrix, y=y):
            residual = points @ matrix.T - y
            hessian = np.broadcast_to(matrix.T @ matrix, (len(points), *(2 * matrix.shape[1:])))
            return Normal(0.5 * np.sum(residual**2, axis=1), residual @ matrix, hessian)

        end = minimize(normal, rng.uniform(low, high, (3, size)), low, high, reduction=1e-15)
        for x, gradient, status in zip(end.x, end.normal.gradient, end.status, strict=True):
            assert status.ok
            inside = (x > low) & (x < high)
            np.testing.assert_allclose(gradient[inside], 0, atol=1e-5)
            assert np.all(gradient[x <= low] >= -1e-6)
            assert np.all(gradient[x >= high] <= 1e-6)


def test_lanes_are_independent() -> None:
    data = SETS["Thurber"]
    rng = np.random.default_rng(5)
    starts = np.array(data.starts[1]) * rng.uniform(0.8, 1.2, (7, 7))
    normal, bounds = of(data), free(7)
    together = minimize(normal, starts, *bounds)
    for k, start in enumerate(starts):
        alone = minimize(normal, start[None], *bounds)
        np.testing.assert_allclose(alone.x[0], together.x[k], rtol=1e-9)
        assert alone.status[0] == together.status[k]
        assert abs(int(alone.iterations[0]) - int(together.iterations[k])) <= 1


def test_a_lane_that_meets_nan_does_not_disturb_the_others() -> None:
    data = SETS["Rat43"]
    bad = [1.0, 1e6, -1e6, 1e-9]  # overflows
    normal = of(data)
    with np.errstate(all="ignore"):
        end = minimize(normal, np.array([data.starts[1], bad]), *free(4))
    assert end.status[0].ok
    np.testing.assert_allclose(end.x[0], data.values, rtol=1e-5)
    assert end.best() == 0 or np.isnan(end.normal.objective[1])


def test_held_parameters_stay() -> None:
    data = SETS["Thurber"]
    start = np.array([data.starts[1]] * 2)
    held = np.zeros(7, bool)
    held[[1, 4]] = True
    end = minimize(of(data), start, *free(7), held=held)
    assert np.array_equal(end.x[:, held], start[:, held])
    assert np.all(end.x[:, ~held] != start[:, ~held])
    each = np.zeros((2, 7), bool)
    each[0, 0] = each[1, 3] = True
    end = minimize(of(data), start, *free(7), held=each)
    assert np.array_equal(end.x[each], start[each])
    assert end.x[0, 3] != start[0, 3]
    assert end.x[1, 0] != start[1, 0]


def test_rows_belong_to_their_sets() -> None:
    y = np.array([[1.0, 2.0, 3.0], [5.0, 5.0, 8.0]])

    def normal(points, sets):
        residual = points - y[sets]
        return Normal(
            0.5 * np.sum(residual**2, axis=1),
            residual.sum(axis=1, keepdims=True),
            np.full((len(points), 1, 1), 3.0),
        )

    end = minimize(normal, np.zeros((3, 1)), *free(1), sets=np.array([1, 0, 1]))
    np.testing.assert_allclose(end.x[:, 0], [6, 2, 6], rtol=1e-6)


def test_every_way_to_stop() -> None:
    exact = normal_equations(lambda x, b: b[0] * x, np.array([1.0, 2.0]), np.array([3.0, 6.0]))
    assert minimize(exact, np.array([[3.0]]), *free(1)).status == [Status.PERFECT]
    assert minimize(exact, np.array([[1.0]]), *free(1)).status[0].ok
    data = SETS["Misra1a"]
    assert minimize(of(data), np.array([data.starts[0]]), *free(2)).status == [Status.CONVERGED]
    assert minimize(of(data), np.array([data.starts[0]]), *free(2), max_iterations=3).status == [Status.MAX_ITERATIONS]
    held = np.ones(2, bool)
    assert minimize(of(data), np.array([data.starts[0]]), *free(2), held=held).status[0].ok
    assert not Status.MAX_ITERATIONS.ok
    assert not Status.NO_PROGRESS.ok

    def uphill(points):  # a gradient that points the wrong way: no step helps
        at = of(data)(points)
        return Normal(at.objective, -at.gradient, at.matrix)

    assert minimize(uphill, np.array([data.starts[1]]), *free(2)).status == [Status.NO_PROGRESS]

    def creeping(points):  # an objective that falls for ever, by 1e-9 of it a step
        ones = np.ones((len(points), 1))
        return Normal(1 - 1e-9 * points[:, 0], -1e-9 * ones, 1e-9 * ones[:, :, None])

    end = minimize(creeping, np.array([[2.0]]), *free(1))
    assert end.status == [Status.IDLE]
    assert end.iterations[0] < 20


def test_what_a_step_would_carry_past_a_bound_stops_there_and_the_others_adapt() -> None:
    """Linear problems with tight boxes: where the joint step is only cut off at them, the others are led astray, and it
    takes twice as many iterations (110 of them, not 52)."""
    rng = np.random.default_rng(2)
    total = 0
    for _ in range(20):
        matrix, y = rng.normal(size=(40, 12)) + 1.0, rng.normal(size=40)
        low = rng.uniform(-0.2, 0.0, 12)
        high = low + 0.2

        def normal(points, matrix=matrix, y=y):
            residual = points @ matrix.T - y
            hessian = np.broadcast_to(matrix.T @ matrix, (len(points), 12, 12))
            return Normal(0.5 * np.sum(residual**2, axis=1), residual @ matrix, hessian)

        total += int(minimize(normal, (low + high)[None] / 2, low, high).iterations[0])
    assert total <= 70


def test_a_parameter_that_nothing_depends_on_does_not_block_the_others() -> None:
    """Its derivative is far below rounding, and yet not 0: a step along it is a leap into nowhere."""

    def normal(points):
        a, b = points[:, :1], points[:, 1:]
        x = np.linspace(0, 1, 20)
        spike = np.exp(-((0.9 / b) ** 2)) * np.where(np.arange(20) == 7, 1.0, 0.0)  # 2e-14 at b = 0.16
        residual = a * x + spike - (2 * x + 0.1 * np.sin(40 * x))
        by_b = spike * 2 * 0.9**2 / b**3
        jacobian = np.stack([np.broadcast_to(x, residual.shape), by_b], axis=-1)
        return Normal(
            0.5 * np.sum(residual**2, axis=1),
            np.einsum("bn,bnk->bk", residual, jacobian),
            np.einsum("bnk,bnl->bkl", jacobian, jacobian),
        )

    x = np.linspace(0, 1, 20)
    slope = x @ (2 * x + 0.1 * np.sin(40 * x)) / (x @ x)
    end = minimize(normal, np.array([[0.1, 0.16]]), np.array([-9.0, 0.005]), np.array([9.0, 1.5]), brightness=30.0)
    assert end.status[0].ok
    np.testing.assert_allclose(end.x[0], [slope, 0.16], rtol=1e-6)


def test_a_last_step_that_leads_uphill_is_not_kept() -> None:
    """A step along what the data hardly see promises next to nothing, and ends a fit without a look at where it leads: here into a wall."""
    slope, left = 1e-6, 1e-5

    def normal(points):
        a, b = points[:, 0], points[:, 1]
        residual = np.stack([a - 1, left + slope * (b - 1) + 5 * np.minimum(b, 0), np.ones_like(a)], axis=-1)
        none = np.zeros_like(a)
        by_a = np.stack([none + 1, none, none], axis=-1)
        by_b = np.stack([none, slope + 5 * (b < 0), none], axis=-1)
        jacobian = np.stack([by_a, by_b], axis=-1)
        return Normal(
            0.5 * np.sum(residual**2, axis=1),
            np.einsum("bn,bnk->bk", residual, jacobian),
            np.einsum("bnk,bnl->bkl", jacobian, jacobian),
        )

    end = minimize(normal, np.array([[1.0, 1.0]]), *free(2))
    assert end.status[0].ok
    assert normal(end.x).objective[0] > 1e3  # where the last step leads
    np.testing.assert_allclose(end.best_point(normal), [1, 1])
    steep = minimize(normal, np.array([[0.2, 1.0]]), *free(2))
    np.testing.assert_array_equal(steep.best_point(normal), steep.x[0])
