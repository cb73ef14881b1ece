"""The report as one HTML page that asks the network for nothing."""

from __future__ import annotations

import math
import os
from pathlib import Path

import numpy as np

from motes.drawing.markup import Html, tag
from motes.drawing.sphere import LIGHTS, sphere_radiances
from motes.files import write_text
from motes.fitting.result import Fit
from motes.measurements.origin import not_measured
from motes.models.composition import in_words
from motes.report import findings, sections
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
from motes.report.findings import percent
from motes.report.sections import Context
from motes.report.slices import Samples, Slices, near_mirror, polar_slices

SPHERE_SIZE = 320  # shown at three quarters of it or less: sharp on dense screens too
NORMALISATION = "; D of Torrance-Sparrow is not normalised unless the model says facets"


def write_report(fit: Fit, path: str | os.PathLike[str]) -> Path:
    """Write a fit as one self-contained HTML page: numbers, pictures and how they came about.

    Parameters
    ----------
    fit
        From `motes.fit`.
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
    The same fit gives the same bytes.  Measurements of more than some thousand directions are thinned for the dots and percentiles, evenly
    and the same way every time; captions say so.
    """
    return write_text(path, render(fit))


def render(fit: Fit) -> str:
    """The page as text; see `write_report`."""
    context = _context(fit)
    parts = [_headline(context), *sectioned(context, SECTIONS), last_words(NORMALISATION)]
    return document(f"{fit.measurement.name}: {fit.model_text}", *parts)


def _context(fit: Fit) -> Context:
    samples = Samples.of(fit)
    spheres, words = _spheres(fit)
    empty = Slices((), 0.0, 0.0)
    some = len(samples) > 0
    return Context(
        fit,
        samples,
        shown_channels(fit),
        polar_slices(samples) if some else empty,
        polar_slices(samples, across=True, most=3) if some else empty,
        near_mirror(samples) if some else None,
        spheres,
        words,
    )


# ---------------------------------------------------------------- headline and spheres


def _headline(context: Context) -> Html:
    fit = context.fit
    data = fit.measurement
    masked = int(data.mask.size - data.mask.sum())
    facts = [
        ("relative RMS", percent(fit.metrics.get("relative_rms", math.nan))),
        ("samples used", f"{int(data.mask.sum()):,}"),
        ("samples masked", f"{masked:,}"),
        ("free parameters", f"{int(fit.metrics.get('n_parameters', len(fit.labels)))}"),
        ("time to fit", f"{fit.seconds:.2g} s"),
    ]
    if (chi := fit.metrics.get("reduced_chi_square")) is not None:
        facts.insert(1, ("reduced chi-square", f"{chi:.3g}"))
    missed = findings.misses(context.samples, context.near)
    said = not_measured(data.provenance)
    lead = (
        f"{said} " if said else None,
        findings.verdict(fit),
        " ",
        findings.determined(fit),
        f" {missed}" if missed else None,
    )
    words = f"A sphere of the fitted material, lit {LIGHTS['three-quarter'].words}"
    return headline(
        (context.spheres["three-quarter"], words),
        data.name,
        in_words(fit.brdf, dusty=fit.dusty),
        lead,
        facts,
        fit.findings,
    )


def _spheres(fit: Fit) -> tuple[dict[str, str], str]:
    """Pictures under each light as data addresses, and how they were made."""
    color = colours_of(fit.material, fit.brdf.channels)
    radiances, coverage = sphere_radiances(fit.brdf, SPHERE_SIZE, list(LIGHTS), colours=color.matrix)
    linear = dict(zip(LIGHTS, radiances, strict=True))
    stops = stops_for(float(np.median(linear["front"][coverage == 1].max(-1))), 0.5)
    words = (
        "One distant lamp (85 % of the light on a surface that faces it) and a uniform white dome (15 %), orthographic camera, no other reflections. "
        f"Exposure: {exposure_words(stops)}; what is brighter clips. Colour: {color.meaning}."
    )
    return {name: encoded(rgb, coverage, stops) for name, rgb in linear.items()}, words


def _spheres_section(context: Context) -> Html:
    pictures = [
        tag(
            "div",
            tag("img", src=uri, alt=f"Sphere of the fitted material, lamp {LIGHTS[name].words}", width=220, height=220),
            f"lamp {LIGHTS[name].words}",
        )
        for name, uri in context.spheres.items()
    ]
    return tag("figure", tag("div", *pictures, class_="strip"), tag("figcaption", context.light_words))


SECTIONS: tuple[Section[Context], ...] = (
    Section("spheres", "The material under a lamp", _spheres_section),
    Section("parameters", "Parameters", sections.parameters),
    Section("slices", "Measured and fitted", sections.slices),
    Section("highlight", "The highlight towards grazing", sections.mirror),
    Section("residuals", "Residuals", sections.agreement),
    Section("lobes", "Lobes", sections.lobes),
    Section("metrics", "Metrics", sections.metrics),
    Section("models", "Models tried", sections.tried),
    Section("masked", "What was masked", sections.masked),
    Section("correlations", "Correlations", sections.correlations),
    Section("data", "Where the data come from", sections.provenance),
    Section("use", "Use the material", sections.use),
)
