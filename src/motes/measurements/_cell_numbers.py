"""The cells of a table as numbers: decimal commas, units behind numbers, words for what is missing."""

from __future__ import annotations

import contextlib
import itertools
import re
from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError
from motes.measurements import _column_names as names
from motes.measurements._cells import NUMBER, PART, Cells

_WITH_UNIT = re.compile(r"([-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eEdD][-+]?\d+)?)\s*([^\d\s.,+-].*)")
_missing = frozenset(names.TABLES["missing"])


class Numbers:
    """Cells as numbers, by one decision for the table on what a comma means."""

    def __init__(self, table: Cells, where: str, columns: Sequence[int]) -> None:
        self.table, self.where = table, where
        self.decimal_comma = False
        comma: tuple[int, str] | None = None
        point: tuple[int, str] | None = None
        for line, row in zip(table.lines, table.rows, strict=True):
            for column in columns:
                cell = row[column]
                if "," in cell:
                    comma = comma or (line, cell)
                elif "." in cell:
                    point = point or (line, cell)
            if comma and point:
                break
        if comma is not None:
            if (
                point is not None
                and any(re.search(r"\d\.\d|^\.", p) for p in (point[1],))
                and re.search(r"\d,\d", comma[1])
            ):
                raise FormatError(
                    f"{where} has numbers with decimal commas ({comma[1][:20]!r}, line {comma[0]}) and with decimal points "
                    f"({point[1][:20]!r}, line {point[0]})",
                    "Write all of them in one way",
                )
            self.decimal_comma = True
        once = sorted(set(columns))
        self._places = {column: k for k, column in enumerate(once)}
        self._plain = self._all_at_once(once) if once else None

    def column(self, at: int, stop: int | None = None) -> tuple[NDArray[np.float64], str]:
        """A column, or several, as float64 with NaN where a cell says that there is no number; and the unit in its cells."""
        columns = range(at, at + 1 if stop is None else stop)
        if self._plain is not None and all(c in self._places for c in columns):
            return self._plain[:, [self._places[c] for c in columns]], ""
        numbers = np.empty((len(self.table.rows), len(columns)))
        found = ""
        for start, texts in self._parts(columns):
            part = numbers[start : start + len(texts) // len(columns)].reshape(-1)
            with contextlib.suppress(ValueError):
                part[:] = np.array(texts, np.float64)
                continue
            for k, text in enumerate(texts):
                row, column = start + k // len(columns), columns[k % len(columns)]
                part[k], unit = self._number(text, row, column)
                if unit and found and unit != found:
                    raise self._error(row, f"{unit!r} stands where {found!r} stands above", column)
                found = found or unit
        return numbers, found

    def _parts(self, columns: Sequence[int]) -> Iterator[tuple[int, list[str]]]:
        """The first row of each part of the table, and the cells of these columns there, row by row."""
        rows = iter(self.table.rows)
        for start in range(0, len(self.table.rows), PART):
            texts = [row[c] for row in itertools.islice(rows, PART) for c in columns]
            yield start, [t.replace(",", ".") for t in texts] if self.decimal_comma else texts

    def _all_at_once(self, columns: Sequence[int]) -> NDArray[np.float64] | None:
        """All columns (rows, columns) in one pass over the text; None where a cell is no plain number."""
        numbers = np.empty((len(self.table.rows), len(columns)))
        try:
            for start, texts in self._parts(columns):
                numbers[start : start + PART] = np.array(texts, np.float64).reshape(-1, len(columns))
        except ValueError:
            return None
        return numbers

    def _number(self, text: str, row: int, column: int) -> tuple[float, str]:
        if text.lower() in _missing:
            return np.nan, ""
        plain = text.replace("\u2212", "-").replace("\u00a0", "").replace("\u202f", "")
        match = NUMBER.fullmatch(plain)
        unit = ""
        if match is None:
            both = _WITH_UNIT.fullmatch(plain)
            if both and names.is_unit(both[2]):
                plain, unit = both[1], both[2].strip()
        try:
            return float(re.sub("[dD]", "e", plain)), unit
        except ValueError:
            raise self._error(row, f"{text[:40]!r} is not a number", column) from None

    def _error(self, row: int, what: str, column: int) -> FormatError:
        return FormatError(
            f"{self.where}, line {self.table.lines[row]}: {what} (column {self.table.header[column] or column + 1})",
            "Leave a cell empty where nothing was measured",
        )
