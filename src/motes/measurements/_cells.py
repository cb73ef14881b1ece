"""The cells of a table, whatever it was written with: encodings, separators, comments, quotes, spreadsheets.

`cells` gives the header and the rows of a file as text; what they mean is for `motes.measurements.table`.  The grammar is
written down in ``docs/data.md``.
"""

from __future__ import annotations

import codecs
import re
from array import array
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import overload

from motes.errors import FormatError
from motes.files import reading
from motes.measurements import _column_names as names

#: What a cell names: "direction", another word for a column of another kind, "" for nothing known.
Known = Callable[[str], str]

COMMENTS = ("#", "%", "//", "!")
HEADER_HINT = "A header names the columns, such as theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,brdf (docs/data.md), or a comment above the numbers"
HEADER_LINES = 400  # that are looked at for the one that names the columns
#: Rows whose cells are in memory at a time.
PART = 1 << 14
BLANKS, WIDE_BLANKS = "blanks", "two blanks or more"
SEPARATORS = ("\t", ";", ",", "|", WIDE_BLANKS, BLANKS)
_MARKS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32"),
    (codecs.BOM_UTF32_BE, "utf-32"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
NUMBER = re.compile(r"[-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eEdD][-+]?\d+)?")


class Rows(Sequence[list[str]]):
    """Rows of a text that are cut into cells when they are asked for: a cell of two characters takes 60 bytes as a text of its own.

    Parameters
    ----------
    lines
        The rows as they stand in the file.
    separator
        What is between their cells.
    width
        How many cells count; more are left off where they are empty.  None for all.
    """

    def __init__(self, lines: list[str], separator: str, width: int | None = None) -> None:
        self._lines, self._separator, self._width = lines, separator, width

    def __len__(self) -> int:
        return len(self._lines)

    @overload
    def __getitem__(self, at: int) -> list[str]: ...
    @overload
    def __getitem__(self, at: slice) -> Rows: ...
    def __getitem__(self, at: int | slice) -> list[str] | Rows:
        if isinstance(at, slice):
            return Rows(self._lines[at], self._separator, self._width)
        return self._cut(self._lines[at])

    def __iter__(self) -> Iterator[list[str]]:
        return map(self._cut, self._lines)

    def _cut(self, line: str) -> list[str]:
        cells = _cells(line, self._separator)
        return cells if self._width is None else cells[: _end(cells, self._width)]

    def of_width(self, width: int) -> Rows:
        """The same rows without empty cells beyond so many."""
        return Rows(self._lines, self._separator, width)

    def without(self, positions: Collection[int]) -> Rows:
        """Without the rows at some positions."""
        left = set(positions)
        return Rows([line for k, line in enumerate(self._lines) if k not in left], self._separator, self._width)


@dataclass
class Cells:
    """A table as text.

    Parameters
    ----------
    header
        The names of its columns, as written.
    rows, lines
        The cells, as many in each row as in the header, and the line of the file that each row stands in.
    notes
        What was passed over to get them, as sentences.
    units
        What a row of units below the header says, a text a column; empty without one.
    """

    header: list[str]
    rows: Rows | list[list[str]]
    lines: Sequence[int]
    notes: list[str] = field(default_factory=list)
    units: list[str] = field(default_factory=list)


def decoded(data: bytes, where: str) -> tuple[str, list[str]]:
    """Text from bytes, and notes on how: by its byte-order mark, as UTF-8, or else as Windows-1252, as spreadsheets write.

    Raises
    ------
    FormatError
        For bytes that are no text.
    """
    for mark, code in _MARKS:
        if data.startswith(mark):
            return data.decode(code, errors="replace").removeprefix("\ufeff"), [
                f"Its byte-order mark says {code.upper()}"
            ] if code != "utf-8" else []
    if b"\0" in data:
        for at, code in ((1, "utf-16-le"), (0, "utf-16-be")):
            if len(data) >= 8 and data[:2000][at::2].count(0) > 0.4 * len(data[:2000]):
                return data.decode(code, errors="replace"), [
                    f"It has no byte-order mark and was read as {code.upper()}"
                ]
        raise FormatError(
            f"{where} is a binary file (byte {data.index(0)} is 0), not the text expected", "Check the file"
        )
    try:
        return data.decode("utf-8"), []
    except UnicodeDecodeError as error:
        if error.start >= len(data) - 3 and error.reason == "unexpected end of data":  # the beginning of a file, cut
            return data.decode("utf-8", errors="ignore"), []
        return data.decode("cp1252", errors="replace"), ["It is not UTF-8 and was read as Windows-1252"]


def of_text(text: str, where: str, known: Known) -> Cells:
    """The cells of a text table; `known` says of a cell what it names."""
    lines = _lines(text)
    found = _header(lines, known)
    if found is None:
        first = next((line.strip() for line in lines if line.strip()), "")
        raise FormatError(
            f"{where} has no line that names columns of directions; its first line is {first[:60]!r}",
            HEADER_HINT,
        )
    at, separator, header, commented = found
    notes: list[str] = []
    before = [
        line
        for line in lines[:at]
        if line.strip() and not _comment(line) and not re.fullmatch(r"sep=.", line.strip(), re.IGNORECASE)
    ]
    if before:
        notes.append(
            f"{len(before)} line{'s' if len(before) > 1 else ''} before the header passed over, from {before[0].strip()[:40]!r} on"
        )
    if commented:
        notes.append("The header stands in a comment, the last before the numbers")
    rows, numbers = [], array("q")
    for number, row in _rows(lines, at + 1):
        if any(_cells(row, _between(separator))):
            rows.append(row)
            numbers.append(number)
    return _squared(Cells(header, Rows(rows, _between(separator)), numbers, notes), where)


def of_sheet(sheet: Sequence[Sequence[str | float | None]], where: str, known: Known) -> Cells:
    """The cells of a spreadsheet."""
    texts = [["" if c is None else c.strip() if isinstance(c, str) else repr(c) for c in row] for row in sheet]
    # 400.0 as the name of a column is a wavelength
    for at, row in enumerate(texts[:HEADER_LINES]):
        if _names(row, known):
            header = [re.sub(r"\.0$", "", c) for c in row]
            body = [
                (at + 2 + k, r + [""] * (len(header) - len(r)))
                for k, r in enumerate(texts[at + 1 :])
                if any(r) and not _comment(r[0])
            ]
            notes = [f"{at} row{'s' if at > 1 else ''} before the header passed over"] if at else []
            return _squared(Cells(header, [r for _, r in body], [n for n, _ in body], notes), where)
    raise FormatError(
        f"{where} has no row that names columns of directions",
        HEADER_HINT,
    )


def has_header(text: str, known: Known) -> bool:
    """Whether the beginning of a text has a line that names columns of directions."""
    return _header(_lines(text), known) is not None


def is_numbers(text: str) -> bool:
    """Whether the beginning of a text holds nothing but rows of four numbers or more."""
    data = [line for line in _lines(text)[:-1] if line.strip() and not _comment(line)][:20]
    rows = [[c for c in re.split(r"[\s,;|]+", line) if c] for line in data]
    return len(rows) >= 2 and all(len(row) >= 4 and all(NUMBER.fullmatch(c) for c in row) for row in rows)


def _lines(text: str) -> list[str]:
    """The lines of a text; one that breaks within quotes, as a header of a spreadsheet may, in the place of its first."""
    lines = re.split(r"\r\n|\r|\n", text)
    for at, line in enumerate(lines[:HEADER_LINES]):
        if line.count('"') % 2 and not _comment(line):
            for more in range(1, 6):
                joined = " ".join(lines[at : at + 1 + more])
                if joined.count('"') % 2 == 0:
                    lines[at : at + 1 + more] = [joined, *[""] * more]
                    break
    return lines


def _comment(line: str) -> bool:
    return line.lstrip().startswith(COMMENTS)


def _names(cells: Iterable[str], known: Known) -> int:
    """How many cells name columns; 0 unless two or more do and one of them is a direction."""
    kinds = [known(cell) for cell in cells if cell and len(cell) <= 100]
    return sum(1 for kind in kinds if kind) if kinds.count("direction") and len([k for k in kinds if k]) >= 2 else 0


def _header(lines: Sequence[str], known: Known) -> tuple[int, str, list[str], bool] | None:
    """Where the header is, what separates its cells, the cells, and whether it stands in a comment.

    It is the first line that names columns and has as many cells as the row after it, and else the last comment like that.
    A line that names columns and has another number of cells is taken where there is no better one.
    """
    commented: tuple[int, str, list[str], bool] | None = None
    uneven: tuple[int, str, list[str], bool] | None = None
    for at, line in enumerate(lines[:HEADER_LINES]):
        if not line.strip():
            continue
        comment = _comment(line)
        text = line.lstrip().lstrip("#%!/").strip() if comment else line.partition("#")[0].rstrip()
        best: tuple[int, str, list[str]] = (0, "", [])
        for separator in SEPARATORS:
            cells = _cells(text, separator, of_header=True)
            n = _names(cells, known)
            if n > best[0]:
                best = (n, separator, cells)
        n, separator, cells = best
        if n == 0:
            continue
        even = _matches_next(lines, at, separator, cells)
        if even and not comment:
            return at, separator, cells, False
        if even:
            commented = (at, separator, cells, True)
        elif not comment:
            uneven = uneven or (at, separator, cells, False)
    return commented or uneven


def _matches_next(lines: Sequence[str], at: int, separator: str, cells: Sequence[str]) -> bool:
    """Whether the first row after a header has as many cells, or one more for a name of its own."""
    cut = (_cells(row, _between(separator)) for _, row in _rows(lines[: at + 50], at + 1))
    row = next((c for c in cut if any(c)), None)
    n, most = len([c for c in cells if c]), len(cells)
    return row is not None and n <= len(row) <= most + 1


def _cells(line: str, separator: str, of_header: bool = False) -> list[str]:
    if separator == WIDE_BLANKS:
        return [c.strip().strip('"') for c in re.split(r"\s{2,}|\t", line.strip())]
    if separator == BLANKS:
        if not of_header:
            return [c.strip('"') for c in line.split()]
        parts = re.findall(r'"[^"]*"|[(\[{][^)\]}]*[)\]}]|[^\s(\[{"]+(?:[(\[{][^)\]}]*[)\]}])?', line)
        joined: list[str] = []
        for part in parts:  # "theta_i (deg)" is one name
            if joined and part[0] in "([{":
                joined[-1] += " " + part
            else:
                joined.append(part.strip('"'))
        return joined
    if '"' not in line:
        return [c.strip() for c in line.split(separator)]
    return next(reading.delimited([line], separator, f"the line that begins with {line[:40]!r}", blanks=True), [])


def _between(separator: str) -> str:
    """What separates the cells of rows, by what separates those of the header."""
    return BLANKS if separator == WIDE_BLANKS else separator


def _rows(lines: Sequence[str], start: int) -> Iterator[tuple[int, str]]:
    """Line numbers and the rows from line `start` on, without comments."""
    for at in range(start, len(lines)):
        line = lines[at]
        if not line or _comment(line):
            continue
        text = (
            line
            if "#" not in line or re.search(r"#(?:N/A|NA|VALUE|DIV)", line, re.IGNORECASE)
            else line.partition("#")[0]
        )
        if text.strip():
            yield at + 1, text


def _squared(table: Cells, where: str) -> Cells:
    """The table with as many cells in each row as in the header: no trailing separators, no empty or nameless columns."""
    header, rows = table.header, table.rows
    while header and header[-1] == "" and all(len(r) < len(header) or r[len(header) - 1] == "" for r in rows):
        header = header[:-1]
    n = len(header)
    rows = rows.of_width(n) if isinstance(rows, Rows) else [r[: _end(r, n)] for r in rows]
    if (
        rows and all(len(r) == n + 1 for r in rows) and _are_row_names([r[0] for r in rows])
    ):  # R's write.table: names of rows without a name of their column
        header, n = ["", *header], n + 1
    repeated = [k for k, r in enumerate(rows) if r == header]
    if repeated:
        table.notes.append(
            f"The header stands {len(repeated)} more time{'s' if len(repeated) > 1 else ''} further down, passed over"
        )
        left = set(repeated)
        rows = rows.without(left) if isinstance(rows, Rows) else [r for k, r in enumerate(rows) if k not in left]
        table.lines = [line for k, line in enumerate(table.lines) if k not in left]
    units: list[str] = []
    if (
        rows
        and len(rows[0]) <= n
        and any(rows[0])
        and all(c == "" or names.is_unit(c.strip("()[] ")) for c in rows[0])
        and not any(NUMBER.fullmatch(c) for c in rows[0])
    ):
        units = [c.strip("()[] ") for c in rows[0]] + [""] * (n - len(rows[0]))
        rows, table.lines = rows[1:], table.lines[1:]
        table.notes.append("The row below the header holds units")
    for row, line in zip(rows, table.lines, strict=True):
        if len(row) != n:
            raise FormatError(
                f"{where}, line {line} has {len(row)} cells; the header has {n}",
                "Each row has a cell for each column; numbers with decimal commas need another separator"
                if len(row) > n
                else "Each row has a cell for each column, empty where nothing was measured",
            )
    return Cells(header, rows, table.lines, table.notes, units)


def _are_row_names(cells: Sequence[str]) -> bool:
    """Whether the first cells of the rows number them from 0 or 1 on, or are words."""
    if all(c.isascii() and c.isdigit() and len(c) < 10 for c in cells):
        return [int(c) - int(cells[0]) for c in cells] == list(range(len(cells))) and int(cells[0]) in (0, 1)
    return not any(NUMBER.fullmatch(c) for c in cells)


def _end(row: Sequence[str], n: int) -> int:
    end = len(row)
    while end > n and row[end - 1] == "":
        end -= 1
    return end


def text_of(path: Path) -> tuple[str, list[str]]:
    """The text of a file of sane size."""
    size = path.stat().st_size
    if size > reading.LARGEST_TEXT:
        raise FormatError(
            f"{path} is {size:,} bytes of text, more than the {reading.LARGEST_TEXT:,} that are read", "Split it"
        )
    return decoded(path.read_bytes(), str(path))
