"""The viewer's scene in a real browser: ground, dust and axis of meshes of one's own, skies of one's own, banding, paper."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motes.material import Material
from motes.viewer import view
from viewer_scenes import coloured_faces, dusty_square, panorama, radiance_hdr
from viewer_support import DUSTY, ROCK, Viewed, browser, driver, drying

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def chrome() -> Iterator[Any]:
    with driver() as playwright, browser(playwright) as running:
        yield running


@pytest.fixture(scope="module")
def dusty(tmp_path_factory: pytest.TempPathFactory) -> Path:
    material = Material(DUSTY, name="dusty", channels=("R", "G", "B"))
    return view(material, ROCK).save(tmp_path_factory.mktemp("scene") / "dusty.html")


def attribute(viewed: Viewed, name: str, mesh: str = "mesh") -> np.ndarray:
    return np.array(viewed.js(f"Array.from(app.picture.{mesh}.geometry.getAttribute({name!r}).array)"))


def middle_row(pixels: np.ndarray) -> np.ndarray:
    """The row through the middle of a picture, in floating point."""
    return pixels[pixels.shape[0] // 2].astype(float)


def test_a_mesh_brings_its_dust_and_says_which_way_is_up(chrome: Any, dusty: Path) -> None:
    with Viewed(chrome, dusty) as viewed:
        page = viewed.settled().page
        assert page.get_by_label("Up", exact=True).is_hidden()  # the page's own shapes stand upright
        viewed.drop("floor.ply", dusty_square())
        viewed.wait("app.store.state.shape === 'floor.ply'")
        assert "Its own dust lies on it, tau up to 0.8" in viewed.messages()
        np.testing.assert_allclose(attribute(viewed, "dust"), [0, 1, 1, 0], atol=1e-6)
        assert viewed.js("app.values(0).tau") == pytest.approx([0.8])
        normals = attribute(viewed, "normal").reshape(-1, 3)
        np.testing.assert_allclose(normals, np.tile([0, 0, 1], (4, 1)), atol=1e-6)  # as the file has it
        page.get_by_label("Up", exact=True).select_option("z")
        np.testing.assert_allclose(attribute(viewed, "normal").reshape(-1, 3), np.tile([0, 1, 0], (4, 1)), atol=1e-6)
        places = attribute(viewed, "position").reshape(-1, 3) / 1.15
        np.testing.assert_allclose(places, [[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1]], atol=1e-6)
        # Drawn: dust from the left to the right, and none of it in the material without a layer.
        viewed.set(elevation=60, lobe=False, environment="none", compare="one", ground=False)
        row = middle_row(viewed.complete().pixels())
        inside = np.flatnonzero(row[:, 3] > 250)
        assert np.abs(row[inside[5], :3] - row[inside[-5], :3]).max() > 20
        page.get_by_label("Dust lies where it settles").uncheck()
        even = middle_row(viewed.complete().pixels())
        assert np.abs(even[inside[5], :3] - row[inside[5], :3]).max() > 20


def test_faces_with_colours_or_textures_of_their_own_are_read(chrome: Any, dusty: Path) -> None:
    with Viewed(chrome, dusty) as viewed:
        viewed.settled()
        for name, texture in (("colours.ply", False), ("texture.ply", True)):
            viewed.drop(name, coloured_faces(texture))
            viewed.wait(f"app.store.state.shape === {name!r}")
            assert "2 triangles" in viewed.messages()
            assert len(attribute(viewed, "position")) == 12  # four vertices: the shared edge stays smooth
            normals = attribute(viewed, "normal").reshape(-1, 3)
            assert (np.abs(normals[:, 0]) < 1e-5).sum() == 2


def test_the_ground_lacks_what_the_shape_keeps_from_it(chrome: Any, dusty: Path) -> None:
    with Viewed(chrome, dusty) as viewed:
        viewed.settled()
        hidden = attribute(viewed, "hidden", "ground").reshape(65, 65)
        places = attribute(viewed, "position", "ground").reshape(65, 65, 3)
        np.testing.assert_allclose(places[..., 1], -1.002, atol=1e-3)
        # A sphere of radius 1 that stands on the ground at a distance r from a point keeps from it the part cos(theta) sin(alpha)^2 of a
        # uniform sky's light, with theta from the zenith to its middle and alpha its radius in angle, while it is all above the horizon.
        r = np.hypot(places[..., 0], places[..., 2])
        near = (r > 0.6) & (r < 1.2)
        squared = r**2 + 1
        expected = 1 / np.sqrt(squared) / squared
        assert np.abs(hidden - expected)[near].max() < 0.08
        assert np.abs(hidden - expected)[near].mean() < 0.03
        assert hidden[r > 2.2].max(initial=0) < 0.02
        viewed.set(lobe=False, sky=1, lamp=0, elevation=30)
        with_ground = viewed.complete().pixels()
        viewed.set(ground=False)
        without = viewed.complete().pixels()
        changed = np.abs(with_ground.astype(int) - without).max(-1) > 8
        assert 0.02 < changed.mean() < 0.5
        assert not changed[: len(changed) // 3].any()
        assert (without[changed & (without[..., 3] == 0)] == 0).all()
        viewed.set(ground=True, environment="none")  # no light from all around, no shadow of it
        assert (viewed.complete().pixels()[-10:, :, 3] == 0).all()


SEEN = """(() => {
  const { picture, store, pair } = app;
  return x.map((changes) => {
    store.change(changes);
    const { renderer, camera, surface } = picture;
    picture.resize(60, 47, 1);
    picture.shade(store.state, pair.shownValues(store.state), 60, 47, 1);
    const pixels = new Float32Array(4 * 60 * 47);
    renderer.readRenderTargetPixels(surface.target, 0, 0, 60, 47, pixels);
    const lit = new Float32Array(4 * 60 * 47);
    renderer.readRenderTargetPixels(picture.sample, 0, 0, 60, 47, lit);
    const bounds = picture.parts(store.state, 60).map((part) => surface.bounds(camera, 47, part));
    return { bounds, distance: Array.from(pixels).filter((_, k) => k % 4 === 2), alpha: Array.from(lit).filter((_, k) => k % 4 === 3) };
  });
})()"""


def test_light_is_computed_where_the_mesh_is_seen(chrome: Any, dusty: Path) -> None:
    """Each pixel of the mesh, from afar, from near, from below, of two materials: all lit, and all within the bounds that are computed."""
    common = {"ground": False, "backdrop": False, "lobe": False}
    looks = [
        {"shape": "sphere", "compare": "one"},
        {"shape": "bunny", "elevation": -60, "azimuth": 70},
        {"shape": "teapot", "distance": 2.2, "elevation": 10},
        {"shape": "sphere", "compare": "side", "distance": 5.0},
        {"compare": "split", "split": 0.3},
    ]
    with Viewed(chrome, dusty) as viewed:
        viewed.settled()
        for number, found in enumerate(viewed.js(SEEN, [common | look for look in looks])):
            seen = np.array(found["distance"]).reshape(47, 60) > 0
            assert seen.mean() > 0.1
            np.testing.assert_array_equal(np.array(found["alpha"]).reshape(47, 60) == 1, seen)
            inside = np.zeros((47, 60), bool)
            for left, right, low, high in found["bounds"]:
                inside[low:high, left:right] = True
            assert not (seen & ~inside).any()
            # Of a sphere not much more than the square around it.
            assert number in (1, 2) or inside.mean() < 1.5 * seen.mean()


def test_a_sky_of_ones_own(chrome: Any, dusty: Path, tmp_path: Path) -> None:
    """The same panorama as Radiance HDR and as OpenEXR: top, bottom and sides where they belong."""
    picture = panorama()
    OpenEXR = pytest.importorskip("OpenEXR")
    exr = tmp_path / "sky.exr"
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(header, {"RGB": np.ascontiguousarray(picture, np.float32)}).write(str(exr))
    with Viewed(chrome, dusty) as viewed:
        page = viewed.settled().page
        for name, content in (("sky.hdr", radiance_hdr(picture)), ("sky.exr", exr.read_bytes())):
            viewed.drop(name, content)
            viewed.wait(f"app.settings.skyName === {name!r}")
            assert viewed.state("environment") == "own"
            found = np.array(viewed.js("Array.from(app.environment('own'))")).reshape(64, 128, 3)
            np.testing.assert_allclose(found[:24].reshape(-1, 3), np.tile([0.5, 0, 0], (24 * 128, 1)), rtol=0.01)
            np.testing.assert_allclose(found[33:].reshape(-1, 3), np.tile([0, 0, 0.25], (31 * 128, 1)), rtol=0.01)
            # The azimuth goes from +z over +x; the patch lies at three quarters of the panorama's width: at +x.
            bright = np.flatnonzero(found[30, :, 0] > 4)
            assert bright.min() == pytest.approx(0.2 * 128, abs=1.5)
            assert bright.max() == pytest.approx(0.3 * 128, abs=1.5)
            viewed.set(lamp=0, sky=1, lobe=False, ground=False, compare="one")
            shown = viewed.complete().pixels().astype(int)
            column = shown[:, shown.shape[1] // 2]
            covered = np.flatnonzero(column[:, 3] == 255)
            top, bottom = (column[int(np.quantile(covered, share))] for share in (0.1, 0.9))
            assert top[0] > top[2] + 80
            assert bottom[0] < bottom[2] + 60
            row = shown[int(np.median(covered))]
            across = np.flatnonzero(row[:, 3] == 255)
            left, right = (row[int(np.quantile(across, share))] for share in (0.1, 0.9))
            assert right[0] > left[0] + 10  # the bright patch is at +x, to the right of who looks along -z
        page.get_by_label("Surroundings", exact=True).select_option("studio")
        assert viewed.state("environment") == "studio"


def test_slopes_are_without_steps(chrome: Any, dusty: Path) -> None:
    """Means over blocks of pixels lie between the 255 steps, where the light's own do."""
    with Viewed(chrome, dusty) as viewed:
        viewed.settled().set(
            lobe=False, environment="none", tone="clip", lamp=0.4, exposure=-6, compare="one", ground=False
        )
        shown = viewed.complete().pixels().astype(float)
        data = viewed.js(
            "(() => { const r = app.picture.radiance(); return [r.width, r.height, Array.from(r.data)]; })()"
        )
    light = np.array(data[2]).reshape(data[1], data[0], 4)[::-1]
    whole = light[..., 3] > 0.999
    linear = np.clip(light[..., :3] / 64, 0, 1)
    exact = 255 * np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    misses = []
    for y in range(0, len(whole) - 8, 4):
        for x in range(0, whole.shape[1] - 8, 4):
            block = (slice(y, y + 8), slice(x, x + 8))
            if whole[block].all() and exact[block].min() > 0.6 and np.ptp(exact[block], axis=(0, 1)).max() < 2:
                misses.append((shown[block][..., :3] - exact[block]).mean((0, 1)))
    assert len(misses) > 20
    # Rounding alone misses by up to half a step, 0.29 in the mean square.
    assert np.sqrt(np.mean(np.square(misses))) < 0.12
    # Rounding alone gives the nearest step nearly everywhere; noise of half a step another one for a quarter of what lies between.
    clear = whole & (exact.min(-1) > 1)
    assert 0.15 < np.mean((shown[..., :3] != np.round(exact))[clear]) < 0.35


def test_the_page_on_paper(chrome: Any, tmp_path: Path) -> None:
    """Light, though the screen is dark; nothing overlaps; what is shown is there, and what sets it is not."""
    from test_report_paper import overlaps, sheets

    file = view(drying()).save(tmp_path / "plaster.html")
    with Viewed(chrome, file, color_scheme="dark") as viewed:
        viewed.settled().page.pdf(path=tmp_path / "page.pdf", format="A4")
    pages = sheets(tmp_path / "page.pdf")
    whole = " ".join(sheet.text for sheet in pages)
    for words in ("plaster", "Parameters", "Over time", "Reflection", "0.34"):
        assert words in whole
    for words in ("Reset all", "lamp height", "Tone mapping", "Open file"):
        assert words not in whole
    assert len(pages) <= 3
    for sheet in pages:
        assert overlaps(sheet.boxes) == 0
    pdfium = pytest.importorskip("pypdfium2")
    document = pdfium.PdfDocument(tmp_path / "page.pdf")
    first = np.array(document[0].render(scale=1).to_pil().convert("L"))
    document.close()
    assert np.median(first) > 225
    assert (first < 80).mean() > 0.002  # its words are dark, and the picture is there
