"""Moving a trend: onto another stretch of time, and onto another surface's values.

Every kind of trend is affine in its values: where they become ``a q + b``, so does the trend at all times.  A trend that is carried keeps its kind, and
its shape in time exactly.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from motes.arrays import Array
from motes.parameters import Slot
from motes.trends import KINDS, AnyTrend, Tabulated, Trend

Interval = tuple[float, float]

#: Below this share of the largest value a ratio to a reference says nothing.
VANISHING = 1e-6


def stretched(trend: AnyTrend, interval: Interval, observed: Interval) -> AnyTrend:
    """The same course of values, with the times `observed` moved linearly onto `interval`; without covariance."""
    (a, b), (t0, t1) = observed, interval
    scale = (t1 - t0) / (b - a)

    def moved(t: Any) -> Any:
        return t0 + (np.asarray(t, float) - a) * scale

    if isinstance(trend, Tabulated):
        return Tabulated(moved(trend.hours), trend.values)
    coefficients = {}
    for c in KINDS[trend.kind].coefficients:
        value = trend.coefficients[c.name]
        if c.is_time:
            value = float(moved(value)) if c.name == "middle" else value * scale
        coefficients[c.name] = value
    first, last = trend.interval
    return Trend(trend.kind, coefficients, (float(moved(first)), float(moved(last))), trend.bounds)


def mapped(trend: AnyTrend, change: Callable[[Any], Any], bounds: Interval) -> AnyTrend:
    """The trend of ``change(q)``, for an affine `change`; without covariance."""
    if isinstance(trend, Tabulated):
        values = change(trend.values)
        return Tabulated(trend.hours, np.clip(values, *bounds))
    coefficients = {
        c.name: change(trend.coefficients[c.name]) if c.bounds is None else trend.coefficients[c.name]
        for c in KINDS[trend.kind].coefficients
    }
    return Trend(trend.kind, coefficients, trend.interval, bounds)


def meaned(trend: AnyTrend) -> AnyTrend:
    """The mean over the channels."""
    if isinstance(trend, Tabulated):
        return Tabulated(trend.hours, trend.values.mean(-1)) if trend.values.ndim > 1 else trend
    coefficients = {
        c.name: float(np.mean(v)) if np.ndim(v := trend.coefficients[c.name]) else v
        for c in KINDS[trend.kind].coefficients
    }
    return Trend(trend.kind, coefficients, trend.interval, trend.bounds)


def carried(trend: AnyTrend, reference: Any, value: Any, rule: str, bounds: Interval) -> tuple[AnyTrend, str]:
    """The trend of a surface whose parameter is `value` where the source's is `reference`.

    Parameters
    ----------
    trend
        The source's.
    reference, value
        Of the source and of the target at the same moment; numbers or (C,).
    rule
        ``"ratio"``: target = value * source / reference, in each channel.  ``"difference"``: value + source - reference.  ``"absolute"``: the source's.
    bounds
        Of the parameter.

    Returns
    -------
    trend, rule
        The rule that was followed: a ratio to a reference that vanishes in a channel becomes a difference.
    """
    reference, value = np.asarray(reference, float), np.asarray(value, float)
    if rule == "ratio" and np.any(reference <= VANISHING * max(1.0, float(np.max(reference)))):
        rule = "difference"
    if rule == "ratio":
        return mapped(trend, lambda q: _plain(q * (value / reference)), bounds), rule
    if rule == "difference":
        return mapped(trend, lambda q: _plain(q + (value - reference)), bounds), rule
    return mapped(trend, _plain, bounds), "absolute"


def _plain(value: Any) -> Any:
    return float(value) if np.ndim(value) == 0 else np.asarray(value, float)


def is_map(slot: Slot) -> bool:
    """True for values that vary over the surface: they have more axes than the channels."""
    return np.ndim(slot.value) > (1 if slot.parameter.per_channel else 0)


def grey(value: Array) -> float:
    """The mean over the channels."""
    return float(np.mean(value))
