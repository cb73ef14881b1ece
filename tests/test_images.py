"""Pictures: PNG, TIFF, JPEG and OpenEXR as other programs write them; what their numbers mean; what is refused."""

from __future__ import annotations

import struct
import threading
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from image_files import MAGIC, PAETH, png_bytes, write_exr, write_parts
from motes.drawing.colour import srgb_encode
from motes.errors import FormatError, MissingExtraError, MotesError
from motes.files import budget
from motes.images import exr, transfer_functions
from motes.images.photograph import open_photograph, read_mask
from motes.images.transfer_functions import asked, srgb_decode

pytest.importorskip("OpenImageIO")


def linear(path: Path, **options: Any) -> np.ndarray:
    return open_photograph(path, **options).linear()


def grey(codes: list[int], kind: type = np.uint16) -> np.ndarray:
    return np.array(codes, kind).reshape(1, -1, 1)


# ---------------------------------------------------------------- PNG


@pytest.mark.parametrize("channels", [1, 2, 3, 4])
@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
def test_png_of_every_filter_comes_out_code_by_code(tmp_path: Path, channels: int, kind: type) -> None:
    rng = np.random.default_rng(1)
    smooth = np.add.outer(np.arange(11) * 5, np.arange(7) * 3)[..., None] + rng.integers(0, 40, (11, 7, channels))
    pixels = (smooth * (1 if kind is np.uint8 else 251)).astype(kind)
    (tmp_path / "a.png").write_bytes(png_bytes(pixels, [0, 1, 2, 3, PAETH, 3, 1]))
    found = open_photograph(tmp_path / "a.png")
    np.testing.assert_array_equal(found.stored, pixels[..., : channels - 1 if channels in (2, 4) else channels])
    assert found.largest == np.iinfo(kind).max


def test_png_of_other_encoders(tmp_path: Path) -> None:
    Image = pytest.importorskip("PIL.Image")
    png = pytest.importorskip("png")
    rng = np.random.default_rng(2)
    ramp = np.linspace(0, 200, 60)[None, :, None] + np.linspace(0, 50, 40)[:, None, None]
    pixels = (ramp + rng.integers(0, 5, (40, 60, 3))).astype(np.uint8)
    path = tmp_path / "a.png"
    Image.fromarray(pixels).save(path, optimize=True)
    np.testing.assert_array_equal(open_photograph(path).stored, pixels)
    deep = (ramp[..., 0] * 257).astype(np.uint16)
    Image.fromarray(deep).save(path)
    np.testing.assert_array_equal(open_photograph(path).stored[..., 0], deep)
    colours = (pixels.astype(np.uint16) * 255 + 17).reshape(40, -1)
    with path.open("wb") as file:
        png.Writer(60, 40, greyscale=False, bitdepth=16, interlace=True).write(file, colours)
    np.testing.assert_array_equal(open_photograph(path).stored.reshape(40, -1), colours)
    Image.fromarray(pixels).quantize(5).save(path)  # a palette
    np.testing.assert_array_equal(open_photograph(path).stored, np.asarray(Image.open(path).convert("RGB")))
    for bits in (1, 2, 4):
        top = 2**bits - 1
        with path.open("wb") as file:
            png.Writer(4, 1, greyscale=True, bitdepth=bits).write(file, [[0, 1, top, 0]])
        np.testing.assert_allclose(read_mask(path), [[0, 1 / top, 1, 0]], atol=1 / 500)


def chrm(primaries: tuple[float, ...]) -> bytes:
    return struct.pack(">8I", *(round(x * 1e5) for x in (*primaries[6:], *primaries[:6])))


def gama(value: float) -> bytes:
    return struct.pack(">I", round(value * 1e5))


