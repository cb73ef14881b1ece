"""Readings of mirrors' reflectance, and those of the package ``mirror-soiling-data``."""

from __future__ import annotations

import datetime
import re
from collections.abc import Sequence
from dataclasses import dataclass
from importlib import resources
from itertools import pairwise
from pathlib import Path
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from motes.errors import DataError, MissingExtraError
from motes.files.spreadsheet import Cell, read_sheets

Floats = NDArray[np.float64]

READINGS = 6  # points on a mirror behind each mean; the package says "6 to 9", and 6 makes the errors too large rather than too small
RESOLUTION = 0.1 / np.sqrt(12)  # per cent; standard deviation of a reading rounded to 0.1
_NAMED_TILT = re.compile(r"T(\d{1,2})$")


@final
@dataclass(frozen=True)
class Series:
    """Readings of one mirror in one campaign.

    Parameters
    ----------
    site, campaign, mirror
        Where, when (the first day, as YYYY-MM-DD), and which.
    tilt_deg
        Of the mirror from the horizontal [degrees].
    days
        Times of the readings (K,) [d], from the first.
    reflectance
        Means over the points on the mirror (K,), 0 to 1.
    stderr
        Their standard errors (K,).
    rained
        Whether rain was recorded between one reading and the next (K - 1,), or None where no rain gauge was.
    start
        Day of the first reading in the spreadsheet's count, which orders campaigns.
    """

    site: str
    campaign: str
    mirror: str
    tilt_deg: float
    days: Floats
    reflectance: Floats
    stderr: Floats
    rained: NDArray[np.bool_] | None = None
    start: float = 0.0

    def __post_init__(self) -> None:
        days, R, se = (np.asarray(x, float) for x in (self.days, self.reflectance, self.stderr))
        if not (days.ndim == 1 and days.shape == R.shape == se.shape) or len(days) < 3:
            raise DataError(
                f"{self.mirror}: {days.shape}, {R.shape} and {se.shape} are not three or more readings with errors",
                "Give as many days, means and errors",
            )
        if not np.isfinite(days).all() or np.any(np.diff(days) <= 0):
            raise DataError(f"{self.mirror}: the times of the readings do not go forward", "Sort them; each time once")
        if not (np.all((R > 0) & (R <= 1)) and np.all(se > 0) and np.isfinite(se).all()):
            raise DataError(
                f"{self.mirror}: a reflectance is outside (0, 1] or has no positive error", "Give shares, not per cent"
            )
        for name, value in (("days", days), ("reflectance", R), ("stderr", se)):
            object.__setattr__(self, name, value)


def read_soiling() -> tuple[Series, ...]:
    """All series of the package ``mirror-soiling-data`` (QUT and HelioCon, MIT licence): mirrors at five Australian sites.

    A series needs three readings.  The spread over a mirror's points, divided by the square root of their number, is the error of a reading.

    Raises
    ------
    MissingExtraError
        Without the package.
    FormatError
        When a spreadsheet is damaged.
    """
    try:
        root = Path(str(resources.files("mirror_soiling_data")))
    except ModuleNotFoundError:
        raise MissingExtraError("mirror-soiling-data", "soiling", "reading the soiling of mirrors") from None
    found: list[Series] = []
    for file in sorted(root.glob("*/*_[0-9]*_[0-9]*.xlsx")):
        found += _campaign(file)
    if not found:
        raise DataError(f"{root} holds no campaigns", "Install mirror-soiling-data again")
    return tuple(found)


def _campaign(file: Path) -> list[Series]:
    sheets = read_sheets(file, ["Tilts", "Weather", "Reflectance_Average", "Reflectance_Sigma"])
    (names, times, means), (others, other_times, spreads) = (
        _columns(sheets[s]) for s in ("Reflectance_Average", "Reflectance_Sigma")
    )
    tilt_names, _, tilts = _columns(sheets["Tilts"])
    weather_names, weather_times, weather = _columns(sheets["Weather"])
    rain = weather[:, weather_names.index("RainIntensity")] if "RainIntensity" in weather_names else None
    site, day = file.parent.name, file.stem.split("_")[-2]
    campaign = f"{day[:4]}-{day[4:6]}-{day[6:]}"
    result = []
    for column, name in enumerate(names):
        if name in tilt_names:
            tilt = float(np.nanmean(tilts[:, tilt_names.index(name)]))
        elif match := _NAMED_TILT.search(name):
            tilt = float(match[1])
        else:
            continue
        if name not in others:
            continue
        spread = np.interp(times, other_times, spreads[:, others.index(name)])
        good = np.isfinite(times) & np.isfinite(means[:, column]) & np.isfinite(spread)
        good &= np.isin(np.round(times, 4), np.round(other_times, 4))
        if good.sum() < 3:
            continue
        t, R = times[good], means[good, column] / 100
        error = np.hypot(spread[good], RESOLUTION) / 100 / np.sqrt(READINGS)
        rained = None
        if rain is not None:
            wet = weather_times[np.nan_to_num(rain) > 0]
            rained = np.array([bool(np.any((wet > a) & (wet <= b))) for a, b in pairwise(t)])
        result.append(Series(site, campaign, name, round(tilt, 1), t - t[0], R, error, rained, float(t[0])))
    return result


def _columns(rows: Sequence[Sequence[Any]]) -> tuple[list[str], Floats, Floats]:
    """Names of the columns after the first, times (R,), values (R, C); what is not a number is NaN, rows without a time are left out."""
    header = [str(c) if c is not None else "" for c in rows[0]] if rows else []
    width = max((k + 1 for k, name in enumerate(header) if name), default=1)
    table = np.full((max(len(rows) - 1, 0), width), np.nan)
    for r, row in enumerate(rows[1:]):
        for c, cell in enumerate(row[:width]):
            table[r, c] = _number(cell)
    table = table[np.isfinite(table[:, 0])]
    return header[1:width], table[:, 0], table[:, 1:]


def _number(cell: Cell) -> float:
    """A number as it is, a date as days in the count of spreadsheets, anything else as NaN."""
    if isinstance(cell, float):
        return cell
    try:
        moment = datetime.datetime.fromisoformat(cell or "")
    except ValueError:
        return np.nan
    if moment.tzinfo is not None:
        return np.nan
    return (moment - datetime.datetime(1899, 12, 30)) / datetime.timedelta(days=1)
