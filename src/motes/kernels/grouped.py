"""Texels that differ in a parameter, sorted by its value: what depends on it alone is then a short polynomial for each group.

A layer of dust with all orders of scattering needs four thousand operations for the numbers that depend on tau, w and g alone.  Where
tau differs from texel to texel, and each is seen in one direction, they would be needed for each.  Values of float32 that share all but their
last bits are near each other: over such a *group* the numbers are polynomials of degree 3, found in float64 and compared
with the numbers at both ends of it.  Where they are not near enough, texels are computed one by one.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.graph import tracing
from motes.graph.tracing import DIRECTIONS, PARAMETERS, Symbol, Trace, TracedParameter
from motes.kernels import loops
from motes.kernels.cheaper import without_division
from motes.kernels.transposing import PIECE

#: A group has all bits of a float32 but so many in common: 16 groups to each power of two.
LAST_BITS = 19
KEYS = 1 << (32 - LAST_BITS)
#: What a polynomial may err by at the ends of a group, of the number itself or of what it changes over a power of e.
NEAR = 5e-6
DEGREE = 3
# Nodes of the polynomials (Chebyshev's), and after them where they are judged.
NODES = np.cos(np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1))
PLACES = np.concatenate([NODES, [-1.0, 1.0]])
#: Texels are evaluated in whole vectors, and groups have to have so many of them on average.
LANES, FULL = loops.WHOLE, 64
SPLIT = 4  # parts of a group, which texels that follow each other are counted into in turn: no count waits for the one before it
_GROUP = 4  # a bit beside those of a model's leaves
_COMPARISONS = ("lt", "le", "gt", "ge")

_DRIVER = """
@kernel
def seen(values, count, keys):
    for n in range(count):
        key = (bits_of(load(F, values, n, "other", 1)) >> {bits}) & {mask}
        store(int32, keys, key, int32(1), "seen", 0, 1)


@kernel
def among(values, count, keys, found):
    total = 0
    for n in range(count):
        key = (bits_of(load(F, values, n, "other", 1)) >> {bits}) & {mask}
        store(int32, found, total, int32(n), "found", 0, 1)
        total += int64(load(int32, keys, key, "other", 1))
    return total


