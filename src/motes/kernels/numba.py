"""Printing a traced model as a Numba module: the kernels of `motes.kernels.engine`.

A module holds the elementary functions it needs, ``span`` (the formula, over a run of directions that lie one after the other in
memory) and a driver that cuts a range of directions into tiles and brings each into that form.  What depends on uniform
parameters alone is not in it: the engine computes these *constants* in float64 and hands them over.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace

from motes.graph import nan, tracing
from motes.graph.tracing import DIRECTIONS, PARAMETERS, Symbol, Trace, TracedParameter
from motes.printing import elementary
from motes.printing.printer import ARITHMETIC, CALLED, Target, statements

# Operations on varying parameters alone from which on they are computed once for a row of directions, not at each.
LEAST_APART = 200
_VARYING = 4  # a bit beside those of a model's leaves
TILE = 1024  # directions; their components and results fit the level-1 cache together with what is spilled

_TEMPLATES = ARITHMETIC | CALLED | {"where": "select({0}, {1}, {2})"}
ELEMENTARY = ("exp", "expm1", "log", "log1p", "asin", "asin_near", "sin", "cos")
# Minima and maxima: one instruction, which keeps a NaN of `a` and drops one of `b`; and one that keeps either (see `motes.graph.nan`).
_EXTREMA = {
    "minimum": ("select({a} > {b}, {b}, {a})", "select(({a} < {b}) | ({a} != {a}), {a}, {b})"),
    "maximum": ("select({a} < {b}, {b}, {a})", "select(({a} > {b}) | ({a} != {a}), {a}, {b})"),
}

_HEADER = '''"""{title}"""

import numba
import numpy as np
from motes.kernels.intrinsics import add_in_any_order, bits_of, float_of, load, select, sqrt, store

F, I = np.{scalar}, np.{integer}
ITEM, TILE = {item}, {tile}
# Without nnan and ninf: NaN is to stay NaN.  Without reassoc: range reduction and short sums of long terms depend on their order.
options = dict(error_model="numpy", fastmath={{"nsz", "arcp", "contract"}})
part = numba.njit(**options)

'''

_COLUMNS = '''
@part
def gather(lanes, source, step, stride, scratch, count):
    """`lanes` rows one after the other in memory, from any layout: item k of entry n is source[n * step + k * stride]."""
    if lanes == 3 and step == 3 and stride == 1:
        for n in range(count):
            store(F, scratch, n, load(F, source, 3 * n, "gather", 3), "gather", 0, 3)
            store(F, scratch, TILE + n, load(F, source, 3 * n + 1, "gather", 3), "gather", 1, 3)
            store(F, scratch, 2 * TILE + n, load(F, source, 3 * n + 2, "gather", 3), "gather", 2, 3)
    else:
        for k in range(lanes):
            for n in range(count):
                store(F, scratch, k * TILE + n, load(F, source, n * step + k * stride, "gather", 3), "gather", 0, 3)


@part
def columns(lanes, source, step, stride, room, count):
    """Where rows one after the other in memory begin, and how far apart they are: `source` itself or a copy in `room`."""
    if step == 1:
        return source, stride
    gather(lanes, source, step, stride, room, count)
    return room, TILE


@part
def scatter(lanes, scratch, target, step, stride, count):
    """The reverse of `gather`."""
    if lanes == 3 and step == 3 and stride == 1:
        for n in range(count):
            store(F, target, 3 * n, load(F, scratch, n, "scatter", 3), "scatter", 0, 3)
            store(F, target, 3 * n + 1, load(F, scratch, TILE + n, "scatter", 3), "scatter", 1, 3)
            store(F, target, 3 * n + 2, load(F, scratch, 2 * TILE + n, "scatter", 3), "scatter", 2, 3)
    else:
        for k in range(lanes):
            for n in range(count):
                store(F, target, n * step + k * stride, load(F, scratch, k * TILE + n, "scatter", 3), "scatter", 0, 3)

'''

# Addresses are integers.  Directions are an address, the step from one to the next and the stride between components, in items; rows of
# `varying` and `slopes` are `row` items apart; `room` has space for a tile of all components and channels.
_EVALUATE = """
@numba.njit("void({signature})", cache=True, nogil=True, **options)
def evaluate(wi, wi_step, wi_stride, wo, wo_step, wo_stride, constants, varying, row, out, out_step, out_stride, room, first, last):
    for start in range(first, last, TILE):
        count = min(TILE, last - start)
        i, i_row = columns(3, wi + ITEM * start * wi_step, wi_step, wi_stride, room, count)
        o, o_row = columns(3, wo + ITEM * start * wo_step, wo_step, wo_stride, room + 3 * ITEM * TILE, count)
        f, f_row = out + ITEM * start * out_step, out_stride
        if out_step != 1:
            f, f_row = room + 6 * ITEM * TILE, TILE
        span(i, i_row, o, o_row, constants, varying + ITEM * start, row, f, f_row, count)
        if out_step != 1:
            scatter({channels}, f, out + ITEM * start * out_step, out_step, out_stride, count)