SAID: list[tuple[str, tuple[tuple[bytes, bytes], ...], Callable[[np.ndarray], np.ndarray]]] = [
    ("nothing", (), srgb_decode),
    ("sRGB", ((b"sRGB", b"\0"),), srgb_decode),
    ("sRGB before gAMA", ((b"gAMA", gama(1)), (b"sRGB", b"\0")), srgb_decode),
    ("linear", ((b"gAMA", gama(1)),), lambda e: e),
    ("gamma 2.2", ((b"gAMA", gama(1 / 2.2)),), lambda e: e**2.2),
    ("gamma 1.8", ((b"gAMA", gama(1 / 1.8)),), lambda e: e**1.8),
    ("sRGB's own cHRM", ((b"gAMA", gama(1)), (b"cHRM", chrm(transfer_functions.SRGB))), lambda e: e),
    ("cICP linear", ((b"gAMA", gama(0.45455)), (b"cICP", bytes([1, 8, 0, 1]))), lambda e: e),
    ("cICP sRGB", ((b"gAMA", gama(1)), (b"cICP", bytes([1, 13, 0, 1]))), srgb_decode),
]


@pytest.mark.parametrize(("what", "chunks", "curve"), SAID, ids=[one[0] for one in SAID])
@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
def test_a_png_says_what_its_numbers_are(
    tmp_path: Path, what: str, chunks: Any, curve: Callable[[np.ndarray], np.ndarray], kind: type
) -> None:
    top = np.iinfo(kind).max
    codes = np.round(np.linspace(0, 0.95, 24).reshape(2, 4, 3) * top).astype(kind)
    (tmp_path / "a.png").write_bytes(png_bytes(codes, [0], chunks=chunks))
    np.testing.assert_allclose(linear(tmp_path / "a.png"), curve(codes / top), rtol=1e-4, atol=1e-7)
    # What somebody says stands above what the file says.
    np.testing.assert_allclose(linear(tmp_path / "a.png", stated=asked("linear")), codes / top, rtol=1e-6)


def test_srgb_is_decoded_and_the_largest_code_is_clipped(tmp_path: Path) -> None:
    (tmp_path / "a.png").write_bytes(png_bytes(np.arange(256, dtype=np.uint8).reshape(16, 16, 1), [0]))
    decoded = linear(tmp_path / "a.png").ravel()
    # The two anchors of IEC 61966-2-1, and the encoder of the report as its inverse.
    assert decoded[0] == 0
    assert decoded[128] == pytest.approx(0.21586, abs=1e-5)
    np.testing.assert_array_equal(srgb_encode(decoded[:255]), np.arange(255))
    assert np.isnan(decoded[255])


def test_other_primaries_are_turned_into_those_of_srgb(tmp_path: Path) -> None:
    cms = pytest.importorskip("imagecodecs")
    adobe = (0.64, 0.33, 0.21, 0.71, 0.15, 0.06, 0.3127, 0.3290)
    wide = (0.7347, 0.2653, 0.1596, 0.8404, 0.0366, 0.0001, 0.3457, 0.3585)  # ProPhoto, white D50
    rng = np.random.default_rng(3)
    codes = rng.integers(6000, 60000, (5, 6, 3), np.uint16)
    target = cms.cms_profile(
        "rgb", whitepoint=transfer_functions.SRGB[6:], primaries=transfer_functions.SRGB[:6], gamma=1.0
    )
    for primaries in (adobe, transfer_functions.BT2020, transfer_functions.P3_D65, (*wide[:5], 0.001, *wide[6:])):
        chunks = ((b"gAMA", gama(1)), (b"cHRM", chrm(primaries)))
        (tmp_path / "a.png").write_bytes(png_bytes(codes, [0], chunks=chunks))
        own = cms.cms_profile("rgb", whitepoint=primaries[6:], primaries=primaries[:6], gamma=1.0)
        expected = cms.cms_transform(
            codes, own, target, colorspace="rgb", outcolorspace="rgb", outdtype="float32", intent=1
        )
        np.testing.assert_allclose(linear(tmp_path / "a.png"), expected, atol=2e-4)  # LittleCMS, through profiles
    np.testing.assert_allclose(transfer_functions.to_srgb((*wide[:5], 0.001, *wide[6:])) @ np.ones(3), 1, atol=1e-9)
    codes[0, 0] = 30000
    codes[0, 1] = (65535, 200, 300)  # a channel that is clipped takes part in all three
    (tmp_path / "a.png").write_bytes(png_bytes(codes, [0], chunks=((b"gAMA", gama(1)), (b"cHRM", chrm(adobe)))))
    found = linear(tmp_path / "a.png")
    np.testing.assert_allclose(found[0, 0], 30000 / 65535, rtol=1e-3)  # grey stays grey
    assert np.isnan(found[0, 1]).all()
    assert np.isfinite(found).sum() == 5 * 6 * 3 - 3


