"""UTIA BRDF tables: the mean over rotations, the whole, pictures, and what is said of their scale."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import format_files as files
import measurement_files
from motes.errors import FormatError, MotesError
from motes.measurements import read


@pytest.fixture
def table(tmp_path: Path) -> Path:
    (tmp_path / "m001_x.bin").write_bytes(files.utia_bytes())
    return tmp_path / "m001_x.bin"


def isotropic_part(m) -> np.ndarray:
    across = np.sum((m.wi + m.wo)[:, :2] ** 2, axis=1)
    return 0.06 + 0.3 * np.exp(-6 * across)


def test_the_mean_over_rotations(table: Path):
    m = read(table)
    assert (m.n_directions, m.channels) == (1728, ("R", "G", "B"))
    np.testing.assert_allclose(m.values[0, :, 0], isotropic_part(m), rtol=1e-9)
    np.testing.assert_allclose(m.values[0, :, 2], 0.25 * isotropic_part(m), rtol=1e-9)
    assert 0.02 < m.provenance["anisotropy"] < 0.3
    assert any("not documented" in note for note in m.provenance["notes"])


def test_the_whole_table(table: Path):
    m = read(table, isotropic=False)
    assert m.n_directions == 6 * 48 * 6 * 48
    some = np.random.default_rng(1).integers(0, m.n_directions, 500)
    phi_i, theta_i = np.arctan2(m.wi[some, 1], m.wi[some, 0]), m.theta_i[some]
    oblique = theta_i > 0.1
    extra = 0.02 * np.cos(2 * phi_i) * np.sin(theta_i)
    np.testing.assert_allclose(m.values[0, some, 0][oblique], (isotropic_part(m)[some] + extra)[oblique], rtol=1e-9)


def test_encoding_and_scale(table: Path):
    m, decoded = read(table), read(table, isotropic=False, encoding="srgb", scale=2.0)
    raw = read(table, isotropic=False).values
    np.testing.assert_allclose(
        decoded.values, 2 * ((raw + 0.055) / 1.055) ** 2.4 * (raw > 0.04045) + 2 * raw / 12.92 * (raw <= 0.04045)
    )
    assert m.values.max() < 1


def test_pictures(tmp_path: Path):
    pytest.importorskip("OpenEXR")
    measurement_files.write_exr(tmp_path / "m001_x.exr", files.utia_table().reshape(288, 288, 3), np.float32)
    m = read(tmp_path / "m001_x.exr")
    assert m.provenance["format"] == "utia"
    np.testing.assert_allclose(m.values[0, :, 0], isotropic_part(m), rtol=1e-5)


def test_what_is_refused(table: Path, tmp_path: Path):
    (tmp_path / "b.bin").write_bytes(table.read_bytes()[:-8])
    with pytest.raises(FormatError, match="not 1,990,656"):
        read(tmp_path / "b.bin", format="utia")
    with pytest.raises(MotesError, match="encoding"):
        read(table, encoding="gamma")
    with pytest.raises(MotesError, match="scale"):
        read(table, scale=-1)
