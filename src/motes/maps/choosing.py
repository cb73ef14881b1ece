"""Which model a map prefers: the candidates that texels can tell apart, by the BIC (`motes.fitting.choice`), on texels from all over it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.errors import DataError, MotesError
from motes.fitting.choice import TEXEL_CANDIDATES, bic, summed
from motes.fitting.joint import Joint
from motes.fitting.losses import ROBUST, Floats
from motes.fitting.metrics import deviation, relative_rms
from motes.fitting.problem import Problem
from motes.fitting.result import Trial
from motes.fitting.scans import single
from motes.fitting.texels import TexelSolver, TexelStatus
from motes.fitting.texels_slow import problem_of
from motes.fitting.verdicts import Status
from motes.maps.settings import Settings, solver_of
from motes.maps.stack import MapStack, Singles
from motes.models import parse

# A candidate that more of the texels than this have too few samples for is not compared.
MOST_WITHOUT = 0.5


class Choice(NamedTuple):
    """The model, where its fits start (K, P), and what was tried: nothing where the model was given."""

    model: str
    starts: Floats
    tried: tuple[Trial, ...]


class _Fitted(NamedTuple):
    """A candidate on the texels: where fits start, and a trial of each texel, None where it has too few samples."""

    model: str
    starts: Floats
    trials: list[Trial | None]


def choose(stack: MapStack, settings: Settings, rows: Singles) -> Choice:
    """The model that was asked for, or with ``"auto"`` the candidate with the least sum of BICs over texels (M, [T,] D, C)."""
    if settings.model != "auto":
        solver = solver_of(stack, settings, settings.model)
        return Choice(settings.model, solver.starts(rows), ())
    texts = [text for text in TEXEL_CANDIDATES if set(parse(text).model.parameters) - set(settings.fixed)]
    if not texts:
        raise MotesError("every parameter is held, so there is nothing to fit", "Hold fewer parameters")
    found: list[_Fitted] = []
    too_few: DataError | None = None
    for text in texts:
        solver = solver_of(stack, settings.for_model(text), text)
        try:
            starts = solver.starts(rows)
        except DataError as error:  # of the smallest candidate, the first, when the data suffice for none
            too_few = too_few or error
            continue
        found.append(_Fitted(text, starts, _trials(solver, text, rows, starts)))
    if not found:
        assert too_few is not None
        raise too_few
    tried = compared([one.trials for one in found])
    best = next(trial.model for trial in tried if trial.chosen)
    return Choice(best, next(one.starts for one in found if one.model == best), tried)


def compared(by_model: list[list[Trial | None]]) -> tuple[Trial, ...]:
    """Trials of all texels, for the models that most texels have enough samples for; on the texels that have enough for all of those."""
    measured = [any(trials) for trials in zip(*by_model, strict=True)]
    kept = [
        trials
        for trials in by_model
        if sum(t is None for t, m in zip(trials, measured, strict=True) if m) <= MOST_WITHOUT * sum(measured)
        and any(trials)
    ]
    texels = [[t for t in trials if t is not None] for trials in zip(*kept, strict=True)]
    enough = [trials for trials in texels if trials and len(trials) == len(kept)]
    if not enough:
        raise DataError("no texel that was looked at has enough samples to compare models on", "Name the model")
    return summed(enough)


def _trials(solver: TexelSolver, text: str, rows: Singles, starts: Floats) -> list[Trial | None]:
    """A candidate, fitted to each texel."""
    solver = solver.in_units(solver.unit_of_starts(starts))
    fit = solver.fit(rows, starts)
    return [
        None if status in (TexelStatus.NO_DATA, TexelStatus.FAILED) else _trial(solver, text, row, x, int(status))
        for row, x, status in zip(rows, fit.x.astype(float), fit.status, strict=True)
    ]


def _trial(solver: TexelSolver, text: str, row: Singles, x: Floats, status: int) -> Trial:
    problem = problem_of(solver, row if solver.parts else row[None])
    point = solver.coordinates(x)
    if solver.parts:
        assert solver.hours is not None
        joint = Joint(problem, solver.hours, np.arange(len(solver.hours)), solver.parts)
        vectors = joint.vectors(point)[0].reshape(len(solver.hours), -1)
        parts = [single(problem_of(solver, row[t : t + 1]), 0) for t in range(len(row))]
    else:
        problem = single(problem, 0)
        vectors, parts = point[None], [problem]
    predicted = np.stack([one.predicted(v) for one, v in zip(parts, vectors, strict=True)])
    if solver.robust.name != "none":
        problem = problem.with_scale(ROBUST[solver.robust.name], _scale(parts, vectors))
    objective: Problem | Joint = (
        Joint(problem, solver.hours, np.arange(len(parts)), solver.parts)
        if solver.parts and solver.hours is not None
        else problem
    )
    half = float(objective.normal(point[None]).objective[0])
    good: NDArray[np.bool_] = np.stack([one.weights > 0 for one in parts])
    measured = np.stack([one.values for one in parts])
    return Trial(
        model=text,
        n_parameters=solver.size,
        bic=bic(half, problem.samples, solver.size, float(problem.brightness().sum())),
        relative_rms=relative_rms(predicted[good], measured[good]),
        objective=half,
        status=Status.MAX_ITERATIONS if status == TexelStatus.MAX_ITERATIONS else Status.CONVERGED,
        chosen=False,
        n_samples=problem.samples,
    )


def _scale(parts: list[Problem], vectors: Floats) -> float:
    """The size of noise among residuals, from their median."""
    residual = np.concatenate([p.residuals(v)[p.weights > 0] for p, v in zip(parts, vectors, strict=True)])
    return float(deviation(residual, parts[0].unit))
