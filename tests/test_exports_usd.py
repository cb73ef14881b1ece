"""USD: read back and validated by usd-core, its nodes held against MaterialX's definitions, drawn by Storm and by Cycles of what Blender imports."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("pxr")
from pxr import Usd, UsdGeom, UsdShade

from motes import Material
from motes.errors import DataError, MotesError, ParameterError
from motes.exports import surface_nodes, surface_over_tau, usd_dust, usd_library
from motes.exports.subject import subject
from motes.exports.surface_fit import SurfaceFit
from motes.exports.surface_over_tau import OverTau, fit_over_tau
from motes.exports.usd_stage import Stage
from motes.exports.usd_surfaces import over_dust, preview, preview_values, previewed
from motes.fitting.conversion import Conversion
from motes.meshes.mesh import Mesh
from motes.meshes.shapes import plane, sphere
from motes.models import Dust, DustLayer, GltfSurface, Lambert, OpenPBR, StandardSurface, Surface
from shader_runners import checked

Run = Callable[..., tuple[int, str, str]]
SIDE = 64
DUSTY = DustLayer(Lambert((0.6, 0.3, 0.1)), Dust((0.95, 0.85, 0.6), 0.2), 0.3)
#: A matte surface alone, whose fits take little time.
MATTE = (
    "openpbr(base_metalness=0, specular_weight=0, specular_color=1, specular_roughness=0.3, specular_ior=1.5, "
    "fuzz_weight=0, fuzz_color=1, fuzz_roughness=0.5)"
)


def table(surface: Surface, tau: list[float], **values: list[Any]) -> OverTau:
    """A table of parameters without a fit."""
    columns = {name: np.array(each, float) for name, each in values.items()}
    return OverTau(surface, np.array(tau), columns, np.zeros(len(tau)), np.zeros(len(tau) - 1), 0.0)


NODES = table(
    OpenPBR(),
    [0.0, 0.2, 0.5],
    base_color=[[0.6, 0.3, 0.1], [0.5, 0.3, 0.2], [0.5, 0.35, 0.05]],
    base_diffuse_roughness=[0.3, 0.1, 0.0],
    base_metalness=[0.0, 0.0, 0.1],
    specular_weight=[1.0, 1.0, 1.0],
    specular_roughness=[0.5, 0.7, 0.8],
    specular_ior=[1.5, 1.5, 1.9],
    fuzz_weight=[0.0, 0.3, 0.2],
    fuzz_color=[[1.0, 0.8, 0.5]] * 3,
    fuzz_roughness=[0.5, 0.5, 0.6],
)
PLAIN = table(
    GltfSurface(specular=1.0),
    [0.0, 0.5],
    base_color=[[0.6, 0.3, 0.1], [0.55, 0.4, 0.2]],
    metallic=[0.0, 0.1],
    roughness=[0.4, 0.8],
    specular_color=[[1.0] * 3] * 2,
)


def ball() -> tuple[Mesh, np.ndarray]:
    """A sphere, and dust that is thickest on top."""
    mesh = sphere(48)
    return mesh, 0.6 * np.maximum(mesh.normals[:, 1], 0)  # type: ignore[index]


def dusted(path: Path, moments: list[tuple[float, np.ndarray]], monkeypatch: pytest.MonkeyPatch, **more: Any) -> Path:
    """A dusty ball with the tables of above."""
    monkeypatch.setattr(usd_dust, "fit_over_tau", lambda _, kind, *__, **___: NODES if kind is OpenPBR else PLAIN)
    usd_dust.write_usd(path, ball()[0], DUSTY, moments, "tau of dust", **more)
    return path


def errors(path: Path) -> list[str]:
    """What all of usd-core's validators find."""
    validation = pytest.importorskip("pxr.UsdValidation")
    context = validation.ValidationContext(validation.ValidationRegistry().GetOrLoadAllValidators())
    return [f"{e.GetName()}: {e.GetMessage()}" for e in context.Validate(Usd.Stage.Open(str(path)))]


def fitted(model: Surface, hours: float | None = None) -> SurfaceFit:
    """A surface as it is, in the place of a rock whose preview is found."""
    what = replace(subject(Material(Lambert(0.4), name="rock")), hours=hours)
    return SurfaceFit(what, model, Conversion(model, 0.0, 0.0, 0.0), ())


# ---------------------------------------------------------------- the file


