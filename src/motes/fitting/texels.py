"""Fits of one model to very many texels that were measured at the same directions: the batched solver of the engine.

Every texel is a fit of its own; with trends, all its times together are.  The kernel is generated from the model (`motes.fitting.printed.normal`,
`motes.fitting.printed.lanes`) and compiled once.  What it cannot do, the losses with a logarithm or a cube root and very many coefficients, runs
through the solver of `motes.fit`, some thousand times slower.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes import workers
from motes.errors import DataError, MotesError
from motes.fitting.joint import Part
from motes.fitting.losses import loss_named
from motes.fitting.printed import covariance, lanes, normal
from motes.fitting.problem import Quantity, layout
from motes.graph import tracing
from motes.kernels import engine
from motes.kernels import numpy as numpy_code
from motes.models import BRDF, describe, parse
from motes.parameters import Parameter
from motes.trends import KINDS

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]

MAX_ITERATIONS = 60
#: A texel has converged when a step promises less than this share of its objective; the step is taken.
REDUCTION = 1e-5
# See `TexelSolver.bounds`.
FLAT = 1e-3
TASK = 128 * lanes.LANES  # texels that a thread takes at a time
# Blocks with at most so many texels left hand them over to blocks of such texels; not worth it for few.
STRAGGLERS, FEW = lanes.LANES // 4, 8 * lanes.LANES
# Objectives are rounded to about this share of the data's square: sums of moments cancel, sums of residuals do not.
ROUNDING = {"moments": 3e-7, "direct": 1e-10}


#: Coefficients of trends that are values of the parameter; the others are times and shares.
VALUE_COEFFICIENTS = ("value", "start", "end", "c0", "c1", "c2", "c3")


class TexelStatus(IntEnum):
    """How a texel's fit ended."""

    CONVERGED = 0
    MAX_ITERATIONS = 1
    NO_DATA = 2
    FAILED = 3


class Column(NamedTuple):
    """What a column of a parameter vector holds: a quantity, for a channel or all (None), and with trends which coefficient of its trend."""

    quantity: str
    channel: int | None
    coefficient: str | None
    parameter: Parameter


class TexelFit(NamedTuple):
    """Results by texel.

    Attributes
    ----------
    x, stderr
        Parameters and their standard errors (M, P), float32; NaN where there is no fit, or no error (at a bound, or not seen by the data).
    relative_rms
        Of the weighted residuals over that of the data (M,), float32.
    status, iterations
        (M,), uint8; see `TexelStatus`.
    """

    x: Singles
    stderr: Singles
    relative_rms: Singles
    status: NDArray[np.uint8]
    iterations: NDArray[np.uint8]


