"""pab-opto goniophotometer files: hand-written ones, and what Radiance's pabopto2bsdf makes of the same."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import format_files as files
import radiance_support as radiance
from motes.errors import MotesError
from motes.measurements import read


@pytest.mark.parametrize("dsf", [False, True])
@pytest.mark.parametrize("up", [90.0, 30.0, None])
def test_values_and_directions(tmp_path: Path, dsf: bool, up: float | None):
    (tmp_path / "a.txt").write_text(files.pab_text(35, 20, dsf=dsf, up=up))
    m = read(tmp_path / "a.txt")
    assert (m.channels, m.name, m.n_directions) == (("Y",), "glass bead", 6 * 24)
    expected = [files.lobed(i, o) for i, o in zip(m.wi, m.wo, strict=True)]
    np.testing.assert_allclose(m.values.ravel(), expected, rtol=1e-4)
    turn = 0 if up == 90 else (60 if up == 30 else 90)
    np.testing.assert_allclose(m.wi[0], files.vector(35, 20 + turn), atol=1e-9)


def test_a_folder_is_one_measurement(tmp_path: Path):
    for k, theta in enumerate((0, 30, 60)):
        (tmp_path / f"scan{k}.txt").write_text(files.pab_text(theta, 0))
    (tmp_path / "notes.txt").write_text("not a scan\n")
    m = read(tmp_path)
    assert (m.provenance["files"], m.n_directions) == (3, 3 * 144)
    assert sorted(set(np.degrees(m.theta_i).round(6))) == [0, 30, 60]


def test_light_from_behind_is_seen_from_there(tmp_path: Path):
    behind = files.pab_text(35, 20)
    rows = [
        line if line.startswith("#") else f"{180 - float(line.split()[0]):g} " + " ".join(line.split()[1:])
        for line in behind.splitlines()
    ]
    (tmp_path / "a.txt").write_text("\n".join(rows).replace("#intheta 35", "#intheta 145") + "\n")
    m = read(tmp_path / "a.txt")
    assert np.all(m.wi[:, 2] > 0)
    assert m.mask.all()
    (tmp_path / "b.txt").write_text(behind.replace("#intheta 35", "#intheta 145"))
    with pytest.raises(MotesError, match="transmission only"):
        read(tmp_path / "b.txt")


def test_radiance_makes_the_same_of_them(tmp_path: Path):
    """Radiance fits Gaussian lobes to the samples and fills patches from them, so the two agree as far as that goes."""
    names = []
    for k, theta in enumerate((0, 20, 40, 60, 75)):
        (tmp_path / f"scan{k}.txt").write_text(
            files.pab_text(theta, 180, lambda i, o: 0.1 + 0.3 * np.exp(-6 * np.sum((i + o)[:2] ** 2)), step=5)
        )
        names.append(f"scan{k}.txt")
    m = read(tmp_path)
    (tmp_path / "a.sir").write_bytes(radiance.program("pabopto2bsdf", "-n", "1", *names, cwd=tmp_path))
    (tmp_path / "a.xml").write_bytes(radiance.program("bsdf2klems", "-n", "64", "-p", "a.sir", cwd=tmp_path))
    some = np.flatnonzero((m.theta_i < 1.1) & (m.theta_r < 1.1))
    some = some[np.random.default_rng(1).integers(0, len(some), 400)]
    theirs = radiance.query(tmp_path / "a.xml", m.wi[some], m.wo[some])[:, 1]
    error = np.abs(theirs / m.values[0, some, 0] - 1)
    assert np.median(error) < 0.1  # a Klems patch is 10 degrees wide, and is asked at the samples within it
    # with the azimuths the wrong way round they would not agree
    turned = radiance.query(tmp_path / "a.xml", m.wi[some], m.wo[some] * [-1, -1, 1])[:, 1]
    assert np.median(np.abs(turned / m.values[0, some, 0] - 1)) > 2 * np.median(error)


@pytest.mark.parametrize(
    ("old", "new", "complaint"),
    [
        ("theta phi BSDF", "theta phi watts", "WATTS"),
        ("#intheta 35", "#intheta 235", "incident angle"),
        ("CIE-Y", "RGB", "colorimetry"),
        ("7.500\t0.000\t", "7.500\t", "no rows"),
        ("7.500\t0.000\t", "7.500\tx\t", "not a number"),
    ],
)
def test_what_is_refused(tmp_path: Path, old: str, new: str, complaint: str):
    text = files.pab_text(35, 20)
    assert old in text
    (tmp_path / "a.txt").write_text(text.replace(old, new, 1))
    with pytest.raises(MotesError, match=complaint) as raised:
        read(tmp_path / "a.txt", format="pab-opto")
    assert raised.value.hint


def test_what_is_too_large_is_masked_without_a_warning(tmp_path: Path):
    text = files.pab_text(35, 20, dsf=True).splitlines()
    text[-1] = "89.9\t0\t1e308"
    (tmp_path / "a.txt").write_text("\n".join(text) + "\n")
    m = read(tmp_path / "a.txt")
    assert dict(m.masked) == {"not a finite number": 1}
