"""HTML by function calls, in which text is escaped unless it was made here."""

from __future__ import annotations

import html
from collections.abc import Iterable, Sequence
from typing import Any

from motes.files.inert import without_controls

_EMPTY = {"br", "hr", "img", "meta", "link", "image"}


class Html(str):
    """Text that is markup already: what the functions here return, and literals of this package."""

    __slots__ = ()


def _characters(text: object) -> str:
    """The text with characters replaced that a page cannot hold (halves of surrogate pairs, from file names that are not UTF-8) or that act in it."""
    return html.escape(without_controls(text), quote=True)


def escape(text: object) -> Html:
    """Anything as text: names out of files pass through here before they reach a page."""
    return text if isinstance(text, Html) else Html(_characters(text))


def join(*parts: object) -> Html:
    """The parts one after the other; None is nothing."""
    return Html("".join(escape(part) for part in parts if part is not None))


def tag(name: str, /, *children: object, **attributes: Any) -> Html:
    """An element.  Children that are not `Html` are escaped, attributes always; ``class_`` is class, ``_`` in names is ``-``, None leaves one out."""
    given = "".join(
        f' {key.rstrip("_").replace("_", "-")}="{_characters(value)}"'
        for key, value in attributes.items()
        if value is not None
    )
    if name in _EMPTY:
        return Html(f"<{name}{given}/>" if name == "image" else f"<{name}{given}>")
    return Html(f"<{name}{given}>{join(*children)}</{name}>")


def table(head: Sequence[object], rows: Iterable[Sequence[object]], *, class_: str | None = None) -> Html:
    """A table.  Cells that are ``<td>`` or ``<th>`` elements already stay as they are."""
    header = tag("tr", *(tag("th", cell, scope="col") for cell in head))
    body = [tag("tr", *(cell if _is_cell(cell) else tag("td", cell) for cell in row)) for row in rows]
    return tag("div", tag("table", tag("thead", header), tag("tbody", *body), class_=class_), class_="scroll")


def _is_cell(cell: object) -> bool:
    return isinstance(cell, Html) and cell.startswith(("<td", "<th"))
