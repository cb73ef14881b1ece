"""A compiled fit of texels, with what depends on directions and times alone."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes import workers
from motes.fitting.levenberg import FIRST_DAMPING, FIRST_GROWTH
from motes.fitting.losses import Floats, Robust
from motes.fitting.printed import module
from motes.fitting.printed.coefficients import Coefficients
from motes.fitting.printed.driver import NO_VERDICT, STATE
from motes.fitting.printed.normal import NormalEquations, Tables
from motes.fitting.printed.rows import LANES
from motes.fitting.printed.sums import UNROLL
from motes.fitting.quantities import columns_for
from motes.fitting.texel_cards import OnDevice, Wanted
from motes.fitting.texel_columns import Sampled
from motes.fitting.texel_setup import TexelSetup
from motes.graph import tracing
from motes.kernels import engine, jobs
from motes.kernels.assembly import LINE
from motes.models import describe
from motes.trends import KINDS

Singles = NDArray[np.float32]

MAX_ITERATIONS = 60
#: A texel has converged when a step promises less than this share of its objective; that step is taken, and one more by the gradient there.  Moments are
#: asked for more than they can tell, so that rounding decides; under a robust function what is left after a step is about as large as the step.
REDUCTION = {"moments": 1e-9, "direct": 1e-7, "series": 1e-7}
ROBUST_REDUCTION = 1e-10
TASK = (
    128 * LANES
)  # texels of one time that a thread takes; under trends fewer, so that all threads have work to the end
# Blocks with at most so many texels left hand them over to blocks of such texels; not worth it for few.
STRAGGLERS, FEW = LANES // 4, 8 * LANES
# The fewest times by which a fit of trends makes its first steps.
FEWEST_TIMES = 4
# Sums in float32 are rounded, from one point to the next, by about this share of their terms.
ROUNDING = 3e-7


@dataclass
class Raw:
    """What kernels return for texels.

    Attributes
    ----------
    points
        In the coordinates of the fit (M, P).
    values, errors, codes
        In the parameters' own units (M, P), float32, NaN where there is none; verdicts, uint8.
    states
        See `motes.fitting.printed.driver.STATE`.
    covariances
        Packed lower triangles (M, P(P+1)/2), in the coordinates of the fit; empty (M, 0) where not asked for.
    """

    points: Floats
    values: Singles
    errors: Singles
    codes: NDArray[np.uint8]
    states: Floats
    covariances: Singles

    @classmethod
    def at(cls, points: Floats, triangle: int) -> Raw:
        """Before a fit that starts from `points`."""
        count, size = points.shape
        states = np.zeros((count, len(STATE)))
        for name, value in (("damping", FIRST_DAMPING), ("growth", FIRST_GROWTH), ("running", 1.0)):
            states[:, STATE.index(name)] = value
        values, errors = (np.full((count, size), np.nan, np.float32) for _ in range(2))
        codes = np.full((count, size), NO_VERDICT, np.uint8)
        covariances = np.full((count, triangle), np.nan, np.float32)
        return cls(np.array(points, np.float64), values, errors, codes, states, covariances)

    def state(self, name: str) -> Floats:
        """A column of the states."""
        return self.states[:, STATE.index(name)]

    def apart(self, values: Floats, most: float) -> NDArray[np.bool_]:
        """Which texels (M,) are further than so many standard errors from values (M, P); where there is no error, at all."""
        with np.errstate(invalid="ignore"):
            return np.asarray((~(np.abs(values - self.values) <= most * np.nan_to_num(self.errors))).any(axis=1))

    def rows(self, rows: NDArray[np.intp]) -> Raw:
        """Some of the texels."""
        return Raw(**{name: part[rows] for name, part in vars(self).items()})

    def replace(self, rows: NDArray[np.intp], other: Raw) -> None:
        """Take over rows from other results."""
        for name, part in vars(self).items():
            part[rows] = getattr(other, name)


@dataclass(frozen=True)
class Recorded:
    """The model of a fit as a graph, and what it is at the fit's directions."""

    trace: tracing.Trace
    fitted: list[str]
    sampled: Sampled
    _found: dict[tuple[str, str], NormalEquations] = field(default_factory=dict)

    @classmethod
    def of(cls, fit: TexelSetup) -> Recorded:
        """Of what is asked for."""
        values = {
            q.name: (np.full(fit.channels, q.parameter.default) if q.per_channel else q.parameter.default)
            for q in fit.quantities
        }
        model = fit.brdf.with_parameters(values)
        fitted = [q.name for q in fit.quantities]
        squared = [q.name for q in fit.quantities if q.parameter.squared]
        trace = tracing.trace(model, fit.channels, horizon=False, squared=squared)
        return cls(trace, fitted, Sampled(trace, model, fitted, fit))

    def equations(self, fit: TexelSetup, form: str, robust: Robust) -> NormalEquations:
        """The normal equations in the form ``"direct"``, or in the ``"cheapest"`` of it and ``"moments"``; found once."""
        key = "direct" if form == "direct" else "cheapest", robust.name
        if key not in self._found:
            self._found[key] = module.equations(self.trace, self.fitted, fit.loss, robust, form)
        return self._found[key]

    def equations_of_whole(self, fit: TexelSetup, robust: Robust) -> NormalEquations | None:
        """Those in the form ``"series"`` where that is cheaper, which serves texels that miss nothing."""
        facts = columns_for(fit.quantities, fit.unit)  # of the parameters at a time
        bounds = {
            q.name: (float(facts.low[q.where.start, 0]), float(facts.high[q.where.start, 0])) for q in fit.quantities
        }
        others = partial(self.equations, fit, "cheapest", robust)
        given = self.trace, self.fitted, fit.loss, robust, self.sampled, bounds, len(fit.wi)
        return module.equations_of_whole(*given, others)


