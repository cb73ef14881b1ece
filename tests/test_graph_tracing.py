"""Expression graphs: recording, folding, derivatives, and what depends on what."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from catalogue import ENTRIES, SPECIAL_WI, SPECIAL_WO, Entry, upper_directions
from motes.arrays import NUMPY, is_foreign, namespace
from motes.directions import Geometry, Vector
from motes.graph import tracing
from motes.graph.tracing import Graph, Symbol
from motes.models import DustLayer, Lambert, OrenNayar, TorranceSparrow
from motes.models.slants import inverses

entries = pytest.mark.parametrize("entry", ENTRIES, ids=str)


def leaves(graph: Graph, names: str) -> list[Symbol]:
    return [graph.leaf(name) for name in names.split()]


# ---------------------------------------------------------------- Recording


def test_equal_expressions_are_one_symbol() -> None:
    graph = Graph()
    a, b, c = leaves(graph, "a b c")
    assert graph.leaf("a") is a
    assert a * b + c is b * a + c
    assert graph.minimum(a, b) is graph.minimum(b, a)
    assert a - b is not b - a
    assert (a + b) + c is not a + (b + c), "the author's order is kept"
    assert 2 * a is a * 2.0
    assert graph.where(a > b, a, c) is graph.where(a > b, a, c)


def test_operations_with_constants_are_folded() -> None:
    graph = Graph()
    a, b = leaves(graph, "a b")
    two = graph.constant(2)
    assert (two * 3 + 1).is_constant(7)
    assert graph.sqrt(two * 8).is_constant(4)
    assert math.isnan((graph.constant(0) / 0).value)
    assert graph.constant(1).is_constant(1)
    assert not graph.constant(True).is_constant(1), "a truth value is not a number"
    assert graph.constant(0.0) is not graph.constant(-0.0)
    for same in (
        a + 0,
        0 + a,
        a - 0,
        a * 1,
        1 * a,
        a / 1,
        graph.apply("neg", -a),
        graph.maximum(a, a),
        graph.where(a > 0, a, a),
    ):
        assert same is a
    assert 0 - a is -a
    assert -1 * a is -a
    assert a + -b is a - b
    minus_b = -b
    assert a - minus_b is a + b
    assert (a * 0).is_constant(0)
    assert (0 / a).is_constant(0)
    assert graph.where(two > 1, a, 5.0) is a
    assert graph.where(two < 1, a, 5.0).is_constant(5)
    assert graph.where(True, a, 5.0) is a


def test_numpy_scalars_mix_with_symbols() -> None:
    graph = Graph()
    (a,) = leaves(graph, "a")
    assert np.float64(2) * a is 2 * a
    assert a - np.float32(0.5) is a - 0.5
    assert is_foreign(a)
    assert namespace(1.0, a) is graph


def test_a_symbol_has_no_truth_value() -> None:
    a, b = leaves(Graph(), "a b")
    with pytest.raises(TypeError, match=r"xp\.where"):
        bool(a < b)


def test_symbols_of_two_graphs_do_not_mix() -> None:
    (a,), (b,) = leaves(Graph(), "a"), leaves(Graph(), "b")
    with pytest.raises(ValueError, match="another graph"):
        a + b


def test_unused_operations_are_not_live() -> None:
    graph = Graph()
    a, b = leaves(graph, "a b")
    unused = graph.exp(a * b)
    order = tracing.live([graph.sqrt(a)])
    assert unused not in order
    assert b not in order
    assert all(argument in order[:k] for k, symbol in enumerate(order) for argument in symbol.args)


@entries
def test_a_recorded_model_is_the_model_bit_for_bit(entry: Entry) -> None:
    model = entry.model
    wi = np.concatenate([upper_directions(200, 1), SPECIAL_WI])
    wo = np.concatenate([upper_directions(200, 2), SPECIAL_WO])
    trace = tracing.trace(model, model.channels)
    values = {slot.name: np.ravel(slot.value) for slot in model.slots()}
    given: dict[Symbol, object] = {p.symbol: values[p.slot][p.channel or 0] for p in trace.parameters}
    given |= dict(zip(trace.directions, [*wi.T, *wo.T], strict=True))
    with np.errstate(all="ignore"):
        recorded = tracing.evaluate(NUMPY, trace.outputs, given)
        direct = model.value(NUMPY, Geometry(NUMPY, Vector.of(wi), Vector.of(wo)))
    recorded = np.stack([np.broadcast_to(x, len(wi)) for x in recorded], axis=-1)
    np.testing.assert_array_equal(recorded, np.broadcast_to(direct, recorded.shape))


def test_parameters_are_leaves_for_a_channel_or_for_all() -> None:
    model = OrenNayar((0.1, 0.2), 0.3) + Lambert(0.5)
    found = [(p.slot, p.channel, p.symbol.value) for p in tracing.trace(model, 2).parameters]
    assert found == [
        ("K_d", 0, "K_d[0]"),
        ("K_d", 1, "K_d[1]"),
        ("sigma_d", None, "sigma_d"),
        ("K_d_2", None, "K_d_2"),
    ]


def test_keys_tell_structures_apart_and_not_values() -> None:
    def key(model: OrenNayar | TorranceSparrow | DustLayer) -> tuple[object, ...]:
        return tracing.key(model, model.channels)

    assert key(OrenNayar(0.1)) == key(OrenNayar(0.2))
    assert key(OrenNayar(0.1)) != key(OrenNayar((0.1, 0.2)))
    assert key(OrenNayar((0.1, 0.2))) == key(OrenNayar((0.3, 0.2)))
    assert key(TorranceSparrow()) != key(TorranceSparrow(normalization="facets"))
    assert key(DustLayer(OrenNayar())) != key(DustLayer(Lambert()))


def test_channels_share_what_does_not_depend_on_them() -> None:
    model = OrenNayar((0.5, 0.4, 0.3))
    one, three = (len(tracing.live(tracing.trace(model, n).outputs)) for n in (1, 3))
    assert three < one + 40, "only what depends on K_d is there three times"


# ---------------------------------------------------------------- Derivatives

UNARY: dict[str, tuple[Callable[[Graph, Symbol], Symbol], Callable[[float], float]]] = {
    "neg": (lambda g, x: -x, lambda x: -1.0),
    "sqrt": (lambda g, x: g.sqrt(x), lambda x: 0.5 / math.sqrt(x)),
    "exp": (lambda g, x: g.exp(x), math.exp),
    "expm1": (lambda g, x: g.expm1(x), math.exp),
    "asin": (lambda g, x: g.asin(x), lambda x: 1 / math.sqrt(1 - x * x)),
    "inverse": (lambda g, x: 1 / x, lambda x: -1 / (x * x)),
    "square": (lambda g, x: x * x, lambda x: 2 * x),
    "difference": (lambda g, x: 3 - x, lambda x: -1.0),
    "maximum": (lambda g, x: g.maximum(x, 0.2), lambda x: 1.0 if x > 0.2 else 0.0),
    "minimum": (lambda g, x: g.minimum(0.2, x), lambda x: 1.0 if x < 0.2 else 0.0),
    "where": (lambda g, x: g.where(x < 0.2, 3 * x, 5.0), lambda x: 3.0 if x < 0.2 else 0.0),
}


@pytest.mark.parametrize("name", UNARY)
@pytest.mark.parametrize("x", [0.05, 0.7])
def test_derivatives_of_each_operation(name: str, x: float) -> None:
    operation, expected = UNARY[name]
    graph = Graph()
    (leaf,) = leaves(graph, "x")
    output = operation(graph, leaf)
    (forward,) = tracing.forward([output], [leaf])
    backward = tracing.adjoint({output: graph.constant(1.0)}, [leaf])
    for slopes in (forward, backward):
        (value,) = tracing.evaluate(NUMPY, [slopes.get(leaf, graph.constant(0.0))], {leaf: np.float64(x)})
        assert value == pytest.approx(expected(x), rel=1e-14)


def random_formula(rng: np.random.Generator, graph: Graph, inputs: list[Symbol], steps: int) -> Symbol:
    """A random smooth expression (away from kinks almost surely), its values of moderate size."""
    pool = list(inputs)
    for _ in range(steps):
        a, b, c = (pool[k] for k in rng.integers(0, len(pool), 3))
        bounded = a / (1 + a * a)
        choice = rng.integers(0, 9)
        pool.append(
            [
                lambda a=a, b=b: a + b,
                lambda a=a, b=b: a - 0.5 * b,
                lambda x=bounded, b=b: x * b,
                lambda a=a, b=b: a / (1 + b * b),
                lambda x=bounded: graph.exp(x),
                lambda x=bounded: graph.expm1(-x),
                lambda x=bounded: graph.asin(x),
                lambda a=a: graph.sqrt(1 + a * a),
                lambda a=a, b=b, c=c: graph.where(c < 0.1, graph.maximum(a, b), graph.minimum(a, 2 * b)),
            ][choice]()
        )
    return pool[-1] + pool[len(pool) // 2]


@pytest.mark.parametrize("seed", range(30))
def test_forward_adjoint_and_differences_agree_on_random_formulas(seed: int) -> None:
    rng = np.random.default_rng(seed)
    graph = Graph()
    inputs = leaves(graph, "a b c d")
    outputs = [random_formula(rng, graph, inputs, 25) for _ in range(2)]
    weights = [0.7, -1.3]
    combined = weights[0] * outputs[0] + weights[1] * outputs[1]
    (forward,) = tracing.forward([combined], inputs)
    seeds: dict[Symbol, Symbol] = {}
    for output, weight in zip(outputs, weights, strict=True):
        seeds[output] = seeds.get(output, graph.constant(0.0)) + weight
    backward = tracing.adjoint(seeds, inputs)
    point = dict(zip(inputs, rng.uniform(-1, 1, 4), strict=True))
    zero = graph.constant(0.0)
    for leaf in inputs:
        slopes = tracing.evaluate(NUMPY, [forward.get(leaf, zero), backward.get(leaf, zero)], point)
        step = 1e-5
        high, low = (tracing.evaluate(NUMPY, [combined], point | {leaf: point[leaf] + h})[0] for h in (step, -step))
        np.testing.assert_allclose(slopes[0], slopes[1], rtol=1e-10, atol=1e-12)
        np.testing.assert_allclose(slopes[0], (high - low) / (2 * step), rtol=1e-6, atol=1e-7)


def test_what_is_zero_by_structure_is_absent() -> None:
    graph = Graph()
    a, b, c = leaves(graph, "a b c")
    product = a * b
    (forward,) = tracing.forward([product], [a, b, c])
    assert set(forward) == {a, b}
    assert forward[a] is b
    assert set(tracing.adjoint({product: graph.constant(1.0)}, [a, c])) == {a}
    assert tracing.forward([graph.where(c > 0, 1.0, 2.0)], [c]) == [{}]


def test_powers_are_differentiated_without_a_way_through_what_they_are_made_of() -> None:
    graph = Graph()
    numbers = [graph.leaf(name) for name in "abcd"]
    point = dict(zip(numbers, (1.3, 0.4, 2.1, 0.9), strict=True))
    over = inverses(*numbers)
    for number, inverse in zip(numbers, over, strict=True):
        for slopes in (
            tracing.forward([inverse], numbers)[0],
            tracing.adjoint({inverse: graph.constant(1.0)}, numbers),
        ):
            assert set(slopes) == {number}, "what cancels is absent"
            (found,) = tracing.evaluate(NUMPY, [slopes[number]], point)
            assert found == pytest.approx(-1 / point[number] ** 2)
    a = numbers[0]
    for product in (a * graph.sqrt(a), graph.sqrt(a) * a):
        (found,) = tracing.evaluate(NUMPY, [tracing.adjoint({product: graph.constant(1.0)}, [a])[a]], {a: 1.3})
        assert found == pytest.approx(1.5 * 1.3**0.5)


def test_no_leaf_is_passed_over() -> None:
    """The derivative by a root, a product or an inverse that is named as a leaf is by it alone."""
    graph = Graph()
    a, b = graph.leaf("a"), graph.leaf("b")
    root, one = graph.sqrt(a), graph.constant(1.0)
    slopes = tracing.adjoint({a * root: one}, [a, root])
    assert slopes[a] is root
    assert slopes[root] is a
    product = a * b
    inverse = one / product
    slopes = tracing.adjoint({b * inverse: one}, [product, b])
    assert slopes[b] is inverse
    assert set(slopes) == {product, b}
    assert set(tracing.adjoint({b * inverse: one}, [inverse, a])) == {inverse}


def test_the_derivative_by_a_symbol_holds_the_others_fixed() -> None:
    graph = Graph()
    (a,) = leaves(graph, "a")
    square = a * a
    output = square * a
    slopes = tracing.adjoint({output: graph.constant(1.0)}, [square, a])
    assert slopes[square] is a
    assert slopes[a] is square


@pytest.mark.parametrize(
    ("formula", "at"),
    [
        (lambda g, x: g.sqrt(x * x), 0.0),
        (lambda g, x: g.maximum(g.sqrt(x), 0.0), 0.0),
        (lambda g, x: g.asin(1 - x), 0.0),
        (lambda g, x: g.asin(g.minimum(1.0, 1 - x)) * x, 0.0),
        (lambda g, x: g.maximum(x, -x), 0.0),
        (lambda g, x: g.minimum(x, x * 1.0 + 0.0 * x), 0.3),
        (lambda g, x: g.where(x >= 0, x, -2 * x), 0.0),
    ],
)
def test_derivatives_are_never_nan_at_kinks(formula: Callable[[Graph, Symbol], Symbol], at: float) -> None:
    graph = Graph()
    (x,) = leaves(graph, "x")
    output = formula(graph, x)
    (forward,) = tracing.forward([output], [x])
    backward = tracing.adjoint({output: graph.constant(1.0)}, [x])
    for slopes in (forward, backward):
        (value,) = tracing.evaluate(NUMPY, [slopes[x]], {x: np.float64(at)})
        assert np.isfinite(value)


# ---------------------------------------------------------------- What depends on what


def test_dependence_splits_a_model_into_directions_and_parameters() -> None:
    trace = tracing.trace(DustLayer(OrenNayar() + TorranceSparrow()))
    bits = tracing.dependence(trace.outputs, trace.leaves())
    assert bits[trace.outputs[0]] == tracing.DIRECTIONS | tracing.PARAMETERS
    for bit, inside in (
        (tracing.DIRECTIONS, set(trace.directions)),
        (tracing.PARAMETERS, {p.symbol for p in trace.parameters}),
    ):
        columns = tracing.frontier(trace.outputs, bits, bit)
        assert columns
        for column in columns:
            behind = {symbol for symbol in tracing.live([column]) if symbol.op == "leaf"}
            assert behind
            assert behind <= inside
        # From both frontiers everything else can be computed.
    known = {*tracing.frontier(trace.outputs, bits, 1), *tracing.frontier(trace.outputs, bits, 2)}
    for symbol, bit in bits.items():
        if bit == tracing.DIRECTIONS | tracing.PARAMETERS:
            assert all(a in known or bits[a] == 3 or a.op == "constant" for a in symbol.args)


def test_rewriting_replaces_operations_and_keeps_the_rest() -> None:
    graph = Graph()
    a, b = leaves(graph, "a b")
    output, other = graph.exp(a / b) + a, a - b
    rule = lambda symbol, args: args[0] * (1 / args[1]) if symbol.op == "div" else None  # noqa: E731
    new = tracing.rewritten([output, other], rule)
    assert new[0] is graph.exp(a * (1 / b)) + a
    assert new[1] is other
    assert all(symbol.op != "div" or symbol.args[0].is_constant(1) for symbol in tracing.live(new))


def test_a_squared_leaf_gives_the_same_values_and_a_slope_at_zero() -> None:
    """Oren-Nayar depends on sigma_d^2: in that coordinate nothing is left of the root, and the slope at 0 is the limit."""
    model = OrenNayar(K_d=0.6, sigma_d=0.3)
    plain, square = tracing.trace(model), tracing.trace(model, squared=("sigma_d",))
    leaf = next(p.symbol for p in square.parameters if p.slot == "sigma_d")
    assert not any(s.op == "sqrt" and s.args[0] is leaf for s in tracing.live(square.outputs))
    w = np.array([[0.3, 0.1, 0.9], [-0.6, 0.2, 0.7]])
    w /= np.linalg.norm(w, axis=1, keepdims=True)

    def value(trace: tracing.Trace, sigma: float, slopes: bool = False) -> float:
        leaves = dict(zip(trace.directions, w.ravel(), strict=True))
        given = {"K_d": 0.6, "sigma_d": sigma}
        leaves |= {p.symbol: np.float64(given[p.slot]) for p in trace.parameters}
        outputs = trace.outputs
        if slopes:
            outputs = [tracing.forward(outputs, [leaf])[0][leaf]]
        return float(tracing.evaluate(NUMPY, outputs, leaves)[0])

    for sigma in (0.0, 0.2, 1.1):
        assert value(square, sigma**2) == pytest.approx(value(plain, sigma), rel=1e-14)
    step = 1e-6
    difference = (value(square, step) - value(square, 0.0)) / step
    assert value(square, 0.0, slopes=True) == pytest.approx(difference, rel=1e-4)
    assert abs(difference) > 1e-3
