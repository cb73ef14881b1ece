"""OpenImageIO, the library by which pictures are read and written, and what it says of damaged ones.

Headers are read first, and what pixels take is worked out from them before any are decoded (`motes.files.budget`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError, MissingExtraError, MotesError
from motes.files import budget

EXR, PNG, JPEG = b"v/1\x01", b"\x89PNG\r\n\x1a\n", b"\xff\xd8\xff"
TIFF = (b"II*\0", b"MM\0*", b"II+\0", b"MM\0+")
#: The numbers that pixels are read as, by the library's names.
KINDS: dict[str, type[np.generic]] = {"uint8": np.uint8, "uint16": np.uint16, "float": np.float32}
#: Bytes that are decoded at a time, where packs of lines or tiles let it be so few.
BAND = 2 * 2**20
#: How often a band, and a pack of lines or a tile, is in memory while one is decoded, as measured: read, converted, copied.
BANDS, PACKS = 5, 2
#: Lines that the compressions of OpenEXR pack together, where more than one ("OpenEXR File Layout"; HTJ2K by its names).
PACKED = {"zip": 16, "pxr24": 16, "piz": 32, "b44": 32, "b44a": 32, "dwaa": 32, "dwab": 256}
PACKED |= {"htj2k32": 32, "htj2k256": 256, "htj2k": 256}
#: Compressions of TIFF that are undone line by line, however long the strips.
STREAMED = ("none", "zip", "lzw", "packbits")


def oiio(purpose: str) -> Any:
    """The package, or the error that names the extra."""
    try:
        import OpenImageIO
    except ImportError:
        raise MissingExtraError("OpenImageIO", "exr", purpose) from None
    return OpenImageIO


@contextmanager
def opened(path: Path, purpose: str) -> Iterator[Any]:
    """The picture, its header read; whatever the library raises on it is a `FormatError`.

    Raises
    ------
    MissingExtraError
        Without the package OpenImageIO.
    FormatError
        When the file is no picture, or is damaged.
    """
    library = oiio(purpose)
    wishes = library.ImageSpec()
    wishes.attribute("oiio:UnassociatedAlpha", 1)  # colours as they are stored, not multiplied by alpha
    picture = None
    try:
        if not path.is_file():
            raise FormatError(f"{path} does not exist or is no file", "Check the path")
        picture = library.ImageInput.open(str(path), wishes)
        if picture is None:
            raise damaged(path, library.geterror())
        yield picture
    except MotesError:
        raise
    except OSError as error:
        raise FormatError(f"{path} cannot be read: {error.strerror or error}", "Check the path") from None
    except Exception as error:  # UnicodeDecodeError of a damaged header, and what else the library may raise
        raise damaged(path, str(error)) from None
    finally:
        if picture is not None:
            picture.close()


def damaged(path: Path, said: str) -> FormatError:
    """The refusal of a file that cannot be decoded, in a sentence."""
    words = " ".join(said.replace(str(path), "").split())[:160].rstrip(".: ") or "it is no picture that is known"
    return FormatError(f"{path} cannot be decoded: {words}", "Fetch or export the file again")


def pixels(path: Path, picture: Any, part: int, channels: Sequence[int], kind: str, held: int = 0) -> NDArray[Any]:
    """Some channels of a part (y, x, C), in the order that is asked for, as numbers of one of the `KINDS`.

    They are read some rows at a time: the library copies what it hands over, and of a whole picture at once everything would be there twice.
    What the decoder keeps of all pixels beside that is `held` bytes for each.

    Raises
    ------
    FormatError
        When they would take too much memory, or cannot be decoded.
    """
    library, facts = oiio("Reading pictures"), picture.spec(part)
    check_size(path, facts, channels, KINDS[kind]().itemsize, held)
    first, last = min(channels), max(channels) + 1
    places = [k - first for k in channels]
    whole = np.empty((facts.height, facts.width, len(places)), KINDS[kind])
    rows = _rows(facts, last - first, whole.itemsize)
    for top in range(0, facts.height, rows):
        span = facts.y + top, facts.y + min(top + rows, facts.height)
        asked = (first, last, library.TypeDesc(kind))
        if facts.tile_width:
            across, through = (facts.x, facts.x + facts.width), (facts.z, facts.z + 1)
            read = picture.read_tiles(part, 0, *across, *span, *through, *asked)
        else:
            read = picture.read_scanlines(part, 0, *span, facts.z, *asked)
        if read is None:
            raise damaged(path, picture.geterror())
        band = np.asarray(read).reshape(span[1] - span[0], facts.width, last - first)
        whole[top : top + rows] = band if places == list(range(last - first)) else band[..., places]
    return whole


def check_size(path: Path, facts: Any, channels: Sequence[int], width: int, held: int = 0) -> None:
    """Refuse parts of no size, deep ones, volumes, and what does not go into memory: the channels as numbers of `width` bytes, and what decoding takes."""
    if facts.deep or facts.depth != 1:
        raise FormatError(
            f"{path} holds {'deep samples' if facts.deep else 'a volume'}, not a flat picture", "Flatten it"
        )
    if min(facts.width, facts.height, facts.nchannels) < 1:
        raise FormatError(f"{path} is {facts.width} x {facts.height} pixels", "The file is damaged")
    across, lines = int(facts.width), _lines(facts)
    pack = f"{lines:,} lines of {across:,} pixels, which are packed together,"
    if facts.tile_width:
        across = int(facts.tile_width)
        pack = f"a tile of {across} x {lines} pixels"
    # Decoded whole, with all channels, however little of it is asked for.
    packed = PACKS * across * lines * int(facts.pixel_bytes(True))
    budget.check(path, packed, pack)
    across = -(-int(facts.width) // across) * across
    band = across * min(_rows(facts, len(channels), width), max(int(facts.height), lines)) * len(channels) * width
    count = int(facts.width) * int(facts.height)
    needed = count * (len(channels) * width + held) + packed + BANDS * band
    budget.check(path, needed, f"{facts.width} x {facts.height} pixels of {len(channels)} channels")


def _rows(facts: Any, channels: int, width: int) -> int:
    """The number of lines that are read at a time: whole tiles, or whole packs of lines."""
    lines = _lines(facts)
    return lines * max(1, BAND // (lines * int(facts.width) * channels * width))


def _lines(facts: Any) -> int:
    """Lines that are decoded together: of tiles, or what a compression packs."""
    if facts.tile_width:
        return int(facts.tile_height)
    packing = str(facts.getattribute("compression") or "none").lower().partition(":")[0]
    lines = PACKED.get(packing, 1)
    if strip := facts.getattribute("tiff:RowsPerStrip"):
        lines = 1 if packing in STREAMED else int(strip)
    return max(1, min(lines, int(facts.height)))
