"""Normal equations from moments of the data.

Where the formula separates (see `motes.graph.separation`) into coefficients q(parameters) times functions b(directions), sums of products b b and
b y determine the objective, its gradient and J J' by algebra.  Functions of the directions alone are summed once a texel; only those that hold
parameters as well are summed at every point.  For Oren-Nayar and Torrance-Sparrow that is one exp a sample.
"""

from __future__ import annotations

from motes.fitting.printed.formulas import packed
from motes.fitting.printed.normal import NormalEquations, Sums
from motes.fitting.printed.traced import SUMS, Traced, total
from motes.graph import separation, tracing
from motes.graph.tracing import PARAMETERS, Symbol


def moments(model: Traced) -> NormalEquations | None:
    """Sums of products of the functions into which the model separates; None where it does not for all channels alike.

    The model's data are weighed by the sample (`Data.by_sample`), its loss is linear, and no function is robust.
    """
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

    opening, moving = Sums(graph, "opening"), Sums(graph, "sum")
    for integrand in model.opening():
        opening.of(integrand)
    fixed = {f for f in functions if not _varies(f, model)}

    def product(a: Symbol, b: Symbol) -> Symbol:
        """The sum of a b."""
        a, b = sorted((a, b), key=lambda f: (f in fixed, f.index))
        return (opening if a in fixed else moving).of(a * b)

    def with_value(a: Symbol, c: int) -> Symbol:
        return (opening if a in fixed else moving).of(a * model.data.values[c])

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
        square = opening.of(model.data.values[c] * model.data.values[c])
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
        form="moments",
        model=model,
        leaves=model.leaves | dict.fromkeys((*opening.leaves, *moving.leaves), SUMS),
        opening=tuple(opening.integrands),
        sums=tuple(moving.integrands),
        opened=tuple(opening.leaves),
        summed=tuple(moving.leaves),
        objective=objective,
        terms=_sizes(objective, moving.leaves),
        gradient=tuple(gradient),
        matrix=tuple(matrix),
        curving=(),
        closing=model.unclamped().closing(model.clamped()),  # texels that a clamp touches are fitted otherwise
    )


def _sizes(objective: Symbol, sums: list[Symbol]) -> Symbol:
    """How much of the objective each of the sums made at a point is, without signs, added up."""
    graph = objective.graph
    slopes = tracing.adjoint({objective: graph.constant(1.0)}, sums)
    parts = [slope * leaf for leaf, slope in slopes.items()]
    return total([graph.constant(0.0), *(graph.maximum(part, -part) for part in parts)])


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
    values = separation.gathered([value * model.data.weights[0] for value in kept.values()], model.leaves)
    return dict(zip(kept, values, strict=True))
