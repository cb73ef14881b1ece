"""The steps of `motes.fitting.levenberg` over NumPy: many parameter vectors at once.

All starts of a fit advance together: their normal equations come from one pass over the data, and those that have
converged leave the batch."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.fitting import levenberg
from motes.fitting.algebra import ARRAYS, Arrays
from motes.fitting.levenberg import At, Box, Damping, Precision
from motes.fitting.losses import Floats
from motes.fitting.verdicts import Status

#: A last step that raises the objective by more than this share of it was none.
UPHILL = 1e-6
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
    algebra
        What the Gauss-Newton matrices are solved with.
    spare
        Which of the fits that still run to give up; their status is that of those whose iterations ran out.
    """
    x = np.clip(np.array(x, float), low, high)
    batch, size = x.shape
    fixed = np.broadcast_to(np.zeros(size) if held is None else held, x.shape).astype(float)
    bright = np.broadcast_to(np.asarray(brightness, float), (batch,))
    box = Box(*(np.broadcast_to(np.asarray(part, float), (size,))[:, None] for part in (low, high, unit)))
    precision = Precision(np.float64(reduction), np.float64(0.0))

    def at_rows(points: Floats, rows: NDArray[np.intp]) -> Normal:
        return normal(points) if sets is None else normal(points, sets[rows])

    found, seen = Normal(*(np.array(part) for part in at_rows(x, np.arange(batch)))), x.copy()
    endings, iterations = np.zeros(batch, np.intp), np.zeros(batch, np.int64)
    first = levenberg.FIRST_DAMPING, levenberg.FIRST_GROWTH, 0.0
    running = np.arange(batch)
    damping = Damping(*(np.full(batch, number) for number in first))
    lanes = _Lanes(x, found.objective, found.gradient, found.matrix, damping, fixed, bright)

    def end(which: NDArray[np.bool_]) -> _Lanes:
        """Put down where some of the lanes are, and go on with the others."""
        rows = running[which]
        x[rows] = seen[rows] = lanes.x[which]
        found.objective[rows], found.gradient[rows], found.matrix[rows] = (
            part[which] for part in (lanes.objective, lanes.gradient, lanes.matrix)
        )
        return lanes.among(~which)

    with np.errstate(all="ignore"):
        for _ in range(max_iterations):
            if spare is not None:
                superfluous = spare(lanes.x, lanes.objective, iterations[running])
                if superfluous.any():
                    lanes, running = end(superfluous), running[~superfluous]
                if not len(running):
                    break
            at = At(lanes.x.T, lanes.objective, lanes.gradient.T, lanes.matrix.transpose(1, 2, 0))
            stopped = levenberg.held(algebra, at, box, lanes.fixed.T, lanes.bright)
            step, scale = None, levenberg.scale_of(algebra, at.matrix, box)
            for _round in range(levenberg.ROUNDS):
                step, stopped, leaving = levenberg.bounded_step(
                    algebra, at, lanes.damping.size, box, stopped, step, scale
                )
                if not leaving.any():
                    break
            assert step is not None
            proposed = levenberg.proposal(algebra, at, lanes.damping, step, box, precision, lanes.bright)
            moved, promised = proposed.moved.T, proposed.promised
            ended = proposed.ending > 0
            if ended.any():
                endings[running[ended]] = proposed.ending[ended].astype(np.intp)
                last, steps = running[ended], moved[ended]
                lanes, running, moved, promised = end(ended), running[~ended], moved[~ended], promised[~ended]
                x[last] = steps
                if not len(running):
                    break
            iterations[running] += 1
            new = at_rows(moved, running)
            verdict = levenberg.judged(algebra, lanes.objective, new.objective, promised, lanes.damping, precision)
            better = verdict.better > 0
            taken: list[Floats] = [moved, *new]
            if not better.all():
                was = (lanes.x, lanes.objective, lanes.gradient, lanes.matrix)
                taken = [
                    np.where(better.reshape(-1, *[1] * (now.ndim - 1)), now, before)
                    for now, before in zip(taken, was, strict=True)
                ]
            lanes = _Lanes(taken[0], taken[1], taken[2], taken[3], verdict.damping, lanes.fixed, lanes.bright)
        end(np.ones(len(running), bool))
    return Solution(x, seen, found, [levenberg.ENDINGS[code] for code in endings], iterations)


class _Lanes(NamedTuple):
    """What is known of the fits that still run: of each (P,), (), (P,), (P, P), the damping, what is held (P,), and ()."""

    x: Floats
    objective: Floats
    gradient: Floats
    matrix: Floats
    damping: Damping
    fixed: Floats
    bright: Floats

    def among(self, rows: NDArray[np.bool_]) -> _Lanes:
        """Some of them."""
        x, objective, gradient, matrix, damping, fixed, bright = self
        damped = Damping(*(part[rows] for part in damping))
        return _Lanes(x[rows], objective[rows], gradient[rows], matrix[rows], damped, fixed[rows], bright[rows])