class TexelSolver:
    """Fits a model to texels that share directions (and times).

    Parameters
    ----------
    model
        Text (see `motes.models.parse`) or a BRDF.
    wi, wo
        Directions (D, 3), above the horizon.
    channels
        Number of channels.
    hours, trends
        Times (T,) and the kind of trend of each parameter by name (`motes.trends.KINDS`; what is not named is constant); None where every texel has one time.
    loss
        ``"linear"`` or ``"plain"`` are fast; see `motes.fitting.losses`.
    weights
        Of the directions (D,); None for all alike.
    fixed, per_channel
        As for `motes.fit`.

    Raises
    ------
    DataError, ParameterError
        For directions that are not above the horizon, shapes that do not fit, unknown names.
    """

    def __init__(
        self,
        model: str | BRDF,
        wi: ArrayLike,
        wo: ArrayLike,
        channels: int,
        *,
        hours: ArrayLike | None = None,
        trends: Mapping[str, str] | None = None,
        loss: str = "linear",
        weights: ArrayLike | None = None,
        fixed: Collection[str] | Mapping[str, Any] = (),
        per_channel: Collection[str] = (),
    ) -> None:
        self.wi, self.wo = _directions(wi, wo)
        self.channels = channels
        self.loss = loss_named(loss)
        self.brdf, self.quantities = _fitted(model, channels, fixed, per_channel)
        self.weights = _weights(weights, len(self.wi))
        self.hours, self.parts = _parts(self.quantities, hours, trends)
        self._solvers: dict[str, _Compiled] = {}

    # ------------------------------------------------------------ what is fitted

    @property
    def times(self) -> int | None:
        """The number of times that are fitted together; None without trends."""
        return None if self.hours is None else len(self.hours)

    @cached_property
    def columns(self) -> tuple[Column, ...]:
        """What the columns of the parameter vectors hold."""
        columns: list[Column] = []
        for q, part in zip(self.quantities, self.parts or [None] * len(self.quantities), strict=True):
            own = list(range(q.where.stop - q.where.start)) if q.per_channel else [None]
            if part is None:
                columns += [Column(q.name, c, None, q.parameter) for c in own]
            else:
                for k in KINDS[part.kind].coefficients:
                    columns += [Column(q.name, c, k.name, q.parameter) for c in ([None] if k.bounds else own)]
        return tuple(columns)

    @property
    def size(self) -> int:
        """The number of columns, P."""
        return len(self.columns)

    @cached_property
    def bounds(self) -> tuple[Floats, Floats]:
        """Lower and upper bounds (P,): the parameters' fit bounds, but `FLAT` of the typical range inside where the slope is 0 at a lower bound."""
        if self.parts:
            pairs = [part.bounds() for part in self.parts]
            low, high = np.concatenate([p[0] for p in pairs]), np.concatenate([p[1] for p in pairs])
        else:
            spans = [column.parameter.fit_bounds for column in self.columns]
            low, high = np.array([s[0] for s in spans], float), np.array([s[1] for s in spans], float)
        for k, column in enumerate(self.columns):
            if column.quantity in self._flat_at_low and low[k] == column.parameter.fit_bounds[0]:
                low[k] += FLAT * (column.parameter.typical[1] - column.parameter.typical[0])
        return low, high

    @cached_property
    def _flat_at_low(self) -> frozenset[str]:
        """Quantities by which the model has no slope at their lower bound, as by sigma_d at 0: a fit that lands there never leaves."""
        names = [q.name for q in self.quantities]
        function = numpy_code.residual_function(self.brdf, names, horizon=False)
        geometry = function.geometry(self.wi, self.wo)
        values = {slot.name: np.mean(slot.value) for slot in self.brdf.slots()}
        flat = set()
        for q in self.quantities:
            at = values | {q.name: q.parameter.fit_bounds[0]}
            slope = function.values_and_jacobian(geometry, at)[1][q.name]
            if np.all(slope == 0):
                flat.add(q.name)
        return frozenset(flat)

    # ------------------------------------------------------------ fits

    def fit(self, values: ArrayLike, starts: ArrayLike, *, own_starts: bool = False) -> TexelFit:
        """Fit every texel.

        Parameters
        ----------
        values
            Measured BRDF [1/sr] (M, D, C), with trends (M, T, D, C), float32; a sample with a channel that is NaN or infinite is left out.
        starts
            Parameter vectors (K, P): each texel starts from the one of them that suits it best.  With `own_starts` (M, P): each texel its own.

        Returns
        -------
        TexelFit
            Bit for bit the same for a texel whatever else is in the call, and for any number of threads.
        """
        data = self._checked(values)
        points = np.atleast_2d(np.asarray(starts, float))
        if points.ndim != 2 or points.shape[1] != self.size or (own_starts and len(points) != len(data)):
            expected = f"({len(data) if own_starts else 'K'}, {self.size})"
            raise DataError(f"starts of shape {np.shape(starts)} do not fit", f"Give an array of shape {expected}")
        if not np.isfinite(points).all():
            raise DataError("starts hold a value that is not finite", "Give parameter vectors within the bounds")
        if not self.compiled:
            from motes.fitting.texels_slow import fit_slowly

            return fit_slowly(self, data, points, own_starts)
        points = np.clip(points, *self.bounds)
        solver = self._solver("cheapest")
        chosen = points if own_starts else solver.best_start(data, points, self._curved())
        result = solver.fit(data, chosen)
        if not own_starts and len(points) > 1:
            self._tried_elsewhere(solver, data, points, result)
        clamped = np.flatnonzero(result.clamped)
        if len(clamped):
            # The model clamps a sample of these at 0, which the moments do not know of.
            near = np.where(np.isfinite(result.x[clamped]), result.x[clamped], chosen[clamped])
            result.replace(clamped, self._solver("direct").fit(data[clamped], near))
        return self.finished(result)

    @property
    def compiled(self) -> bool:
        """Whether a kernel serves this fit."""
        return self.loss.name in ("linear", "plain") and self.size <= lanes.MOST_COEFFICIENTS and engine.available()

    def _checked(self, values: ArrayLike) -> Singles:
        data = np.ascontiguousarray(values, np.float32)
        times = () if self.hours is None else (len(self.hours),)
        shape = (*times, len(self.wi), self.channels)
        if data.ndim != len(shape) + 1 or data.shape[1:] != shape:
            raise DataError(
                f"values of shape {data.shape} do not fit the directions, times and channels",
                f"Expected (M, {', '.join(map(str, shape))})",
            )
        return data

    def _tried_elsewhere(self, solver: _Compiled, data: Singles, starts: Floats, result: Raw) -> None:
        """Fit texels that ended at a bound of a curved column from all starts, and keep what is best.

        A highlight of the least width allowed is mostly a false minimum: a spike at one sample.
        """
        low, high = self.bounds
        with np.errstate(invalid="ignore"):
            margin = 1e-6 * (1 + np.abs(result.x))
            stuck = (result.x <= low + margin) | (result.x >= high - margin)
        rows = np.flatnonzero((stuck & self._curved()).any(axis=1))
        if not len(rows):
            return
        part = data[rows]
        for start in starts:
            again = solver.fit(part, np.repeat(start[None], len(rows), axis=0))
            better = np.flatnonzero(again.squares < result.squares[rows] * (1 - 1e-6))
            result.replace(rows[better], again.rows(better))

    def _curved(self) -> NDArray[np.bool_]:
        """The columns along which an objective has several valleys: those that `best_start` holds."""
        values = (None, *VALUE_COEFFICIENTS)
        return np.array([bool(c.parameter.starts) or c.coefficient not in values for c in self.columns])

    def finished(self, raw: Raw) -> TexelFit:
        samples = raw.samples
        free = np.maximum(samples - self.size, 1)
        with np.errstate(all="ignore"):
            rms = np.sqrt(raw.squares / raw.brightness)
            stderr = raw.errors * np.sqrt(samples / free)[:, None]
        status = np.where(raw.running, TexelStatus.MAX_ITERATIONS, TexelStatus.CONVERGED)
        status[~np.isfinite(raw.x).all(axis=1) | ~np.isfinite(rms)] = TexelStatus.FAILED
        empty = (samples <= self.size) | (raw.brightness == 0)
        status[empty] = TexelStatus.NO_DATA
        gone = np.isin(status, (TexelStatus.NO_DATA, TexelStatus.FAILED))
        x, rms = np.where(gone[:, None], np.nan, raw.x), np.where(gone, np.nan, rms)
        return TexelFit(
            x.astype(np.float32),
            np.where(gone[:, None], np.nan, stderr).astype(np.float32),
            rms.astype(np.float32),
            status.astype(np.uint8),
            np.minimum(raw.iterations, 255).astype(np.uint8),
        )

    def _solver(self, form: str) -> _Compiled:
        if form not in self._solvers:
            self._solvers[form] = _Compiled(self, form)
        return self._solvers[form]

    def starts(self, values: ArrayLike) -> Floats:
        """Where fits of texels like these start well: up to six parameter vectors (K, P), from full searches on each of a few texels.

        Parameters
        ----------
        values
            As for `fit`, of some texels (a few dozen) from all over a map.
        """
        from motes.fitting.texels_starts import representative_starts

        return representative_starts(self, self._checked(values))


