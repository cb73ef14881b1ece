"""MaterialX documents: valid for the library, shaders generated from them, and one drawn by its renderer."""

from __future__ import annotations

import shutil
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motes import Material
from motes.errors import DataError, MissingExtraError, MotesError
from motes.exports import export, materialx
from motes.exports.approximation import lobes
from motes.exports.approximation import written as words
from motes.exports.materialx import loaded
from motes.exports.subject import subject
from motes.models import BRDF, Dielectric, Dust, DustLayer, Lambert, Schlick, TorranceSparrow
from shader_runners import checked, tool
from shader_support import COAT, MODELS, PLASTER, SPECTRAL

#: Dust whose lobes take the network of `motes.models.multiple_scattering`, thousands of nodes.
LOBES = {
    **MODELS,
    "dusty_multiple": DustLayer(PLASTER + COAT, Dust((0.9, 0.8, 0.6), 0.3), tau=0.4, scattering="multiple"),
    "dust_multiple": Dust((0.9, 0.8, 0.6), 0.3, scattering="multiple"),
}
NASTY = 'Plaster "1" & <x> -- ünï\n]]> --> \\'


def written(model: BRDF, folder: Path, name: str = "rock") -> Path:
    return export(Material(model, name=name, channels=("R", "G", "B")), "materialx", folder / "rock.mtlx").files[0]


@pytest.mark.parametrize("name", LOBES)
def test_valid_and_generated(name: str, tmp_path: Path) -> None:
    """`check` validates, and generates GLSL, OSL and MDL."""
    pytest.importorskip("MaterialX")
    assert materialx.check(written(LOBES[name], tmp_path))


def test_a_nasty_name(tmp_path: Path) -> None:
    pytest.importorskip("MaterialX")
    path = written(MODELS["dusty"], tmp_path, NASTY)
    materialx.check(path)
    root = ElementTree.parse(path).getroot()
    assert {e.get("name") for e in root.iter("surfacematerial")} == {"plaster_1_x_uni", "plaster_1_x_uni_lobes"}


def generated(path: Path, what: str, element: str | None = None) -> str:
    """The pixel shader of a material, or of a node of that category."""
    mx = pytest.importorskip("MaterialX")
    from MaterialX import (
        PyMaterialXGenGlsl,
        PyMaterialXGenMdl,
        PyMaterialXGenMsl,
        PyMaterialXGenOsl,
        PyMaterialXGenShader,
    )

    modules = {"Glsl": PyMaterialXGenGlsl, "Essl": PyMaterialXGenGlsl, "Osl": PyMaterialXGenOsl}
    modules |= {"Mdl": PyMaterialXGenMdl, "Msl": PyMaterialXGenMsl}
    document, search = loaded(mx, path)
    generator = getattr(modules[what], f"{what}ShaderGenerator").create()
    context = PyMaterialXGenShader.GenContext(generator)
    context.registerSourceCodeSearchPath(search)
    node = document.getNode(element or "rock") or document.addNode(element, "value", "color3")
    return str(generator.generate(node.getName(), node, context).getSourceCode("pixel"))


@pytest.mark.parametrize("what", ["Glsl", "Essl"])
@pytest.mark.parametrize("element", ["rock", "rock_lobes", "motes_rock_value"])
def test_generated_glsl_compiles(what: str, element: str, tmp_path: Path) -> None:
    validator = tool("glslangValidator")
    text = generated(written(MODELS["dusty"], tmp_path), what, element)
    assert ("motes_rock_at(" in text) == (element != "rock_lobes")
    assert ("generalized_schlick_bsdf(" in text) == (element == "rock_lobes")
    (tmp_path / "rock.frag").write_text(text, encoding="utf-8")
    checked(validator, tmp_path / "rock.frag")


@pytest.mark.parametrize(("what", "exact"), [("Msl", True), ("Osl", False), ("Mdl", False)])
def test_other_targets(what: str, exact: bool, tmp_path: Path) -> None:
    """Metal inherits the exact node; closures are standard lobes; the value is exact in OSL."""
    path = written(MODELS["dusty"], tmp_path)
    text = generated(path, what)
    assert ("motes_rock_at(" in text) == exact
    assert ("oren_nayar_diffuse_bsdf(" in text) != exact
    if what == "Osl":
        assert "motes_rock_at(" in generated(path, what, "motes_rock_value")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "material", "tolerance"),
    [("dusty", "rock", 2e-6), ("dusty", "rock_lobes", 0.3), ("eon", "rock_lobes", 1e-5)],
)
def test_drawn_by_materialx(name: str, material: str, tolerance: float, tmp_path: Path) -> None:
    """A square under the sun in MaterialX's renderer: BRDF x cosine x intensity, exactly, and by standard lobes nearly.

    EON is one of the standard lobes, so that MaterialX's own code for it must draw our values.
    """
    pytest.importorskip("MaterialX")
    xvfb = tool("xvfb-run")
    model = MODELS[name]
    path, result = written(model, tmp_path), tmp_path / "result.npz"
    checked(xvfb, "-a", sys.executable, Path(__file__).with_name("materialx_render.py"), path, material, result)
    found = np.load(result)
    side = len(found["colors"])
    x = (2 * np.arange(side) + 1) / side - 1
    place = np.stack([*np.meshgrid(3 / found["scale"] * x, 3 / found["scale"] * x), np.zeros((side, side))], axis=-1)
    wo = found["eye"] - place
    wo /= np.linalg.norm(wo, axis=-1, keepdims=True)
    wi = np.array([0.3, 0.2, 1.0]) / np.linalg.norm([0.3, 0.2, 1.0])
    inside = (np.abs(place) < 0.98).all(axis=-1)
    np.testing.assert_allclose(found["colors"][inside], 2 * (model.eval(wi, wo) * wi[2])[inside], rtol=tolerance)


