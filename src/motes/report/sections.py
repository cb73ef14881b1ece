"""The sections of a report: each takes the `Context` and gives HTML, or None where it does not apply."""

from __future__ import annotations

import base64
import json
import math
from typing import NamedTuple

import numpy as np

from motes.directions import theta
from motes.drawing.colour import diverging, hex_color
from motes.drawing.markup import Html, join, table, tag
from motes.fitting.error_bars import ErrorBars
from motes.fitting.losses import LOSSES
from motes.fitting.result import Fit, FittedParameter
from motes.fitting.verdicts import Verdict
from motes.material import Material
from motes.measurements.origin import over_scale
from motes.report import plots, residuals
from motes.report.document import folded
from motes.report.figures import Shown
from motes.report.findings import count, percent
from motes.report.slices import NearMirror, Samples, Slices

# Larger tables of correlations are given as their strongest pairs.
MOST_CORRELATED = 12
_CHIPS = {
    Verdict.IDENTIFIED: ("good", "✓"),
    Verdict.WEAK: ("warn", "≈"),
    Verdict.UNIDENTIFIABLE: ("bad", "✗"),
    Verdict.AT_LOWER: ("warn", "⊢"),
    Verdict.AT_UPPER: ("warn", "⊣"),
    Verdict.FIXED: ("plain", "="),
}


class Context(NamedTuple):
    """What the sections share, computed once."""

    fit: Fit
    samples: Samples
    channels: list[Shown]
    along: Slices
    across: Slices
    near: NearMirror | None
    spheres: dict[str, str]
    light_words: str


# ---------------------------------------------------------------- parameters


def parameters(context: Context) -> Html:
    fit = context.fit
    rows = fit.table()
    head = ("parameter", "channel", "value", "standard error", "unit", "verdict", "meaning", "range searched")
    many = {name for name, p in fit.parameters.items() if len(p.verdicts) > 4}
    few = [_row(fit.parameters[r["name"]], r) for r in rows if r["name"] not in many]
    rest = [_row(fit.parameters[r["name"]], r) for r in rows if r["name"] in many]
    spectral = plots.spectral_figure(fit)
    short = {name: sum(v is not Verdict.IDENTIFIED for v in fit.parameters[name].verdicts) for name in many}
    summary = "; ".join(
        f"{name}: {len(fit.parameters[name].verdicts)} channels, {n or 'none'} not identified"
        for name, n in sorted(short.items())
    )
    return join(
        table(head, few) if few else None,
        spectral,
        folded(f"Table of {summary}", head, rest) if rest else None,
        tag(
            "p",
            f"The standard error is one sigma, by the sandwich estimator {fit.errors}. {what_errors_hold_for(fit.errors)}",
            class_="note",
        ),
    )


def what_errors_hold_for(errors: ErrorBars) -> str:
    """Of which residuals the standard errors are true."""
    if errors.kind == "blocks":
        return "It holds where residuals of a direction and of its neighbours go together, as those of a model do that does not fit."
    return "It holds for noise of any size that is independent from sample to sample, not for what the model cannot express."


def _row(p: FittedParameter, row: dict[str, str]) -> list[object]:
    verdict = Verdict(row["verdict"])
    _, _, detail = row["verdict"].partition(": ")
    low, high = p.bounds
    return [
        tag("td", tag("code", row["name"])),
        row["channel"] or "all",
        tag("td", row["value"], class_="number"),
        tag("td", f"± {row['stderr']}" if row["stderr"] else "–", class_="number"),
        row["unit"] or "ratio",
        tag("td", chip(verdict), f" {detail}" if detail else None),
        row["meaning"],
        tag(
            "td",
            "held" if verdict is Verdict.FIXED else f"{low:.4g} to {'∞' if math.isinf(high) else f'{high:.4g}'}",
            class_="number",
        ),
    ]


def chip(verdict: Verdict) -> Html:
    """A verdict as a mark and a word in its colour."""
    kind, mark = _CHIPS[verdict]
    return tag("span", f"{mark} {str(verdict).partition(': ')[0]}", class_=f"verdict {kind}")


# ---------------------------------------------------------------- figures


def slices(context: Context) -> Html:
    groups = [g for g in (context.along, context.across) if g.panels]
    if not groups or not context.channels:
        return tag(
            "p",
            f"The data hold {count(len(context.samples), 'usable direction')}: too few along any plane through the normal for a curve.",
            class_="note",
        )
    scale = plots.slice_scale(context.fit, groups, context.channels)
    names = ", ".join(c.name for c in context.channels)
    hidden = context.fit.measurement.n_channels - len(context.channels)
    return join(
        tag("p", f"Channels shown: {names}; {hidden} others are not drawn.", class_="note") if hidden else None,
        *(plots.slices_figure(context.fit, g, context.channels, scale) for g in groups),
    )


