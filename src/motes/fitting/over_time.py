"""`fit_over_time`: trends of the parameters over all scans of a measurement, and `TimeFit`, what comes of it."""

from __future__ import annotations

import math
import os
import time as clock
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes import outlets
from motes.errors import DataError, MotesError
from motes.fitting.choice import is_auto, summed
from motes.fitting.joint import Joint
from motes.fitting.losses import LOSSES, ROBUST, Floats
from motes.fitting.problem import Problem
from motes.fitting.result import Fit, Status, Trial, Verdict
from motes.fitting.scans import ScanFits, fit_scans
from motes.fitting.setup import prepare
from motes.fitting.solver import Solution
from motes.fitting.static import fit_scan
from motes.fitting.trend_choice import Alternative, determined, first_guess, select, steady_values
from motes.fitting.uncertainty import uncertainty, verdict_of
from motes.material import Material
from motes.measurements import Measurement
from motes.models import BRDF, Lambert, describe, layer_of
from motes.parameters import Role
from motes.trends import KINDS, Trend

Progress = Callable[[int, int, str], None]
# A scan is an outlier when its misfit to the trends (a chi-square over its degrees of freedom) is this many times the median scan's, and over
# this at all; or when its noise is.
OUTLIER_RATIO, OUTLIER_MISFIT, OUTLIER_NOISE = 12.0, 12.0, 4.0
FEWEST_SCANS_TO_JUDGE = 5
SUSPECTS = 3  # scans that are left out in turn when no trend suits all
HIDDEN = 0.01  # share of the light below which what lies under the dust is not seen


@final
@dataclass(frozen=True)
class ScanOutlier:
    """A scan left out of the trends: its position, its time [h], and why."""

    index: int
    hours: float
    reason: str


@final
@dataclass(frozen=True)
class TrendFit:
    """The trend of one parameter.

    Parameters
    ----------
    trend
        With the covariance of its coefficients.
    verdict
        What the data say about the parameter over the whole time.
    alternatives
        The kinds compared, the best first, with their distance in BIC.
    scan_values, scan_stderr
        What each scan says on its own (T, W), W = 1 or the number of channels; NaN errors where a scan does not determine it.
    """

    name: str
    trend: Trend
    verdict: Verdict
    alternatives: tuple[Alternative, ...]
    scan_values: Floats
    scan_stderr: Floats
    symbol: str
    unit: str
    doc: str

    def band(self, hours: ArrayLike) -> tuple[Floats, Floats]:
        """Value and one standard error (T, W) at times [h].

        The error holds that of the coefficients, and how far the other kinds of trend that the data allow lie from the chosen one, by their weight
        exp(-delta BIC / 2): so that it opens where the data end.
        """
        t = np.atleast_1d(np.asarray(hours, float))
        value = self.trend(t).reshape(len(t), -1)
        own = np.nan_to_num(self.trend.stderr(t).reshape(len(t), -1))
        weights = np.exp(-0.5 * np.array([min(max(a.delta_bic, 0.0), 700.0) for a in self.alternatives]))
        weights /= weights.sum()
        between = sum(
            w * (a.trend(t).reshape(len(t), -1) - value) ** 2 for w, a in zip(weights, self.alternatives, strict=True)
        )
        return value, np.sqrt(own**2 + between)


