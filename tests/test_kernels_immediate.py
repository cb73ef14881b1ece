"""Evaluation of a few directions without compiling: the same bits as the equations over NumPy, in any company, and nothing done twice."""

from __future__ import annotations

import gc
import pickle
import sys
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

from catalogue import ENTRIES, SPECIAL_WI, SPECIAL_WO, Entry, reference, upper_directions
from engine_support import risky_pairs
from motes.arrays import NUMPY, Array
from motes.directions import Geometry, Vector
from motes.errors import DataError
from motes.graph import recording, tracing
from motes.graph.recording import Kind
from motes.graph.tracing import Graph
from motes.kernels import engine, immediate, jobs
from motes.kernels.registers import program
from motes.models import BRDF, Component, Dust, DustLayer, Lambert, OrenNayar, TorranceSparrow
from motes.models.lobes import CosineLobe
from motes.parameters import parameter

entries = pytest.mark.parametrize("entry", ENTRIES, ids=str)
BY_NAME = {entry.name: entry.model for entry in ENTRIES}
DUSTY = BY_NAME["dust_layer"]
PAINT = OrenNayar((0.8, 0.7, 0.6), 0.4) + TorranceSparrow(0.3, 0.15)


def as_printed(model: BRDF, wi: Array, wo: Array) -> Array:
    """The equations over NumPy, in the precision of the directions."""
    with np.errstate(all="ignore"):
        return model.value(NUMPY, Geometry(NUMPY, Vector.of(wi), Vector.of(wo)))


def value(model: BRDF, wi: Array, wo: Array) -> Array | None:
    """Without compiling and not as the equations stand, or None."""
    found = immediate.call(Kind.VALUE, model, wi, wo)
    return None if found is None else found[0]


@entries
def test_bits_are_those_of_the_equations_over_numpy(entry: Entry) -> None:
    for name, (wi, wo) in risky_pairs(300, 1).items():
        found = value(entry.model, wi, wo)
        expected = np.broadcast_to(as_printed(entry.model, wi, wo), (300, entry.model.channels))
        np.testing.assert_array_equal(found, expected, err_msg=name)
    found = value(entry.model, SPECIAL_WI, SPECIAL_WO)
    np.testing.assert_array_equal(found, reference(entry.model, SPECIAL_WI, SPECIAL_WO))


@entries
@pytest.mark.parametrize("scalar", [np.float32, np.float64])
def test_a_direction_gives_the_same_bits_in_any_company(entry: Entry, scalar: type) -> None:
    n = 2 * immediate.BLOCK + 5
    wi, wo = (upper_directions(n, seed).astype(scalar) for seed in (2, 3))
    wi[7, 2] = -0.1  # its block looks at the horizon, the others do not
    wo[9, 2] = np.nan
    found = entry.model.eval(wi, wo)
    assert found.dtype == scalar
    assert (found[7] == 0).all()
    assert np.isnan(found[9]).all()
    for k in (0, 7, 8, 9, immediate.BLOCK, n - 1):
        np.testing.assert_array_equal(entry.model.eval(wi[k], wo[k]), found[k])
        few = slice(k, min(k + immediate.FEW + 1, n))
        np.testing.assert_array_equal(entry.model.eval(wi[few], wo[few]), found[few])


@entries
def test_float32_is_float64_within_1e_5(entry: Entry) -> None:
    wi, wo = (upper_directions(1000, seed).astype(np.float32) for seed in (4, 5))
    expected = reference(entry.model, wi.astype(np.float64), wo.astype(np.float64))
    found = entry.model.eval(wi, wo)
    assert (np.abs(found - expected) <= 1e-5 * np.maximum(np.abs(expected), 0.01)).all()


def test_nan_in_any_component_comes_out_where_the_equations_have_it() -> None:
    wi, wo = upper_directions(6, 6), upper_directions(6, 7)
    for k in range(6):
        (wi if k < 3 else wo)[k, k % 3] = np.nan
    for model in (DUSTY, PAINT, Lambert(0.5)):
        expected = np.broadcast_to(as_printed(model, wi, wo), (6, model.channels))
        np.testing.assert_array_equal(model.eval(wi, wo), expected)
        several = model.eval(np.tile(wi, (9, 1)), np.tile(wo, (9, 1)))
        np.testing.assert_array_equal(several, np.tile(expected, (9, 1)))


