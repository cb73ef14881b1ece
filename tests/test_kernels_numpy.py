"""The functions that fits call: values and derivatives of a model as straight-line NumPy."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from catalogue import ENTRIES, SPECIAL_WI, SPECIAL_WO, Entry, reference, upper_directions
from motes.graph.symbols import Graph
from motes.kernels.numpy import function_of_numbers, residual_function, scalar_function
from motes.kernels.parameters_alone import FEW, Alone, Results, found
from motes.models import BRDF, CoatedDiffuse, DustLayer, Lambert, OrenNayar, TorranceSparrow

entries = pytest.mark.parametrize("entry", ENTRIES, ids=str)
WI = np.concatenate([upper_directions(40, 3), SPECIAL_WI])
WO = np.concatenate([upper_directions(40, 4), SPECIAL_WO])


def stacked(model: BRDF, sets: int = 1) -> dict[str, NDArray[np.float64]]:
    """The values of a model's parameters, `sets` times: (B, 1, C) or (B, 1, 1)."""
    return {
        slot.name: np.repeat(np.reshape(np.asarray(slot.value, float), (1, 1, -1)), sets, axis=0)
        for slot in model.slots()
    }


@entries
def test_values_are_those_of_the_model(entry: Entry) -> None:
    function = residual_function(entry.model, [])
    f = function.values(function.geometry(WI, WO), stacked(entry.model))
    expected = reference(entry.model, WI, WO)
    np.testing.assert_array_equal(np.broadcast_to(f[0], expected.shape), expected)


@entries
def test_derivatives_match_differences(entry: Entry) -> None:
    model = entry.model
    names = [slot.name for slot in model.slots()]
    function = residual_function(model, names)
    geometry = function.geometry(WI, WO)
    parameters = stacked(model)
    f, jacobian = function.values_and_jacobian(geometry, parameters)
    np.testing.assert_array_equal(f, function.values(geometry, parameters))
    assert list(jacobian) == names
    for name in names:
        step = 1e-6 * np.maximum(np.abs(parameters[name]), 0.1)
        high, low = (function.values(geometry, parameters | {name: parameters[name] + h}) for h in (step, -step))
        differences = (high - low) / (2 * step)
        rounding = 4e-16 * np.abs(f) / step  # what the rounding of two values makes of their difference
        error = np.abs(jacobian[name] - differences)
        assert (error <= 1e-6 * np.abs(differences) + rounding + 1e-9).all(), name
        assert np.isfinite(jacobian[name]).all()


def test_many_sets_at_once_are_each_on_its_own() -> None:
    model = DustLayer(OrenNayar((0.8, 0.7, 0.6)) + TorranceSparrow())
    rng = np.random.default_rng(5)
    parameters = {
        name: value * rng.uniform(0.5, 1.1, (6, *value.shape[1:])) for name, value in stacked(model, 6).items()
    }
    function = residual_function(model, ["K_d", "K_s", "tau"])
    geometry = function.geometry(WI, WO)
    f, jacobian = function.values_and_jacobian(geometry, parameters)
    assert f.shape == (6, len(WI), 3)
    assert jacobian["K_s"].shape == (6, len(WI), 1), "a derivative that all channels share is computed once"
    assert jacobian["K_d"].shape == (6, len(WI), 3)
    for k in range(6):
        one = {name: value[k : k + 1] for name, value in parameters.items()}
        f_k, jacobian_k = function.values_and_jacobian(geometry, one)
        np.testing.assert_array_equal(f[k], f_k[0])
        for name in jacobian:
            np.testing.assert_array_equal(jacobian[name][k], jacobian_k[name][0])


@entries
def test_few_sets_and_many_give_the_same_to_the_last_digit(entry: Entry) -> None:
    model, few = entry.model, 2
    names = [slot.name for slot in model.slots()]
    coloured = [name for name, value in stacked(model).items() if value.size > 1]
    function = residual_function(model, names, per_channel=coloured)
    geometry = function.geometry(WI, WO)
    shades = np.linspace(1, 0.97, 3 * FEW)[:, None, None]
    many = {name: np.repeat(value, 3 * FEW, axis=0) * shades for name, value in stacked(model).items()}
    f, jacobian = function.values_and_jacobian(geometry, many)
    g, slopes = function.values_and_jacobian(geometry, {name: value[:few] for name, value in many.items()})
    np.testing.assert_array_equal(f[:few], g)
    for name in names:
        slope = np.broadcast_to(jacobian[name], (3 * FEW, *f.shape[1:]))
        np.testing.assert_array_equal(slope[:few], np.broadcast_to(slopes[name], g.shape))
        assert jacobian[name].shape[1:] == slopes[name].shape[1:], name


