"""Whether a PNG is one that a decoder reads to its end (PNG, ISO 15948, third edition: 5.6, 7, 9 and 11.2).

Nothing is decoded here but the packing, a piece at a time, so that its length and the filter of each row are known.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from motes.errors import FormatError
from motes.files import budget

PIXELS = b"IDAT"
#: The chunks that no decoder may go over.
CRITICAL = (b"IHDR", b"PLTE", PIXELS, b"IEND")
#: Numbers of a pixel, and the bits that they may have, by the kind of colour.
SAMPLES = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}
BITS = {0: (1, 2, 4, 8, 16), 2: (8, 16), 3: (1, 2, 4, 8), 4: (8, 16), 6: (8, 16)}
PALETTE = 3
#: The largest width and height that libpng takes.
LONGEST = 1_000_000
#: Of the seven passes (8.2): the first column and row, and the steps to the next.
PASSES = ((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2))
FILTERS = 5
PIECE = 2**20


class Header(NamedTuple):
    """What the chunk IHDR says."""

    width: int
    height: int
    bits: int
    kind: int
    packing: int
    filtering: int
    interlace: int


def header_of(path: Path, chunks: Sequence[tuple[bytes, memoryview]]) -> Header:
    """The header, which is one that a picture can have.

    Raises
    ------
    FormatError
        When it is missing, or says what is not in the standard.
    """
    name, content = chunks[0] if chunks else (b"", memoryview(b""))
    if name != b"IHDR" or len(content) != 13:
        raise FormatError(f"{path} has no header", "The file is damaged; fetch it again")
    header = Header(*struct.unpack(">IIBBBBB", content))
    if not (0 < header.width <= LONGEST and 0 < header.height <= LONGEST):
        raise _undecodable(
            path, f"it is {header.width} x {header.height} pixels, and {LONGEST:,} either way is the limit"
        )
    if header.bits not in BITS.get(header.kind, ()):
        raise _undecodable(
            path, f"its header says {header.bits} bits and the colour type {header.kind}, which do not go together"
        )
    if header.packing or header.filtering or header.interlace > 1:
        raise _undecodable(path, f"its header names the methods {header[4:]} of packing, filters and interlace")
    return header


def check_order(path: Path, header: Header, chunks: Sequence[tuple[bytes, memoryview]]) -> None:
    """Refuse chunks that end a decoder: of no name, unknown and critical, twice, or out of place.

    Raises
    ------
    FormatError
        With the name of the chunk.
    """
    names = [name for name, _ in chunks]
    for name in names:
        if not (
            name.isascii() and name.isalpha() and name[2:3].isupper()
        ):  # the third letter is kept for later standards
            raise _undecodable(path, f"it has a chunk with the name {name!r}")
        if name[:1].isupper() and name not in CRITICAL:
            raise _undecodable(path, f"it has a chunk {name.decode()}, which is not known and may not be left out")
    first = names.index(PIXELS)
    count = names.count(PIXELS)
    if names[first : first + count] != [PIXELS] * count:
        raise _undecodable(path, "other chunks stand among its pixels")
    if names.count(b"IHDR") > 1 or names.count(b"PLTE") > 1 or b"PLTE" in names[first:]:
        raise _undecodable(path, "it has a second header or palette, or a palette behind its pixels")
    palette = next((content for name, content in chunks if name == b"PLTE"), None)
    if header.kind == PALETTE and (palette is None or len(palette) % 3 or not 0 < len(palette) <= 3 * 2**header.bits):
        found = "none" if palette is None else f"one of {len(palette)} bytes"
        raise _undecodable(path, f"its pixels name colours of a palette, and it has {found}")


def check(path: Path, header: Header, packed: Sequence[memoryview]) -> None:
    """Refuse pixels that are too many, damaged, end too soon or far too late, or are filtered in a way that is not in the standard.

    Raises
    ------
    FormatError
        With what is wrong.
    """
    passes = list(_passes(header))
    ends = np.cumsum([rows * stride for rows, stride in passes])
    position, total = 0, int(ends[-1])
    budget.check(path, total, f"{header.width} x {header.height} pixels")
    for piece in _unpacked(path, packed):
        for (rows, stride), end in zip(passes, ends.tolist(), strict=True):
            start = end - rows * stride
            if start < position + len(piece) and position < end:
                first = start - position if position <= start else (start - position) % stride
                filters = np.frombuffer(piece, np.uint8)[first : end - position : stride]
                if filters.size and filters.max() >= FILTERS:
                    raise _undecodable(path, f"a row has the filter {filters.max()}; there are 0 to {FILTERS - 1}")
        position += len(piece)
        if position > total + PIECE:
            raise _undecodable(path, f"its pixels go on after their {total:,} bytes")
    if position < total:
        raise _undecodable(path, f"its pixels end after {position:,} of {total:,} bytes")


def _passes(header: Header) -> Iterator[tuple[int, int]]:
    """The rows of each pass, and the bytes of a row with its filter."""
    size = header.bits * SAMPLES[header.kind]
    for x, y, right, down in PASSES if header.interlace else ((0, 0, 1, 1),):
        columns, rows = -(-(header.width - x) // right), -(-(header.height - y) // down)
        if columns > 0 and rows > 0:
            yield rows, 1 + -(-columns * size // 8)


def _unpacked(path: Path, packed: Sequence[memoryview]) -> Iterator[bytes]:
    """What is packed, in pieces; all of it, since the checksum stands at its end."""
    unpacker = zlib.decompressobj()
    try:
        for part in packed:
            rest: bytes | memoryview = part
            while len(rest) and not unpacker.eof:
                yield unpacker.decompress(rest, PIECE)
                rest = unpacker.unconsumed_tail
        while not unpacker.eof and (piece := unpacker.decompress(unpacker.unconsumed_tail, PIECE)):
            yield piece
    except zlib.error as error:
        raise _undecodable(path, str(error)) from None
    if not unpacker.eof:
        raise _undecodable(path, "its pixels are cut short")


def _undecodable(path: Path, said: str) -> FormatError:
    return FormatError(f"{path} cannot be decoded: {said}", "Fetch or export the file again")
