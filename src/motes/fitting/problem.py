"""A fit as a least-squares problem: many parameter vectors at once in, objectives, gradients and normal matrices out.

Parameters are *shared* (sigma_d) or *per channel* (K_d), so the normal matrix is an arrow: a small block for each
channel and a border of shared ones.  It is built from one (K, K) product for each channel, with K = per-channel +
shared parameters, never from a dense Jacobian.  Inside, the directions are the last axis: with a few channels there, NumPy
takes twice as long."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from copy import copy
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from motes.arrays import dot
from motes.fitting.algebra import ARRAYS, Arrays
from motes.fitting.arrowhead import Arrowhead
from motes.fitting.by_functions import ByFunctions
from motes.fitting.channel_layout import ChannelLayout
from motes.fitting.channels_among_many import CHANNELS, rise_among_channels
from motes.fitting.columns import Columns
from motes.fitting.covariance import LEAST_REMAINDER
from motes.fitting.data_passes import directions_first, directions_last, in_passes, rows_of, transformed
from motes.fitting.even_weights import count, rooted, roots_of, same_in_channels, taken
from motes.fitting.losses import Floats, Loss, Robust
from motes.fitting.objective import Objective
from motes.fitting.quantities import Quantity, columns_for
from motes.fitting.solver import Normal
from motes.kernels.numpy import FitFunction, residual_function
from motes.kernels.separated import Seen, Separated, separated
from motes.models import BRDF

Part = TypeVar("Part")
Vector = TypeVar("Vector", Floats, NDArray[np.bool_])
# Elements (parameter sets x samples x channels) of a pass worked on at a time: few enough for the cache, enough that NumPy's overhead does not show.
CHUNK = 1 << 17


@dataclass(frozen=True)
class Problem(Objective):
    """Data, loss and layout of a fit.

    Parameters
    ----------
    model
        The form of the BRDF.
    quantities
        What is fitted, in the order of the parameter vector (P,), each in its coordinate (`Quantity.coordinate`).
    fixed
        Values of the other parameters, to broadcast against (B, N, C).
    wi, wo
        Directions (N, 3), all above the horizon.
    values, weights
        Measured BRDF and weights (N, C), or (T, N, C) for T data sets at the same directions; the weight is 0 where
        masked, and the value is finite everywhere.
    common
        A relative uncertainty that all values share: of the scale.
    unit
        That of the values: `motes.fitting.columns.unit_of`.
    loss, robust, scale
        The residuals' transform; the robust function, and the noise in units of which it measures residuals.
    """

    model: BRDF
    quantities: tuple[Quantity, ...]
    fixed: Mapping[str, Floats | float]
    wi: Floats
    wo: Floats
    values: Floats
    weights: Floats
    loss: Loss
    robust: Robust
    scale: float = 1.0
    common: float = 0.0
    unit: float = 1.0
    _function: FitFunction = field(init=False)
    _separated: Separated | None = field(init=False)
    _cosines: Floats = field(init=False)
    _targets: Floats = field(init=False)
    _roots: Floats = field(init=False)

    def __post_init__(self) -> None:
        squared = [q.name for q in self.quantities if q.parameter.squared]
        own = [q.name for q in self.quantities if q.per_channel and self.channels > 1]
        own += [name for name, value in self.fixed.items() if np.size(value) > 1]
        fitted = [q.name for q in self.quantities]
        function = residual_function(self.model, fitted, horizon=False, squared=squared, per_channel=own)
        made = separated(self.model, fitted, squared=squared, per_channel=own) if self.loss.is_linear else None
        cosines = np.ascontiguousarray(self.wi[:, 2])
        for name, value in (
            ("_function", function),
            ("_separated", made),
            ("_cosines", cosines),
            ("_targets", transformed(self.loss, self.values, cosines)),
            ("_roots", roots_of(self.weights)),
        ):
            object.__setattr__(self, name, value)

    @cached_property
    def _columns(self) -> tuple[Floats, ...]:
        return tuple(column[:, 0] for column in self._function.geometry(self.wi, self.wo))

    @cached_property
    def _by_functions(self) -> ByFunctions | None:
        """The sums of a fit in another way; None where the model, the loss or the weights do not allow it."""
        made, roots = self._separated, self._roots
        if made is None or self.robust.name != "none" or self.values.ndim != 2 or not same_in_channels(roots):
            return None
        fixed, columns, sure = self._functions
        if made.clamped and not sure:
            return None
        slope = self.loss.slope(np.zeros(()), self._cosines)
        return ByFunctions(made, fixed, columns, roots[0] * slope, self._weighted, self.layout)

    @cached_property
    def _functions(self) -> Seen:
        assert self._separated is not None
        return self._separated.geometry(self.wi, self.wo)

    def seen_from(self, whole: Problem, rows: NDArray[np.intp]) -> None:
        """Take what depends on the directions alone from a problem of the same model at more of them."""
        if whole._by_functions is not None and self._separated is not None:
            fixed, columns, sure = whole._functions
            self.__dict__["_functions"] = Seen(fixed.take(rows, 1), tuple(c.take(rows) for c in columns), sure)

    @property
    def channels(self) -> int:
        return int(self.values.shape[-1])

    @property
    def size(self) -> int:
        """The number of fitted values, P."""
        return self.quantities[-1].where.stop if self.quantities else 0

    @property
    def samples(self) -> int:
        return count(self.weights)

    @cached_property
    def columns(self) -> Columns:
        return columns_for(self.quantities, self.unit)

    @cached_property
    def algebra(self) -> Arrays:
        if self.size <= CHANNELS:
            return ARRAYS
        own = [np.arange(q.where.start, q.where.stop) for q in self.quantities if q.per_channel]
        shared = np.array([q.where.start for q in self.quantities if not q.per_channel], np.intp)
        return Arrowhead(np.stack(own, axis=1), shared) if own else ARRAYS

    @property
    def groups(self) -> list[slice]:
        return [q.where for q in self.quantities]

    def brightness(self) -> Floats:
        return self._brightness

    @cached_property
    def _brightness(self) -> Floats:
        if self.values.ndim == 2:
            return np.array([dot(self._weighted, self._weighted)])
        return np.atleast_1d(np.square(self._roots * self._targets).sum(axis=(-2, -1)))

    @cached_property
    def _weighted(self) -> Floats:
        """What residuals are taken from (C, N), in their units."""
        return rooted(self._roots, self._targets)

    def labels(self, channels: tuple[str, ...]) -> tuple[str, ...]:
        """A name for each fitted value: ``K_d[R]``, ``sigma_d``."""
        names = (
            [f"{q.name}[{channel}]" for channel in channels] if q.per_channel else [q.name] for q in self.quantities
        )
        return tuple(name for some in names for name in some)

    def _with(self, **changes: Any) -> Self:
        """A copy with other attributes, what is computed of the directions among them; without what was found so far."""
        other = copy(self)
        for name in ("_brightness", "_last", "_by_functions", "_weighted"):
            other.__dict__.pop(name, None)
        for name, value in changes.items():
            object.__setattr__(other, name, value)
        return other

    def with_scale(self, robust: Robust, scale: float) -> Self:
        """The same data under a robust function."""
        return self._with(robust=robust, scale=scale)

    def at_directions(self, rows: NDArray[np.intp]) -> Self:
        other = self._with(
            wi=self.wi.take(rows, axis=0),
            wo=self.wo.take(rows, axis=0),
            values=self.values.take(rows, axis=-2),
            weights=taken(self.weights, rows, -2),
            _cosines=self._cosines[rows],
            _targets=self._targets.take(rows, axis=-1),
            _roots=taken(self._roots, rows, -1),
        )
        other.__dict__.pop("_functions", None)
        if "_columns" in self.__dict__:  # what is not known of the directions yet may never be asked for
            other.__dict__["_columns"] = tuple(c.take(rows) if len(c) > 1 else c for c in self._columns)
        other.seen_from(self, rows)
        return other

    def counting(self, times: Floats) -> Self:
        return self._with(weights=self.weights * times[:, None], _roots=self._roots * np.sqrt(times))

    def weighing(self, weights: Floats) -> Self:
        """The same data with other weights (N, C), or with several, (T, N, C)."""
        return self._with(weights=weights, _roots=roots_of(weights))

    def some_channels(self, channels: NDArray[np.intp]) -> Self:
        """The problem at some of the channels."""
        quantities, start = [], 0
        for q in self.quantities:
            stop = start + (len(channels) if q.per_channel else 1)
            quantities.append(q._replace(where=slice(start, stop)))
            start = stop
        fixed: dict[str, Floats | float] = {}
        for name, held in self.fixed.items():
            value = np.asarray(held)
            fixed[name] = value[..., channels] if value.ndim and value.shape[-1] == self.channels else held
        values, weights = self.values[..., channels], self.weights[..., channels]
        return replace(self, quantities=tuple(quantities), fixed=fixed, values=values, weights=weights)

    def at_channels(self, x: Vector, channels: NDArray[np.intp]) -> Vector:
        """The parameter vector (P,) of `some_channels`, or what goes with it."""
        return np.concatenate([x[q.where][channels] if q.per_channel else x[q.where] for q in self.quantities])

    def between_channels(self, part: Problem, x: Floats, channels: NDArray[np.intp]) -> Floats:
        """A parameter vector (P,) out of one of `some_channels`, linear between them."""
        everywhere = np.arange(self.channels)
        parts = ((x[own.where], own.per_channel) for own in part.quantities)
        return np.concatenate([np.interp(everywhere, channels, own) if each else own for own, each in parts])

    # ------------------------------------------------------------ evaluation

    def normal(self, x: Floats, sets: NDArray[np.intp] | None = None) -> Normal:
        """Objectives and normal equations for parameter vectors ``x`` (B, P).

        ``sets`` (B,) says which of T data sets each vector belongs to."""
        if len(x) == 1 and sets is None and self.size <= CHANNELS:  # 2,151 bands: a matrix is 37 MB
            return self.once("normal", x, lambda: self._normal(x, None))
        return self._normal(x, sets)

    def _normal(self, x: Floats, sets: NDArray[np.intp] | None) -> Normal:
        if sets is None and self._by_functions is not None:
            return self._by_functions.normal(self._by_channel(x), len(x))
        results = self._mapped(lambda rows: self._normal_part(x, rows, sets), len(x))
        if len(results) == 1:
            return Normal(*results[0])
        return Normal(*(np.sum(parts, axis=0) for parts in zip(*results, strict=True)))

    def predicted(self, x: Floats) -> Floats:
        """The BRDF (N, C) [1/sr] for one parameter vector (P,)."""
        return directions_first(self._predicted(x))

    def _predicted(self, x: Floats) -> Floats:
        """The same as (C, N)."""

        def everywhere() -> Floats:
            if self._by_functions is not None:
                return self._by_functions.predicted(self._by_channel(x[None]))
            return np.concatenate(self._mapped(lambda rows: self._f(x[None], rows)[0], 1), axis=-1)

        return self.once("predicted", x, everywhere)

    def _f(self, x: Floats, rows: slice) -> Floats:
        return self._broadcast(self._function.values(self._rows(rows), self._arguments(x)), rows, len(x))

    def residuals(self, x: Floats) -> Floats:
        """Weighted residuals (N, C) for one parameter vector (P,); 0 where masked."""
        return rooted(self._roots, self.loss.transform(self._predicted(x), self._cosines) - self._targets).T

    def misfits(self, x: Floats, sets: NDArray[np.intp] | None = None) -> Floats:
        """Weighted residuals (B, C, N) for parameter vectors (B, P), each of its data set."""

        def part(rows: slice) -> Floats:
            apart = self.loss.transform(self._f(x, rows), self._cosines[rows]) - rows_of(self._targets, rows, sets)
            return np.asarray(rows_of(self._roots, rows, sets) * apart)

        return np.concatenate(self._mapped(part, len(x)), axis=-1)

    @property
    def directions(self) -> tuple[Floats, Floats]:
        return self.wi, self.wo

    def misses(self, x: Floats) -> Floats:
        residual = self.residuals(x)
        if self.robust.name != "none":
            residual = residual * self.robust.slope((residual / self.scale) ** 2)
        return residual[None]

    def spread(self, x: Floats, inverse: Floats, sets: NDArray[np.intp] | None = None) -> Floats:
        """The middle of the sandwich estimator (P, P): the sum of (psi / (1 - h))^2 J' J for one parameter vector.

        ``inverse`` is that of `curvature`, h = J inverse J' the leverage of a sample, psi its (robust) weighted residual: MacKinnon
        and White's HC3 (1985), which does not ask whether the noise is the same everywhere, or goes with the weights."""
        if sets is None and self._by_functions is not None:
            return self._by_functions.spread(self._by_channel(x[None]), inverse)
        return np.asarray(np.sum(self._mapped(lambda rows: self._spread_part(x[None], inverse, rows, sets), 1), axis=0))

    def curvature(self, x: Floats, sets: NDArray[np.intp] | None = None) -> Floats:
        """The expected second derivative (P, P) of the objective at one parameter vector, for standard errors: the Gauss-Newton matrix; under a robust
        function less than the matrix that makes good steps, which leaves out that a residual counts less as it grows."""
        if self.robust.name == "none":
            return np.asarray(self.normal(x[None], sets).matrix[0])
        return np.asarray(np.sum(self._mapped(lambda rows: self._curvature_part(x[None], rows, sets), 1), axis=0))

    def pull(self, x: Floats, sets: NDArray[np.intp] | None = None) -> Floats:
        values = directions_last(self.values)
        slopes = self.loss.slope(values, self._cosines)
        moved = np.where(self._roots > 0, self._roots * slopes * values * self.common, 0.0)

        def part(rows: slice) -> Floats:
            _, jacobian = self.linearised(x[None], rows, sets)
            push = rows_of(moved, rows, sets)
            pushed = np.einsum("bcnk,bcn->bck", jacobian, push.reshape(1, *push.shape[-2:]))
            return np.asarray(self.layout.vector(pushed)[0])

        return np.asarray(np.sum(self._mapped(part, 1), axis=0))

    def refitted(
        self, x: Floats, points: Floats, held: NDArray[np.bool_], *, max_iterations: int, reduction: float
    ) -> Floats:
        """See `Objective.refitted`; of many channels by how much the objective of some rises."""
        rise = rise_among_channels(self, x, points, held, max_iterations, reduction)
        if rise is None:
            return super().refitted(x, points, held, max_iterations=max_iterations, reduction=reduction)
        return np.asarray(self.normal(x[None]).objective + rise)

    def _normal_part(self, x: Floats, rows: slice, sets: NDArray[np.intp] | None) -> tuple[Floats, Floats, Floats]:
        residual, jacobian = self.linearised(x, rows, sets)
        z = (residual / self.scale) ** 2
        objective = 0.5 * self.scale**2 * self.robust.rho(z).sum(axis=(1, 2))
        if self.robust.name != "none":
            root = np.sqrt(self.robust.slope(z))
            residual = residual * root
            jacobian *= root[..., None]
        transposed = np.swapaxes(jacobian, 2, 3)  # (B, C, K, n)
        products = transposed @ jacobian  # (B, C, K, K)
        slopes = (transposed @ residual[..., None])[..., 0]  # (B, C, K)
        return objective, self.layout.vector(slopes), self.layout.matrix(products)

    def _curvature_part(self, x: Floats, rows: slice, sets: NDArray[np.intp] | None) -> Floats:
        residual, jacobian = self.linearised(x, rows, sets)
        bend = self.robust.bend((residual / self.scale) ** 2)[..., None]  # (1, C, n, 1)
        return np.asarray(self.layout.matrix(np.swapaxes(jacobian, 2, 3) @ (bend * jacobian))[0])

    def _spread_part(self, x: Floats, inverse: Floats, rows: slice, sets: NDArray[np.intp] | None) -> Floats:
        residual, jacobian = self.linearised(x, rows, sets)
        z = (residual / self.scale) ** 2
        psi = (residual * self.robust.slope(z))[0]  # (C, n)
        blocks = inverse[self.layout.index[:, :, None], self.layout.index[:, None, :]]  # (C, K, K)
        transposed = np.swapaxes(jacobian[0], 1, 2)  # (C, K, n), which is how it lies in memory
        leverage = ((blocks @ transposed) * transposed).sum(axis=1)
        leverage *= self.robust.bend(z)[0]
        scaled = transposed * (psi / np.maximum(1 - leverage, LEAST_REMAINDER))[:, None]
        return np.asarray(self.layout.matrix((scaled @ np.swapaxes(scaled, 1, 2))[None])[0])

    def linearised(self, x: Floats, rows: slice, sets: NDArray[np.intp] | None) -> tuple[Floats, Floats]:
        """Weighted residuals (B, C, n) and their derivatives (B, C, n, K): per-channel parameters, then shared."""
        f, derivatives = self._function.values_and_jacobian(self._rows(rows), self._arguments(x))
        f = self._broadcast(f, rows, len(x))
        roots, targets = (rows_of(part, rows, sets) for part in (self._roots, self._targets))
        cosines = self._cosines[rows]
        residual = roots * (self.loss.transform(f, cosines) - targets)
        slope = roots * self.loss.slope(f, cosines)  # (B, C, n) or (C, n)
        batch, channels, n = residual.shape
        transposed = np.empty((batch, channels, len(self.quantities), n))
        for k, name in enumerate(self.layout.order):
            np.multiply(derivatives[name], slope, out=transposed[:, :, k])
        return residual, np.swapaxes(transposed, 2, 3)

    def _arguments(self, x: Floats) -> dict[str, Floats | float]:
        held = {k: v if np.ndim(v) == 0 else directions_last(np.asarray(v)) for k, v in self.fixed.items()}
        return {q.name: x[:, q.where, None] for q in self.quantities} | held

    def _by_channel(self, x: Floats) -> dict[str, Any]:
        held = {k: v if np.ndim(v) == 0 else np.asarray(v)[0] for k, v in self.fixed.items()}
        return {q.name: x[:, q.where] for q in self.quantities} | held

    def _rows(self, rows: slice) -> tuple[Floats, ...]:
        return tuple(column[rows] if len(column) > 1 else column for column in self._columns)

    def _broadcast(self, f: Floats, rows: slice, batch: int = 1) -> Floats:
        shape = (batch, self.channels, rows.stop - rows.start)
        return f if f.shape == shape else np.broadcast_to(f, shape)

    def _mapped(self, work: Callable[[slice], Part], batch: int) -> list[Part]:
        return in_passes(work, len(self.wi), batch * self.channels, CHUNK)

    @cached_property
    def layout(self) -> ChannelLayout:
        """Where what acts on a channel stands in the parameter vector."""
        return ChannelLayout(self.quantities, self.channels)
