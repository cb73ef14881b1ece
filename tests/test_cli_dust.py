"""``motes dust``: dust settles on a mesh, from the command line."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

if (
    find_spec("mitsuba") is None
):  # not importorskip: Dr.Jit chooses its LLVM when it is imported, and Motes must come first
    pytest.skip("mitsuba is not installed", allow_module_level=True)

from motes import Lambert, Material
from motes.ageing import age
from motes.meshes.meshfile import read_mesh
from motes.meshes.ply import write_ply
from motes.meshes.shapes import plane, sphere
from motes.rendering import load_mitsuba
from motes.rendering.deposition import deposit
from rendering_support import Run, message

SECONDS = 120


def test_a_sphere_gets_dust_on_top(motes: Run) -> None:
    ball = sphere(12)
    write_ply("ball.ply", ball)
    status, out, err = motes("dust", "ball.ply", "--days", 30, "--set", "noise=0", "--rays", 64)
    assert (status, err) == (0, "")
    dusty = read_mesh("ball-dusty.ply")
    np.testing.assert_allclose(dusty.attributes["tau"], 0.15 * deposit(ball, noise=0, rays=64).share, atol=1e-6)
    np.testing.assert_array_equal(dusty.triangles, ball.triangles)
    assert "tau = 0.15 where it is level and open, after 30 days" in out
    assert "ball-dusty.ply" in out
    seen = load_mitsuba().load_dict({"type": "ply", "filename": "ball-dusty.ply"})
    np.testing.assert_allclose(np.array(seen.attribute_buffer("vertex_tau")), dusty.attributes["tau"], atol=1e-7)
    assert b"comment tau of dust after 30 days" in Path("ball-dusty.ply").read_bytes()


def test_what_can_be_said_is_passed_on(motes: Run) -> None:
    write_ply("cover.ply", plane(1, size=0.5).moved(shift=(0, 0.2, 0)))
    options = ("--growth-per-day", 0.01, "--refine", 1, "--stroke", "1,0,0,1,0,1,0.2", "--seed", 3, "--rays", 32)
    status, out, err = motes("dust", "plane", "--days", 10, *options, "--shelter", "cover.ply", "--json", "-o", "a.ply")
    assert (status, err) == (0, "")
    told = json.loads(out)
    dusty = read_mesh("a.ply")
    tau, p = dusty.attributes["tau"], dusty.positions
    assert told["open_tau"] == pytest.approx(0.1)
    assert told["vertices"] == len(tau) == 129**2
    assert told["tau"]["max"] == pytest.approx(tau.max(), abs=1e-6)
    assert tau[(np.abs(p) < 0.1).all(1)].max() == 0  # under the cover
    assert tau[(np.abs(p[:, 0] - 1) < 0.02) & (np.abs(p[:, 2] - 0.5) < 0.1)].min() < 0.05  # where the brush was
    assert np.median(tau) == pytest.approx(0.1, abs=0.02)
    windy = motes(
        "dust", "plane", "--days", 10, "--wind", "x", "--set", "scour=1", "--rays", 8, "--json", "-o", "b.ply"
    )
    assert json.loads(windy[1])["tau"]["max"] == 0
    tilted = motes("dust", "plane", "--days", 10, "--up", "1,1,0", "--source=-y", "--rays", 8, "--json", "-o", "c.ply")
    assert json.loads(tilted[1])["tau"]["max"] == 0  # dust that comes from below


def test_the_dust_of_a_material_is_used(motes: Run) -> None:
    age(Lambert(K_d=0.4), "dust", hours=240, tau_growth=0.7).save("slate.json")
    status, out, _ = motes("dust", "plane", "--days", 5, "--material", "slate.json", "--rays", 8, "--json")
    assert status == 0
    assert json.loads(out)["open_tau"] == pytest.approx(0.35)
    assert Path("plane-dusty.ply").is_file()


def test_a_texture_is_written(motes: Run) -> None:
    options = ("--set", "noise=0", "--rays", 16, "--texture-size", 32)
    status, out, err = motes("dust", "teapot", "--days", 20, *options, "-o", "tau.exr")
    assert (status, err) == (0, "")
    assert "texels" in out
    picture = np.array(load_mitsuba().Bitmap("tau.exr")).squeeze()
    assert picture.shape[:2] == (32, 32)
    assert picture.max() == pytest.approx(0.1, rel=0.02)
    assert picture.min() == 0


def test_an_inside_out_mesh_is_said_and_turned(motes: Run) -> None:
    """Dust that lands nowhere is no answer: the reason is said, with the option that mends it."""
    ball = sphere(12)
    rows = [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in ball.positions]
    rows += [f"f {c + 1} {b + 1} {a + 1}" for a, b, c in ball.triangles]
    Path("in.obj").write_text("\n".join(rows))
    options = ("--days", 30, "--rays", 16, "--set", "noise=0")
    status, out, err = motes("dust", "in.obj", *options)
    assert status == 0
    assert "the mesh is inside out: its faces point inwards" in out
    assert err.startswith("warning: no dust landed anywhere: the mesh is inside out")
    assert "--outwards" in err
    status, out, err = motes("dust", "in.obj", *options, "--outwards")
    assert (status, err) == (0, "")
    assert f"{len(ball.triangles)} of {len(ball.triangles)} faces were turned" in out
    assert read_mesh("in-dusty.ply").attributes["tau"].max() == pytest.approx(0.15, rel=0.02)


def test_meshes_of_other_formats(motes: Run) -> None:
    trimesh = pytest.importorskip("trimesh")
    box = trimesh.creation.box((2, 2, 2))
    for kind in ("stl", "glb"):
        Path(f"a.{kind}").write_bytes(box.export(file_type=kind))
        status, _, err = motes("dust", f"a.{kind}", "--days", 30, "--rays", 16, "--set", "noise=0")
        assert (status, err) == (0, "")
        assert read_mesh("a-dusty.ply").attributes["tau"].max() == pytest.approx(0.15, rel=0.02)


def test_a_mesh_far_from_the_origin_keeps_its_digits(motes: Run) -> None:
    write_ply("far.ply", sphere(12).moved(shift=(500_000.25, 4_100_000.5, 300)))
    write_ply("near.ply", sphere(12))
    for name in ("far", "near"):
        assert motes("dust", f"{name}.ply", "--days", 30, "--rays", 16, "--set", "noise=0")[0] == 0
    far, near = read_mesh("far-dusty.ply"), read_mesh("near-dusty.ply")
    np.testing.assert_allclose(
        far.positions - near.positions, [[500_000.25, 4_100_000.5, 300]] * len(near.positions), atol=1e-6
    )
    np.testing.assert_allclose(far.attributes["tau"], near.attributes["tau"], atol=1e-3)
    seen = load_mitsuba().load_dict({"type": "ply", "filename": "far-dusty.ply"})  # which reads doubles
    assert seen.bbox().max.y == pytest.approx(4_100_002.5)


def test_what_was_mended_is_said(motes: Run) -> None:
    Path("a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 0 -1\nf 1 2 3\nf 1 1 2\n")
    status, out, _ = motes("dust", "a.obj", "--days", 1, "--rays", 4)
    assert status == 0
    assert "1 of 2 triangles have no area" in out
    assert "the file has no normals" in out


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("plane",), "--days"),
        (("plane", "--days", -1), "days = -1"),
        (("plane", "--days", "soon"), "soon"),
        (("plan", "--days", 1), "plan does not exist"),
        (("plane", "--days", 1, "-o", "a.stl"), "neither a mesh nor a texture"),
        (("plane", "--days", 1, "--up", "north"), "--up 'north' is not numbers"),
        (("plane", "--days", 1, "--up", "0,1"), "is not a direction"),
        (("plane", "--days", 1, "--up", "0,0,0"), "is not a direction"),
        (("plane", "--days", 1, "--wind", "y"), "straight along up"),
        (("plane", "--days", 1, "--set", "sticky=1"), "no option 'sticky'"),
        (("plane", "--days", 1, "--set", "adhesion=7"), "adhesion = 7 is outside"),
        (("plane", "--days", 1, "--stroke", "1,2,3"), "has 3 numbers"),
        (("plane", "--days", 1, "--stroke", "1,2,3,-1"), "radius"),
        (("plane", "--days", 1, "--mask", "none.png"), "none.png does not exist"),
        (("plane", "--days", 1, "--growth-per-day", -1), "growth_per_day = -1"),
        (("plane", "--days", 1e9), "tau_growth = 5e+06"),
        (("plane", "--days", 1, "--refine", 9), "--refine 9"),
        (("plane", "--days", 1, "--rays", 0), "rays = 0"),
        (("plane", "--days", 1, "--material", "m.json", "--growth-per-day", 1), "both"),
        (("plane", "--days", 1, "--material", "plain.json"), "no layer of dust"),
        (("plane", "--days", 1, "-o", "/proc/motes/a.ply"), "cannot be written"),
        (("bunny", "--days", 1, "-o", "a.exr"), "no texture coordinates"),
        (("nan.obj", "--days", 1), "position is not finite"),
        (("flat.obj", "--days", 1), "no triangle with an area"),
    ],
)
def test_wrong_usage_is_a_sentence_and_a_hint(motes: Run, arguments: tuple[object, ...], words: str) -> None:
    Material(Lambert()).save("plain.json")
    Path("nan.obj").write_text("v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    Path("flat.obj").write_text("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")
    before = set(Path().iterdir())
    status, out, err = motes("dust", *arguments)
    assert (status, out) == (2, "")
    assert words in message(err)[0]
    assert set(Path().iterdir()) == before


def test_an_interrupt_leaves_nothing(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "motes.cli.main", "dust", "bunny", "--days", "9", "--rays", "65536"]
    process = subprocess.Popen(
        command,
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={k: v for k, v in os.environ.items() if k != "MOTES_DEBUG"},
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    time.sleep(4)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=SECONDS)
    assert (process.returncode, out, err) == (130, "", "interrupted\n")
    assert not list(tmp_path.iterdir())
