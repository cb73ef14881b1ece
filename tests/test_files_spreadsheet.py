"""Spreadsheets: cells as they are shown, formulas without values refused, nothing decoded that would not fit."""

from __future__ import annotations

import datetime
import io
import tracemalloc
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motes.errors import FormatError, MissingExtraError
from motes.files import budget, spreadsheet
from motes.files.spreadsheet import read_sheets, read_spreadsheet

openpyxl = pytest.importorskip("openpyxl")

MAIN = 'xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"'
RELATIONS = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
PACKAGE = "http://schemas.openxmlformats.org/package/2006"
KINDS = "application/vnd.openxmlformats-officedocument.spreadsheetml"


def book(path: Path, rows: str, *, head: str = "", settings: str = "", more: dict[str, str] | None = None) -> Path:
    """A workbook with one sheet, A, written by hand."""
    parts = {
        "[Content_Types].xml": f'<Types xmlns="{PACKAGE}/content-types"><Default Extension="xml" ContentType="application/xml"/>'
        f'<Override PartName="/xl/workbook.xml" ContentType="{KINDS}.sheet.main+xml"/>'
        f'<Override PartName="/xl/worksheets/s.xml" ContentType="{KINDS}.worksheet+xml"/>'
        f'<Override PartName="/xl/sharedStrings.xml" ContentType="{KINDS}.sharedStrings+xml"/></Types>',
        "xl/workbook.xml": f'<workbook {MAIN} xmlns:r="{RELATIONS}"><sheets><sheet name="A" sheetId="1" r:id="i1"/></sheets>{settings}</workbook>',
        "xl/_rels/workbook.xml.rels": f'<Relationships xmlns="{PACKAGE}/relationships">'
        f'<Relationship Id="i1" Type="{RELATIONS}/worksheet" Target="worksheets/s.xml"/></Relationships>',
        "xl/sharedStrings.xml": f"<sst {MAIN}><si><t>Time</t></si><si><r><t>ri</t></r><r><t>ch</t></r></si></sst>",
        "xl/worksheets/s.xml": f"{head}<worksheet {MAIN}><sheetData>{rows}</sheetData></worksheet>",
        "xl/styles.xml": f"<styleSheet {MAIN}/>",
        **(more or {}),
    }
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in parts.items():
            archive.writestr(name, text)
    return path


def test_cells_go_where_they_say(tmp_path: Path) -> None:
    first = (
        '<row r="2"><c r="A2" t="s"><v>0</v></c><c r="C2"><v>2.5</v></c><c r="D2" t="inlineStr"><is><t>in</t></is></c>'
        '<c r="AB2" t="str"><v>x</v></c></row>'
    )
    other = (
        '<row><c><v>7</v></c><c r="B3"/><c t="e" r="C3"><v>#N/A</v></c>'
        '<c r="D3" t="b"><v>1</v></c><c t="s" r="E3"><v>1</v></c><c r="F3"/></row><row r="9"/>'
    )
    found = read_spreadsheet(book(tmp_path / "b.xlsx", first + other))
    assert found[0] == []  # rows keep their places
    assert found[1][:4] == ["Time", None, 2.5, "in"]
    assert (found[1][27], len(found[1])) == ("x", 28)
    assert found[2:] == [[7.0, None, "#N/A", "TRUE", "rich"]]


def test_what_a_spreadsheet_program_writes(tmp_path: Path) -> None:
    made = openpyxl.Workbook()
    sheet = made.active
    moment = datetime.datetime(2024, 3, 1, 6, 30)
    sheet.append(["theta_i [deg]", 1, 0.25, -1e-300, moment, moment.date(), datetime.time(1, 2, 3)])
    sheet.append([datetime.timedelta(hours=25.5), "  ", "1,5", "µ", None, False])
    sheet.merge_cells("A5:C6")
    sheet["A5"] = "merged"
    path = tmp_path / "b.xlsx"
    made.save(path)
    assert read_spreadsheet(path) == [
        ["theta_i [deg]", 1.0, 0.25, -1e-300, "2024-03-01T06:30:00", "2024-03-01", "01:02:03"],
        ["25:30:00", None, "1,5", "µ", None, "FALSE"],
        [],
        [],
        ["merged"],
    ]
    path.rename(tmp_path / "b.data")  # what it is, not what it is called
    assert read_spreadsheet(tmp_path / "b.data")[4] == ["merged"]


