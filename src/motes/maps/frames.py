"""What the chunks of a Zarr array would decode to, found out before any of it is decoded.

A codec makes room for what a frame says of itself, or decodes for as long as something comes, whatever the array's metadata say a chunk has.  Frames of
zstd, Blosc and lz4 state their size at their beginning; streams of gzip, zlib, bz2 and lzma do not, and are decoded once in small pieces to be counted,
where their files are large enough to matter.
"""

from __future__ import annotations

import bz2
import itertools
import lzma
import math
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from motes.errors import FormatError
from motes.files import budget

ZSTD = b"\x28\xb5\x2f\xfd"
HEAD = 18  # bytes: the longest header of a frame
PIECE = 2**20
# Streams expand so many times at most, or without a bound.
EXPANSION = {"gzip": 1032, "zlib": 1032}
STREAMS: dict[str, Callable[[], Any]] = {
    "gzip": lambda: zlib.decompressobj(31),
    "zlib": lambda: zlib.decompressobj(15),
    "bz2": bz2.BZ2Decompressor,
    "lzma": lzma.LZMADecompressor,
}
NOTHING = 2**64 - 1  # where an index of a shard says that a chunk is not there


def check_frames(array: Any, where: object, part: Any = ...) -> None:
    """Refuse chunks that decode to more than a chunk of the array has, and to more than a file may take.

    Parameters
    ----------
    array
        The Zarr array, of a store in a folder.
    where
        The folder of the store.
    part
        What is going to be read: slices or numbers along the axes.

    Raises
    ------
    FormatError
        With the chunk and the size.
    """
    most = max(2 * math.prod(array.chunks) * array.dtype.itemsize, budget.LEAST)
    outer, inner, index_first = _layout(array)
    names = [str(codec.to_dict()["name"]).removeprefix("numcodecs.") for codec in inner]
    for file in _files(array, Path(str(where)), outer, part):
        pieces = _pieces(file, outer, array.chunks, index_first)
        for at, length in pieces:
            size = _size(file, at, length, names, most)
            if size > most:
                raise FormatError(
                    f"{where}: a chunk of {array.basename}, {length:,} bytes in {file.name}, decodes to {budget.mebibytes(size)} or more, and a chunk has "
                    f"{budget.mebibytes(math.prod(array.chunks) * array.dtype.itemsize)}",
                    "The store is damaged: write it again",
                )


def is_regular(file: Path, where: object) -> bool:
    """Whether there is a file; what is there and is none, a pipe that nobody writes to, say, would be waited for without end.

    Raises
    ------
    FormatError
        For what is no regular file.
    """
    if file.is_file():
        return True
    if file.exists():
        raise FormatError(f"{where}: {file.relative_to(str(where))} is no regular file", "Write the store again")
    return False


def _layout(array: Any) -> tuple[tuple[int, ...], Any, bool | None]:
    """The shape of what one file holds, the codecs of a chunk, and for shards whether their index comes first."""
    codecs = array.metadata.codecs
    shards = getattr(array, "shards", None)
    if shards is None:
        return tuple(array.chunks), codecs, None
    sharding = codecs[0]
    return tuple(shards), sharding.codecs, "start" in str(sharding.index_location).lower()


def _files(array: Any, store: Path, outer: tuple[int, ...], part: Any) -> Iterator[Path]:
    """The files of the chunks that a part touches, those that are there."""
    given = part if isinstance(part, tuple) else (part,)
    if Ellipsis in given:
        k = given.index(Ellipsis)
        given = (*given[:k], *[slice(None)] * (array.ndim - len(given) + 1), *given[k + 1 :])
    given = (*given, *[slice(None)] * (array.ndim - len(given)))
    axes = []
    for each, n, size in zip(given, array.shape, outer, strict=True):
        start, stop, _ = each.indices(n) if isinstance(each, slice) else (int(each), int(each) + 1, 1)
        axes.append(range(start // size, -(-stop // size)))
    for coordinates in itertools.product(*axes):
        file = store / array.path / array.metadata.encode_chunk_key(coordinates)
        if is_regular(file, store):
            yield file


def _pieces(
    file: Path, outer: tuple[int, ...], chunk: tuple[int, ...], index_first: bool | None
) -> list[tuple[int, int]]:
    """Where the frames of a file are, and how long."""
    length = file.stat().st_size
    if index_first is None:
        return [(0, length)]
    count = math.prod(-(-n // c) for n, c in zip(outer, chunk, strict=True))
    if length < 16 * count + 4:
        return []
    with file.open("rb") as stream:
        stream.seek(0 if index_first else length - 16 * count - 4)
        index = stream.read(16 * count)
    words = [int.from_bytes(index[k : k + 8], "little") for k in range(0, len(index), 8)]
    return [(at, n) for at, n in zip(words[::2], words[1::2], strict=True) if at != NOTHING and at + n <= length]


def _size(file: Path, at: int, length: int, names: list[str], most: int) -> int:
    """What a frame decodes to [bytes], as far as it says so or can be counted; not further than `most` and a piece."""
    with file.open("rb") as stream:
        stream.seek(at)
        head = stream.read(min(HEAD, length))
        for name in names:
            if name == "zstd":
                return _zstd(head)
            if name == "blosc":
                return int.from_bytes(head[4:8], "little")
            if name == "lz4":
                return int.from_bytes(head[:4], "little")
            if name in STREAMS and length * EXPANSION.get(name, most) > most:
                return _counted(STREAMS[name], head + stream.read(length - len(head)), most)
    return 0


def _zstd(head: bytes) -> int:
    """The content size of a frame of Zstandard, RFC 8878 section 3.1.1; 0 where it does not say it."""
    if head[:4] != ZSTD or len(head) < 5:
        return 0
    descriptor = head[4]
    single, code = descriptor >> 5 & 1, descriptor >> 6
    at = 5 + (1 - single) + (0, 1, 2, 4)[descriptor & 3]
    size = (single, 2, 4, 8)[code]
    return int.from_bytes(head[at : at + size], "little") + (256 if size == 2 else 0)


def _counted(make: Callable[[], Any], data: bytes, most: int) -> int:
    """How much a stream decodes to, or a little more than `most`; what is damaged counts as nothing, for it is refused later."""
    total = 0
    try:
        while data and total <= most:
            decoder = make()
            while not decoder.eof and total <= most:
                made = decoder.decompress(data, PIECE)
                total += len(made)
                data = getattr(decoder, "unconsumed_tail", b"")
                if not made and not data:
                    return total
            data = decoder.unused_data
    except (zlib.error, OSError, lzma.LZMAError, EOFError):
        return total
    return total