@final
@dataclass(frozen=True)
class TimeFit:
    """The result of fitting a measurement with several times.

    Parameters
    ----------
    material
        With trends; ``fit.material.at(hours)`` is a BRDF.
    trends
        By parameter name, in the order of the model.
    hours
        The times of the scans (T,).
    outliers
        Scans that were left out.
    findings
        Sentences on what the data do not show or determine.
    metrics
        As in `Fit`, over all scans; and ``n_coefficients``.
    status, tried, measurement, predicted (T, N, C), loss, robust, model_text, iterations, seconds
        As in `Fit`.
    """

    material: Material
    trends: dict[str, TrendFit]
    hours: Floats
    outliers: tuple[ScanOutlier, ...]
    findings: tuple[str, ...]
    metrics: dict[str, float]
    status: Status
    tried: tuple[Trial, ...]
    measurement: Measurement
    predicted: Floats
    loss: str
    robust: str
    model_text: str
    iterations: int
    seconds: float

    @property
    def brdf(self) -> BRDF:
        """The BRDF at the first scan."""
        return self.material.at(float(self.hours[0]))

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON values."""
        from motes.fitting.tables import time_fit_to_dict

        return time_fit_to_dict(self)

    def table(self) -> list[dict[str, str]]:
        """The trends as rows of text: name, kind, first, last, coefficients, verdict."""
        from motes.fitting.tables import trend_rows

        return trend_rows(self)

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Write ``material.json``, ``fit.json`` and ``parameters.csv`` (a row for each scan and parameter)."""
        from motes.fitting.tables import save_time_fit

        return save_time_fit(self, folder)

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Write a self-contained HTML report; returns its path."""
        return outlets.report("fit over time", self, path)


def fit_over_time(
    data: Measurement,
    model: str | BRDF = "auto",
    *,
    loss: str = "linear",
    robust: str = "none",
    weights: str | ArrayLike = "measurement",
    fixed: Collection[str] | Mapping[str, Any] = (),
    per_channel: Collection[str] = (),
    trends: str | Mapping[str, str] = "auto",
    progress: Progress | None = None,
) -> TimeFit:
    """Fit every scan, then the trends of all parameters over all scans together; arguments as for `motes.fit`."""
    started = clock.perf_counter()
    say = progress or (lambda done, total, what: None)
    kinds = {} if isinstance(trends, str) else dict(trends)
    if isinstance(trends, str) and trends != "auto":
        raise MotesError(f"trends {trends!r} is not 'auto' or a mapping", "Give for example {'sigma_d': 'constant'}")
    for name, kind in kinds.items():
        if kind not in KINDS:
            raise MotesError(f"trend {kind!r} of {name} is not one of {', '.join(KINDS)}")
    usable = np.flatnonzero(data.mask.any(axis=(1, 2)))
    if len(usable) < 2:
        raise DataError(
            f"{len(usable)} of {data.n_times} scans has usable samples, and a trend needs two",
            "Fit the one scan with time=",
        )
    tried: tuple[Trial, ...] = ()
    if is_auto(model):
        say(0, 100, "choosing the model")
        model, tried = _choose(data, usable, loss, robust, weights, fixed, per_channel)
    setup = prepare(data, model, loss, weights, fixed, frozenset(per_channel))
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
    if least <= problem.size:
        raise DataError(
            f"a scan with {least} usable sample(s) cannot determine the {problem.size} parameters of {describe(setup.brdf)}",
            "Measure more directions, or fit a smaller model",
        )
    hours = np.asarray(data.times, float)
    say(10, 100, f"fitting {len(usable)} scans")
    fits = fit_scans(problem, usable)
    if robust != "none":
        residual = np.concatenate(
            [_residuals(problem, int(t), x)[problem.weights[t] > 0] for t, x in zip(usable, fits.x, strict=True)]
        )
        scale = 1.4826 * float(np.median(np.abs(residual - np.median(residual))))
        problem = problem.with_scale(ROBUST[robust], max(scale, 1e-12))
        fits = fit_scans(problem, usable)
    say(40, 100, "choosing trends")
    joint, solution, alternatives, outliers = _joint(problem, hours, fits, usable, kinds, say)
    return _result(
        data, setup.brdf, joint, solution, alternatives, outliers, fits, usable, tried, loss, robust, started
    )


def _choose(
    data: Measurement,
    usable: NDArray[np.intp],
    loss: str,
    robust: str,
    weights: str | ArrayLike,
    fixed: Collection[str] | Mapping[str, Any],
    per_channel: Collection[str],
) -> tuple[str, tuple[Trial, ...]]:
    """The candidate with the smallest BIC over the first, the middle and the last scan together."""
    looked_at = sorted({int(usable[0]), int(usable[len(usable) // 2]), int(usable[-1])})
    trials = summed(
        [
            fit_scan(
                data.at(t), "auto", loss=loss, robust=robust, weights=weights, fixed=fixed, per_channel=per_channel
            ).tried
            for t in looked_at
        ]
    )
    return next(trial.model for trial in trials if trial.chosen), trials


def _residuals(problem: Problem, scan: int, x: Floats) -> Floats:
    from motes.fitting.scans import single

    return single(problem, scan).residuals(x)


def _joint(
    problem: Problem,
    hours: Floats,
    fits: ScanFits,
    usable: NDArray[np.intp],
    kinds: Mapping[str, str],
    say: Progress,
) -> tuple[Joint, Solution, dict[str, list[Alternative]], tuple[ScanOutlier, ...]]:
    """The joint fit, refitted without scans that do not belong, one at a time."""
    outliers: list[ScanOutlier] = []
    kept = np.arange(len(usable))
    noise = _noise(problem, fits, usable)
    loud = noise > OUTLIER_NOISE * np.median(noise)
    if len(usable) >= FEWEST_SCANS_TO_JUDGE and loud.sum() <= len(usable) // 5:
        for k in np.flatnonzero(loud).tolist():
            ratio = noise[k] / float(np.median(noise))
            outliers.append(
                ScanOutlier(int(usable[k]), float(hours[usable[k]]), f"its noise is {ratio:.1f} times the others'")
            )
        kept = kept[~loud]

    def fitted(kept: NDArray[np.intp]) -> tuple[Joint, Solution, dict[str, list[Alternative]], Floats]:
        """The joint fit of some scans, and how badly it suits each of all."""
        part = fits.select(kept)
        joint, c = first_guess(problem, hours, part, usable[kept], kinds)
        level = float(np.median(_noise(problem, part, usable[kept])) ** 2)
        joint, solution, alternatives = select(
            joint,
            c,
            kinds,
            lambda done, total, what: say(45 + done, 100, what),
            steady_values(problem, part),
        )
        return joint, solution, alternatives, _misfit(replace(joint, scans=usable), solution.x[0], fits, level)

    found = fitted(kept)
    while len(kept) >= FEWEST_SCANS_TO_JUDGE and len(outliers) < max(1, len(usable) // 5):
        misfit = found[3][kept]
        order = np.argsort(-misfit)
        if misfit[order[0]] < OUTLIER_MISFIT:
            break
        # No trend suits all scans.  Is there one that suits all but one?
        best = None
        for k in order[:SUSPECTS]:
            without = np.delete(kept, k)
            trial = fitted(without)
            others = trial[3][without]
            far = trial[3][kept[k]] > max(OUTLIER_RATIO * float(np.median(others)), OUTLIER_MISFIT)
            if far and others.sum() < 0.5 * np.delete(misfit, k).sum() and (best is None or others.sum() < best[0]):
                best = (others.sum(), kept[k], without, trial)
        if best is None:
            break
        _, worst, kept, found = best
        scan = int(usable[worst])
        reason = f"it lies {math.sqrt(found[3][worst]):.0f} standard errors from the trends of the others"
        outliers.append(ScanOutlier(scan, float(hours[scan]), reason))
    return *found[:3], tuple(sorted(outliers, key=lambda o: o.index))


def _noise(problem: Problem, fits: ScanFits, usable: NDArray[np.intp]) -> Floats:
    """Root mean square of the weighted residuals of each scan."""
    samples = np.array([np.count_nonzero(problem.weights[t]) for t in usable])
    return np.sqrt(2 * fits.normal.objective / np.maximum(samples - problem.size, 1))


def _misfit(joint: Joint, c: Floats, fits: ScanFits, noise: float) -> Floats:
    """How much worse the trends suit each scan than its own fit does: a chi-square over its number of parameters."""
    x, _ = joint.vectors(c)
    scan = joint.problem.normal(x, joint.scans)
    return 2 * np.maximum(scan.objective - fits.normal.objective, 0) / (max(noise, 1e-300) * joint.problem.size)


def _result(
    data: Measurement,
    brdf: BRDF,
    joint: Joint,
    solution: Solution,
    alternatives: dict[str, list[Alternative]],
    outliers: tuple[ScanOutlier, ...],
    fits: ScanFits,
    usable: NDArray[np.intp],
    tried: tuple[Trial, ...],
    loss: str,
    robust: str,
    started: float,
) -> TimeFit:
    c = solution.x[0]
    covariance = uncertainty(joint, c).covariance
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
    about = {
        "data": {k: v for k, v in data.provenance.items() if isinstance(v, (str, int, float, bool))},
        "loss": loss,
        "robust": robust,
        "status": str(solution.status[0]),
    }
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
    findings = _findings(results, outliers, len(usable), data, material)
    metrics = {"relative_rms": _rms(f - r) / max(_rms(r), 1e-300)}
    for name, each in LOSSES.items():
        metrics[f"rms_{name}"] = _rms(each.transform(f, cosines) - each.transform(r, cosines))
    metrics |= {
        "objective": objective,
        "bic": joint.bic(objective),
        "n_samples": float(joint.samples),
        "n_parameters": float(joint.problem.size),
        "n_coefficients": float(joint.size),
    }
    return TimeFit(
        material=material,
        trends=results,
        hours=hours,
        outliers=outliers,
        findings=findings,
        metrics=metrics,
        status=solution.status[0],
        tried=tried,
        measurement=data,
        predicted=predicted,
        loss=loss,
        robust=robust,
        model_text=describe(brdf),
        iterations=int(solution.iterations.sum()),
        seconds=clock.perf_counter() - started,
    )


def _trend_verdict(joint: Joint, kind: str, p: Any, values: Floats, stderr: Floats) -> Verdict:
    low, high = p.fit_bounds
    width = p.typical[1] - p.typical[0]
    if (values <= low + 1e-9 * (1 + abs(low))).all():
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
        p, float(np.broadcast_to(values, np.broadcast_shapes(values.shape, stderr.shape))[k]), float(stderr[k])
    )


def _findings(
    results: dict[str, TrendFit],
    outliers: tuple[ScanOutlier, ...],
    scans: int,
    data: Measurement,
    material: Material,
) -> tuple[str, ...]:
    """Sentences on what the data do not show; what can't be known by them is marked in `results`."""
    found = []
    missing = data.n_times - scans
    if missing:
        found.append(f"{missing} of {data.n_times} scans {'has' if missing == 1 else 'have'} no usable sample.")
    for outlier in outliers:
        found.append(f"Scan {outlier.index} at {outlier.hours:.3g} h was left out: {outlier.reason}.")
    if scans - len(outliers) < 4:
        found.append(
            f"With {scans - len(outliers)} scans the shape of a trend is a guess: they tell only whether it changes."
        )

    def mark(names: list[str]) -> None:
        for name in names:
            results[name] = replace(results[name], verdict=Verdict.UNIDENTIFIABLE)

    hours = np.asarray(data.times, float)
    brdf, told = material.brdf, set()
    layer = layer_of(brdf)
    if layer is not None and _share_below(material, data) < HIDDEN:
        told = {s.name for s in (*layer.below, layer.depth) if s.name in results}
        mark(sorted(told))
        found.append(
            f"The dust hides the surface at all times, or the surface is black: it adds less than {100 * HIDDEN:g} % of the light, and the data do not "
            f"determine {', '.join(n for n in results if n in told)}."
        )
    for strength in brdf.slots(Role.HIGHLIGHT_STRENGTH):
        name, own = strength.name, brdf.beside(strength, Role.HIGHLIGHT_WIDTH)
        if name not in results or name in told or own is None:
            continue
        value, error = results[name].band(hours)
        width = own.name
        if (value <= 3 * error).all() or results[name].verdict == Verdict.AT_LOWER:
            told.add(width)
            if width in results:
                mark([width])
            found.append(
                f"No highlight is seen: {name} is 0 within its errors at all times, and its width {width} means nothing."
            )
    for name, t in results.items():
        if t.verdict == Verdict.UNIDENTIFIABLE and name not in told:
            found.append(f"The data do not determine {name} ({t.doc}).")
    return tuple(found)


def _share_below(material: Material, data: Measurement) -> float:
    """The largest share, over the scans, of the light that comes from below the dust (root mean squares over the directions)."""
    up = (data.wi[:, 2] > 0) & (data.wo[:, 2] > 0)
    wi, wo = data.wi[up], data.wo[up]
    largest = 0.0
    for hour in data.times:
        layer = layer_of(material.at(float(hour)))
        assert layer is not None
        whole = layer.whole.eval(wi, wo)
        below = whole - layer.over(Lambert(K_d=0.0)).eval(wi, wo)  # over black nothing but the layer itself is seen
        largest = max(largest, _rms(below) / max(_rms(whole), 1e-300))
    return largest


def _rms(x: Floats) -> float:
    return float(np.sqrt(np.mean(np.square(x)))) if x.size else math.nan


__all__ = ["Fit", "ScanOutlier", "TimeFit", "TrendFit", "fit_over_time"]
