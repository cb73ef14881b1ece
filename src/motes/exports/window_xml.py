"""The frame of a BSDF file of WINDOW and Radiance (XML), around the numbers of one reflecting side."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from xml.sax.saxutils import escape

from motes.exports import tristimulus
from motes.exports.shaders import plain
from motes.exports.subject import Subject
from motes.files import write_text

#: How WINDOW names the quantities.
NAMES = {"X": "CIE-X", "Y": "Visible", "Z": "CIE-Z"}
#: WINDOW's names of the three responses, for its ``DetectorSpectrum``.
DETECTORS = {"Visible": "ASTM E308 1931 Y.dsp", "CIE-X": "ASTM E308 1931 X.dsp", "CIE-Z": "ASTM E308 1931 Z.dsp"}


def limits(subject: Subject) -> list[str]:
    """What the XML cannot say, however its numbers are arranged."""
    said = ["The file holds the side that WINDOW calls the back and Radiance the front, opaque: no transmission."]
    said += tristimulus.limits(subject)
    if not subject.brdf.reciprocal:
        said.append("Radiance takes files for reciprocal, and this BRDF is not.")
    return said


def write(subject: Subject, path: Path, definition: str, blocks: Mapping[str, tuple[str, str]]) -> list[Path]:
    """Write the file.

    Parameters
    ----------
    subject, path
        What, and where to.
    definition
        The content of ``DataDefinition``.
    blocks
        Name of the quantity -> the elements that name its angle bases, and its numbers.
    """
    from motes.version import __version__

    parts = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f"<!-- {_comment(f'{subject.title}; Motes {__version__}')} -->",
        *(f"<!-- {_comment(note)} -->" for note in subject.notes),
        '<WindowElement xmlns="http://windows.lbl.gov" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"'
        ' xsi:schemaLocation="http://windows.lbl.gov/BSDF-v1.4.xsd">',
        "<WindowElementType>System</WindowElementType>",
        "<FileType>BSDF</FileType>",
        "<Optical>",
        "<Layer>",
        f"<Material><Name>{escape(plain(subject.name))}</Name><Manufacturer>Motes</Manufacturer>"
        "<DeviceType>Other</DeviceType></Material>",
        "<Geometry></Geometry>",
        f"<DataDefinition>\n{definition}\n</DataDefinition>",
    ]
    for name, (bases, numbers) in blocks.items():
        parts += [
            "<WavelengthData>",
            "<LayerNumber>System</LayerNumber>",
            f'<Wavelength unit="Integral">{name}</Wavelength>',
            "<SourceSpectrum>CIE Illuminant E</SourceSpectrum>",
            f"<DetectorSpectrum>{DETECTORS.get(name, 'none')}</DetectorSpectrum>",
            "<WavelengthDataBlock>",
            "<WavelengthDataDirection>Reflection Back</WavelengthDataDirection>",
            bases,
            "<ScatteringDataType>BRDF</ScatteringDataType>",
            f"<ScatteringData>\n{numbers}\n</ScatteringData>",
            "</WavelengthDataBlock>",
            "</WavelengthData>",
        ]
    parts += ["</Layer>", "</Optical>", "</WindowElement>", ""]
    return [write_text(path, "\n".join(parts))]


def _comment(text: str) -> str:
    return plain(text).replace("--", "- -").rstrip("-")
