"""Lit spheres side by side: the material, the surface of another program in its place, and the difference; an SVG that holds its pictures."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from motes.channels import names_or_default
from motes.drawing.colour import LUMINANCE, channels_to_srgb, data_uri, diverging, png, srgb_encode
from motes.drawing.markup import Html, tag
from motes.exports.surface_fit import LIGHTINGS, Floats, SurfaceFit, lit
from motes.models import BRDF

SIDE, GAP, LEFT, TOP = 160, 10, 96, 44
#: The difference of luminance that has the strongest colour, relative to a white diffuser facing the light.
STRONGEST = 0.1


def picture(fits: Sequence[SurfaceFit]) -> str:
    """A row for each light, and a block of rows for each moment."""
    rows, y = [], TOP
    columns = ("material", fits[0].surface.words, f"difference (±{100 * STRONGEST:g} % of white)")
    for k, title in enumerate(columns):
        rows.append(_text(LEFT + k * (SIDE + GAP) + SIDE / 2, TOP - 12, title, "middle"))
    for fit in fits:
        for light, error in zip(LIGHTINGS, fit.lights, strict=True):
            for k, pixels in enumerate(_spheres(fit, light)):
                x = LEFT + k * (SIDE + GAP)
                rows.append(tag("image", href=data_uri(png(pixels)), x=x, y=y, width=SIDE, height=SIDE))
            words = [light, f"{100 * error.difference:.2g} %", f"energy {error.energy:.3g}"]
            if fit.what.hours is not None:
                words.insert(0, f"{fit.what.hours:g} h")
            rows += [_text(8, y + SIDE / 2 - 8 + 18 * k, text, "start") for k, text in enumerate(words)]
            y += SIDE + GAP
    width, title = LEFT + 3 * (SIDE + GAP), f"{fits[0].what.name} as {fits[0].surface.program}"
    body = [tag("title", title), tag("rect", width=width, height=y, fill="#ffffff"), *rows]
    return tag(
        "svg", *body, xmlns="http://www.w3.org/2000/svg", viewBox=f"0 0 {width} {y}", width=width, height=y
    ) + Html("\n")


def _text(x: float, y: float, words: str, anchor: str) -> Html:
    style = {"font_family": "sans-serif", "font_size": 13, "fill": "#222222"}
    return tag("text", words, x=f"{x:g}", y=f"{y:g}", text_anchor=anchor, **style)


def _spheres(fit: SurfaceFit, light: str) -> tuple[NDArray[np.uint8], ...]:
    """The three pictures (side, side, 4) of a light, by one exposure that shows all but the peaks of highlights."""
    names = names_or_default(fit.what.channels, fit.what.brdf.channels)
    matrix = np.asarray(channels_to_srgb(names).matrix, np.float64)
    wanted, covered = _shown(fit.what.brdf, light, matrix)
    got, _ = _shown(fit.surface, light, matrix)
    bright = float(np.quantile(wanted[covered > 0], 0.97))
    exposure = 0.8 / bright if bright > 0 else 1.0
    alpha = np.round(255 * covered).astype(np.uint8)[..., None]
    off = diverging(np.clip((got - wanted) @ LUMINANCE / STRONGEST, -1, 1)).astype(np.uint8)
    return (
        *(np.concatenate([srgb_encode(exposure * rgb), alpha], axis=-1) for rgb in (wanted, got)),
        np.concatenate([off, alpha], axis=-1),
    )


def _shown(model: BRDF, light: str, matrix: Floats) -> tuple[Floats, Floats]:
    """Linear sRGB (side, side, 3) and the coverage."""
    radiance, covered = lit(model, light, SIDE, samples=2)
    return np.broadcast_to(radiance, (*radiance.shape[:2], len(matrix))) @ matrix, covered
