"""Normal equations from moments of the data.

Where the formula separates (see `motes.graph.separation`) into coefficients q(parameters) times functions b(directions), sums of products b b and
b y determine the objective, its gradient and J J' by algebra.  Functions of the directions alone are summed once a texel; only those that hold
parameters as well are summed at every point.  For Oren-Nayar and Torrance-Sparrow that is one exp a sample.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from motes.fitting.printed.formulas import packed
from motes.fitting.printed.normal import NormalEquations, Sums
from motes.fitting.printed.traced import SUMS, Closing, Traced, total
from motes.graph import separation, tracing
from motes.graph.tracing import PARAMETERS, Symbol

#: Functions of the directions with their coefficients.
Combination = dict[Symbol, Symbol]


@dataclass(frozen=True)
class Separated:
    """A model as sums of coefficients times functions, by channel.

    Attributes
    ----------
    residuals
        Of each channel, the data left out.
    rows
        The derivatives of these by the parameters.
    slopes
        Of each function, its derivatives: functions as well.
    fixed
        The functions that hold no parameter.
    channels
        Of each channel, the functions by the factors of their coefficients.
    """

    residuals: tuple[Combination, ...]
    rows: tuple[dict[Symbol, Combination], ...]
    slopes: dict[Symbol, dict[Symbol, Symbol]]
    fixed: frozenset[Symbol]
    channels: tuple[separation.Terms, ...]

    @classmethod
    def of(cls, model: Traced) -> Separated | None:
        """None where the model does not separate for all channels alike."""
        graph = model.graph
        outputs = separation.unclamped(model.outputs, tracing.dependence(model.outputs, model.leaves))
        bits = tracing.dependence(outputs, model.leaves)
        channels = [separation.terms(output, bits) for output in outputs]
        channels = [_functions(terms, model) for terms in channels]
        functions = list(dict.fromkeys(value for terms in channels for value in terms.values()))
        slopes = {
            function: dict(zip(row, separation.gathered(list(row.values()), model.leaves), strict=True))
            for function, row in zip(functions, tracing.forward(functions, model.parameters), strict=True)
        }
        own = set(model.parameters) - _shared(model)
        if any(p in slope for slope in slopes.values() for p in own):
            return None  # a function of a channel's own parameters: the channels have no sums in common
        residuals, all_rows = [], []
        for terms in channels:
            residual: Combination = {}
            rows: dict[Symbol, Combination] = {}
            for key, function in terms.items():
                coefficient = graph.constant(1.0)
                for factor in key:
                    coefficient = coefficient * factor
                _add(residual, function, coefficient)
                (tangents,) = tracing.forward([coefficient], model.parameters)
                for parameter, slope in tangents.items():
                    _add(rows.setdefault(parameter, {}), function, slope)
                for parameter, slope in slopes[function].items():
                    _add(rows.setdefault(parameter, {}), slope, coefficient)
            residuals.append(residual)
            all_rows.append(rows)
        fixed = frozenset(f for f in functions if not _varies(f, model))
        return cls(tuple(residuals), tuple(all_rows), slopes, fixed, tuple(channels))

    def closing(self, model: Traced) -> Closing:
        """What is summed at the solution (`Traced.closing`), of the functions; texels that a clamp touches are fitted otherwise.

        Here are most of the operations of a fit, so a channel's own parameter is taken out of the terms that it is a factor of: what remains is
        largely the same for all channels, and for the values and their derivatives.
        """
        own = set(model.parameters) - _shared(model)
        found = [self._nested(terms, own, model) for terms in self.channels]
        values = separation.gathered([value for value, _ in found], model.leaves)
        residuals = [value - y for value, y in zip(values, model.data.values, strict=True)]
        jacobian = [
            dict(zip(row, separation.gathered(list(row.values()), model.leaves), strict=True)) for _, row in found
        ]
        return model.unclamped().closing(self._clamped(model, own), residuals, jacobian)

    def _clamped(self, model: Traced, own: set[Symbol]) -> Symbol:
        """`Traced.clamped`, where what is clamped is, but for a factor that is never negative, made of some of a channel's terms: of sums that are there."""
        graph, mark, found = model.graph, model.graph.leaf("mark"), list[Symbol]()
        leaves = model.leaves | {mark: PARAMETERS}
        inner = separation.clamps(model.outputs, tracing.dependence(model.outputs, model.leaves))
        held = {symbol: graph.leaf(f"clamped[{k}]") for k, symbol in enumerate(inner)}
        for output, terms in zip(model.outputs, self.channels, strict=True):
            slopes = tracing.forward([separation.in_place_of_clamps(output, held)], tuple(held.values()))[0]
            if len(slopes) != 1:
                return model.clamped()
            (slope,) = slopes.values()
            if not _never_negative(slope, (graph.leaf("root"), graph.leaf("cosine"))):
                return model.clamped()
            marked = separation.in_place_of_clamps(output, {symbol: mark * symbol for symbol in inner})
            all_terms = _functions(separation.terms(marked, tracing.dependence([marked], leaves)), model)
            here = {tuple(f for f in key if f is not mark): f for key, f in all_terms.items() if mark in key}
            if any(terms.get(key) is not function for key, function in here.items()):
                return model.clamped()
            found.append(self._nested(here, own, model)[0])
        if not found:
            return model.clamped()
        least = separation.gathered(found, model.leaves)
        smallest = least[0]
        for value in least[1:]:
            smallest = graph.minimum(smallest, value)
        return graph.where(smallest < 0, model.data.weights[0], 0.0)

    def _nested(self, terms: separation.Terms, own: set[Symbol], model: Traced) -> tuple[Symbol, dict[Symbol, Symbol]]:
        """A channel's value and its derivatives, as (terms without p) + p (terms with p, and those with higher powers)."""
        graph, zero = model.graph, model.graph.constant(0.0)
        counts = {p: sum(p in key for key in terms) for p in model.parameters if p in own}
        p = max(counts, key=counts.__getitem__, default=None)
        parts: tuple[list[Combination], ...] = ([], [], [])  # without p, with p, with more of it
        for key, function in terms.items():
            power, coefficient = 0, graph.constant(1.0)
            for factor in key:
                if factor is p and not power:
                    power = 1
                    continue
                power += factor is p
                coefficient = coefficient * factor
            parts[min(power, 2)].append({function: coefficient})
        rows: list[dict[Symbol, Symbol]] = []
        sums = []
        for part in parts:
            sums.append(total([zero, *(q * f for row in part for f, q in row.items())]))
            slopes: dict[Symbol, list[Symbol]] = {}
            for row in part:
                for f, q in row.items():
                    for r, slope in tracing.forward([q], model.parameters)[0].items():
                        slopes.setdefault(r, []).append(slope * f)
                    for r, slope in self.slopes[f].items():
                        slopes.setdefault(r, []).append(q * slope)
            rows.append({r: total(items) for r, items in slopes.items()})
        if p is None:
            return sums[0], rows[0]
        inner = sums[1] + sums[2]
        slopes_of_inner = {r: rows[1].get(r, zero) + rows[2].get(r, zero) for r in (*rows[1], *rows[2])}
        derivatives = {
            r: rows[0].get(r, zero) + (p * slopes_of_inner[r] if r in slopes_of_inner and r is not p else zero)
            for r in model.parameters
            if r in rows[0] or r in slopes_of_inner
        }
        # p A + p (p B) has the derivative (A + p B) + p B, whose parts are there.
        derivatives[p] = rows[0].get(p, zero) + (inner + p * slopes_of_inner[p] if p in slopes_of_inner else inner)
        return sums[0] + p * inner, {r: derivatives[r] for r in model.parameters if r in derivatives}


