"""`import_images`: a folder of photographs under known lights, with a table of the lights, as a reflectance map.

Table (CSV): a row a picture.  ``file``; the direction to the light as ``theta_i, phi_i`` (radians, or degrees with ``_deg``) or ``wi_x, wi_y,
wi_z`` (any length); the direction to the viewer as ``theta_r, phi_r`` or ``wo_x, wo_y, wo_z``, straight from above where it is missing; ``time`` (hours;
``time_s``, ``time_min``, ``time_d`` say otherwise), 0 where it is missing; ``exposure`` and ``irradiance``, 1 where they are missing.

.. math::  f_r = L / (\\text{exposure}\\; E \\cos\\theta_i)

for linear pixels L: the exposure is what a radiance is multiplied by to give a pixel, E is the irradiance of the lamp on a surface that faces it.  Light and
viewer are distant, one direction for all texels; pictures are of one size and registered, the surface flat and parallel to the picture, x to the right, y
*upwards* in the local frame (row 0 of the picture is at the top).

What the numbers of a picture are, it says itself: EXR pictures are linear; PNG by the chunks cICP, iCCP, sRGB, gAMA and cHRM, and sRGB where there are none;
TIFF and JPEG by their ICC profile or Exif data, and where they have none, ``transfer`` must say it (for all formats it stands above what a file says).  Other
primaries than sRGB's are turned into those.  The largest code is clipped: NaN, as is what is not finite, what is transparent, and what lies outside an EXR's
data window.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import numpy as np

from motes.channels import default_names
from motes.errors import FormatError, MotesError
from motes.images.photograph import Photograph, open_photograph
from motes.images.transfer_functions import Transfer, asked
from motes.maps import making, zarrs
from motes.maps.lights import Row, rows_of, table_of
from motes.maps.stack import MapStack, create_map, open_stack
from motes.measurements import _common_directions

AT_ONCE = 2**20  # pixels that are made linear at once


def import_images(
    folder: str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    table: str | os.PathLike[str] | None = None,
    linear: bool = False,
    transfer: str | None = None,
    layer: str | None = None,
    chunk: int = 64,
    progress: Callable[[int, int, str], None] | None = None,
) -> MapStack:
    """Turn pictures of a surface under known lights into a reflectance map.

    Parameters
    ----------
    folder
        Holds the pictures and the table.
    out
        The Zarr store to write; nothing may be there.
    table
        The CSV; the only one in the folder when not given.  See the module for its columns.
    linear
        The pictures hold linear values, whatever they say: ``transfer="linear"``.
    transfer
        What the numbers are, whatever the pictures say: ``linear``, ``srgb``, or an exponent such as ``2.2``.
    layer
        Of OpenEXR pictures with several: ``ViewLayer.Combined``, or one channel.
    chunk
        Rows and columns of texels in a chunk.
    progress
        Called with (done, total, what).

    Returns
    -------
    MapStack

    Raises
    ------
    FormatError, DataError
        For a table or a picture that cannot be used.

    Notes
    -----
    Pictures are read once, into a temporary file beside `out` as large as the map; memory holds one picture as it is stored and one row of chunks.
    """
    source = Path(folder)
    if not source.is_dir():
        raise FormatError(f"{source} is not a folder", "Give the folder of the pictures and their table")
    rows = rows_of(table_of(source, table), source)
    times = sorted({row.hours for row in rows})
    scans = [[row for row in rows if row.hours == t] for t in times]
    union, places = _common_directions.union([np.array([[*r.wi, *r.wo] for r in scan]) for scan in scans])
    if linear and transfer not in (None, "linear"):
        raise MotesError(f"both linear and the transfer function {transfer!r} were given", "Give one of them")
    reader = _Reader(asked("linear") if linear else None if transfer is None else asked(transfer), layer)
    height, width, channels = reader.open(rows[0].file).shape
    slots = [(t, int(d), row) for t, scan in enumerate(scans) for d, row in zip(places[t], scan, strict=True)]
    with making.whole(
        out, hint="The import needs twice the size of the map on the disk, half of it for a while"
    ) as store:
        stack = create_map(
            store,
            (height, width),
            union[:, :3],
            union[:, 3:],
            hours=times,
            channels=default_names(channels),
            chunk=chunk,
            name=source.resolve().name,
            attributes={"source": f"{len(rows)} pictures"},
        )
        _transpose(stack, slots, store.with_name("pictures"), reader, progress)
        zarrs.open_group(store, "r+").attrs["notes"] = reader.notes()
    return open_stack(out, mode="r+")


class _Reader:
    """Opens pictures, and remembers what they said of their numbers."""

    def __init__(self, stated: Transfer | None, layer: str | None) -> None:
        self.stated, self.layer = stated, layer
        self.said: Counter[str] = Counter()

    def open(self, path: Path) -> Photograph:
        # A layer is for OpenEXR; a folder may hold others beside.
        return open_photograph(path, self.stated, self.layer if path.suffix.lower() == ".exr" else None)

    def remember(self, picture: Photograph) -> None:
        self.said.update([f"pixels taken as {picture.transfer}", *picture.notes])
        if picture.largest is not None:
            self.said.update(["the largest code of a picture is clipped, and is NaN"])

    def notes(self) -> list[str]:
        """Sentences on all pictures, with their number where they do not all say the same."""
        total = max(self.said.values(), default=0)
        told = [words if n == total else f"{words} ({n} of {total} pictures)" for words, n in self.said.items()]
        return [
            "f_r = pixel / (exposure x irradiance x cos(theta_i)), one direction of light and view for all texels",
            *told,
        ]


def _transpose(
    stack: MapStack,
    slots: list[tuple[int, int, Row]],
    temporary: Path,
    reader: _Reader,
    progress: Callable[[int, int, str], None] | None,
) -> None:
    """Pictures one by one into a file, then out of it one row of chunks at a time."""
    height, width = stack.shape
    shape = (len(slots), height, width, len(stack.channels))
    held = np.memmap(temporary, np.float32, "w+", shape=shape)
    with suppress(AttributeError), temporary.open("r+b") as file:
        # A full disk is found out now, not by a signal in the middle of writing to memory.
        os.posix_fallocate(file.fileno(), 0, held.nbytes)
    bands = range(0, height, stack.array.chunks[0])
    for k, (_, _, row) in enumerate(slots):
        picture = reader.open(row.file)
        if picture.shape != shape[1:]:
            raise FormatError(
                f"{row.file} has {picture.shape[1]} x {picture.shape[0]} pixels and {picture.shape[2]} channels, the first "
                f"picture {width} x {height} and {shape[3]}",
                "All pictures are of one size, and registered",
            )
        for y in range(0, height, max(1, AT_ONCE // width)):
            part = slice(y, min(y + max(1, AT_ONCE // width), height))
            held[k, part] = picture.linear(part) / np.float32(row.scale)
        reader.remember(picture)
        if progress:
            progress(k + 1, len(slots) + len(bands), f"reading {row.file.name}")
    for k, y in enumerate(bands):
        rows = slice(y, min(y + stack.array.chunks[0], height))
        band = np.full((rows.stop - rows.start, width, *stack.sizes), np.nan, np.float32)
        for index, (t, d, _) in enumerate(slots):
            band[:, :, t, d] = held[index, rows]
        stack.write(y, 0, band)
        if progress:
            progress(len(slots) + k + 1, len(slots) + len(bands), "writing")
    del held