class Domain(NamedTuple):
    """Where series hold: columns of a texel's vector, their least and largest value, and whether these lie within the columns' own bounds.

    There are several under a trend: all that are values of the parameter, which is never beyond all of them (`motes.trends`).
    """

    columns: NDArray[np.intp]
    low: float
    high: float
    narrowed_low: bool
    narrowed_high: bool

    @classmethod
    def of(cls, fit: TexelSetup, equations: NormalEquations, tables: Tables, low: Floats, high: Floats) -> Domain:
        """That of a form, whose bounds become those of the columns (P,)."""
        place = equations.model.parameters.index(tables.parameter)
        (name,) = (q.name for q in fit.quantities if q.where.start == place)
        columns = np.array([k for k, c in enumerate(fit.columns) if c.quantity == name and c.value])
        first = columns[0]
        domain = cls(columns, tables.low, tables.high, bool(tables.low > low[first]), bool(tables.high < high[first]))
        low[columns], high[columns] = tables.low, tables.high
        return domain

    def inside(self, points: Floats, margin: float = 0.0) -> NDArray[np.bool_]:
        """Which points (M, P) are within, by more than a share of the width where there is a `margin`."""
        at, off = points[:, self.columns], margin * (self.high - self.low)
        return np.asarray(((at >= self.low + off) & (at <= self.high - off)).all(axis=1))

    def stopped(self, points: Floats) -> NDArray[np.bool_]:
        """Which points (M, P) stand where the series end, but the parameter does not."""
        at, margin = points[:, self.columns], 1e-6 * (self.high - self.low)
        low = self.low + margin if self.narrowed_low else -np.inf
        high = self.high - margin if self.narrowed_high else np.inf
        return np.asarray(((at <= low) | (at >= high)).any(axis=1))


