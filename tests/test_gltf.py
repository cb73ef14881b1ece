"""Dusty meshes as glTF: valid for the Khronos validator, read back, drawn by three.js; the last two need node or chromium, by name."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from motes.errors import DataError, MotesError, ParameterError
from motes.exports.gltf_dust import dusty_look, write_gltf
from motes.meshes import read_mesh
from motes.meshes.glb import write_glb
from motes.meshes.mesh import Mesh
from motes.models import BRDF, GGX, Dust, DustLayer, Lambert, OrenNayar, Schlick
from three_support import drawn_gltf

ROOT = Path(__file__).resolve().parents[1]
Run = Callable[..., tuple[int, str, str]]
SAND = Dust((0.95, 0.85, 0.6), 0.2)
PAINT = Lambert((0.6, 0.3, 0.1))
TAU = np.array([0.0, 0.1, 1.0, 30.0])


def square(tau: float = 0.4) -> Mesh:
    """Two triangles that face z, and a vertex that none uses."""
    corners = np.array([[-1.0, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0], [9, 9, 9]])
    normals = np.array([[0.0, 0, 1]] * 4 + [[0, 0, 0]])
    uv = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1], [0, 0]])
    return Mesh(corners, np.array([[0, 1, 2], [0, 2, 3]]), normals, uv, {"tau": np.full(5, tau)}, "square")


def written(path: Path, model: BRDF, tau: float = 0.4) -> tuple[Path, np.ndarray]:
    look = dusty_look(model, np.full(5, tau))
    return write_glb(path, square(tau), look.colours, look.material, "test"), look.colours[0]


# ---------------------------------------------------------------- the look


@pytest.mark.parametrize("scattering", ["single", "multiple"])
def test_colours_go_from_the_base_to_the_dust(scattering: str) -> None:
    look = dusty_look(DustLayer(PAINT, SAND, scattering=scattering), TAU)
    np.testing.assert_allclose(look.colours[0], PAINT.K_d, rtol=1e-12)
    deep = Dust(SAND.w, SAND.g, scattering=scattering).spherical_albedo()
    np.testing.assert_allclose(look.colours[-1], deep, rtol=0.03)
    middle = DustLayer(PAINT, SAND, 1.0, scattering=scattering).spherical_albedo()
    np.testing.assert_allclose(look.colours[2], middle, rtol=0.1)
    assert look.material["extensions"]["KHR_materials_specular"] == {"specularFactor": 0.0}


def test_a_highlight_is_that_of_the_mean_vertex() -> None:
    model = DustLayer(PAINT + GGX(1.0, 0.25, Schlick(0.05)), SAND, scattering="multiple")
    clean, dusty = dusty_look(model, np.zeros(3)), dusty_look(model, np.full(3, 0.5))
    assert clean.material["pbrMetallicRoughness"]["roughnessFactor"] == pytest.approx(0.5)
    strength = [x.material["extensions"]["KHR_materials_specular"]["specularColorFactor"] for x in (clean, dusty)]
    np.testing.assert_allclose(strength[0], 0.05 / 0.04, rtol=1e-9)
    np.testing.assert_allclose(strength[1], np.exp(-0.5 * 3.32) * 0.05 / 0.04, rtol=1e-9)
    assert "highlight" in clean.notes[1]


def test_what_gltf_cannot_hold_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ParameterError, match="no layer of dust"):
        dusty_look(PAINT, TAU)
    with pytest.raises(DataError, match="7 channels"):
        dusty_look(DustLayer(Lambert(np.linspace(0.1, 0.7, 7)), Dust()), TAU)
    bare = Mesh(square().positions, square().triangles)
    with pytest.raises(MotesError, match="no normals"):
        write_glb(tmp_path / "x.glb", bare, np.ones((5, 3)), {}, "test")


# ---------------------------------------------------------------- the file


def test_read_back(tmp_path: Path) -> None:
    pytest.importorskip("trimesh")
    path, _ = written(tmp_path / "square.glb", DustLayer(PAINT, SAND))
    mesh = read_mesh(path)
    np.testing.assert_allclose(mesh.positions, square().positions[:4])
    assert mesh.triangles.tolist() == square().triangles.tolist()
    np.testing.assert_allclose(mesh.normals, square().normals[:4])


VALIDATE = """
const validator = require(process.argv[1]);
const [fs, path, file] = [require('fs'), require('path'), process.argv[2]];
const beside = (uri) => Promise.resolve(new Uint8Array(fs.readFileSync(path.join(path.dirname(file), uri))));
validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {externalResourceFunction: beside}).then((report) => console.log(JSON.stringify(report)));
"""


def validated(path: Path) -> dict:
    """The report of the Khronos validator."""
    node, package = shutil.which("node"), ROOT / "viewer" / "node_modules" / "gltf-validator"
    if node is None or not package.is_dir():
        pytest.skip("gltf-validator is not installed (npm ci in viewer)")
    done = subprocess.run([node, "-e", VALIDATE, str(package), str(path)], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def test_the_khronos_validator_finds_nothing(tmp_path: Path) -> None:
    shiny = DustLayer(OrenNayar((0.5, 0.4, 0.3), 0.3) + GGX(1.0, 0.2, Schlick(0.5)), SAND, scattering="multiple")
    for name, model in (("matte", DustLayer(PAINT, SAND)), ("shiny", shiny)):
        report = validated(written(tmp_path / f"{name}.glb", model)[0])
        assert report["issues"]["numErrors"] == report["issues"]["numWarnings"] == 0, report["issues"]
        assert report["info"]["totalVertexCount"] == 4
    broken = bytearray((tmp_path / "matte.glb").read_bytes())
    broken[-20:] = b"\xff" * 20  # an index beyond the vertices
    (tmp_path / "broken.glb").write_bytes(broken)
    assert validated(tmp_path / "broken.glb")["issues"]["numErrors"] > 0


@pytest.mark.slow
def test_drawn_by_three(tmp_path: Path) -> None:
    """A square of dusty paint under a sun: colour / pi x cosine x intensity."""
    model = DustLayer(PAINT, SAND, scattering="multiple")
    path, colour = written(tmp_path / "square.glb", model)
    found = drawn_gltf(path, tmp_path, ("PerspectiveCamera", [0.01, 1, 0.1, 100]), side=3, step=3)
    assert found["tau"] == pytest.approx(0.4)
    assert found["specular"] == 0
    np.testing.assert_allclose(found["pixels"][0], colour / np.pi * 0.8 * 2, rtol=1e-3)


@pytest.mark.slow
def test_days_are_an_animation(tmp_path: Path) -> None:
    """Bare, after 30 and after 90 days: the colours of a moment are the line between those of the days beside it."""
    model = DustLayer(PAINT, SAND, scattering="multiple")
    moments = [(0.0, np.zeros(5)), (30.0, np.full(5, 0.2)), (90.0, np.full(5, 0.6))]
    path = tmp_path / "ageing.glb"
    notes = write_gltf(path, square(), model, moments, "test")
    assert "from day 0 to 90" in notes[-1]
    shiny = DustLayer(PAINT + GGX(1.0, 0.2, Schlick(0.5)), SAND, scattering="multiple")
    assert "that after 90 days" in write_gltf(tmp_path / "shiny.glb", square(), shiny, moments, "test")[-1]
    report = validated(path)
    assert report["issues"]["numErrors"] == report["issues"]["numWarnings"] == 0, report["issues"]
    assert (report["info"]["animationCount"], report["info"]["hasMorphTargets"]) == (1, True)
    bare, thin, thick = (dusty_look(model, tau).colours[0] for _, tau in moments)
    # 90 days in four seconds: 15 days are two thirds of one, 60 days are 8/3.
    for second, colour in ((2 / 3, (bare + thin) / 2), (8 / 3, (thin + thick) / 2)):
        folder = tmp_path / f"{second:.1f}"
        folder.mkdir()
        found = drawn_gltf(path, folder, ("PerspectiveCamera", [0.01, 1, 0.1, 100]), side=3, step=3, at=second)
        assert found["tau"] == pytest.approx(0.6)
        np.testing.assert_allclose(found["pixels"][0], colour / np.pi * 0.8 * 2, rtol=1e-3)


# ---------------------------------------------------------------- the command


def test_the_command(motes: Run) -> None:
    pytest.importorskip("mitsuba")
    status, out, err = motes("dust", "sphere", "--days", 100, "--rays", 16, "-o", "ball.glb", "--json")
    assert (status, err) == (0, "")
    said = json.loads(out)
    assert said["open_tau"] == pytest.approx(0.5)
    assert "diffuse light" in " ".join(said["notes"])
    assert validated(Path("ball.glb"))["issues"]["numErrors"] == 0
    assert motes("dust", "plane", "--days", 1, "--material", "plaster", "--rays", 4, "-o", "p.glb", "--quiet")[0] == 0
    assert motes("dust", "plane", "--days", "0,9", "--rays", 4, "-o", "days.glb", "--quiet")[0] == 0
    assert validated(Path("days.glb"))["info"]["animationCount"] == 1
    assert motes("dust", "plane", "--days", "0,9", "--rays", 4, "-o", "days.ply")[0] == 2
    status, _, err = motes("dust", "sphere", "--days", 1, "-o", "ball.fbx")
    assert status == 2
    assert "NAME.glb" in err