def iccp(profile: bytes) -> bytes:
    return b"a profile\0\0" + zlib.compress(profile)


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
def test_profiles_are_followed(tmp_path: Path, kind: type) -> None:
    cms = pytest.importorskip("imagecodecs")
    top = np.iinfo(kind).max
    codes = np.round(np.linspace(0.02, 0.98, 24).reshape(2, 4, 3) * top).astype(kind)
    path = tmp_path / "a.png"
    path.write_bytes(png_bytes(codes, [0], chunks=((b"gAMA", gama(1)), (b"iCCP", iccp(cms.cms_profile("srgb"))))))
    np.testing.assert_allclose(linear(path), srgb_decode(codes / top), atol=2e-5)
    path.write_bytes(
        png_bytes(
            codes[..., :1],
            [0],
            chunks=((b"iCCP", iccp(cms.cms_profile("gray", whitepoint=(0.3457, 0.3585, 1), gamma=2.2))),),
        )
    )
    np.testing.assert_allclose(linear(path), (codes[..., :1] / top) ** 2.2, atol=2e-5)
    for damage in (b"x" * 200, cms.cms_profile("srgb")[:300], b""):
        path.write_bytes(png_bytes(codes, [0], chunks=((b"iCCP", iccp(damage)),)))
        with pytest.raises(FormatError, match=r"ICC profile.*--transfer"):
            linear(path)
        np.testing.assert_allclose(linear(path, stated=asked("srgb")), srgb_decode(codes / top), rtol=1e-5)
    path.write_bytes(png_bytes(codes, [0], chunks=((b"iCCP", b"a\0\0" + zlib.compress(bytes(40 * 2**20))),)))
    with pytest.raises(FormatError, match="is damaged"):
        linear(path)


def test_alpha_is_never_data(tmp_path: Path) -> None:
    codes = np.full((2, 2, 4), 100, np.uint8)
    codes[..., 3] = [[255, 128], [1, 0]]
    (tmp_path / "a.png").write_bytes(png_bytes(codes, [0]))
    found = linear(tmp_path / "a.png", stated=asked("linear"))
    np.testing.assert_allclose(
        found[:, :, 0], [[100 / 255] * 2, [100 / 255, np.nan]], rtol=1e-6
    )  # not multiplied by it
    codes[..., 3] = 0  # of programs that have no use for it
    (tmp_path / "a.png").write_bytes(png_bytes(codes, [0]))
    assert np.isfinite(linear(tmp_path / "a.png")).all()


def test_an_alpha_of_signalling_nan_is_read(tmp_path: Path) -> None:
    alpha = np.full((2, 3), 0x7D01, np.uint16).view(np.float16)
    write_exr(tmp_path / "a.exr", {name: np.full((2, 3), 0.5, np.float16) for name in "RGB"} | {"A": alpha})
    assert (linear(tmp_path / "a.exr") == 0.5).all()


