"""The steps of `motes.fitting.levenberg` over NumPy: many parameter vectors at once.

All starts of a fit advance together: their normal equations come from one pass over the data, and those that have
converged leave the batch."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.fitting import levenberg
from motes.fitting.algebra import ARRAYS, Arrays
from motes.fitting.levenberg import At, Box, Damping, Precision
from motes.fitting.losses import Floats
from motes.fitting.verdicts import Status

#: A last step that raises the objective by more than this share of it was none.
UPHILL = 1e-6
# The code of a fit that was given up; `motes.fitting.levenberg.ENDINGS` has those of the others.
_GIVEN_UP = -1
#: Which of the fits that still run to give up, from their parameters (R, P), objectives (R,) and iterations (R,).
Spare = Callable[[Floats, Floats, NDArray[np.int64]], NDArray[np.bool_]]


class Normal(NamedTuple):
    """Half the (robust) sum of squares (B,), its gradient (B, P), and the Gauss-Newton matrix (B, P, P)."""

    objective: Floats
    gradient: Floats
    matrix: Floats


@dataclass
class Solution:
    """Where each start ended: parameters (B, P), the normal equations there, why, and after how many iterations.

    The normal equations are those of the point before the last step, `seen`, which promised next to nothing.
    """

    x: Floats
    seen: Floats
    normal: Normal
    status: list[Status]
    iterations: NDArray[np.int64]

    def best(self) -> int:
        """The start with the smallest objective."""
        return int(np.argmin(self.normal.objective))

    def best_point(self, normal: Callable[[Floats], Normal]) -> Floats:
        """Where that start ended (P,); before its last step where that led uphill: along what the data hardly see it may be long."""
        k = self.best()
        uphill = normal(self.x[k : k + 1]).objective[0] > self.normal.objective[k] * (1 + UPHILL)
        point: Floats = self.seen[k] if uphill else self.x[k]
        return point


def minimize(
    normal: Callable[..., Normal],
    x: Floats,
    low: Floats,
    high: Floats,
    *,
    held: NDArray[np.bool_] | None = None,
    sets: NDArray[np.intp] | None = None,
    brightness: float | Floats = 0.0,
    unit: float | Floats = 1.0,
    max_iterations: int = 200,
    reduction: float = 1e-10,
    settled: float = 0.0,
    damping: float = levenberg.FIRST_DAMPING,
    algebra: Arrays = ARRAYS,
    spare: Spare | None = None,
) -> Solution:
    """Minimise from each row of `x` (B, P) within [low, high] (P,).

    Parameters
    ----------
    normal
        Objective, gradient and Gauss-Newton matrix of a batch; see `Normal`.
    held
        Parameters (P,) that stay as they are, or (B, P) for each row its own.
    sets
        What each row belongs to (B,), passed on to `normal` as a second argument.
    brightness
        The weighted sum of squares of the data, or (B,) of each row's; see `motes.fitting.levenberg.BLIND`.
    unit
        How large ordinary values are, or (P,) of each parameter; see `motes.fitting.columns.Columns`.
    reduction
        Converged when a full step promises less than this share of the objective; see also `motes.fitting.levenberg`.
    settled
        A last step that promises less than this share of the objective is not taken: the normal equations are those of where it ends then.
    damping
        The first; less where the starts are near a solution.
    algebra
        What the Gauss-Newton matrices are solved with.
    spare
        Which of the fits that still run to give up; their status is that of those whose iterations ran out.
    """
    x = np.clip(np.array(x, float), low, high)
    batch, size = x.shape
    box = Box(*(np.broadcast_to(np.asarray(part, float), (size,))[:, None] for part in (low, high, unit)))
    precision = Precision(np.float64(reduction), np.float64(0.0))

    def at_rows(points: Floats, rows: NDArray[np.intp]) -> Normal:
        return normal(points) if sets is None else normal(points, sets[rows])

    found, seen = Normal(*(np.array(part) for part in at_rows(x, np.arange(batch)))), x.copy()
    endings, iterations = np.zeros(batch, np.intp), np.zeros(batch, np.int64)
    running = np.arange(batch)
    lanes = _Lanes.of(x, found, np.zeros(size) if held is None else held, brightness, damping)

    def end(which: NDArray[np.bool_], last: Floats) -> _Lanes:
        """Put down where some of the lanes are, and at what points (P, B) they end, and go on with the others."""
        rows = running[which]
        x[rows], seen[rows] = last.T[which], lanes.x.T[which]
        found.objective[rows], found.gradient[rows] = lanes.objective[which], lanes.gradient.T[which]
        found.matrix[rows] = lanes.matrix[which]
        return lanes.among(~which)

    with np.errstate(all="ignore"):
        for _ in range(max_iterations):
            here, damped, bright = lanes.x, lanes.damping, lanes.bright
            at = At(here, lanes.objective, lanes.gradient, lanes.matrix.transpose(1, 2, 0))
            stopped = levenberg.held(algebra, at, box, lanes.fixed, bright)
            step, scale = None, levenberg.scale_of(algebra, at.matrix, box)
            for _round in range(levenberg.ROUNDS):
                step, stopped, leaving = levenberg.bounded_step(algebra, at, damped.size, box, stopped, step, scale)
                if not np.count_nonzero(leaving):
                    break
            assert step is not None
            moved, promised, ending = levenberg.proposal(algebra, at, damped, step, box, precision, bright)
            last = moved if not settled else np.where(promised < settled * at.objective, here, moved)
            if spare is not None:  # these stay where they are
                superfluous = spare(here.T, at.objective, iterations[running])
                if np.count_nonzero(superfluous):
                    last = np.where(superfluous, here, last)
                    ending = np.where(superfluous, _GIVEN_UP, ending)
            if np.count_nonzero(ending):
                ended = ending != 0
                endings[running[ended]] = ending[ended].astype(np.intp)
                lanes, running = end(ended, last), running[~ended]
                if not len(running):
                    break
                moved, promised, damped = moved[:, ~ended], promised[~ended], lanes.damping
            iterations[running] += 1
            new = at_rows(moved.T, running)
            verdict = levenberg.judged(algebra, lanes.objective, new.objective, promised, damped, precision)
            lanes = lanes.after(moved, new, verdict.better > 0, verdict.damping)
        if len(running):
            end(np.ones(len(running), bool), lanes.x)
    return Solution(x, seen, found, [levenberg.ENDINGS[code] for code in np.maximum(endings, 0)], iterations)


class _Lanes(NamedTuple):
    """What is known of the fits that still run: numbers, a column each, in one array, which is quickly cut; and their matrices (B, P, P).

    From the top the numbers are the parameters (P,), the gradient (P,), what is held (P,), the objective, the damping and the brightness.
    """

    numbers: Any
    matrix: Any

    @classmethod
    def of(cls, x: Floats, at: Normal, fixed: NDArray[Any], bright: float | Floats, damping: float) -> _Lanes:
        """Those that begin at points (B, P)."""
        size = x.shape[1]
        numbers = np.empty((3 * size + 5, len(x)))
        numbers[:size], numbers[size : 2 * size] = x.T, at.gradient.T
        numbers[2 * size : 3 * size] = np.broadcast_to(fixed, x.shape).T
        numbers[3 * size :] = 0.0
        numbers[-5], numbers[-4], numbers[-3] = at.objective, damping, levenberg.FIRST_GROWTH
        numbers[-1] = bright
        return cls(numbers, at.matrix)

    @property
    def x(self) -> Any:
        return self.numbers[: self.matrix.shape[1]]

    @property
    def gradient(self) -> Any:
        size = self.matrix.shape[1]
        return self.numbers[size : 2 * size]

    @property
    def fixed(self) -> Any:
        size = self.matrix.shape[1]
        return self.numbers[2 * size : 3 * size]

    @property
    def objective(self) -> Any:
        return self.numbers[-5]

    @property
    def damping(self) -> Damping:
        return Damping(self.numbers[-4], self.numbers[-3], self.numbers[-2])

    @property
    def bright(self) -> Any:
        return self.numbers[-1]

    def among(self, rows: NDArray[np.bool_]) -> _Lanes:
        """Some of them."""
        return _Lanes(self.numbers[:, rows], self.matrix[rows])

    def after(self, moved: Floats, new: Normal, better: NDArray[np.bool_], damping: Damping) -> _Lanes:
        """The same at points (P, B) where those are better, with the damping that follows."""
        numbers = self.numbers.copy()
        size = self.matrix.shape[1]
        numbers[-4], numbers[-3], numbers[-2] = damping
        if np.count_nonzero(better) == len(better):
            numbers[:size], numbers[size : 2 * size], numbers[-5] = moved, new.gradient.T, new.objective
            return _Lanes(numbers, new.matrix)
        for part, now in (
            (numbers[:size], moved),
            (numbers[size : 2 * size], new.gradient.T),
            (numbers[-5], new.objective),
        ):
            np.copyto(part, now, where=better)
        return _Lanes(numbers, np.where(better[:, None, None], new.matrix, self.matrix))
