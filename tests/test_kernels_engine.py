"""The compiled engine against the equations over NumPy: values, NaN, layouts, parameters of all shapes, gradients."""

from __future__ import annotations

import itertools
import multiprocessing
import sys
import threading
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from catalogue import ENTRIES, SPECIAL_WI, SPECIAL_WO, jax_in_float64, reference, upper_directions
from engine_support import risky_pairs
from golden import appendices

pytest.importorskip("llvmlite")

from motes import workers
from motes.arrays import namespace
from motes.directions import Geometry, Vector
from motes.errors import DataError, ParameterError
from motes.kernels import engine, jobs
from motes.kernels.loops import TILE
from motes.models import BRDF, Dust, DustLayer, Lambert, OrenNayar, TorranceSparrow

BY_NAME = {entry.name: entry for entry in ENTRIES}
DUSTY = BY_NAME["dust_layer"].model
ROUGH = OrenNayar(0.5, 1.0)  # its clamp at 0 acts
CHOSEN = {
    "lambert": BY_NAME["lambert"].model,
    "rough": ROUGH,
    "conductor": BY_NAME["torrance_sparrow_conductor"].model,
    "dusty": DUSTY,
}
models = pytest.mark.parametrize("model", CHOSEN.values(), ids=CHOSEN)

# Errors are relative to the value, or to this where it is smaller [1/sr]: 3 % of a white Lambertian surface.
FLOOR = 0.01


