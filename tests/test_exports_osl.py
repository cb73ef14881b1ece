"""OSL shaders in Blender's Cycles: the value against NumPy, the closures against the albedo.

They need a Python with the package bpy (5.0 wants numpy < 2, so an environment of its own): set MOTES_BPY to its interpreter, or to several.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from motes import Material
from motes.exports import export, osl
from motes.models import BRDF, Dust, DustLayer
from shader_runners import checked
from shader_support import COAT, MODELS, PLASTER, SPECTRAL, check, directions, expected

SCRIPT = Path(__file__).with_name("osl_in_blender.py")
WI, WO = directions()
MULTIPLE = DustLayer(PLASTER + COAT, Dust((0.9, 0.8, 0.6), 0.3), tau=0.4, scattering="multiple")


def in_blender(python: str, shader: Path, output: str, inputs: str = "Light,View") -> np.ndarray:
    pairs, result = shader.with_suffix(".npz"), shader.with_suffix(".npy")
    np.savez(pairs, wi=WI, wo=WO)
    checked(python, SCRIPT, shader, output, pairs, result, inputs)
    return np.load(result)


def value_in_blender(python: str, shader: Path, model: BRDF, name: str, output: str, inputs: str) -> None:
    check(name, in_blender(python, shader, output, inputs), expected(model, WI, WO))


@pytest.mark.slow
@pytest.mark.parametrize("name", MODELS)
def test_value_against_numpy(name: str, blender: str, tmp_path: Path) -> None:
    shader = export(MODELS[name], "osl", tmp_path / "material.osl").files[0]
    value_in_blender(blender, shader, MODELS[name], name, "Reflectance", "Light,View")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "tolerance"),
    [
        ("lambert", 0.001),
        ("torrance_sparrow", 0.05),
        ("conductor", 0.08),
        ("plaster_and_coat", 0.08),
        ("dusty", 0.1),
        ("dusty_multiple", 0.1),
    ],
)
def test_closures_keep_the_albedo(name: str, tolerance: float, blender: str, tmp_path: Path) -> None:
    """Under a white sky, seen from above."""
    model = MULTIPLE if name == "dusty_multiple" else MODELS[name]
    shader = export(model, "osl", tmp_path / "material.osl").files[0]
    found = in_blender(blender, shader, "BSDF").mean(axis=0)
    albedo = np.broadcast_to(model.directional_albedo((0, 0, 1)), 3)
    np.testing.assert_allclose(found, albedo, rtol=tolerance)


@pytest.mark.slow
def test_a_spectrum_compiles(blender: str, tmp_path: Path) -> None:
    shader = export(SPECTRAL, "osl", tmp_path / "material.osl").files[0]
    code = f"import bpy, _cycles, sys; sys.exit(not _cycles.osl_compile({str(shader)!r}, {str(tmp_path / 'x.oso')!r}))"
    checked(blender, "-c", code)


def test_oslc_accepts_it(tmp_path: Path) -> None:
    oslc = shutil.which("oslc")
    if oslc is None:
        pytest.skip("oslc is not installed")
    shader = export(MODELS["dusty"], "osl", tmp_path / "material.osl").files[0]
    subprocess.run([oslc, "-o", tmp_path / "x.oso", shader], check=True, timeout=60)


def test_what_cannot_be_said_is_said(tmp_path: Path) -> None:
    done = export(Material(MODELS["dusty"], name='a "b"\n*/', channels=("R", "G", "B")), "osl", tmp_path / "x.osl")
    text = done.files[0].read_text(encoding="utf-8")
    flat = " ".join(text.replace("//", "").split())
    assert "a shader never sees the light" in flat
    for note in done.notes[1:]:
        assert note in flat
    assert re.search(r"^shader motes_a_b\(", text, re.MULTILINE)
    assert 'string help = "diffuse reflectance of a facet", float min = 0' in text
    grey = osl.shader(SPECTRAL).source
    assert "There is no closure" in grey
    assert "BSDF" not in grey
    assert "output float Reflectance[7]" in grey
