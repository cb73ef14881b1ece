"""MBSDF (NVIDIA's MDL SDK): isotropic tables of reflection in even bins of theta_i, theta_r and the azimuth between
them.

``NVIDIA ARC MBSDF V1``, lines of text, ``MBSDF_DATA_REFLECTION=`` (older files: ``MBSDF_DATA=``); int32 type (0 scalar, 1 RGB), n_theta, n_phi;
float32 [theta_in][theta_out][phi][channel].  theta spans [0, pi/2] and phi [0, pi], whose last bin is the specular
side.  Bins are read at their centres. The values obey reciprocity as they are (no cosine in them); small negative ones,
of colours outside the gamut, are data like others.
"""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np

from motes import directions
from motes.errors import FormatError
from motes.files import reading
from motes.measurements._angles import polar_bins
from motes.measurements.measurement import Measurement

NAME = "mbsdf"
SOURCE = "in the layout of measured BSDFs of NVIDIA's Material Definition Language SDK"
MAGIC = b"NVIDIA ARC MBSDF"
REFLECTIONS, TRANSMISSION = (b"MBSDF_DATA_REFLECTION=\n", b"MBSDF_DATA=\n"), b"MBSDF_DATA_TRANSMISSION="
HEADER = 65536  # the text before the table; metadata of a few lines


def sniff(path: Path, head: bytes) -> bool:
    return head.startswith(MAGIC)


def read_mbsdf(path: Path) -> Measurement:
    """The reflection table, one pair of directions a bin, weighted by solid angle."""
    header = reading.head(path, HEADER)
    reading.require(
        header.startswith(MAGIC),
        f"{path} starts with {header[:16]!r}, not {MAGIC.decode()!r}",
        "This is not an MBSDF file",
    )
    starts = [(at, at + len(name)) for name in REFLECTIONS if (at := header.find(name)) >= 0]
    reading.require(
        bool(starts),
        f"{path} has neither {' nor '.join(name.decode().strip() for name in REFLECTIONS)} in its first {HEADER:,} bytes",
        "Only reflection is read",
    )
    first, start = min(starts)
    reading.require(
        len(header) >= start + 12,
        f"{path} is truncated at byte {len(header)}, before the sizes of its table",
        "Fetch it again",
    )
    kind, n_theta, n_phi = struct.unpack_from("<3i", header, start)
    if kind not in (0, 1) or not 0 < n_theta <= 32768 or not 0 < n_phi <= 32768:
        raise FormatError(
            f"{path}: type {kind} with {n_theta} x {n_theta} x {n_phi} bins is no MBSDF table",
            "Types are 0 (scalar) and 1 (RGB)",
        )
    n_channels = 3 if kind == 1 else 1
    shape = (n_theta, n_theta, n_phi, n_channels)
    table = reading.binary(
        path, "<f4", reading.product(shape), start + 12, f"the table of {' x '.join(map(str, shape))}"
    )
    values = reading.doubles(table.reshape(shape))

    theta, polar = polar_bins(n_theta)
    phi = (np.arange(n_phi) + 0.5) / n_phi * np.pi
    theta_i, theta_r, dphi = np.meshgrid(theta, theta, phi, indexing="ij")
    weights = np.broadcast_to(polar[:, None, None] * polar[:, None] * (np.pi / n_phi), theta_i.shape)
    values = values.reshape(-1, n_channels)
    notes = ["f_r in 1/sr, at the centres of the bins, weighted by their solid angles"]
    copies = _copies(table.reshape(n_theta, -1))
    if copies:
        notes.append(
            f"The last {copies} of {n_theta} angles of incidence repeat the one before them: filled in, not measured"
        )
    if TRANSMISSION in header[:first] or _after(path, start + 12 + table.nbytes).startswith(TRANSMISSION):
        notes.append("The file holds a transmission too, which is not read")
    return Measurement.from_arrays(
        directions.from_spherical(theta_i.reshape(-1), 0.0),
        directions.from_spherical(theta_r.reshape(-1), dphi.reshape(-1)),
        values,
        weights=weights.reshape(-1),
        provenance={"format": NAME, "path": str(path), "name": path.stem, "source": SOURCE, "notes": notes},
    )


def _after(path: Path, offset: int) -> bytes:
    """What begins behind the table, without blank space."""
    with path.open("rb") as file:
        file.seek(offset)
        return file.read(256).lstrip()


def _copies(slabs: np.ndarray) -> int:
    """How many slabs at the end equal the one before them."""
    n = 0
    while n < len(slabs) - 1 and np.array_equal(slabs[-1 - n], slabs[-2 - n]):
        n += 1
    return n
