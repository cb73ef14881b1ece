"""Chunks that are written and read whole: the bytes that Zarr would write, without its event loop.

Zarr takes a millisecond for each assignment, whatever its size: a task on another thread, its lock, and as many coroutines.  A block of a fitted map is one
chunk of each of some twenty arrays.  What it reads goes through its memory and into an array's, of which each page is cleared first; numbers that are not
compressed go from their files to where they belong.
"""

from __future__ import annotations

import math
import os
import secrets
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self, final

import numpy as np
from numpy.typing import NDArray

from motes.kernels import memory

Encode = Callable[[NDArray[Any]], bytes]


@final
@dataclass(frozen=True, eq=False)
class Chunks:
    """The chunks of an array in a folder.

    Parameters
    ----------
    array
        The Zarr array.
    folder
        Where its chunks are.
    kind
        Of its numbers as they are stored.
    encode
        From a chunk to the bytes of its file; None where only Zarr knows.
    """

    array: Any
    folder: Path
    kind: np.dtype[Any]
    encode: Encode | None

    @classmethod
    def of(cls, array: Any, store: Path) -> Self:
        """Those of an array of a store on a disk."""
        kind = np.dtype(array.dtype).newbyteorder("<")
        ours = not array.read_only and not getattr(array, "shards", None)
        return cls(array, store / array.path, kind, _encoding(array) if ours else None)

    def put(self, place: tuple[int, ...], values: NDArray[Any]) -> None:
        """Write a chunk; at the far edges `values` is what is left of it.

        The file is written beside and renamed; there is none for nothing but the fill value.

        Parameters
        ----------
        place
            Of the chunk along the first axes of the array; along the others there is one.
        values
            All numbers of the chunk.

        Raises
        ------
        OSError
            When the disk refuses.
        """
        where = place + (0,) * (self.array.ndim - len(place))
        shape = tuple(self.array.chunks)
        if self.encode is None:
            starts = [k * n for k, n in zip(where, shape, strict=True)]
            self.array[tuple(slice(s, s + n) for s, n in zip(starts, values.shape, strict=True))] = values
            return
        chunk: NDArray[Any] = np.ascontiguousarray(values, self.kind)
        if chunk.shape != shape:
            part, chunk = chunk, np.full(shape, self.array.fill_value, self.kind)
            chunk[tuple(map(slice, part.shape))] = part
        file = self.folder / self.array.metadata.encode_chunk_key(where)
        if self._nothing(chunk):
            file.unlink(missing_ok=True)
            return
        _replace(file, self.encode(chunk))

    def _nothing(self, chunk: NDArray[Any]) -> bool:
        """Whether all of it is the fill value."""
        fill = self.array.fill_value
        first = chunk.flat[0]
        if isinstance(fill, (float, np.floating)) and math.isnan(fill):
            return bool(np.isnan(first) and np.isnan(chunk).all())
        return bool(first == fill and (chunk == fill).all())


