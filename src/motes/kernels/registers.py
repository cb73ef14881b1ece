"""Printing a graph as NumPy calls that write into a few rows of memory, taken again as soon as nothing needs what they hold.

Expressions over arrays make a new array for every operation.  Where arrays are of some thousand numbers, finding memory for them and fetching it
from beyond the level-1 cache cost more than the arithmetic; here some fifteen rows serve a whole formula.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from motes.graph.dependence import live
from motes.graph.tracing import Symbol

#: Functions of NumPy by operation; all but ``where`` can be told where to write, for which `program` writes two statements.
CALLS = {
    "neg": "negative",
    "add": "add",
    "sub": "subtract",
    "mul": "multiply",
    "div": "divide",
    "lt": "less",
    "le": "less_equal",
    "gt": "greater",
    "ge": "greater_equal",
    "sqrt": "sqrt",
    "exp": "exp",
    "expm1": "expm1",
    "log1p": "log1p",
    "asin": "arcsin",
    "sin": "sin",
    "cos": "cos",
    "log": "log",
    "minimum": "minimum",
    "maximum": "maximum",
    "where": "where",
}
_TRUTHS = ("lt", "le", "gt", "ge")


@dataclass(frozen=True)
class Program:
    """Statements, the text of each output, and how many rows of numbers ``r0, r1, ...`` and of truth values ``m0, ...`` they want."""

    lines: tuple[str, ...]
    results: tuple[str, ...]
    numbers: int
    truths: int


class _Names:
    """Names of a kind, the lowest free one first."""

    def __init__(self, prefix: str) -> None:
        self.prefix, self.count, self.free = prefix, 0, list[int]()

    def take(self) -> str:
        if self.free:
            self.free.sort(reverse=True)
            return f"{self.prefix}{self.free.pop()}"
        self.count += 1
        return f"{self.prefix}{self.count - 1}"

    def give_back(self, name: str) -> None:
        self.free.append(int(name[len(self.prefix) :]))


def program(
    outputs: Sequence[Symbol],
    given: Mapping[Symbol, str],
    constant: Callable[[float | bool], str],
    row: Callable[[float], str] | None = None,
) -> Program:
    """The operations that `outputs` need, each a call.

    Parameters
    ----------
    outputs
        What to compute.
    given
        The text of the symbols that are there already, rows or numbers; they are not written to.  Truth values among them are no rows.
    constant
        The text of a number or a truth value.
    row
        The text of a row that holds a number everywhere: NumPy takes a minimum or maximum with one in half the time that it takes with a number.
    """
    order = [symbol for symbol in live(outputs, given) if symbol not in given]
    last = {a: k for k, symbol in enumerate(order) for a in symbol.args}
    last |= dict.fromkeys(outputs, len(order))
    kinds = {"numbers": _Names("r"), "truths": _Names("m")}
    text, lines = dict(given), list[str]()
    held: dict[Symbol, _Names] = {}
    for k, symbol in enumerate(order):
        if symbol.op == "constant":
            text[symbol] = constant(symbol.value)
            continue
        if symbol.op == "leaf":
            raise KeyError(f"the leaf {symbol!r} was not given")
        ends = [a for a in dict.fromkeys(symbol.args) if a in held and last[a] == k]
        if symbol.op == "where":
            name, more = _chosen(symbol, text, kinds["numbers"], held, ends)
            lines += more
            kind = kinds["numbers"]
        else:
            extremum = symbol.op in ("minimum", "maximum")
            rows = {a: row(a.value) for a in symbol.args if a.op == "constant"} if extremum and row is not None else {}
            arguments = ", ".join(rows.get(a) or text[a] for a in symbol.args)
            for a in ends:  # a result may be written where an argument was: number by number, each is read first
                held.pop(a).give_back(text[a])
            kind = kinds["truths" if symbol.op in _TRUTHS else "numbers"]
            name = kind.take()
            target = f"out={name}" if extremum else name
            lines.append(f"{CALLS[symbol.op]}({arguments}, {target})")
        text[symbol], held[symbol] = name, kind
    return Program(
        tuple(lines), tuple(text[symbol] for symbol in outputs), kinds["numbers"].count, kinds["truths"].count
    )


def _chosen(
    symbol: Symbol, text: Mapping[Symbol, str], numbers: _Names, held: dict[Symbol, _Names], ends: list[Symbol]
) -> tuple[str, list[str]]:
    """Where a choice is written, and by which statements; `ends` are the arguments that nothing asks for after it.

    ``where`` makes a new array, in the time of two other operations; so what the condition names is put into the other numbers.
    """
    condition, first, second = symbol.args
    alone = condition not in held  # one truth value for all directions
    if not alone and second in ends and held[second] is numbers:
        name, lines = text[second], []
        held.pop(second)
        ends.remove(second)
    else:
        name = numbers.take()  # before the arguments give theirs back, for one of them is read after it is written to
        lines = [f"copyto({name}, {f'{text[first]} if {text[condition]} else ' if alone else ''}{text[second]})"]
    for a in ends:
        held.pop(a).give_back(text[a])
    return name, lines if alone else [*lines, f"putmask({name}, {text[condition]}, {text[first]})"]
