"""What results say of themselves: how they were made, numbers for tables, and how they look in a prompt and in a notebook."""

from __future__ import annotations

import hashlib
import json
import re
import sys
from datetime import UTC, datetime, timedelta
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest

import motes
from fitting_oracle import scattered
from motes.cli.main import main
from motes.errors import MissingExtraError
from motes.measurements import Measurement
from motes.measurements.table_writing import write_table

MODEL = "oren_nayar"
SURFACE = motes.OrenNayar(K_d=(0.6, 0.4, 0.25), sigma_d=0.4)


def measured(times: int = 1, name: str = "rock", seed: int = 0) -> Measurement:
    wi, wo = scattered(60, seed=8)
    clean = SURFACE.eval(wi, wo)
    values = np.stack(
        [clean * (1 + 0.02 * np.random.default_rng(seed + k).standard_normal(clean.shape)) for k in range(times)]
    )
    hours = np.arange(float(times))
    return Measurement.from_arrays(wi, wo, values, times=hours, time_unit="h", provenance={"name": name})


def test_a_fit_says_how_it_was_made() -> None:
    data = measured()
    fit = motes.fit(data, MODEL, fixed={"sigma_d": 0.4}, max_theta=1.4, weights=np.ones(60))
    origin = fit.to_dict()["origin"]
    assert abs(datetime.fromisoformat(origin["date"]) - datetime.now(UTC)) < timedelta(minutes=2)
    assert origin["motes"] == motes.__version__
    assert origin["command"] is None
    assert origin["sha256_of_file"] is None
    options = origin["options"]
    assert (options["model"], options["fixed"], options["max_theta"]) == (MODEL, {"sigma_d": 0.4}, 1.4)
    again = motes.fit(data, **options)
    assert again.to_dict()["origin"]["sha256_of_arrays"] == origin["sha256_of_arrays"]
    assert (again.parameters["K_d"].value == fit.parameters["K_d"].value).all()
    total = hashlib.sha256()
    for array in (data.wi, data.wo, data.times, data.values, data.weights):
        total.update(array.astype("<f8").tobytes())
    assert origin["sha256_of_arrays"] == total.hexdigest()
    other = motes.fit(measured(seed=5), SURFACE, weights=np.full((60, 3), 2.0)).to_dict()["origin"]
    assert other["sha256_of_arrays"] != origin["sha256_of_arrays"]
    assert other["options"]["weights"] == "an array of shape (60, 3)"
    assert other["options"]["model"] == {"model": MODEL, "starts": {"K_d": [0.6, 0.4, 0.25], "sigma_d": 0.4}}


def test_the_command_and_the_file_are_in_fit_json(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "my rock.csv"
    write_table(measured(), path)
    assert main(["fit", str(path), "-m", MODEL, "-o", str(tmp_path / "out"), "--no-report"]) == 0
    saved = json.loads((tmp_path / "out" / "fit.json").read_text())
    assert saved["origin"]["command"].startswith(f"motes fit '{path}' -m oren_nayar")
    assert saved["origin"]["sha256_of_file"] == hashlib.sha256(path.read_bytes()).hexdigest()
    assert np.shape(saved["covariance"]) == (4, 4)
    assert saved["errors"]["kind"] == "blocks"
    assert np.shape(saved["parameters"]["K_d"]["intervals"]["95"]) == (3, 2)
    assert "over 15 blocks of directions" in capsys.readouterr().out


@pytest.mark.parametrize("times", [1, 3])
def test_records_are_numbers(times: int) -> None:
    fit = motes.fit(measured(times), MODEL)
    rows = fit.records()
    assert len(rows) == 4 * times
    assert {row["parameter"] for row in rows} == {"K_d", "sigma_d"}
    assert all(isinstance(row[name], float) for row in rows for name in ("value", "stderr"))
    if times == 1:
        assert [row["channel"] for row in rows] == [*fit.material.channels, ""]
        p = fit.parameters["K_d"]
        assert [rows[1][f"{side}_95"] for side in ("low", "high")] == p.intervals["95"][1].tolist()
    pandas = pytest.importorskip("pandas")
    frame = fit.to_dataframe()
    assert isinstance(frame, pandas.DataFrame)
    assert frame["value"].dtype == float
    assert frame.to_dict("records") == rows


def test_without_pandas_it_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(MissingExtraError, match="needs the package pandas"):
        motes.fit(measured(), MODEL).to_dataframe()


@pytest.mark.parametrize("times", [1, 3])
def test_a_result_is_short_in_a_prompt(times: int) -> None:
    fit = motes.fit(measured(times), MODEL)
    text = repr(fit)
    assert len(text) < 200
    assert re.fullmatch(r"<(Time)?Fit of oren_nayar to 'rock': relative RMS [\d.]+ %>", text)
    if times > 1:
        assert len(repr(fit.trends)) < 400


class _Tags(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.seen: set[str] = set()
        self.text = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.open.append(tag)
        self.seen.add(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text += data


@pytest.mark.parametrize("times", [1, 3])
def test_a_notebook_shows_a_table_and_no_markup_of_files(times: int) -> None:
    fit = motes.fit(measured(times, name="<script>alert(1)</script>"), MODEL)
    page = _Tags()
    page.feed(fit._repr_html_())
    assert page.open == []
    assert "script" not in page.seen
    assert {"table", "td", "li"} <= page.seen
    assert "<script>alert(1)</script>" in page.text
    assert "over independent samples" in page.text or "blocks" in page.text
    for row in fit.table():
        assert (row["value"] if times == 1 else row["first"]) in page.text