@pytest.mark.parametrize("suffix", usd_library.SUFFIXES)
def test_read_back(suffix: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    mesh, tau = ball()
    path = dusted(tmp_path / f"ball{suffix}", [(0.0, 0 * tau), (30.0, 0.5 * tau), (90.0, tau)], monkeypatch)
    assert [file.name for file in tmp_path.iterdir()] == [path.name]
    stage = Usd.Stage.Open(str(path))
    assert UsdGeom.GetStageUpAxis(stage) == "Y"
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    assert (stage.GetStartTimeCode(), stage.GetEndTimeCode()) == (0, 90)
    assert stage.GetDefaultPrim().GetName() == "sphere"
    made = UsdGeom.Mesh(stage.GetPrimAtPath("/sphere/mesh"))
    used = np.unique(mesh.triangles)
    np.testing.assert_allclose(made.GetPointsAttr().Get(), mesh.positions[used], atol=1e-6)
    corners = np.array(made.GetPointsAttr().Get())[np.array(made.GetFaceVertexIndicesAttr().Get())]
    np.testing.assert_allclose(corners, mesh.positions[mesh.triangles.ravel()], atol=1e-6)
    np.testing.assert_allclose(made.GetNormalsAttr().Get(), mesh.normals[used], atol=1e-6)  # type: ignore[index]
    primvars = UsdGeom.PrimvarsAPI(made)
    for frame, share in ((0, 0.0), (30, 0.5), (90, 1.0)):
        np.testing.assert_allclose(primvars.GetPrimvar("tau").Get(frame), share * tau[used], atol=1e-6)
    look = preview_values(PLAIN.at(tau[used]))
    np.testing.assert_allclose(primvars.GetPrimvar("displayColor").Get(90), look["diffuseColor"], atol=1e-6)
    np.testing.assert_allclose(primvars.GetPrimvar("motes_ior").Get(90), 1.5, atol=1e-6)  # of a reflectance of 0.04
    assert primvars.GetPrimvar("tau").GetInterpolation() == "vertex"
    if suffix == ".usda":
        text = path.read_text()
        assert text.startswith("#usda 1.0")
        assert "what lies under the dust is as on day 90" in text


def test_usd_core_validates(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is left but that usd-core does not know MaterialX; what follows looks at its nodes."""
    path = dusted(tmp_path / "ball.usdz", [(0.0, 0 * ball()[1]), (9.0, ball()[1])], monkeypatch)
    others = [error for error in errors(path) if "shaderId 'ND_" not in error]
    assert not others
    stage = Usd.Stage.Open(str(dusted(tmp_path / "ball.usda", [(0.0, ball()[1])], monkeypatch)))
    stage.GetPrimAtPath("/sphere/mesh").GetAttribute("faceVertexIndices").Set([0, 1, 10**6])
    UsdShade.Shader(stage.GetPrimAtPath("/sphere/Looks/dusty/preview")).CreateIdAttr("UsdNoSurface")
    stage.GetRootLayer().Export(str(tmp_path / "broken.usda"))
    assert [error for error in errors(tmp_path / "broken.usda") if "UsdNoSurface" in error]


TYPES = {"color3f": "color3", "float": "float", "bool": "boolean", "string": "string", "token": "surfaceshader"}


def test_its_nodes_are_materialxs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    mx = pytest.importorskip("MaterialX")
    library = mx.createDocument()
    mx.loadLibraries(mx.getDefaultDataLibraryFolders(), mx.getDefaultDataSearchPath(), library)
    files = [dusted(tmp_path / "ball.usda", [(0.0, ball()[1])], monkeypatch)]
    files += [
        surface_nodes.write([fitted(m)], tmp_path / f"{k}.usda") for k, m in enumerate((OpenPBR(), StandardSurface()))
    ]
    seen = set()
    for path in files:
        stage = Usd.Stage.Open(str(path))
        for prim in stage.Traverse():
            shader = UsdShade.Shader(prim)
            if not shader or not str(shader.GetShaderId()).startswith("ND_"):
                continue
            definition = library.getNodeDef(str(shader.GetShaderId()))
            assert definition is not None, shader.GetShaderId()
            seen.add(str(shader.GetShaderId()))
            for given in shader.GetInputs():
                wanted = definition.getActiveInput(given.GetBaseName())
                assert wanted is not None, given.GetFullName()
                assert TYPES[str(given.GetTypeName())] == wanted.getType(), given.GetFullName()
            assert [TYPES[str(out.GetTypeName())] for out in shader.GetOutputs()] == [definition.getType()]
    assert len(seen) == 6, seen


def test_where_up_is(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    tau = ball()[1]
    z = Usd.Stage.Open(str(dusted(tmp_path / "z.usda", [(0.0, tau)], monkeypatch, up=(0, 0, 1))))
    assert UsdGeom.GetStageUpAxis(z) == "Z"
    path = dusted(tmp_path / "x.usda", [(0.0, tau)], monkeypatch, up=(1, 0, 0))
    stage = Usd.Stage.Open(str(path))  # which prims do not keep
    turned = UsdGeom.Mesh(stage.GetPrimAtPath("/sphere/mesh"))
    points, mesh = np.array(turned.GetPointsAttr().Get()), ball()[0]
    np.testing.assert_allclose(points[:, 1], mesh.positions[np.unique(mesh.triangles), 0], atol=1e-6)
    assert "turned so that y is up" in path.read_text()


def test_a_material_of_several_moments(tmp_path: Path) -> None:
    wet, dry = OpenPBR((0.3, 0.2, 0.1), specular_roughness=0.2), OpenPBR((0.6, 0.4, 0.2), specular_weight=0.0)
    stage = Usd.Stage.Open(str(surface_nodes.write([fitted(wet, 0.0), fitted(dry, 2.0)], tmp_path / "rock.usdc")))
    looks = "/rock_materials/Looks"
    assert {p.GetName() for p in stage.GetPrimAtPath(looks).GetChildren()} == {"rock", "rock_at_0_h", "rock_at_2_h"}
    shader = UsdShade.Shader(stage.GetPrimAtPath(f"{looks}/rock/surface"))
    for frame, model in ((1, wet), (25, dry)):
        np.testing.assert_allclose(shader.GetInput("base_color").Get(frame), model.base_color, rtol=1e-5)
    assert shader.GetInput("specular_weight").Get(25) == 0
    assert shader.GetInput("specular_roughness").Get(25) == pytest.approx(0.2)  # means nothing then
    bound = UsdShade.MaterialBindingAPI(stage.GetPrimAtPath("/rock_materials/rock_at_2_h_sphere"))
    assert bound.ComputeBoundMaterial()[0].GetPath().name == "rock_at_2_h"
    assert stage.GetEndTimeCode() == 25


def test_what_cannot_be_written_is_a_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(MotesError, match="cannot be written"):
        dusted(tmp_path / "file" / "x.usda", [(0.0, ball()[1])], monkeypatch)
    bare = Mesh(plane(2).positions, plane(2).triangles)
    with pytest.raises(MotesError, match="no normals"):
        Stage("x", ["a line"]).mesh("mesh", bare)
    monkeypatch.setitem(sys.modules, "pxr", None)
    with pytest.raises(ImportError, match="writing USD needs the package usd-core"):
        usd_library.library()


# ---------------------------------------------------------------- the fit


def test_parameters_over_dust(monkeypatch: pytest.MonkeyPatch) -> None:
    done: list[int] = []
    monkeypatch.setattr(surface_over_tau, "MOST", 6)
    over = fit_over_tau(DUSTY, OpenPBR, 2.0, texts=(MATTE,), progress=lambda k, *_: done.append(k))
    assert over.tau[0] == 0
    assert over.tau[-1] == 2
    assert len(done) == len(over.tau) <= 6
    np.testing.assert_allclose(over.values["base_color"][0], DUSTY.base.K_d, atol=0.01)
    for k, tau in enumerate(0.5 * (over.tau[1:] + over.tau[:-1])):
        here = over.model(float(tau))
        np.testing.assert_allclose(here.base_color, over.values["base_color"][k : k + 2].mean(axis=0))
        distance = Conversion.between(DUSTY.with_parameters({"tau": float(tau)}), here)
        assert distance.seen == pytest.approx(over.between[k])
        assert distance.relative_rms <= over.relative_rms
    assert over.at([9.0])["base_color"][0] == pytest.approx(over.values["base_color"][-1])
    assert f"{len(over.tau)} thicknesses" in over.said()
    clean = fit_over_tau(DUSTY, OpenPBR, 0.0, texts=(MATTE,))
    assert "without dust" in clean.said()
    assert [node.name for node in over_dust("OpenPBR", clean)] == ["dust", "surface"]


def test_a_preview_has_no_colour_of_highlights() -> None:
    found = previewed(GltfSurface(0.5, specular_color=(1.0, 2.0, 3.0)))
    values = preview_values({name: np.asarray(v) for name, v in found.written().items()})
    assert values["ior"] == pytest.approx((1 + np.sqrt(0.08)) / (1 - np.sqrt(0.08)))
    assert [node.definition for node in preview(values)] == ["UsdPreviewSurface"]


def test_what_has_no_dust_or_no_colours_is_refused() -> None:
    with pytest.raises(ParameterError, match="no layer of dust"):
        fit_over_tau(Lambert(0.5), OpenPBR, 1.0)
    with pytest.raises(DataError, match="7 channels"):
        fit_over_tau(DustLayer(Lambert(np.linspace(0.1, 0.7, 7)), Dust()), OpenPBR, 1.0)


# ---------------------------------------------------------------- programs


@pytest.mark.slow
def test_drawn_by_storm_and_imported_by_blender(blender: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A dusty ball on the last of its days: the nodes, and the preview, are what the tables say; with MaterialX at hand no validator finds anything."""
    moderngl = pytest.importorskip("moderngl")
    monkeypatch.setenv("EGL_PLATFORM", "surfaceless")
    path = dusted(tmp_path / "ball.usda", [(0.0, 0 * ball()[1]), (8.0, ball()[1])], monkeypatch)
    packages, result = Path(moderngl.__file__).parents[1], tmp_path / "result.npz"
    script = Path(__file__).with_name("usd_in_programs.py")
    checked(blender, script, path, result, str(SIDE), packages, "/sphere/Looks/dusty", "/sphere/mesh")
    found = np.load(result)
    assert found["validators"].tolist() == []
    x, y = np.meshgrid(*[(2 * np.arange(SIDE) + 1) / SIDE - 1] * 2)
    normal = np.stack([x, y, np.sqrt(np.maximum(1 - x**2 - y**2, 0))], axis=-1)
    seen = (x**2 + y**2 < 0.85) & (normal @ found["sun"] > 0.2)
    limits = {"storm_mtlx": (NODES, 0.004, 0.01), "storm_preview": (PLAIN, 0.01, 0.06), "cycles": (PLAIN, 0.01, 0.05)}
    for name, (over, middle, most) in limits.items():
        off = found[name][..., :3][seen] / expected(over, normal[seen], found["sun"]) - 1
        assert np.abs(np.median(off, axis=0)).max() < middle, (name, np.median(off, axis=0))
        assert np.quantile(np.abs(off), 0.9) < most, (name, np.quantile(np.abs(off), 0.9))
    assert np.abs(found["storm_mtlx"] - found["storm_preview"])[seen].max() > 0.005  # they are two


def expected(over: OverTau, normal: np.ndarray, sun: np.ndarray) -> np.ndarray:
    """What a camera far above sees: BRDF x cosine (N, 3), of a channel for a place."""
    across = np.cross(normal, [0.3, 0.9, 0.1])
    across /= np.linalg.norm(across, axis=-1, keepdims=True)
    along = np.cross(normal, across)
    wi, wo = (np.stack([across @ w, along @ w, normal @ w], axis=-1) for w in (sun, np.array([0.0, 0.0, 1.0])))
    tau = 0.6 * np.maximum(normal[:, 1], 0)
    found = np.empty_like(normal)
    for each in np.unique(tau):  # one a row of the picture
        at = tau == each
        found[at] = over.model(float(each)).eval(wi[at], wo[at]) * wi[at, 2:]
    return found


# ---------------------------------------------------------------- the commands


def test_the_command(motes: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    if find_spec("mitsuba") is None:
        pytest.skip("mitsuba is not installed")
    monkeypatch.setattr(surface_over_tau, "FIRST", 2)
    monkeypatch.setattr(surface_over_tau, "MOST", 2)
    monkeypatch.setattr(usd_dust, "OVER_DUST", (MATTE,))
    write = ("dust", "sphere", "--rays", 16, "--set", "noise=0")
    status, out, err = motes(*write, "--days", "0,50,100", "-o", "ball.usda", "--json")
    assert (status, err) == (0, "")
    told = json.loads(out)
    assert [each["days"] for each in told["moments"]] == [0, 50, 100]
    assert [each["open_tau"] for each in told["moments"]] == pytest.approx([0, 0.25, 0.5])
    assert "MaterialX: Parameters of OpenPBR" in " ".join(told["notes"])
    stage = Usd.Stage.Open("ball.usda")
    tau = UsdGeom.PrimvarsAPI(stage.GetPrimAtPath("/sphere/mesh")).GetPrimvar("tau")
    assert tau.GetTimeSamples() == [0, 50, 100]
    np.testing.assert_allclose(2 * np.array(tau.Get(50)), tau.Get(100), atol=1e-6)
    for days, name, says in (
        ("0,50", "ball.ply", "2 moments"),
        ("5,1", "ball.usda", "do not increase"),
        ("x", "b.usda", "0,30,90"),
    ):
        status, _, err = motes(*write, "--days", days, "-o", name)
        assert status == 2
        assert says in err


def test_export_as_usd(motes: Run) -> None:
    status, out, err = motes("export", "lambert(K_d=0.5)", "--to", "openpbr", "-o", "grey.usda", "--json")
    assert (status, err) == (0, "")
    assert json.loads(out)["files"] == ["grey.usda", "grey_fit.json", "grey_fit.svg"]
    assert not [error for error in errors(Path("grey.usda")) if "shaderId 'ND_" not in error]
    assert "UsdPreviewSurface, for programs without MaterialX: Parameters of" in Path("grey.usda").read_text()
