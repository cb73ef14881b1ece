"""What `motes export` writes in the formats of measuring rooms and engines: read back, and by Radiance and Mitsuba."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import format_files as files
import motes
import radiance_support as radiance
from motes.directions import from_spherical
from motes.errors import DataError, MotesError, ParameterError
from motes.exports import export
from motes.measurements import Measurement, read
from motes.measurements.rgl import TensorBRDF

# IEC 61966-2-1, each row divided by its sum
SRGB_TO_XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
SRGB_TO_XYZ /= SRGB_TO_XYZ.sum(axis=1, keepdims=True)

GREY = motes.OrenNayar(K_d=0.5, sigma_d=0.4) + motes.TorranceSparrow(K_s=0.3, sigma_s=0.25)
PLASTER = motes.OrenNayar(K_d=(0.8, 0.5, 0.2), sigma_d=0.3) + motes.TorranceSparrow(K_s=0.3, sigma_s=0.25)
SPECTRUM = motes.Material(
    motes.OrenNayar(K_d=(0.2, 0.4, 0.6), sigma_d=0.3), name="blue brick", wavelengths=(450, 550, 650)
)


def y_of(brdf, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
    f = np.asarray(brdf.eval(wi, wo))
    return f[:, 0] if f.shape[1] == 1 else f @ SRGB_TO_XYZ[1]


@pytest.mark.parametrize("basis", ["full", "half", "quarter"])
def test_klems_matrices_are_means_over_their_patches(tmp_path: Path, basis: str):
    export(GREY, "klems", tmp_path / "a.xml", basis=basis)
    m = read(tmp_path / "a.xml")
    # the mean by a sum of its own: random points, uniform in the projected solid angle of a few pairs of patches
    rng = np.random.default_rng(1)
    rings = {
        "full": (0, 5, 15, 25, 35, 45, 55, 65, 75, 90),
        "half": (0, 6.5, 19.5, 32.5, 45.5, 58.5, 71.5, 90),
        "quarter": (0, 9, 27, 45, 63, 90),
    }
    edges = np.cos(np.radians(rings[basis])) ** 2

    def points(w: np.ndarray) -> np.ndarray:
        theta, phi = np.degrees(np.arccos(w[2])), np.arctan2(w[1], w[0])
        ring = np.searchsorted(rings[basis], theta, side="right") - 1
        count = len(
            np.unique(
                np.round(np.arctan2(*m.wo[np.abs(m.wo[:, 2] - w[2]) < 1e-9, 1::-1].T) % (2 * np.pi), 6) % 6.283185
            )
        )
        cos2 = rng.uniform(edges[ring + 1], edges[ring], 4000)
        azimuth = phi + rng.uniform(-np.pi, np.pi, 4000) / count
        return from_spherical(np.arccos(np.sqrt(cos2)), azimuth)

    for k in rng.integers(0, m.n_directions, 12):
        f = y_of(GREY, points(m.wi[k]), points(m.wo[k]))
        assert m.values[0, k, 0] == pytest.approx(f.mean(), abs=4 * f.std() / np.sqrt(len(f)) + 0.01 * f.mean())
    table = m.values[0, :, 0].reshape(round(m.n_directions**0.5), -1)
    np.testing.assert_allclose(table, table.T, rtol=1e-5)  # reciprocal, as the model is


@pytest.mark.parametrize("to", ["klems", "tensortree"])
@pytest.mark.parametrize("material", [GREY, PLASTER], ids=["grey", "rgb"])
def test_radiance_reads_the_same_values(tmp_path: Path, to: str, material: motes.BRDF):
    done = export(material, to, tmp_path / "a.xml", **({"basis": "half"} if to == "klems" else {}))
    assert any("Radiance the front" in note for note in done.notes)
    m = read(tmp_path / "a.xml")
    some = np.random.default_rng(1).integers(0, m.n_directions, 300)
    theirs = radiance.query(tmp_path / "a.xml", m.wi[some], m.wo[some])
    if m.n_channels == 1:
        np.testing.assert_allclose(m.values[0, some, 0], theirs[:, 1], rtol=5e-4)
    else:
        assert m.channels == ("X", "Y", "Z")
        np.testing.assert_allclose(m.values[0, some, 1], theirs[:, 1], rtol=2e-3)
        if to == "klems":  # Radiance keeps two bytes of chromaticity
            np.testing.assert_allclose(m.values[0, some], theirs, rtol=0.08)


def test_radiance_reads_the_colour_of_a_tree(tmp_path: Path):
    """Of one colour: where it varies, Radiance's library takes a common part out of isotropic trees and loses the rest."""
    export(motes.Lambert(K_d=(0.8, 0.5, 0.2)), "tensortree", tmp_path / "a.xml")
    m = read(tmp_path / "a.xml")
    np.testing.assert_allclose(m.values[0, 0], SRGB_TO_XYZ @ [0.8, 0.5, 0.2] / np.pi, rtol=1e-4)
    theirs = radiance.query(tmp_path / "a.xml", from_spherical([0.3, 0.8], np.pi), from_spherical([0.5, 0.2], [0, 1.0]))
    np.testing.assert_allclose(theirs, np.broadcast_to(m.values[0, 0], (2, 3)), rtol=1e-3)


