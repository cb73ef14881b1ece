"""`motes export MAP.zarr --to openpbr` and its like: what the pictures hold, what the documents say, and how far single fits are from the batched ones."""

from __future__ import annotations

import json
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("zarr")

import maps_support as support
from motes import maps
from motes.drawing.colour import srgb_curve
from motes.exports import materialx, texel_surface, texture_documents, texture_files, texture_gltf
from motes.exports.texel_planes import between
from motes.exports.texel_surface import TexelSurfaces, fit_texels
from motes.exports.texture_export import export_textures
from motes.exports.texture_normals import normal_map
from motes.exports.texture_sets import CORE, Layout, TextureSet
from motes.fitting.conversion import Conversion, convert
from motes.images import exr, png_writing
from motes.images.transfer_functions import srgb_decode
from motes.maps.simulated import drying_surface
from motes.models import GltfSurface, OpenPBR, OrenNayar, Principled, StandardSurface, Surface, TorranceSparrow
from shader_runners import checked
from test_cli_maps import refused
from test_gltf import validated

Run = Callable[..., tuple[int, str, str]]
SIDE = 12
MODEL = OrenNayar() + TorranceSparrow()


@pytest.fixture(scope="module", autouse=True)
def few() -> Iterator[None]:
    """Few texels are fitted singly, which takes most of the time of a small map."""
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(texel_surface, "FIRST", 3)
        patched.setattr(texel_surface, "HELD_OUT", 3)
        yield


@pytest.fixture(scope="module")
def values() -> dict[str, np.ndarray]:
    """The parameters of the small surface, texels row by row."""
    y, x = np.meshgrid(*2 * [np.linspace(0, 1, SIDE)], indexing="ij")
    return {name: v.reshape(SIDE * SIDE, *v.shape[2:]) for name, v in drying_surface(y, x, np.array(2.0)).items()}


@pytest.fixture(scope="module")
def surfaces(values: dict[str, np.ndarray]) -> TexelSurfaces:
    return fit_texels(MODEL, values, OpenPBR, OpenPBR.candidates[:1])


