"""The sections of a report over time: each takes the `TimeContext` and gives HTML, or None where it does not apply."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from motes.drawing.markup import Html, join, table, tag
from motes.drawing.sphere import LIGHTS
from motes.fitting.formatting import with_error
from motes.fitting.result import Fit
from motes.fitting.time_result import TimeFit, TrendFit
from motes.fitting.verdicts import Verdict
from motes.report import plots, residuals, sections, time_plots
from motes.report.document import folded
from motes.report.figures import Shown, channel_key
from motes.report.findings import count, percent
from motes.report.sections import Context, what_errors_hold_for
from motes.report.slices import Samples, polar_slices
from motes.report.time_plots import Times
from motes.trends import KINDS

SPHERE_SIZE = 200
FILM_LIGHTS = ("three-quarter", "side")
MANY_CHANNELS = 4


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


def filmstrip(context: TimeContext) -> Html:
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


def findings(context: TimeContext) -> Html:
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


def trends(context: TimeContext) -> Html | None:
    return time_plots.trend_figures(context.fit, context.times, context.channels) if context.channels else None


def coefficients(context: TimeContext) -> Html:
    head = ("parameter", "trend", "coefficient", "channel", "value", "standard error", "unit", "meaning", "verdict")
    few: list[list[object]] = []
    many: list[list[object]] = []
    for t in context.fit.trends.values():
        rows = _coefficient_rows(t, context.fit.material.channels, context.times.unit)
        (many if t.scan_values.shape[1] > MANY_CHANNELS else few).extend(rows)
    return join(
        table(head, few) if few else None,
        folded(f"Coefficients of the parameters with {context.fit.measurement.n_channels} channels", head, many)
        if many
        else None,
        tag(
            "p",
            f"The standard error is one sigma, from the scatter of the residuals of all scans {context.fit.errors}. "
            f"{what_errors_hold_for(context.fit.errors)} No error is given where a coefficient sits at a bound or is not determined. "
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
                    tag("td", sections.chip(t.verdict)) if first else "",
                ]
            )
        start += len(values)
    return rows


def slices(context: TimeContext) -> Html:
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
            tag("div", *(plots.slice_panel(fit, s, context.channels, scale) for s in group.panels), class_="panels"),
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


def closeness(context: TimeContext) -> Html | None:
    return time_plots.closeness_figure(context.fit, context.times) if len(context.times.kept) else None


def agreement(context: TimeContext) -> Html | None:
    if len(context.whole.samples) < 2 or not context.channels:
        return None
    return residuals.agreement_figure(context.whole.samples, context.channels)


def metrics(context: TimeContext) -> Html:
    return sections.metrics(context.whole)


def tried(context: TimeContext) -> Html | None:
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


def masked(context: TimeContext) -> Html:
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


def provenance(context: TimeContext) -> Html:
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


def use(context: TimeContext) -> Html:
    middle = float(f"{0.5 * (context.times.first + context.times.last):.3g}")
    lines = (
        ('material = motes.load("material.json")', "written by motes fit, or saved from the page"),
        (f"brdf = material.at(hours={middle:g})", "beyond the last scan it extrapolates"),
        ("f = brdf.eval(wi, wo)", "1/sr, without the cosine; wi, wo (..., 3) unit vectors"),
    )
    code = "import motes\n" + "\n".join(f"{line:<42}# {words}" for line, words in lines)
    return sections.material_to_use(context.fit.material, code)