def test_radiance_finds_the_albedo(tmp_path: Path):
    """checkBSDF sums the file's projected solid angles, in percent."""
    export(motes.Lambert(K_d=0.6), "tensortree", tmp_path / "a.xml")
    export(motes.Lambert(K_d=0.6), "klems", tmp_path / "b.xml")
    for name in ("a.xml", "b.xml"):
        printed = radiance.program("checkBSDF", name, cwd=tmp_path).decode()
        line = next(line for line in printed.splitlines() if line.startswith("Interior Refl"))
        assert [float(x) for x in line.split()[2:5]] == pytest.approx([60, 60, 60], abs=0.1)


def test_a_tree_has_the_material_in_its_cells(tmp_path: Path):
    export(GREY, "tensortree", tmp_path / "a.xml")
    m = read(tmp_path / "a.xml")
    error = np.abs(m.values[0, :, 0] / y_of(GREY, m.wi, m.wo) - 1)
    assert np.median(error) < 5e-4
    assert np.quantile(error, 0.95) < 0.01


def directions(n: int, seed: int, largest_deg: float) -> tuple[np.ndarray, np.ndarray]:
    """Half of them anywhere, half about the mirror direction, both up to a polar angle."""
    rng = np.random.default_rng(seed)
    low = np.cos(np.radians(largest_deg))
    wi = from_spherical(np.arccos(rng.uniform(low, 1, n)), rng.uniform(-np.pi, np.pi, n))
    wo = from_spherical(np.arccos(rng.uniform(low, 1, n)), rng.uniform(-np.pi, np.pi, n))
    near = wi * [-1, -1, 1] + rng.normal(0, 0.05, (n, 3))
    near /= np.linalg.norm(near, axis=1, keepdims=True)
    near_enough = (np.arange(n) % 2 == 0) & (near[:, 2] > low)
    wo[near_enough] = near[near_enough]
    return wi.astype("f4").astype(float), wo.astype("f4").astype(float)


RGL = {
    "plaster": PLASTER,
    "gloss": motes.OrenNayar(K_d=(0.8, 0.5, 0.2), sigma_d=0.3) + motes.TorranceSparrow(K_s=3.0, sigma_s=0.06),
    "dusty": motes.DustLayer(motes.OrenNayar(K_d=0.6, sigma_d=0.5), motes.Dust(w=(0.7, 0.6, 0.5), g=0.3), tau=0.2),
}


