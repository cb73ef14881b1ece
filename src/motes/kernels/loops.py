"""Printing a traced model as a module over directions: the kernels of `motes.kernels.engine`.

A module holds ``span`` (the formula, over a run of directions that lie one after the other in memory) and a driver that cuts a range of
directions into tiles and brings each into that form.  The values of models, densities and gradients (`motes.kernels.gradients`) are programs of vectors
(`motes.kernels.vectors`), over `WHOLE` directions or a multiple of them; samples and float64 numbers of rows are statements for one direction, with
the elementary functions that they need, which LLVM's vectoriser makes vectors of.  What depends on uniform
parameters alone is not in it: the engine computes these *constants* in float64 and hands them over.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace

from motes.graph import nan, tracing
from motes.graph.tracing import DIRECTIONS, PARAMETERS, Symbol, Trace, TracedParameter
from motes.kernels import drivers
from motes.kernels.cheaper import cheaper, without_division
from motes.kernels.programs import WORDLESS, computed, intrinsic
from motes.printing import elementary
from motes.printing.printer import ARITHMETIC, CALLED, Target, statements

# Operations on varying parameters alone from which on they are computed once for a row of directions, not at each.
LEAST_APART = 200
_VARYING = 4  # a bit beside those of a model's leaves
WHOLE = 32  # directions, which are whole vectors in any precision on any processor
TILE = 1024  # directions; their components and results fit the level-1 cache together with what is spilled

_TEMPLATES = ARITHMETIC | CALLED | {"where": "select({0}, {1}, {2})"}
ELEMENTARY = ("exp", "expm1", "log", "log1p", "asin", "asin_near", "sin", "cos")
# Minima and maxima: one instruction, which keeps a NaN of `a` and drops one of `b`; and one that keeps either (see `motes.graph.nan`).
_CAREFUL = {"minimum": "least", "maximum": "most"}
_EXTREMA = {
    "minimum": "select({a} > {b}, {b}, {a})",
    "maximum": "select({a} < {b}, {b}, {a})",
    "least": "select(({a} < {b}) | ({a} != {a}), {a}, {b})",
    "most": "select(({a} > {b}) | ({a} != {a}), {a}, {b})",
}


@dataclass(frozen=True)
class Kernel:
    """The text of a module and what its driver wants.

    Attributes
    ----------
    source
        Of the module; its driver is called `driver`.
    constants
        Symbols that depend on uniform parameters alone, to be computed beforehand; the module reads them in this order.
    varying
        Parameters with a value for every direction, a row of memory each, in this order.
    totals
        Those of the constants, for a gradient, whose derivatives the driver adds up; others have none.
    width
        How many numbers the driver computes at a place, for `numbers`.
    """

    source: str
    driver: str
    constants: tuple[Symbol, ...]
    varying: tuple[TracedParameter, ...]
    totals: tuple[Symbol, ...] = ()
    width: int = 0


def evaluation(trace: Trace, varying: Collection[str], scalar: str, held: Collection[Symbol] = ()) -> Kernel:
    """The kernel that evaluates a model, or the density of its samples.

    Parameters
    ----------
    trace
        The model.
    varying
        Slots that have a value for every direction.
    scalar
        ``"float32"`` or ``"float64"``.
    held
        Leaves that are read as they are: see `motes.kernels.cheaper`.
    """
    span, constants, rows = _program(trace, varying, scalar, held) if _spoken(trace) else _forward(trace, varying)
    driver = drivers.EVALUATE.format(channels=len(trace.outputs))
    text = module(trace, "Evaluates a reflectance model", scalar, span, driver)
    return Kernel(text, "evaluate", tuple(constants), tuple(rows))


def _spoken(trace: Trace) -> bool:
    """Whether programs of vectors have words for all of it."""
    return WORDLESS.isdisjoint(symbol.op for symbol in tracing.live(trace.outputs))


def table(trace: Trace, varying: Collection[str], scalar: str) -> Kernel:
    """The kernel that computes the outputs of a trace, any number of them, at places where parameters vary: rows in, rows out, as `evaluation`."""
    span, constants, rows = _forward(trace, varying)
    text = module(trace, "Tabulates", scalar, span, drivers.TABLE)
    return Kernel(text, "evaluate", tuple(constants), tuple(rows), width=len(trace.outputs))


def sampling(trace: Trace, varying: Collection[str], scalar: str) -> Kernel:
    """The kernel that chooses directions; its trace is that of a sample, and the rest as for `evaluation`."""
    span, constants, rows = _forward(trace, varying)
    driver = drivers.SAMPLE.format(channels=len(trace.outputs) - 4)
    text = module(trace, "Samples a reflectance model", scalar, span, driver)
    return Kernel(text, "sample", tuple(constants), tuple(rows))


def _program(
    trace: Trace, varying: Collection[str], scalar: str, held: Collection[Symbol]
) -> tuple[str, list[Symbol], list[TracedParameter]]:
    """What `_forward` gives, as a program of vectors."""
    rows, bits = inputs_of(trace, varying)
    outputs = cheaper(trace, bits, held)
    constants = tracing.frontier(outputs, tracing.dependence(outputs, bits), PARAMETERS)
    kind = "F" if scalar == "float32" else "D"
    lines, names = computed(outputs, places(trace, constants, rows, kind), special=words(outputs, inputs(bits)))
    lines += [f"put f {kind} {c}*f_row+n {names[output]}" for c, output in enumerate(outputs)]
    return program("i, i_row, o, o_row, constants, varying, row, f, f_row, count", kind, lines), constants, rows


def places(trace: Trace, constants: Sequence[Symbol], rows: Sequence[TracedParameter], kind: str) -> dict[Symbol, str]:
    """Where programs of vectors find what a formula starts from."""
    found = {symbol: f"splat constants {kind} {k}" for k, symbol in enumerate(constants)}
    for k, symbol in enumerate(trace.directions):
        found[symbol] = f"row {'io'[k // 3]} {kind} {k % 3}*{'io'[k // 3]}_row+n"
    return found | {p.symbol: f"row varying {kind} {k}*row+n" for k, p in enumerate(rows)}


def program(arguments: str, kind: str, lines: Sequence[str]) -> str:
    """The text of ``span``, which runs a program of vectors over a run of directions."""
    text = intrinsic("stretch", f'vectors.stretch(WHOLE, "{kind}", ', arguments.split(", "), lines)
    return f"{text}\n\n\ndef span({arguments}):\n    stretch({arguments})"


def _forward(trace: Trace, varying: Collection[str]) -> tuple[str, list[Symbol], list[TracedParameter]]:
    """The loop that stores the outputs of a trace in rows ``f``, the constants it wants, and the parameters that vary."""
    rows, bits = inputs_of(trace, varying)
    outputs = without_division(trace.outputs, bits)
    constants = tracing.frontier(outputs, tracing.dependence(outputs, bits), PARAMETERS)
    loads, given = _given(trace, constants, rows)
    lines, results = statements(_target(outputs, inputs(bits)), outputs, given)
    lanes = len(results)
    body = [*_loads(trace, lanes, given, rows), *lines]
    body += [f'store(F, f, {_row("f_row", c)}n, {result}, "span", {c}, {lanes})' for c, result in enumerate(results)]
    return _span("i, i_row, o, o_row, constants, varying, row, f, f_row, count", loads, body), constants, rows


def numbers(trace: Trace, varying: Collection[str], scalar: str) -> Kernel:
    """The kernel that computes, at each place where parameters vary, what `apart` takes as constant there; in rows, one for each number."""
    found = _constants(trace)
    one, zero = trace.graph.constant(1.0), trace.graph.constant(0.0)
    outputs = tuple(trace.graph.where(c, one, zero) if c.op in ("lt", "le", "gt", "ge") else c for c in found)
    return table(replace(trace, outputs=outputs), varying, scalar)


def apart(trace: Trace, varying: Collection[str], scalar: str) -> Kernel:
    """The kernel that evaluates a model at rows of directions, with parameters that are uniform over each row."""
    kernel = evaluation(trace, (), scalar)
    return Kernel(joined(kernel.source, drivers.APART), "apart", (), ())


def worth_apart(trace: Trace, varying: Collection[str]) -> bool:
    """Whether much of what a model computes depends on the parameters that vary, and not on directions."""
    leaves = trace.leaves() | {p.symbol: _VARYING for p in trace.parameters if p.slot in varying}
    bits = tracing.dependence(trace.outputs, leaves)
    return sum(bool(bit & _VARYING and not bit & DIRECTIONS) for bit in bits.values()) >= LEAST_APART


def _constants(trace: Trace) -> list[Symbol]:
    """What depends on parameters alone."""
    bits = trace.leaves()
    outputs = cheaper(trace, bits) if _spoken(trace) else without_division(trace.outputs, bits)
    return tracing.frontier(outputs, tracing.dependence(outputs, bits), PARAMETERS)


def functions(scalar: str) -> str:
    """A module with the elementary functions alone, for tests and for looking at them."""
    return joined(_header("Elementary functions", scalar), elementary.source(elementary.PRECISIONS[scalar]))


def _target(outputs: Sequence[Symbol], leaves: Collection[Symbol]) -> Target:
    """How to print `outputs`, of which `leaves` may be NaN."""
    special = {}
    for symbol, (word, args) in words(outputs, leaves).items():
        a, b = ("{0}", "{1}") if args[0] is symbol.args[0] else ("{1}", "{0}")
        special[symbol] = f"{word}({{0}})" if len(args) == 1 else _EXTREMA[word].format(a=a, b=b)
    return Target(_TEMPLATES, _constant, special=special)


def words(outputs: Sequence[Symbol], leaves: Collection[Symbol]) -> dict[Symbol, tuple[str, tuple[Symbol, ...]]]:
    """How to compute extrema and arc sines of `outputs`, of which `leaves` may be NaN: a word and its arguments."""
    found: dict[Symbol, tuple[str, tuple[Symbol, ...]]] = {}
    careful = nan.careful(outputs, leaves)
    for symbol in tracing.live(outputs):
        if symbol.op in _CAREFUL:
            a, b = symbol.args
            order = (a, b) if nan.first(symbol) is a else (b, a)
            found[symbol] = (_CAREFUL[symbol.op] if symbol in careful else symbol.op), order
        elif symbol.op == "asin" and symbol.args[0].op == "minimum":
            # directions.polar_angle: the smaller of a sine and a cosine is at most sin(pi/4).
            found[symbol] = "asin_near", symbol.args
    return found


def _constant(value: float | bool) -> str:
    return repr(value) if isinstance(value, bool) else f"F({value!r})"


def inputs_of(trace: Trace, varying: Collection[str]) -> tuple[list[TracedParameter], dict[Symbol, int]]:
    """The parameters that vary, and all leaves with their bits: what varies counts as a direction."""
    rows = [p for p in trace.parameters if p.slot in varying]
    return rows, trace.leaves() | {p.symbol: DIRECTIONS for p in rows}


def inputs(leaves: Mapping[Symbol, int]) -> list[Symbol]:
    """Those that a kernel reads for every direction."""
    return [leaf for leaf, bit in leaves.items() if bit == DIRECTIONS]


def _row(name: str, k: int) -> str:
    """The start of an index into row k of rows that are `name` items apart."""
    return "" if k == 0 else f"{name} + " if k == 1 else f"{k} * {name} + "


def _given(
    trace: Trace, constants: Sequence[Symbol], rows: Sequence[TracedParameter]
) -> tuple[list[str], dict[Symbol, str]]:
    """Statements that load the constants, and the names of everything a formula starts from."""
    axes = [f"{w}{axis}" for w in "io" for axis in "xyz"]
    given = dict(zip(trace.directions, axes, strict=False))
    given |= {symbol: f"c{k}" for k, symbol in enumerate(constants)}
    given |= {p.symbol: f"v{k}" for k, p in enumerate(rows)}
    loads = []
    for k, symbol in enumerate(constants):
        truth = " != F(0.0)" if symbol.op in ("lt", "le", "gt", "ge") else ""
        loads.append(f'c{k} = load(F, constants, {k}, "other", 1){truth}')
    return loads, given


def _loads(trace: Trace, lanes: int, given: dict[Symbol, str], rows: Sequence[TracedParameter]) -> list[str]:
    """Statements that load one direction."""
    lines = [
        f'{given[symbol]} = load(F, {"io"[k // 3]}, {_row("io"[k // 3] + "_row", k % 3)}n, "span", {lanes})'
        for k, symbol in enumerate(trace.directions)
    ]
    return lines + [f'v{k} = load(F, varying, {_row("row", k)}n, "span", {lanes})' for k in range(len(rows))]


def _span(arguments: str, before: Sequence[str], body: Sequence[str], after: Sequence[str] = ()) -> str:
    lines = [*before, "for n in range(count):", *("    " + line for line in body), *after]
    return f"def span({arguments}):\n    " + "\n    ".join(lines)


def _header(title: str, scalar: str) -> str:
    integer, item = ("int32", 4) if scalar == "float32" else ("int64", 8)
    return drivers.HEADER.format(title=title, scalar=scalar, integer=integer, item=item, whole=WHOLE, tile=TILE)


def module(trace: Trace, title: str, scalar: str, span: str, driver: str) -> str:
    needs = any(f"{name}(" in span for name in ELEMENTARY)
    title = f"{title}: generated by Motes, {len(trace.outputs)} output(s), {scalar}."
    functions = elementary.source(elementary.PRECISIONS[scalar]) if needs else ""
    return joined(_header(title, scalar), functions, drivers.COLUMNS, span, driver)


def joined(*parts: str) -> str:
    """Parts of a module with two empty lines between them."""
    return "\n\n\n".join(part.strip("\n") for part in parts if part) + "\n"
