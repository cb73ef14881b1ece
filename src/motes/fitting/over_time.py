"""`fit_over_time`: trends of the parameters over all scans of a measurement."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import DataError, MotesError
from motes.fitting.advice import about_dust
from motes.fitting.choice import is_auto, summed
from motes.fitting.climbing import climb
from motes.fitting.estimating import estimated
from motes.fitting.joint import Joint
from motes.fitting.judgement import Contender, Judgement, judged
from motes.fitting.ladder import Rung
from motes.fitting.losses import ROBUST, Floats
from motes.fitting.metrics import chi_square, deviation, distances
from motes.fitting.outliers import joint_fit
from motes.fitting.plausibility import implausible_fit
from motes.fitting.result import Progress, Trial
from motes.fitting.scans import ScanFits, fit_scans, single
from motes.fitting.setup import Setup, Wishes, check_enough, prepare
from motes.fitting.solver import Solution
from motes.fitting.time_findings import findings
from motes.fitting.time_result import Alternative, ScanOutlier, TimeFit, TrendFit
from motes.fitting.trend_choice import determined
from motes.fitting.uncertainty import at_rest, verdict_of
from motes.fitting.verdicts import Verdict
from motes.material import Material
from motes.measurements import Measurement
from motes.measurements.doubts import implausible
from motes.models import BRDF, describe
from motes.trends import KINDS


def fit_over_time(
    data: Measurement,
    model: str | BRDF,
    wishes: Wishes,
    trends: str | Mapping[str, str] = "auto",
    progress: Progress | None = None,
) -> TimeFit:
    """Fit every scan, then the trends of all parameters over all scans together; `trends` as for `motes.fit`."""
    started = clock.perf_counter()
    say = progress or (lambda done, total, what: None)
    kinds = {} if isinstance(trends, str) else dict(trends)
    if isinstance(trends, str) and trends != "auto":
        raise MotesError(f"trends {trends!r} is not 'auto' or a mapping", "Give for example {'sigma_d': 'constant'}")
    for name, kind in kinds.items():
        if kind not in KINDS:
            raise MotesError(f"trend {kind!r} of {name} is not one of {', '.join(KINDS)}", "Name one of them")
    usable = np.flatnonzero(data.mask.any(axis=(1, 2)))
    if len(usable) < 2:
        raise DataError(
            f"{len(usable)} of {data.n_times} scans has usable samples, and a trend needs two",
            "Fit the one scan with --time, or time= in Python",
        )
    tried: tuple[Trial, ...] = ()
    if wishes.errors == "profile":
        raise MotesError(
            "errors 'profile' is for one time, and these are trends over several",
            "Choose one with time= (--time), or errors='bootstrap' (--errors bootstrap)",
        )
    dusty: bool | None = None
    text = ""
    said: tuple[str, ...] = ()
    if is_auto(model):
        say(0, 100, "choosing the model")
        judgement, tried = _choose(data, usable, wishes)
        chosen, dusty, said = judgement.chosen, judgement.dusty, about_dust(judgement)
        model = text = chosen.text
        wishes = replace(wishes, per_channel=(*wishes.per_channel, *chosen.per_channel))
    setup = prepare(data, model, wishes)
    problem = setup.problem
    names = [q.name for q in problem.quantities]
    for name in kinds:
        if name not in names:
            raise MotesError(f"no parameter {name!r} is fitted, so it has no trend", f"Fitted are {', '.join(names)}")
        if not determined(kinds[name], len(usable)):
            raise DataError(
                f"{len(usable)} scans cannot determine a {kinds[name]} trend of {name}",
                "Choose a kind with fewer coefficients",
            )
    least = int(min(np.count_nonzero(problem.weights[t]) for t in usable))
    check_enough(least, problem.size, setup.brdf, "a scan with ")
    hours = np.asarray(data.times, float)
    say(10, 100, f"fitting {len(usable)} scans")
    fits = fit_scans(problem, usable)
    if wishes.robust != "none":
        residual = [
            single(problem, int(t)).residuals(x)[problem.weights[t] > 0] for t, x in zip(usable, fits.x, strict=True)
        ]
        problem = problem.with_scale(ROBUST[wishes.robust], float(deviation(np.concatenate(residual), problem.unit)))
        fits = fit_scans(problem, usable)
    say(40, 100, "choosing trends")
    joint, solution, alternatives, outliers = joint_fit(problem, hours, fits, usable, kinds, say)
    result = _result(data, setup, wishes, joint, solution, alternatives, outliers, fits, usable, tried, started, say)
    return replace(result, dusty=dusty, model_text=text or result.model_text, findings=(*result.findings, *said))


def _choose(data: Measurement, usable: NDArray[np.intp], wishes: Wishes) -> tuple[Judgement, tuple[Trial, ...]]:
    """What is taken for the first, the middle and the last scan together, and what was tried."""
    looked_at = sorted({int(usable[0]), int(usable[len(usable) // 2]), int(usable[-1])})
    # The last first: dust gathers, and a layer that one scan asks for is tried on the others.
    scans: list[tuple[Rung, ...]] = []
    for t in reversed(looked_at):
        scans.insert(0, climb(data.at(t), wishes, also=[rung for scan in scans for rung in scan]))
    columns = [
        found
        for rung in scans[-1]
        if len(found := [r for scan in scans for r in scan if _key(r) == _key(rung)]) == len(scans)
    ]
    judgement = judged([Contender.of(column) for column in columns])
    chosen = judgement.chosen
    trials = summed([[rung.trial() for rung in scan] for scan in scans], (chosen.text, chosen.per_channel))
    return judgement, trials


def _key(rung: Rung) -> tuple[str, tuple[str, ...]]:
    return rung.text, rung.per_channel


def _result(
    data: Measurement,
    setup: Setup,
    wishes: Wishes,
    joint: Joint,
    solution: Solution,
    alternatives: dict[str, list[Alternative]],
    outliers: tuple[ScanOutlier, ...],
    fits: ScanFits,
    usable: NDArray[np.intp],
    tried: tuple[Trial, ...],
    started: float,
    say: Progress,
) -> TimeFit:
    brdf, c = setup.brdf, at_rest(joint, solution.best_point(joint.normal))
    bars, errors, _ = estimated(joint, c, wishes.errors, data.provenance, setup.factor is not None, say)
    covariance = errors.covariance
    hours = np.asarray(data.times, float)
    results: dict[str, TrendFit] = {}
    for part, where in zip(joint.parts, joint.slices(), strict=True):
        own = covariance[where, where]
        trend = part.trend(c[where], own)
        q = part.quantity
        stderr = trend.stderr(hours).reshape(len(hours), -1)
        values = trend(hours).reshape(len(hours), -1)
        p = q.parameter
        results[q.name] = TrendFit(
            q.name,
            trend,
            _trend_verdict(joint, part.kind, p, values, stderr),
            tuple(alternatives[q.name]),
            q.value(fits.x[:, q.where]),
            fits.stderr[:, q.where],
            p.symbol,
            p.unit,
            p.doc,
        )
    first = {name: (t.trend(hours[0]) if t.trend.channels else float(t.trend(hours[0]))) for name, t in results.items()}
    at_start = brdf.with_parameters(first)
    wavelengths = () if data.wavelengths is None else tuple(float(w) for w in data.wavelengths)
    about = wishes.about(data) | {"status": str(solution.status[0])}
    material = Material(
        at_start, data.name, data.channels, wavelengths, {name: t.trend for name, t in results.items()}, about
    )
    predicted = np.stack([material.at(float(h)).eval(data.wi, data.wo) for h in hours])
    predicted = np.broadcast_to(predicted, data.values.shape)
    keep = np.zeros(data.n_times, bool)
    keep[joint.scans] = True
    mask = data.mask & keep[:, None, None]
    r, f = data.values[mask], predicted[mask]
    cosines = np.broadcast_to(data.wi[None, :, 2:3], mask.shape)[mask]
    objective = float(solution.normal.objective[0])
    found = findings(results, outliers, len(usable), data, material)
    metrics = (
        distances(f, r, cosines)
        | {
            "objective": objective,
            "bic": joint.bic(objective),
            "n_samples": float(joint.samples),
            "n_parameters": float(joint.problem.size),
            "n_coefficients": float(joint.size),
        }
        | chi_square(objective, setup.factor, joint.samples - joint.size)
    )
    result = TimeFit(
        material=material,
        trends=results,
        hours=hours,
        outliers=outliers,
        findings=found,
        metrics=metrics,
        status=solution.status[0],
        tried=tried,
        measurement=data,
        predicted=predicted,
        loss=wishes.loss,
        robust=wishes.robust,
        model_text=describe(brdf),
        iterations=int(solution.iterations.sum()),
        seconds=clock.perf_counter() - started,
        errors=bars,
    )
    return replace(result, findings=(*found, *implausible(data), *implausible_fit(result)))


def _trend_verdict(joint: Joint, kind: str, p: Any, values: Floats, stderr: Floats) -> Verdict:
    low, high = p.fit_bounds
    width = p.typical[1] - p.typical[0]
    unit = min(joint.problem.unit, 1.0)
    if (values <= low + 1e-9 * (unit + abs(low))).all():
        return Verdict.AT_LOWER
    if math.isfinite(high) and (values >= high - 1e-9 * (1 + abs(high))).all():
        return Verdict.AT_UPPER
    if not np.isfinite(stderr).any() or not (stderr > 0).any():
        return Verdict.UNIDENTIFIABLE
    if not width > 0:
        return Verdict.IDENTIFIED
    # The best-determined moment decides: a highlight that fades is still known from when it was there.
    k = np.unravel_index(np.nanargmin(np.where(stderr > 0, stderr, np.nan)), stderr.shape)
    return verdict_of(
        p,
        float(np.broadcast_to(values, np.broadcast_shapes(values.shape, stderr.shape))[k]),
        float(stderr[k]),
        joint.problem.unit,
    )
