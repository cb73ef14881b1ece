"""The normal equations of a fit as sums over samples, in one of two forms.

For residuals r = scale f(directions; parameters) - y a fit needs, at every point it tries, sum r^2, sum J r and sum J J'.

``direct``
    These sums themselves: the formula and its derivatives at every sample.  Serves every model.
``moments``
    Where the formula separates (see `motes.graph.separation`) into coefficients q(parameters) times functions b(directions): sums of products
    b b and b y, from which the rest is algebra.  Functions of the directions alone are summed once a texel; only those that hold
    parameters as well are summed at every point.  For Oren-Nayar and Torrance-Sparrow that is one exp a sample.

Both are graphs; `motes.fitting.printed.lanes` prints them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from motes.fitting.levenberg import packed
from motes.graph import separation, tracing
from motes.graph.tracing import DIRECTIONS, PARAMETERS, Symbol

DATA, SUMS = 4, 8  # more bits for `tracing.dependence`


@dataclass(frozen=True)
class NormalEquations:
    """A fit as graphs.

    Attributes
    ----------
    form
        ``"direct"`` or ``"moments"``.
    leaves
        With their bits: what the directions fix (`DIRECTIONS`), fitted parameters (`PARAMETERS`), a sample's values and weight (`DATA`) and
        the sums (`SUMS`).
    parameters
        The fitted parameters.
    values, weight
        Of a sample: its value for each channel, scaled, less `offsets`, and 0 where there is none; 1, or 0 where there is none.
    offsets
        Of each channel what depends on directions alone.
    opening
        What is summed over the samples once; the first is the square of the values, the second the weight.
    sums
        What is summed at every point.
    opened, summed
        The leaves that stand for those sums.
    objective, gradient, matrix
        Half the sum of squares, its gradient, and J J' as a packed lower triangle: of the parameters and the sums.
    closing
        What is summed at the solution: squared residuals, 1 where a clamp of the model acts that `moments` leaves out, and r^2 J J'
        (packed), the middle of the sandwich estimator of the covariance.
    """

    form: str
    leaves: dict[Symbol, int]
    parameters: tuple[Symbol, ...]
    values: tuple[Symbol, ...]
    offsets: tuple[Symbol, ...]
    weight: Symbol
    opening: tuple[Symbol, ...]
    sums: tuple[Symbol, ...]
    opened: tuple[Symbol, ...]
    summed: tuple[Symbol, ...]
    objective: Symbol
    gradient: tuple[Symbol, ...]
    matrix: tuple[Symbol, ...]
    closing: tuple[Symbol, ...]

    def cost(self) -> int:
        """About how many operations a sample takes at every point."""
        bits = tracing.dependence(self.sums, self.leaves)
        return len(self.sums) + sum(1 for symbol, bit in bits.items() if bit & PARAMETERS and bit & (DIRECTIONS | DATA))


@dataclass(frozen=True)
class Traced:
    """A model for a fit: its graph with the residual's ingredients; `offsets` are those parts of the outputs that are taken off the data."""

    leaves: dict[Symbol, int]
    parameters: tuple[Symbol, ...]
    outputs: tuple[Symbol, ...]
    offsets: tuple[Symbol, ...]
    values: tuple[Symbol, ...]
    weight: Symbol

    @classmethod
    def of(cls, trace: tracing.Trace, fitted: Sequence[str]) -> Traced:
        """From the trace of a model (recorded without a look at the horizon) and the slots that are fitted."""
        graph = trace.graph
        scale = graph.leaf("scale")
        weight = graph.leaf("weight")
        values = tuple(graph.leaf(f"value[{c}]") for c in range(len(trace.outputs)))
        parameters = tuple(p.symbol for slot in fitted for p in trace.parameters if p.slot == slot)
        leaves = trace.leaves()
        leaves |= {p.symbol: DIRECTIONS for p in trace.parameters if p.symbol not in parameters}
        leaves |= {scale: DIRECTIONS, weight: DATA} | dict.fromkeys(values, DATA)
        outputs = separation.gathered([output * scale for output in trace.outputs], leaves)
        # What no parameter acts on, such as the dust of a layer that is held, is taken off the data.
        bits = tracing.dependence(outputs, leaves)
        plain = separation.unclamped(outputs, bits)
        terms = [separation.terms(output, tracing.dependence([output], leaves)) for output in plain]
        offsets = [row.get((), graph.constant(0.0)) for row in terms]
        bits = tracing.dependence(offsets, leaves)
        offsets = [offset if bits[offset] == DIRECTIONS else graph.constant(0.0) for offset in offsets]
        return cls(leaves, parameters, tuple(outputs), tuple(offsets), values, weight)

    @property
    def graph(self) -> tracing.Graph:
        return self.weight.graph

    def opening(self) -> list[Symbol]:
        whole = [v + self.weight * offset for v, offset in zip(self.values, self.offsets, strict=True)]
        return [total([v * v for v in whole]), self.weight]

    def residuals(self) -> list[Symbol]:
        return [
            self.weight * (f - offset) - v for f, offset, v in zip(self.outputs, self.offsets, self.values, strict=True)
        ]

    def jacobian(self) -> list[dict[Symbol, Symbol]]:
        """Derivatives of each channel's residual by the parameters."""
        rows = tracing.forward(self.outputs, self.parameters)
        return [
            dict(
                zip(row, separation.gathered([slope * self.weight for slope in row.values()], self.leaves), strict=True)
            )
            for row in rows
        ]

    def closing(self) -> tuple[Symbol, ...]:
        graph, zero = self.graph, self.graph.constant(0.0)
        clamped = zero
        for inner in separation.clamps(self.outputs, tracing.dependence(self.outputs, self.leaves)):
            clamped = graph.maximum(clamped, graph.where(inner < 0, 1.0, 0.0))
        squares = [r * r for r in self.residuals()]
        return (total(squares), self.weight * clamped, *self.products(self.jacobian(), squares))

    def products(self, jacobian: Sequence[dict[Symbol, Symbol]], weights: Sequence[Symbol]) -> list[Symbol]:
        """The sum over channels of weight J J', packed."""
        size = len(self.parameters)
        return [
            self.weighted(
                [
                    (row[self.parameters[i]] * row[self.parameters[j]], weight)
                    for weight, row in zip(weights, jacobian, strict=True)
                    if self.parameters[i] in row and self.parameters[j] in row
                ]
            )
            for i in range(size)
            for j in range(i + 1)
        ]

    def weighted(self, terms: Sequence[tuple[Symbol, Symbol]]) -> Symbol:
        """The sum of value times weight, with the weights of equal values added up first."""
        weights: dict[Symbol, list[Symbol]] = {}
        for value, weight in terms:
            weights.setdefault(value, []).append(weight)
        result = self.graph.constant(0.0)
        for value, several in weights.items():
            same = all(w is several[0] for w in several)
            result = result + value * (float(len(several)) * several[0] if same else total(several))
        return result


