"""A Zemax tabular BSDF: scatter about the mirror direction, for OpticStudio and what else reads ``.bsdf`` text."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes.directions import HORIZON, from_spherical
from motes.exports import tristimulus
from motes.exports.shaders import plain
from motes.exports.subject import Subject
from motes.files import write_text
from motes.measurements.zemax import about_mirror

SUFFIX = ".bsdf"
Array = NDArray[np.float64]

INCIDENCE = tuple(range(0, 90, 5))
AZIMUTH = tuple(range(0, 181, 10))
RADIAL = (
    0,
    1,
    2,
    3,
    4,
    5,
    6,
    8,
    10,
    12.5,
    15,
    17.5,
    20,
    25,
    30,
    35,
    40,
    45,
    50,
    55,
    60,
    65,
    70,
    75,
    80,
    85,
    90,
    *range(100, 180, 10),
)
QUANTITIES = {"X": "TristimulusX", "Y": "TristimulusY", "Z": "TristimulusZ"}
RINGS = 64  # of directions that the total integrated scatter is summed over


def limits(subject: Subject) -> list[str]:
    """What the format cannot say."""
    said = [
        "The radial steps are 1 degree at the mirror direction and 5 to 10 away from it: a highlight narrower than a degree falls between.",
        "Directions below the horizon hold 0.",
    ]
    return [*tristimulus.limits(subject), *said]


def write(subject: Subject, path: Path) -> list[Path]:
    """Write the table."""
    from motes.version import __version__

    names, f = tristimulus.evaluator(subject)
    theta, azimuth, radial = (
        a.reshape(-1)
        for a in np.meshgrid(*(np.deg2rad(np.array(a, float)) for a in (INCIDENCE, AZIMUTH, RADIAL)), indexing="ij")
    )
    wi, wo = from_spherical(theta, 0.0), about_mirror(theta, np.zeros_like(theta), radial, azimuth)
    above = wo[:, 2] > HORIZON
    values = np.zeros((len(wi), len(names)))
    values[above] = f(wi[above], wo[above])
    tables = values.reshape(len(INCIDENCE), len(AZIMUTH), len(RADIAL), len(names))
    total = np.stack([_total(f, float(t)) for t in np.deg2rad(INCIDENCE)])
    lines = [f"# {plain(subject.title)}; Motes {__version__}", *(f"# {plain(note)}" for note in subject.notes)]
    lines += ["Source\tMeasured", "Symmetry\tPlaneSymmetrical"]
    lines += [
        f"SpectralContent\t{'Monochrome' if len(names) == 1 else 'XYZ'}",
        "ScatterType\tBRDF",
        "SampleRotation\t1",
        "0",
    ]
    for keyword, angles in (("AngleOfIncidence", INCIDENCE), ("ScatterAzimuth", AZIMUTH), ("ScatterRadial", RADIAL)):
        lines += [f"{keyword}\t{len(angles)}", "\t".join(f"{a:g}" for a in angles)]
    lines.append("")
    for c, name in enumerate(names):
        lines += ["Monochrome" if len(names) == 1 else QUANTITIES[name], "DataBegin"]
        for t, table in enumerate(tables[..., c]):
            lines.append(f"TIS\t{total[t, c]:.6g}")
            lines += ["\t".join(f"{x:.6E}" for x in row) for row in table.tolist()]
        lines.append("DataEnd")
    write_text(path, "\n".join(lines) + "\n")
    return [path]


def _total(f: object, theta_i: float) -> Array:
    """The directional albedo of each quantity, by the midpoint rule over the projected hemisphere."""
    assert callable(f)
    sin2, phi = (np.arange(RINGS) + 0.5) / RINGS, (np.arange(2 * RINGS) + 0.5) / (2 * RINGS) * np.pi
    sin = np.sqrt(sin2)[:, None]
    wo = np.stack([sin * np.cos(phi), sin * np.sin(phi), np.sqrt(1 - sin**2) * np.ones_like(phi)], axis=-1).reshape(
        -1, 3
    )
    wi = np.tile(from_spherical(theta_i, 0.0), (len(wo), 1))
    return np.asarray(np.pi * np.mean(f(wi, wo), axis=0))