# ---------------------------------------------------------------- the compiled solver


@dataclass
class Raw:
    """What solvers return for texels: parameters, errors before the factor for the degrees of freedom, whether the limit of iterations ended
    them, samples, sums of squares of the data and of the residuals, and whether a clamp of the model acts that the solver does not know of."""

    x: Floats
    errors: Floats
    running: NDArray[np.bool_]
    iterations: NDArray[np.int64]
    samples: Floats
    brightness: Floats
    squares: Floats
    clamped: NDArray[np.bool_]

    @classmethod
    def empty(cls, count: int, size: int) -> Raw:
        """Nothing fitted yet."""
        return cls(
            x=np.full((count, size), np.nan),
            errors=np.full((count, size), np.nan),
            running=np.zeros(count, bool),
            iterations=np.zeros(count, np.int64),
            samples=np.zeros(count),
            brightness=np.zeros(count),
            squares=np.zeros(count),
            clamped=np.zeros(count, bool),
        )

    def rows(self, rows: NDArray[np.intp]) -> Raw:
        """Some of the texels."""
        return Raw(**{name: part[rows] for name, part in vars(self).items()})

    def replace(self, rows: NDArray[np.intp], other: Raw) -> None:
        """Take over rows from other results."""
        for name, part in vars(self).items():
            part[rows] = getattr(other, name)


