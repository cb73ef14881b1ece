"""Formulas by fewer operations: the same values, the rules one by one, and what must not be touched."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pytest

from catalogue import ENTRIES, Entry
from motes.arrays import NUMPY
from motes.graph import tracing
from motes.graph.tracing import Graph, Symbol, Trace, TracedParameter
from motes.kernels.cheaper import cheaper

# As of NumPy, in which the values are compared.
POWERS = {
    "exp2": np.exp2,
    "exp2_below": np.exp2,
    "exp2m1": lambda x: np.expm1(x * math.log(2)),
    "exp2m1_below": lambda x: np.expm1(x * math.log(2)),
    "asin_near": np.arcsin,
}


class Case:
    """A graph with a direction's components x, y, z and parameters a, b (not negative), c."""

    def __init__(self) -> None:
        self.graph = Graph()
        self.x, self.y, self.z = (self.graph.leaf(name) for name in "xyz")
        self.parameters = tuple(
            TracedParameter(name, None, self.graph.leaf(name), least)
            for name, least in (("a", 0.0), ("b", 0.0), ("c", -math.inf))
        )
        self.a, self.b, self.c = (p.symbol for p in self.parameters)

    def written(self, *outputs: Symbol, held: Sequence[Symbol] = ()) -> list[Symbol]:
        trace = Trace(self.graph, (self.x, self.y, self.z), self.parameters, outputs)
        return cheaper(trace, trace.leaves(), held)

    def count(self, outputs: Sequence[Symbol], *ops: str) -> int:
        return sum(symbol.op in ops and not self._beforehand(symbol) for symbol in tracing.live(outputs))

    def _beforehand(self, symbol: Symbol) -> bool:
        return not {self.x, self.y, self.z} & set(tracing.live([symbol]))


def computed(outputs: Sequence[Symbol], values: dict[Symbol, float]) -> list[float]:
    """Values of symbols, the words that programs of vectors alone have among them."""
    found: dict[Symbol, np.float64] = {symbol: np.float64(value) for symbol, value in values.items()}
    for symbol in tracing.live(outputs):
        args = [found[a] for a in symbol.args]
        if symbol.op in POWERS:
            found[symbol] = POWERS[symbol.op](*args)
        elif symbol.op == "constant":
            found[symbol] = np.float64(symbol.value) if not isinstance(symbol.value, bool) else np.bool_(symbol.value)
        elif symbol not in found:
            found[symbol] = tracing.compute(NUMPY, symbol.op, *args)
    return [float(found[symbol]) for symbol in outputs]


@pytest.mark.parametrize("entry", ENTRIES, ids=str)
def test_models_have_the_same_values(entry: Entry) -> None:
    channels = entry.model.channels
    trace = tracing.trace(entry.model, channels)
    outputs = cheaper(trace, trace.leaves())
    slots = {slot.name: slot.value for slot in entry.model.slots()}
    values = {p.symbol: float(p.of(np.ravel(slots[p.slot]))) for p in trace.parameters}
    rng = np.random.default_rng(3)
    for k in range(20):
        w = rng.normal(size=(2, 3))
        w /= np.linalg.norm(w, axis=1, keepdims=True)
        if k > 2:
            w[:, 2] = np.abs(w[:, 2])
        given = values | dict(zip(trace.directions, map(float, w.ravel()), strict=True))
        with np.errstate(all="ignore"):
            expected, found = computed(trace.outputs, given), computed(outputs, given)
        np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-13)
    before, after = (sum(s.op in ("div", "mul") for s in tracing.live(o)) for o in (trace.outputs, outputs))
    assert after <= 1.3 * before + 8  # constants, which are computed beforehand, are counted too


def test_constants_are_multiplied_beforehand() -> None:
    case = Case()
    outputs = case.written(case.a * (case.b * case.graph.sqrt(case.x)) + case.y)
    assert case.count(outputs, "mul") == 1
    held = case.written(case.a * (case.b * case.graph.sqrt(case.x)) + case.y, held=[case.a, case.b])
    assert case.count(held, "mul") == 2


def test_numbers_leave_squares_and_parameters_stay() -> None:
    case = Case()
    root = 0.5 * case.x
    assert case.count(case.written(root * root * case.a), "mul") == 2
    root = case.c * case.x  # its square might be no number of float32
    outputs = case.written(root * root)
    assert case.count(outputs, "mul") == 2
    assert case.c in tracing.frontier(outputs, tracing.dependence(outputs, {case.x: 1, case.c: 2}), 2)


def test_one_division_for_several() -> None:
    case = Case()
    clamped = [case.graph.maximum(w, 1e-6) for w in (case.x, case.y)]
    outputs = case.written(case.z / clamped[0] / clamped[1])
    assert case.count(outputs, "div") == 1
    outputs = case.written((case.z / clamped[0]) * (case.x / clamped[1]))
    assert case.count(outputs, "div") == 1
    small = [case.graph.maximum(w, 1e-20) for w in (case.x, case.y)]
    assert case.count(case.written(case.z / small[0] / small[1]), "div") == 2, "their product may be no float32"
    assert case.count(case.written(case.z / (case.x + 1) / (case.y + 1)), "div") == 2, "nothing is known of either"


def test_common_factors_leave_extrema_and_comparisons() -> None:
    case = Case()
    root = case.graph.sqrt(case.z)
    first, second = case.x * root, case.y * root
    chosen = case.graph.where(first < second, case.graph.minimum(first, second), case.z)
    outputs = case.written(chosen)
    assert case.count(outputs, "mul") == 1
    first, second = case.x * case.z, case.y * case.z  # z may be negative
    assert case.count(case.written(case.graph.minimum(first, second)), "mul") == 2


def test_clamps_that_do_nothing_are_left_out() -> None:
    case = Case()
    square = case.x * case.x + case.graph.sqrt(case.y)
    (output,) = case.written(case.graph.maximum(square, 0.0) * case.z)
    assert case.count([output], "maximum") == 0
    (output,) = case.written(case.graph.maximum(case.x, 0.0))
    assert case.count([output], "maximum") == 1
    (output,) = case.written(case.graph.maximum(case.graph.minimum(case.x, 0.0), 0.0))
    assert output.op == "sub"  # 0 or NaN
    assert math.isnan(computed([output], {case.x: math.nan})[0])


def test_exponentials_are_to_the_base_2() -> None:
    case = Case()
    falling, rising = case.graph.exp(-(case.a * case.graph.sqrt(case.x))), case.graph.expm1(case.c * case.x)
    outputs = case.written(falling, rising)
    assert [symbol.op for symbol in outputs] == ["exp2_below", "exp2m1"]
    assert case.count(outputs, "mul") == 2
    width = case.graph.exp(-((case.x / case.c) * (case.x / case.c)))
    (output,) = case.written(width)
    assert output.op == "exp2_below"
    assert case.count([output], "mul") == 2
    (output,) = case.written(case.graph.exp(case.a) * case.x)
    assert case.count([output], "exp", "exp2") == 0, "what depends on parameters alone stays as it is"
