"""The page of a comparison: one table of all models, and where over the hemisphere each is off, side by side."""

from __future__ import annotations

import math
import os
from pathlib import Path

import numpy as np

from motes.drawing.markup import Html, join, table, tag
from motes.files import write_text
from motes.fitting.model_table import Compared, Comparison
from motes.report.document import document, last_words
from motes.report.findings import percent
from motes.report.residuals import residual_figure, shared_end
from motes.report.slices import Samples

VERDICTS = {
    True: "A layer of dust predicts directions left out far better than any model without one, and has values of dust.",
    None: "Whether dust lies on it these models do not tell.",
    False: "No layer of dust predicts directions left out better than the models without one.",
}


def write_comparison(found: Comparison, path: str | os.PathLike[str]) -> Path:
    """Write a comparison as one HTML page that asks the network for nothing; returns its path."""
    return write_text(path, render(found))


def render(found: Comparison) -> str:
    """The page as text."""
    data = found.measurement
    samples = [Samples.of(row.fit) for row in found.rows]
    end = shared_end(samples)
    parts = [
        tag("h1", f"{data.name}: {len(found.rows)} models"),
        tag("p", VERDICTS[found.dusty]),
        _table(found),
        tag(
            "p",
            "Left out: the relative RMS, weighted as the loss weighs, of blocks of directions that a fit to the others predicts. BIC: above the "
            "smallest. Sphere: the mean colour difference Delta E ITP to the measurement over a sphere under a lamp 45° to the side, at the nearest "
            "measured directions; about 1 is just visible.",
            class_="note",
        ),
        tag("h2", "Residuals, all on one scale"),
        *(
            join(tag("h3", row.fit.model_text), residual_figure(each, end))
            for row, each in zip(found.rows, samples, strict=True)
        ),
        last_words(""),
    ]
    return document(f"{data.name}: models compared", *parts)


def _table(found: Comparison) -> Html:
    heads = ("model", "free parameters", "relative RMS", "left out", "BIC", "sphere ΔE", "parameters")
    return table(heads, [_row(row) for row in found.rows])


def _row(row: Compared) -> list[object]:
    number = {"class_": "number"}
    values = ", ".join(f"{p.name} {_range(p.value)}" for p in row.fit.parameters.values())
    return [
        tag("td", tag("code", row.fit.model_text), tag("span", " ✓", class_="verdict good") if row.chosen else None),
        tag("td", int(row.fit.metrics["n_parameters"]), **number),
        tag("td", percent(row.fit.metrics["relative_rms"]), **number),
        tag("td", percent(row.left_out) if math.isfinite(row.left_out) else "–", **number),
        tag("td", f"+{row.delta_bic:,.1f}" if row.delta_bic > 0 else "0", **number),
        tag("td", f"{row.delta_e:.3g}", **number),
        values,
    ]


def _range(value: object) -> str:
    values = np.atleast_1d(np.asarray(value, float))
    low, high = float(values.min()), float(values.max())
    return f"{low:.3g}" if low == high else f"{low:.3g} to {high:.3g}"
