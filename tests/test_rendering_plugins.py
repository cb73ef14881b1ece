"""The plugins' values: the same as Motes', in every kind of variant, from Python and XML, with textures, time and derivatives."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose
from numpy.typing import NDArray

from catalogue import reference, upper_directions
from motes import GGX, Conductor, Dielectric, Dust, DustLayer, Lambert, OrenNayar, Schlick, TorranceSparrow
from motes.directions import HORIZON
from motes.material import Material
from motes.models import BRDF
from motes.rendering import load_mitsuba, load_scene
from motes.trends import Trend
from plugin_support import needs_llvm, rgb, sphere_scene

Description = dict[str, Any]
Floats = NDArray[np.float64]

RED = (0.8, 0.5, 0.2)
WHITE = (0.9, 0.8, 0.7)
CASES: dict[str, tuple[Description, BRDF]] = {
    "defaults": ({"type": "motes_oren_nayar"}, OrenNayar()),
    "lambert": ({"type": "motes_lambert", "K_d": rgb(*RED)}, Lambert(RED)),
    "dust": ({"type": "motes_dust", "w": rgb(*WHITE), "g": 0.4, "form": "brdf"}, Dust(WHITE, 0.4)),
    "oren_nayar": ({"type": "motes_oren_nayar", "K_d": rgb(*RED), "sigma_d": 0.9}, OrenNayar(RED, 0.9)),
    "brighter_than_white": ({"type": "motes_oren_nayar", "K_d": rgb(3.0, 1.2, 0.2)}, OrenNayar((3.0, 1.2, 0.2))),
    "torrance_sparrow": ({"type": "motes_torrance_sparrow", "K_s": 0.8, "sigma_s": 0.05}, TorranceSparrow(0.8, 0.05)),
    "facets": (
        {"type": "motes_torrance_sparrow", "normalization": "facets", "sigma_s": 0.4},
        TorranceSparrow(0.3, 0.4, normalization="facets"),
    ),
    "dielectric": (
        {"type": "motes_torrance_sparrow", "fresnel": "dielectric", "n": 1.33},
        TorranceSparrow(fresnel=Dielectric(1.33)),
    ),
    "conductor": (
        {"type": "motes_torrance_sparrow", "fresnel": "conductor", "n": rgb(0.2, 0.9, 1.1), "k": rgb(3.4, 2.4, 2.1)},
        TorranceSparrow(fresnel=Conductor((0.2, 0.9, 1.1), (3.4, 2.4, 2.1))),
    ),
    "schlick": (
        {"type": "motes_torrance_sparrow", "fresnel": "schlick", "f0": 0.1},
        TorranceSparrow(fresnel=Schlick(0.1)),
    ),
    "compensated": (
        {"type": "motes_ggx", "alpha": 0.6, "fresnel": "schlick", "f0": rgb(*RED), "scattering": "multiple"},
        GGX(alpha=0.6, fresnel=Schlick(RED), scattering="multiple"),
    ),
    "dusty": (
        {"type": "motes_dusty", "K_d": rgb(*RED), "sigma_s": 0.2, "w": rgb(*WHITE), "g": 0.4, "tau": 0.15},
        DustLayer(OrenNayar(RED) + TorranceSparrow(sigma_s=0.2), Dust(WHITE, 0.4), 0.15),
    ),
    "dust_over_diffuse": (
        {"type": "motes_dusty", "base": {"type": "diffuse", "reflectance": rgb(*RED)}, "w": 0.9, "g": -0.6, "tau": 0.4},
        DustLayer(Lambert(RED), Dust(0.9, -0.6), 0.4),
    ),
    "dusty_multiple": (
        {"type": "motes_dusty", "K_d": rgb(*RED), "w": rgb(*WHITE), "g": 0.6, "tau": 0.5, "scattering": "multiple"},
        DustLayer(OrenNayar(RED) + TorranceSparrow(), Dust(WHITE, 0.6), 0.5, "multiple"),
    ),
    "multiple_over_diffuse": (
        {
            "type": "motes_dusty",
            "base": {"type": "diffuse", "reflectance": rgb(*RED)},
            "w": rgb(*WHITE),
            "g": 0.6,
            "tau": 0.7,
            "scattering": "multiple",
        },
        DustLayer(Lambert(RED), Dust(WHITE, 0.6), 0.7, "multiple"),
    ),
    "dust_over_dust": (
        {
            "type": "motes_dusty",
            "base": {"type": "motes_dusty", "base": {"type": "motes_oren_nayar"}, "tau": 0.1},
            "g": 0.5,
        },
        DustLayer(DustLayer(OrenNayar(), Dust(), 0.1), Dust(g=0.5)),
    ),
    "huge_tau": ({"type": "motes_dusty", "tau": 1e30}, DustLayer(OrenNayar() + TorranceSparrow(), Dust(), 1e30)),
    "no_dust": ({"type": "motes_dusty", "tau": 0.0}, DustLayer(OrenNayar() + TorranceSparrow(), Dust(), 0.0)),
}
every_case = pytest.mark.parametrize("name", CASES)


def pairs(n: int) -> tuple[Floats, Floats]:
    """Viewers and lights over the upper hemisphere, also grazing, normal and mutually grazing, as float32 holds them."""
    viewer, light = upper_directions(n, 1), upper_directions(n, 2)
    low = np.array([[np.cos(a), np.sin(a), 2e-3] for a in np.linspace(0, 6, 40)])
    low /= np.linalg.norm(low, axis=1, keepdims=True)
    up = np.array([[0.0, 0.0, 1.0]])
    viewer = np.concatenate([viewer, low, low, np.repeat(up, 2, 0)])
    light = np.concatenate([light, low[::-1], upper_directions(40, 3), up, low[:1]])
    return viewer.astype(np.float32).astype(np.float64), light.astype(np.float32).astype(np.float64)


def evaluate(mi: Any, bsdf: Any, viewer: Floats, light: Floats, *, uv: Any = None, wavelengths: Any = None) -> Floats:
    """`eval` of a BSDF of Mitsuba (n, channels), one pair at a time in scalar variants."""
    import drjit as dr

    def interaction(n: int) -> Any:
        si = dr.zeros(mi.SurfaceInteraction3f, n)
        if wavelengths is not None:
            si.wavelengths = wavelengths
        return si

    context = mi.BSDFContext()
    if mi.variant().startswith("scalar"):
        rows = []
        for k in range(len(viewer)):
            si = interaction(1)
            si.wi = mi.Vector3f(viewer[k].tolist())
            value = bsdf.eval(context, si, mi.Vector3f(light[k].tolist()))
            rows.append(np.array(value, np.float64).reshape(4, 4, -1)[0, 0] if mi.is_polarized else np.array(value))
        return np.stack(rows)
    si = interaction(len(viewer))
    si.wi = mi.Vector3f(viewer.T)
    if uv is not None:
        si.uv = mi.Point2f(uv.T)
    value = bsdf.eval(context, si, mi.Vector3f(light.T))
    return np.array(value[0][0] if mi.is_polarized else value, np.float64).T


def error(value: Floats, expected: Floats) -> float:
    """The largest error, of the value or of 0.01/sr where that is more: as in docs/engine.md."""
    return float(np.max(np.abs(value - expected) / np.maximum(np.abs(expected), 0.01)))


# ---------------------------------------------------------------- Values


@needs_llvm
@every_case
def test_eval_is_that_of_motes_times_the_cosine(name: str) -> None:
    mi = load_mitsuba("llvm_ad_rgb")
    description, model = CASES[name]
    viewer, light = pairs(4000)
    expected = reference(model, light, viewer) * light[:, 2:]
    assert error(evaluate(mi, load_scene(description), viewer, light), expected) < 1e-5


@every_case
def test_the_scalar_variant_says_the_same(name: str) -> None:
    mi = load_mitsuba("scalar_rgb")
    description, model = CASES[name]
    viewer, light = (w[::40] for w in pairs(800))
    expected = reference(model, light, viewer) * light[:, 2:]
    assert error(evaluate(mi, load_scene(description), viewer, light), expected) < 1e-5


@needs_llvm
@every_case
def test_reciprocity(name: str) -> None:
    mi = load_mitsuba("llvm_ad_rgb")
    bsdf = load_scene(CASES[name][0])
    viewer, light = pairs(2000)
    there = evaluate(mi, bsdf, viewer, light) / light[:, 2:]
    back = evaluate(mi, bsdf, light, viewer) / viewer[:, 2:]
    assert error(there, back) < 2e-5


@needs_llvm
@every_case
def test_below_the_horizon_there_is_nothing(name: str) -> None:
    import drjit as dr

    mi = load_mitsuba("llvm_ad_rgb")
    bsdf = load_scene(CASES[name][0])
    up = upper_directions(64, 5)
    down = up * np.array([1, 1, -1])
    for viewer, light in ((up, down), (down, up), (down, down)):
        assert np.all(evaluate(mi, bsdf, viewer, light) == 0)
        si = dr.zeros(mi.SurfaceInteraction3f, 64)
        si.wi = mi.Vector3f(viewer.T)
        assert np.all(np.array(bsdf.pdf(mi.BSDFContext(), si, mi.Vector3f(light.T))) == 0)
    level = up * np.array([1, 1, 0]) + np.array(
        [0, 0, 0.5 * HORIZON]
    )  # above, but what the models count as the horizon
    assert np.all(evaluate(mi, bsdf, level, up) == 0)


@needs_llvm
@every_case
def test_sample_and_eval_and_pdf_are_of_one_mind(name: str) -> None:
    import drjit as dr

    mi = load_mitsuba("llvm_ad_rgb")
    bsdf, context, n = load_scene(CASES[name][0]), mi.BSDFContext(), 4000
    rng = np.random.default_rng(4)
    si = dr.zeros(mi.SurfaceInteraction3f, n)
    si.wi = mi.Vector3f(upper_directions(n, 6).T)
    sample1, sample2 = mi.Float(rng.random(n, np.float32)), mi.Point2f(rng.random((2, n), np.float32))
    bs, weight = bsdf.sample(context, si, sample1, sample2)
    value, pdf = bsdf.eval_pdf(context, si, bs.wo)
    alive = np.array(bs.pdf) > 0
    assert alive.mean() > 0.5
    weight, value, pdf = np.array(weight).T, np.array(value).T, np.array(pdf)
    assert np.all(weight[~alive] == 0)
    assert_allclose(np.array(bs.pdf)[alive], pdf[alive], rtol=1e-5)
    assert_allclose(weight[alive] * pdf[alive, None], value[alive], rtol=1e-4, atol=1e-6)
    assert_allclose(np.linalg.norm(np.array(bs.wo), axis=0), 1, atol=1e-5)
    assert set(np.array(bs.sampled_component).tolist()) <= set(range(bsdf.component_count()))


# ---------------------------------------------------------------- Spectra, polarisation


@needs_llvm
@pytest.mark.parametrize("name", ["oren_nayar", "brighter_than_white", "conductor", "dusty", "dust_over_diffuse"])
def test_spectral_variants_evaluate_each_wavelength(name: str) -> None:
    """The value is that of Motes for the parameters at each wavelength, as Mitsuba makes spectra of colours: no luminance."""
    import drjit as dr

    mi = load_mitsuba("llvm_ad_spectral")
    description, model = CASES[name]
    nm = [420.0, 510.0, 590.0, 680.0]
    viewer, light = pairs(500)
    value = evaluate(mi, load_scene(description), viewer, light, wavelengths=nm)

    def spectrum(color: Any) -> Floats:
        scale = max(1.0, float(np.max(color)))
        si = dr.zeros(mi.SurfaceInteraction3f)
        si.wavelengths = nm
        texture = mi.load_dict({"type": "rgb", "value": (np.asarray(color) / scale).tolist()})
        return np.array(texture.eval(si), np.float64).ravel() * scale

    colors = {slot.name: spectrum(slot.value) for slot in model.slots() if np.ndim(slot.value)}
    assert all(np.ptp(color) > 0.05 for color in colors.values())
    expected = reference(model.with_parameters(colors), light, viewer) * light[:, 2:]
    assert error(value, expected) < 1e-5


@needs_llvm
def test_measured_spectra_are_used_as_they_are(tmp_path: Path) -> None:
    mi = load_mitsuba("llvm_ad_spectral")
    nm = tuple(float(w) for w in range(400, 710, 10))
    K_d = 0.5 + 0.4 * np.sin(np.array(nm) / 40)
    material = Material(OrenNayar(K_d=K_d, sigma_d=0.5), channels=tuple(f"{w:g} nm" for w in nm), wavelengths=nm)
    file = material.save(tmp_path / "spectral.json")
    viewer, light = pairs(200)
    at = [410.0, 505.0, 600.0, 690.0]
    value = evaluate(mi, load_scene({"type": "motes_material", "filename": str(file)}), viewer, light, wavelengths=at)
    expected = reference(OrenNayar(K_d=np.interp(at, nm, K_d), sigma_d=0.5), light, viewer) * light[:, 2:]
    assert error(value, expected) < 1e-5


@pytest.mark.parametrize(
    "variant",
    ["scalar_spectral", "scalar_spectral_polarized"]
    + [
        pytest.param(v, marks=needs_llvm)
        for v in ("llvm_ad_mono", "llvm_ad_mono_polarized", "llvm_ad_spectral_polarized")
    ],
)
@pytest.mark.parametrize(
    "description", [{"type": "motes_dusty"}, {"type": "motes_dusty", "base": {"type": "motes_oren_nayar"}}]
)
def test_other_variants(variant: str, description: Description) -> None:
    """Grey surfaces are grey everywhere; light that is scattered is not polarised."""
    import drjit as dr

    mi = load_mitsuba(variant)
    wavelengths = [420.0, 510.0, 590.0, 680.0] if mi.is_spectral else None
    highlight = TorranceSparrow() if "base" not in description else TorranceSparrow(K_s=0.0)
    model = DustLayer(OrenNayar() + highlight)
    viewer, light = (w[:12] for w in pairs(12))
    bsdf = load_scene(description)
    value = evaluate(mi, bsdf, viewer, light, wavelengths=wavelengths)
    assert error(value, reference(model, light, viewer) * light[:, 2:]) < 1e-5
    si = dr.zeros(mi.SurfaceInteraction3f)
    if mi.is_spectral:
        si.wavelengths = wavelengths
    si.wi = mi.Vector3f(0.6, 0, 0.8)
    bs, weight = bsdf.sample(mi.BSDFContext(), si, mi.Float(0.3), mi.Point2f(0.2, 0.4))
    assert np.isfinite(np.array(weight, np.float64)).all()
    assert float(np.array(bs.pdf).ravel()[0]) > 0


# ---------------------------------------------------------------- Nested BSDFs of Mitsuba


@needs_llvm
def test_a_mirror_under_dust_keeps_its_image_and_loses_light() -> None:
    import drjit as dr

    mi = load_mitsuba("llvm_ad_rgb")
    tau, n = 0.2, 40_000
    bsdf = load_scene({"type": "motes_dusty", "base": {"type": "conductor", "material": "none"}, "tau": tau, "w": 1.0})
    assert bsdf.flags() & mi.BSDFFlags.DeltaReflection
    rng = np.random.default_rng(2)
    si = dr.zeros(mi.SurfaceInteraction3f, n)
    si.wi = mi.Vector3f(0.6, 0.0, 0.8)
    bs, weight = bsdf.sample(
        mi.BSDFContext(), si, mi.Float(rng.random(n, np.float32)), mi.Point2f(rng.random((2, n), np.float32))
    )
    mirrored = np.array(bs.sampled_type) == int(mi.BSDFFlags.DeltaReflection)
    assert_allclose(np.array(bs.wo).T[mirrored], [[-0.6, 0, 0.8]] * mirrored.sum(), atol=1e-6)
    # The chance and the weight together are what the layer lets through, twice: in and out at cos 0.8.
    through = np.exp(-tau * 2 / 0.8)
    weight = np.array(weight).T[:, 0]
    chance = np.array(bs.pdf)[mirrored][0]
    assert_allclose(weight[mirrored] * chance, through, rtol=1e-5)
    assert abs(mirrored.mean() - chance) < 4 * np.sqrt(chance / n)
    # And the rest is the dust, as much as over a black base.
    dust = DustLayer(Lambert(0.0), Dust(w=1.0), tau).directional_albedo(np.array([0.6, 0, 0.8]))[0]
    rest = np.where(mirrored, 0, weight)
    assert abs(rest.mean() - dust) < 4 * rest.std() / np.sqrt(n)


@needs_llvm
def test_light_into_glass_crosses_the_layer_once_and_none_from_inside_to_inside() -> None:
    mi = load_mitsuba("llvm_ad_rgb")
    glass = {"type": "roughdielectric", "alpha": 0.3}
    clear, dusty = load_scene(glass), load_scene({"type": "motes_dusty", "base": glass, "tau": 0.3})
    viewer, light = upper_directions(300, 7), upper_directions(300, 8)
    flip = np.array([1.0, 1.0, -1.0])
    for v, w, depth in (
        (viewer, light * flip, 0.3 / viewer[:, 2:]),
        (viewer * flip, light, 0.3 / light[:, 2:]),
        (viewer * flip, light * flip, np.zeros((300, 1))),
    ):
        bare = evaluate(mi, clear, v, w)
        assert bare.max() > 1e-3
        assert error(evaluate(mi, dusty, v, w), bare * np.exp(-depth)) < 1e-5


@needs_llvm
def test_a_context_can_ask_for_single_parts() -> None:
    mi = load_mitsuba("llvm_ad_rgb")
    viewer, light = pairs(300)
    import drjit as dr

    si = dr.zeros(mi.SurfaceInteraction3f, len(viewer))
    si.wi = mi.Vector3f(viewer.T)
    wo = mi.Vector3f(light.T)
    for description in (CASES["dusty"][0], {"type": "motes_dusty", "base": {"type": "principled"}}):
        bsdf = load_scene(description)
        parts = np.zeros((len(viewer), 3))
        everything = mi.BSDFContext(mi.TransportMode.Radiance, 0x1FF)
        for k in range(bsdf.component_count()):
            context = mi.BSDFContext(mi.TransportMode.Radiance, 0x1FF, k)
            parts += np.array(bsdf.eval(context, si, wo), np.float64).T
        if description["type"] == "motes_dusty" and "base" not in description:
            assert bsdf.component_count() == 3
            assert error(parts, np.array(bsdf.eval(everything, si, wo), np.float64).T) < 1e-5
        nothing = mi.BSDFContext(mi.TransportMode.Radiance, int(mi.BSDFFlags.DeltaTransmission))
        assert np.all(np.array(bsdf.eval(nothing, si, wo)) == 0)
        assert np.all(np.array(bsdf.sample(nothing, si, mi.Float(0.3), mi.Point2f(0.2, 0.7))[1]) == 0)


# ---------------------------------------------------------------- Textures, scenes, time


@needs_llvm
def test_every_parameter_can_be_a_texture() -> None:
    """Each texel has its own value: two of them, looked up by uv."""
    mi = load_mitsuba("llvm_ad_rgb")
    viewer, light = pairs(50)
    left = np.repeat([[0.25, 0.5]], len(viewer), 0)
    right = np.repeat([[0.75, 0.5]], len(viewer), 0)
    model = CASES["dusty"][1]
    for slot in model.slots():
        low, high = slot.parameter.typical
        values = np.array([low + 0.3 * (high - low), low + 0.7 * (high - low)])
        colors = values[None, :, None] * (np.array([1.0, 0.8, 0.6]) if slot.parameter.per_channel else np.ones(1))
        bitmap = {
            "type": "bitmap",
            "data": mi.TensorXf(colors.astype(np.float32)),
            "raw": True,
            "filter_type": "nearest",
        }
        bsdf = load_scene(CASES["dusty"][0] | {slot.name: bitmap})
        for uv, value in ((left, colors[0, 0]), (right, colors[0, 1])):
            given = value if slot.parameter.per_channel else float(value[0])
            expected = reference(model.with_parameters({slot.name: given}), light, viewer) * light[:, 2:]
            assert error(evaluate(mi, bsdf, viewer, light, uv=uv), expected) < 1e-5, slot.name


@needs_llvm
def test_dust_on_the_vertices_of_a_mesh() -> None:
    mi = load_mitsuba("llvm_ad_rgb")
    mesh = mi.Mesh("square", vertex_count=4, face_count=2, has_vertex_texcoords=True)
    parameters = mi.traverse(mesh)
    parameters["vertex_positions"] = [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]
    parameters["faces"] = [0, 1, 2, 0, 2, 3]
    mesh.add_attribute("vertex_tau", 1, [0, 0, 5.0, 5.0])  # dusty above, clean below
    parameters.update()
    mesh.set_bsdf(
        load_scene(
            {
                "type": "motes_dusty",
                "base": {"type": "diffuse", "reflectance": rgb(0.0, 0.0, 0.0)},
                "tau": {"type": "mesh_attribute", "name": "vertex_tau"},
                "w": 1.0,
            }
        )
    )
    view = mi.ScalarTransform4f().look_at(origin=[0, 0, 3], target=[0, 0, 0], up=[0, 1, 0])
    film = {"type": "hdrfilm", "width": 16, "height": 16, "rfilter": {"type": "box"}, "pixel_format": "rgb"}
    scene = load_scene(
        {
            "type": "scene",
            "integrator": {"type": "direct"},
            "sensor": {"type": "perspective", "fov": 35, "to_world": view, "film": film},
            "light": {"type": "constant"},
            "mesh": mesh,
        }
    )
    picture = np.array(mi.render(scene, spp=256))[:, :, 0]
    # Pixel centres on the square, which fills the picture but for a rim of a twentieth.
    y, x = (3 * np.tan(np.deg2rad(17.5)) * c for c in np.meshgrid(*[(np.arange(16) - 7.5) / 8] * 2, indexing="ij"))
    towards = np.stack([-x, -y, 3 + 0 * x], -1)
    towards /= np.linalg.norm(towards, axis=-1, keepdims=True)
    tau = 2.5 * (1 - y)  # from 0 below to 5 above
    expected = DustLayer(Lambert(0.0), Dust(w=1.0), tau).directional_albedo(towards)[..., 0]
    assert_allclose(picture, expected, atol=0.02)  # noise of 256 samples, and curvature within a pixel
    assert_allclose(picture.mean(1), expected.mean(1), atol=5e-3)


XML = """<scene version="3.0.0">
  <integrator type="path"><integer name="max_depth" value="3"/></integrator>
  <sensor type="perspective">
    <transform name="to_world"><lookat origin="0,0,5" target="0,0,0" up="0,1,0"/></transform>
    <film type="hdrfilm"><integer name="width" value="8"/><integer name="height" value="8"/></film>
  </sensor>
  <emitter type="constant"/>
  <shape type="sphere">
    <bsdf type="motes_dusty">
      <float name="tau" value="0.3"/>
      <rgb name="w" value="0.9, 0.8, 0.7"/>
      <bsdf type="plastic"/>
    </bsdf>
  </shape>
  <shape type="sphere">
    <point name="center" x="2" y="0" z="0"/>
    <bsdf type="motes_torrance_sparrow">
      <string name="fresnel" value="dielectric"/>
      <float name="n" value="1.33"/>
    </bsdf>
  </shape>
  <shape type="sphere">
    <point name="center" x="-2" y="0" z="0"/>
    <bsdf type="motes_material"><string name="filename" value="paint.json"/><float name="time" value="1.5"/></bsdf>
  </shape>
