"""A fitted map through Mitsuba: every texel as its own model says by NumPy, where it lies, when, and where nothing was fitted."""

from __future__ import annotations

import tracemalloc
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

pytest.importorskip("zarr")
from maps_support import fitted_map
from motes.directions import from_spherical
from motes.errors import DataError, MotesError, ParameterError
from motes.maps import FittedMap, moment
from motes.models import parse
from motes.rendering import load_mitsuba, load_scene
from motes.rendering.map_stage import map_stage
from motes.rendering.map_textures import nearest
from motes.rendering.passes import Look
from plugin_support import needs_llvm

pytestmark = needs_llvm
Floats = NDArray[np.float64]
SHAPE = (4, 6)
PIXELS = 8  # along a side of a texel
LOOK = Look(scene="flat", size=(SHAPE[1] * PIXELS, SHAPE[0] * PIXELS), samples=4, lamp_deg=(30.0, 20.0))
LAMP, ABOVE = from_spherical(np.radians(30), np.radians(20)), np.array([0.0, 0.0, 1.0])
#: Widths, of which a point between texels would look like none.
RNG = np.random.default_rng(5)


def spread(low: float, high: float, *tail: int) -> Floats:
    """Values (4, 6, 1[, C]) far from one texel to the next."""
    return RNG.uniform(low, high, (*SHAPE, 1, *tail))


CASES: dict[str, tuple[str, dict[str, Floats], tuple[str, ...]]] = {
    "the paper's": (
        "oren_nayar + torrance_sparrow",
        {
            "K_d": spread(0.02, 0.9, 3),
            "sigma_d": spread(0, 1.2),
            "K_s": spread(0.0, 3, 3),
            "sigma_s": spread(0.05, 0.6),
        },
        ("K_s",),
    ),
    "a sum of others": (
        "eon + ggx + gtr",
        {
            "rho": spread(0, 1, 3),
            "r": spread(0, 1),
            "K_s": spread(0, 2),
            "alpha": spread(0.1, 0.8),
            "K_s_2": spread(0, 2),
            "alpha_2": spread(0.1, 0.8),
            "gamma": spread(1.2, 3),
        },
        (),
    ),
    "dust": (
        "dust_layer(oren_nayar(sigma_d=0.3))",
        {"K_d": spread(0, 0.9, 3), "w": spread(0.2, 1, 3), "g": spread(-0.8, 0.8), "tau": spread(0, 1.5)},
        (),
    ),
    "all orders": (
        "dust_layer(lambert, scattering=multiple)",
        {"K_d": spread(0, 0.9, 3), "tau": spread(0, 1.5), "w": spread(0.5, 1, 3), "g": spread(0, 0.7)},
        (),
    ),
}


@pytest.fixture(autouse=True)
def mi() -> Any:
    return load_mitsuba("llvm_ad_rgb")


def brdf(fitted: FittedMap, values: dict[str, Floats], y: int, x: int, wi: Floats = LAMP, wo: Floats = ABOVE) -> Floats:
    """pi times the BRDF of a texel, by NumPy in float64: what a lamp shows of it that lets white have radiance 1."""
    model = parse(fitted.model).model.with_parameters({name: v[y, x, 0] for name, v in values.items()})
    return np.broadcast_to(np.pi * model.eval(wi, wo), 3)


def texels(image: Floats) -> Floats:
    """A picture (H, W, 3) as (y, x, pixels, 3)."""
    parts = image.reshape(SHAPE[0], PIXELS, SHAPE[1], PIXELS, 3)
    return parts.transpose(0, 2, 1, 3, 4).reshape(*SHAPE, PIXELS**2, 3)


def colours(path: Path, **options: Any) -> FittedMap:
    """A map of plain colours: red rises to the right, green downwards."""
    y, x = np.indices(SHAPE)
    K_d = np.stack([(x + 1) / 8, (y + 1) / 8, 0.5 * np.ones(SHAPE)], -1)[:, :, None]
    return fitted_map(path, "lambert", {"K_d": K_d, **options.pop("values", {})}, **options)


# ---------------------------------------------------------------- every texel as it was fitted


