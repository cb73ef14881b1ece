"""Straight-line programs over rows of lanes, as vector instructions: what the kernels of `motes.fitting.printed.lanes` are made of.

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

from motes.printing.elementary import FLOAT32, FLOAT64, Precision

#: A value is NaN where it should be, and sums keep their order.
FLAGS = ("nsz", "arcp", "contract")
_FLOAT, _DOUBLE, _WORD = ir.FloatType(), ir.DoubleType(), ir.IntType(64)
_SCALARS = {"F": _FLOAT, "D": _DOUBLE}
_COMPARISONS = {"lt": "<", "le": "<=", "gt": ">", "ge": ">="}


def rows(lanes: int, scalar: str, program: str, *arguments: Any) -> tuple[Any, Callable[..., Any]]:
    """Signature and code of an intrinsic that runs `program` once; its arguments are the addresses that the program names, in its first line."""
    names, lines = _parsed(program)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        writer = _Writer(builder, lanes, scalar, dict(zip(names, args, strict=True)))
        writer.run(lines, {})
        return context.get_dummy_value()

    return types.void(*arguments), generate


def sums(lanes: int, run: int, count: int, step: int, program: str, *arguments: Any) -> tuple[Any, Callable[..., Any]]:
    """Signature and code of an intrinsic that adds up over samples, in float32 over runs of `run` and in float64 beyond.

    The program leaves its `count` terms for `step` samples that follow each other in ``sum0 sum1 ...``.  It may use ``sample``, the first of
    them, in indices: ``columns F 3*row+sample+1``.  Arguments are columns, row, constants, data, samples and totals, where
    results are added.
    """
    names, lines = _parsed(program)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        given = dict(zip(names, args, strict=True))
        writer = _Writer(builder, lanes, "F", given)
        vector, wide = ir.VectorType(_FLOAT, lanes), ir.VectorType(_DOUBLE, lanes)
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


def _parsed(program: str) -> tuple[list[str], list[list[str]]]:
    lines = [line.split() for line in program.strip().splitlines()]
    return lines[0], lines[1:]


class _Writer:
    """Writes a program's instructions with a builder."""

    def __init__(self, builder: Any, lanes: int, scalar: str, addresses: Mapping[str, Any]) -> None:
        self.builder, self.lanes, self.addresses = builder, lanes, addresses
        self.element = _SCALARS[scalar]
        self.scalar = scalar
        self.vector = ir.VectorType(self.element, lanes)
        self.truth = ir.VectorType(ir.IntType(1), lanes)
        self.precision = FLOAT32 if scalar == "F" else FLOAT64

    def run(self, lines: list[list[str]], indices: Mapping[str, Any]) -> dict[str, Any]:
        values: dict[str, Any] = {}
        self._exponentials: dict[Any, tuple[Any, Any]] = {}
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
                values[name] = self._operation(op, [values[a] for a in arguments])
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

    def _row(self, address: str, scalar: str, index: str, indices: Mapping[str, Any]) -> Any:
        kind = ir.VectorType(_SCALARS[scalar], self.lanes)
        place = self.place(address, scalar, index, indices, kind)
        return self._cast(self.builder.load(place, align=4 if scalar == "F" else 8), scalar, self.scalar)

    def _splat(self, address: str, scalar: str, index: str, indices: Mapping[str, Any]) -> Any:
        value = self.builder.load(self.place(address, scalar, index, indices, _SCALARS[scalar]))
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
        place = self.place(address, scalar, index, indices, value.type)
        if how == "add":
            value = builder.fadd(builder.load(place, align=align), value, flags=FLAGS)
        builder.store(value, place, align=align)

    def _cast(self, value: Any, scalar: str, wanted: str) -> Any:
        if scalar == wanted:
            return value
        kind = ir.VectorType(_SCALARS[wanted], self.lanes)
        return (self.builder.fptrunc if wanted == "F" else self.builder.fpext)(value, kind)

    # ------------------------------------------------------------ arithmetic

    def number(self, value: float) -> Any:
        return ir.Constant(self.vector, [ir.Constant(self.element, value)] * self.lanes)

    def _operation(self, op: str, args: list[Any]) -> Any:
        b = self.builder
        if op in ("add", "sub", "mul", "div"):
            return getattr(b, f"f{op}")(*args, flags=FLAGS)
        if op in _COMPARISONS:
            return b.fcmp_ordered(_COMPARISONS[op], *args)
        if op == "neg":
            return b.fneg(args[0], flags=FLAGS)
        if op == "where":
            return b.select(*args)
        if op in ("minimum", "maximum"):
            first = b.fcmp_ordered(">" if op == "minimum" else "<", args[0], args[1])
            return b.select(first, args[1], args[0])
        if op == "sqrt":
            name = f"llvm.sqrt.v{self.lanes}f{32 if self.scalar == 'F' else 64}"
            function = b.module.globals.get(name) or ir.Function(
                b.module, ir.FunctionType(self.vector, [self.vector]), name
            )
            return b.call(function, args)
        if op in ("exp", "expm1"):
            return self._exponential(op, args[0])
        raise ValueError(
            f"no vector instructions are known for {op}"
        )  # asin belongs to directions, which NumPy computes

    def _exponential(self, op: str, x: Any) -> Any:
        """As ``exp`` and ``expm1`` of `motes.printing.elementary`, which says how."""
        b, p = self.builder, self.precision
        if x not in self._exponentials:
            self._exponentials[x] = self._exp_parts(x, p)
        s, fraction = self._exponentials[x]
        product = b.fmul(s, fraction, flags=FLAGS)
        rest = s if op == "exp" else b.fsub(s, self.number(0.5), flags=FLAGS)
        return b.fmul(self.number(2.0), b.fadd(product, rest, flags=FLAGS), flags=FLAGS)

    def _exp_parts(self, x: Any, p: Precision) -> tuple[Any, Any]:
        b, number = self.builder, self.number

        def fused(a: Any, c: Any, d: Any) -> Any:
            return b.fadd(b.fmul(a, c, flags=FLAGS), d, flags=FLAGS)

        x = b.select(b.fcmp_ordered("<", x, number(p.lowest)), number(p.lowest), x)
        x = b.select(b.fcmp_ordered(">", x, number(p.highest)), number(p.highest), x)
        shifted = fused(x, number(1.4426950408889634), number(p.shift))
        k = b.fsub(shifted, number(p.shift), flags=FLAGS)
        r = b.fsub(
            b.fsub(x, b.fmul(k, number(p.ln2[0]), flags=FLAGS), flags=FLAGS),
            b.fmul(k, number(p.ln2[1]), flags=FLAGS),
            flags=FLAGS,
        )
        width = 32 if self.scalar == "F" else 64
        integer = ir.VectorType(ir.IntType(width), self.lanes)

        def whole(value: int) -> Any:
            return ir.Constant(integer, [ir.Constant(ir.IntType(width), value)] * self.lanes)

        bits = b.add(b.bitcast(shifted, integer), whole(p.bias - 1))
        s = b.bitcast(b.shl(bits, whole(p.fraction)), self.vector)
        polynomial = number(p.exp[-1])
        for c in p.exp[-2::-1]:
            polynomial = fused(polynomial, r, number(c))
        return s, fused(polynomial, b.fmul(r, r, flags=FLAGS), r)
