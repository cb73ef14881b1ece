"""`Objective`: what is minimised, the problem of one scan or of all scans through trends, and what is asked of it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from functools import cached_property
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from motes.fitting.algebra import ARRAYS, Arrays
from motes.fitting.columns import Columns
from motes.fitting.levenberg import FIRST_DAMPING
from motes.fitting.losses import Floats
from motes.fitting.solver import Normal, Solution, Spare, minimize

T = TypeVar("T")


class Objective(ABC):
    """Half a weighted (robust) sum of squares, as a function of a parameter vector (P,)."""

    #: A relative uncertainty that all values share: of the scale.
    common: float

    @property
    @abstractmethod
    def columns(self) -> Columns:
        """What is known of the parameters beforehand."""

    @property
    @abstractmethod
    def groups(self) -> list[slice]:
        """The columns of each parameter: its channels."""

    @property
    @abstractmethod
    def samples(self) -> int:
        """The number of samples with a weight."""

    @abstractmethod
    def brightness(self) -> Floats:
        """The weighted sum of squares of the data of each scan (T,)."""

    @abstractmethod
    def normal(self, x: Floats, sets: NDArray[np.intp] | None = None) -> Normal:
        """Objectives and normal equations for parameter vectors (B, P); ``sets`` (B,) says which of several data sets each is for."""

    @abstractmethod
    def curvature(self, x: Floats) -> Floats:
        """The expected second derivative (P, P)."""

    @abstractmethod
    def spread(self, x: Floats, inverse: Floats) -> Floats:
        """The middle of the sandwich estimator (P, P), with the inverse of the curvature."""

    @abstractmethod
    def pull(self, x: Floats) -> Floats:
        """By how much the gradient (P,) changes when all values grow by their common uncertainty, one standard deviation."""

    @property
    @abstractmethod
    def directions(self) -> tuple[Floats, Floats]:
        """To the light and to the viewer (N, 3)."""

    @abstractmethod
    def misses(self, x: Floats) -> Floats:
        """Weighted residuals (T, N, C) of all scans, as far as the robust function lets them count; 0 where masked."""

    @abstractmethod
    def at_directions(self, rows: NDArray[np.intp]) -> Objective:
        """The part of it at some of the directions: those of a partition add up to the whole."""

    @abstractmethod
    def counting(self, times: Floats) -> Objective:
        """The objective in which each direction counts so many times (N,)."""

    @cached_property
    def _last(self) -> dict[str, tuple[bytes, Any]]:
        return {}

    def once(self, what: str, x: Floats, make: Callable[[], T]) -> T:
        """What `make` finds at `x`, kept until it is asked for elsewhere: several ask for it at a solution, and it is a pass over the data."""
        if self._last.get(what, (b"",))[0] != x.tobytes():
            self._last[what] = (x.tobytes(), make())
        found: T = self._last[what][1]
        return found

    @property
    def algebra(self) -> Arrays:
        """What its matrices are computed with."""
        return ARRAYS

    def refitted(
        self, x: Floats, points: Floats, held: NDArray[np.bool_], *, max_iterations: int, reduction: float
    ) -> Floats:
        """Objectives (L,) of fits from `points` (L, P) with some of the parameters `held` (L, P), beside the solution `x` (P,)."""
        return self.solve(points, held=held, max_iterations=max_iterations, reduction=reduction).normal.objective

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """Lower and upper bounds (P,), in the coordinates of the fit."""
        return self.columns.low[:, 0], self.columns.high[:, 0]

    def solve(
        self,
        starts: Floats,
        *,
        sets: NDArray[np.intp] | None = None,
        held: NDArray[np.bool_] | None = None,
        reduction: float = 1e-10,
        settled: float = 0.0,
        damping: float = FIRST_DAMPING,
        max_iterations: int = 200,
        spare: Spare | None = None,
    ) -> Solution:
        """Minimise from each of `starts` (B, P); see `motes.fitting.solver.minimize`."""
        bright = self.brightness()
        return minimize(
            self.normal,
            starts,
            *self.bounds,
            held=held,
            sets=sets,
            brightness=float(bright.sum()) if sets is None else bright[sets],
            unit=self.columns.unit[:, 0],
            reduction=reduction,
            settled=settled,
            damping=damping,
            max_iterations=max_iterations,
            algebra=self.algebra,
            spare=spare,
        )