def mirror(context: Context) -> Html:
    if context.near is None or not context.channels:
        return tag(
            "p",
            "Fewer than three angles of incidence have a sample within 6° of the mirror direction: what the highlight does towards grazing cannot be seen.",
            class_="note",
        )
    return plots.mirror_figure(context.fit, context.near, context.channels)


def agreement(context: Context) -> Html:
    if len(context.samples) < 2 or not context.channels:
        return tag(
            "p", f"The data hold {count(len(context.samples), 'usable direction')}: nothing to compare.", class_="note"
        )
    return join(
        residuals.agreement_figure(context.samples, context.channels),
        tag("h3", "Over the hemisphere"),
        residuals.residual_figure(context.samples),
    )


def lobes(context: Context) -> Html | None:
    return plots.lobes_figure(context.fit, context.channels) if context.channels else None


# ---------------------------------------------------------------- tables


def metrics(context: Context) -> Html:
    fit = context.fit
    data = fit.measurement
    mask, values = data.mask[0], data.values[0]
    cosines = np.broadcast_to(np.clip(data.wi[:, 2:3], 0, None), values.shape)[mask]
    words = {
        "linear": "difference of f cos θᵢ: what a light makes visible",
        "log": "difference of log(1 + f cos θᵢ): weighs dim parts more",
        "cube_root": "difference of (f cos θᵢ)^(1/3): about the eye's lightness",
        "plain": "difference of f itself: dominated by grazing angles and highlights",
    }
    units = {"linear": "1/sr", "plain": "1/sr", "cube_root": "sr^(−1/3)", "log": ""}
    rows: list[list[object]] = []
    for name in ("linear", "log", "cube_root", "plain"):
        value = fit.metrics.get(f"rms_{name}", math.nan)
        signal = LOSSES[name].transform(values[mask], cosines)
        size = float(np.sqrt(np.mean(signal**2))) if signal.size else math.nan
        share = percent(value / size) if size > 0 and math.isfinite(value) else "–"
        minimised = tag("span", " ← minimised", class_="verdict plain") if name == fit.loss else None
        rows.append(
            [
                tag("td", name, minimised),
                tag("td", f"{value:.4g} {units[name]}".strip(), class_="number"),
                tag("td", share, class_="number"),
                words[name],
            ]
        )
    relative = percent(fit.metrics.get("relative_rms", math.nan))
    robust = f", robust function {fit.robust}" if fit.robust != "none" else ""
    return join(
        tag(
            "p",
            tag("strong", f"Relative RMS {relative}"),
            ": RMS(f − r) / RMS(r), unweighted, over all unmasked samples, with f the fit and r the measurement.",
        ),
        table(("loss", "RMS of the residual", "of the signal's RMS", "meaning"), rows),
        tag(
            "p",
            f"Minimised: {fit.loss}{robust}. Status: {fit.status}. {count(fit.iterations, 'iteration')} from {count(fit.n_starts, 'start')}, "
            f"{fit.seconds:.2g} s. "
            f"BIC {fit.metrics.get('bic', math.nan):.1f}.",
            class_="note",
        ),
    )


def tried(context: Context) -> Html | None:
    tried = context.fit.tried
    if not tried:
        return None
    best = min((t.bic for t in tried if math.isfinite(t.bic)), default=math.nan)
    rows = [
        [
            tag(
                "td",
                tag("code", t.model),
                f" ({', '.join(t.per_channel)} per channel)" if t.per_channel else None,
                tag("span", " ✓ chosen", class_="verdict good") if t.chosen else None,
            ),
            tag("td", t.n_parameters, class_="number"),
            tag("td", percent(t.relative_rms), class_="number"),
            tag("td", percent(t.left_out) if math.isfinite(t.left_out) else "–", class_="number"),
            tag("td", f"{t.bic:,.1f}".replace("-", "−"), class_="number"),
            tag("td", f"+{t.bic - best:,.1f}" if t.bic > best else "0", class_="number"),
            str(t.status),
        ]
        for t in tried
    ]
    note = (
        "Left out: the relative RMS, weighted as the loss weighs, of blocks of directions that a fit to the others predicts. The simplest model "
        "is chosen than which the best predicts better by less than a standard error, or which has the smaller BIC; a layer only where it is "
        "dust. BIC weighs closeness against the number of parameters, given independent noise."
        if len(tried) > 1
        else 'One model was asked for, so none was compared; model="auto" compares several.'
    )
    compared = min(t.n_samples for t in tried)
    if len(tried) > 1 and compared < context.fit.measurement.mask.sum():
        note += f" They were compared on {compared:,} samples spread evenly over the data; the chosen one was then fitted to all."
    return join(
        table(("model", "free parameters", "relative RMS", "left out", "BIC", "above the best", "status"), rows),
        tag("p", note, class_="note"),
    )


