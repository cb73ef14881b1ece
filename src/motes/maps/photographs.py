"""`import_images`: a folder of photographs under known lights, with a table of the lights, as a reflectance map.

Table (CSV): a row a picture.  ``file``; the direction to the light as ``theta_i, phi_i`` (radians, or degrees with ``_deg``) or ``wi_x, wi_y,
wi_z`` (any length); the direction to the viewer as ``theta_r, phi_r`` or ``wo_x, wo_y, wo_z``, straight from above where it is missing; ``time`` (hours;
``time_s``, ``time_min``, ``time_d`` say otherwise), 0 where it is missing; ``exposure`` and ``irradiance``, 1 where they are missing.

.. math::  f_r = L / (\\text{exposure}\\; E \\cos\\theta_i)

for linear pixels L: the exposure is what a radiance is multiplied by to give a pixel, E is the irradiance of the lamp on a surface that faces it.  Light and
viewer are distant, one direction for all texels; pictures are of one size and registered, the surface flat and parallel to the picture, x to the right, y
*upwards* in the local frame (row 0 of the picture is at the top).

EXR pictures are linear.  PNG pictures of 8 or 16 bits are decoded as sRGB (IEC 61966-2-1) unless ``linear`` is asked for.  The largest code of a PNG
is clipped: NaN, as is what is not finite in an EXR.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes.channels import LUMINANCE, RGB, default_names
from motes.errors import FormatError, MotesError
from motes.images import exr as _exr
from motes.images import png as _png
from motes.maps.lights import Row, rows_of, table_of
from motes.maps.stack import MapStack, create_map
from motes.measurements import _scans

Singles = NDArray[np.float32]
Floats = NDArray[np.float64]


def import_images(
    folder: str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    table: str | os.PathLike[str] | None = None,
    linear: bool = False,
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
        PNG pictures hold linear values, not sRGB.
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
    Pictures are read once, into a temporary file beside `out` as large as the map; memory holds one picture and one row of chunks.
    """
    source = Path(folder)
    if not source.is_dir():
        raise FormatError(f"{source} is not a folder", "Give the folder of the pictures and their table")
    rows = rows_of(table_of(source, table), source)
    times = sorted({row.hours for row in rows})
    scans = [[row for row in rows if row.hours == t] for t in times]
    union, places = _scans.union([np.array([[*r.wi, *r.wo] for r in scan]) for scan in scans])
    first = picture(rows[0].file, linear)
    height, width, channels = first.shape
    stack = create_map(
        out,
        (height, width),
        union[:, :3],
        union[:, 3:],
        hours=times,
        channels=default_names(channels),
        chunk=chunk,
        name=source.resolve().name,
        attributes={
            "source": f"{len(rows)} pictures",
            "notes": [
                "f_r = pixel / (exposure x irradiance x cos(theta_i)), one direction of light and view for all texels",
                "PNG values taken as linear" if linear else "PNG values decoded from sRGB (IEC 61966-2-1)",
                "the largest code of a PNG is clipped, and is NaN",
            ],
        },
    )
    slots = [(t, int(d), row) for t, scan in enumerate(scans) for d, row in zip(places[t], scan, strict=True)]
    try:
        with tempfile.TemporaryDirectory(prefix=".motes-", dir=Path(out).resolve().parent) as temporary:
            _transpose(stack, slots, Path(temporary) / "pictures", linear, progress)
    except BaseException as error:
        import shutil

        shutil.rmtree(stack.path, ignore_errors=True)
        if isinstance(error, OSError):
            raise MotesError(
                f"{out} cannot be written: {error.strerror or error}",
                "The import needs twice the size of the map on the disk, half of it for a while",
            ) from error
        raise
    return stack


def picture(path: Path, linear: bool) -> Singles:
    """Linear pixels (y, x, C) as float32, C = 3 or 1; NaN where the picture is clipped or not finite."""
    try:
        if path.suffix.lower() == ".exr":
            channels = _exr.read(path, "Reading pictures")
            names = next((n for n in (RGB, (LUMINANCE,)) if set(n) <= set(channels)), sorted(channels)[:1])
            values = np.stack([channels[n] for n in names], axis=-1)
            values[~np.isfinite(values)] = np.nan
            return values
        codes, largest = _png.read(path)
    except OSError as error:
        raise FormatError(
            f"{path} cannot be read: {error.strerror or error}", "Check the table and the folder"
        ) from None
    return np.asarray(_decoded(largest, linear)[codes])


def srgb_decode(encoded: Floats) -> Floats:
    """sRGB in [0, 1] to linear (IEC 61966-2-1)."""
    return np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)


def _decoded(largest: int, linear: bool) -> Singles:
    """The linear value of every code; the largest is clipped, NaN."""
    codes = np.arange(largest + 1) / largest
    table = (codes if linear else srgb_decode(codes)).astype(np.float32)
    table[-1] = np.nan
    return table


def _transpose(
    stack: MapStack,
    slots: list[tuple[int, int, Row]],
    temporary: Path,
    linear: bool,
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
        values = picture(row.file, linear)
        if values.shape != shape[1:]:
            raise FormatError(
                f"{row.file} has {values.shape[1]} x {values.shape[0]} pixels and {values.shape[2]} channels, the first "
                f"picture {width} x {height} and {shape[3]}",
                "All pictures are of one size, and registered",
            )
        held[k] = values / np.float32(row.scale)
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
