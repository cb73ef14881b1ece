"""Blender's extension: what it is built of, and what it does in Blender, against Motes.

The tests in Blender need a Python with the package bpy (see docs/blender.md): set MOTES_BPY to its interpreter, or to several.
"""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import zipfile
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from numpy.typing import NDArray

from motes import Material
from motes.errors import ParameterError
from motes.exports import surface_blender, surface_files
from motes.exports.approximation import lobes
from motes.exports.osl_layer import Beneath, layer_shader
from motes.exports.subject import subject
from motes.exports.surface_fit import SurfaceFit
from motes.fitting.conversion import Conversion
from motes.meshes.mesh import Mesh
from motes.models import BRDF, Dust, DustLayer, Lambert, Principled
from motes.models.dust_optics import DUSTS
from motes.models.standard import DIFFUSIVITY

ROOT = Path(__file__).resolve().parents[1]
SCRIPT = Path(__file__).with_name("blender_dust.py")
SIDE = 48
BASE = Lambert((0.6, 0.3, 0.1))
Floats = NDArray[np.float64]


@pytest.fixture(scope="module")
def build() -> ModuleType:
    """tools/blender_build.py"""
    spec = importlib.util.spec_from_file_location("blender_build", ROOT / "tools" / "blender_build.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


# ---------------------------------------------------------------- what it is built of


def test_the_zip_is_the_same_twice_and_whole(build: ModuleType, tmp_path: Path) -> None:
    first, second = build.build(tmp_path / "a"), build.build(tmp_path / "b")
    assert first.read_bytes() == second.read_bytes()
    with zipfile.ZipFile(first) as archive:
        names = set(archive.namelist())
        assert archive.read("gathering.py") == (ROOT / "src/motes/rendering/gathering.py").read_bytes()
        table = json.loads(archive.read("dusts.json"))
        manifest = archive.read("blender_manifest.toml").decode()
    assert {"__init__.py", "layer.py", "settling.py", "numbers.py", "importing.py", "sockets.json", "LICENSE"} < names
    assert set(table) == set(DUSTS) == {n[4:-4] for n in names if n.startswith("osl/")}
    assert f'version = "{build.__version__}"' in manifest


@pytest.mark.parametrize("name", DUSTS)
def test_its_curves_are_the_lobes_of_the_layer(build: ModuleType, name: str) -> None:
    """At the stops of the ramps, and by straight lines between them, over bases of three albedos."""
    facts = build.facts(DUSTS[name].dust())
    place = np.linspace(0, 1, build.STOPS)
    for tau, tolerance in ((10 / 21, 1e-5), (2.0 * 20 / 22, 0.02), (0.05, 0.05)):
        at = [
            np.array([np.interp(tau / (1 + tau), place, np.array(facts[key])[:, c]) for c in range(3)])
            for key in ("escaping", "below", "returned")
        ]
        for albedo in (0.0, 0.4, 0.9):
            _, once, more = lobes(DustLayer(Beneath(albedo), DUSTS[name].dust(), tau, scattering="multiple"))
            through = np.exp(-tau * 2 * DIFFUSIVITY)
            np.testing.assert_allclose(once.grazing, (1 - through) * np.array(facts["once"]), rtol=1e-6)
            found = at[0] + albedo * at[1] / (1 - albedo * at[2])
            np.testing.assert_allclose(found, more.grazing, rtol=tolerance, atol=1e-3 if tolerance > 1e-4 else 1e-6)


def test_the_shader_says_what_it_is() -> None:
    text = layer_shader(Dust((0.9, 0.8, 0.7), 0.3), shader_name="sand", title='a "b" */\nc')
    assert "shader sand(" in text
    assert "closure color Base = 0" in text
    assert "multiple scattering; g = 0.3" in text
    assert all(line.startswith("//") for line in text.splitlines()[:4])
    once = layer_shader(Dust(0.6, 0.0), scattering="single")
    assert len(once) < len(text) / 10
    with pytest.raises(ParameterError, match="no colour"):
        layer_shader(Dust(np.linspace(0.5, 0.9, 7), 0.0))


# ---------------------------------------------------------------- what it does


@pytest.fixture(scope="module")
def found(build: ModuleType, blender: str, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Floats]:
    """What tests/blender_dust.py saw in Blender, the extension being installed from its zip."""
    folder = tmp_path_factory.mktemp("blender")
    extension, result = build.build(folder), folder / "result.npz"
    environment = {**os.environ, "BLENDER_USER_RESOURCES": str(folder / "user")}
    command = [blender, str(SCRIPT), str(extension), str(result), str(SIDE)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, env=environment, check=False)
    assert result.is_file(), done.stdout[-2000:] + done.stderr[-2000:]
    return dict(np.load(result))


def shares(points: Floats, triangles: Floats, normals: Floats, others: list[Mesh], **options: object) -> Floats:
    """Motes' own, by Mitsuba's rays, without noise."""
    pytest.importorskip("mitsuba")
    from motes.rendering.deposition import deposit

    mesh = Mesh(points, triangles.astype(np.int64), normals)
    return deposit(mesh, others=others, noise=0.0, **options).share  # type: ignore[arg-type]


@pytest.mark.slow
def test_dust_lies_where_motes_says(found: dict[str, Floats]) -> None:
    points, quads = found["points"], found["triangles"]
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    level = np.broadcast_to([0.0, 0.0, 1.0], points.shape).copy()
    corner = np.array([[-0.3, -0.3, 0.6], [0.3, -0.3, 0.6], [0.3, 0.3, 0.6], [-0.3, 0.3, 0.6]])
    table = Mesh(corner, np.array([[0, 1, 2], [0, 2, 3]]), level[:4])
    up = {"up": (0, 0, 1), "rays": 48}
    np.testing.assert_allclose(found["open"], shares(points, triangles, level, [], **up), atol=1e-5)
    np.testing.assert_allclose(found["sheltered"], shares(points, triangles, level, [table], **up), atol=1e-5)
    assert found["sheltered"].min() < 0.2 < 0.99 < found["sheltered"].max()
    expected = shares(
        found["ball_points"],
        found["ball_triangles"],
        found["ball_normals"],
        [],
        up=(0, 1, 1),
        rays=64,
        slipperiness=0.5,
    )
    assert np.median(np.abs(found["ball"] - expected)) < 1e-5
    np.testing.assert_allclose(found["ball"], expected, atol=0.02)  # a ray that grazes the ball itself is one of 64


def exact(model: BRDF, sun: Floats) -> tuple[NDArray[np.bool_], Floats]:
    """Where a ball is well lit, and what an orthographic camera above sees of it: BRDF x cosine."""
    x = (2 * np.arange(SIDE) + 1) / SIDE - 1
    x, y = np.meshgrid(x, x)
    normal = np.stack([x, y, np.sqrt(np.maximum(1 - x**2 - y**2, 0))], axis=-1)
    seen = (x**2 + y**2 < 0.9) & (normal @ sun > 0.15)
    normal = normal[seen]
    across = np.cross(normal, [0.3, 0.9, 0.1])
    across /= np.linalg.norm(across, axis=-1, keepdims=True)
    along = np.cross(normal, across)
    wi, wo = (np.stack([across @ w, along @ w, normal @ w], axis=-1) for w in (sun, np.array([0.0, 0.0, 1.0])))
    return seen, model.eval(wi, wo) * wi[:, 2:]


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["NODES", "OSL"])
def test_it_looks_as_motes_says(kind: str, found: dict[str, Floats]) -> None:
    """Under a sun, over a diffuse base; what is left is what standard lobes lose (docs/exports.md)."""
    seen, clean = exact(BASE, found["sun"])
    assert np.median(np.abs(found["diffuse_clean"][seen] / clean - 1)) < 0.005
    dusty = DustLayer(BASE, DUSTS["sahara"].dust(), 0.5, scattering="multiple")
    _, expected = exact(dusty, found["sun"])
    off = np.abs(found[f"diffuse_{kind}"][seen] / expected - 1)
    assert 0.01 < np.median(off) < 0.15
    assert np.abs(found[f"diffuse_{kind}"][seen].sum() / expected.sum() - 1) < 0.1
    for base in ("diffuse", "principled"):
        np.testing.assert_allclose(found[f"{base}_{kind}_day_0"], found[f"{base}_clean"], atol=1e-6)
        assert np.abs(found[f"{base}_{kind}"] / np.maximum(found[f"{base}_clean"], 1e-3) - 1)[seen].mean() > 0.1