def test_damaged_png_are_refused(tmp_path: Path) -> None:
    good = png_bytes(np.zeros((4, 5, 3), np.uint8), [0])

    def with_size(width: int, height: int) -> bytes:
        header = b"IHDR" + struct.pack(">II", width, height) + good[24:29]
        return good[:12] + header + struct.pack(">I", zlib.crc32(header)) + good[33:]

    def of(chunks: list[tuple[bytes, bytes]]) -> bytes:
        parts = [struct.pack(">I", len(d)) + n + d + struct.pack(">I", zlib.crc32(n + d)) for n, d in chunks]
        return MAGIC + b"".join(parts)

    ihdr = struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)
    bad = {
        "no picture of a known format": b"GIF89a" + good,
        "damaged at byte": good[:60] + b"\xff" + good[61:],
        "has no header": of([(b"IDAT", b""), (b"IEND", b"")]),
        "cannot be decoded": png_bytes(np.zeros((4, 5, 1), np.uint16), [0], kind=3),
        "2147483647 x 2147483647 pixels, and 1,000,000": with_size(2**31 - 1, 2**31 - 1),
        "would take .* MiB of memory": with_size(5000, 5000) + bytes(100_000),
        "pixels end after 64 of 96 bytes": with_size(5, 6),
        "cut short": good[:-12],
        "a row has the filter 9": of([(b"IHDR", ihdr), (b"IDAT", zlib.compress(b"\x09" + bytes(3))), (b"IEND", b"")]),
        "gAMA chunk says 0": png_bytes(np.zeros((4, 5, 3), np.uint8), [0], chunks=((b"gAMA", bytes(4)),)),
        "cICP chunk names": png_bytes(np.zeros((4, 5, 3), np.uint8), [0], chunks=((b"cICP", bytes([9, 16, 0, 1])),)),
        "span no colours": png_bytes(
            np.zeros((4, 5, 3), np.uint8), [0], chunks=((b"gAMA", gama(1)), (b"cHRM", bytes(32)))
        ),
    }
    for words, data in bad.items():
        (tmp_path / "a.png").write_bytes(data)
        with pytest.raises(FormatError, match=words):
            linear(tmp_path / "a.png")
    with pytest.raises(FormatError, match="cannot be read: No such file"):
        open_photograph(tmp_path / "none.png")


# ---------------------------------------------------------------- TIFF and JPEG


def test_tiff_and_jpeg_say_it_or_are_told(tmp_path: Path) -> None:
    tifffile, Image = pytest.importorskip("tifffile"), pytest.importorskip("PIL.Image")
    cms = pytest.importorskip("imagecodecs")
    codes = np.random.default_rng(4).integers(0, 65000, (5, 6, 3), np.uint16)
    path = tmp_path / "a.tif"
    for options in ({}, {"compression": "zlib", "predictor": True}, {"byteorder": ">"}, {"planarconfig": "separate"}):
        pixels = np.moveaxis(codes, -1, 0) if "planarconfig" in options else codes
        tifffile.imwrite(path, pixels, photometric="rgb", **options)
        with pytest.raises(FormatError, match=r"TIFF that does not say what its numbers are.* --transfer linear"):
            open_photograph(path)
        np.testing.assert_allclose(linear(path, stated=asked("linear")), codes / 65535, rtol=1e-6)
        np.testing.assert_allclose(linear(path, stated=asked("2.2")), (codes / 65535) ** 2.2, rtol=1e-5)
    tifffile.imwrite(path, codes, photometric="rgb", iccprofile=cms.cms_profile("srgb"))
    np.testing.assert_allclose(linear(path), srgb_decode(codes / 65535), atol=2e-5)
    values = codes.astype(np.float32) / 1e5
    values[0, 0, 0] = np.inf
    tifffile.imwrite(path, values, photometric="rgb")
    np.testing.assert_array_equal(linear(path), np.where(np.isfinite(values), values, np.nan))
    tifffile.imwrite(path, codes[..., 0], photometric="minisblack")
    np.testing.assert_allclose(linear(path, stated=asked("linear"))[..., 0], codes[..., 0] / 65535, rtol=1e-6)
    tifffile.imwrite(path, np.stack([codes[..., 0]] * 2), photometric="minisblack")
    with pytest.raises(FormatError, match="several pages"):
        open_photograph(path, asked("linear"))
    photo = Image.fromarray((codes >> 8).astype(np.uint8))
    photo.convert("CMYK").save(path)
    with pytest.raises(FormatError, match="CMYK"):
        open_photograph(path, asked("srgb"))
    jpeg = tmp_path / "a.jpg"
    photo.convert("CMYK").save(jpeg)
    with pytest.raises(FormatError, match="CMYK"):
        open_photograph(jpeg, asked("srgb"))
    photo.save(jpeg, quality=100, subsampling=0)
    with pytest.raises(FormatError, match="JPEG that does not say"):
        open_photograph(jpeg)
    np.testing.assert_allclose(linear(jpeg, stated=asked("linear")), codes / 65535, atol=0.02)
    camera = photo.getexif()
    camera.get_ifd(0x8769)[0xA001] = 1
    photo.save(jpeg, quality=100, subsampling=0, exif=camera)
    np.testing.assert_allclose(linear(jpeg), srgb_decode(codes / 65535), atol=0.04)
    photo.save(jpeg, quality=100, subsampling=0, icc_profile=cms.cms_profile("srgb"))
    np.testing.assert_allclose(linear(jpeg), srgb_decode(codes / 65535), atol=0.04)


