"""The times of the rows of a table, as hours."""

from __future__ import annotations

import re
from datetime import datetime

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError
from motes.measurements import _cells, _roles
from motes.measurements import _column_names as names
from motes.measurements._cell_numbers import Numbers

_DURATION = re.compile(r"(-?)(\d{1,6}):(\d{2})(?::(\d{2}(?:\.\d+)?))?")


def hours_of(table: _cells.Cells, where: str, roles: _roles.Roles) -> tuple[NDArray[np.float64], str]:
    """Hours (N,) and the unit: ``"h"``, or ``"scan"`` where a column numbers the scans.

    Numbers in the unit of the column, dates as ISO 8601 writes them (hours from the earliest), or durations ``1:30`` and
    ``1:30:00``.
    """
    role = next((r for r in ("time", "scan") if r in roles.single), None)
    if role is None:
        return np.zeros(len(table.rows)), "h"
    at = roles.single[role]
    column = roles.columns[at]
    assert column is not None
    stamps = _stamps(table, where, at) if role == "time" else None
    if stamps is not None:
        roles.units[at] = "h, from dates or durations"
        return stamps, "h"
    values, in_cells = Numbers(table, where, [at]).column(at)
    bad = ~np.isfinite(values[:, 0])
    if bad.any():
        raise FormatError(
            f"{where}, line {table.lines[int(np.argmax(bad))]}: {table.header[at]} is missing or not finite",
            "Fill it in",
        )
    if role == "scan":
        return values[:, 0], "scan"
    unit = names.unit_of(in_cells, "time") if in_cells else ""
    if unit is None or (unit and column.unit and unit != column.unit):
        raise FormatError(
            f"{where}: the cells of {table.header[at]!r} are in {in_cells!r}"
            + (f", its name says {column.unit}" if column.unit else ""),
            "Correct one of them",
        )
    roles.units[at] = column.unit or unit or "h"
    factor = names.FACTORS[roles.units[at]]
    # 1/60 h is not 60/3600 h in floating point, and scans of one time must have one number
    return np.asarray(values[:, 0] * factor, np.float64), "h"


def _stamps(table: _cells.Cells, where: str, at: int) -> NDArray[np.float64] | None:
    """Dates or durations as hours; None where the cells are plain numbers."""
    cells = [row[at].strip() for row in table.rows]
    first = next((c for c in cells if c), "")
    if not re.search(r"\d[:/-]\d|\d\.\d+\.\d", first):
        return None
    matches = [_DURATION.fullmatch(c) for c in cells]
    if all(matches):
        found = [(-1 if m[1] else 1) * (int(m[2]) + int(m[3]) / 60 + float(m[4] or 0) / 3600) for m in matches if m]
        return np.array(found)
    dates = []
    for line, cell in zip(table.lines, cells, strict=True):
        try:
            dates.append(datetime.fromisoformat(cell))
        except ValueError:
            raise FormatError(
                f"{where}, line {line}: {cell[:40]!r} is no time",
                "Write dates as 2024-05-01 10:30, durations as 1:30:00, or numbers of hours",
            ) from None
    if len({d.tzinfo is None for d in dates}) > 1:
        raise FormatError(
            f"{where}: some times in {table.header[at]!r} have a time zone and some none", "Write all in one way"
        )
    earliest = min(dates)
    return np.array([(d - earliest).total_seconds() / 3600 for d in dates])
