"""Surfaces of other programs: against MaterialX's own renderer, and what `motes export --to openpbr` and its like fit and say."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from blender_support import version
from catalogue import upper_directions
from motes import Material
from motes.ageing import age
from motes.directions import from_spherical
from motes.errors import DataError, MotesError, ParameterError
from motes.exports import SURFACES, export, surface_blender, surface_gltf, surface_nodes
from motes.exports.subject import subject
from motes.exports.surface_fit import LIGHTINGS, SurfaceFit, by_light, fit_surface
from motes.fitting.conversion import Conversion, convert
from motes.models import (
    BRDF,
    EON,
    Dust,
    DustLayer,
    GltfSurface,
    Lambert,
    OpenPBR,
    OrenNayar,
    Principled,
    StandardSurface,
    Surface,
    TorranceSparrow,
    parse,
    registered,
)
from shader_runners import checked, tool
from test_gltf import validated
from three_support import drawn_gltf

CLAY = Material(OrenNayar((0.7, 0.5, 0.3), 0.4), name="clay", channels=("R", "G", "B"))
#: White surfaces, and the least that they reflect of a white sky; glTF and Standard Surface lose some by their definitions.
WHITE = [
    (OpenPBR(1.0, 0.5, specular_roughness=0.8), 0.97),
    (OpenPBR(1.0, base_metalness=1.0, specular_roughness=0.6), 0.97),
    (OpenPBR(1.0, fuzz_weight=1.0, fuzz_color=1.0), 0.97),
    (StandardSurface(1.0, 0.3), 0.94),
    (StandardSurface(1.0, metalness=1.0, specular_roughness=0.6), 0.97),
    (StandardSurface(1.0, sheen=1.0, sheen_color=1.0), 0.97),
    (GltfSurface(1.0), 0.97),
    (GltfSurface(1.0, metallic=1.0, roughness=0.3), 0.97),
    (GltfSurface(1.0, sheen_weight=1.0, sheen_tint=1.0), 0.9),
    (Principled(1.0, 0.5), 0.97),
    (Principled(1.0, metallic=1.0, roughness=0.8), 0.97),
    (Principled(1.0, sheen_weight=1.0, sheen_tint=1.0), 0.97),
]
DRAWN = {
    "diffuse under facets": OpenPBR((0.8, 0.5, 0.2), 0.4, specular_color=(0.9, 0.6, 0.4), specular_roughness=0.6),
    "fuzz": OpenPBR((0.2, 0.1, 0.1), specular_weight=0.0, fuzz_weight=0.8, fuzz_color=(0.8, 0.7, 0.5)),
    "metal": OpenPBR((0.8, 0.5, 0.2), base_metalness=1.0, specular_color=(0.9, 0.7, 0.5), specular_roughness=0.5),
    "everything": OpenPBR(
        (0.8, 0.5, 0.2), 0.4, 0.3, 3.0, (0.9, 0.7, 0.5), 0.5, fuzz_weight=0.5, fuzz_color=(0.3, 0.5, 0.8)
    ),
    "standard diffuse": StandardSurface((0.8, 0.5, 0.2), 0.4, specular=0.7, specular_roughness=0.6, specular_IOR=1.8),
    "standard sheen": StandardSurface(0.2, specular=0.0, sheen=0.8, sheen_color=(0.8, 0.7, 0.5), sheen_roughness=0.4),
    "standard metal": StandardSurface(
        (0.8, 0.5, 0.2), metalness=1.0, specular_color=(0.9, 0.7, 0.5), specular_roughness=0.5
    ),
}
#: With how far Cycles is from our formula.
IN_CYCLES = {
    "diffuse": (Principled((0.8, 0.5, 0.2), 0.4, specular_ior_level=0.0), 1e-4),
    "gloss": (Principled((0.8, 0.5, 0.2), roughness=0.5), 0.012),
    "tinted": (Principled((0.8, 0.5, 0.2), 0.4, roughness=0.8, ior=2.0, specular_tint=(0.9, 0.6, 0.4)), 0.045),
    "metal": (Principled((0.8, 0.5, 0.2), metallic=1.0, specular_tint=(0.9, 0.7, 0.5), roughness=0.6), 0.002),
    "sheen": (Principled(0.2, specular_ior_level=0.0, sheen_weight=0.8, sheen_tint=(1.0, 0.7, 0.5)), 0.045),
}
#: With how far three.js is, which adds light that facets send to each other, and has a sheen's albedo of its own.
IN_THREE = {
    "gloss": (GltfSurface((0.8, 0.5, 0.2), roughness=0.5), 0.015),
    "strong": (GltfSurface((0.8, 0.5, 0.2), 0.2, 0.6, specular=0.5, specular_color=6.0), 0.02),
    "sheen": (GltfSurface((0.3, 0.2, 0.1), specular=0.0, sheen_weight=0.6, sheen_tint=(1.0, 0.8, 0.6)), 0.08),
}
SURFACE_MODELS = {
    **DRAWN,
    **{n: m for n, (m, _) in IN_CYCLES.items()},
    **{f"{n} in glTF": m for n, (m, _) in IN_THREE.items()},
}


def unfitted(model: Surface, name: str = "rock") -> SurfaceFit:
    """A surface as it is, for writers."""
    what = subject(Material(model, name=name))
    return SurfaceFit(what, model.canonical(), Conversion(model, 0.0, 0.0, 0.0), ())


@pytest.mark.slow
@pytest.mark.parametrize("sun", [(0.3, 0.2, 1.0), (1.0, 0.3, 0.5)], ids=["high", "low"])
@pytest.mark.parametrize("name", DRAWN)
def test_drawn_by_materialx(name: str, sun: tuple[float, float, float], tmp_path: Path) -> None:
    """MaterialX's node draws what our formula says: within 0.4 %, by which its albedo of facets differs from ours.

    No light stands more than 90 degrees from the viewer, where MaterialX 1.39.5 takes the diffuse part for what it is at 90.
    """
    pytest.importorskip("MaterialX")
    xvfb, model = tool("xvfb-run"), DRAWN[name]
    path, result = surface_nodes.write([unfitted(model)], tmp_path / "rock.mtlx"), tmp_path / "result.npz"
    told = ",".join(map(str, sun))
    checked(xvfb, "-a", sys.executable, Path(__file__).with_name("materialx_render.py"), path, "rock", result, told)
    found = np.load(result)
    side = len(found["colors"])
    x = (2 * np.arange(side) + 1) / side - 1
    place = np.stack([*np.meshgrid(3 / found["scale"] * x, 3 / found["scale"] * x), np.zeros((side, side))], axis=-1)
    inside = (np.abs(place) < 0.98).all(axis=-1)
    wo = (found["eye"] - place)[inside]
    wo /= np.linalg.norm(wo, axis=-1, keepdims=True)
    wi = np.array(sun) / np.linalg.norm(sun)
    np.testing.assert_allclose(found["colors"][inside], 2 * model.eval(wi, wo) * wi[2], rtol=0.004)


@pytest.mark.slow
@pytest.mark.parametrize("sun", [(0.3, 0.2, 1.0), (1.5, 0.3, 0.6)], ids=["high", "low"])
@pytest.mark.parametrize("name", IN_CYCLES)
def test_drawn_by_cycles(name: str, sun: tuple[float, float, float], blender: str, tmp_path: Path) -> None:
    """A plane seen at up to 68 degrees, its material made by the script that the export writes."""
    model, tolerance = IN_CYCLES[name]
    if version(blender) < (5, 3):
        model = replace(model, interreflection="coloured")
    script, result = surface_blender.write([unfitted(model)], tmp_path / "rock.py"), tmp_path / "result.npz"
    told = ",".join(map(str, sun))
    checked(blender, Path(__file__).with_name("principled_in_blender.py"), script, "rock", result, told)
    found = np.load(result)["colors"]
    x = np.tan(np.radians(60)) * ((2 * np.arange(len(found)) + 1) / len(found) - 1)
    wo = np.stack([*np.meshgrid(-x, -x), np.ones(found.shape[:2])], axis=-1)
    wo /= np.linalg.norm(wo, axis=-1, keepdims=True)
    wi = np.array(sun) / np.linalg.norm(sun)
    np.testing.assert_allclose(found, np.pi * model.eval(wi, wo) * wi[2], rtol=tolerance)


def test_what_rough_facets_send_each_other() -> None:
    """Without a highlight it is EON; as Blender 5.0 to 5.2 have it, the part reflected several times has the colour once more."""
    wi, wo = upper_directions(64, 3), upper_directions(64, 4)
    color = np.array([0.8, 0.5, 0.2])
    eon = EON(color, 0.7)
    model = Principled(color, 0.7, specular_ior_level=0.0)
    np.testing.assert_allclose(model.eval(wi, wo), eon.eval(wi, wo), rtol=1e-5)
    darker = replace(model, interreflection="coloured").eval(wi, wo)
    single = EON(1e-9, 0.7).eval(wi, wo) / 1e-9 * color  # so dark that nothing comes a second time
    np.testing.assert_allclose(darker, single + color * (eon.eval(wi, wo) - single), rtol=1e-5)
    assert (darker < eon.eval(wi, wo)).all()


@pytest.mark.slow
@pytest.mark.parametrize("name", IN_THREE)
def test_drawn_by_three(name: str, tmp_path: Path) -> None:
    """The sphere of the file in three.js, under a sun from the side, against ours pixel by pixel."""
    model, tolerance = IN_THREE[name]
    path = surface_gltf.write([unfitted(model)], tmp_path / "ball.gltf")
    # A picture so large that three.js adds little roughness for the curvature of a pixel.
    found = drawn_gltf(path, tmp_path, ("OrthographicCamera", [-1, 1, 1, -1, 0.1, 100]), side=400, step=10)
    pixels = np.array(found["pixels"]).reshape(40, 40, 3)
    x, y = np.meshgrid(*2 * [(2 * (10 * np.arange(40) + 5) + 1) / 400 - 1])
    seen = x * x + y * y < 0.85
    normal = np.stack([x, y, np.sqrt(np.where(seen, 1 - x * x - y * y, 1.0))], axis=-1)[seen]
    light, view = np.array([0.6, 0.0, 0.8]), np.array([0.0, 0.0, 1.0])
    side = view - normal * normal[:, 2:]
    side /= np.linalg.norm(side, axis=-1, keepdims=True)
    frame = np.stack([side, np.cross(normal, side), normal], axis=1)
    wi, wo = frame @ light, frame @ view
    lit = wi[:, 2] > 0.1
    wanted = 2 * model.eval(wi, wo) * wi[:, 2:]
    np.testing.assert_allclose(pixels[seen][lit], wanted[lit], rtol=tolerance)


def test_the_khronos_validator_finds_nothing(tmp_path: Path) -> None:
    path = surface_gltf.write([unfitted(model) for model, _ in IN_THREE.values()][:1], tmp_path / "ball.gltf")
    report = validated(path)
    assert report["issues"]["numErrors"] == report["issues"]["numWarnings"] == 0, report["issues"]


def test_white_surfaces_keep_their_light() -> None:
    """A furnace: nothing is made of light, and no more is lost than a surface loses by its definition."""
    for model, least in WHITE:
        assert least < model.spherical_albedo()[0] < 1.012, model


@pytest.mark.parametrize("model", SURFACE_MODELS.values(), ids=list(SURFACE_MODELS))
def test_samples_weigh_what_is_reflected(model: Surface) -> None:
    """The mean weight of samples is the directional albedo, which is integrated in another way."""
    wi = from_spherical(0.9, 0.3)
    weight = model.sample(wi, np.random.default_rng(4).random((40_000, 2))).weight
    error = np.std(weight, axis=0) / np.sqrt(len(weight))
    np.testing.assert_array_less(np.abs(weight.mean(axis=0) - model.directional_albedo(wi)), 5 * error + 2e-4)


def test_texts_know_surfaces_and_lists_do_not() -> None:
    assert isinstance(parse("openpbr(specular_ior=1.4)").model, OpenPBR)
    assert "openpbr" not in registered(BRDF)
    assert registered(Surface, unlisted=True)["openpbr"] is OpenPBR


def test_a_weight_above_one_is_written_as_an_index() -> None:
    model = OpenPBR((0.5, 0.4, 0.3), specular_weight=5.0, specular_roughness=0.4)
    written = model.canonical().written()
    assert written["specular_weight"] == 1.0
    assert written["specular_ior"] == pytest.approx(2.618, abs=1e-3)  # (1 + sqrt 0.2) / (1 - sqrt 0.2)
    same = OpenPBR(**written)
    wi, wo = upper_directions(100, 1), upper_directions(100, 2)
    np.testing.assert_allclose(same.eval(wi, wo), model.eval(wi, wo), rtol=1e-9)


@pytest.mark.parametrize(
    "model",
    [
        GltfSurface((0.3, 0.2, 0.1), sheen_weight=0.8, sheen_tint=(0.5, 0.4, 0.3)),
        Principled((0.3, 0.2, 0.1), sheen_weight=0.8, sheen_tint=(0.5, 0.4, 0.3), specular_ior_level=1.5),
    ],
)
def test_the_tint_of_a_sheen_has_a_full_channel(model: Surface) -> None:
    """Programs cover what lies below by the brightest channel; the light that the sheen itself reflects stays."""
    same = model.canonical()
    assert np.max(same.parameters["sheen_tint"]) == 1.0
    assert same.parameters["sheen_weight"] == pytest.approx(0.4)
    wi, wo = from_spherical(1.4, 0.0), from_spherical(1.45, 0.0)
    black = {"base_color": 0.0, "specular_ior_level" if isinstance(model, Principled) else "specular": 0.0}
    a, b = (m.with_parameters({**black, **({"ior": 1.5} if isinstance(m, Principled) else {})}) for m in (model, same))
    np.testing.assert_allclose(a.eval(wi, wo), b.eval(wi, wo), rtol=1e-6)


def test_what_weighs_nothing_is_not_written() -> None:
    written = OpenPBR(0.5, specular_weight=0.0).written()
    assert set(written) == {
        "base_color",
        "base_diffuse_roughness",
        "base_metalness",
        "specular_weight",
        "specular_ior",
        "fuzz_weight",
    }
    assert written["base_color"] == (0.5, 0.5, 0.5)


def test_errors_by_light() -> None:
    for light in by_light(Lambert(0.8), Lambert(0.6)):
        assert light.energy == pytest.approx(0.75, rel=1e-4)
        assert light.difference == pytest.approx(0.25, rel=1e-4)


def test_what_the_surface_has_is_found() -> None:
    """EON is OpenPBR's own diffuse part: nothing is left but what the facets' absence costs."""
    found = fit_surface(subject(EON((0.8, 0.5, 0.2), 0.4)), OpenPBR)
    written = found.surface.written()
    np.testing.assert_allclose(written["base_color"], (0.8, 0.5, 0.2), atol=2e-3)
    assert written["base_diffuse_roughness"] == pytest.approx(0.4, abs=5e-3)
    assert found.conversion.seen < 2e-3
    assert max(abs(light.energy - 1) for light in found.lights) < 3e-3


def test_fuzz_is_taken_for_dust() -> None:
    """Where it is clearly nearer; and the error is that of an independent integral over the hemisphere."""
    below = OrenNayar((0.3, 0.1, 0.1), 0.3) + TorranceSparrow(0.5, 0.15)
    dusty = DustLayer(below, Dust((0.7, 0.6, 0.5), 0.3), tau=0.4, scattering="multiple")
    found = fit_surface(subject(dusty), OpenPBR)
    assert found.surface.written()["fuzz_weight"] > 0.05
    wi, wo = upper_directions(40_000, 5), upper_directions(40_000, 6)
    both = wi[:, 2:] * wo[:, 2:]
    wanted = dusty.eval(wi, wo) * both
    off = np.sqrt(np.mean((found.surface.eval(wi, wo) * both - wanted) ** 2) / np.mean(wanted**2))
    assert found.conversion.relative_rms == pytest.approx(off, rel=0.2)


def test_a_kind_of_surface_is_never_found_farther_than_one_that_it_contains() -> None:
    """With nothing but its own starts OpenPBR with fuzz ended farther from this material than without."""
    below = OrenNayar((0.3, 0.1, 0.1), 0.3) + TorranceSparrow(0.5, 0.15)
    dusty = DustLayer(below, Dust((0.7, 0.6, 0.5), 0.3), tau=0.4, scattering="multiple")
    bare, fuzzy = OpenPBR.candidates[:2]
    without = convert(dusty, bare, loss="cube_root")
    started = convert(dusty, fuzzy, loss="cube_root", start=without.brdf)
    assert started.seen < 0.95 * without.seen
    held = convert(dusty, bare, loss="cube_root", start=started.brdf)  # what a text holds stays held
    assert held.brdf.parameters["fuzz_weight"] == 0
    assert held.seen < 1.001 * without.seen


def test_files_say_what_was_found(tmp_path: Path) -> None:
    done = export(CLAY, "openpbr", tmp_path / "clay.mtlx")
    document, numbers, picture = done.files
    assert [file.name for file in done.files] == ["clay.mtlx", "clay_fit.json", "clay_fit.svg"]
    (fit,) = json.loads(numbers.read_text(encoding="utf-8"))["moments"]
    assert fit == json.loads(json.dumps(done.fits[0]))
    text = document.read_text(encoding="utf-8")
    assert all(note in text for note in done.notes)
    percent = f"{100 * fit['error']['relative_rms']:.2g} % relative RMS"
    assert percent in done.notes[0]
    root = ElementTree.fromstring(text)
    (shader,) = root.iter("open_pbr_surface")
    given = {port.get("name"): [float(x) for x in port.get("value", "").split(",")] for port in shader}
    assert given.keys() == fit["parameters"].keys()
    for name, value in fit["parameters"].items():
        np.testing.assert_allclose(given[name], np.ravel(value), rtol=1e-4, err_msg=name)
    drawing = ElementTree.fromstring(picture.read_text(encoding="utf-8"))
    assert len(list(drawing.iter("{http://www.w3.org/2000/svg}image"))) == 3 * len(LIGHTINGS)
    assert "http" not in re.sub(r"http://www.w3.org/2000/svg", "", picture.read_text(encoding="utf-8"))


def test_materialx_finds_it_valid(tmp_path: Path) -> None:
    pytest.importorskip("MaterialX")
    from motes.exports import materialx

    assert materialx.check(surface_nodes.write([unfitted(DRAWN["everything"])], tmp_path / "rock.mtlx"))


def test_a_material_for_each_moment(tmp_path: Path) -> None:
    drying = age(CLAY, "drying_surface", hours=4)
    done = export(drying, "openpbr", tmp_path / "clay.mtlx", hours=[0, 2.5])
    root = ElementTree.parse(done.files[0]).getroot()
    assert [e.get("name") for e in root.iter("surfacematerial")] == [
        "clay_drying_surface_at_0_h",
        "clay_drying_surface_at_2_5_h",
    ]
    assert [fit["hours"] for fit in done.fits] == [0, 2.5]
    for fit in done.fits:
        reflected = OpenPBR(**fit["parameters"]).spherical_albedo()
        np.testing.assert_allclose(reflected, drying.at(fit["hours"]).spherical_albedo(), rtol=0.03)
    assert sum("fitted at" in note for note in done.notes) == 2


@pytest.mark.parametrize("to", ["standard_surface", "gltf", "blender"])
def test_the_others_come_near(to: str, tmp_path: Path) -> None:
    """A matte clay: what is left under the sky and at 45 degrees is small, and the file states it."""
    done = export(CLAY, to, tmp_path / f"clay{SURFACES[to][0].suffix}")
    error = done.fits[0]["error"]
    assert error["relative_rms"] < 0.1  # a glint of its own would be far more
    lights = error["by_light"]
    assert lights["sky"]["mean_relative_difference"] < 0.05
    assert lights["45 degrees"]["mean_relative_difference"] < 0.06
    assert all(note.replace("--", "- -") in done.files[0].read_text(encoding="utf-8") for note in done.notes)


@pytest.mark.slow
def test_a_script_keys_each_moment(blender: str, tmp_path: Path) -> None:
    """Blender runs it, and finds the values of the second moment 24 frames later."""
    fits = []
    for hours, roughness in ((0.0, 0.3), (2.0, 0.6)):
        fit = unfitted(Principled((0.4, 0.3, 0.2), roughness=roughness))
        fits.append(replace(fit, what=replace(fit.what, hours=hours)))
    script = surface_blender.write(fits, tmp_path / "rock.py")
    look = (
        "import bpy, runpy, sys\n"
        "runpy.run_path(sys.argv[1])\n"
        "bpy.data.objects['Cube'].data.materials.append(bpy.data.materials['rock'])\n"
        "socket = bpy.data.materials['rock'].node_tree.nodes['Principled BSDF'].inputs['Roughness']\n"
        "for frame in (1, 25):\n"
        "    bpy.context.scene.frame_set(frame)\n"
        "    print('found', round(socket.default_value, 4))\n"
        "print('found', sorted(m.name for m in bpy.data.materials if m.name.startswith('rock')))\n"
    )
    (tmp_path / "look.py").write_text(look, encoding="utf-8")
    said = subprocess.run([blender, str(tmp_path / "look.py"), str(script)], capture_output=True, text=True, check=True)
    assert [line[6:] for line in said.stdout.splitlines() if line.startswith("found")] == [
        "0.3",
        "0.6",
        "['rock', 'rock_at_0_h', 'rock_at_2_h']",
    ]


@pytest.mark.parametrize("to", SURFACES)
def test_refused(to: str, tmp_path: Path) -> None:
    spectral = Material(Lambert(np.linspace(0.1, 0.9, 5)), name="paper")
    with pytest.raises(DataError, match="5 channels"):
        export(spectral, to, tmp_path / "x")
    with pytest.raises(MotesError, match="reflects nothing"):
        export(Lambert(0.0), to, tmp_path / "x")
    with pytest.raises(ParameterError, match="has no option"):
        export(CLAY, to, tmp_path / "x", version="450")
    assert not list(tmp_path.iterdir())
