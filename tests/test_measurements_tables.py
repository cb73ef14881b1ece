"""The reader of tables: `tests/tables.json`, which the viewer's reader runs through as well, encodings, spreadsheets, options."""

from __future__ import annotations

import codecs
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motes.directions import from_spherical
from motes.errors import FormatError, MotesError
from motes.measurements import Measurement, read
from motes.measurements._column_names import column
from motes.measurements.table_writing import write_table

TABLES: list[dict[str, Any]] = json.loads(Path(__file__).with_name("tables.json").read_text(encoding="utf-8"))["tables"]
HEADER = "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,"


def measured(path: Path, **options: Any) -> Measurement:
    data = read(path, **options)
    assert isinstance(data, Measurement)
    assert data.provenance["format"] == "csv"
    return data


def written(folder: Path, text: str, name: str = "table.csv") -> Path:
    (folder / name).write_text(text, encoding="utf-8")
    return folder / name


@pytest.mark.parametrize("table", TABLES, ids=[t["name"] for t in TABLES])
def test_what_comes_of_a_table(table: dict[str, Any], tmp_path: Path) -> None:
    path = tmp_path / "table.csv"
    path.write_bytes(table["text"].encode())
    if "refused" in table:
        with pytest.raises(FormatError) as caught:
            read(path)
        assert table["refused"] in caught.value.message
        assert caught.value.hint
        return
    data = measured(path)
    assert list(data.channels) == table["channels"]
    values = np.array(table["values"], float)
    np.testing.assert_allclose(data.values, values, rtol=1e-12)
    np.testing.assert_allclose(data.times, table.get("times", [0.0]), rtol=1e-12)
    np.testing.assert_allclose(np.degrees(data.theta_i), table["theta_i"], atol=1e-9)
    np.testing.assert_allclose(np.degrees(data.theta_r), table["theta_r"], atol=1e-9)
    if "dphi" in table:
        np.testing.assert_allclose(data.dphi, np.radians(table["dphi"]), atol=1e-12)
    if "wavelengths" in table:
        np.testing.assert_allclose(data.wavelengths, table["wavelengths"], rtol=1e-12)
    else:
        assert data.wavelengths is None
    if "uncertainties" in table:
        np.testing.assert_allclose(data.uncertainties, table["uncertainties"], rtol=1e-12)
    else:
        assert data.uncertainties is None
    np.testing.assert_array_equal(data.mask, table.get("usable", np.isfinite(values)))
    for words in table.get("notes", ()):
        assert words in " ".join(data.provenance["notes"])
    assert len(data.provenance["columns"]) >= 2


def test_names_of_the_tables_differ() -> None:
    names = [t["name"] for t in TABLES]
    assert len(set(names)) == len(names) > 70


GREEK = "θ_i (deg),θ_r (deg),φ_r (deg),brdf\n10,20,0,.1\n30,40,0,.2\n"


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (GREEK.encode("utf-8"), ""),
        (codecs.BOM_UTF8 + GREEK.encode("utf-8"), ""),
        (GREEK.encode("utf-16"), "UTF-16"),
        (codecs.BOM_UTF16_BE + GREEK.encode("utf-16-be"), "UTF-16"),
        (GREEK.encode("utf-16-le"), "UTF-16-LE"),
        (GREEK.replace("θ", "theta").replace("φ", "phi").replace("deg", "°").encode("cp1252"), "Windows-1252"),
        (GREEK.replace("\n", "\r").encode(), ""),
    ],
)
def test_encodings(data: bytes, words: str, tmp_path: Path) -> None:
    (tmp_path / "t.txt").write_bytes(data)
    found = measured(tmp_path / "t.txt")
    np.testing.assert_allclose(np.degrees(found.theta_r), [20, 40])
    assert words in " ".join(found.provenance["notes"])


def test_what_each_column_is_taken_for_is_said(tmp_path: Path) -> None:
    text = "id,theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,hours,R,G,B,rel_unc_R\n" + "1,10,0,20,0,0,.1,.2,.3,.01\n"
    assert measured(written(tmp_path, text)).provenance["columns"] == [
        "id: left out",
        "theta_i_deg: theta_i [deg]",
        "phi_i_deg: phi_i [deg]",
        "theta_r_deg: theta_r [deg]",
        "phi_r_deg: phi_r [deg]",
        "hours: time [h]",
        "R: f_r [1/sr], channel R",
        "G: f_r [1/sr], channel G",
        "B: f_r [1/sr], channel B",
        "rel_unc_R: uncertainty, one standard deviation, as a share of the value of channel R",
    ]


