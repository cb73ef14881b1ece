"""Plain CSV: ``theta_i,phi_i,theta_r,phi_r[,time],<channel>...``, a row a sample.

The header is required.  Angles are in radians, or in degrees where the name ends in ``_deg``; theta may be negative,
which is the opposite azimuth.  ``theta_o, phi_o`` mean the same as ``theta_r, phi_r``.  ``phi_i`` may be missing and is
then 0, since an isotropic surface knows the difference of the azimuths only; ``phi_r`` is required.  ``time`` is in
hours, ``time_s``, ``time_min``, ``time_h``, ``time_d`` say otherwise. ``weight`` is the solid angle that a sample
stands for.  Every other column is a channel of f_r [1/sr]; where all are named by numbers (``400``, ``400nm``, ``400
nm``) these are wavelengths.  An empty cell is a value that was not measured.  ``#`` starts a comment; commas,
semicolons or tabs separate.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.errors import FormatError
from motes.files import reading
from motes.measurements import _scans, policy
from motes.measurements.measurement import Measurement

NAME = "csv"
SOURCE = "a table of the user's"
TIMES = {"time": 1.0, "time_h": 1.0, "time_s": 1 / 3600, "time_min": 1 / 60, "time_d": 24.0}
ANGLES = {
    "theta_i": "theta_i",
    "phi_i": "phi_i",
    "theta_r": "theta_r",
    "phi_r": "phi_r",
    "theta_o": "theta_r",
    "phi_o": "phi_r",
}
WAVELENGTH = re.compile(r"(\d+(?:\.\d+)?)\s*(?:nm)?", re.IGNORECASE)
LARGEST_ANGLE = 2 * np.pi + 1e-6
MOST_CHANNELS = 10_000


def sniff(path: Path, head: bytes) -> bool:
    if path.is_dir() or b"\0" in head:
        return False
    for line in head.decode("utf-8", errors="replace").removeprefix("\ufeff").splitlines():
        line = line.partition("#")[0].strip()
        if line:
            names = {n.removesuffix("_deg") for n in _cells(line.lower(), _separator(line))}
            return "theta_i" in names and bool(names & {"theta_r", "theta_o"})
    return False


def read_table(path: Path) -> Measurement:
    """The table as a measurement; rows of one time make a scan."""
    numbered = ((n, line.partition("#")[0].rstrip(" \r")) for n, line in enumerate(reading.text(path).splitlines(), 1))
    lines = [(n, line) for n, line in numbered if line.strip()]
    if len(lines) < 2:
        raise FormatError(f"{path} has {len(lines)} lines that are no comments", "It needs a header and a row a sample")
    separator = _separator(lines[0][1])
    header = _cells(lines[0][1], separator)
    angles, time, weight, channels = _columns(path, header)
    rows = _rows(path, lines[1:], separator, len(header))
    line_of = [number for number, _ in lines[1:]]
    for column in (*angles.values(), *time, *weight):
        bad = ~np.isfinite(rows[:, column])
        if bad.any():
            raise FormatError(
                f"{path}, line {line_of[int(np.argmax(bad))]}: {header[column]} is missing or not finite", "Fill it in"
            )

    def angle(name: str) -> NDArray[np.float64]:
        if name not in angles:
            return np.zeros(len(rows))
        values, label = rows[:, angles[name]], header[angles[name]]
        if label.lower().endswith("_deg"):
            values = np.radians(values)
        bad = np.abs(values) > LARGEST_ANGLE
        if bad.any():
            i = int(np.argmax(bad))
            raise FormatError(
                f"{path}, line {line_of[i]}: {label} = {rows[i, angles[name]]:g} is outside +-2 pi rad (+-360 degrees)",
                f"Angles are in radians; name the column {label}_deg for degrees"
                if not label.lower().endswith("_deg")
                else "Check the row",
            )
        return values

    wi = directions.from_spherical(angle("theta_i"), angle("phi_i"))
    wo = directions.from_spherical(angle("theta_r"), angle("phi_r"))
    values = rows[:, channels]
    stamps = rows[:, time[0]] * TIMES[header[time[0]].lower()] if time else np.zeros(len(rows))
    times, scan = np.unique(stamps, return_inverse=True)
    scan = scan.reshape(-1)
    members = np.split(np.argsort(scan, kind="stable"), np.cumsum(np.bincount(scan))[:-1])
    union, indices = _scans.union([np.concatenate([wi[m], wo[m]], axis=1) for m in members])
    spread, present = _scans.spread(len(union), indices, [values[m] for m in members], len(channels), str(path))
    weights = np.ones(len(union))
    if weight:
        for index, m in zip(indices, members, strict=True):
            weights[index] = rows[m, weight[0]]
    wi, wo = union[:, :3], union[:, 3:]
    names = [header[c] for c in channels]
    matches = [WAVELENGTH.fullmatch(n) for n in names]
    wavelengths = [float(m[1]) for m in matches if m] if all(matches) else None
    notes = ["f_r in 1/sr, as the table says"]
    if "phi_i" not in angles:
        notes.append("phi_i is missing and taken as 0")
    return Measurement.from_arrays(
        wi,
        wo,
        spread,
        times=times,
        channels=names if wavelengths is None else [f"{w:g} nm" for w in wavelengths],
        wavelengths=wavelengths,
        weights=weights,
        reasons={policy.NOT_MEASURED: ~present[:, :, None], policy.CLIPPED: policy.clipped(wi, wo, spread)},
        provenance={"format": NAME, "path": str(path), "name": path.stem, "source": SOURCE, "notes": notes},
    )


def _separator(header: str) -> str:
    return max(",;\t", key=header.count)


def _cells(line: str, separator: str) -> list[str]:
    return [cell.strip().strip('"') for cell in line.split(separator)]


def _rows(path: Path, lines: list[tuple[int, str]], separator: str, n_columns: int) -> NDArray[np.float64]:
    """The numbers of all lines, NaN in empty cells."""
    cells: list[str] = []
    for number, line in lines:
        row = _cells(line, separator)
        reading.require(
            len(row) == n_columns,
            f"{path}, line {number} has {len(row)} cells; the header has {n_columns}",
            "Rows match the header",
        )
        cells += [cell or "nan" for cell in row]
    try:
        return np.array(cells, np.float64).reshape(-1, n_columns)
    except ValueError:
        for i, (number, _) in enumerate(lines):  # find the line, for the message
            reading.numbers(cells[i * n_columns : (i + 1) * n_columns], f"{path}, line {number}")
        raise


def _columns(path: Path, header: list[str]) -> tuple[dict[str, int], list[int], list[int], list[int]]:
    """Where the angles, the time, the weight and the channels are."""
    angles: dict[str, int] = {}
    time, weight, channels = [], [], []
    for column, name in enumerate(header):
        lower = name.lower()
        angle = ANGLES.get(lower.removesuffix("_deg"))
        if angle is not None:
            reading.require(angle not in angles, f"{path} gives {angle} in two columns", "Keep one")
            angles[angle] = column
        elif lower in TIMES:
            time.append(column)
        elif lower == "weight":
            weight.append(column)
        else:
            channels.append(column)
    missing = [name for name in ("theta_i", "theta_r", "phi_r") if name not in angles]
    if missing:
        raise FormatError(
            f"{path} has no column {', '.join(missing)}; it has {', '.join(header)[:200]}",
            "Columns: theta_i,phi_i,theta_r,phi_r,<channel>...",
        )
    reading.require(
        len(time) <= 1 and len(weight) <= 1, f"{path} has several columns of time or weight", "Keep one of each"
    )
    names = [header[c] for c in channels]
    if not 1 <= len(names) <= MOST_CHANNELS or len(set(names)) != len(names) or "" in names:
        raise FormatError(
            f"{path} has {len(names)} channels, or some without a name of their own", "Name one column of f_r a channel"
        )
    return angles, time, weight, channels
