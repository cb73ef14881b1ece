"""ASAM OpenMATERIAL 3D ``.xompt`` (JSON): a look-up table of wavelength [m], theta_i, theta_o, phi_o [rad], f_r [1/sr].

phi_o is relative to the azimuth of the light.  The schema says that "the incident ray is used as the reference", which leaves
open whether 0 lies on the side of the light or opposite; the first is taken, as Motes and the standard's source
(SEMI ME1392) name directions, and ``reference="forward"`` takes the second.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.errors import FormatError, MotesError
from motes.files import budget, reading
from motes.files.structured import json_object
from motes.measurements._long_table import pivot
from motes.measurements.measurement import Measurement

NAME = "openmaterial"
SOURCE = "ASAM OpenMATERIAL 3D, BRDF look-up table"
SAMPLE = 260  # bytes of memory a row
METRES = 1e9  # to nm
REFERENCES = {"light": 0.0, "forward": np.pi}
DARK = 0.005  # a Lambertian surface of this albedo is blacker than any paint: below it the unit is in doubt
NOT_MEASURED = "not measured at this wavelength"

Array = NDArray[np.float64]


def sniff(path: Path, head: bytes) -> bool:
    if path.is_dir() or not head.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"{"):
        return False
    return b"openMaterial3dVersion" in head or b"OpenMATERIAL" in head or path.suffix.lower() == ".xompt"


def read_openmaterial(path: Path, *, reference: str = "light") -> Measurement:
    """The table, wavelengths as channels.

    Parameters
    ----------
    path
        The ``.xompt`` file.
    reference
        ``"light"``: phi_o = 0 is the side of the light; ``"forward"``: the mirror side.
    """
    if reference not in REFERENCES:
        raise MotesError(f"reference = {reference!r} is no side", f"Give {' or '.join(REFERENCES)}")
    document = json_object(path)
    metadata = document.get("metadata")
    brdf = document.get("brdf")
    if not isinstance(brdf, dict) or not isinstance(brdf.get("lookupTable"), list):
        kinds = ", ".join(map(str, document))[:100]
        raise FormatError(f"{path} has no brdf.lookupTable, only {kinds}", "Other OpenMATERIAL files hold no BRDF")
    rows = _rows(path, brdf["lookupTable"])
    metadata = metadata if isinstance(metadata, dict) else {}
    notes = ["f_r in 1/sr, wavelengths converted from metres"]
    wavelength = rows[:, 0] * METRES
    bad = ~(np.isfinite(wavelength) & (wavelength > 0))
    reading.require(
        not bad.any(), f"{path}, row {int(bad.argmax()) + 1}: the wavelength is no number above 0", "It is in metres"
    )
    if np.median(wavelength) > 2e7:
        raise FormatError(
            f"{path}: a wavelength of {np.median(rows[:, 0]):g} m", "Wavelengths stand in metres: 550 nm is 5.5e-7"
        )
    angles, (nm,), (values,), present = pivot(rows[:, 1:4], [np.round(wavelength, 6)], [rows[:, 4]], path)
    wi = directions.from_spherical(angles[:, 0], 0.0)
    wo = directions.from_spherical(angles[:, 1], angles[:, 2] + REFERENCES[reference])
    if np.any((angles[:, 0] > 0) & (angles[:, 1] > 0)):
        side = "light" if reference == "light" else "mirror direction"
        notes.append(f"Azimuth 0 is taken as the side of the {side}; the standard leaves it open, reference= chooses")
    notes += _doubts(angles, values)
    solid = brdf.get("receiverSolidAngles")
    return Measurement.from_arrays(
        wi,
        wo,
        values,
        wavelengths=np.asarray(nm, np.float64),
        reasons={NOT_MEASURED: ~present[None]},
        provenance={
            "format": NAME,
            "path": str(path),
            "name": _text(metadata, "name") or path.stem,
            "source": SOURCE,
            **{k: _text(metadata, k) for k in ("description", "sources", "license", "uuid") if _text(metadata, k)},
            "authors": [str(a)[:200] for a in metadata.get("authors", []) if isinstance(a, str)][:20]
            if isinstance(metadata.get("authors"), list)
            else [],
            **({"receiver_solid_angles": len(solid)} if isinstance(solid, list) else {}),
            "notes": notes,
        },
    )


def _text(metadata: dict[str, Any], name: str) -> str:
    value = metadata.get(name)
    return value[:500] if isinstance(value, str) else ""


def _rows(path: Path, table: list[Any]) -> Array:
    """The table (M, 5), NaN for null."""
    reading.require(bool(table), f"{path}: its lookupTable is empty", "It needs rows of 5 numbers")
    budget.check(path, SAMPLE * len(table), f"{len(table):,} rows")
    for k, row in enumerate(table):
        if not (isinstance(row, list) and len(row) == 5 and all(x is None or type(x) in (int, float) for x in row)):
            raise FormatError(
                f"{path}, row {k + 1} of the lookupTable is {str(row)[:60]}",
                "A row is [wavelength, theta_i, theta_o, phi_o, value]",
            )
    try:
        rows = np.array([[np.nan if x is None else x for x in row] for row in table], np.float64)
    except OverflowError:
        raise FormatError(f"{path}: a number of the lookupTable is too large", "Check the file") from None
    bad = ~np.all(np.isfinite(rows[:, 1:4]) & (np.abs(rows[:, 1:4]) <= 6.2832), axis=1) | (
        rows[:, 1:3].max(axis=1) > 1.5709
    )
    if bad.any():
        row = int(np.argmax(bad))
        raise FormatError(
            f"{path}, row {row + 1} of the lookupTable: {rows[row, 1:4].tolist()} are not angles in radians",
            "theta_i and theta_o lie in 0 to pi/2, phi_o in 0 to 2 pi",
        )
    return rows


def _doubts(angles: Array, values: Array) -> list[str]:
    """What looks wrong about the numbers."""
    said = []
    usable = values[np.isfinite(values)]
    if usable.size and 0 < np.pi * float(np.median(usable)) < DARK:
        said.append(
            f"The median of f_r, {np.median(usable):.3g}/sr, is that of a matte surface of albedo {np.pi * np.median(usable):.2g}: "
            "darker than any known surface, so the values may be in another unit; they are read as they are"
        )
    # one outgoing direction seen under several incident ones: does f/cos(theta_i) stay the same while f does not?
    cos = np.cos(angles[:, 0])
    grid = np.unique(np.round(angles[:, 1:], 6), axis=0, return_inverse=True)[1].reshape(-1)
    ratio, plain = [], []
    for k in np.unique(grid)[:200]:
        some = (grid == k) & np.isfinite(values[:, 0]) & (values[:, 0] > 0) & (cos > 1e-4)
        if some.sum() >= 3:
            f = values[some, 0]
            plain.append(np.ptp(f) / np.mean(f))
            ratio.append(np.ptp(f / cos[some]) / np.mean(f / cos[some]))
    if plain and np.median(plain) > 0.2 and np.median(ratio) < 0.01:
        said.append(
            "The values go as cos(theta_i): they may be f_r cos(theta_i) instead of f_r; they are read as they are"
        )
    return said