def errors(found: NDArray[Any], expected: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.abs(found - expected) / np.maximum(np.abs(expected), FLOOR)


def close(found: NDArray[Any], expected: NDArray[np.float64], tolerance: float) -> bool:
    return bool((np.abs(found - expected) <= tolerance * np.maximum(np.abs(expected), FLOOR)).all())


# ---------------------------------------------------------------- Values


@models
def test_float64_is_numpy_within_1e_12(model: BRDF) -> None:
    for name, (wi, wo) in risky_pairs(4000, 1).items():
        found = engine.evaluate(model, wi, wo)
        expected = reference(model, wi, wo)
        assert found.dtype == np.float64
        assert close(found, expected, 1e-12), name
        below = (wi[:, 2] <= 0) | (wo[:, 2] <= 0)
        assert (found[below] == 0).all()


@models
def test_float32_is_float64_within_1e_5(model: BRDF) -> None:
    for name, (wi, wo) in risky_pairs(20_000, 2).items():
        wi, wo = wi.astype(np.float32), wo.astype(np.float32)
        found = engine.evaluate(model, wi, wo)
        expected = reference(model, wi.astype(np.float64), wo.astype(np.float64))
        assert found.dtype == np.float32
        assert close(found, expected, 1e-5), name


def test_a_million_directions() -> None:
    wi, wo = upper_directions(1_000_000, 3), upper_directions(1_000_000, 4)
    f64 = engine.evaluate(DUSTY, wi, wo)
    wi32, wo32 = wi.astype(np.float32), wo.astype(np.float32)
    f32 = engine.evaluate(DUSTY, wi32, wo32)
    for start in range(0, 1_000_000, 100_000):  # NumPy's intermediate results, a part at a time
        part = slice(start, start + 100_000)
        assert errors(f64[part], reference(DUSTY, wi[part], wo[part])).max() < 1e-12
        exact = reference(DUSTY, wi32[part].astype(np.float64), wo32[part].astype(np.float64))
        assert errors(f32[part], exact).max() < 1e-5


def test_golden_rows() -> None:
    rows = appendices()
    model, expected = BY_NAME["dust_layer"].at_rows(rows)  # all equations; parameters that differ from row to row
    found = engine.evaluate(model, rows["wi"], rows["wo"])
    np.testing.assert_allclose(found[:, 0], expected, rtol=1e-9, atol=1e-12)


@models
def test_special_directions_are_as_in_numpy(model: BRDF) -> None:
    expected = reference(model, SPECIAL_WI, SPECIAL_WO)
    found = engine.evaluate(model, SPECIAL_WI, SPECIAL_WO)
    np.testing.assert_allclose(found, np.broadcast_to(expected, found.shape), rtol=1e-12, atol=0)


@models
@pytest.mark.parametrize("scalar", [np.float32, np.float64])
def test_nan_comes_out_where_numpy_has_it(model: BRDF, scalar: type) -> None:
    base = [
        *zip(upper_directions(3, 5), upper_directions(3, 6), strict=True),
        *zip(SPECIAL_WI, SPECIAL_WO, strict=True),
    ]
    pairs = []
    for wi, wo in base:
        for mask in itertools.product([False, True], repeat=6):
            pairs.append(np.where(mask, np.nan, np.concatenate([wi, wo])))
    both = np.array(pairs).astype(scalar)
    wi, wo = both[:, :3], both[:, 3:]
    found = engine.evaluate(model, wi, wo)
    expected = np.isnan(np.broadcast_to(reference(model, wi.astype(np.float64), wo.astype(np.float64)), found.shape))
    assert expected.any()
    assert not expected.all()
    np.testing.assert_array_equal(np.isnan(found), expected)


def test_many_channels() -> None:
    model = OrenNayar(np.linspace(0.1, 0.9, 11), 0.2) + TorranceSparrow(np.linspace(0.5, 0.1, 11), 0.05)
    wi, wo = upper_directions(300, 7), upper_directions(300, 8)
    found = engine.evaluate(model, wi, wo)
    assert found.shape == (300, 11)
    assert errors(found, reference(model, wi, wo)).max() < 1e-12


# ---------------------------------------------------------------- Shapes and layouts


def test_large_evaluations_of_models_go_through_the_engine(monkeypatch: pytest.MonkeyPatch) -> None:
    wi, wo = upper_directions(600, 9), upper_directions(600, 10)
    calls = []
    evaluate = engine.evaluate
    monkeypatch.setattr(engine, "evaluate", lambda *args: calls.append(args) or evaluate(*args))
    monkeypatch.setattr(engine, "THRESHOLD", 601)
    below = DUSTY.eval(wi, wo)
    assert not calls
    monkeypatch.setattr(engine, "THRESHOLD", 600)
    np.testing.assert_allclose(DUSTY.eval(wi, wo), below, rtol=1e-12)
    assert calls


def test_what_counts_is_the_number_of_pairs(monkeypatch: pytest.MonkeyPatch) -> None:
    """An outer product, or parameters that vary, are many values made of few directions."""
    calls = []
    evaluate = engine.evaluate
    monkeypatch.setattr(engine, "evaluate", lambda *args: calls.append(args) or evaluate(*args))
    monkeypatch.setattr(engine, "THRESHOLD", 200)
    wi, wo = upper_directions(20, 9)[:, None], upper_directions(10, 10)
    DUSTY.eval(wi, wo)
    assert len(calls) == 1
    Lambert(np.full((200, 1), 0.5)).eval([0, 0, 1], [0, 0, 1])
    assert len(calls) == 2
    DUSTY.eval(wi[:19], wo)
    assert len(calls) == 2


@pytest.mark.parametrize("count", [1, 7, TILE - 1, TILE, TILE + 1, engine.CHUNK, 2 * engine.CHUNK + 3])
def test_any_number_of_directions(count: int) -> None:
    wi, wo = upper_directions(count, 11), upper_directions(count, 12)
    found = engine.evaluate(DUSTY, wi, wo)
    assert found.shape == (count, 3)
    assert errors(found, reference(DUSTY, wi, wo)).max() < 1e-12


def test_no_directions() -> None:
    assert engine.evaluate(DUSTY, np.empty((0, 3)), np.empty((0, 3))).shape == (0, 3)
    assert engine.evaluate(DUSTY, np.empty((4, 0, 3)), np.empty((1, 3))).shape == (4, 0, 3)


def layouts(w: NDArray[Any]) -> dict[str, NDArray[Any]]:
    """The same directions in memory of every kind."""
    n = len(w)
    wider = np.zeros((2 * n, 5), w.dtype)
    wider[::2, 1:4] = w
    packed = np.frombuffer(b"\0" + np.ascontiguousarray(w).tobytes(), np.uint8)[1:].view(w.dtype).reshape(n, 3)
    fixed = w.copy()
    fixed.setflags(write=False)
    return {
        "one piece": np.ascontiguousarray(w),
        "rows": np.ascontiguousarray(w.T).T,
        "strides": wider[::2, 1:4],
        "reversed": np.ascontiguousarray(w[::-1])[::-1],
        "components reversed": np.ascontiguousarray(w[:, ::-1])[:, ::-1],
        "read-only": fixed,
        "unaligned": packed,
        "other byte order": w.astype(w.dtype.newbyteorder()),
    }


@pytest.mark.parametrize("scalar", [np.float32, np.float64])
def test_all_layouts_give_the_same_bits(scalar: type) -> None:
    wi, wo = upper_directions(1500, 13).astype(scalar), upper_directions(1500, 14).astype(scalar)
    expected = engine.evaluate(DUSTY, wi, wo)
    seconds = layouts(wo)
    for name, first in layouts(wi).items():
        for other, second in ((name, seconds[name]), ("one piece", wo)):
            found = engine.evaluate(DUSTY, first, second)
            np.testing.assert_array_equal(found, expected, err_msg=f"{name}, {other}")


def test_rows_in_rows_out() -> None:
    wi, wo = np.ascontiguousarray(upper_directions(50, 1).T), np.ascontiguousarray(upper_directions(50, 2).T)
    assert engine.evaluate(DUSTY, wi.T, wo.T).T.flags.c_contiguous
    assert engine.evaluate(DUSTY, np.ascontiguousarray(wi.T), np.ascontiguousarray(wo.T)).flags.c_contiguous


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ((), ()),
        ((), (40,)),
        ((40,), ()),
        ((1,), (40,)),
        ((5, 1), (1, 7)),
        ((5, 7), (7,)),
        ((2, 1, 3), (4, 1)),
        ((1, 1), (1, 1)),
    ],
)
def test_directions_broadcast(first: tuple[int, ...], second: tuple[int, ...]) -> None:
    wi = upper_directions(int(np.prod(first)), 15).reshape(*first, 3)
    wo = upper_directions(int(np.prod(second)), 16).reshape(*second, 3)
    found = engine.evaluate(DUSTY, wi, wo)
    assert found.shape == (*np.broadcast_shapes(first, second), 3)
    assert errors(found, reference(DUSTY, wi, wo)).max() < 1e-12