@pytest.fixture(scope="module")
def fitted(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A fitted map, two of its texels without a fit, and one at its first scan only."""
    folder = tmp_path_factory.mktemp("textures")
    stack = maps.simulate_map(folder / "paint.zarr", (SIDE, SIDE), times=2, lights=8, chunk=SIDE)
    values_ = support.values_of(stack.path)
    values_[3, 4] = np.nan
    values_[0, 0] = np.nan
    values_[9, 5, 0] = np.nan
    return maps.fit_map(stack.path, support.MODEL, out=folder / "fitted.zarr").path


def read(path: Path) -> np.ndarray:
    """A picture as numbers of [0, 1], by another library than the one that wrote it."""
    from PIL import Image

    with Image.open(path) as picture:
        codes = np.asarray(picture)
    return codes / (65535 if codes.dtype.itemsize > 1 else 255)


def sets_of(kind: type[Surface], to: str, **grids: np.ndarray) -> TextureSet:
    """A set of given values, all other parameters as they are by default."""
    shape = next(iter(grids.values())).shape[:2]
    every = {}
    for slot in kind().slots():
        wide = (*shape, 3) if slot.parameter.per_channel else shape
        every[slot.name] = np.broadcast_to(grids.get(slot.name, slot.value), wide).astype(float)
    layout = Layout.of(to, kind)
    textures, constants = layout.textures(kind, every)
    return TextureSet("rock", None, textures, constants)


@pytest.fixture
def grids() -> dict[str, np.ndarray]:
    rng = np.random.default_rng(7)
    return {"base_color": rng.random((5, 7, 3)), "rough": rng.random((5, 7)), "index": 1 + 2 * rng.random((5, 7))}


# ------------------------------------------------------------ the fit


def test_texels_are_as_near_as_single_fits(values: dict[str, np.ndarray], surfaces: TexelSurfaces) -> None:
    """At texels that no single fit was made of before, and with what `motes export` of one material would find."""
    assert surfaces.found.all()
    assert len(surfaces.compared) == 3
    assert surfaces.added == max(batched - single for _, single, batched in surfaces.compared)
    for row, single, batched in surfaces.compared:
        exact = MODEL.with_parameters({name: v[row] for name, v in values.items()})
        alone = convert(exact, OpenPBR.candidates[0], loss="cube_root").brdf
        assert isinstance(alone, Surface)
        assert Conversion.between(exact, alone.canonical()).seen == pytest.approx(single, rel=1e-6)
        assert batched < 1.05 * single
        own = {name: v[row] for name, v in surfaces.values.items()}
        np.testing.assert_allclose(own["base_color"], alone.parameters["base_color"], rtol=0.06)
        np.testing.assert_allclose(own["specular_roughness"], alone.parameters["specular_roughness"], atol=0.04)
        there = Conversion.between(exact, OpenPBR().with_parameters(own))
        assert surfaces.seen[row] == pytest.approx(there.seen, rel=0.25)
        assert surfaces.relative_rms[row] == pytest.approx(there.relative_rms, rel=0.25)


def test_planes_between_texels(
    values: dict[str, np.ndarray], surfaces: TexelSurfaces, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With planes between 60 of 144 texels all are about as near; one that is unlike its neighbours is fitted."""
    monkeypatch.setattr(texel_surface, "NODES", 60)
    monkeypatch.setattr(texel_surface, "HELD_OUT", 0)
    nodes = texel_surface._some(SIDE * SIDE)
    odd = next(k for k in range(60, 100) if k not in nodes)
    changed = {name: v.copy() for name, v in values.items()}
    changed["K_d"][odd], changed["K_s"][odd] = changed["K_d"][odd][::-1], 0.9
    found = fit_texels(MODEL, changed, OpenPBR, OpenPBR.candidates[:1])
    assert 60 < found.fits < 140

    def off(of: TexelSurfaces, k: int) -> float:
        exact = MODEL.with_parameters({name: v[k] for name, v in changed.items()})
        return Conversion.between(exact, OpenPBR().with_parameters({name: v[k] for name, v in of.values.items()})).seen

    for k in [k for k in range(3, SIDE * SIDE, 35) if k not in nodes]:
        assert off(found, k) < 1.1 * off(surfaces, k)
    exact = MODEL.with_parameters({name: v[odd] for name, v in changed.items()})
    alone = convert(exact, OpenPBR.candidates[0], loss="cube_root").brdf
    assert isinstance(alone, Surface)
    assert off(found, odd) < 1.15 * Conversion.between(exact, alone.canonical()).seen


def test_planes_go_through_what_is_linear() -> None:
    rng = np.random.default_rng(4)
    nodes, points = rng.random((200, 3)), rng.random((50, 3))
    slope = rng.normal(size=(3, 2))
    found = between(points, nodes, 1 + nodes @ slope, np.full(200, 7.0))
    np.testing.assert_allclose(found.values, 1 + points @ slope, atol=0.02)
    np.testing.assert_allclose(found.known, 7.0)


def test_parameters_of_texels_are_what_the_program_has() -> None:
    """`admissible` on arrays is what `canonical` is of one surface."""
    rng = np.random.default_rng(3)
    for kind, names in (
        (OpenPBR, {"specular_weight": 8.0}),
        (Principled, {"specular_ior_level": 4.0, "sheen_weight": 0.9, "sheen_tint": 0.9}),
        (GltfSurface, {"sheen_weight": 0.9, "sheen_tint": 0.9}),
        (StandardSurface, {}),
    ):
        many = {}
        for slot in kind().slots():
            wide = (20, 3) if slot.parameter.per_channel else (20,)
            many[slot.name] = np.broadcast_to(slot.value, wide).astype(float)
            if slot.name in names:
                many[slot.name] = names[slot.name] * rng.random(wide)
        found = kind.admissible(many)
        for k in range(20):
            one = kind().with_parameters({name: v[k] for name, v in many.items()}).canonical()
            for name, value in one.parameters.items():
                np.testing.assert_allclose(found[name][k], value, rtol=1e-12, err_msg=name)


# ------------------------------------------------------------ pictures


@pytest.mark.parametrize("bits", [8, 16])
def test_pictures_hold_the_parameters(bits: int, grids: dict[str, np.ndarray], tmp_path: Path) -> None:
    """To half a code; indices above 1 are OpenEXR, and exact."""
    pytest.importorskip("OpenImageIO")
    colour, rough, index = grids.values()
    one = sets_of(OpenPBR, "openpbr", base_color=colour, specular_roughness=rough, specular_ior=index)
    made = texture_files.pictures([one], tmp_path, bits)
    names = ["rock_base_color.png", "rock_specular_roughness.png", "rock_specular_ior.exr"]
    assert [file.name for file in made] == names
    codes, half = 2**bits - 1, 0.5001 / (2**bits - 1)
    if bits == 8:  # Pillow has no RGB of 16 bits
        np.testing.assert_allclose(read(tmp_path / names[0]), srgb_curve(colour), atol=half)
        assert np.abs(srgb_decode(read(tmp_path / names[0])) - colour).max() < 0.005
    np.testing.assert_allclose(read(tmp_path / names[1]), rough, atol=half)
    np.testing.assert_array_equal(exr.read_exr(tmp_path / names[2], "a test").values[..., 0], index.astype(np.float32))
    assert one.constants["specular_weight"] == 1.0
    assert "specular_roughness" not in one.constants
    assert codes in (255, 65535)


def test_colours_of_sixteen_bits(grids: dict[str, np.ndarray], tmp_path: Path) -> None:
    oiio = pytest.importorskip("OpenImageIO")
    one = sets_of(OpenPBR, "openpbr", base_color=grids["base_color"])
    (file,) = texture_files.pictures([one], tmp_path, 16)
    found = oiio.ImageBuf(str(file)).get_pixels("uint16") / 65535
    np.testing.assert_allclose(found, srgb_curve(grids["base_color"]), atol=0.5001 / 65535)


def test_channels_of_engines(grids: dict[str, np.ndarray], tmp_path: Path) -> None:
    colour, rough, metal = grids["base_color"], grids["rough"], grids["rough"][::-1]
    given = {"base_color": colour, "roughness": rough, "metallic": metal}
    half = 0.5001 / 255
    for to, base, packed, order in (
        ("orm", "BaseColor", "OcclusionRoughnessMetallic", (1 + 0 * rough, rough, metal)),
        ("unity", "BaseMap", "MaskMap", (metal, 1 + 0 * rough, 0 * rough, 1 - rough)),
        ("gltf", "baseColor", "metallicRoughness", (1 + 0 * rough, rough, metal)),
    ):
        folder = tmp_path / to
        folder.mkdir()
        texture_files.pictures([sets_of(GltfSurface, to, **given)], folder, 8)
        assert sorted(file.name for file in folder.iterdir()) == sorted([f"rock_{base}.png", f"rock_{packed}.png"])
        np.testing.assert_allclose(read(folder / f"rock_{base}.png"), srgb_curve(colour), atol=half)
        np.testing.assert_allclose(read(folder / f"rock_{packed}.png"), np.stack(order, axis=-1), atol=half)


# ------------------------------------------------------------ documents


@pytest.mark.parametrize(("to", "kind"), [("openpbr", OpenPBR), ("standard_surface", StandardSurface)])
def test_materialx_finds_documents_valid(
    to: str, kind: type[Surface], grids: dict[str, np.ndarray], tmp_path: Path
) -> None:
    pytest.importorskip("MaterialX")
    rough = "specular_roughness"
    one = sets_of(kind, to, base_color=grids["base_color"], **{rough: grids["rough"]})
    made = texture_files.document(to, [one], kind, ["about -- it"], {}, "rock_normal.png", tmp_path / "rock")
    materialx.check(made[0])
    root = ElementTree.parse(made[0]).getroot()
    files = {node.get("value"): node.get("colorspace") for node in root.iter("input") if node.get("name") == "file"}
    assert files == {"rock_base_color.png": "srgb_texture", f"rock_{rough}.png": None, "rock_normal.png": None}
    shader = next(node for node in root if node.get("type") == "surfaceshader")
    linked = {node.get("name"): node.get("nodename") for node in shader if node.get("nodename")}
    assert linked["base_color"] == "rock_base_color"
    assert linked[texture_documents.NORMALS[shader.tag]] == "normal_map"
    broken = made[0].read_text().replace('name="base_color" type="color3"', 'name="base_color" type="float"')
    made[0].write_text(broken)
    with pytest.raises(Exception, match="invalid"):
        materialx.check(made[0])


def test_gltf_is_valid(grids: dict[str, np.ndarray], tmp_path: Path) -> None:
    """With all extensions, two moments, and a normal map; what is multiplied comes back to the values."""
    given = {"base_color": grids["base_color"], "roughness": grids["rough"], "specular_color": 4 * grids["base_color"]}
    one = sets_of(GltfSurface, "gltf", **given, sheen_weight=grids["rough"], sheen_tint=grids["base_color"])
    two = TextureSet("later", 2.0, one.textures, one.constants)
    texture_files.pictures([one, two], tmp_path, 8)
    codes = np.full((5, 7, 3), 128, np.uint8)
    (tmp_path / "rock_normal.png").write_bytes(png_writing.encoded(codes))
    (path,) = texture_files.document(
        "gltf", [one, two], GltfSurface, ["about"], {}, "rock_normal.png", tmp_path / "rock"
    )
    found = json.loads(path.read_text())
    specular = found["materials"][0]["extensions"]["KHR_materials_specular"]
    file = found["images"][found["textures"][specular["specularColorTexture"]["index"]]["source"]]["uri"]
    back = srgb_decode(read(tmp_path / file)[..., :3]) * specular["specularColorFactor"]
    np.testing.assert_allclose(back, given["specular_color"], atol=0.02)
    np.testing.assert_allclose(read(tmp_path / file)[..., 3], 1.0)
    assert all((tmp_path / image["uri"]).is_file() for image in found["images"])
    report = validated(path)
    assert report["issues"]["numErrors"] == report["issues"]["numWarnings"] == 0, report["issues"]["messages"]


@pytest.mark.slow
def test_blender_takes_the_pictures(blender: str, grids: dict[str, np.ndarray], tmp_path: Path) -> None:
    given = {"base_color": grids["base_color"], "roughness": grids["rough"], "ior": grids["index"]}
    one = sets_of(Principled, "blender", **given)
    texture_files.pictures([one], tmp_path, 8)
    (tmp_path / "rock_normal.png").write_bytes(png_writing.encoded(np.full((5, 7, 3), 128, np.uint8)))
    (script,) = texture_files.document(
        "blender", [one], Principled, ["about"], {}, "rock_normal.png", tmp_path / "rock"
    )
    look = tmp_path / "look.py"
    look.write_text(LOOK)
    checked(blender, look, script, tmp_path / "result.json")
    found = json.loads((tmp_path / "result.json").read_text())
    assert {socket: (file, space) for socket, (file, space, _) in found.items()} == {
        "Base Color": ("rock_base_color.png", "sRGB"),
        "Roughness": ("rock_roughness.png", "Non-Color"),
        "IOR": ("rock_ior.exr", "Non-Color"),
        "Normal": ("rock_normal.png", "Non-Color"),
    }
    # Blender's first row is the lowest one.
    np.testing.assert_allclose(np.reshape(found["IOR"][2], (5, 7, 4))[::-1, :, 0], grids["index"], rtol=1e-3)


LOOK = """
import json, runpy, sys
import bpy
bpy.ops.wm.read_factory_settings(use_empty=True)
runpy.run_path(sys.argv[1])
tree = bpy.data.materials["rock"].node_tree
found = {}
for link in tree.links:
    source = link.from_node
    if source.bl_idname == "ShaderNodeNormalMap":
        source = source.inputs["Color"].links[0].from_node
    if source.bl_idname == "ShaderNodeTexImage" and link.to_node.bl_idname == "ShaderNodeBsdfPrincipled":
        image = source.image
        found[link.to_socket.name] = (image.name, image.colorspace_settings.name, list(image.pixels))
json.dump(found, open(sys.argv[2], "w"))
"""


# ------------------------------------------------------------ the command


def test_a_map_becomes_textures(motes: Run, fitted: Path) -> None:
    """Values, holes, marks, words and the normal map, once through the command."""
    normal = np.random.default_rng(1).integers(0, 256, (SIDE, SIDE, 3), np.uint8)
    Path("bumps.png").write_bytes(png_writing.encoded(normal))
    status, out, err = motes("export", fitted, "--to", "orm", "-o", "set", "--normal", "bumps.png", "--json")
    assert (status, err) == (0, "")
    found = json.loads(out)
    stem = "set/paint_"
    assert {*found["files"]} == {
        *(f"{stem}{end}" for end in ("fit.json", "fit.svg", "BaseColor.png", "OcclusionRoughnessMetallic.png")),
        f"{stem}fitted.png", f"{stem}normal.png", "set/README.txt",
    }  # fmt: skip
    assert Path(f"{stem}normal.png").read_bytes() == Path("bumps.png").read_bytes()
    (record,) = found["fits"]
    assert record == json.loads(Path(f"{stem}fit.json").read_text())
    assert record["texels"] == {"all": 144, "filled": 2, "bridged": 1, "undetermined": record["texels"]["undetermined"]}
    marks = read(Path(f"{stem}fitted.png"))
    assert [tuple(k) for k in np.argwhere(marks == 0).tolist()] == [(0, 0), (3, 4)]
    assert marks[9, 5] == 128 / 255
    base, packed = read(Path(f"{stem}BaseColor.png")), read(Path(f"{stem}OcclusionRoughnessMetallic.png"))
    assert any(np.array_equal(base[3, 4], base[y, x]) for y, x in ((2, 4), (4, 4), (3, 3), (3, 5)))
    material = maps.open_map(fitted).material(7, 2).at(0.0)  # type: ignore[union-attr]
    alone = convert(material, record["fitted_text"], loss="cube_root").brdf
    assert record["fitted_text"] in CORE
    np.testing.assert_allclose(srgb_decode(base[7, 2]), alone.parameters["base_color"], atol=0.03)
    np.testing.assert_allclose(packed[7, 2, 2], alone.parameters["metallic"], atol=0.03)
    for words in (
        "not measured",
        "this is how it is at 0 h",
        "2 of 144 texels have no fit",
        "DirectX's",
        "relative RMS",
    ):
        assert any(words in note for note in found["notes"]), words
        assert words in Path("set/README.txt").read_text()
    assert {error["worst"] >= error["95 %"] >= error["median"] > 0 for error in record["error"].values()} == {True}
    assert Path(f"{stem}fit.svg").read_text().count("<image") == 6


def test_mitsuba_shows_the_models_own_parameters(motes: Run, fitted: Path) -> None:
    """The BSDF of the file at a place of each quarter of the map, against the material of the texel there."""
    pytest.importorskip("OpenImageIO")
    mi = pytest.importorskip("mitsuba")
    mi.set_variant("scalar_rgb")
    from motes import rendering

    rendering.register()
    assert motes("export", fitted, "--to", "mitsuba", "-o", "set", "--quiet") == (0, "", "")
    text = (
        Path("set/paint.xml")
        .read_text()
        .replace("</scene>", '<shape type="rectangle"><ref id="paint"/></shape></scene>')
    )
    Path("set/shown.xml").write_text(text)
    bsdf = mi.load_file("set/shown.xml").shapes()[0].bsdf()
    found = maps.open_map(fitted)
    wi, wo = np.array([0.3, 0.2, 0.9]), np.array([-0.5, 0.1, 0.8])
    wi, wo = wi / np.linalg.norm(wi), wo / np.linalg.norm(wo)
    for y, x in ((2, 1), (2, 10), (8, 3), (10, 9)):
        si = mi.SurfaceInteraction3f()
        si.wi, si.uv = wi, [(x + 0.5) / SIDE, (y + 0.5) / SIDE]
        shown = np.array(bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(wo))).ravel() / wo[2]
        np.testing.assert_allclose(shown, found.material(y, x).at(0.0).eval(wi, wo), rtol=1e-4)  # type: ignore[union-attr]