@pytest.mark.parametrize("name", RGL)
def test_mitsuba_sees_the_material_in_an_rgl_file(tmp_path: Path, name: str):
    mi = pytest.importorskip("mitsuba")
    mi.set_variant("scalar_rgb")
    export(RGL[name], "rgl", tmp_path / "a.bsdf")
    bsdf = mi.load_dict({"type": "measured", "filename": str(tmp_path / "a.bsdf")})
    context, interaction = mi.BSDFContext(), mi.SurfaceInteraction3f()
    wi, wo = directions(600, 3, 85)
    theirs = []
    for i, o in zip(wi.tolist(), wo.tolist(), strict=True):
        interaction.wi = i
        theirs.append(np.array(bsdf.eval(context, interaction, o)).ravel())
    theirs = np.array(theirs)
    ours = TensorBRDF.load(tmp_path / "a.bsdf").eval(wi, wo) * wo[:, 2:]
    np.testing.assert_allclose(ours, theirs, rtol=2e-4)  # float32 there
    f = np.broadcast_to(RGL[name].eval(wi, wo), ours.shape) * wo[:, 2:]
    error = np.abs(theirs / f - 1)
    assert np.median(error) < 0.003
    assert np.quantile(error, 0.95) < 0.03
    # and it draws directions in proportion: the mean weight is the albedo, with little noise
    interaction.wi = from_spherical(0.8, 0.0).tolist()
    rng = np.random.default_rng(1)
    weights = np.array(
        [np.array(bsdf.sample(context, interaction, a, [b, c])[1]).ravel() for a, b, c in rng.random((3000, 3))]
    )
    sin2, phi = np.meshgrid((np.arange(300) + 0.5) / 300, (np.arange(300) + 0.5) / 300 * 2 * np.pi)
    outgoing = from_spherical(np.arcsin(np.sqrt(sin2.ravel())), phi.ravel())
    albedo = np.pi * np.broadcast_to(
        RGL[name].eval(np.tile(from_spherical(0.8, 0.0), (90000, 1)), outgoing), (90000, 3)
    ).mean(axis=0)
    np.testing.assert_allclose(weights.mean(axis=0), albedo, rtol=0.02)
    assert np.all(weights.std(axis=0) < 0.5 * weights.mean(axis=0))


def test_a_spectral_rgl_file_reads_back(tmp_path: Path):
    export(SPECTRUM, "rgl", tmp_path / "a.bsdf")
    brdf = TensorBRDF.load(tmp_path / "a.bsdf")
    assert brdf.wavelengths.tolist() == [450, 550, 650]
    assert "blue brick" in brdf.description
    wi, wo = directions(500, 4, 80)
    error = np.abs(brdf.eval(wi, wo) / SPECTRUM.brdf.eval(wi, wo) - 1)
    assert np.median(error) < 0.003


@pytest.mark.parametrize("material", [GREY, PLASTER], ids=["grey", "rgb"])
def test_zemax_tables_read_back(tmp_path: Path, material: motes.BRDF):
    export(material, "zemax", tmp_path / "a.bsdf")
    m = read(tmp_path / "a.bsdf")
    usable = m.mask[0, :, 0]
    y = m.channels.index("Y") if m.n_channels == 3 else 0
    np.testing.assert_allclose(m.values[0, usable, y], y_of(material, m.wi[usable], m.wo[usable]), rtol=1e-5)
    assert usable.sum() > 3000
    totals = np.array(m.provenance["total_integrated_scatter"])
    sin2, phi = np.meshgrid((np.arange(200) + 0.5) / 200, (np.arange(200) + 0.5) / 200 * 2 * np.pi)
    wo = from_spherical(np.arcsin(np.sqrt(sin2.ravel())), phi.ravel())
    wi = np.tile(from_spherical(np.radians(30), 0.0), (len(wo), 1))
    reference = np.asarray(material.eval(wi, wo)).mean(axis=0) * np.pi
    expected = reference[0] if len(reference) == 1 else (SRGB_TO_XYZ @ reference)[0]
    assert totals[6] == pytest.approx(expected, rel=2e-3)  # of the first quantity, at 30 degrees


