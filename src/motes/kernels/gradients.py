"""Printing the adjoint of a traced model as a module over directions, a program of vectors: see `motes.kernels.loops`.

Derivatives by the constants are sums over directions.  Each has a row of lanes, to which every step adds its products, one instruction for a
product and its addition; after a tile these rows go into rows of float64.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence

from motes.graph import tracing
from motes.graph.tracing import DIRECTIONS, PARAMETERS, Symbol, Trace
from motes.kernels import drivers, loops
from motes.kernels.cheaper import cheaper
from motes.kernels.programs import computed

#: Lanes of a row of sums: as many as a vector has at most.
LANES = loops.WHOLE // 2


def gradient(trace: Trace, varying: Collection[str], scalar: str) -> loops.Kernel:
    """The kernel of the adjoint: sum over directions and channels of seed times value, differentiated.

    Derivatives by the constants are added up in `scalar` over a tile and in float64 over tiles; derivatives by varying parameters are
    stored for every direction.
    """
    graph = trace.graph
    rows, leaves = loops.inputs_of(trace, varying)
    outputs = cheaper(trace, leaves)
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
    kind = "F" if scalar == "float32" else "D"
    places = loops.places(trace, constants, rows, kind)
    places |= {leaf: f"row f {kind} {c}*f_row+n" for c, leaf in enumerate(seed_leaves)}
    lines = _lines(wanted, len(totals), places, kind, loops.words(wanted, loops.inputs(leaves)))
    arguments = "i, i_row, o, o_row, constants, varying, row, f, f_row, slopes, slopes_row, sums, count"
    span = loops.program(arguments, kind, lines)
    driver = drivers.GRADIENT.format(channels=len(seed_leaves), rows=len(rows), totals=len(totals), lanes=LANES)
    text = loops.module(trace, "Derivatives of a reflectance model", scalar, span, driver)
    return loops.Kernel(text, "gradient", tuple(constants), tuple(rows), tuple(totals))


def room(kernel: loops.Kernel) -> int:
    """Items of scratch memory that the driver wants besides those for a tile's components and channels."""
    return 3 * LANES * len(kernel.totals) + 2 * loops.TILE * len(kernel.varying)


def _lines(
    wanted: Sequence[Symbol],
    totals: int,
    places: Mapping[Symbol, str],
    kind: str,
    special: Mapping[Symbol, tuple[str, Sequence[Symbol]]],
) -> list[str]:
    """The program: each sum where the last of its terms is known, with the products that nothing else needs."""
    order = tracing.live(wanted)
    uses = Counter(a for symbol in order for a in symbol.args)
    uses.update(wanted)
    terms = [_terms(symbol, uses, special) for symbol in wanted[:totals]]
    needed = {factor for found in terms for _, factors in found for factor in factors}
    lines, names = computed([*needed, *wanted[totals:]], places, special=special)
    for k, found in enumerate(terms):
        texts = ["-" * minus + "*".join(names[factor] for factor in factors) for minus, factors in found]
        lines.append(f"sum sums {kind} {LANES * k} {' '.join(texts)}")
    stores = [f"put slopes {kind} {v}*slopes_row+n {names[symbol]}" for v, symbol in enumerate(wanted[totals:])]
    return [*_soon(lines), *stores]


def _terms(
    symbol: Symbol, uses: Mapping[Symbol, int], special: Collection[Symbol], minus: bool = False
) -> list[tuple[bool, tuple[Symbol, ...]]]:
    """What adds up to `symbol`: products of one or two, with their signs; what is used elsewhere stays whole."""
    if uses[symbol] == 1 and symbol not in special:
        if symbol.op in ("add", "sub"):
            a, b = symbol.args
            return _terms(a, uses, special, minus) + _terms(b, uses, special, minus != (symbol.op == "sub"))
        if symbol.op == "neg":
            return _terms(symbol.args[0], uses, special, not minus)
        if symbol.op == "mul":
            return [(minus, symbol.args)]
    return [(minus, (symbol,))]


def _soon(lines: Sequence[str]) -> list[str]:
    """The lines with each sum moved to where the last name in it is known."""
    at = {line.split()[0]: k for k, line in enumerate(lines) if " = " in line}
    keys = []
    for k, line in enumerate(lines):
        if line.startswith("sum "):
            names = (name for term in line.split()[4:] for name in term.lstrip("-").split("*"))
            keys.append((max(at[name] for name in names), 1, k))
        else:
            keys.append((k, 0, k))
    return [lines[k] for _, _, k in sorted(keys)]
