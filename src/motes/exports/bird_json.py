"""BiRD JSON: a material as calculated values, or a measurement as it is, with uncertainties and times."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from motes.exports.angle_table import measurement
from motes.exports.subject import Subject
from motes.measurements.bird_writing import write_bird
from motes.measurements.measurement import Measurement

SUFFIX = ".json"


def limits(subject: Subject) -> list[str]:
    """What the format cannot say."""
    return [
        "Steps of 5 to 15 degrees: a highlight narrower than that falls between the values.",
        "Organisation, contact and sample are not known here: the file says so where the schema asks for them.",
    ]


def write(moments: Sequence[tuple[float | None, Subject]], path: Path) -> list[Path]:
    """Write the material at its moments."""
    write_bird(measurement(moments), path, method="simulation")
    return [path]


def write_measurement(data: Measurement, path: Path) -> list[str]:
    """Write measured samples; what is lost, as sentences."""
    return write_bird(data, path)
