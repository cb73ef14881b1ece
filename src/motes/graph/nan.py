"""Which minima and maxima must be written so that a NaN in either operand wins, as it does in NumPy.

A processor's minimum lets a NaN of one operand through and drops that of the other; winning from both sides costs two more
instructions.  They are mostly not needed: where a NaN is dropped, another term of the formula usually carries it into the result all
the same.  `careful` finds the operations for which that cannot be shown.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

from motes.graph.dependence import live
from motes.graph.symbols import Symbol


def careful(outputs: Sequence[Symbol], leaves: Collection[Symbol]) -> set[Symbol]:
    """Minima and maxima of `outputs` in which the NaN of either operand must win.

    Parameters
    ----------
    outputs
        What is computed.
    leaves
        The inputs that may be NaN.

    Notes
    -----
    For every symbol, `depends` is the set of leaves it depends on and `carries` those whose NaN it is sure to carry although minima and maxima
    keep the NaN of the first operand only (`first`).  Where the two are equal, the symbol is NaN exactly if a leaf is, whatever happens
    beneath it; so only what can be reached from the outputs without passing through such a symbol needs care.
    """
    depends: dict[Symbol, frozenset[Symbol]] = {}
    carries: dict[Symbol, frozenset[Symbol]] = {}
    for symbol in live(outputs):
        args = symbol.args
        depends[symbol] = frozenset().union(*(depends[a] for a in args)) | (
            {symbol} if symbol in leaves else frozenset()
        )
        if symbol in leaves:
            carries[symbol] = frozenset({symbol})
        elif symbol.op in ("minimum", "maximum"):
            carries[symbol] = carries[first(symbol)]
        elif symbol.op == "where":
            carries[symbol] = carries[args[1]] & carries[args[2]]
        elif symbol.op in ("lt", "le", "gt", "ge"):
            carries[symbol] = frozenset()  # a truth value is never NaN
        else:
            carries[symbol] = frozenset().union(*(carries[a] for a in args))
    exposed: set[Symbol] = set()
    stack = list(outputs)
    while stack:
        symbol = stack.pop()
        if symbol not in exposed and carries[symbol] != depends[symbol]:
            exposed.add(symbol)
            stack.extend(symbol.args)
    return {symbol for symbol in exposed if symbol.op in ("minimum", "maximum")}


def first(symbol: Symbol) -> Symbol:
    """The operand of a minimum or maximum that is written first: a constant comes second."""
    a, b = symbol.args
    return b if a.op == "constant" else a
