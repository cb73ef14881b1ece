"""The same values by fewer operations: what programs of vectors are made of (`motes.kernels.loops`).

A formula says what is meant; of its operations a processor feels the divisions, and then the multiplications and comparisons, which are bound to two of
its four pipes.  Each change here is equal but for rounding, keeps NaN, and makes no product of denominators that float32 could not hold.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from typing import NamedTuple

from motes.directions import SMALLEST_COSINE
from motes.graph import tracing
from motes.graph.derivatives import powers
from motes.graph.tracing import DIRECTIONS, PARAMETERS, Symbol, Trace

#: Denominators whose product is known to be at least so large are multiplied; one of unknown size may be among them.
LEAST_PRODUCT = 1e-13
_EXTREMA = frozenset({"minimum", "maximum"})
_ORDERED = _EXTREMA | {"lt", "le", "gt", "ge"}
_BASE_2 = {"exp": "exp2", "expm1": "exp2m1"}


def without_division(outputs: Sequence[Symbol], leaves: Mapping[Symbol, int]) -> list[Symbol]:
    """Fewer divisions; each change is one rounding more.

    Division by what is constant becomes multiplication by its inverse, one more constant, which is much faster.  1/a + 1/b becomes (a + b) / (a b)
    where both are clamped cosines.
    """
    bits = tracing.dependence(outputs, leaves)

    def rule(symbol: Symbol, args: tuple[Symbol, ...]) -> Symbol | None:
        if symbol.op == "add" and all(_inverse_of_clamped(a) for a in args):
            a, b = (quotient.args[1] for quotient in args)
            return (a + b) / (a * b)
        if symbol.op != "div" or bits[symbol.args[1]] != PARAMETERS or not bits[symbol] & DIRECTIONS:
            return None
        return args[0] * (1.0 / args[1])

    return tracing.rewritten(outputs, rule)


def _inverse_of_clamped(symbol: Symbol) -> bool:
    """Whether this is 1/a of an a that is kept so far from 0 that a product of two of them is a normal number in float32."""
    if symbol.op != "div" or not symbol.args[0].is_constant(1) or symbol.args[1].op != "maximum":
        return False
    return any(a.op == "constant" and a.value >= SMALLEST_COSINE for a in symbol.args[1].args)


def cheaper(trace: Trace, leaves: Mapping[Symbol, int], held: Collection[Symbol] = ()) -> list[Symbol]:
    """The outputs of a trace by fewer operations.

    Parameters
    ----------
    trace
        What is computed.
    leaves
        What it starts from, with bits: `DIRECTIONS` or `PARAMETERS`.
    held
        Leaves of `PARAMETERS` that stay as they are: nothing is multiplied by them beforehand.
    """
    sizes = _Sizes({p.symbol: p.least for p in trace.parameters})
    bits = {symbol: bit | DIRECTIONS if symbol in held else bit for symbol, bit in leaves.items()}
    outputs = without_division(trace.outputs, leaves)
    for _ in range(2):  # what one pass has taken apart has fewer users for the next
        outputs = _factored(outputs, bits, sizes)
    outputs = _in_base_2(outputs, bits, sizes)
    return _Products(outputs, bits, sizes, held).outputs


# ---------------------------------------------------------------- what is known of sizes


class _Sizes:
    """Lower bounds of symbols, minus infinity where nothing is known."""

    def __init__(self, known: Mapping[Symbol, float]) -> None:
        self._known = dict(known)

    def least(self, symbol: Symbol) -> float:
        if symbol not in self._known:
            self._known[symbol] = self._least(symbol)
        return self._known[symbol]

    def _least(self, symbol: Symbol) -> float:
        op, args = symbol.op, symbol.args
        if op == "constant":
            return -math.inf if isinstance(symbol.value, bool) else float(symbol.value)
        if op in ("mul", "div") and args[0] is args[1]:
            return 0.0 if op == "mul" else 1.0
        bounds = [self.least(a) for a in args]
        if op == "maximum":
            return max(bounds)
        if op == "minimum":
            return min(bounds)
        if op == "where":
            return min(bounds[1:])
        if op == "add":
            return sum(bounds)
        if op == "exp":
            return 0.0
        if op == "sqrt":
            return math.sqrt(max(0.0, bounds[0]))
        if op in ("mul", "div") and min(bounds) >= 0:
            return bounds[0] * bounds[1] if op == "mul" else 0.0
        if op in ("asin", "asin_near") and bounds[0] >= 0:
            return 0.0
        return -math.inf


# ---------------------------------------------------------------- common factors, and signs that are known


def _factored(outputs: Sequence[Symbol], leaves: Mapping[Symbol, int], sizes: _Sizes) -> list[Symbol]:
    """min(a x, b x) as min(a, b) x, and a x < b x as a < b, where x is not negative; no maximum of 0 and what is not negative."""
    users: dict[Symbol, set[str]] = {}
    for symbol in tracing.live(outputs):
        for a in symbol.args:
            users.setdefault(a, set()).add(symbol.op)
    for symbol in outputs:
        users.setdefault(symbol, set()).add("output")

    def rule(symbol: Symbol, args: tuple[Symbol, ...]) -> Symbol | None:
        if symbol.op == "asin" and symbol.args[0].op == "minimum":  # directions.polar_angle
            return symbol.graph.apply("asin_near", *args)  # the smaller of a sine and a cosine is at most sin(pi/4)
        if symbol.op == "maximum":
            for a, b in (args, args[::-1]):
                if b.is_constant(0) and sizes.least(a) >= 0:
                    return a
                if b.is_constant(0) and (x := _negative_part(a)) is not None and leaves.get(x) == DIRECTIONS:
                    return x - x  # 0, or NaN: the components of directions are finite
        if symbol.op in _ORDERED and all(users[a] <= _ORDERED for a in symbol.args):
            (top_a, bottom_a), (top_b, bottom_b) = (_factors(a) for a in args)
            top, bottom = _common(top_a, top_b), _common(bottom_a, bottom_b)
            if (top or bottom) and all(sizes.least(x) >= 0 for x in (*top, *bottom)):
                rests = [
                    _quotient(symbol, _without(t, top), _without(b, bottom))
                    for t, b in ((top_a, bottom_a), (top_b, bottom_b))
                ]
                ordered = symbol.graph.apply(symbol.op, *rests)
                return _quotient(symbol, [ordered, *top], bottom) if symbol.op in _EXTREMA else ordered
        return None

    return tracing.rewritten(outputs, rule)


def _negative_part(symbol: Symbol) -> Symbol | None:
    """x, of min(x, 0)."""
    if symbol.op == "minimum":
        for x, zero in (symbol.args, symbol.args[::-1]):
            if zero.is_constant(0):
                return x
    return None


def _factors(symbol: Symbol) -> tuple[list[Symbol], list[Symbol]]:
    """The factors of a product, and its denominators."""
    if symbol.op == "mul":
        (top_a, bottom_a), (top_b, bottom_b) = (_factors(a) for a in symbol.args)
        return top_a + top_b, bottom_a + bottom_b
    if symbol.op == "div":
        top, bottom = _factors(symbol.args[0])
        return top, [*bottom, symbol.args[1]]
    return [symbol], []


def _common(a: list[Symbol], b: list[Symbol]) -> list[Symbol]:
    rest, found = list(b), []
    for symbol in a:
        if symbol in rest:
            rest.remove(symbol)
            found.append(symbol)
    return found


def _without(symbols: list[Symbol], some: list[Symbol]) -> list[Symbol]:
    rest = list(symbols)
    for symbol in some:
        rest.remove(symbol)
    return rest


def _quotient(like: Symbol, top: Sequence[Symbol], bottom: Sequence[Symbol]) -> Symbol:
    result = like.graph.constant(1.0)
    for symbol in top:
        result = result * symbol
    for symbol in bottom:
        result = result / symbol
    return result


# ---------------------------------------------------------------- exponentials


def _in_base_2(outputs: Sequence[Symbol], leaves: Mapping[Symbol, int], sizes: _Sizes) -> list[Symbol]:
    """Exponentials of what depends on directions to the base 2, so that their argument need not be turned: a constant factor takes the ln(2) up."""
    bits = tracing.dependence(outputs, leaves)

    def rule(symbol: Symbol, args: tuple[Symbol, ...]) -> Symbol | None:
        if symbol.op not in _BASE_2 or not bits[symbol] & DIRECTIONS:
            return None
        (x,) = args
        below = x.op == "neg" and sizes.least(x.args[0]) >= 0
        square = x.args[0] if x.op == "neg" else x
        if square.op == "mul" and square.args[0] is square.args[1]:
            root = square.args[0] * math.sqrt(1 / math.log(2))
            turned = -(root * root) if x.op == "neg" else root * root
        else:
            turned = x * (1 / math.log(2))
        return symbol.graph.apply(_BASE_2[symbol.op] + ("_below" if below else ""), turned)

    return tracing.rewritten(outputs, rule)


# ---------------------------------------------------------------- products


class _Product(NamedTuple):
    """A constant times factors over denominators."""

    constant: Symbol
    top: tuple[Symbol, ...] = ()
    bottom: tuple[Symbol, ...] = ()


class _Products:
    """Products and quotients written anew: constants together, and one division for what was several."""

    def __init__(
        self, outputs: Sequence[Symbol], leaves: Mapping[Symbol, int], sizes: _Sizes, held: Collection[Symbol]
    ) -> None:
        order = list(tracing.live(outputs))
        self.bits = tracing.dependence(outputs, leaves)
        self.users: dict[Symbol, list[Symbol | None]] = {symbol: [] for symbol in order}
        for symbol in order:
            for a in dict.fromkeys(symbol.args):
                self.users[a].append(symbol)
        for symbol in outputs:
            self.users[symbol].append(None)
        self.sizes, self.held = sizes, set(held)
        self.powers = powers(order)
        self.products: dict[Symbol, _Product] = {}
        self.new: dict[Symbol, Symbol] = {}
        for symbol in order:
            if not self.bits[symbol] & DIRECTIONS:
                self.new[symbol] = symbol
            elif symbol.op in ("mul", "div", "neg"):
                self.products[symbol] = self._product(symbol)
            else:
                args = tuple(self._value(a) for a in symbol.args)
                self.new[symbol] = symbol if args == symbol.args else symbol.graph.apply(symbol.op, *args)
        self.outputs = [self._value(symbol) for symbol in outputs]

    def _value(self, symbol: Symbol) -> Symbol:
        if symbol not in self.new:
            self.new[symbol] = self._written(self.products[symbol])
        return self.new[symbol]

    def _product(self, symbol: Symbol) -> _Product:
        one = symbol.graph.constant(1.0)
        if symbol.op == "neg":
            constant, top, bottom = self._part(symbol.args[0], symbol)
            return _Product(-constant, top, bottom)
        a, b = symbol.args
        if a is b and symbol.op == "mul":
            inner = self.products.get(a)
            if inner and self.users[a] == [symbol] and inner.constant.op == "constant" and not inner.bottom:
                core = self._written(inner._replace(constant=one))
                return _Product(inner.constant * inner.constant, (core, core))
            return _Product(one, (self._value(a), self._value(a)))
        first = self._part(a, symbol)
        if symbol.op == "div":
            constant, divisor = self._divisor(b, symbol)
            if first.bottom and not self._harmless((*first.bottom, divisor)):
                first = _Product(one, (self._written(first),))
            return _Product(first.constant / constant, first.top, (*first.bottom, divisor))
        second = self._part(b, symbol)
        bottom = (*first.bottom, *second.bottom)
        if first.bottom and second.bottom and not self._harmless(bottom):
            first, bottom = _Product(one, (self._written(first),)), second.bottom
        return _Product(first.constant * second.constant, (*first.top, *second.top), bottom)

    def _divisor(self, symbol: Symbol, user: Symbol) -> tuple[Symbol, Symbol]:
        """A divisor as a constant and what is divided by."""
        one = symbol.graph.constant(1.0)
        product = self.products.get(symbol)
        if product is None or self.users[symbol] != [user]:
            return one, self._value(symbol)
        return product.constant, self._written(product._replace(constant=one))

    def _part(self, symbol: Symbol, user: Symbol) -> _Product:
        """What a factor or denominator brings into the product of `user`: all of it, its constant, or itself."""
        one = symbol.graph.constant(1.0)
        if not self.bits[symbol] & DIRECTIONS:
            return _Product(symbol)
        product = self.products.get(symbol)
        if symbol in self.powers and symbol.op == "mul":  # stays whole, which its derivative is a short one of
            return _Product(one, (self._value(symbol),))
        if product is not None and self.users[symbol] == [user]:
            return product
        if product is not None and all(u is not None and self._scales(u) for u in self.users[symbol]):
            return _Product(product.constant, (self._written(product._replace(constant=one)),))
        return _Product(one, (self._value(symbol),))

    def _scales(self, symbol: Symbol) -> bool:
        """Whether this is a constant times something."""
        return symbol.op == "mul" and any(not self.bits[a] & DIRECTIONS for a in symbol.args)

    def _harmless(self, bottom: Sequence[Symbol]) -> bool:
        """Whether a product of denominators is as good as one after the other, in float32 too."""
        bounds = [self.sizes.least(symbol) for symbol in bottom]
        known = [bound for bound in bounds if bound > 0]
        return len(known) >= len(bounds) - 1 and math.prod(known) >= LEAST_PRODUCT

    def _written(self, product: _Product) -> Symbol:
        constant, top, bottom = product
        for a in top:  # the smaller of two times the larger
            if a.op == "minimum":
                larger = next((b for b in top if b.op == "maximum" and set(b.args) == set(a.args)), None)
                if larger is not None:
                    top = (*_without(list(top), [a, larger]), *a.args)
                    break
        # The constant comes last: channels share what is before it, and an addition that follows goes with it.
        result, *rest = sorted(top, key=self.held.__contains__) or [constant]
        for symbol in rest:
            result = result * symbol
        if bottom:
            first, *rest = sorted(bottom, key=lambda s: s.index)  # in one order, so that equal divisors are one
            divisor = first
            for symbol in rest:
                divisor = divisor * symbol
            result = result / divisor
        if not top:
            return result
        return -result if constant.is_constant(-1) else result * constant
