"""Kinds of trends: their coefficients, their formulas, and their values with derivatives.

Formulas stand once, over any namespace, and are differentiated and printed as NumPy like those of the models.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from math import comb
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.arrays import Array
from motes.graph.derivatives import forward
from motes.graph.symbols import Graph
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
    graph = Graph()
    family = KINDS[kind]
    columns = [graph.leaf(f"b{k}") for k in range(len(family.basis(np.zeros(1), 0.0, 1.0)))]
    coefficients = [graph.leaf(c.name) for c in family.coefficients]
    output = graph.lift(family.formula(graph, columns, coefficients))
    (tangents,) = forward([output], coefficients)
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