OUTER = {
    "long rows": ((70, 1), (1, 2000)),
    "rows longer than a chunk": ((3, 1), (1, engine.CHUNK + 77)),
    "short rows": ((9000, 1), (1, 5)),
    "one after the other, and repeated": ((40, 1000), (40, 1)),
    "three axes": ((7, 1, 600), (1, 30, 1)),
    "three axes, the last one short": ((60, 1, 40), (1, 50, 1)),
    "a slab of more than a chunk": ((4, 1, 3), (1, 20_000, 1)),
}


@pytest.mark.parametrize("name", OUTER)
@pytest.mark.parametrize("scalar", [np.float32, np.float64])
def test_an_outer_product_is_its_pairs(name: str, scalar: type) -> None:
    """Wherever rows are computed: values, into an array that is given, and gradients.

    Bits may differ in the last place: where a tile ends, another tail of the vector instructions computes."""
    first, second = OUTER[name]
    wi = upper_directions(int(np.prod(first)), 15).reshape(*first, 3).astype(scalar)
    wo = upper_directions(int(np.prod(second)), 16).reshape(*second, 3).astype(scalar)[..., ::-1, :]
    shape = np.broadcast_shapes(first, second)
    pairs = [np.ascontiguousarray(np.broadcast_to(w, (*shape, 3))) for w in (wi, wo)]
    expected = engine.evaluate(DUSTY, *pairs)
    found = engine.evaluate(DUSTY, wi, wo)
    np.testing.assert_allclose(found, expected, rtol=1e-13 if scalar is np.float64 else 1e-5)
    out = np.full((*shape, 3), np.nan, scalar)
    assert engine.evaluate(DUSTY, wi, wo, out=out) is out
    assert np.array_equal(out, found)
    seed = np.random.default_rng(3).random((*shape, 3))
    gradients = [engine.vjp(DUSTY, *w, seed) for w in ((wi, wo), pairs)]
    for slot, gradient in gradients[0].items():
        np.testing.assert_allclose(gradient, gradients[1][slot], rtol=1e-11 if scalar is np.float64 else 2e-5)


