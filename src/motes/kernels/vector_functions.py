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

from collections.abc import Callable

from motes.kernels.assembly import Builder, Value, number, scalar, vector
from motes.printing.elementary import FLOAT32, FLOAT64

_COMPARISONS = {"lt": "olt", "le": "ole", "gt": "ogt", "ge": "oge"}
_BASE_2 = ("exp2", "exp2m1", "exp2_below", "exp2m1_below")
# What a third of a number's bits lacks to be the bits of its cube root, to 3 %; and how many of Halley's steps make it exact.
_THIRD = {"F": 709958130, "D": 715094163 << 32}
_HALLEY = {"F": 2, "D": 3}
_LEAST_NORMAL = {"F": 2.0**-126, "D": 2.0**-1022}


class Lanes:
    """Operations on vectors of `lanes` numbers of a scalar type, written with a builder."""

    def __init__(self, builder: Builder, lanes: int, letter: str) -> None:
        self.builder, self.lanes, self.letter = builder, lanes, letter
        self.element = scalar(letter)
        self.vector = vector(lanes, self.element)
        self.truth = vector(lanes, "i1")
        self.precision = FLOAT32 if letter == "F" else FLOAT64
        self.words = vector(lanes, "i32" if letter == "F" else "i64")
        self._exponentials: dict[Value, tuple[Value, Value]] = {}
        self._powers: dict[tuple[Value, bool], tuple[Value, Value]] = {}
        #: Whether roots in float64 are made by multiplications, of whole vectors of AVX-512; the third of three is left to the divider, beside these.
        self.multiplied_roots = False
        self._roots = 0

    def number(self, value: float) -> Value:
        """The same number in all lanes."""
        return number(self.vector, value)

    def whole(self, value: int) -> Value:
        """The same integer, as wide as a number, in all lanes."""
        return number(self.words, value)

    def operation(self, op: str, args: list[Value]) -> Value:
        """An operation of a graph (`motes.graph.tracing`)."""
        b = self.builder
        if op in ("add", "sub", "mul", "div"):
            return b.binary(f"f{op}", *args)
        if op in _COMPARISONS:
            return b.compared(_COMPARISONS[op], *args)
        if op == "neg":
            return b.negated(args[0])
        if op == "where":
            return b.select(*args)
        if op in ("minimum", "maximum"):
            first = b.compared("ogt" if op == "minimum" else "olt", args[0], args[1])
            return b.select(first, args[1], args[0])
        if op == "sqrt":
            return self._root(args[0])
        if op in ("exp", "expm1"):
            return self._exponential(op, args[0])
        if op in _BASE_2:
            return self._base_2(op, args[0])
        if op == "log1p":
            return self._log1p(args[0])
        if op == "cbrt":
            return self._cbrt(args[0])
        if op == "asin":
            return self._asin(args[0])
        if op == "asin_near":
            return self._asin_near(args[0])
        if op in ("least", "most"):  # minimum and maximum that are NaN where either is
            first = b.compared("olt" if op == "least" else "ogt", *args)
            return b.select(b.binary("or", first, b.compared("uno", args[0], args[0])), *args)
        raise ValueError(f"no vector instructions are known for {op}")

    # ------------------------------------------------------------ in short

    def _add(self, a: Value, c: Value) -> Value:
        return self.builder.binary("fadd", a, c)

    def _sub(self, a: Value, c: Value) -> Value:
        return self.builder.binary("fsub", a, c)

    def _mul(self, a: Value, c: Value) -> Value:
        return self.builder.binary("fmul", a, c)

    def _div(self, a: Value, c: Value) -> Value:
        return self.builder.binary("fdiv", a, c)

    def _fused(self, a: Value, c: Value, d: Value) -> Value:
        return self._add(self._mul(a, c), d)

    def _polynomial(self, coefficients: tuple[float, ...], x: Value) -> Value:
        result = self.number(coefficients[-1])
        for c in coefficients[-2::-1]:
            result = self._fused(result, x, self.number(c))
        return result

    def _called(self, name: str, x: Value) -> Value:
        """An intrinsic function of LLVM's that is one instruction."""
        full = f"llvm.{name}.v{self.lanes}f{32 if self.letter == 'F' else 64}"
        return self.builder.intrinsic(full, self.vector, [x])

    # ------------------------------------------------------------ functions

    def _root(self, x: Value) -> Value:
        self._roots += 1
        if self.multiplied_roots and self.letter == "D" and self._roots % 3:
            return self._multiplied_root(x)
        return self._called("sqrt", x)

    def _multiplied_root(self, x: Value) -> Value:
        """The square root, rounded as the processor's instruction for it rounds, from an estimate of 14 bits.

        Two of Goldschmidt's steps make it good to a unit of the last place, and half of its inverse to as much; what its square lacks of x is then known
        exactly, and says how to round.  (Two processors' estimates differ, the results do not.)  Where x is 0 or infinite, so is the root.
        """
        b, half = self.builder, self.number(0.5)
        near = self._whole_vectors(x, self._estimate)
        root, over = self._mul(x, near), self._mul(half, near)
        for _ in range(2):
            off = self._less(half, root, over)
            root, over = self._fma(root, off, root), self._fma(over, off, over)
        root = self._fma(self._less(x, root, root), over, root)
        return b.select(self._whole_vectors(x, self._endless), x, root)

    def _estimate(self, x: Value) -> Value:
        name = "llvm.x86.avx512.rsqrt14.pd.512"
        return self.builder.intrinsic(name, x.kind, [x, number(x.kind, 0.0), Value("i8", "-1")])

    def _endless(self, x: Value) -> Value:
        """Whether it is 0 of either sign, or infinite."""
        return self.builder.intrinsic("llvm.x86.avx512.fpclass.pd.512", vector(8, "i1"), [x, Value("i32", "14")])

    def _whole_vectors(self, x: Value, function: Callable[[Value], Value]) -> Value:
        """A function of one of the processor's vectors, of all lanes."""
        parts = [self.builder.shuffled(x, x, range(k, k + 8)) for k in range(0, self.lanes, 8)]
        found = [function(part) for part in parts]
        while len(found) > 1:
            pairs = zip(found[::2], found[1::2], strict=True)
            found = [self.builder.shuffled(p, q, range(2 * self.lanes // len(found))) for p, q in pairs]
        return found[0]

    def _fma(self, a: Value, c: Value, d: Value) -> Value:
        """a c + d, rounded once."""
        return self.builder.intrinsic(f"llvm.fma.v{self.lanes}f64", self.vector, [a, c, d])

    def _less(self, d: Value, a: Value, c: Value) -> Value:
        """d - a c, rounded once."""
        return self._fma(self.builder.negated(a), c, d)

    def _exponential(self, op: str, x: Value) -> Value:
        """As ``exp`` and ``expm1`` of `motes.printing.elementary`, which says how."""
        if x not in self._exponentials:
            self._exponentials[x] = self._exp_parts(x)
        s, fraction = self._exponentials[x]
        product = self._mul(s, fraction)
        rest = s if op == "exp" else self._sub(s, self.number(0.5))
        return self._mul(self.number(2.0), self._add(product, rest))

    def _exp_parts(self, x: Value) -> tuple[Value, Value]:
        b, number, p = self.builder, self.number, self.precision
        x = b.select(b.compared("olt", x, number(p.lowest)), number(p.lowest), x)
        x = b.select(b.compared("ogt", x, number(p.highest)), number(p.highest), x)
        shifted = self._fused(x, number(1.4426950408889634), number(p.shift))
        k = self._sub(shifted, number(p.shift))
        r = self._sub(self._sub(x, self._mul(k, number(p.ln2[0]))), self._mul(k, number(p.ln2[1])))
        bits = b.binary("add", b.turned("bitcast", shifted, self.words), self.whole(p.bias - 1))
        s = b.turned("bitcast", b.binary("shl", bits, self.whole(p.fraction)), self.vector)
        return s, self._fused(self._polynomial(p.exp, r), self._mul(r, r), r)

    def _base_2(self, op: str, x: Value) -> Value:
        """2^x, or 2^x - 1; ``_below`` where x is known not to be positive, and so needs no upper limit."""
        name, limited = op.removesuffix("_below"), not op.endswith("_below")
        if (x, limited) not in self._powers:
            self._powers[x, limited] = self._power_parts(x, limited)
        s, fraction = self._powers[x, limited]
        return self._fused(s, fraction, s if name == "exp2" else self._sub(s, self.number(1.0)))

    def _power_parts(self, x: Value, limited: bool) -> tuple[Value, Value]:
        """2^k and 2^r - 1, where x = k + r."""
        b, number, p = self.builder, self.number, self.precision
        low, high = number(-p.bias), number(p.bias + 0.5 - 2.0**-10)
        x = b.select(b.compared("olt", x, low), low, x)
        if limited:  # beyond, the power is infinite: that of the limit itself times two
            x, beyond = b.select(b.compared("ogt", x, high), high, x), b.compared("ogt", x, high)
        shifted = self._add(x, number(p.shift))
        k = self._sub(shifted, number(p.shift))
        r = self._sub(x, k)
        bits = b.binary("add", b.turned("bitcast", shifted, self.words), self.whole(p.bias))
        s = b.turned("bitcast", b.binary("shl", bits, self.whole(p.fraction)), self.vector)
        if limited:
            s = b.select(beyond, number(float("inf")), s)
        return s, self._mul(self._polynomial(p.exp2, r), r)

    def _asin_near(self, x: Value) -> Value:
        z = self._mul(x, x)
        return self._fused(self._polynomial(self.precision.asin, z), self._mul(z, x), x)

    def _asin(self, x: Value) -> Value:
        """As ``asin`` of `motes.printing.elementary`."""
        b, number = self.builder, self.number
        negative = b.compared("olt", x, number(0.0))
        a = b.select(negative, b.negated(x), x)
        far = b.compared("ogt", a, number(0.70715))
        root = self._called("sqrt", self._mul(self._sub(number(1.0), a), self._add(number(1.0), a)))
        y = self._asin_near(b.select(far, root, a))
        y = b.select(far, self._sub(number(1.5707963267948966), y), y)
        return b.select(negative, b.negated(y), y)

    def _log1p(self, x: Value) -> Value:
        b, number, p = self.builder, self.number, self.precision
        one = number(1.0)
        u = self._add(one, x)
        shifted = b.binary("add", b.turned("bitcast", u, self.words), self.whole(p.one - p.half_root))
        exponent = b.binary("sub", b.binary("ashr", shifted, self.whole(p.fraction)), self.whole(p.bias))
        fraction = b.binary("and", shifted, self.whole((1 << p.fraction) - 1))
        m = b.turned("bitcast", b.binary("add", fraction, self.whole(p.half_root)), self.vector)
        k = b.turned("sitofp", exponent, self.vector)
        near = b.compared("eq", exponent, self.whole(0))
        lost = b.select(b.compared("ogt", x, one), self._sub(one, self._sub(u, x)), self._sub(x, self._sub(u, one)))
        c = b.select(near, number(0.0), self._div(lost, u))
        f = b.select(near, x, self._sub(m, one))
        s = self._div(f, self._add(number(2.0), f))
        z = self._mul(s, s)
        half = self._mul(number(0.5), self._mul(f, f))
        tail = self._fused(s, self._add(half, self._mul(z, self._polynomial(p.log, z))), c)
        tail = self._fused(k, number(p.ln2[1]), tail)
        result = self._fused(k, number(p.ln2[0]), self._sub(f, self._sub(half, tail)))
        edge = b.select(b.compared("oeq", u, number(0.0)), number(float("-inf")), number(float("nan")))
        result = b.select(b.compared("ogt", u, number(0.0)), result, edge)
        return b.select(b.compared("oeq", x, number(float("inf"))), x, result)

    def _cbrt(self, x: Value) -> Value:
        b, number = self.builder, self.number
        negative = b.compared("olt", x, number(0.0))
        size = b.select(negative, b.negated(x), x)
        third = self._mul(b.turned("sitofp", b.turned("bitcast", size, self.words), self.vector), number(1 / 3))
        t = b.turned(
            "bitcast",
            b.binary("add", b.turned("fptosi", third, self.words), self.whole(_THIRD[self.letter])),
            self.vector,
        )
        half = self._mul(number(0.5), size)
        for _ in range(_HALLEY[self.letter]):
            cube = self._mul(self._mul(t, t), t)
            off = self._div(self._mul(number(0.5), self._sub(cube, size)), self._add(cube, half))
            t = self._sub(t, self._mul(t, off))
        t = b.select(b.compared("olt", size, number(_LEAST_NORMAL[self.letter])), number(0.0), t)
        return b.select(negative, b.negated(t), t)