class Products(Protocol):
    """Sums over the samples of a texel."""

    def product(self, a: Symbol, b: Symbol) -> Symbol:
        """Of two functions' product."""

    def with_value(self, a: Symbol, c: int) -> Symbol:
        """Of a function times the values of a channel."""

    def square(self, c: int) -> Symbol:
        """Of the squared values of a channel."""


@dataclass(frozen=True)
class Assembled:
    """Half the sum of squares, its gradient, and J J' as a packed lower triangle."""

    objective: Symbol
    gradient: tuple[Symbol, ...]
    matrix: tuple[Symbol, ...]

    @classmethod
    def of(cls, model: Traced, parts: Separated, sums: Products) -> Assembled:
        """From sums of products."""
        graph, size = model.graph, len(model.parameters)
        objective = graph.constant(0.0)
        gradient = [graph.constant(0.0)] * size
        matrix = [graph.constant(0.0)] * (size * (size + 1) // 2)
        for c, (residual, rows) in enumerate(zip(parts.residuals, parts.rows, strict=True)):
            # The functions' products with the residual: G z - m.
            used = list(dict.fromkeys([*residual, *(f for row in rows.values() for f in row)]))
            fit = {f: total([z * sums.product(f, g) for g, z in residual.items()]) for f in used}
            data = {f: sums.with_value(f, c) for f in used}
            square = sums.square(c)
            objective = objective + 0.5 * (total([z * (fit[f] - 2 * data[f]) for f, z in residual.items()]) + square)
            for i, p in enumerate(model.parameters):
                if p not in rows:
                    continue
                gradient[i] = gradient[i] + total([q * (fit[f] - data[f]) for f, q in rows[p].items()])
                onto = {f: total([q * sums.product(f, g) for g, q in rows[p].items()]) for f in used}
                for j, other in enumerate(model.parameters[: i + 1]):
                    if other in rows:
                        k = packed(i, j)
                        matrix[k] = matrix[k] + total([q * onto[f] for f, q in rows[other].items()])
        return cls(objective, tuple(gradient), tuple(matrix))


class _Summed:
    """Sums made once where both factors are fixed, at every point elsewhere."""

    def __init__(self, model: Traced, fixed: frozenset[Symbol]) -> None:
        self.model, self.fixed = model, fixed
        self.opening, self.moving = Sums(model.graph, "opening"), Sums(model.graph, "sum")
        for integrand in model.opening():
            self.opening.of(integrand)

    def product(self, a: Symbol, b: Symbol) -> Symbol:
        a, b = sorted((a, b), key=lambda f: (f in self.fixed, f.index))
        return (self.opening if a in self.fixed else self.moving).of(a * b)

    def with_value(self, a: Symbol, c: int) -> Symbol:
        return (self.opening if a in self.fixed else self.moving).of(a * self.model.data.values[c])

    def square(self, c: int) -> Symbol:
        return self.opening.of(self.model.data.values[c] * self.model.data.values[c])


def moments(model: Traced) -> NormalEquations | None:
    """Sums of products of the functions into which the model separates; None where it does not for all channels alike.

    The model's data are weighed by the sample (`Data.by_sample`), its loss is linear, and no function is robust.
    """
    parts = Separated.of(model)
    if parts is None:
        return None
    sums = _Summed(model, parts.fixed)
    assembled = Assembled.of(model, parts, sums)
    opening, moving, closing = sums.opening, sums.moving, parts.closing(model)
    return NormalEquations(
        form="moments",
        model=model,
        leaves=model.leaves | dict.fromkeys((*opening.leaves, *moving.leaves), SUMS),
        opening=tuple(opening.integrands),
        sums=tuple(moving.integrands),
        opened=tuple(opening.leaves),
        summed=tuple(moving.leaves),
        objective=assembled.objective,
        terms=_sizes(assembled.objective, moving.leaves),
        gradient=assembled.gradient,
        matrix=assembled.matrix,
        curving=(),
        closing=closing.sums,
        stages=closing.stages,
    )


def _sizes(objective: Symbol, sums: list[Symbol]) -> Symbol:
    """How much of the objective each of the sums made at a point is, without signs, added up."""
    graph = objective.graph
    slopes = tracing.adjoint({objective: graph.constant(1.0)}, sums)
    parts = [slope * leaf for leaf, slope in slopes.items()]
    return total([graph.constant(0.0), *(graph.maximum(part, -part) for part in parts)])


def _never_negative(symbol: Symbol, leaves: tuple[Symbol, ...]) -> bool:
    """Whether its operations alone say so; of `leaves` it is known."""
    if symbol.op == "constant":
        return bool(symbol.value >= 0)
    if symbol.op in ("exp", "sqrt") or symbol in leaves:
        return True
    return symbol.op in ("add", "mul", "div") and all(_never_negative(a, leaves) for a in symbol.args)


def _add(row: Combination, function: Symbol, coefficient: Symbol) -> None:
    row[function] = row[function] + coefficient if function in row else coefficient


def _varies(symbol: Symbol, model: Traced) -> bool:
    return bool(tracing.dependence([symbol], model.leaves)[symbol] & PARAMETERS)


def _shared(model: Traced) -> set[Symbol]:
    """Parameters that act on all channels."""
    shared = set(model.parameters)
    for output in model.outputs:
        shared &= set(tracing.live([output]))
    return shared


def _functions(terms: separation.Terms, model: Traced) -> separation.Terms:
    """The functions of a channel's terms with a sample's weight, in the order of `separation.gathered`; fixed parts and others apart."""
    kept = {key: value for key, value in terms.items() if value not in model.offsets}
    values = separation.gathered([value * model.data.weights[0] for value in kept.values()], model.leaves)
    return dict(zip(kept, values, strict=True))
