"""Cells of a spreadsheet (Office Open XML, ``.xlsx``) by openpyxl: numbers and texts, nothing else.

What a cell holds is what the program that wrote the file last showed there: the values of formulas, dates as ISO 8601.  openpyxl itself does not look at
sizes, so the parts of the archive are gone through once before it sees them: how much memory they would take, and that they bring no document type of
their own, whose entities can explode.
"""

from __future__ import annotations

import datetime
import re
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

from motes.errors import FormatError, MissingExtraError, MotesError
from motes.files import budget
from motes.quiet import without_warnings

Cell = str | float | None

ZIP, OLE = b"PK\x03\x04", b"\xd0\xcf\x11\xe0"
PIECE = 2**20
#: Bytes that openpyxl takes, as measured: for an element of a part that it keeps whole (styles, relations), and for a row that it has passed.
KEPT, ROW = 600, 100
#: Tags between two rows: more than the 16,384 cells of a row need; each takes 250 bytes while the row is read.
MOST_TAGS = 120_000
#: A row without cells, which all of these share: a number of a row in the file can leave out a million; and the bytes that one takes in a table at last.
NOTHING: list[Cell] = []
GAP = 160
_DOCTYPE = tuple(
    word.encode(code) for word in ("<!DOCTYPE", "<!ENTITY") for code in ("ascii", "utf-16-le", "utf-16-be")
)
_ROW = re.compile(rb"<(?:\w+:)?(?:row|si)\b")
_FORMULA = re.compile(rb"<(?:\w+:)?c\b([^<>]*)><(?:\w+:)?f[\s/>]")
# A formula without a value; what was calculated to no text is stored as such, by the type of the cell.
_EMPTY = re.compile(
    rb"<(?:\w+:)?c\b([^<>]*)>\s*<(?:\w+:)?f\b(?:[^<>]*/>|[^<>]*>[^<]*</(?:\w+:)?f>)\s*(?:<(?:\w+:)?v\s*/>|<(?:\w+:)?v>\s*</(?:\w+:)?v>)?\s*</(?:\w+:)?c>"
)
_TEXT = re.compile(rb"\bt=[\"']str")
# What programs write that do not calculate: their formulas have no values, or zeros in place of them.
_UNCALCULATED = re.compile(rb"fullCalcOnLoad\s*=\s*[\"'](?:1|true)")
LONGEST = 9000  # bytes of the longest of these patterns, carried from piece to piece: a formula has at most 8,192


def read_spreadsheet(path: Path, sheet: str | None = None) -> list[list[Cell]]:
    """The rows of a sheet: texts, numbers as float, None where a cell is empty.

    Parameters
    ----------
    path
        An ``.xlsx`` or ``.xlsm`` file.
    sheet
        Its name; the only visible sheet that holds anything when not given.

    Returns
    -------
    list of list
        A list a row, from the first row on, each as long as its last cell that is not empty.  Dates are texts such as ``2024-03-01`` or
        ``2024-03-01T12:30:00``, times of day ``12:30:00``, durations ``25:30:00``; truth values are ``TRUE`` and ``FALSE``, errors their names, such
        as ``#N/A``.

    Raises
    ------
    MissingExtraError
        Without the package openpyxl.
    FormatError
        When the file is no spreadsheet, is damaged, would take too much memory, has no such sheet or several to choose from, or holds a formula whose
        value is not stored.
    """
    if sheet is not None:
        return read_sheets(path, [sheet])[sheet]
    found = {name: rows for name, rows in read_sheets(path).items() if rows}
    if len(found) != 1:
        names = ", ".join(repr(name) for name in list(found)[:8]) or "nothing"
        raise FormatError(f"{path} has {len(found)} sheets with cells: {names}", "Name the sheet to be read")
    return next(iter(found.values()))


