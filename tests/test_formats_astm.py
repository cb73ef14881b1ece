"""ASTM E1392/E2387 text: units of angles, azimuths, uncertainties, cosine-corrected columns."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import format_files as files
from motes.errors import MotesError
from motes.measurements import read


@pytest.mark.parametrize("degrees", [False, True])
def test_values_and_units_of_angles(tmp_path: Path, degrees: bool):
    (tmp_path / "a.astm").write_text(files.astm_text(degrees))
    m = read(tmp_path / "a.astm")
    assert (m.wavelengths.tolist(), m.name, m.n_directions) == ([465, 630], "a paint", 12)
    np.testing.assert_allclose(m.values[0, :, 0], 0.1 + 0.01 * np.arange(12))
    np.testing.assert_allclose(m.wi[0], files.vector(10, 0), atol=1e-6)
    np.testing.assert_allclose(m.wo[4], files.vector(45, 100), atol=1e-6)
    unit = "degrees" if degrees else "radians"
    assert any(f"taken as {unit}" in note for note in m.provenance["notes"])


def test_without_an_azimuth_of_the_light_the_mirror_side_is_zero(tmp_path: Path):
    (tmp_path / "a.astm").write_text(files.astm_text(phi_i=None))
    m = read(tmp_path / "a.astm")
    np.testing.assert_allclose(m.wi[0], files.vector(10, 180), atol=1e-6)
    assert any("180 degrees" in note for note in m.provenance["notes"])


def table(names: str, *rows: str) -> str:
    return f"VARS {names}\n\n" + "\n".join(rows) + "\n"


def test_signed_angles_uncertainties_and_the_cosine(tmp_path: Path):
    (tmp_path / "a.astm").write_text(
        "WAVELENGTH 632.8 nm\n" + table("theta_i theta_s phi_s ccBRDF sigma", "10 -60 0 0.2 0.01", "10 60 0 0.3 0.02")
    )
    m = read(tmp_path / "a.astm")
    np.testing.assert_allclose(m.wo[0], files.vector(60, 180), atol=1e-12)
    np.testing.assert_allclose(m.values.ravel(), [0.4, 0.6])
    np.testing.assert_allclose(m.uncertainties.ravel(), [0.02, 0.04])
    assert m.wavelengths.tolist() == [632.8]
    assert any("divided by the cosine" in note for note in m.provenance["notes"])


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        (table("theta_i,phi_i,theta_s,phi_s,f", "1,0,3,0,.1"), "may be degrees or radians"),
        (table("theta_i,phi_i,theta_s,phi_s,f", "10,0,1000,0,.1"), "an angle of 1000"),
        (table("theta_i,phi_i,phi_s,f", "10,0,20,.1"), "no theta_s"),
        (table("theta_i,phi_i,theta_s,phi_s", "10,0,20,0"), "no column of values"),
        (table("theta_i,phi_i,theta_s,phi_s,log_f", "10,0,20,0,-3"), "logarithms"),
        (table("theta_i,phi_i,theta_s,phi_s,f,u_g,g2", "10,0,20,0,1,1,1"), "no column"),
        (table("theta_i,phi_i,theta_s,phi_s,f", "10,0,20,0"), "no multiple"),
        (files.astm_text(n=99), "NUM_POINTS says 99"),
        (files.astm_text()[:-60], "no multiple|NUM_POINTS"),
    ],
)
def test_contradictions_are_refused(tmp_path: Path, text: str, complaint: str):
    (tmp_path / "a.astm").write_text(text)
    with pytest.raises(MotesError, match=complaint) as raised:
        read(tmp_path / "a.astm")
    assert raised.value.hint


def test_the_unit_can_be_given(tmp_path: Path):
    (tmp_path / "a.astm").write_text(table("theta_i,phi_i,theta_s,phi_s,f", "1,0,3,0,.1"))
    m = read(tmp_path / "a.astm", angles="degrees")
    assert m.theta_r[0] == pytest.approx(math.radians(3))
