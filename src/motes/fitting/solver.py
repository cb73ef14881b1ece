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


class Normal(NamedTuple):
    """Half the (robust) sum of squares (B,), its gradient (B, P), and the Gauss-Newton matrix (B, P, P)."""

    objective: Floats
    gradient: Floats
    matrix: Floats


@dataclass
class Solution:
    """Where each start ended: parameters (B, P), the normal equations there, why, and after how many iterations.

    The normal equations are those of the point before the last step, which promised next to nothing.
    """

    x: Floats
    normal: Normal
    status: list[Status]
    iterations: NDArray[np.int64]

    def best(self) -> int:
        """The start with the smallest objective."""
        return int(np.argmin(self.normal.objective))


def minimize(
    normal: Callable[..., Normal],
    x: Floats,
    low: Floats,
    high: Floats,
    *,
    held: NDArray[np.bool_] | None = None,
    sets: NDArray[np.intp] | None = None,
    brightness: float | Floats = 0.0,
    max_iterations: int = 200,
    reduction: float = 1e-10,
    algebra: Arrays = ARRAYS,
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
    reduction
        Converged when a full step promises less than this share of the objective; see also `motes.fitting.levenberg`.
    algebra
        What the Gauss-Newton matrices are solved with.
    """
    x = np.clip(np.array(x, float), low, high)
    batch, size = x.shape
    fixed = np.broadcast_to(np.zeros(size) if held is None else held, x.shape).astype(float)
    bright = np.broadcast_to(np.asarray(brightness, float), (batch,))
    box = Box(*(np.broadcast_to(bound, (size,))[:, None] for bound in (low, high)))
    precision = Precision(np.float64(reduction), np.float64(0.0))

    def at_rows(points: Floats, rows: NDArray[np.intp]) -> Normal:
        return normal(points) if sets is None else normal(points, sets[rows])

    objective, gradient, matrix = (np.array(part) for part in at_rows(x, np.arange(batch)))
    endings, iterations = np.zeros(batch, np.intp), np.zeros(batch, np.int64)
    first = levenberg.FIRST_DAMPING, levenberg.FIRST_GROWTH, 0.0
    damping = Damping(*(np.full(batch, number) for number in first))
    running = np.arange(batch)
    with np.errstate(all="ignore"):
        for _ in range(max_iterations):
            if not len(running):
                break
            at = At(x[running].T, objective[running], gradient[running].T, matrix[running].transpose(1, 2, 0))
            damped = Damping(*(part[running] for part in damping))
            stopped = levenberg.held(algebra, at, box, fixed[running].T, bright[running])
            step = np.zeros_like(at.x)
            for _round in range(levenberg.ROUNDS):
                step, stopped, leaving = levenberg.bounded_step(algebra, at, damped.size, box, stopped, step)
                if not leaving.any():
                    break
            proposed = levenberg.proposal(algebra, at, damped, step, box, precision)
            moved, promised = proposed.moved.T, proposed.promised
            ended = proposed.ending > 0
            endings[running[ended]] = proposed.ending[ended].astype(np.intp)
            x[running[ended]] = moved[ended]
            running, moved, promised = running[~ended], moved[~ended], promised[~ended]
            if not len(running):
                break
            iterations[running] += 1
            new = at_rows(moved, running)
            damped = Damping(*(part[running] for part in damping))
            verdict = levenberg.judged(algebra, objective[running], new.objective, promised, damped, precision)
            for part, after in zip(damping, verdict.damping, strict=True):
                part[running] = after
            better = verdict.better > 0
            accepted = running[better]
            x[accepted] = moved[better]
            objective[accepted], gradient[accepted], matrix[accepted] = (part[better] for part in new)
    status = [levenberg.ENDINGS[code] for code in endings]
    return Solution(x, Normal(objective, gradient, matrix), status, iterations)
