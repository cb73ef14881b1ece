"""ASAM OpenMATERIAL ``.xompt``: a spectral material as calculated values, or a measurement with wavelengths as it is."""

from __future__ import annotations

from pathlib import Path

from motes.exports.angle_table import measurement
from motes.exports.subject import Subject
from motes.measurements.measurement import Measurement
from motes.measurements.openmaterial_writing import write_openmaterial

SUFFIX = ".xompt"


def limits(subject: Subject) -> list[str]:
    """What the format cannot say."""
    return [
        "Steps of 5 to 15 degrees: a highlight narrower than that falls between the values.",
        "Authors, copyright and licence are not known here: the file says so where the schema asks for them.",
    ]


def write(subject: Subject, path: Path) -> list[Path]:
    """Write the table."""
    write_openmaterial(measurement([(None, subject)]), path, sources="simulation")
    return [path]


def write_measurement(data: Measurement, path: Path) -> list[str]:
    """Write measured samples; what is lost, as sentences."""
    return write_openmaterial(data, path)
