"""OpenEXR pictures as float32 arrays; headers are checked against the size of the file before decoding."""

from __future__ import annotations

import io
import os
import struct
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes.channels import LUMINANCE, RGB
from motes.errors import FormatError, MissingExtraError
from motes.files import reading

MAGIC = struct.pack("<I", 20000630)
HEADER = 65536
# The best that lossless compression makes of a measured picture is far below; it bounds what a small hostile file can
# make us allocate.
LARGEST_RATIO = 1000


def size(path: Path) -> tuple[int, int] | None:
    """(height, width) from the header, or None where it is not a plain scan-line or tiled picture of sane size."""
    header = reading.head(path, HEADER)
    if not header.startswith(MAGIC) or len(header) < 8 or header[5] & 0x18:  # deep or multi-part
        return None
    at = 8
    window: tuple[int, ...] | None = None
    try:
        while header[at] != 0:
            name_end = header.index(0, at)
            type_end = header.index(0, name_end + 1)
            (length,) = struct.unpack_from("<i", header, type_end + 1)
            if length < 0:
                return None
            if header[at:name_end] == b"dataWindow" and length == 16:
                window = struct.unpack_from("<4i", header, type_end + 5)
            at = type_end + 5 + length
    except (IndexError, ValueError, struct.error):
        return None
    if window is None:
        return None
    height, width = window[3] - window[1] + 1, window[2] - window[0] + 1
    if height < 1 or width < 1 or height * width * 2 > LARGEST_RATIO * path.stat().st_size:
        return None
    return height, width


def read(path: Path, purpose: str) -> dict[str, NDArray[np.float32]]:
    """The channels (height, width) by name.

    Raises
    ------
    MissingExtraError
        Without the package OpenEXR.
    FormatError
        When the file is not an EXR, is truncated, or claims a size that it cannot hold.
    """
    try:
        import OpenEXR
    except ImportError:
        raise MissingExtraError("OpenEXR", "exr", purpose) from None
    if size(path) is None:
        raise FormatError(f"{path} is not a complete OpenEXR picture of sane size", "Fetch the file again")
    try:
        with _quiet(), np.errstate(invalid="ignore"), OpenEXR.File(str(path), separate_channels=True) as file:
            channels = {name: np.asarray(c.pixels, np.float32) for name, c in file.channels().items()}
    except Exception as error:  # the library raises what it likes: RuntimeError, ValueError, TypeError
        raise FormatError(
            f"{path} cannot be decoded: {str(error)[:200]}", "The file is damaged; fetch it again"
        ) from None
    if not channels or any(c.ndim != 2 or c.shape != next(iter(channels.values())).shape for c in channels.values()):
        raise FormatError(f"{path} has no channels of one size", "Layers and subsampled channels are not read")
    return channels


@contextmanager
def _quiet() -> Iterator[None]:
    """Keep the library's remarks on damaged files from the terminal: the error that follows says it in a sentence.

    It prints to Python's stdout, which may be a table for machines, and C's stderr.
    """
    try:
        saved = os.dup(2)
    except OSError:  # no stderr, nothing to keep quiet
        saved = -1
    try:
        if saved >= 0:
            sink = os.open(os.devnull, os.O_WRONLY)
            os.dup2(sink, 2)
            os.close(sink)
        with redirect_stdout(io.StringIO()):
            yield
    finally:
        if saved >= 0:
            os.dup2(saved, 2)
            os.close(saved)


def rgb(path: Path, purpose: str) -> NDArray[np.float32]:
    """R, G and B (height, width, 3); a grey channel Y serves for all three."""
    channels = read(path, purpose)
    names = RGB if RGB[0] in channels else (LUMINANCE,) * 3
    if not all(n in channels for n in names):
        raise FormatError(f"{path} has the channels {', '.join(channels)[:100]}", "R, G and B (or Y) are needed")
    return np.stack([channels[n] for n in names], axis=-1)
