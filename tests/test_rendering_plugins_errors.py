"""Bad input to the plugins: one sentence that names the parameter, its value and its range."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motes.errors import FormatError, MotesError, ParameterError, install_command
from motes.material import Material
from motes.models import Dust, Lambert, OrenNayar
from motes.rendering import load_mitsuba, load_scene, register
from plugin_support import needs_llvm, rgb

DIFFUSE = {"type": "diffuse"}
Description = dict[str, Any]


@pytest.fixture(autouse=True)
def mi() -> Any:
    return load_mitsuba("scalar_rgb")


@pytest.mark.parametrize(
    ("description", "message"),
    [
        ({"type": "motes_dusty", "tau": float("nan")}, "motes_dusty: tau = nan is outside [0, inf)"),
        ({"type": "motes_dusty", "tau": -0.5}, "motes_dusty: tau = -0.5 is outside [0, inf) (optical thickness"),
        ({"type": "motes_dusty", "base": DIFFUSE, "tau": float("inf")}, "tau = inf is outside [0, inf)"),
        ({"type": "motes_dusty", "base": DIFFUSE, "g": 1.0}, "g = 1 is outside (-1, 1)"),
        ({"type": "motes_oren_nayar", "sigma_d": 20.0}, "sigma_d = 20 is outside [0, 1.571] rad"),
        ({"type": "motes_oren_nayar", "K_d": rgb(0.5, -0.1, 0.5)}, "K_d = -0.1 is outside [0, inf)"),
        ({"type": "motes_torrance_sparrow", "sigma_s": 0.0}, "sigma_s = 0 is outside [0.001, 1.571] rad"),
        ({"type": "motes_dusty", "tau": rgb(0.1, 0.2, 0.3)}, "tau is a colour, but one number serves all channels"),
        ({"type": "motes_dusty", "tau": {"type": "rgb", "value": 0.1}}, "tau is a colour"),
        ({"type": "motes_dusty", "tau": DIFFUSE}, "motes_dusty: tau is a BSDF (optical thickness"),
        ({"type": "motes_dusty", "tau": "much"}, "tau is a string"),
        ({"type": "motes_dusty", "tau": True}, "tau is a bool"),
        ({"type": "motes_dusty", "a": DIFFUSE, "b": DIFFUSE}, "motes_dusty has 2 nested BSDFs"),
        ({"type": "motes_dusty", "base": {"type": "mask", "bsdf": DIFFUSE}}, "Put motes_dusty inside the mask"),
        ({"type": "motes_dusty", "base": DIFFUSE, "K_d": 0.5}, "motes_dusty has no parameter 'K_d'"),
        ({"type": "motes_dusty", "scattering": "twice"}, "scattering = 'twice' is not one of single, multiple"),
        ({"type": "motes_dusty", "base": DIFFUSE, "scattering": "twice"}, "scattering = 'twice' is not one of single"),
        (
            {"type": "motes_dusty", "base": DIFFUSE, "scattering": "multiple", "w": 1.2},
            "motes_dusty: w = 1.2 is outside [0, 1]",
        ),
        (
            {"type": "motes_oren_nayar", "sigma": 0.5},
            "motes_oren_nayar has no parameter 'sigma'. Did you mean sigma_d?",
        ),
        (
            {"type": "motes_torrance_sparrow", "fresnel": "metal"},
            "fresnel = 'metal' is not one of dielectric, conductor",
        ),
        ({"type": "motes_torrance_sparrow", "fresnel": 1.5}, "fresnel = 1.5 is not a word"),
        ({"type": "motes_torrance_sparrow", "normalization": "none"}, "normalization = 'none' is not one of printed"),
        ({"type": "motes_dust", "form": "brightness"}, "motes_dust with form = 'brightness' is not reciprocal"),
        ({"type": "motes_torrance_sparrow", "n": 1.5}, "motes_torrance_sparrow has no parameter 'n'"),
        ({"type": "motes_material"}, "motes_material has no filename"),
        ({"type": "motes_material", "filename": "/nowhere/paint.json"}, "paint.json cannot be read: No such file"),
    ],
)
def test_sentences(description: Description, message: str) -> None:
    with pytest.raises(MotesError) as caught:
        load_scene(description)
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)
    assert caught.value.hint or "not one of" in str(caught.value)


# What is refused at different places of a constructor, and one layer whose base is refused.
REFUSED: list[Description] = [
    {"type": "motes_dusty", "tau": -1.0},
    {"type": "motes_dusty", "a": DIFFUSE, "b": DIFFUSE},
    {"type": "motes_dusty", "base": {"type": "motes_oren_nayar", "sigma_d": 9.0}},
    {"type": "motes_oren_nayar", "K_d": -1.0},
    {"type": "motes_oren_nayar", "sigma": 0.5},
    {"type": "motes_material", "filename": "/nowhere/paint.json"},
]
RENDER_AFTER = """
import json, sys
import numpy as np
from motes.rendering import load_mitsuba, load_scene
mi = load_mitsuba("llvm_ad_rgb")
sensor = {"type": "perspective", "film": {"type": "hdrfilm", "width": 4, "height": 4}, "to_world": mi.ScalarTransform4f().translate([0, 0, -5])}
ball = {"type": "sphere", "bsdf": {"type": "motes_oren_nayar", "K_d": 0.5}}
good = {"type": "scene", "integrator": {"type": "path"}, "light": {"type": "constant"}, "ball": ball, "sensor": sensor}
kept = []  # as an interactive interpreter keeps what was raised
for bad in json.loads(sys.argv[1]):
    for load in (load_scene, mi.load_dict):
        try:
            load({**good, "bad": {"type": "sphere", "bsdf": bad}})
        except Exception as error:
            kept.append(error)
        print(float(np.array(mi.render(load_scene(good), spp=4)).mean()))