@kernel
@flushing
def grouped(
    wi, wi_step, wi_stride, wo, wo_step, wo_stride, constants, width, groups, group, varying, row, out, out_step, out_stride, room, first, last
):
    count = last - first
    size = count + {lanes}
    where, rank, begin = room, room + 4 * count, room + 8 * count
    end = begin + 4 * ({split} * groups + 1)
    box = (end + 4 * {split} * groups + 63) // 64 * 64
    tile = box + 4 * {width} * count
    f = tile + 4 * {width} * TILE
    wi, wo, varying, out = wi + 4 * first * wi_step, wo + 4 * first * wo_step, varying + 4 * first, out + 4 * first * out_step
    for k in range({split} * groups):
        store(int32, end, k, int32(0), "cleared", 0, 1)
    for n in range(count):
        key = (bits_of(load(F, varying, {key} * row + n, "other", 1)) >> {bits}) & {mask}
        part = {split} * int64(load(int32, group, key, "other", 1)) + n % {split}
        among = load(int32, end, part, "other", 1)
        store(int32, end, part, int32(among + 1), "counted", 0, 1)
        store(int32, where, n, int32(part), "counted", 0, 1)
        store(int32, rank, n, among, "counted", 0, 1)
    at = 0
    for k in range({split} * groups):
        store(int32, begin, k, int32(at), "begun", 0, 1)
        at += load(int32, end, k, "other", 1)
    store(int32, begin, {split} * groups, int32(count), "begun", 0, 1)
    for n in range(count):
        at = load(int32, begin, load(int32, where, n, "other", 1), "other", 1) + load(int32, rank, n, "other", 1)
        store(int32, where, n, int32(at), "placed", 0, 1)
    start = 0
    while start < count:
        some = min(TILE, count - start)
        i, i_row = columns(3, wi + 4 * start * wi_step, wi_step, wi_stride, tile, some, False)
        o, o_row = columns(3, wo + 4 * start * wo_step, wo_step, wo_stride, tile + 3 * 4 * TILE, some, False)
        v = varying + 4 * start
        boxed(some // 16 * 16, where + 4 * start, box, {brought})
        for n in range(some // 16 * 16, some):
            at = int64(load(int32, where, start + n, "other", 1))
{brought_singly}
        start += some
    for b in range(groups):
        at, past = int64(load(int32, begin, {split} * b, "other", 1)), int64(load(int32, begin, {split} * b + {split}, "other", 1))
        while at < past:
            part = min(TILE, past - at)
            turned(box + 4 * {width} * at, part, tile, TILE)
            span(
                tile, TILE, tile + 3 * 4 * TILE, TILE, constants + 4 * width * b, tile + 6 * 4 * TILE, TILE, f + 4 * at, size,
                (part + {lanes} - 1) // {lanes} * {lanes},
            )
            at += part
    for n in range(count):
        at = int64(load(int32, where, n, "other", 1))
{scattered}
"""


class Grouping(NamedTuple):
    """How texels are grouped: by a parameter, of which these numbers and their polynomials depend."""

    parameter: TracedParameter
    numbers: tuple[Symbol, ...]
    outputs: tuple[Symbol, ...]  # of the model, with polynomials in the place of the numbers
    extras: tuple[Symbol, ...]  # the middle of a group, 1 over its half width, and the coefficients of each number


@dataclass(frozen=True)
class GroupedKernel(loops.Kernel):
    """A kernel that reads, for each group, `columns` of what `Kernel.constants` and `Grouping.extras` are, one after the other.

    `key` is the row of varying parameters that texels are grouped by.  Its module also has ``seen``, which notes the groups there are, and
    ``among``, which lists the texels of some of them.
    """

    columns: tuple[int, ...] = ()
    key: int = 0


def grouping(trace: Trace, varying: Collection[str]) -> Grouping | None:
    """The parameter to group texels by, if any is worth it."""
    rows = [p for p in trace.parameters if p.slot in varying]
    outputs = without_division(trace.outputs, trace.leaves())
    best: tuple[int, TracedParameter, dict[Symbol, int]] | None = None
    for parameter in rows:
        own = {p.symbol: _GROUP if p is parameter else DIRECTIONS for p in rows}
        bits = tracing.dependence(outputs, trace.leaves() | own)
        count = sum(bool(bit & _GROUP and not bit & DIRECTIONS) for bit in bits.values())
        if count >= loops.LEAST_APART and (best is None or count > best[0]):
            best = count, parameter, bits
    if best is None:
        return None
    _, parameter, bits = best
    numbers = tuple(
        symbol
        for symbol in tracing.frontier(outputs, bits, PARAMETERS | _GROUP)
        if bits[symbol] & _GROUP and symbol is not parameter.symbol
    )
    if any(symbol.op in _COMPARISONS for symbol in numbers):
        return None
    graph = trace.graph
    extras = [graph.leaf("group.middle"), graph.leaf("group.inverse")]
    s = (parameter.symbol - extras[0]) * extras[1]
    polynomials = {}
    for k, symbol in enumerate(numbers):
        coefficients = [graph.leaf(f"group.{k}.{power}") for power in range(DEGREE + 1)]
        extras += coefficients
        total = coefficients[-1]
        for coefficient in reversed(coefficients[:-1]):
            total = coefficient + s * total
        polynomials[symbol] = total
    changed = tracing.rewritten(outputs, lambda symbol, _: polynomials.get(symbol))
    return Grouping(parameter, numbers, tuple(changed), tuple(extras))


def evaluation(trace: Trace, varying: Collection[str], scalar: str) -> GroupedKernel:
    """The kernel that sorts texels and evaluates a model group by group, for a trace that has a `grouping`."""
    found = _found(trace, varying)
    more = tuple(TracedParameter(f"group.{k}", None, leaf) for k, leaf in enumerate(found.extras))
    changed = replace(trace, outputs=found.outputs, parameters=(*trace.parameters, *more))
    kernel = loops.evaluation(changed, varying, scalar, found.extras)
    place = {leaf: k for k, leaf in enumerate(found.extras)}
    uniform = [symbol for symbol in kernel.constants if symbol not in place]
    columns = [len(uniform) + place[s] if s in place else uniform.index(s) for s in kernel.constants]
    (key,) = (k for k, p in enumerate(kernel.varying) if p.symbol is found.parameter.symbol)
    rows, channels = len(kernel.varying), len(trace.outputs)
    whole = _whole(rows)
    sources = [f"{w} + {4 * k} * {w}_row" for w in "io" for k in range(3)]
    sources += [f"v + {4 * k} * row" for k in range(rows)]
    singly = [
        f'store(F, box, {whole} * at + {k}, load(F, {s}, n, "other", 1), "boxed", 0, 1)' for k, s in enumerate(sources)
    ]
    scattered = [
        f'store(F, out, n * out_step + {k} * out_stride, load(F, f, {k} * size + at, "other", 1), "scattered", {k}, {channels})'
        for k in range(channels)
    ]
    driver = _DRIVER.format(
        key=key,
        channels=channels,
        width=whole,
        split=SPLIT,
        brought=", ".join(sources),
        brought_singly="\n".join(" " * 12 + line for line in singly),
        scattered="\n".join(" " * 8 + line for line in scattered),
        lanes=LANES,
        bits=LAST_BITS,
        mask=KEYS - 1,
    )
    given = ", ".join(["count", "at", "items", *(f"row{k}" for k in range(len(sources)))])
    boxed = f"def boxed({given}):\n    return vectors.boxed({whole // PIECE}, {given})"
    given = "address, count, room, pitch"
    turned = f"def turned({given}):\n    return vectors.turned({whole // PIECE}, {given})"
    source = loops.joined(kernel.source, boxed, turned, driver)
    return GroupedKernel(source, "grouped", tuple(uniform), kernel.varying, columns=tuple(columns), key=key)


def numbers(trace: Trace, varying: Collection[str], scalar: str) -> loops.Kernel:
    """The kernel that computes the numbers at given values of the parameter."""
    found = _found(trace, varying)
    return loops.table(replace(trace, outputs=found.numbers), (found.parameter.slot,), scalar)


def _found(trace: Trace, varying: Collection[str]) -> Grouping:
    found = grouping(trace, varying)
    if found is None:
        raise ValueError("nothing is worth grouping by")
    return found


def places(keys: NDArray[np.int64]) -> NDArray[np.float64]:
    """Where numbers are needed (groups, places); a group of nothing but 0 is a point."""
    low, high = _ends(keys)
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    found: NDArray[np.float64] = middle[:, None] + half[:, None] * PLACES
    return found


def polynomials(keys: NDArray[np.int64], values: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """The extras (groups, extras) from numbers (numbers, groups, places); and which groups are near enough."""
    low, high = _ends(keys)
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    point = half == 0
    inverse = np.where(point, 0.0, 1 / np.where(point, 1.0, half))
    powers = np.vander(PLACES, DEGREE + 1, increasing=True)
    with np.errstate(all="ignore"):
        c = values[..., : DEGREE + 1] @ np.linalg.inv(powers[: DEGREE + 1]).T
        error = np.abs(c @ powers[DEGREE + 1 :].T - values[..., DEGREE + 1 :]).max(axis=-1)
        steep = np.abs(c[..., 1] * (middle * inverse))
        near = (error <= NEAR * np.maximum(np.abs(c[..., 0]), steep)).all(axis=0)
    coefficients = c.swapaxes(0, 1).reshape(len(keys), -1)
    return np.concatenate([middle[:, None], inverse[:, None], coefficients], axis=1), near


def _ends(keys: NDArray[np.int64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The least and the largest value of each group, or the other way round; below 1.3e-38 all is 0."""
    bits = keys.astype(np.uint32) << np.uint32(LAST_BITS)
    with np.errstate(all="ignore"):
        low = bits.view(np.float32).astype(np.float64)
        high = (bits + np.uint32((1 << LAST_BITS) - 1)).view(np.float32).astype(np.float64)
        step = np.spacing(np.abs(high).astype(np.float32)).astype(np.float64)
        nothing = keys % (KEYS // 2) == 0
        return np.where(nothing, 0.0, low), np.where(nothing, 0.0, high + np.copysign(step, high))


def room(kernel: GroupedKernel, count: int, groups: int, channels: int) -> Any:
    """Scratch memory for a task of so many texels."""
    whole = _whole(len(kernel.varying))
    return np.empty(
        2 * count + 2 * SPLIT * groups + 32 + whole * (count + loops.TILE) + channels * (count + LANES), np.float32
    )


def _whole(rows: int) -> int:
    """Numbers that lie together for a texel: directions and what varies, in whole pieces."""
    return -(-(6 + rows) // PIECE) * PIECE
