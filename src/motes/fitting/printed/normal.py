"""The normal equations of a fit as sums over samples, in one of three forms.

For residuals r = root (T(f(directions; parameters)) - T(y)) a fit needs, at every point it tries, sum r^2, sum J r and sum J J'.

``direct``
    These sums themselves: the formula and its derivatives at every sample.  Serves every model, loss and robust function.
``moments``
    `motes.fitting.printed.moments`: sums of products of the functions into which the model separates.
``series``
    `motes.fitting.printed.series`: these, with series in the parameter that a function holds: no sum over samples but the first.

All are graphs; `motes.fitting.printed.module` prints them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motes.fitting.printed.traced import DATA, SUMS, Traced, total
from motes.graph import tracing
from motes.graph.tracing import DIRECTIONS, PARAMETERS, Graph, Symbol

POINTS = 5  # at which the normal equations of a fit are wanted, about


@dataclass(frozen=True)
class Tables:
    """Sums as series in the one parameter that meets directions inside a function: see `motes.fitting.printed.series`.

    Attributes
    ----------
    parameter
        That parameter, a leaf of the model; `low` and `high` bound where the series hold.
    columns
        Leaves that stand for what the series have of each direction, and the numbers (D,).
    numbers
        Leaves for what all texels share, and the numbers.
    values
        The sums of the form's `summed`, as formulas of the parameter, `numbers` and sums over the samples.
    error
        By how much a function differs from its series at most, in units of its largest value.
    """

    parameter: Symbol
    low: float
    high: float
    columns: dict[Symbol, NDArray[np.float64]]
    numbers: dict[Symbol, float]
    values: tuple[Symbol, ...]
    error: float


@dataclass(frozen=True)
class NormalEquations:
    """A fit as graphs.

    Attributes
    ----------
    form
        ``"direct"``, ``"moments"`` or ``"series"``.
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
        What is summed at the solution: squared residuals, their squares, the gradient, the middle of the sandwich (packed), and 1 where a clamp of the model
        acts that moments leave out.
    stages
        What `closing` is made of, one stage after the other: residuals and their derivatives, and what weighs them.
    tables
        Of the form ``"series"``.
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
    stages: tuple[tuple[Symbol, ...], ...]
    tables: Tables | None = None

    def cost(self) -> int:
        """About how many operations a sample takes at every point."""
        bits = tracing.dependence(self.sums, self.leaves)
        return len(self.sums) + sum(1 for symbol, bit in bits.items() if bit & PARAMETERS and bit & (DIRECTIONS | DATA))

    def work(self, samples: int) -> float:
        """About how many vector operations a texel takes, errors left out."""
        once = samples * _operations(self.opening, self.leaves)
        at_points = samples * _operations(self.sums, self.leaves)
        if self.tables is not None:  # in float64, a vector of which holds half as many lanes
            at_points += 2 * _operations(self.tables.values, self.leaves)
        return once + POINTS * at_points


def _operations(results: tuple[Symbol, ...], leaves: dict[Symbol, int]) -> int:
    bits = tracing.dependence(results, leaves)
    # A sum of a product is one operation, and what depends on directions alone is computed beforehand.
    return sum(1 for symbol, bit in bits.items() if symbol not in leaves and bit & ~DIRECTIONS) + len(results)


class Sums:
    """Sums over samples: what is summed, and the leaves that stand for the sums."""

    def __init__(self, graph: Graph, name: str) -> None:
        self.graph, self.name = graph, name
        self.integrands: list[Symbol] = []
        self.leaves: list[Symbol] = []
        self._known: dict[Symbol, Symbol] = {}

    def of(self, integrand: Symbol) -> Symbol:
        """The sum of `integrand`; of 0 it is 0."""
        if integrand.is_constant(0.0):
            return integrand
        if integrand not in self._known:
            self._known[integrand] = self.graph.leaf(f"{self.name}[{len(self.leaves)}]")
            self.leaves.append(self._known[integrand])
            self.integrands.append(integrand)
        return self._known[integrand]


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
        # What steps are made of: positive, and near the solution almost the curvature.
        slopes = [graph.maximum(bend, model.bending * slope) for bend, slope in zip(bends, slopes, strict=True)]
    wanted = [lost, *model.gradient(residuals, jacobian), *model.products(jacobian, slopes)]
    sums = Sums(graph, "sum")
    lost, *rest = [sums.of(symbol) for symbol in wanted]
    objective = 0.5 * unit * lost
    size = len(model.parameters)
    opening = model.opening()
    opened = tuple(graph.leaf(f"opening[{k}]") for k in range(len(opening)))
    closing = model.closing(graph.constant(0.0))
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
        closing=closing.sums,
        stages=closing.stages,
    )
