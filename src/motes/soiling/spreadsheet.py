"""Cells of a spreadsheet (Office Open XML): numbers and texts, nothing else; sizes are checked before anything is decoded."""

from __future__ import annotations

import zipfile
import zlib
from collections.abc import Sequence
from pathlib import Path
from xml.etree import ElementTree

from motes.errors import FormatError

LARGEST_FILE = 16 * 2**20
LARGEST_PART = 64 * 2**20
MOST_COLUMNS = 1024
_MAIN = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
_REFERENCE = "{http://schemas.openxmlformats.org/officeDocument/2006/relationships}id"

Cell = float | str | None
#: What reading a damaged archive, or a sheet that refers to what is not there, raises.
DAMAGE = (
    zipfile.BadZipFile,
    zipfile.LargeZipFile,
    zlib.error,
    ElementTree.ParseError,
    LookupError,
    ValueError,
    EOFError,
    RuntimeError,
)


def read(path: Path, sheets: Sequence[str]) -> dict[str, list[list[Cell]]]:
    """Rows of the named sheets; empty cells are None.

    Raises
    ------
    FormatError
        When the file is no spreadsheet, is damaged or too large, or lacks a sheet.
    """
    try:
        if path.stat().st_size > LARGEST_FILE:
            raise FormatError(f"{path} has {path.stat().st_size} bytes, more than {LARGEST_FILE}")
        with zipfile.ZipFile(path) as archive:
            book = _part(archive, "xl/workbook.xml", path)
            targets = {e.get("Id"): str(e.get("Target")) for e in _part(archive, "xl/_rels/workbook.xml.rels", path)}
            where = {e.get("name"): targets[e.get(_REFERENCE)] for e in book.iter(f"{_MAIN}sheet")}
            missing = [name for name in sheets if name not in where]
            if missing:
                raise FormatError(f"{path} has no sheet {missing[0]!r}", "The file is not what it was taken for")
            texts: list[str] = []
            if "xl/sharedStrings.xml" in archive.namelist():
                shared = _part(archive, "xl/sharedStrings.xml", path)
                texts = ["".join(t.text or "" for t in e.iter(f"{_MAIN}t")) for e in shared.iter(f"{_MAIN}si")]
            found = {}
            for name in sheets:
                target = where[name].lstrip("/")
                found[name] = _rows(_part(archive, target if target.startswith("xl/") else f"xl/{target}", path), texts)
            return found
    except OSError as error:
        raise FormatError(f"{path} cannot be read: {error.strerror or error}") from error
    except DAMAGE as error:
        if isinstance(error, FormatError):
            raise
        raise FormatError(
            f"{path} is not a readable spreadsheet: {str(error)[:100]}", "Fetch the file again"
        ) from error


def _part(archive: zipfile.ZipFile, name: str, path: Path) -> ElementTree.Element:
    info = archive.getinfo(name)
    if info.file_size > LARGEST_PART:
        raise FormatError(f"{path}: {name} has {info.file_size} bytes, more than {LARGEST_PART}")
    data = archive.read(info)
    if b"<!DOCTYPE" in data[:1000] or b"<!ENTITY" in data:  # spreadsheets have none, and entities can explode
        raise FormatError(f"{path}: {name} has a document type of its own", "Fetch the file again")
    return ElementTree.fromstring(data)


def _rows(sheet: ElementTree.Element, texts: list[str]) -> list[list[Cell]]:
    rows: list[list[Cell]] = []
    for row in sheet.iter(f"{_MAIN}row"):
        cells: list[Cell] = []
        for cell in row.iter(f"{_MAIN}c"):
            value = cell.find(f"{_MAIN}v")
            if value is None or value.text is None:
                continue
            column = _column(cell.get("r") or "") if cell.get("r") else len(cells)
            if column >= MOST_COLUMNS:
                continue
            cells += [None] * (column + 1 - len(cells))
            kind = cell.get("t")
            cells[column] = (
                texts[int(value.text)] if kind == "s" else _number(value.text) if kind in (None, "n") else value.text
            )
        rows.append(cells)
    return rows


def _column(reference: str) -> int:
    """0 for A1, 27 for AB7."""
    n = 0
    for letter in reference:
        if not "A" <= letter <= "Z":
            break
        n = 26 * n + ord(letter) - 64
    return n - 1


def _number(text: str) -> Cell:
    try:
        return float(text)
    except ValueError:
        return text
