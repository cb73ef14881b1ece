r"""Normal equations from moments alone: no sum over samples but the first.

The form ``moments`` still has sums to make at every point, of functions b(directions; p) in which one parameter meets the directions, such as
exp(-(theta_h/sigma_s)^2).  Such a family of functions is numerically of low rank.  Here each is a Chebyshev series in a coordinate u of the parameter,

.. math:: b(\omega; p) = \sum_{n<N} T_n(u(p))\, F_n(\omega), \qquad u = 2 \frac{t - t_0}{t_1 - t_0} - 1, \quad t = \frac{p}{p + a}.

A sum of b y over a texel's samples is then a series whose coefficients, sums of F_n y, are made once; its derivative by p is the sum with the derivative of b,
to the last digit.  Sums of b b are the same for all texels that miss no sample: series in u with known coefficients.  An iteration does not look at the data.

The coordinate (a) is the one with the fewest terms, and terms are kept until those left out add up to `TOLERANCE` of the largest value of the function; for
products without data, which cost nothing a sample, to `SHARED_TOLERANCE`.  Where the parameter makes a function vanish at all directions (a
highlight narrower than the distance of the nearest sample) there would be nothing but the error of the series: it holds between `Tables.low` and `Tables.high`
alone, and fits that leave this interval are made by another form.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from motes.fitting.printed.moments import Assembled, Separated
from motes.fitting.printed.normal import NormalEquations, Sums, Tables
from motes.fitting.printed.traced import SUMS, Traced, total
from motes.graph.tracing import DIRECTIONS, Graph, Symbol

Floats = NDArray[np.float64]
#: Values (len(symbols), K, D) of symbols at the directions, for values (K,) of a parameter.
Sampler = Callable[[Sequence[Symbol], Symbol, Floats], Floats]

TOLERANCE, SHARED_TOLERANCE = 1e-6, 1e-8
# A function whose size (the root of its mean square over directions) is less than this share of the largest is not told from the error of its series.
LEAST_SIZE = 0.03
MOST_TERMS = 64
# The number of terms is a multiple of this: sets of directions that differ a little then share a compiled module.
STEP, SHARED_STEP = 4, 2
NODES = 256
# Multiplications that are not worth a second thread.
ALONE = 200_000
SHAPES = (0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.5, 1.0, 1e6)  # a, in units of the largest value of the parameter
# Moments are made in float32 and cancel: a sum of squares is known to this share of the data's, which is added to it, so that it does not get negative.
FLOOR = 1e-6


@dataclass(frozen=True)
class Coordinate:
    """u(p) from -1 to 1 for p from `low` to `high`."""

    low: float
    high: float
    shape: float

    @property
    def ends(self) -> tuple[float, float]:
        return self.low / (self.low + self.shape), self.high / (self.high + self.shape)

    def nodes(self) -> tuple[Floats, Floats]:
        """Values of the parameter at the zeros of T_NODES, and du/dp there."""
        first, last = self.ends
        u = np.cos((np.arange(NODES) + 0.5) * np.pi / NODES)
        t = first + 0.5 * (u + 1) * (last - first)
        p = self.shape * t / (1 - t)
        return p, 2 * self.shape / (last - first) / (p + self.shape) ** 2

    def formula(self, p: Symbol) -> tuple[Symbol, Symbol]:
        """u, and its derivative."""
        first, last = self.ends
        below = 1.0 / (p + self.shape)
        scale = 2 / (last - first)
        return (p * below - first) * scale - 1.0, self.shape * scale * (below * below)


@functools.cache
def _cosines() -> Floats:
    order = np.arange(NODES)
    return np.asarray(np.cos(np.outer(order, order + 0.5) * np.pi / NODES))


def coefficients(values: Floats) -> Floats:
    """Chebyshev coefficients (NODES, ...) from values at the nodes (NODES, ...)."""
    flat = values.reshape(NODES, -1)
    # Few rows at a time, which a library of linear algebra multiplies in this thread: its others take longer to wake than all of it takes.
    rows = min(32, ALONE // flat.size) or NODES
    found = np.concatenate([part @ flat for part in np.split(_cosines(), range(rows, NODES, rows))])
    found *= 2 / NODES
    found[0] /= 2
    return np.asarray(found.reshape(values.shape))


def terms_needed(found: Floats, tolerance: float, step: int = STEP) -> tuple[int, float]:
    """How many terms leave out no more than `tolerance` of the largest value of any of the functions (NODES, ...), and how much that is.

    Their number is a multiple of `step`.
    """
    size = np.abs(found).reshape(NODES, -1)
    scale = np.abs(found).sum(axis=0).max()
    left = np.cumsum(size[::-1], axis=0)[::-1].max(axis=1) / scale
    count = int(np.argmax(np.append(left, 0.0) <= tolerance))
    count = min(NODES - step, -(-count // step) * step)
    return count, float(left[count])


@dataclass
class _Group:
    """Sums that are one series: coefficients as symbols, the leaf of the sum, and that of its derivative.

    What is expanded of a function that is a derivative by p itself is the derivative by u: `turns` counts these.
    """

    coefficients: list[Symbol]
    turns: int = 0
    value: Symbol | None = None
    slope: Symbol | None = None


@dataclass
class _Series:
    """Sums of products, as leaves; `tables` says what they are."""

    model: Traced
    parts: Separated
    parameter: Symbol
    sample: Sampler
    coordinate: Coordinate
    kept: dict[Symbol, tuple[int, Floats]]
    opening: Sums
    columns: dict[Symbol, Floats] = field(default_factory=dict)
    numbers: dict[Symbol, float] = field(default_factory=dict)
    groups: dict[tuple[object, ...], _Group] = field(default_factory=dict)
    leaves: list[Symbol] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.derived = {
            slope: f for f, row in self.parts.slopes.items() for p, slope in row.items() if p is self.parameter
        }
        every = [*self.kept, *self.derived, *self.parts.fixed]
        nodes, turn = self.coordinate.nodes()
        self.sampled = dict(zip(every, self.sample(every, self.parameter, nodes), strict=True))
        for slope in self.derived:
            self.sampled[slope] = self.sampled[slope] / turn[:, None]
        self.pooled = {f: self._alike(f) for f in (*self.kept, *self.derived)}

    @property
    def graph(self) -> Graph:
        return self.model.graph

    def _alike(self, f: Symbol) -> bool:
        """Whether all channels have the function with the same coefficients: their values can be added up first."""
        residuals, rows = self.parts.residuals, self.parts.rows
        if any(r.get(f) is not residuals[0].get(f) for r in residuals):
            return False
        return all(row.get(p, {}).get(f) is rows[0].get(p, {}).get(f) for row in rows for p in self.model.parameters)

    # ------------------------------------------------------------ sums

    def product(self, a: Symbol, b: Symbol) -> Symbol:
        a, b = sorted((a, b), key=lambda f: (f in self.parts.fixed, f in self.kept, f.index))
        if a in self.parts.fixed:
            return self._number(f"product[{a.index},{b.index}]", float(np.sum(self.sampled[a][0] * self.sampled[b][0])))
        f = self.derived.get(a)
        if f is None:
            return self._value(self._shared(a, b))
        if b in self.parts.fixed:
            return self._slope(self._shared(f, b))
        if b is f:
            return 0.5 * self._slope(self._shared(f, f))
        return self._value(self._shared(a, b))

    def with_value(self, a: Symbol, c: int) -> Symbol:
        values = self.model.data.values
        if a in self.parts.fixed:
            return self.opening.of(a * values[c])
        f = self.derived.get(a, a)
        if self.pooled[f] and self.pooled[a]:
            if c:
                return self.graph.constant(0.0)
            group = self._own(f, None, total(values))
        else:
            group = self._own(f, c, values[c])
        return self._value(group) if a is f else self._slope(group)

    def square(self, c: int) -> Symbol:
        """Those of all channels together."""
        if c:
            return self.graph.constant(0.0)
        return self.opening.of(total([v * v for v in self.model.data.values])) + FLOOR * self.opening.leaves[0]

    # ------------------------------------------------------------ series

    def _number(self, name: str, value: float) -> Symbol:
        leaf = self.graph.leaf(f"number.{name}")
        self.numbers[leaf] = value
        return leaf

    def _shared(self, a: Symbol, b: Symbol) -> _Group:
        """The series of the sum of a b, the same for all texels."""
        key = (a, b)
        if key not in self.groups:
            found = coefficients(np.sum(self.sampled[a] * self.sampled[b], axis=1))
            # What the gradient is made of has to be sure to more digits than the matrix.
            turns = (a in self.derived) + (b in self.derived)
            count, _ = terms_needed(found, TOLERANCE if turns == 2 else SHARED_TOLERANCE, SHARED_STEP)
            names = [f"series[{a.index},{b.index}][{n}]" for n in range(count)]
            numbers = [self._number(name, float(x)) for name, x in zip(names, found, strict=False)]
            self.groups[key] = _Group(numbers, turns=turns)
        return self.groups[key]

    def _own(self, f: Symbol, c: int | None, values: Symbol) -> _Group:
        """The series of the sum of f times values: a texel's own."""
        key = (f, c)
        if key not in self.groups:
            count, found = self.kept[f]
            own = []
            for n in range(count):
                column = self.graph.leaf(f"column[{f.index}][{n}]")
                self.columns[column] = found[n]
                own.append(self.opening.of(column * values))
            self.groups[key] = _Group(own)
        return self.groups[key]

    def _value(self, group: _Group) -> Symbol:
        if group.value is None:
            group.value = self._leaf()
        return group.value

    def _slope(self, group: _Group) -> Symbol:
        if group.slope is None:
            group.slope = self._leaf()
        return group.slope

    def _leaf(self) -> Symbol:
        self.leaves.append(self.graph.leaf(f"series[{len(self.leaves)}]"))
        return self.leaves[-1]

    def formulas(self) -> list[Symbol]:
        """What the leaves stand for.  All series go forward together, so that what they share does not wait in memory."""
        graph, zero = self.graph, self.graph.constant(0.0)
        u, turn = self.coordinate.formula(self.parameter)
        found: dict[Symbol, Symbol] = {}
        twice = 2.0 * u
        # T_n and its derivative, and those before.
        this, rising, before, rising_before = graph.constant(1.0), zero, zero, zero
        for n in range(max(len(group.coefficients) for group in self.groups.values())):
            for group in self.groups.values():
                if n < len(group.coefficients):
                    for leaf, factor in ((group.value, this), (group.slope, rising)):
                        if leaf is not None:
                            found[leaf] = found.get(leaf, zero) + group.coefficients[n] * factor
            if n == 0:
                this, before, rising, rising_before = u, this, graph.constant(1.0), zero
            else:
                this, before, rising, rising_before = (
                    twice * this - before,
                    this,
                    (2.0 * this + twice * rising) - rising_before,
                    rising,
                )
        turns = {leaf: group.turns for group in self.groups.values() if (leaf := group.value) is not None}
        turns |= {leaf: group.turns + 1 for group in self.groups.values() if (leaf := group.slope) is not None}
        powers = (graph.constant(1.0), turn, turn * turn)
        return [found[leaf] * powers[turns[leaf]] for leaf in self.leaves]


