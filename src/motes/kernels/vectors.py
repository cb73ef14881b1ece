"""Straight-line programs over rows of lanes, as vector instructions: what the kernels of `motes.fitting.printed` are made of.

A program is text, one instruction a line, in the order of evaluation::

    a0 = row state D 3            LANES numbers (float64) at row 3 of the memory that starts at address `state`
    a1 = splat box D 2            the number at item 2, for all lanes
    t0 = mul a0 a1
    t1 = lt t0 a0
    t2 = where t1 t0 a1
    put state D 4 t2              stores; `add` instead of `put` adds to what is there
    sum sums F 16 t0*t2 -t2       adds products and numbers, with their signs, to a row as long as a vector of the processor (for `stretch`)

A program becomes vector instructions as it stands: no compiler has to find out that they can be vectors.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from motes.kernels.assembly import DOUBLE, FLOAT, WORD, Builder, Value, number, scalar, vector
from motes.kernels.machine_code import long_roots, tuning, vector_bytes
from motes.kernels.transposing import boxed, transposed, turned
from motes.kernels.vector_functions import Lanes

#: What generated modules call.
__all__ = ["boxed", "each", "rows", "stretch", "sums", "transposed", "turned"]

TOGETHER = 8  # lanes for which a program over rows is run at a time: a vector of AVX-512 in float64
LONG = 800  # lines of a program over long rows, 40 bytes of instructions each for two vectors
AT_ONCE = 16  # samples for which a part of a long program is done before the next part


def rows(builder: Builder, lanes: int, letter: str, program: str, *arguments: Value) -> None:
    """Write `program` once; its arguments are the addresses that it names, in its first line.

    It runs for `TOGETHER` lanes after the others, whose numbers are in the processor's registers then and not on the stack.
    """
    names, lines = _parsed(program)
    writer = _Writer(builder, min(lanes, TOGETHER), letter, dict(zip(names, arguments, strict=True)))
    with builder.loop(number(WORD, 0), number(WORD, lanes), writer.lanes) as lane:
        writer.run(lines, {"lane": lane})


def each(builder: Builder, lanes: int, program: str, *arguments: Value) -> None:
    """Write `program`, in float32, for every sample.

    The program may use ``sample`` in indices; one of its arguments is ``samples``, their number.
    """
    names, lines = _parsed(program)
    given = dict(zip(names, arguments, strict=True))
    writer = _Writer(builder, lanes, "F", given)
    with builder.loop(number(WORD, 0), given["samples"], 1) as sample:
        writer.run(lines, {"sample": sample})


def sums(builder: Builder, lanes: int, run: int, count: int, step: int, program: str, *arguments: Value) -> None:
    """Write what adds up over samples, in float32 over runs of `run` and in float64 beyond.

    The program leaves its `count` terms for `step` samples that follow each other in ``sum0 sum1 ...``.  It may use ``sample``, the first of
    them, in indices: ``columns F 3*row+sample+1``.  Arguments are columns, row, constants, data, samples and totals, where
    results are added.

    A line ``cut`` divides a long program: what is above it is done for `AT_ONCE` samples before what is below, and what that needs waits in the
    nearest cache.  A processor has registers for each part, and several samples of a short part in work at once.
    """
    names, lines = _parsed(program)
    given = dict(zip(names, arguments, strict=True))
    writer = _Writer(builder, lanes, "F", given)
    narrow, wide = vector(lanes, FLOAT), vector(lanes, DOUBLE)
    totals = [builder.place(narrow) for _ in range(count)]
    samples, parts = given["samples"], _parts(lines)
    waiting = builder.place(f"[{sum(len(part.left) for part in parts) * AT_ONCE or 1} x {narrow}]")

    def least(a: Value, b: Value) -> Value:
        return builder.select(builder.compared("slt", a, b), a, b)

    def place(name: str, item: Value) -> Value:
        at = builder.binary("add", item, number(WORD, AT_ONCE * places[name]))
        return builder.value("ptr", f"getelementptr {narrow}, ptr {waiting.text}, i64 {at.text}")

    places, truths = dict[str, int](), set[str]()
    with builder.loop(number(WORD, 0), samples, run) as first:
        for total in totals:
            builder.store(number(narrow, 0.0), total)
        last = least(builder.binary("add", first, number(WORD, run)), samples)
        with builder.loop(first, last, AT_ONCE if len(parts) > 1 else run) as start:
            stop = least(builder.binary("add", start, number(WORD, AT_ONCE)), last) if len(parts) > 1 else last
            for part in parts:
                with builder.loop(start, stop, step) as sample:
                    item = builder.binary("sub", sample, start)
                    known = {name: builder.load(narrow, place(name, item)) for name in part.taken}
                    for name in truths.intersection(known):
                        known[name] = builder.compared("une", known[name], writer.number(0.0))
                    values = writer.run(part.lines, {"sample": sample}, known)
                    for name in part.left:
                        places[name], value = len(places), values[name]
                        if value.kind == writer.truth:
                            truths.add(name)
                            value = builder.select(value, writer.number(1.0), writer.number(0.0))
                        builder.store(value, place(name, item))
                    for k, total in enumerate(totals):
                        if f"sum{k}" in values:
                            builder.store(builder.binary("fadd", builder.load(narrow, total), values[f"sum{k}"]), total)
        for k, total in enumerate(totals):
            at = writer.place("totals", "D", str(k * lanes), {})
            new = builder.turned("fpext", builder.load(narrow, total), wide)
            builder.store(builder.binary("fadd", builder.load(wide, at, 8), new), at, 8)


class _Part(NamedTuple):
    """A part of a program: its lines, and the names that it takes from parts before and leaves for those after."""

    lines: list[list[str]]
    taken: list[str]
    left: list[str]


def _parts(lines: list[list[str]]) -> list[_Part]:
    """A program as divided by ``cut``; what can be read again is."""
    found: list[list[list[str]]] = [[]]
    for line in lines:
        if line == ["cut"]:
            found.append([])
        else:
            found[-1].append(line)
    again = {
        line[0]: line for part in found for line in part if line[1] == "=" and line[2] in ("row", "splat", "const")
    }
    made = [{line[0] for line in part if line[1] == "="} for part in found]
    taken = list[list[str]]()
    for k, part in enumerate(found):
        used = dict.fromkeys(name for line in part for name in line[3:] if name not in made[k])
        found[k] = [again[name] for name in used if name in again] + part
        taken.append([name for name in used if any(name in names for names in made[:k]) and name not in again])
    later = [set[str]().union(*taken[k + 1 :]) for k in range(len(found))]
    left = [sorted(names & after) for names, after in zip(made, later, strict=True)]
    return [_Part(*items) for items in zip(found, taken, left, strict=True)]


def stretch(builder: Builder, most: int, letter: str, program: str, *arguments: Value) -> None:
    """Write `program` over long rows, for several of the processor's vectors at a time, or `most` lanes if these are fewer.

    The program may use ``n``, the first item of such a step, in indices; one of its arguments is ``count``, a multiple of `most`.  What it says with
    ``splat`` and ``const`` is the same for all steps, and done once before.  Two vectors, because a processor waits for the one's divisions and
    polynomials where it has nothing else to do, and four of AVX2; one in programs of more than `LONG` lines, whose instructions for two do not fit the
    first cache.
    """
    names, lines = _parsed(program)
    uniform, rest = _uniform(lines)
    given = dict(zip(names, arguments, strict=True))
    at_once = 1 if len(rest) > LONG else 4 if vector_bytes() == 32 and not any(line[0] == "sum" for line in rest) else 2
    writer = _Writer(builder, min(most, at_once * _vector(letter)), letter, given)
    writer.multiplied_roots = long_roots()
    builder.tuning = tuning()
    values = writer.run(uniform, {})
    with builder.loop(number(WORD, 0), given["count"], writer.lanes) as n:
        writer.run(rest, {"n": n}, values)


def _vector(letter: str) -> int:
    """Numbers in one of the processor's vectors."""
    return vector_bytes() // (4 if letter == "F" else 8)