@pytest.mark.parametrize("name", CASES)
def test_every_texel_is_what_its_model_says(name: str, tmp_path: Path) -> None:
    model, values, per_channel = CASES[name]
    fitted = fitted_map(tmp_path / "map.zarr", model, values, per_channel=per_channel)
    draw, notes = map_stage(fitted, LOOK, (0.0, 0.0))
    shown = texels(draw(0.0))
    expected = np.array([[brdf(fitted, values, y, x) for x in range(SHAPE[1])] for y in range(SHAPE[0])])
    assert np.ptp(expected.mean(-1)) > 0.2 * expected.mean()  # the texels do differ
    np.testing.assert_allclose(shown, np.repeat(expected[:, :, None], PIXELS**2, 2), rtol=1e-4, atol=1e-6)
    assert notes == ["each point has the parameters of its own texel (nearest)"]


def test_light_is_mixed_between_texels_and_not_parameters(tmp_path: Path) -> None:
    """Halfway between a glossy and a matte texel is half of the light of either; the mean of their widths shines otherwise."""
    model, values, per_channel = CASES["the paper's"]
    fitted = fitted_map(tmp_path / "map.zarr", model, values, per_channel=per_channel)
    bsdf = load_scene({"type": "motes_map", "filename": str(fitted.path), "filter": "bilinear"})
    for y, x, down, right in ((1, 2, 0.5, 0.5), (0, 4, 0.0, 0.25), (2, 0, 0.9, 0.1)):
        weights = {(y, x): (1 - down) * (1 - right), (y, x + 1): (1 - down) * right}
        weights |= {(y + 1, x): down * (1 - right), (y + 1, x + 1): down * right}
        expected = sum(w * brdf(fitted, values, *at) for at, w in weights.items())
        shown = evaluated(bsdf, (x + 0.5 + right) / SHAPE[1], (y + 0.5 + down) / SHAPE[0])
        np.testing.assert_allclose(shown, expected, rtol=1e-4)
    middle = {
        name: 0.25 * sum(v[1 + i, 2 + j] for i in (0, 1) for j in (0, 1))[None, None] for name, v in values.items()
    }
    of_means = brdf(fitted, middle, 0, 0)
    mean = np.mean([brdf(fitted, values, 1 + i, 2 + j) for i in (0, 1) for j in (0, 1)], axis=0)
    assert np.abs(of_means / mean - 1).max() > 0.05


def evaluated(bsdf: Any, u: float, v: float, wi: Floats = LAMP) -> Floats:
    """pi times the BRDF (3,) at a place, seen from above."""
    import drjit as dr
    import mitsuba

    si = dr.zeros(mitsuba.SurfaceInteraction3f)
    si.wi, si.uv = mitsuba.Vector3f(*ABOVE.tolist()), mitsuba.Point2f(u, v)
    return np.pi / wi[2] * np.array(bsdf.eval(mitsuba.BSDFContext(), si, mitsuba.Vector3f(*wi.tolist()))).ravel()


@pytest.mark.parametrize("theta", [0.0, 1.4])
def test_samples_follow_the_density_between_texels_that_are_marked(theta: float, tmp_path: Path) -> None:
    """By Mitsuba's chi-square test, at a point of which a quarter is magenta and the rest has three highlights."""
    from mitsuba.chi2 import BSDFAdapter, ChiSquareTest, SphericalDomain

    model, values, per_channel = CASES["the paper's"]
    holed = {name: v.copy() for name, v in values.items()}
    holed["K_d"][0, 0] = np.nan
    fitted_map(tmp_path / "map.zarr", model, holed, per_channel=per_channel)
    xml = f'<string name="filename" value="{tmp_path / "map.zarr"}"/><string name="filter" value="bilinear"/><string name="gaps" value="mark"/>'
    xml += f'<transform name="to_uv"><translate x="{1.2 / SHAPE[1]}" y="{0.9 / SHAPE[0]}"/></transform>'
    sample, pdf = BSDFAdapter("motes_map", xml, wi=from_spherical(theta, 0.5).tolist())
    test = ChiSquareTest(SphericalDomain(), sample, pdf, 3, sample_count=200_000, res=101, ires=32, seed=3)
    assert test.run(0.01, 2, quiet=True), test.messages


