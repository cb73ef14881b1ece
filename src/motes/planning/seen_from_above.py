"""A plan as a picture: the hemisphere of the lamp and of the detector from above, and what the pairs are to a surface."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.drawing.figure import figure
from motes.drawing.markup import Html
from motes.drawing.svg import Panel, Scale

Floats = NDArray[np.float64]
Pairs = tuple[Floats, Floats]
FIND, CHECK, EVEN = "--blue", "--vermilion", "--muted"
SIDE = 300
# With more shots than this their numbers would lie over one another.
MOST_NUMBERS = 40
# Degrees within which numbers would.
APART = 24.0


def drawn(planned: Pairs, even: Pairs, checking: NDArray[np.bool_], shot: NDArray[np.intp]) -> str:
    """The text of an SVG file.

    Parameters
    ----------
    planned, even
        ``wi, wo`` (K, 3) of the plan and of the even choice.
    checking
        Which of the planned ones (K,) check the model.
    shot
        Their numbers (K,), from 0.
    """
    panels = [
        _hemisphere("Lamp, from above", planned[0], even[0], checking, shot),
        _hemisphere("Detector, from above", planned[1], even[1], checking, shot),
        _angles(planned, even, checking),
    ]
    key = {"to find the parameters": FIND, "to check the model": CHECK, "even choice": EVEN}
    return figure(panels, columns=3, size=(SIDE, SIDE), legend=key)


def _hemisphere(title: str, planned: Floats, even: Floats, checking: NDArray[np.bool_], shot: NDArray[np.intp]) -> Html:
    """The polar angle as the distance from the middle, the azimuth around it; rings every 30 degrees."""
    scale = Scale(-112.0, 112.0)
    panel = Panel(scale, scale, title, width=SIDE, height=SIDE, axes=False)
    around = np.linspace(0, 2 * np.pi, 121)
    for ring in (30.0, 60.0, 90.0):
        panel.line(ring * np.cos(around), ring * np.sin(around), "--grid", "ring")
        panel.text(0.0, -ring, f"{ring:.0f}°", shift=(0, 12))
    for azimuth in range(0, 360, 90):
        turn = np.radians(azimuth)
        panel.line([0.0, 90 * np.cos(turn)], [0.0, 90 * np.sin(turn)], "--grid", "ring")
    panel.text(90.0, 0.0, "0°", "start", shift=(4, 4))
    panel.text(-90.0, 0.0, "180°", "end", shift=(-2, 4))
    panel.dots(*_flat(even), EVEN, 3.0)
    x, y = _flat(planned)
    for which, colour in ((~checking, FIND), (checking, CHECK)):
        panel.dots(x[which], y[which], colour, 7.0)
    if shot.max() < MOST_NUMBERS:
        written: list[tuple[float, float, list[int]]] = []
        for px, py, number in sorted(zip(x.tolist(), y.tolist(), (shot + 1).tolist(), strict=True)):
            # What stands close together shares a label.
            for at_x, at_y, numbers in written:
                if abs(px - at_x) < APART and abs(py - at_y) < APART:
                    numbers.append(number)
                    break
            else:
                written.append((px, py, [number]))
        for px, py, numbers in written:
            panel.text(px, py, _listed(sorted(set(numbers))), "start", shift=(3, -6))
    return panel.svg(f"{title}: {len(planned)} directions of the plan, {len(even)} of the even choice")


def _listed(numbers: list[int]) -> str:
    """Numbers in order, runs of three and more by their ends: ``1-4 9``."""
    runs: list[list[int]] = []
    for number in numbers:
        if runs and runs[-1][-1] == number - 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    return " ".join(" ".join(map(str, run)) if len(run) < 3 else f"{run[0]}–{run[-1]}" for run in runs)


def _flat(w: Floats) -> tuple[Floats, Floats]:
    theta, phi = np.degrees(directions.theta(w)), directions.phi(w)
    return theta * np.cos(phi), theta * np.sin(phi)


def _angles(planned: Pairs, even: Pairs, checking: NDArray[np.bool_]) -> Html:
    """Half angle against difference angle: a highlight lies on the left, what the surface sends back to the lamp below."""
    panel = Panel(
        Scale(-3, 93, ticks=(0, 30, 60, 90)),
        Scale(-3, 93, ticks=(0, 30, 60, 90)),
        "What the pairs are",
        "half angle θh [°]",
        "difference angle θd [°]",
        width=SIDE,
        height=SIDE,
    )
    for (wi, wo), which, colour, size in (
        (even, slice(None), EVEN, 3.0),
        (planned, ~checking, FIND, 6.0),
        (planned, checking, CHECK, 6.0),
    ):
        theta_h, theta_d, _ = directions.half_difference(wi[which], wo[which])
        panel.dots(np.degrees(theta_h), np.degrees(theta_d), colour, size)
    return panel.svg("Half angle against difference angle of the planned and of the even directions")