def test_bird_files_of_a_material(tmp_path: Path):
    export(PLASTER, "bird", tmp_path / "a.json")
    m = read(tmp_path / "a.json")
    assert m.channels == ("R", "G", "B")
    np.testing.assert_allclose(m.values[0], PLASTER.eval(m.wi, m.wo), rtol=1e-8)
    assert m.provenance["method"] == "simulation"
    assert "not measured" in json.loads((tmp_path / "a.json").read_text())["metadata"]["comments"]


def test_openmaterial_files_of_a_material(tmp_path: Path, shared_file: Callable[[str], Path]):
    export(SPECTRUM, "openmaterial", tmp_path / "a.xompt")
    m = read(tmp_path / "a.xompt")
    assert m.wavelengths.tolist() == [450, 550, 650]
    np.testing.assert_allclose(m.values[0], SPECTRUM.brdf.eval(m.wi, m.wo), rtol=1e-5)
    assert json.loads((tmp_path / "a.xompt").read_text())["metadata"]["sources"] == "simulation"
    with pytest.raises(DataError, match="no wavelengths"):
        export(PLASTER, "openmaterial", tmp_path / "b.xompt")
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads(shared_file("openmaterial/material_brdf_schema.json").read_text())
    jsonschema.Draft7Validator(schema).validate(json.loads((tmp_path / "a.xompt").read_text()))


def some_data(**more: object) -> Measurement:
    rng = np.random.default_rng(1)
    wi, wo = directions(50, 5, 80)
    return Measurement.from_arrays(
        wi,
        wo,
        rng.uniform(0.01, 1, (50, 2)),
        wavelengths=[500, 600],
        provenance={"name": "Ein Stück", "source": "x"},
        **more,
    )


def test_measured_samples_are_written_as_they_are(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    data = some_data(uncertainties=0.01)
    done = export(data, "bird")
    assert done.files == (Path("ein_stuck.json"),)
    back = read(done.files[0])
    np.testing.assert_allclose(back.values, data.values, rtol=1e-9)
    np.testing.assert_allclose(back.uncertainties, 0.01)
    done = export(data, "openmaterial", tmp_path / "a.xompt")
    assert any("Uncertainties are left out" in note for note in done.notes)
    back = read(tmp_path / "a.xompt")
    np.testing.assert_allclose(np.sort(back.values.ravel()), np.sort(data.values.ravel()), rtol=1e-8)
    with pytest.raises(ParameterError, match="takes a material"):
        export(data, "glsl")
    with pytest.raises(ParameterError, match="hours"):
        export(data, "bird", hours=1)
    with pytest.raises(MotesError, match="basis"):
        export(GREY, "klems", tmp_path / "x.xml", basis="third")


def test_the_command_writes_data_and_bases(tmp_path: Path, motes: Callable[..., tuple[int, str, str]]):
    (tmp_path / "a.xompt").write_text(files.xompt_json())
    status, printed, _ = motes("export", tmp_path / "a.xompt", "--to", "bird", "-o", tmp_path / "a.json")
    assert status == 0
    assert "measurement" in printed
    np.testing.assert_allclose(read(tmp_path / "a.json").values, read(tmp_path / "a.xompt").values)
    status, _, said = motes("export", tmp_path / "a.xompt", "--to", "glsl")
    assert status != 0
    assert said


def test_colours_survive_the_way_there_and_back(tmp_path: Path):
    """RGB becomes X, Y, Z in the file, and pictures of what is read back have the RGB again."""
    from motes.drawing.colour import channels_to_srgb

    export(PLASTER, "zemax", tmp_path / "a.bsdf")
    m = read(tmp_path / "a.bsdf")
    usable = m.mask[0, :, 0]
    rgb = m.values[0, usable] @ channels_to_srgb(m.channels).matrix
    np.testing.assert_allclose(rgb, PLASTER.eval(m.wi[usable], m.wo[usable]), rtol=1e-4)