def test_what_samples_carry_is_the_albedo(mi: Any, tmp_path: Path) -> None:
    """Their weights have the mean that cosine sampling gives, bilinear and marked too: each has a part in the value."""
    import drjit as dr

    model, values, per_channel = CASES["the paper's"]
    holed = {name: v.copy() for name, v in values.items()}
    holed["K_d"][0, 0] = np.nan
    fitted_map(tmp_path / "map.zarr", model, holed, per_channel=per_channel)
    n = 200_000
    u = np.random.default_rng(8).random((3, n), np.float32)
    si = dr.zeros(mi.SurfaceInteraction3f, n)
    si.wi, si.uv = mi.Vector3f(0.6, 0, 0.8), mi.Point2f(1.2 / SHAPE[1], 0.9 / SHAPE[0])
    for way in ("nearest", "bilinear"):
        bsdf = load_scene({"type": "motes_map", "filename": str(tmp_path / "map.zarr"), "filter": way, "gaps": "mark"})
        context, number = mi.BSDFContext(), mi.Point2f(*u[1:])
        _, weight = bsdf.sample(context, si, mi.Float(u[0]), number)
        wo = mi.warp.square_to_cosine_hemisphere(number)
        plain = bsdf.eval(context, si, wo) / mi.warp.square_to_cosine_hemisphere_pdf(wo)
        carried, known = np.array(weight), np.array(plain)
        error = np.sqrt((carried.var(1) + known.var(1)) / n)
        assert (np.abs(carried.mean(1) - known.mean(1)) < 4 * error).all()
        assert carried.var(1).max() < known.var(1).max()


# ---------------------------------------------------------------- where


QUAD = "v -1 0 0\nv 1 0 0\nv 1 2 0\nv -1 2 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"


def test_the_first_texel_is_at_the_upper_left(tmp_path: Path) -> None:
    """Rows go down and columns to the right, flat and on a mesh whose texture coordinates go up."""
    fitted = colours(tmp_path / "map.zarr")
    image = texels(map_stage(fitted, LOOK, (0.0, 0.0))[0](0.0))
    np.testing.assert_allclose(image[0, 0, 0], [1 / 8, 1 / 8, 0.5], rtol=1e-4)
    np.testing.assert_allclose(image[0, 5, -1], [6 / 8, 1 / 8, 0.5], rtol=1e-4)
    np.testing.assert_allclose(image[3, 0, -1], [1 / 8, 4 / 8, 0.5], rtol=1e-4)
    (tmp_path / "quad.obj").write_text(QUAD)
    for scene in (str(tmp_path / "quad.obj"), "sphere"):
        draw, _ = map_stage(fitted, Look(scene=scene, size=(64, 64), samples=4, repeat=1), (0.0, 0.0))
        image = draw(0.0)
        shade = image / image[..., 2:]  # blue is the same everywhere
        left, right, top, bottom = (shade[at].mean((0, 1)) for at in SIDES)
        assert right[0] > left[0] + 0.2, scene
        assert bottom[1] > top[1] + 0.2, scene


SIDES = (np.s_[28:36, 18:24], np.s_[28:36, 40:46], np.s_[16:22, 30:34], np.s_[42:48, 30:34])


def test_every_second_copy_is_mirrored(tmp_path: Path) -> None:
    fitted = colours(tmp_path / "map.zarr")
    look = Look(scene="flat", size=(96, 64), samples=4, repeat=2)
    draw, notes = map_stage(fitted, look, (0.0, 0.0))
    image = draw(0.0)
    np.testing.assert_allclose(image, image[:, ::-1], rtol=1e-5)
    np.testing.assert_allclose(image, image[::-1], rtol=1e-5)
    assert notes[-1] == "2 x 2 copies of the map, every second one mirrored"
    np.testing.assert_allclose(image[0, 0], [1 / 8, 1 / 8, 0.5], rtol=1e-4)


def test_a_film_of_another_aspect_shows_all_of_the_sample(tmp_path: Path) -> None:
    fitted = colours(tmp_path / "map.zarr")
    image = map_stage(fitted, Look(scene="flat", size=(60, 60), samples=4), (0.0, 0.0))[0](0.0)
    assert (image[:10] == 0).all()  # 60 x 40 of the 60 x 60 are the sample
    assert (image[10:50] > 0).all()
    assert (image[50:] == 0).all()


