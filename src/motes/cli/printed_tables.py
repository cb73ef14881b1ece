"""Parameters as a table for a terminal."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, Any

import numpy as np
from rich import box

from motes.cli.console import Table, clean
from motes.cli.console import width as console_width
from motes.models import BRDF

if TYPE_CHECKING:
    from motes.fitting import Fit
    from motes.fitting.time_result import TimeFit
    from motes.material import Material
    from motes.trends import AnyTrend

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


def model_table(brdf: BRDF, leave_out: Collection[str] = ()) -> Table:
    """A row a parameter of a model."""
    table = _table()
    for heading in ("value", "unit", "meaning"):
        table.add_column(heading)
    for slot in (s for s in brdf.slots() if s.name not in leave_out):
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


# ---------------------------------------------------------------- over time


def trend_table(fit: TimeFit, truth: dict[str, Any] | None = None) -> Table:
    """A row a parameter and channel: the kind of trend, the values at the first and the last scan.

    `truth` holds, by name, a dictionary with the true ``kind``, and the values ``first`` and ``last``.
    """
    wide = console_width() >= WIDE
    table = _table()
    table.add_column("channel", no_wrap=True)
    table.add_column("trend", no_wrap=True)
    for heading in ("first", "last"):
        table.add_column(heading, justify="right", no_wrap=True)
    if wide:
        table.add_column("unit")
    if truth and wide:
        table.add_column("true trend", no_wrap=True)
    for heading in ("first", "last") if truth else ():
        table.add_column(f"true {heading}", justify="right", no_wrap=True)
    if wide or not truth:
        table.add_column("verdict")
    for name, rows in _by_name(fit.table()).items():
        t = fit.trends[name]
        if len(rows) > MOST_CHANNELS:
            first, last = (f"{v.min():.4g} .. {v.max():.4g}" for v in t.band(fit.hours[[0, -1]])[0])
            rows = [{**rows[0], "channel": f"all {len(rows)}", "first": first, "last": last}]
        for k, row in enumerate(rows):
            ends = [row["first"], row["last"]]
            if not wide:  # the errors need much room
                ends = [end.partition(" ±")[0] for end in ends]
            cells = [
                clean(row["channel"]),
                _spaced(row["trend"]) if k == 0 else "",
                *ends,
                *([row["unit"]] if wide else []),
            ]
            true = (truth or {}).get(name)
            if truth and wide:
                cells.append(_spaced(true["kind"]) if true and k == 0 else "")
            if truth:
                cells += [f"{np.ravel(true[end])[k]:.4g}" if true else "" for end in ("first", "last")]
            if wide or not truth:
                cells.append(row["verdict"].partition(":")[0] if k == 0 else "")
            table.add_row(name if k == 0 else "", *cells)
    return table


def coefficient_table(fit: TimeFit, truth: dict[str, Any]) -> Table:
    """The times among the coefficients (time constants, middles, widths), beside the true ones where the kind is right."""
    table = _table()
    for heading in ("coefficient", "fitted", "unit", "true"):
        table.add_column(heading, justify="right" if heading in ("fitted", "true") else "left")
    from motes.fitting.formatting import with_error
    from motes.trends import KINDS

    for name, t in fit.trends.items():
        start = 0
        covariance = t.trend.covariance
        for c in KINDS[t.trend.kind].coefficients:
            value = t.trend.coefficients[c.name]
            true = truth.get(name, {})
            if c.is_time:
                same = true.get("kind") == t.trend.kind
                error = 0.0 if covariance is None else float(np.sqrt(covariance[start, start]))
                texts = with_error(float(value), error)
                known = f"{true['coefficients'][c.name]:.4g}" if same else ""
                table.add_row(name, c.name, " ± ".join(x for x in texts if x), fit.measurement.time_unit, known)
            start += np.size(value)
    return table


def trend_notes(fit: TimeFit) -> list[tuple[str, str]]:
    """The findings, and a line for each verdict that they do not speak of."""
    rows = [("finding", text) for text in fit.findings]
    for name, t in fit.trends.items():
        if ":" in t.verdict and not any(f" {name}" in text for text in fit.findings):
            rows.append(("note", f"{name} {t.verdict}"))
    return rows


def material_trends(material: Material) -> Table:
    """A row a parameter that follows time: kind, the values at both ends of the interval, coefficients that are times."""
    table = _table()
    wide = console_width() >= WIDE
    for heading in ("trend", "first", "last", "unit", "times [h]", *(("meaning",) if wide else ())):
        table.add_column(heading)
    slots = {slot.name: slot.parameter for slot in material.brdf.slots()}
    for name, trend in material.trends.items():
        ends = trend(np.asarray(trend.interval))
        separator = ", " if wide else "\n"
        first, last = (_numbers(end, separator) for end in (ends[0], ends[-1]))
        cells = [_spaced(trend.kind), first, last, slots[name].unit, _times(trend)]
        table.add_row(name, *cells, *([slots[name].doc] if wide else []))
    return table


def _times(trend: AnyTrend) -> str:
    """The coefficients of a trend that are times."""
    from motes.trends import KINDS, Tabulated

    if isinstance(trend, Tabulated):
        return f"{len(trend.hours)} of them"
    named = [(c.name, trend.coefficients[c.name]) for c in KINDS[trend.kind].coefficients if c.is_time]
    return "\n".join(f"{_spaced(name)} {value:.4g}" for name, value in named)


def _spaced(kind: str) -> str:
    return kind.replace("_", " ")


def _by_name(rows: list[dict[str, str]]) -> dict[str, list[dict[str, str]]]:
    found: dict[str, list[dict[str, str]]] = {}
    for row in rows:
        found.setdefault(row["name"], []).append(row)
    return found


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
