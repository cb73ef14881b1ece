"""Trends of all parameters fitted to all scans at once.

Each scan says how good a vector of BRDF parameters is (its objective, gradient and normal matrix, `Problem.normal`); the trends say which vector each scan
has.  The chain rule joins the two: with Q the parameters of all scans as functions of the trends' coefficients c, the gradient is
sum_t (dQ_t/dc)' g_t and the matrix sum_t (dQ_t/dc)' H_t (dQ_t/dc).  So one solver serves one scan and many.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product

import numpy as np
from numpy.typing import NDArray

from motes.fitting.choice import bic
from motes.fitting.columns import Columns, columns_of
from motes.fitting.losses import Floats
from motes.fitting.objective import Objective
from motes.fitting.problem import Problem
from motes.fitting.quantities import Quantity
from motes.fitting.scans import single
from motes.fitting.solver import Normal
from motes.parameters import Parameter
from motes.trends import KINDS, Trend, evaluate

# The lower bound of values whose square a model depends on, as a share of the typical range: at 0 a trend of them has no slope.
FLAT = 1e-3


@dataclass(frozen=True)
class Part:
    """The trend of one parameter, and where its coefficients stand in the vector of all of them."""

    quantity: Quantity
    kind: str
    interval: tuple[float, float]

    @property
    def width(self) -> int:
        """The number of channels of its values."""
        return int(self.quantity.where.stop - self.quantity.where.start)

    @property
    def size(self) -> int:
        """The number of its flat coefficients."""
        return sum(1 if c.bounds else self.width for c in KINDS[self.kind].coefficients)

    @property
    def squared(self) -> bool:
        """Whether the coefficients are squares: of a constant, where the model depends on the square."""
        return self.kind == "constant" and self.quantity.parameter.squared

    def trend(self, c: Floats, covariance: Floats | None = None) -> Trend:
        """The trend with flat coefficients `c`, in the coordinates of the fit; `covariance` is of the trend's own."""
        values: dict[str, float | Floats] = {}
        start = 0
        c = self.quantity.value(c) if self.squared else c
        for coefficient in KINDS[self.kind].coefficients:
            n = 1 if coefficient.bounds else self.width
            values[coefficient.name] = (
                c[start : start + n] if self.quantity.per_channel and not coefficient.bounds else float(c[start])
            )
            start += n
        return Trend(self.kind, values, self.interval, self.quantity.parameter.fit_bounds, covariance)

    def basis(self, hours: Floats) -> list[Floats]:
        """What the trend needs of the times (T,): columns (T, 1)."""
        return [column[:, None] for column in KINDS[self.kind].basis(hours, *self.interval)]

    def values(self, basis: list[Floats], c: Floats) -> tuple[Floats, Floats]:
        """Coordinates of the parameter (B, T, W) and their derivatives (B, T, W, K) for flat coefficients (B, K)."""
        given, where, start = {}, {}, 0
        for coefficient in KINDS[self.kind].coefficients:
            n = 1 if coefficient.bounds else self.width
            where[coefficient.name] = slice(start, start + n)
            given[coefficient.name] = c[:, None, start : start + n]
            start += n
        value, slopes = evaluate(self.kind, basis, given)
        shape = (len(c), len(basis[0]), self.width)
        jacobian = np.zeros((*shape, self.size))
        for name, slope in slopes.items():
            columns = where[name]
            if columns.stop - columns.start == 1:
                jacobian[..., columns.start] = slope
            else:
                for channel, k in enumerate(range(columns.start, columns.stop)):
                    jacobian[..., channel, k] = np.broadcast_to(slope, shape)[..., channel]
        value = np.broadcast_to(value, shape)
        if self.quantity.parameter.squared and not self.squared:
            return value * value, 2 * value[..., None] * jacobian
        return value, jacobian

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """Of the flat coefficients: the parameter's for values, parts of the duration for times."""
        first, last = self.interval
        low: list[float] = []
        high: list[float] = []
        for coefficient in KINDS[self.kind].coefficients:
            if coefficient.bounds is None:
                a, b = self._value_bounds()
            elif coefficient.is_time:
                a, b = (x * (last - first) for x in coefficient.bounds)
                if coefficient.name == "middle":
                    a, b = a + first, b + first
            else:
                a, b = coefficient.bounds
            n = 1 if coefficient.bounds else self.width
            low += [a] * n
            high += [b] * n
        return np.array(low), np.array(high)

    def _value_bounds(self) -> tuple[float, float]:
        parameter = self.quantity.parameter
        if self.squared or not parameter.squared:
            return self.quantity.bounds
        low, high = parameter.fit_bounds
        return low + (FLAT * (parameter.typical[1] - parameter.typical[0]) if low == 0 else 0.0), high

    @property
    def declared(self) -> list[Parameter | None]:
        """Of each flat coefficient the parameter that it is a value of; None for times and shares."""
        return [
            None if coefficient.bounds else self.quantity.parameter
            for coefficient in KINDS[self.kind].coefficients
            for _ in range(1 if coefficient.bounds else self.width)
        ]

    def starts(self, hours: Floats, values: Floats) -> Floats:
        """Flat coefficients to start from (S, K), given rough coordinates of the parameter (T, W) at the scans."""
        first, last = self.interval
        values = values if self.squared else self.quantity.value(values)
        edge = max(1, len(hours) // 6)
        begin, end = values[:edge].mean(axis=0), values[-edge:].mean(axis=0)
        columns: list[list[Floats]] = []
        kind = KINDS[self.kind]
        controls = [c for c in kind.coefficients if c.name.startswith("c") and c.name[1:].isdigit()]
        for coefficient in kind.coefficients:
            if coefficient.name in ("start", "end"):
                columns.append([begin if coefficient.name == "start" else end])
            elif coefficient.name == "value":
                columns.append([values.mean(axis=0)])
            elif coefficient in controls:
                at = first + (last - first) * int(coefficient.name[1:]) / max(len(controls) - 1, 1)
                columns.append([np.array([np.interp(at, hours, v) for v in values.T])])
            else:
                scale, shift = (
                    ((last - first), first if coefficient.name == "middle" else 0.0)
                    if coefficient.is_time
                    else (1.0, 0.0)
                )
                columns.append([np.array([shift + scale * s]) for s in coefficient.starts])
        return np.array([np.concatenate(choice) for choice in product(*columns)])


@dataclass(frozen=True)
class Joint(Objective):
    """All scans with a kind of trend for each parameter.

    ``hours`` (T,) are the times of the data sets of `problem`; ``scans`` those that take part.  ``inflation`` has a
    number for each part: how much noisier it is than the mean sample says (see `Profile.inflation`); 1 where it is empty.
    """

    problem: Problem
    hours: Floats
    scans: NDArray[np.intp]
    parts: tuple[Part, ...]
    inflation: tuple[float, ...] = ()

    @property
    def size(self) -> int:
        return sum(p.size for p in self.parts)

    def slices(self) -> list[slice]:
        """Where each part's coefficients stand."""
        stops = np.cumsum([p.size for p in self.parts]).tolist()
        return [slice(stop - p.size, stop) for stop, p in zip(stops, self.parts, strict=True)]

    def vectors(self, c: Floats) -> tuple[Floats, Floats]:
        """The BRDF parameters (T, P) of every scan that takes part, and their derivatives (T, P, K)."""
        hours = self.hours[self.scans]
        x = np.empty((len(hours), self.problem.size))
        jacobian = np.zeros((len(hours), self.problem.size, self.size))
        for part, where in zip(self.parts, self.slices(), strict=True):
            value, slopes = part.values(part.basis(hours), c[None, where])
            x[:, part.quantity.where], jacobian[:, part.quantity.where, where] = value[0], slopes[0]
        return x, jacobian

    @cached_property
    def columns(self) -> Columns:
        return columns_for(self.parts, self.problem.unit)

    @property
    def groups(self) -> list[slice]:
        return groups_for(self.parts)

    def brightness(self) -> Floats:
        return self.problem.brightness()[self.scans]

    def normal(self, batch: Floats, sets: NDArray[np.intp] | None = None) -> Normal:
        """Objectives and normal equations for coefficient vectors (B, K)."""
        results = []
        for c in batch:
            x, jacobian = self.vectors(c)
            scan = self.problem.normal(x, self.scans)
            gradient = np.einsum("tpk,tp->k", jacobian, scan.gradient)
            results.append((scan.objective.sum(), gradient, chained(jacobian, scan.matrix)))
        return Normal(*(np.array(part) for part in zip(*results, strict=True)))

    @property
    def samples(self) -> int:
        return int(np.count_nonzero(self.problem.weights[self.scans]))

    @property
    def directions(self) -> tuple[Floats, Floats]:
        return self.problem.directions

    def misses(self, c: Floats) -> Floats:
        """See `Objective.misses`."""
        scans = [single(self.problem, t) for t in self.scans]
        return np.concatenate([scan.misses(x) for scan, x in zip(scans, self.vectors(c)[0], strict=True)])

    def at_directions(self, rows: NDArray[np.intp]) -> Joint:
        """See `Objective.at_directions`: what a model misses at a direction it misses in every scan."""
        return replace(self, problem=self.problem.at_directions(rows))

    def counting(self, times: Floats) -> Joint:
        return replace(self, problem=self.problem.counting(times))

    def bic(self, objective: float) -> float:
        """The Bayesian information criterion of an objective, with a coefficient as a parameter, or as `inflation` of them."""
        count = sum(p.size * i for p, i in zip(self.parts, self.inflation or (1.0,) * len(self.parts), strict=True))
        return bic(objective, self.samples, count)

    def curvature(self, c: Floats) -> Floats:
        """The expected second derivative (K, K) of the objective; see `Problem.curvature`."""
        x, jacobian = self.vectors(c)
        scans = [self.problem.curvature(x[k], np.array([t])) for k, t in enumerate(self.scans)]
        return chained(jacobian, np.stack(scans))

    @property
    def common(self) -> float:  # type: ignore[override]  # a field there
        return self.problem.common

    def pull(self, c: Floats) -> Floats:
        """See `Problem.pull`."""
        x, jacobian = self.vectors(c)
        scans = np.stack([self.problem.pull(x[k], np.array([t])) for k, t in enumerate(self.scans)])
        return np.asarray(np.einsum("tpk,tp->k", jacobian, scans))

    def spread(self, c: Floats, inverse: Floats) -> Floats:
        """The middle of the sandwich (K, K) over all scans; see `Problem.spread`."""
        x, jacobian = self.vectors(c)
        middles = []
        for k, t in enumerate(self.scans):
            own = jacobian[k] @ inverse @ jacobian[k].T
            middles.append(self.problem.spread(x[k], own, np.array([t])))
        return chained(jacobian, np.stack(middles))


def columns_for(parts: Sequence[Part], unit: float = 1.0) -> Columns:
    """What is known of the coefficients of trends beforehand; `unit` is that of the data."""
    low, high = (np.concatenate([part.bounds[k] for part in parts]) for k in (0, 1))
    squared = [part.squared for part in parts for _ in range(part.size)]
    return columns_of([p for part in parts for p in part.declared], low, high, squared=squared, unit=unit)


def groups_for(parts: Sequence[Part]) -> list[slice]:
    """The coefficients of each parameter that is constant: its channels.  What changes may be absent for a while only."""
    stops = np.cumsum([part.size for part in parts]).tolist()
    return [slice(stop - p.size, stop) for stop, p in zip(stops, parts, strict=True) if p.kind == "constant"]


def chained(jacobian: Floats, matrices: Floats) -> Floats:
    """The sum over scans of J' H J: from the scans' parameters (T, P, P) to the coefficients (K, K)."""
    return np.asarray(np.einsum("tpk,tpq,tql->kl", jacobian, matrices, jacobian, optimize=True))
