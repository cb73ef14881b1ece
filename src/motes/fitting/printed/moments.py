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
from motes.fitting.printed.traced import SUMS, Traced, total
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
    """

    residuals: tuple[Combination, ...]
    rows: tuple[dict[Symbol, Combination], ...]
    slopes: dict[Symbol, dict[Symbol, Symbol]]
    fixed: frozenset[Symbol]

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
        return cls(tuple(residuals), tuple(all_rows), slopes, fixed)

    def closing(self, model: Traced) -> tuple[Symbol, ...]:
        """What is summed at the solution (`Traced.closing`), of the functions; texels that a clamp touches are fitted otherwise."""
        residuals = [
            total([coefficient * function for function, coefficient in row.items()]) - value
            for row, value in zip(self.residuals, model.data.values, strict=True)
        ]
        jacobian = [
            {p: total([q * f for f, q in rows[p].items()]) for p in model.parameters if p in rows} for rows in self.rows
        ]
        return model.unclamped().closing(model.clamped(), residuals, jacobian)


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
    opening, moving = sums.opening, sums.moving
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
        closing=parts.closing(model),
    )


def _sizes(objective: Symbol, sums: list[Symbol]) -> Symbol:
    """How much of the objective each of the sums made at a point is, without signs, added up."""
    graph = objective.graph
    slopes = tracing.adjoint({objective: graph.constant(1.0)}, sums)
    parts = [slope * leaf for leaf, slope in slopes.items()]
    return total([graph.constant(0.0), *(graph.maximum(part, -part) for part in parts)])


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