def read_sheets(path: Path, names: list[str] | None = None) -> dict[str, list[list[Cell]]]:
    """The rows of several sheets by name, as `read_spreadsheet` gives them; of all that are visible when no names are given."""
    _check_formulas(path, _examined(path))
    with _opened(path, data_only=True) as book:
        present = [s.title for s in book.worksheets if names is not None or s.sheet_state == "visible"]
        wanted = present if names is None else names
        missing = [name for name in wanted if name not in present]
        if missing:
            listed = ", ".join(repr(name) for name in present[:8]) or "none"
            raise FormatError(f"{path} has no sheet {missing[0][:60]!r}; it has {listed}", "Name one of these")
        purse = _Purse(path)
        return {name: _rows(book[name], purse) for name in wanted}


def is_spreadsheet(head: bytes) -> bool:
    """Whether a file that begins so may be a spreadsheet: an archive, or the container of older ones."""
    return head.startswith((ZIP, OLE))


class _Purse:
    """What the cells that are kept may take, in bytes: an archive says little of what its rows will be."""

    def __init__(self, path: Path) -> None:
        self.path, self.size, self.spent = path, path.stat().st_size, 0
        self.allowed = budget.allowed(self.size)

    def spend(self, n: int) -> None:
        self.spent += n
        if self.spent > self.allowed:
            budget.check(self.path, self.spent, "its cells", self.size)


def _rows(sheet: Any, purse: _Purse) -> list[list[Cell]]:
    sheet.reset_dimensions()  # what a file says of its extent is often wrong, and rows would be filled up to it
    rows: list[list[Cell]] = []
    for row in sheet.iter_rows(values_only=True):
        cells = [_cell(value) for value in row]
        while cells and cells[-1] is None:
            cells.pop()
        purse.spend(GAP if not cells else 64 + 32 * len(cells) + sum(len(c) for c in cells if isinstance(c, str)))
        rows.append(cells or NOTHING)
    while rows and not rows[-1]:
        rows.pop()
    return rows


def _cell(value: Any) -> Cell:
    match value:
        case None:
            return None
        case bool():
            return "TRUE" if value else "FALSE"
        case int() | float():
            return float(value)
        case datetime.datetime():
            midnight = value.time() == datetime.time(0)
            return value.date().isoformat() if midnight else value.isoformat()
        case datetime.date() | datetime.time():
            return value.isoformat()
        case datetime.timedelta():
            seconds = round(value.total_seconds())
            sign, seconds = ("-" if seconds < 0 else ""), abs(seconds)
            return f"{sign}{seconds // 3600}:{seconds // 60 % 60:02d}:{seconds % 60:02d}"
        case _:
            text = str(value)
            return text if text.strip() else None


class _Facts(NamedTuple):
    """Of a part or of all: the memory it takes [bytes], the first formula and the first without a value, whether they wait to be calculated."""

    cost: int = 0
    formula: str = ""
    empty: str = ""
    uncalculated: bool = False

    def with_part(self, other: _Facts) -> _Facts:
        return _Facts(
            self.cost + other.cost,
            self.formula or other.formula,
            self.empty or other.empty,
            self.uncalculated or other.uncalculated,
        )


def _examined(path: Path) -> _Facts:
    """Go through the archive: sizes, no document types."""
    try:
        size = path.stat().st_size
        with path.open("rb") as file:
            start = file.read(4)
        if start == OLE:
            raise FormatError(
                f"{path} is a spreadsheet of the old kind (.xls), or one with a password",
                "Save it as .xlsx, without a password",
            )
        if start != ZIP:
            raise FormatError(f"{path} is not a spreadsheet: it begins with {start!r}", "Save it as .xlsx")
        facts = _Facts()
        with zipfile.ZipFile(path) as archive:
            parts = archive.infolist()
            budget.check(path, sum(part.file_size for part in parts), "its parts", size)
            # As many bytes as a part claims to be packed in are asked of the file, and memory made for them, before any is read.
            if long := [part for part in parts if part.compress_size > size]:
                said = f"{long[0].filename[:80]} takes {long[0].compress_size} bytes of its {size}"
                raise _damaged(path, zipfile.BadZipFile(said))
            for part in parts:
                if part.filename.lower().endswith((".xml", ".rels", ".vml")):
                    facts = facts.with_part(_part(path, archive, part))
                    budget.check(path, facts.cost, "its cells", size)
            if "[Content_Types].xml" not in archive.namelist():
                raise FormatError(f"{path} is an archive, but not a spreadsheet", "Save it as .xlsx")
        return facts
    except MotesError:
        raise
    except OSError as error:
        raise FormatError(f"{path} cannot be read: {error.strerror or error}", "Check the path") from error
    except Exception as error:  # zipfile raises BadZipFile, zlib.error, EOFError, NotImplementedError, RuntimeError...
        raise _damaged(path, error) from None


