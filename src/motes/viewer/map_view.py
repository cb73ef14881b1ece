"""A fitted map to look at: `MapView`, a page that says at each texel what was fitted there."""

from __future__ import annotations

import os
import webbrowser
from pathlib import Path
from typing import final

from motes.drawing.colour import data_uri, png
from motes.drawing.markup import tag
from motes.files import write_text
from motes.maps.fitted import FittedMap
from motes.report.map_page import contact_sheet, parameter_strips
from motes.viewer.contract import MapPayload
from motes.viewer.map_payload import map_payload
from motes.viewer.page import document


@final
class MapView:
    """What `motes.view` returns of a fitted map.

    Attributes
    ----------
    payload
        What the page gets: plain JSON values.
    """

    def __init__(self, fitted: FittedMap, notes: tuple[str, ...] = ()) -> None:
        self.payload: MapPayload = map_payload(fitted, notes)
        self._fitted = fitted

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write one self-contained HTML page that asks the network for nothing; returns its path."""
        strips = parameter_strips(self._fitted)
        names = ", ".join(strip.name for strip in strips)
        sheet = data_uri(png(contact_sheet([strip.pictures for strip in strips])))
        return write_text(
            path,
            document(
                self.payload["name"],
                self.payload,
                "maps.js",
                tag("p", "These pictures stand in for the page, which needs JavaScript.", class_="motes-why"),
                tag("img", src=sheet, alt=f"Maps of {names}, a row each, time from left to right"),
            ),
        )

    def open(self, path: str | os.PathLike[str]) -> Path:
        """`save`, and open the page in the browser."""
        written = self.save(path)
        webbrowser.open(written.resolve().as_uri())
        return written

    def __repr__(self) -> str:
        return f"MapView({self.payload['name']!r})"
