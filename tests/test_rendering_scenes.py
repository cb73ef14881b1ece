"""Preview scenes, tone mapping, panels, films and measured materials."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motes.errors import DataError, FormatError, MotesError

if (
    find_spec("mitsuba") is None
):  # not importorskip: Dr.Jit chooses its LLVM when it is imported, and Motes must come first
    pytest.skip("mitsuba is not installed", allow_module_level=True)

from motes.meshes.mesh import Mesh
from motes.meshes.shapes import plane, sphere
from motes.rendering import load_mitsuba, load_scene
from motes.rendering.films import (
    forget,
    frames_folder,
    read_radiance,
    render_frames,
    write_film,
    write_picture,
    write_radiance,
)
from motes.rendering.measured import measured_bsdf, table
from motes.rendering.panels import columns_for, sheet
from motes.rendering.scenes import NAMES, Subject, on_stage, preview, subject
from motes.rendering.tonemap import OPERATORS, neutral, picture, stated

SECONDS = 120
GREY = {"type": "diffuse", "reflectance": {"type": "uniform", "value": 0.5}}


def rendered(description: dict[str, Any], samples: int = 16, seed: int = 0) -> np.ndarray:
    mi = load_mitsuba()
    return np.array(mi.render(load_scene(description), spp=samples, seed=seed))


# ---------------------------------------------------------------- scenes


@pytest.mark.parametrize("name", NAMES)
def test_previews_show_their_object_and_nothing_strange(name: str) -> None:
    image = rendered(preview(subject(name), GREY, size=(48, 48)))
    assert image.shape == (48, 48, 3)
    assert np.isfinite(image).all()
    assert image.min() > 0.02  # no black rims, no holes
    assert image.max() < 4
    np.testing.assert_allclose(image, image.mean(-1, keepdims=True) * np.ones(3), atol=1e-5)  # all of it is grey
    other = rendered(
        preview(
            subject(name), {"type": "diffuse", "reflectance": {"type": "rgb", "value": [0.8, 0.1, 0.1]}}, size=(48, 48)
        )
    )
    red = other[..., 0] > 1.5 * other[..., 1]
    assert 0.08 < red.mean() < 0.6
    assert red[24, 24]
    assert not (red[0] | red[-1]).any()  # it does not leave the picture above or below
    assert not (red[:, 0] | red[:, -1]).any()


def test_a_white_surface_facing_the_key_is_about_white() -> None:
    # Exposure: the brightest part of a white diffuser fills the range without clipping.
    image = rendered(
        preview(
            subject("sphere"), {"type": "diffuse", "reflectance": {"type": "uniform", "value": 0.9}}, size=(64, 64)
        ),
        64,
    )
    assert 0.75 < np.quantile(image[:40], 0.97) < 1.15


def test_an_environment_takes_the_place_of_the_lights(tmp_path: Path) -> None:
    mi = load_mitsuba()
    sky = np.zeros((8, 16, 3), np.float32)
    sky[:, :, 2] = 1.0
    mi.Bitmap(sky).write(str(tmp_path / "sky.exr"))
    image = rendered(preview(subject("sphere"), GREY, size=(32, 32), env=tmp_path / "sky.exr"))
    assert image[..., :2].max() < 1e-4
    assert image[2, 2, 2] == pytest.approx(1, abs=1e-3)  # it is seen behind the object
    assert image[16, 16, 2] == pytest.approx(0.5, abs=0.12)
    with pytest.raises(FormatError, match="does not exist"):
        preview(subject("sphere"), GREY, env=tmp_path / "none.exr")


def test_any_mesh_is_brought_to_the_stage() -> None:
    tall = plane(2).moved(100, (7, 7, 7))
    thin = Mesh(tall.positions[:, [0, 2, 1]], tall.triangles)
    for mesh in (tall, thin, sphere(8).moved(1e-4)):
        placed = on_stage(mesh)
        low, high = placed.bounds
        assert low[1] == pytest.approx(0, abs=1e-9)
        assert max((high - low)[[0, 2]].max() / 2.2, (high - low)[1] / 1.9) == pytest.approx(1)
        assert placed.normals is not None
    upright = on_stage(thin, up="x" and (0, 0, 1))
    assert np.ptp(upright.positions[:, 1]) < 1e-9 or np.ptp(upright.positions[:, 1]) <= 1.9 + 1e-9


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("spere", "sphere"),
        ("bunnny", "bunny"),
        ("tea", "Choose|teapot"),
        ("zzz", "Choose sphere"),
        ("none.ply", "Give"),
        ("spere.obj", "sphere"),
    ],
)
def test_an_unknown_scene_suggests_close_names(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, hint: str
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "sphere.obj").write_text("")
    with pytest.raises(MotesError) as caught:
        subject(name)
    assert any(word in caught.value.hint for word in hint.split("|"))


@pytest.mark.parametrize("size", [(0, 10), (10, 10**6)])
def test_absurd_sizes_are_refused(size: tuple[int, int]) -> None:
    with pytest.raises(MotesError, match="pixels"):
        preview(Subject(None, "sphere"), GREY, size=size)


# ---------------------------------------------------------------- tone mapping


def khronos(color: list[float]) -> np.ndarray:
    """The specification's listing, line by line, for one colour."""
    c = np.array(color)
    start, desaturation = 0.8 - 0.04, 0.15
    x = min(c)
    c = c - (x - 6.25 * x * x if x < 0.08 else 0.04)
    peak = max(c)
    if peak < start:
        return c
    d = 1 - start
    new_peak = 1 - d * d / (peak + d - start)
    c = c * new_peak / peak
    g = 1 - 1 / (desaturation * (peak - new_peak) + 1)
    return c * (1 - g) + g * new_peak * np.ones(3)


