"""The functions that a shader brings: elementary ones, and equations of parameters alone that are too long to stand among the others.

Shading languages promise little of asin and exp (GLSL: 4096 ulp for asin; OSL: 1e-4), and most have no expm1.  So a shader has its
own, with the float32 polynomials of `motes.printing.elementary`.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping

from motes.graph import tracing
from motes.graph.tracing import PARAMETERS, Symbol
from motes.printing.elementary import FLOAT32, horner
from motes.printing.language import Language, comment, indented
from motes.printing.names import Recording
from motes.printing.printer import Target, steps

# Operations that an outlined function must at least hold.
LARGE = 12


def outlined(
    recording: Recording,
    language: Language,
    target: Target,
    prefix: str,
    given: Mapping[Symbol, str],
    skip: Collection[Symbol],
) -> tuple[dict[Symbol, str], list[str]]:
    """Equations that become functions: the calls that stand for their symbols, and the definitions.

    `skip` are symbols that cannot, because they are colours.
    """
    bits = tracing.dependence(recording.trace.outputs, recording.trace.leaves())
    calls: dict[Symbol, str] = {}
    known: dict[str, str] = {}
    for symbol, name in recording.names.items():
        cone = tracing.live([symbol])
        if not name.equation or bits.get(symbol) != PARAMETERS or symbol in skip or len(cone) <= LARGE:
            continue
        leaves = [s for s in cone if s.op == "leaf"]
        lines = _inside(recording, language, target, symbol, _arguments(leaves))
        key = "\n".join(lines)
        if key not in known:  # a second highlight uses the function of the first
            count = 1 + sum(text.startswith(f"{prefix}_{name.text}") for text in known.values())
            known[key] = f"{prefix}_{name.text}" + (f"_{count}" if count > 1 else "")
        calls[symbol] = f"{known[key]}({', '.join(given[leaf] for leaf in leaves)})"
    definitions = {}
    for symbol, call in calls.items():
        leaves = [s for s in tracing.live([symbol]) if s.op == "leaf"]
        arguments = _arguments(leaves)
        said = [line for paragraph in recording.names[symbol].comment for line in comment(paragraph)]
        function = language.function(
            call.partition("(")[0], list(arguments.values()), _inside(recording, language, target, symbol, arguments)
        )
        definitions[call.partition("(")[0]] = "\n".join([*said, function])
    return calls, list(definitions.values())


def _arguments(leaves: list[Symbol]) -> dict[Symbol, str]:
    """Names for the arguments of a function: those of the parameters, without the number that tells a second one apart."""
    bare = [re.sub(r"_\d+$", "", leaf.value) for leaf in leaves]
    return {leaf: name if bare.count(name) == 1 else leaf.value for leaf, name in zip(leaves, bare, strict=True)}


def _inside(
    recording: Recording, language: Language, target: Target, symbol: Symbol, given: Mapping[Symbol, str]
) -> list[str]:
    """The statements of a function that computes `symbol`."""
    names = {s: n.text for s, n in recording.names.items() if s is not symbol}

    def block(output: Symbol) -> list[str]:
        done, (result,) = steps(target, [output], given, names)
        return [*(language.declare(language.type(s.symbol), s.name, s.value) for s in done), f"return {result};"]

    if symbol.op == "where":  # of the two branches only one is computed
        condition, yes, no = symbol.args
        _, (test,) = steps(target, [condition], given)
        lines = [f"if ({test}) {{", *indented(block(yes)), "}", *block(no)]
    else:
        lines = block(symbol)
    return [*language.named_constants(lines), *lines]


_MINIMAX = "The coefficients are minimax (tools/minimax.py of Motes)."
_REDUCED = "x = k ln(2) + r, with ln(2) in two parts, the first of so few bits that k times it is exact; 1.4427 = 1/ln(2); s = 2^(k - 1)."
_ABOUT = {
    "asin": f"The arc sine on [-0.7072, 0.7072], where the formulas need it, to 1 ulp. {_MINIMAX}",
    "exp": f"exp to 1.5 ulp; 0 below -87, before float32 ends. {_REDUCED} {_MINIMAX}",
    "expm1": f"exp(x) - 1 to 2.5 ulp, also where x is small. {_REDUCED} {_MINIMAX}",
}


def elementary(language: Language, op: str, prefix: str) -> str:
    """The definition of an elementary function."""
    literal = language.literal

    def let(name: str, value: str) -> str:
        return language.declaration.format(type=language.number, name=name, value=value)

    def polynomial(coefficients: tuple[float, ...], x: str) -> str:
        text = re.sub(r"F\(([^()]*)\)", lambda m: literal(float(m[1])), horner(coefficients, x))
        return text[1:-1]

    if op == "asin":
        lines = [let("z", "x * x"), let("p", polynomial(FLOAT32.asin, "z")), "return p * (z * x) + x;"]
    else:
        low, high = literal(FLOAT32.lowest), literal(FLOAT32.highest)
        clamped = language.templates["minimum"].format(language.templates["maximum"].format("x", low), high)
        lines = [
            let("y", clamped),
            let("k", f"floor(y * {literal(1.4426950408889634)} + {literal(0.5)})"),
            let("r", f"(y - k * {literal(FLOAT32.ln2[0])}) - k * {literal(FLOAT32.ln2[1])}"),
            let("s", language.power.format(k="k")),
            let("p", f"({polynomial(FLOAT32.exp, 'r')}) * (r * r) + r"),
            f"return {literal(2.0)} * (s * p + {'s' if op == 'exp' else f'(s - {literal(0.5)})'});",
        ]
    return "\n".join([*comment(_ABOUT[op]), language.function(f"{prefix}_{op}", ["x"], lines)])