def _uniform(lines: list[list[str]]) -> tuple[list[list[str]], list[list[str]]]:
    """The lines of a program that are the same wherever it runs, and the others."""
    same: set[str] = set()
    for line in lines:
        if line[1] == "=" and (line[2] in ("splat", "const") or (line[2] == "true" and line[3] in same)):
            same.add(line[0])
    return [line for line in lines if line[0] in same], [line for line in lines if line[0] not in same]


def _parsed(program: str) -> tuple[list[str], list[list[str]]]:
    lines = [line.split() for line in program.strip().splitlines()]
    return lines[0], lines[1:]


class _Writer(Lanes):
    """Writes a program's instructions with a builder."""

    def __init__(self, builder: Builder, lanes: int, letter: str, addresses: Mapping[str, Value]) -> None:
        super().__init__(builder, lanes, letter)
        # LLVM keeps vectors for which it has no register on the stack, which it aligns to 16 bytes unless told otherwise: half of a cache line's vectors
        # would then lie across two.
        builder.aligned = True
        self.addresses = addresses

    def run(
        self, lines: list[list[str]], indices: Mapping[str, Value], known: Mapping[str, Value] | None = None
    ) -> dict[str, Value]:
        values: dict[str, Value] = dict(known or {})
        self._exponentials, self._powers = {}, {}
        for line in lines:
            if line[0] in ("put", "add"):
                self._store(line[0], line[1], line[2], line[3], values[line[4]], indices)
                continue
            if line[0] == "sum":
                self._sum(line[1], line[2], line[3], line[4:], values, indices)
                continue
            name, _, op, *arguments = line
            if op == "row":
                values[name] = self._row(arguments[0], arguments[1], arguments[2], indices)
            elif op == "splat":
                values[name] = self._splat(arguments[0], arguments[1], arguments[2], indices)
            elif op == "const":
                values[name] = self.number(float(arguments[0]))
            elif op == "true":  # a truth value that was stored as a number
                values[name] = self.builder.compared("une", values[arguments[0]], self.number(0.0))
            else:
                values[name] = self.operation(op, [values[a] for a in arguments])
        return values

    # ------------------------------------------------------------ memory

    def place(self, address: str, letter: str, index: str, indices: Mapping[str, Value]) -> Value:
        """A pointer to an item: a sum of products of numbers, arguments and indices."""
        builder = self.builder
        whole, terms = 0, []
        for term in index.split("+"):
            known, product = 1, None
            for factor in term.split("*"):
                if factor.isdigit():
                    known *= int(factor)
                    continue
                value = indices[factor] if factor in indices else self.addresses[factor]
                product = value if product is None else builder.binary("mul", product, value)
            if product is None:
                whole += known
            else:
                terms.append(product if known == 1 else builder.binary("mul", product, number(WORD, known)))
        at, size = self.addresses[address], 4 if letter == "F" else 8
        for items in terms:
            at = builder.binary("add", at, builder.binary("mul", items, number(WORD, size)))
        return builder.pointer(builder.binary("add", at, number(WORD, size * whole)) if whole else at)

    @staticmethod
    def _of_lanes(index: str, indices: Mapping[str, Value]) -> str:
        """The item of a row at which the lanes begin for which the program is run."""
        return f"{index}+lane" if "lane" in indices else index

    def _row(self, address: str, letter: str, index: str, indices: Mapping[str, Value]) -> Value:
        place = self.place(address, letter, self._of_lanes(index, indices), indices)
        kind = vector(self.lanes, scalar(letter))
        return self._cast(self.builder.load(kind, place, 4 if letter == "F" else 8), letter, self.letter)

    def _splat(self, address: str, letter: str, index: str, indices: Mapping[str, Value]) -> Value:
        value = self.builder.load(scalar(letter), self.place(address, letter, index, indices))
        if letter != self.letter:
            value = self.builder.turned("fptrunc" if self.letter == "F" else "fpext", value, self.element)
        nothing = Value(self.vector, "poison")
        one = self.builder.value(self.vector, f"insertelement {self.vector} poison, {value.kind} {value.text}, i32 0")
        return self.builder.shuffled(one, nothing, [0] * self.lanes)

    def _store(
        self, how: str, address: str, letter: str, index: str, value: Value, indices: Mapping[str, Value]
    ) -> None:
        builder = self.builder
        if value.kind == self.truth:
            value = builder.select(value, self.number(1.0), self.number(0.0))
        value = self._cast(value, self.letter, letter)
        align = 4 if letter == "F" else 8
        place = self.place(address, letter, self._of_lanes(index, indices), indices)
        if how == "add":
            value = builder.binary("fadd", builder.load(value.kind, place, align), value)
        builder.store(value, place, align)

    def _sum(
        self,
        address: str,
        letter: str,
        index: str,
        terms: Sequence[str],
        values: Mapping[str, Value],
        indices: Mapping[str, Value],
    ) -> None:
        """Add terms to a row, one of the processor's vectors after the other."""
        builder, size = self.builder, 4 if letter == "F" else 8
        place, whole = self.place(address, letter, index, indices), min(self.lanes, _vector(letter))
        total = builder.load(vector(whole, self.element), place, size)
        for first in range(0, self.lanes, whole):
            order = list(range(first, first + whole))
            for term in terms:
                a, *b = (builder.shuffled(values[name], values[name], order) for name in term.lstrip("-").split("*"))
                product = builder.binary("fmul", a, b[0]) if b else a
                total = builder.binary("fsub" if term[0] == "-" else "fadd", total, product)
        builder.store(total, place, size)

    def _cast(self, value: Value, letter: str, wanted: str) -> Value:
        if letter == wanted:
            return value
        return self.builder.turned("fptrunc" if wanted == "F" else "fpext", value, vector(self.lanes, scalar(wanted)))
