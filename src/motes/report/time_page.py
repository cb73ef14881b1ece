"""The report of a fit over time: trends, a filmstrip, and the scans beside the model."""

from __future__ import annotations

import math
import os
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.drawing.markup import Html
from motes.drawing.sphere import LIGHTS, sphere_radiances
from motes.files import write_text
from motes.fitting.result import Fit
from motes.fitting.time_result import TimeFit
from motes.material import Material
from motes.measurements.origin import not_measured
from motes.models.composition import in_words
from motes.report import time_sections
from motes.report.document import (
    Section,
    colours_of,
    document,
    encoded,
    exposure_words,
    headline,
    last_words,
    sectioned,
    stops_for,
)
from motes.report.figures import shown_channels
from motes.report.findings import count, percent
from motes.report.sections import Context
from motes.report.slices import Samples, Slices
from motes.report.time_plots import Times
from motes.report.time_sections import FILM_LIGHTS, SPHERE_SIZE, TimeContext

MOMENTS = 7
STYLE = """
.film { display: grid; grid-template-columns: repeat(var(--n), minmax(92px, 1fr)); gap: 8px 10px; overflow-x: auto; }
.film div { text-align: center; font-size: 14px; color: var(--muted); font-variant-numeric: tabular-nums; }
.film img { width: 100%; max-width: 180px; height: auto; display: block; margin: 0 auto; }
.film .time { color: var(--ink); font-weight: 600; }
.panels.trends { gap: 0 26px; }
.panels.trends + figcaption { margin-top: 14px; }
.trend { display: grid; grid-row: span 3; grid-template-rows: subgrid; align-items: end; margin-bottom: 18px; }
.trend h3 { font-size: 14.5px; font-weight: 500; margin: 6px 0 0; color: var(--muted); }
.trend h3 code { color: var(--ink); font-size: 15px; font-weight: 700; }
.trend .note { margin: 2px 0 0; max-width: 430px; align-self: start; }
.findings { margin: 10px 0; padding-left: 22px; max-width: 80ch; }
.findings li { margin: 4px 0; }
svg .faint { opacity: 0.32; }
svg .cross { font-size: 20px; font-weight: 700; fill: var(--bad); }
svg .dashed { stroke-linecap: butt; }
.panels.trends svg .band { opacity: 0.15; }
@media print {
  .film { overflow: visible; grid-template-columns: repeat(var(--n), 1fr); gap: 4pt; }
  .film div, .trend .note { font-size: 8.5pt; }
  .trend { display: inline-block; }
  .trend h3, .trend h3 code { font-size: 9.5pt; }
}
"""


def write_time_report(fit: TimeFit, path: str | os.PathLike[str]) -> Path:
    """Write a fit over time as one self-contained HTML page: trends, pictures, numbers and how they came about.

    Parameters
    ----------
    fit
        From `motes.fit` of a measurement with several times.
    path
        The file to write; whole or not at all.

    Returns
    -------
    Path

    Raises
    ------
    MotesError
        When the file cannot be written.

    Notes
    -----
    The same fit gives the same bytes.
    """
    return write_text(path, render(fit))


def render(fit: TimeFit) -> str:
    """The page as text; see `write_time_report`."""
    context = _context(fit)
    parts = [_headline(context), *sectioned(context, SECTIONS), last_words()]
    return document(f"{fit.measurement.name} over time: {fit.model_text}", *parts, style=STYLE)


# ---------------------------------------------------------------- what the sections share


