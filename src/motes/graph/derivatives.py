"""Derivatives of expression graphs, as further symbols of the same graph: carried forward, or back from the outputs."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence

from motes.graph.dependence import live
from motes.graph.symbols import Symbol

# Where a square root or an arc sine has an infinite slope, the derivative is kept finite, so that 0 times it is 0 and not NaN.
_LEAST_ROOT = 1e-18
# Powers of 2, and what they have in their slopes; the words that kernels have for them are in `motes.kernels.cheaper`.
_BASE_2 = {f"{op}{suffix}": f"exp2{suffix}" for op in ("exp2", "exp2m1") for suffix in ("", "_below")}
_LN_2 = math.log(2)
# Places of what is no argument: what a symbol is 1 over, and what it is the power 3/2 of.
_INVERTED, _THREE_HALVES = -1, -2


def powers(symbols: Sequence[Symbol], leaves: Collection[Symbol] = ()) -> dict[Symbol, tuple[int, Symbol]]:
    """Symbols that are a power of one symbol, and how: their derivative leads there without a way through what they are made of.

    Powers are 1/x, a quotient or a known inverse times a factor that it is the inverse of (`motes.models.slants.inverses`), and x sqrt(x).
    Nothing is passed over that is one of `leaves`.
    """
    found: dict[Symbol, tuple[int, Symbol]] = {}
    for symbol in symbols:
        if symbol.op == "div" and symbol.args[0].is_constant(1) and symbol not in leaves:
            found[symbol] = _INVERTED, symbol.args[1]
        if symbol.op != "mul" or symbol in leaves:
            continue
        for factor, other in (symbol.args, symbol.args[::-1]):
            how, product = found.get(other, (0, symbol))
            if other.op == "sqrt" and other.args[0] is factor and other not in leaves:
                found[symbol] = _THREE_HALVES, factor
            elif how == _INVERTED and product.op == "mul" and factor in product.args and product not in leaves:
                found[symbol] = _INVERTED, product.args[factor is product.args[0]]
    return found


def _arguments(symbol: Symbol, shorter: Mapping[Symbol, tuple[int, Symbol]]) -> list[tuple[int, Symbol]]:
    """What the derivative of a symbol goes on to, with its place."""
    return [shorter[symbol]] if symbol in shorter else list(enumerate(symbol.args))


def _through(symbol: Symbol, k: int, t: Symbol) -> Symbol | None:
    """`t` times the derivative of `symbol` by its argument k; None where that is 0.  Forward and adjoint both use this."""
    graph, op, args = symbol.graph, symbol.op, symbol.args
    if k == _INVERTED:
        return -(t * symbol * symbol)
    if k == _THREE_HALVES:
        return t * (1.5 * args[args[0].op != "sqrt" or args[0].args[0] is not args[1]])
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
    if op in _BASE_2:
        return t * (_LN_2 * graph.apply(_BASE_2[op], a))
    if op in ("asin", "asin_near"):
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
    order = live(outputs)
    shorter = powers(order, set(leaves))
    for symbol in order:
        tangent = {symbol: symbol.graph.constant(1.0)} if symbol in leaves else {}
        for k, argument in _arguments(symbol, shorter):
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
    shorter = powers(order, set(leaves))
    for symbol in order:
        if any(a in wanted for a in symbol.args):
            wanted.add(symbol)
    adjoints = dict(seeds)
    for symbol in reversed(order):
        t = adjoints.get(symbol)
        if t is None or symbol not in wanted or symbol in leaves:
            continue
        for k, argument in _arguments(symbol, shorter):
            step = _through(symbol, k, t) if argument in wanted else None
            if step is not None and not step.is_constant(0):
                adjoints[argument] = adjoints[argument] + step if argument in adjoints else step
    return {leaf: adjoints[leaf] for leaf in leaves if leaf in adjoints}