"""

# Rows of `length` directions, each with values of its own for what is uniform over it: `width` constants, and where its directions begin.
_APART = """
@numba.njit("void({signature})", cache=True, nogil=True, **options)
def apart(wi_at, wi_step, wi_stride, wo_at, wo_step, wo_stride, constants, width, out, out_step, out_stride, length, room, first, last):
    for k in range(first, last):
        evaluate(
            load(np.int64, wi_at, k - first, "apart", 1), wi_step, wi_stride, load(np.int64, wo_at, k - first, "apart", 1), wo_step, wo_stride,
            constants + ITEM * width * (k - first), 0, 0, out + ITEM * k * length * out_step, out_step, out_stride, room, 0, length,
        )
"""

_GRADIENT = """
@numba.njit("void({signature})", cache=True, nogil=True, **options)
def gradient(
    wi, wi_step, wi_stride, wo, wo_step, wo_stride, constants, varying, row, seed, seed_step, seed_stride, slopes, totals,
    room, first, last,
):
    for start in range(first, last, TILE):
        count = min(TILE, last - start)
        i, i_row = columns(3, wi + ITEM * start * wi_step, wi_step, wi_stride, room, count)
        o, o_row = columns(3, wo + ITEM * start * wo_step, wo_step, wo_stride, room + 3 * ITEM * TILE, count)
        f, f_row = columns({channels}, seed + ITEM * start * seed_step, seed_step, seed_stride, room + 6 * ITEM * TILE, count)
        span(i, i_row, o, o_row, constants, varying + ITEM * start, row, f, f_row, slopes + ITEM * start, totals, count)
"""

# `u` are two random numbers; what is sampled is brought from rows into three arrays.
_SAMPLE = """
@numba.njit("void({signature})", cache=True, nogil=True, **options)
def sample(
    wi, wi_step, wi_stride, u, u_step, u_stride, constants, varying, row, wo, wo_step, wo_stride, density, weight, weight_step, weight_stride,
    room, first, last,
):
    f = room + 5 * ITEM * TILE
    for start in range(first, last, TILE):
        count = min(TILE, last - start)
        i, i_row = columns(3, wi + ITEM * start * wi_step, wi_step, wi_stride, room, count)
        o, o_row = columns(2, u + ITEM * start * u_step, u_step, u_stride, room + 3 * ITEM * TILE, count)
        span(i, i_row, o, o_row, constants, varying + ITEM * start, row, f, TILE, count)
        scatter(3, f, wo + ITEM * start * wo_step, wo_step, wo_stride, count)
        scatter(1, f + 3 * ITEM * TILE, density + ITEM * start, 1, 1, count)
        scatter({channels}, f + 4 * ITEM * TILE, weight + ITEM * start * weight_step, weight_step, weight_stride, count)
