"""One iteration of Levenberg-Marquardt with box bounds, in named steps over an algebra (`motes.fitting.algebra`).

`motes.fitting.solver` runs them over NumPy, `motes.fitting.printed` prints them into kernels: the same steps and the same
constants for one fit and for millions.  A parameter at a bound whose gradient points outwards is held for the step, and one
that a step would carry past a bound stops there and the others are solved for again; damping follows Nielsen (1999), with
the diagonal of the normal matrix as the scale (Marquardt), so that units do not matter.

Each iteration is `held`, `bounded_step` (as often as something leaves the box, `ROUNDS` at most), `proposal`, the normal
equations at the proposed point, and `judged`.  A step that converges is taken without another look at the data: what is
left is the error of the step after it.
"""

from __future__ import annotations

from typing import NamedTuple

from motes.arrays import Array
from motes.fitting.algebra import Algebra, absolute, chosen, flag
from motes.fitting.verdicts import Status

FIRST_DAMPING, LEAST_DAMPING, MOST_DAMPING = 1e-3, 1e-10, 1e12
FIRST_GROWTH = 2.0
# With more damping than this a small step says nothing about convergence.
FULL_STEP = 1e-2
# A parameter that, moved by its own size, changes the squared residuals by less than this share of the data's square stays
# where it is for a step: its derivative is noise, and a step along it would spoil the steps of the others.
BLIND = 1e-18
# A fit ends after so many better points in a row that are hardly better: it creeps along a valley that the data hardly
# tell from its floor.  Hardly better is by less than this many times what counts as converged.
PATIENCE, HARDLY = 8.0, 100.0
# A step that moves every parameter by less than this share of it is the last.
SMALL_STEP = 1e-9
# An objective below this share of the data's square is zero.
PERFECT = 1e-30
# A step from the solution that promises more than this share of the objective is none: the gradient that asks for it is rounding.
LAST_REDUCTION = 1e-4
# How often a step is solved for again because something left the box.
ROUNDS = 3

# A fit whose normal equations are approximate has ended elsewhere when the exact gradient there promises more than this share of a residual's variance
# (half the square of 0.06 standard errors; the last step takes care of less), and of the data's square.
MOST_DRIFT, LEAST_DRIFT = 2e-3, 1e-11

#: Why a lane ended, by the code that `proposal` gives it; 0 goes on.
ENDINGS = (
    Status.MAX_ITERATIONS,
    Status.PERFECT,
    Status.CONVERGED,
    Status.SMALL_STEP,
    Status.IDLE,
    Status.NO_PROGRESS,
)


class At(NamedTuple):
    """A point (P, B), and there half the sum of squares (B,), its gradient (P, B) and the matrix J'J (P, P, B)."""

    x: Array
    objective: Array
    gradient: Array
    matrix: Array


class Box(NamedTuple):
    """The bounds of the parameters (P, 1), and how large ordinary values are: `motes.fitting.columns.Columns.unit`."""

    low: Array
    high: Array
    unit: Array


class Damping(NamedTuple):
    """How much a step is damped, by what that grows, and how many points in a row were hardly better; all (B,)."""

    size: Array
    growth: Array
    idle: Array


class Precision(NamedTuple):
    """The share of the objective that a full step must promise for a fit to go on, and what objectives are rounded to; (B,) or one number."""

    reduction: Array
    noise: Array


class Step(NamedTuple):
    """A bounded step (P, B); 1 for what is stopped, those that it stopped included; how many it stopped (B,)."""

    step: Array
    stopped: Array
    leaving: Array


class Proposal(NamedTuple):
    """Where a step leads (P, B), what it promises to take off the objective (B,), and why it is the last one: a position in `ENDINGS`, or 0."""

    moved: Array
    promised: Array
    ending: Array


class Judgement(NamedTuple):
    """1 where the new point is taken (B,), and the damping that follows."""

    better: Array
    damping: Damping


def held(algebra: Algebra, at: At, box: Box, fixed: Array, brightness: Array) -> Array:
    """1 for what stays as it is in this step: fixed, not seen by the data, or at a bound and pushed out; else 0.

    `brightness` is the weighted sum of squares of the data.
    """
    x, gradient = at.x, at.gradient
    size = algebra.maximum(absolute(algebra, x), 1e-3 * box.unit)
    unseen = flag(algebra, algebra.less(algebra.diagonal(at.matrix) * size * size, BLIND * brightness + 1e-300))
    at_low = algebra.where(algebra.less(box.low, x), 0.0, flag(algebra, algebra.less(0.0, gradient)))
    at_high = algebra.where(algebra.less(x, box.high), 0.0, flag(algebra, algebra.less(gradient, 0.0)))
    return algebra.maximum(algebra.maximum(unseen, fixed), algebra.maximum(at_low, at_high))


def diagonal_of(algebra: Algebra, matrix: Array, box: Box) -> Array:
    """The diagonal of the matrix (P, B), nothing of it negligible: that of Marquardt's damping."""
    diagonal = algebra.diagonal(matrix)
    square = box.unit * box.unit  # diagonals of other units are compared in theirs
    floor = algebra.maximum(1e-20 * algebra.largest(diagonal * square) / square, 1e-300)
    return algebra.maximum(diagonal, floor)


def scale_of(algebra: Algebra, matrix: Array, box: Box) -> Array:
    """What `bounded_step` is given of a matrix."""
    return algebra.scale(diagonal_of(algebra, matrix, box))


