"""Zemax tabular BSDF: directions about the mirror direction, quantities, what was not measured."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import format_files as files
from motes.errors import MotesError
from motes.measurements import read
from motes.measurements.zemax import UNMEASURED, about_mirror


def test_directions_about_the_mirror_direction():
    for theta in (0.0, 15.0, 70.0):
        for radial in (0.0, 30.0, 85.0):
            for azimuth in (0.0, 50.0, 180.0, 300.0):
                ours = about_mirror(*np.radians([theta, 0.0, radial, azimuth]))
                np.testing.assert_allclose(ours, files.about_mirror(theta, radial, azimuth), atol=1e-12)
    # azimuth 0 lies towards the normal: at the radial angle theta it is the normal, at twice that the light
    np.testing.assert_allclose(about_mirror(*np.radians([40.0, 0, 40, 0])), [0, 0, 1], atol=1e-12)
    np.testing.assert_allclose(about_mirror(*np.radians([40.0, 0, 80, 0])), files.vector(40, 0), atol=1e-12)
    turned = about_mirror(*np.radians([40.0, 90, 80, 0]))
    np.testing.assert_allclose(turned, files.vector(40, 90), atol=1e-12)


def test_values(tmp_path: Path):
    (tmp_path / "a.bsdf").write_text(files.zemax_text())
    m = read(tmp_path / "a.bsdf")
    assert (m.n_directions, m.channels, m.provenance["total_integrated_scatter"]) == (26, ("grey",), [0.3, 0.3])
    usable = m.mask[0, :, 0]
    expected = np.array([files.lobed(i, o) for i, o in zip(m.wi, m.wo, strict=True)])
    np.testing.assert_allclose(m.values[0, usable, 0], expected[usable], rtol=1e-5)
    assert np.all(m.wo[usable, 2] > 0)
    assert m.masked[UNMEASURED] == 26 - usable.sum() > 0
    assert len(np.unique(np.round(np.concatenate([m.wi, m.wo], axis=1), 9), axis=0)) == 26  # no direction twice


def test_tristimulus(tmp_path: Path):
    (tmp_path / "a.bsdf").write_text(files.zemax_text(names=("TristimulusX", "TristimulusY", "TristimulusZ")))
    m = read(tmp_path / "a.bsdf")
    assert m.channels == ("X", "Y", "Z")
    usable = m.mask[0, :, 0]
    np.testing.assert_allclose(m.values[0, usable, 2] / m.values[0, usable, 0], 3, rtol=1e-4)


@pytest.mark.parametrize(
    ("old", "new", "complaint"),
    [
        ("ScatterType\tBRDF", "ScatterType\tBTDF", "BTDF"),
        ("ScatterRadial 4", "ScatterRadial 400000000", "no count"),
        ("ScatterRadial 4", "ScatterRadial 99999", "needs 99999 numbers|'Monochrome'|not a number"),
        ("0\t5\t20\t60", "0\t5\t5\t60", "do not increase"),
        ("PlaneSymmetrical", "Sideways", "Sideways"),
        ("TIS 0.3", "TAS 0.3", "does not start with TIS"),
        ("DataBegin", "DataEnd", "no DataBegin"),
    ],
)
def test_what_is_refused(tmp_path: Path, old: str, new: str, complaint: str):
    text = files.zemax_text()
    assert old in text
    (tmp_path / "a.bsdf").write_text(text.replace(old, new))
    with pytest.raises(MotesError, match=complaint) as raised:
        read(tmp_path / "a.bsdf", format="zemax")
    assert raised.value.hint


def test_a_truncated_file(tmp_path: Path):
    (tmp_path / "a.bsdf").write_text(files.zemax_text()[:-120])
    with pytest.raises(MotesError, match="truncated"):
        read(tmp_path / "a.bsdf")