@pytest.mark.slow
def test_it_keeps_the_energy_under_a_sky(found: dict[str, Floats]) -> None:
    """Seen from above; a channel is off by what the phase function would do, which a diffuse lobe has not."""
    dusty = DustLayer(BASE, DUSTS["sahara"].dust(), 0.5, scattering="multiple")
    middle = found["sky"][SIDE // 2 - 3 : SIDE // 2 + 3, SIDE // 2 - 3 : SIDE // 2 + 3].mean(axis=(0, 1))
    expected = dusty.directional_albedo((0, 0, 1))
    np.testing.assert_allclose(middle.sum(), expected.sum(), rtol=0.06)
    np.testing.assert_allclose(middle, expected, rtol=0.25)


@pytest.mark.slow
def test_nodes_and_osl_agree(found: dict[str, Floats]) -> None:
    seen, _ = exact(BASE, found["sun"])
    for base in ("diffuse", "principled"):
        np.testing.assert_allclose(found[f"{base}_NODES"][seen], found[f"{base}_OSL"][seen], rtol=2e-3)


@pytest.mark.slow
def test_days_animate_and_dust_comes_off(found: dict[str, Floats]) -> None:
    np.testing.assert_allclose(found["days"], [0, 50, 100], atol=0.01)
    np.testing.assert_allclose(found["first_frame"], found["principled_clean"], atol=1e-6)
    np.testing.assert_allclose(found["cleaned"], found["principled_clean"], atol=1e-6)
    assert not found["left"].any()


@pytest.mark.slow
def test_materials_are_imported(build: ModuleType, blender: str, tmp_path: Path) -> None:
    """A fitted material of two moments becomes a node group with the values that the export's script gives its node, over frames too."""
    moments = (
        Principled((0.3, 0.2, 0.1), 0.2, roughness=0.2, ior=1.6),
        Principled((0.6, 0.4, 0.2), 0.4, roughness=0.7, sheen_weight=0.3, sheen_tint=(1.0, 0.8, 0.6)),
    )
    fits = []
    for k, model in enumerate(moments):
        what = replace(subject(Material(model, name="wet rock")), hours=2.0 * k)
        fits.append(SurfaceFit(what, model.canonical(), Conversion(model, 0.0, 0.0, 0.0), ()))
    script, result = surface_blender.write(fits, tmp_path / "rock.py"), tmp_path / "result.json"
    (tmp_path / "rock_fit.json").write_text(surface_files.record(fits))
    Material(Lambert(0.5)).save(tmp_path / "material.json")
    files = [script, tmp_path / "rock_fit.json", tmp_path / "material.json", result]
    environment = {**os.environ, "BLENDER_USER_RESOURCES": str(tmp_path / "user")}
    command = [blender, str(SCRIPT.with_name("blender_import.py")), str(build.build(tmp_path)), *map(str, files)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, env=environment, check=False)
    assert result.is_file(), done.stdout[-2000:] + done.stderr[-2000:]
    found = json.loads(result.read_text())
    assert (found["material"], found["group"], found["ends"]) == ("wet rock", "Motes wet rock", ["OUTPUT_MATERIAL"])
    assert set(surface_blender.SOCKETS.values()) <= set(found["imported"])
    for socket, values in found["scripted"].items():
        np.testing.assert_allclose(found["imported"][socket], values, rtol=2e-5, atol=1e-6, err_msg=socket)
    assert found["imported"]["Roughness"] == pytest.approx([0.2, 0.7])
    assert "has no parameters of Blender's. motes export MATERIAL --to blender" in found["refused"]