@pytest.mark.parametrize("orientation", range(1, 9))
def test_pictures_are_turned_as_they_are_looked_at(tmp_path: Path, orientation: int) -> None:
    Image, Ops = pytest.importorskip("PIL.Image"), pytest.importorskip("PIL.ImageOps")
    pixels = np.zeros((4, 6, 3), np.uint8)
    pixels[0, 0], pixels[0, -1], pixels[-1, 0] = 40, 90, 160
    picture = Image.fromarray(pixels)
    said = picture.getexif()
    said[0x0112] = orientation
    picture.save(tmp_path / "a.tif", exif=said)
    expected = np.asarray(Ops.exif_transpose(Image.open(tmp_path / "a.tif")))
    np.testing.assert_array_equal(open_photograph(tmp_path / "a.tif", asked("linear")).stored, expected)


@pytest.mark.parametrize("text", ["", "sRGBish", "0", "-2.2", "nan", "1e9"])
def test_transfer_functions_that_are_none(text: str) -> None:
    with pytest.raises(MotesError, match=r"is not known. Say linear, srgb, or an exponent"):
        asked(text)


# ---------------------------------------------------------------- OpenEXR

R, G, B, A = (np.full((3, 4), value, np.float32) for value in (0.6, 0.4, 0.2, 0.9))
NAMES = {
    "plain": ("R", "G", "B"),
    "with alpha": ("R", "G", "B", "A"),
    "Blender": tuple(f"ViewLayer.Combined.{c}" for c in "RGBA"),
    "V-Ray": (".R", ".G", ".B", ".A"),
    "lower case": ("r", "g", "b"),
    "words": ("red", "green", "blue", "alpha"),
    "deep names": tuple(f"Scene.View.Layer.Combined.{c}" for c in "RGBA"),
}


@pytest.mark.parametrize("kind", [np.float16, np.float32])
@pytest.mark.parametrize("names", list(NAMES.values()), ids=list(NAMES))
def test_colours_are_found_by_their_last_letter(tmp_path: Path, names: tuple[str, ...], kind: type) -> None:
    pytest.importorskip("OpenEXR")
    values = dict(zip(names, (c.astype(kind) for c in (R, G, B, A)), strict=False))
    found = exr.read_exr(write_exr(tmp_path / "a.exr", values), "a test")
    np.testing.assert_allclose(found.values, np.broadcast_to([0.6, 0.4, 0.2], (3, 4, 3)), rtol=1e-3)
    assert (found.alpha is None) == (len(names) == 3)