def _context(fit: TimeFit) -> TimeContext:
    times = Times.of(fit)
    whole = _whole(fit)
    channels = shown_channels(whole)
    kept = times.kept if len(times.kept) else times.usable
    picks = sorted({int(kept[0]), int(kept[len(kept) // 2]), int(kept[-1])})
    empty = Slices((), 0.0, 0.0)
    context = Context(whole, Samples.of(whole), channels, empty, empty, None, {}, "")
    spheres, film_hours, words = _film(fit, times)
    return TimeContext(fit, times, channels, context, [(k, _moment(fit, k)) for k in picks], spheres, film_hours, words)


def _moment(fit: TimeFit, index: int) -> Fit:
    """The trends at one scan, beside that scan."""
    data = fit.measurement.at(index)
    brdf = fit.material.at(float(fit.hours[index]))
    return Fit(
        material=Material(brdf, fit.material.name, fit.material.channels, fit.material.wavelengths),
        parameters={},
        labels=(),
        correlations=np.zeros((0, 0)),
        covariance=np.zeros((0, 0)),
        metrics=dict(fit.metrics),
        status=fit.status,
        tried=fit.tried,
        findings=(),
        measurement=data,
        predicted=fit.predicted[index],
        loss=fit.loss,
        robust=fit.robust,
        model_text=fit.model_text,
        iterations=fit.iterations,
        n_starts=1,
        seconds=fit.seconds,
        errors=fit.errors,
    )


def _whole(fit: TimeFit) -> Fit:
    """All scans as samples of one fit: what is said of residuals holds for all of them."""
    data = fit.measurement
    n, m, c = data.values.shape
    samples = replace(
        data,
        wi=np.tile(data.wi, (n, 1)),
        wo=np.tile(data.wo, (n, 1)),
        weights=np.tile(data.weights, n),
        values=data.values.reshape(1, n * m, c),
        mask=data.mask.reshape(1, n * m, c),
        times=data.times[:1],
        _codes=None,
    )
    return replace(
        _moment(fit, 0), measurement=samples, predicted=np.ascontiguousarray(fit.predicted).reshape(n * m, c)
    )


def _film(fit: TimeFit, times: Times) -> tuple[dict[str, list[str]], list[float], str]:
    """Spheres at moments from the first scan to the last, by light, all at one exposure; and how they were made."""
    kept = times.kept if len(times.kept) else times.usable
    gaps = np.diff(times.hours[kept])
    if len(kept) >= MOMENTS and gaps.max() > 1.5 * gaps.min():  # scans are closest where most happens
        hours = times.hours[kept[np.unique(np.linspace(0, len(kept) - 1, MOMENTS).astype(int))]]
        chosen = "at the times of scans"
    else:
        hours = np.linspace(times.first, times.last, MOMENTS)
        chosen = "evenly spaced in time"
    material = fit.material
    first = material.at(float(hours[0]))
    color = colours_of(material, first.channels)
    linear: dict[str, list[NDArray[np.float64]]] = {name: [] for name in FILM_LIGHTS}
    bright = 0.0
    coverage: Any = None
    for hour in hours:
        radiances, coverage = sphere_radiances(material.at(float(hour)), SPHERE_SIZE, list(FILM_LIGHTS))
        for name, radiance in zip(FILM_LIGHTS, radiances, strict=True):
            linear[name].append(radiance @ color.matrix)
        middle = linear["three-quarter"][-1][coverage == 1].max(-1)
        bright = max(bright, float(np.nan_to_num(np.percentile(middle, 70))))
    stops = stops_for(bright, 0.6)
    pictures = {name: [encoded(rgb, coverage, stops) for rgb in shown] for name, shown in linear.items()}
    words = (
        f"The trends {chosen}, all at one exposure: {exposure_words(stops)}; what is brighter clips. One distant lamp (85 %) and a uniform white dome (15 %), "
        f"no other reflections. Colour: {color.meaning}."
    )
    return pictures, [float(h) for h in hours], words


# ---------------------------------------------------------------- headline


def _headline(context: TimeContext) -> Html:
    fit, times = context.fit, context.times
    data = fit.measurement
    facts = [
        ("relative RMS", percent(fit.metrics.get("relative_rms", math.nan))),
        ("scans", f"{len(times.kept)}" + (f" of {data.n_times}" if len(times.kept) < data.n_times else "")),
        ("samples used", f"{int(fit.metrics.get('n_samples', data.mask.sum())):,}"),
        ("coefficients", f"{int(fit.metrics.get('n_coefficients', 0))}"),
        ("time to fit", f"{fit.seconds:.2g} s"),
    ]
    alt = f"A sphere of the material at {times.words(context.film_hours[-1])}, lit {LIGHTS['three-quarter'].words}"
    model = f"{in_words(fit.brdf, dusty=fit.dusty)}, {times.words(times.first)} to {times.words(times.last)}"
    said = not_measured(data.provenance)
    lead = (f"{said} " if said else None, verdict(fit, times), " ", changes(fit))
    return headline((context.spheres["three-quarter"][-1], alt), data.name, model, lead, facts)


def verdict(fit: TimeFit, times: Times) -> str:
    """How it ended, and how close the trends are, in a sentence."""
    share = fit.metrics.get("relative_rms", math.nan)
    ended = "The fit converged" if fit.status.ok else "The fit did not converge: do not trust its numbers"
    if not math.isfinite(share):
        return f"{ended}. Its distance from the data is not defined: no usable sample has a value above 0."
    close = (
        "the trends follow the measurement closely"
        if share <= 0.1
        else "the trends follow the measurement in outline"
        if share <= 0.3
        else "the trends miss much of the measurement"
    )
    joined = ". As it stands, " if not fit.status.ok else " and " if share <= 0.3 else ", but "
    return f"{ended}{joined}{close}: relative RMS {percent(share)} over {count(len(times.kept), 'scan')}."


def changes(fit: TimeFit) -> str:
    """What moves, how, and what stays."""
    moving: dict[str, list[str]] = {}
    for t in fit.trends.values():
        moving.setdefault(t.trend.kind.replace("_", " "), []).append(t.name)
    still = moving.pop("constant", [])
    parts = [f"{_and(names)} ({kind})" for kind, names in moving.items()]
    one = sum(map(len, moving.values())) == 1
    words = f"{_and(parts)} change{'s' if one else ''} with time" if parts else "Nothing is seen to change with time"
    if still:
        words += f"; {_and(still)} {'stays' if len(still) == 1 else 'stay'}"
    return f"{words}."


def _and(names: list[str]) -> str:
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


SECTIONS: tuple[Section[TimeContext], ...] = (
    Section("film", "The material over time", time_sections.filmstrip),
    Section("findings", "Findings", time_sections.findings),
    Section("trends", "Trends", time_sections.trends),
    Section("coefficients", "Coefficients", time_sections.coefficients),
    Section("slices", "Measured and fitted", time_sections.slices),
    Section("scans", "Scan by scan", time_sections.closeness),
    Section("residuals", "Residuals", time_sections.agreement),
    Section("metrics", "Metrics", time_sections.metrics),
    Section("models", "Models tried", time_sections.tried),
    Section("masked", "What was masked", time_sections.masked),
    Section("data", "Where the data come from", time_sections.provenance),
    Section("use", "Use the material", time_sections.use),
)
