"""The report of a fit over time: trends, a filmstrip, and the scans beside the model."""

from __future__ import annotations

import base64
import json
import math
import os
from collections.abc import Callable
from dataclasses import replace
from importlib import resources
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from motes.drawing.colour import channels_to_srgb, data_uri, png, srgb_encode
from motes.drawing.markup import Html, join, table, tag
from motes.drawing.sphere import LIGHTS, sphere_radiances
from motes.files import write_text
from motes.fitting.over_time import TimeFit, TrendFit
from motes.fitting.result import Fit, Verdict
from motes.fitting.tables import with_error
from motes.material import Material
from motes.report import plots, residuals, sections, time_plots
from motes.report.figures import Shown, channel_key, shown_channels
from motes.report.findings import count, percent
from motes.report.fit_page import POLICY
from motes.report.sections import Context
from motes.report.slices import Samples, Slices, polar_slices
from motes.report.time_plots import Times
from motes.trends import KINDS
from motes.version import __version__

SPHERE_SIZE = 200
MOMENTS = 7
FILM_LIGHTS = ("three-quarter", "side")
MANY_CHANNELS = 4
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
"""


class TimeContext(NamedTuple):
    """What the sections share, computed once.

    ``whole`` holds all scans as one set of samples; ``moments`` the first, the middle and the last scan as fits of their own.
    """

    fit: TimeFit
    times: Times
    channels: list[Shown]
    whole: Context
    moments: list[tuple[int, Fit]]
    spheres: dict[str, list[str]]
    film_hours: list[float]
    light_words: str


class Section(NamedTuple):
    """A part of the page; ``body`` gives None where it does not apply."""

    anchor: str
    title: str
    body: Callable[[TimeContext], Html | None]


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
    shown = [(s, body) for s in SECTIONS if (body := s.body(context)) is not None]
    style = resources.files("motes.report").joinpath("style.css").read_text(encoding="utf-8")
    head = tag(
        "head",
        tag("meta", charset="utf-8"),
        tag("meta", http_equiv="Content-Security-Policy", content=POLICY),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("title", f"{fit.measurement.name} over time: {fit.model_text} · Motes"),
        tag("style", Html(style + STYLE)),
    )
    links = tag("nav", *(tag("a", s.title, href=f"#{s.anchor}") for s, _ in shown), aria_label="Sections")
    parts = [tag("section", tag("h2", s.title), body, id=s.anchor) for s, body in shown]
    body = tag("body", tag("main", _headline(context), links, *parts, _footer()))
    return "<!doctype html>\n" + tag("html", head, body, lang="en") + "\n"


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
        metrics=dict(fit.metrics),
        status=fit.status,
        tried=fit.tried,
        measurement=data,
        predicted=fit.predicted[index],
        loss=fit.loss,
        robust=fit.robust,
        model_text=fit.model_text,
        iterations=fit.iterations,
        n_starts=1,
        seconds=fit.seconds,
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
    names = material.channels if len(material.channels) == first.channels else tuple("?" * first.channels)
    color = channels_to_srgb(names, material.wavelengths or None)
    linear: dict[str, list[np.ndarray]] = {name: [] for name in FILM_LIGHTS}
    bright = 0.0
    coverage: Any = None
    for hour in hours:
        radiances, coverage = sphere_radiances(material.at(float(hour)), SPHERE_SIZE, list(FILM_LIGHTS))
        for name, radiance in zip(FILM_LIGHTS, radiances, strict=True):
            linear[name].append(radiance @ color.matrix)
        middle = linear["three-quarter"][-1][coverage == 1].max(-1)
        bright = max(bright, float(np.nan_to_num(np.percentile(middle, 70))))
    stops = int(np.clip(np.floor(np.log2(0.6 / bright)), 0, 4)) if bright > 0 else 0
    alpha = np.round(255 * coverage).astype(np.uint8)[..., None]
    encoded = {
        name: [data_uri(png(np.concatenate([srgb_encode(2.0**stops * rgb), alpha], axis=-1))) for rgb in pictures]
        for name, pictures in linear.items()
    }
    exposure = (
        "a white diffuser facing the lamp would be display white"
        if stops == 0
        else f"exposure raised by {count(stops, 'stop')} (a white diffuser facing the lamp would have {2**stops} times display white)"
    )
    words = (
        f"The trends {chosen}, all at one exposure: {exposure}; what is brighter clips. One distant lamp (85 %) and a uniform white dome (15 %), "
        f"no other reflections. Colour: {color.meaning}."
    )
    return encoded, [float(h) for h in hours], words


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
    return tag(
        "header",
        tag(
            "img",
            src=context.spheres["three-quarter"][-1],
            alt=f"A sphere of the material at {times.words(context.film_hours[-1])}, lit {LIGHTS['three-quarter'].words}",
            width=240,
            height=240,
        ),
        tag(
            "div",
            tag("h1", data.name),
            tag("p", f"{fit.brdf.in_words()}, {times.words(times.first)} to {times.words(times.last)}", class_="model"),
            tag("p", verdict(fit, times), " ", changes(fit), class_="lead"),
            tag("dl", *(tag("div", tag("dt", name), tag("dd", value)) for name, value in facts), class_="facts"),
        ),
    )


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


# ---------------------------------------------------------------- sections


def _filmstrip(context: TimeContext) -> Html:
    times = context.times
    cells = [tag("div", times.words(hour), class_="time") for hour in context.film_hours]
    for name, pictures in context.spheres.items():
        cells += [
            tag(
                "div",
                tag(
                    "img",
                    src=uri,
                    alt=f"Sphere at {times.words(hour)}, lamp {LIGHTS[name].words}",
                    width=SPHERE_SIZE,
                    height=SPHERE_SIZE,
                ),
            )
            for uri, hour in zip(pictures, context.film_hours, strict=True)
        ]
    rows = " and ".join(
        f"{where}: lamp {LIGHTS[name].words}"
        for where, name in zip(("Upper row", "lower row"), FILM_LIGHTS, strict=True)
    )
    strip = tag(
        "div",
        *cells,
        class_="film",
        style=f"--n:{len(context.film_hours)}",
        tabindex="0",
        role="group",
        aria_label="Spheres over time",
    )
    return tag("figure", strip, tag("figcaption", f"{rows}. {context.light_words}"))


def _findings(context: TimeContext) -> Html:
    said = [tag("li", text) for text in context.fit.findings]
    said += [tag("li", text) for text in _determined(context.fit)]
    for reading in context.fit.measurement.provenance.get("notes") or ():
        if context.times.unit == "scan" and "time" in str(reading).lower():
            said.append(tag("li", str(reading), "."))
    return (
        tag("ul", *said, class_="findings")
        if said
        else tag("p", "All parameters are determined by the data, and no scan stands out.")
    )


def _determined(fit: TimeFit) -> list[str]:
    """Sentences on parameters that are not well determined, where the findings do not speak of them."""
    said = []
    words = {
        Verdict.WEAK: "is only weakly determined: its standard error is over half of its value at all times",
        Verdict.UNIDENTIFIABLE: "is not determined by these data",
        Verdict.AT_LOWER: "stays at its lower bound",
        Verdict.AT_UPPER: "stays at its upper bound",
    }
    for t in fit.trends.values():
        if t.verdict in words and not any(f" {t.name}" in text for text in fit.findings):
            said.append(f"{t.name} ({t.doc}) {words[t.verdict]}.")
    return said


def _trends(context: TimeContext) -> Html | None:
    return time_plots.trend_figures(context.fit, context.times, context.channels) if context.channels else None


def _coefficients(context: TimeContext) -> Html:
    head = ("parameter", "trend", "coefficient", "channel", "value", "standard error", "unit", "meaning", "verdict")
    few: list[list[object]] = []
    many: list[list[object]] = []
    for t in context.fit.trends.values():
        rows = _coefficient_rows(t, context.fit.material.channels, context.times.unit)
        (many if t.scan_values.shape[1] > MANY_CHANNELS else few).extend(rows)
    return join(
        table(head, few) if few else None,
        tag(
            "details",
            tag("summary", f"Coefficients of the parameters with {context.fit.measurement.n_channels} channels"),
            table(head, many),
        )
        if many
        else None,
        tag(
            "p",
            "The standard error is one sigma (68 %), from the scatter of the residuals of all scans: it holds for noise that is independent from sample to "
            "sample. No error is given where a coefficient sits at a bound or is not determined. "
            "The verdict is that of the moment at which the parameter is best known.",
            class_="note",
        ),
    )


def _coefficient_rows(t: TrendFit, channels: tuple[str, ...], unit: str) -> list[list[object]]:
    rows: list[list[object]] = []
    variance = None if t.trend.covariance is None else np.diag(t.trend.covariance)
    start = 0
    for c in KINDS[t.trend.kind].coefficients:
        values = np.atleast_1d(t.trend.coefficients[c.name])
        for k, value in enumerate(values):
            stderr = math.nan if variance is None or variance[start + k] <= 0 else math.sqrt(variance[start + k])
            text, error = with_error(float(value), stderr)
            first = not rows
            rows.append(
                [
                    tag("td", tag("code", t.name) if first else None),
                    t.trend.kind.replace("_", " ") if first else "",
                    tag("td", tag("code", c.name)) if k == 0 else "",
                    channels[k] if len(values) > 1 else "all",
                    tag("td", text.replace("-", "−"), class_="number"),
                    tag("td", f"± {error}" if error else "–", class_="number"),
                    unit if c.is_time else "ratio" if c.bounds else t.unit or "ratio",
                    c.doc if k == 0 else "",
                    _chip(t.verdict) if first else "",
                ]
            )
        start += len(values)
    return rows


def _chip(of: Verdict) -> Html:
    kind, mark = sections._CHIPS[of]
    return tag("td", tag("span", f"{mark} {str(of).partition(': ')[0]}", class_=f"verdict {kind}"))


def _slices(context: TimeContext) -> Html:
    groups = [(k, fit, polar_slices(samples, most=3)) for k, fit in context.moments if len(samples := Samples.of(fit))]
    groups = [(k, fit, group) for k, fit, group in groups if group.panels]
    if not groups or not context.channels:
        return tag(
            "p",
            "The scans hold too few usable directions along any plane through the normal for a curve.",
            class_="note",
        )
    scale = plots.slice_scale(groups[0][1], [group for _, _, group in groups], context.channels)
    times = context.times
    rows = [
        join(
            tag("h3", times.words(float(times.hours[k])) + ("" if times.unit == "scan" else f" (scan {k})")),
            tag("div", *(plots._slice_panel(fit, s, context.channels, scale) for s in group.panels), class_="panels"),
        )
        for k, fit, group in groups
    ]
    off_plane, off_angle = (
        max(np.degrees(getattr(g, name)) for _, _, g in groups) for name in ("off_plane", "off_angle")
    )
    caption = (
        f"BRDF in the plane of incidence, one angle of incidence a panel, all on the same {'logarithmic ' if scale.log else ''}scale. "
        "Negative θᵣ is the side of the light, positive the side of the mirror direction (dotted line). "
        f"Dots are samples within {off_plane:.2g}° of the plane and {off_angle:.2g}° of θᵢ; "
        "curves are the trends at that moment exactly in the plane; the stroke at a dot ends at the fit for that very sample."
    )
    return tag("figure", channel_key(context.channels), *rows, tag("figcaption", caption))


def _closeness(context: TimeContext) -> Html | None:
    return time_plots.closeness_figure(context.fit, context.times) if len(context.times.kept) else None


def _agreement(context: TimeContext) -> Html | None:
    if len(context.whole.samples) < 2 or not context.channels:
        return None
    return residuals.agreement_figure(context.whole.samples, context.channels)


def _metrics(context: TimeContext) -> Html:
    return sections.metrics(context.whole)


def _tried(context: TimeContext) -> Html | None:
    shown = sections.tried(context.whole._replace(fit=context.moments[0][1]))
    if shown is None:
        return None
    return join(
        tag(
            "p",
            "Compared on the first, the middle and the last scan with samples, each fitted alone: free parameters are those of one scan, the BIC is the sum.",
        )
        if len(context.fit.tried) > 1
        else None,
        shown,
    )


def _masked(context: TimeContext) -> Html:
    data = context.fit.measurement
    total = data.mask.size
    lost = int(total - data.mask.sum())
    shape = f"{count(data.n_times, 'scan')} × {count(data.n_directions, 'direction')} × {count(data.n_channels, 'channel')} = {count(total, 'sample')}"
    if not lost:
        return tag(
            "p",
            f"Nothing: all of {shape} were used"
            + (", but for the scans left out." if len(context.times.outliers) else "."),
        )
    rows = [
        [reason, tag("td", f"{n:,}", class_="number"), tag("td", percent(n / total), class_="number")]
        for reason, n in data.masked.items()
    ]
    by_scan = (~data.mask).sum(axis=(1, 2))
    each = data.mask[0].size
    uneven = [k for k in range(data.n_times) if by_scan[k] > 1.5 * np.median(by_scan) + 0.02 * each]
    where = ", ".join(f"{k} ({percent(by_scan[k] / each)})" for k in uneven[:12]) + (", …" if len(uneven) > 12 else "")
    return join(
        tag("p", f"{lost:,} of {shape} ({percent(lost / total)}) were left out. Nothing was clamped or filled in."),
        table(("reason", "samples", "share"), rows),
        tag("p", f"More than usual of scan{'s' if len(uneven) > 1 else ''} {where}.") if uneven else None,
    )


def _provenance(context: TimeContext) -> Html:
    times = context.times
    listed = [f"{h:.4g}" for h in times.hours]
    if len(listed) > 16:
        listed = [*listed[:12], "…", listed[-1]]
    pairs = tag(
        "dl",
        tag("dt", "scans"),
        tag("dd", str(len(times.hours))),
        tag("dt", times.label),
        tag("dd", ", ".join(listed)),
        class_="pairs",
    )
    data = replace(context.whole.fit, measurement=context.fit.measurement)
    return join(pairs, sections.provenance(context.whole._replace(fit=data)))


def _use(context: TimeContext) -> Html:
    text = json.dumps(context.fit.material.to_dict(), indent=1, default=str)
    address = "data:application/json;base64," + base64.b64encode(text.encode()).decode("ascii")
    middle = float(f"{0.5 * (context.times.first + context.times.last):.3g}")
    lines = (
        ('material = motes.load("material.json")', "written by motes fit, or saved from the link below"),
        (f"brdf = material.at(hours={middle:g})", "beyond the last scan it extrapolates"),
        ("f = brdf.eval(wi, wo)", "1/sr, without the cosine; wi, wo (..., 3) unit vectors"),
    )
    code = "import motes\n" + "\n".join(f"{line:<42}# {words}" for line, words in lines)
    return join(
        tag("pre", tag("code", code)),
        tag("p", tag("a", "Save material.json", href=address, download="material.json"), " (it is part of this page)."),
        tag("details", tag("summary", "material.json"), tag("pre", tag("code", text))),
    )


def _footer() -> Html:
    return tag(
        "footer",
        tag(
            "p",
            "Conventions: wi points to the light, wo to the viewer, both away from the surface; θ is the angle from the normal; values are f in 1/sr without "
            "the cosine, linear; angles are radians in numbers and degrees in pictures.",
        ),
        tag("p", f"Motes {__version__}. This page is self-contained: it asks the network for nothing."),
    )


SECTIONS = (
    Section("film", "The material over time", _filmstrip),
    Section("findings", "Findings", _findings),
    Section("trends", "Trends", _trends),
    Section("coefficients", "Coefficients", _coefficients),
    Section("slices", "Measured and fitted", _slices),
    Section("scans", "Scan by scan", _closeness),
    Section("residuals", "Residuals", _agreement),
    Section("metrics", "Metrics", _metrics),
    Section("models", "Models tried", _tried),
    Section("masked", "What was masked", _masked),
    Section("data", "Where the data come from", _provenance),
    Section("use", "Use the material", _use),
)
