"""The viewer as one HTML page that asks the network for nothing, and whose policy forbids it to."""

from __future__ import annotations

import base64
import hashlib
import json
import os
from functools import cache
from importlib import resources
from pathlib import Path

import numpy as np

from motes.channels import names_or_default
from motes.drawing.colour import channels_to_srgb, data_uri, png, srgb_encode
from motes.drawing.markup import Html, join, tag
from motes.drawing.sphere import LIGHTS, sphere_radiances
from motes.files import write_text
from motes.files.inert import without_controls
from motes.material import Material
from motes.viewer.contract import Payload

PICTURE_SIZE = 200


@cache
def asset(name: str) -> str:
    """A file that ships with Motes: ``viewer.js`` or ``viewer.css``."""
    return resources.files("motes.viewer").joinpath("static", name).read_text(encoding="utf-8")


def policy(script: str, style: str) -> str:
    """The page's Content-Security-Policy: its own script and style by their hashes, pictures out of the page, and no connection at all."""
    return "; ".join(
        [
            "default-src 'none'",
            f"script-src {_hash(script)}",
            f"style-src {_hash(style)}",
            "img-src data: blob:",
            "connect-src 'none'",
            "base-uri 'none'",
            "form-action 'none'",
        ]
    )


def safe_json(value: object) -> str:
    """JSON inside a script element: no ``<`` that could end it, no line separators that old scripts trip over, no text that runs backwards."""
    text = without_controls(json.dumps(value, allow_nan=False, separators=(",", ":"), ensure_ascii=False))
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def write_page(payload: Payload, materials: list[Material], path: str | os.PathLike[str]) -> Path:
    """Write the page, whole or not at all.

    Parameters
    ----------
    payload
        From `motes.viewer.payload.payload`.
    materials
        The same, for the pictures that a browser without WebGL 2 shows.
    path
        The file to write.
    """
    return write_text(path, page(payload, materials))


def page(payload: Payload, materials: list[Material]) -> str:
    """The page as text."""
    title = " and ".join(material.name for material in materials)
    return document(
        title,
        payload,
        "viewer.js",
        tag(
            "p",
            "These pictures stand in for the viewer, which needs JavaScript and WebGL 2.",
            class_="motes-why",
        ),
        *(_pictures(material) for material in materials),
    )


def document(title: str, payload: object, program: str, *still: Html) -> str:
    """A page with a script that ships with Motes, what it shows, and what stands in for it where no script runs."""
    script, style = asset(program), asset("viewer.css")
    head = tag(
        "head",
        tag("meta", charset="utf-8"),
        tag("meta", http_equiv="Content-Security-Policy", content=policy(script, style)),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("meta", name="referrer", content="no-referrer"),
        tag("title", f"{title} · Motes"),
        tag("style", Html(style)),
    )
    body = tag(
        "body",
        tag("main", tag("div", tag("h1", title), *still, class_="motes-still"), id="motes", class_="motes"),
        tag("script", Html(safe_json(payload)), type="application/json", id="motes-data"),
        tag("script", Html(script), type="module"),
    )
    return "<!doctype html>\n" + tag("html", head, body, lang="en") + "\n"


def _pictures(material: Material) -> Html:
    """Spheres of a material, under each lamp; over time, at its first and its last moment."""
    interval = material.interval
    moments: list[tuple[str, float | None]] = [("", None)]
    if interval:
        moments = [(f", at {hours:.3g} h", hours) for hours in interval]
    figures = []
    for words, hours in moments:
        brdf = material.brdf if hours is None else material.at(hours)
        names = names_or_default(material.channels, brdf.channels)
        matrix = channels_to_srgb(names, material.wavelengths or None).matrix
        lamps = [light for light in LIGHTS.values() if light.name != "back"]
        radiances, coverage = sphere_radiances(brdf, PICTURE_SIZE, [light.name for light in lamps])
        alpha = np.round(255 * coverage).astype(np.uint8)[..., None]
        for light, radiance in zip(lamps, radiances, strict=True):
            rgb = np.broadcast_to(radiance, (*radiance.shape[:-1], len(matrix))) @ matrix
            source = data_uri(png(np.concatenate([srgb_encode(rgb), alpha], axis=-1)))
            alt = f"A sphere of {material.name}{words}, the lamp {light.words}"
            figures.append(tag("img", src=source, alt=alt, width=PICTURE_SIZE, height=PICTURE_SIZE))
    return join(tag("h2", material.name), tag("div", *figures, class_="motes-strip"))


def _hash(text: str) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode('utf-8')).digest()).decode('ascii')}'"
