"""A recorded formula as NumPy functions of two kinds: over scalars for a single direction, and over rows of memory for many.

Both do the same operations in the same order.  What depends on parameters alone is left to a third function, of the *constants*.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.graph import tracing
from motes.graph.tracing import Symbol, TracedParameter
from motes.kernels import numpy as numpy_code
from motes.kernels.registers import CALLS, program
from motes.printing.printer import Target, statements

Array = NDArray[Any]
Function = Callable[..., Any]

# NumPy's own look for arrays first, which takes longer than the work; these give what those give.
_OF_SCALARS: dict[str, Any] = {
    **{name: getattr(np, name) for name in CALLS.values()},
    "minimum": lambda a, b: a if a < b or a != a else b,
    "maximum": lambda a, b: a if a > b or a != a else b,
    "where": lambda condition, a, b: a if condition else b,
}
_OF_ROWS: dict[str, Any] = {name: getattr(np, name) for name in (*CALLS.values(), "copyto", "putmask")}


class Formula:
    """The functions of a formula, each printed when it is first asked for.

    Parameters
    ----------
    inputs
        The leaves that differ from direction to direction.
    parameters
        The other leaves.
    outputs
        Lists of outputs, of which a call computes one: the formula with and without something.
    """

    def __init__(
        self, inputs: Sequence[Symbol], parameters: Sequence[TracedParameter], outputs: Sequence[Sequence[Symbol]]
    ) -> None:
        self.parameters, self._outputs = tuple(parameters), outputs
        leaves = dict.fromkeys(inputs, tracing.DIRECTIONS) | {p.symbol: tracing.PARAMETERS for p in parameters}
        together = [symbol for some in outputs for symbol in some]
        frontier = tracing.frontier(together, tracing.dependence(together, leaves), tracing.PARAMETERS)
        names = {p.symbol: f"p{k}" for k, p in enumerate(parameters)}
        self.constants: Callable[..., tuple[Any, ...]] = numpy_code.scalar_function("constants", names, frontier)
        columns = {symbol: f"i{k}" for k, symbol in enumerate(inputs)}
        self._given = columns | {symbol: f"c{k}" for k, symbol in enumerate(frontier)}
        self._arguments = [*columns.values(), *(f"c{k}" for k in range(len(frontier)))]
        self._made: dict[Any, Any] = {}

    def of_scalars(self, scalar: np.dtype[Any], which: int = 0) -> Function:
        """The inputs and the constants in, a tuple of outputs out: all of them numbers of NumPy's of that type."""
        key = (scalar, which, "scalars")
        if key not in self._made:
            pool: dict[float, str] = {}
            target = Target(numpy_code.NUMPY.templates, lambda value: _named(pool, value))
            body, results = statements(target, self._outputs[which], self._given)
            source = numpy_code.function("formula", self._arguments, body, results)
            self._made[key] = _function(source, pool, scalar.type, _OF_SCALARS)
        made: Function = self._made[key]
        return made

    def of_rows(self, scalar: np.dtype[Any], which: int = 0) -> tuple[Function, int, int]:
        """The same over rows, and how many of numbers and of truth values it wants to write to.

        The function is handed these rows, a list of arrays to store the outputs in, the inputs, and the constants as arrays without axes.
        """
        key = (scalar, which, "rows")
        if key not in self._made:
            pool: dict[float, str] = {}
            full: dict[float, str] = {}
            rows = program(
                self._outputs[which],
                self._given,
                lambda value: _named(pool, value),
                lambda value: full.setdefault(value, f"w{len(full)}"),
            )
            kinds = (("r", rows.numbers, "numbers"), ("m", rows.truths, "truths"))
            unpacked = [f"{''.join(f'{x}{k}, ' for k in range(n))}= {what}" for x, n, what in kinds if n]
            unpacked += [f"{name} = all_{name}({self._arguments[0]}.size)" for name in full.values()]
            stored = [f"out[{c}][...] = {result}" for c, result in enumerate(rows.results)]
            takes = ["numbers", "truths", "out", *self._arguments]
            source = numpy_code.function("formula", takes, [*unpacked, *rows.lines, *stored], ["out"])
            wide = {f"all_{name}": _Everywhere(value, scalar).row for value, name in full.items()}
            function = _function(source, pool, lambda value: np.array(value, scalar), _OF_ROWS | wide)
            self._made[key] = function, rows.numbers, rows.truths
        made: tuple[Function, int, int] = self._made[key]
        return made


class _Everywhere:
    """Rows that hold a number everywhere; nobody writes to them."""

    def __init__(self, value: float, scalar: np.dtype[Any]) -> None:
        self._longest = np.full(0, value, scalar)
        self._value = value

    def row(self, size: int) -> Array:
        """So long a row, of one that is kept."""
        longest = self._longest
        if longest.size < size:
            longest = self._longest = np.full(size, self._value, longest.dtype)
        return longest[:size]


def _named(pool: dict[float, str], value: float | bool) -> str:
    """The name of a constant, which is made of the type of the others; a truth value is written as it is."""
    return repr(value) if isinstance(value, bool) else pool.setdefault(value, f"k{len(pool)}")


def _function(source: str, pool: dict[float, str], lift: Callable[[float], Any], functions: dict[str, Any]) -> Function:
    names = functions | {name: lift(value) for value, name in pool.items()}
    exec(compile(source, "<motes: a formula>", "exec"), names)
    made: Function = names["formula"]
    return made
