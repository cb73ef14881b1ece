"""Sums over a texel's samples, as functions of rows: float32 over short runs, float64 beyond."""

from __future__ import annotations

from collections.abc import Sequence

from motes.fitting.printed.rows import LANES, Rows
from motes.graph.dependence import live
from motes.graph.tracing import Symbol
from motes.kernels.programs import computed, intrinsic

UNROLL = 4  # samples whose terms are added before they go to memory; few where a formula is long
LONG = 150
RUN = 128  # samples that are summed in float32
GROUP = 24  # sums that a processor's registers hold: those of short terms are made in groups


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
) -> str:
    """A function that adds the sums of `integrands` over a time's samples to the rows of ``totals``.

    Parameters
    ----------
    data
        Leaves: what the rows of a sample hold, one after the other.
    columns, constants
        What depends on directions alone, the same in all lanes; what depends on a lane's parameters alone.
    """
    stop = {*columns.where, *constants.where, *data}
    unroll = unroll or (UNROLL if len(live(integrands, stop)) < LONG else 1)
    shared, known = computed(
        [symbol for symbol in live(integrands, stop) if symbol in constants.where],
        {symbol: f"row constants F {k * LANES}" for symbol, k in constants.where.items()},
        suffix="_c",
    )
    lines = ["zero = const 0.0", *shared]
    copies: list[dict[Symbol, str]] = []
    for copy in range(unroll):
        places = {symbol: f"splat columns F {k}*row+sample+{copy}" for symbol, k in columns.where.items()}
        for k, symbol in enumerate(data):
            places[symbol] = f"row data F sample*{len(data) * LANES}+{(copy * len(data) + k) * LANES}"
        own, names = computed(integrands, places, known, f"_{copy}")
        lines += own
        copies.append(names)
    for k, symbol in enumerate(integrands):
        terms = [names[symbol] for names in copies]
        while len(terms) > 1:
            lines.append(f"s{k}_{len(terms)} = add {terms[0]} {terms[1]}")
            terms = [f"s{k}_{len(terms)}", *terms[2:]]
        lines.append(f"sum{k} = add {terms[0]} zero")
    call = f"vectors.sums(LANES, RUN, {len(integrands)}, {unroll}, "
    return intrinsic(name, call, ["columns", "row", "constants", "data", "samples", "totals"], lines)
