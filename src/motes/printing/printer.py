"""What all targets share: the order of the statements, which subexpressions get a name, and brackets."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from motes.graph.dependence import live
from motes.graph.tracing import Symbol

ARITHMETIC = {
    "neg": "(-{0})",
    "add": "({0} + {1})",
    "sub": "({0} - {1})",
    "mul": "({0} * {1})",
    "div": "({0} / {1})",
    "lt": "({0} < {1})",
    "le": "({0} <= {1})",
    "gt": "({0} > {1})",
    "ge": "({0} >= {1})",
}
#: Functions that languages of numbers call by the operation's name.
CALLED = {op: f"{op}({{0}})" for op in ("sqrt", "exp", "expm1", "log1p", "asin", "sin", "cos", "log")}
# Arithmetic without brackets, for targets with `levels`.
INFIX = {op: template[1:-1] for op, template in ARITHMETIC.items()}
LEVELS = {"lt": 1, "le": 1, "gt": 1, "ge": 1, "neg": 2, "add": 2, "sub": 2, "mul": 3, "div": 3}
_TIGHT = 9
LONGEST_EXPRESSION = 88


@dataclass(frozen=True)
class Target:
    """How a language writes things.

    Parameters
    ----------
    templates
        By operation, with ``{0} {1} {2}`` for the arguments; what needs brackets brings them.
    constant
        Writes a number or a truth value.
    assignment
        A statement, with ``{name}`` and ``{value}``.
    repeats
        Operations whose template names an argument twice: their arguments are computed beforehand.
    special
        Templates of single symbols, instead of that of their operation; these may repeat arguments too.
    inline
        The same, for templates that name each argument once.
    levels
        How tightly the templates of operations bind, where these bring no brackets of their own: the printer adds those that the order
        of evaluation needs.
    """

    templates: Mapping[str, str]
    constant: Callable[[float | bool], str] = repr
    assignment: str = "{name} = {value}"
    repeats: frozenset[str] = frozenset()
    special: Mapping[Symbol, str] = field(default_factory=dict)
    inline: Mapping[Symbol, str] = field(default_factory=dict)
    levels: Mapping[str, int] = field(default_factory=dict)


class Step(NamedTuple):
    """A statement: the symbol it computes, the name it gets, the text of its value."""

    symbol: Symbol
    name: str
    value: str


def statements(
    target: Target, outputs: Sequence[Symbol], given: Mapping[Symbol, str], prefix: str = "t"
) -> tuple[list[str], list[str]]:
    """Straight-line code for `outputs`.

    Parameters
    ----------
    outputs
        What to compute.
    given
        The text of the symbols that are there already: leaves, and what was computed elsewhere.
    prefix
        Of the names ``t0, t1, ...`` given to subexpressions that are used more than once.

    Returns
    -------
    statements, and the text of each output
    """
    done, results = steps(target, outputs, given, prefix=prefix)
    return [target.assignment.format(name=step.name, value=step.value) for step in done], results


def steps(
    target: Target,
    outputs: Sequence[Symbol],
    given: Mapping[Symbol, str],
    names: Mapping[Symbol, str] | None = None,
    prefix: str = "t",
) -> tuple[list[Step], list[str]]:
    """`statements` before they are written out; symbols in `names` get a statement and that name.

    Returns
    -------
    steps, and the text of each output
    """
    names = names or {}
    order = [symbol for symbol in live(outputs, given) if symbol not in given]
    uses = Counter(a for symbol in order for a in symbol.args)
    uses.update(outputs)
    named = {a for symbol in order if symbol.op in target.repeats or symbol in target.special for a in symbol.args}
    text: dict[Symbol, str] = dict(given)
    level: dict[Symbol, int] = {}  # of the text of a symbol; a name or a call binds most tightly
    done: list[Step] = []
    unnamed = 0
    for symbol in order:
        if symbol.op == "constant":
            text[symbol] = target.constant(symbol.value)
            if target.levels and text[symbol].startswith("-"):
                level[symbol] = target.levels["neg"]
            continue
        if symbol.op == "leaf":
            raise KeyError(f"the leaf {symbol!r} was not given")
        template = target.special.get(symbol) or target.inline.get(symbol) or target.templates[symbol.op]
        own = target.levels.get(symbol.op) if template is target.templates.get(symbol.op) else None
        arguments = [text[a] for a in symbol.args]
        if own is not None:
            arguments = [
                f"({argument})" if level.get(a, _TIGHT) < own + (k > 0 or symbol.op == "neg") else argument
                for k, (a, argument) in enumerate(zip(symbol.args, arguments, strict=True))
            ]
        elif not template.startswith("("):  # a call, whose arguments need no brackets
            arguments = [unbracketed(argument) for argument in arguments]
        expression = template.format(*arguments)
        if symbol in names or uses[symbol] > 1 or symbol in named or len(expression) > LONGEST_EXPRESSION:
            text[symbol] = names.get(symbol) or f"{prefix}{unnamed}"
            unnamed += symbol not in names
            done.append(Step(symbol, text[symbol], unbracketed(expression)))
        else:
            text[symbol] = expression
            if own is not None:
                level[symbol] = own
    return done, [unbracketed(text[symbol]) for symbol in outputs]


def unbracketed(expression: str) -> str:
    """Without the brackets around the whole of it, if there are any."""
    if not expression.startswith("("):
        return expression
    depth = 0
    for k, character in enumerate(expression):
        depth += (character == "(") - (character == ")")
        if depth == 0:
            return expression[1:-1] if k == len(expression) - 1 else expression
    return expression
