"""`motes.exports.export`: every target, moments, and what is refused."""

from __future__ import annotations

import doctest
import importlib
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from catalogue import ENTRIES, Entry
from motes import Material
from motes.ageing import age
from motes.errors import MotesError, ParameterError
from motes.exports import SURFACES, TARGETS, export, targets
from motes.models import BRDF, Sum, registered
from shader_support import MODELS

PAINT = age(Material(MODELS["plaster_and_coat"], name="Wet paint", channels=("R", "G", "B")), "drying_paint", hours=6)
MODELLED = [to for to in TARGETS if to not in ("merl", "csv", "openmaterial")]
RGB = [to for to in TARGETS if to != "openmaterial"]  # which asks for wavelengths


@pytest.mark.parametrize("to", RGB)
def test_a_material_that_changes_says_when(to: str, tmp_path: Path) -> None:
    done = export(PAINT, to, tmp_path / "out", hours=2.5)
    assert all(file.is_file() for file in done.files)
    assert done.files[0] == tmp_path / "out"
    assert any("this is how it is at 2.5 h" in note for note in done.notes)
    if to not in ("merl",):  # which has no room for words
        text = " ".join(done.files[0].read_text(encoding="utf-8", errors="replace").replace("//", "").split())
        assert "(0 to 6 h); this is how it is at 2.5 h" in text


@pytest.mark.parametrize("to", ["glsl", "c", "three", "materialx"])
def test_values_are_those_of_the_moment(to: str, tmp_path: Path) -> None:
    """The number in the file is that of the material at the time."""
    K_s = float(np.asarray(PAINT.at(2.5).parameters["K_s"]))
    assert K_s != pytest.approx(float(np.asarray(PAINT.brdf.parameters["K_s"])), rel=0.05)
    text = "".join(file.read_text(encoding="utf-8") for file in export(PAINT, to, tmp_path / "out", hours=2.5).files)
    assert f"{K_s:.6g}"[:7] in text


def test_the_first_moment_is_the_default(tmp_path: Path) -> None:
    done = export(PAINT, "glsl", tmp_path / "x.glsl")
    assert any("No time was asked for" in note for note in done.notes)
    assert done.files[0].read_text() != export(PAINT, "glsl", tmp_path / "y.glsl", hours=6).files[0].read_text()
    assert any("outside the times" in note for note in export(PAINT, "glsl", tmp_path / "z.glsl", hours=60).notes)


def test_the_name_of_the_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    material = Material(MODELS["grey"], name="Wet 'paint'")
    assert export(material, "hlsl").files == (Path("wet_paint.hlsl"),)
    assert (tmp_path / "wet_paint.hlsl").is_file()


@pytest.mark.parametrize(
    ("material", "to", "options", "says"),
    [
        (PAINT, "obj", {}, "'obj' is nothing that Motes exports to"),
        (PAINT, "wgsl", {"version": "450"}, "wgsl has no option 'version'"),
        (PAINT, "glsl", {"version": "330"}, "'330' is not one of"),
        (PAINT, "c", {"scalar": "half"}, "'half' is not one of"),
        (PAINT, "glsl", {"hours": [1, 2]}, "2 moments, and GLSL ES 3.00 or 4.5 holds one"),
        (PAINT, "csv", {"hours": []}, "0 moments"),
        (PAINT, "csv", {"hours": [1, 1]}, "do not increase"),
        (PAINT, "glsl", {"hours": float("nan")}, "nan h is not finite"),
        (MODELS["dusty"], "glsl", {"hours": 1.0}, "does not change, so 1 h means nothing"),
        ("paint.json", "glsl", {}, "a str is neither a material nor a BRDF"),
    ],
)
def test_refused(material: Any, to: str, options: dict[str, Any], says: str, tmp_path: Path) -> None:
    with pytest.raises(ParameterError, match=says):
        export(material, to, tmp_path / "x", **options)
    assert not list(tmp_path.iterdir())


def test_a_folder_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ParameterError, match="is a folder"):
        export(PAINT, "glsl", tmp_path)


@pytest.mark.parametrize("to", [*TARGETS, *SURFACES])
def test_a_file_of_another_kind_by_its_name_is_refused(to: str, tmp_path: Path) -> None:
    with pytest.raises(ParameterError) as refused:
        export(PAINT, to, tmp_path / "paint.v2.png", hours=2)
    target = targets.target_named(to)
    assert str(refused.value).startswith(f"paint.v2.png is no name for {to}, whose files end in ")
    assert all(suffix in str(refused.value) for suffix in target.suffixes)
    assert f"Write -o paint.v2{target.suffix}" in str(refused.value)
    assert not list(tmp_path.iterdir())


def test_other_suffixes_of_a_language_are_taken(tmp_path: Path) -> None:
    for to, name in (("c", "paint.cuh"), ("glsl", "paint.FRAG"), ("wgsl", "paint")):
        assert export(PAINT, to, tmp_path / name, hours=2).files == (tmp_path / name,)


@pytest.mark.parametrize("to", MODELLED)
def test_nothing_half_written(to: str, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(MotesError, match="cannot be written"):
        export(PAINT, to, tmp_path / "file" / "x")
    assert [p.name for p in tmp_path.iterdir()] == ["file"]


@pytest.mark.parametrize("to", RGB)
def test_the_same_twice(to: str, tmp_path: Path) -> None:
    """Files depend on the material alone."""
    first, second = (export(MODELS["grey"], to, tmp_path / n / "x").files for n in "ab")
    assert [f.read_bytes() for f in first] == [f.read_bytes() for f in second]


def test_every_model_has_a_lobe_and_a_sentence() -> None:
    for cls in registered(BRDF).values():
        own = {name for part in cls.__mro__[: cls.__mro__.index(BRDF)] for name in vars(part)}
        assert {"words", "approximation", "standard_lobes"} <= own, cls
    assert "in_words" in vars(Sum)


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.name)
def test_every_model_goes_to_programs_of_lobes(entry: Entry, tmp_path: Path) -> None:
    """What a model's lobes are computed by has words in OSL and nodes in MaterialX, whatever its options."""
    for to in ("osl", "materialx") if entry.model.channels in (1, 3) else ("osl",):
        assert export(entry.model, to, tmp_path / f"x{targets.TARGETS[to].suffix}").files[0].stat().st_size > 1000


def test_doctest() -> None:
    module = importlib.import_module("motes.exports.targets")
    assert module is targets
    failed, tried = doctest.testmod(module)
    assert tried > 3
    assert failed == 0


def test_importing_is_light() -> None:
    """No library of a target is loaded before it is needed."""
    code = "import sys, motes.exports; print([m for m in ('MaterialX', 'mitsuba', 'llvmlite', 'matplotlib', 'scipy') if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.strip() == "[]"
