"""One set of parameters for a measurement at one time."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from motes.directions import above
from motes.fitting.advice import about_choice
from motes.fitting.channels_among_many import even_channels
from motes.fitting.choice import CANDIDATES, bic, is_auto
from motes.fitting.climbing import climb, even_rows
from motes.fitting.data_passes import beside
from motes.fitting.direction_blocks import blocks_of
from motes.fitting.estimating import estimated
from motes.fitting.judgement import Contender, judged
from motes.fitting.later import Later
from motes.fitting.levenberg import FIRST_DAMPING
from motes.fitting.losses import ROBUST, Floats
from motes.fitting.metrics import chi_square, deviation, distances
from motes.fitting.nested import Found, nearer
from motes.fitting.plausibility import implausible_fit
from motes.fitting.problem import Problem
from motes.fitting.result import Fit, FittedParameter, Progress, Trial
from motes.fitting.scaled import NAME, Scaled, in_units
from motes.fitting.setup import Wishes, check_enough, prepare
from motes.fitting.solver import Solution
from motes.fitting.starts import starting_points
from motes.fitting.uncertainty import at_rest
from motes.fitting.verdicts import Status, Verdict
from motes.material import Material
from motes.measurements import Measurement
from motes.measurements.doubts import implausible
from motes.models import BRDF, describe
from motes.models.composition import layer_of
from motes.models.expressions import Parsed

#: With more than three times as many samples, starts are thinned out on a part of so many first, of `PARTS` the larger ones later.
PART_SAMPLES = 200_000
PARTS = ((PART_SAMPLES, 1), (20_000, 3))  # with how many of the starts are followed
# Where the fit to a part ended, the whole one starts a few standard errors from its end, and damping would only keep it from there.
NEAR_DAMPING = 1e-7


def fit_scan(
    data: Measurement,
    model: str | BRDF,
    wishes: Wishes,
    progress: Progress | None = None,
    below: Sequence[Found] = (),
) -> Fit:
    """Fit a measurement with one time; `below` is what fits of other models to it found, which a named model starts from where that is nearer."""
    started = clock.perf_counter()
    say = progress or (lambda done, total, what: None)
    if not is_auto(model):
        text = model if isinstance(model, str) else describe(model) if isinstance(model, BRDF) else ""
        say(0, 1, text)
        attempt = _Attempt(data, model, wishes, False, below=below)
        result = attempt.result((replace(attempt.trial(), chosen=True),), started, progress)
        say(1, 1, "done")
        return result
    steps, done = len(CANDIDATES) + 1, 0

    def tried(text: str) -> None:
        nonlocal done
        say(min(done, steps - 1), steps, text)
        done += 1

    rungs = climb(data, wishes, tried)
    judgement = judged([Contender.of([rung]) for rung in rungs])
    taken = judgement.chosen.of_rungs(rungs)
    say(steps - 1, steps, f"{taken.text}, all samples")
    own = replace(wishes, per_channel=(*wishes.per_channel, *taken.per_channel))
    best = _Attempt(data, taken.text, own, True, taken.x)
    trials = tuple(replace(rung.trial(), chosen=rung is taken) for rung in rungs)
    result = best.result(trials, started, progress)
    say(steps, steps, "done")
    said = about_choice(taken, rungs, judgement)
    findings = Later(lambda: (*result.findings, *said))
    return replace(result, dusty=judgement.dusty, model_text=taken.text, findings=findings)


def _starts(problem: Problem, given: Floats | None) -> Floats:
    """Where the fit of a problem starts (B, P): many points, or few of them where a pass over the data is costly."""
    work = len(problem.wi) * problem.channels
    # With much data a part of it says nearly the same: the starts are found on the largest and thinned out on growing ones.
    parts: list[tuple[Problem, int]] = []
    for samples, most in PARTS:
        if work > 3 * samples:
            whole = parts[-1][0] if parts else problem
            rows = even_rows(len(whole.wi), max(200, samples // problem.channels))
            parts.append((whole.at_directions(rows), most))
    starts = starting_points(parts[0][0] if parts else problem, given, most=int(np.clip(600_000 // work, 3, 16)))
    for part, most in reversed(parts):
        rough = part.solve(starts, max_iterations=60, reduction=1e-7)
        starts = rough.x[np.argsort(rough.normal.objective, kind="stable")[:most]]
    return starts


class _Attempt:
    """A model, fitted; `near` is where a fit of the same model to the same data, or to a part of them, ended; `below` as for `fit_scan`."""

    def __init__(
        self,
        data: Measurement,
        model: str | BRDF | Parsed,
        wishes: Wishes,
        lenient: bool,
        near: Floats | None = None,
        below: Sequence[Found] = (),
    ) -> None:
        self.data, self.wishes = data, wishes
        self.brdf, start, self.problem, self.factor = prepare(data, model, wishes, lenient)
        check_enough(self.problem.samples, self.problem.size, self.brdf)
        wi, wo = self.problem.directions
        # What needs no fit is found out beside it.
        self.blocks = beside(data, lambda: blocks_of(wi, wo))
        if near is not None and len(near) != self.problem.size:
            near = None  # of other channels
        self.below = below if near is not None else (*below, *self._base())
        self.solution = self._solve(self._vector(start) if start else None, near)
        self.x = at_rest(self.problem, self.solution.best_point(self.problem.normal))
        self.objective = float(self.solution.normal.objective.min())
        bright = float(self.problem.brightness().sum())
        self.bic = bic(self.objective, self.problem.samples, self.problem.size, bright)
        self.predicted = self._predicted()

    def _base(self) -> tuple[Found, ...]:
        """What a fit of the base of a layer finds, where the layer may be absent."""
        layer, free = layer_of(self.brdf), {q.name for q in self.problem.quantities}
        if layer is None or layer.depth.name not in free:
            return ()
        names = frozenset(slot.name for slot in layer.base.slots())
        if not names & free:
            return ()
        base = _Attempt(self.data, Parsed(layer.base, names - free), self.wishes, True)
        return (Found(base.problem.quantities, base.x),)

    def _vector(self, start: BRDF) -> Floats | None:
        """The values of a BRDF as a parameter vector; None when their shapes do not fit the data."""
        values, x = start.parameters, np.empty(self.problem.size)
        for q in self.problem.quantities:
            value = np.asarray(values.get(q.name, q.parameter.default), float)
            if value.ndim and not (q.per_channel and value.shape in ((1,), (self.problem.channels,))):
                value = value.mean()
            x[q.where] = q.coordinate(value)
        return x

    def _solve(self, given: Floats | None, near: Floats | None) -> Solution:
        """From the best of many starts, or from the solution on a part of the data, `near`."""
        problem = self.problem
        work = len(problem.wi) * problem.channels
        # A relative change of the objective of 1/work moves the parameters by about a standard error.
        reduction = min(1e-8, 1e-2 / work) if work > PART_SAMPLES else 1e-10
        # With much data each pass counts: a last step of less than a thousandth of a standard error is none.
        of_part = work > 3 * PARTS[-1][0]
        settled, damping = (1e-6 / work, NEAR_DAMPING) if of_part else (0.0, FIRST_DAMPING)
        if near is not None:
            starts = near[None]
        elif (channels := even_channels(problem.weights)) is not None:
            part = problem.some_channels(channels)
            rough = part.solve(_starts(part, None if given is None else problem.at_channels(given, channels)))
            starts = problem.between_channels(part, rough.x[rough.best()], channels)[None]
        else:
            starts = _starts(problem, given)
        solution = problem.solve(starts, reduction=reduction, settled=settled, damping=damping)
        simpler = nearer(problem, self.below, float(solution.normal.objective.min()))
        if simpler is not None:
            solution = problem.solve(simpler[None], reduction=reduction, settled=settled)
        if self.wishes.robust != "none":
            residual = problem.residuals(solution.x[solution.best()])[problem.weights > 0]
            scale = float(deviation(residual, self.problem.unit))
            starts = np.concatenate([solution.x, starts])
            # The mild function has no valleys of its own; from its ends cauchy does not stop in one of its many.
            mild = problem.with_scale(ROBUST["soft_l1"], scale).solve(starts)
            self.problem = problem.with_scale(ROBUST[self.wishes.robust], scale)
            solution = self.problem.solve(np.concatenate([mild.x, starts]))
        return solution

    def _predicted(self) -> Floats:
        """The fitted BRDF at all directions of the data (N, C), those without a usable sample included."""
        data = self.data
        if len(self.problem.wi) == data.n_directions:
            return self.problem.predicted(self.x)
        shape = (data.n_directions, self.problem.channels)
        everywhere = replace(self.problem, wi=data.wi, wo=data.wo, values=np.zeros(shape), weights=np.zeros(shape))
        return np.where(above(data.wi, data.wo)[:, None], everywhere.predicted(self.x), 0.0)

    # ------------------------------------------------------------ the result

    @property
    def status(self) -> Status:
        return self.solution.status[self.solution.best()]

    def metrics(self, data: Measurement, predicted: Floats) -> dict[str, float]:
        return (
            (self._distances if data is self.data else _distances(data, predicted))
            | {
                "objective": self.objective,
                "bic": self.bic,
                "n_samples": float(self.problem.samples),
                "n_parameters": float(self.problem.size),
            }
            | chi_square(self.objective, self.factor, self.problem.samples - self.problem.size)
        )

    @cached_property
    def _distances(self) -> dict[str, float]:
        return _distances(self.data, self.predicted)

    def trial(self) -> Trial:
        return Trial(
            describe(self.brdf),
            self.problem.size,
            self.bic,
            self._distances["relative_rms"],
            self.objective,
            self.status,
            False,
            self.problem.samples,
        )

    def fitted_brdf(self) -> BRDF:
        """The BRDF, `Scaled` where the scale of the data was fitted."""
        values = {
            q.name: (q.value(self.x[q.where]) if q.per_channel else float(q.value(self.x[q.where])[0]))
            for q in self.problem.quantities
        }
        return self.problem.model.with_parameters(values)

    def result(self, tried: tuple[Trial, ...], started: float, progress: Progress | None = None) -> Fit:
        if self.wishes.errors != "independent":
            self.blocks.result()
        bars, errors, between = estimated(
            self.problem, self.x, self.wishes.errors, self.data.provenance, self.factor is not None, progress
        )
        found = self.fitted_brdf()
        where = {q.name: q for q in self.problem.quantities}
        parameters = {}
        for slot in found.slots():
            p = slot.parameter
            if slot.name in where:
                _, p, own, at = where[slot.name]
                stderr: Any = errors.stderr[at] if own else float(errors.stderr[at][0])
                verdicts = tuple(errors.verdicts[at])
                ends = {level: both[:, at].T if own else both[:, at][:, 0] for level, both in between.items()}
            else:
                stderr = np.full(np.shape(slot.value), np.nan) if np.ndim(slot.value) else math.nan
                verdicts = (Verdict.FIXED,) * max(1, np.size(slot.value))
                ends = {level: np.full((*np.shape(slot.value), 2), np.nan) for level in between}
            parameters[slot.name] = FittedParameter(
                slot.name, slot.value, stderr, ends, verdicts, p.symbol, p.unit, p.doc, p.fit_bounds
            )
        covariance, data, predicted, brdf = errors.covariance, self.data, self.predicted, found
        if isinstance(found, Scaled):
            parameters[NAME], covariance, data = in_units(parameters[NAME], covariance, data)
            brdf, predicted = found.base, predicted / float(found.scale)
        metrics = self.metrics(data, predicted)
        about = self.wishes.about(data) | {
            "relative_rms": metrics["relative_rms"],
            "status": str(self.status),
            "stderr": {
                p.name: [None if not math.isfinite(e) else float(e) for e in np.atleast_1d(p.stderr)]
                for p in parameters.values()
            },
        }
        wavelengths = () if data.wavelengths is None else tuple(float(w) for w in data.wavelengths)
        result = Fit(
            material=Material(brdf, data.name, data.channels, wavelengths, about=about),
            parameters=parameters,
            labels=self.problem.labels(data.channels),
            correlations=errors.correlations,
            covariance=covariance,
            metrics=metrics,
            status=self.status,
            tried=tried,
            findings=(),
            measurement=data,
            predicted=predicted,
            loss=self.wishes.loss,
            robust=self.wishes.robust,
            model_text=describe(self.brdf),
            iterations=int(self.solution.iterations.sum()),
            n_starts=len(self.solution.x),
            seconds=clock.perf_counter() - started,
            errors=bars,
        )
        return replace(result, findings=Later(lambda: (*implausible(data), *implausible_fit(result))))


def _distances(data: Measurement, predicted: Floats) -> dict[str, float]:
    mask, cosines = data.mask[0], data.wi[:, 2:3]
    samples = (predicted, data.values[0], cosines)
    if not mask.all():
        samples = tuple(np.broadcast_to(part, mask.shape)[mask] for part in samples)
    return distances(*samples)
