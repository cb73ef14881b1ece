"""What the pages of reports share: one HTML document with sections, a headline, pictures at one exposure, and its last words."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from importlib import resources
from typing import Generic, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from motes.drawing.colour import ColorOf, channels_to_srgb, data_uri, png, srgb_encode
from motes.drawing.figure import panel_style
from motes.drawing.markup import Html, table, tag
from motes.material import Material
from motes.report.findings import count
from motes.version import __version__

POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'"
CONVENTIONS = (
    "Conventions: wi points to the light, wo to the viewer, both away from the surface; θ is the angle from the normal; values are f in 1/sr without the "
    "cosine, linear; angles are radians in numbers and degrees in pictures"
)
MOST_STOPS = 4
#: Rows of a folded table that are printed; of a longer one paper has the words alone.
MOST_PRINTED = 250

C = TypeVar("C")


class Section(NamedTuple, Generic[C]):
    """A part of a page; ``body`` gives None where it does not apply."""

    anchor: str
    title: str
    body: Callable[[C], Html | None]


def document(title: str, *parts: object, style: str = "") -> str:
    """A self-contained HTML page with these parts: its policy forbids it the network.

    `style` adds to the style sheet of all reports.
    """
    shared = resources.files("motes.report").joinpath("style.css").read_text(encoding="utf-8")
    head = tag(
        "head",
        tag("meta", charset="utf-8"),
        tag("meta", http_equiv="Content-Security-Policy", content=POLICY),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("title", f"{title} · Motes"),
        tag("style", Html(panel_style() + shared + style)),
    )
    return "<!doctype html>\n" + tag("html", head, tag("body", tag("main", *parts)), lang="en") + "\n"


def sectioned(context: C, sections: Sequence[Section[C]]) -> list[Html]:
    """Links to the sections that apply, then the sections."""
    shown = [(s, body) for s in sections if (body := s.body(context)) is not None]
    links = tag("nav", *(tag("a", s.title, href=f"#{s.anchor}") for s, _ in shown), aria_label="Sections")
    return [links, *(tag("section", tag("h2", s.title), body, id=s.anchor) for s, body in shown)]


def headline(
    picture: tuple[str, str],
    title: str,
    model: str,
    lead: Sequence[object],
    facts: Sequence[tuple[str, str]],
    findings: Sequence[str] = (),
) -> Html:
    """The head of a page: a picture (its address, and words for it), what was fitted, how it went, some numbers, and what is odd."""
    address, words = picture
    return tag(
        "header",
        tag("img", src=address, alt=words, width=240, height=240),
        tag(
            "div",
            tag("h1", title),
            tag("p", model, class_="model"),
            tag("p", *lead, class_="lead"),
            tag("dl", *(tag("div", tag("dt", name), tag("dd", value)) for name, value in facts), class_="facts"),
            tag("ul", *(tag("li", text) for text in findings), class_="notes") if findings else None,
        ),
    )


def folded(summary: str, head: Sequence[object], rows: Sequence[Sequence[object]]) -> Html:
    """A table that opens at a click; paper shows it whole unless it is very long."""
    return tag(
        "details",
        tag("summary", summary),
        table(head, rows),
        class_="long" if len(rows) > MOST_PRINTED else None,
    )


def last_words(conventions: str = "") -> Html:
    """The foot of a page: the conventions, with what `conventions` adds, and which Motes wrote it."""
    return tag(
        "footer",
        tag("p", f"{CONVENTIONS}{conventions}."),
        tag("p", f"Motes {__version__}. This page is self-contained: it asks the network for nothing."),
    )


# ---------------------------------------------------------------- pictures


def colours_of(material: Material, channels: int) -> ColorOf:
    """How a material's channels become colours; channels without names of their own are greys."""
    names = material.channels if len(material.channels) == channels else tuple("?" * channels)
    return channels_to_srgb(names, material.wavelengths or None)


def stops_for(bright: float, wanted: float) -> int:
    """By how many whole stops to raise the exposure so that the value `bright` is at most `wanted`: a dark material would show as a black disc."""
    return int(np.clip(np.floor(np.log2(wanted / bright)), 0, MOST_STOPS)) if np.isfinite(bright) and bright > 0 else 0


def encoded(linear: NDArray[np.floating], coverage: NDArray[np.floating], stops: int) -> str:
    """A picture (H, W, 3) of linear sRGB as the address of a PNG, raised by stops, transparent where nothing is covered."""
    alpha = np.round(255 * coverage).astype(np.uint8)[..., None]
    return data_uri(png(np.concatenate([srgb_encode(2.0**stops * linear), alpha], axis=-1)))


def exposure_words(stops: int) -> str:
    """What the exposure of pictures means."""
    if stops == 0:
        return "a white diffuser facing the lamp would be display white"
    return (
        f"raised by {count(stops, 'stop')}, a white diffuser facing the lamp would have {2**stops} times display white"
    )