@pytest.mark.parametrize("name", OUTER)
def test_an_outer_product_makes_no_copy_of_all_pairs(name: str) -> None:
    first, second = OUTER[name]
    wi, wo = (upper_directions(int(np.prod(s)), 15).reshape(*s, 3) for s in (first, second))
    job = jobs.Job(DUSTY, wi, wo)
    if name == "a slab of more than a chunk":  # short rows of more than two axes are copied
        assert not np.may_share_memory(job.wi, wi)
        return
    assert np.may_share_memory(job.wi, wi)
    assert np.may_share_memory(job.wo, wo)


def test_integers_and_mixed_precision_are_computed_in_float64() -> None:
    up = np.array([0, 0, 1])
    assert engine.evaluate(DUSTY, up, up).dtype == np.float64
    assert engine.evaluate(DUSTY, [[0, 0, 1]], [[0, 0.6, 0.8]]).dtype == np.float64
    wi = upper_directions(20, 1).astype(np.float32)
    mixed = engine.evaluate(DUSTY, wi, upper_directions(20, 2))
    np.testing.assert_array_equal(mixed, engine.evaluate(DUSTY, wi.astype(np.float64), upper_directions(20, 2)))


def test_out_is_filled_in_place() -> None:
    wi, wo = upper_directions(60, 17), upper_directions(60, 18)
    expected = engine.evaluate(DUSTY, wi, wo)
    canvas = np.full((60, 7), -1.0)
    for out in (np.empty((60, 3)), np.empty((3, 60)).T, canvas[:, 2:5], np.empty((60, 3))[::-1]):
        assert engine.evaluate(DUSTY, wi, wo, out=out) is out
        np.testing.assert_array_equal(out, expected)
    assert (canvas[:, [0, 1, 5, 6]] == -1).all()
    shaped = np.empty((3, 20, 6))[..., ::2]  # no (N, C) view exists
    engine.evaluate(DUSTY, wi.reshape(3, 20, 3), wo.reshape(3, 20, 3), out=shaped)
    np.testing.assert_array_equal(shaped.reshape(60, 3), expected)
    own = wi.copy()
    engine.evaluate(DUSTY, own, wo, out=own)  # over its own input
    np.testing.assert_array_equal(own, expected)


@pytest.mark.parametrize(
    ("out", "found"),
    [
        (np.empty((5, 2)), r"float64 \(5, 2\)"),
        (np.empty((5, 3), np.float32), r"float32 \(5, 3\)"),
        (np.broadcast_to(0.0, (5, 3)), "read-only"),
    ],
)
def test_an_out_that_does_not_fit_is_refused(out: NDArray[Any], found: str) -> None:
    wi = upper_directions(5, 1)
    with pytest.raises(DataError, match=found):
        engine.evaluate(DUSTY, wi, wi, out=out)


def test_inputs_that_do_not_fit_are_refused() -> None:
    wi = upper_directions(5, 1)
    with pytest.raises(DataError, match="wo has shape"):
        engine.evaluate(DUSTY, wi, wi[:, :2])
    with pytest.raises(DataError, match="wi has shape"):
        engine.evaluate(DUSTY, 1.0, wi)
    with pytest.raises(ParameterError, match=r"sigma_d \(4,\)"):
        engine.evaluate(OrenNayar(0.5, np.full(4, 0.3)), wi, wi)
    with pytest.raises(DataError, match="upstream has shape"):
        engine.vjp(DUSTY, wi, wi, np.ones((4, 3)))