def test_shapes_and_types() -> None:
    wi, wo = upper_directions(5, 8), upper_directions(4, 9)
    outer = PAINT.eval(wi[:, None], wo)
    assert outer.shape == (5, 4, 3)
    np.testing.assert_array_equal(outer[3, 2], PAINT.eval(wi[3], wo[2]))
    assert PAINT.eval(wi[0], wo[0]).shape == (3,)
    assert PAINT.eval(wi[:0], wo[:0]).shape == (0, 3)
    assert PAINT.eval(wi.astype(np.float32), wo[0]).dtype == np.float64
    np.testing.assert_array_equal(
        PAINT.eval([0, 0, 1], [0, 0, 1]), PAINT.eval(np.array([0, 0, 1.0]), np.array([0, 0, 1.0]))
    )
    strided = np.asfortranarray(np.tile(wi, (9, 1)))[::2]
    np.testing.assert_array_equal(PAINT.eval(strided, strided), PAINT.eval(strided.copy(), strided.copy()))


@pytest.mark.parametrize("count", [1, 50])
def test_what_is_refused_is_refused_with_few_directions_too(count: int) -> None:
    good = np.tile([0.0, 0.6, 0.8], (count, 1))
    for bad in (np.where(good > 0.7, 1.02, good), -np.where(good > 0.7, 1.02, good)):
        for pair in ((bad, good), (good, bad)):
            with pytest.raises(DataError, match=r"component of 1\.02"):
                PAINT.eval(*pair)
    with pytest.raises(DataError, match="last axis"):
        PAINT.eval(good[:, :2], good)
    with pytest.raises(DataError, match="broadcast"):
        PAINT.eval(np.tile(good, (3, 1))[: count + 1], np.tile(good, (3, 1))[: count + 2])
    unknown = good.copy()
    unknown[0] = np.nan
    assert np.isnan(PAINT.eval(unknown, good)[0]).all(), "NaN is no length"


def test_parameters_that_vary_and_very_many_channels_go_the_general_way() -> None:
    wi, wo = upper_directions(4, 10), upper_directions(4, 11)
    varying = OrenNayar(K_d=0.5, sigma_d=np.array([0.1, 0.2, 0.3, 0.4]))
    assert value(varying, wi, wo) is None
    expected = [OrenNayar(K_d=0.5, sigma_d=s).eval(wi[k], wo[k]) for k, s in enumerate(varying.sigma_d)]
    np.testing.assert_allclose(varying.eval(wi, wo), expected, rtol=1e-14)
    colours = np.linspace(0.1, 0.9, immediate.CHANNELS + 1)
    assert value(Lambert(colours), wi, wo) is None
    np.testing.assert_allclose(Lambert(colours).eval(wi, wo)[2], colours / np.pi, rtol=1e-14)


@dataclass(frozen=True, eq=False)
class _OfSomebody(BRDF):
    """A formula that only NumPy can follow."""

    K: Array = parameter(0.5, bounds=(0, 1), symbol="K", doc="a share", per_channel=True)

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return self.shape(geometry) * self.K

    def shape(self, geometry: Geometry) -> Array:
        return np.cos(geometry.theta_i)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return [Component(self.formula, CosineLobe(), self.K)]


class _Asks(_OfSomebody):
    """One whose formula asks a parameter what it is."""

    def shape(self, geometry: Geometry) -> Array:
        return 2.0 if self.K == 0.5 else geometry.cos_theta_i


def test_a_formula_that_symbols_cannot_follow_is_run_as_it_stands(monkeypatch: pytest.MonkeyPatch) -> None:
    wi = upper_directions(3, 12)
    np.testing.assert_allclose(_OfSomebody().eval(wi, wi)[:, 0], 0.5 * wi[:, 2], rtol=1e-14)
    np.testing.assert_array_equal(_Asks(0.5).eval(wi, wi), np.ones((3, 1)))
    np.testing.assert_allclose(_Asks(0.25).eval(wi, wi)[:, 0], 0.25 * wi[:, 2], rtol=1e-14)
    monkeypatch.setattr(recording, "_RECORDERS", {})  # once is enough to know it
    np.testing.assert_allclose(_OfSomebody(0.25).eval(wi, wi)[:, 0], 0.25 * wi[:, 2], rtol=1e-14)


def test_a_symbol_answers_no_question_by_a_number() -> None:
    x = Graph().leaf("x")
    assert x == x
    assert x != Graph().leaf("x")
    for question in (lambda: x == 1.0, lambda: np.float64(1.0) == x, lambda: x in (1.0, 2.0)):
        with pytest.raises(TypeError, match=r"xp\.where"):
            question()


# ---------------------------------------------------------------- Nothing is done twice


