"""Time stamps out of text whose layout is not known: dates, clock times or seconds, as many as there are scans."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from datetime import datetime
from fractions import Fraction
from itertools import pairwise

LONGEST = 2**20  # characters that are looked at

_CLOCK = r"(\d{1,2}):(\d{2})(?::(\d{2}(?:\.\d{1,9})?))?"
_YEAR_FIRST = re.compile(rf"(?<!\d)(\d{{4}})[-/.](\d{{1,2}})[-/.](\d{{1,2}})[ T,_]+{_CLOCK}")
_YEAR_LAST = re.compile(rf"(?<!\d)(\d{{1,2}})[-/.](\d{{1,2}})[-/.](\d{{4}})[ T,_]+{_CLOCK}")
_MONTHS = ("jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec")
_ASCTIME = re.compile(
    rf"({'|'.join(_MONTHS)})[a-z]{{0,6}}\.? +(\d{{1,2}}),? +{_CLOCK}(?: +[A-Z]{{2,5}})? +(\d{{4}})", re.IGNORECASE
)
_BARE_CLOCK = re.compile(rf"(?<![\d:.]){_CLOCK}(?![\d:])")
_NUMBER = r"([-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d{1,3})?|[-+]?\.\d+)"
_UNIT = r" ?(s|secs?|seconds?|m|mins?|minutes?|h|hrs?|hours?|d|days?)?\b\.?"
# for lines with single spaces only, so that the optional parts cannot backtrack over long runs of them
_SCAN_LINE = re.compile(
    rf"^(?:scan|time|t|frame|#)? ?_?#? ?\d+ ?[:=,; ] ?(?:at|time)? ?[:=]? ?{_NUMBER}{_UNIT}$", re.IGNORECASE
)
_BARE_LINE = re.compile(rf"^{_NUMBER}{_UNIT}$", re.IGNORECASE)
_HEADING_UNIT = re.compile(r"[\[(] ?(s|secs?|seconds?|mins?|minutes?|h|hours?|d|days?) ?[\])]", re.IGNORECASE)
_HOURS = {"s": 1 / 3600, "m": 1 / 60, "h": 1.0, "d": 24.0}


def hours(text: str, n_scans: int) -> list[float] | None:
    """Hours since the first scan of `n_scans` time stamps, or None where the text does not hold as many in increasing
    order.

    Tried in this order, each only when it finds exactly `n_scans`: dates with clock times (year first as in ISO 8601,
    month/day/year, or C's asctime), clock times alone (passing midnight adds a day), lines ``scan 3: 72.5 s``, numbers
    after a line "Time stamps" (seconds where no unit is given).
    """
    text = text[:LONGEST]
    lines = [" ".join(line.split()) for line in text.splitlines()]
    attempts: list[Callable[[], Iterable[float | Fraction]]] = [
        lambda: [_date(m.group(1, 2, 3), m.group(4, 5, 6)) for m in _YEAR_FIRST.finditer(text)],
        lambda: [_american(m.group(1, 2, 3), m.group(4, 5, 6)) for m in _YEAR_LAST.finditer(text)],
        lambda: [
            _date((m[6], str(1 + _MONTHS.index(m[1].lower())), m[2]), m.group(3, 4, 5)) for m in _ASCTIME.finditer(text)
        ],
        lambda: _past_midnight([_clock(m.groups()) for m in _BARE_CLOCK.finditer(text)]),
        lambda: [_seconds(m) for line in lines if (m := _SCAN_LINE.match(line))],
        lambda: _after_heading(lines),
    ]
    for attempt in attempts:
        try:
            found = list(attempt())
        except (ValueError, OverflowError):  # the 31st of February, 1e999 days
            continue
        times = [float(t - found[0]) for t in found]
        if len(times) == n_scans and all(b > a for a, b in pairwise(times)):
            return times
    return None


def _clock(parts: tuple[str | None, ...]) -> float:
    hour, minute, second = (float(p or 0) for p in parts)
    if hour > 24 or minute >= 60 or second >= 62:
        raise ValueError("not a clock time")
    return hour + minute / 60 + second / 3600


def _date(date: tuple[str, ...], clock: tuple[str | None, ...]) -> Fraction:
    """Hours, exact: in a float, two thousand years leave microseconds only."""
    year, month, day = (int(d) for d in date)
    return 24 * datetime(year, month, day).toordinal() + Fraction(_clock(clock))


def _american(date: tuple[str, ...], clock: tuple[str | None, ...]) -> Fraction:
    first, second, year = date
    month, day = (first, second) if int(first) <= 12 else (second, first)
    return _date((year, month, day), clock)


def _past_midnight(times: list[float]) -> list[float]:
    shift = 0.0
    result: list[float] = []
    for i, time in enumerate(times):
        if i and time < times[i - 1]:
            shift += 24
        result.append(time + shift)
    return result


def _seconds(match: re.Match[str]) -> float:
    return float(match[1]) * _HOURS[(match[2] or "s")[0].lower()]


def _after_heading(lines: list[str]) -> list[float]:
    """Numbers on the line that names time stamps, or alone on the lines below it."""
    for i, line in enumerate(lines):
        label, separator, rest = line.replace("=", ":", 1).partition(":")
        if not separator or not re.search("time|stamp", label, re.IGNORECASE):
            continue
        unit = _HEADING_UNIT.search(label)
        factor = _HOURS[unit[1][0].lower()] if unit else _HOURS["s"]
        found = [float(x) for x in re.findall(rf"(?<![\w.]){_NUMBER}(?![\w.])", rest)]
        for k in range(i + 1, len(lines)):
            match = _BARE_LINE.match(lines[k])
            if match is None:
                break
            found.append(float(match[1]))
        if found:
            return [x * factor for x in found]
    return []
