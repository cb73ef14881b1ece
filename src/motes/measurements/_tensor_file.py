"""Tensor files, the container of the RGL database: named arrays of any type.

``tensor_file\\0``, version bytes 1 0, uint32 number of fields; a field is uint16 name length, name, uint16 ndim, uint8
dtype, uint64 offset, uint64 shape[ndim].
"""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError
from motes.files import reading

MAGIC = b"tensor_file\0"
DTYPES = {1: "u1", 2: "i1", 3: "<u2", 4: "<i2", 5: "<u4", 6: "<i4", 7: "<u8", 8: "<i8", 9: "<f2", 10: "<f4", 11: "<f8"}
HEADER = 65536  # bytes that the table of contents must fit into


class TensorFile:
    """The table of contents; arrays are read when asked for, after their place in the file was checked."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.table: dict[str, tuple[str, int, tuple[int, ...]]] = {}
        header = reading.head(path, HEADER)
        if not header.startswith(MAGIC):
            raise FormatError(f"{path} starts with {header[:12]!r}, not {MAGIC!r}", "This is not a tensor file")
        try:
            if header[12:14] != b"\x01\x00":
                raise FormatError(
                    f"{path} is a tensor file of version {tuple(header[12:14])}, not (1, 0)", "Only version 1.0 is read"
                )
            (n,), at = struct.unpack_from("<I", header, 14), 18
            reading.require(n <= 1000, f"{path} claims {n} fields", "The file is damaged")
            for _ in range(n):
                (length,) = struct.unpack_from("<H", header, at)
                name = header[at + 2 : at + 2 + length].decode("utf-8", errors="replace")
                at += 2 + length
                ndim, dtype, offset = struct.unpack_from("<HBQ", header, at)
                reading.require(
                    ndim <= 8 and dtype in DTYPES,
                    f"{path}: field {name[:40]!r} has {ndim} dimensions of type {dtype}",
                    "The file is damaged",
                )
                shape = struct.unpack_from(f"<{ndim}Q", header, at + 11)
                at += 11 + 8 * ndim
                self.table[name] = (DTYPES[dtype], offset, shape)
        except struct.error:
            raise FormatError(
                f"{path} is truncated: its table of fields ends at byte {len(header)}", "Fetch the file again"
            ) from None

    def __contains__(self, name: str) -> bool:
        return name in self.table

    def array(self, name: str, ndim: int) -> NDArray[np.float64]:
        if name not in self.table:
            raise FormatError(
                f"{self.path} has no field {name!r}, only {', '.join(self.table)[:200]}",
                "This tensor file is not a measured BSDF",
            )
        dtype, offset, shape = self.table[name]
        if len(shape) != ndim or reading.product(shape) == 0:
            raise FormatError(
                f"{self.path}: field {name!r} has shape {shape}, not {ndim} dimensions of at least 1",
                "The file is damaged",
            )
        table = reading.binary(self.path, dtype, reading.product(shape), offset, f"field {name!r} {shape}")
        return reading.doubles(table.reshape(shape))

    def string(self, name: str) -> str:
        if name not in self.table or self.table[name][0] != "u1":
            return ""
        _, offset, shape = self.table[name]
        return (
            bytes(reading.binary(self.path, "u1", min(reading.product(shape), 4096), offset, name))
            .decode("utf-8", errors="replace")
            .strip()
        )
