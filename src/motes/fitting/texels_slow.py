"""Fits of texels without a kernel, by the solver of `motes.fit`: for sizes that `motes.fitting.printed` has no code for, and as its check."""

from __future__ import annotations

import numpy as np

from motes.fitting.covariance import VERDICTS
from motes.fitting.joint import Joint
from motes.fitting.losses import ROBUST, Floats
from motes.fitting.printed.driver import STATE
from motes.fitting.problem import Problem
from motes.fitting.scans import single
from motes.fitting.texel_kernel import MAX_ITERATIONS, Raw, Singles
from motes.fitting.texel_setup import TexelSetup
from motes.fitting.uncertainty import at_rest, uncertainty
from motes.fitting.verdicts import Status

_FAILURES = (Status.MAX_ITERATIONS, Status.NO_PROGRESS)


def problem_of(solver: TexelSetup, data: Singles) -> Problem:
    """The problem with texels, or with the times of one, as data sets: values (T, D, C) in float64, NaN left out."""
    good = np.isfinite(data)
    slots = {slot.name: slot for slot in solver.brdf.slots()}
    fitted = {q.name for q in solver.quantities}
    held = {name: slot for name, slot in slots.items() if name not in fitted}
    return Problem(
        model=solver.brdf,
        quantities=solver.quantities,
        fixed={
            name: np.asarray(slot.value)[None, None, :] if np.ndim(slot.value) else slot.value
            for name, slot in held.items()
        },
        wi=solver.wi,
        wo=solver.wo,
        values=np.where(good, data, 0).astype(float),
        weights=np.where(good, solver.weights[:, None], 0.0),
        loss=solver.loss,
        robust=ROBUST["none"],
        unit=solver.unit,
    )


def fit_slowly(solver: TexelSetup, data: Singles, starts: Floats, own_starts: bool) -> Raw:
    """As `motes.fitting.texels.TexelSolver.fit`, from points in the coordinates of the fit."""
    size = solver.size
    raw = Raw.at(np.full((len(data), size), np.nan), 0)
    for k in range(len(data)):
        problem = problem_of(solver, data[k] if solver.parts else data[k : k + 1])
        own = starts[k : k + 1] if own_starts else starts
        states = dict.fromkeys(STATE, 0.0) | {
            "samples": float(problem.samples),
            "brightness": float(problem.brightness().sum()),
        }
        if problem.samples > size and states["brightness"] > 0:
            objective: Problem | Joint
            if solver.parts:
                assert solver.hours is not None
                objective = Joint(problem, solver.hours, np.arange(len(solver.hours)), solver.parts)
            else:
                objective = problem = single(problem, 0)
            solution = objective.solve(own, max_iterations=MAX_ITERATIONS)
            best = solution.best()
            x = raw.points[k] = at_rest(objective, solution.x[best])
            errors = uncertainty(objective, x)
            raw.values[k], raw.errors[k] = solver.values(x), errors.stderr
            raw.codes[k] = [VERDICTS.index(verdict) for verdict in errors.verdicts]
            states |= {
                "running": float(solution.status[best] in _FAILURES),
                "iterations": float(solution.iterations[best]),
                "squares": 2 * float(objective.normal(x[None]).objective[0]),
            }
        raw.states[k] = [states[name] for name in STATE]
    return raw
