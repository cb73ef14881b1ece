"""BSDF files of WINDOW and Radiance: hand-written ones, ones by Radiance's programs, ones of ours read by Radiance."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import format_files as files
import motes
import radiance_support as radiance
from motes.errors import FormatError, MotesError
from motes.measurements import read
from motes.measurements._angle_basis import KLEMS
from motes.measurements.measurement import Measurement

FUNCTION = "f(ix,iy,iz,ox,oy,oz) : 0.2/PI + 0.3*exp(-6*((ix+ox)*(ix+ox)+(iy+oy)*(iy+oy))) + 0.02*ix*ox + 0.01*iy*oy;\n"


def of_lobed(m: Measurement) -> np.ndarray:
    return np.array([files.lobed(i, o) for i, o in zip(m.wi, m.wo, strict=True)])


@pytest.mark.parametrize("structure", ["Columns", "Rows"])
def test_a_matrix_is_read_at_its_directions(tmp_path: Path, structure: str):
    (tmp_path / "a.xml").write_text(files.klems_xml(structure=structure))
    m = read(tmp_path / "a.xml")
    assert (m.n_directions, m.channels, m.name) == (41 * 41, ("visible",), "a blind")
    np.testing.assert_allclose(m.values[0, :, 0], of_lobed(m), rtol=1e-6)
    assert m.weights.sum() == pytest.approx((2 * np.pi) ** 2, rel=1e-12)


def test_colours_and_wavelengths(tmp_path: Path):
    (tmp_path / "a.xml").write_text(files.klems_xml(names=("CIE-X", "Visible", "CIE-Z")))
    m = read(tmp_path / "a.xml")
    assert m.channels == ("X", "Y", "Z")
    np.testing.assert_allclose(m.values[0] / of_lobed(m)[:, None], np.broadcast_to([1, 2, 3], (41 * 41, 3)), rtol=1e-6)
    text = files.klems_xml(names=("0.45", "0.65")).replace('unit="Integral"', 'unit="Micron"')
    (tmp_path / "b.xml").write_text(text)
    assert read(tmp_path / "b.xml").wavelengths.tolist() == [450, 650]


def test_the_side_is_chosen_and_said(tmp_path: Path):
    both = files.klems_xml().replace(
        "</Layer>", files.klems_xml(lambda i, o: 0.5, direction="Reflection Front").split("</DataDefinition>")[1]
    )
    both = both[: both.index("</WindowElement>")] + "</WindowElement>"
    (tmp_path / "a.xml").write_text(both)
    back, front = read(tmp_path / "a.xml"), read(tmp_path / "a.xml", side="front")
    assert any("both sides" in note for note in back.provenance["notes"])
    assert (back.provenance["side"], front.provenance["side"]) == ("back", "front")
    np.testing.assert_allclose(front.values, 0.5, rtol=1e-6)
    assert np.all(front.wi[:, 2] > 0)
    (tmp_path / "b.xml").write_text(files.klems_xml(direction="Transmission Front"))
    with pytest.raises(FormatError, match="no reflection"):
        read(tmp_path / "b.xml")
    (tmp_path / "c.xml").write_text(files.klems_xml())
    with pytest.raises(FormatError, match="of the front"):
        read(tmp_path / "c.xml", side="front")


@pytest.mark.parametrize("d", [3, 4])
def test_a_tree_has_its_values_in_their_cells(tmp_path: Path, d: int):
    (tmp_path / "a.xml").write_text(files.tree_xml(d=d))
    m = read(tmp_path / "a.xml")
    cells = 2**d - 1 + 2**d
    assert m.n_directions == (
        cells if d == 4 else 8 + 3
    )  # of eight parts, the four with the first bit set are not used
    # half the hemisphere of light in each coordinate: all weights add up to the projected solid angles of what is used
    total = np.sum(m.weights * m.wi[:, 2] * m.wo[:, 2] / (1 if d == 4 else np.hypot(m.wi[:, 0], m.wi[:, 1])))
    assert total == pytest.approx(1.0 if d == 4 else 0.5, rel=1e-9)
    assert set(np.round(m.values.ravel(), 6)) <= {round(0.1 + 0.01 * k, 6) for k in range(32)}


@pytest.mark.parametrize("options", [[], ["-h"], ["-q"]], ids=["full", "half", "quarter"])
@pytest.mark.parametrize("side", ["front", "back"])
def test_matrices_by_radiance(tmp_path: Path, options: list[str], side: str):
    (tmp_path / "f.cal").write_text(FUNCTION)
    where = ["+forward", "-backward"] if side == "front" else ["-forward", "+backward"]
    text = radiance.program("bsdf2klems", *options, "-n", "16", "-p", *where, "-f", "f.cal", "f", cwd=tmp_path)
    (tmp_path / "a.xml").write_bytes(text)
    m = read(tmp_path / "a.xml")
    assert m.provenance["side"] == side
    some = np.random.default_rng(1).integers(0, m.n_directions, 300)
    # Radiance's front has z up; its back is ours turned about y
    turn = np.array([1, 1, 1]) if side == "back" else np.array([-1, 1, -1])
    theirs = radiance.query(tmp_path / "a.xml", m.wi[some] * turn, m.wo[some] * turn)[:, 1]
    np.testing.assert_allclose(m.values[0, some, 0], theirs, rtol=4e-4)  # Radiance adds +-3e-4 to tell patches apart


@pytest.mark.parametrize("d", [3, 4])
def test_trees_by_radiance(tmp_path: Path, d: int):
    (tmp_path / "f.cal").write_text(FUNCTION if d == 4 else FUNCTION.replace(" + 0.02*ix*ox + 0.01*iy*oy", ""))
    text = radiance.program(
        "bsdf2ttree", "-p", f"-t{d}", "-g", "4", "-forward", "+backward", "-f", "f.cal", "f", cwd=tmp_path
    )
    (tmp_path / "a.xml").write_bytes(text[text.index(b"<?xml") :])
    m = read(tmp_path / "a.xml")
    some = np.random.default_rng(1).integers(0, m.n_directions, 300)
    theirs = radiance.query(tmp_path / "a.xml", m.wi[some], m.wo[some])[:, 1]
    np.testing.assert_allclose(m.values[0, some, 0], theirs, rtol=5e-4)


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ('<?xml version="1.0"?><!DOCTYPE x [<!ENTITY a "b">]><WindowElement>&a;</WindowElement>', "entities"),
        ('<!DOCTYPE x SYSTEM "http://example.org/x.dtd"><WindowElement/>', "document type"),
        ("<WindowElement>" + "<a>" * 100 + "</a>" * 100 + "</WindowElement>", "nested"),
        (files.klems_xml()[:4000], "well-formed"),
        (files.klems_xml().replace("Klems Quarter", "Klems Half"), "77 rows"),
        (files.klems_xml().replace("LBNL/Klems Quarter", "Mine"), "not defined"),
        (files.klems_xml().replace("Columns", "Slices"), "IncidentDataStructure"),
        (files.tree_xml("{1 2 3}"), "grid of 3"),
        (files.tree_xml("{{1}{2}}"), "2 parts"),
        (files.tree_xml("{" * 40 + "1"), "halved"),
        (files.tree_xml("{1} {2}"), "more than one tree"),
        (files.tree_xml("{1 2 x 4 5 6 7 8}"), "'x', not a number"),
        (files.tree_xml().replace("Shirley-Chiu", "Other"), "angle basis"),
    ],
)
def test_what_is_refused(tmp_path: Path, text: str, complaint: str):
    (tmp_path / "a.xml").write_text(text)
    with pytest.raises(MotesError, match=complaint) as raised:
        read(tmp_path / "a.xml", format="bsdf-xml")
    assert raised.value.hint


def test_an_own_basis_is_used_and_checked(tmp_path: Path):
    bounds = "<ThetaBounds><LowerTheta>{}</LowerTheta><UpperTheta>{}</UpperTheta></ThetaBounds>"
    ring = "<AngleBasisBlock><Theta>0</Theta><nPhis>{}</nPhis>" + bounds + "</AngleBasisBlock>"
    own = (
        "<AngleBasis><AngleBasisName>Mine</AngleBasisName>"
        + ring.format(1, 0, 30)
        + ring.format(4, 30, 90)
        + "</AngleBasis>"
    )
    bases = "<ColumnAngleBasis>Mine</ColumnAngleBasis><RowAngleBasis>Mine</RowAngleBasis>"
    block = files.window_block("Visible", "Reflection Front", bases, " ".join(["0.1"] * 25))
    structure = "<IncidentDataStructure>Columns</IncidentDataStructure>"
    (tmp_path / "a.xml").write_text(files.window_xml(structure + own, block))
    m = read(tmp_path / "a.xml")
    np.testing.assert_allclose(np.unique(np.degrees(m.theta_r).round(6)), [0, 60])
    (tmp_path / "a.xml").write_text(files.window_xml(structure + own.replace("<nPhis>4", "<nPhis>99999"), block))
    with pytest.raises(FormatError, match=r"99999|0 parts"):
        read(tmp_path / "a.xml")


def test_points_share_the_projected_solid_angle():
    for basis in KLEMS.values():
        assert basis.projected_solid_angle.sum() == pytest.approx(np.pi, rel=1e-12)
        points = basis.points(40)
        np.testing.assert_allclose(np.linalg.norm(points, axis=-1), 1, rtol=1e-12)
        # their mean cosine squared is that of the patch: the mean of cos^2 over projected area
        edges = np.cos(np.deg2rad(basis.edges)) ** 2
        middle = ((edges[1:] + edges[:-1]) / 2)[basis.ring]
        np.testing.assert_allclose((points[..., 2] ** 2).mean(axis=1), middle, rtol=1e-9)


def test_it_can_be_fitted(tmp_path: Path):
    (tmp_path / "a.xml").write_text(files.klems_xml(lambda i, o: 0.4 / np.pi))
    fit = motes.fit(read(tmp_path / "a.xml"), model="lambert")
    assert float(fit.parameters["K_d"].value) == pytest.approx(0.4, rel=1e-4)
