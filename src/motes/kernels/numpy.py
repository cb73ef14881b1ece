"""Printing a graph as straight-line NumPy, and the functions that fits call: values and derivatives of a model.

A fit evaluates one model at fixed directions for many parameter sets.  `residual_function` writes a module for that: what depends on the
directions alone is computed once (``geometry``), what depends on parameters alone is computed at the shape of the parameters
(`motes.kernels.parameters_alone`), and the rest broadcasts.  Derivatives are carried forward, since a derivative by a shared parameter
keeps its smaller shape to the last step.
"""

from __future__ import annotations

import keyword
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes import workers
from motes.graph import tracing
from motes.graph.tracing import Symbol
from motes.kernels.parameters_alone import NUMBERS, Alone, Results, found
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
# The bit of parameters that each channel has for itself, where that is known; and from how many operations on parameters alone they are a function.
_OF_CHANNELS, _WORTH_A_FUNCTION = 4, 32
HEADER = "from numpy import arcsin, cos, exp, expm1, log, log1p, maximum, minimum, sin, sqrt, where\n"


def function(name: str, arguments: Sequence[str], body: Sequence[str], results: Sequence[str]) -> str:
    """The text of a Python function that returns a tuple."""
    returned = ", ".join(results) + ("," if len(results) == 1 else "")
    return "\n    ".join([f"def {name}({', '.join(arguments)}):", *body, f"return ({returned})"]) + "\n"


def scalar_function(
    name: str, arguments: Mapping[Symbol, str], results: Sequence[Symbol]
) -> Callable[..., tuple[Any, ...]]:
    """A function of numbers (or arrays) that computes `results`, straight from memory."""
    body, texts = statements(NUMPY, results, arguments)
    namespace = compiled(f"{HEADER}\n\n{function(name, list(arguments.values()), body, texts)}", name)
    made: Callable[..., tuple[Any, ...]] = namespace[name]
    return made


def function_of_numbers(
    name: str, arguments: Mapping[Symbol, str], results: Sequence[Symbol]
) -> Callable[..., tuple[Any, ...]]:
    """The same of numbers alone, in Python's own: the same bits in a third of the time."""
    body, texts = statements(NUMPY, results, arguments)
    text = function(name, list(arguments.values()), body, texts)
    names = NUMBERS.copy()
    exec(compile(text, f"<motes: {name}>", "exec"), names)
    over_numbers: Callable[..., tuple[Any, ...]] = names[name]
    over_arrays: list[Callable[..., tuple[Any, ...]]] = []

    def made(*given: float) -> tuple[Any, ...]:
        with np.errstate(all="ignore"):
            try:
                return over_numbers(*map(float, given))
            except (
                ZeroDivisionError,
                ValueError,
            ):  # NumPy goes on with an infinity or a NaN, which `where` may leave out
                over_arrays[:] = over_arrays or [compiled(f"{HEADER}\n\n{text}", name)[name]]
                return over_arrays[0](*map(np.float64, given))

    return made


def compiled(source: str, title: str) -> dict[str, Any]:
    """The names that our own generated `source` defines."""
    names: dict[str, Any] = {}
    exec(compile(source, f"<motes: {title}>", "exec"), names)
    return names


@dataclass(frozen=True)
class _Formula:
    """Generated functions that make one: what depends on parameters alone, at most twice, and the rest."""

    alone: tuple[Alone, ...]
    takes: tuple[str, ...]
    rest: Callable[..., tuple[Any, ...]]

    def __call__(self, geometry: Columns, parameters: Mapping[str, Any]) -> tuple[Any, ...]:
        results = [Results()]
        for alone in self.alone:
            results.append(found(alone, [parameters[slot] for slot in alone.takes], results[-1]))
        return self.rest(geometry, *(each.arrays for each in results[1:]), *(parameters[slot] for slot in self.takes))


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
    _values: _Formula
    _both: _Formula

    def geometry(self, wi: NDArray[Any], wo: NDArray[Any]) -> Columns:
        """Everything that depends on the directions ``wi, wo`` (N, 3) alone: float64 arrays (N, 1)."""
        return in_blocks(self._geometry, wi, wo)

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
            return self._values(geometry, parameters)[0]

    def values_and_jacobian(self, geometry: Columns, parameters: Mapping[str, Any]) -> tuple[Any, dict[str, Any]]:
        """As `values`, and the derivative by each of `fitted`, in whatever smaller shape it has: (B, N, 1) for K_s, for example."""
        with np.errstate(all="ignore"):
            f, *derivatives = self._both(geometry, parameters)
        return f, dict(zip(self.fitted, derivatives, strict=True))


