"""NaN in minima and maxima of generated kernels: as in NumPy where it can be seen, cheap where it cannot."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np
import pytest

from catalogue import ENTRIES, Entry, reference

pytest.importorskip("llvmlite")

from motes.arrays import Array
from motes.directions import Geometry
from motes.graph import tracing
from motes.graph.nan import careful
from motes.graph.tracing import Graph
from motes.kernels import engine
from motes.models import BRDF, Component
from motes.parameters import parameter


def test_a_minimum_that_is_seen_needs_care() -> None:
    graph = Graph()
    a, b = graph.leaf("a"), graph.leaf("b")
    smaller = graph.minimum(a, b)
    for output in (smaller, graph.exp(smaller), smaller + a, graph.where(a > 0, smaller, b)):
        assert careful([output], [a, b]) == {smaller}


def test_a_minimum_behind_a_term_with_the_same_inputs_needs_none() -> None:
    graph = Graph()
    a, b = graph.leaf("a"), graph.leaf("b")
    smaller = graph.minimum(a, b)
    assert careful([smaller + a * b], [a, b]) == set()
    assert careful([smaller + b], [a, b]) == set(), (
        "a NaN of a comes through the minimum, one of b through the other term"
    )
    assert careful([graph.minimum(a, 1.0), graph.maximum(0.0, b)], [a, b]) == set(), "a constant is no NaN"
    assert careful([smaller], [a]) == set(), "b is no input that may be NaN"
    assert careful([smaller + a * b, smaller], [a, b]) == {smaller}, "the second output shows it"


def test_both_branches_of_a_choice_count() -> None:
    graph = Graph()
    a, b = graph.leaf("a"), graph.leaf("b")
    smaller = graph.minimum(a, b)
    assert careful([smaller * graph.where(a > 0, b, 2 * b)], [a, b]) == set()
    assert careful([smaller * graph.where(a > 0, b, 2.0)], [a, b]) == {smaller}


@pytest.mark.parametrize("entry", ENTRIES, ids=str)
def test_the_models_need_none(entry: Entry) -> None:
    trace = tracing.trace(entry.model, entry.model.channels)
    assert careful(trace.outputs, trace.directions) == set()


@dataclass(frozen=True, eq=False)
class Extremes(BRDF):
    """No reflectance, but a formula in which a NaN of any operand would go unseen."""

    K_d: Array = parameter(1.0, bounds=(0, 9), symbol="K_d", doc="scale", per_channel=True)

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        wi, wo = geometry.wi, geometry.wo
        larger = xp.maximum(xp.minimum(wi.x, 0.25), wo.x)
        return self.K_d * (3 + xp.minimum(larger, xp.maximum(wi.y, wo.y)))

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return []


def test_seen_minima_treat_nan_as_numpy_does() -> None:
    values = (np.nan, -0.5, 0.1, 0.4)
    grid = np.array(list(itertools.product(values, repeat=4)))
    up = np.ones(len(grid))
    wi, wo = np.stack([grid[:, 0], grid[:, 1], up], -1), np.stack([grid[:, 2], grid[:, 3], up], -1)
    found, expected = engine.evaluate(Extremes(), wi, wo), reference(Extremes(), wi, wo)
    np.testing.assert_array_equal(found, expected)
    assert 0.6 < np.isnan(found).mean() < 0.9
