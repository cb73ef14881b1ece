"""UTIA BRDF database (Filip, Vavra 2014), ``.bin`` or ``.exr``: RGB over even grids of both directions, anisotropic.

``.bin``: three planes R, G, B of float64, [theta_i][phi_i][theta_v][phi_v] with 6 x 48 x 6 x 48 entries, steps of 15 and 7.5
degrees.  ``.exr``: the same as a picture, rows (theta_i, phi_i), columns (theta_v, phi_v).

Motes' models are isotropic: the mean over rotations of the sample is read unless the whole is asked for.  Neither the scale
nor the transfer curve of the values is documented, and public readers disagree (values as they are; sRGB decoded; divided by
140, decoded, times 100): see ``encoding`` and ``scale``.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.errors import MotesError
from motes.files import reading
from motes.images import exr
from motes.measurements._angles import node_weights
from motes.measurements.measurement import Measurement

NAME = "utia"
SOURCE = "Filip, Vavra, Template-Based Sampling of Anisotropic BRDFs, Computer Graphics Forum 33(7), 2014 (UTIA BRDF database)"
N_THETA, N_PHI = 6, 48
SIDE = N_THETA * N_PHI
SIZE = 3 * SIDE * SIDE * 8
ENCODINGS = ("linear", "srgb")
_PICTURE = re.compile(r"m\d{3}_.*\.exr", re.IGNORECASE)

Array = NDArray[np.float64]


def sniff(path: Path, head: bytes) -> bool:
    if path.is_dir():
        return False
    if head.startswith(exr.MAGIC):
        return _PICTURE.fullmatch(path.name) is not None and exr.size(path) == (SIDE, SIDE)
    return path.suffix.lower() == ".bin" and path.stat().st_size == SIZE


def read_utia(path: Path, *, isotropic: bool = True, encoding: str = "linear", scale: float = 1.0) -> Measurement:
    """The table.

    Parameters
    ----------
    path
        The file.
    isotropic
        Whether to read the mean over the 48 rotations of the sample, 1,728 pairs of directions, instead of all 82,944.
    encoding
        ``"linear"``, or ``"srgb"`` to decode the values by the curve of sRGB.
    scale
        What the (decoded) values are multiplied by to be f_r [1/sr].
    """
    if encoding not in ENCODINGS:
        raise MotesError(f"encoding = {encoding!r} is none", f"Give {' or '.join(ENCODINGS)}")
    if not (np.isfinite(scale) and scale > 0):
        raise MotesError(f"scale = {scale!r} is not above 0", "It multiplies the values")
    values = _table(path)  # theta_i, phi_i, theta_v, phi_v, channel
    with np.errstate(over="ignore", invalid="ignore"):  # damaged values stay what they are and are masked
        if encoding == "srgb":
            values = np.where(values > 0.04045, ((np.maximum(values, 0) + 0.055) / 1.055) ** 2.4, values / 12.92)
        values = values * scale
    notes = [
        f"f_r in 1/sr: the values taken as {encoding}, times {scale:g}; their scale and transfer curve are not documented"
    ]
    polar = np.deg2rad(15.0 * np.arange(N_THETA))
    azimuth = np.deg2rad(7.5 * np.arange(N_PHI))
    rings = node_weights(polar)
    extra = {}
    if isotropic:
        turned = np.stack([np.roll(values[:, k], -k, axis=2) for k in range(N_PHI)], axis=1)  # phi_v - phi_i
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            values, spread = turned.mean(axis=1), turned.std(axis=1)
            ratio = (spread / values)[values > 0]
        ratio = ratio[np.isfinite(ratio)]
        anisotropy = float(np.median(ratio)) if ratio.size else 0.0
        extra = {"anisotropy": anisotropy}
        notes.append(
            f"The mean over {N_PHI} rotations of the sample, about which the values scatter by {anisotropy:.1%} in the median: "
            "isotropic=False reads all"
        )
        theta_i, theta_v, phi_v = np.meshgrid(polar, polar, azimuth, indexing="ij")
        phi_i = np.zeros_like(theta_i)
        weights = rings[:, None, None] * rings[:, None] * np.ones(N_PHI)
    else:
        theta_i, phi_i, theta_v, phi_v = np.meshgrid(polar, azimuth, polar, azimuth, indexing="ij")
        weights = rings[:, None, None, None] * np.ones((N_PHI, 1, 1)) * rings[:, None] * np.ones(N_PHI)
    return Measurement.from_arrays(
        directions.from_spherical(theta_i.reshape(-1), phi_i.reshape(-1)),
        directions.from_spherical(theta_v.reshape(-1), phi_v.reshape(-1)),
        values.reshape(-1, 3),
        channels=("R", "G", "B"),
        weights=weights.reshape(-1),
        provenance={
            "format": NAME,
            "path": str(path),
            "name": path.stem,
            "source": SOURCE,
            "isotropic": isotropic,
            **extra,
            "notes": notes,
        },
    )


def _table(path: Path) -> Array:
    """(6, 48, 6, 48, 3)."""
    if reading.head(path, 4) == exr.MAGIC:
        picture = exr.rgb(path, "reading UTIA pictures")
        reading.require(
            picture.shape == (SIDE, SIDE, 3),
            f"{path} has {picture.shape[1]} x {picture.shape[0]} pixels, not {SIDE} x {SIDE}",
            "This is not a UTIA table",
        )
        return reading.doubles(picture).reshape(N_THETA, N_PHI, N_THETA, N_PHI, 3)
    size = path.stat().st_size
    reading.require(
        size == SIZE,
        f"{path} is {size:,} bytes long, not {SIZE:,}",
        "It is truncated, or no UTIA table of 6 x 48 x 6 x 48",
    )
    planes = reading.binary(path, "<f8", SIZE // 8, 0, "the table")
    table = np.moveaxis(planes.reshape(3, N_THETA, N_PHI, N_THETA, N_PHI), 0, -1)
    return np.ascontiguousarray(table)
