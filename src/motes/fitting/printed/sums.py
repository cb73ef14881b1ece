"""Sums over a texel's samples, as functions of rows: float32 over short runs, float64 beyond."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from motes.fitting.printed.rows import LANES, Rows
from motes.graph.dependence import live
from motes.graph.tracing import Symbol
from motes.kernels.programs import computed, intrinsic

UNROLL = 4  # samples whose terms are added before they go to memory; few where a formula is long
LONG = 150
RUN = 128  # samples that are summed in float32
GROUP = 24  # sums that a processor's registers hold: those of short terms are made in groups
#: Functions that take many operations, and numbers of their own: those of several samples are computed one after the other.
COSTLY = frozenset({"exp", "expm1", "log1p", "cbrt", "asin", "asin_near"})


def many_sums(name: str, data: Sequence[Symbol], integrands: Sequence[Symbol], columns: Rows, constants: Rows) -> str:
    """As `sum_function`, for many sums of short terms."""
    texts, calls = [], []
    for first in range(0, len(integrands), GROUP):
        part = f"{name}_{first}"
        texts.append(sum_function(part, data, integrands[first : first + GROUP], columns, constants, unroll=1))
        calls.append(f"    {part}(columns, row, constants, data, samples, totals + 8 * LANES * {first})")
    body = "\n".join(calls)
    return "\n\n\n".join([*texts, f"def {name}(columns, row, constants, data, samples, totals):\n{body}"])


def sum_function(
    name: str,
    data: Sequence[Symbol],
    integrands: Sequence[Symbol],
    columns: Rows,
    constants: Rows,
    unroll: int | None = None,
    stages: Sequence[Sequence[Symbol]] = (),
) -> str:
    """A function that adds the sums of `integrands` over a time's samples to the rows of ``totals``.

    Parameters
    ----------
    data
        Leaves: what the rows of a sample hold, one after the other.
    columns, constants
        What depends on directions alone, the same in all lanes; what depends on a lane's parameters alone.
    stages
        What long terms are made of: a stage is worked out for several samples before the next, as its functions (`COSTLY`) are before it.
    """
    stop = {*columns.where, *constants.where, *data}
    wanted = live(integrands, stop)
    long = len(wanted) >= LONG
    unroll = unroll or (1 if long else UNROLL)
    shared, known = computed(
        [symbol for symbol in wanted if symbol in constants.where],
        {symbol: f"row constants F {k * LANES}" for symbol, k in constants.where.items()},
        suffix="_c",
    )
    lines = ["zero = const 0.0", *shared]
    copies: list[dict[Symbol, str]] = []
    for copy in range(unroll):
        places = {symbol: f"splat columns F {k}*row+sample+{copy}" for symbol, k in columns.where.items()}
        for k, symbol in enumerate(data):
            places[symbol] = f"row data F sample*{len(data) * LANES}+{(copy * len(data) + k) * LANES}"
        if long and stages:
            lines += _in_stages(integrands, stages, wanted, places, known)
            break
        own, names = computed(integrands, places, known, f"_{copy}")
        lines += own
        copies.append(names)
    for k, symbol in enumerate(integrands if copies else ()):
        terms = [names[symbol] for names in copies]
        while len(terms) > 1:
            lines.append(f"s{k}_{len(terms)} = add {terms[0]} {terms[1]}")
            terms = [f"s{k}_{len(terms)}", *terms[2:]]
        lines.append(f"sum{k} = add {terms[0]} zero")
    call = f"vectors.sums(LANES, RUN, {len(integrands)}, {unroll}, "
    return intrinsic(name, call, ["columns", "row", "constants", "data", "samples", "totals"], lines)


def _in_stages(
    integrands: Sequence[Symbol],
    stages: Sequence[Sequence[Symbol]],
    wanted: Sequence[Symbol],
    places: Mapping[Symbol, str],
    known: Mapping[Symbol, str],
) -> list[str]:
    """The lines for one sample with a ``cut`` after each stage; terms are summed as soon as they can be, those made of the last stage in parts of their own."""
    given = {*places, *known}
    functions = [symbol for symbol in wanted if symbol.op in COSTLY and symbol not in given]
    order = {symbol: k for k, stage in enumerate(stages) for symbol in stage if symbol.op != "constant"}
    parts: list[list[Symbol]] = [functions, *map(list, stages)]
    terms: list[list[int]] = [[] for _ in parts]
    last = list[int]()
    for k, integrand in enumerate(integrands):
        stage = max((order[symbol] for symbol in live([integrand], given) if symbol in order), default=0)
        (last if stage == len(stages) - 1 else terms[1 + stage]).append(k)
    for first in range(0, len(last), GROUP):
        parts.append([])
        terms.append(last[first : first + GROUP])
    lines, names = list[str](), dict(known)
    for number, (part, some) in enumerate(zip(parts, terms, strict=True)):
        own, names = computed([*part, *(integrands[k] for k in some)], places, names, f"_{number}")
        lines += [*own, *(f"sum{k} = add {names[integrands[k]]} zero" for k in some), "cut"]
    return lines[:-1]