def test_sheets_are_chosen_by_name_and_never_guessed(tmp_path: Path) -> None:
    made = openpyxl.Workbook()
    made.active.title = "notes"
    data = made.create_sheet("data")
    data.append([1.0])
    hidden = made.create_sheet("old")
    hidden.append([2.0])
    hidden.sheet_state = "hidden"
    path = tmp_path / "b.xlsx"
    made.save(path)
    assert read_spreadsheet(path) == [[1.0]]  # the only one to be seen with anything in it
    assert read_spreadsheet(path, "old") == [[2.0]]
    assert set(read_sheets(path)) == {"notes", "data"}
    with pytest.raises(FormatError, match="no sheet 'B'; it has 'notes', 'data', 'old'"):
        read_spreadsheet(path, "B")
    made["notes"].append(["by hand"])
    made.save(path)
    with pytest.raises(FormatError, match="2 sheets with cells: 'notes', 'data'"):
        read_spreadsheet(path)


@pytest.mark.parametrize(
    ("cell", "outcome"),
    [
        ('<c r="C7"><f>A1</f><v>3</v></c>', 3.0),
        ('<c r="C7" t="str"><f>IF(A1="","",A1)</f><v></v></c>', None),  # calculated, to no text
        ('<c r="C7" t="str"><f>A1</f><v>yes</v></c>', "yes"),
        ('<c r="C7"><f>A1</f><v></v></c>', "C7 is a formula whose value is not stored"),
        ('<c r="C7"><f>A1</f><v/></c>', "C7 is a formula whose value is not stored"),
        ('<c r="C7"><f>A1</f></c>', "C7 is a formula whose value is not stored"),
        ('<c s="1" r="C7"><f t="shared" si="0"/></c>', "C7 is a formula whose value is not stored"),
    ],
)
def test_formulas_have_their_values_or_are_refused(tmp_path: Path, cell: str, outcome: object) -> None:
    plain = '<c r="A7"><v>1</v></c>'
    path = book(tmp_path / "b.xlsx", f'<row r="7">{plain}{cell}<c r="D7"><v>4</v></c></row>')
    if isinstance(outcome, str) and "formula" in outcome:
        with pytest.raises(FormatError, match=outcome):
            read_spreadsheet(path)
    else:
        assert read_spreadsheet(path)[6] == [1.0, None, outcome, 4.0]


def test_zeros_in_place_of_values_are_not_taken_for_values(tmp_path: Path) -> None:
    """Programs that do not calculate write 0 for a formula and ask for the calculation when the file is opened."""
    row = '<row r="1"><c r="A1"><f>1+1</f><v>0</v></c></row>'
    path = book(tmp_path / "b.xlsx", row, settings='<calcPr calcId="124519" fullCalcOnLoad="1"/>')
    with pytest.raises(FormatError, match="A1 is a formula, and the program that wrote the file left it"):
        read_spreadsheet(path)
    made = openpyxl.Workbook()
    made.active.append([1.0, "=A1+1"])
    made.save(path)
    with pytest.raises(FormatError, match="B1 is a formula"):
        read_spreadsheet(path)


def test_a_formula_is_found_across_the_pieces_of_a_large_sheet(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    rows = "".join(f'<row r="{k}"><c r="A{k}"><v>{k}</v></c></row>' for k in range(1, 30))
    path = book(tmp_path / "b.xlsx", rows + '<row r="30"><c r="A30"><f>A1</f></c></row>')
    for piece in (1, 7, 64, 1000):
        monkeypatch.setattr(spreadsheet, "PIECE", piece)
        with pytest.raises(FormatError, match="A30 is a formula whose value"):
            read_spreadsheet(path)


def claimed(path: Path, size: int) -> None:
    """A workbook whose directory says that a part, which nothing scans, is packed in so many bytes."""
    data = bytearray(book(path, "").read_bytes())
    at = data.rindex(b"PK\x01\x02") + 20
    data[at : at + 4] = size.to_bytes(4, "little")
    path.write_bytes(data)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda p: p.write_bytes(b"PK no"), "not a spreadsheet"),
        (lambda p: p.write_bytes(b"PK\x03\x04 no"), "not a readable spreadsheet"),
        (lambda p: p.write_bytes(b"\xd0\xcf\x11\xe0" + bytes(600)), "old kind"),
        (lambda p: p.write_text("theta_i,R\n1,2\n"), "not a spreadsheet"),
        (lambda p: book(p, '<row><c r="A1" t="s"><v>9</v></c></row>'), "not a readable spreadsheet"),
        (lambda p: book(p, '<row><c r="A1"><v>' + "1" * 400 + "</v></c></row>"), "not a readable spreadsheet"),
        (lambda p: book(p, "<row>"), "not a readable spreadsheet"),
        (lambda p: book(p, "", head='<!DOCTYPE x [<!ENTITY a "b">]>'), "document type"),
        (lambda p: zipfile.ZipFile(p, "w").writestr("a.txt", "x"), "not a spreadsheet"),
        (lambda p: claimed(p, 2**32 - 2**20), "takes 4293918720 bytes of its"),
        (lambda p: None, "cannot be read"),
    ],
)
def test_damaged_spreadsheets_are_named(make: Callable[[Path], object], message: str, tmp_path: Path) -> None:
    make(tmp_path / "b.xlsx")
    with pytest.raises(FormatError, match=message):
        read_spreadsheet(tmp_path / "b.xlsx", "A")


