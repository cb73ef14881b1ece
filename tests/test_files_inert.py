"""Texts out of files do nothing in spreadsheets, terminals and pages; what is written has the mode that the umask says."""

from __future__ import annotations

import csv
import os
import unicodedata
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import motes
from motes.cli import console
from motes.drawing.markup import tag
from motes.exports import csv_table
from motes.files import write_csv, write_text
from motes.files.inert import cell, without_controls
from motes.viewer.page import safe_json

FORMULAS = [
    "=cmd|' /C calc'!A0",
    "+1+1",
    "-2+3",
    "@SUM(A1)",
    " =1+1",
    "\t=1",
    "＝1+1",
    "a;=1+1",
    "a,\n=1+1",
    'x";=1',
    "-1;-2",
]
# Every character that Unicode says turns or isolates direction, by its own table.
DIRECTIONS = [chr(c) for c in range(0x110000) if unicodedata.bidirectional(chr(c)) in
              {"LRE", "RLE", "LRO", "RLO", "PDF", "LRI", "RLI", "FSI", "PDI"}]  # fmt: skip
MARKS = ["\u200e", "\u200f", "\u061c"]
CONTROLS = [chr(c) for c in range(0x110000) if unicodedata.category(chr(c)) == "Cc" and chr(c) not in "\t\n\r"]


def begins_formula(text: str) -> bool:
    return text.lstrip().startswith(tuple("=+-@＝＋－＠"))


def number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


@pytest.mark.parametrize("text", FORMULAS)
@pytest.mark.parametrize("delimiter", [",", ";"])
def test_no_cell_is_a_formula_for_either_kind_of_spreadsheet(text: str, delimiter: str, tmp_path: Path) -> None:
    path = write_csv(tmp_path / "t.csv", [["name", "value"], [text, "-0.25"]])
    with path.open(newline="", encoding="utf-8") as handle:
        cells = [c for row in csv.reader(handle, delimiter=delimiter) for c in row]
    assert not [c for c in cells if begins_formula(c) and not number(c)]
    assert any(c.endswith("-0.25") for c in cells)


@pytest.mark.parametrize(
    "text", ["R", "550 nm", "-0.5", "1e-300", "-inf", "nan", "a-b", "K_d = 3", "-", "", "naïve, über"]
)
def test_what_is_harmless_stays(text: str) -> None:
    assert cell(text) == text
    assert without_controls(text) == text


def test_a_fit_of_data_with_a_hostile_channel(tmp_path: Path) -> None:
    from motes.directions import from_spherical
    from motes.measurements import Measurement

    wi = from_spherical(np.linspace(0.1, 1.2, 12), 0.0)
    wo = from_spherical(np.linspace(1.1, 0.2, 12), 1.0)
    names = ["=cmd|' /C calc'!A0", "\x1b]0;title\x07 \u202egnp"]
    fit = motes.fit(Measurement.from_arrays(wi, wo, np.full((12, 2), 0.1), channels=names), "lambert")
    with (fit.save(tmp_path) / "parameters.csv").open(newline="", encoding="utf-8") as handle:
        channels = [row["channel"] for row in csv.DictReader(handle)]
    assert channels == ["'=cmd|' /C calc'!A0", "\ufffd]0;title\ufffd \ufffdgnp"]


def test_notes_of_a_table(tmp_path: Path) -> None:
    subject = SimpleNamespace(
        title="x,=1+1;@SUM(A1)", notes=(), wavelengths=(), channels=("-1",), brdf=motes.Lambert(0.5)
    )
    csv_table.write([(None, subject)], tmp_path / "t.csv")  # type: ignore[list-item]
    for delimiter in ",;":
        with (tmp_path / "t.csv").open(newline="", encoding="utf-8") as handle:
            cells = [c for row in csv.reader(handle, delimiter=delimiter) for c in row]
        assert not [c for c in cells if begins_formula(c) and not number(c)]


def test_pages_show_nothing_that_acts() -> None:
    hostile = "".join([*DIRECTIONS, *MARKS, *CONTROLS, "\ud800", "\u2028", "\U000e0041"])
    assert len(DIRECTIONS) == 9
    assert tag("p", hostile, title=hostile) == tag("p", "\ufffd" * len(hostile), title="\ufffd" * len(hostile))
    page = safe_json({hostile: ["x", hostile]})
    assert not [c for c in [*DIRECTIONS, *MARKS, "\u2028"] if c in page or f"\\u{ord(c):04x}" in page]
    assert not [c for c in CONTROLS if c in page]


def test_terminals_show_nothing_that_acts(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    hostile = "\x1b]0;title\x07\x9b31m\u202egnp"
    table = console.Table()
    table.add_column(hostile)
    table.add_row(hostile)
    console.print_table(table)
    console.print_facts([(hostile, hostile)])
    console.warn(hostile)
    out, err = capsys.readouterr()
    assert not [c for c in "\x1b\x07\x9b\u202e" if c in out + err]
    assert out.count("gnp") == 4
    assert "gnp" in err


def test_every_table_on_a_terminal_is_a_clean_one() -> None:
    sources = Path(console.__file__).parent.glob("*.py")
    found = [p.name for p in sources if "rich.table" in p.read_text() or "from rich import table" in p.read_text()]
    assert found == ["console.py"]


@pytest.mark.skipif(os.name != "posix", reason="modes are those of POSIX")
@pytest.mark.parametrize(("mask", "mode"), [(0o022, 0o644), (0o077, 0o600), (0o002, 0o664)])
def test_the_mode_is_the_umasks_which_is_never_set(
    mask: int, mode: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before, real = os.umask(mask), os.umask
    try:
        with monkeypatch.context() as patch:
            patch.setattr(os, "umask", lambda _: pytest.fail("the umask belongs to all threads"))
            path = write_text(tmp_path / "t.txt", "x")
    finally:
        real(before)
    assert path.stat().st_mode & 0o777 == mode
    assert [p.name for p in tmp_path.iterdir()] == ["t.txt"]
