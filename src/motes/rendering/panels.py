"""Pictures side by side, with words above and beside them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import MissingExtraError

Bytes = NDArray[np.uint8]
PAPER, INK = (255, 255, 255), (40, 40, 44)
GAP = 4  # pixels between panels


def pillow() -> tuple[Any, Any, Any]:
    """Pillow's Image, ImageDraw and ImageFont; raises `MissingExtraError` without it."""
    try:
        from PIL import Image, ImageDraw, ImageFont
    except ImportError:
        raise MissingExtraError("pillow", "render", "writing pictures") from None
    return Image, ImageDraw, ImageFont


def columns_for(n: int) -> int:
    """How many panels go into a row: all up to four, else about as many as there are rows."""
    return n if n <= 4 else math.ceil(math.sqrt(n * 1.4))


def sheet(panels: Sequence[Sequence[Bytes | None]], rows: Sequence[str] = (), columns: Sequence[str] = ()) -> Bytes:
    """Panels of one size as a table, with titles for its rows (on their left) and columns (above).

    Parameters
    ----------
    panels
        Rows of 8-bit pictures (H, W, 3); None leaves a place empty.
    rows, columns
        Titles; none leaves their margin out.
    """
    Image, ImageDraw, ImageFont = pillow()
    height, width, _ = next(p for row in panels for p in row if p is not None).shape
    size = max(round(min(height, width) / 16), 11)
    font = ImageFont.load_default(size)
    top = round(1.9 * size) if any(columns) else 0
    left = round(1.9 * size) if any(rows) else 0
    n_rows, n_columns = len(panels), max(len(row) for row in panels)
    page = Image.new("RGB", (left + n_columns * (width + GAP) - GAP, top + n_rows * (height + GAP) - GAP), PAPER)
    draw = ImageDraw.Draw(page)
    for j, title in enumerate(columns):
        words = _fitting(draw, title, font, width)
        draw.text((left + j * (width + GAP) + width / 2, top / 2), words, fill=INK, font=font, anchor="mm")
    for i, row in enumerate(panels):
        y = top + i * (height + GAP)
        for j, panel in enumerate(row):
            if panel is not None:
                page.paste(Image.fromarray(panel), (left + j * (width + GAP), y))
        if left and i < len(rows):
            strip = Image.new("RGB", (height, left), PAPER)
            pen = ImageDraw.Draw(strip)
            pen.text((height / 2, left / 2), _fitting(pen, rows[i], font, height), fill=INK, font=font, anchor="mm")
            page.paste(strip.rotate(90, expand=True), (0, y))
    return np.array(page)


def _fitting(draw: Any, text: str, font: Any, room: float) -> str:
    """The text, cut with dots where it is longer than the room."""
    text = "".join(c if c.isprintable() else " " for c in text)
    while draw.textlength(text, font=font) > room and len(text) > 4:
        text = text[:-4] + "..."
    return text
