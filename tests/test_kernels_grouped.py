"""Texels that differ in a parameter, evaluated in groups of about the same value: they say what the equations say."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

pytest.importorskip("llvmlite")

from motes import BRDF, Dust, DustLayer, Lambert, OrenNayar, TorranceSparrow
from motes.graph import tracing
from motes.kernels import engine, grouped, jobs, loops

COUNT = jobs.MANY + 1234  # no whole number of vectors or tiles
RNG = np.random.default_rng(8)
SIGMA = RNG.uniform(0.05, 1.2, COUNT)
Calls = list[bool]


@pytest.fixture
def calls(monkeypatch: pytest.MonkeyPatch) -> Calls:
    """Models that are compiled in a second are grouped, too; of each call, whether it was."""
    found: Calls = []
    plain = engine._evaluate_grouped

    def noted(job: jobs.Job, target: NDArray[Any]) -> bool:
        found.append(plain(job, target))
        return found[-1]

    monkeypatch.setattr(engine, "_evaluate_grouped", noted)
    monkeypatch.setattr(loops, "LEAST_APART", 1)
    monkeypatch.setattr(engine, "_grouped", {})
    return found


def directions(seed: int) -> NDArray[np.float32]:
    w = np.random.default_rng(seed).normal(size=(COUNT, 3))
    w[:, 2] = np.abs(w[:, 2]) - 0.1  # some below the horizon
    return (w / np.linalg.norm(w, axis=-1, keepdims=True)).astype(np.float32)


WI, WO = directions(1), directions(2)


def surface(sigma_d: Any, K_d: Any = (0.6, 0.4, 0.2)) -> BRDF:
    return OrenNayar(K_d, sigma_d) + TorranceSparrow(0.3, 0.3)


def assert_right(model: BRDF, found: NDArray[np.float32]) -> None:
    expected = model.eval(WI.astype(np.float64), WO.astype(np.float64))
    error = np.abs(found - expected) / np.maximum(expected, 0.01)
    assert expected.max() > 0.1
    assert error.max() < 1e-5


def test_values_are_those_of_the_equations_in_every_layout(calls: Calls) -> None:
    model = surface(SIGMA)
    found = engine.evaluate(model, WI, WO)
    assert_right(model, found)
    rows = [np.ascontiguousarray(w.T).T for w in (WI, WO)]
    for wi, wo in (rows, (WI[::-1][::-1], rows[1])):
        for out in (np.empty((COUNT, 3), np.float32), np.empty((3, COUNT), np.float32).T):
            assert engine.evaluate(model, wi, wo, out=out) is out
            np.testing.assert_array_equal(out, found)
    assert calls == [True] * 5


def test_what_else_differs_goes_along(calls: Calls) -> None:
    model = surface(SIGMA, RNG.uniform(0.1, 0.9, (COUNT, 3)))
    assert_right(model, engine.evaluate(model, WI, WO))
    assert calls == [True]


def test_a_map_under_one_light(calls: Calls) -> None:
    """Parameters (rows, columns), one direction to the light and one to the viewer."""
    sigma = SIGMA[: jobs.MANY].reshape(128, -1)
    wi, wo = np.array([0.3, 0.1, 0.9], np.float32), np.array([-0.2, 0.3, 0.8], np.float32)
    wi, wo = wi / np.linalg.norm(wi), wo / np.linalg.norm(wo)
    found = engine.evaluate(surface(sigma), wi, wo)
    expected = surface(sigma).eval(wi.astype(np.float64), wo.astype(np.float64))
    assert found.shape == expected.shape == (*sigma.shape, 3)
    assert np.abs(found - expected).max() < 1e-5 * expected.max()
    assert calls == [True]


def test_zero_is_zero(calls: Calls) -> None:
    """Half of a map is often clean: 0, and what is next to it in float32."""
    sigma = np.where(RNG.random(COUNT) < 0.5, 0.0, SIGMA)
    sigma[:2] = -0.0, 1e-40
    assert_right(surface(sigma), engine.evaluate(surface(sigma), WI, WO))
    assert calls == [True]


def test_groups_that_are_not_near_are_computed_one_by_one(calls: Calls, monkeypatch: pytest.MonkeyPatch) -> None:
    model = surface(SIGMA)
    near = engine.evaluate(model, WI, WO)
    monkeypatch.setattr(jobs, "MANY", COUNT + 1)
    plain = engine.evaluate(model, WI, WO)
    assert (plain != near).any()
    monkeypatch.setattr(jobs, "MANY", COUNT)
    judged = grouped.polynomials

    def doubted(keys: Any, values: Any) -> Any:
        extras, good = judged(keys, values)
        good[::2] = False
        extras[::2] = np.nan
        return extras, good

    monkeypatch.setattr(grouped, "polynomials", doubted)
    mixed = engine.evaluate(model, WI, WO)
    of_group = SIGMA.astype(np.float32).view(np.uint32) >> np.uint32(grouped.LAST_BITS)
    alone = np.isin(of_group, np.unique(of_group)[::2])
    np.testing.assert_array_equal(mixed[alone], plain[alone])
    np.testing.assert_array_equal(mixed[~alone], near[~alone])
    assert calls == [True, True]


def test_few_texels_to_a_group_are_computed_one_by_one(calls: Calls) -> None:
    model = surface(10 ** RNG.uniform(-30, 0, COUNT))
    assert_right(model, engine.evaluate(model, WI, WO))
    assert calls == [False]


def test_polynomials_are_judged_at_the_ends() -> None:
    keys = np.unique(np.array([0.0, 0.3, 0.5, 1.0, -2.0], np.float32).view(np.uint32) >> np.uint32(grouped.LAST_BITS))
    keys = keys.astype(np.int64)
    at = grouped.places(keys)
    assert at[0].tolist() == [0.0] * at.shape[1]
    assert ((at[1:].min(axis=1) > -2.13) & (at[1:].max(axis=1) < 1.0626)).all()
    smooth, bent = np.exp(-at), np.maximum(at, 0.31)
    assert grouped.polynomials(keys, smooth[None])[1].all()
    assert grouped.polynomials(keys, bent[None])[1].tolist() == [
        True,
        not (at[1].min() < 0.31 < at[1].max()),
        *[True] * 3,
    ]
    extras, _ = grouped.polynomials(keys, smooth[None])
    s = (at - extras[:, :1]) * extras[:, 1:2]
    np.testing.assert_allclose((extras[:, 2:, None] * s[:, None] ** np.arange(4)[:, None]).sum(1), smooth, rtol=1e-6)


def test_a_parameter_is_grouped_by_where_much_depends_on_it_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    trace = tracing.trace(surface(SIGMA), 3)
    assert grouped.grouping(trace, ("sigma_d",)) is None  # a few operations only
    monkeypatch.setattr(loops, "LEAST_APART", 1)
    found = grouped.grouping(trace, ("sigma_d", "K_s"))
    assert found is not None
    assert found.parameter.slot == "sigma_d"
    bits = tracing.dependence(found.outputs, trace.leaves())
    assert not any(symbol in bits for symbol in found.numbers)


def test_dust_in_all_orders_is_grouped_by_its_depth() -> None:
    """tau from 0 to 10 over texels, as the engine does it of itself."""
    tau = np.where(RNG.random(COUNT) < 0.2, 0.0, 10 ** RNG.uniform(-1.5, 1, COUNT))
    model = DustLayer(Lambert(0.3), Dust(w=0.9, g=0.6), tau, scattering="multiple")
    found = engine.evaluate(model, WI, WO)
    assert_right(model, found)
    here = next(pair for key, pair in engine._grouped.items() if key[1] == ("tau",) and pair)
    assert here[0].width > 20
    clean = (tau == 0) & (WI[:, 2] > 0) & (WO[:, 2] > 0)
    np.testing.assert_array_equal(found[clean], np.float32(0.3) * np.float32(1 / np.pi))
