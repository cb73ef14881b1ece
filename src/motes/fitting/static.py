"""`fit`: one set of parameters for a measurement at one time."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Callable, Collection, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from motes.errors import DataError, MotesError
from motes.fitting.losses import LOSSES, ROBUST, Floats, loss_named, robust_named
from motes.fitting.problem import Problem, layout
from motes.fitting.result import Fit, FittedParameter, Status, Trial, Verdict
from motes.fitting.solver import Solution, minimize
from motes.fitting.starts import starting_points
from motes.fitting.uncertainty import uncertainty
from motes.material import Material
from motes.measurements import Measurement
from motes.models import BRDF, describe, parse

#: What ``model="auto"`` compares.
CANDIDATES = (
    "lambert",
    "oren_nayar",
    "oren_nayar + torrance_sparrow",
    "dust_layer(oren_nayar + torrance_sparrow)",
)
Progress = Callable[[int, int, str], None]


def fit(
    data: Measurement,
    model: str | BRDF = "auto",
    *,
    loss: str = "linear",
    robust: str = "none",
    weights: str | ArrayLike = "measurement",
    fixed: Collection[str] | Mapping[str, Any] = (),
    per_channel: Collection[str] = (),
    time: int = 0,
    progress: Progress | None = None,
) -> Fit:
    """Fit a model to measured reflectance by bounded least squares.

    Parameters
    ----------
    data
        The measurement; masked samples are left out.
    model
        Text such as ``"oren_nayar + torrance_sparrow"`` (values given in it are held, see `motes.models.parse`), a BRDF (the fit also starts
        from its values), or ``"auto"``: the candidate with the smallest BIC.
    loss
        ``"linear"``, ``"plain"``, ``"log"`` or ``"cube_root"``; see `motes.fitting.losses`.
    robust
        ``"none"``, ``"soft_l1"``, ``"huber"`` or ``"cauchy"``: how far-off samples count less.  The noise is taken from the median residual of a plain fit.
    weights
        ``"measurement"`` for the weights that come with the data (solid angles, where the format has them), ``"uniform"``, or an array (N,) or (N, C).
    fixed
        Parameters to hold: names (at the model's values), or a mapping of names to values.
    per_channel
        Parameters to fit for each channel that are shared otherwise: ``["K_s"]`` for a coloured highlight (metals).
    time
        Which of the measurement's times.
    progress
        Called with (done, total, what).

    Returns
    -------
    Fit

    Raises
    ------
    DataError
        When fewer samples are left than parameters, or the data have no such time.
    ParameterError
        When the model or a name in it is not known.
    """
    started = clock.perf_counter()
    if not isinstance(data, Measurement):
        raise DataError(f"a {type(data).__name__} cannot be fitted: it is not a Measurement", "motes.read(path) or Measurement.from_arrays makes one")
    if not 0 <= time < data.n_times:
        raise DataError(f"time {time} is outside 0..{data.n_times - 1}: the measurement has {data.n_times} time(s)", "Choose one with time=")
    data = data.at(time) if data.n_times > 1 else data
    loss_named(loss), robust_named(robust)
    texts: tuple[str | BRDF, ...] = CANDIDATES if isinstance(model, str) and model.strip() == "auto" else (model,)
    attempts: list[_Attempt] = []
    too_few: DataError | None = None
    for k, candidate in enumerate(texts):
        if progress:
            progress(k, len(texts), candidate if isinstance(candidate, str) else describe(candidate))
        try:
            attempts.append(_Attempt(data, candidate, loss, robust, weights, fixed, frozenset(per_channel), len(texts) > 1))
        except DataError as error:
            too_few = error
    if not attempts:
        assert too_few is not None
        raise too_few
    best = min(attempts, key=lambda a: a.bic)
    if progress:
        progress(len(texts), len(texts), "done")
    return best.result(attempts, started)


def _weights(data: Measurement, weights: str | ArrayLike) -> Floats:
    """Weights (N, C), 0 where masked, with mean 1 over the rest."""
    mask = data.mask[0]
    if isinstance(weights, str):
        if weights not in ("measurement", "uniform"):
            raise MotesError(f"weights {weights!r} is not 'measurement', 'uniform' or an array")
        given = data.weights if weights == "measurement" else np.ones(data.n_directions)
    else:
        given = np.asarray(weights, float)
    given = given[:, None] if given.ndim == 1 else given
    if given.shape not in ((data.n_directions, 1), (data.n_directions, data.n_channels)):
        expected = f"({data.n_directions},) or ({data.n_directions}, {data.n_channels})"
        raise DataError(f"weights of shape {np.shape(weights)} do not fit the data", f"Give an array of shape {expected}")
    if not (np.isfinite(given).all() and (given >= 0).all()):
        raise DataError("weights hold a negative or non-finite value", "Weights are 0 or positive")
    full = np.where(mask, given, 0.0)
    used = int(np.count_nonzero(full))
    if used == 0:
        reasons = ", ".join(f"{count} {reason}" for reason, count in data.masked.items()) or "all weights are 0"
        raise DataError(f"no sample of {mask.size} is left to fit: {reasons}", "motes info DATA shows what was masked and why")
    return full * (used / full.sum())


class _Attempt:
    """One candidate, fitted."""

    def __init__(
        self,
        data: Measurement,
        model: str | BRDF,
        loss: str,
        robust: str,
        weights: str | ArrayLike,
        fixed: Collection[str] | Mapping[str, Any],
        per_channel: frozenset[str],
        lenient: bool,
    ) -> None:
        self.data, self.loss, self.robust = data, loss, robust
        start: BRDF | None = None
        if isinstance(model, BRDF):
            brdf, held = model, frozenset[str]()
            start = model
        else:
            brdf, held = parse(model)
        names = [slot.name for slot in brdf.slots()]
        for name in (*fixed, *per_channel):
            # auto tries small models too, which need not have every parameter
            if name not in names and not lenient:
                raise MotesError(f"{describe(brdf)} has no parameter {name!r}", f"It has {', '.join(names)}")
        if isinstance(fixed, Mapping):
            brdf = brdf.with_parameters({name: value for name, value in fixed.items() if name in names})
        held = held | (frozenset(fixed) & frozenset(names))
        self.brdf, self.held = brdf, held
        full = _weights(data, weights)
        quantities = layout(brdf, data.n_channels, held, per_channel)
        used = full.any(axis=1)
        self.problem = Problem(
            model=brdf,
            quantities=quantities,
            fixed={slot.name: self._held_value(slot.value, slot.parameter.per_channel) for slot in brdf.slots() if slot.name in held},
            wi=data.wi[used],
            wo=data.wo[used],
            values=np.where(full > 0, data.values[0], 0.0)[used],
            weights=full[used],
            loss=LOSSES[loss],
            robust=ROBUST["none"],
        )
        if not quantities:
            raise MotesError(f"every parameter of {describe(brdf)} is held, so there is nothing to fit", "Hold fewer parameters")
        if self.problem.samples <= self.problem.size:
            raise DataError(
                f"{self.problem.samples} usable sample(s) cannot determine the {self.problem.size} parameters of {describe(brdf)}",
                "Measure more directions, or fit a smaller model",
            )
        self.solution = self._solve(self._vector(start) if start else None)
        self.x = self.solution.x[self.solution.best()]
        n = self.problem.samples
        objective = float(self.solution.normal.objective.min())
        self.objective = objective
        self.bic = n * math.log(max(2 * objective / n, 1e-300)) + self.problem.size * math.log(n)
        self.predicted = self.problem_everywhere().predicted(self.x)

    def _held_value(self, value: Any, per_channel: bool) -> Any:
        if np.ndim(value) == 0:
            return value
        if per_channel and np.shape(value) in ((self.data.n_channels,), (1,)):
            return np.asarray(value)[None, None, :]
        raise DataError(f"a held value of shape {np.shape(value)} does not fit {self.data.n_channels} channels", "Give one value, or one for each channel")

    def _vector(self, start: BRDF) -> Floats | None:
        """The values of a BRDF as a parameter vector; None when their shapes do not fit the data."""
        values, x = start.parameters, np.empty(self.problem.size)
        for q in self.problem.quantities:
            value = np.asarray(values[q.name], float)
            if value.ndim and not (q.per_channel and value.shape in ((1,), (self.problem.channels,))):
                value = value.mean()
            x[q.where] = value
        return x

    def _solve(self, given: Floats | None) -> Solution:
        problem = self.problem
        work = len(problem.wi) * problem.channels
        most = int(np.clip(600_000 // work, 3, 16))
        starts = starting_points(problem, given, most)
        low, high = problem.bounds
        if work > 60_000:  # the fit of every start is costly: thin them out on a part of the data first
            part = self._part(20_000)
            rough = minimize(part.normal, starts, low, high, max_iterations=40, reduction=1e-5)
            starts = rough.x[np.argsort(rough.normal.objective, kind="stable")[:2]]
        solution = minimize(problem.normal, starts, low, high)
        if self.robust != "none":
            residual = problem.residuals(solution.x[solution.best()])[problem.weights > 0]
            scale = 1.4826 * float(np.median(np.abs(residual - np.median(residual))))
            self.problem = problem.with_scale(ROBUST[self.robust], max(scale, 1e-12))
            solution = minimize(self.problem.normal, np.concatenate([solution.x, starts]), low, high)
        return solution

    def _part(self, samples: int) -> Problem:
        """An even part of the directions."""
        from dataclasses import replace

        problem = self.problem
        count = max(200, samples // problem.channels)
        if count >= len(problem.wi):
            return problem
        rows = np.random.default_rng(19940724).choice(len(problem.wi), count, replace=False)
        rows.sort()
        return replace(problem, wi=problem.wi[rows], wo=problem.wo[rows], values=problem.values[rows], weights=problem.weights[rows])

    def problem_everywhere(self) -> Problem:
        """The problem at all directions of the data, those without a usable sample included."""
        from dataclasses import replace

        if len(self.problem.wi) == self.data.n_directions:
            return self.problem
        shape = (self.data.n_directions, self.data.n_channels)
        return replace(self.problem, wi=self.data.wi, wo=self.data.wo, values=np.zeros(shape), weights=np.zeros(shape))

    # ------------------------------------------------------------ the result

    @property
    def status(self) -> Status:
        return self.solution.status[self.solution.best()]

    def metrics(self) -> dict[str, float]:
        mask = self.data.mask[0]
        measured, fitted = self.data.values[0], self.predicted
        cosines = np.broadcast_to(self.data.wi[:, 2:3], mask.shape)[mask]
        r, f = measured[mask], fitted[mask]
        metrics = {"relative_rms": _rms(f - r) / max(_rms(r), 1e-300)}
        for name, loss in LOSSES.items():
            metrics[f"rms_{name}"] = _rms(loss.transform(f, cosines) - loss.transform(r, cosines))
        metrics |= {
            "objective": self.objective,
            "bic": self.bic,
            "n_samples": float(self.problem.samples),
            "n_parameters": float(self.problem.size),
        }
        return metrics

    def trial(self, chosen: bool) -> Trial:
        return Trial(
            describe(self.brdf), self.problem.size, self.bic, self.metrics()["relative_rms"], self.objective, self.status, chosen
        )

    def fitted_brdf(self) -> BRDF:
        values = {q.name: (self.x[q.where] if q.per_channel else float(self.x[q.where][0])) for q in self.problem.quantities}
        return self.brdf.with_parameters(values)

    def result(self, attempts: list[_Attempt], started: float) -> Fit:
        errors = uncertainty(self.problem, self.x)
        brdf = self.fitted_brdf()
        where = {q.name: (q.where, q.per_channel) for q in self.problem.quantities}
        parameters = {}
        for slot in brdf.slots():
            p = slot.parameter
            if slot.name in where:
                at, own = where[slot.name]
                stderr: Any = errors.stderr[at] if own else float(errors.stderr[at][0])
                verdicts = tuple(errors.verdicts[at])
            else:
                stderr = np.full(np.shape(slot.value), np.nan) if np.ndim(slot.value) else math.nan
                verdicts = (Verdict.FIXED,) * max(1, np.size(slot.value))
            parameters[slot.name] = FittedParameter(slot.name, slot.value, stderr, verdicts, p.symbol, p.unit, p.doc, p.fit_bounds)
        metrics = self.metrics()
        data = self.data
        about = {
            "data": {k: v for k, v in data.provenance.items() if isinstance(v, (str, int, float, bool))},
            "loss": self.loss,
            "robust": self.robust,
            "relative_rms": metrics["relative_rms"],
            "status": str(self.status),
            "stderr": {p.name: [None if not math.isfinite(e) else float(e) for e in np.atleast_1d(p.stderr)] for p in parameters.values()},
        }
        wavelengths = () if data.wavelengths is None else tuple(float(w) for w in data.wavelengths)
        return Fit(
            material=Material(brdf, data.name, data.channels, wavelengths, about),
            parameters=parameters,
            labels=self.problem.labels(data.channels),
            correlations=errors.correlations,
            metrics=metrics,
            status=self.status,
            tried=tuple(a.trial(a is self) for a in attempts),
            measurement=data,
            predicted=self.predicted,
            loss=self.loss,
            robust=self.robust,
            model_text=describe(self.brdf),
            iterations=int(self.solution.iterations.sum()),
            n_starts=len(self.solution.x),
            seconds=clock.perf_counter() - started,
        )


def _rms(x: Floats) -> float:
    return float(np.sqrt(np.mean(np.square(x)))) if x.size else math.nan
