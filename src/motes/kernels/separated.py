"""A model as few functions of directions, with coefficients that are functions of parameters: what a fit needs of it is then sums of products of these.

f = sum of q_k(parameters) b_k(directions; parameters), and so are its derivatives, of the same functions and their slopes.  All of Oren-Nayar is three
functions of directions alone; Torrance-Sparrow is one that holds sigma_s, and its slope.
"""

from __future__ import annotations

import keyword
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes import workers
from motes.graph import separation, tracing
from motes.graph.tracing import DIRECTIONS, PARAMETERS, Symbol
from motes.kernels.numpy import HEADER, NUMPY, Columns, compiled, function
from motes.kernels.straight_line import Formula
from motes.parameters import Parametrised
from motes.printing.printer import statements

Floats = NDArray[np.float64]
#: Of more functions, or more that hold parameters, sums of all products take longer than the formula itself.
MOST, MOST_MIXED = 12, 6
#: Exponents of functions do not go below; e^-300 is 1e-130.
LEAST_EXPONENT = -300.0
#: Directions of which functions are made at a time: what is written on the way stays in cache.
BLOCK = 4096
#: Functions by their coefficients.
Combination = dict[Symbol, Symbol]


class Seen(NamedTuple):
    """At N directions: functions without parameters (F, N), columns (N,) that the others are made of; and if factors of what is clamped are never below 0."""

    fixed: Floats
    columns: Columns
    sure: bool


