"""The iteration of `motes.fitting.levenberg`, as functions of rows."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np

from motes.fitting import covariance, levenberg
from motes.fitting.printed.formulas import Formula, Formulas, triangle_of
from motes.fitting.printed.rows import Rows, Target, Uniform, lane_function

#: What follows the point and its normal equations in the rows of a block's state.
SCALARS = ("damping", "growth", "idle", "running", "iterations", "ending", "brightness")
# Less than this share of the data's square says nothing: residuals are differences of numbers in float32, moments are sums of float64 in the end.
LEAST_NOISE = {"direct": 1e-10, "moments": 1e-12, "series": 1e-12}


def step_functions(size: int, form: str, apart: Collection[int]) -> list[str]:
    """``held``, ``bounded_step``, ``proposal``, ``ended``, ``judged`` and ``rested`` for so many coefficients, in a form of the normal equations whose
    matrix is 0 where coefficients are `apart` (packed).

    Their rows: ``state`` (the point, normal equations, `SCALARS`), ``own`` (1 for each coefficient that the texel holds), ``stops`` (what is
    stopped, the step, how many left the box), ``trial`` (a point, what it promises, why it is the last), ``fresh`` (normal
    equations there).  Normal equations are the objective, its terms, gradient and matrix.
    """
    algebra = Formulas()
    graph = algebra.graph
    x, gradient, matrix = (
        algebra.vector("x", size),
        algebra.vector("gradient", size),
        algebra.matrix("matrix", size, apart),
    )
    objective, terms = algebra.number("objective"), algebra.number("terms")
    normal = [objective[0], terms[0], *gradient, *triangle_of(matrix)]
    scalars = [algebra.number(name) for name in SCALARS]
    damping, (running, iterations, ending, brightness) = levenberg.Damping(*scalars[:3]), scalars[3:]
    low, high, unit, fixed = (algebra.vector(name, size) for name in ("low", "high", "unit", "fixed"))
    bounds = levenberg.Box(low, high, unit)
    reduction, rounding = algebra.number("reduction"), algebra.number("rounding")
    precision = levenberg.Precision(reduction, rounding * terms + LEAST_NOISE[form] * brightness)
    at = levenberg.At(x, objective, gradient, matrix)
    state = Rows("state", "D").all([*x, *normal, *(s[0] for s in scalars)])
    own = Rows("own", "D").put(fixed)
    box = Uniform("box", (*low, *high, *unit, *reduction, *rounding))
    given, stopped = algebra.vector("given", size), algebra.vector("stopped", size)
    stops = Rows("stops", "D").put([*stopped, *given])

    stuck = levenberg.held(algebra, at, bounds, fixed, brightness)
    held = lane_function(
        "held", [state, box, own], [Target("stops", "D", [*algebra.lifted(stuck), *algebra.lifted(np.zeros(size))])]
    )
    step = levenberg.bounded_step(
        algebra, at, damping.size, bounds, stopped, given, levenberg.scale_of(algebra, matrix, bounds)
    )
    results = [*algebra.lifted(step.stopped), *algebra.lifted(step.step), *algebra.lifted(step.leaving)]
    bounded_step = lane_function("bounded_step", [state, box, stops], [Target("next_stops", "D", results)])
    proposed = levenberg.proposal(algebra, at, damping, given, bounds, precision, brightness)
    zero = np.zeros(1)
    moved = algebra.where(algebra.less(zero, running), proposed.moved, x)
    results = [*moved, *algebra.lifted(proposed.promised), *algebra.lifted(proposed.ending)]
    proposal = lane_function("proposal", [state, box, stops], [Target("trial", "D", results)])

    # A lane that ends takes its last point and is left alone from then on.
    points, promised, reason = algebra.vector("point", size), algebra.number("promised"), algebra.number("reason")
    trial = Rows("trial", "D").put([*points, *promised, *reason])
    ends = running * algebra.where(algebra.less(zero, reason), 1.0, 0.0)
    goes_on = running - ends
    last = algebra.where(algebra.less(zero, ends), reason, ending)
    stays = [
        *algebra.where(algebra.less(zero, ends), points, x), *normal,
        *(item for part in damping for item in part), *goes_on, *iterations, *last, *brightness,
    ]  # fmt: skip
    ended = lane_function("ended", [state, trial], [Target("next_state", "D", stays)])
    new = [graph.leaf(f"new[{k}]") for k in range(2 + size)] + triangle_of(algebra.matrix("new_matrix", size, apart))

    def either(taken: Formula, new: list[Any]) -> list[Any]:
        """The normal equations of the new point where it is taken."""
        condition = algebra.less(zero, taken)[0]
        return [b if a is b else graph.where(condition, a, b) for a, b in zip(new, normal, strict=True)]

    verdict = levenberg.judged(algebra, objective, np.array(new[:1], object), promised, damping, precision)
    taken = verdict.better * goes_on
    updated = [
        *algebra.where(algebra.less(zero, taken + ends), points, x),
        *either(taken, new),
        *(
            algebra.where(algebra.less(zero, goes_on), after, before)[0]
            for after, before in zip(verdict.damping, damping, strict=True)
        ),
        *goes_on,
        *(iterations + goes_on),
        *last,
        *brightness,
    ]
    fresh = Rows("fresh", "D").all(new)
    judged = lane_function("judged", [state, box, trial, fresh], [Target("next_state", "D", updated)])
    # Of a lane that did not move the normal equations stay as they are: those of the point before its last step.
    taken = covariance.alike(algebra, objective, np.array(new[:1], object)) * algebra.where(
        algebra.less(zero, promised), 1.0, 0.0
    )
    settled = [
        *algebra.where(algebra.less(zero, taken), points, x),
        *either(taken, new),
        *(s[0] for s in scalars),
    ]
    rested = lane_function("rested", [state, trial, fresh], [Target("next_state", "D", settled)])
    return [held, bounded_step, proposal, ended, judged, rested]
