"""Arithmetic on vectors of lanes, as LLVM's instructions: what the programs of `motes.kernels.vectors` are made of.

exp, expm1 and log1p are those of `motes.printing.elementary`.  cbrt serves the losses of fits; errors in units of the last place of the
result, measured by ``tests/test_kernels_vectors.py``:

=======  =======  =====================================================================================
log1p    at most  1.5; -inf at -1, NaN below
cbrt     at most  1; |x| up to a half of the largest number; 0 for what is smaller than a normal number
=======  =======  =====================================================================================

cbrt divides the exponent by three (Kahan's trick) and then takes two or three steps of Halley.  Imported by generated modules only (it
imports llvmlite).
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir

from motes.printing.elementary import FLOAT32, FLOAT64

#: A value is NaN where it should be, and sums keep their order.
FLAGS = ("nsz", "arcp", "contract")
FLOAT, DOUBLE = ir.FloatType(), ir.DoubleType()
SCALARS = {"F": FLOAT, "D": DOUBLE}
_COMPARISONS = {"lt": "<", "le": "<=", "gt": ">", "ge": ">="}
# What a third of a number's bits lacks to be the bits of its cube root, to 3 %; and how many of Halley's steps make it exact.
_THIRD = {"F": 709958130, "D": 715094163 << 32}
_HALLEY = {"F": 2, "D": 3}
_LEAST_NORMAL = {"F": 2.0**-126, "D": 2.0**-1022}


class Lanes:
    """Operations on vectors of `lanes` numbers of a scalar type, written with a builder."""

    def __init__(self, builder: Any, lanes: int, scalar: str) -> None:
        self.builder, self.lanes, self.scalar = builder, lanes, scalar
        self.element = SCALARS[scalar]
        self.vector = ir.VectorType(self.element, lanes)
        self.truth = ir.VectorType(ir.IntType(1), lanes)
        self.precision = FLOAT32 if scalar == "F" else FLOAT64
        self._word = ir.IntType(32 if scalar == "F" else 64)
        self.words = ir.VectorType(self._word, lanes)
        self._exponentials: dict[Any, tuple[Any, Any]] = {}

    def number(self, value: float) -> Any:
        """The same number in all lanes."""
        return ir.Constant(self.vector, [ir.Constant(self.element, value)] * self.lanes)

    def whole(self, value: int) -> Any:
        """The same integer, as wide as a number, in all lanes."""
        return ir.Constant(self.words, [ir.Constant(self._word, value)] * self.lanes)

    def operation(self, op: str, args: list[Any]) -> Any:
        """An operation of a graph (`motes.graph.tracing`)."""
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
            return self._called("sqrt", args[0])
        if op in ("exp", "expm1"):
            return self._exponential(op, args[0])
        if op == "log1p":
            return self._log1p(args[0])
        if op == "cbrt":
            return self._cbrt(args[0])
        if op == "asin":
            return self._asin(args[0])
        if op == "asin_near":
            return self._asin_near(args[0])
        if op in ("least", "most"):  # minimum and maximum that are NaN where either is
            first = b.fcmp_ordered("<" if op == "least" else ">", *args)
            return b.select(b.or_(first, b.fcmp_unordered("uno", args[0], args[0])), *args)
        raise ValueError(f"no vector instructions are known for {op}")

    # ------------------------------------------------------------ in short

    def _add(self, a: Any, c: Any) -> Any:
        return self.builder.fadd(a, c, flags=FLAGS)

    def _sub(self, a: Any, c: Any) -> Any:
        return self.builder.fsub(a, c, flags=FLAGS)

    def _mul(self, a: Any, c: Any) -> Any:
        return self.builder.fmul(a, c, flags=FLAGS)

    def _div(self, a: Any, c: Any) -> Any:
        return self.builder.fdiv(a, c, flags=FLAGS)

    def _fused(self, a: Any, c: Any, d: Any) -> Any:
        return self._add(self._mul(a, c), d)

    def _polynomial(self, coefficients: tuple[float, ...], x: Any) -> Any:
        result = self.number(coefficients[-1])
        for c in coefficients[-2::-1]:
            result = self._fused(result, x, self.number(c))
        return result

    def _called(self, name: str, x: Any) -> Any:
        """An intrinsic function of LLVM's that is one instruction."""
        full = f"llvm.{name}.v{self.lanes}f{32 if self.scalar == 'F' else 64}"
        module = self.builder.module
        function = module.globals.get(full) or ir.Function(module, ir.FunctionType(self.vector, [self.vector]), full)
        return self.builder.call(function, [x])

    # ------------------------------------------------------------ functions

    def _exponential(self, op: str, x: Any) -> Any:
        """As ``exp`` and ``expm1`` of `motes.printing.elementary`, which says how."""
        if x not in self._exponentials:
            self._exponentials[x] = self._exp_parts(x)
        s, fraction = self._exponentials[x]
        product = self._mul(s, fraction)
        rest = s if op == "exp" else self._sub(s, self.number(0.5))
        return self._mul(self.number(2.0), self._add(product, rest))

    def _exp_parts(self, x: Any) -> tuple[Any, Any]:
        b, number, p = self.builder, self.number, self.precision
        x = b.select(b.fcmp_ordered("<", x, number(p.lowest)), number(p.lowest), x)
        x = b.select(b.fcmp_ordered(">", x, number(p.highest)), number(p.highest), x)
        shifted = self._fused(x, number(1.4426950408889634), number(p.shift))
        k = self._sub(shifted, number(p.shift))
        r = self._sub(self._sub(x, self._mul(k, number(p.ln2[0]))), self._mul(k, number(p.ln2[1])))
        bits = b.add(b.bitcast(shifted, self.words), self.whole(p.bias - 1))
        s = b.bitcast(b.shl(bits, self.whole(p.fraction)), self.vector)
        return s, self._fused(self._polynomial(p.exp, r), self._mul(r, r), r)

    def _asin_near(self, x: Any) -> Any:
        z = self._mul(x, x)
        return self._fused(self._polynomial(self.precision.asin, z), self._mul(z, x), x)

    def _asin(self, x: Any) -> Any:
        """As ``asin`` of `motes.printing.elementary`."""
        b, number = self.builder, self.number
        negative = b.fcmp_ordered("<", x, number(0.0))
        a = b.select(negative, b.fneg(x, flags=FLAGS), x)
        far = b.fcmp_ordered(">", a, number(0.70715))
        root = self._called("sqrt", self._mul(self._sub(number(1.0), a), self._add(number(1.0), a)))
        y = self._asin_near(b.select(far, root, a))
        y = b.select(far, self._sub(number(1.5707963267948966), y), y)
        return b.select(negative, b.fneg(y, flags=FLAGS), y)

    def _log1p(self, x: Any) -> Any:
        b, number, p = self.builder, self.number, self.precision
        one = number(1.0)
        u = self._add(one, x)
        shifted = b.add(b.bitcast(u, self.words), self.whole(p.one - p.half_root))
        exponent = b.sub(b.ashr(shifted, self.whole(p.fraction)), self.whole(p.bias))
        fraction = b.and_(shifted, self.whole((1 << p.fraction) - 1))
        m = b.bitcast(b.add(fraction, self.whole(p.half_root)), self.vector)
        k = b.sitofp(exponent, self.vector)
        near = b.icmp_signed("==", exponent, self.whole(0))
        lost = b.select(b.fcmp_ordered(">", x, one), self._sub(one, self._sub(u, x)), self._sub(x, self._sub(u, one)))
        c = b.select(near, number(0.0), self._div(lost, u))
        f = b.select(near, x, self._sub(m, one))
        s = self._div(f, self._add(number(2.0), f))
        z = self._mul(s, s)
        half = self._mul(number(0.5), self._mul(f, f))
        tail = self._fused(s, self._add(half, self._mul(z, self._polynomial(p.log, z))), c)
        tail = self._fused(k, number(p.ln2[1]), tail)
        result = self._fused(k, number(p.ln2[0]), self._sub(f, self._sub(half, tail)))
        edge = b.select(b.fcmp_ordered("==", u, number(0.0)), number(float("-inf")), number(float("nan")))
        result = b.select(b.fcmp_ordered(">", u, number(0.0)), result, edge)
        return b.select(b.fcmp_ordered("==", x, number(float("inf"))), x, result)

    def _cbrt(self, x: Any) -> Any:
        b, number = self.builder, self.number
        negative = b.fcmp_ordered("<", x, number(0.0))
        size = b.select(negative, b.fneg(x, flags=FLAGS), x)
        third = self._mul(b.sitofp(b.bitcast(size, self.words), self.vector), number(1 / 3))
        t = b.bitcast(b.add(b.fptosi(third, self.words), self.whole(_THIRD[self.scalar])), self.vector)
        half = self._mul(number(0.5), size)
        for _ in range(_HALLEY[self.scalar]):
            cube = self._mul(self._mul(t, t), t)
            off = self._div(self._mul(number(0.5), self._sub(cube, size)), self._add(cube, half))
            t = self._sub(t, self._mul(t, off))
        t = b.select(b.fcmp_ordered("<", size, number(_LEAST_NORMAL[self.scalar])), number(0.0), t)
        return b.select(negative, b.fneg(t, flags=FLAGS), t)