def test_layers_are_taken_by_name_and_never_guessed(tmp_path: Path) -> None:
    pytest.importorskip("OpenEXR")
    view = {f"ViewLayer.Combined.{c}": v for c, v in zip("RGBA", (R, G, B, A), strict=True)}
    depth = {"ViewLayer.Depth.Z": 5 * R, **{f"ViewLayer.Normal.{c}": G for c in "XYZ"}}
    path = write_exr(tmp_path / "a.exr", view | depth)
    assert exr.read_exr(path, "a test").layer == "ViewLayer.Combined"
    np.testing.assert_array_equal(exr.read_exr(path, "a test", "ViewLayer.Depth.Z").values[..., 0], 5 * R)
    with pytest.raises(FormatError, match=r"no layer or channel 'Depth'; it has the channels .*Depth.Z"):
        exr.read_exr(path, "a test", "Depth")
    direct = {f"ViewLayer.DiffDir.{c}": v for c, v in zip("RGB", (B, B, B), strict=True)}
    write_exr(path, view | depth | direct)
    with pytest.raises(FormatError, match=r"2 layers with colours: .* Choose one: --layer ViewLayer"):
        exr.read_exr(path, "a test")
    np.testing.assert_array_equal(exr.read_exr(path, "a test", "ViewLayer.DiffDir").values, np.stack([B] * 3, -1))
    write_exr(path, {"R": R, "G": G, "B": B} | direct)
    np.testing.assert_array_equal(
        exr.read_exr(path, "a test").values[..., 1], G
    )  # the layer without a name is the picture


@pytest.mark.parametrize(
    "channels",
    [
        {"A": A},
        {"B": B},
        {"R": R, "G": G},
        {"X": R, "Y": G, "Z": B},
        {"Z": R},
        {"Y": R, "R": G},
        {"450nm": R, "550nm": G},
    ],
    ids=lambda c: "+".join(c),
)
def test_what_is_not_colour_is_refused_with_its_names(tmp_path: Path, channels: dict[str, np.ndarray]) -> None:
    pytest.importorskip("OpenEXR")
    path = write_exr(tmp_path / "a.exr", channels)
    with pytest.raises(FormatError, match=f"the channels .*{next(iter(channels))}.*--layer"):
        exr.read_exr(path, "a test")


@pytest.mark.parametrize("name", ["Y", "L", "grey", "luminance", "View.Y"])
def test_a_grey_alone_is_grey(tmp_path: Path, name: str) -> None:
    pytest.importorskip("OpenEXR")
    found = open_photograph(write_exr(tmp_path / "a.exr", {name: G, "A": A}))
    assert found.shape == (3, 4, 1)
    np.testing.assert_array_equal(found.linear()[..., 0], G)


def test_parts(tmp_path: Path) -> None:
    pytest.importorskip("OpenEXR")
    colours = {"R": R, "G": G, "B": B, "A": A}
    path = write_parts(tmp_path / "a.exr", {"beauty": colours, "depth": {"Z": R}})
    found = exr.read_exr(path, "a test")
    np.testing.assert_array_equal(found.values, np.stack([R, G, B], -1))
    assert found.layer == "beauty"
    np.testing.assert_array_equal(exr.read_exr(path, "a test", "depth.Z").values[..., 0], R)
    write_parts(path, {"left": colours, "right": {"R": B, "G": B, "B": B}})
    with pytest.raises(FormatError, match=r"2 layers with colours: left, right. Choose one: --layer left"):
        exr.read_exr(path, "a test")
    np.testing.assert_array_equal(exr.read_exr(path, "a test", "right").values[..., 0], B)


def windows(data: tuple[int, int, int, int], display: tuple[int, int, int, int]) -> dict[str, Any]:
    def box(b: tuple[int, int, int, int]) -> Any:
        return np.array(b[:2], np.int32), np.array(b[2:], np.int32)

    return {"dataWindow": box(data), "displayWindow": box(display)}


def test_a_tile_larger_than_the_picture_is_refused_where_it_takes_too_much(tmp_path: Path) -> None:
    """It is decoded whole, whatever lies in it."""
    from OpenImageIO import ImageOutput, ImageSpec

    spec = ImageSpec(24, 20, 3, "half")
    spec.tile_width, spec.tile_height = 16, 16
    output = ImageOutput.create(str(tmp_path / "a.exr"))
    output.open(str(tmp_path / "a.exr"), spec)
    output.write_image(np.full((20, 24, 3), 0.5, np.float16))
    output.close()
    whole = (tmp_path / "a.exr").read_bytes()
    assert exr.read_exr(tmp_path / "a.exr", "tests").values.shape == (20, 24, 3)
    sizes = (16).to_bytes(4, "little") * 2
    at = whole.index(b"tiledesc") + len("tiledesc") + 1 + 4
    assert whole[at : at + 8] == sizes
    (tmp_path / "b.exr").write_bytes(whole[:at] + (1 << 20).to_bytes(4, "little") + sizes[4:] + whole[at + 8 :])
    with pytest.raises(FormatError, match="a tile of 1048576 x 16 pixels would take"):
        exr.read_exr(tmp_path / "b.exr", "tests")


