"""``motes render``: pictures and films of materials, from the command line."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

if (
    find_spec("mitsuba") is None
):  # not importorskip: Dr.Jit chooses its LLVM when it is imported, and Motes must come first
    pytest.skip("mitsuba is not installed", allow_module_level=True)

from PIL import Image

from motes import Lambert, Material, OrenNayar, TorranceSparrow
from motes.ageing import age
from motes.cli.render_command import hours_of
from motes.errors import MotesError
from motes.meshes.ply import write_ply
from motes.meshes.shapes import sphere
from motes.rendering.films import read_radiance
from rendering_support import Run, message

SECONDS = 240
QUICK = ("--size", 48, "--samples", 4)
RED = Material(Lambert(K_d=(0.7, 0.1, 0.1)), "red", ("R", "G", "B"))
BLUE = Material(
    OrenNayar(K_d=(0.1, 0.1, 0.7), sigma_d=0.4) + TorranceSparrow(K_s=0.3, sigma_s=0.2), "blue", ("R", "G", "B")
)


def picture(path: str) -> np.ndarray:
    with Image.open(path) as image:
        return np.array(image.convert("RGB")).astype(int)


@pytest.fixture(autouse=True)
def materials(motes: Run) -> None:
    """In the folder of the test: a red surface, a blue one, and the red one that gathers dust and one that dries."""
    RED.save("red.json")
    BLUE.save("blue.json")
    age(RED, "dust", hours=240, tau_growth=2.0).save("dusty.json")
    age(RED, "drying_paint", hours=10).save("drying.json")


# ---------------------------------------------------------------- pictures


def test_a_material_is_rendered(motes: Run) -> None:
    status, out, err = motes("render", "red.json", *QUICK, "-o", "red.png")
    assert (status, err) == (0, "")
    shown = picture("red.png")
    assert shown.shape == (48, 48, 3)
    middle, corner = shown[24, 24], shown[2, 2]
    assert middle[0] > 1.5 * middle[1]
    assert np.ptp(corner) < 25
    for words in ("red", "sphere", "Khronos PBR Neutral, exposure +0 EV, sRGB", "red.png"):
        assert words in out
    with Image.open("red.png") as image:
        assert "Khronos" in image.text["Comment"]  # type: ignore[attr-defined]
    assert sorted(p.name for p in Path().iterdir()) == ["blue.json", "drying.json", "dusty.json", "red.json", "red.png"]


def test_materials_stand_side_by_side(motes: Run) -> None:
    status, out, _ = motes("render", "red.json", "blue.json", *QUICK, "--no-labels", "--json", "-o", "both.png")
    assert status == 0
    told = json.loads(out)
    assert (told["rows"], told["columns"], told["materials"]) == (1, 2, ["red", "blue"])
    shown = picture("both.png")
    assert shown.shape == (48, 100, 3)
    assert shown[24, 24, 0] > shown[24, 24, 2] + 50
    assert shown[24, 76, 2] > shown[24, 76, 0] + 50


def test_materials_and_times_make_a_table(motes: Run) -> None:
    arguments = ("red.json", "dusty.json", "--scene", "grid", "--time", "0,2.5,5,10d", *QUICK, "--json")
    status, out, _ = motes("render", *arguments, "-o", "table.png")
    assert status == 0
    told = json.loads(out)
    assert (told["rows"], told["columns"], told["hours"]) == (2, 4, [0, 60, 120, 240])
    shown = picture("table.png")
    height, width, _ = shown.shape
    assert height > 2 * 48 + 4  # titles
    tops = [shown[height - 100 + 24, width - 204 + 52 * k + 24] for k in range(4)]
    bottoms = [shown[height - 24, width - 204 + 52 * k + 24] for k in range(4)]
    assert max(np.abs(t - tops[0]).max() for t in tops) == 0  # red stays red, with the same seed to the bit
    greenness = [b[1] / b[0] for b in bottoms]
    assert greenness == sorted(greenness)  # dust hides the red
    assert greenness[-1] > greenness[0] + 0.2


def test_radiance_is_written_without_tone_mapping(motes: Run) -> None:
    assert motes("render", "red.json", "blue.json", *QUICK, "-o", "both.exr")[0] == 0
    radiance = read_radiance(Path("both.exr"))
    assert radiance.shape == (48, 96, 3)
    assert np.isfinite(radiance).all()
    motes("render", "red.json", "blue.json", *QUICK, "--tone", "clip", "--no-labels", "-o", "both.png")
    shown = picture("both.png")[:, :48]
    from motes.drawing.colour import srgb_encode

    assert np.abs(shown - srgb_encode(radiance[:, :48]).astype(int)).max() <= 1  # half floats between them
    brighter = motes(
        "render", "red.json", "blue.json", *QUICK, "--tone", "clip", "--exposure", 1, "--no-labels", "-o", "b.png"
    )
    assert brighter[0] == 0
    assert np.abs(picture("b.png")[:, :48] - srgb_encode(2 * radiance[:, :48]).astype(int)).max() <= 2


def test_every_scene_is_rendered(motes: Run, tmp_path: Path) -> None:
    from motes.rendering import load_mitsuba

    mi = load_mitsuba()
    sky = np.full((4, 8, 3), 0.5, np.float32)
    mi.Bitmap(sky).write(str(tmp_path / "sky.exr"))
    write_ply("ball.ply", sphere(12).moved(3.0, (9, 9, 9)))
    for scene in ("bunny", "teapot", "ball.ply"):
        assert motes("render", "red.json", "--scene", scene, *QUICK, "--quiet", "-o", "a.png") == (0, "", "")
        shown = picture("a.png")
        assert (shown[..., 0] > 1.4 * shown[..., 1]).mean() > 0.1
    assert motes("render", "red.json", "--env", "sky.exr", *QUICK, "--quiet", "-o", "a.png") == (0, "", "")
    assert np.abs(picture("a.png")[2, 24] - 180).max() < 12  # 0.46 of the light, after the offset of the tone mapping


XML = """<scene version="3.0.0">
  <integrator type="path"/>
  <sensor type="perspective">
    <transform name="to_world"><lookat origin="0, 0, 4" target="0, 0, 0" up="0, 1, 0"/></transform>
    <film type="hdrfilm"><integer name="width" value="40"/><integer name="height" value="30"/></film>
  </sensor>
  <emitter type="constant"/>
  <shape type="sphere">
    <bsdf type="motes_material"><string name="filename" value="$material"/><float name="time" value="$time"/></bsdf>
  </shape>
