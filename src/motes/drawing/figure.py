"""Panels in a grid as one SVG file that stands alone, for pages of text: light or dark as the reader's screen is, with a key."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from importlib import resources

from motes.drawing.markup import Html, tag

GAP, KEY = 14, 30


@cache
def panel_style() -> str:
    """The style sheet of panels, which pages that hold them share: colours by name, kinds of lines, sizes of words."""
    return resources.files("motes.drawing").joinpath("panel.css").read_text(encoding="utf-8")


def figure(
    panels: Sequence[Html],
    *,
    columns: int = 3,
    size: tuple[int, int] = (340, 250),
    legend: Mapping[str, str] | None = None,
) -> str:
    """The text of an SVG file.

    Parameters
    ----------
    panels
        What `motes.drawing.svg.Panel.svg` gives, all of one `size` (width, height) in pixels.
    columns
        How many stand side by side.
    legend
        A colour for each word of the key, as ``#rrggbb`` or a custom property ``--name``; None for no key.
    """
    across, down = size[0] + GAP, size[1] + GAP
    rows = -(-len(panels) // columns)
    top = KEY if legend else 0
    width, height = columns * across - GAP, top + rows * down - GAP
    parts = [tag("rect", width="100%", height="100%", style="fill:var(--page)")]
    at = 10.0
    for words, colour in (legend or {}).items():
        shown = f"var({colour})" if colour.startswith("--") else colour
        parts.append(tag("path", class_="line", style=f"--c:{shown}", d=f"M{at:.0f} 15h22"))
        parts.append(tag("text", words, class_="label", x=f"{at + 28:.0f}", y="19"))
        at += 52 + 7.5 * len(words)
    for k, panel in enumerate(panels):
        x, y = k % columns * across, top + k // columns * down
        placed = panel.replace("<svg ", f'<svg x="{x}" y="{y}" width="{size[0]}" height="{size[1]}" ', 1)
        parts.append(Html(placed))
    whole = tag(
        "svg",
        tag("style", Html(panel_style())),
        *parts,
        xmlns="http://www.w3.org/2000/svg",
        viewBox=f"0 0 {width} {height}",
        width=str(width),
        height=str(height),
    )
    return f"{whole}\n"