def test_engine_is_available() -> None:
    assert engine.available()


# ---------------------------------------------------------------- Parameters that vary


def varying_model() -> BRDF:
    rng = np.random.default_rng(19)
    return DustLayer(
        OrenNayar(K_d=rng.uniform(0.1, 0.9, (40, 3)), sigma_d=rng.uniform(0.1, 0.9, 40))
        + TorranceSparrow(0.3, rng.uniform(0.1, 0.3, (40,))),
        Dust(w=rng.uniform(0.1, 0.9, (40, 1)), g=0.3),
        tau=0.2,
    )


def one_of(model: BRDF, k: int) -> BRDF:
    """The model of direction k, without axes besides the channels."""
    values = {}
    for slot in model.slots():
        batch = np.ndim(slot.value) - bool(slot.parameter.per_channel)
        values[slot.name] = slot.value[k] if batch > 0 else slot.value
    return model.with_parameters(values)


def test_parameters_that_vary_from_direction_to_direction() -> None:
    model = varying_model()
    wi, wo = upper_directions(40, 20), upper_directions(40, 21)
    found = engine.evaluate(model, wi, wo)
    assert found.shape == (40, 3)
    for k in range(40):
        np.testing.assert_allclose(found[k], reference(one_of(model, k), wi[k], wo[k]), rtol=1e-12)
    # One pair of directions, many parameters; and a grid of both.
    single = engine.evaluate(model, wi[0], wo[0])
    np.testing.assert_allclose(single[7], reference(one_of(model, 7), wi[0], wo[0]), rtol=1e-12)
    grid = engine.evaluate(model, wi[:, None], wo[:, None])
    assert grid.shape == (40, 40, 3)
    np.testing.assert_allclose(grid[3, 7], reference(one_of(model, 7), wi[3], wo[3]), rtol=1e-12)


def test_axes_of_length_one_do_not_vary() -> None:
    wi, wo = upper_directions(9, 22), upper_directions(9, 23)
    axes = DUSTY.with_parameters({"K_d": np.array([[0.8, 0.7, 0.6]]), "sigma_d": np.array([0.4])})
    np.testing.assert_array_equal(engine.evaluate(axes, wi, wo), engine.evaluate(DUSTY, wi, wo))
    assert engine.evaluate(axes, wi[0], wo[0]).shape == (1, 3)


# ---------------------------------------------------------------- Gradients


def objective(model: BRDF, wi: NDArray[Any], wo: NDArray[Any], upstream: NDArray[Any]) -> float:
    return float(np.sum(np.broadcast_to(reference(model, wi, wo), upstream.shape) * upstream))


@pytest.mark.parametrize("name", ["dust_layer", "dust_on_plaster_and_varnish"])
def test_gradients_match_differences(name: str) -> None:
    model = BY_NAME[name].model
    wi = np.concatenate([upper_directions(500, 24), SPECIAL_WI[:5]])
    wo = np.concatenate([upper_directions(500, 25), SPECIAL_WO[:5]])
    upstream = np.random.default_rng(26).normal(size=(505, model.channels))
    gradients = engine.vjp(model, wi, wo, upstream)
    assert set(gradients) == {slot.name for slot in model.slots()}
    for slot in model.slots():
        value = np.asarray(slot.value, float)
        assert gradients[slot.name].shape == value.shape
        for index in np.ndindex(value.shape):
            step = np.zeros_like(value)
            step[index] = 1e-5
            high, low = (
                objective(model.with_parameters({slot.name: value + h}), wi, wo, upstream) for h in (step, -step)
            )
            np.testing.assert_allclose(gradients[slot.name][index], (high - low) / 2e-5, rtol=1e-6, atol=1e-6)


