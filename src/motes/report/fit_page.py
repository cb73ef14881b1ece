"""The report as one HTML page that asks the network for nothing."""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from importlib import resources
from pathlib import Path
from typing import NamedTuple

import numpy as np

from motes.drawing.colour import channels_to_srgb, data_uri, png, srgb_encode
from motes.drawing.markup import Html, tag
from motes.drawing.sphere import LIGHTS, sphere_radiances
from motes.files import write_text
from motes.fitting.result import Fit
from motes.report import findings, sections
from motes.report.figures import shown_channels
from motes.report.findings import count, percent
from motes.report.sections import Context
from motes.report.slices import Samples, Slices, near_mirror, polar_slices
from motes.version import __version__

POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'"
SPHERE_SIZE = 320  # shown at three quarters of it or less: sharp on dense screens too


class Section(NamedTuple):
    """A part of the page; ``body`` gives None where it does not apply."""

    anchor: str
    title: str
    body: Callable[[Context], Html | None]


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
    shown = [(s, body) for s in SECTIONS if (body := s.body(context)) is not None]
    style = resources.files("motes.report").joinpath("style.css").read_text(encoding="utf-8")
    head = tag(
        "head",
        tag("meta", charset="utf-8"),
        tag("meta", http_equiv="Content-Security-Policy", content=POLICY),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("title", f"{fit.measurement.name}: {fit.model_text} · Motes"),
        tag("style", Html(style)),
    )
    links = tag("nav", *(tag("a", s.title, href=f"#{s.anchor}") for s, _ in shown), aria_label="Sections")
    parts = [tag("section", tag("h2", s.title), body, id=s.anchor) for s, body in shown]
    body = tag("body", tag("main", _headline(context), links, *parts, _footer()))
    return "<!doctype html>\n" + tag("html", head, body, lang="en") + "\n"


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
    missed = findings.misses(context.samples, context.near)
    return tag(
        "header",
        tag(
            "img",
            src=context.spheres["three-quarter"],
            alt=f"A sphere of the fitted material, lit {LIGHTS['three-quarter'].words}",
            width=240,
            height=240,
        ),
        tag(
            "div",
            tag("h1", data.name),
            tag("p", fit.brdf.in_words(), class_="model"),
            tag(
                "p",
                findings.verdict(fit),
                " ",
                findings.determined(fit),
                f" {missed}" if missed else None,
                class_="lead",
            ),
            tag("dl", *(tag("div", tag("dt", name), tag("dd", value)) for name, value in facts), class_="facts"),
        ),
    )


def _spheres(fit: Fit) -> tuple[dict[str, str], str]:
    """Pictures under each light as data addresses, and how they were made."""
    material = fit.material
    names = material.channels if len(material.channels) == fit.brdf.channels else tuple("?" * fit.brdf.channels)
    color = channels_to_srgb(names, material.wavelengths or None)
    radiances, coverage = sphere_radiances(fit.brdf, SPHERE_SIZE, list(LIGHTS))
    linear = dict(zip(LIGHTS, (r @ color.matrix for r in radiances), strict=True))
    # Whole stops, chosen from the sphere lit from the camera: a dark material would show as a black disc.
    bright = float(np.median(linear["front"][coverage == 1].max(-1)))
    stops = int(np.clip(np.floor(np.log2(0.5 / bright)), 0, 4)) if math.isfinite(bright) and bright > 0 else 0
    alpha = np.round(255 * coverage).astype(np.uint8)[..., None]
    encoded = {
        name: data_uri(png(np.concatenate([srgb_encode(2.0**stops * rgb), alpha], axis=-1)))
        for name, rgb in linear.items()
    }
    exposure = (
        "A white diffuser facing the lamp would be display white"
        if stops == 0
        else f"Exposure is raised by {count(stops, 'stop')}: a white diffuser facing the lamp would have {2**stops} times the value of display white"
    )
    words = (
        "One distant lamp (85 % of the light on a surface that faces it) and a uniform white dome (15 %), orthographic camera, no other reflections. "
        f"{exposure}; what is brighter clips. Colour: {color.meaning}."
    )
    return encoded, words


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


def _footer() -> Html:
    return tag(
        "footer",
        tag(
            "p",
            "Conventions: wi points to the light, wo to the viewer, both away from the surface; θ is the angle from the normal; "
            "values are f in 1/sr without the "
            "cosine, linear; angles are radians in numbers and degrees in pictures; D of Torrance-Sparrow is not normalised unless the model says facets.",
        ),
        tag("p", f"Motes {__version__}. This page is self-contained: it asks the network for nothing."),
    )


SECTIONS = (
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
