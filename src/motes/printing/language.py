"""How a shading language writes things, and the texts around its statements: comments, blocks, what numbers are made of."""

from __future__ import annotations

import math
import re
import textwrap
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field

from motes import directions, equations
from motes.graph.tracing import Symbol

OWN = ("asin", "exp", "expm1")
#: How most languages write what is not arithmetic.
TEMPLATES = {
    "sqrt": "sqrt({0})",
    "log1p": "log(1.0 + {0})",
    "minimum": "min({0}, {1})",
    "maximum": "max({0}, {1})",
    "where": "({0} ? {1} : {2})",
}
WIDTH = 118
#: `Language.power` where the bits of numbers cannot be written: exp2 of a whole number is exact.
POWER_WITHOUT_BITS = "({k} < -125.0 ? 0.0 : exp2({k} - 1.0))"
# Numbers of the equations that have a name, and why they are what they are.
CONSTANTS = {
    equations.INV_PI: ("INV_PI", "1/pi"),
    directions.HALF_PI: ("HALF_PI", "pi/2"),
    directions.SMALLEST_COSINE: (
        "SMALLEST_COSINE",
        "cosines divide: kept above 0, below what a unit vector can resolve",
    ),
}


@dataclass(frozen=True)
class Language:
    """How a shading language writes things.

    Parameters
    ----------
    title
        For people: ``GLSL ES 3.00``.
    number, color, direction, truth
        Types.
    constant
        A declaration of a named number, with ``{name}`` and ``{value}``.
    declaration
        A statement, with ``{type}``, ``{name}`` and ``{value}``.
    header
        The head of a function of numbers, with ``{name}`` and ``{arguments}``.
    argument
        One argument of it, with ``{type}`` and ``{name}``.
    qualifier
        What stands before the head of every function.
    templates
        By operation.
    splat
        A number as a colour, with ``{0}``.
    components
        The three components of a colour ``{0}``.
    power
        2^(k - 1) for a whole number k, with ``{k}``: exact, and 0 for k = -126, where float32 keeps only some of its bits.
    literal
        Writes a number.
    reserved
        Words that cannot be names, beside those of C.
    own
        The operations for which a shader brings functions of its own.
    color_header
        The head of a function of directions that returns a colour.
    array_argument, array_header, array_first, array_copy, array_last, loop
        For other than one or three channels: an argument with a value for each, the head of the function that fills ``f``, statements
        at its beginning (`array_copy` for each such argument, which is indexed as ``{name}_all`` then) and end, the head of the loop.
    """

    title: str
    number: str
    color: str
    direction: str
    truth: str
    constant: str
    splat: str
    templates: Mapping[str, str] = field(default_factory=TEMPLATES.copy)
    components: tuple[str, str, str] = ("{0}.x", "{0}.y", "{0}.z")
    power: str = ""
    declaration: str = "{type} {name} = {value};"
    header: str = "{number} {name}({arguments})"
    argument: str = "{type} {name}"
    qualifier: str = ""
    literal: Callable[[float], str] = repr
    reserved: frozenset[str] = frozenset()
    own: tuple[str, ...] = OWN
    color_header: str = "{color} {name}({arguments})"
    array_argument: str = "{number} {name}[{count}]"
    array_header: str = "void {name}({arguments}, out {number} f[{count}])"
    array_first: str = ""
    array_copy: str = ""
    array_last: str = ""
    loop: str = "for (int c = 0; c < {count}; ++c)"

    def type(self, symbol: Symbol, colored: Collection[Symbol] = ()) -> str:
        """The type of a symbol, of which those in `colored` are colours."""
        if symbol.op in ("lt", "le", "gt", "ge"):
            return self.truth
        return self.color if symbol in colored else self.number

    def declare(self, type_: str, name: str, value: str) -> str:
        """A statement that names a value, with a comment that explains its long numbers."""
        return self.declaration.format(type=type_, name=name, value=value) + explained(value)

    def named_constants(self, lines: Sequence[str]) -> list[str]:
        """Declarations of the named numbers in some lines, comments aside."""
        code = "\n".join(line for line in lines if not line.lstrip().startswith("//"))
        return [
            f"{self.constant.format(name=name, value=self.literal(value))}  // {why}"
            for value, (name, why) in CONSTANTS.items()
            if re.search(rf"\b{name}\b", code)
        ]

    def function(self, name: str, arguments: Sequence[str], lines: Sequence[str]) -> str:
        """The definition of a function of numbers."""
        declared = ", ".join(self.argument.format(type=self.number, name=argument) for argument in arguments)
        head = self.header.format(number=self.number, name=name, arguments=declared)
        return "\n".join([f"{self.qualifier}{head} {{", *indented(lines), "}"])

    def text(self, value: float | bool) -> str:
        """A number, by its name where it has one, or a truth value."""
        if isinstance(value, bool):
            return "true" if value else "false"
        return CONSTANTS[value][0] if value in CONSTANTS else self.literal(value)


def comment(text: str, mark: str = "//", indent: str = "") -> list[str]:
    """`text` as lines of comment."""
    return textwrap.wrap(
        text,
        WIDTH,
        initial_indent=f"{mark} {indent}",
        subsequent_indent=f"{mark} {indent}",
        break_long_words=False,
        break_on_hyphens=False,
    )


def indented(lines: Sequence[str], depth: int = 1) -> list[str]:
    """`lines` of a block."""
    return ["    " * depth + line if line else line for line in lines]


def explained(code: str) -> str:
    """A comment that says what the long numbers of a statement are made of: ``2/pi = 0.6366``."""
    found = {}
    for literal in re.findall(r"(?<![\w.])\d+\.\d{8,}(?:e-?\d+)?", code):
        if origin := _origin(float(literal)):
            found[origin] = f"{origin} = {float(literal):.4g}"
    return f"  // {', '.join(found.values())}" if found else ""


def _origin(value: float) -> str:
    """A number as a short decimal times or over a power of pi, or as one over a whole number; empty where it is neither."""
    for factor, name in ((math.pi, "/pi"), (math.pi**2, "/pi^2"), (1 / math.pi, " pi")):
        short = f"{value * factor:.4g}"
        if math.isclose(float(short) / factor, value, rel_tol=1e-15):
            return f"{short}{name}"
    inverse = round(1 / value)
    return f"1/{inverse}" if 2 < inverse < 100 and math.isclose(1 / inverse, value, rel_tol=1e-15) else ""
