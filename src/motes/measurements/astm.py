"""ASTM E1392 and E2387 text (``.astm``): a header of keywords, ``VARS`` that names the columns, rows of numbers.

``VARS theta_i,phi_i,theta_s,phi_s,<channel>...`` and rows separated by commas or blanks.  Angles are those of directions away
from the surface; where no column gives the azimuth of the light, it lies at 180 degrees, so that ``phi_s = 0`` is the mirror
side (E2387), and a signed ``theta_s`` is positive there.  By specification at second hand: from the summary of the standards
and public readers of such files.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.errors import FormatError, MotesError
from motes.files import budget, reading
from motes.files.structured import number_list
from motes.measurements.measurement import Measurement

NAME = "astm"
SOURCE = "ASTM E1392/E2387 text"
SAMPLE = 160  # bytes of memory a value
MOST_COLUMNS = 10_000
ANGLES = {
    "theta_i": ("theta_i", "thetai", "ti"),
    "phi_i": ("phi_i", "phii", "pi"),
    "theta_s": ("theta_s", "theta_r", "theta_o", "thetas", "ts"),
    "phi_s": ("phi_s", "phi_r", "phi_o", "phis", "ps"),
}
UNITS = ("degrees", "radians")
_VARS = re.compile(r"^\s*VARS[\s:=]+(.+)$", re.IGNORECASE | re.MULTILINE)
_KEYWORD = re.compile(r"^\s*([A-Za-z][\w ]*?)[\s:=]+(.*)$")
_WAVELENGTH = re.compile(r"(\d+(?:\.\d*)?) *(nm|um|µm|μm)", re.IGNORECASE)
_COSINE = re.compile(r"cc[_ ]?b[rs]df.*|cosine.corrected.*|arsf?|.*\* ?cos.*", re.IGNORECASE)
_SIGMA = re.compile(r"(?:u|sigma|unc|uncertainty)(?:[_ (]+(.*?)\)?)?", re.IGNORECASE)

Array = NDArray[np.float64]


def sniff(path: Path, head: bytes) -> bool:
    if path.is_dir() or b"\0" in head:
        return False
    match = _VARS.search(head.decode("utf-8", errors="replace"))
    return match is not None and "theta" in match[1].lower()


def read_astm(path: Path, *, angles: str | None = None) -> Measurement:
    """The table.

    Parameters
    ----------
    path
        The file.
    angles
        ``"degrees"`` or ``"radians"``.  Where it is not given, degrees if an angle exceeds 2 pi, radians if all polar angles
        are below pi/2; what is between is an error.
    """
    if angles is not None and angles not in UNITS:
        raise MotesError(f"angles = {angles!r} is no unit of angles", f"Give {' or '.join(UNITS)}")
    text = reading.text(path)
    match = _VARS.search(text)
    if match is None:
        raise FormatError(f"{path} has no line VARS, which names the columns", "This is not an ASTM file")
    header = _header(text[: match.start()])
    names = [name.strip().strip('"') for name in re.split(r"[,\t]+" if "," in match[1] else r"\s+", match[1].strip())]
    reading.require(
        len(set(names)) == len(names) <= MOST_COLUMNS, f"{path}: a name stands twice in VARS", "Each column has its own"
    )
    rows = _rows(path, text[match.end() :], len(names))
    _count(path, header, len(rows))
    columns = dict(zip(names, rows.T, strict=True))
    notes = ["f_r in 1/sr"]
    found = {angle: _take(columns, aliases) for angle, aliases in ANGLES.items()}
    for angle in ("theta_i", "theta_s"):
        reading.require(
            found[angle] is not None, f"{path}: VARS has no {angle}: {', '.join(names)[:200]}", "It needs one"
        )
    scale = _scale(path, found, angles, notes)
    theta_i, theta_s = (np.asarray(found[k]) * scale for k in ("theta_i", "theta_s"))
    phi_s = 0.0 if found["phi_s"] is None else np.asarray(found["phi_s"]) * scale
    if found["phi_i"] is None:
        phi_i: Array | float = np.pi
        notes.append(
            "No azimuth of the light is given: it is taken as 180 degrees, so that phi_s = 0 is the mirror side"
        )
    else:
        phi_i = np.asarray(found["phi_i"]) * scale
    wo = directions.from_spherical(theta_s, phi_s)
    values, uncertainties, channels = _channels(path, columns, wo[:, 2], notes)
    nm = [_nm(name) for name in channels]
    if len(channels) == 1 and nm[0] is None:  # the header may know it
        nm = [_nm(header.get("wavelength", ""))]
    wavelengths = np.array(nm, np.float64) if all(w is not None for w in nm) else None
    return Measurement.from_arrays(
        directions.from_spherical(theta_i, phi_i),
        wo,
        values,
        channels=channels if wavelengths is None else None,
        wavelengths=wavelengths,
        uncertainties=uncertainties,
        provenance={
            "format": NAME,
            "path": str(path),
            "name": header.get("sample_name", "").strip('"') or path.stem,
            "source": SOURCE,
            "header": header,
            "notes": notes,
        },
    )


def _header(text: str) -> dict[str, str]:
    found: dict[str, str] = {}
    for line in text.splitlines()[:500]:
        match = _KEYWORD.match(line)
        if match:
            found.setdefault(match[1].strip().lower(), match[2].strip()[:200])
    return found


def _rows(path: Path, text: str, n: int) -> Array:
    budget.check(path, SAMPLE * (len(text) // 4 + 1), "its numbers")
    numbers = number_list(text, str(path))
    reading.require(
        len(numbers) > 0 and len(numbers) % n == 0,
        f"{path}: {len(numbers):,} numbers are no multiple of the {n} columns of VARS",
        "It is truncated, or VARS does not name every column",
    )
    return numbers.reshape(-1, n)


def _count(path: Path, header: dict[str, str], n: int) -> None:
    stated = reading.integer(header.get("num_points", ""))
    if stated is not None and stated != n:
        raise FormatError(
            f"{path}: NUM_POINTS says {stated} and there are {n} rows", "It is truncated; or mend NUM_POINTS"
        )


def _take(columns: dict[str, Array], aliases: tuple[str, ...]) -> Array | None:
    for name in list(columns):
        if name.lower() in aliases:
            return columns.pop(name)
    return None


def _scale(path: Path, found: dict[str, Array | None], angles: str | None, notes: list[str]) -> float:
    """What makes radians of the angles."""
    polar = max(float(np.max(np.abs(a))) for k, a in found.items() if a is not None and k.startswith("theta"))
    largest = max(float(np.max(np.abs(a))) for a in found.values() if a is not None)
    reading.require(
        np.isfinite(largest) and largest <= 360, f"{path}: an angle of {largest:g}", "Angles are in degrees or radians"
    )
    if angles is None:
        if largest > 2 * np.pi + 1e-3:
            angles = "degrees"
        elif polar <= np.pi / 2 + 1e-3:
            angles = "radians"
        else:
            raise FormatError(
                f"{path}: polar angles up to {polar:g} are more than pi/2 and may be degrees or radians",
                "Say which: --read angles=degrees",
            )
        notes.append(f"Angles are taken as {angles}: the largest is {largest:g}")
    return np.pi / 180 if angles == "degrees" else 1.0


def _channels(
    path: Path, columns: dict[str, Array], cos: Array, notes: list[str]
) -> tuple[Array, Array | None, list[str]]:
    """The values (N, C), their uncertainties or None, and the names of the channels."""
    spreads: dict[str, Array] = {}
    values: dict[str, Array] = {}
    for name, column in columns.items():
        if "log" in name.lower():
            raise FormatError(f"{path}: the column {name[:40]!r} holds logarithms", "Write the values themselves")
        sigma = _SIGMA.fullmatch(name)
        if sigma:
            spreads[sigma[1] or ""] = column
        else:
            values[name] = column
    reading.require(bool(values), f"{path}: VARS names no column of values", "They follow the angles")
    for name in spreads:
        known = name in values or (len(values) == 1 and len(spreads) == 1)
        reading.require(
            known, f"{path}: the uncertainty of {name[:40]!r}, which is no column", f"{', '.join(values)[:200]} are"
        )
    table = np.stack(list(values.values()), axis=-1)
    spread = None
    if spreads:
        only = next(iter(spreads.values())) if len(values) == 1 else None
        nothing = np.full(len(table), np.nan)
        spread = np.stack([spreads.get(name, nothing if only is None else only) for name in values], axis=-1)
        notes.append("Uncertainties are taken as standard ones, in 1/sr")
    corrected = [bool(_COSINE.fullmatch(name)) for name in values]
    if any(corrected):
        factor = np.where(corrected, cos[:, None], 1.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            table = table / factor
            spread = None if spread is None else spread / np.abs(factor)
        which = ", ".join(name for name, c in zip(values, corrected, strict=True) if c)
        notes.append(f"{which[:200]} holds f cos(theta_s) by its name, and was divided by the cosine")
    return table, spread, list(values)


def _nm(name: str) -> float | None:
    match = _WAVELENGTH.fullmatch(name.strip())
    if match is None:
        return None
    return float(match[1]) * (1.0 if match[2].lower() == "nm" else 1e3)
