"""What a picture is said to take is what it takes: the process is looked at while each kind is read."""

from __future__ import annotations

import json
import struct
import subprocess
import sys
import zlib
from pathlib import Path

import numpy as np
import pytest

from image_files import png_bytes
from motes.errors import FormatError
from motes.images import jpeg, photograph, png_pixels
from motes.images.transfer_functions import Transfer

oiio = pytest.importorskip("OpenImageIO")
SOURCES = str(Path(__file__).resolve().parents[1] / "src")
#: Bytes that a decoder takes whatever the picture.
OWN = 3 * 2**20
NUMBERS = {"half": np.float16, "float": np.float32, "uint8": np.uint8, "uint16": np.uint16}
CASES = {
    "zip.exr": ((900, 1000, 4), "half", {"compression": "zip"}),
    "tiles.exr": ((900, 1000, 4), "float", {"compression": "zip", "tile": 64}),
    "wide.exr": ((64, 16000, 4), "half", {"compression": "piz"}),
    "packed.exr": ((250, 900, 32), "half", {"compression": "dwab"}),
    "tile.exr": ((500, 700, 8), "float", {"compression": "zip", "tile": 1024}),
    "grey.png": ((1500, 2000, 1), "uint8", {}),
    "deep.png": ((1500, 2000, 4), "uint16", {}),
    "strip.tif": ((1500, 2000, 3), "uint16", {"compression": "zip", "tiff:RowsPerStrip": 10000}),
    "planes.tif": ((1500, 2000, 3), "uint8", {"compression": "lzw", "planarconfig": "separate"}),
    "lines.jpg": ((1500, 2000, 3), "uint8", {}),
    "progressive.jpg": ((1500, 2000, 3), "uint8", {}),
    "interlaced.png": ((1500, 2000, 3), "uint8", {}),
}
SCRIPT = """
import json, os, sys
from pathlib import Path
from motes.files import budget
from motes.images.photograph import open_photograph
from motes.images.transfer_functions import Transfer

def most(field):
    return next(1024 * int(line.split()[1]) for line in open("/proc/self/status") if line.startswith(field))

path, little = map(Path, sys.argv[1:])
linear = Transfer("linear")
open_photograph(little, linear)  # everything is loaded
said = []
check = budget.check
budget.check = lambda path, needed, *more: said.append(needed) or check(path, needed, *more)
with open("/proc/self/clear_refs", "w") as file:
    file.write("5")
before = most("VmRSS")
open_photograph(path, linear)
print(json.dumps([max(said), most("VmHWM") - before]))
"""


def written(path: Path, shape: tuple[int, int, int], kind: str, options: dict[str, object]) -> Path:
    """A picture that packs well, so that its file is small."""
    pixels = (np.arange(np.prod(shape)).reshape(shape) % 251).astype(NUMBERS[kind])
    if path.name in ("progressive.jpg", "interlaced.png"):
        if path.suffix == ".jpg":
            pytest.importorskip("PIL.Image").fromarray(pixels).save(path, progressive=True)
        else:
            writer = pytest.importorskip("png").Writer(shape[1], shape[0], greyscale=False, interlace=True)
            with path.open("wb") as file:
                writer.write_array(file, pixels.ravel())
        return path
    facts = oiio.ImageSpec(shape[1], shape[0], shape[2], kind)
    for name, value in options.items():
        if name == "tile":
            facts.tile_width = facts.tile_height = value
        else:
            facts.attribute(name, value)
    if path.suffix == ".exr":
        facts.channelnames = ("R", "G", "B", *(f"x{k}" for k in range(shape[2] - 3)))
    out = oiio.ImageOutput.create(str(path))
    assert out.open(str(path), facts), out.geterror()
    assert out.write_image(pixels), out.geterror()
    out.close()
    return path


@pytest.mark.skipif(not Path("/proc/self/clear_refs").exists(), reason="the most memory as Linux counts it")
@pytest.mark.parametrize("name", list(CASES))
def test_no_picture_takes_more_than_was_counted(name: str, tmp_path: Path) -> None:
    shape, kind, options = CASES[name]
    path = written(tmp_path / name, shape, kind, options)
    little = written(tmp_path / f"little{path.suffix}", (8, 8, shape[2]), kind, {})
    environment = {"PYTHONPATH": SOURCES, "MOTES_LARGEST_MIB": "4000", "OPENIMAGEIO_THREADS": "1", "EXR_THREADS": "1"}
    run = subprocess.run(
        [sys.executable, "-c", SCRIPT, path, little], capture_output=True, text=True, timeout=100, env=environment
    )
    assert run.returncode == 0, run.stderr
    counted, taken = json.loads(run.stdout)
    assert taken <= counted + OWN
    assert taken > 0.25 * counted  # and what is counted is no fancy


