"""A Klems matrix in a BSDF file of WINDOW and Radiance: 145 x 145 patches of directions.

Each number is the mean of the BRDF over a pair of patches, weighted by the cosines, of 16 x 16 pairs of points: the same points
for light and viewer, so that the matrix is exactly as reciprocal as the BRDF.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from motes.errors import ParameterError
from motes.exports import tristimulus, window_xml
from motes.exports.subject import Subject
from motes.measurements._angle_basis import KLEMS, AngleBasis, towards_light

SUFFIX = ".xml"
BASES = {"full": "lbnl/klems full", "half": "lbnl/klems half", "quarter": "lbnl/klems quarter"}
PER_AXIS = 4  # points across a patch, in each of its two axes


def limits(subject: Subject) -> list[str]:
    """What the format cannot say."""
    return [
        *window_xml.limits(subject),
        "Patches are 10 to 15 degrees wide: a highlight narrower than that is spread over its patch.",
    ]


def write(subject: Subject, path: Path, *, basis: str = "full") -> list[Path]:
    """Write the matrix.

    Parameters
    ----------
    subject, path
        What, and where to.
    basis
        ``"full"`` (145 patches), ``"half"`` (77) or ``"quarter"`` (41).
    """
    if basis not in BASES:
        raise ParameterError(f"basis = {basis!r} is no basis of Klems", f"Give {', '.join(BASES)}")
    names, f = tristimulus.evaluator(subject)
    angles = KLEMS[BASES[basis]]
    points = angles.points(PER_AXIS)
    outgoing = points.reshape(-1, 3)
    table = np.empty((angles.size, angles.size, len(names)))  # outgoing, incident
    for k, incident in enumerate(towards_light(points)):
        wi = np.repeat(incident, len(outgoing), axis=0)
        wo = np.tile(outgoing, (len(incident), 1))
        values = np.broadcast_to(f(wi, wo), (len(wi), len(names)))
        table[:, k] = values.reshape(len(incident), angles.size, -1, len(names)).mean(axis=(0, 2))
    bases = f"<ColumnAngleBasis>{angles.name}</ColumnAngleBasis>\n<RowAngleBasis>{angles.name}</RowAngleBasis>"
    blocks = {
        window_xml.NAMES[name]: (
            bases,
            "\n".join("\t".join(f"{x:.7g}" for x in row) for row in table[:, :, c].tolist()),
        )
        for c, name in enumerate(names)
    }
    return window_xml.write(subject, path, _definition(angles), blocks)


def _definition(angles: AngleBasis) -> str:
    rings = []
    for lower, upper, count in zip(angles.edges, angles.edges[1:], angles.counts, strict=False):
        middle = 0.0 if count == 1 else (lower + upper) / 2
        rings.append(
            f"<AngleBasisBlock><Theta>{middle:g}</Theta><nPhis>{count}</nPhis><ThetaBounds>"
            f"<LowerTheta>{lower:g}</LowerTheta><UpperTheta>{upper:g}</UpperTheta></ThetaBounds></AngleBasisBlock>"
        )
    return "\n".join(
        [
            "<IncidentDataStructure>Columns</IncidentDataStructure>",
            f"<AngleBasis><AngleBasisName>{angles.name}</AngleBasisName>",
            *rings,
            "</AngleBasis>",
        ]
    )
