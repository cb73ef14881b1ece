"""Recording a formula as an expression graph, and differentiating the graph.

A `Graph` is an array namespace (see `motes.arrays`) whose arrays are `Symbol`s: running ``model.value`` on symbols records every
operation once.  Equal operations on equal arguments are the same symbol (hash-consing), constants are folded, the author's order
of evaluation is kept, and what no output needs is never visited.  `motes.printing` prints graphs, `motes.kernels.engine` compiles them.

NaN.  Recording folds ``0 * x`` to 0 although NaN times 0 is NaN; as in all the formulas of Motes, a direction that is NaN still
gives NaN, through the terms that are not multiplied by a constant 0.  No other fold changes a value.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from motes.arrays import NUMPY, Array
from motes.directions import Geometry, Vector
from motes.parameters import Parametrised

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
FUNCTIONS = ("sqrt", "exp", "expm1", "asin", "minimum", "maximum", "where")
_COMMUTATIVE = frozenset({"add", "mul", "minimum", "maximum"})
# Where a square root or an arc sine has an infinite slope, the derivative is kept finite, so that 0 times it is 0 and not NaN.
_LEAST_ROOT = 1e-18


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

    def minimum(self, a: Array, b: Array) -> Symbol:
        return self.apply("minimum", a, b)

    def maximum(self, a: Array, b: Array) -> Symbol:
        return self.apply("maximum", a, b)

    def where(self, condition: Array, a: Array, b: Array) -> Symbol:
        return self.apply("where", condition, a, b)

    def apply(self, op: str, *operands: Symbol | float | bool) -> Symbol:
        """The symbol of an operation: folded, found again, or new."""
        args = tuple(self.lift(x) for x in operands)
        if all(a.op == "constant" for a in args):
            with np.errstate(all="ignore"):
                result = compute(
                    NUMPY, op, *(np.bool_(a.value) if isinstance(a.value, bool) else np.float64(a.value) for a in args)
                )
            return self.lift(bool(result) if result.dtype == bool else float(result))
        simpler = self._simplified(op, *args)
        if simpler is not None:
            return simpler
        indices = [a.index for a in args]
        return self._node((op, *(sorted(indices) if op in _COMMUTATIVE else indices)), op, args, None)

    def _node(self, key: tuple[Any, ...], op: str, args: tuple[Symbol, ...], value: Any) -> Symbol:
        if key not in self._known:
            self._known[key] = Symbol(self, len(self.nodes), op, args, value)
            self.nodes.append(self._known[key])
        return self._known[key]

    def _simplified(self, op: str, a: Symbol, b: Symbol | None = None, c: Symbol | None = None) -> Symbol | None:
        """An equal, smaller expression, or None."""
        if op == "neg":
            return a.args[0] if a.op == "neg" else None
        if b is None:
            return None
        if op in ("add", "mul") and a.is_constant():
            a, b = b, a  # the constant, if any, is b
        if op == "add":
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
        elif op == "mul":
            for unit, result in ((0.0, b), (1.0, a), (-1.0, None)):
                if b.is_constant(unit):
                    return -a if result is None else result
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


def live(outputs: Iterable[Symbol]) -> list[Symbol]:
    """The symbols that the outputs need, themselves included, each after its arguments."""
    seen: set[Symbol] = set()
    stack = list(outputs)
    while stack:
        symbol = stack.pop()
        if symbol not in seen:
            seen.add(symbol)
            stack.extend(symbol.args)
    return sorted(seen, key=lambda symbol: symbol.index)


def evaluate(xp: Any, outputs: Sequence[Symbol], leaves: Mapping[Symbol, Array]) -> list[Array]:
    """The values of `outputs` over a namespace, from the values of the leaves."""
    values: dict[Symbol, Array] = dict(leaves)
    for symbol in live(outputs):
        if symbol.op == "constant":
            values[symbol] = symbol.value
        elif symbol.op != "leaf":
            values[symbol] = compute(xp, symbol.op, *(values[a] for a in symbol.args))
    return [values[symbol] for symbol in outputs]


# ---------------------------------------------------------------- Derivatives


def _through(symbol: Symbol, k: int, t: Symbol) -> Symbol | None:
    """`t` times the derivative of `symbol` by its argument k; None where that is 0.  Forward and adjoint both use this."""
    graph, op, args = symbol.graph, symbol.op, symbol.args
    a, b = args[0], args[-1]
    if op in ("add", "sub"):
        return -t if op == "sub" and k == 1 else t
    if op == "mul":
        return t * args[1 - k]
    if op == "div":
        return t / b if k == 0 else -(t / b * symbol)
    if op == "neg":
        return -t
    if op == "sqrt":
        return t * (0.5 / graph.maximum(symbol, _LEAST_ROOT))
    if op in ("exp", "expm1"):
        return t * graph.exp(a)
    if op == "asin":
        return t / graph.maximum(graph.sqrt((1 - a) * (1 + a)), _LEAST_ROOT)
    if op in ("minimum", "maximum"):  # one-sided at a tie: the first argument
        first = a <= b if op == "minimum" else a >= b
        return graph.where(first, t, 0.0) if k == 0 else graph.where(first, 0.0, t)
    if op == "where":
        return (None, graph.where(a, t, 0.0), graph.where(a, 0.0, t))[k]
    return None  # comparisons


def forward(outputs: Sequence[Symbol], leaves: Sequence[Symbol]) -> list[dict[Symbol, Symbol]]:
    """Derivatives of every output by every leaf, carried along with the values; what is 0 by structure is absent."""
    tangents: dict[Symbol, dict[Symbol, Symbol]] = {}
    for symbol in live(outputs):
        tangent = {symbol: symbol.graph.constant(1.0)} if symbol in leaves else {}
        for k, argument in enumerate(symbol.args):
            for leaf, t in tangents[argument].items():
                step = _through(symbol, k, t)
                if step is not None:
                    tangent[leaf] = tangent[leaf] + step if leaf in tangent else step
        tangents[symbol] = {leaf: t for leaf, t in tangent.items() if not t.is_constant(0)}
    return [tangents[symbol] for symbol in outputs]


def adjoint(seeds: Mapping[Symbol, Symbol], leaves: Sequence[Symbol]) -> dict[Symbol, Symbol]:
    """The derivative of sum(output * seed) by every leaf, carried back from the outputs; what is 0 by structure is absent.

    Any symbols may be named as `leaves`: the derivative by one of them holds the others fixed.
    """
    order = live(seeds)
    wanted = set(leaves)
    for symbol in order:
        if any(a in wanted for a in symbol.args):
            wanted.add(symbol)
    adjoints = dict(seeds)
    for symbol in reversed(order):
        t = adjoints.get(symbol)
        if t is None or symbol not in wanted or symbol in leaves:
            continue
        for k, argument in enumerate(symbol.args):
            step = _through(symbol, k, t) if argument in wanted else None
            if step is not None and not step.is_constant(0):
                adjoints[argument] = adjoints[argument] + step if argument in adjoints else step
    return {leaf: adjoints[leaf] for leaf in leaves if leaf in adjoints}


# ---------------------------------------------------------------- What depends on what


def dependence(outputs: Iterable[Symbol], leaves: Mapping[Symbol, int]) -> dict[Symbol, int]:
    """For every live symbol the union (bitwise or) of the bits of the leaves it depends on; 0 for constants."""
    bits: dict[Symbol, int] = {}
    for symbol in live(outputs):
        bits[symbol] = leaves.get(symbol, 0)
        for a in symbol.args:
            bits[symbol] |= bits[a]
    return bits


def frontier(outputs: Sequence[Symbol], bits: Mapping[Symbol, int], inside: int) -> list[Symbol]:
    """The symbols that depend on `inside` alone and are used by others that do not, or are outputs: what to compute beforehand."""
    needed = {a for symbol, bit in bits.items() if bit & ~inside for a in symbol.args} | set(outputs)
    return [symbol for symbol in bits if symbol in needed and bits[symbol] and not bits[symbol] & ~inside]


def rewritten(outputs: Sequence[Symbol], rule: Callable[[Symbol, tuple[Symbol, ...]], Symbol | None]) -> list[Symbol]:
    """The outputs with operations replaced: ``rule(symbol, new_arguments)`` gives a replacement, or None to keep the operation."""
    new: dict[Symbol, Symbol] = {}
    for symbol in live(outputs):
        args = tuple(new[a] for a in symbol.args)
        replacement = rule(symbol, args) if args else None
        if replacement is None:
            replacement = symbol if args == symbol.args else symbol.graph.apply(symbol.op, *args)
        new[symbol] = replacement
    return [new[symbol] for symbol in outputs]


# ---------------------------------------------------------------- Models

DIRECTIONS, PARAMETERS = 1, 2  # bits for `dependence`


@dataclass(frozen=True)
class TracedParameter:
    """A parameter of a traced model: the name of its slot, the channel it belongs to (None: all of them), its leaf."""

    slot: str
    channel: int | None
    symbol: Symbol


@dataclass(frozen=True)
class Trace:
    """A model as a graph.

    Attributes
    ----------
    directions
        Six leaves: the components of ``wi``, then of ``wo``.
    parameters
        The leaves of the parameters, in the order of the model's slots.
    outputs
        The value of each channel.
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
        if slot.name in split:
            parameters += [TracedParameter(slot.name, c, graph.leaf(f"{slot.name}[{c}]")) for c in range(channels)]
        else:
            parameters.append(TracedParameter(slot.name, None, graph.leaf(slot.name)))
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
