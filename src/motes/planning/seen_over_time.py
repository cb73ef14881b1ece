"""Planned moments as a picture: how each parameter is believed to go, when it is scanned, and how well it is then known."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.drawing.figure import figure
from motes.drawing.markup import Html
from motes.drawing.svg import Panel, Scale

Floats = NDArray[np.float64]
PLANNED, EVEN, MADE = "--blue", "--muted", "--ink"
SIZE = (360, 230)


class Course(NamedTuple):
    """How a parameter is believed to go: values (C, T) of its channels, one where they share it, and standard errors with the planned and the even scans."""

    name: str
    unit: str
    hours: Floats
    value: Floats
    planned: Floats
    even: Floats


def drawn(courses: Sequence[Course], planned: Floats, even: Floats, made: Floats) -> str:
    """The text of an SVG file: for each parameter its course with the moments of scans [h] on it, and beside it its error at each moment."""
    hours = courses[0].hours
    time = Scale.around(hours, made)
    panels = []
    for course in courses:
        panels += [_going(course, time, planned, even, made), _known(course, time, planned)]
    key = {"planned scans": PLANNED, "as many, evenly spaced": EVEN, **({"scans already made": MADE} if len(made) else {})}  # fmt: skip
    return figure(panels, columns=2, size=SIZE, legend=key)


def _going(course: Course, time: Scale, planned: Floats, even: Floats, made: Floats) -> Html:
    unit = f" [{course.unit}]" if course.unit else ""
    panel = Panel(time, Scale.around(course.value), f"{course.name}{unit}, as believed", "time [h]", "", *SIZE)
    for value in course.value:
        panel.line(course.hours, value, "--ink", "thin")
        for moments, colour, size in ((even, EVEN, 5.0), (made, MADE, 6.0), (planned, PLANNED, 8.0)):
            inside = moments[(moments >= course.hours[0]) & (moments <= course.hours[-1])]
            panel.dots(inside, np.interp(inside, course.hours, value), colour, size)
    first, last = course.value[:, 0].mean(), course.value[:, -1].mean()
    listed = ", ".join(f"{t:.4g}" for t in planned)
    return panel.svg(f"{course.name} goes from {first:.3g} to {last:.3g}; scans are planned at {listed} h")


def _known(course: Course, time: Scale, planned: Floats) -> Html:
    errors = np.concatenate([course.planned, course.even])
    finite = errors[np.isfinite(errors)]
    y = Scale.around(finite, zero=True) if finite.size else Scale(0.0, 1.0)
    left = "" if len(finite) == errors.size else ", where the scans tell" if finite.size else ": not determined"
    panel = Panel(time, y, f"its standard error{left}", "time [h]", "", *SIZE)
    for moment in planned:
        panel.line([moment, moment], [y.low, y.high], PLANNED, "guide")
    for rows, colour, kind in ((course.even, EVEN, "dashed"), (course.planned, PLANNED, "line")):
        for row in rows:
            panel.line(course.hours, np.where(np.isfinite(row), row, np.nan), colour, kind)
    words = [
        f"{np.median(rows[np.isfinite(rows)]):.2g}" if np.isfinite(rows).any() else "not determined"
        for rows in (course.planned, course.even)
    ]
    return panel.svg(f"Standard error of {course.name} over time: in the middle {words[0]} as planned, {words[1]} with even scans")  # fmt: skip
