"""A MERL ``.binary`` table: what measured-BRDF readers of renderers load.

The layout is that of `motes.measurements.merl`: 90 x 90 x 180 bins of theta_h, theta_d, phi_d, each with the value at its centre, in float64: 35 MB.
Bins below the horizon hold 0; the files of the database hold negative numbers there, which some readers interpolate.
"""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np

from motes.drawing.colour import channels_to_srgb
from motes.errors import DataError
from motes.exports.subject import Subject
from motes.files import replacing
from motes.measurements._angles import half_difference_grid
from motes.measurements.merl import FULL, SCALE

SUFFIX = ".binary"
CHUNK = 50_000  # directions at a time


def limits(subject: Subject) -> list[str]:
    """What the format cannot say."""
    said = [
        "Bins are 1 degree wide in theta_d and phi_d; those whose centre is below the horizon hold 0, so that a reader that "
        "interpolates darkens the last degree before grazing."
    ]
    if subject.brdf.channels not in (1, 3):
        said.append("A MERL table has three channels: the spectrum became linear sRGB.")
    if not subject.brdf.reciprocal:
        said.append("A MERL table is reciprocal, and this BRDF is not: each bin holds f(wi, wo) of its wi.")
    return said


def write(subject: Subject, path: Path) -> list[Path]:
    """Write the table.

    Raises
    ------
    DataError
        When the channels are neither one nor three nor a spectrum of the visible.
    """
    nm = subject.wavelengths
    if subject.brdf.channels not in (1, 3) and not (nm and min(nm) <= 480 and max(nm) >= 620):
        raise DataError(
            f"{subject.name} has {subject.brdf.channels} channels that are not a spectrum of the visible, and a MERL table is RGB",
            "csv takes any number of channels",
        )
    wi, wo, _, above = half_difference_grid(*FULL)
    color = channels_to_srgb(subject.channels, subject.wavelengths or None)
    table = np.zeros((3, above.size))
    places = np.flatnonzero(above)
    for start in range(0, len(wi), CHUNK):
        part = slice(start, start + CHUNK)
        values = subject.brdf.eval(wi[part], wo[part])
        rgb = np.broadcast_to(values, (len(values), 3)) if values.shape[1] in (1, 3) else values @ color.matrix
        table[:, places[part]] = (np.maximum(rgb, 0.0) / SCALE).T
    with replacing(path) as temporary, open(temporary, "wb") as file:
        file.write(struct.pack("<3i", *FULL))
        file.write(table.astype("<f8").tobytes())
    return [path]