</scene>"""


@pytest.fixture
def paint(tmp_path: Path) -> Path:
    """A material that darkens and whose highlight widens, to a file."""
    trends = {
        "K_d": Trend("linear", {"start": [0.8, 0.6, 0.4], "end": [0.4, 0.3, 0.2]}, (0.0, 2.0)),
        "sigma_s": Trend("exponential", {"start": 0.1, "end": 0.4, "time_constant": 1.0}, (0.0, 2.0)),
    }
    brdf = OrenNayar((0.8, 0.6, 0.4), 0.3) + TorranceSparrow(0.3, 0.1)
    return Material(brdf, channels=("R", "G", "B"), trends=trends).save(tmp_path / "paint.json")


@pytest.mark.parametrize("variant", ["scalar_rgb", pytest.param("llvm_ad_spectral", marks=needs_llvm)])
def test_scene_files(paint: Path, variant: str) -> None:
    """From a file, with the material beside it, and rendered."""
    mi = load_mitsuba(variant)
    file = paint.parent / "scene.xml"
    file.write_text(XML)
    picture = np.array(mi.render(load_scene(file), spp=4))
    assert np.isfinite(picture).all()
    assert picture[..., :3].mean() > 0.1


@pytest.mark.parametrize("variant", ["scalar_rgb", pytest.param("llvm_ad_rgb", marks=needs_llvm)])
def test_a_material_at_a_time_and_then_at_another(paint: Path, variant: str) -> None:
    from motes import load

    mi = load_mitsuba(variant)
    viewer, light = (w[:20] for w in pairs(20))
    bsdf = load_scene({"type": "motes_material", "filename": str(paint), "time": 0.7, "sigma_d": 0.5})
    parameters = mi.traverse(bsdf)
    for hours in (0.7, 0.0, 2.0):
        parameters["time.value"] = hours
        parameters.update()
        model = load(paint).at(hours).with_parameters({"sigma_d": 0.5})  # what the scene gives stays
        expected = reference(model, light, viewer) * light[:, 2:]
        assert error(evaluate(mi, bsdf, viewer, light), expected) < 1e-5


@pytest.mark.parametrize("variant", ["scalar_rgb", pytest.param("llvm_ad_rgb", marks=needs_llvm)])
def test_a_material_brighter_than_white(tmp_path: Path, variant: str) -> None:
    """Measurements of unknown scale give such; what mitsuba.traverse shows is the value itself."""
    mi = load_mitsuba(variant)
    model = OrenNayar((3.0, 1.2, 0.2))
    file = Material(model, channels=("R", "G", "B")).save(tmp_path / "bright.json")
    bsdf = load_scene({"type": "motes_material", "filename": str(file)})
    viewer, light = (w[:20] for w in pairs(20))
    assert error(evaluate(mi, bsdf, viewer, light), reference(model, light, viewer) * light[:, 2:]) < 1e-5
    for shown in (bsdf, load_scene({"type": "motes_oren_nayar", "K_d": rgb(3.0, 1.2, 0.2)})):
        assert_allclose(np.array(mi.traverse(shown)["K_d.value"]).ravel(), [3.0, 1.2, 0.2], rtol=1e-6)


# ---------------------------------------------------------------- Derivatives


@needs_llvm
@pytest.mark.parametrize(
    ("case", "count"), [("dusty", 7), ("dust_over_diffuse", 3), ("dusty_multiple", 7), ("multiple_over_diffuse", 3)]
)
def test_gradients_by_every_parameter(case: str, count: int) -> None:
    """Dr.Jit's, in float32, against central differences of Motes in float64."""
    import drjit as dr

    mi = load_mitsuba("llvm_ad_rgb")
    description, model = CASES[case]
    bsdf = load_scene(description)
    viewer, light = (w[:400] for w in pairs(400))
    parameters = mi.traverse(bsdf)
    names = [name for name, _ in parameters if not name.startswith("base")]
    assert len(names) == count
    for name in names:
        dr.enable_grad(parameters[name])
    parameters.update()
    si = dr.zeros(mi.SurfaceInteraction3f, len(viewer))
    si.wi = mi.Vector3f(viewer.T)
    dr.backward(dr.sum(dr.sum(bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(light.T)))))
    for name in names:
        slot = next(s for s in model.slots() if s.name == name.removesuffix(".value"))
        value, step = np.asarray(slot.value, np.float64), 1e-6
        totals = []
        for change in (step, -step):
            changed = reference(model.with_parameters({slot.name: value + change}), light, viewer)
            totals.append(np.sum(changed * light[:, 2:]))
        # The step is made in all channels at once.
        gradient = np.array(parameters[name].grad if hasattr(parameters[name], "grad") else dr.grad(parameters[name]))
        assert_allclose(np.sum(gradient), (totals[0] - totals[1]) / (2 * step), rtol=2e-3), name


