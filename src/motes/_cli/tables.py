"""Parameters as a table for a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from rich import box
from rich.table import Table

from motes._cli.console import clean
from motes.models import BRDF

if TYPE_CHECKING:
    from motes.fitting import Fit

MOST_COLUMNS = 4  # channels that have a column of their own


def parameter_table(fit: Fit, truth: dict[str, Any] | None = None) -> Table:
    """A row a parameter, a column a channel where there are few; with the true values where they are known."""
    rows = fit.table()
    channels = fit.material.channels
    wide = any(row["channel"] for row in rows) and len(channels) <= MOST_COLUMNS
    table = _table()
    for heading in channels if wide else ("value",):
        table.add_column(clean(heading), justify="right", no_wrap=True)
    table.add_column("unit")
    if truth:
        table.add_column("true", justify="right")
    table.add_column("verdict")
    table.add_column("meaning", overflow="fold")
    for name, parameter in fit.parameters.items():
        own = [row for row in rows if row["name"] == name]
        cells = [_value(row) for row in own]
        if len(own) == 1:
            cells += [""] * (len(channels) - 1 if wide else 0)
        elif not wide:
            cells = [_numbers(parameter.value)]
        cells.append(parameter.unit)
        if truth:
            cells.append(_numbers(truth.get(name)))
        cells += [str(parameter.verdict).partition(":")[0], parameter.doc]
        table.add_row(name, *cells)
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


def _numbers(value: Any) -> str:
    if value is None:
        return ""
    values = np.atleast_1d(value)
    if values.size > MOST_COLUMNS:
        return f"{values.min():.4g} .. {values.max():.4g} in {values.size} channels"
    return ", ".join(f"{x:.4g}" for x in values)