class _Compiled:
    """A kernel with what depends on directions and times alone."""

    def __init__(self, fit: TexelSolver, form: str) -> None:
        values = {
            q.name: (np.full(fit.channels, q.parameter.default) if q.per_channel else q.parameter.default)
            for q in fit.quantities
        }
        model = fit.brdf.with_parameters(values)
        fitted = [q.name for q in fit.quantities]
        trace = tracing.trace(model, fit.channels, horizon=False)
        traced = normal.Traced.of(trace, fitted)
        equations = normal.direct(traced) if form == "direct" else normal.cheapest(traced)
        printed = lanes.solver(equations, _coefficients(fit))
        self.form = printed.form
        self.source = printed.source
        self.driver = engine.module(printed.source, f"the fit of {describe(fit.brdf)} to texels", [covariance]).fit
        self.size, self.channels = fit.size, fit.channels
        self.times = 1 if fit.hours is None else len(fit.hours)
        self.given = len(fit.wi)
        self.samples = -(-self.given // lanes.UNROLL) * lanes.UNROLL
        cosine = fit.wi[:, 2] if fit.loss.name == "linear" else np.ones(self.given)
        scale = np.sqrt(fit.weights) * cosine
        self.scale = scale.astype(np.float32)
        self.columns, self.offsets = (
            self._rows(symbols, trace, traced, model, fit, scale) for symbols in (printed.columns, printed.offsets)
        )
        self.basis = _basis(fit)
        self.low, self.high = fit.bounds
        self.items = printed.room + lanes.LANES * self.times * (
            len(equations.opening) + -(-self.samples * (self.channels + 1) // 2)
        )

    def _rows(
        self,
        symbols: tuple[tracing.Symbol, ...],
        trace: tracing.Trace,
        traced: normal.Traced,
        model: BRDF,
        fit: TexelSolver,
        scale: Floats,
    ) -> Singles:
        """What depends on directions alone, a row each."""
        held = [p for p in trace.parameters if p.symbol not in traced.parameters]
        leaves = {leaf: f"d{k}" for k, leaf in enumerate(trace.directions)}
        leaves[trace.graph.leaf("scale")] = "scale"
        leaves |= {p.symbol: f"p{k}" for k, p in enumerate(held)}
        slots = {slot.name: slot for slot in model.slots()}
        numbers = [np.ravel(slots[p.slot].value)[p.channel or 0] for p in held]
        function = numpy_code.scalar_function("rows", leaves, symbols)
        with np.errstate(all="ignore"):
            results = function(*fit.wi.T, *fit.wo.T, scale, *map(float, numbers))
        rows = np.zeros((max(1, len(results)), self.samples), np.float32)
        for row, result in zip(rows, results, strict=False):
            row[: self.given] = result
            row[self.given :] = row[self.given - 1]
        return rows

    def best_start(self, data: Singles, starts: Floats, curved: NDArray[np.bool_]) -> Floats:
        """For every texel the start from which the parameters that are not `curved` alone get closest to the data."""
        if len(starts) == 1:
            return np.repeat(starts, len(data), axis=0)
        best = np.empty((len(data), self.size))
        least = np.full(len(data), np.inf)
        for start in starts:
            points = np.repeat(start[None], len(data), axis=0)
            states = self._states(len(data))
            self._run(data, points, states, np.empty_like(points), fixed=curved, limit=3, leave=0, close=False)
            objective = np.nan_to_num(states[:, 9], nan=np.inf)
            better = objective < least
            best[better], least[better] = start, objective[better]
            best[better] = np.where(np.isfinite(points[better]), points[better], start)
        best[~np.isfinite(least)] = starts[0]
        return best

    def fit(self, data: Singles, points: Floats) -> Raw:
        points = np.array(points, np.float64)
        states, errors = self._states(len(data)), np.full(points.shape, np.nan)
        active = np.arange(len(data))
        while len(active):
            leave = STRAGGLERS if len(active) > FEW else 0
            if len(active) == len(data):
                self._run(data, points, states, errors, fixed=None, limit=MAX_ITERATIONS, leave=leave, close=True)
            else:  # what the blocks before have left over, together
                x, state, error = points[active], states[active], errors[active]
                self._run(data[active], x, state, error, fixed=None, limit=MAX_ITERATIONS, leave=leave, close=True)
                points[active], states[active], errors[active] = x, state, error
            active = np.flatnonzero((states[:, 3] > 0) & (states[:, 4] < MAX_ITERATIONS))
        return Raw(
            points,
            errors,
            states[:, 3] > 0,
            states[:, 4].astype(np.int64),
            states[:, 5],
            states[:, 6],
            states[:, 7],
            states[:, 8] > 0,
        )

    @staticmethod
    def _states(count: int) -> Floats:
        states = np.zeros((count, len(lanes.STATE)))
        states[:, 0], states[:, 1], states[:, 3] = 1e-3, 2.0, 1.0
        return states

    def _run(
        self,
        data: Singles,
        points: Floats,
        states: Floats,
        errors: Floats,
        *,
        fixed: NDArray[np.bool_] | None,
        limit: int,
        leave: int,
        close: bool,
    ) -> None:
        held = np.zeros(self.size) if fixed is None else fixed.astype(float)
        box = np.concatenate([self.low, self.high, held, [REDUCTION, ROUNDING[self.form]]])
        at = engine.address
        row = self.given * self.channels * self.times

        def work(task: int, room: NDArray[Any]) -> None:
            first, last = task * TASK, min(len(data), (task + 1) * TASK)
            self.driver(
                at(data) + 4 * first * row, self.times, self.given, self.samples, at(self.scale), at(self.columns), self.columns.shape[1],
                at(self.basis), at(box), last - first, at(points) + 8 * first * self.size, at(errors) + 8 * first * self.size,
                at(states) + 8 * first * states.shape[1], limit, leave, int(close), at(room), at(self.offsets),
            )  # fmt: skip

        workers.spread(-(-len(data) // TASK), work, lambda: np.empty(self.items))


def _coefficients(fit: TexelSolver) -> lanes.Coefficients:
    """The parameters as functions of a texel's vector."""
    if not fit.parts:
        return lanes.Coefficients.themselves(fit.size)
    graph = tracing.Graph()
    leaves: list[tracing.Symbol] = []
    basis: dict[str, list[tracing.Symbol]] = {}
    values: list[tracing.Symbol] = []
    for part in fit.parts:
        kind = KINDS[part.kind]
        q = part.quantity
        own = range(part.width) if q.per_channel else [0]
        symbols: dict[str, list[tracing.Symbol]] = {}
        for coefficient in kind.coefficients:
            for c in [None] if coefficient.bounds else own:
                leaf = graph.leaf(f"{q.name}.{coefficient.name}[{c}]")
                symbols.setdefault(coefficient.name, []).append(leaf)
                leaves.append(leaf)
        count = len(kind.basis(np.zeros(1), 0.0, 1.0))
        columns = basis.setdefault(part.kind, [graph.leaf(f"{part.kind}.basis[{k}]") for k in range(count)])
        for c in range(part.width):
            given = [symbols[k.name][0 if k.bounds else c] for k in kind.coefficients]
            values.append(graph.lift(kind.formula(graph, list(columns), given)))
    return lanes.Coefficients(
        graph, tuple(leaves), tuple(b for columns in basis.values() for b in columns), tuple(values)
    )


def _basis(fit: TexelSolver) -> Floats:
    """What trends need of the times: (T, B)."""
    if not fit.parts:
        return np.zeros((1, 1))
    assert fit.hours is not None
    kinds = dict.fromkeys(part.kind for part in fit.parts)
    interval = fit.parts[0].interval
    columns = [column for kind in kinds for column in KINDS[kind].basis(fit.hours, *interval)]
    return np.ascontiguousarray(np.stack(columns, axis=1))


# ---------------------------------------------------------------- checks


def _directions(wi: ArrayLike, wo: ArrayLike) -> tuple[Floats, Floats]:
    pair = []
    for name, w in (("wi", wi), ("wo", wo)):
        array = np.ascontiguousarray(w, np.float64)
        if array.ndim != 2 or array.shape[1] != 3 or not len(array):
            raise DataError(f"{name} has shape {array.shape}", "Pass directions (D, 3)")
        off = np.abs(np.linalg.norm(array, axis=1) - 1)
        if not (off < 1e-3).all():
            raise DataError(
                f"{name} holds a vector of length {np.linalg.norm(array[np.argmax(off)]):.4g}, not 1", "Normalise it"
            )
        if not (array[:, 2] > 0).all():
            raise DataError(
                f"{int(np.count_nonzero(array[:, 2] <= 0))} direction(s) of {name} are at or below the horizon",
                "Leave them out",
            )
        pair.append(array / np.linalg.norm(array, axis=1, keepdims=True))
    if len(pair[0]) != len(pair[1]):
        raise DataError(f"{len(pair[0])} directions wi and {len(pair[1])} directions wo", "They come in pairs")
    return pair[0], pair[1]


def _fitted(
    model: str | BRDF, channels: int, fixed: Collection[str] | Mapping[str, Any], per_channel: Collection[str]
) -> tuple[BRDF, tuple[Quantity, ...]]:
    brdf, held = (model, frozenset[str]()) if isinstance(model, BRDF) else parse(model)
    names = [slot.name for slot in brdf.slots()]
    for name in (*fixed, *per_channel):
        if name not in names:
            raise MotesError(f"{describe(brdf)} has no parameter {name!r}", f"It has {', '.join(names)}")
    if isinstance(fixed, Mapping):
        brdf = brdf.with_parameters(dict(fixed))
    quantities = layout(brdf, channels, held | frozenset(fixed), frozenset(per_channel))
    if not quantities:
        raise MotesError(
            f"every parameter of {describe(brdf)} is held, so there is nothing to fit", "Hold fewer parameters"
        )
    if channels < 1:
        raise DataError(f"{channels} channels", "A texel has at least one")
    return brdf, quantities


def _weights(weights: ArrayLike | None, count: int) -> Floats:
    given = np.ones(count) if weights is None else np.asarray(weights, float)
    if given.shape != (count,) or not np.isfinite(given).all() or (given < 0).any() or not given.any():
        raise DataError(f"weights of shape {given.shape} do not fit", f"Give {count} numbers >= 0, not all 0")
    return given / given.mean()


def _parts(
    quantities: tuple[Quantity, ...], hours: ArrayLike | None, trends: Mapping[str, str] | None
) -> tuple[Floats | None, tuple[Part, ...]]:
    if hours is None:
        if trends:
            raise DataError("trends need the times of the data", "Pass hours=")
        return None, ()
    times = np.asarray(hours, float)
    trends = trends or {}
    if times.ndim != 1 or len(times) < 2 or not (np.diff(times) > 0).all() or not np.isfinite(times).all():
        raise DataError(
            f"hours {np.array2string(times, threshold=6)} do not go forward", "Give two or more rising times"
        )
    names = [q.name for q in quantities]
    for name, kind in trends.items():
        if name not in names:
            raise MotesError(f"no fitted parameter {name!r} to have a trend", f"Those fitted are {', '.join(names)}")
        if kind not in KINDS:
            raise MotesError(f"trend {kind!r} is not one of {', '.join(KINDS)}")
    interval = (float(times[0]), float(times[-1]))
    if math.isclose(*interval):
        raise DataError("all hours are the same", "Fit without trends")
    return times, tuple(Part(q, trends.get(q.name, "constant"), interval) for q in quantities)
