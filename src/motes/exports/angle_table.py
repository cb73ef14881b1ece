"""A material as a measurement of itself, over the even grid of angles that tables are written on."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from motes.directions import from_spherical
from motes.exports.csv_table import grid
from motes.exports.shaders import plain
from motes.exports.subject import Subject
from motes.measurements.measurement import Measurement


def measurement(moments: Sequence[tuple[float | None, Subject]]) -> Measurement:
    """The values of a material at its moments, said to be calculated."""
    first = moments[0][1]
    angles = grid()
    wi, wo = (
        from_spherical(np.deg2rad(angles[:, 0]), 0.0),
        from_spherical(np.deg2rad(angles[:, 1]), np.deg2rad(angles[:, 2])),
    )
    shape = (len(wi), len(first.channels))
    values = np.stack([np.broadcast_to(subject.brdf.eval(wi, wo), shape) for _, subject in moments])
    notes = ["calculated from a model, not measured", *map(plain, first.notes if len(moments) == 1 else first.origin)]
    source = ". ".join((f"Motes: {plain(first.title)}", *map(plain, first.origin)))
    return Measurement.from_arrays(
        wi,
        wo,
        values,
        times=[hours or 0.0 for hours, _ in moments] if len(moments) > 1 else None,
        channels=[plain(name) for name in first.channels],
        wavelengths=first.wavelengths or None,
        provenance={"name": plain(first.name), "source": source, "notes": notes},
    )
