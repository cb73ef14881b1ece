"""MERL and CSV tables, read back with motes.read."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest

import motes
from motes import Material
from motes.ageing import age
from motes.directions import from_half_difference, from_spherical
from motes.errors import DataError, ParameterError
from motes.exports import csv_table, export
from motes.exports.subject import subject
from motes.models import BRDF, Dust
from shader_support import MODELS, SPECTRAL

# ---------------------------------------------------------------- MERL


@pytest.fixture(scope="module")
def merl(tmp_path_factory: pytest.TempPathFactory) -> tuple[BRDF, Path]:
    model = MODELS["dusty"]
    path = tmp_path_factory.mktemp("merl") / "dusty.binary"
    assert export(model, "merl", path).files == (path,)
    return model, path


def test_merl_is_read_back(merl: tuple[BRDF, Path]) -> None:
    model, path = merl
    data = motes.read(path)
    assert data.provenance["format"] == "merl"
    assert data.values.shape[1:] == (len(data.wi), 3)
    assert len(data.wi) > 1_000_000
    assert data.mask.all()
    some = slice(None, None, 97)
    np.testing.assert_allclose(data.values[0][some], model.eval(data.wi[some], data.wo[some]), rtol=1e-12)


def test_merl_bins_are_where_every_reader_looks(merl: tuple[BRDF, Path]) -> None:
    """Index, scale and the square-root bins as in the database's own reader (BRDFRead.cpp), written out here."""
    model, path = merl
    raw = path.read_bytes()
    assert struct.unpack_from("<3i", raw) == (90, 90, 180)
    assert len(raw) == 12 + 3 * 8 * 90 * 90 * 180
    for i, j, k in ((0, 0, 0), (3, 40, 17), (20, 60, 90), (45, 10, 179)):
        theta_h = np.pi / 2 * ((i + 0.5) / 90) ** 2  # inverse of index = int(90 sqrt(theta_h / (pi/2)))
        wi, wo = from_half_difference(theta_h, (j + 0.5) / 90 * np.pi / 2, (k + 0.5) / 180 * np.pi)
        index = k + 180 * (j + 90 * i)
        stored = [struct.unpack_from("<d", raw, 12 + 8 * (index + plane * 90 * 90 * 180))[0] for plane in range(3)]
        rgb = np.array(stored) * (1.0 / 1500, 1.15 / 1500, 1.66 / 1500)
        np.testing.assert_allclose(rgb, model.eval(wi, wo), rtol=1e-11)


def test_merl_of_a_spectrum(tmp_path: Path) -> None:
    """White stays white, and what is no spectrum of the visible is refused."""
    wavelengths = tuple(np.linspace(400, 700, 31).tolist())
    white = Material(
        motes.Lambert(np.full(31, 0.5)), name="white", channels=tuple(map(str, wavelengths)), wavelengths=wavelengths
    )
    done = export(white, "merl", tmp_path / "white.binary")
    assert any("linear sRGB" in note for note in done.notes)
    values = motes.read(done.files[0]).values[0][::5000]
    np.testing.assert_allclose(values, 0.5 / np.pi, rtol=2e-4)
    with pytest.raises(DataError, match="not a spectrum of the visible"):
        export(SPECTRAL, "merl", tmp_path / "x.binary")
    assert not (tmp_path / "x.binary").exists()


# ---------------------------------------------------------------- CSV


@pytest.mark.parametrize("name", ["dusty", "grey", "spectral"])
def test_csv_is_read_back(name: str, tmp_path: Path) -> None:
    model = (MODELS | {"spectral": SPECTRAL})[name]
    data = motes.read(export(model, "csv", tmp_path / "table.csv").files[0])
    assert data.values.shape == (1, len(csv_table.grid()), model.channels)
    assert data.mask.all()
    np.testing.assert_allclose(data.values[0], model.eval(data.wi, data.wo), rtol=1e-12)


def test_no_row_is_there_twice() -> None:
    """At normal incidence all azimuths are one direction."""
    theta_i, theta_r, phi = np.deg2rad(csv_table.grid()).T
    wi, wo = from_spherical(theta_i, 0 * phi), from_spherical(theta_r, phi)
    pairs = np.column_stack([wi[:, 2], wo[:, 2], np.sum(wi * wo, axis=1)]).round(9)
    assert len(np.unique(pairs, axis=0)) == len(pairs)


def test_csv_over_time(tmp_path: Path) -> None:
    drying = age(
        motes.Material(MODELS["plaster_and_coat"], name="paint", channels=("R", "G", "B")), "drying_paint", hours=6
    )
    data = motes.read(export(drying, "csv", tmp_path / "eleven.csv").files[0])
    np.testing.assert_allclose(data.times, np.linspace(0, 6, 11))
    np.testing.assert_allclose(data.values, drying.at(data.times).eval(data.wi, data.wo), rtol=1e-12)
    data = motes.read(export(drying, "csv", tmp_path / "two.csv", hours=[0.5, 2]).files[0])
    assert data.times.tolist() == [0.5, 2]
    with pytest.raises(ParameterError, match="do not increase"):
        export(drying, "csv", tmp_path / "x.csv", hours=[2, 0.5])


NUMBERED = ["channel 1", "channel 2", "channel 3"]


@pytest.mark.parametrize(
    ("channels", "expected", "read"),
    [
        (("R", "G", "B"), ["R", "G", "B"], ["R", "G", "B"]),
        (("red, a", 'g"', "b#"), ["brdf[red a]", "brdf[g]", "brdf[b]"], ["red a", "g", "b"]),
        (("theta_i", "x", "y"), ["brdf[theta_i]", "brdf[x]", "brdf[y]"], ["theta_i", "x", "y"]),
        (("a", "a", "b"), NUMBERED, NUMBERED),
        (("", "a", "b"), NUMBERED, NUMBERED),
        (("weight", "a", "b"), ["brdf[weight]", "brdf[a]", "brdf[b]"], ["weight", "a", "b"]),
    ],
)
def test_names_of_columns(channels: tuple[str, ...], expected: list[str], read: list[str], tmp_path: Path) -> None:
    material = Material(MODELS["lambert"], name="a\nb,c", channels=channels)
    assert csv_table.headings(subject(material)) == expected
    data = motes.read(export(material, "csv", tmp_path / "table.csv").files[0])
    assert list(data.channels) == read


def test_a_fit_finds_the_material_in_its_table(tmp_path: Path) -> None:
    model = MODELS["oren_nayar"]
    data = motes.read(export(model, "csv", tmp_path / "table.csv").files[0])
    found = motes.fit(data, model="oren_nayar").material.brdf.parameters
    np.testing.assert_allclose(found["K_d"], (0.8, 0.7, 0.6), rtol=1e-5)
    np.testing.assert_allclose(found["sigma_d"], 0.4, rtol=1e-5)


def test_dust_as_brightness_is_said(tmp_path: Path) -> None:
    bright = Dust((0.7, 0.6, 0.5), 0.3, form="brightness")
    assert any("not" in note and "reciprocal" in note for note in export(bright, "merl", tmp_path / "x.binary").notes)


def test_unwritable(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(motes.errors.MotesError, match="cannot be written"):
        export(MODELS["lambert"], "csv", tmp_path / "file" / "x.csv")
    assert [p.name for p in tmp_path.iterdir()] == ["file"]
