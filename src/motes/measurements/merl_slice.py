"""Slices of MERL tables, as ALTA and BRDF Explorer pass them around (f_r in 1/sr).

A text file ``.alta`` with ``#PARAM_IN COS_TH``: rows ``cos(theta_h) R G B`` at theta_d ~ 0, which is backscatter: wi =
wo at theta_h from the normal.  Or an OpenEXR picture of 512 x 512: theta_h = 0..90 degrees along x, theta_d = 0..90
degrees upward, phi_d = 90 degrees, linear f_r.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from motes import directions
from motes.errors import FormatError
from motes.files import reading
from motes.images import exr as _exr
from motes.measurements.measurement import Measurement

NAME = "merl-slice"
SOURCE = "in the layout of slices of the MERL database (Matusik, Pfister, Brand, McMillan, ACM TOG 22(3), 2003) of ALTA"
SIZE = (512, 512)


def sniff(path: Path, head: bytes) -> bool:
    if path.is_dir():
        return False
    if head.startswith(_exr.MAGIC):
        return _exr.size(path) == SIZE
    return b"\0" not in head and b"#PARAM_IN" in head and b"COS_TH" in head


def read_merl_slice(path: Path) -> Measurement:
    """The slice, at the cosines of its rows or the centres of its pixels."""
    if reading.head(path, 4) == _exr.MAGIC:
        return _picture(path)
    return _curve(path)


def _curve(path: Path) -> Measurement:
    header: dict[str, list[str]] = {}
    comments, tokens, rows = [], [], 0
    for line in reading.text(path).splitlines():
        if line.startswith("#"):
            words = line[1:].split()
            if words and words[0].isupper():
                header[words[0]] = words[1:]
            elif words:
                comments.append(" ".join(words))
        elif line.strip():
            words = line.split()
            reading.require(
                len(words) == 4,
                f"{path}, data row {rows + 1} has {len(words)} numbers, not 4",
                "Rows are: cos(theta_h) R G B",
            )
            tokens += words
            rows += 1
    if header.get("DIM") != ["1", "3"] or header.get("PARAM_IN") != ["COS_TH"] or rows == 0:
        raise FormatError(
            f"{path} has {rows} rows of DIM {header.get('DIM')} over {header.get('PARAM_IN')}",
            "Only #DIM 1 3 over COS_TH is read",
        )
    numbers = reading.numbers(tokens, str(path)).reshape(-1, 4)
    cosine = numbers[:, 0]
    reading.require(
        bool(np.all(np.abs(cosine) <= 1)), f"{path}: the first column is not a cosine", "Rows are: cos(theta_h) R G B"
    )
    w = directions.from_spherical(np.arccos(cosine), 0.0)
    notes = ["f_r in 1/sr along cos(theta_h) at theta_d ~ 0, read as exact backscatter: wi = wo", *comments]
    return Measurement.from_arrays(w, w, numbers[:, 1:], channels=("R", "G", "B"), provenance=_provenance(path, notes))


def _picture(path: Path) -> Measurement:
    values = _exr.rgb(path, "reading a slice")
    height, width = values.shape[:2]
    reading.require(
        (height, width) == SIZE,
        f"{path} is {width} x {height} pixels, not 512 x 512",
        "This picture is no slice of a MERL table",
    )
    theta_h = (np.arange(width) + 0.5) / width * directions.HALF_PI
    theta_d = (1 - (np.arange(height) + 0.5) / height) * directions.HALF_PI
    theta_h, theta_d = (a.reshape(-1) for a in np.meshgrid(theta_h, theta_d))
    wi, wo = directions.from_half_difference(theta_h, theta_d, directions.HALF_PI)
    notes = [
        "f_r in 1/sr at the centres of the pixels; phi_d = 90 degrees",
        "weighted by sin(theta_h) 4 cos(theta_d) sin(theta_d), the solid angle within the slice",
        "nothing in an OpenEXR picture says that it is a slice: it was taken for one for its 512 x 512 pixels",
    ]
    return Measurement.from_arrays(
        wi,
        wo,
        values.reshape(-1, 3),
        channels=("R", "G", "B"),
        weights=np.sin(theta_h) * 4 * np.cos(theta_d) * np.sin(theta_d),
        provenance=_provenance(path, notes),
    )


def _provenance(path: Path, notes: list[str]) -> dict[str, Any]:
    return {"format": NAME, "path": str(path), "name": path.stem, "source": SOURCE, "notes": notes}