def test_what_decoding_takes_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Many channels of which three are read, packed by hundreds of lines."""
    path = written(tmp_path / "packed.exr", *CASES["packed.exr"])
    with monkeypatch.context() as patched:
        patched.setattr("motes.files.budget.LEAST", 2**24)
        with pytest.raises(FormatError, match=r"250 lines of 900 pixels, which are packed together, would take 27 MiB"):
            photograph.open_photograph(path)
    assert photograph.open_photograph(path).shape == (250, 900, 3)


@pytest.mark.parametrize("data", [b"", b"\xff\xd8", b"\xff\xd8\xff\xda\0\2", b"\xff\xd8\xff\xe0\xff", b"\xff\xd8" * 40])
def test_a_jpeg_that_does_not_say_it_may_be_progressive(data: bytes, tmp_path: Path) -> None:
    (tmp_path / "a.jpg").write_bytes(data)
    assert jpeg.progressive(tmp_path / "a.jpg")


def test_progressive_pictures_are_told(tmp_path: Path) -> None:
    Image = pytest.importorskip("PIL.Image")
    for progressive in (False, True):
        Image.fromarray(np.zeros((9, 9, 3), np.uint8)).save(
            tmp_path / "a.jpg", progressive=progressive, exif=b"Exif\0\0"
        )
        assert jpeg.progressive(tmp_path / "a.jpg") is progressive


@pytest.mark.parametrize("bits", [1, 2, 4, 8, 16])
@pytest.mark.parametrize("interlace", [False, True])
@pytest.mark.parametrize("size", [(1, 1), (3, 5), (9, 17)])
def test_pixels_by_another_encoder_are_whole(tmp_path: Path, bits: int, interlace: bool, size: tuple[int, int]) -> None:
    """All widths of numbers, in passes and without, palettes among them; cut by a byte of a row they are refused."""
    writer = pytest.importorskip("png").Writer
    height, width = size
    rng = np.random.default_rng(bits)
    codes = rng.integers(0, 2**bits, size)
    palettes = [None, [(k, 2 * k, 3 * k) for k in range(min(2**bits, 80))]] if bits < 16 else [None]
    for palette in palettes:
        colours = {"palette": palette} if palette else {"greyscale": True}
        shown = codes % len(palette) if palette else codes
        with (tmp_path / "a.png").open("wb") as file:
            writer(width, height, bitdepth=bits, interlace=interlace, **colours).write(file, shown.tolist())
        found = photograph.open_photograph(tmp_path / "a.png", Transfer("linear")).stored
        if palette:
            np.testing.assert_array_equal(found, np.array(palette)[shown])
        else:
            np.testing.assert_array_equal(found[..., 0], shown if bits >= 8 else shown * (255 // (2**bits - 1)))


def test_pixels_that_go_on_for_ever_are_refused_soon(tmp_path: Path) -> None:
    """A megabyte that unpacks to a thousand, of a picture of a hundred."""
    good = png_bytes(np.zeros((4, 5, 3), np.uint8), [0])
    body = b"IDAT" + zlib.compress(bytes(300 * 2**20), 1)
    at = good.index(b"IDAT") - 4
    chunk = struct.pack(">I", len(body) - 4) + body + struct.pack(">I", zlib.crc32(body))
    (tmp_path / "a.png").write_bytes(good[:at] + chunk + good[-12:])
    with pytest.raises(FormatError, match="go on after their 64 bytes"):
        photograph.open_photograph(tmp_path / "a.png")
    assert png_pixels.PIECE < 2**22


CHUNKS = [b"tnul", b"t1Xt", b"ABCD", b"IHDR", b"PLTE", b"tE\0t"]


@pytest.mark.parametrize("name", CHUNKS)
@pytest.mark.parametrize("behind", [False, True])
def test_chunks_that_end_a_decoder_are_refused_without_a_word(
    tmp_path: Path, name: bytes, behind: bool, capfd: pytest.CaptureFixture[str]
) -> None:
    """Names that are none, critical ones that nobody knows, second headers, and palettes behind the pixels: libpng says it on the terminal."""
    good = png_bytes(np.zeros((4, 5, 3), np.uint8), [0])
    body = name + (good[16:29] if name == b"IHDR" else bytes(6))
    chunk = struct.pack(">I", len(body) - 4) + body + struct.pack(">I", zlib.crc32(body))
    at = len(good) - 12 if behind else 33
    (tmp_path / "a.png").write_bytes(good[:at] + chunk + good[at:])
    if name == b"PLTE" and not behind:  # one that suggests colours
        assert photograph.open_photograph(tmp_path / "a.png").shape == (4, 5, 3)
    else:
        with pytest.raises(FormatError, match="cannot be decoded: it has a"):
            photograph.open_photograph(tmp_path / "a.png")
    assert capfd.readouterr() == ("", "")
