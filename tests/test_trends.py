"""Trends: their formulas against ones typed a second time, derivatives, bounds, errors, and what they become on disk."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal
from scipy.integrate import quad
from scipy.interpolate import BPoly
from scipy.stats import multivariate_normal

from motes.errors import DataError, MotesError, ParameterError
from motes.material import Material
from motes.models import OrenNayar, TorranceSparrow
from motes.trends import KINDS, Tabulated, Trend, evaluate, flat, trend_from_dict

T0, T1 = 1.5, 7.5
INTERVAL = (T0, T1)
NUMBERS: dict[str, dict[str, Any]] = {
    "constant": {"value": 0.4},
    "linear": {"start": 0.2, "end": 0.7},
    "exponential": {"start": 0.8, "end": 0.1, "time_constant": 1.7},
    "logistic": {"start": 0.15, "end": 0.65, "middle": 4.0, "width": 0.6},
    "quadratic": {"c0": 0.2, "c1": 0.9, "c2": 0.4},
    "cubic": {"c0": 0.2, "c1": 0.9, "c2": 0.1, "c3": 0.6},
    "monotone_spline": {"start": 0.7, "end": 0.2, "share0": 0.3, "share1": 0.1, "share2": 0.6},
}
every_kind = pytest.mark.parametrize("kind", NUMBERS)
both = pytest.mark.parametrize("channels", [None, 3])


def channelled(kind: str, channels: int | None) -> dict[str, Any]:
    """The coefficients, with another value for each channel."""
    if channels is None:
        return dict(NUMBERS[kind])
    values = {c.name for c in KINDS[kind].coefficients if c.bounds is None}
    scale = 1 - 0.2 * np.arange(channels)
    return {name: v * scale if name in values else v for name, v in NUMBERS[kind].items()}


def hat(k: int, u: float) -> float:
    """A hat of 1 at knot k of 0, 1/3, 2/3, 1."""
    return max(0.0, 1 - abs(3 * u - k))


def rise(k: int, u: float) -> float:
    points = [p / 3 for p in range(4) if 0 < p / 3 < u]
    return (
        quad(lambda x: hat(k, x), 0, u, points=points or None)[0]
        / quad(lambda x: hat(k, x), 0, 1, points=[1 / 3, 2 / 3])[0]
    )


def formula(kind: str, t: float, c: dict[str, Any]) -> Any:
    """Each trend once more, from its formula."""
    u = (t - T0) / (T1 - T0)
    match kind:
        case "constant":
            return c["value"]
        case "linear":
            return (1 - u) * c["start"] + u * c["end"]
        case "exponential":
            return c["end"] + (c["start"] - c["end"]) * 2.0 ** (-(t - T0) / (c["time_constant"] * np.log(2)))
        case "logistic":
            return c["start"] + (c["end"] - c["start"]) * 0.5 * (1 + np.tanh((t - c["middle"]) / (2 * c["width"])))
        case "quadratic" | "cubic":
            return BPoly(np.array(list(c.values()))[:, None], [T0, T1])(t)
        case "monotone_spline":
            s0, s1, s2 = c["share0"], c["share1"], c["share2"]
            shares = [s0, (1 - s0) * s1, (1 - s0) * (1 - s1) * s2, (1 - s0) * (1 - s1) * (1 - s2)]
            return c["start"] + (c["end"] - c["start"]) * sum(s * rise(k, u) for k, s in enumerate(shares))
    raise AssertionError(kind)


def test_every_kind_is_tested() -> None:
    assert set(NUMBERS) == set(KINDS)


# ---------------------------------------------------------------- Values


@every_kind
@both
def test_values_are_the_formula(kind: str, channels: int | None) -> None:
    c = channelled(kind, channels)
    trend = Trend(kind, c, INTERVAL)
    assert trend.channels == channels
    for t in (T0, 2.0, 3.49, 3.51, 5.6, T1):
        expected = (
            formula(kind, t, c)
            if channels is None
            else [formula(kind, t, {n: v if np.ndim(v) == 0 else v[k] for n, v in c.items()}) for k in range(channels)]
        )
        assert_allclose(trend(t), expected, rtol=1e-9)


@pytest.mark.parametrize("kind", ["linear", "monotone_spline", "quadratic", "cubic"])
def test_ends_are_the_first_and_last_value(kind: str) -> None:
    first, *_, last = [v for c, v in zip(KINDS[kind].coefficients, NUMBERS[kind].values(), strict=True) if not c.bounds]
    assert_allclose(Trend(kind, NUMBERS[kind], INTERVAL)([T0, T1]), [first, last], rtol=1e-12)


def test_an_exponential_starts_at_its_start_and_tends_to_its_end() -> None:
    trend = Trend("exponential", NUMBERS["exponential"], INTERVAL)
    assert_allclose(trend(T0), 0.8, rtol=1e-15)
    assert_allclose(trend(T0 + 1.7), 0.1 + 0.7 / np.e, rtol=1e-14)
    assert trend(1e6) == pytest.approx(0.1, rel=1e-14)


def test_a_logistic_passes_half_the_way_at_its_middle() -> None:
    trend = Trend("logistic", NUMBERS["logistic"], INTERVAL)
    assert_allclose(trend(4.0), 0.4, rtol=1e-14)
    assert_allclose(trend([4.0 - 1.2, 4.0 + 1.2]), 0.15 + 0.5 * np.array([0.1192, 0.8808]), rtol=1e-4)  # 12 % and 88 %


@every_kind
@both
@pytest.mark.parametrize("shape", [(), (1,), (4,), (2, 3), (0,)])
def test_times_of_any_shape(kind: str, channels: int | None, shape: tuple[int, ...]) -> None:
    trend = Trend(kind, channelled(kind, channels), INTERVAL)
    hours = np.random.default_rng(1).uniform(T0 - 2, T1 + 2, shape)
    values = trend(hours)
    assert values.shape == (shape if channels is None else (*shape, channels))
    for index in np.ndindex(*shape):
        assert_allclose(values[index], trend(hours[index]), rtol=1e-15)


# ---------------------------------------------------------------- Derivatives


@every_kind
@both
def test_derivatives_against_finite_differences(kind: str, channels: int | None) -> None:
    c = channelled(kind, channels)
    hours = np.array([T0, 2.3, 4.1, 5.0, T1, T1 + 3])
    jacobian = Trend(kind, c, INTERVAL).jacobian(hours)
    shape = hours.shape if channels is None else (*hours.shape, channels)
    for name in c:
        step = 1e-6
        up, down = (Trend(kind, {**c, name: c[name] + s}, INTERVAL)(hours) for s in (step, -step))
        assert_allclose(np.broadcast_to(jacobian[name], shape), (up - down) / (2 * step), rtol=1e-6, atol=1e-8)


@every_kind
def test_the_rate_is_the_slope_in_time(kind: str) -> None:
    trend = Trend(kind, NUMBERS[kind], INTERVAL)
    for t in (2.0, 4.6, 7.0):
        expected = (formula(kind, t + 1e-5, NUMBERS[kind]) - formula(kind, t - 1e-5, NUMBERS[kind])) / 2e-5
        assert_allclose(trend.rate(t), expected, rtol=1e-5, atol=1e-9)


def test_evaluate_broadcasts_coefficients_over_a_batch() -> None:
    basis = [b[:, None] for b in KINDS["exponential"].basis(np.array([T0, 3.0]), *INTERVAL)]
    starts = np.array([[[0.8]], [[0.5]]])
    value, slopes = evaluate("exponential", basis, {"start": starts, "end": 0.1, "time_constant": 1.7})
    for k, start in enumerate((0.8, 0.5)):
        one = Trend("exponential", {"start": start, "end": 0.1, "time_constant": 1.7}, INTERVAL)
        assert_allclose(value[k, :, 0], one([T0, 3.0]), rtol=1e-14)
    assert set(slopes) == {"start", "end", "time_constant"}


# ---------------------------------------------------------------- Bounds


def coefficients(kind: str, low: float, high: float) -> st.SearchStrategy[dict[str, float]]:
    """Any coefficients within the bounds."""
    span = T1 - T0
    drawn = {}
    for c in KINDS[kind].coefficients:
        if c.bounds is None:
            drawn[c.name] = st.floats(low, high)
        elif c.is_time:
            shift = T0 if c.name == "middle" else 0.0
            drawn[c.name] = st.floats(shift + c.bounds[0] * span, shift + c.bounds[1] * span)
        else:
            drawn[c.name] = st.floats(*c.bounds)
    return st.fixed_dictionaries(drawn)


@every_kind
@given(data=st.data())
def test_inside_the_interval_a_trend_stays_within_the_bounds_of_its_values(kind: str, data: st.DataObject) -> None:
    low, high = sorted((data.draw(st.floats(-10, 10)), data.draw(st.floats(-10, 10))))
    c = data.draw(coefficients(kind, low, high))
    values = Trend(kind, c, INTERVAL)(np.linspace(T0, T1, 41))  # without bounds: nothing is clipped
    slack = 1e-12 * max(abs(low), abs(high), 1e-300)
    assert values.min() >= low - slack
    assert values.max() <= high + slack


@pytest.mark.parametrize("kind", [name for name, kind in KINDS.items() if kind.monotone])
@given(data=st.data())
def test_monotone_kinds_go_one_way(kind: str, data: st.DataObject) -> None:
    c = data.draw(coefficients(kind, 0.0, 1.0))
    steps = np.diff(Trend(kind, c, INTERVAL)(np.linspace(T0 - 3, T1 + 3, 200)))
    assert (steps >= -1e-12).all() or (steps <= 1e-12).all()


def test_a_cubic_is_not_declared_monotone() -> None:
    assert not KINDS["cubic"].monotone
    steps = np.diff(Trend("cubic", NUMBERS["cubic"], INTERVAL)(np.linspace(T0, T1, 50)))
    assert steps.min() < 0 < steps.max()


@every_kind
@given(data=st.data())
def test_extrapolation_is_finite_and_within_bounds(kind: str, data: st.DataObject) -> None:
    c = data.draw(coefficients(kind, 0.1, 0.9))
    trend = Trend(kind, c, INTERVAL, (0.0, 1.0))
    hours = data.draw(st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=5))
    values = trend(hours)
    assert ((values >= 0) & (values <= 1)).all()
    assert np.isfinite(Trend(kind, c, INTERVAL)(hours)).all()


def test_extrapolation_meets_the_bound() -> None:
    trend = Trend("linear", NUMBERS["linear"], INTERVAL, (0.0, 0.75))
    assert trend(T1 + 5) == 0.75
    assert trend(T0 - 50) == 0.0


def test_long_before_the_start_equal_ends_stay_equal() -> None:
    trend = Trend("exponential", {"start": 0.5, "end": 0.5, "time_constant": 0.01}, INTERVAL)
    assert trend(-1e5) == 0.5


def test_a_spline_goes_straight_on_beyond_its_ends() -> None:
    trend = Trend("monotone_spline", NUMBERS["monotone_spline"], INTERVAL)
    outside = trend([T1, T1 + 1, T1 + 2])
    assert_allclose(np.diff(outside, 2), 0, atol=1e-14)
    assert outside[1] < outside[0]


# ---------------------------------------------------------------- Errors of a value


@pytest.mark.parametrize("kind", ["linear", "exponential", "logistic", "cubic"])
@both
def test_standard_errors_against_monte_carlo(kind: str, channels: int | None) -> None:
    c = channelled(kind, channels)
    mean = flat(Trend(kind, c, INTERVAL))
    rng = np.random.default_rng(7)
    root = 2e-4 * rng.standard_normal((len(mean), len(mean)))
    covariance = root @ root.T  # coefficients that are correlated
    hours = np.array([T0, 3.0, 5.2, T1, T1 + 3])
    drawn = multivariate_normal(mean, covariance, allow_singular=True).rvs(20_000, random_state=8)
    names = [(c_.name, np.ndim(c[c_.name])) for c_ in KINDS[kind].coefficients]
    values, start = {}, 0
    for name, wide in names:
        n = channels if wide and channels else 1
        values[name] = drawn[:, None, start : start + n]
        start += n
    basis = [b[:, None] for b in KINDS[kind].basis(hours, *INTERVAL)]
    sampled = np.broadcast_to(evaluate(kind, basis, values)[0], (20_000, len(hours), channels or 1)).std(axis=0)
    found = Trend(kind, c, INTERVAL, covariance=covariance).stderr(hours).reshape(len(hours), -1)
    assert_allclose(found, sampled, rtol=0.03)


def test_without_a_covariance_the_error_is_not_known() -> None:
    assert np.isnan(Trend("linear", NUMBERS["linear"], INTERVAL).stderr([2.0, 3.0])).all()
    nothing = Trend("linear", NUMBERS["linear"], INTERVAL, covariance=np.full((2, 2), np.nan))
    assert np.isnan(nothing.stderr(2.0)).all()


def test_a_coefficient_that_is_not_determined_counts_as_known() -> None:
    half = np.array([[np.nan, np.nan], [np.nan, 0.04]])
    trend = Trend("linear", NUMBERS["linear"], INTERVAL, covariance=half)
    assert_allclose(trend.stderr([T0, (T0 + T1) / 2, T1]), [0, 0.1, 0.2], atol=1e-15)


# ---------------------------------------------------------------- Disk


@every_kind
@both
@pytest.mark.parametrize("bounds", [(-np.inf, np.inf), (0.0, np.inf), (0.0, 1.5)])
def test_json_gives_it_back(kind: str, channels: int | None, bounds: tuple[float, float]) -> None:
    bare = Trend(kind, channelled(kind, channels), INTERVAL)
    covariance = np.eye(len(flat(bare)))
    covariance[0, 0] = np.nan
    trend = Trend(kind, bare.coefficients, INTERVAL, bounds, covariance)
    again = trend_from_dict(json.loads(json.dumps(trend.to_dict(), allow_nan=False)))
    assert isinstance(again, Trend)
    assert (again.kind, again.interval, again.bounds) == (kind, INTERVAL, bounds)
    assert_array_equal(flat(again), flat(trend))
    assert_array_equal(again.covariance, covariance)
    assert_array_equal(again([2.0, 9.0]), trend([2.0, 9.0]))


# ---------------------------------------------------------------- Bad input


@pytest.mark.parametrize(
    ("kind", "c", "interval", "message"),
    [
        ("parabola", {"value": 1}, INTERVAL, "'parabola' is not one of constant, linear"),
        ("linear", {"start": 1}, INTERVAL, "a linear trend has the coefficients start, end, not start"),
        ("linear", {"start": 1, "end": 2, "slope": 3}, INTERVAL, "has the coefficients start, end, not"),
        ("linear", {"start": 1, "end": np.nan}, INTERVAL, "is not finite"),
        ("linear", {"start": [1, np.inf], "end": [1, 2]}, INTERVAL, "is not finite"),
        ("linear", {"start": [1, 2], "end": [1, 2, 3]}, INTERVAL, "have the shapes"),
        ("linear", {"start": [[1, 2]], "end": 1}, INTERVAL, "have the shapes"),
        ("linear", {"start": [], "end": []}, INTERVAL, "have the shapes"),
        ("exponential", {"start": 1, "end": 2, "time_constant": 0}, INTERVAL, "time_constant .* not above 0"),
        ("exponential", {"start": 1, "end": 2, "time_constant": [1, 2]}, INTERVAL, "time_constant .* one number"),
        ("logistic", {"start": 1, "end": 2, "middle": 1, "width": -1}, INTERVAL, "width .* is -1 h, not above 0"),
        ("monotone_spline", {**NUMBERS["monotone_spline"], "share1": 1.2}, INTERVAL, r"share1 .* outside \[0, 1\]"),
        ("constant", {"value": 1}, (2.0, 1.0), "interval 2 to 1 h of a trend does not go forward"),
        ("constant", {"value": 1}, (1.0, 1.0), "does not go forward"),
        ("constant", {"value": 1}, (0.0, np.nan), "does not go forward"),
        ("constant", {"value": 1}, (0.0, np.inf), "does not go forward"),
    ],
)
def test_bad_trends_are_refused(kind: str, c: dict[str, Any], interval: tuple[float, float], message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        Trend(kind, c, interval)


@pytest.mark.parametrize("bounds", [(1.0, 0.0), (np.nan, 1.0)])
def test_bounds_the_wrong_way_round_are_refused(bounds: tuple[float, float]) -> None:
    with pytest.raises(ParameterError, match="wrong way round"):
        Trend("constant", {"value": 1.0}, INTERVAL, bounds)


# ---------------------------------------------------------------- Tabulated


def test_a_table_is_straight_between_its_points_and_held_beyond() -> None:
    table = Tabulated(np.array([0.0, 1.0, 3.0]), np.array([1.0, 2.0, 0.0]))
    assert_allclose(table([-5.0, 0.0, 0.5, 2.0, 3.0, 9.0]), [1.0, 1.0, 1.5, 1.0, 0.0, 0.0])
    assert table(np.zeros((2, 3))).shape == (2, 3)
    assert table(0.5).shape == ()
    assert table.interval == (0.0, 3.0)


def test_a_table_with_channels() -> None:
    table = Tabulated(np.array([0.0, 2.0]), np.array([[0.0, 1.0], [1.0, 3.0]]))
    assert_allclose(table([0.5, 1.0]), [[0.25, 1.5], [0.5, 2.0]])
    assert table(1.0).shape == (2,)
    again = trend_from_dict(json.loads(json.dumps(table.to_dict())))
    assert isinstance(again, Tabulated)
    assert_array_equal(again.values, table.values)
    assert_array_equal(again.hours, table.hours)


@pytest.mark.parametrize(
    ("hours", "values"),
    [([0.0, 0.0], [1.0, 2.0]), ([1.0, 0.0], [1.0, 2.0]), ([0.0, 1.0], [1.0]), ([], []), ([[0.0]], [1.0])],
)
def test_bad_tables_are_refused(hours: list[Any], values: list[float]) -> None:
    with pytest.raises(DataError, match="increasing times and as many values"):
        Tabulated(np.array(hours), np.array(values))


# ---------------------------------------------------------------- Materials


MATERIAL = Material(
    OrenNayar(K_d=(0.5, 0.4, 0.3), sigma_d=0.3) + TorranceSparrow(K_s=0.3, sigma_s=0.15),
    channels=("R", "G", "B"),
    trends={
        "K_d": Trend(
            "logistic", {"start": (0.3, 0.2, 0.1), "end": (0.6, 0.5, 0.4), "middle": 3.0, "width": 0.5}, INTERVAL
        ),
        "K_s": Trend("exponential", NUMBERS["exponential"], INTERVAL, (0.0, np.inf)),
        "sigma_s": Tabulated(np.array([T0, T1]), np.array([0.1, 0.3])),
    },
)


def directions(n: int) -> np.ndarray:
    theta = np.linspace(0.1, 1.2, n)
    return np.stack([np.sin(theta), np.zeros(n), np.cos(theta)], axis=-1)


def test_a_material_at_many_times_is_the_material_at_each() -> None:
    hours = np.array([T0, 2.0, 4.4, T1, 20.0])
    wi, wo = directions(6), directions(6)[::-1]
    many = MATERIAL.at(hours).eval(wi, wo)
    assert many.shape == (5, 6, 3)
    for k, t in enumerate(hours):
        now = MATERIAL.at(float(t))
        assert_allclose(now.parameters["K_s"], formula("exponential", t, NUMBERS["exponential"]), rtol=1e-12)
        assert_allclose(many[k], now.eval(wi, wo), rtol=1e-13)
    assert MATERIAL.interval == INTERVAL


def test_a_material_with_trends_comes_back_from_json() -> None:
    again = Material.from_dict(json.loads(json.dumps(MATERIAL.to_dict(), allow_nan=False)))
    for t in (0.0, T0, 3.3, 30.0):
        assert again.at(t) == MATERIAL.at(t)


def test_a_trend_of_a_parameter_that_is_not_there_is_refused() -> None:
    with pytest.raises(MotesError, match="no parameter 'tau' to follow a trend"):
        Material(MATERIAL.brdf, trends={"tau": Trend("constant", {"value": 0.0}, INTERVAL)})


@pytest.mark.parametrize(
    "data",
    [
        {},
        {"kind": "tabulated"},
        {"kind": "tabulated", "hours": [0, 1]},
        {"kind": "tabulated", "hours": [0, 10**400], "values": [1, 1]},
        {"kind": "linear", "coefficients": {"start": 1, "end": 2}},
        {"kind": "linear", "coefficients": [1], "interval_h": [0, 1]},
        {"kind": {}, "coefficients": {"start": 1, "end": 2}, "interval_h": [0, 1]},
        {"kind": "linear", "coefficients": {"start": 10**400, "end": 2}, "interval_h": [0, 1]},
        {"kind": "linear", "coefficients": {"start": 1, "end": 2}, "interval_h": [0, 10**400]},
    ],
)
def test_damaged_trends_are_refused_with_a_next_step(data: dict[str, Any]) -> None:
    with pytest.raises(MotesError) as caught:
        trend_from_dict(data)
    assert caught.value.hint