def plain(array: Any, store: Path, part: Any) -> NDArray[Any] | None:
    """A part of an array that begins with a chunk along its first two axes and is whole along the others, from files of bare numbers.

    None where only Zarr knows how to read it, or what is wrong with it.

    Parameters
    ----------
    array
        The Zarr array.
    store
        The folder of its store.
    part
        Slices, as for the array.
    """
    kind, shape, chunks = np.dtype(array.dtype), tuple(array.shape), tuple(array.chunks)
    if not (isinstance(part, tuple) and 2 <= len(part) <= len(shape) and all(isinstance(s, slice) for s in part)):
        return None
    ranges = [range(*s.indices(n)) for s, n in zip(part, shape, strict=False)]
    whole = all(r == range(n) for r, n in zip(ranges[2:], shape[2:], strict=False)) and chunks[2:] == shape[2:]
    aligned = all(r.step == 1 and len(r) and r.start % n == 0 for r, n in zip(ranges[:2], chunks, strict=False))
    codecs = [codec.to_dict() for codec in array.metadata.codecs]
    bare = len(codecs) == 1 and not getattr(array, "shards", None) and _in_order(codecs[0])
    if not (whole and aligned and bare and kind == kind.newbyteorder("<") and kind.kind in "fiu"):
        return None
    ys, xs = ranges[:2]
    found = memory.empty((len(ys), len(xs), *shape[2:]), kind)
    for y in range(0, len(ys), chunks[0]):
        for x in range(0, len(xs), chunks[1]):
            place = ((ys.start + y) // chunks[0], (xs.start + x) // chunks[1]) + (0,) * (len(shape) - 2)
            target = found[y : y + chunks[0], x : x + chunks[1]]
            if not _filled(target, store / array.path / array.metadata.encode_chunk_key(place), chunks):
                if not _missing(store / array.path / array.metadata.encode_chunk_key(place)):
                    return None
                target[...] = array.fill_value
    return found


def _filled(target: NDArray[Any], file: Path, chunks: tuple[int, ...]) -> bool:
    """Read what is there of a chunk, row by row; False where there is no such file, or it is not of a chunk's size."""
    row = math.prod(chunks[1:]) * target.itemsize
    if not file.is_file():  # a pipe would be waited for
        return False
    try:
        with open(file, "rb", buffering=0) as stream:
            if os.fstat(stream.fileno()).st_size != chunks[0] * row:
                return False
            for k, texels in enumerate(target):
                if texels.nbytes != row:  # at the far edge
                    stream.seek(k * row)
                if stream.readinto(memoryview(texels).cast("B")) != texels.nbytes:
                    return False
    except OSError:
        return False
    return True


def _missing(file: Path) -> bool:
    """Whether there is nothing where a file would be."""
    return not os.path.lexists(file)


def there(folder: Path, counts: tuple[int, int]) -> NDArray[np.bool_]:
    """Which chunks of an array of two axes have a file.  They are listed: opening a million of them through Zarr would take minutes."""
    found = np.zeros(counts, bool)
    for row in _numbered(folder / "c"):
        for column in _numbered(folder / "c" / str(row)):
            if row < counts[0] and column < counts[1]:
                found[row, column] = True
    return found


def _numbered(folder: Path) -> list[int]:
    """The names in a folder that are numbers; none where there is no folder."""
    try:
        return [int(name) for name in os.listdir(folder) if name.isdecimal()]
    except FileNotFoundError:
        return []


def _encoding(array: Any) -> Encode | None:
    """What the codecs of an array do, of those that stores of Motes have: numbers as bytes, and perhaps Blosc or Zstandard."""
    codecs = [codec.to_dict() for codec in array.metadata.codecs]
    names = [str(codec["name"]) for codec in codecs]
    if not _in_order(codecs[0]):
        return None
    if len(codecs) == 1:
        return lambda chunk: chunk.tobytes()
    about = codecs[1].get("configuration") or {}
    if names[1:] == ["blosc"]:
        from numcodecs.blosc import Blosc

        shuffle = {"noshuffle": Blosc.NOSHUFFLE, "shuffle": Blosc.SHUFFLE, "bitshuffle": Blosc.BITSHUFFLE}[
            about["shuffle"]
        ]
        try:
            blosc = Blosc(
                about["cname"], int(about["clevel"]), shuffle, int(about["blocksize"]), int(about["typesize"])
            )
        except TypeError:  # of numcodecs before 0.16, which asks the array for the size
            return None
        return lambda chunk: bytes(blosc.encode(chunk))
    if names[1:] != ["zstd"]:
        return None
    from numcodecs.zstd import Zstd

    zstd = Zstd(level=int(about.get("level", 0)), checksum=bool(about.get("checksum", False)))
    return lambda chunk: bytes(zstd.encode(chunk))


def _in_order(codec: dict[str, Any]) -> bool:
    """Whether a codec, the first of an array, puts numbers down as they are, the lowest byte first."""
    return bool(codec["name"] == "bytes" and (codec.get("configuration") or {}).get("endian", "little") == "little")


def _replace(file: Path, data: bytes) -> None:
    """A file as a whole, or as it was."""
    beside = f"{file}.{secrets.token_hex(8)}.partial"
    try:
        try:
            stream = open(beside, "wb")  # noqa: SIM115 (its folder is missing only once)
        except FileNotFoundError:
            file.parent.mkdir(parents=True, exist_ok=True)
            stream = open(beside, "wb")  # noqa: SIM115
        with stream:
            stream.write(data)
        os.replace(beside, file)
    except BaseException:
        with suppress(OSError):
            os.unlink(beside)
        raise
