"""What the shading languages share: typed statements with the names of the source.

`body` prints a recorded model as the inside of a function, `define` as a whole one.  Parameters that have a value for each channel are
either colours, in languages that compute with three numbers at once, or entries of arrays, with a loop over the channels.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace

from motes.graph import tracing
from motes.graph.tracing import Symbol
from motes.printing.auxiliary import elementary, outlined
from motes.printing.language import CONSTANTS, Language, comment, indented
from motes.printing.names import Name, Recording
from motes.printing.printer import INFIX, LEVELS, Target, steps

_WORDS = """auto break case char const continue default do double else enum extern float for goto if int long register return short signed sizeof
static struct switch typedef union unsigned void volatile while true false bool half wi wo f c p"""
_RESERVED = frozenset(_WORDS.split())


@dataclass(frozen=True)
class Body:
    """The inside of a function that evaluates a model.

    Attributes
    ----------
    constants
        Declarations of the named numbers that the statements use.
    shared
        Statements for all channels together.
    each
        Those for colours, or for one channel.
    result
        The value; a colour where `colored`.
    functions
        Definitions that must come before.
    before
        Statements for what is held in variables that others declare, by stage; the ones above use these.
    """

    constants: list[str]
    shared: list[str]
    each: list[str]
    result: str
    colored: bool
    functions: list[str] = field(default_factory=list)
    before: list[list[str]] = field(default_factory=list)


def body(
    recording: Recording,
    language: Language,
    *,
    prefix: str,
    given: Mapping[Symbol, str],
    split: Collection[str],
    vectors: bool = True,
    first: Callable[[Symbol], Symbol] | None = None,
    held: Sequence[Mapping[Symbol, str]] = (),
) -> Body:
    """Print a recorded model.

    Parameters
    ----------
    recording
        From `motes.printing.names.record`.
    prefix
        Of the functions that are defined on the way.
    given
        The texts of the leaves.
    split
        Slots with a value for each channel.
    vectors
        True where such parameters are colours, False where they are numbers in a loop over the channels.
    first
        Which operand of a minimum or maximum is written first, where functions ``prefix_min`` and ``prefix_max`` stand for these.
    held
        By stage, symbols and the variables, declared elsewhere, that hold them: what they need is computed in `Body.before`.
    """
    variables = {symbol: name for stage in held for symbol, name in stage.items()}
    trace = recording.trace
    outputs = trace.outputs
    many = {p.symbol for p in trace.parameters if p.slot in split}
    colored = {s for s, bit in tracing.dependence(outputs, dict.fromkeys(many, 1)).items() if bit}
    taken = {*_RESERVED, *language.reserved, *given.values(), *(name for name, _ in CONSTANTS.values())}
    taken |= {re.split(r"\W", text)[0] for text in given.values()}
    if first is not None:
        language = replace(language, templates={**language.templates, **_extrema(prefix)})
    target = _target(language, outputs, colored if vectors else frozenset(), prefix)
    calls, functions = outlined(recording, language, target, prefix, given, colored)
    names = _names(recording, taken, dict(given) | calls) | variables
    if first is not None:
        swapped = {s for s in tracing.live(outputs) if s.op in _EXTREMA and first(s) is not s.args[0]}
        target = replace(target, inline={s: _extrema(prefix, "{1}, {0}")[s.op] for s in swapped})
    called = {symbol: variables[symbol] for symbol in calls if symbol in variables}
    done, (result,) = steps(target, outputs, dict(given) | calls | called, names)
    # For each stage, and last the rest: statements of numbers, and of colours.
    blocks: list[tuple[list[str], list[str]]] = [([], []) for _ in range(len(held) + 1)]
    stage_of = {s: k for k, stage in reversed([*enumerate(held)]) for s in tracing.live(stage)}
    for symbol, name in called.items():
        blocks[stage_of[symbol]][0].append(f"{name} = {calls[symbol]};")
    for step in done:
        numbers, colors = blocks[stage_of.get(step.symbol, -1)]
        block = colors if step.symbol in colored else numbers
        block += _commented(recording.names.get(step.symbol), first=not numbers and not colors)
        if step.symbol in variables:
            block.append(f"{step.name} = {step.value};")
        else:
            block.append(
                language.declare(language.type(step.symbol, colored if vectors else ()), step.name, step.value)
            )
    before = [[*numbers, *colors] for numbers, colors in blocks[:-1]]
    lines = dict(zip((False, True), blocks[-1], strict=True))
    code = [*lines[False], *lines[True], result]
    written = "\n".join([*(line for stage in before for line in stage), *code, *functions])
    own = [op for op in language.own if f"{prefix}_{op}(" in written]
    functions = [*(elementary(language, op, prefix) for op in own), *functions]
    constants = language.named_constants(code)
    return Body(constants, lines[False], lines[True], result, outputs[0] in colored, functions, before)


def components(recording: Recording, language: Language) -> dict[Symbol, str]:
    """The texts of the components of ``wi`` and ``wo``."""
    texts = [part.format(w) for w in ("wi", "wo") for part in language.components]
    return dict(zip(recording.trace.directions, texts, strict=True))


def define(
    recording: Recording, language: Language, *, name: str, prefix: str, split: Collection[str], channels: int
) -> list[str]:
    """Lines that define the helpers and the function `name`, whose arguments are ``wi, wo`` and the parameters.

    With one channel or three it returns a colour; with others it fills an array ``f``.
    """
    parameters = recording.trace.parameters
    arrays = channels not in (1, 3)
    words = {
        "number": language.number,
        "color": language.color,
        "direction": language.direction,
        "count": str(channels),
        "name": name,
    }
    given = components(recording, language)
    arguments = [language.argument.format(type=language.direction, name=w) for w in ("wi", "wo")]
    first = [language.array_first.format(**words)] if arrays and language.array_first else []
    for parameter in parameters:
        many = parameter.slot in split
        slot = words | {"name": parameter.slot}
        given[parameter.symbol] = parameter.slot
        if not (many and arrays):
            type_ = language.color if many else language.number
            arguments.append(language.argument.format(type=type_, name=parameter.slot))
            continue
        arguments.append(language.array_argument.format(**slot))
        given[parameter.symbol] = f"{parameter.slot}[c]"
        if language.array_copy:
            given[parameter.symbol] = f"{parameter.slot}_all[c]"
            first.append(language.array_copy.format(**slot))
    printed = body(recording, language, prefix=prefix, given=given, split=split, vectors=not arrays)
    words["arguments"] = ", ".join(arguments)
    if arrays:
        head = language.array_header.format(**words)
        loop = [*printed.each, f"f[c] = {printed.result};"]
        inside = [*first, *printed.shared, language.loop.format(**words) + " {", *indented(loop), "}"]
        inside += [language.array_last] if language.array_last else []
    else:
        head = language.color_header.format(**words)
        result = printed.result if printed.colored else language.splat.format(printed.result)
        inside = [*printed.shared, *printed.each, f"return {result};"]
    lines = [line for function in printed.functions for line in [*function.split("\n"), ""]]
    return [*lines, f"{language.qualifier}{head} {{", *indented([*printed.constants, *inside]), "}"]


@dataclass(frozen=True)
class Stages:
    """A function in three: of the parameters, of the viewer, of the light; each keeps in variables what the next ones need.

    Attributes
    ----------
    lines
        The program: ``name_parameters(...)``, ``name_view(wo, ...)``, ``name_light(wi, wo, ...)``, and ``name_with(wi, wo, ...)``, which calls them all.
    kept
        The variables of the first stage, and their types.
    work
        How many operations the first stage takes.
    symbols
        What the variables of the first stage stand for, in their order.
    parameters
        The leaves of these.
    """

    lines: list[str]
    kept: dict[str, str]
    work: int
    symbols: list[Symbol]
    parameters: tuple[tracing.TracedParameter, ...]


_LIGHT, _VIEW, _PARAMETERS = 1, 2, 4


def define_in_stages(
    recording: Recording, language: Language, *, name: str, prefix: str, split: Collection[str]
) -> Stages:
    """As `define`, of one channel or three, for programs that ask for many ``wi`` with one ``wo``, and for many ``wo`` with the same parameters."""
    trace = recording.trace
    parameters = {p.symbol: p.slot for p in trace.parameters}
    bits = dict.fromkeys(trace.directions[:3], _LIGHT) | dict.fromkeys(trace.directions[3:], _VIEW)
    bits = tracing.dependence(trace.outputs, bits | dict.fromkeys(parameters, _PARAMETERS))
    many = dict.fromkeys((symbol for symbol, slot in parameters.items() if slot in split), 1)
    colored = {s for s, bit in tracing.dependence(trace.outputs, many).items() if bit}
    frontiers = [tracing.frontier(trace.outputs, bits, inside) for inside in (_PARAMETERS, _PARAMETERS | _VIEW)]
    first = [s for s in frontiers[0] if s.op != "leaf"]
    second = [s for s in frontiers[1] if s.op != "leaf" and bits[s] != _PARAMETERS]
    held = [
        {symbol: f"{prefix}_{word}{k}" for k, symbol in enumerate(stage)}
        for word, stage in (("kept", first), ("seen", second))
    ]
    types = {name: language.type(symbol, colored) for stage in held for symbol, name in stage.items()}
    given = components(recording, language) | parameters
    printed = body(recording, language, prefix=prefix, given=given, split=split, held=held)
    result = printed.result if printed.colored else language.splat.format(printed.result)
    wi, wo = (language.argument.format(type=language.direction, name=w) for w in ("wi", "wo"))
    rest = [
        language.argument.format(type=language.color if slot in split else language.number, name=slot)
        for slot in parameters.values()
    ]
    slots = [*parameters.values()]

    def function(head: str, arguments: list[str], inside: list[str]) -> list[str]:
        return [f"{head}({', '.join(arguments)}) {{", *indented(inside), "}", ""]

    before = [[*language.named_constants(stage), *stage] for stage in printed.before]
    lines = [f"{type_} {variable};" for variable, type_ in types.items()] + [""]
    lines += [line for each in printed.functions for line in [*each.split("\n"), ""]]
    lines += function(f"void {name}_parameters", rest, before[0])
    lines += function(f"void {name}_view", [wo, *rest], before[1])
    lines += function(
        f"{language.color} {name}_light",
        [wi, wo, *rest],
        [*printed.constants, *printed.shared, *printed.each, f"return {result};"],
    )
    lines += function(
        f"{language.color} {name}_with",
        [wi, wo, *rest],
        [
            f"{name}_parameters({', '.join(slots)});",
            f"{name}_view({', '.join(['wo', *slots])});",
            f"return {name}_light({', '.join(['wi', 'wo', *slots])});",
        ],
    )
    work = sum(bit == _PARAMETERS and symbol.op != "leaf" for symbol, bit in bits.items())
    return Stages(
        lines[:-1], {variable: types[variable] for variable in held[0].values()}, work, first, trace.parameters
    )


_EXTREMA = {"minimum": "min", "maximum": "max"}


def _extrema(prefix: str, order: str = "{0}, {1}") -> dict[str, str]:
    return {op: f"{prefix}_{short}({order})" for op, short in _EXTREMA.items()}


def _commented(name: Name | None, first: bool) -> list[str]:
    """The comment above a statement, after an empty line."""
    if name is None or not (name.comment or name.formula):
        return []
    lines = [line for paragraph in name.comment for line in comment(paragraph)]
    if name.equation and name.formula:
        lines += comment(f"{name.text} = {name.formula}", indent="  ")
    return lines if first else ["", *lines]


def _target(language: Language, outputs: Sequence[Symbol], colored: Collection[Symbol], prefix: str) -> Target:
    """The printer's table, with templates for the operations that mix numbers and colours."""
    templates = {**INFIX, **language.templates, **{op: f"{prefix}_{op}({{0}})" for op in language.own}}
    inline: dict[Symbol, str] = {}
    special: dict[Symbol, str] = {}
    for symbol in tracing.live(outputs):
        if symbol not in colored:
            continue
        if symbol.op in ("minimum", "maximum", "where"):
            parts = [
                f"{{{k}}}" if a in colored or (symbol.op == "where" and k == 0) else language.splat.format(f"{{{k}}}")
                for k, a in enumerate(symbol.args)
            ]
            inline[symbol] = templates[symbol.op].format(*parts)
        elif symbol.op in language.own:
            parts = [f"{prefix}_{symbol.op}({part})" for part in language.components]
            special[symbol] = f"{language.color}({', '.join(parts)})"
    return Target(templates, language.text, special=special, inline=inline, levels=LEVELS)


def _names(recording: Recording, taken: Collection[str], given: Mapping[Symbol, str]) -> dict[Symbol, str]:
    """A name of its own for every symbol that the source names; a second ``D`` is ``D_2``."""
    used = set(taken)
    names: dict[Symbol, str] = {}
    for symbol in tracing.live(recording.trace.outputs):
        name = recording.names.get(symbol)
        if name is None or symbol in given:
            continue
        text, count = name.text, 1
        while text in used or re.fullmatch(r"t\d+", text):  # the printer has t0, t1, ...
            count += 1
            text = f"{name.text}_{count}"
        used.add(text)
        names[symbol] = text
    return names
