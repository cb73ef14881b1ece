"""A flat patch of a map under two lights: with the materials that were fitted, with the surfaces in their place, and the difference."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.directions import from_spherical
from motes.drawing.colour import LUMINANCE, data_uri, diverging, png, srgb_encode
from motes.drawing.markup import Html, tag
from motes.models import BRDF

Floats = NDArray[np.float64]
#: The longer side of a patch: as it is shown, and texels of it at most.
SIDE, MOST = 240, 256
GAP, LEFT, TOP = 10, 128, 44
#: The difference of luminance that has the strongest colour, relative to the white of the pictures.
STRONGEST = 0.2


class Lighting(NamedTuple):
    """A lamp and the viewer, far away."""

    words: tuple[str, ...]
    wi: Floats
    wo: Floats


LIGHTINGS = (
    Lighting(("lamp at 45°,", "seen from above"), from_spherical(np.pi / 4, np.pi), from_spherical(0.0, 0.0)),
    Lighting(("lamp at 45°,", "seen where a", "mirror reflects it"), from_spherical(np.pi / 4, np.pi), from_spherical(np.pi / 4, 0.0)),
)  # fmt: skip


class Patch(NamedTuple):
    """A map at a moment: both models over a part of its texels, for directions (1, 3), rows of texels one after the other."""

    words: str
    exact: BRDF
    surface: BRDF
    shape: tuple[int, int]


def step(shape: tuple[int, int]) -> int:
    """Every so manieth texel is shown."""
    return max(1, -(-max(shape) // MOST))


def picture(patches: Sequence[Patch], title: str, words: str, matrix: Floats) -> str:
    """An SVG with a row for each light and moment.

    Parameters
    ----------
    patches
        The moments.
    title
        What is shown.
    words
        Of the surfaces, over their column.
    matrix
        From the channels to linear sRGB.
    """
    scale = SIDE / max(patches[0].shape)
    height, width = (scale * n for n in patches[0].shape)
    rows, y = [], float(TOP)
    for k, text in enumerate(("as fitted", words, f"difference (±{100 * STRONGEST:g} % of white)")):
        rows.append(_text(LEFT + k * (width + GAP) + width / 2, TOP - 12, text, "middle"))
    for patch in patches:
        for lighting in LIGHTINGS:
            for k, pixels in enumerate(_pixels(patch, lighting, matrix)):
                place = {
                    "x": f"{LEFT + k * (width + GAP):g}",
                    "y": f"{y:g}",
                    "width": f"{width:g}",
                    "height": f"{height:g}",
                }
                rows.append(tag("image", href=data_uri(png(pixels)), style="image-rendering: pixelated", **place))
            said = [*([patch.words] if patch.words else []), *lighting.words]
            rows += [_text(8, y + 20 + 18 * k, text, "start") for k, text in enumerate(said)]
            y += max(height, 24.0 + 18 * len(said)) + GAP
    whole = LEFT + 3 * (width + GAP)
    size = {"width": f"{whole:g}", "height": f"{y:g}"}
    body = [tag("title", title), tag("rect", fill="#ffffff", **size), *rows]
    return tag("svg", *body, xmlns="http://www.w3.org/2000/svg", viewBox=f"0 0 {whole:g} {y:g}", **size) + Html("\n")


def _text(x: float, y: float, words: str, anchor: str) -> Html:
    style = {"font_family": "sans-serif", "font_size": 13, "fill": "#222222"}
    return tag("text", words, x=f"{x:g}", y=f"{y:g}", text_anchor=anchor, **style)


def _pixels(patch: Patch, lighting: Lighting, matrix: Floats) -> tuple[NDArray[np.uint8], ...]:
    """The three pictures, by one exposure that shows all but the peaks."""
    wanted, got = (radiance(model, lighting, patch.shape) for model in (patch.exact, patch.surface))
    shown = [np.broadcast_to(x, (*patch.shape, len(matrix))) @ matrix for x in (wanted, got)]
    bright = float(np.quantile(shown[0], 0.98))
    exposure = 0.85 / bright if bright > 0 else 1.0
    off = diverging(np.clip(exposure * (shown[1] - shown[0]) @ LUMINANCE / STRONGEST, -1, 1))
    return srgb_encode(exposure * shown[0]), srgb_encode(exposure * shown[1]), off


def radiance(model: BRDF, lighting: Lighting, shape: tuple[int, int]) -> Floats:
    """What the viewer sees (y, x, C), relative to a white diffuser that faces the lamp."""
    values: Any = model.eval(lighting.wi[None], lighting.wo[None])
    count = shape[0] * shape[1]
    return np.asarray(
        np.pi * lighting.wi[2] * np.broadcast_to(values, (count, 1, values.shape[-1])).reshape(*shape, -1)
    )