def test_neutral_is_that_of_the_specification() -> None:
    rng = np.random.default_rng(0)
    colors = np.concatenate(
        [rng.uniform(0, 0.2, (50, 3)), rng.exponential(0.8, (200, 3)), [[0, 0, 0], [0.04] * 3, [0.8] * 3, [40, 2, 1]]]
    )
    np.testing.assert_allclose(neutral(colors), [khronos(c) for c in colors.tolist()], atol=1e-12)
    assert neutral(colors).max() < 1
    assert neutral([-1.0, -2, -3]).tolist() == [0, 0, 0]


def test_pictures_are_srgb() -> None:
    # IEC 61966-2-1 at known points: 0.5 of the light is 188, 0.2159 is 128.
    flat = np.array([[[0.5, 0.21586, 0.0], [1.0, 2.0, np.nan]]])
    np.testing.assert_array_equal(picture(flat, "clip"), [[[188, 128, 0], [255, 255, 0]]])
    np.testing.assert_array_equal(picture(flat, "clip", exposure=-1)[0, 1], [188, 255, 0])
    assert picture(flat).dtype == np.uint8
    ramp = picture(np.linspace(0, 1.2, 4096)[None, :, None] * np.ones(3), "neutral")[0, :, 0].astype(int)
    assert (np.diff(ramp) >= 0).all()
    assert np.diff(ramp[200:]).max() <= 2  # no steps that one could see
    assert all("sRGB" in stated(name, 0.5) for name in OPERATORS)
    with pytest.raises(MotesError, match="'filmic' is not a tone mapping"):
        picture(flat, "filmic")
    with pytest.raises(MotesError, match="nan EV"):
        picture(flat, exposure=float("nan"))


# ---------------------------------------------------------------- panels


def test_panels_stand_in_rows_and_columns() -> None:
    red, blue = (np.full((40, 60, 3), c, np.uint8) for c in ((200, 0, 0), (0, 0, 200)))
    bare = sheet([[red, blue], [blue, None]])
    assert bare.shape == (84, 124, 3)
    np.testing.assert_array_equal(bare[:40, :60], red)
    np.testing.assert_array_equal(bare[44:, :60], blue)
    assert (bare[44:, 64:] == 255).all()
    titled = sheet([[red, blue]], rows=["a name that is much longer than its room"], columns=["0 h", "12 h"])
    top, left = titled.shape[0] - 40, titled.shape[1] - 124
    np.testing.assert_array_equal(titled[top:, left:], sheet([[red, blue]]))
    assert (titled[:top, left : left + 60] < 128).any()
    assert (titled[top:, :left] < 128).any()
    assert [columns_for(n) for n in (1, 4, 5, 12)] == [1, 4, 3, 5]