def test_gradients_match_torch() -> None:
    torch = pytest.importorskip("torch")
    wi, wo = upper_directions(300, 27), upper_directions(300, 28)
    upstream = np.random.default_rng(29).normal(size=(300, 3))
    values = {s.name: torch.tensor(np.asarray(s.value, float), requires_grad=True) for s in DUSTY.slots()}
    f = DUSTY.with_parameters(values).eval(torch.tensor(wi), torch.tensor(wo))
    (f * torch.tensor(upstream)).sum().backward()
    gradients = engine.vjp(DUSTY, wi, wo, upstream)
    for name, value in values.items():
        np.testing.assert_allclose(gradients[name], value.grad.numpy(), rtol=1e-10, atol=1e-12, err_msg=name)


def test_gradients_match_jax() -> None:
    jax = pytest.importorskip("jax")
    wi, wo = upper_directions(300, 30), upper_directions(300, 31)
    upstream = np.random.default_rng(32).normal(size=(300, 3))
    with jax_in_float64():
        xp = namespace(jax.numpy.ones(1))

        def loss(values: dict[str, Any]) -> Any:
            geometry = Geometry(xp, Vector.of(jax.numpy.asarray(wi)), Vector.of(jax.numpy.asarray(wo)))
            return (DUSTY.with_parameters(values).value(xp, geometry) * upstream).sum()

        expected = jax.jit(jax.grad(loss))(
            {s.name: jax.numpy.asarray(np.asarray(s.value, float)) for s in DUSTY.slots()}
        )
        gradients = engine.vjp(DUSTY, wi, wo, upstream)
        for name, value in expected.items():
            np.testing.assert_allclose(gradients[name], np.asarray(value), rtol=1e-10, atol=1e-12, err_msg=name)


def test_gradients_in_float32_are_those_in_float64() -> None:
    n = engine.CHUNK + 1000
    wi, wo = upper_directions(n, 33).astype(np.float32), upper_directions(n, 34).astype(np.float32)
    upstream = np.random.default_rng(35).uniform(0.5, 1.5, (n, 3)).astype(np.float32)
    wi[::9] *= -1  # below the horizon: nothing comes from there
    single = engine.vjp(DUSTY, wi, wo, upstream)
    double = engine.vjp(DUSTY, wi.astype(np.float64), wo.astype(np.float64), upstream.astype(np.float64))
    for name, value in single.items():
        assert value.dtype == np.float64
        np.testing.assert_allclose(value, double[name], rtol=2e-6, err_msg=name)


def test_gradients_by_parameters_that_vary() -> None:
    model = varying_model()
    wi, wo = upper_directions(40, 36), upper_directions(40, 37)
    upstream = np.random.default_rng(38).normal(size=(40, 3))
    gradients = engine.vjp(model, wi, wo, upstream)
    for slot in model.slots():
        assert gradients[slot.name].shape == np.shape(slot.value)
    each = []
    for k in range(40):  # by the kernel of DUSTY, which has a w for each channel
        one = one_of(model, k)
        each.append(
            engine.vjp(one.with_parameters({"w": np.repeat(one.parameters["w"], 3)}), wi[k], wo[k], upstream[k])
        )
    for slot in model.slots():
        stack = np.stack([one[slot.name] for one in each])
        stack = stack.sum(-1, keepdims=True) if slot.name == "w" else stack
        expected = stack if np.ndim(slot.value) > slot.parameter.per_channel else stack.sum(0)
        np.testing.assert_allclose(gradients[slot.name], expected.reshape(np.shape(slot.value)), rtol=1e-10, atol=1e-13)