@pytest.mark.parametrize(
    ("model", "albedo"),
    [
        (Lambert((0.8, 0.5, 0.2)), (0.8, 0.5, 0.2)),
        (TorranceSparrow(0.3, 0.05), 0.3 * np.pi * 0.05**2),
        (TorranceSparrow(0.5, 0.05, "facets"), 0.5),
        (TorranceSparrow(0.5, 0.05, "facets", Dielectric(1.5)), 0.5 * 0.04),
        (TorranceSparrow(0.5, 0.05, "facets", Schlick((0.1, 0.2, 0.3))), (0.05, 0.1, 0.15)),
        (Dust(0.5, 0.0), 0.5 * 2 * (1 - np.log(2)) / 3),
        (DustLayer(Lambert(0.5), Dust(0.0), 0.3), 0.5 * np.exp(-3.32 * 0.3)),
    ],
)
def test_conversions(model: BRDF, albedo: Any) -> None:
    """Reflectances of the lobes, against closed forms."""
    total = sum(lobe.normal for lobe in lobes(model))
    np.testing.assert_allclose(total, np.broadcast_to(albedo, model.channels), rtol=1e-4)


def computed(graph: ElementTree.Element, values: dict[str, Any]) -> list[tuple[Any, Any, Any]]:
    """What the lobes of a node graph get: reflectance at normal and grazing incidence, roughness; its nodes being computed here."""
    nodes: dict[str, Any] = {}
    found = []
    for node in graph:
        given = {}
        for port in node.iter("input"):
            name = port.get("name")
            if port.get("interfacename"):
                given[name] = values.get(port.get("interfacename"))
            elif port.get("nodename"):
                given[name] = nodes[port.get("nodename")]
            elif port.get("type") not in ("string", "boolean"):
                given[name] = np.array([float(x) for x in port.get("value").split(",")])
        if node.tag in ("multiply", "divide", "add", "subtract") and node.get("type") != "BSDF":
            nodes[node.get("name")] = getattr(np, node.tag)(given["in1"], given["in2"])
        elif node.tag in ("max", "min"):
            nodes[node.get("name")] = getattr(np, f"{node.tag}imum")(given["in1"], given["in2"])
        elif node.tag == "ifgreater":
            nodes[node.get("name")] = np.where(given["value1"] > given["value2"], given["in1"], given["in2"])
        elif node.tag in ("exp", "sqrt"):
            nodes[node.get("name")] = getattr(np, node.tag)(given["in"])
        elif node.tag == "convert":
            nodes[node.get("name")] = np.broadcast_to(given["in"], 3)
        elif node.tag == "combine2":
            nodes[node.get("name")] = np.array([float(np.ravel(given[k])[0]) for k in ("in1", "in2")])
        elif node.get("type") == "BSDF":
            nodes[node.get("name")] = None
        if node.tag == "oren_nayar_diffuse_bsdf":
            found.append((given["color"], given["color"], given["roughness"]))
        elif node.tag == "generalized_schlick_bsdf":
            found.append((given["color0"], given["color90"], given["roughness"]))
    return found