# ---------------------------------------------------------------- films


def ramps(n: int) -> list[np.ndarray]:
    """Frames of smooth colours that move."""
    base = np.linspace(0, 1, 64)[None, :, None] * np.array([220, 160, 90]) + np.zeros((48, 1, 1))
    return [np.roll(base, 3 * k, axis=1).astype(np.uint8) for k in range(n)]


def frames(n: int) -> Callable[[], Iterator[np.ndarray]]:
    return lambda: iter(ramps(n))


def test_a_gif_plays_what_was_drawn(tmp_path: Path) -> None:
    from PIL import Image

    write_film(tmp_path / "a.gif", frames(7), fps=12.5, comment="clipped at 1")
    with Image.open(tmp_path / "a.gif") as film:
        assert film.n_frames == 7
        assert film.info["duration"] == 80
        assert film.info["loop"] == 0
        assert film.info["comment"] == b"clipped at 1"
        for k, expected in enumerate(ramps(7)):
            film.seek(k)
            shown = np.array(film.convert("RGB")).astype(float)
            assert np.abs(shown - expected).mean() < 3
            assert np.abs(shown.mean((0, 1)) - expected.mean((0, 1))).max() < 1.5


def test_an_mp4_plays_what_was_drawn(tmp_path: Path) -> None:
    av = pytest.importorskip("av")
    write_film(tmp_path / "a.mp4", frames(7), fps=12)
    with av.open(str(tmp_path / "a.mp4")) as film:
        assert film.streams.video[0].average_rate == 12
        shown = [f.reformat(format="rgb24", src_colorspace="ITU709").to_ndarray() for f in film.decode(video=0)]
    assert len(shown) == 7
    for picture_, expected in zip(shown, ramps(7), strict=True):
        # 4:2:0 blurs colour at the one hard edge; the mean tells whether the matrix was right.
        assert np.abs(picture_.astype(float).mean((0, 1)) - expected.mean((0, 1))).max() < 2.5


def test_odd_sizes_and_wrong_rates(tmp_path: Path) -> None:
    write_film(tmp_path / "a.mp4", lambda: iter([np.zeros((31, 33, 3), np.uint8)] * 2), fps=5)
    with pytest.raises(MotesError, match="0 frames a second"):
        write_film(tmp_path / "b.gif", frames(2), fps=0)
    with pytest.raises(MotesError, match="not a film"):
        write_film(tmp_path / "b.avi", frames(2), fps=5)
    with pytest.raises(MotesError, match="cannot be written"):
        write_film("/proc/motes/b.gif", frames(2), fps=5)
    assert [p.name for p in tmp_path.iterdir()] == ["a.mp4"]


def test_frames_that_are_there_are_not_drawn_again(tmp_path: Path) -> None:
    drawn: list[int] = []
    told: list[str] = []

    def draw(k: int) -> np.ndarray:
        drawn.append(k)
        if k == 3 and len(drawn) == 4:
            raise KeyboardInterrupt
        return np.full((4, 4, 3), k / 8, np.float32)

    folder = tmp_path / "frames"
    with pytest.raises(KeyboardInterrupt):
        render_frames(folder, 6, draw)
    assert sorted(p.name for p in folder.iterdir()) == ["00000.exr", "00001.exr", "00002.exr"]
    (folder / "00001.exr").write_bytes(b"cut off")
    paths = render_frames(folder, 6, draw, lambda done, total, what: told.append(f"{done}/{total} {what}"))
    assert drawn == [0, 1, 2, 3, 1, 3, 4, 5]
    assert [read_radiance(p)[0, 0, 0] for p in paths] == [k / 8 for k in range(6)]
    assert told[0].startswith("2/6 frame 2 of 6")
    assert "left" in told[1]
    forget(folder, paths)
    assert not folder.exists()


