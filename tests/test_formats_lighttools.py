"""LightTools BSDF text, as far as its reader in another program tells its layout."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import format_files as files
from motes.errors import MotesError
from motes.measurements import read


def test_values_and_sides(tmp_path: Path):
    (tmp_path / "a.bsdf").write_text(files.lighttools_text())
    m = read(tmp_path / "a.bsdf")
    assert (m.n_directions, m.wavelengths.tolist(), m.provenance["format"]) == (18, [550], "lighttools")
    np.testing.assert_allclose(m.wi[-1], files.vector(50, 90), atol=1e-12)
    expected = [files.lobed(i, o) for i, o in zip(m.wi, m.wo, strict=True)]
    np.testing.assert_allclose(m.values.ravel(), expected, rtol=1e-6)
    assert any("second hand" in note for note in m.provenance["notes"])
    assert read(tmp_path / "a.bsdf", side="back").n_directions == 9


@pytest.mark.parametrize(
    ("old", "new", "complaint"),
    [
        ("AOI 50", "AOI 150", "AOI 150"),
        ("Wavelength 550", "Wavelength 0.55", "wavelength 0.55"),
        ("ScatterAzimuth 4", "Azimuth 4", "before its angles"),
        ("Side Front", "Side Back", "no BRDF of the front"),
    ],
)
def test_what_is_refused(tmp_path: Path, old: str, new: str, complaint: str):
    (tmp_path / "a.bsdf").write_text(files.lighttools_text().replace(old, new))
    with pytest.raises(MotesError, match=complaint) as raised:
        read(tmp_path / "a.bsdf", format="lighttools")
    assert raised.value.hint


def test_a_truncated_file(tmp_path: Path):
    (tmp_path / "a.bsdf").write_text(files.lighttools_text()[:-40])
    with pytest.raises(MotesError, match="truncated"):
        read(tmp_path / "a.bsdf")
