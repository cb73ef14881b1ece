"""`Trend`: a parameter as a function of time, of one of the kinds of `motes.trends.kinds`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Self, final

import numpy as np
from numpy.typing import ArrayLike

from motes.errors import ParameterError
from motes.trends.kinds import KINDS, Floats, evaluate


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
            raise ParameterError(f"trend {str(self.kind)[:40]!r} is not one of {', '.join(KINDS)}", "Name one of them")
        expected = [c.name for c in KINDS[self.kind].coefficients]
        if sorted(self.coefficients) != sorted(expected):
            raise ParameterError(
                f"a {self.kind} trend has the coefficients {', '.join(expected)}, not {', '.join(self.coefficients)}",
                "Give each of them",
            )
        start, end = self.interval
        if not (np.isfinite(start) and np.isfinite(end) and end > start):
            raise ParameterError(
                f"the interval {start:g} to {end:g} h of a trend does not go forward in time",
                "Give the first and the last time [h]",
            )
        try:
            values = {name: np.asarray(self.coefficients[name], float) for name in expected}
        except (TypeError, ValueError, OverflowError) as error:
            raise ParameterError(
                f"a coefficient of a {self.kind} trend is not a number: {error}", "Give numbers, or a list for each"
            ) from None
        if not all(np.isfinite(v).all() for v in values.values()):
            raise ParameterError(
                f"a coefficient of a {self.kind} trend is not finite: {str(dict(self.coefficients))[:200]}",
                "Give numbers that are",
            )
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
            raise ParameterError(
                f"the bounds {low:g} to {high:g} of a trend are the wrong way round", "Give the lower one first"
            )
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
        except (KeyError, TypeError, ValueError, OverflowError) as error:
            raise ParameterError(
                f"a trend is incomplete or damaged: {error}", "Write the material again with motes fit"
            ) from None
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
    """Derivatives by the flat coefficients: of `shape` and then K, where shape is (T,) or (T, C)."""
    columns = []
    for c in KINDS[trend.kind].coefficients:
        slope = np.broadcast_to(jacobian.get(c.name, np.zeros(())), shape)
        if np.ndim(trend.coefficients[c.name]):  # one column for each channel
            columns.append(slope[..., None] * np.eye(shape[-1]))
        else:
            columns.append(slope[..., None])
    return np.concatenate(columns, axis=-1)
