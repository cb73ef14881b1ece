"""A normal map that goes along with the pictures of a map: passed through byte for byte, or with its green turned."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError
from motes.images import library, png, png_writing

#: Colour types with three colours, and the bits of their channels that normal maps have.
COLOURED, DEPTHS = {2: 3, 6: 4}, (8, 16)


def normal_map(path: Path, flip_green: bool) -> tuple[bytes, tuple[int, int]]:
    """The bytes of a normal map for the folder, and its height and width.

    Parameters
    ----------
    path
        A PNG with three colours, of 8 or 16 bits.
    flip_green
        Whether green is turned round: from OpenGL's convention (green is up) to DirectX's (down), or back.  Without, the bytes are the file's.

    Raises
    ------
    FormatError
        When the file is no such picture, or is damaged.
    MissingExtraError
        With `flip_green`, without the package OpenImageIO.
    """
    chunks = png.chunks_of(path)
    width, height, bits, kind = struct.unpack(">IIBB", chunks[b"IHDR"][:10])
    if kind not in COLOURED or bits not in DEPTHS:
        raise FormatError(
            f"{path} is no normal map: it has {bits} bits and the colour type {kind}",
            "Give a PNG of red, green and blue with 8 or 16 bits",
        )
    if not flip_green:
        return path.read_bytes(), (height, width)
    codes = _codes(path, COLOURED[kind], bits)
    codes[..., 1] = np.iinfo(codes.dtype).max - codes[..., 1]
    return png_writing.encoded(codes), (height, width)


def _codes(path: Path, channels: int, bits: int) -> NDArray[Any]:
    with library.opened(path, "Turning the green of a normal map") as picture:
        facts = picture.spec(0)
        library.check_size(path, facts, range(channels), bits // 8)
        return library.pixels(path, picture, 0, range(channels), f"uint{bits}")
