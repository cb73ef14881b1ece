"""Separating a formula into what depends on parameters alone times what depends on directions.

The diffuse terms of these models are sums of products: K_d C1(sigma_d) times a function of the directions, and so on.  A fit of many
texels at the same directions then needs no sum over samples for them but one: sums of products of the direction-dependent factors.
Only factors in which directions and parameters meet inside a function, exp(-(theta_h/sigma_s)^2), have to be summed anew for each
value of the parameters.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from motes.graph.dependence import DIRECTIONS, PARAMETERS, live, rewritten
from motes.graph.symbols import Symbol

#: Products of parameter-only symbols (their factors in order) and the factor that depends on directions.
Terms = dict[tuple[Symbol, ...], Symbol]
MOST_TERMS = 16  # of a product that is multiplied out


def gathered(outputs: Sequence[Symbol], leaves: Mapping[Symbol, int]) -> list[Symbol]:
    """The outputs with the factors of every product in one order: what depends on directions alone, both, parameters alone.

    What depends on one side alone then is a single number that is computed beforehand, and products with the same beginning, such as a
    function and its derivative, share it.
    """
    bits = dict(leaves)
    parts: dict[Symbol, tuple[list[Symbol], list[Symbol], list[Symbol]]] = {}

    def bits_of(symbol: Symbol) -> int:
        if symbol not in bits:
            bits[symbol] = 0
            for a in symbol.args:
                bits[symbol] |= bits_of(a)
        return bits[symbol]

    def split(symbol: Symbol) -> tuple[list[Symbol], list[Symbol], list[Symbol]]:
        if symbol in parts:
            return parts[symbol]
        bit = bits_of(symbol)
        if bit in (0, PARAMETERS):
            return [], [], [symbol]
        return ([symbol], [], []) if bit == DIRECTIONS else ([], [symbol], [])

    def rule(symbol: Symbol, args: tuple[Symbol, ...]) -> Symbol | None:
        graph = symbol.graph
        if symbol.op == "mul":
            factors = [a + b for a, b in zip(split(args[0]), split(args[1]), strict=True)]
        elif symbol.op == "neg":
            factors = [list(part) for part in split(args[0])]
            factors[0].append(graph.constant(-1.0))
        elif symbol.op == "div" and bits_of(args[1]) in (0, DIRECTIONS, PARAMETERS):
            factors = [list(part) for part in split(args[0])]
            factors[2 if bits_of(args[1]) == PARAMETERS else 0].append(1.0 / args[1])
        else:
            return None
        if not factors[1] and not (factors[0] and factors[2]):
            return None  # one side alone: as the author has it
        # Those of a sample's data come first: a weight is shared by all that follows.
        fixed, mixed, free = (
            sorted(part, key=lambda f: (bits_of(f) & (DIRECTIONS | PARAMETERS), f.index)) for part in factors
        )
        # Numbers go with what depends on directions alone.
        fixed += [f for f in free if not bits_of(f)]
        free = [f for f in free if bits_of(f)]
        product = graph.constant(1.0)
        for factor in fixed:
            product = product * factor
        for factor in mixed:
            product = product * factor
        own = graph.constant(1.0)
        for factor in free:
            own = own * factor
        result = product * own
        parts[result] = (fixed, mixed, free)
        return result

    return rewritten(outputs, rule)


def clamps(outputs: Sequence[Symbol], bits: Mapping[Symbol, int]) -> list[Symbol]:
    """What the outputs clamp at a constant, ``maximum(a, constant)``, and depends on parameters: the symbols `a`."""
    found = []
    for symbol in live(outputs):
        if symbol.op == "maximum" and bits[symbol] & ~DIRECTIONS:
            a, b = symbol.args
            if a.op == "constant" or b.op == "constant":
                found.append(b if a.op == "constant" else a)
    return found


def unclamped(outputs: Sequence[Symbol], bits: Mapping[Symbol, int]) -> list[Symbol]:
    """The outputs without these clamps: the same wherever they do nothing."""
    inner = set(clamps(outputs, bits))

    def rule(symbol: Symbol, args: tuple[Symbol, ...]) -> Symbol | None:
        if symbol.op != "maximum" or not any(a in inner for a in symbol.args):
            return None
        return args[0] if symbol.args[0] in inner else args[1]

    return rewritten(outputs, rule)


def in_place_of_clamps(output: Symbol, instead: Mapping[Symbol, Symbol]) -> Symbol:
    """The output with something else in place of each of its clamps, by what these clamp."""

    def rule(symbol: Symbol, args: tuple[Symbol, ...]) -> Symbol | None:
        if symbol.op != "maximum":
            return None
        return next((instead[a] for a in symbol.args if a in instead), None)

    return rewritten([output], rule)[0]


def terms(output: Symbol, bits: Mapping[Symbol, int]) -> Terms:
    """`output` as a sum of products.

    Parameters
    ----------
    output
        A formula, `gathered` (negations are factors then).
    bits
        Of every symbol, see `motes.graph.dependence.dependence`; symbols without the bit `DIRECTIONS` can be factors.
    """
    known: dict[Symbol, Terms] = {}
    for symbol in live([output]):
        known[symbol] = _terms(symbol, known, bits)
    return known[output]


def _terms(symbol: Symbol, known: Mapping[Symbol, Terms], bits: Mapping[Symbol, int]) -> Terms:
    graph, op, args = symbol.graph, symbol.op, symbol.args
    bit = bits[symbol]
    if not bit & DIRECTIONS:
        number, factors = _factors(symbol)
        return {factors: graph.constant(number)}
    if bit == DIRECTIONS:
        return {(): symbol}
    if op in ("add", "sub"):
        total = dict(known[args[0]])
        for key, value in known[args[1]].items():
            if key in total:
                total[key] = total[key] + value if op == "add" else total[key] - value
            else:
                total[key] = value if op == "add" else -value
        return total
    if op == "mul":
        a, b = (known[x] for x in args)
        if len(a) * len(b) <= MOST_TERMS:
            product: Terms = {}
            for key_a, value_a in a.items():
                for key_b, value_b in b.items():
                    key = _ordered((*key_a, *key_b))
                    value = value_a * value_b
                    product[key] = product[key] + value if key in product else value
            return product
    if op == "div":
        if not bits[args[1]] & DIRECTIONS:
            number, factors = _factors(1.0 / args[1])
            return {_ordered((*key, *factors)): value * number for key, value in known[args[0]].items()}
        if bits[args[1]] == DIRECTIONS:
            return {key: value / args[1] for key, value in known[args[0]].items()}
    if op == "where" and bits[args[0]] == DIRECTIONS:
        a, b = known[args[1]], known[args[2]]
        zero = graph.constant(0.0)
        return {key: graph.where(args[0], a.get(key, zero), b.get(key, zero)) for key in {**a, **b}}
    return {(): symbol}


def _factors(symbol: Symbol) -> tuple[float, tuple[Symbol, ...]]:
    """A symbol as a number times factors that are not products."""
    if symbol.op == "constant":
        return float(symbol.value), ()
    if symbol.op == "mul":
        (m, a), (n, b) = (_factors(x) for x in symbol.args)
        return m * n, _ordered((*a, *b))
    return 1.0, (symbol,)


def _ordered(factors: tuple[Symbol, ...]) -> tuple[Symbol, ...]:
    return tuple(sorted(factors, key=lambda symbol: symbol.index))
