"""Pictures under known lights as a map: PNG and EXR decoding, the table of lights, what is refused."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("zarr")

import measurement_files as files
from image_files import PAETH, png_bytes, write_exr
from motes import maps
from motes.errors import DataError, FormatError, MotesError

# ---------------------------------------------------------------- folders


def photographs(folder: Path, values: np.ndarray, suffix: str = ".exr") -> list[str]:
    """A picture (y, x, 3) each, as they are (EXR) or as 16-bit sRGB (PNG); their names."""
    folder.mkdir()
    names = []
    for k, pixels in enumerate(values):
        names.append(f"light{k:02d}{suffix}")
        if suffix == ".exr":
            files.write_exr(folder / names[-1], pixels, np.float32)
        else:
            encoded = np.where(pixels <= 0.0031308, 12.92 * pixels, 1.055 * pixels ** (1 / 2.4) - 0.055)
            (folder / names[-1]).write_bytes(png_bytes(np.round(65535 * encoded).astype(np.uint16), [PAETH, 2]))
    return names


THETA, PHI = np.array([10.0, 40.0, 60.0, 75.0]), np.array([0.0, 90.0, 180.0, 300.0])


@pytest.mark.parametrize("suffix", [".exr", ".png"])
def test_pictures_become_a_map_that_fits(tmp_path: Path, suffix: str) -> None:
    if suffix == ".exr":
        pytest.importorskip("OpenEXR")
    rng = np.random.default_rng(5)
    K_d = rng.uniform(0.2, 0.9, (9, 7, 3))
    exposure, irradiance = np.array([0.5, 1.0, 1.5, 2.0]), 1.2
    factor = exposure * irradiance * np.cos(np.radians(THETA))
    names = photographs(tmp_path / "shots", K_d[None] / np.pi * factor[:, None, None, None], suffix)
    rows = [f"{n},{t},{p},{e},{irradiance}" for n, t, p, e in zip(names, THETA, PHI, exposure, strict=True)]
    table = (
        "# a rig\nfile,theta_i_deg,phi_i_deg,exposure,irradiance,note_iso\n"
        + "\n".join(f"{row},400" for row in rows)
        + "\n"
    )
    (tmp_path / "shots" / "lights.csv").write_text(table)
    stack = maps.import_images(tmp_path / "shots", tmp_path / "out.zarr", chunk=4)
    assert (stack.shape, stack.sizes, stack.name) == ((9, 7), (1, 4, 3), "shots")
    np.testing.assert_allclose(stack.wi[:, 2], np.cos(np.radians(THETA)))
    np.testing.assert_array_equal(stack.wo, np.tile([0, 0, 1], (4, 1)))
    tolerance = 1e-6 if suffix == ".exr" else 1e-3  # half a code in 65535, at the dark end
    np.testing.assert_allclose(stack.texels(8, 6)[0], np.tile(K_d[8, 6] / np.pi, (4, 1)), rtol=tolerance)
    fitted = maps.fit_map(stack, "lambert", out=tmp_path / "fit.zarr")
    np.testing.assert_allclose(fitted.values("K_d")[:, :, 0], K_d, rtol=tolerance)
    assert not [p for p in tmp_path.iterdir() if p.name.startswith(".motes")]


def test_times_viewers_and_gaps(tmp_path: Path) -> None:
    pytest.importorskip("OpenEXR")
    names = photographs(tmp_path / "shots", np.full((5, 2, 3, 3), 0.25) * np.arange(1, 6)[:, None, None, None])
    table = (
        "file;wi_x;wi_y;wi_z;theta_r;phi_r;time_min\n"
        f"{names[0]};0;0;2;0.5;0;0\n{names[1]};1e308;0;1e308;0.5;0;0\n"  # vectors of any length
        f"{names[2]};0;0;1;0.5;0;30\n{names[3]};1;0;1;0.5;0;30\n{names[4]};0;1;1;0.7;1;30\n"
    )
    (tmp_path / "shots" / "l.csv").write_text(table)
    (tmp_path / "shots" / "other.csv").write_text("")
    with pytest.raises(FormatError, match="holds 2 CSV files"):
        maps.import_images(tmp_path / "shots", tmp_path / "out.zarr")
    stack = maps.import_images(tmp_path / "shots", tmp_path / "out.zarr", table="l.csv")
    np.testing.assert_allclose(stack.hours, [0, 0.5])
    assert stack.sizes == (2, 3, 3)
    np.testing.assert_allclose(stack.wo[:, 2], np.cos([0.5, 0.5, 0.7]))
    values = stack.texels(1, 2)[..., 0]
    np.testing.assert_allclose(values[0, :2], [0.25, 0.5 * np.sqrt(2)], rtol=1e-5)
    np.testing.assert_allclose(values[1], [0.75, np.sqrt(2), 1.25 * np.sqrt(2)], rtol=1e-5)
    assert np.isnan(values[0, 2])  # this direction was not photographed at the first time


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "no rows"),
        ("file,theta_i\n", "no rows"),
        ("name,theta_i,phi_i\nlight00.exr,0,0\n", "needs the column file"),
        ("file,theta_i,phi_i\nlight00.exr,0\n", "row 2 has 2 cells"),
        ("file,theta_i,phi_i\nlight00.exr,zero,0\n", "not a number"),
        ("file,theta_i,phi_i\nlight00.exr,nan,0\n", "not finite"),
        ("file,theta_i,phi_i\nlight00.exr,30,0\n", "theta_i_deg for degrees"),
        ("file,theta_i_deg,phi_i\nlight00.exr,90,0\n", "at or below the horizon"),
        ("file,wi_x,wi_y,wi_z\nlight00.exr,1,0,-1\n", "at or below the horizon"),
        ("file,wi_x,wi_y,wi_z\nlight00.exr,0,0,0\n", r"\(0, 0, 0\)"),
        ("file,time\nlight00.exr,0\n", "direction to the light is not known"),
        ("file,theta_i,phi_i,exposure\nlight00.exr,0,0,0\n", "Both are above 0"),
        ("file,theta_i,phi_i,exposure\nlight00.exr,0,0,1e300\n", r"from 1e-12 to 1e\+12"),
        ("file,theta_i,phi_i,irradiance\nlight00.exr,0,0,1e-300\n", r"from 1e-12 to 1e\+12"),
        (
            "file,theta_i,phi_i,expossure\nlight00.exr,0,0,2\n",
            "'expossure', which is not known; the nearest are exposure",
        ),
        ("file,theta_i,phi_i,theta_i_deg\nlight00.exr,0,0,3\n", "theta of the light twice, in theta_i_deg and theta_i"),
        ("file,theta_i,phi_i,wi_x,wi_y,wi_z\nlight00.exr,0,0,0,0,1\n", "theta of the light twice, in theta_i and wi_x"),
        ("file,theta_i,phi_i,time,time_s\nlight00.exr,0,0,0,9\n", "the time twice, in time and time_s"),
        ("file,theta_i,phi_i\nmissing.exr,0,0\n", "does not exist"),
        ("file,theta_i,phi_i\n../secret.exr,0,0\n", "outside the folder"),
        ("file,theta_i,phi_i\nlight00.gif,0,0\n", "is not a picture that is read"),
        ("file,theta_i,phi_i\nlight00.exr,0,0\nwide.exr,1,0\n", "All pictures are of one size"),
        ("file,theta_i,phi_i\nbroken.exr,0,0\n", "no picture of a known format"),
        ("file,theta_i,phi_i\nlight00.exr,0,0\nbroken.png,0.1,0\n", "no picture of a known format"),
    ],
)
def test_bad_tables_and_pictures_leave_nothing(tmp_path: Path, text: str, words: str) -> None:
    pytest.importorskip("OpenEXR")
    folder = tmp_path / "shots"
    photographs(folder, np.full((1, 2, 3, 3), 0.25))
    files.write_exr(tmp_path / "secret.exr", np.zeros((2, 3, 3)))
    files.write_exr(folder / "wide.exr", np.zeros((2, 4, 3)))
    (folder / "broken.exr").write_bytes(b"x" * 100)
    (folder / "broken.png").write_bytes(b"x" * 100)
    (folder / "lights.csv").write_text(text)
    with pytest.raises((FormatError, DataError), match=words):
        maps.import_images(folder, tmp_path / "out.zarr")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["secret.exr", "shots"]


def test_folders_that_are_none(tmp_path: Path) -> None:
    with pytest.raises(FormatError, match="not a folder"):
        maps.import_images(tmp_path / "none", tmp_path / "out.zarr")
    with pytest.raises(FormatError, match="holds 0 CSV files"):
        maps.import_images(tmp_path, tmp_path / "out.zarr")
    with pytest.raises(FormatError, match="does not exist"):
        maps.import_images(tmp_path, tmp_path / "out.zarr", table="lights.csv")


def test_grey_pictures_and_what_is_there_already(tmp_path: Path) -> None:
    folder = tmp_path / "shots"
    folder.mkdir()
    (folder / "a.png").write_bytes(png_bytes(np.full((3, 4, 1), 100, np.uint8), [1]))
    (folder / "l.csv").write_text("file,theta_i,phi_i\na.png,0,0\n")
    stack = maps.import_images(folder, tmp_path / "out.zarr", linear=True)
    assert stack.channels == ("grey",)
    np.testing.assert_allclose(stack.texels(2, 3), 100 / 255, rtol=1e-6)
    with pytest.raises(MotesError, match="exists and is not empty"):
        maps.import_images(folder, tmp_path / "out.zarr")
    assert maps.open_map(tmp_path / "out.zarr").shape == (3, 4)


TRUTH = np.array([0.6, 0.4, 0.2])


def lit(folder: Path, write: Callable[[Path, np.ndarray], None], suffix: str) -> Path:
    """Pictures of a surface with K_d = TRUTH under four lights, each as `write` writes it."""
    folder.mkdir()
    rows = []
    for k, (theta, phi) in enumerate(zip(THETA, PHI, strict=True)):
        pixels = np.full((3, 4, 3), np.cos(np.radians(theta)) / np.pi) * TRUTH
        write(folder / f"shot{k}{suffix}", pixels)
        rows.append(f"shot{k}{suffix},{theta},{phi}")
    (folder / "lights.csv").write_text("file,theta_i_deg,phi_i_deg\n" + "\n".join(rows) + "\n")
    return folder


@pytest.mark.parametrize(
    "names", ["R G B A", "ViewLayer.Combined.R ViewLayer.Combined.G ViewLayer.Combined.B ViewLayer.Combined.A", "r g b"]
)
def test_layers_of_renderers_become_a_map(tmp_path: Path, names: str) -> None:
    pytest.importorskip("OpenEXR")

    def write(path: Path, pixels: np.ndarray) -> None:
        planes = [*np.moveaxis(pixels.astype(np.float32), -1, 0), np.ones((3, 4), np.float32)]
        write_exr(path, dict(zip(names.split(), planes, strict=False)))

    stack = maps.import_images(lit(tmp_path / "shots", write, ".exr"), tmp_path / "out.zarr")
    assert stack.channels == ("R", "G", "B")
    fitted = maps.fit_map(stack, "lambert", out=tmp_path / "fit.zarr")
    np.testing.assert_allclose(fitted.values("K_d")[:, :, 0], np.broadcast_to(TRUTH, (3, 4, 3)), rtol=1e-5)


def test_layers_that_are_ambiguous_are_settled_by_the_option(tmp_path: Path) -> None:
    pytest.importorskip("OpenEXR")

    def write(path: Path, pixels: np.ndarray) -> None:
        planes = np.moveaxis(pixels.astype(np.float32), -1, 0)
        both = {
            f"{layer}.{c}": p * (1 + (layer == "View.Direct"))
            for layer in ("View.Combined", "View.Direct")
            for c, p in zip("RGB", planes, strict=True)
        }
        write_exr(path, both)

    folder = lit(tmp_path / "shots", write, ".exr")
    with pytest.raises(
        FormatError, match=r"2 layers with colours: View.Combined, View.Direct. Choose one: --layer View.Combined"
    ):
        maps.import_images(folder, tmp_path / "out.zarr")
    assert not (tmp_path / "out.zarr").exists()
    stack = maps.import_images(folder, tmp_path / "out.zarr", layer="View.Combined")
    np.testing.assert_allclose(stack.texels(1, 1)[0] * np.pi, np.tile(TRUTH, (4, 1)), rtol=1e-5)
    assert "the layer View.Combined of OpenEXR pictures" in stack.attributes["notes"]


LINEAR = ((b"gAMA", (100000).to_bytes(4, "big")),)


@pytest.mark.parametrize(
    ("chunks", "options", "said"),
    [
        (LINEAR, {}, "pixels taken as linear: its gAMA chunk says 1"),
        ((), {"linear": True}, "pixels taken as linear: as asked"),
        ((), {"transfer": "linear"}, "pixels taken as linear: as asked"),
        (((b"sRGB", b"\0"),), {"transfer": "linear"}, "pixels taken as linear: as asked"),
    ],
)
def test_linear_png_are_taken_as_linear(tmp_path: Path, chunks: Any, options: Any, said: str) -> None:
    def write(path: Path, pixels: np.ndarray) -> None:
        path.write_bytes(png_bytes(np.round(pixels * 65535).astype(np.uint16), [PAETH], chunks=chunks))

    stack = maps.import_images(lit(tmp_path / "shots", write, ".png"), tmp_path / "out.zarr", **options)
    np.testing.assert_allclose(stack.texels(2, 3)[0] * np.pi, np.tile(TRUTH, (4, 1)), rtol=2e-3)
    assert said in stack.attributes["notes"]
    assert said in maps.open_map(stack.path).attributes["notes"]


def test_pictures_that_say_different_things_are_counted(tmp_path: Path) -> None:
    def write(path: Path, pixels: np.ndarray) -> None:
        linear = path.stem != "shot3"
        encoded = (
            pixels if linear else np.where(pixels <= 0.0031308, 12.92 * pixels, 1.055 * pixels ** (1 / 2.4) - 0.055)
        )
        path.write_bytes(png_bytes(np.round(encoded * 65535).astype(np.uint16), [0], chunks=LINEAR if linear else ()))

    stack = maps.import_images(lit(tmp_path / "shots", write, ".png"), tmp_path / "out.zarr")
    np.testing.assert_allclose(stack.texels(2, 3)[0] * np.pi, np.tile(TRUTH, (4, 1)), rtol=2e-3)
    notes = " ".join(stack.attributes["notes"])
    assert "gAMA chunk says 1 (3 of 4 pictures)" in notes
    assert "by custom they are then sRGB (1 of 4 pictures)" in notes


def test_both_linear_and_another_transfer_function_are_refused(tmp_path: Path) -> None:
    folder = lit(tmp_path / "shots", lambda path, pixels: path.write_bytes(b""), ".png")
    with pytest.raises(MotesError, match="both linear and the transfer function 'srgb'"):
        maps.import_images(folder, tmp_path / "out.zarr", linear=True, transfer="srgb")