def direct(model: Traced) -> NormalEquations:
    """The sums themselves."""
    graph, weight = model.graph, model.weight
    jacobian, residuals = model.jacobian(), model.residuals()
    wanted = [0.5 * total([r * r for r in residuals])]
    for parameter in model.parameters:
        wanted.append(
            model.weighted(
                [(row[parameter], r) for r, row in zip(residuals, jacobian, strict=True) if parameter in row]
            )
        )
    wanted += model.products(jacobian, [graph.constant(1.0)] * len(jacobian))
    sums = Sums(graph, "sum")
    objective, *rest = [sums.of(symbol) for symbol in wanted]
    size = len(model.parameters)
    opening = model.opening()
    opened = tuple(graph.leaf(f"opening[{k}]") for k in range(len(opening)))
    return NormalEquations(
        "direct",
        model.leaves | dict.fromkeys((*opened, *sums.leaves), SUMS),
        model.parameters,
        model.values,
        model.offsets,
        weight,
        tuple(opening),
        tuple(sums.integrands),
        opened,
        tuple(sums.leaves),
        objective,
        tuple(rest[:size]),
        tuple(rest[size:]),
        model.closing(),
    )


def moments(model: Traced) -> NormalEquations | None:
    """Sums of products of the functions into which the model separates; None where it does not for all channels alike."""
    graph, weight = model.graph, model.weight
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

    opening, moving = Sums(graph, "opening"), Sums(graph, "sum")
    for integrand in model.opening():
        opening.of(integrand)
    fixed = {f for f in functions if not _varies(f, model)}

    def product(a: Symbol, b: Symbol) -> Symbol:
        """The sum of a b."""
        a, b = sorted((a, b), key=lambda f: (f in fixed, f.index))
        return (opening if a in fixed else moving).of(a * b)

    def with_value(a: Symbol, c: int) -> Symbol:
        return (opening if a in fixed else moving).of(a * model.values[c])

    objective = graph.constant(0.0)
    size = len(model.parameters)
    gradient = [graph.constant(0.0)] * size
    matrix = [graph.constant(0.0)] * (size * (size + 1) // 2)
    for c, terms in enumerate(channels):
        # The residual, and its derivative by each parameter, as coefficients of functions.
        residual: dict[Symbol, Symbol] = {}
        rows: dict[Symbol, dict[Symbol, Symbol]] = {}
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
        # The functions' products with the residual: G z - m.
        used = list(dict.fromkeys([*residual, *(f for row in rows.values() for f in row)]))
        fit = {f: total([z * product(f, g) for g, z in residual.items()]) for f in used}
        data = {f: with_value(f, c) for f in used}
        square = opening.of(model.values[c] * model.values[c])
        objective = objective + 0.5 * (total([z * (fit[f] - 2 * data[f]) for f, z in residual.items()]) + square)
        for i, p in enumerate(model.parameters):
            if p not in rows:
                continue
            gradient[i] = gradient[i] + total([q * (fit[f] - data[f]) for f, q in rows[p].items()])
            onto = {f: total([q * product(f, g) for g, q in rows[p].items()]) for f in used}
            for j, other in enumerate(model.parameters[: i + 1]):
                if other in rows:
                    k = packed(i, j)
                    matrix[k] = matrix[k] + total([q * onto[f] for f, q in rows[other].items()])
    return NormalEquations(
        "moments",
        model.leaves | dict.fromkeys((*opening.leaves, *moving.leaves), SUMS),
        model.parameters,
        model.values,
        model.offsets,
        weight,
        tuple(opening.integrands),
        tuple(moving.integrands),
        tuple(opening.leaves),
        tuple(moving.leaves),
        objective,
        tuple(gradient),
        tuple(matrix),
        model.closing(),
    )


def cheapest(model: Traced) -> NormalEquations:
    """The form with fewer operations a sample."""
    plain, separated = direct(model), moments(model)
    return separated if separated is not None and separated.cost() < plain.cost() else plain


class Sums:
    """Sums over samples: what is summed, and the leaves that stand for the sums."""

    def __init__(self, graph: tracing.Graph, name: str) -> None:
        self.graph, self.name = graph, name
        self.integrands: list[Symbol] = []
        self.leaves: list[Symbol] = []

    def of(self, integrand: Symbol) -> Symbol:
        """The sum of `integrand`; of 0 it is 0."""
        if integrand.is_constant(0.0):
            return integrand
        if integrand not in self.integrands:
            self.leaves.append(self.graph.leaf(f"{self.name}[{len(self.leaves)}]"))
            self.integrands.append(integrand)
        return self.leaves[self.integrands.index(integrand)]


def total(parts: Sequence[Symbol]) -> Symbol:
    """The sum of symbols."""
    result = parts[0]
    for part in parts[1:]:
        result = result + part
    return result


def _add(row: dict[Symbol, Symbol], function: Symbol, coefficient: Symbol) -> None:
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
    values = separation.gathered([value * model.weight for value in kept.values()], model.leaves)
    return dict(zip(kept, values, strict=True))