def test_other_settings_have_other_frames(tmp_path: Path) -> None:
    one = frames_folder(tmp_path / "a.gif", {"samples": 16})
    assert one == frames_folder(tmp_path / "a.gif", {"samples": 16})
    assert one != frames_folder(tmp_path / "a.gif", {"samples": 17})
    assert one.name.startswith("a.frames-")


def test_pictures_and_radiance_are_written_whole(tmp_path: Path) -> None:
    from PIL import Image

    radiance = np.random.default_rng(0).exponential(1, (5, 7, 3)).astype(np.float32)
    np.testing.assert_array_equal(read_radiance(write_radiance(tmp_path / "a.exr", radiance)), radiance)
    write_picture(tmp_path / "a.png", ramps(1)[0], "a remark")
    with Image.open(tmp_path / "a.png") as stored:
        np.testing.assert_array_equal(np.array(stored), ramps(1)[0])
        assert stored.text["Comment"] == "a remark"
    for write in (lambda p: write_radiance(p, radiance), lambda p: write_picture(p, ramps(1)[0])):
        with pytest.raises(MotesError, match="cannot be written"):
            write(tmp_path / "a.png" / "deeper.png")


# ---------------------------------------------------------------- measured materials


def write_merl(path: Path, brdf: Any) -> None:
    """A MERL table of a BRDF at the middles of its bins; -1 below the horizon."""
    from motes.measurements import merl
    from motes.measurements._angles import half_difference_grid

    wi, wo, _, above = half_difference_grid(*merl.FULL)
    planes = np.full((3, int(np.prod(merl.FULL))), -1.0)
    planes[:, above] = (np.broadcast_to(brdf.eval(wi, wo), (len(wi), 3)) / merl.SCALE).T
    path.write_bytes(np.array(merl.FULL, "<i4").tobytes() + planes.astype("<f8").tobytes())


def test_a_merl_table_is_rendered_as_measured(tmp_path: Path) -> None:
    import motes

    mi = load_mitsuba()
    import drjit as dr

    surface = motes.OrenNayar(K_d=(0.5, 0.3, 0.2), sigma_d=0.3) + motes.TorranceSparrow(K_s=0.2, sigma_s=0.3)
    write_merl(tmp_path / "paint.binary", surface)
    assert table(tmp_path / "paint.binary").shape == (90, 90, 182, 3)
    bsdf = measured_bsdf(tmp_path / "paint.binary")
    rng = np.random.default_rng(1)
    w = rng.normal(size=(2, 4000, 3))
    w[..., 2] = np.abs(w[..., 2]) + 0.3
    wi, wo = w / np.linalg.norm(w, axis=-1, keepdims=True)
    si = dr.zeros(mi.SurfaceInteraction3f, len(wi))
    si.wi = mi.Vector3f(wo.T.astype(np.float32))
    value = np.array(bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(wi.T.astype(np.float32)))).T
    expected = surface.eval(wi, wo) * wi[:, 2:]
    assert np.abs(value - expected).max() < 0.02 * expected.max()  # what interpolation between bins costs
    assert np.median(np.abs(value - expected) / expected) < 2e-3
    # The sampling agrees with its density: the mean weight of samples is the integral of the BRDF times the cosine.
    n = 200_000
    si = dr.zeros(mi.SurfaceInteraction3f, n)
    si.wi = mi.Vector3f(0.6, 0.0, 0.8) + dr.zeros(mi.Float, n)
    u = [mi.Float(rng.random(n).astype(np.float32)) for _ in range(3)]
    _, weight = bsdf.sample(mi.BSDFContext(), si, u[0], mi.Point2f(u[1], u[2]))
    albedo = surface.directional_albedo(np.array([0.6, 0, 0.8]))
    np.testing.assert_allclose(np.array(weight).mean(1), albedo, rtol=0.01)


