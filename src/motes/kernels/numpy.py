"""Printing a graph as straight-line NumPy, and the functions that fits call: values and derivatives of a model.

A fit evaluates one model at fixed directions for many parameter sets.  `residual_function` writes a module for that: what depends on the
directions alone is computed once (``geometry``), what depends on parameters alone is computed at the shape of the parameters, and
the rest broadcasts.  Derivatives are carried forward, since a derivative by a shared parameter keeps its smaller shape to the last step.
"""

from __future__ import annotations

import keyword
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.graph import tracing
from motes.graph.tracing import Symbol
from motes.parameters import Parametrised
from motes.printing.printer import ARITHMETIC, CALLED, Target, statements

Columns = tuple[NDArray[np.float64], ...]

NUMPY = Target(
    templates=ARITHMETIC
    | CALLED
    | {
        "asin": "arcsin({0})",
        "minimum": "minimum({0}, {1})",
        "maximum": "maximum({0}, {1})",
        "where": "where({0}, {1}, {2})",
    },
)
#: Directions of which `FitFunction.geometry` is made at a time.
BLOCK = 8192
_HEADER = "from numpy import arcsin, cos, exp, expm1, log, log1p, maximum, minimum, sin, sqrt, where\n"


def function(name: str, arguments: Sequence[str], body: Sequence[str], results: Sequence[str]) -> str:
    """The text of a Python function that returns a tuple."""
    returned = ", ".join(results) + ("," if len(results) == 1 else "")
    return "\n    ".join([f"def {name}({', '.join(arguments)}):", *body, f"return ({returned})"]) + "\n"


def scalar_function(
    name: str, arguments: Mapping[Symbol, str], results: Sequence[Symbol]
) -> Callable[..., tuple[Any, ...]]:
    """A function of numbers (or arrays) that computes `results`, straight from memory."""
    body, texts = statements(NUMPY, results, arguments)
    namespace = compiled(f"{_HEADER}\n\n{function(name, list(arguments.values()), body, texts)}", name)
    made: Callable[..., tuple[Any, ...]] = namespace[name]
    return made


def compiled(source: str, title: str) -> dict[str, Any]:
    """The names that our own generated `source` defines."""
    names: dict[str, Any] = {}
    exec(compile(source, f"<motes: {title}>", "exec"), names)
    return names


@dataclass(frozen=True)
class FitFunction:
    """A model at fixed directions as a function of its parameters; see `residual_function`.

    Attributes
    ----------
    slots
        The parameters that `values` wants, by slot name.
    fitted
        Those by which `values_and_jacobian` differentiates.
    source
        The generated module.
    """

    slots: tuple[str, ...]
    fitted: tuple[str, ...]
    source: str
    _geometry: Callable[..., Columns]
    _values: Callable[..., tuple[Any]]
    _both: Callable[..., tuple[Any, ...]]

    def geometry(self, wi: NDArray[Any], wo: NDArray[Any]) -> Columns:
        """Everything that depends on the directions ``wi, wo`` (N, 3) alone: float64 arrays (N, 1)."""
        axes = [
            np.ascontiguousarray(w[:, k])
            for w in (np.asarray(wi, np.float64), np.asarray(wo, np.float64))
            for k in range(3)
        ]
        count = len(axes[0])
        with np.errstate(all="ignore"):
            columns = self._geometry(*(axis[:BLOCK, None] for axis in axes))
            if count <= BLOCK:
                return columns
            whole = tuple(np.empty((count, 1)) if len(column) == BLOCK else column for column in columns)
            for first in range(0, count, BLOCK):  # whose intermediate results stay in cache
                rows = slice(first, first + BLOCK)
                columns = self._geometry(*(axis[rows, None] for axis in axes)) if first else columns
                for column, part in zip(whole, columns, strict=True):
                    if len(column) == count:
                        column[rows] = part
        return whole

    def values(self, geometry: Columns, parameters: Mapping[str, Any]) -> Any:
        """The BRDF [1/sr].

        Parameters
        ----------
        geometry
            From `geometry`.
        parameters
            For each of `slots` a number or an array that broadcasts against (B, N, C): (B, 1, 1) for B sets of a parameter that all channels
            share, (B, 1, C) where each channel has its own.  Any other order of axes that broadcasts will do: NumPy is twice as
            fast with the directions last, columns (N,) and parameters (B, C, 1).

        Returns
        -------
        array, the shape that the inputs broadcast to
        """
        with np.errstate(all="ignore"):
            return self._values(geometry, *(parameters[slot] for slot in self.slots))[0]

    def values_and_jacobian(self, geometry: Columns, parameters: Mapping[str, Any]) -> tuple[Any, dict[str, Any]]:
        """As `values`, and the derivative by each of `fitted`, in whatever smaller shape it has: (B, N, 1) for K_s, for example."""
        with np.errstate(all="ignore"):
            f, *derivatives = self._both(geometry, *(parameters[slot] for slot in self.slots))
        return f, dict(zip(self.fitted, derivatives, strict=True))


_functions: dict[tuple[Any, ...], FitFunction] = {}


def residual_function(
    model: Parametrised, fitted: Sequence[str], *, horizon: bool = True, squared: Sequence[str] = ()
) -> FitFunction:
    """Values and derivatives of `model` as functions of its parameters; made once for each kind of model and set of names.

    Parameters
    ----------
    model
        A BRDF; the values of its parameters do not matter.
    fitted
        The slots to differentiate by.
    horizon
        False when no direction is at or below the horizon: the function then does not look.
    squared
        Slots that are given as their square; see `motes.graph.tracing.trace`.
    """
    key = (tracing.structure(model), tuple(fitted), horizon, tuple(squared))
    if key not in _functions:
        _functions[key] = _generate(tracing.trace(model, 1, horizon=horizon, squared=squared), tuple(fitted))
    return _functions[key]


def _generate(trace: tracing.Trace, fitted: tuple[str, ...]) -> FitFunction:
    (output,) = trace.outputs
    leaves = {p.slot: p.symbol for p in trace.parameters}
    unknown = [name for name in fitted if name not in leaves]
    if unknown:
        raise KeyError(f"no parameter {unknown[0]!r}: the model has {', '.join(leaves)}")
    (tangents,) = tracing.forward([output], [leaves[name] for name in fitted])
    both = [output, *(tangents.get(leaves[name], trace.graph.constant(0.0)) for name in fitted)]

    bits = tracing.dependence(both, trace.leaves())
    columns = tracing.frontier(both, bits, tracing.DIRECTIONS)
    axes = ["ix", "iy", "iz", "ox", "oy", "oz"]
    body, results = statements(NUMPY, columns, dict(zip(trace.directions, axes, strict=True)))
    source = [_HEADER, function("geometry", axes, body, results)]
    arguments = {slot: f"{slot}_" if keyword.iskeyword(slot) else slot for slot in leaves}
    given = {leaves[slot]: text for slot, text in arguments.items()}
    given |= {column: f"g{k}" for k, column in enumerate(columns)}
    for name, outputs in (("values", [output]), ("values_and_jacobian", both)):
        body, results = statements(NUMPY, outputs, given)
        unpack = [f"{''.join(f'g{k}, ' for k in range(len(columns)))}= geometry"] if columns else []
        source.append(function(name, ["geometry", *arguments.values()], [*unpack, *body], results))
    text = "\n\n".join(source)
    names = compiled(text, "fit function")
    return FitFunction(tuple(leaves), fitted, text, names["geometry"], names["values"], names["values_and_jacobian"])
