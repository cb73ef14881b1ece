"""Levenberg-Marquardt with box bounds, on many parameter vectors at once.

All starts of a fit advance together: their normal equations come from one pass over the data, and those that have
converged leave the batch. A parameter at a bound whose gradient points outwards is held for the step; one that a step
would carry past a bound stops there, and the others are solved for again; damping follows Nielsen (1999), with the
diagonal of the normal matrix as the scale (Marquardt), so that units do not matter."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motes.fitting.losses import Floats
from motes.fitting.problem import Normal
from motes.fitting.result import Status

# A parameter that, moved by its own size, changes the squared residuals by less than this share of the objective stays
# where it is for a step: its derivative is noise, and a step along it would spoil the steps of the others.
BLIND = 1e-18
# A fit ends after so many better points in a row, none of them better by 100 times what `minimize` takes for converged:
# it creeps along a valley that the data hardly tell from its floor.
PATIENCE = 8


@dataclass
class Solution:
    """Where each start ended: parameters (B, P), the normal equations there, why, and after how many iterations."""

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
    max_iterations: int = 200,
    reduction: float = 1e-10,
    step: float = 1e-9,
) -> Solution:
    """Minimise from each row of `x` (B, P) within [low, high] (P,).

    Parameters
    ----------
    normal
        Objective, gradient and Gauss-Newton matrix of a batch; see `motes.fitting.problem.Problem.normal`.
    held
        Parameters (P,) that stay as they are, or (B, P) for each row its own.
    sets
        What each row belongs to (B,), passed on to `normal` as a second argument.
    reduction
        Converged when a full step promises less than this share of the objective; see also `PATIENCE`.
    step
        Converged when a step moves every parameter by less than this share of it.
    """
    x = np.clip(np.array(x, float), low, high)
    batch, size = x.shape
    held = np.broadcast_to(np.zeros(size, bool) if held is None else held, x.shape)

    def at_rows(points: Floats, rows: NDArray[np.intp]) -> Normal:
        return normal(points) if sets is None else normal(points, sets[rows])

    at = at_rows(x, np.arange(batch))
    objective, gradient, matrix = (np.array(part) for part in at)
    status = [Status.MAX_ITERATIONS] * batch
    iterations = np.zeros(batch, np.int64)
    damping, growth = np.full(batch, 1e-3), np.full(batch, 2.0)
    idle = np.zeros(batch, np.int64)
    running = np.arange(batch)
    with np.errstate(all="ignore"):
        for _ in range(max_iterations):
            if not len(running):
                break
            xs, gs, hs = x[running], gradient[running], matrix[running]
            blind = np.einsum("bpp->bp", hs) * np.maximum(np.abs(xs), 1e-3) ** 2 <= BLIND * objective[running][:, None]
            stuck = held[running] | blind | ((xs <= low) & (gs > 0)) | ((xs >= high) & (gs < 0))
            moved = np.clip(xs + _bounded_step(hs, gs, damping[running], stuck, low - xs, high - xs), low, high)
            delta = moved - xs
            promised = -np.einsum("bp,bp->b", gs, delta) - 0.5 * np.einsum("bp,bpq,bq->b", delta, hs, delta)
            small = np.abs(delta) <= step * (np.abs(xs) + step)
            full_step = damping[running] <= 1e-2
            done = {
                Status.PERFECT: objective[running] <= 1e-30,
                Status.CONVERGED: full_step & (np.abs(promised) <= reduction * objective[running]),
                # Any step is small once it is damped enough: what it promises must be rounding then.
                Status.SMALL_STEP: small.all(axis=1) & (full_step | (promised <= 1e-13 * objective[running])),
                Status.IDLE: idle[running] >= PATIENCE,
                Status.NO_PROGRESS: damping[running] > 1e12,
            }
            finished = np.zeros(len(running), bool)
            for reason, which in done.items():
                for k in running[which & ~finished]:
                    status[k] = reason
                finished |= which
            running, moved, promised = running[~finished], moved[~finished], promised[~finished]
            if not len(running):
                break
            new = at_rows(moved, running)
            iterations[running] += 1
            gain = (objective[running] - new.objective) / np.where(promised > 0, promised, np.inf)
            better = np.isfinite(new.objective) & (new.objective < objective[running])
            accepted = running[better]
            shrunk = objective[accepted] - new.objective[better] > 100 * reduction * objective[accepted]
            idle[accepted] = np.where(shrunk, 0, idle[accepted] + 1)
            x[accepted] = moved[better]
            objective[accepted], gradient[accepted], matrix[accepted] = (part[better] for part in new)
            factor = np.clip(1 - (2 * gain - 1) ** 3, 1 / 5, 2.0)
            damping[running] *= np.where(better, factor, growth[running])
            damping[running] = np.maximum(damping[running], 1e-12)
            growth[running] = np.where(better, 2.0, 2 * growth[running])
    return Solution(x, Normal(objective, gradient, matrix), status, iterations)


def _bounded_step(
    matrix: Floats, gradient: Floats, damping: Floats, stuck: NDArray[np.bool_], low: Floats, high: Floats
) -> Floats:
    """A step (B, P) within [low, high]: what would leave stops at its bound, and the others are solved for again."""
    step = np.zeros_like(gradient)
    for _ in range(3):
        against = gradient + np.einsum("bpq,bq->bp", matrix, np.where(stuck, step, 0.0))
        step = np.where(stuck, step, _step(matrix, against, damping, stuck))
        leaves = ~stuck & ((step < low) | (step > high))
        step, stuck = np.clip(step, low, high), stuck | leaves
        if not leaves.any():
            break
    return step


def _step(matrix: Floats, gradient: Floats, damping: Floats, stuck: NDArray[np.bool_]) -> Floats:
    """Solve (H + damping diag H) step = -gradient for what is not stuck; scaled so that the diagonal is 1."""
    diagonal = np.einsum("bpp->bp", matrix)
    largest = diagonal.max(axis=1, keepdims=True)
    scale = 1 / np.sqrt(np.maximum(diagonal, 1e-20 * np.maximum(largest, 1e-300)))
    scaled = matrix * scale[:, :, None] * scale[:, None, :]
    free = ~stuck
    scaled *= free[:, :, None] & free[:, None, :]
    size = matrix.shape[1]
    index = np.arange(size)
    scaled[:, index, index] = np.where(free, 1 + damping[:, None], 1.0)
    right = -(gradient * scale) * free
    try:
        solved = np.linalg.solve(scaled, right[..., None])[..., 0]
    except np.linalg.LinAlgError:  # exactly singular: the smallest solution
        solved = np.stack([np.linalg.lstsq(a, b, rcond=1e-12)[0] for a, b in zip(scaled, right, strict=True)])
    return np.where(np.isfinite(solved), solved, right) * scale
