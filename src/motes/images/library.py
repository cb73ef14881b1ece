"""OpenImageIO, the library by which pictures are read and written, and what it says of damaged ones.

Headers are read first, and what pixels take is worked out from them before any are decoded (`motes.files.budget`).
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError, MissingExtraError, MotesError
from motes.files import budget

EXR, PNG, JPEG = b"v/1\x01", b"\x89PNG\r\n\x1a\n", b"\xff\xd8\xff"
TIFF = (b"II*\0", b"MM\0*", b"II+\0", b"MM\0+")


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


def pixels(path: Path, picture: Any, part: int, first: int, last: int, kind: Any) -> NDArray[Any]:
    """The channels first to last (without it) of a part (y, x, C), as numbers of a kind of the library's.

    Raises
    ------
    FormatError
        When they would take too much memory, or cannot be decoded.
    """
    facts = picture.spec(part)
    check_size(path, facts, last - first, kind.size())
    read = picture.read_image(part, 0, first, last, kind)
    if read is None:
        raise damaged(path, picture.geterror())
    return np.asarray(read).reshape(facts.height, facts.width, last - first)


def check_size(path: Path, facts: Any, channels: int, width: int) -> None:
    """Refuse parts of no size, deep ones, volumes, and what does not go into memory."""
    if facts.deep or facts.depth != 1:
        raise FormatError(
            f"{path} holds {'deep samples' if facts.deep else 'a volume'}, not a flat picture", "Flatten it"
        )
    if min(facts.width, facts.height, facts.nchannels) < 1:
        raise FormatError(f"{path} is {facts.width} x {facts.height} pixels", "The file is damaged")
    count = int(facts.width) * int(facts.height) * channels
    budget.check(path, count * width, f"{facts.width} x {facts.height} pixels of {channels} channels")
    if facts.tile_width:  # a tile is decoded whole, with all channels, however little of the picture lies in it
        tile = int(facts.tile_width) * int(facts.tile_height)
        size = tile * int(facts.nchannels) * max(width, 4)
        budget.check(path, size, f"a tile of {facts.tile_width} x {facts.tile_height} pixels")