def calls_of(work: Callable[[], Any]) -> int:
    """How many functions of Python's and of others are called."""
    count = 0

    def seen(frame: Any, event: str, argument: Any) -> None:
        nonlocal count
        count += event in ("call", "c_call")

    sys.setprofile(seen)
    try:
        work()
    finally:
        sys.setprofile(None)
    return count


def test_a_second_call_does_little_besides_the_formula() -> None:
    wi, wo = upper_directions(1, 13), upper_directions(1, 14)
    DUSTY.eval(wi, wo)
    general = calls_of(lambda: as_printed(DUSTY, wi, wo))
    assert calls_of(lambda: DUSTY.eval(wi, wo)) < 100, f"the formula alone, over NumPy, makes {general}"


def test_a_second_call_of_the_engine_does_little() -> None:
    pytest.importorskip("llvmlite")
    wi, wo = upper_directions(100, 13), upper_directions(100, 14)
    before = len(jobs._known)

    def called() -> None:
        model = DustLayer(PAINT, Dust(w=(0.7, 0.6, 0.5), g=0.3), tau=0.2)
        expected = engine.evaluate(model, wi, wo)
        assert calls_of(lambda: engine.evaluate(model, wi, wo)) < 150
        other = model.with_parameters({"tau": 0.3})
        assert not np.array_equal(engine.evaluate(other, wi, wo), expected)
        np.testing.assert_array_equal(engine.evaluate(model, wi, wo), expected)
        assert len(jobs._known) >= before + 2

    called()
    gc.collect()
    assert len(jobs._known) <= before


def test_models_of_one_structure_are_recorded_once(monkeypatch: pytest.MonkeyPatch) -> None:
    wi = upper_directions(3, 15)
    PAINT.eval(wi, wi)
    monkeypatch.setattr(recording, "_RECORDERS", {})
    other = OrenNayar((0.1, 0.2, 0.3), 0.9) + TorranceSparrow(0.5, 0.3)
    np.testing.assert_array_equal(value(other, wi, wi), as_printed(other, wi, wi))


def test_what_is_kept_of_a_model_goes_with_it() -> None:
    wi = upper_directions(3, 16)
    before = len(immediate._models)
    made = [Lambert(k / 100) for k in range(50)]
    for model in made:
        model.eval(wi, wi)
    assert len(immediate._models) >= before + 50
    del made, model
    gc.collect()
    assert len(immediate._models) <= before
    again = pickle.loads(pickle.dumps(DUSTY))
    np.testing.assert_array_equal(again.eval(wi, wi), DUSTY.eval(wi, wi))


def test_many_directions_go_through_the_engine(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("llvmlite")
    wi = upper_directions(20, 17)
    expected = PAINT.eval(wi, wi)
    seen = []
    monkeypatch.setattr(engine, "THRESHOLD", 20)
    monkeypatch.setattr(engine, "evaluate", lambda *inputs: seen.append(inputs))
    PAINT.eval(wi, wi)
    assert len(seen) == 1
    monkeypatch.setattr(engine, "available", lambda: False)
    np.testing.assert_array_equal(PAINT.eval(wi, wi), expected)


# ---------------------------------------------------------------- Rows of memory


def test_rows_are_used_again_but_never_while_they_are_needed() -> None:
    graph = Graph()
    x, y = graph.leaf("x"), graph.leaf("y")
    chain = x * y
    for k in range(1, 30):
        chain = graph.sqrt(chain + k) + graph.minimum(chain, y * k)
    kept = x + y
    outputs = [chain * kept, kept, graph.where(chain > kept, chain, kept)]
    printed = program(outputs, {x: "x", y: "y"}, repr)
    assert printed.numbers < 8
    rows = {f"r{k}": np.empty(5) for k in range(printed.numbers)} | {
        f"m{k}": np.empty(5, bool) for k in range(printed.truths)
    }
    values = {"x": np.linspace(1, 2, 5), "y": np.linspace(3, 7, 5)}
    scope = {name: getattr(np, name) for name in dir(np)} | rows | values
    exec("\n".join(printed.lines), scope)
    expected = tracing.evaluate(NUMPY, outputs, {x: values["x"], y: values["y"]})
    for text, value in zip(printed.results, expected, strict=True):
        np.testing.assert_array_equal(scope[text], value)
    np.testing.assert_array_equal(values["x"], np.linspace(1, 2, 5))


def test_a_layer_of_dust_takes_few_rows() -> None:
    trace = tracing.trace(DUSTY, DUSTY.channels)
    given = {s: f"a{s.index}" for s in trace.leaves()}
    assert isinstance(DUSTY, DustLayer)
    assert program(trace.outputs, given, repr).numbers <= 40
