"""One iteration of Levenberg-Marquardt with box bounds, as formulas over an array namespace.

`motes.fitting.printed.lanes` prints them into kernels, where a lane is a texel; on NumPy arrays they run as they are, which the tests use.  The
method is that of `motes.fitting.solver`: damping by Nielsen (1999) with the diagonal of the normal matrix as the scale; a parameter at a
bound whose gradient points outwards is held for the step, and one that a step would carry past a bound stops there and the others are
solved for again.  Nothing branches: what differs from lane to lane is chosen with ``where``.

Two things differ, since kernels work in float32: a step that converges is taken, not only judged, so that the error left is that of the
*next* step; and differences of objectives below their rounding (`noise`) count as none.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from motes.arrays import Array

LEAST_DAMPING, MOST_DAMPING = 1e-9, 1e12
# With more damping than this a small step says nothing about convergence.
FULL_STEP = 1e-2
# See `motes.fitting.solver.BLIND`; float32 sums cannot see less than this.
BLIND = 1e-16
# After so many better points in a row that are hardly better, a lane stops.
PATIENCE = 6.0


def packed(row: int, column: int) -> int:
    """Where an element of a symmetric matrix stands among the rows of its lower triangle."""
    row, column = max(row, column), min(row, column)
    return row * (row + 1) // 2 + column


class Step(NamedTuple):
    """A bounded step: the step itself and, for each parameter, 1 where it left the box and was stopped, besides those stopped before."""

    step: list[Array]
    stopped: list[Array]
    leaving: Array


def held(
    xp: Array,
    x: Sequence[Array],
    gradient: Sequence[Array],
    matrix: Sequence[Array],
    low: Sequence[Array],
    high: Sequence[Array],
    fixed: Sequence[Array],
    brightness: Array,
) -> list[Array]:
    """1 for what stays as it is in this step: fixed, unseen by the data, or at a bound and pushed out; else 0.

    `brightness` is the sum of squares of the data.
    """
    stuck = []
    for k, value in enumerate(x):
        size = xp.maximum(xp.maximum(value, -value), 1e-3)
        blind = matrix[packed(k, k)] * size * size <= BLIND * brightness
        outward = xp.where(
            gradient[k] > 0, value <= low[k], xp.where(gradient[k] < 0, value >= high[k], gradient[k] > 0)
        )
        stuck.append(xp.where(blind, 1.0, xp.where(outward, 1.0, fixed[k])))
    return stuck


def bounded_step(
    xp: Array,
    x: Sequence[Array],
    gradient: Sequence[Array],
    matrix: Sequence[Array],
    damping: Array,
    low: Sequence[Array],
    high: Sequence[Array],
    stopped: Sequence[Array],
    given: Sequence[Array],
) -> Step:
    """Solve (H + damping diag H) step = -gradient for what is not `stopped`, whose steps are `given`; then stop what leaves the box."""
    size = len(x)
    diagonal = [matrix[packed(k, k)] for k in range(size)]
    largest = diagonal[0]
    for d in diagonal[1:]:
        largest = xp.maximum(largest, d)
    floor = xp.maximum(1e-14 * largest, 1e-300)
    scale = [1 / xp.sqrt(xp.maximum(d, floor)) for d in diagonal]
    free = [1.0 - s for s in stopped]
    rows: list[list[Array]] = []
    inverse: list[Array] = []
    for i in range(size):  # L D L' of the scaled matrix, with unit rows for what is stopped
        row: list[Array] = []
        for j in range(i):
            a = matrix[packed(i, j)] * (scale[i] * scale[j]) * (free[i] * free[j])
            for k in range(j):
                a = a - row[k] * rows[j][k]
            row.append(a)
        pivot = 1.0 + damping
        unit = [a * inverse[k] for k, a in enumerate(row)]
        for a, u in zip(row, unit, strict=True):
            pivot = pivot - a * u
        rows.append(unit)
        inverse.append(1 / xp.maximum(pivot, 1e-9))
    z: list[Array] = []
    for i in range(size):
        against = gradient[i]
        for k in range(size):
            against = against + matrix[packed(i, k)] * (stopped[k] * given[k])
        a = -(against * scale[i] * free[i])
        for k in range(i):
            a = a - rows[i][k] * z[k]
        z.append(a)
    solved: list[Array] = [0.0] * size
    for i in reversed(range(size)):
        a = z[i] * inverse[i]
        for k in range(i + 1, size):
            a = a - rows[k][i] * solved[k]
        solved[i] = a
    step: list[Array] = []
    now: list[Array] = []
    leaving: Array = 0.0
    for k in range(size):
        wanted = xp.where(stopped[k] > 0, given[k], solved[k] * scale[k])
        down, up = low[k] - x[k], high[k] - x[k]
        within = xp.minimum(xp.maximum(wanted, down), up)
        leaves = xp.where(stopped[k] > 0, 0.0, xp.where(within < wanted, 1.0, xp.where(within > wanted, 1.0, 0.0)))
        step.append(within)
        now.append(stopped[k] + leaves)
        leaving = leaving + leaves
    return Step(step, now, leaving)


class Proposal(NamedTuple):
    """Where a step leads, what it promises to take off the objective, and 1 where it is the last one."""

    moved: list[Array]
    promised: Array
    last: Array


def proposal(
    xp: Array,
    x: Sequence[Array],
    objective: Array,
    gradient: Sequence[Array],
    matrix: Sequence[Array],
    damping: Array,
    idle: Array,
    step: Sequence[Array],
    low: Sequence[Array],
    high: Sequence[Array],
    reduction: Array,
    noise: Array,
) -> Proposal:
    """The point of a step, and whether the lane has converged: the step promises less than `reduction` of the objective, or than `noise`."""
    size = len(x)
    moved = [xp.minimum(xp.maximum(x[k] + step[k], low[k]), high[k]) for k in range(size)]
    delta = [m - v for m, v in zip(moved, x, strict=True)]
    promised: Array = 0.0
    for i in range(size):
        bend = 0.5 * matrix[packed(i, i)] * delta[i]
        for k in range(i):
            bend = bend + matrix[packed(i, k)] * delta[k]
        promised = promised - delta[i] * (gradient[i] + bend)
    small = promised <= reduction * objective + 1e-3 * noise
    full = xp.where(damping <= FULL_STEP, 1.0, 0.0)
    last = xp.where(small, full, 0.0)
    last = xp.maximum(last, xp.where(promised <= 1e-6 * noise, 1.0, 0.0))
    last = xp.maximum(last, xp.where(idle >= PATIENCE, 1.0, 0.0))
    last = xp.maximum(last, xp.where(damping > MOST_DAMPING, 1.0, 0.0))
    return Proposal(moved, xp.maximum(promised, 0.0), last)


class Judgement(NamedTuple):
    """1 where the new point is taken, and the state of the damping."""

    better: Array
    damping: Array
    growth: Array
    idle: Array


def judged(
    xp: Array,
    objective: Array,
    trial: Array,
    promised: Array,
    damping: Array,
    growth: Array,
    idle: Array,
    reduction: Array,
    noise: Array,
) -> Judgement:
    """Whether the objective at the new point, `trial`, is better (NaN is not), and the damping that follows."""
    gain = (objective - trial + noise) / (promised + noise)
    better = xp.where(trial < objective + noise, 1.0, 0.0)
    r = 2 * gain - 1
    factor = xp.minimum(xp.maximum(1 - r * r * r, 0.2), 2.0)
    shrunk = objective - trial > 100 * reduction * objective + noise
    new_damping = xp.maximum(damping * xp.where(better > 0, factor, growth), LEAST_DAMPING)
    return Judgement(
        better,
        new_damping,
        xp.where(better > 0, 2.0, 2 * growth),
        xp.where(better > 0, xp.where(shrunk, 0.0, idle + 1), idle),
    )
