"""Chunks that are written whole: the bytes that Zarr would write, without its event loop.

Zarr takes a millisecond for each assignment, whatever its size: a task on another thread, its lock, and as many coroutines.  A block of a fitted map is one
chunk of each of some twenty arrays.
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
    """What the codecs of an array do, of those that stores of Motes have: numbers as bytes, and perhaps Zstandard."""
    codecs = [codec.to_dict() for codec in array.metadata.codecs]
    names = [str(codec["name"]) for codec in codecs]
    if names[:1] != ["bytes"] or (codecs[0].get("configuration") or {}).get("endian", "little") != "little":
        return None
    if len(codecs) == 1:
        return lambda chunk: chunk.tobytes()
    if names[1:] != ["zstd"]:
        return None
    from numcodecs.zstd import Zstd

    about = codecs[1].get("configuration") or {}
    zstd = Zstd(level=int(about.get("level", 0)), checksum=bool(about.get("checksum", False)))
    return lambda chunk: bytes(zstd.encode(chunk))


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