@dataclass(frozen=True)
class Separated:
    """A model at directions above the horizon, separated; see `separated`.

    Attributes
    ----------
    fixed
        How many functions hold no parameter; the first ones.
    mixed
        How many do.
    clamped
        How many of these, the first ones, are what the model clamps at 0, times the first column of `geometry`.
    slots
        The parameters that the functions want.
    values
        Positions of the functions in the model, and those of their coefficients in what `coefficients` returns.
    derivatives
        The same for each of the fitted parameters.
    """

    fixed: int
    mixed: int
    clamped: int
    slots: tuple[str, ...]
    values: tuple[tuple[int, int], ...]
    derivatives: Mapping[str, tuple[tuple[int, int], ...]]
    _geometry: Formula
    _columns: int
    _functions: Callable[..., tuple[Any, ...]]
    _coefficients: Callable[..., tuple[Any, ...]]
    _wanted: tuple[str, ...]

    def geometry(self, wi: NDArray[Any], wo: NDArray[Any]) -> Seen:
        """What depends on directions (N, 3) alone."""
        function, numbers, truths = self._geometry.of_rows(np.dtype(np.float64))
        count = len(wi)
        whole = np.empty((self._columns, count))

        def filled(block: int, memory: tuple[Floats, NDArray[np.bool_]]) -> None:
            rows = slice(block * BLOCK, min((block + 1) * BLOCK, count))
            here = rows.stop - rows.start
            axes = (np.ascontiguousarray(w[rows, k], float) for w in (wi, wo) for k in range(3))
            with np.errstate(all="ignore"):
                function(*(part[:, :here] for part in memory), whole[:, rows], *axes)

        def room() -> tuple[Floats, NDArray[np.bool_]]:
            return np.empty((numbers, min(BLOCK, count))), np.empty((truths, min(BLOCK, count)), bool)

        workers.spread(-(-count // BLOCK), filled, room)
        return Seen(whole[1 : 1 + self.fixed], tuple(whole[1 + self.fixed :]), bool(whole[0].min(initial=0.0) >= 0))

    def functions(self, columns: Columns, parameters: Mapping[str, Any]) -> tuple[Any, ...]:
        """Those that hold parameters, at columns (n,) for parameters (B, 1)."""
        return self._functions(*columns, *(parameters[slot] for slot in self.slots))

    def coefficients(self, parameters: Mapping[str, Any]) -> tuple[Any, ...]:
        """All coefficients, in whatever shape the parameters, (B, C) or (B, 1), give them."""
        return self._coefficients(*(parameters[slot] for slot in self._wanted))


_known: dict[tuple[Any, ...], Separated | None] = {}


def separated(
    model: Parametrised, fitted: Sequence[str], *, squared: Sequence[str] = (), per_channel: Sequence[str] = ()
) -> Separated | None:
    """The model, separated; None where it does not separate into few functions that all channels share.

    Arguments as for `motes.kernels.numpy.residual_function`.
    """
    key = (tracing.structure(model), tuple(fitted), tuple(squared), tuple(per_channel))
    if key not in _known:
        trace = tracing.trace(model, 1, horizon=False, squared=squared)
        _known[key] = _made(trace, tuple(fitted), frozenset(per_channel))
    return _known[key]


def _made(trace: tracing.Trace, fitted: tuple[str, ...], per_channel: frozenset[str]) -> Separated | None:
    graph, (output,) = trace.graph, trace.outputs
    slots = {p.symbol: p.slot for p in trace.parameters}
    own = {symbol for symbol, slot in slots.items() if slot in per_channel}
    mark, leaves = graph.leaf("mark"), trace.leaves()
    factor, marked = graph.constant(1.0), output
    inner = separation.clamps([output], tracing.dependence([output], leaves))
    if inner:
        if len(inner) > 1 or not _clamps_at_zero(output, inner[0]):
            return None
        held = graph.leaf("held")
        slope = tracing.forward([separation.in_place_of_clamps(output, {inner[0]: held})], [held])[0].get(held)
        if slope is None or tracing.dependence([slope], leaves | {held: PARAMETERS})[slope] & PARAMETERS:
            return None
        factor, marked = slope, separation.in_place_of_clamps(output, {inner[0]: mark * inner[0]})
    leaves |= {mark: PARAMETERS}

    value: Combination = {}
    clamped: set[Symbol] = set()
    for b, q, of_clamp in _terms(marked, leaves, mark):
        _add(value, b, q)
        if of_clamp != (b in clamped) and b in value and value[b] is not q:
            return None  # one function both within what is clamped and outside
        if of_clamp:
            clamped.add(b)
    bits = tracing.dependence(value, leaves)
    mixed = [b for b in value if bits[b] & PARAMETERS]
    if any(own & set(tracing.live([b])) for b in mixed):
        return None
    by_slot = {slot: symbol for symbol, slot in slots.items()}
    wanted = [by_slot[name] for name in fitted]
    rows: dict[str, Combination] = {name: {} for name in fitted}
    slopes = tracing.forward(list(value), wanted)
    for (b, q), slopes_of_b in zip(value.items(), slopes, strict=True):
        (of_q,) = tracing.forward([q], wanted)
        for name, p in zip(fitted, wanted, strict=True):
            if p in of_q:
                _add(rows[name], b, of_q[p])
            if p in slopes_of_b:
                for s, more, _ in _terms(slopes_of_b[p], leaves, mark):
                    _add(rows[name], s, q * more)
                    if b in clamped:
                        clamped.add(s)
    functions = list(dict.fromkeys([*value, *(b for row in rows.values() for b in row)]))
    bits = tracing.dependence(functions, leaves)
    functions.sort(key=lambda b: (bool(bits[b] & PARAMETERS), b not in clamped))
    fixed = sum(not bits[b] & PARAMETERS for b in functions)
    if len(functions) > MOST or len(functions) - fixed > MOST_MIXED or any(b in clamped for b in functions[fixed:]):
        return None

    at = {b: k for k, b in enumerate(functions)}
    coefficients = list(dict.fromkeys([*value.values(), *(q for row in rows.values() for q in row.values())]))
    place = {q: k for k, q in enumerate(coefficients)}
    texts = {symbol: f"{slot}_" if keyword.iskeyword(slot) else slot for symbol, slot in slots.items()}
    moving = _without_subnormals(functions[fixed:])
    columns = tracing.frontier(moving, tracing.dependence(moving, leaves), DIRECTIONS)
    held_by = tuple(slot for symbol, slot in slots.items() if symbol in set(tracing.live(moving)))
    asked = tuple(slot for symbol, slot in slots.items() if symbol in set(tracing.live(coefficients)))

    def written(name: str, outputs: Sequence[Symbol], given: Mapping[Symbol, str], takes: Sequence[str]) -> Any:
        body, results = statements(NUMPY, outputs, given)
        return compiled(f"{HEADER}\n\n{function(name, takes, body, results)}", "separated model")[name]

    as_columns = {column: f"g{k}" for k, column in enumerate(columns)}
    return Separated(
        fixed,
        len(moving),
        len(clamped),
        held_by,
        tuple((at[b], place[q]) for b, q in value.items()),
        {name: tuple((at[b], place[q]) for b, q in row.items()) for name, row in rows.items()},
        Formula(trace.directions, (), [[factor, *functions[:fixed], *columns]]),
        1 + fixed + len(columns),
        written("functions", moving, texts | as_columns, [*as_columns.values(), *(texts[by_slot[s]] for s in held_by)]),
        written("coefficients", coefficients, texts, [texts[by_slot[s]] for s in asked]),
        asked,
    )


def _without_subnormals(functions: Sequence[Symbol]) -> list[Symbol]:
    """The same with exponentials that stay so large that no product of two functions is below the smallest normal number: Intel's processors take a
    hundred cycles for each of those, and what is so small adds nothing to any sum."""

    def rule(symbol: Symbol, args: tuple[Symbol, ...]) -> Symbol | None:
        return symbol.graph.apply("exp", symbol.graph.maximum(args[0], LEAST_EXPONENT)) if symbol.op == "exp" else None

    return tracing.rewritten(functions, rule)


def _terms(symbol: Symbol, leaves: Mapping[Symbol, int], mark: Symbol) -> list[tuple[Symbol, Symbol, bool]]:
    """Functions, their coefficients, and whether they stand in what is clamped; numbers go with the coefficients."""
    graph = symbol.graph
    (output,) = separation.gathered([symbol], leaves)
    found = []
    for key, value in separation.terms(output, tracing.dependence([output], leaves)).items():
        (b,) = separation.gathered([value], leaves)
        q = graph.constant(1.0)
        if b.op == "constant":
            q, b = b, graph.constant(1.0)
        for factor in key:
            q = q if factor is mark else q * factor
        found.append((b, q, mark in key))
    return found


def _clamps_at_zero(output: Symbol, inner: Symbol) -> bool:
    clamps = [s for s in tracing.live([output]) if s.op == "maximum" and inner in s.args]
    return all(any(a.is_constant(0.0) for a in s.args) for s in clamps)


def _add(row: Combination, function: Symbol, coefficient: Symbol) -> None:
    row[function] = row[function] + coefficient if function in row else coefficient