def test_channels_are_shown_by_their_names(tmp_path: Path) -> None:
    fitted = colours(tmp_path / "map.zarr", channels=("B", "G", "R"))
    image = map_stage(fitted, LOOK, (0.0, 0.0))[0](0.0)
    np.testing.assert_allclose(image[0, -1], [0.5, 1 / 8, 6 / 8], rtol=1e-4)
    other = colours(tmp_path / "other.zarr", channels=("450 nm", "550 nm", "650 nm"))
    with pytest.raises(DataError, match="K_d has the channels 450 nm, 550 nm, 650 nm, and textures are grey or red"):
        map_stage(other, LOOK, (0.0, 0.0))[0](0.0)
    grey = fitted_map(tmp_path / "grey.zarr", "lambert", {"K_d": np.full((*SHAPE, 1), 0.4)}, channels=("grey",))
    np.testing.assert_allclose(map_stage(grey, LOOK, (0.0, 0.0))[0](0.0), 0.4, rtol=1e-4)


# ---------------------------------------------------------------- when


def test_between_scans_a_texel_is_on_the_line_between_its_own(tmp_path: Path) -> None:
    K_d = np.zeros((*SHAPE, 3, 3))
    K_d[:] = np.array([0.2, 0.4, 0.8])[:, None]
    K_d[0, 0, 1] = np.nan  # its scans before and after stand for it
    K_d[1, 0, 2] = np.nan  # the one before is held
    fitted = fitted_map(tmp_path / "map.zarr", "lambert", {"K_d": K_d}, hours=(0.0, 1.0, 3.0))
    for t, usual, held in ((-2, 0.2, 0.2), (0.5, 0.3, 0.3), (1, 0.4, 0.4), (2, 0.6, 0.4), (9, 0.8, 0.4)):
        now = moment(fitted, t)
        assert now.fitted.all()
        np.testing.assert_allclose(now.values["K_d"][3, 5], usual, rtol=1e-6)
        np.testing.assert_allclose(now.values["K_d"][1, 0], held, rtol=1e-6)
        for y, x in ((0, 0), (1, 0), (3, 5)):
            np.testing.assert_allclose(
                now.values["K_d"][y, x], fitted.material(y, x).at(t).parameters["K_d"], rtol=1e-6
            )
        if t == 1:
            np.testing.assert_allclose(now.values["K_d"][0, 0], 0.2 + 0.6 / 3, rtol=1e-6)
            assert now.bridged.sum() == 1
    draw, notes = map_stage(fitted, LOOK, (1.0, 4.0))
    np.testing.assert_allclose(draw(2.0)[-1, -1], 0.6, rtol=1e-4)
    assert "1 of 24 texels have no fit at 1 h itself: their scans before and after stand for it" in notes
    assert "the map has 0 to 3 h: outside the nearest scan is held" in notes


def test_trends_are_evaluated_at_every_texel(mi: Any, tmp_path: Path) -> None:
    """Against the printed formula of the trend; and a scene that is there already moves in time."""
    start, end = RNG.uniform(0.1, 0.8, (2, *SHAPE, 3))
    constant, sigma = RNG.uniform(0.5, 4, SHAPE), RNG.uniform(0.1, 1, SHAPE)
    values = {"K_d_start": start, "K_d_end": end, "K_d_time_constant": constant, "sigma_d_value": sigma}
    fitted = fitted_map(
        tmp_path / "map.zarr", "oren_nayar", values, hours=(1.0, 2.0, 7.0), trends={"K_d": "exponential"}
    )
    bsdf = load_scene({"type": "motes_map", "filename": str(fitted.path), "time": 1.0})
    for t in (1.0, 4.5, 9.0):
        parameters = mi.traverse(bsdf)
        parameters["time.value"] = t
        parameters.update()
        y, x = 2, 3
        K_d = end[y, x] + (start[y, x] - end[y, x]) * np.exp(-(t - 1) / constant[y, x])
        expected = np.pi * parse("oren_nayar").model.with_parameters({"K_d": K_d, "sigma_d": sigma[y, x]}).eval(
            LAMP, ABOVE
        )
        np.testing.assert_allclose(evaluated(bsdf, 3.5 / 6, 2.5 / 4), expected, rtol=1e-4)
    assert "the map has 1 to 7 h: outside trends go on" in map_stage(fitted, LOOK, (1.0, 9.0))[1]


