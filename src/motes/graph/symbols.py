"""Expression graphs: symbols, and the graph that records, folds and shares them.

A `Graph` is an array namespace (see `motes.arrays`) whose arrays are `Symbol`s: running a formula on symbols records every operation
once.  Equal operations on equal arguments are the same symbol (hash-consing), constants are folded, the author's order of evaluation is
kept.

NaN.  Recording folds ``0 * x`` to 0 although NaN times 0 is NaN; as in all the formulas of Motes, a direction that is NaN still
gives NaN, through the terms that are not multiplied by a constant 0.  No other fold changes a value.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from motes.arrays import NUMPY, Array, Columns

INFIX: dict[str, Callable[[Any, Any], Any]] = {
    "add": operator.add,
    "sub": operator.sub,
    "mul": operator.mul,
    "div": operator.truediv,
    "lt": operator.lt,
    "le": operator.le,
    "gt": operator.gt,
    "ge": operator.ge,
}
FUNCTIONS = ("sqrt", "exp", "expm1", "asin", "log1p", "cbrt", "sin", "cos", "log", "minimum", "maximum", "where")
_COMMUTATIVE = frozenset({"add", "mul", "minimum", "maximum"})


def _binary(op: str) -> tuple[Callable[..., Symbol], Callable[..., Symbol]]:
    return (lambda self, other: self.graph.apply(op, self, other)), (
        lambda self, other: self.graph.apply(op, other, self)
    )


class Symbol:
    """A node of a `Graph`: a leaf (an input), a constant, or an operation on earlier symbols.  Compare with ``is``.

    Attributes
    ----------
    op
        ``"leaf"``, ``"constant"``, ``"neg"``, a key of `INFIX` or a member of `FUNCTIONS`.
    args
        The arguments, symbols of lower `index`.
    value
        The name of a leaf, the value of a constant, None otherwise.
    """

    __slots__ = ("args", "graph", "index", "op", "value")
    __array_ufunc__ = None  # a NumPy scalar times a symbol is a symbol, not an array of objects

    def __init__(self, graph: Graph, index: int, op: str, args: tuple[Symbol, ...], value: Any) -> None:
        self.graph, self.index, self.op, self.args, self.value = graph, index, op, args, value

    __add__, __radd__ = _binary("add")
    __sub__, __rsub__ = _binary("sub")
    __mul__, __rmul__ = _binary("mul")
    __truediv__, __rtruediv__ = _binary("div")
    __lt__, __le__, __gt__, __ge__ = (_binary(op)[0] for op in ("lt", "le", "gt", "ge"))

    def __neg__(self) -> Symbol:
        return self.graph.apply("neg", self)

    def __eq__(self, other: object) -> bool:
        """Itself alone; a number is refused, lest a formula that asks ``if n == 1`` be recorded with the answer No for good."""
        if other is None or isinstance(other, Symbol):
            return self is other
        raise TypeError("a symbol equals no number: choose with xp.where, not with if")

    __hash__ = object.__hash__

    def __bool__(self) -> bool:
        raise TypeError("a symbol has no truth value: choose with xp.where, not with if, min or max")

    def __repr__(self) -> str:
        return str(self.value) if not self.args else f"{self.op}({', '.join(f'#{a.index}' for a in self.args)})"

    def is_constant(self, value: float | None = None) -> bool:
        """True for a constant, or for the constant `value`."""
        return self.op == "constant" and (value is None or (self.value == value and not isinstance(self.value, bool)))


class Graph:
    """An array namespace that records what is computed; `nodes` is in an order in which it can be computed."""

    name = "symbols"

    def __init__(self) -> None:
        self.nodes: list[Symbol] = []
        self._known: dict[tuple[Any, ...], Symbol] = {}

    def leaf(self, name: str) -> Symbol:
        """The input called `name`."""
        return self._node(("leaf", name), "leaf", (), name)

    def constant(self, value: float | bool) -> Symbol:
        value = value if isinstance(value, bool) else float(value)
        return self._node(("constant", repr(value)), "constant", (), value)

    def lift(self, x: Symbol | float | bool) -> Symbol:
        """`x` as a symbol of this graph."""
        if isinstance(x, Symbol):
            if x.graph is not self:
                raise ValueError(f"the symbol {x!r} belongs to another graph")
            return x
        return self.constant(bool(x) if isinstance(x, (bool, np.bool_)) else x)

    def sqrt(self, x: Array) -> Symbol:
        return self.apply("sqrt", x)

    def exp(self, x: Array) -> Symbol:
        return self.apply("exp", x)

    def expm1(self, x: Array) -> Symbol:
        return self.apply("expm1", x)

    def asin(self, x: Array) -> Symbol:
        return self.apply("asin", x)

    def log1p(self, x: Array) -> Symbol:
        return self.apply("log1p", x)

    def cbrt(self, x: Array) -> Symbol:
        """For the losses of fits (`motes.fitting.losses`): no model needs it, and no shading language prints it."""
        return self.apply("cbrt", x)

    def sin(self, x: Array) -> Symbol:
        """For sampling, as are the next three: no formula of a model needs them, and no shading language prints them."""
        return self.apply("sin", x)

    def cos(self, x: Array) -> Symbol:
        return self.apply("cos", x)

    def log(self, x: Array) -> Symbol:
        return self.apply("log", x)

    def stack(self, parts: Sequence[Array]) -> Columns:
        return Columns(self.lift(x) for x in parts)

    def minimum(self, a: Array, b: Array) -> Symbol:
        return self.apply("minimum", a, b)

    def maximum(self, a: Array, b: Array) -> Symbol:
        return self.apply("maximum", a, b)

    def where(self, condition: Array, a: Array, b: Array) -> Symbol:
        return self.apply("where", condition, a, b)

    def apply(self, op: str, *operands: Symbol | float | bool) -> Symbol:
        """The symbol of an operation: folded, found again, or new."""
        args = tuple([x if isinstance(x, Symbol) and x.graph is self else self.lift(x) for x in operands])
        for a in args:
            if a.op != "constant":
                break
        else:
            with np.errstate(all="ignore"):
                result = compute(
                    NUMPY, op, *(np.bool_(a.value) if isinstance(a.value, bool) else np.float64(a.value) for a in args)
                )
            return self.lift(bool(result) if result.dtype == bool else float(result))
        simpler = self._simplified(op, *args)
        if simpler is not None:
            return simpler
        indices = [a.index for a in args]
        if op in _COMMUTATIVE:
            indices.sort()
        return self._node((op, *indices), op, args, None)

    def _node(self, key: tuple[Any, ...], op: str, args: tuple[Symbol, ...], value: Any) -> Symbol:
        known = self._known.get(key)
        if known is None:
            known = self._known[key] = Symbol(self, len(self.nodes), op, args, value)
            self.nodes.append(known)
        return known

    def _simplified(self, op: str, a: Symbol, b: Symbol | None = None, c: Symbol | None = None) -> Symbol | None:
        """An equal, smaller expression, or None."""
        if op == "neg":
            return a.args[0] if a.op == "neg" else None
        if b is None:
            return None
        if op == "mul":
            if a.op == "constant":
                a, b = b, a  # the constant, if any, is b
            if b.op == "constant":
                for unit, result in ((0.0, b), (1.0, a), (-1.0, None)):
                    if b.is_constant(unit):
                        return -a if result is None else result
        elif op == "add":
            if a.op == "constant":
                a, b = b, a
            if b.is_constant(0):
                return a
            if b.op == "neg":
                return a - b.args[0]
            if a.op == b.op == "where" and a.args[0] is b.args[0]:  # the two halves of the derivative of one choice
                for x, y in ((a, b), (b, a)):
                    if x.args[2].is_constant(0) and y.args[1].is_constant(0):
                        return self.where(x.args[0], x.args[1], y.args[2])
        elif op == "sub":
            if b.is_constant(0):
                return a
            if a.is_constant(0):
                return -b
            if b.op == "neg":
                return a + b.args[0]
        elif op == "div":
            if b.is_constant(1) or a.is_constant(0):
                return a
        elif op in ("minimum", "maximum"):
            return a if a is b else None
        elif op == "where":
            if a.op == "constant":
                return b if a.value else c
            return b if b is c else None
        return None


def compute(xp: Any, op: str, *args: Array) -> Array:
    """One operation, on the arrays of a namespace."""
    if op == "neg":
        return -args[0]
    return INFIX[op](*args) if op in INFIX else getattr(xp, op)(*args)
