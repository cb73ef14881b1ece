"""The normal equations of a fit as sums over samples, in one of two forms.

For residuals r = root (T(f(directions; parameters)) - T(y)) a fit needs, at every point it tries, sum r^2, sum J r and sum J J'.

``direct``
    These sums themselves: the formula and its derivatives at every sample.  Serves every model, loss and robust function.
``moments``
    `motes.fitting.printed.moments`: sums of products of the functions into which the model separates.

Both are graphs; `motes.fitting.printed.module` prints them.
"""

from __future__ import annotations

from dataclasses import dataclass

from motes.fitting.printed.traced import DATA, SUMS, Traced, total
from motes.graph import tracing
from motes.graph.tracing import DIRECTIONS, PARAMETERS, Graph, Symbol


@dataclass(frozen=True)
class NormalEquations:
    """A fit as graphs.

    Attributes
    ----------
    form
        ``"direct"`` or ``"moments"``.
    model
        What it is made of.
    leaves
        With their bits: those of the model, and the sums (`SUMS`).
    opening
        What is summed over the samples once; the first is the square of the values, the second their number.
    sums
        What is summed at every point.
    opened, summed
        The leaves that stand for those sums.
    objective, terms, gradient, matrix
        Half the (robust) sum of squares, the sizes of what it is added up from, its gradient, and J J' as a packed lower triangle: of the
        parameters and the sums.  Float32 rounds the objective, from point to point, by a share of `terms`.
    curving
        What is summed for the curvature of the objective (packed), where that is not `matrix`: under a robust function.
    closing
        What is summed at the solution: squared residuals, 0, the gradient, the middle of the sandwich (packed), and 1 where a clamp of the model acts
        that moments leave out.
    """

    form: str
    model: Traced
    leaves: dict[Symbol, int]
    opening: tuple[Symbol, ...]
    sums: tuple[Symbol, ...]
    opened: tuple[Symbol, ...]
    summed: tuple[Symbol, ...]
    objective: Symbol
    terms: Symbol
    gradient: tuple[Symbol, ...]
    matrix: tuple[Symbol, ...]
    curving: tuple[Symbol, ...]
    closing: tuple[Symbol, ...]

    def cost(self) -> int:
        """About how many operations a sample takes at every point."""
        bits = tracing.dependence(self.sums, self.leaves)
        return len(self.sums) + sum(1 for symbol, bit in bits.items() if bit & PARAMETERS and bit & (DIRECTIONS | DATA))


class Sums:
    """Sums over samples: what is summed, and the leaves that stand for the sums."""

    def __init__(self, graph: Graph, name: str) -> None:
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


def direct(model: Traced) -> NormalEquations:
    """The sums themselves; the model's data are weighed by the channel (`Data.by_channel`)."""
    graph, weights = model.graph, model.data.weights
    one = graph.constant(1.0)
    jacobian, residuals = model.jacobian(), model.residuals()
    slopes, curving = list(weights), list[Symbol]()
    lost, unit = total([r * r for r in residuals]), one
    if model.is_robust:
        sizes = model.sizes()
        lost, unit = total([graph.lift(model.robust.of(graph, z)) for z in sizes]), model.noise * model.noise
        slopes = [w * graph.lift(model.robust.sloped(graph, z)) for w, z in zip(weights, sizes, strict=True)]
        bends = [w * graph.lift(model.robust.bent(graph, z)) for w, z in zip(weights, sizes, strict=True)]
        curving = model.products(jacobian, bends)
    wanted = [lost, *model.gradient(), *model.products(jacobian, slopes)]
    sums = Sums(graph, "sum")
    lost, *rest = [sums.of(symbol) for symbol in wanted]
    objective = 0.5 * unit * lost
    size = len(model.parameters)
    opening = model.opening()
    opened = tuple(graph.leaf(f"opening[{k}]") for k in range(len(opening)))
    return NormalEquations(
        form="direct",
        model=model,
        leaves=model.leaves | dict.fromkeys((*opened, *sums.leaves), SUMS),
        opening=tuple(opening),
        sums=tuple(sums.integrands),
        opened=opened,
        summed=tuple(sums.leaves),
        objective=objective,
        terms=objective,
        gradient=tuple(rest[:size]),
        matrix=tuple(rest[size:]),
        curving=tuple(curving),
        closing=model.closing(graph.constant(0.0)),
    )