def test_values_at_their_bounds_stay_within_them_in_float32(tmp_path: Path) -> None:
    """pi/2 in float32 is 4e-8 more than pi/2, which a plugin refuses; g stays between -1 and 1."""
    values = {
        "sigma_s": np.full((*SHAPE, 1), np.pi / 2),
        "K_s": np.full((*SHAPE, 1), 0.5),
        "tau": np.full((*SHAPE, 1), 0.2),
        "w": np.ones((*SHAPE, 1, 3)),
        "g": np.full((*SHAPE, 1), 1.0),
    }
    fitted = fitted_map(tmp_path / "map.zarr", "dust_layer(torrance_sparrow)", values)
    now = moment(fitted, 0.0)
    assert np.isclose(now.values["sigma_s"], np.pi / 2).all()
    assert (now.values["sigma_s"].astype(float) <= np.pi / 2).all()
    assert (now.values["g"] < 1).all()
    load_scene({"type": "motes_map", "filename": str(fitted.path)})


# ---------------------------------------------------------------- where nothing was fitted


def test_texels_without_a_fit_are_filled_or_marked_and_counted(tmp_path: Path) -> None:
    y, x = np.indices(SHAPE)
    K_d = np.repeat(((10 * y + x) / 50)[:, :, None, None], 3, axis=3)
    K_d[1:3, 2:4], K_d[3, 5, 0, 1] = np.nan, np.nan  # a texel lacks one channel: it has no fit
    fitted = fitted_map(tmp_path / "map.zarr", "lambert", {"K_d": K_d})
    draw, notes = map_stage(fitted, LOOK, (0.0, 0.0))
    image = texels(draw(0.0))[:, :, 0, 0]
    # By hand: beside, left before right; of two at one distance the one in the same row.
    for (at_y, at_x), value in {
        (1, 2): 0.22,
        (1, 3): 0.28,
        (2, 2): 0.42,
        (2, 3): 0.48,
        (3, 5): 0.68,
        (0, 3): 0.06,
    }.items():
        assert image[at_y, at_x] == pytest.approx(value, rel=1e-4)
    assert "5 of 24 texels have no fit: they have the parameters of the nearest one that has" in notes
    draw, notes = map_stage(fitted, replaced(gaps="mark"), (0.0, 0.0))
    image = texels(draw(0.0))
    np.testing.assert_allclose(image[1, 2], np.tile([0.9, 0, 0.9], (PIXELS**2, 1)), rtol=1e-4)
    assert image[0, 3, 0, 0] == pytest.approx(0.06, rel=1e-4)
    assert "5 of 24 texels have no fit: they are magenta" in notes
    assert ((image[..., 0] > 0.8) & (image[..., 1] == 0)).mean() == 5 / 24


def replaced(**options: Any) -> Look:
    return Look(scene=LOOK.scene, size=LOOK.size, samples=4, **options)


def test_what_the_data_do_not_determine_is_shown_and_said_or_left_out(tmp_path: Path) -> None:
    model, values, per_channel = CASES["the paper's"]
    fitted = fitted_map(tmp_path / "map.zarr", model, values, per_channel=per_channel)
    import zarr

    store = zarr.open_group(str(fitted.path), mode="r+", use_consolidated=False)
    store["K_s_verdict"][0, 1, 0, 2] = 2  # unidentifiable, in blue alone
    notes = map_stage(fitted, LOOK, (0.0, 0.0))[1]
    assert "the data do not determine K_s at 1 of 24 texels; shown as fitted" in notes
    draw, notes = map_stage(fitted, replaced(strict=True, gaps="mark"), (0.0, 0.0))
    assert "1 of 24 texels have no fit, or a parameter that the data do not determine: they are magenta" in notes
    np.testing.assert_allclose(texels(draw(0.0))[0, 1, 0], [0.9, 0, 0.9], rtol=1e-4)
    store["sigma_s_verdict"][...] = 2
    with pytest.raises(DataError, match=r"none of the 24 texels of .* has a fit of which the data determine every"):
        map_stage(fitted, replaced(strict=True), (0.0, 0.0))