</scene>
"""


def test_a_scene_of_mitsuba_takes_the_material(motes: Run) -> None:
    Path("room.xml").write_text(XML)
    arguments = ("--scene", "room.xml", "--samples", 16, "--time", "0,10h", "--no-labels", "--quiet", "-o", "room.png")
    assert motes("render", "drying.json", *arguments) == (0, "", "")
    shown = picture("room.png")
    assert shown.shape == (30, 84, 3)
    assert shown[15, 20, 0] < shown[15, 64, 0]  # dry paint is lighter
    Path("room.xml").write_text(XML.replace("$material", "red.json"))
    assert (
        "no place for the material" in message(motes("render", "red.json", "--scene", "room.xml", "-o", "a.png")[2])[0]
    )
    Path("room.xml").write_text(XML.replace("</scene>", ""))
    assert (
        "Mitsuba cannot load room.xml"
        in message(motes("render", "red.json", "--scene", "room.xml", "-o", "a.png")[2])[0]
    )
    Path("room.xml").write_text(XML.replace("constant", "sun_and_moon"))
    assert "sun_and_moon" in message(motes("render", "red.json", "--scene", "room.xml", "-o", "a.png")[2])[0]


# ---------------------------------------------------------------- dust that settles


def test_deposited_dust_lies_on_top(motes: Run) -> None:
    shots = {}
    for name, options in {"even": (), "settled": ("--deposit", "--set", "noise=0")}.items():
        arguments = ("dusty.json", "--time", "10d", "--size", 64, "--samples", 16, *options)
        assert motes("render", *arguments, "--quiet", "-o", f"{name}.exr") == (0, "", "")
        shots[name] = read_radiance(Path(f"{name}.exr"))
    redness = {name: shot[..., 0] / shot[..., 1] for name, shot in shots.items()}
    top, side = np.s_[14:18, 30:34], np.s_[40:46, 26:38]
    assert redness["settled"][top].mean() < 1.6  # the dust's own colour: 0.78 to 0.70
    assert redness["settled"][side].mean() > 2 * redness["settled"][top].mean()
    assert redness["even"][side].mean() < 1.6


def test_dust_is_laid_on_what_has_none(motes: Run) -> None:
    status, out, _ = motes("render", "red.json", "--deposit", "--wind", "x", "--time", "0,5d", *QUICK, "-o", "a.png")
    assert status == 0
    assert "the material has no dust; that of the phenomenon lies on it, tau to 0.5 in the open" in out


def test_a_mesh_brings_its_dust(motes: Run) -> None:
    assert motes("dust", "bunny", "--days", 400, "--rays", 32, "--quiet", "-o", "bunny.ply") == (0, "", "")
    status, out, _ = motes("render", "red.json", "--scene", "bunny.ply", *QUICK, "-o", "dusty.png")
    assert status == 0
    assert "dust lies as bunny says: tau up to 2" in out
    motes("render", "red.json", "--scene", "bunny", *QUICK, "-o", "clean.png")
    dusty, clean = picture("dusty.png"), picture("clean.png")
    red = [np.count_nonzero(p[..., 0] > 1.6 * p[..., 1]) for p in (dusty, clean)]
    assert red[0] < 0.8 * red[1]


@pytest.mark.parametrize(("value", "words"), [(np.nan, "not finite"), (-0.5, "negative"), (1e9, "huge")])
def test_a_mesh_with_an_impossible_tau_is_explained(motes: Run, value: float, words: str) -> None:
    ball = sphere(6)
    tau = np.zeros(len(ball.positions))
    tau[7] = value
    write_ply("ball.ply", ball.with_attribute("tau", tau))
    status, out, err = motes("render", "red.json", "--scene", "ball.ply", *QUICK, "-o", "a.png")
    assert (status, out) == (2, "")
    assert f"1 of {len(tau)} values of tau are {words}" in message(err)[0]
    assert "number 7" in message(err)[0]


# ---------------------------------------------------------------- films


def test_a_film_shows_what_changes(motes: Run) -> None:
    status, out, err = motes("render", "drying.json", "--time", "0:10h:5", *QUICK, "--fps", 10, "-o", "drying.gif")
    assert (status, err) == (0, "")
    assert "5 frames" in out
    with Image.open("drying.gif") as film:
        assert (film.n_frames, film.info["duration"]) == (5, 100)  # type: ignore[attr-defined]
        shades = []
        for k in range(5):
            film.seek(k)
            frame = np.array(film.convert("RGB")).astype(int)
            shades.append(frame[-24, 24, 1])
    assert shades == sorted(shades)  # wet paint is darker
    assert shades[-1] > shades[0] + 10
    assert not list(Path().glob("*.frames-*"))


def test_a_film_spans_the_time_that_the_material_has(motes: Run) -> None:
    status, out, _ = motes(
        "render", "drying.json", "--size", 16, "--samples", 1, "--json", "--keep-frames", "-o", "a.mp4"
    )
    assert status == 0
    told = json.loads(out)
    assert (len(told["hours"]), told["hours"][0], told["hours"][-1]) == (48, 0, 10)
    (folder,) = Path().glob("a.frames-*")
    assert len(list(folder.iterdir())) == 48
    assert Path("a.mp4").stat().st_size > 1000
    status, out, _ = motes("render", "drying.json", "--size", 16, "--samples", 1, "--json", "-o", "a.gif")
    assert json.loads(out)["frames_kept"] == 48  # the same frames serve the other format
    assert not folder.exists()


def test_an_interrupted_film_goes_on_where_it_was(motes: Run, tmp_path: Path) -> None:
    arguments = ["render", "drying.json", "--time", "0:10h:400", *map(str, QUICK), "-o", "film.gif"]
    process = subprocess.Popen(
        [sys.executable, "-m", "motes.cli.main", *arguments],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={k: v for k, v in os.environ.items() if k != "MOTES_DEBUG"},
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    deadline = time.monotonic() + SECONDS
    while len(list(tmp_path.glob("film.frames-*/000*.exr"))) < 3:
        assert process.poll() is None
        assert time.monotonic() < deadline
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=SECONDS)
    assert (process.returncode, out) == (130, "")
    assert err.splitlines()[-1] == "interrupted"
    assert "finished frames are kept" in err
    (folder,) = tmp_path.glob("film.frames-*")
    kept = sorted(folder.iterdir())
    assert 3 <= len(kept) < 400
    assert all(p.suffix == ".exr" and p.name[0] == "0" for p in kept)  # no half-written one
    assert not (tmp_path / "film.gif").exists()
    # The same call, with the rest of the frames filled in from the first one so that the test need not wait for them.
    stamps = {p: p.stat().st_mtime_ns for p in kept}
    for k in range(len(kept), 398):
        os.link(kept[0], folder / f"{k:05d}.exr")
    status, out, _ = motes(*arguments)
    assert status == 0
    assert "398 frames were there already" in out
    assert all(p not in stamps for p in folder.glob("*"))
    with Image.open(tmp_path / "film.gif") as film:
        durations = []
        for k in range(film.n_frames):  # type: ignore[attr-defined]
            film.seek(k)
            durations.append(film.info["duration"])
    assert sum(durations) == 400 * 80  # frames that are the same share one picture


# ---------------------------------------------------------------- measured materials


def test_a_measured_material_stands_beside_its_fit(motes: Run, shared: Callable[[str], Path]) -> None:
    silk = shared("data/rgl/vch_silk_blue_rgb.bsdf")
    status, out, err = motes(
        "render", "--compare", silk, "-m", "oren_nayar + torrance_sparrow", "--size", 64, "--samples", 16, "-o", "a.exr"
    )
    assert (status, err) == (0, "")
    assert "fit: oren_nayar + torrance_sparrow" in out
    measured, fitted = np.split(read_radiance(Path("a.exr")), 2, axis=1)
    at = np.s_[26:38, 26:38]
    blue = [shot[at].mean((0, 1)) for shot in (measured, fitted)]
    assert 0.6 < blue[0][2] / blue[1][2] < 1.6
    assert all(b[2] > 2 * b[0] for b in blue)
    status, out, _ = motes("render", "red.json", "--compare", silk, *QUICK, "--json", "-o", "b.png")
    assert (json.loads(out)["materials"], json.loads(out)["columns"]) == (["red"], 2)


# ---------------------------------------------------------------- what is wrong


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ((), "no material was given"),
        (("none.json",), "none.json does not exist"),
        (("red.json", "--scene", "spere"), "'spere' is not a scene"),
        (("red.json", "--scene", "none.ply"), "none.ply does not exist"),
        (("red.json", "--scene", "none.xml"), "none.xml cannot be read"),
        (("red.json", "--scene", "nan.obj"), "position is not finite"),
        (("red.json", "--scene", "flat.obj"), "no triangle with an area"),
        (("red.json", "--env", "none.exr"), "none.exr does not exist"),
        (("red.json", "--env", "red.json"), "red.json"),
        (("red.json", "--time", "noon"), "--time 'noon' is not a time"),
        (("red.json", "--time", "0:1"), "is not FIRST:LAST:COUNT"),
        (("red.json", "--time", "0:1:0"), "asks for 0 frames"),
        (("red.json", "--time", "inf"), "not numbers"),
        (("red.json", "--size", "big"), "--size 'big'"),
        (("red.json", "--size", 0), "0 x 0"),
        (("red.json", "--samples", 0), "0 samples"),
        (("red.json", "--samples", "many"), "many"),
        (("red.json", "--exposure", "nan"), "nan EV"),
        (("red.json", "--tone", "filmic"), "filmic"),
        (("red.json", "--seed", -1), "seed -1"),
        (("red.json", "--set", "noise=0"), "without --deposit"),
        (("red.json", "--wind", "x"), "without --deposit"),
        (("red.json", "--deposit", "--set", "adhesion=2"), "adhesion = 2"),
        (("red.json", "-o", "a.jpg"), "neither a picture nor a film"),
        (("red.json", "-o", "/proc/motes/a.png"), "cannot be written"),
        (("red.json", "-o", "folder.png"), "is a folder"),
        (("red.json", "-o", "a.gif"), "nothing changes with time"),
        (("drying.json", "-o", "a.gif", "--fps", 0), "0 frames a second"),
        (("red.json", "--compare", "red.json"), "neither an RGL nor a MERL"),
        (("--compare", "text.binary"), "text.binary"),
        (("red.json", "--scene", "room.xml", "--size", 9), "--size was given for room.xml"),
        (("red.json", "--scene", "room.xml", "--deposit"), "cannot be deposited"),
    ],
)
def test_what_is_wrong_is_a_sentence_and_a_hint(motes: Run, arguments: tuple[object, ...], words: str) -> None:
    Path("nan.obj").write_text("v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    Path("flat.obj").write_text("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")
    Path("text.binary").write_text("hello")
    Path("folder.png").mkdir()
    Path("room.xml").write_text(XML)
    before = sorted(Path().iterdir())
    quick = [] if {"--size", "--scene"} & {a for a in arguments if isinstance(a, str)} else ["--size", 16]
    output = () if "-o" in arguments else ("-o", "a.png")
    status, out, err = motes("render", *arguments, *quick, *output)
    assert (status, out) == (2, "")
    assert words in message(err)[0]
    assert sorted(Path().iterdir()) == before


@pytest.mark.parametrize(
    ("text", "hours"),
    [
        ("12", [12]),
        ("12h", [12]),
        ("30min", [0.5]),
        ("0,6,24h", [0, 6, 24]),
        ("0,1,2d", [0, 24, 48]),
        ("1h,2d", [1, 48]),
        ("0:2d:3", [0, 24, 48]),
        ("0h:2d:3", [0, 24, 48]),
        ("3600s:2h:2", [1, 2]),
        ("5:9:1", [5]),
    ],
)
def test_times_are_read(text: str, hours: list[float]) -> None:
    assert hours_of(text) == pytest.approx(hours)


@pytest.mark.parametrize("text", ["", ":", "a", "1:2", "1:2:x", "1:2:1000000", "1,,2", "h"])
def test_times_that_are_none_are_explained(text: str) -> None:
    with pytest.raises(MotesError):
        hours_of(text)


def test_without_llvm_the_preview_is_small_and_says_so(tmp_path: Path) -> None:
    RED.save(tmp_path / "red.json")
    # A folder for Python's prefix that has no wheel of LLVM in it, and an environment that names a library that is none.
    script = (
        "import sys; from pathlib import Path\n"
        "from motes.rendering import llvm\n"
        "llvm.candidates = lambda: [Path('/nonexistent/libLLVM.so')]\n"
        "from motes.cli.main import main\n"
        "sys.exit(main(sys.argv[1:]))\n"
    )
    command = [sys.executable, "-c", script, "render", "red.json", "--samples", "1", "--json", "-o", "a.png"]
    run = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=SECONDS)
    assert run.returncode == 0, run.stderr
    assert "small previews only" in run.stderr
    assert "pip install" in run.stderr or "DRJIT_LIBLLVM_PATH" in run.stderr
    assert json.loads(run.stdout)["size"] == [96, 96]
    shown = picture(str(tmp_path / "a.png"))
    assert shown[48, 48, 0] > 1.4 * shown[48, 48, 1]
