r"""Trends: parameters as functions of time.

==================  =============================================================================  =========================
``constant``        :math:`q = a`                                                                  does not change
``linear``          :math:`q = a + (b - a) u,\ u = (t - t_0)/(t_1 - t_0)`                          steady growth
``exponential``     :math:`q = b + (a - b) e^{-(t - t_0)/T}`                                       evaporation, relaxation
``logistic``        :math:`q = a + (b - a) / (1 + e^{-(t - m)/s})`                                 wet to dry, a front passing
``quadratic``       :math:`q = \sum_{k=0}^2 c_k B_k(u)`, Bernstein                                 smooth, no law known
``cubic``           the same with four control values                                              smooth, no law known
``monotone_spline`` :math:`q = a + (b - a) \sum_k s_k I_k(u)`, I-splines                           one-way, no law known
``tabulated``       piecewise linear through measured points                                       measured, not fitted
==================  =============================================================================  =========================

All but time constants are *values of the parameter* (at the start, at the end, control values), so the bounds of the parameter are the bounds of the
trend, and inside the observed interval a trend never leaves them.  Time is in hours.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any, Self, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.arrays import Array
from motes.errors import DataError, ParameterError
from motes.graph import tracing
from motes.kernels.numpy import scalar_function

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Coefficient:
    """A fitted number of a trend: a value of the parameter, a time, or a share.

    ``bounds`` are those of a time or a share in units of the observed duration, None for a value (the parameter's own bounds hold).
    """

    name: str
    doc: str
    bounds: tuple[float, float] | None = None
    is_time: bool = False
    #: Position of a time on the observed interval, from which a fit starts.
    starts: tuple[float, ...] = ()


@dataclass(frozen=True)
class Kind:
    """A family of trends: its coefficients, what it needs of time alone, and its formula over any namespace."""

    name: str
    doc: str
    coefficients: tuple[Coefficient, ...]
    basis: Callable[[Floats, float, float], list[Floats]]
    formula: Callable[[Any, list[Array], list[Array]], Array]
    monotone: bool = False


def _u(t: Floats, t0: float, t1: float) -> Floats:
    return (t - t0) / (t1 - t0)


def _exponential(xp: Any, basis: list[Array], c: list[Array]) -> Array:
    start, end, constant = c
    # exp of at most 600, long before the start: what is multiplied with it must stay finite.
    return end + (start - end) * xp.exp(xp.minimum(-(basis[0] / constant), 600.0))


def _logistic(xp: Any, basis: list[Array], c: list[Array]) -> Array:
    start, end, middle, width = c
    # exp of at most 700: float64 holds it, and 1/(1 + e) is 0 to all digits there.
    return start + (end - start) / (1 + xp.exp(xp.minimum((middle - basis[0]) / width, 700.0)))


def _weighted(xp: Any, basis: list[Array], c: list[Array]) -> Array:
    total: Array = 0.0
    for b, value in zip(basis, c, strict=True):
        total = total + b * value
    return total


def _bernstein(degree: int) -> Callable[[Floats, float, float], list[Floats]]:
    from math import comb

    def basis(t: Floats, t0: float, t1: float) -> list[Floats]:
        u = _u(t, t0, t1)
        return [comb(degree, k) * u**k * (1 - u) ** (degree - k) for k in range(degree + 1)]

    return basis


SPLINE_STEPS = 4


def _rises(t: Floats, t0: float, t1: float) -> list[Floats]:
    """Quadratic I-splines: smooth steps from 0 to 1 over overlapping stretches; straight on beyond the ends."""
    u = _u(t, t0, t1)
    inside = np.clip(u, 0, 1)
    knots = np.linspace(0, 1, SPLINE_STEPS)  # centres of the rises
    half = 1 / (SPLINE_STEPS - 1)
    columns = []
    for knot in knots:
        left, right = max(knot - half, 0.0), min(knot + half, 1.0)
        columns.append(_hat_integral(inside, left, knot, right))
    # The slope at either end carries on, so that an extrapolated band opens.
    columns[0] = columns[0] + np.minimum(u, 0) * 2 / half
    columns[-1] = columns[-1] + np.maximum(u - 1, 0) * 2 / half
    return columns


def _hat_integral(u: Floats, left: float, peak: float, right: float) -> Floats:
    """The integral of a hat function from 0 to `u`, scaled to end at 1."""
    area = 0.5 * (right - left)
    rising = np.clip(u, left, peak) - left
    falling = right - np.clip(u, peak, right)
    up = 0.5 * rising**2 / (peak - left) if peak > left else np.zeros_like(u)
    down = 0.5 * ((right - peak) - falling**2 / (right - peak)) if right > peak else np.zeros_like(u)
    return (up + down) / area


def _monotone(xp: Any, basis: list[Array], c: list[Array]) -> Array:
    """Stick-breaking: each coefficient is the share of what is left of the way from a to b that this step takes."""
    start, end, *shares = c
    left: Array = 1.0
    way: Array = 0.0
    for b, share in zip(basis, [*shares, 1.0], strict=True):
        way = way + b * (left * share)
        left = left * (1 - share)
    return start + (end - start) * way


_START = Coefficient("start", "value at the start")
_END = Coefficient("end", "value at the end")

KINDS: dict[str, Kind] = {
    kind.name: kind
    for kind in (
        Kind(
            "constant",
            "does not change",
            (Coefficient("value", "the value"),),
            lambda t, a, b: [np.ones_like(t)],
            _weighted,
            True,
        ),
        Kind("linear", "steady change", (_START, _END), _bernstein(1), _weighted, True),
        Kind(
            "exponential",
            "decays from a start towards an end",
            (
                _START,
                Coefficient("end", "value long after"),
                Coefficient(
                    "time_constant", "time in which the difference falls to 37 %", (0.02, 5), True, (0.08, 0.25, 0.7)
                ),
            ),
            lambda t, a, b: [t - a],
            _exponential,
            True,
        ),
        Kind(
            "logistic",
            "passes from one value to another about a moment",
            (
                Coefficient("start", "value long before"),
                Coefficient("end", "value long after"),
                Coefficient("middle", "moment of half the way", (-0.5, 1.5), True, (0.25, 0.5, 0.75)),
                Coefficient("width", "a quarter of the time it takes from 12 % to 88 %", (0.01, 1), True, (0.05, 0.15)),
            ),
            lambda t, a, b: [t],
            _logistic,
            True,
        ),
        Kind(
            "quadratic",
            "a parabola",
            tuple(Coefficient(f"c{k}", f"control value {k}") for k in range(3)),
            _bernstein(2),
            _weighted,
        ),
        Kind(
            "cubic",
            "a cubic",
            tuple(Coefficient(f"c{k}", f"control value {k}") for k in range(4)),
            _bernstein(3),
            _weighted,
        ),
        Kind(
            "monotone_spline",
            "one way, in a shape of its own",
            (
                _START,
                _END,
                *(
                    Coefficient(
                        f"share{k}",
                        f"share of the rest of the way in step {k}",
                        (0, 1),
                        False,
                        (1 / (SPLINE_STEPS - k),),
                    )
                    for k in range(SPLINE_STEPS - 1)
                ),
            ),
            _rises,
            _monotone,
            True,
        ),
    )
}


@cache
def _function(kind: str) -> tuple[Callable[..., tuple[Any, ...]], tuple[str, ...]]:
    """The formula of a kind with its derivatives, as generated NumPy, and the coefficients it differentiates by."""
    graph = tracing.Graph()
    family = KINDS[kind]
    columns = [graph.leaf(f"b{k}") for k in range(len(family.basis(np.zeros(1), 0.0, 1.0)))]
    coefficients = [graph.leaf(c.name) for c in family.coefficients]
    output = graph.lift(family.formula(graph, columns, coefficients))
    (tangents,) = tracing.forward([output], coefficients)
    moving = [leaf for leaf in coefficients if leaf in tangents]
    given = {leaf: leaf.value for leaf in (*columns, *coefficients)}
    generated = scalar_function(kind, given, [output, *(tangents[leaf] for leaf in moving)])
    return generated, tuple(leaf.value for leaf in moving)


def evaluate(kind: str, basis: list[Floats], coefficients: Mapping[str, Any]) -> tuple[Any, dict[str, Any]]:
    """Values and derivatives by each coefficient; all arguments broadcast, and the results have the shape they naturally have."""
    trend, names = _function(kind)
    with np.errstate(over="ignore"):
        value, *slopes = trend(*basis, *(coefficients[c.name] for c in KINDS[kind].coefficients))
    return value, dict(zip(names, slopes, strict=True))


@final
@dataclass(frozen=True)
class Trend:
    """A parameter as a function of time.

    Parameters
    ----------
    kind
        A key of `KINDS`.
    coefficients
        By name: values of the parameter, a number or (C,) for C channels; times [h] and shares, numbers.
    interval
        The observed times [h] from first to last; outside it the trend extrapolates.
    bounds
        Of the parameter; extrapolated values stay inside.
    covariance
        Of the flat coefficients (see `flat`), or None; NaN for those that are at a bound or not determined.
    """

    kind: str
    coefficients: Mapping[str, Any]
    interval: tuple[float, float]
    bounds: tuple[float, float] = (-np.inf, np.inf)
    covariance: Floats | None = field(default=None, compare=False)

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise ParameterError(f"trend {self.kind!r} is not one of {', '.join(KINDS)}")
        expected = [c.name for c in KINDS[self.kind].coefficients]
        if sorted(self.coefficients) != sorted(expected):
            raise ParameterError(
                f"a {self.kind} trend has the coefficients {', '.join(expected)}, not {', '.join(self.coefficients)}"
            )
        start, end = self.interval
        if not (np.isfinite(start) and np.isfinite(end) and end > start):
            raise ParameterError(f"the interval {start:g} to {end:g} h of a trend does not go forward in time")
        try:
            values = {name: np.asarray(self.coefficients[name], float) for name in expected}
        except (TypeError, ValueError, OverflowError) as error:
            raise ParameterError(f"a coefficient of a {self.kind} trend is not a number: {error}") from None
        if not all(np.isfinite(v).all() for v in values.values()):
            raise ParameterError(f"a coefficient of a {self.kind} trend is not finite: {dict(self.coefficients)}")
        widths = {v.shape for v in values.values() if v.ndim}
        if len(widths) > 1 or any(len(w) != 1 or w[0] == 0 for w in widths):
            raise ParameterError(
                f"the coefficients of a {self.kind} trend have the shapes {', '.join(str(v.shape) for v in values.values())}",
                "Give numbers, or as many values for each as there are channels",
            )
        for c in KINDS[self.kind].coefficients:
            value = values[c.name]
            if c.bounds and value.ndim:
                raise ParameterError(
                    f"{c.name} of a {self.kind} trend has the shape {value.shape}", f"It is one number: {c.doc}"
                )
            if c.name in ("time_constant", "width") and not value > 0:
                raise ParameterError(
                    f"{c.name} of a {self.kind} trend is {value:g} h, not above 0", f"It is the {c.doc}"
                )
            if c.bounds and not c.is_time and not 0 <= value <= 1:
                raise ParameterError(
                    f"{c.name} of a {self.kind} trend is {value:g}, outside [0, 1]", f"It is the {c.doc}"
                )
        low, high = self.bounds
        if not low <= high:
            raise ParameterError(f"the bounds {low:g} to {high:g} of a trend are the wrong way round")
        size = sum(v.size for v in values.values())
        if self.covariance is not None and np.shape(self.covariance) != (size, size):
            raise ParameterError(
                f"the covariance of a {self.kind} trend has the shape {np.shape(self.covariance)}",
                f"It has {size} rows and columns, one for each coefficient and channel",
            )
        object.__setattr__(self, "coefficients", {name: v if v.ndim else float(v) for name, v in values.items()})

    @property
    def channels(self) -> int | None:
        """Number of channels of its values; None when they have none."""
        return max((np.shape(v)[-1] for v in self.coefficients.values() if np.ndim(v)), default=None)

    def __call__(self, hours: ArrayLike) -> Floats:
        """The parameter at times [h] of any shape (...): (...), or (..., C) where values have channels."""
        value, _ = self._evaluated(hours)
        return np.clip(value, *self.bounds)

    def jacobian(self, hours: ArrayLike) -> dict[str, Floats]:
        """Derivatives of the value by each coefficient, in the shape that they naturally have."""
        return self._evaluated(hours)[1]

    def rate(self, hours: ArrayLike) -> Floats:
        """The change per hour, by central differences of a millionth of the interval."""
        step = 1e-6 * (self.interval[1] - self.interval[0])
        t = np.asarray(hours, float)
        ahead, behind = (self._evaluated(t + s)[0] for s in (step, -step))
        return (ahead - behind) / (2 * step)

    def stderr(self, hours: ArrayLike) -> Floats:
        """One standard error of the value at times [h], from `covariance`; NaN without one, or where it knows nothing.

        Coefficients at a bound, or not determined, count as known.
        """
        t = np.atleast_1d(np.asarray(hours, float))
        value, jacobian = self._evaluated(t)
        if self.covariance is None or not np.isfinite(self.covariance).any():
            return np.full(value.shape, np.nan)
        covariance = np.where(np.isfinite(self.covariance), self.covariance, 0.0)
        rows = flat_jacobian(self, jacobian, value.shape)  # (T[, C], K)
        error: Floats = np.sqrt(np.maximum(np.einsum("...k,kl,...l->...", rows, covariance, rows), 0))
        return error

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON values."""
        return {
            "kind": self.kind,
            "coefficients": {name: np.asarray(v).tolist() for name, v in self.coefficients.items()},
            "interval_h": list(self.interval),
            "bounds": [b if np.isfinite(b) else None for b in self.bounds],
            "covariance": None
            if self.covariance is None
            else [[float(v) if np.isfinite(v) else None for v in row] for row in self.covariance],
        }

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Self:
        """Back from `to_dict`."""
        try:
            low, high = data.get("bounds") or (None, None)
            start, end = data["interval_h"]
            covariance = data.get("covariance")
            kind, coefficients = str(data["kind"]), dict(data["coefficients"])
            interval = (float(start), float(end))
            bounds = (-np.inf if low is None else float(low), np.inf if high is None else float(high))
            matrix = None if covariance is None else np.asarray(covariance, float)
        except (TypeError, ValueError, OverflowError) as error:
            raise ParameterError(f"a trend is incomplete or damaged: {error}") from None
        return cls(kind, coefficients, interval, bounds, matrix)

    def _evaluated(self, hours: ArrayLike) -> tuple[Floats, dict[str, Floats]]:
        t = np.asarray(hours, float)
        tail = (...,) if self.channels is None else (..., None)
        basis = [column[tail] for column in KINDS[self.kind].basis(t, *self.interval)]
        value, slopes = evaluate(self.kind, basis, self.coefficients)
        shape = t.shape if self.channels is None else (*t.shape, self.channels)
        return np.broadcast_to(value, shape), slopes


def flat(trend: Trend) -> Floats:
    """The coefficients as one vector (K,), in the order of the kind; channels of one coefficient stand together."""
    return np.concatenate([np.ravel(trend.coefficients[c.name]) for c in KINDS[trend.kind].coefficients])


def flat_jacobian(trend: Trend, jacobian: Mapping[str, Floats], shape: tuple[int, ...]) -> Floats:
    """Derivatives by the flat coefficients: shape (*shape, K), where shape is (T,) or (T, C)."""
    columns = []
    for c in KINDS[trend.kind].coefficients:
        slope = np.broadcast_to(jacobian.get(c.name, np.zeros(())), shape)
        if np.ndim(trend.coefficients[c.name]):  # one column for each channel
            columns.append(slope[..., None] * np.eye(shape[-1]))
        else:
            columns.append(slope[..., None])
    return np.concatenate(columns, axis=-1)


@final
@dataclass(frozen=True)
class Tabulated:
    """Values at given times, straight lines between them, held before the first and after the last.

    Parameters
    ----------
    hours
        Increasing times (T,) [h].
    values
        (T,) or (T, C).
    """

    hours: Floats
    values: Floats
    kind: str = field(default="tabulated", init=False)

    def __post_init__(self) -> None:
        hours, values = np.asarray(self.hours, float), np.asarray(self.values, float)
        if hours.ndim != 1 or len(hours) == 0 or np.any(np.diff(hours) <= 0) or len(values) != len(hours):
            raise DataError(
                f"a tabulated trend wants increasing times and as many values: {hours.shape} and {values.shape}"
            )
        object.__setattr__(self, "hours", hours)
        object.__setattr__(self, "values", values)

    @property
    def interval(self) -> tuple[float, float]:
        """The first and the last time [h]."""
        return float(self.hours[0]), float(self.hours[-1])

    def __call__(self, hours: ArrayLike) -> Floats:
        """The value at times [h] of any shape (...): (...) or (..., C)."""
        t = np.asarray(hours, float)
        if self.values.ndim == 1:
            value: Floats = np.interp(t, self.hours, self.values)
            return value
        return np.stack([np.interp(t, self.hours, column) for column in self.values.T], axis=-1)

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON values."""
        return {"kind": "tabulated", "hours": self.hours.tolist(), "values": self.values.tolist()}


AnyTrend = Trend | Tabulated


def trend_from_dict(data: Mapping[str, Any]) -> AnyTrend:
    """Back from ``to_dict`` of either; raises `ParameterError` or KeyError when something is missing."""
    if data.get("kind") == "tabulated":
        try:
            hours, values = np.asarray(data["hours"], float), np.asarray(data["values"], float)
        except (TypeError, ValueError, OverflowError) as error:
            raise ParameterError(f"a tabulated trend is damaged: {error}") from None
        return Tabulated(hours, values)
    return Trend.from_dict(data)
