"""Straight-line programs over rows of lanes, as vector instructions: what the kernels of `motes.fitting.printed` are made of.

A program is text, one instruction a line, in the order of evaluation::

    a0 = row state D 3            LANES numbers (float64) at row 3 of the memory that starts at address `state`
    a1 = splat box D 2            the number at item 2, for all lanes
    t0 = mul a0 a1
    t1 = lt t0 a0
    t2 = where t1 t0 a1
    put state D 4 t2              stores; `add` instead of `put` adds to what is there

Numba would need a second to type every few dozen such lines, and then LLVM to find out that they can be vectors.  Here a
program becomes LLVM's vector instructions directly, inside a Numba intrinsic; Numba keeps what is made of it in its cache.
Imported by generated modules only (it imports Numba).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from llvmlite import ir
from numba.core import cgutils, types

from motes.kernels.vector_functions import DOUBLE, FLAGS, FLOAT, SCALARS, Lanes

_WORD = ir.IntType(64)
TOGETHER = 8  # lanes for which a program over rows is run at a time: a vector of AVX-512 in float64
LINE = 64  # bytes of a cache line
PIECE = 8  # numbers that `transposed` reads at once from a lane's memory
Intrinsic = tuple[Any, Callable[..., Any]]


def rows(lanes: int, scalar: str, program: str, *arguments: Any) -> Intrinsic:
    """Signature and code of an intrinsic that runs `program` once; its arguments are the addresses that the program names, in its first line.

    It runs for `TOGETHER` lanes after the others, whose numbers are in the processor's registers then and not on the stack.
    """
    names, lines = _parsed(program)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        writer = _Writer(builder, min(lanes, TOGETHER), scalar, dict(zip(names, args, strict=True)))
        zero, step = ir.Constant(_WORD, 0), ir.Constant(_WORD, writer.lanes)
        with cgutils.for_range_slice(builder, zero, ir.Constant(_WORD, lanes), step, _WORD) as (lane, _):
            writer.run(lines, {"lane": lane})
        return context.get_dummy_value()

    return types.void(*arguments), generate


def each(lanes: int, program: str, *arguments: Any) -> Intrinsic:
    """Signature and code of an intrinsic that runs `program`, in float32, for every sample.

    The program may use ``sample`` in indices; one of its arguments is ``samples``, their number.
    """
    names, lines = _parsed(program)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        given = dict(zip(names, args, strict=True))
        writer = _Writer(builder, lanes, "F", given)
        zero, one = ir.Constant(_WORD, 0), ir.Constant(_WORD, 1)
        with cgutils.for_range_slice(builder, zero, given["samples"], one, _WORD) as (sample, _):
            writer.run(lines, {"sample": sample})
        return context.get_dummy_value()

    return types.void(*arguments), generate


def sums(lanes: int, run: int, count: int, step: int, program: str, *arguments: Any) -> Intrinsic:
    """Signature and code of an intrinsic that adds up over samples, in float32 over runs of `run` and in float64 beyond.

    The program leaves its `count` terms for `step` samples that follow each other in ``sum0 sum1 ...``.  It may use ``sample``, the first of
    them, in indices: ``columns F 3*row+sample+1``.  Arguments are columns, row, constants, data, samples and totals, where
    results are added.
    """
    names, lines = _parsed(program)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        given = dict(zip(names, args, strict=True))
        writer = _Writer(builder, lanes, "F", given)
        vector, wide = ir.VectorType(FLOAT, lanes), ir.VectorType(DOUBLE, lanes)
        totals = [cgutils.alloca_once(builder, vector) for _ in range(count)]
        samples, zero = given["samples"], ir.Constant(_WORD, 0)
        with cgutils.for_range_slice(builder, zero, samples, ir.Constant(_WORD, run), _WORD) as (first, _):
            for total in totals:
                builder.store(ir.Constant(vector, None), total)
            end = builder.add(first, ir.Constant(_WORD, run))
            last = builder.select(builder.icmp_signed("<", end, samples), end, samples)
            with cgutils.for_range_slice(builder, first, last, ir.Constant(_WORD, step), _WORD) as (sample, _):
                values = writer.run(lines, {"sample": sample})
                for k, total in enumerate(totals):
                    builder.store(builder.fadd(builder.load(total), values[f"sum{k}"], flags=FLAGS), total)
            for k, total in enumerate(totals):
                place = writer.place("totals", "D", str(k * lanes), {}, wide)
                new = builder.fadd(builder.load(place, align=8), builder.fpext(builder.load(total), wide), flags=FLAGS)
                builder.store(new, place, align=8)
        return context.get_dummy_value()

    return types.void(*arguments), generate


def stretch(most: int, scalar: str, program: str, *arguments: Any) -> Intrinsic:
    """Signature and code of an intrinsic that runs `program` over long rows, for two of the processor's vectors at a time, or `most` lanes if these are fewer.

    The program may use ``n``, the first item of such a step, in indices; one of its arguments is ``count``, a multiple of `most`.  What it says with
    ``splat`` and ``const`` is the same for all steps, and done once before.  Two vectors, because a processor waits for the one's divisions and
    polynomials where it has nothing else to do.
    """
    names, lines = _parsed(program)
    uniform, rest = _uniform(lines)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        given = dict(zip(names, args, strict=True))
        size = 4 if scalar == "F" else 8
        writer = _Writer(builder, min(most, 2 * _vector_bytes(context) // size), scalar, given)
        builder.function.attributes.add("noinline")  # within another function the stack would not be aligned
        values = writer.run(uniform, {})
        zero, step = ir.Constant(_WORD, 0), ir.Constant(_WORD, writer.lanes)
        with cgutils.for_range_slice(builder, zero, given["count"], step, _WORD) as (n, _):
            writer.run(rest, {"n": n}, values)
        return context.get_dummy_value()

    return types.void(*arguments), generate


def _uniform(lines: list[list[str]]) -> tuple[list[list[str]], list[list[str]]]:
    """The lines of a program that are the same wherever it runs, and the others."""
    same: set[str] = set()
    for line in lines:
        if line[1] == "=" and (line[2] in ("splat", "const") or (line[2] == "true" and line[3] in same)):
            same.add(line[0])
    return [line for line in lines if line[0] in same], [line for line in lines if line[0] not in same]


def _vector_bytes(context: Any) -> int:
    """The bytes of a vector of the processor that is compiled for."""
    features = set(context.codegen().magic_tuple()[2].split(","))
    return 64 if "+avx512f" in features else 32 if "+avx" in features else 16


def transposed(lanes: int, source: Any, stride: Any, last: Any, first: Any, target: Any) -> Intrinsic:
    """Signature and code of an intrinsic that brings `PIECE` numbers of each of 16 lanes into rows of lanes.

    Arguments: the address of the first lane's numbers (float32), the bytes from a lane's to the next lane's, the last lane that there is (those beyond
    repeat it), the position of the first number, and the address of the rows, of which those at `first` and beyond are written.
    """

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        address, step, end, start, room = args
        piece = ir.VectorType(FLOAT, PIECE)
        four = ir.Constant(_WORD, 4)
        begin = builder.add(address, builder.mul(start, four))
        vectors = []
        for lane in range(lanes):
            number = ir.Constant(_WORD, lane)
            number = builder.select(builder.icmp_signed("<", number, end), number, end)
            place = builder.inttoptr(builder.add(begin, builder.mul(number, step)), piece.as_pointer())
            vectors.append(builder.load(place, align=4))
        row = ir.VectorType(FLOAT, lanes)
        for k, value in enumerate(_columns(builder, vectors)):
            at = builder.mul(builder.add(start, ir.Constant(_WORD, k)), ir.Constant(_WORD, 4 * lanes))
            builder.store(value, builder.inttoptr(builder.add(room, at), row.as_pointer()), align=4)
        return context.get_dummy_value()

    return types.void(source, stride, last, first, target), generate


def _columns(builder: Any, rows: list[Any]) -> list[Any]:
    """The columns of twice `PIECE` rows of `PIECE` numbers, in shuffles that processors have: first within quarters of four numbers, then of these."""
    size, quarters = 2 * PIECE, PIECE // 2

    def picked(a: Any, b: Any, order: list[int]) -> Any:
        mask = ir.Constant(ir.VectorType(ir.IntType(32), len(order)), [ir.Constant(ir.IntType(32), n) for n in order])
        return builder.shuffle_vector(a, b, mask)

    def within(a: Any, b: Any, *places: int) -> Any:
        return picked(a, b, [4 * q + (n if n < 4 else n - 4 + size) for q in range(quarters) for n in places])

    # Rows k and k + 8 are one vector: numbers 0-3 and 4-7 of the one, and of the other.
    both = [picked(a, b, list(range(size))) for a, b in zip(rows[:PIECE], rows[PIECE:], strict=True)]
    fours = []
    for k in (0, 4):  # four rows by four numbers, in each quarter
        low = [within(both[k + n], both[k + n + 1], 0, 4, 1, 5) for n in (0, 2)]
        high = [within(both[k + n], both[k + n + 1], 2, 6, 3, 7) for n in (0, 2)]
        fours.append([within(*pair, *places) for pair in (low, high) for places in ((0, 1, 4, 5), (2, 3, 6, 7))])
    found = []
    for first in (0, 4):
        order = [quarter + n for quarter in (first, size + first, 8 + first, size + 8 + first) for n in range(4)]
        found += [picked(a, b, order) for a, b in zip(*fours, strict=True)]
    return found


def _parsed(program: str) -> tuple[list[str], list[list[str]]]:
    lines = [line.split() for line in program.strip().splitlines()]
    return lines[0], lines[1:]


class _Writer(Lanes):
    """Writes a program's instructions with a builder."""

    def __init__(self, builder: Any, lanes: int, scalar: str, addresses: Mapping[str, Any]) -> None:
        super().__init__(builder, lanes, scalar)
        # LLVM keeps vectors for which it has no register on the stack, which it aligns to 16 bytes unless told otherwise: half of a cache line's vectors
        # would then lie across two.
        builder.function.attributes.alignstack = LINE
        builder.function.attributes.add("nounwind")  # llvmlite writes no attributes where there are none of this kind
        self.addresses = addresses

    def run(
        self, lines: list[list[str]], indices: Mapping[str, Any], known: Mapping[str, Any] | None = None
    ) -> dict[str, Any]:
        values: dict[str, Any] = dict(known or {})
        self._exponentials = {}
        for line in lines:
            if line[0] in ("put", "add"):
                self._store(line[0], line[1], line[2], line[3], values[line[4]], indices)
                continue
            name, _, op, *arguments = line
            if op == "row":
                values[name] = self._row(arguments[0], arguments[1], arguments[2], indices)
            elif op == "splat":
                values[name] = self._splat(arguments[0], arguments[1], arguments[2], indices)
            elif op == "const":
                values[name] = self.number(float(arguments[0]))
            elif op == "true":  # a truth value that was stored as a number
                values[name] = self.builder.fcmp_unordered("!=", values[arguments[0]], self.number(0.0))
            else:
                values[name] = self.operation(op, [values[a] for a in arguments])
        return values

    # ------------------------------------------------------------ memory

    def place(self, address: str, scalar: str, index: str, indices: Mapping[str, Any], kind: Any) -> Any:
        """A pointer to `kind` at an item: a sum of products of numbers, arguments and indices."""
        builder = self.builder
        total: Any = ir.Constant(_WORD, 0)
        for term in index.split("+"):
            product: Any = ir.Constant(_WORD, 1)
            for factor in term.split("*"):
                value = (
                    ir.Constant(_WORD, int(factor))
                    if factor.isdigit()
                    else indices.get(factor, self.addresses.get(factor))
                )
                product = builder.mul(product, value)
            total = builder.add(total, product)
        size = 4 if scalar == "F" else 8
        at = builder.add(self.addresses[address], builder.mul(total, ir.Constant(_WORD, size)))
        return builder.inttoptr(at, kind.as_pointer())

    @staticmethod
    def _of_lanes(index: str, indices: Mapping[str, Any]) -> str:
        """The item of a row at which the lanes begin for which the program is run."""
        return f"{index}+lane" if "lane" in indices else index

    def _row(self, address: str, scalar: str, index: str, indices: Mapping[str, Any]) -> Any:
        kind = ir.VectorType(SCALARS[scalar], self.lanes)
        place = self.place(address, scalar, self._of_lanes(index, indices), indices, kind)
        return self._cast(self.builder.load(place, align=4 if scalar == "F" else 8), scalar, self.scalar)

    def _splat(self, address: str, scalar: str, index: str, indices: Mapping[str, Any]) -> Any:
        value = self.builder.load(self.place(address, scalar, index, indices, SCALARS[scalar]))
        if scalar != self.scalar:
            value = (self.builder.fptrunc if self.scalar == "F" else self.builder.fpext)(value, self.element)
        one = self.builder.insert_element(ir.Constant(self.vector, ir.Undefined), value, ir.Constant(ir.IntType(32), 0))
        mask = ir.Constant(ir.VectorType(ir.IntType(32), self.lanes), [0] * self.lanes)
        return self.builder.shuffle_vector(one, ir.Constant(self.vector, ir.Undefined), mask)

    def _store(self, how: str, address: str, scalar: str, index: str, value: Any, indices: Mapping[str, Any]) -> None:
        builder = self.builder
        if value.type == self.truth:
            value = builder.select(value, self.number(1.0), self.number(0.0))
        value = self._cast(value, self.scalar, scalar)
        align = 4 if scalar == "F" else 8
        place = self.place(address, scalar, self._of_lanes(index, indices), indices, value.type)
        if how == "add":
            value = builder.fadd(builder.load(place, align=align), value, flags=FLAGS)
        builder.store(value, place, align=align)

    def _cast(self, value: Any, scalar: str, wanted: str) -> Any:
        if scalar == wanted:
            return value
        kind = ir.VectorType(SCALARS[wanted], self.lanes)
        return (self.builder.fptrunc if wanted == "F" else self.builder.fpext)(value, kind)