def bounded_step(
    algebra: Algebra, at: At, damping: Array, box: Box, stopped: Array, given: Array | None, scale: Array
) -> Step:
    """Solve (H + damping diag H) step = -gradient for what is not `stopped`, whose steps are `given`; then stop what leaves the box.

    `given` is None where all of them are 0; `scale` as `scale_of` finds it.
    """
    free = 1.0 - stopped
    against = at.gradient if given is None else at.gradient + algebra.times(at.matrix, stopped * given)
    solved = algebra.damped(at.matrix, -against, free, damping, scale)
    wanted = solved if given is None else chosen(algebra, stopped, given, solved)
    within = algebra.minimum(algebra.maximum(wanted, box.low - at.x), box.high - at.x)
    leaves = free * algebra.maximum(
        flag(algebra, algebra.less(within, wanted)), flag(algebra, algebra.less(wanted, within))
    )
    return Step(within, stopped + leaves, algebra.total(leaves))


def proposal(
    algebra: Algebra, at: At, damping: Damping, step: Array, box: Box, precision: Precision, brightness: Array
) -> Proposal:
    """The point of a step, and whether it is the last: see `ENDINGS`; `brightness` as for `held`."""
    x, objective, noise = at.x, at.objective, precision.noise
    moved = algebra.minimum(algebra.maximum(x + step, box.low), box.high)
    delta = moved - x
    promised = -algebra.total(delta * (at.gradient + 0.5 * algebra.times(at.matrix, delta)))
    full = flag(algebra, algebra.less(damping.size, FULL_STEP))
    # Any step is small once it is damped enough: what it promises must be rounding then.
    nothing = flag(algebra, algebra.less(promised, 1e-13 * objective + 1e-6 * noise))
    away = algebra.largest(absolute(algebra, delta) / (absolute(algebra, x) + SMALL_STEP * box.unit))
    small = flag(algebra, algebra.less(away, SMALL_STEP))
    converged = flag(algebra, algebra.less(promised, precision.reduction * objective + 1e-2 * noise + 1e-300))
    zero = 0.0 * objective
    perfect = PERFECT * algebra.where(algebra.less(0.0, brightness), brightness, 1.0)
    ending = zero
    for code, condition in (  # the first that holds wins
        (5.0, flag(algebra, algebra.less(MOST_DAMPING, damping.size))),
        (4.0, flag(algebra, algebra.less(PATIENCE - 0.5, damping.idle))),
        (
            3.0,
            algebra.maximum(small * full, nothing * algebra.maximum(small, flag(algebra, algebra.less(0.0, noise)))),
        ),
        (2.0, converged * full),
        (1.0, flag(algebra, algebra.less(objective, perfect))),
    ):
        ending = chosen(algebra, condition, code, ending)
    return Proposal(moved, algebra.maximum(promised, zero), ending)


def judged(
    algebra: Algebra, objective: Array, trial: Array, promised: Array, damping: Damping, precision: Precision
) -> Judgement:
    """Whether the objective at the new point, `trial`, is better (NaN is not), and the damping that follows."""
    reduction, noise = precision
    better = flag(algebra, algebra.less(trial, objective + noise))
    surprise = 2.0 * ((objective - trial + noise) / (promised + noise + 1e-300)) - 1.0
    factor = algebra.minimum(algebra.maximum(1.0 - surprise * surprise * surprise, 0.2), 2.0)
    shrunk = algebra.less(HARDLY * reduction * objective + noise, objective - trial)
    after = Damping(
        algebra.maximum(damping.size * chosen(algebra, better, factor, damping.growth), LEAST_DAMPING),
        chosen(algebra, better, FIRST_GROWTH, 2.0 * damping.growth),
        chosen(algebra, better, algebra.where(shrunk, 0.0, damping.idle + 1.0), damping.idle),
    )
    return Judgement(better, after)


def polished(
    algebra: Algebra, x: Array, objective: Array, ending: Array, gradient: Array, inverse: Array, among: Array, box: Box
) -> Array:
    """The point (P, B) one full step on from where a fit ended, by a gradient that is sure to more digits than those of the fit.

    Only lanes that ended by themselves move, and only what is in `among`, with the `inverse` of its matrix.
    """
    step = -algebra.times(inverse, gradient) * among
    promised = -0.5 * algebra.total(step * gradient)
    zero = 0.0 * objective
    small = flag(algebra, algebra.less(promised, LAST_REDUCTION * objective + zero))
    return algebra.minimum(algebra.maximum(x + step * (small * _by_itself(algebra, ending)), box.low), box.high)


def adrift(
    algebra: Algebra,
    variance: Array,
    brightness: Array,
    ending: Array,
    gradient: Array,
    inverse: Array,
    among: Array,
) -> Array:
    """1 where a fit that ended by itself did not end where the exact objective, with this `gradient`, has its minimum (B,).

    `variance` is that of a residual, `brightness` the data's sum of squares.
    """
    promised = 0.5 * algebra.total(algebra.times(inverse, gradient) * among * gradient)
    much = flag(algebra, algebra.less(MOST_DRIFT * variance + LEAST_DRIFT * brightness, promised))
    return much * _by_itself(algebra, ending)


def _by_itself(algebra: Algebra, ending: Array) -> Array:
    zero = 0.0 * ending
    return flag(algebra, algebra.less(0.5 + zero, ending)) * flag(algebra, algebra.less(ending, 4.5 + zero))