@pytest.mark.parametrize("count", [1, 31, 33, 1024 + 5, engine.CHUNK + 35])
def test_gradients_of_directions_that_do_not_make_whole_vectors(count: int) -> None:
    """The last directions count once, whatever fills the vector that they are in, and write no slope but their own."""
    rng = np.random.default_rng(60)
    wi, wo, upstream = upper_directions(count, 61), upper_directions(count, 62), rng.normal(size=(count, 3))
    model = DUSTY.with_parameters({"tau": rng.uniform(0.1, 0.9, count), "g": rng.uniform(-0.5, 0.5, count)})
    found = engine.vjp(model, wi, wo, upstream)
    some = np.unique(np.r_[0, max(0, count - 40) : count])  # slopes of their own, by a call of other length and begin
    part = model.with_parameters({name: model.parameters[name][some] for name in ("tau", "g")})
    alone = engine.vjp(part, wi[some], wo[some], upstream[some])
    for name in ("tau", "g"):
        np.testing.assert_allclose(found[name][some], alone[name], rtol=1e-12, atol=1e-14)
    backwards = model.with_parameters({name: model.parameters[name][::-1] for name in ("tau", "g")})
    turned = engine.vjp(backwards, wi[::-1], wo[::-1], upstream[::-1])
    for slot in model.slots():
        value = turned[slot.name][::-1] if slot.name in ("tau", "g") else turned[slot.name]
        np.testing.assert_allclose(found[slot.name], value, rtol=1e-9, atol=1e-11, err_msg=slot.name)


def test_gradients_are_summed_over_the_axes_along_which_a_parameter_is_broadcast() -> None:
    rng = np.random.default_rng(50)
    wi, wo = upper_directions(20, 51).reshape(4, 5, 3), upper_directions(5, 52)
    upstream = rng.normal(size=(4, 5, 3))
    for shape in ((5,), (4, 1), (4, 5), (1, 5)):
        value = rng.uniform(0.1, 0.9, shape)
        found = engine.vjp(DUSTY.with_parameters({"tau": value}), wi, wo, upstream)["tau"]
        whole = engine.vjp(DUSTY.with_parameters({"tau": np.broadcast_to(value, (4, 5))}), wi, wo, upstream)["tau"]
        axes = tuple(k for k, n in enumerate(((1,) * (2 - len(shape))) + shape) if n == 1)
        assert found.shape == shape
        np.testing.assert_allclose(found, whole.sum(axis=axes, keepdims=True).reshape(shape), rtol=1e-12)
        for index in ((0,) * len(shape), (-1,) * len(shape)):
            step = np.zeros(shape)
            step[index] = 1e-6
            high, low = (objective(one_axis_more(DUSTY, value + h), wi, wo, upstream) for h in (step, -step))
            np.testing.assert_allclose(found[index], (high - low) / 2e-6, rtol=1e-6, atol=1e-8)


def one_axis_more(model: BRDF, tau: NDArray[np.float64]) -> BRDF:
    """With an axis for the channels, which the equations over NumPy broadcast against."""
    return model.with_parameters({"tau": tau[..., None]})


def test_an_upstream_broadcasts() -> None:
    wi, wo = upper_directions(30, 39), upper_directions(30, 40)
    expected = engine.vjp(DUSTY, wi, wo, np.full((30, 3), 2.0))
    for upstream in (2.0, np.full((30, 1), 2.0), np.full(3, 2.0), np.full((3, 30), 2.0).T):
        found = engine.vjp(DUSTY, wi, wo, upstream)
        for name, value in expected.items():
            np.testing.assert_allclose(found[name], value, rtol=1e-14)


def test_gradients_at_kinks_and_masked_directions_are_finite() -> None:
    gradients = engine.vjp(DUSTY, SPECIAL_WI, SPECIAL_WO, 1.0)
    assert all(np.isfinite(value).all() for value in gradients.values())
    below = engine.vjp(DUSTY, -SPECIAL_WI[:3], SPECIAL_WO[:3], 1.0)
    assert all((value == 0).all() for value in below.values())


# ---------------------------------------------------------------- Threads and processes


def test_results_do_not_depend_on_the_number_of_threads(monkeypatch: pytest.MonkeyPatch) -> None:
    n = 5 * engine.CHUNK + 17
    wi, wo = upper_directions(n, 41), upper_directions(n, 42)
    results = []
    for threads in (1, 2, 5):
        monkeypatch.setattr(workers, "threads", lambda threads=threads: threads)
        monkeypatch.setattr(workers, "_pool", None)
        results.append((engine.evaluate(DUSTY, wi, wo), engine.vjp(DUSTY, wi, wo, 1.0)))
    for values, gradients in results[1:]:
        np.testing.assert_array_equal(values, results[0][0])
        for name, value in gradients.items():
            np.testing.assert_array_equal(value, results[0][1][name])