def test_many_columns_are_said_in_one_line(tmp_path: Path) -> None:
    bands = range(400, 600)
    text = HEADER + ",".join(map(str, bands)) + "\n10,0,20,0," + ",".join(["0.1"] * 200) + "\n"
    assert measured(written(tmp_path, text)).provenance["columns"][4:] == [
        "400 .. 599 (200 columns): f_r [1/sr] at a wavelength [nm]"
    ]


class TestOptions:
    """`--read` in Python's words."""

    def test_a_column_that_is_not_known(self, tmp_path: Path) -> None:
        path = written(tmp_path, HEADER + "lum,T\n10,0,20,0,.1,21\n")
        with pytest.raises(FormatError, match=r"'lum' is not|'T' is not") as caught:
            read(path)
        assert "--read 'column:" in caught.value.hint
        data = measured(path, columns={"T": "ignore", "lum": "brdf"})
        assert data.channels in (("grey",), ("lum",))
        assert data.values.ravel().tolist() == [0.1]
        assert data.provenance["options"] == {"columns": {"T": "ignore", "lum": "brdf"}}

    def test_the_nearest_names_are_three(self, tmp_path: Path) -> None:
        path = written(tmp_path, HEADER + "brdff\n10,0,20,0,.1\n")
        with pytest.raises(FormatError, match=r"nearest names are brdf, \w+, \w+"):
            read(path)

    def test_two_unknown_columns_become_two_channels(self, tmp_path: Path) -> None:
        path = written(tmp_path, HEADER + "p,q\n10,0,20,0,.1,.2\n")
        data = measured(path, columns={"p": "brdf", "q": "brdf"})
        assert data.channels == ("p", "q")
        assert measured(path, columns={"5": "R", "6": "ignore"}).channels == ("R",)

    def test_what_does_not_fit(self, tmp_path: Path) -> None:
        path = written(tmp_path, HEADER + "brdf\n10,0,20,0,.1\n")
        for options, words in (
            ({"columns": {"nothing": "brdf"}}, "has no column 'nothing'"),
            ({"columns": {"brdf": "sparkle"}}, "'sparkle' is no role"),
            ({"angles": "grad"}, "angles = grad is none of"),
            ({"azimuth": "left"}, "azimuth = left"),
            ({"sheet": "a"}, "is no spreadsheet"),
            ({"theta_i_deg": 3.0}, "has a column of theta_i already"),
            ({"relative_uncertainty": 2}, "outside"),
        ):
            with pytest.raises(MotesError, match=words):
                read(path, **options)

    def test_angles_that_all_rows_share(self, tmp_path: Path) -> None:
        path = written(tmp_path, "theta_i_deg,brdf\n10,.1\n20,.2\n")
        data = measured(path, theta_r_deg=8, phi_r_deg=180)
        np.testing.assert_allclose(np.degrees(data.theta_r), 8)
        np.testing.assert_allclose(np.abs(data.dphi), np.pi)
        assert any("8 degrees for all rows" in note for note in data.provenance["notes"])

    def test_angles_without_units_in_degrees(self, tmp_path: Path) -> None:
        path = written(tmp_path, "theta_i,theta_r,phi_r,brdf\n10,20,90,.1\n")
        np.testing.assert_allclose(np.degrees(measured(path, angles="deg").theta_r), 20)

    def test_azimuths_from_the_mirror_side(self, tmp_path: Path) -> None:
        path = written(tmp_path, "theta_i_deg,theta_r_deg,phi_r_deg,brdf\n10,20,0,.1\n10,-20,0,.1\n")
        np.testing.assert_allclose(np.abs(measured(path).dphi), [0, np.pi], atol=1e-12)
        np.testing.assert_allclose(np.abs(measured(path, azimuth="mirror").dphi), [np.pi, 0], atol=1e-12)

    def test_wavelengths_in_micrometres(self, tmp_path: Path) -> None:
        path = written(tmp_path, HEADER + "0.45,0.63\n10,0,20,0,.1,.2\n")
        assert measured(path, wavelength_unit="um").wavelengths.tolist() == [450, 630]

    def test_uncertainties_from_outside(self, tmp_path: Path) -> None:
        path = written(tmp_path, HEADER + "brdf\n10,0,20,0,.1\n")
        data = measured(path, relative_uncertainty=0.05, common_uncertainty=0.02)
        np.testing.assert_allclose(data.uncertainties, 0.005)
        assert data.common_uncertainty == 0.02
        both = written(tmp_path, HEADER + "brdf,brdf_unc\n10,0,20,0,.1,.01\n", "both.csv")
        with pytest.raises(MotesError, match="brings uncertainties of its own"):
            read(both, relative_uncertainty=0.05)