print(len(kept))
"""


@needs_llvm
def test_what_was_refused_breaks_no_later_render() -> None:
    """Dr.Jit calls every BSDF object of the process that was once made, whole or not: nothing is made before all is read."""
    run = subprocess.run(
        [sys.executable, "-c", RENDER_AFTER, json.dumps(REFUSED)], capture_output=True, text=True, timeout=300
    )
    assert run.returncode == 0, run.stderr
    *means, raised = run.stdout.split()
    assert int(raised) == len(means) == 2 * len(REFUSED)
    assert {float(mean) for mean in means} == {float(means[0])}
    assert 0.3 < float(means[0]) < 1.0


def bitmap(values: Any, **options: Any) -> Description:
    mi = load_mitsuba()
    return {"type": "bitmap", "data": mi.TensorXf(np.asarray(values, np.float32)), **options}


@pytest.mark.parametrize("value", [-0.25, np.nan, np.inf])
def test_one_bad_texel(value: float) -> None:
    texels = np.full((4, 5, 1), 0.3)
    load_scene({"type": "motes_dusty", "tau": bitmap(texels, raw=True)})
    texels[2, 3] = value
    with pytest.raises(ParameterError, match=r"motes_dusty: tau = (-0.25|nan|inf) is outside \[0, inf\)"):
        load_scene({"type": "motes_dusty", "tau": bitmap(texels, raw=True)})


def test_a_texture_that_is_missing(tmp_path: Path) -> None:
    with pytest.raises(MotesError, match=r"nowhere\.png.*No such file") as caught:
        load_scene({"type": "motes_dusty", "tau": {"type": "bitmap", "filename": str(tmp_path / "nowhere.png")}})
    assert "Traceback" not in str(caught.value)


@needs_llvm
def test_pictures_of_the_wrong_kind_in_spectral_variants() -> None:
    """Mitsuba makes spectra of colours, unless the picture is raw: then it is numbers."""
    load_mitsuba("llvm_ad_spectral")
    color = np.full((2, 2, 3), 0.5)
    with pytest.raises(ParameterError, match=r"tau is a picture of the wrong kind.*Set raw to true"):
        load_scene({"type": "motes_dusty", "tau": bitmap(color, raw=False)})
    with pytest.raises(ParameterError, match=r"K_d is a picture of the wrong kind.*Set raw to false"):
        load_scene({"type": "motes_dusty", "K_d": bitmap(color, raw=True)})
    with pytest.raises(ParameterError, match="tau is a colour"):
        load_scene({"type": "motes_dusty", "tau": {"type": "spectrum", "value": [(400, 0.1), (700, 0.2)]}})
    load_scene({"type": "motes_dusty", "K_d": bitmap(color, raw=False)})


@needs_llvm
def test_what_goes_out_of_bounds_later_is_cut_off() -> None:
    """A step of an optimiser, or a texture whose numbers cannot be seen beforehand."""
    import drjit as dr

    mi = load_mitsuba("llvm_ad_rgb")
    bsdf = load_scene({"type": "motes_dusty", "tau": 0.3, "w": 0.9, "g": 0.5, "sigma_s": 0.2})
    parameters = mi.traverse(bsdf)
    si = dr.zeros(mi.SurfaceInteraction3f)
    si.wi = mi.Vector3f(0.6, 0, 0.8)

    def value() -> Any:
        return np.array(bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(0.0, 0.6, 0.8)), np.float64).ravel()

    def at(**values: float) -> Any:
        for name, number in values.items():
            parameters[f"{name}.value"] = number
        parameters.update()
        return value()

    clean = at(tau=0.0)
    assert np.array_equal(at(tau=-0.2), clean)
    assert np.array_equal(at(tau=float("nan")), clean)
    assert np.isfinite(at(tau=float("inf"))).all()
    at(tau=0.3)
    assert np.array_equal(at(g=1.5), at(g=1 - 2e-6))
    at(g=0.5)
    assert np.array_equal(at(sigma_s=-1.0), at(sigma_s=0.001))


def test_materials_that_cannot_be_shown(tmp_path: Path) -> None:
    grey = Material(Lambert(0.5)).save(tmp_path / "grey.json")
    load_scene({"type": "motes_material", "filename": str(grey)})
    with pytest.raises(ParameterError, match="motes_material has no parameter 'tau'"):
        load_scene({"type": "motes_material", "filename": str(grey), "tau": 0.3})
    with pytest.raises(ParameterError, match="a time of nan h is not finite"):
        load_scene({"type": "motes_material", "filename": str(grey), "time": float("nan")})
    with pytest.raises(ParameterError, match="time = 'noon' is not a number of hours"):
        load_scene({"type": "motes_material", "filename": str(grey), "time": "noon"})
    bright = Material(Dust(form="brightness")).save(tmp_path / "bright.json")
    with pytest.raises(ParameterError, match="is not reciprocal"):
        load_scene({"type": "motes_material", "filename": str(bright)})
    five = Material(OrenNayar(K_d=np.linspace(0.1, 0.5, 5)), channels=tuple("ABCDE")).save(tmp_path / "five.json")
    with pytest.raises(ParameterError, match="K_d has 5 channels of unknown wavelengths"):
        load_scene({"type": "motes_material", "filename": str(five)})
    broken = tmp_path / "broken.json"
    broken.write_text(json.dumps({"format": "motes material", "version": 1}))
    with pytest.raises(FormatError, match="the material is incomplete"):
        load_scene({"type": "motes_material", "filename": str(broken)})


def test_mitsuba_s_own_complaints_are_passed_on(tmp_path: Path) -> None:
    for description, message in (
        ({"type": "nonsense"}, "nonsense"),
        ("<scene version='3.0.0'><bsdf type='motes_dusty'><float name='tau' value='x'/></bsdf></scene>", "x"),
        (tmp_path / "nowhere.xml", "nowhere.xml"),
    ):
        with pytest.raises(MotesError, match="Mitsuba cannot load this") as caught:
            load_scene(description)
        assert message in str(caught.value)


def test_variants_that_are_not_there() -> None:
    with pytest.raises(ParameterError, match=r"Mitsuba has no variant 'llvm_fast'. It has .*llvm_ad_rgb"):
        load_mitsuba("llvm_fast")


def test_without_mitsuba_the_command_is_named() -> None:
    """In a process where it cannot be imported."""
    script = """
import sys
sys.modules["mitsuba"] = None
from motes.errors import MissingExtraError
from motes.rendering import load_mitsuba, register
for call in (load_mitsuba, register):
    try:
        call()
    except MissingExtraError as error:
        print(error)
"""
    out = subprocess.check_output([sys.executable, "-c", script], text=True).splitlines()
    told = f"rendering needs the package mitsuba, which is not installed. {install_command('render')}"
    assert out == [told] * 2


def test_registering_twice_does_no_harm(mi: Any) -> None:
    register()
    register()
    assert "motes_oren_nayar" in str(load_scene({"type": "motes_oren_nayar"}))
