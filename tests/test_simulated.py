"""Simulated data say that they are simulated, in every file and on every page that comes of them."""

from __future__ import annotations

import csv
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import motes
from motes.ageing import Rig, age, drying_plaster, simulate
from motes.exports import TARGETS, export
from motes.measurements.origin import not_measured

SAYS = "simulated by Motes"
#: Formats of numbers alone: nothing can be said in them.
SILENT = {"merl"}


@pytest.fixture(scope="module")
def fit(tmp_path_factory: pytest.TempPathFactory) -> Any:
    folder = tmp_path_factory.mktemp("simulated") / "scans"
    data = motes.read(simulate(folder, drying_plaster, scans=4, seed=1, rig=Rig(step_deg=6), name="plaster"))
    return motes.fit(data, model="oren_nayar + torrance_sparrow")


@pytest.mark.parametrize("alone", [False, True])
def test_results_and_their_report(fit: Any, tmp_path: Path, alone: bool) -> None:
    result = motes.fit(fit.measurement.at(0), model="lambert") if alone else fit
    result.save(tmp_path)
    page = result.report(tmp_path / "report.html").read_text("utf-8")
    head = page.split("<header", 1)[1].split("</header>", 1)[0]
    assert f"The data are not measured: {SAYS}" in head
    with (tmp_path / "parameters.csv").open(newline="") as handle:
        assert all(row["source"].startswith(SAYS) for row in csv.DictReader(handle))
    assert json.loads((tmp_path / "fit.json").read_text())["measurement"]["source"].startswith(SAYS)
    assert json.loads((tmp_path / "material.json").read_text())["about"]["data"]["source"].startswith(SAYS)


def test_a_page_of_the_viewer(fit: Any, tmp_path: Path) -> None:
    fit.save(tmp_path)
    for what in (fit, motes.load(tmp_path / "material.json"), fit.measurement.at(0)):
        shown = motes.view(what, model="lambert").payload
        assert f"The data are not measured: {SAYS}" in shown["notes"][0]
        assert shown["materials"][0]["json"]["about"]["data"]["simulated"] is True  # type: ignore[typeddict-item]
        assert "path" not in shown["materials"][0]["json"]["about"]["data"]  # type: ignore[typeddict-item]


@pytest.mark.parametrize("to", [name for name in TARGETS if name not in SILENT])
def test_exports(fit: Any, to: str, tmp_path: Path) -> None:
    nanometres = (610.0, 550.0, 465.0)
    material, data = fit.material, fit.measurement
    if to == "openmaterial":  # which has spectra, and one time
        material = replace(material, wavelengths=nanometres)
        data = replace(data.at(1), wavelengths=np.array(nanometres))
    written = [export(material, to, tmp_path / "material"), export(material, to, tmp_path / "later", hours=1.0)]
    if TARGETS[to].measured:
        written.append(export(data, to, tmp_path / "data"))
    for each in written:
        assert SAYS.encode() in each.files[0].read_bytes()


def test_a_map(tmp_path: Path) -> None:
    pytest.importorskip("zarr")
    from motes.maps import fit_map, simulate_map

    simulate_map(tmp_path / "map.zarr", (6, 5), times=1)
    fit_map(tmp_path / "map.zarr", out=tmp_path / "fitted.zarr", model="lambert")
    from motes.maps.fitted import open_fitted

    fitted = open_fitted(tmp_path / "fitted.zarr")
    assert fitted.summary()["origin"] == SAYS
    assert f"The data are not measured: {SAYS}." in fitted.report(tmp_path / "map.html").read_text("utf-8")
    assert not_measured(fitted.material(0, 0).about["data"])


def test_ageing_keeps_it(fit: Any) -> None:
    assert not_measured(age(fit.material, "dust", hours=10).about["data"])


@pytest.mark.parametrize(
    "about", [None, {}, {"source": "CUReT"}, {"source": "not simulated"}, {"simulated": False}, "x"]
)
def test_measured_data_are_not_called_simulated(about: Any) -> None:
    assert not_measured(about) == ""
