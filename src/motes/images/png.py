"""What a PNG says of its numbers, and whether it is whole: the chunks before the pixels, and all checksums (PNG, ISO 15948, third edition).

The pixels are decoded by OpenImageIO, which hands on neither cHRM nor cICP.  The library below it, libpng, says what is wrong with a file on the terminal,
past everybody; so what it would refuse is refused before: see `motes.images.png_pixels`.
"""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

from motes.errors import FormatError
from motes.images import png_pixels, transfer_functions
from motes.images.transfer_functions import Transfer

MAGIC = b"\x89PNG\r\n\x1a\n"
PIXELS = png_pixels.PIXELS
LARGEST_FILE = 2**31
LARGEST_PROFILE = 16 * 2**20
_PRIMARIES = {
    1: transfer_functions.SRGB,
    9: transfer_functions.BT2020,
    12: transfer_functions.P3_D65,
}  # of cICP, ITU-T H.273
_CURVES = {8: "linear", 13: "srgb"}


def chunks_of(path: Path) -> dict[bytes, bytes]:
    """The chunks before the pixels by name, once the whole file is known to hold together.

    Raises
    ------
    FormatError
        When the file is no PNG, is damaged or cut short.
    """
    length = path.stat().st_size
    if length > LARGEST_FILE:
        raise FormatError(f"{path} has {length:,} bytes, too many for a picture", "Check the file")
    data = path.read_bytes()
    if not data.startswith(MAGIC):
        raise FormatError(f"{path} is not a PNG picture; it starts with {data[:8]!r}", "Check the file")
    found, whole = _chunks(path, data)
    header = png_pixels.header_of(path, found)
    if not whole:
        raise FormatError(f"{path} is cut short: its pixels or its end are missing", "Fetch or copy the file again")
    png_pixels.check_order(path, header, found)
    png_pixels.check(path, header, [content for name, content in found if name == PIXELS])
    chunks: dict[bytes, bytes] = {}
    for name, content in found:
        if name == PIXELS:
            break
        chunks.setdefault(name, bytes(content))
    return chunks


def interlaced(chunks: dict[bytes, bytes]) -> bool:
    """Whether the pixels come in several passes, for which a decoder keeps all of them."""
    return chunks[b"IHDR"][12] != 0


def _chunks(path: Path, data: bytes) -> tuple[list[tuple[bytes, memoryview]], bool]:
    """All chunks, and whether pixels and end are among them; all checksums hold."""
    found: list[tuple[bytes, memoryview]] = []
    at, pixels = len(MAGIC), False
    view = memoryview(data)
    while at + 12 <= len(data):
        length, name = struct.unpack_from(">I4s", data, at)
        check = data[at + 8 + length : at + 12 + length]
        if len(check) < 4 or zlib.crc32(view[at + 4 : at + 8 + length]) != struct.unpack(">I", check)[0]:
            raise FormatError(f"{path} is damaged at byte {at}", "Fetch or copy the file again")
        pixels = pixels or name == PIXELS
        found.append((name, view[at + 8 : at + 8 + length]))
        if name == b"IEND":
            return found, pixels
        at += 12 + length
    return found, False


def transfer_of(path: Path, chunks: dict[bytes, bytes]) -> Transfer | None:
    """What the numbers are by these chunks, None where none says it; by the order of precedence of the standard: cICP, iCCP, sRGB, then gAMA and cHRM.

    Raises
    ------
    FormatError
        When a chunk says what is not known.
    """
    if cicp := chunks.get(b"cICP"):
        primaries, curve, matrix, full = struct.unpack("4B", cicp) if len(cicp) == 4 else (0, 0, 1, 0)
        if primaries not in _PRIMARIES or curve not in _CURVES or matrix or not full:
            raise FormatError(
                f"{path}: its cICP chunk names the primaries {primaries} and the transfer function {curve}, which are not known here",
                "Say what the numbers are: --transfer linear, srgb or an exponent",
            )
        own = _PRIMARIES[primaries]
        return Transfer(
            _CURVES[curve], "its cICP chunk says so", primaries=None if own == transfer_functions.SRGB else own
        )
    if b"iCCP" in chunks:
        return Transfer("icc", "its iCCP chunk holds it", profile=_profile(path, chunks[b"iCCP"]))
    if b"sRGB" in chunks:
        return Transfer("srgb", "its sRGB chunk says so")
    if b"gAMA" not in chunks:
        return None
    gama = struct.unpack(">I", chunks[b"gAMA"])[0] if len(chunks[b"gAMA"]) == 4 else 0
    gamma = 100000 / gama if gama else 0.0
    if not transfer_functions.LOWEST_GAMMA <= gamma <= transfer_functions.HIGHEST_GAMMA:
        raise FormatError(
            f"{path}: its gAMA chunk says {gama / 1e5:g}, which is no transfer function",
            "Say what the numbers are: --transfer linear, srgb or an exponent",
        )
    primaries_ = None
    if len(chunks.get(b"cHRM", b"")) == 32:
        white_first = [v / 1e5 for v in struct.unpack(">8I", chunks[b"cHRM"])]
        own = (*white_first[2:], *white_first[:2])
        primaries_ = None if transfer_functions.same_primaries(own, transfer_functions.SRGB) else own
    kind = "linear" if abs(gama - 100000) <= 1 else "gamma"
    return Transfer(kind, f"its gAMA chunk says {gama / 1e5:g}", gamma=gamma, primaries=primaries_)


def _profile(path: Path, chunk: bytes) -> bytes:
    _, _, rest = chunk.partition(b"\0")
    try:
        unpacker = zlib.decompressobj()
        profile = unpacker.decompress(rest[1:], LARGEST_PROFILE)
    except zlib.error:
        profile = b""
    if len(profile) < 128 or unpacker.unconsumed_tail:
        raise FormatError(
            f"{path}: the ICC profile in its iCCP chunk is damaged",
            "Say what the numbers are: --transfer linear, srgb or an exponent",
        )
    return profile
