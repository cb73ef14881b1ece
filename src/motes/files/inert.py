"""Texts out of files, made so that what shows them does nothing: no escape sequences, no text that runs backwards, no formulas."""

from __future__ import annotations

import csv
import os
import re
from collections.abc import Iterable, Sequence
from pathlib import Path

from motes.files.writing import replacing

_INSTEAD = "\N{REPLACEMENT CHARACTER}"
# Controls but tab and line ends; marks, embeddings, overrides and isolates of direction (Unicode Standard Annex 9), which reorder what is
# around them; line separators, byte-order marks and tags, which nobody sees; halves of surrogate pairs.
_ACTING = re.compile(
    "[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028\u2029\u202a-\u202e\u2066-\u2069\ufeff\ud800-\udfff\U000e0000-\U000e007f]"
)
# Where a spreadsheet begins a cell (some split at semicolons), and what makes it a formula there, in the width of Latin or of Japanese letters.
_FORMULA = re.compile(r"(?:^|(?<=[,;\t\r\n]))(\s*)(?=[=+\-@＝＋－＠]\s*\S)")


def without_controls(text: object) -> str:
    """A text for a page: each character that acts instead of being seen replaced by U+FFFD; tabs and ends of lines stay."""
    return _ACTING.sub(_INSTEAD, str(text))


def cell(text: object) -> str:
    """A cell of a table that spreadsheets open: a text that they would run as a formula gets an apostrophe before it; numbers stay."""
    plain = without_controls(text)
    try:
        float(plain)
    except ValueError:
        return _FORMULA.sub(r"\1'", plain)
    return plain


def write_csv(path: str | os.PathLike[str], rows: Iterable[Sequence[object]]) -> Path:
    """Write rows as a CSV file, whole or not at all; every one is made of `cell`.

    Raises
    ------
    MotesError
        When the file cannot be written.
    """
    with replacing(path) as temporary, temporary.open("w", newline="", encoding="utf-8") as handle:
        csv.writer(handle).writerows([cell(value) for value in row] for row in rows)
    return Path(path)
