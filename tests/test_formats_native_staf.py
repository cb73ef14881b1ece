"""STAF folders in their authors' layout: real times, stored 1/sigma^2, the fitted course."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import format_files as files
import measurement_files
from motes.errors import FormatError, ParameterError
from motes.measurements import TabulatedMaps, read

pytest.importorskip("OpenEXR")


def write_exr(path: Path, pixels: np.ndarray) -> None:
    measurement_files.write_exr(path, pixels, np.float32)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return files.native_staf_folder(tmp_path / "tvBTF45", write_exr)


def test_measured_maps_at_real_times(folder: Path):
    maps = read(folder)
    assert isinstance(maps, TabulatedMaps)
    assert (maps.hours.tolist(), maps.time_unit, maps.shape) == ([0, 2, 4], "h", (4, 5))
    assert "cast iron" in maps.name
    first, between = maps.at(0), maps.at(1.0)
    np.testing.assert_allclose(first["K_d"][2, 3], [0.3, 0.15, 0.075], rtol=1e-6)
    np.testing.assert_allclose(first["sigma_s"], 0.2, rtol=1e-6)
    np.testing.assert_allclose(first["K_s"], 2, rtol=1e-6)
    np.testing.assert_allclose(between["sigma_s"], 0.25, rtol=1e-6)
    np.testing.assert_allclose(maps.at(4.0)["K_d"][0, 0, 0], 0.5, rtol=1e-6)
    summary = maps.summary()
    assert summary["kind"] == "parameter maps"
    np.testing.assert_allclose(summary["mean"]["sigma_s"], [0.2, 0.3, 0.4], rtol=1e-6)
    with pytest.raises(ParameterError, match="outside"):
        maps.at(5)


def test_red_and_blue_can_be_swapped(folder: Path):
    np.testing.assert_allclose(read(folder, bgr=True).at(0)["K_d"][0, 0], [0.075, 0.15, 0.3], rtol=1e-6)


def test_the_fitted_course(folder: Path):
    maps = read(folder, which="fitted")
    # p = 0.1 phi((t - 0.5)/2) + 1 with phi(x) = 2 x + 1, t = 0, 1/2, 1
    for k, t in enumerate((0.0, 0.5, 1.0)):
        p = 0.1 * (2 * (t - 0.5) / 2 + 1) + 1
        at = maps.at(float(maps.hours[k]))
        np.testing.assert_allclose(at["K_d"], p, rtol=1e-6)
        np.testing.assert_allclose(at["sigma_s"], p**-0.5, rtol=1e-6)
    assert any("from the highest power" in note for note in maps.provenance["notes"])


def test_times_that_do_not_fit_are_said(folder: Path):
    (folder / "tvBTF45-time.txt").write_text("0:0:0:0\n")
    maps = read(folder)
    assert (maps.time_unit, maps.hours.tolist()) == ("scan", [0, 1, 2])
    assert any("1 times for 3 maps" in note for note in maps.provenance["notes"])


def test_what_is_refused(folder: Path):
    (folder / "TSparamNew" / "tvBTF45-02-00-TSparam-Ks.exr").unlink()
    with pytest.raises(FormatError, match="no Ks of time 02"):
        read(folder)
    (folder / "SIM" / "tvBTF45-staf-Ks-phi.txt").write_text("pphi_Ks: 1 2 3\n")
    with pytest.raises(FormatError, match="3 coefficients"):
        read(folder, which="fitted")
    write_exr(folder / "TSparamNew" / "tvBTF45-02-00-TSparam-Ks.exr", np.ones((3, 3, 3)))
    with pytest.raises(FormatError, match="one size"):
        read(folder).at(2)
    (folder / "tvBTF45-time.txt").write_text("1:0:0:0\n0:0:0:0\n")
    assert read(folder).time_unit == "scan"