def series(model: Traced, sample: Sampler, bounds: Mapping[Symbol, tuple[float, float]]) -> NormalEquations | None:
    """The form; None where more than one parameter meets the directions in its functions, or where it takes too many terms.

    Parameters
    ----------
    model
        Its data miss nothing (`motes.fitting.printed.traced.Data.whole`), its loss is linear, and no function is robust.
    sample
        What functions are at the directions of the fit.
    bounds
        Of each parameter.
    """
    parts = Separated.of(model)
    if parts is None:
        return None
    functions = [f for f in dict.fromkeys(f for r in parts.residuals for f in r) if f not in parts.fixed]
    met = {p for f in functions for p in parts.slopes[f]}
    if len(met) != 1:
        return None
    parameter = met.pop()
    low, high = bounds[parameter]
    if not (0 < low < high < np.inf):
        return None
    coordinate, kept, error = _coordinate(functions, parameter, sample, low, high)
    if max(count for count, _ in kept.values()) > MOST_TERMS:
        return None
    graph = model.graph
    opening = Sums(graph, "opening")
    opening.of(model.opening()[0])
    opening.of(graph.where(graph.leaf("root") > 0, float(len(model.data.values)), 0.0))
    sums = _Series(model, parts, parameter, sample, coordinate, kept, opening)
    assembled = Assembled.of(model, parts, sums)
    if not sums.groups:
        return None
    leaves = model.leaves | dict.fromkeys((*opening.leaves, *sums.leaves, *sums.numbers), SUMS)
    leaves |= dict.fromkeys(sums.columns, DIRECTIONS)
    closing = parts.closing(model)
    return NormalEquations(
        form="series",
        model=model,
        leaves=leaves,
        opening=tuple(opening.integrands),
        sums=(),
        opened=tuple(opening.leaves),
        summed=tuple(sums.leaves),
        objective=assembled.objective,
        terms=graph.constant(0.0),  # the sums are made once: what is rounded is the same at all points
        gradient=assembled.gradient,
        matrix=assembled.matrix,
        curving=(),
        closing=closing.sums,
        stages=closing.stages,
        tables=Tables(
            parameter,
            coordinate.low,
            coordinate.high,
            sums.columns,
            sums.numbers,
            tuple(sums.formulas()),
            error,
        ),
    )


