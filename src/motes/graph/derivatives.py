"""Derivatives of expression graphs, as further symbols of the same graph: carried forward, or back from the outputs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from motes.graph.dependence import live
from motes.graph.symbols import Symbol

# Where a square root or an arc sine has an infinite slope, the derivative is kept finite, so that 0 times it is 0 and not NaN.
_LEAST_ROOT = 1e-18


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
    if op == "log1p":
        return t / (1 + a)
    if op == "log":
        return t / a
    if op == "sin":
        return t * graph.cos(a)
    if op == "cos":
        return -(t * graph.sin(a))
    if op == "cbrt":
        return t / (3 * graph.maximum(symbol * symbol, _LEAST_ROOT))
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
