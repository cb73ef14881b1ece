"""What the figures of a report share: which channels are drawn and in which colours, panels in a grid, keys, captions."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.channels import colours_of
from motes.drawing.colour import hex_color
from motes.drawing.markup import Html, tag
from motes.fitting.result import Fit

# The Okabe-Ito colours that are dark enough for lines, as custom properties of the page.
PALETTE = ("--blue", "--vermilion", "--green", "--purple")
RGB_COLORS = ("--vermilion", "--green", "--blue")
#: Ticks of axes of angles.
DEGREES = tuple(range(-90, 91, 30))


class Shown(NamedTuple):
    """A channel that is drawn: its index, its name (out of the file), its colour."""

    channel: int
    name: str
    color: str


def shown_channels(fit: Fit) -> list[Shown]:
    """All channels up to four; of spectra those nearest to 450, 550 and 650 nm; else first, middle and last.  Those without data are left out."""
    data = fit.measurement
    usable = [c for c in range(data.n_channels) if data.mask[0, :, c].any()]
    names = data.channels
    if len(usable) <= 4:
        known = colours_of(names)
        colors = PALETTE if known is None else [RGB_COLORS[known[c]] for c in usable]
        return [Shown(c, names[c], color) for c, color in zip(usable, colors, strict=False)]
    picks = [usable[0], usable[len(usable) // 2], usable[-1]]
    if data.wavelengths is not None:
        nearest = [usable[int(np.argmin(np.abs(data.wavelengths[usable] - nm)))] for nm in (450, 550, 650)]
        picks = nearest if len(set(nearest)) == 3 else picks
    return [Shown(c, names[c], color) for c, color in zip(picks, ("--blue", "--green", "--vermilion"), strict=True)]


def figure(panels: Iterable[Html], caption: object, key: object = None, *, kind: str = "panels") -> Html:
    """Panels side by side as the page is wide, a key above, a caption below."""
    grid = tag("div", *panels, class_=kind)
    return tag("figure", key, grid, tag("figcaption", caption))


def key(entries: Sequence[tuple[str, str, str]]) -> Html:
    """Legend entries (mark, colour, words): marks are line, dashed, dotted, dot, bar."""
    return tag(
        "p",
        *(
            tag("span", tag("i", class_=f"mark {mark}", style=f"--c:var({color})"), words)
            for mark, color, words in entries
        ),
        class_="key",
    )


def color_bar(low: str, high: str, ramp: NDArray[np.uint8], words: str) -> Html:
    """A colour scale with its ends named."""
    stops = ",".join(hex_color(c) for c in ramp)
    return tag(
        "p",
        tag("span", words),
        tag("span", low),
        tag("i", class_="ramp", style=f"background:linear-gradient(90deg,{stops})"),
        tag("span", high),
        class_="key",
    )


def channel_key(channels: Sequence[Shown], more: Sequence[tuple[str, str, str]] = ()) -> Html:
    if len(channels) == 1:
        color = channels[0].color
        return key([("dot", color, "measured"), ("line", color, "fitted"), *more])
    names = [("line", c.color, c.name) for c in channels]
    return key([*names, ("dot", "--muted", "measured"), ("line", "--muted", "fitted"), *more])
