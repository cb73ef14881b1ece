"""What a store must hold to be a reflectance map, and how its coordinates are read."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import DataError, FormatError
from motes.maps import zarrs
from motes.maps.zarrs import AXES, NAME
from motes.measurements import policy

Floats = NDArray[np.float64]

# What one is in hours, by the units that a time may have; those after "since" count from the first.
UNITS = {
    **dict.fromkeys(("h", "hour", "hours", "hr", ""), 1.0),
    **dict.fromkeys(("s", "second", "seconds"), 1 / 3600),
    **dict.fromkeys(("min", "minute", "minutes"), 1 / 60),
    **dict.fromkeys(("d", "day", "days"), 24.0),
    **dict.fromkeys(("ms", "milliseconds"), 1 / 3.6e6),
    "microseconds": 1 / 3.6e9,
    "nanoseconds": 1 / 3.6e12,
}


def reflectance(members: Mapping[str, Any], folder: Path) -> Any:
    """The array of values, by its name or by its five axes."""
    found = {name: zarrs.dimensions(a) for name, a in members.items()}
    five = [name for name, dims in found.items() if len(dims) == len(AXES)]
    name = NAME if NAME in found else five[0] if len(five) == 1 else None
    expected = f"A map has the axes ({', '.join(AXES)}), named in dimension_names"
    if name is None:
        listed = ", ".join(f"{n} ({', '.join(d)})" for n, d in list(found.items())[:6]) or "nothing"
        raise FormatError(f"{folder} has no array {NAME}; it holds {listed}", expected)
    if found[name] != AXES:
        hint = (
            "Bring them into order: " + zarrs.rewritten(folder, f".transpose({', '.join(map(json.dumps, AXES))}, ...)")
            if sorted(found[name]) == sorted(AXES)
            else expected
        )
        raise FormatError(f"{folder}: {name} has the axes ({', '.join(found[name])})", hint)
    array = members[name]
    if array.dtype.kind not in "fiu":
        raise FormatError(f"{folder}: {name} holds {array.dtype}, not numbers", "Write float32")
    if 0 in array.shape:
        raise FormatError(f"{folder}: {name} has shape {array.shape}: nothing is in it", "Every axis has at least one")
    return array


def vectors(members: Mapping[str, Any], name: str, count: int, folder: Path) -> Floats:
    if name not in members:
        raise FormatError(
            f"{folder} has no array {name}: the direction to the {'light' if name == 'wi' else 'viewer'} is not known",
            f"Add the coordinate {name} (direction, xyz), unit vectors away from the surface",
        )
    vectors = zarrs.numbers(members[name], folder)
    if vectors.shape != (count, 3):
        raise FormatError(
            f"{folder}: {name} has shape {vectors.shape}, not ({count}, 3)", "One unit vector a direction"
        )
    return policy.unit_directions(vectors, f"{folder}: {name}")


def hours_of(array: Any, count: int, folder: Path) -> Floats:
    if array is None:
        if count == 1:
            return np.zeros(1)
        raise FormatError(f"{folder} has {count} times and no coordinate time", "Add time (time,), with units h")
    units, _, since = str(array.attrs.get("units", "h")).partition(" since ")
    if units.strip() not in UNITS:
        raise FormatError(
            f"{folder}: time has the units {units[:40]!r}", f"Known are {', '.join(u for u in UNITS if u)}"
        )
    values = zarrs.numbers(array, folder)
    if values.shape != (count,):
        raise FormatError(
            f"{folder}: time has shape {values.shape}, and the values have {count:,} times", "One number a time"
        )
    if since and len(values):
        values = values - values[0]
    return values * UNITS[units.strip()]


def forward(hours: Floats, where: object) -> Floats:
    """The times [h]; raises `DataError` unless they increase."""
    if hours.ndim != 1 or not len(hours) or not np.isfinite(hours).all() or (np.diff(hours) <= 0).any():
        shown = np.array2string(hours, threshold=8)
        raise DataError(f"{where}: the times {shown} do not increase", "Give one time [h] a scan, in order")
    return hours


def check(wi: Floats, wo: Floats, hours: Floats, channels: int, where: object) -> None:
    if len(wi) != len(wo):
        raise DataError(f"{where}: {len(wi)} directions wi and {len(wo)} wo", "They come in pairs")
    forward(hours, where)