@pytest.mark.parametrize("name", LOBES)
def test_three_ways_of_one_conversion(name: str, tmp_path: Path) -> None:
    """The nodes of MaterialX, the words of shaders, and the numbers agree, at other values than those of the file, too."""
    file = LOBES[name]
    root = ElementTree.parse(written(file, tmp_path)).getroot()
    graph = next(g for g in root.iter("nodegraph") if g.get("name") == "NG_motes_rock_lobes")
    others = {"tau": 0.9, "sigma_s": 0.3, "K_s": 0.45, "K_d": 0.35, "w": 0.25}
    model = file.with_parameters({k: v for k, v in others.items() if k in file.parameters})
    parameters = {slot.name: np.asarray(slot.value, float) for slot in model.slots()}
    statements, texts = words(file, ["K_d"], "color")
    # Whoever looks at 53 degrees sees the mean of 1/cos, which the nodes and the numbers take.
    scope: dict[str, Any] = {
        "color": lambda x: x,
        "exp": np.exp,
        "sqrt": np.sqrt,
        "max": np.maximum,
        "min": np.minimum,
        "select": lambda otherwise, then, chosen: np.where(chosen, then, otherwise),
        "wo": (0, 0, 1 / 1.66),
        **parameters,
    }
    for statement in statements:
        if not statement.startswith("//"):
            exec(statement.split(maxsplit=1)[1].removesuffix(";"), scope)
    found = computed(graph, parameters)
    for lobe, text in zip(lobes(model), texts, strict=True):
        # What facets pass on to each other MaterialX gives back itself.
        nodes = (lobe.normal, lobe.grazing, lobe.roughness) if lobe.regained else found.pop(0)
        color, f0 = (eval(word, scope) for word in (text.grazing, text.normal))
        np.testing.assert_allclose(nodes[2], lobe.roughness, rtol=1e-12)
        np.testing.assert_allclose(eval(text.roughness, scope), lobe.roughness, rtol=1e-12)
        for number, node, word in zip((lobe.normal, lobe.grazing), nodes[:2], (color * f0, color), strict=True):
            np.testing.assert_allclose(np.broadcast_to(node, 3), np.broadcast_to(number, 3), rtol=1e-12)
            np.testing.assert_allclose(np.broadcast_to(word, 3), np.broadcast_to(number, 3), rtol=1e-12)
    assert not found


@pytest.mark.parametrize("name", ["torrance_sparrow", "facets_narrow_schlick", "dust_backward", "conductor"])
def test_lobes_keep_the_energy(name: str) -> None:
    """At 30 degrees the model reflects about what its lobe does."""
    model = MODELS[name]
    wi = np.array([0.5, 0, np.sqrt(0.75)])
    total = sum(lobe.normal for lobe in lobes(model))
    np.testing.assert_allclose(total, model.directional_albedo(wi), rtol=0.15)


def test_what_is_lost_is_said(tmp_path: Path) -> None:
    done = export(MODELS["dusty"], "materialx", tmp_path / "x.mtlx")
    text = " ".join(done.files[0].read_text(encoding="utf-8").split())
    assert sorted(f.name for f in done.files) == sorted(p.name for p in tmp_path.iterdir())
    for note in done.notes:
        assert " ".join(note.split()) in text
    assert "exp(-3.32 tau)" in text
    assert "inter-reflection (7)" in text


def test_a_nasty_file_name(tmp_path: Path) -> None:
    pytest.importorskip("MaterialX")
    done = export(MODELS["dusty"], "materialx", tmp_path / 'a "b" & c.v2.mtlx')
    assert done.files[0].name == 'a "b" & c.v2.mtlx'
    assert {file.name[:9] for file in done.files[1:]} == {"a-b-c-v2_"}
    materialx.check(done.files[0])


def test_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(DataError, match="7 channels"):
        export(SPECTRAL, "materialx", tmp_path / "x.mtlx")
    assert not list(tmp_path.iterdir())
    path = written(MODELS["lambert"], tmp_path)
    monkeypatch.setitem(sys.modules, "MaterialX", None)
    with pytest.raises(MissingExtraError, match="MaterialX"):
        materialx.check(path)


def test_an_invalid_document_is_found(tmp_path: Path) -> None:
    pytest.importorskip("MaterialX")
    path = written(MODELS["lambert"], tmp_path)
    path.write_text(path.read_text(encoding="utf-8").replace('type="color3"', 'type="float"'), encoding="utf-8")
    with pytest.raises(MotesError, match="invalid"):
        materialx.check(path)


@pytest.mark.slow
def test_generated_osl_compiles_and_is_right(blender: str, tmp_path: Path) -> None:
    """In Blender; see test_exports_osl."""
    from test_exports_osl import value_in_blender

    mx = pytest.importorskip("MaterialX")
    text = generated(written(MODELS["dusty"], tmp_path), "Osl", "motes_rock_value")
    (tmp_path / "value.osl").write_text(text, encoding="utf-8")
    include = Path(mx.__file__).parent / "libraries" / "stdlib" / "genosl" / "include"
    for file in include.glob("*.h"):
        shutil.copy(file, tmp_path)
    value_in_blender(blender, tmp_path / "value.osl", MODELS["dusty"], "dusty", "out", "light,view")


def test_identifiers() -> None:
    def identifier(name: str) -> str:
        return subject(Material(Lambert(0.5), name=name)).identifier

    assert identifier("Dusty plaster") == "dusty_plaster"
    assert identifier("0.5 mm__ x") == "material_0_5_mm_x"
    assert identifier("***") == "material"
    assert identifier("é" * 200) == "e" * 48
