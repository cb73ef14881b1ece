"""Fits of texels without a kernel: by the solver of `motes.fit`, for losses and sizes that `motes.fitting.printed.lanes` has no code for, and as its check."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from motes.fitting.joint import Joint
from motes.fitting.losses import ROBUST, Floats
from motes.fitting.problem import Problem
from motes.fitting.solver import Solution, minimize
from motes.fitting.verdicts import Status

if TYPE_CHECKING:
    from motes.fitting.texels import Singles, TexelFit, TexelSolver

_FAILURES = (Status.MAX_ITERATIONS, Status.NO_PROGRESS)


def problem_of(solver: TexelSolver, data: Singles) -> Problem:
    """The problem with texels, or with the times of one, as data sets: values (T, D, C) in float64, NaN left out."""
    good = np.isfinite(data).all(axis=-1, keepdims=True) & np.ones(data.shape, bool)
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
    )


def fit_slowly(solver: TexelSolver, data: Singles, starts: Floats, own_starts: bool) -> TexelFit:
    """As `TexelSolver.fit`."""
    from motes.fitting.texels import MAX_ITERATIONS, Raw

    count, size = len(data), solver.size
    raw = Raw.empty(count, size)
    for k in range(count):
        problem = problem_of(solver, data[k] if solver.parts else data[k : k + 1])
        weights, roots = problem.weights, problem._roots
        raw.samples[k] = np.count_nonzero(np.isfinite(data[k]).all(axis=-1)) * solver.channels
        raw.brightness[k] = np.sum((roots * problem._targets) ** 2)
        if raw.samples[k] <= size or raw.brightness[k] == 0:
            continue
        own = starts[k : k + 1] if own_starts else starts
        solution = _solved(solver, problem, own, MAX_ITERATIONS)
        best = solution.best()
        x = solution.x[best]
        raw.x[k], raw.iterations[k] = x, solution.iterations[best]
        raw.running[k] = solution.status[best] in _FAILURES
        raw.squares[k] = 2 * solution.normal.objective[best]
        raw.errors[k] = _errors(solver, problem, x, solution.normal.matrix[best])
        del weights
    return solver.finished(raw)


def _solved(solver: TexelSolver, problem: Problem, starts: Floats, limit: int) -> Solution:
    low, high = solver.bounds
    if not solver.parts:
        return minimize(problem.normal, starts, low, high, sets=np.zeros(len(starts), np.intp), max_iterations=limit)
    joint = _joint(solver, problem)
    return minimize(joint.normal, starts, low, high, max_iterations=limit)


def _joint(solver: TexelSolver, problem: Problem) -> Joint:
    assert solver.hours is not None
    return Joint(problem, solver.hours, np.arange(len(solver.hours)), solver.parts)


def _errors(solver: TexelSolver, problem: Problem, x: Floats, matrix: Floats) -> Floats:
    """Standard errors by the sandwich without leverages, as in the kernel, before the factor for the degrees of freedom."""
    low, high = solver.bounds
    span = 1e-9 + 1e-6 * np.abs(x)
    free = np.flatnonzero((x > low + span) & (x < high - span) & (np.diag(matrix) > 0))
    nothing = np.zeros((problem.size, problem.size))
    if solver.parts:
        points, jacobian = _joint(solver, problem).vectors(x)
        spreads = [problem.spread(p, nothing, np.array([t])) for t, p in enumerate(points)]
        middle = np.einsum("tpk,tpq,tql->kl", jacobian, np.stack(spreads), jacobian, optimize=True)
    else:
        middle = problem.spread(x, nothing, np.zeros(1, np.intp))
    inverse = np.zeros_like(matrix)
    scale = 1 / np.sqrt(np.diag(matrix)[free])
    inner = matrix[np.ix_(free, free)] * np.outer(scale, scale)
    inverse[np.ix_(free, free)] = np.linalg.pinv(inner, rcond=1e-12, hermitian=True) * np.outer(scale, scale)
    errors = np.full(len(x), np.nan)
    errors[free] = np.sqrt(np.maximum(np.diag(inverse @ middle @ inverse)[free], 0))
    return errors