def _coordinate(
    functions: Sequence[Symbol], parameter: Symbol, sample: Sampler, low: float, high: float
) -> tuple[Coordinate, dict[Symbol, tuple[int, Floats]], float]:
    """The coordinate with the fewest terms; of each function their number and the coefficients; and the largest error."""
    grid = np.geomspace(low, high, 400)
    size = np.sqrt(np.mean(sample(functions, parameter, grid) ** 2, axis=(0, 2)))
    seen = np.flatnonzero(size >= LEAST_SIZE * size.max())
    if seen[0] > 0:
        low = float(grid[seen[0]])
    if seen[-1] < len(grid) - 1:
        high = float(grid[seen[-1]])
    best: tuple[int, Coordinate, dict[Symbol, tuple[int, Floats]], float] | None = None
    for shape in SHAPES:
        coordinate = Coordinate(low, high, shape * high)
        kept, worst = {}, 0.0
        for f, values in zip(functions, sample(functions, parameter, coordinate.nodes()[0]), strict=True):
            found = coefficients(values)
            count, error = terms_needed(found, TOLERANCE)
            kept[f], worst = (count, found[:count]), max(worst, error)
        terms = sum(count for count, _ in kept.values())
        if best is None or terms < best[0]:
            best = terms, coordinate, kept, worst
    assert best is not None
    return best[1:]
