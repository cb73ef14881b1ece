"""A model for a fit of texels, as a graph: what is kept of the data, residuals, derivatives, and what weighs them.

The residual of a sample and channel is root (T(f) - T(y)) with the loss's transform T (`motes.fitting.losses`) and root the square root of the
direction's weight; it is 0 where there is no value.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from motes.fitting.covariance import LEAST_REMAINDER
from motes.fitting.losses import Loss, Robust
from motes.fitting.printed.formulas import packed
from motes.graph import separation, tracing
from motes.graph.tracing import DIRECTIONS, PARAMETERS, Graph, Symbol

DATA, SUMS = 4, 8  # more bits for `tracing.dependence`


@dataclass(frozen=True)
class Data:
    """What is kept of a sample's values, and how formulas read it.

    Attributes
    ----------
    raw
        Leaves: the measured values of the channels, not finite where there is none.
    stored
        What is kept, as formulas of `raw` and the directions; `leaves` stand for it.
    blank
        What is kept of a sample that does not exist.
    values, weights
        Of each channel: the transformed value less its offset, 0 where there is none; 1, or 0 where there is none.
    measured
        The transformed values with their offsets, where these are not made of `values`.
    """

    raw: tuple[Symbol, ...]
    stored: tuple[Symbol, ...]
    leaves: tuple[Symbol, ...]
    blank: tuple[float, ...]
    values: tuple[Symbol, ...]
    weights: tuple[Symbol, ...]
    measured: tuple[Symbol, ...] | None = None

    @classmethod
    def by_channel(cls, graph: Graph, raw: Sequence[Symbol], targets: Sequence[Symbol], root: Symbol) -> Data:
        """Each channel may be missing by itself: NaN is kept there."""
        nan = graph.constant(float("nan"))
        stored = [graph.where(root > 0, graph.where((t - t) <= 0, t, nan), nan) for t in targets]
        leaves = [graph.leaf(f"value[{c}]") for c in range(len(raw))]
        there = [leaf <= leaf for leaf in leaves]
        values = [graph.where(ok, leaf, 0.0) for ok, leaf in zip(there, leaves, strict=True)]
        weights = [graph.where(ok, 1.0, 0.0) for ok in there]
        return cls(tuple(raw), tuple(stored), tuple(leaves), (float("nan"),) * len(raw), tuple(values), tuple(weights))

    @classmethod
    def by_sample(cls, graph: Graph, raw: Sequence[Symbol], targets: Sequence[Symbol], root: Symbol) -> Data:
        """A sample counts when all of its channels are there."""
        good = graph.where(root > 0, graph.where(total([t - t for t in targets]) <= 0, 1.0, 0.0), 0.0)
        stored = [graph.where(good > 0, t, 0.0) for t in targets]
        values = [graph.leaf(f"value[{c}]") for c in range(len(raw))]
        weight = graph.leaf("weight")
        blank = (0.0,) * (len(raw) + 1)
        return cls(tuple(raw), (*stored, good), (*values, weight), blank, tuple(values), (weight,) * len(raw))

    @classmethod
    def whole(cls, raw: Sequence[Symbol], measured: Sequence[Symbol], offsets: Sequence[Symbol]) -> Data:
        """Nothing is missing: what is measured is kept as it is.  A sample without weight counts for nothing, as its root is 0."""
        values = tuple(value - offset for value, offset in zip(measured, offsets, strict=True))
        weights = (raw[0].graph.constant(1.0),) * len(raw)
        return cls(tuple(raw), tuple(raw), tuple(raw), (0.0,) * len(raw), values, weights, tuple(measured))


class Closing(NamedTuple):
    """What is summed at a solution, and what that is made of in stages: see `motes.fitting.printed.normal.NormalEquations`."""

    sums: tuple[Symbol, ...]
    stages: tuple[tuple[Symbol, ...], ...]


@dataclass(frozen=True)
class Traced:
    """A model for a fit: its graph with the residual's ingredients.

    Attributes
    ----------
    leaves
        With their bits: what the directions fix (`DIRECTIONS`: `root` and `cosine` among them), parameters and `noise` (`PARAMETERS`), data (`DATA`).
    outputs
        The transformed and weighted model, root T(f), for each channel; `slopes` its derivatives.
    offsets
        Those parts of the outputs that depend on directions alone: they are taken off the data.
    noise
        The size of a residual in units of which the robust function measures.
    bending
        Under a robust function: the least share of a residual's weight that a step takes for the curvature of the objective there.
    leverage
        Leaves for the (packed) inverse of the curvature.
    by_channel
        Whether each channel of a sample has a weight of its own.
    """

    leaves: dict[Symbol, int]
    parameters: tuple[Symbol, ...]
    outputs: tuple[Symbol, ...]
    slopes: tuple[dict[Symbol, Symbol], ...]
    offsets: tuple[Symbol, ...]
    data: Data
    robust: Robust
    noise: Symbol
    bending: Symbol
    leverage: tuple[Symbol, ...]
    by_channel: bool

    @classmethod
    def of(
        cls,
        trace: tracing.Trace,
        fitted: Sequence[str],
        loss: Loss,
        robust: Robust,
        by_channel: bool,
        whole: bool = False,
    ) -> Traced:
        """From the trace of a model (recorded without a look at the horizon) and the slots that are fitted; `whole`: nothing is missing (`Data.whole`)."""
        graph = trace.graph
        root, cosine, noise, bending = (graph.leaf(name) for name in ("root", "cosine", "noise", "bending"))
        raw = tuple(graph.leaf(f"raw[{c}]") for c in range(len(trace.outputs)))
        parameters = tuple(p.symbol for slot in fitted for p in trace.parameters if p.slot == slot)
        leverage = tuple(graph.leaf(f"leverage[{k}]") for k in range(len(parameters) * (len(parameters) + 1) // 2))
        leaves = trace.leaves()
        leaves |= {p.symbol: DIRECTIONS for p in trace.parameters if p.symbol not in parameters}
        leaves |= {root: DIRECTIONS, cosine: DIRECTIONS, noise: PARAMETERS, bending: PARAMETERS}
        leaves |= dict.fromkeys(leverage, PARAMETERS) | dict.fromkeys(raw, DATA)

        def transformed(f: Symbol) -> Symbol:
            return root * graph.lift(loss.transformed(graph, f, cosine))

        outputs = separation.gathered([transformed(f) for f in trace.outputs], leaves)
        zero = graph.constant(0.0)
        if loss.is_linear:
            slopes = tracing.forward(outputs, parameters)
            # What no parameter acts on, such as the dust of a layer that is held, is taken off the data.
            bits = tracing.dependence(outputs, leaves)
            plain = separation.unclamped(outputs, bits)
            terms = [separation.terms(output, tracing.dependence([output], leaves)) for output in plain]
            offsets = [row.get((), zero) for row in terms]
            bits = tracing.dependence(offsets, leaves)
            offsets = [offset if bits[offset] == DIRECTIONS else zero for offset in offsets]
        else:
            # The loss says what its slope is: that of the cube root is held near 0.
            offsets = [zero] * len(raw)
            slopes = [
                {p: t * (root * graph.lift(loss.sloped(graph, f, cosine))) for p, t in row.items()}
                for f, row in zip(trace.outputs, tracing.forward(trace.outputs, parameters), strict=True)
            ]
        measured = [transformed(y) for y in raw]
        targets = [y - offset for y, offset in zip(measured, offsets, strict=True)]
        if whole:
            data = Data.whole(raw, separation.gathered(measured, leaves), offsets)
        else:
            data = (Data.by_channel if by_channel else Data.by_sample)(graph, raw, targets, root)
        leaves |= dict.fromkeys(data.leaves, DATA)
        return cls(
            leaves,
            parameters,
            tuple(outputs),
            tuple(slopes),
            tuple(offsets),
            data,
            robust,
            noise,
            bending,
            leverage,
            by_channel,
        )

    @property
    def graph(self) -> Graph:
        return self.noise.graph

    def opening(self) -> list[Symbol]:
        """The square of the transformed values, and 1 for each."""
        data = self.data
        whole = data.measured or [v + w * o for v, w, o in zip(data.values, data.weights, self.offsets, strict=True)]
        return [total([v * v for v in whole]), total(data.weights)]

    def residuals(self) -> list[Symbol]:
        graph, data = self.graph, self.data
        wanted = [f - offset for f, offset in zip(self.outputs, self.offsets, strict=True)]
        if self.by_channel:
            return [graph.where(y <= y, f - y, 0.0) for f, y in zip(wanted, data.leaves, strict=True)]
        return [w * f - v for w, f, v in zip(data.weights, wanted, data.values, strict=True)]

    def jacobian(self) -> list[dict[Symbol, Symbol]]:
        """Derivatives of each channel's residual by the parameters, with the sample's weight; not with a channel's own (`by_channel`).

        Derivatives that all channels share are then one symbol, and their products are summed once.
        """
        rows = [
            list(row.values()) if self.by_channel else [s * w for s in row.values()]
            for row, w in zip(self.slopes, self.data.weights, strict=True)
        ]
        return [
            dict(zip(row, separation.gathered(values, self.leaves), strict=True))
            for row, values in zip(self.slopes, rows, strict=True)
        ]

    def sizes(self) -> list[Symbol]:
        """Squares of the residuals in units of the noise."""
        per_noise = 1.0 / (self.noise * self.noise)
        return [r * r * per_noise for r in self.residuals()]

    @property
    def is_robust(self) -> bool:
        return self.robust.name != "none"

    def clamped(self) -> Symbol:
        """1 where a clamp of the model acts that sums of moments leave out."""
        graph = self.graph
        inner = separation.clamps(self.outputs, tracing.dependence(self.outputs, self.leaves))
        if not inner:
            return graph.constant(0.0)
        least = inner[0]
        for value in inner[1:]:
            least = graph.minimum(least, value)
        return graph.where(least < 0, self.data.weights[0], 0.0)

    def unclamped(self) -> Traced:
        """Without clamps: the same wherever they do nothing."""
        outputs = separation.unclamped(self.outputs, tracing.dependence(self.outputs, self.leaves))
        return replace(self, outputs=tuple(outputs), slopes=tuple(tracing.forward(outputs, self.parameters)))

    def gradient(self, residuals: Sequence[Symbol], jacobian: Sequence[dict[Symbol, Symbol]]) -> list[Symbol]:
        """The sum over channels of the residual, as the robust function counts it, times its derivatives."""
        graph = self.graph
        if self.is_robust:
            slopes = [graph.lift(self.robust.sloped(graph, z)) for z in self.sizes()]
            residuals = [r * slope for r, slope in zip(residuals, slopes, strict=True)]
        return [
            self.weighted([(row[p], r) for r, row in zip(residuals, jacobian, strict=True) if p in row])
            for p in self.parameters
        ]

    def closing(
        self,
        clamped: Symbol,
        residuals: Sequence[Symbol] | None = None,
        jacobian: Sequence[dict[Symbol, Symbol]] | None = None,
    ) -> Closing:
        """See `motes.fitting.printed.normal.NormalEquations`; residuals and derivatives may be given in another form."""
        residuals = self.residuals() if residuals is None else residuals
        jacobian = self.jacobian() if jacobian is None else jacobian
        squares = [r * r for r in residuals]
        gradient = self.gradient(residuals, jacobian)
        weights, middle = self.middle(residuals, jacobian)
        sums = (total(squares), total([s * s for s in squares]), *gradient, *middle, clamped)
        return Closing(sums, ((*residuals, *(s for row in jacobian for s in row.values()), clamped), weights))

    def middle(
        self, residuals: Sequence[Symbol], jacobian: Sequence[dict[Symbol, Symbol]]
    ) -> tuple[tuple[Symbol, ...], list[Symbol]]:
        """The squares of residuals over what their leverage leaves of them, and these times J J' (packed): the middle of the sandwich (HC3).

        It takes most of the last pass.  What all channels share is computed once, leverages as Horner's nested sums, and one division serves
        several channels.
        """
        graph = self.graph
        order = sorted(
            range(len(self.parameters)), key=lambda k: len({row.get(self.parameters[k]) for row in jacobian}) == 1
        )
        left, wanted = [], []
        for r, z, row in zip(residuals, self.sizes(), jacobian, strict=True):
            leverage = self._leverage(row, order)
            if self.is_robust:
                leverage = leverage * graph.lift(self.robust.bent(graph, z))
                r = r * graph.lift(self.robust.sloped(graph, z))
            left.append(graph.maximum(1.0 - leverage, LEAST_REMAINDER))
            wanted.append(r)
        scaled = [r * inverse for r, inverse in zip(wanted, inverses(left), strict=True)]
        weights = tuple(s * s for s in scaled)
        return weights, self._weighed(jacobian, weights)

    def _leverage(self, row: dict[Symbol, Symbol], order: Sequence[int]) -> Symbol:
        """J' C J of a channel with `leverage` as C; what stands last in `order` is added up first."""
        present = [(k, row[self.parameters[k]]) for k in order if self.parameters[k] in row]
        result = self.graph.constant(0.0)
        for n, (i, slope) in reversed(list(enumerate(present))):
            onto = total(
                [self.leverage[packed(i, i)] * slope]
                + [(2.0 * self.leverage[packed(i, j)]) * other for j, other in present[n + 1 :]]
            )
            result = result + slope * onto
        return result

    def _weighed(self, jacobian: Sequence[dict[Symbol, Symbol]], weights: Sequence[Symbol]) -> list[Symbol]:
        """The sum over channels of weight J J', packed, for weights that differ: what channels share is taken out of their sums."""
        alike = {p for p in self.parameters if len({row.get(p) for row in jacobian}) == 1}
        found = []
        for i, p in enumerate(self.parameters):
            for q in self.parameters[: i + 1]:
                rows = [(row, w) for row, w in zip(jacobian, weights, strict=True) if p in row and q in row]
                if not rows:
                    found.append(self.graph.constant(0.0))
                    continue
                inner, outer = (p, q) if q in alike else (q, p)
                if inner in alike:
                    sums = rows[0][0][inner] * total([w for _, w in rows])
                elif outer in alike:
                    sums = total([row[inner] * w for row, w in rows])
                else:
                    found.append(total([(row[inner] * w) * row[outer] for row, w in rows]))
                    continue
                found.append(sums * rows[0][0][outer])
        return found

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


# So many numbers are inverted together: products of more, each of at least `LEAST_REMAINDER`, would leave what single precision holds.
TOGETHER = 4


def inverses(numbers: Sequence[Symbol]) -> list[Symbol]:
    """1 over each of some numbers between `LEAST_REMAINDER` and about 1, with one division for several."""
    found: list[Symbol] = []
    for first in range(0, len(numbers), TOGETHER):
        part = numbers[first : first + TOGETHER]
        products = [part[0]]
        for number in part[1:]:
            products.append(products[-1] * number)
        rest, backwards = 1.0 / products[-1], []
        for k in range(len(part) - 1, 0, -1):
            backwards.append(rest * products[k - 1])
            rest = rest * part[k]
        found += [rest, *reversed(backwards)]
    return found


def total(parts: Sequence[Symbol]) -> Symbol:
    """The sum of symbols."""
    result = parts[0]
    for part in parts[1:]:
        result = result + part
    return result