def test_each_bin_of_a_merl_table_is_found(tmp_path: Path) -> None:
    """A table that no surface has, in which each bin has a number of its own."""
    import drjit as dr

    from motes.measurements import merl
    from motes.measurements._angles import half_difference_grid

    mi = load_mitsuba()
    number = 1 + np.arange(np.prod(merl.FULL)) / np.prod(merl.FULL)
    planes = np.repeat(number[None], 3, axis=0) / merl.SCALE[:, None]
    (tmp_path / "a.binary").write_bytes(np.array(merl.FULL, "<i4").tobytes() + planes.astype("<f8").tobytes())
    bsdf = measured_bsdf(tmp_path / "a.binary")
    wi, wo, _, above = half_difference_grid(*merl.FULL)
    chosen = np.random.default_rng(2).integers(0, len(wi), 5000)
    expected = number[above][chosen]
    for a, b in ((wi, wo), (wo, wi)):  # the second has phi_d + pi, which is the same bin
        si = dr.zeros(mi.SurfaceInteraction3f, len(chosen))
        si.wi = mi.Vector3f(b[chosen].T.astype(np.float32))
        value = np.array(bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(a[chosen].T.astype(np.float32))))[0]
        found = value / a[chosen][:, 2]
        # phi_d is ill-defined where theta_d or theta_h are small, and the last bin leads on to the first.
        assert np.quantile(np.abs(found - expected), 0.98) < 2e-5


def test_the_density_of_the_merl_bsdf_passes_chi_square(tmp_path: Path) -> None:
    from mitsuba.chi2 import ChiSquareTest, SphericalDomain

    import motes

    mi = load_mitsuba()
    import drjit as dr

    write_merl(
        tmp_path / "rough.binary", motes.Lambert(K_d=(0.4, 0.3, 0.2)) + motes.TorranceSparrow(K_s=0.3, sigma_s=0.35)
    )
    bsdf = measured_bsdf(tmp_path / "rough.binary")

    def interaction(n: int) -> Any:
        si = dr.zeros(mi.SurfaceInteraction3f, n)
        si.wi = mi.Vector3f(0.8, 0.0, 0.6) + dr.zeros(mi.Float, n)
        return si

    def sample(u: Any) -> Any:
        bs, _ = bsdf.sample(mi.BSDFContext(), interaction(dr.width(u)), u.z, mi.Point2f(u.x, u.y))
        return bs.wo, dr.select(bs.pdf > 0, mi.Float(1), 0)

    def pdf(wo: Any) -> Any:
        return bsdf.pdf(mi.BSDFContext(), interaction(dr.width(wo)), wo)

    test = ChiSquareTest(SphericalDomain(), sample, pdf, sample_dim=3, sample_count=400_000, res=51, ires=16, seed=1)
    test.tabulate_histogram()
    test.tabulate_pdf()
    sums = (np.asarray(x).item() for x in (test.pdf_sum, test.histogram_sum))
    assert abs(next(sums) - next(sums)) < 5e-3
    os.chdir(tmp_path)  # it writes a file where it fails
    assert test.run(significance_level=0.001), test.messages


def test_rgl_files_are_rendered_by_mitsuba(shared: Callable[[str], Path]) -> None:
    bsdf = measured_bsdf(shared("data/rgl/vch_silk_blue_rgb.bsdf"))
    image = rendered(preview(subject("sphere"), {"type": "twosided", "inner": bsdf}, size=(32, 32)))
    assert image[16, 16, 2] > 1.3 * image[16, 16, 0]  # blue silk


@pytest.mark.parametrize(
    "content", [b"", b"hello", b"tensor_file\0\1\0", b"\x5a\0\0\0\x5a\0\0\0\xb4\0\0\0" + bytes(99)]
)
def test_damaged_measurements_are_explained(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "a.binary").write_bytes(content)
    with pytest.raises((DataError, FormatError)):
        measured_bsdf(tmp_path / "a.binary")
    with pytest.raises(DataError, match="does not exist"):
        measured_bsdf(tmp_path / "none.binary")
