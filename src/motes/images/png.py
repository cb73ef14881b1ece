"""PNG pictures of 8 and 16 bits as arrays (PNG, ISO 15948).

A hundred lines rather than an imaging library, because the common one reduces 16-bit colour to 8 bits.  Pictures with a palette, of fewer bits, or
interlaced are refused.
"""

from __future__ import annotations

import struct
import zlib
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError

MAGIC = b"\x89PNG\r\n\x1a\n"
CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}  # by the colour type: grey, RGB, grey and alpha, RGB and alpha
LARGEST_FILE, LARGEST_RATIO = 2**31, 1100  # deflate shrinks by at most 1032


def read(path: Path) -> tuple[NDArray[Any], int]:
    """Pixels (y, x, C) as stored, uint8 or uint16, without alpha; and the largest code.

    Raises
    ------
    FormatError
        When the file is not such a picture, is truncated, or claims a size that it cannot hold.
    """
    length = path.stat().st_size
    if length > LARGEST_FILE:
        raise FormatError(f"{path} has {length:,} bytes, too many for a picture", "Check the file")
    data = path.read_bytes()
    if not data.startswith(MAGIC):
        raise FormatError(f"{path} is not a PNG picture; it starts with {data[:8]!r}", "Give PNG or OpenEXR pictures")
    chunks = _chunks(path, data)
    header = chunks.get(b"IHDR", b"")
    if len(header) != 13:
        raise FormatError(f"{path} has no header", "The file is damaged; fetch it again")
    width, height, bits, kind, _, _, interlaced = struct.unpack(">IIBBBBB", header)
    if bits not in (8, 16) or kind not in CHANNELS or interlaced or not width or not height:
        what = "interlaced" if interlaced else f"of {bits} bits, colour type {kind}"
        raise FormatError(f"{path} is a PNG {what}", "Pictures of 8 or 16 bits, grey or RGB, not interlaced, are read")
    channels = CHANNELS[kind]
    step = channels * bits // 8
    line = width * step
    packed = chunks.get(b"IDAT", b"")
    if height * (line + 1) > LARGEST_RATIO * len(packed) + 65536:
        raise FormatError(f"{path} claims {width} x {height} pixels, more than it can hold", "The file is damaged")
    try:
        raw = zlib.decompressobj().decompress(packed, height * (line + 1))
    except zlib.error as error:
        raise FormatError(f"{path} cannot be decoded: {error}", "The file is damaged; fetch it again") from None
    if len(raw) != height * (line + 1):
        raise FormatError(f"{path} is truncated: {len(raw):,} of {height * (line + 1):,} bytes", "Fetch it again")
    rows = np.frombuffer(raw, np.uint8).reshape(height, line + 1)
    if (rows[:, 0] > 4).any():
        raise FormatError(f"{path} uses a filter that does not exist", "The file is damaged; fetch it again")
    pixels = np.empty((height, line), np.uint8)
    _unfilter()(rows, step, pixels)
    values = pixels.view(">u2").astype(np.uint16) if bits == 16 else pixels
    values = values.reshape(height, width, channels)
    return values[..., : channels - 1 if channels in (2, 4) else channels], 2**bits - 1


def _chunks(path: Path, data: bytes) -> dict[bytes, bytes]:
    """The chunks by name, those of one name put together; their checksums hold."""
    found: dict[bytes, list[bytes]] = {}
    at = len(MAGIC)
    while at + 12 <= len(data):
        length, name = struct.unpack_from(">I4s", data, at)
        body = data[at + 8 : at + 8 + length]
        check = data[at + 8 + length : at + 12 + length]
        if len(check) < 4 or zlib.crc32(name + body) != struct.unpack(">I", check)[0]:
            raise FormatError(f"{path} is damaged at byte {at}", "Fetch or copy the file again")
        found.setdefault(name, []).append(body)
        if name == b"IEND":
            break
        at += 12 + length
    return {name: b"".join(parts) for name, parts in found.items()}


@cache
def _unfilter() -> Any:
    """The five filters undone, byte by byte: compiled when the first picture is read."""
    import numba

    @numba.njit(nogil=True)
    def unfilter(rows: Any, step: int, out: Any) -> None:
        height, line = out.shape
        for y in range(height):
            kind = rows[y, 0]
            for x in range(line):
                left = np.int64(out[y, x - step]) if x >= step else np.int64(0)
                up = np.int64(out[y - 1, x]) if y > 0 else np.int64(0)
                corner = np.int64(out[y - 1, x - step]) if y > 0 and x >= step else np.int64(0)
                add = np.int64(0)
                if kind == 1:
                    add = left
                elif kind == 2:
                    add = up
                elif kind == 3:
                    add = (left + up) // 2
                elif kind == 4:  # Paeth: of left, up and corner the one nearest to left + up - corner
                    guess = left + up - corner
                    a, b, c = abs(guess - left), abs(guess - up), abs(guess - corner)
                    add = left if a <= b and a <= c else up if b <= c else corner
                out[y, x] = np.uint8((np.int64(rows[y, x + 1]) + add) & 255)

    return unfilter
