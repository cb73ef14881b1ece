"""What needs what in an expression graph: order, values, dependence on leaves, and replacements.

What no output needs is never visited.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from operator import attrgetter
from typing import Any

from motes.arrays import Array
from motes.graph.symbols import Symbol, compute

_index = attrgetter("index")
DIRECTIONS, PARAMETERS = 1, 2  # the bits of a model's leaves


def live(outputs: Iterable[Symbol], given: Container[Symbol] = ()) -> list[Symbol]:
    """The symbols that the outputs need, themselves included, each after its arguments; none that only `given` ones need."""
    seen = set(outputs)
    stack = list(seen)
    while stack:
        symbol = stack.pop()
        if symbol not in given:
            for a in symbol.args:
                if a not in seen:
                    seen.add(a)
                    stack.append(a)
    return sorted(seen, key=_index)


def evaluate(xp: Any, outputs: Sequence[Symbol], leaves: Mapping[Symbol, Array]) -> list[Array]:
    """The values of `outputs` over a namespace, from the values of the leaves."""
    values: dict[Symbol, Array] = dict(leaves)
    for symbol in live(outputs):
        if symbol.op == "constant":
            values[symbol] = symbol.value
        elif symbol.op != "leaf":
            values[symbol] = compute(xp, symbol.op, *(values[a] for a in symbol.args))
    return [values[symbol] for symbol in outputs]


def dependence(outputs: Iterable[Symbol], leaves: Mapping[Symbol, int]) -> dict[Symbol, int]:
    """For every live symbol the union (bitwise or) of the bits of the leaves it depends on; 0 for constants."""
    bits: dict[Symbol, int] = {}
    for symbol in live(outputs):
        bit = leaves.get(symbol, 0)
        for a in symbol.args:
            bit |= bits[a]
        bits[symbol] = bit
    return bits


def frontier(outputs: Sequence[Symbol], bits: Mapping[Symbol, int], inside: int) -> list[Symbol]:
    """The symbols that depend on `inside` alone and are used by others that do not, or are outputs: what to compute beforehand."""
    needed = {a for symbol, bit in bits.items() if bit & ~inside for a in symbol.args} | set(outputs)
    return [symbol for symbol in bits if symbol in needed and bits[symbol] and not bits[symbol] & ~inside]


def rewritten(outputs: Sequence[Symbol], rule: Callable[[Symbol, tuple[Symbol, ...]], Symbol | None]) -> list[Symbol]:
    """The outputs with operations replaced: ``rule(symbol, new_arguments)`` gives a replacement, or None to keep the operation."""
    new: dict[Symbol, Symbol] = {}
    for symbol in live(outputs):
        if not symbol.args:
            new[symbol] = symbol
            continue
        args = tuple([new[a] for a in symbol.args])
        replacement = rule(symbol, args)
        if replacement is None:
            replacement = symbol if args == symbol.args else symbol.graph.apply(symbol.op, *args)
        new[symbol] = replacement
    return [new[symbol] for symbol in outputs]
