"""The table of a folder of pictures: where light and viewer were, when, and at which exposure; see `motes.maps.photographs`."""

from __future__ import annotations

import difflib
import os
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.errors import DataError, FormatError
from motes.files import reading
from motes.images.photograph import SUFFIXES
from motes.measurements.table import TIMES

Floats = NDArray[np.float64]

#: For each thing that a row says, the ways to say it: the columns that belong together.
WAYS: dict[str, tuple[tuple[str, ...], ...]] = {
    f"{angle} of the {what}": (
        (f"{angle}_{suffix}_deg",),
        (f"{angle}_{suffix}",),
        tuple(f"{vector}_{axis}" for axis in "xyz"),
    )
    for what, vector, suffix in (("light", "wi", "i"), ("viewer", "wo", "r"))
    for angle in ("theta", "phi")
} | {"the time": tuple((name,) for name in TIMES)}
OTHERS = ("file", "exposure", "irradiance")
LEFT_OUT = "note"
LARGEST_GAIN = 1e12  # of an exposure or irradiance: beyond it pixels in float32 lose their values


class Row(NamedTuple):
    """A picture: its file, the directions, the time [h], and what a BRDF is multiplied by to give a pixel."""

    file: Path
    wi: Floats
    wo: Floats
    hours: float
    scale: float


def table_of(folder: Path, table: str | os.PathLike[str] | None) -> Path:
    if table is not None:
        path = Path(table) if Path(table).is_file() else folder / table
        if not path.is_file():
            raise FormatError(f"{path} does not exist", "Give the CSV of the lights with --table")
        return path
    found = sorted(p for p in folder.iterdir() if p.suffix.lower() == ".csv")
    if len(found) != 1:
        names = ", ".join(p.name for p in found[:5]) or "none"
        raise FormatError(
            f"{folder} holds {len(found)} CSV files ({names}), and one of them must say where the lights were",
            "Columns: file,theta_i_deg,phi_i_deg[,theta_r_deg,phi_r_deg][,time][,exposure]; name it with --table",
        )
    return found[0]


def rows_of(path: Path, folder: Path) -> list[Row]:
    """The table, checked, in its order."""
    text = "\n".join(line.partition("#")[0] for line in reading.text(path).splitlines())
    lines = [line for line in text.splitlines() if line.strip()]
    separator = max(",;\t", key=(lines or [""])[0].count)
    cells = list(reading.delimited(lines, separator, str(path)))
    if len(cells) < 2:
        raise FormatError(f"{path} has no rows", "It needs a header and a row a picture")
    header = [name.lower() for name in cells[0]]
    if "file" not in header or len(set(header)) != len(header):
        raise FormatError(
            f"{path} has the columns {', '.join(header)[:200]}", "It needs the column file, and each once"
        )
    _check_columns(path, header)
    rows = []
    for number, row in enumerate(cells[1:], 2):
        where = f"{path}, row {number}"
        if len(row) != len(header):
            raise FormatError(f"{where} has {len(row)} cells; the header has {len(header)}", "Rows match the header")
        entry = dict(zip(header, row, strict=True))
        rows.append(_row(entry, where, folder))
    return rows


def _check_columns(path: Path, header: list[str]) -> None:
    """Refuse a column that is not known, which may be a misspelt exposure, and what is said in two ways."""
    known = [*OTHERS, *(name for ways in WAYS.values() for way in ways for name in way)]
    for name in header:
        if name not in known and not name.startswith(LEFT_OUT):
            close = difflib.get_close_matches(name, known, n=3, cutoff=0.0)
            raise FormatError(
                f"{path} has the column {name[:80]!r}, which is not known; the nearest are {', '.join(close)}",
                f"Rename it; a column whose name begins with {LEFT_OUT} is left out",
            )
    for what, ways in WAYS.items():
        used = [way for way in ways if any(name in header for name in way)]
        if len(used) > 1:
            both = " and ".join(next(name for name in way if name in header) for way in used)
            raise FormatError(
                f"{path} says {what} twice, in {both}", f"Keep one; a column that begins with {LEFT_OUT} is left out"
            )


def _row(entry: dict[str, str], where: str, folder: Path) -> Row:
    file = folder / entry["file"]
    if file.suffix.lower() not in SUFFIXES:
        raise FormatError(
            f"{where}: {entry['file'][:80]!r} is not a picture that is read", f"{', '.join(SUFFIXES)} are"
        )
    if not file.resolve().is_relative_to(folder.resolve()):
        raise FormatError(f"{where}: {entry['file'][:80]!r} is outside the folder", "Pictures stand in the folder")
    if not file.is_file():
        raise FormatError(f"{where}: {file} does not exist", "Check the column file")

    def number(name: str, default: float | None = None) -> float:
        if not entry.get(name):
            if default is None:
                raise FormatError(f"{where}: {name} is missing", "Fill it in")
            return default
        value = float(reading.numbers([entry[name]], f"{where}, {name}")[0])
        if not np.isfinite(value):
            raise FormatError(f"{where}: {name} = {entry[name][:40]} is not finite", "Fill it in")
        return value

    wi = _direction(entry, where, number, "wi", "i")
    wo = _direction(entry, where, number, "wo", "r")
    hours = 0.0
    for name in [n for n in TIMES if n in entry]:
        hours = number(name) * TIMES[name]
    gains = [number(name, 1.0) for name in ("exposure", "irradiance")]
    if min(gains) < 1 / LARGEST_GAIN or max(gains) > LARGEST_GAIN:
        raise DataError(
            f"{where}: exposure {gains[0]:g}, irradiance {gains[1]:g}",
            f"Both are above 0, from {1 / LARGEST_GAIN:g} to {LARGEST_GAIN:g}",
        )
    if not directions.above(wi, wo):
        raise DataError(
            f"{where}: the {'light' if not directions.above(wi) else 'viewer'} is at or below the horizon",
            "Leave it out",
        )
    return Row(file, wi, wo, hours, gains[0] * gains[1] * float(wi[2]))


def _direction(entry: dict[str, str], where: str, number: Any, name: str, suffix: str) -> Floats:
    """A unit vector out of components or angles; straight up where neither is given, which only a viewer may be."""
    if f"{name}_x" in entry:
        vector = np.array([number(f"{name}_{axis}") for axis in "xyz"])
        found = directions.unit(vector)
        if found is None:
            raise DataError(f"{where}: {name} is (0, 0, 0)", "It points away from the surface")
        return found
    angles = []
    for angle in ("theta", "phi"):
        if f"{angle}_{suffix}_deg" in entry:
            angles.append(np.radians(number(f"{angle}_{suffix}_deg")))
        elif f"{angle}_{suffix}" in entry:
            angles.append(number(f"{angle}_{suffix}"))
        elif name == "wo" and not angles:
            return np.array([0.0, 0.0, 1.0])
        else:
            raise FormatError(
                f"{where}: the direction to the {'light' if name == 'wi' else 'viewer'} is not known: no {angle}_{suffix}",
                f"Columns theta_{suffix}_deg and phi_{suffix}_deg, or {name}_x, {name}_y, {name}_z",
            )
    if abs(angles[0]) > np.pi / 2:
        raise DataError(
            f"{where}: theta_{suffix} = {angles[0]:.4g} rad is outside [-1.571, 1.571]",
            f"Angles are in radians; name the column theta_{suffix}_deg for degrees",
        )
    return np.asarray(directions.from_spherical(*angles), float)
