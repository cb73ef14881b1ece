"""ASAM OpenMATERIAL look-up tables: hand-written ones, and the standard's two examples."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import format_files as files
from motes.errors import MotesError
from motes.measurements import read


def test_values_and_directions(tmp_path: Path):
    (tmp_path / "a.xompt").write_text(files.xompt_json())
    m = read(tmp_path / "a.xompt")
    assert m.wavelengths.tolist() == [450, 650]
    assert m.name == "brick"
    theta_i, theta_o = np.degrees(m.theta_i), np.degrees(m.theta_r)
    np.testing.assert_allclose(m.values[0, :, 0], 0.1 + 0.001 * theta_i + 0.0001 * theta_o, atol=1e-6)
    backscatter = (theta_i > 1) & (np.abs(m.dphi) < 1e-6)
    assert backscatter.sum() == 2
    turned = read(tmp_path / "a.xompt", reference="forward")
    np.testing.assert_allclose(turned.wo * [-1, -1, 1], m.wo, atol=1e-9)
    assert any("leaves it open" in note for note in m.provenance["notes"])
    assert not any("darker" in note or "cos" in note for note in m.provenance["notes"])


def test_null_is_masked(tmp_path: Path):
    rows = [[5.5e-7, 0.1, 0.2, 0.0, 0.3], [5.5e-7, 0.1, 0.3, 0.0, None], [6.5e-7, 0.1, 0.2, 0.0, 0.4]]
    (tmp_path / "a.xompt").write_text(files.xompt_json(rows))
    m = read(tmp_path / "a.xompt")
    assert dict(m.masked) == {"not measured at this wavelength": 1, "not a finite number": 1}


@pytest.mark.parametrize(
    ("row", "complaint"),
    [
        ([550, 0.1, 0.2, 0.0, 0.3], "550 m"),
        ([5.5e-7, 30, 0.2, 0.0, 0.3], "not angles"),
        ([5.5e-7, 0.1, 0.2, 0.3], r"row 1 of the lookupTable is \["),
        ([None, 0.1, 0.2, 0.0, 0.3], "wavelength"),
        (["a", 0.1, 0.2, 0.0, 0.3], "lookupTable is"),
    ],
)
def test_wrong_units_and_rows_are_refused(tmp_path: Path, row: list, complaint: str):
    import json

    document = json.loads(files.xompt_json())
    document["brdf"]["lookupTable"] = [row] * 3
    (tmp_path / "a.xompt").write_text(json.dumps(document))
    with pytest.raises(MotesError, match=complaint) as raised:
        read(tmp_path / "a.xompt")
    assert raised.value.hint


def test_the_examples_of_the_standard_are_doubted_and_not_mended(shared_file):
    camera = read(shared_file("openmaterial/example_material_camera_brdf.xompt"))
    lidar = read(shared_file("openmaterial/example_material_lidar_brdf.xompt"))
    assert (camera.n_directions, camera.n_channels, camera.wavelengths[0]) == (59, 32, pytest.approx(390))
    assert (camera.values.min(), camera.values.max()) == (1.4e-5, 2.6e-5)  # as in the file
    assert any("another unit" in note for note in camera.provenance["notes"])
    assert lidar.wavelengths.tolist() == [pytest.approx(905)]
    assert lidar.values.max() == 1.3255e-3
    assert any("another unit" in note for note in lidar.provenance["notes"])
    assert any("cos(theta_i)" in note for note in lidar.provenance["notes"])