def test_what_depends_on_parameters_alone_is_worked_out_in_numbers_for_a_few_sets() -> None:
    """Over arrays NumPy stops at each of thousands of operations for half a microsecond."""
    model = DustLayer(CoatedDiffuse((0.5, 0.4, 0.3)), scattering="multiple")
    function = residual_function(model, ["tau"], per_channel=["rho", "w"])
    counted = Counter[str]()

    def counting(kind: str, call: Callable[..., tuple[float, ...]]) -> Callable[..., tuple[float, ...]]:
        return lambda *given: (counted.update([kind]), call(*given))[1]

    counters = tuple(
        replace(one, over_arrays=counting("array", one.over_arrays), over_numbers=counting("number", one.over_numbers))
        for one in function._values.alone
    )
    assert [one.takes for one in counters] == [("n", "g", "tau"), ("rho", "w", "g", "tau")]
    function = replace(function, _values=replace(function._values, alone=counters))
    geometry = function.geometry(WI, WO)
    function.values(geometry, stacked(model, FEW // 3))
    assert counted == {"number": FEW // 3 + FEW}
    counted.clear()
    function.values(geometry, stacked(model, FEW // 3 + 1))
    assert counted == {"number": FEW // 3 + 1, "array": 1}


def test_a_division_by_zero_is_left_to_numpy() -> None:
    """What `where` leaves out may divide by zero, which Python refuses."""
    inverse = Alone(("x",), lambda before, x: (np.where(x > 0, 1 / x, 0.0),), lambda before, x: (1 / x,))
    with np.errstate(all="ignore"):
        results = found(inverse, [np.array([2.0, 0.0])], Results())
    np.testing.assert_array_equal(results.arrays[0], [0.5, 0.0])
    assert found(inverse, [np.array([2.0, 4.0])], Results()).rows == [(0.5,), (0.25,)]


def test_functions_of_numbers_are_numpy_s_to_the_last_digit() -> None:
    graph = Graph()
    a, b = graph.leaf("a"), graph.leaf("b")
    results = [graph.exp(a) / b, graph.sqrt(a - b), graph.where(a < b, a / b, graph.maximum(a, b)), a * b]
    names = {a: "a", b: "b"}
    over_numbers, over_arrays = function_of_numbers("f", names, results), scalar_function("f", names, results)
    for given in ((0.7, 0.3), (1.0, 0.0), (-1.0, 2.0), (1e300, 1e-300), (float("nan"), 1.0), (-3.0, 0.0)):
        with np.errstate(all="ignore"):
            expected = over_arrays(*map(np.float64, given))
        np.testing.assert_array_equal(over_numbers(*given), expected)


def test_any_order_of_axes_that_broadcasts_will_do() -> None:
    model = OrenNayar((0.8, 0.7, 0.6)) + TorranceSparrow()
    function = residual_function(model, ["K_d"])
    geometry, parameters = function.geometry(WI, WO), stacked(model, 2)
    turned = {name: np.swapaxes(value, 1, 2) for name, value in parameters.items()}
    f = function.values(tuple(column[:, 0] for column in geometry), turned)
    np.testing.assert_array_equal(np.swapaxes(f, 1, 2), function.values(geometry, parameters))


def test_geometry_does_not_depend_on_parameters_and_holds_nothing_twice() -> None:
    function = residual_function(DustLayer(OrenNayar() + TorranceSparrow()), ["g", "sigma_s"])
    geometry = function.geometry(WI, WO)
    assert all(column.shape == (len(WI), 1) for column in geometry)
    found = function.geometry(upper_directions(50, 1), upper_directions(50, 2))
    # What is 0 carries the NaN of one direction or the other.
    columns = [column.tobytes() for column in found if column.dtype == float and column.any()]
    assert len(columns) > 10
    assert len(set(columns)) == len(columns)
    assert "arcsin" in function.source.split("def values(")[0]
    assert "arcsin(" not in function.source.split("def values(")[1], "angles depend on directions alone"


def test_without_a_horizon_there_is_no_mask() -> None:
    model = OrenNayar(0.5) + TorranceSparrow()
    wi, wo = upper_directions(30, 1), upper_directions(30, 2)
    masked, plain = (residual_function(model, ["K_d"], horizon=horizon) for horizon in (True, False))
    assert plain is not masked
    assert len(plain.source) < len(masked.source)
    f, jacobian = plain.values_and_jacobian(plain.geometry(wi, wo), stacked(model))
    g, slopes = masked.values_and_jacobian(masked.geometry(wi, wo), stacked(model))
    np.testing.assert_array_equal(f, g)
    np.testing.assert_array_equal(jacobian["K_d"], slopes["K_d"])


def test_functions_are_made_once_for_a_structure() -> None:
    one = residual_function(OrenNayar(0.5, 0.1), ["K_d"])
    assert one is residual_function(OrenNayar((0.1, 0.2), 0.3), ["K_d"])
    assert one is not residual_function(OrenNayar(0.5, 0.1), ["sigma_d"])


def test_a_parameter_without_influence_has_derivative_zero() -> None:
    function = residual_function(Lambert(), ["K_d"])
    below = np.array([[0.0, 0.0, -1.0]])
    f, jacobian = function.values_and_jacobian(function.geometry(below, below), {"K_d": np.full((1, 1, 1), 0.5)})
    assert f.item() == 0.0
    assert jacobian["K_d"].item() == 0.0


def test_an_unknown_parameter_is_refused() -> None:
    with pytest.raises(KeyError, match="sigma_s"):
        residual_function(OrenNayar(), ["sigma_s"])
