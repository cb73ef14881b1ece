"""What is recorded of a model besides its value: the density of its samples, and a sample with its density and weight; each once for a structure."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from typing import Any

from motes.arrays import Columns
from motes.directions import Geometry, Vector
from motes.graph.symbols import Graph
from motes.graph.tracing import MEAN, Trace, TracedParameter, key, split_slots, trace
from motes.parameters import Parametrised


class Kind(Enum):
    """What is computed of a model."""

    VALUE = "the value"
    DENSITY = "the density of a sample"
    SAMPLE = "a sample, its density and its weight"


def _leaves(
    graph: Graph, model: Parametrised, channels: int
) -> tuple[list[TracedParameter], Parametrised, list[Parametrised]]:
    """The leaves of the parameters; the model of their means over the channels, which chooses samples; the model of each channel."""
    split = split_slots(model, channels)
    parameters: list[TracedParameter] = []
    for slot in model.slots():
        kinds = (MEAN, *range(channels)) if slot.name in split else (None,)
        for c in kinds:
            suffix = "" if c is None else "[mean]" if c == MEAN else f"[{c}]"
            parameters.append(TracedParameter(slot.name, c, graph.leaf(slot.name + suffix), slot.parameter.bounds[0]))

    def of(channel: int) -> Parametrised:
        return model.with_parameters({p.slot: p.symbol for p in parameters if p.channel in (None, channel)})

    return parameters, of(MEAN), [of(c) for c in range(channels)]


def _density(model: Any, channels: int) -> Trace:
    graph = Graph()
    inputs = tuple(graph.leaf(f"{w}.{axis}") for w in ("wi", "wo") for axis in "xyz")
    parameters, mean, _ = _leaves(graph, model, channels)
    density = mean.density(graph, Columns(inputs[:3]), Columns(inputs[3:]))  # type: ignore[attr-defined]
    return Trace(graph, inputs, tuple(parameters), (graph.lift(density),))


def _sample(model: Any, channels: int) -> Trace:
    graph = Graph()
    inputs = tuple(graph.leaf(name) for name in ("wi.x", "wi.y", "wi.z", "u.0", "u.1"))
    parameters, mean, each = _leaves(graph, model, channels)
    wi = Columns(inputs[:3])
    wo = mean.drawn(graph, wi, Columns(inputs[3:]))  # type: ignore[attr-defined]
    density = mean.density(graph, wi, wo)  # type: ignore[attr-defined]
    geometry = Geometry(graph, Vector(*wi), Vector(*wo))
    scale = mean.weighing(graph, wo, density)  # type: ignore[attr-defined]
    weights = [one.value(graph, geometry) * scale for one in each]  # type: ignore[attr-defined]
    outputs = tuple(graph.lift(x) for x in (*wo, density, *weights))
    return Trace(graph, inputs, tuple(parameters), outputs)


_RECORDERS: dict[Kind, Callable[[Any, int], Trace]] = {
    Kind.VALUE: trace,
    Kind.DENSITY: _density,
    Kind.SAMPLE: _sample,
}
_recorded: dict[tuple[Any, ...], Trace | None] = {}


def recorded(kind: Kind, model: Parametrised, channels: int) -> Trace | None:
    """A model as a graph, recorded once for its structure; None where symbols cannot follow its formulas."""
    full = (kind, key(model, channels))
    try:
        known = full in _recorded
    except TypeError:  # a field that is nothing to look up by, such as an array
        return None
    if not known:
        try:
            _recorded[full] = _RECORDERS[kind](model, channels)
        except Exception:  # a formula of somebody's own may do anything
            _recorded[full] = None
    return _recorded[full]