def test_green_is_turned(tmp_path: Path) -> None:
    pytest.importorskip("OpenImageIO")
    for kind in (np.uint8, np.uint16):
        codes = np.random.default_rng(2).integers(0, np.iinfo(kind).max, (4, 6, 3), kind)
        path = tmp_path / "n.png"
        path.write_bytes(png_writing.encoded(codes))
        assert normal_map(path, False) == (path.read_bytes(), (4, 6))
        turned = codes.copy()
        turned[..., 1] = np.iinfo(kind).max - turned[..., 1]
        assert normal_map(path, True)[0] == png_writing.encoded(turned)


def test_what_cannot_be_is_said(motes: Run, fitted: Path, tmp_path: Path) -> None:
    refused(motes("export", fitted, "--to", "glsl"), "material for every texel", "--to openpbr")
    refused(motes("export", fitted.with_name("paint.zarr"), "--to", "orm"), "measured reflectance", "motes fit")
    refused(motes("export", fitted, "--to", "orm", "-o", "set.png"), "set.png is the name of a file", "-o set")
    refused(motes("export", fitted, "--to", "orm", "--flip-green"), "no normal map", "--normal FILE")
    refused(motes("export", fitted, "--to", "orm", "--hours", "2,1"), "2, 1 h do not increase")
    refused(motes("export", fitted, "--to", "orm", "--as", "ggx"), "--as is for one material")
    refused(motes("export", "gold", "--to", "orm"), "orm is a set of textures", "openpbr")
    refused(motes("export", "gold", "--to", "openpbr", "--bits", 16), "--bits, --normal and --flip-green")
    Path("grey.png").write_bytes(png_writing.encoded(np.zeros((2, 2, 1), np.uint8)))
    refused(motes("export", fitted, "--to", "orm", "--normal", "grey.png"), "grey.png is no normal map", "Give a PNG")
    refused(motes("export", fitted, "--to", "orm", "--normal", "none.png"), "none.png")
    found = maps.open_map(fitted)
    with pytest.raises(Exception, match="pictures of 12 bits"):
        export_textures(found, "orm", tmp_path, bits=12)  # type: ignore[arg-type]
    assert texture_gltf.APART > 1