def _part(path: Path, archive: zipfile.ZipFile, part: zipfile.ZipInfo) -> _Facts:
    folder, _, name = part.filename.lower().rpartition("/")
    strings = "sharedstrings" in name
    is_sheet = folder.endswith("worksheets") or ("sheet" in name and not folder.endswith(("chartsheets", "_rels")))
    rows = elements = since = 0
    formula = empty = ""
    uncalculated, tail = False, b""
    with archive.open(part) as file:
        while piece := file.read(PIECE):
            data = tail + piece
            if any(word in data for word in _DOCTYPE):
                raise FormatError(f"{path}: {part.filename[:80]} brings a document type", "Save it as .xlsx again")
            if is_sheet:
                found = _FORMULA.search(data)
                formula = formula or (_place(found[1]) if found else "")
                empty = empty or next((_place(m[1]) for m in _EMPTY.finditer(data) if not _TEXT.search(m[1])), "")
            else:
                uncalculated = uncalculated or _UNCALCULATED.search(data) is not None
            segments = _ROW.split(piece)  # a name across the border of two pieces is counted as a tag of the row before
            rows += len(segments) - 1
            for k, segment in enumerate(segments):
                n = segment.count(b"<")
                elements += n - segment.count(b"</")
                since = n + (since if k == 0 else 0)
                if (is_sheet or strings) and since > MOST_TAGS:
                    raise FormatError(
                        f"{path}: {part.filename[:80]} holds more than {MOST_TAGS:,} tags in a row",
                        "The file is damaged",
                    )
            tail = data[-LONGEST:]
    if is_sheet or strings:
        return _Facts(ROW * rows + (part.file_size if strings else 0), formula, empty, uncalculated)
    return _Facts(part.file_size + KEPT * elements, formula, empty, uncalculated)


def _place(attributes: bytes) -> str:
    """``C7`` out of the attributes of a cell."""
    found = re.search(rb"\br=[\"']([A-Za-z]{1,3}[0-9]{1,7})", attributes)
    return found[1].decode() if found else "of a sheet"


def _check_formulas(path: Path, facts: _Facts) -> None:
    """Refuse formulas without a value: a file that no program has calculated yet holds none, or zeros in their place."""
    hint = "Open it in a spreadsheet program and save it there, or store values in place of formulas"
    if facts.formula and facts.uncalculated:
        raise FormatError(
            f"{path}: the cell {facts.formula} is a formula, and the program that wrote the file left it to be calculated",
            hint,
        )
    if facts.empty:
        raise FormatError(f"{path}: the cell {facts.empty} is a formula whose value is not stored", hint)


@contextmanager
def _opened(path: Path, *, data_only: bool) -> Iterator[Any]:
    """The workbook; whatever the library raises on it is a `FormatError`."""
    try:
        import openpyxl
    except ImportError:
        raise MissingExtraError("openpyxl", "xlsx", "Reading a spreadsheet") from None
    book = None
    try:
        # It warns of what it will not write again (validation, conditional formats); nothing is written here.
        with (
            without_warnings(),
            path.open("rb") as file,
        ):  # by a handle: the library goes by the name's suffix otherwise
            book = openpyxl.load_workbook(file, read_only=True, data_only=data_only, keep_links=False)
            yield book
    except (MotesError, MemoryError):
        raise
    except Exception as error:  # KeyError, TypeError, ParseError...: what a damaged archive makes of the library
        raise _damaged(path, error) from None
    finally:
        if book is not None:
            book.close()


def _damaged(path: Path, error: Exception) -> FormatError:
    said = " ".join(str(error).split())[:100] or type(error).__name__
    return FormatError(f"{path} is not a readable spreadsheet: {said}", "Save it again as .xlsx, or fetch it again")
