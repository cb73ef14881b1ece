"""PNG files from pixels, without an imaging library."""

from __future__ import annotations

import struct
import zlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

#: The colour type of a picture by its number of channels (PNG, ISO 15948).
TYPES = {1: 0, 2: 4, 3: 2, 4: 6}
#: What the chunk sRGB says: perceptual.
INTENT = b"\0"


def encoded(pixels: NDArray[Any], *, srgb: bool = False) -> bytes:
    """A PNG file of pixels (H, W, C): grey, grey and alpha, RGB, or RGB and straight alpha.

    A dozen lines rather than an imaging library: the format's uncompressed layout is fixed (PNG, ISO 15948), zlib is in the standard library, and the
    bytes depend on nothing but the pixels.

    Parameters
    ----------
    pixels
        uint8 or uint16.
    srgb
        Whether a chunk says that the numbers are of sRGB.
    """
    height, width, channels = pixels.shape
    depth = pixels.dtype.itemsize
    # Filter 1 (difference to the pixel on the left, byte by byte) suits smooth shading; the arithmetic is modulo 256.
    stored = np.ascontiguousarray(pixels, ">u2" if depth == 2 else np.uint8)
    data = stored.view(np.uint8).reshape(height, width, channels * depth)
    filtered = data.copy()
    filtered[:, 1:] -= data[:, :-1]
    rows = np.concatenate([np.ones((height, 1), np.uint8), filtered.reshape(height, -1)], axis=1)

    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    header = struct.pack(">IIBBBBB", width, height, 8 * depth, TYPES[channels], 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + (chunk(b"sRGB", INTENT) if srgb else b"")
        + chunk(b"IDAT", zlib.compress(rows.tobytes(), 6))
        + chunk(b"IEND", b"")
    )