def test_a_picture_is_what_its_display_window_shows(tmp_path: Path) -> None:
    pytest.importorskip("OpenEXR")
    ramp = np.arange(12, dtype=np.float32).reshape(3, 4)
    colours = {"R": ramp, "G": ramp, "B": ramp}
    cropped = exr.read_exr(
        write_exr(tmp_path / "a.exr", colours, **windows((2, 1, 5, 3), (0, 0, 7, 4))), "a test"
    ).values
    assert cropped.shape == (5, 8, 3)
    np.testing.assert_array_equal(cropped[1:4, 2:6, 0], ramp)
    assert np.isnan(cropped).sum() == (40 - 12) * 3
    beyond = exr.read_exr(
        write_exr(tmp_path / "a.exr", colours, **windows((-1, -1, 2, 1), (0, 0, 1, 0))), "a test"
    ).values
    np.testing.assert_array_equal(beyond[..., 0], ramp[1:2, 1:3])
    with pytest.raises(FormatError, match="display window of 100000 x 100000 pixels would take"):
        exr.read_exr(write_exr(tmp_path / "a.exr", colours, **windows((0, 0, 3, 2), (0, 0, 99999, 99999))), "a test")


def test_chromaticities_and_ids(tmp_path: Path) -> None:
    pytest.importorskip("OpenEXR")
    colours = {"R": R, "G": G, "B": B}
    wide = open_photograph(write_exr(tmp_path / "a.exr", colours, chromaticities=transfer_functions.BT2020)).linear()
    np.testing.assert_allclose(
        wide[0, 0], transfer_functions.to_srgb(transfer_functions.BT2020) @ [0.6, 0.4, 0.2], rtol=1e-5
    )
    plain = open_photograph(write_exr(tmp_path / "a.exr", colours, chromaticities=transfer_functions.SRGB)).linear()
    np.testing.assert_array_equal(plain[0, 0], np.float32([0.6, 0.4, 0.2]))
    write_exr(tmp_path / "a.exr", {"Y": np.ones((3, 4), np.uint32)})
    with pytest.raises(FormatError, match="holds uint, which is for names"):
        exr.read_exr(tmp_path / "a.exr", "a test")


def test_what_is_written_is_read_by_another_library(tmp_path: Path) -> None:
    OpenEXR = pytest.importorskip("OpenEXR")
    values = np.random.default_rng(5).normal(size=(7, 5, 3)).astype(np.float32)
    exr.write(tmp_path / "a.exr", values, "a test")
    with OpenEXR.File(str(tmp_path / "a.exr"), separate_channels=True) as file:
        for k, name in enumerate("RGB"):
            np.testing.assert_array_equal(file.channels()[name].pixels, values[..., k])
    np.testing.assert_array_equal(exr.read_exr(tmp_path / "a.exr", "a test").values, values)
    with pytest.raises(MotesError, match=r"cannot be written|No such"):
        exr.write(tmp_path / "a.exr" / "b.exr", values, "a test")


def test_many_channels_count_and_few_are_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("OpenEXR")
    flat = np.zeros((400, 500), np.float32)
    path = write_exr(tmp_path / "a.exr", {"R": flat, "G": flat, "B": flat} | {f"x{k}.Z": flat for k in range(20)})
    monkeypatch.setattr(budget, "LEAST", 2**20)
    assert path.stat().st_size < 100_000
    with pytest.raises(
        FormatError, match=r"16 lines of 500 pixels, which are packed together, would take 1 MiB of memory"
    ):
        exr.read_exr(path, "a test")