def test_several_threads_may_call_at_once() -> None:
    wi, wo = upper_directions(3 * engine.CHUNK, 43), upper_directions(3 * engine.CHUNK, 44)
    expected = engine.evaluate(DUSTY, wi, wo)
    wrong: list[int] = []

    def call(k: int) -> None:
        for _ in range(5):
            if not np.array_equal(engine.evaluate(DUSTY, wi, wo), expected):
                wrong.append(k)

    threads = [threading.Thread(target=call, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(60)
    assert not wrong
    assert not any(thread.is_alive() for thread in threads)


def in_child(pipe: Any, wi: NDArray[Any], wo: NDArray[Any]) -> None:
    pipe.send(engine.evaluate(DUSTY, wi, wo))


@pytest.mark.skipif(sys.platform in ("win32", "darwin"), reason="the platform does not fork")
@pytest.mark.filterwarnings("ignore:.*fork:DeprecationWarning", "ignore:.*fork:RuntimeWarning")
def test_a_forked_process_has_an_engine_of_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workers, "threads", lambda: 2)
    wi, wo = upper_directions(3 * engine.CHUNK, 45), upper_directions(3 * engine.CHUNK, 46)
    expected = engine.evaluate(DUSTY, wi, wo)  # the parent has its threads now
    context = multiprocessing.get_context("fork")
    ours, theirs = context.Pipe()
    child = context.Process(target=in_child, args=(theirs, wi, wo))
    child.start()
    answered = ours.poll(60)
    found = ours.recv() if answered else None
    if not answered:
        child.kill()
    child.join()
    assert answered, "the child waits for threads that only its parent has"
    np.testing.assert_array_equal(found, expected)


def test_an_error_in_a_helper_thread_is_raised(monkeypatch: pytest.MonkeyPatch) -> None:
    job = jobs.Job(Lambert(), np.zeros((5 * engine.CHUNK, 3)), np.zeros(3))
    monkeypatch.setattr(workers, "threads", lambda: 3)
    monkeypatch.setattr(workers, "_pool", None)
    done: list[int] = []

    def work(first: int, last: int, room: int) -> None:
        done.append(first)
        if threading.current_thread() is not threading.main_thread():
            raise MemoryError("helper")
        threading.Event().wait(0.05)

    with pytest.raises(MemoryError, match="helper"):
        job.run(work)
    assert sorted(done) == sorted(set(done))


def test_many_chunks_go_to_a_thread_together_and_one_at_the_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workers, "threads", lambda: 2)
    w = np.broadcast_to(np.float32([0, 0, 1]), (100 * engine.CHUNK + 7, 3))
    job = jobs.Job(DUSTY, w, w)
    shares = job.shares()
    assert [first for first, _ in shares] == [0, *(last for _, last in shares[:-1])]
    assert shares[-1][1] == len(w)
    sizes = [(last - first) // engine.CHUNK for first, last in shares]
    assert (sizes[0], sizes[-2:]) == (12, [1, 0])
    assert len(sizes) < 40
    outer = jobs.Job(DUSTY, np.ones((2, 3 * engine.CHUNK, 3)), np.ones((2, 1, 3)))
    assert len(outer.shares()) == outer.chunks == 6  # rows that are copied a chunk at a time


def test_shares_change_no_bits(monkeypatch: pytest.MonkeyPatch) -> None:
    wi, wo = (upper_directions(9 * engine.CHUNK + 45, seed).astype(np.float32) for seed in (1, 2))
    found = []
    for several in (1, 2, 16):
        monkeypatch.setattr(jobs, "SEVERAL", several)
        monkeypatch.setattr(workers, "threads", lambda: 1)
        found.append((engine.evaluate(DUSTY, wi, wo), engine.density(DUSTY, wi, wo)))
    for values, density in found[1:]:
        np.testing.assert_array_equal(values, found[0][0])
        np.testing.assert_array_equal(density, found[0][1])
