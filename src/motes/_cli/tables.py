"""Parameters as a table for a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from rich import box
from rich.table import Table

from motes._cli.console import clean
from motes._cli.console import width as console_width
from motes.models import BRDF

if TYPE_CHECKING:
    from motes.fitting import Fit

MOST_CHANNELS = 4  # that are listed one by one
WIDE = 130  # columns of a terminal that has room for a column a channel, and for what the parameters mean


def parameter_table(fit: Fit, truth: dict[str, Any] | None = None) -> Table:
    """A row a parameter; few channels are listed one by one, side by side where there is room.

    `truth` holds the true values, where they are known.
    """
    rows = fit.table()
    channels = fit.material.channels
    wide = console_width() >= WIDE
    few = 1 < len(channels) <= MOST_CHANNELS
    table = _table()
    for heading in channels if wide and few else ("value",):
        table.add_column(clean(heading), justify="right", no_wrap=True)
    table.add_column("unit")
    if truth:
        table.add_column("true", justify="right")
    table.add_column("verdict")
    meaning = wide and not truth
    if meaning:
        table.add_column("meaning")
    for name, parameter in fit.parameters.items():
        own = [row for row in rows if row["name"] == name]
        if len(own) == 1:
            cells = [_value(own[0])]
        elif few:
            cells = [_value(row) if wide else f"{clean(row['channel'])} {_value(row)}" for row in own]
        else:
            cells = [_numbers(parameter.value)]
        cells = cells + [""] * (len(channels) - len(cells)) if wide and few else ["\n".join(cells)]
        cells.append(parameter.unit)
        if truth:
            cells.append(_numbers(truth.get(name), ", " if wide else "\n"))
        cells.append(str(parameter.verdict).partition(":")[0])
        table.add_row(name, *cells, *([parameter.doc] if meaning else []))
    return table


def model_table(brdf: BRDF) -> Table:
    """A row a parameter of a model."""
    table = _table()
    for heading in ("value", "unit", "meaning"):
        table.add_column(heading)
    for slot in brdf.slots():
        table.add_row(slot.name, _numbers(slot.value), slot.parameter.unit, slot.parameter.doc)
    return table


def verdict_notes(fit: Fit) -> list[tuple[str, str]]:
    """A line for each kind of verdict that needs explaining, with the parameters it holds for."""
    notes: dict[str, list[str]] = {}
    for name, parameter in fit.parameters.items():
        for k, verdict in enumerate(parameter.verdicts):
            if ":" in verdict:
                notes.setdefault(str(verdict), []).append(
                    f"{name}[{fit.material.channels[k]}]" if len(parameter.verdicts) > 1 else name
                )
    return [
        ("note", f"{', '.join(names[:8])}{', ...' if len(names) > 8 else ''} {text}") for text, names in notes.items()
    ]


def _table() -> Table:
    table = Table(box=box.SIMPLE_HEAD, show_edge=False, pad_edge=False)
    table.add_column("parameter", style="bold", no_wrap=True)
    return table


def _value(row: dict[str, str]) -> str:
    return f"{row['value']} ± {row['stderr']}" if row["stderr"] else row["value"]


def _numbers(value: Any, separator: str = ", ") -> str:
    if value is None:
        return ""
    values = np.atleast_1d(value)
    if values.size > MOST_CHANNELS:
        low, high = f"{values.min():.4g}", f"{values.max():.4g}"
        return f"{low if low == high else f'{low} .. {high}'} in {values.size} channels"
    return separator.join(f"{x:.4g}" for x in values)
