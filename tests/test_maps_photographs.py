"""Pictures under known lights as a map: PNG and EXR decoding, the table of lights, what is refused."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("zarr")

import contextlib

import measurement_files as files
from motes import maps
from motes.drawing.colour import srgb_encode
from motes.errors import DataError, FormatError, MotesError
from motes.images import png as _png
from motes.maps.photographs import picture, srgb_decode

PAETH = 4


def png_bytes(pixels: np.ndarray, filters: list[int], kind: int | None = None, interlace: int = 0) -> bytes:
    """A PNG by the book, each row with the filter asked for; pixels (y, x, C) of uint8 or uint16."""
    height, width, channels = pixels.shape
    bits = 8 * pixels.itemsize
    raw = pixels.astype(f">u{pixels.itemsize}").tobytes()
    step, line = channels * pixels.itemsize, channels * pixels.itemsize * width
    rows = [list(raw[y * line : (y + 1) * line]) for y in range(height)]
    out = bytearray()
    for y, row in enumerate(rows):
        f = filters[y % len(filters)]
        out.append(f)
        for x, value in enumerate(row):
            a = row[x - step] if x >= step else 0
            b = rows[y - 1][x] if y else 0
            c = rows[y - 1][x - step] if y and x >= step else 0
            nearest = min((a, b, c), key=lambda v: abs(a + b - c - v))  # the first of equals, as the standard wants
            out.append((value - (0, a, b, (a + b) // 2, nearest)[f]) % 256)
    kind = {1: 0, 2: 4, 3: 2, 4: 6}[channels] if kind is None else kind

    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    packed = zlib.compress(bytes(out))
    parts = [packed[: len(packed) // 2], packed[len(packed) // 2 :]]  # the standard allows several IDAT
    header = struct.pack(">IIBBBBB", width, height, bits, kind, 0, 0, interlace)
    body = chunk(b"IHDR", header) + chunk(b"tEXt", b"a\0b") + b"".join(chunk(b"IDAT", p) for p in parts)
    return _png.MAGIC + body + chunk(b"IEND", b"")


@pytest.mark.parametrize("channels", [1, 2, 3, 4])
@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
def test_png_of_every_filter(tmp_path: Path, channels: int, kind: type) -> None:
    rng = np.random.default_rng(1)
    smooth = np.add.outer(np.arange(11) * 5, np.arange(7) * 3)[..., None] + rng.integers(0, 40, (11, 7, channels))
    pixels = (smooth * (1 if kind is np.uint8 else 251)).astype(kind)
    (tmp_path / "a.png").write_bytes(png_bytes(pixels, [0, 1, 2, 3, PAETH, 3, 1]))
    found, largest = _png.read(tmp_path / "a.png")
    np.testing.assert_array_equal(found, pixels[..., : channels - 1 if channels in (2, 4) else channels])
    assert largest == np.iinfo(kind).max


def test_png_of_another_encoder(tmp_path: Path) -> None:
    Image = pytest.importorskip("PIL.Image")
    rng = np.random.default_rng(2)
    ramp = np.linspace(0, 200, 60)[None, :, None] + np.linspace(0, 50, 40)[:, None, None]
    pixels = (ramp + rng.integers(0, 5, (40, 60, 3))).astype(np.uint8)
    Image.fromarray(pixels).save(tmp_path / "a.png", optimize=True)
    np.testing.assert_array_equal(_png.read(tmp_path / "a.png")[0], pixels)
    deep = (ramp[..., 0] * 257).astype(np.uint16)
    Image.fromarray(deep).save(tmp_path / "b.png")
    np.testing.assert_array_equal(_png.read(tmp_path / "b.png")[0][..., 0], deep)


def test_damaged_png_are_refused(tmp_path: Path) -> None:
    good = png_bytes(np.zeros((4, 5, 3), np.uint8), [0])

    def with_size(width: int, height: int) -> bytes:
        header = b"IHDR" + struct.pack(">II", width, height) + good[24:29]
        return good[:12] + header + struct.pack(">I", zlib.crc32(header)) + good[33:]

    bad = {
        "no PNG": b"GIF89a" + good,
        "damaged": good[:60] + b"\xff" + good[61:],
        "has no header": _png.MAGIC,
        "of 16 bits, colour type 3": png_bytes(np.zeros((4, 5, 1), np.uint16), [0], kind=3),
        "interlaced": png_bytes(np.zeros((4, 5, 1), np.uint8), [0], interlace=1),
        "more than it can hold": with_size(2**31 - 1, 2**31 - 1),
        "is truncated": with_size(5, 6),
        "filter that does not exist": png_bytes_with_filter_9(),
    }
    for words, data in bad.items():
        (tmp_path / "a.png").write_bytes(data)
        with pytest.raises(FormatError, match=words.replace("no PNG", "not a PNG")):
            _png.read(tmp_path / "a.png")
    rng = np.random.default_rng(3)
    for _ in range(300):
        data = bytearray(good[: rng.integers(8, len(good))])
        data[rng.integers(0, len(data))] = rng.integers(0, 256)
        (tmp_path / "a.png").write_bytes(bytes(data))
        with contextlib.suppress(FormatError):
            _png.read(tmp_path / "a.png")


def png_bytes_with_filter_9() -> bytes:
    """A picture whose row names a filter that there is not."""
    data = zlib.compress(b"\x09" + bytes(3))
    parts = [(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)), (b"IDAT", data), (b"IEND", b"")]
    return _png.MAGIC + b"".join(
        struct.pack(">I", len(d)) + n + d + struct.pack(">I", zlib.crc32(n + d)) for n, d in parts
    )


def test_srgb_is_decoded_and_the_largest_code_is_clipped(tmp_path: Path) -> None:
    codes = np.arange(256, dtype=np.uint8).reshape(16, 16, 1)
    (tmp_path / "a.png").write_bytes(png_bytes(codes, [0]))
    decoded = picture(tmp_path / "a.png", linear=False).ravel()
    # The two anchors of IEC 61966-2-1, and the encoder of the report as its inverse.
    assert decoded[0] == 0
    assert decoded[128] == pytest.approx(0.21586, abs=1e-5)
    np.testing.assert_array_equal(srgb_encode(decoded[:255]), codes.ravel()[:255])
    assert np.isnan(decoded[255])
    np.testing.assert_allclose(picture(tmp_path / "a.png", linear=True).ravel()[:255], np.arange(255) / 255, rtol=1e-6)
    deep = np.array([[[0, 30000, 65535]]], np.uint16)
    (tmp_path / "b.png").write_bytes(png_bytes(deep, [0]))
    values = picture(tmp_path / "b.png", linear=False)[0, 0]
    assert values[1] == pytest.approx(float(srgb_decode(np.array(30000 / 65535))), rel=1e-6)
    assert np.isnan(values[2])


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
    table = "# a rig\nfile,theta_i_deg,phi_i_deg,exposure,irradiance\n" + "\n".join(rows) + "\n"
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
        f"{names[0]};0;0;2;0.5;0;0\n{names[1]};3;0;3;0.5;0;0\n"  # vectors of any length
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
        ("file,theta_i,phi_i\nmissing.exr,0,0\n", "does not exist"),
        ("file,theta_i,phi_i\n../secret.exr,0,0\n", "outside the folder"),
        ("file,theta_i,phi_i\nlight00.tiff,0,0\n", "PNG and OpenEXR"),
        ("file,theta_i,phi_i\nlight00.exr,0,0\nwide.exr,1,0\n", "All pictures are of one size"),
        ("file,theta_i,phi_i\nbroken.exr,0,0\n", "not a complete OpenEXR"),
        ("file,theta_i,phi_i\nlight00.exr,0,0\nbroken.png,0.1,0\n", "not a PNG"),
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