"""


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


def evaluation(trace: Trace, varying: Collection[str], scalar: str) -> Kernel:
    """The kernel that evaluates a model, or the density of its samples.

    Parameters
    ----------
    trace
        The model.
    varying
        Slots that have a value for every direction.
    scalar
        ``"float32"`` or ``"float64"``.
    """
    span, constants, rows = _forward(trace, varying)
    driver = _EVALUATE.format(signature=signature(15), channels=len(trace.outputs))
    return Kernel(
        _module(trace, "Evaluates a reflectance model", scalar, span, driver), "evaluate", tuple(constants), tuple(rows)
    )


def sampling(trace: Trace, varying: Collection[str], scalar: str) -> Kernel:
    """The kernel that chooses directions; its trace is that of a sample, and the rest as for `evaluation`."""
    span, constants, rows = _forward(trace, varying)
    driver = _SAMPLE.format(signature=signature(19), channels=len(trace.outputs) - 4)
    text = _module(trace, "Samples a reflectance model", scalar, span, driver)
    return Kernel(text, "sample", tuple(constants), tuple(rows))


def _forward(trace: Trace, varying: Collection[str]) -> tuple[str, list[Symbol], list[TracedParameter]]:
    """The loop that stores the outputs of a trace in rows ``f``, the constants it wants, and the parameters that vary."""
    rows, leaves = _leaves(trace, varying)
    outputs = without_division(trace.outputs, leaves)
    constants = tracing.frontier(outputs, tracing.dependence(outputs, leaves), PARAMETERS)
    loads, given = _given(trace, constants, rows)
    lines, results = statements(_target(outputs, _inputs(leaves)), outputs, given)
    lanes = len(results)
    body = [*_loads(trace, lanes, given, rows), *lines]
    body += [f'store(F, f, {_row("f_row", c)}n, {result}, "span", {c}, {lanes})' for c, result in enumerate(results)]
    return _span("i, i_row, o, o_row, constants, varying, row, f, f_row, count", loads, body), constants, rows


def numbers(trace: Trace, varying: Collection[str], scalar: str) -> Kernel:
    """The kernel that computes, at each place where parameters vary, what `apart` takes as constant there; in rows, one for each number."""
    found = _constants(trace)
    one, zero = trace.graph.constant(1.0), trace.graph.constant(0.0)
    outputs = tuple(trace.graph.where(c, one, zero) if c.op in ("lt", "le", "gt", "ge") else c for c in found)
    return replace(evaluation(replace(trace, outputs=outputs), varying, scalar), width=len(outputs))


def apart(trace: Trace, varying: Collection[str], scalar: str) -> Kernel:
    """The kernel that evaluates a model at rows of directions, with parameters that are uniform over each row."""
    kernel = evaluation(trace, (), scalar)
    return Kernel(joined(kernel.source, _APART.format(signature=signature(15))), "apart", (), ())


def worth_apart(trace: Trace, varying: Collection[str]) -> bool:
    """Whether much of what a model computes depends on the parameters that vary, and not on directions."""
    leaves = trace.leaves() | {p.symbol: _VARYING for p in trace.parameters if p.slot in varying}
    bits = tracing.dependence(trace.outputs, leaves)
    return sum(bool(bit & _VARYING and not bit & DIRECTIONS) for bit in bits.values()) >= LEAST_APART


def _constants(trace: Trace) -> list[Symbol]:
    """What depends on parameters alone."""
    leaves = trace.leaves()
    outputs = without_division(trace.outputs, leaves)
    return tracing.frontier(outputs, tracing.dependence(outputs, leaves), PARAMETERS)


def gradient(trace: Trace, varying: Collection[str], scalar: str) -> Kernel:
    """The kernel of the adjoint: sum over directions and channels of seed times value, differentiated.

    Derivatives by the constants are added up in `scalar` over a tile and in float64 over tiles; derivatives by varying parameters are
    stored for every direction.
    """
    graph = trace.graph
    rows, leaves = _leaves(trace, varying)
    outputs = without_division(trace.outputs, leaves)
    seeds: dict[Symbol, Symbol] = {}
    seed_leaves = [graph.leaf(f"seed[{c}]") for c in range(len(outputs))]
    for output, seed in zip(outputs, seed_leaves, strict=True):  # channels of equal value are one symbol
        seeds[output] = seeds[output] + seed if output in seeds else seed
    constants = tracing.frontier(outputs, tracing.dependence(outputs, leaves), PARAMETERS)
    slopes = tracing.adjoint(seeds, [*constants, *(p.symbol for p in rows)])
    totals = [symbol for symbol in constants if symbol in slopes]
    wanted = [*(slopes[symbol] for symbol in totals), *(slopes.get(p.symbol, graph.constant(0.0)) for p in rows)]

    leaves |= dict.fromkeys(seed_leaves, DIRECTIONS)
    constants = tracing.frontier(wanted, tracing.dependence(wanted, leaves), PARAMETERS)
    loads, given = _given(trace, constants, rows)
    given |= {leaf: f"seed{c}" for c, leaf in enumerate(seed_leaves)}
    lines, results = statements(_target(wanted, _inputs(leaves)), wanted, given)
    lanes = max(1, len(rows))
    body = [*_loads(trace, lanes, given, rows)]
    body += [f'seed{c} = load(F, f, {_row("f_row", c)}n, "span", {lanes})' for c in range(len(seed_leaves))]
    body += lines
    body += [f"s{k} = add_in_any_order(s{k}, {result})" for k, result in enumerate(results[: len(totals)])]
    body += [
        f'store(F, slopes, {_row("row", v)}n, {result}, "span", {v}, {lanes})'
        for v, result in enumerate(results[len(totals) :])
    ]
    before = [*loads, *(f"s{k} = F(0.0)" for k in range(len(totals)))]
    after = [
        f'store(np.float64, totals, {k}, load(np.float64, totals, {k}, "other", 1) + s{k}, "totals", 0, 1)'
        for k in range(len(totals))
    ]
    span = _span("i, i_row, o, o_row, constants, varying, row, f, f_row, slopes, totals, count", before, body, after)
    driver = _GRADIENT.format(signature=signature(17), channels=len(seed_leaves))
    text = _module(trace, "Derivatives of a reflectance model", scalar, span, driver)
    return Kernel(text, "gradient", tuple(constants), tuple(rows), tuple(totals))


def functions(scalar: str) -> str:
    """A module with the elementary functions alone, for tests and for looking at them."""
    return joined(_header("Elementary functions", scalar), elementary.source(elementary.PRECISIONS[scalar]))


def _target(outputs: Sequence[Symbol], leaves: Collection[Symbol]) -> Target:
    """How to print `outputs`, of which `leaves` may be NaN."""
    special = {}
    careful = nan.careful(outputs, leaves)
    for symbol in tracing.live(outputs):
        if symbol.op in _EXTREMA:
            order = {"a": "{0}", "b": "{1}"} if nan.first(symbol) is symbol.args[0] else {"a": "{1}", "b": "{0}"}
            special[symbol] = _EXTREMA[symbol.op][symbol in careful].format(**order)
        elif symbol.op == "asin" and symbol.args[0].op == "minimum":
            # directions.polar_angle: the smaller of a sine and a cosine is at most sin(pi/4).
            special[symbol] = "asin_near({0})"
    return Target(_TEMPLATES, _constant, special=special)


def _constant(value: float | bool) -> str:
    return repr(value) if isinstance(value, bool) else f"F({value!r})"


def without_division(outputs: Sequence[Symbol], leaves: Mapping[Symbol, int]) -> list[Symbol]:
    """Division by what is constant becomes multiplication by its inverse, one more constant: one rounding more, and much faster."""
    bits = tracing.dependence(outputs, leaves)

    def rule(symbol: Symbol, args: tuple[Symbol, ...]) -> Symbol | None:
        if symbol.op != "div" or bits[symbol.args[1]] != PARAMETERS or not bits[symbol] & DIRECTIONS:
            return None
        return args[0] * (1.0 / args[1])

    return tracing.rewritten(outputs, rule)


def _leaves(trace: Trace, varying: Collection[str]) -> tuple[list[TracedParameter], dict[Symbol, int]]:
    """The parameters that vary, and all leaves with their bits: what varies counts as a direction."""
    rows = [p for p in trace.parameters if p.slot in varying]
    return rows, trace.leaves() | {p.symbol: DIRECTIONS for p in rows}


def _inputs(leaves: Mapping[Symbol, int]) -> list[Symbol]:
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
    return f"@part\ndef span({arguments}):\n    " + "\n    ".join(lines)


def signature(count: int) -> str:
    return ", ".join(["int64"] * count)


def _header(title: str, scalar: str) -> str:
    integer, item = ("int32", 4) if scalar == "float32" else ("int64", 8)
    return _HEADER.format(title=title, scalar=scalar, integer=integer, item=item, tile=TILE)


def _module(trace: Trace, title: str, scalar: str, span: str, driver: str) -> str:
    needs = any(f"{name}(" in span for name in ELEMENTARY)
    title = f"{title}: generated by Motes, {len(trace.outputs)} output(s), {scalar}."
    functions = elementary.source(elementary.PRECISIONS[scalar]) if needs else ""
    return joined(_header(title, scalar), functions, _COLUMNS, span, driver)


def joined(*parts: str) -> str:
    """Parts of a module with two empty lines between them."""
    return "\n\n\n".join(part.strip("\n") for part in parts if part) + "\n"
