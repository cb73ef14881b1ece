"""``motes render map.zarr``: a fitted map from the command line, as pictures, films, on meshes and in scenes of one's own."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("zarr")
from PIL import Image

from maps_support import fitted_map
from motes import Lambert, Material
from motes.rendering.films import read_radiance
from motes.rendering.pictures import default_look
from plugin_support import needs_llvm
from rendering_support import Run, message

pytestmark = needs_llvm
SHAPE = (4, 6)
SMALL = ("--size", 24, "--samples", 4)
XML = """<scene version="3.0.0">
  <integrator type="path"/>
  <sensor type="orthographic">
    <transform name="to_world"><lookat origin="0, 0, 4" target="0, 0, 0" up="0, 1, 0"/></transform>
    <film type="hdrfilm"><integer name="width" value="24"/><integer name="height" value="24"/><rfilter type="box"/></film>
  </sensor>
  <emitter type="constant"/>
  <shape type="rectangle">
    <bsdf type="motes_map"><string name="filename" value="$material"/><float name="time" value="$time"/>
      <transform name="to_uv"><scale y="-1"/><translate y="1"/></transform></bsdf>
  </shape>
</scene>
"""


@pytest.fixture(autouse=True)
def wall(motes: Run) -> None:
    """In the folder of the test: a wall that grows brighter, red to the right and green downwards, without a fit at one texel."""
    y, x = np.indices(SHAPE)
    at_first = np.stack([(x + 1) / 12, (y + 1) / 12, 0.2 * np.ones(SHAPE)], -1)
    K_d = np.stack([at_first, 2 * at_first], axis=2)
    K_d[2, 5] = np.nan
    fitted_map(Path("wall.zarr"), "lambert", {"K_d": K_d}, hours=(2.0, 6.0))
    Material(Lambert(K_d=(0.5, 0.4, 0.3)), "paint").save("paint.json")


def test_a_map_is_a_flat_sample_of_its_own_aspect(motes: Run) -> None:
    status, out, err = motes("render", "wall.zarr", *SMALL, "-o", "wall.exr")
    assert (status, err) == (0, "")
    image = read_radiance(Path("wall.exr"))
    assert image.shape == (16, 24, 3)
    np.testing.assert_allclose(image[0, 0], [1 / 12, 1 / 12, 0.2], rtol=1e-3)  # half floats
    np.testing.assert_allclose(image[-1, -1], [6 / 12, 4 / 12, 0.2], rtol=1e-3)
    for words in ("flat, 1 x 1 panels", "2 h", "1 of 24 texels have no fit", "own texel (nearest)"):
        assert words in out
    assert motes("render", "wall.zarr", "--size", "9x9", "--samples", 1, "--quiet", "-o", "wall.png") == (0, "", "")
    with Image.open("wall.png") as picture:
        assert picture.size == (9, 9)
    assert default_look(aspect=6 / 4).size == (512, 341)
    assert default_look(aspect=6 / 4, scene="sphere").size == (512, 512)


def test_times_are_panels_and_frames(motes: Run) -> None:
    status, out, _ = motes("render", "wall.zarr", *SMALL, "--time", "2,4,6h", "--json", "-o", "wall.exr")
    assert (status, json.loads(out)["hours"]) == (0, [2, 4, 6])
    blue = [panel[0, 0, 2] for panel in np.split(read_radiance(Path("wall.exr")), 3, axis=1)]
    np.testing.assert_allclose(blue, [0.2, 0.3, 0.4], rtol=1e-3)
    status, out, _ = motes("render", "wall.zarr", *SMALL, "--time", "0:6h:3", "--keep-frames", "-o", "wall.gif")
    assert status == 0
    assert "the map has 2 to 6 h: outside the nearest scan is held" in out
    (folder,) = Path().glob("wall.frames-*")
    frames = [read_radiance(frame)[0, 0, 2] for frame in sorted(folder.glob("*.exr"))]
    np.testing.assert_allclose(frames, [0.2, 0.25, 0.4], rtol=1e-3)
    status, out, _ = motes("render", "wall.zarr", "--size", 4, "--samples", 1, "--json", "-o", "all.gif")
    told = json.loads(out)
    assert (len(told["hours"]), told["hours"][0], told["hours"][-1]) == (48, 2, 6)


def test_a_map_that_was_fitted_again_is_drawn_again(motes: Run) -> None:
    arguments = ("render", "wall.zarr", *SMALL, "--time", "2:6h:2", "--keep-frames", "--json", "-o", "wall.gif")
    assert json.loads(motes(*arguments)[1])["frames_kept"] == 0
    assert json.loads(motes(*arguments)[1])["frames_kept"] == 2
    import zarr

    zarr.open_group("wall.zarr", mode="r+", use_consolidated=False)["K_d"][0, 0] = 0.9
    assert json.loads(motes(*arguments)[1])["frames_kept"] == 0


def test_a_map_stands_beside_a_material(motes: Run) -> None:
    arguments = ("wall.zarr", "paint.json", *SMALL, "--gaps", "mark", "--filter", "bilinear", "--lamp", "20,0")
    status, out, _ = motes("render", *arguments, "-o", "both.exr")
    assert status == 0
    assert "texels have no fit: they are magenta" in out
    assert "their light is mixed, not their parameters (bilinear)" in out
    wall, paint = np.split(read_radiance(Path("both.exr")), 2, axis=1)
    np.testing.assert_allclose(wall[10, 22], [0.9, 0, 0.9], rtol=0.3, atol=0.1)
    # The material's own sample is square, in the middle of a film of the map's aspect.
    np.testing.assert_allclose(paint[:, 5:19], np.broadcast_to([0.5, 0.4, 0.3], (16, 14, 3)), rtol=1e-3)
    assert (paint[:, :3] == 0).all()


def test_a_scene_of_mitsuba_takes_a_map(motes: Run) -> None:
    Path("room.xml").write_text(XML)
    arguments = ("--scene", "room.xml", "--samples", 16, "--time", "6h", "--quiet", "-o", "room.exr")
    assert motes("render", "wall.zarr", *arguments) == (0, "", "")
    image = read_radiance(Path("room.exr"))
    shade = image / image[..., 2:]  # blue is the same everywhere; of the sky there is noise
    np.testing.assert_allclose(shade[1, 1], [1 / 6 / 0.4, 1 / 6 / 0.4, 1], rtol=2e-3)
    np.testing.assert_allclose(shade[-2, 1], [1 / 6 / 0.4, 4 / 6 / 0.4, 1], rtol=2e-3)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("measured-wall.zarr",), "measured-wall.zarr holds measured reflectance at every texel"),
        (("none.zarr",), "none.zarr does not exist"),
        (("wall.zarr", "--scene", "bunny"), "bunny has no texture coordinates"),
        (("wall.zarr", "--deposit"), "dust cannot be deposited on the map"),
        (("paint.json", "--scene", "flat", "--deposit"), "dust lies evenly on a flat sample"),
        (("wall.zarr", "--repeat", 0), "0 copies of a map"),
        (("wall.zarr", "--filter", "cubic"), "cubic"),
        (("wall.zarr", "--lamp", "high"), "--lamp 'high' is no direction"),
        (("wall.zarr", "--lamp", "89,0"), "the lamp at 89, 0 degrees is not above the sample"),
        (("wall.zarr", "--lamp", "45,0", "--scene", "sphere"), "--lamp was given for the scene sphere"),
        (("paint.json", "--repeat", 2), "--repeat was given, and nothing that is shown is a map"),
        (("paint.json", "--strict"), "--strict was given, and nothing that is shown is a map"),
        (("wall.zarr", "--gaps", "mark", "--scene", "room.xml"), "--gaps was given for room.xml"),
        (("wall.zarr", "--scene", "other.xml"), "other.xml has no place for the map"),
        (("still.zarr", "-o", "a.gif"), "nothing changes with time"),
    ],
)
def test_what_is_wrong_is_a_sentence_and_a_hint(motes: Run, arguments: tuple[object, ...], words: str) -> None:
    Path("room.xml").write_text(XML)
    Path("other.xml").write_text(XML.replace("motes_map", "motes_material"))
    if "still.zarr" in arguments:
        fitted_map(Path("still.zarr"), "lambert", {"K_d": np.full((*SHAPE, 1, 3), 0.5)})
    quick = ("--samples", 1) if any(str(a).endswith(".xml") for a in arguments) else ("--size", 16)
    status, out, err = motes("render", *arguments, *quick, *(() if "-o" in arguments else ("-o", "a.png")))
    assert (status, out) == (2, "")
    assert words in message(err)[0]


def test_where_one_material_is_asked_for_rendering_is_named(motes: Run) -> None:
    hint = message(motes("age", "wall.zarr", "--phenomenon", "dust")[2])[1]
    assert "motes render wall.zarr -o NAME.png shows it" in hint