def in_blocks(made: Callable[..., Columns], wi: NDArray[Any], wo: NDArray[Any]) -> Columns:
    """What a function makes of the six components of directions ``wi, wo`` (N, 3): float64 arrays (N, 1), or (1, 1)."""
    wi, wo = np.asarray(wi, np.float64), np.asarray(wo, np.float64)
    count = len(wi)
    with np.errstate(all="ignore"):
        columns = made(*_axes(wi[:BLOCK], wo[:BLOCK]))
        if count <= BLOCK:
            return columns
        # In one array: the system hands out memory of some megabytes in large pages, and many small ones take as long as what is computed.
        long = [len(column) == BLOCK for column in columns]
        room = iter(np.empty((sum(long), count, 1)))
        whole = tuple(next(room) if own else column for own, column in zip(long, columns, strict=True))

    def filled(block: int, _: None) -> None:
        rows = slice(block * BLOCK, (block + 1) * BLOCK)
        with np.errstate(all="ignore"):  # intermediate results stay in cache
            parts = made(*_axes(wi[rows], wo[rows])) if block else columns
        for own, column, part in zip(long, whole, parts, strict=True):
            if own:
                column[rows] = part

    workers.spread(-(-count // BLOCK), filled, lambda: None)
    return whole


def _axes(wi: NDArray[np.float64], wo: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """The six components (n, 1) of pairs of directions (n, 3), each in one piece."""
    return [np.ascontiguousarray(w[:, k])[:, None] for w in (wi, wo) for k in range(3)]


_functions: dict[tuple[Any, ...], FitFunction] = {}


def residual_function(
    model: Parametrised,
    fitted: Sequence[str],
    *,
    horizon: bool = True,
    squared: Sequence[str] = (),
    per_channel: Sequence[str] = (),
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
    per_channel
        Slots that will be given for each channel: what the others alone tell is then computed once for all channels.
    """
    key = (tracing.structure(model), tuple(fitted), horizon, tuple(squared), tuple(per_channel))
    if key not in _functions:
        trace = tracing.trace(model, 1, horizon=horizon, squared=squared)
        _functions[key] = _generate(trace, tuple(fitted), frozenset(per_channel))
    return _functions[key]


def _generate(trace: tracing.Trace, fitted: tuple[str, ...], per_channel: frozenset[str]) -> FitFunction:
    (output,) = trace.outputs
    leaves = {p.slot: p.symbol for p in trace.parameters}
    unknown = [name for name in fitted if name not in leaves]
    if unknown:
        raise KeyError(f"no parameter {unknown[0]!r}: the model has {', '.join(leaves)}")
    (tangents,) = tracing.forward([output], [leaves[name] for name in fitted])
    both = [output, *(tangents.get(leaves[name], trace.graph.constant(0.0)) for name in fitted)]

    columns = tracing.frontier(both, tracing.dependence(both, trace.leaves()), tracing.DIRECTIONS)
    axes = ["ix", "iy", "iz", "ox", "oy", "oz"]
    body, results = statements(NUMPY, columns, dict(zip(trace.directions, axes, strict=True)))
    writer = _Writer(trace, columns, per_channel)
    geometry = writer.compiled(function("geometry", axes, body, results), "geometry")
    formulas = writer.formula("values", [output]), writer.formula("values_and_jacobian", both)
    return FitFunction(tuple(leaves), fitted, "\n\n".join([HEADER, *writer.source]), geometry, *formulas)


class _Writer:
    """Writes the functions of the formulas of a model."""

    def __init__(self, trace: tracing.Trace, columns: Sequence[Symbol], per_channel: frozenset[str]) -> None:
        self.columns = {column: f"g{k}" for k, column in enumerate(columns)}
        self.slots = {p.symbol: p.slot for p in trace.parameters}
        self.leaves = trace.leaves() | {s: _OF_CHANNELS for s, slot in self.slots.items() if slot in per_channel}
        self.source: list[str] = []

    def compiled(self, text: str, name: str) -> Callable[..., Any]:
        """A function as it works on arrays."""
        self.source.append(text)
        made: Callable[..., Any] = compiled(f"{HEADER}\n\n{text}", "fit function")[name]
        return made

    def formula(self, name: str, outputs: Sequence[Symbol]) -> _Formula:
        """The functions for some outputs."""
        bits = tracing.dependence(outputs, self.leaves)
        before: dict[str, dict[Symbol, str]] = {}
        alone = []
        for stage, inside, by in (
            ("_shared", tracing.PARAMETERS, tracing.PARAMETERS),
            ("_own", tracing.PARAMETERS | _OF_CHANNELS, _OF_CHANNELS),
        ):
            known = {symbol for names in before.values() for symbol in names}
            wanted = [s for s in tracing.frontier(outputs, bits, inside) if s.args and bits[s] & by and s not in known]
            if sum(bool(s.args) and s not in known for s in tracing.live(wanted, known)) < _WORTH_A_FUNCTION:
                continue
            text, takes = self._function(f"{name}{stage}", wanted, before or {"_shared": {}})
            code = compile(text, "<motes: parameters alone>", "exec")
            numbers = NUMBERS.copy()
            exec(code, numbers)
            over_numbers, mixed = numbers[f"{name}{stage}"], by == _OF_CHANNELS
            alone.append(Alone(takes, self.compiled(text, f"{name}{stage}"), over_numbers, mixed))
            before[stage] = {symbol: f"{stage}{k}" for k, symbol in enumerate(wanted)}
        text, takes = self._function(name, outputs, {"geometry": self.columns} | before)
        return _Formula(tuple(alone), takes, self.compiled(text, name))

    def _function(
        self, name: str, outputs: Sequence[Symbol], before: Mapping[str, Mapping[Symbol, str]]
    ) -> tuple[str, tuple[str, ...]]:
        """The text of a function that takes tuples of what was computed `before`, and parameters; the slots of these."""
        given = {symbol: text for names in before.values() for symbol, text in names.items()}
        needed = set(tracing.live(outputs, given))
        takes = tuple(slot for symbol, slot in self.slots.items() if symbol in needed)
        texts = {symbol: f"{slot}_" if keyword.iskeyword(slot) else slot for symbol, slot in self.slots.items()}
        body, results = statements(NUMPY, outputs, texts | given)
        unpacked = [
            f"{''.join(f'{text}, ' for text in names.values())}= {which}" for which, names in before.items() if names
        ]
        arguments = [*before, *(texts[symbol] for symbol, slot in self.slots.items() if slot in takes)]
        return function(name, arguments, [*unpacked, *body], results), takes