@pytest.mark.parametrize("seed", range(3))
def test_the_nearest_texel_is_found(seed: int) -> None:
    """Against a search through all of them."""
    known = np.random.default_rng(seed).random((17, 23)) < (0.3, 0.03, 0.005)[seed]
    known[4, 20] = True
    found = nearest(known)
    assert found is not None
    assert known[found].all()
    y, x = np.indices(known.shape)
    good = np.argwhere(known)
    best = ((y[..., None] - good[:, 0]) ** 2 + (x[..., None] - good[:, 1]) ** 2).min(-1)
    np.testing.assert_array_equal((found[0] - y) ** 2 + (found[1] - x) ** 2, best)
    assert nearest(np.ones((2, 3), bool)) is None


def test_a_moment_is_read_block_by_block(tmp_path: Path) -> None:
    """Of 24 times no more is held than the moment and a few blocks of 16 x 16 texels."""
    times, shape = 24, (64, 96)
    K_d = np.broadcast_to(np.linspace(0.1, 0.9, times)[:, None], (*shape, times, 3))
    fitted = fitted_map(tmp_path / "map.zarr", "lambert", {"K_d": K_d}, hours=np.arange(float(times)), block=(16, 16))
    moment(fitted, 0.0)  # what is imported, and opened once
    tracemalloc.start()
    now = moment(fitted, 4.5)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    result = sum(v.nbytes for v in now.values.values()) + 3 * now.fitted.nbytes
    whole = K_d.size * 4
    assert peak < result + 0.25 * whole  # float32; the store's doubles would be twice the whole
    np.testing.assert_allclose(now.values["K_d"][7, 9], np.interp(4.5, fitted.hours, K_d[0, 0, :, 0]), rtol=1e-6)


# ---------------------------------------------------------------- what is wrong


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"filename": "none.zarr"}, "none.zarr does not exist"),
        ({"filename": None}, "motes_map has no filename"),
        ({"filename": "measured-map.zarr"}, "holds measured reflectance at every texel"),
        ({"filter": "trilinear"}, "filter = 'trilinear' is not one of nearest, bilinear"),
        ({"gaps": "blur"}, "gaps = 'blur' is not one of fill, mark"),
        ({"strict": "very"}, "strict = 'very' is neither true nor false"),
        ({"time": "noon"}, "time = 'noon' is not a number of hours"),
        ({"time": float("nan")}, "a time of nan h is not finite"),
        ({"to_uv": 3.0}, "to_uv = 3.0 is not a transformation"),
        ({"K_s": 0.5}, "motes_map has no parameter 'K_s'"),
    ],
)
def test_what_is_wrong_in_a_scene_is_one_sentence(
    wrong: dict[str, Any], words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    colours(tmp_path / "map.zarr")
    described = {"type": "motes_map", "filename": "map.zarr", **wrong}
    with pytest.raises(MotesError, match=words) as caught:
        load_scene({name: value for name, value in described.items() if value is not None})
    assert caught.value.hint


def test_variants_without_red_green_and_blue_are_refused(tmp_path: Path) -> None:
    fitted = colours(tmp_path / "map.zarr")
    load_mitsuba("llvm_ad_spectral")
    with pytest.raises(
        ParameterError, match="motes_map shows red, green and blue, and the variant is llvm_ad_spectral"
    ):
        load_scene({"type": "motes_map", "filename": str(fitted.path)})


def test_a_map_without_any_fit_and_what_it_cannot_lie_on_are_refused(tmp_path: Path) -> None:
    nothing = fitted_map(tmp_path / "nothing.zarr", "lambert", {"K_d": np.full((*SHAPE, 1, 3), np.nan)})
    with pytest.raises(DataError, match=r"none of the 24 texels of .*nothing.zarr has a fit"):
        map_stage(nothing, LOOK, (0.0, 0.0))
    fitted = colours(tmp_path / "map.zarr")
    with pytest.raises(MotesError, match="bunny has no texture coordinates, and a map lies by them"):
        map_stage(fitted, Look(scene="bunny"), (0.0, 0.0))
    wrong: list[tuple[dict[str, Any], str]] = [
        ({"repeat": 0}, "0 copies of a map are outside"),
        ({"lamp_deg": (95.0, 0.0)}, "the lamp at 95, 0 degrees is not above the sample"),
        ({"lamp_deg": (45.0,)}, "the lamp at 45 degrees is not above the sample"),
        ({"filter": "cubic"}, "filter = 'cubic' is not one of"),
    ]
    for options, words in wrong:
        with pytest.raises(MotesError, match=words):
            Look(**options)
