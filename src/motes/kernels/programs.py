"""The text of programs over rows of lanes: see `motes.kernels.vectors` for the language."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from motes.graph.dependence import live
from motes.graph.tracing import Symbol

#: Operations that the language has no word for: samples need them, and are printed one direction at a time.
WORDLESS = frozenset({"sin", "cos", "log"})


def computed(
    outputs: Sequence[Symbol],
    places: Mapping[Symbol, str],
    known: Mapping[Symbol, str] | None = None,
    suffix: str = "",
    special: Mapping[Symbol, tuple[str, Sequence[Symbol]]] | None = None,
) -> tuple[list[str], dict[Symbol, str]]:
    """The lines of a program that computes `outputs`, and all names in it.

    Parameters
    ----------
    places
        Where the leaves are, in the language of the programs.
    known
        Names of lines before.
    suffix
        Of all new names.
    special
        By symbol the word and the arguments to compute it by, where these are not its operation and its own.
    """
    lines: list[str] = []
    names, special = dict(known or {}), special or {}
    for k, symbol in enumerate(live(outputs, {*places, *names})):
        if symbol in names:
            continue
        if symbol in places:
            name = names[symbol] = f"a{k}{suffix}"
            lines.append(f"{name} = {places[symbol]}")
            if is_truth(symbol):
                names[symbol] = f"{name}_"
                lines.append(f"{name}_ = true {name}")
            continue
        name = names[symbol] = f"t{k}{suffix}"
        if symbol.op == "leaf":
            raise KeyError(f"the leaf {symbol!r} was not given")
        if symbol.op == "constant":
            lines.append(f"{name} = const {symbol.value!r}")
        else:
            op, args = special.get(symbol, (symbol.op, symbol.args))
            lines.append(f"{name} = {op} {' '.join(names[a] for a in args)}")
    return lines, names


def is_truth(symbol: Symbol) -> bool:
    return symbol.op in ("lt", "le", "gt", "ge")


def intrinsic(name: str, call: str, arguments: Sequence[str], lines: Sequence[str]) -> str:
    """The text of a function that is a program of `motes.kernels.vectors`."""
    given = ", ".join(arguments)
    program = "\n".join([" ".join(arguments), *lines])
    return f'def {name}({given}):\n    program = """\n{program}\n"""\n    return {call}program, {given})'