@needs_llvm
def test_gradients_are_numbers_at_the_ends_of_the_range() -> None:
    """At tau = 0 too, from where an optimiser may start; and for viewers at normal incidence and at the horizon."""
    import drjit as dr

    mi = load_mitsuba("llvm_ad_rgb")
    bsdf = load_scene({"type": "motes_dusty", "tau": 0.0, "sigma_d": 0.0, "K_s": 0.0, "w": 0.0, "g": 0.0, "K_d": 0.0})
    parameters = mi.traverse(bsdf)
    for name, _ in parameters:
        dr.enable_grad(parameters[name])
    parameters.update()
    viewer, light = pairs(100)
    si = dr.zeros(mi.SurfaceInteraction3f, len(viewer))
    si.wi = mi.Vector3f(viewer.T)
    wo = mi.Vector3f(light.T)
    dr.enable_grad(si.wi)
    value, pdf = bsdf.eval_pdf(mi.BSDFContext(), si, wo)
    dr.backward(dr.sum(dr.sum(value)) + dr.sum(pdf))
    for name, _ in parameters:
        assert np.isfinite(np.array(dr.grad(parameters[name]))).all(), name
    assert abs(np.array(dr.grad(parameters["K_d.value"])).sum()) > 0.01
    assert np.isfinite(np.array(dr.grad(si.wi))).all()


@needs_llvm
def test_gradients_through_a_picture() -> None:
    """Of a rendering by Mitsuba's differentiable integrator, against differences of renderings with the same numbers."""
    import drjit as dr

    mi = load_mitsuba("llvm_ad_rgb")
    base = {"type": "motes_dusty", "tau": 0.3, "K_d": 0.8, "w": 0.3}
    scene = sphere_scene(base, {"type": "prb", "max_depth": 3}, {"type": "constant"}, size=12)
    parameters = mi.traverse(scene)
    key = "sphere.bsdf.tau.value"
    dr.enable_grad(parameters[key])
    parameters.update()
    dr.backward(dr.sum(mi.render(scene, parameters, spp=256, seed=1), axis=None))
    gradient = float(np.array(dr.grad(parameters[key])).ravel()[0])
    totals = []
    for tau in (0.32, 0.28):
        parameters[key] = tau
        parameters.update()
        totals.append(float(np.array(mi.render(scene, spp=1024, seed=2)).sum()))
    assert_allclose(gradient, (totals[0] - totals[1]) / 0.04, rtol=0.05)