def masked(context: Context) -> Html:
    data = context.fit.measurement
    total = data.mask.size
    lost = int(total - data.mask.sum())
    shape = f"{count(data.n_directions, 'direction')} × {count(data.n_channels, 'channel')} = {count(total, 'sample')}"
    if not lost:
        return tag("p", f"Nothing: all of {shape} were used.")
    rows = [
        [reason, tag("td", f"{n:,}", class_="number"), tag("td", percent(n / total), class_="number")]
        for reason, n in data.masked.items()
    ]
    empty = [data.channels[c] for c in range(data.n_channels) if not data.mask[0, :, c].any()]
    return join(
        tag("p", f"{lost:,} of {shape} ({percent(lost / total)}) were left out. Nothing was clamped or filled in."),
        table(("reason", "samples", "share"), rows),
        tag(
            "p",
            tag("strong", "No usable sample: "),
            ", ".join(empty),
            ". What is said of these channels rests on no data.",
        )
        if empty
        else None,
    )


def correlations(context: Context) -> Html | None:
    labels, matrix = context.fit.labels, np.asarray(context.fit.correlations)
    if len(labels) < 2:
        return None
    undetermined = [label for k, label in enumerate(labels) if not np.isfinite(matrix[k, k])]
    note = (
        tag("p", f"No correlations: {', '.join(undetermined)} (at a bound, or not determined).", class_="note")
        if undetermined
        else None
    )
    words = tag(
        "p",
        "Two parameters with a correlation near ±1 trade against each other: the data determine a combination of the two better than either.",
        class_="note",
    )
    if len(labels) <= MOST_CORRELATED:
        rows = [
            [
                tag("th", label, scope="row"),
                *(_heat(matrix[i, j]) if i != j else tag("td", "1", class_="blank") for j in range(len(labels))),
            ]
            for i, label in enumerate(labels)
        ]
        return join(table(("", *labels), rows, class_="heat"), words, note)
    i, j = np.triu_indices(len(labels), 1)
    strength = np.nan_to_num(np.abs(matrix[i, j]))
    order = np.argsort(-strength, kind="stable")[:10]
    rows = [
        [tag("code", labels[i[k]]), tag("code", labels[j[k]]), _heat(matrix[i[k], j[k]])]
        for k in order
        if strength[k] > 0
    ]
    if not rows:
        return note
    return join(
        tag("p", f"The ten strongest of {len(i):,} pairs."),
        table(("parameter", "with", "correlation"), rows, class_="heat"),
        words,
        note,
    )


def _heat(value: float) -> Html:
    if not math.isfinite(value):
        return tag("td", "–", class_="blank")
    color = diverging(value)
    ink = "#1c1d1f" if np.dot(color, [0.299, 0.587, 0.114]) > 130 else "#ffffff"
    return tag("td", f"{value:+.2f}".replace("-", "−"), style=f"background:{hex_color(color)};color:{ink}")


def provenance(context: Context) -> Html:
    data = context.fit.measurement
    about = data.provenance
    pairs: list[tuple[str, object]] = [
        (name, about[name]) for name in ("format", "path", "sample", "source") if about.get(name) not in (None, "")
    ]
    if scale := over_scale(about):
        pairs.append(("scale", f"the values of the file, {scale}"))
    pairs.append(("directions", f"{data.n_directions:,}"))
    channels = ", ".join(data.channels[:8]) + (
        f", … {data.channels[-1]} ({data.n_channels})" if data.n_channels > 8 else ""
    )
    pairs.append(("channels", channels))
    if data.n_directions:
        for name, w in (("θᵢ", data.wi), ("θᵣ", data.wo)):
            low, high = (theta(w[k(w[:, 2])]) for k in (np.argmax, np.argmin))
            pairs.append((name, f"{np.degrees(low):.3g}° to {np.degrees(high):.3g}°"))
    pairs.append(("weights", "by solid angle" if np.ptp(data.weights) > 0 else "all alike"))
    if float(data.times[0]) or about.get("n_times"):
        pairs.append(("time", f"{data.times[0]:g} {data.time_unit}"))
    notes = [str(note) for note in about.get("notes") or ()]
    return join(
        tag("dl", *(join(tag("dt", name), tag("dd", value)) for name, value in pairs), class_="pairs"),
        tag("ul", *(tag("li", note) for note in notes)) if notes else None,
    )


def use(context: Context) -> Html:
    code = (
        "import motes\n"
        'material = motes.load("material.json")       # written by motes fit, or saved from the page\n'
        "f = material.brdf.eval(wi, wo)               # 1/sr, without the cosine; wi, wo (..., 3) unit vectors"
    )
    return material_to_use(context.fit.material, code)


def material_to_use(material: Material, code: str) -> Html:
    """Lines that use a material, and the material itself, to save or to read."""
    text = json.dumps(material.to_dict(), indent=1, default=str)
    address = "data:application/json;base64," + base64.b64encode(text.encode()).decode("ascii")
    return join(
        tag("pre", tag("code", code)),
        tag(
            "p",
            tag("a", "Save material.json", href=address, download="material.json"),
            " (it is part of this page).",
            class_="screen",
        ),
        tag("details", tag("summary", "material.json"), tag("pre", tag("code", text)), class_="screen"),
    )
