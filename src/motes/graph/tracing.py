"""Recording a model as an expression graph.

`trace` runs ``model.value`` on the symbols of a `Graph`, one leaf for every component of the directions and every parameter.
`motes.printing` prints graphs, `motes.kernels.engine` compiles them.  What one does with graphs can be had from here under one name:
symbols (`motes.graph.symbols`), what needs what (`motes.graph.dependence`) and derivatives (`motes.graph.derivatives`).
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass
from typing import Any

import numpy as np

from motes.directions import Geometry, Vector
from motes.graph.dependence import DIRECTIONS, PARAMETERS, dependence, evaluate, frontier, live, rewritten
from motes.graph.derivatives import adjoint, forward
from motes.graph.symbols import FUNCTIONS, INFIX, Graph, Symbol, compute
from motes.parameters import Parametrised

__all__ = [
    "DIRECTIONS",
    "FUNCTIONS",
    "INFIX",
    "MEAN",
    "PARAMETERS",
    "Graph",
    "Symbol",
    "Trace",
    "TracedParameter",
    "adjoint",
    "compute",
    "dependence",
    "evaluate",
    "forward",
    "frontier",
    "key",
    "live",
    "rewritten",
    "split_slots",
    "structure",
    "trace",
]

#: In the place of a channel: the mean over all of them, with which samples are chosen.
MEAN = -1


@dataclass(frozen=True)
class TracedParameter:
    """A parameter of a traced model: its slot's name, the channel it belongs to (None: all; `MEAN`), its leaf, the least value that it may have."""

    slot: str
    channel: int | None
    symbol: Symbol
    least: float = -math.inf

    def of(self, value: Any) -> Any:
        """From the value of a slot with the channels on its last axis what the leaf stands for."""
        return np.mean(value, axis=-1) if self.channel == MEAN else value[..., self.channel or 0]


@dataclass(frozen=True)
class Trace:
    """A model as a graph.

    Attributes
    ----------
    directions
        Six leaves: the components of ``wi``, then of ``wo``; of a sample five, with two random numbers in the place of ``wo``.
    parameters
        The leaves of the parameters, in the order of the model's slots.
    outputs
        The value of each channel; or the density; or, of a sample, the components of ``wo``, the density, and the weight of each channel.
    """

    graph: Graph
    directions: tuple[Symbol, ...]
    parameters: tuple[TracedParameter, ...]
    outputs: tuple[Symbol, ...]

    def leaves(self) -> dict[Symbol, int]:
        """The leaves with their bits, `DIRECTIONS` or `PARAMETERS`."""
        return dict.fromkeys(self.directions, DIRECTIONS) | {p.symbol: PARAMETERS for p in self.parameters}


def split_slots(model: Parametrised, channels: int) -> tuple[str, ...]:
    """The slots that hold a value for each of the channels."""
    return tuple(
        slot.name
        for slot in model.slots()
        if channels > 1 and slot.parameter.per_channel and np.ndim(slot.value) and np.shape(slot.value)[-1] == channels
    )


def structure(model: Parametrised) -> tuple[Any, ...]:
    """What the formula of a model depends on besides the values of its parameters: its types and options, all the way down."""
    children = ((name, structure(child)) for name, child in model.children().items())
    return (type(model), tuple(model.options().items()), tuple(children))


def key(model: Parametrised, channels: int) -> tuple[Any, ...]:
    """Models with equal keys have equal traces."""
    return (structure(model), channels, split_slots(model, channels))


def trace(model: Parametrised, channels: int = 1, *, horizon: bool = True, squared: Collection[str] = ()) -> Trace:
    """Record ``model.value`` for a number of channels.

    Parameters
    ----------
    model
        A BRDF.  Its parameters become leaves: one for every channel (``K_d[0]``, ``K_d[1]``, ...) where the value of a
        per-channel parameter has `channels` entries on its last axis, one for all channels otherwise.
    channels
        Number of channels, at least 1.
    horizon
        False to record ``model.formula``, which holds above the horizon only: for data that has nothing below.
    squared
        Slots whose leaf is the *square* of the parameter: what a fit moves in where a model depends on nothing else
        (`Parameter.squared`), since the slope by the parameter itself is 0 at 0.
    """
    graph = Graph()
    directions = tuple(graph.leaf(f"{w}.{axis}") for w in ("wi", "wo") for axis in "xyz")
    split = split_slots(model, channels)
    parameters: list[TracedParameter] = []
    for slot in model.slots():
        least = slot.parameter.bounds[0]
        for c in range(channels) if slot.name in split else (None,):
            name = slot.name if c is None else f"{slot.name}[{c}]"
            parameters.append(TracedParameter(slot.name, c, graph.leaf(name), least))
    geometry = Geometry(graph, Vector(*directions[:3]), Vector(*directions[3:]))
    outputs = []
    for c in range(channels):
        symbols = {
            p.slot: graph.sqrt(p.symbol) if p.slot in squared else p.symbol
            for p in parameters
            if p.channel in (None, c)
        }
        channel = model.with_parameters(symbols)
        recorded = channel.value if horizon else channel.formula  # type: ignore[attr-defined]
        outputs.append(graph.lift(recorded(graph, geometry)))
    if squared:
        outputs = rewritten(outputs, _square_of_root)
    return Trace(graph, directions, tuple(parameters), tuple(outputs))


def _square_of_root(symbol: Symbol, args: tuple[Symbol, ...]) -> Symbol | None:
    """The square of a leaf's root is the leaf."""
    if symbol.op == "mul" and args[0] is args[1] and args[0].op == "sqrt" and args[0].args[0].op == "leaf":
        return args[0].args[0]
    return None
