"""Zemax tabular BSDF (``.bsdf`` text; Radiant's BSDF Data Interchange): scatter about the mirror direction.

Keywords ``Source, Symmetry, SpectralContent, ScatterType, SampleRotation, AngleOfIncidence, ScatterAzimuth,
ScatterRadial`` with their angles [deg]; then for each quantity ``DataBegin``, and for each rotation and angle of incidence
a line ``TIS`` and the BSDF [1/sr], a row an azimuth, a column a radial angle; ``DataEnd``.

The radial angle is that to the mirror direction; the azimuth about it counts from the plane of incidence, 0 towards the normal.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.errors import FormatError
from motes.files import budget, reading
from motes.measurements._keyword_text import Keywords, choice, told_apart
from motes.measurements.measurement import Measurement

NAME = "zemax"
SOURCE = "Zemax tabular BSDF (Radiant BSDF Data Interchange format)"
UNMEASURED = "exactly 0, which the format has where nothing was measured"
SAMPLE = 220  # bytes of memory a sample
_SYMMETRY = {"planesymmetrical": "PlaneSymmetrical", "asymmetrical": "Asymmetrical", "asymmetrical4d": "Asymmetrical4D"}
_QUANTITIES = {"monochrome": "grey", "tristimulusx": "X", "tristimulusy": "Y", "tristimulusz": "Z"}

Array = NDArray[np.float64]


def sniff(path: Path, head: bytes) -> bool:
    words = head.decode("latin-1").lower()
    return not path.is_dir() and b"\0" not in head and "scatterazimuth" in words and "angleofincidence" in words


def read_zemax(path: Path) -> Measurement:
    """The BRDF of the file, X, Y and Z as channels where it has them."""
    text = Keywords(path)
    grids: dict[str, Array] = {}
    symmetry = kind = ""
    tables: dict[str, Array] = {}
    totals: dict[str, list[float | None]] = {}
    quantity = "grey"
    while text.more():
        where, word = text.where(), text.word()
        if word in ("samplerotation", "angleofincidence", "scatterazimuth", "scatterradial"):
            grids[word] = text.angles()
        elif word == "symmetry":
            symmetry = _SYMMETRY[choice(text.value(), _SYMMETRY, where, "the symmetry")]
        elif word == "scattertype":
            kind = text.value().upper()
        elif word in _QUANTITIES:
            quantity = _QUANTITIES[word]
            text.at += 1
        elif word == "databegin":
            text.at += 1
            reading.require(quantity not in tables, f"{where}: {quantity} is there twice", "The file is damaged")
            tables[quantity], totals[quantity] = _table(text, grids, where)
        else:
            text.value()
    reading.require(bool(tables), f"{path} is truncated: it has no DataBegin", "Fetch the file again")
    if kind != "BRDF":
        raise FormatError(f"{path} has a ScatterType of {kind[:40] or 'nothing'!r}", "Only BRDF is read")
    names = [name for name in ("grey", "X", "Y", "Z") if name in tables]
    values = np.stack([tables[name] for name in names], axis=-1)
    wi, wo = _directions(grids)
    kept = told_apart(values, len(grids["scatterazimuth"]), grids["scatterradial"])
    wi, wo, values = wi[kept], wo[kept], values[kept]
    notes = [
        "f_r in 1/sr; radial angles are those to the mirror direction, azimuths count from the side of the normal",
        f"Symmetry: {symmetry or 'not stated'}; angles that the file leaves out by symmetry are left out here, too",
    ]
    if not kept.all():
        notes.append(f"{int(np.count_nonzero(~kept)):,} repeats of the value in the mirror direction are left out")
    rotations = grids["samplerotation"]
    if len(rotations) > 1:
        notes.append("SampleRotation is taken as the azimuth of the light; which way it counts is not stated")
    return Measurement.from_arrays(
        wi,
        wo,
        values,
        channels=names,
        reasons={UNMEASURED: np.all(values == 0, axis=-1, keepdims=True)[None]},
        provenance={
            "format": NAME,
            "path": str(path),
            "name": path.stem,
            "source": SOURCE,
            "comments": text.comments,
            "total_integrated_scatter": totals[names[0]],
            "notes": notes,
        },
    )


def _table(text: Keywords, grids: dict[str, Array], where: str) -> tuple[Array, list[float | None]]:
    """The values (N,) between DataBegin and DataEnd, and the TIS of each geometry, None where it is no number."""
    grids.setdefault("samplerotation", np.zeros(1))
    for name in ("angleofincidence", "scatterazimuth", "scatterradial"):
        reading.require(name in grids, f"{where}: DataBegin before {name}", "The file is damaged")
    geometries = len(grids["samplerotation"]) * len(grids["angleofincidence"])
    inner = len(grids["scatterazimuth"]) * len(grids["scatterradial"])
    budget.check(text.path, SAMPLE * geometries * inner, f"{geometries} x {inner} directions")
    parts: list[Array] = []
    totals: list[float | None] = []
    for _ in range(geometries):
        here = text.where()
        if not text.more() or text.word() != "tis":
            raise FormatError(
                f"{here}: table {len(parts) + 1} of {geometries} does not start with TIS",
                "The file is truncated or damaged",
            )
        total = float(reading.numbers([text.value() or "nan"], here)[0])
        totals.append(total if np.isfinite(total) else None)
        parts.append(text.numbers(inner, f"table {len(parts) + 1} of {geometries}"))
    if text.more() and text.word() == "dataend":
        text.at += 1
    return np.concatenate(parts), totals


def _directions(grids: dict[str, Array]) -> tuple[Array, Array]:
    """wi, wo (N, 3) in the order of the values."""
    names = ("samplerotation", "angleofincidence", "scatterazimuth", "scatterradial")
    rotation, incidence, azimuth, radial = (
        a.reshape(-1) for a in np.meshgrid(*(np.deg2rad(grids[name]) for name in names), indexing="ij")
    )
    return directions.from_spherical(incidence, rotation), about_mirror(incidence, rotation, radial, azimuth)


def about_mirror(theta_i: Array, phi_i: Array, radial: Array, azimuth: Array) -> Array:
    """Outgoing directions (..., 3) at a radial angle from the mirror direction of the light at (theta_i, phi_i) [rad].

    In the plane of incidence the light lies at +x, so the mirror direction is (-sin, 0, cos), and (cos, 0, sin) is at right
    angles to it, towards the normal: there the azimuth is 0.
    """
    across, along = np.sin(radial) * np.sin(azimuth), np.cos(radial)
    inward = np.sin(radial) * np.cos(azimuth)
    cos, sin = np.cos(theta_i), np.sin(theta_i)
    x, z = inward * cos - along * sin, inward * sin + along * cos
    return np.stack(
        [x * np.cos(phi_i) - across * np.sin(phi_i), x * np.sin(phi_i) + across * np.cos(phi_i), z], axis=-1
    )
