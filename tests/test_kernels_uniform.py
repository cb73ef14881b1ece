"""What of a kernel depends on uniform parameters alone: worked out for values that are new, and gone back through."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from motes.graph import tracing
from motes.graph.tracing import TracedParameter
from motes.kernels import loops
from motes.kernels.uniform import Uniform
from motes.models import Dust, DustLayer, Lambert

MODEL = DustLayer(Lambert(0.5), Dust(w=0.9, g=0.3), 0.2, scattering="multiple")


@pytest.fixture(scope="module")
def uniform() -> Uniform:
    trace = tracing.trace(MODEL)
    constants = loops.evaluation(trace, (), "float64").constants
    return Uniform(trace, trace.parameters, constants, constants, np.dtype(np.float64))


def of(**changed: float) -> dict[str, float]:
    return {slot.name: float(np.ravel(slot.value)[0]) for slot in MODEL.slots()} | changed


def found(uniform: Uniform, values: dict[str, float]) -> NDArray[np.float64]:
    return uniform.constants(lambda p: values[p.slot])


def test_new_values_are_noticed_and_old_ones_kept(uniform: Uniform) -> None:
    first = found(uniform, of())
    assert found(uniform, of()) is first
    other = found(uniform, of(tau=0.3))
    assert not np.array_equal(first, other)
    np.testing.assert_array_equal(found(uniform, of()), first)
    assert found(uniform, of(tau=0.0)) is not found(uniform, of(tau=-0.0)), "0 and -0 have inverses of their own"
    with pytest.raises(ValueError, match="read-only"):
        first[0] = 0.0


def test_the_way_back_is_that_of_the_values_at_hand(uniform: Uniform) -> None:
    weights = np.random.default_rng(1).normal(size=len(found(uniform, of())))
    found(uniform, of(tau=0.7))  # another call's values in between
    values = of(tau=0.4)
    slopes = uniform.pullback(lambda p: values[p.slot], weights)

    def total(p: TracedParameter, step: float) -> float:
        return float(weights @ found(uniform, values | {p.slot: values[p.slot] + step}))

    assert {p.slot for p in slopes} == set(values)
    for p, slope in slopes.items():
        assert slope == pytest.approx((total(p, 1e-6) - total(p, -1e-6)) / 2e-6, rel=1e-6, abs=1e-6)