EMPTY = '<row r="1"/>'
FAR = "".join(f'<row><c r="XFD{k}"><v>1</v></c></row>' for k in range(40))
BOMBS: dict[str, dict[str, Any]] = {
    "one large part": {"more": {"xl/media/a.bin": "\0" * 8_000_000}},
    "strings": {"more": {"xl/sharedStrings.xml": f"<sst {MAIN}>" + "<si><t>a</t></si>" * 70_000 + "</sst>"}},
    "styles": {
        "more": {"xl/styles.xml": f"<styleSheet {MAIN}><cellXfs>" + "<xf/>" * 20_000 + "</cellXfs></styleSheet>"}
    },
    "cells of a row": {"rows": "<row>" + "<c/>" * 150_000 + "</row>"},
    "rows": {"rows": "<row/>" * 80_000},
    "a cell far away": {"rows": '<row r="1048576"><c r="XFD1048576"><v>1</v></c></row>' + FAR},
    "a row far away": {"rows": '<row r="1048576"><c r="A1048576"><v>1</v></c></row>'},
    "what no row holds": {"rows": EMPTY + "<x/>" * 150_000},
}


@pytest.mark.parametrize("kind", list(BOMBS))
def test_small_files_do_not_become_large_ones(tmp_path: Path, kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(budget, "LEAST", 6 * 2**20)  # all in a tenth of the size
    path = tmp_path / "b.xlsx"
    book(path, **{"rows": EMPTY, **BOMBS[kind]})
    assert path.stat().st_size < 300_000
    tracemalloc.start()
    try:
        with pytest.raises(FormatError, match=r"MiB of memory|tags in a row"):
            read_spreadsheet(path, "A")
        assert tracemalloc.get_traced_memory()[1] < budget.LEAST
    finally:
        tracemalloc.stop()


def test_more_memory_is_had_by_asking(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = book(tmp_path / "b.xlsx", '<row r="1"><c><v>5</v></c></row>', more={"xl/media/a.bin": "\0" * 80_000_000})
    with pytest.raises(FormatError, match=r"76 MiB of memory, more than 64. .* set MOTES_LARGEST_MIB=77"):
        read_spreadsheet(path)
    monkeypatch.setenv(budget.VARIABLE, "77")
    assert read_spreadsheet(path) == [[5.0]]
    monkeypatch.setenv(budget.VARIABLE, "much")
    with pytest.raises(Exception, match="'much' is not a number of MiB"):
        read_spreadsheet(path)


def test_mutated_spreadsheets_give_rows_or_a_sentence(tmp_path: Path) -> None:
    """Bytes of the archive, and bytes of its parts before they are packed, which no checksum then finds."""
    rng = np.random.default_rng(7)
    rows = "".join(
        f'<row r="{k}"><c r="A{k}" t="s"><v>0</v></c><c r="B{k}" s="0"><v>{k / 3}</v></c></row>' for k in range(1, 5)
    )
    good = book(tmp_path / "good.xlsx", rows).read_bytes()
    with zipfile.ZipFile(io.BytesIO(good)) as archive:
        parts = {name: archive.read(name) for name in archive.namelist()}
    path, answers, longest = tmp_path / "b.xlsx", 0, 0
    for k in range(800):
        if k % 4 == 0:
            data = bytearray(good[: rng.integers(4, len(good))] if k % 8 else good)
            data[rng.integers(0, len(data))] = rng.integers(0, 256)
            path.write_bytes(bytes(data))
        else:
            name = list(parts)[rng.integers(0, len(parts))]
            text = bytearray(parts[name])
            at = int(rng.integers(0, len(text)))
            text[at : at + int(rng.integers(0, 4))] = bytes(rng.integers(32, 127, rng.integers(0, 4)))
            with zipfile.ZipFile(path, "w") as archive:
                for each, content in parts.items():
                    archive.writestr(each, bytes(text) if each == name else content)
        try:
            answers += len(read_spreadsheet(path)) >= 0
        except FormatError as error:
            longest = max(longest, len(str(error)))
    assert answers > 50
    assert longest < 600


def test_without_the_package_the_command_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "openpyxl", None)
    with pytest.raises(MissingExtraError, match=r"openpyxl.*\[xlsx\]"):
        read_spreadsheet(book(tmp_path / "b.xlsx", ""))
