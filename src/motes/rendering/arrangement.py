"""Which panel stands where, and what is written over it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.rendering import panels
from motes.rendering.stage import Stage

Floats = NDArray[np.floating[Any]]
Bytes = NDArray[np.uint8]


class Cell(NamedTuple):
    """A panel: who draws it, when, and its title."""

    stage: Stage
    hours: float
    title: str


def layout(
    stages: Sequence[Stage], names: Sequence[str], times: Sequence[float], film: bool
) -> list[list[Cell | None]]:
    """Rows of panels: materials x times where there are several of both, else whatever there is, in rows of a good length."""
    span = (min(times), max(times))
    if not film and len(times) > 1 and len(stages) > 1:
        return [[Cell(s, t, words(t, span)) for t in times] for s in stages]
    if film or len(times) == 1:
        cells = [Cell(s, times[0], name) for s, name in zip(stages, names, strict=True)]
    else:
        cells = [Cell(stages[0], t, words(t, span)) for t in times]
    columns = len(cells) if film else panels.columns_for(len(cells))
    padded: list[Cell | None] = [*cells, *[None] * (-len(cells) % columns)]
    return [padded[k : k + columns] for k in range(0, len(padded), columns)]


def each_titled(
    grid: Sequence[Sequence[NDArray[np.uint8] | None]], table: Sequence[Sequence[Cell | None]]
) -> NDArray[np.uint8]:
    """Rows with titles of their own, one above the other."""
    rows = [
        panels.sheet([row], columns=[cell.title if cell else "" for cell in cells])
        for row, cells in zip(grid, table, strict=True)
    ]
    return np.concatenate(rows)


def mosaic(grid: Sequence[Sequence[Floats | None]]) -> Floats:
    """Panels of radiance (H, W, 3) as one; what is missing is black."""
    shape = next(p.shape for row in grid for p in row if p is not None)
    return np.concatenate(
        [np.concatenate([np.zeros(shape, np.float32) if p is None else p for p in row], axis=1) for row in grid]
    )


def words(hours: float, span: tuple[float, float]) -> str:
    """A time in the unit that suits the whole span, with as many digits for all."""
    longest = max(abs(span[0]), abs(span[1]))
    value, unit = (hours / 24, "d") if longest >= 96 else (hours, "h") if longest >= 2 else (hours * 60, "min")
    return f"{value:.1f} {unit}" if value != round(value) else f"{value:.0f} {unit}"
