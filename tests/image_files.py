"""Pictures as files, written by hand or by other libraries than the one that reads them."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path
from typing import Any

import numpy as np

MAGIC = b"\x89PNG\r\n\x1a\n"
PAETH = 4


def png_bytes(
    pixels: np.ndarray, filters: list[int], kind: int | None = None, chunks: tuple[tuple[bytes, bytes], ...] = ()
) -> bytes:
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
    header = struct.pack(">IIBBBBB", width, height, bits, kind, 0, 0, 0)
    said = b"".join(chunk(name, data) for name, data in chunks)
    body = chunk(b"IHDR", header) + said + chunk(b"tEXt", b"a\0b") + b"".join(chunk(b"IDAT", p) for p in parts)
    return MAGIC + body + chunk(b"IEND", b"")


def write_exr(path: Path, channels: dict[str, np.ndarray], **header: Any) -> Path:
    """Named channels (y, x) by the package OpenEXR; more of the header by names."""
    import OpenEXR

    facts = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage, **header}
    OpenEXR.File(facts, {name: np.ascontiguousarray(values) for name, values in channels.items()}).write(str(path))
    return path


def write_parts(path: Path, parts: dict[str, dict[str, np.ndarray]]) -> Path:
    """A multi-part OpenEXR file: the channels of each part by its name."""
    import OpenEXR

    made = [OpenEXR.Part({"name": name, "type": OpenEXR.scanlineimage}, channels) for name, channels in parts.items()]
    OpenEXR.File(made).write(str(path))
    return path
