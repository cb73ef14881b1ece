"""Panels as one SVG file that stands alone."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import numpy as np
import pytest

from motes.drawing.figure import GAP, KEY, figure, panel_style
from motes.drawing.svg import Panel, Scale
from motes.report.document import document

SVG = "{http://www.w3.org/2000/svg}"


def panel(title: str) -> str:
    drawn = Panel(Scale(0, 1), Scale(0, 1), title, "x", "y")
    drawn.line([0, 1], [0, 1], "--blue")
    return drawn.svg(f"about {title}")


@pytest.mark.parametrize(
    ("count", "columns", "shape"), [(1, 1, (1, 1)), (4, 3, (3, 2)), (6, 3, (3, 2)), (2, 5, (5, 1))]
)
def test_panels_stand_in_a_grid(count: int, columns: int, shape: tuple[int, int]) -> None:
    root = ElementTree.fromstring(figure([panel(f"<{k}>") for k in range(count)], columns=columns))
    width, height = shape[0] * (340 + GAP) - GAP, shape[1] * (250 + GAP) - GAP
    assert root.get("viewBox") == f"0 0 {width} {height}"
    placed = root.findall(f"{SVG}svg")
    assert [svg.get("aria-label") for svg in placed] == [f"about <{k}>" for k in range(count)]
    corners = [(int(svg.get("x")), int(svg.get("y"))) for svg in placed]
    assert len(set(corners)) == count
    assert all(x + 340 <= width and y + 250 <= height for x, y in corners)


def test_the_key_names_every_colour() -> None:
    root = ElementTree.fromstring(figure([panel("a")], columns=1, legend={"K_d & more": "--blue", "sigma": "#ff0000"}))
    assert [text.text for text in root.findall(f"{SVG}text")] == ["K_d & more", "sigma"]
    assert [path.get("style") for path in root.findall(f"{SVG}path")] == ["--c:var(--blue)", "--c:#ff0000"]
    assert root.findall(f"{SVG}svg")[0].get("y") == str(KEY)


def test_every_class_and_colour_has_its_style() -> None:
    """A figure holds what it needs, and asks the network for nothing."""
    text = figure([panel("a")], legend={"a": "--vermilion"})
    style = panel_style()
    for name in np.unique(re.findall(r'class="(\w+)"', text)):
        assert name == "panel" or f".{name}" in style
    for name in np.unique(re.findall(r"var\((--\w+)\)", text)):
        assert name == "--c" or f"{name}:" in style
    assert "http" not in text.replace("http://www.w3.org/2000/svg", "")
    assert "prefers-color-scheme: dark" in text


def test_reports_share_the_style() -> None:
    assert panel_style() in document("a")


@pytest.mark.parametrize("letters", [10, 38, 45, 90])
def test_titles_stay_within_their_panel(letters: int) -> None:
    """They begin above the plot area where there is room, else at the edge; and never end beyond it."""
    panel = Panel(Scale(0, 1), Scale(0, 1), "w" * letters)
    found = re.search(r'<text ([^>]*class="title"[^>]*)>', panel.svg("a panel"))
    assert found is not None
    given = dict(re.findall(r'(\w+)="([^"]*)"', found[1]))
    length = float(given.get("textLength", 7.2 * letters))
    assert 0 < float(given["x"]) < float(given["x"]) + length <= panel.width
    assert ("textLength" in given) == (letters > 45)
    assert (float(given["x"]) > 40) == (letters < 39)