def test_reading_in_threads_leaves_the_terminal_alone(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    """Also of damaged files: nothing is printed, and what others print is seen."""
    import os

    pytest.importorskip("OpenEXR")
    noise = np.random.default_rng(6).normal(size=(64, 64)).astype(np.float32)
    whole = write_exr(tmp_path / "a.exr", {"R": noise, "G": noise, "B": noise}).read_bytes()
    (tmp_path / "b.exr").write_bytes(whole[:-3000])
    refused: list[str] = []

    def work() -> None:
        for name in ("a.exr", "b.exr") * 5:
            try:
                exr.read_exr(tmp_path / name, "a test")
            except FormatError as error:
                refused.append(str(error))
            os.write(2, b"said\n")

    threads = [threading.Thread(target=work) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(refused) == 40
    print("heard")
    out, err = capfd.readouterr()
    assert (out, err) == ("heard\n", "said\n" * 80)


# ---------------------------------------------------------------- all of them


def samples(folder: Path) -> dict[str, bytes]:
    tifffile, Image = pytest.importorskip("tifffile"), pytest.importorskip("PIL.Image")
    pytest.importorskip("OpenEXR")
    codes = np.random.default_rng(7).integers(0, 65000, (12, 10, 3), np.uint16)
    tifffile.imwrite(folder / "z.tif", codes, photometric="rgb", compression="zlib")
    Image.fromarray((codes >> 8).astype(np.uint8)).save(folder / "j.jpg")
    names = {f"V.C.{c}": codes[..., k].astype(np.float32) for k, c in enumerate("RGB")}
    write_exr(folder / "e.exr", names | {"Z": names["V.C.R"]})
    write_parts(folder / "m.exr", {"a": names, "b": {"Z": names["V.C.R"]}})
    made = {path.name: path.read_bytes() for path in folder.iterdir()}
    return made | {
        "p.png": png_bytes(codes, [1, PAETH], chunks=((b"gAMA", gama(0.5)), (b"cHRM", chrm(transfer_functions.BT2020))))
    }


def mended_checksums(data: bytes) -> bytes:
    """A PNG whose checksums hold again, so that damage gets as far as the decoder."""
    at, parts = 8, [data[:8]]
    while at + 12 <= len(data):
        (n,) = struct.unpack_from(">I", data, at)
        body = data[at + 4 : at + 8 + n]
        parts.append(data[at : at + 8 + n] + struct.pack(">I", zlib.crc32(body)))
        at += 12 + n
    return b"".join(parts)


def test_mutated_pictures_give_numbers_or_a_sentence(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    """And nothing on the terminal: libpng, below OpenImageIO, says what is wrong with a file there, past everybody, unless it is found before."""
    (tmp_path / "good").mkdir()
    rng = np.random.default_rng(8)
    answers: dict[str, int] = {}
    for name, good in samples(tmp_path / "good").items():
        path = tmp_path / name
        for k in range(500):
            data = bytearray(good)
            for _ in range(rng.integers(1, 4)):
                data[rng.integers(0, min(len(data), 600) if k % 2 else len(data))] = rng.integers(0, 256)
            if k % 5 == 0:
                data = data[: rng.integers(1, len(data))]
            path.write_bytes(mended_checksums(bytes(data)) if name == "p.png" and k % 4 else bytes(data))
            try:
                picture = open_photograph(path, None if name.endswith(("exr", "png")) else asked("srgb"))
                assert picture.linear().dtype == np.float32
                answers[name] = answers.get(name, 0) + 1
            except FormatError:
                pass
    assert min(answers.get(name, 0) for name in ("z.tif", "j.jpg", "e.exr", "m.exr", "p.png")) > 4
    assert capfd.readouterr() == ("", "")


def test_without_the_package_the_command_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "a.png").write_bytes(png_bytes(np.zeros((4, 5, 3), np.uint8), [0]))
    monkeypatch.setitem(__import__("sys").modules, "OpenImageIO", None)
    with pytest.raises(MissingExtraError, match=r"OpenImageIO.*pip install.*\[exr\]"):
        open_photograph(tmp_path / "a.png")
