"""MERL ``.binary`` (Matusik, Pfister, Brand, McMillan 2003): isotropic RGB tables in half and difference angles.

int32 little-endian (90, 90, 180); three planes R, G, B of float64 little-endian, index = phi_d + 180 (theta_d + 90
theta_h), with square-root bins of theta_h; f_r = stored x (1, 1.15, 1.66) / 1500.  Bins are read at their centres.
Those whose wi or wo lies below the horizon are left out and counted in ``provenance["dropped"]``; a negative value in
the others marks an invalid bin and is masked.
"""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np

from motes.errors import FormatError
from motes.files import reading
from motes.measurements._angles import half_difference_grid
from motes.measurements.measurement import Measurement

NAME = "merl"
SOURCE = "in the layout of the MERL database (Matusik, Pfister, Brand, McMillan, ACM TOG 22(3), 2003)"
SCALE = np.array([1.0, 1.15, 1.66]) / 1500
FULL = (90, 90, 180)


def sniff(path: Path, head: bytes) -> bool:
    if path.is_dir() or len(head) < 12:
        return False
    n_h, n_d, n_p = struct.unpack_from("<3i", head)
    return n_h == n_d and n_p in (2 * n_d, 4 * n_d) and 0 < n_h <= 4096


def read_merl(path: Path) -> Measurement:
    """The table as a measurement: its bins above the horizon, with their solid angles as weights."""
    header = reading.head(path, 12)
    reading.require(
        len(header) == 12,
        f"{path} is {len(header)} bytes long, too short for a MERL header of 12",
        "Fetch the file again",
    )
    shape = struct.unpack("<3i", header)
    n_h, n_d, n_p = shape
    if n_h == n_d and n_p == 4 * n_d and n_h > 0:
        raise FormatError(
            f"{path} has {n_p} bins of phi_d, the variant without reciprocity",
            f"Only the reciprocal layout {FULL} is read; average the two halves",
        )
    if not (0 < n_h == n_d <= 4096 and n_p == 2 * n_d):
        raise FormatError(
            f"{path} starts with the sizes {shape}, not {FULL} (theta_h, theta_d, phi_d)", "This is not a MERL file"
        )
    n = reading.product(shape)
    expected, size = 12 + 24 * n, path.stat().st_size
    reading.require(
        size == expected,
        f"{path} is {size:,} bytes long; sizes {shape} need exactly {expected:,}",
        "It is truncated or of another kind",
    )
    planes = reading.binary(path, "<f8", 3 * n, 12, "the table").reshape(3, n)
    wi, wo, weights, above = half_difference_grid(*shape)
    with np.errstate(invalid="ignore"):  # a signalling NaN in a damaged file is a NaN, not a warning
        values = (planes[:, above].T * SCALE)[None]
    below = int(n - len(wi))
    with np.errstate(invalid="ignore"):
        negative = values < 0
    notes = [
        "f_r in 1/sr = stored x (1, 1.15, 1.66) / 1500, at the centres of the bins, weighted by their solid angles",
        f"{below:,} of {n:,} bins lie below the horizon and are left out",
    ]
    if shape != FULL:
        notes.append(f"The table has {shape} bins instead of {FULL}")
    return Measurement.from_arrays(
        wi,
        wo,
        values,
        weights=weights,
        reasons={"negative (invalid bin)": negative},
        provenance={
            "format": NAME,
            "path": str(path),
            "name": path.stem,
            "source": SOURCE,
            "notes": notes,
            "dropped": {"bins below the horizon": below},
        },
    )
