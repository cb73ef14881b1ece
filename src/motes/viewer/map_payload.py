"""What the page of a fitted map gets to show: at every texel, or every n-th, values, standard errors and verdicts over time."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.drawing.colour import channels_to_srgb, sequential
from motes.errors import DataError
from motes.maps.fitted import FittedMap
from motes.maps.layout import FLAGS, VERDICT_FLAGS, Variable, worst
from motes.measurements.origin import not_measured
from motes.report.map_page import BLANK, STATUS_COLORS, VERDICT_COLORS
from motes.version import __version__
from motes.viewer.contract import VERSION, LayerView, MapPayload
from motes.viewer.packing import packed

#: Numbers that a page holds, of all maps together: 4 bytes each, in base64 a third more.
MOST_NUMBERS = 1_500_000

Where = tuple[slice, slice]
Floats = NDArray[np.floating]
GREY = f"rgb{BLANK}".replace(" ", "")


def map_payload(fitted: FittedMap, notes: tuple[str, ...] = ()) -> MapPayload:
    """Everything the page of a map needs, as plain JSON values.

    Parameters
    ----------
    fitted
        From `motes.maps.fit_map`; it may be unfinished.
    notes
        Sentences to show.

    Raises
    ------
    DataError
        When so many channels and times were fitted that a page cannot hold even a coarse map.
    """
    step = _step(fitted)
    where = (slice(None, None, step), slice(None, None, step))
    rows, columns = (len(range(0, n, step)) for n in fitted.shape)
    said = [not_measured({"source": fitted.origin})]
    done = fitted.done()
    if not done.all():
        said.append(f"Only {int(done.sum())} of {done.size} blocks are fitted; what is missing is grey.")
    if step > 1:
        size = f"{fitted.shape[1]:,} x {fitted.shape[0]:,} texels"
        said.append(f"The map has {size}; the page holds every {step}th of a row and of a column, {columns} x {rows}.")
    color = channels_to_srgb(fitted.channels)
    return {
        "format": "motes map",
        "version": VERSION,
        "motes": __version__,
        "name": fitted.name,
        "model": fitted.model,
        "shape": (rows, columns),
        "step": step,
        "hours": fitted.hours.tolist(),
        "channels": list(fitted.channels),
        "to_srgb": color.matrix.tolist(),
        "color": color.meaning,
        "ramp": packed(sequential(np.linspace(0, 1, 256)), "u1"),
        "verdicts": {name: (code, _css(VERDICT_COLORS.get(name))) for name, code in VERDICT_FLAGS.items()},
        "statuses": {name: (code, _css(STATUS_COLORS.get(name))) for name, code in FLAGS.items()},
        "status": packed(fitted.read_map("status", where), "u1"),
        "residual": _layer("relative residual", "residual over data", "", fitted.read_map("relative_rms", where)),
        "layers": list(_layers(fitted, where)),
        "notes": [text for text in (*said, *notes) if text],
    }


def _step(fitted: FittedMap) -> int:
    """Which n-th texels a page has room for."""
    times = 1 if fitted.joint else len(fitted.hours)
    each = sum((len(fitted.channels) if v.per_channel else 1) * times for v in fitted.variables.values())
    if fitted.joint:  # and what they give at each time
        each += len(fitted.quantities) * len(fitted.hours) * len(fitted.channels)
    numbers = 2 * each + times
    step = 1
    while np.prod([-(-n // step) for n in fitted.shape]) * numbers > MOST_NUMBERS and step < max(fitted.shape):
        step += 1
    if numbers > MOST_NUMBERS:
        raise DataError(
            f"a texel of {fitted.path} has {numbers:,} numbers, more than the {MOST_NUMBERS:,} that a page holds",
            "Fit fewer channels or times",
        )
    return step


def _layers(fitted: FittedMap, where: Where) -> Iterator[LayerView]:
    """The parameters; with trends first what they are at every time, then the coefficients with their errors."""
    slots = {slot.name: slot.parameter for slot in fitted.brdf.slots()}
    if fitted.joint:
        for quantity in fitted.quantities:
            p = slots[quantity]
            verdicts = fitted.verdicts(quantity, where) if fitted.version > 1 else None
            yield _layer(quantity, p.doc, p.unit, fitted.values(quantity, where), verdicts=verdicts)
    for v in fitted.variables.values():
        yield _variable(fitted, v, where)


def _variable(fitted: FittedMap, v: Variable, where: Where) -> LayerView:
    values, errors = (np.asarray(fitted.read_map(name, where), np.float64) for name in (v.name, f"{v.name}_stderr"))
    verdicts = None
    if fitted.version > 1:
        codes = fitted.verdicts(v.name, where)
        verdicts = worst(codes) if v.per_channel else codes
    return _layer(v.name, v.doc, v.unit, _timed(values, fitted), _timed(errors, fitted), verdicts)


def _timed(values: Floats, fitted: FittedMap) -> Floats:
    """With an axis of time, of length 1 where the values have none."""
    return values[:, :, None] if fitted.joint else values


def _layer(
    name: str,
    doc: str,
    unit: str,
    values: Floats,
    errors: Floats | None = None,
    verdicts: NDArray[np.uint8] | None = None,
) -> LayerView:
    """A map (y, x[, T][, C]) as the page takes it."""
    full = values if values.ndim > 2 else values[:, :, None]
    full = full if full.ndim == 4 else full[..., None]
    return {
        "name": name,
        "doc": doc,
        "unit": unit,
        "times": full.shape[2],
        "channels": full.shape[3],
        "values": packed(full, "<f4"),
        "stderr": None if errors is None else packed(errors, "<f4"),
        "verdicts": None if verdicts is None else packed(verdicts, "u1"),
        "span": _span(full),
        "error_span": None if errors is None else _span(errors),
    }


def _span(values: Any) -> tuple[float, float]:
    """The ends of a colour scale: all but the outermost hundredths."""
    finite = values[np.isfinite(values)]
    low, high = (float(q) for q in np.quantile(finite, (0.01, 0.99))) if finite.size else (0.0, 1.0)
    if high - low < 1e-9 + 1e-6 * abs(high):
        low, high = low - 0.5 * (abs(low) or 1), high + 0.5 * (abs(high) or 1)
    return low, high


def _css(color: tuple[int, int, int] | None) -> str:
    return GREY if color is None else f"rgb({color[0]},{color[1]},{color[2]})"