class Kernel:
    """The module of a form of the normal equations."""

    def __init__(self, fit: TexelSetup, recorded: Recorded, equations: NormalEquations, robust: Robust) -> None:
        printed = module.module(equations, _coefficients(fit), fit.facts)
        self.form, self.source = printed.form, printed.source
        self._title = f"the fit of {describe(fit.brdf)} to texels"
        self.size, self.channels = fit.size, fit.channels
        self.times = 1 if fit.hours is None else len(fit.hours)
        self.given = len(fit.wi)
        self.samples = -(-self.given // UNROLL) * UNROLL
        self.columns = self._columns(printed.columns, recorded.sampled, equations.tables)
        self.basis = _basis(fit, equations.tables)
        facts = fit.facts
        low, high = facts.low[:, 0].copy(), facts.high[:, 0].copy()
        self.domain = None if equations.tables is None else Domain.of(fit, equations, equations.tables, low, high)
        whole = float(np.count_nonzero(fit.weights) * self.channels * self.times)
        numbers = np.array([REDUCTION[self.form] if robust.name == "none" else ROBUST_REDUCTION, ROUNDING, whole])
        self.box = np.concatenate(
            [
                low,
                high,
                facts.unit[:, 0],
                numbers,
                *(part[:, 0] for part in (facts.span, facts.least, facts.most, facts.rest)),
            ]
        )
        self.every = 1 if equations.tables is None else _every(fit)
        self.items = printed.layout.room(self.times, self.given, self.samples)
        self._device = fit.device
        self._driver: Callable[..., None] | None = None
        self._lock = threading.Lock()

    @property
    def driver(self) -> Callable[..., None]:
        """The compiled function; compiled when it is first asked for, since many fits have no texel for one of their forms."""
        with self._lock:  # threads that ask at once wait for the first
            if self._driver is None:
                self._driver = engine.module(self.source, self._title).fit
        compiled: Callable[..., None] = self._driver
        return compiled

    @cached_property
    def _elsewhere(self) -> OnDevice:
        """The same on the fit's device."""
        assert self._device is not None
        sizes = (self.times, self.given, self.samples)
        return OnDevice(self._device, self.source, sizes, self.items, (self.columns, self.basis))

    def _columns(self, symbols: tuple[tracing.Symbol, ...], sampled: Sampled, tables: Tables | None) -> Singles:
        """What depends on directions alone, a row each; 0 for samples that do not exist."""
        given = {} if tables is None else tables.columns
        rows = np.zeros((max(1, len(symbols)), self.samples), np.float32)
        plain = [k for k, symbol in enumerate(symbols) if symbol not in given]
        if plain and tables is not None:
            rows[plain] = sampled.columns([symbols[k] for k in plain], self.samples - self.given)
        elif plain:
            rows[plain, : self.given] = sampled.columns([symbols[k] for k in plain])
            # Any direction will do where there is none: what is kept of the data there counts for nothing.
            rows[:, self.given :] = rows[:, self.given - 1 : self.given]
        for k, symbol in enumerate(symbols):
            if symbol in given:
                rows[k, : self.given] = given[symbol]
        return rows

    # ------------------------------------------------------------ fits

    def fit(
        self,
        data: Singles,
        points: Floats,
        *,
        noise: Floats | None = None,
        held: NDArray[np.bool_] | None = None,
        covariance: bool = False,
        limit: int = MAX_ITERATIONS,
        reduction: float | None = None,
        close: bool = True,
    ) -> Raw:
        """Fit texels (M, [T,] D, C) from points (M, P).

        Parameters
        ----------
        noise
            Of each texel (M,), for robust functions.
        held
            Coefficients that stay as they are: (M, P), or (P,) for all texels.
        close
            Whether errors and verdicts are wanted.
        """
        raw = Raw.at(points, self.size * (self.size + 1) // 2 if covariance else 0)
        active = np.arange(len(data))
        every = self.every if limit == MAX_ITERATIONS else 1
        while len(active):
            whole = len(active) == len(data)
            leave = STRAGGLERS if len(active) > FEW else 0
            part = raw if whole else raw.rows(active)  # what the blocks before have left over, together
            self._run(
                data if whole else data[active],
                part,
                noise=noise if noise is None or whole else noise[active],
                held=held if held is None or held.ndim == 1 or whole else held[active],
                limit=limit,
                reduction=reduction,
                leave=leave,
                every=every,
                close=1 if close else 0,
            )
            if not whole:
                raw.replace(active, part)
            every = 1
            left = np.flatnonzero(raw.state("running") > 0)  # few: the other column is looked up for them alone
            active = left[raw.state("iterations")[left] < limit]
        return raw

    def diagonal(self, data: Singles, points: Floats, noise: Floats | None) -> Floats:
        """The diagonal of the curvature (M, P) at points."""
        raw = Raw.at(points, 0)
        self._run(data, raw, noise=noise, close=2)
        return raw.points

    def residuals(self, data: Singles, points: Floats) -> Singles:
        """The weighted residuals of texels (M, T D C) at points, NaN where there is no value; of a kernel with a robust function only."""
        per = self.times * self.given * self.channels
        blocks = np.empty((-(-len(data) // LANES), per, LANES), np.float32)
        self._run(data, Raw.at(points, 0), out=blocks)
        return blocks.transpose(0, 2, 1).reshape(-1, per)[: len(data)]

    def _run(
        self,
        data: Singles,
        raw: Raw,
        *,
        noise: Floats | None = None,
        held: NDArray[np.bool_] | None = None,
        limit: int = 0,
        reduction: float | None = None,
        leave: int = 0,
        every: int = 1,
        close: int = 0,
        out: Singles | None = None,
    ) -> None:
        box = self.box.copy()
        if reduction is not None:
            box[3 * self.size] = reduction
        units = np.ones(1) if noise is None else np.ascontiguousarray(noise, np.float64)
        holds = np.ascontiguousarray(np.zeros(self.size) if held is None else held, np.float64)
        if self._device is not None:
            results = (raw.points, raw.states, raw.values, raw.errors, raw.codes, raw.covariances)
            self._elsewhere.run(data, box, holds, units, Wanted(limit, every, close), results, out)
            return
        noise_step, held_step = int(noise is not None), self.size if holds.ndim == 2 else 0
        at, size, given = engine.address, self.size, self.times * self.given * self.channels
        # A thread that is one of several takes all that it has been given.
        together = LANES * max(2, TASK // (LANES * self.times)) if not workers.at_work() else max(1, len(data))
        triangle, driver = raw.covariances.shape[1], self.driver

        def work(task: int, room: NDArray[Any]) -> None:
            first, last = task * together, min(len(data), (task + 1) * together)
            driver(
                at(data) + 4 * first * given, self.times, self.given, self.samples, at(self.columns), self.columns.shape[1],
                at(self.basis), at(box), last - first, at(raw.points) + 8 * first * size, at(raw.states) + 8 * first * len(STATE),
                at(holds) + 8 * first * held_step, held_step, at(units) + 8 * first * noise_step, noise_step,
                limit, leave, every, close, at(raw.values) + 4 * first * size, at(raw.errors) + 4 * first * size, at(raw.codes) + first * size,
                at(raw.covariances) + 4 * first * triangle if triangle else 0,
                0 if out is None else at(out) + 4 * first * given, jobs.aligned(room),
            )  # fmt: skip

        workers.spread(-(-len(data) // together), work, lambda: np.empty(self.items + LINE // 8))


def _every(fit: TexelSetup) -> int:
    """A fit of trends makes its first steps by every so manieth time: by one more than a trend has coefficients, at least."""
    if not fit.parts:
        return 1
    needed = max(FEWEST_TIMES, 1 + max(len(KINDS[part.kind].coefficients) for part in fit.parts))
    return max(1, (fit.times or 1) // needed)


def _coefficients(fit: TexelSetup) -> Coefficients:
    """The parameters, or their squares where the model wants those, as functions of a texel's vector."""
    if not fit.parts:
        return Coefficients.themselves(fit.size)
    graph = tracing.Graph()
    leaves: list[tracing.Symbol] = []
    basis: dict[str, list[tracing.Symbol]] = {}
    values: list[tracing.Symbol] = []
    for part in fit.parts:
        kind = KINDS[part.kind]
        q = part.quantity
        own: list[int | None] = list(range(part.width)) if q.per_channel else [0]
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
            value = graph.lift(kind.formula(graph, list(columns), given))
            values.append(value * value if q.parameter.squared and not part.squared else value)
    return Coefficients(graph, tuple(leaves), tuple(b for columns in basis.values() for b in columns), tuple(values))


def _basis(fit: TexelSetup, tables: Tables | None) -> Floats:
    """What trends need of the times, (T, B) one after the other; then what series have that all texels share."""
    columns: list[Floats] = []
    if fit.parts:
        assert fit.hours is not None
        kinds = dict.fromkeys(part.kind for part in fit.parts)
        columns = [column for kind in kinds for column in KINDS[kind].basis(fit.hours, *fit.parts[0].interval)]
    shared = [0.0] if tables is None else list(tables.numbers.values())  # never an array without an address
    return np.concatenate([np.array(columns).T.ravel(), shared])