class TestSpreadsheets:
    """What `motes.files.spreadsheet` gives, read as text tables are."""

    @staticmethod
    def saved(path: Path, rows: list[list[Any]], second: list[list[Any]] | None = None) -> Path:
        openpyxl = pytest.importorskip("openpyxl")
        book = openpyxl.Workbook()
        for row in rows:
            book.active.append(row)
        for row in second or ():
            (book["other"] if "other" in book.sheetnames else book.create_sheet("other")).append(row)
        book.save(path)
        return path

    def test_a_table(self, tmp_path: Path) -> None:
        rows = [
            ["Goniometer 3"],
            [],
            ["theta_i_deg", "theta_r_deg", "phi_r_deg", "hours", 450, 550],
            [10, 20, 0, 0, 0.1, 0.2],
            [10, 20, 0, 2, 0.3, None],
        ]
        data = measured(self.saved(tmp_path / "a.xlsx", rows))
        assert data.wavelengths.tolist() == [450, 550]
        np.testing.assert_array_equal(data.values, [[[0.1, 0.2]], [[0.3, np.nan]]])
        assert data.times.tolist() == [0, 2]

    def test_dates(self, tmp_path: Path) -> None:
        from datetime import datetime

        rows = [
            ["time", "theta_i_deg", "theta_r_deg", "phi_r_deg", "brdf"],
            [datetime(2024, 5, 1, 10), 10, 20, 0, 0.1],
            [datetime(2024, 5, 1, 16), 10, 20, 0, 0.2],
        ]
        assert measured(self.saved(tmp_path / "a.xlsx", rows)).times.tolist() == [0, 6]

    def test_a_sheet_is_chosen(self, tmp_path: Path) -> None:
        rows = [["theta_i_deg", "theta_r_deg", "phi_r_deg", "brdf"], [10, 20, 0, 0.1]]
        path = self.saved(tmp_path / "a.xlsx", [["nothing", "here"]], rows)
        with pytest.raises(FormatError, match="2 sheets"):
            read(path)
        assert measured(path, sheet="other").values.ravel().tolist() == [0.1]

    def test_formulas_are_refused(self, tmp_path: Path) -> None:
        rows = [["theta_i_deg", "theta_r_deg", "phi_r_deg", "brdf"], [10, 20, 0, "=1/10"]]
        with pytest.raises(FormatError, match="formula"):
            read(self.saved(tmp_path / "a.xlsx", rows))


def test_rows_of_numbers_without_names(tmp_path: Path) -> None:
    path = written(tmp_path, "10,0,20,0,.1\n20,0,20,0,.1\n30,0,20,0,.1\n")
    with pytest.raises(FormatError, match="no line names its columns"):
        read(path)


def test_a_long_table_with_times(tmp_path: Path) -> None:
    rng = np.random.default_rng(0)
    rows, expected = [], np.empty((3, 5, 4))
    for t in range(3):
        for d in range(5):
            for c, nm in enumerate((400, 500, 600, 700)):
                f = float(rng.uniform(0.1, 0.5))
                expected[t, d, c] = f
                rows.append(f"{10 * d},20,0,{t},{nm},{f!r},{0.01 * f!r}")
    rng.shuffle(rows)
    data = measured(
        written(
            tmp_path,
            "theta_i_deg,theta_r_deg,phi_r_deg,days,lambda [nm],brdf,u_c\n".replace("u_c", "brdf_err")
            + "\n".join(rows),
        )
    )
    order = np.argsort(data.theta_i)
    np.testing.assert_array_equal(data.values[:, order], expected)
    np.testing.assert_allclose(data.uncertainties[:, order], 0.01 * expected)
    assert data.times.tolist() == [0, 24, 48]


# ---------------------------------------------------------------- docs/data.md

PAGE = Path(__file__).parents[1] / "docs" / "data.md"
SHARED_ANGLES = {("phi_r",): {"phi_r_deg": 180.0}, ("phi_r", "theta_r"): {"theta_r_deg": 8.0, "phi_r_deg": 180.0}}


def test_the_tables_of_the_page_are_read(tmp_path: Path) -> None:
    blocks = [
        part.removeprefix("\n") for part in PAGE.read_text(encoding="utf-8").split("```")[1::2] if part[0] == "\n"
    ]
    tables = [b for b in blocks if not b.startswith("error")]
    assert len(tables) >= 6
    for text in tables:
        path = written(tmp_path, text)
        header = text.splitlines()[0]
        absent = tuple(sorted(name for name in ("theta_r", "phi_r") if name not in header))
        options = SHARED_ANGLES[absent] if absent else {}
        assert measured(path, **options).mask.all()


