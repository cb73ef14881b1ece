"""``motes export``."""

from __future__ import annotations

import json
from pathlib import Path
from typing import get_args

import pytest

import motes
from motes import Material
from motes.ageing import age
from motes.cli.export_command import To
from motes.cli.main import USAGE, main
from motes.exports import SURFACES, TARGETS, TEXTURES
from shader_support import MODELS


@pytest.fixture
def dusty(tmp_path: Path) -> Path:
    return Material(MODELS["dusty"], name="Dusty plaster", channels=("R", "G", "B")).save(tmp_path / "dusty.json")


@pytest.fixture
def paint(tmp_path: Path) -> Path:
    whole = Material(MODELS["plaster_and_coat"], name="paint", channels=("R", "G", "B"))
    return age(whole, "drying_paint", hours=6).save(tmp_path / "paint.json")


def test_choices_are_the_targets() -> None:
    assert get_args(To) == (*TARGETS, *SURFACES, *TEXTURES)


@pytest.mark.parametrize("to", [to for to in TARGETS if to not in ("merl", "openmaterial")])
def test_writes_and_says(to: str, dusty: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["export", str(dusty), "--to", to, "-o", str(tmp_path / "new" / "out")]) == 0
    printed = capsys.readouterr().out
    assert str(tmp_path / "new" / "out") in printed
    assert TARGETS[to].title in printed
    assert (tmp_path / "new" / "out").is_file()
    if to == "osl":
        assert "inter-reflection (7) are left out" in printed


def test_time_and_json(paint: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "paint.glsl"
    assert (
        main(["export", str(paint), "--to", "glsl", "-o", str(out), "--hours", "2", "--glsl-version", "450", "--json"])
        == 0
    )
    said = json.loads(capsys.readouterr().out)
    assert said["files"] == [str(out)]
    assert any("at 2 h" in note for note in said["notes"])
    assert "GLSL 4.50" in out.read_text()


def test_a_table_of_several_moments(paint: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "paint.csv"
    assert main(["export", str(paint), "--to", "csv", "-o", str(out), "--hours", "0,1,2.5", "--quiet"]) == 0
    assert capsys.readouterr().out == ""
    assert motes.read(out).times.tolist() == [0, 1, 2.5]


def test_scalar(dusty: Path, tmp_path: Path) -> None:
    assert main(["export", str(dusty), "--to", "c", "-o", str(tmp_path / "x.h"), "--scalar", "float"]) == 0
    assert "const float wi[3]" in (tmp_path / "x.h").read_text()


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["--to", "pdf"], "pdf"),
        ([], "--to"),
        (["--to", "glsl", "--hours", "2"], "does not change"),
        (["--to", "glsl", "--hours", "soon"], "'soon' is not a number"),
        (["--to", "wgsl", "--glsl-version", "450"], "wgsl has no option 'version'"),
        (["--to", "glsl", "-o", "."], "is a folder"),
    ],
)
def test_refused(
    arguments: list[str], says: str, dusty: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(dusty.parent)
    assert main(["export", str(dusty), *arguments]) == USAGE
    error = capsys.readouterr().err
    assert error.startswith("error: ")
    assert says in error
    assert "Traceback" not in error
    assert [p.name for p in dusty.parent.iterdir()] == ["dusty.json"]


def test_measured_data_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "data.csv").write_text("theta_i,theta_r,phi_r,R\n0,0,0,1\n")
    assert main(["export", str(tmp_path / "data.csv"), "--to", "glsl"]) == USAGE
    assert "is not JSON" in capsys.readouterr().err


def test_help(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["export", "--help"]) == 0
    printed = capsys.readouterr().out
    for word in ("materialx", "mitsuba", "--hours", "--output"):
        assert word in printed