def test_the_error_of_the_page_is_printed_so(tmp_path: Path) -> None:
    block = re.search(
        r"^```\nerror: (scan\.csv: .*?)\nhint: (.*?)\n```", PAGE.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE
    )
    assert block
    path = written(tmp_path, "theta_i_deg,theta_r_deg,phi_r_deg,intensity\n10,20,0,.1\n", "scan.csv")
    with pytest.raises(FormatError) as caught:
        read(path)
    assert caught.value.message.replace(f"{tmp_path}/", "") == block[1]
    assert caught.value.hint == block[2]


def test_the_names_of_the_page_are_known() -> None:
    rows = re.search(r"\| role \|.*?\n\n", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert rows
    names = [n for line in rows[0].strip().splitlines()[2:] for n in re.findall(r"`([^`]+)`", line.split("|")[2])]
    assert len(names) > 70
    for name in names:
        assert column(name if name != "t" else "t (h)") is not None, name


def test_a_measurement_is_written_and_read_back(tmp_path: Path) -> None:
    rng = np.random.default_rng(4)
    wi, wo = (from_spherical(rng.uniform(0, 1.4, 7), rng.uniform(-3, 3, 7)) for _ in range(2))
    values = rng.uniform(0.1, 0.5, (3, 7, 2))
    values[1, 3, 0] = np.nan
    for channels, wavelengths in ((("clear coat", "base"), None), (None, [450.5, 630.0])):
        data = Measurement.from_arrays(
            wi,
            wo,
            values,
            times=[0, 1.5, 3],
            channels=channels,
            wavelengths=wavelengths,
            weights=rng.uniform(1, 2, 7),
            uncertainties=0.01 * np.nan_to_num(values, nan=1.0),
            common_uncertainty=0.02,
        )
        again = measured(write_table(data, tmp_path / "t.csv"), common_uncertainty=0.02)
        assert (again.channels, again.common_uncertainty) == (data.channels, 0.02)
        np.testing.assert_array_equal(again.times, data.times)
        np.testing.assert_array_equal(again.mask, data.mask)
        np.testing.assert_array_equal(again.values[again.mask], data.values[data.mask])
        np.testing.assert_allclose(again.uncertainties[again.mask], data.uncertainties[data.mask], rtol=1e-12)
        np.testing.assert_array_equal(again.weights, data.weights)
        for name in ("wi", "wo"):
            np.testing.assert_allclose(getattr(again, name), getattr(data, name), atol=1e-12)


@pytest.mark.parametrize("text", ["alpha,beta,f\n1,2,0.1\n3,4,0.2\n", "# alpha beta f\n 1 2 0.1\n 3 4 0.2\n"])
def test_a_table_whose_columns_name_no_direction_is_told_so(text: str, tmp_path: Path) -> None:
    with pytest.raises(FormatError, match="no column is a direction by its name; its columns are 'alpha', 'beta', 'f'"):
        read(written(tmp_path, text))


@pytest.mark.parametrize(
    "text", ["Dear all,\nhere are 3 numbers, 4 words, 5 signs.\n", '{"a": [1, 2, 3]}\n', "\x00\x01,\x02\n1,2\n"]
)
def test_what_is_no_table_is_not_called_one(text: str, tmp_path: Path) -> None:
    with pytest.raises(FormatError) as caught:
        read(written(tmp_path, text))
    assert "looks like a table" not in caught.value.message


def test_what_a_column_was_taken_for_names_the_unit_that_it_was_read_in(tmp_path: Path) -> None:
    """That of an option or of the cells, where the name has none: a page that says radians of degrees is believed."""
    path = tmp_path / "a.csv"
    path.write_text(
        "time,theta_i,theta_r,phi,wavelength,f_r,unc\n5 min,10,20,0,0.5,0.1,2 %\n10 min,10,20,0,0.5,0.1,3 %\n"
    )
    said = read(path, angles="deg", wavelength_unit="um").summary()["columns"]
    assert said[:2] == ["time: time [min]", "theta_i: theta_i [deg]"]
    assert "wavelength: wavelength of the row [um]" in said
    assert "unc: uncertainty, one standard deviation, in % of the value" in said
    path.write_text("theta_i,theta_r,phi,f_r\n10°,20°,0°,.1\n")
    assert read(path).summary()["columns"][0] == "theta_i: theta_i [deg]"
    path.write_text("theta_i,theta_r,phi,0.45,0.55\n1,1.1,0,.1,.2\n")
    assert read(path, wavelength_unit="um").summary()["columns"][-1] == "0.55: f_r [1/sr] at a wavelength [um]"
