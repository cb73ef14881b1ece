"""Numbers that stand for no reading, and were not said to: 9999, or 0 amid a bright surface."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motes.measurements.measurement import Measurement

Floats = NDArray[np.float64]

FEWEST = 20  # samples of a channel that a statement needs
ZEROS = 3  # of the value 0 that are no accident
GAP = 0.1  # of the median: the least that a reading is, where 0 is none
STEPS = 3.0  # of rounding: the least positive reading is so much, where 0 is no rounded one
FAR, FARTHEST = 30.0, 1000.0  # times the next largest reading: of numbers that programs fill with, and of any
USUAL = frozenset(
    [99.0, 999.0, 9999.0, 99999.0, 999999.0, 99.9, 999.9, 9999.9, 32767.0, 65535.0, 2147483647.0, 1e10, 1e20, 1e30]
)


def fillers(data: Measurement) -> list[str]:
    """Sentences on values that may stand for no reading; at most one a kind."""
    found: list[str] = []
    for said in (_zeros, _far):
        for c in range(data.n_channels):
            values = data.values[..., c].ravel().compress(data.mask[..., c].ravel())
            if len(values) >= FEWEST and (sentence := said(values, data.channels[c], data)):
                found.append(sentence)
                break
    return found


def _zeros(values: Floats, channel: str, data: Measurement) -> str:
    zeros = int(np.count_nonzero(values == 0))
    if zeros < ZEROS or values.min() < 0 or zeros == len(values):
        return ""
    levels = np.unique(values[values > 0])
    if levels[0] <= max(STEPS * _step(levels), GAP * float(np.median(values[values > 0]))):
        return ""
    return (
        f"{zeros} of {len(values)} values of {channel} are exactly 0, and the least of the others is {levels[0]:.3g}: where 0 stands for no "
        f"reading, {_mend('0', data)}"
    )


def _step(levels: Floats) -> float:
    """The power of ten that all levels are multiples of; 0 where there is none to speak of."""
    for power in range(2, -7, -1):
        units = levels / 10.0**power
        if np.all(np.abs(units - np.round(units)) < 1e-6):
            return float(10.0**power)
    return 0.0


def _far(values: Floats, channel: str, data: Measurement) -> str:
    largest = float(values.max())
    others = values.compress(values < largest)
    if len(others) < FEWEST - 1 or largest <= 0:
        return ""
    next_largest = float(others.max())
    count = len(values) - len(others)
    times = largest / next_largest if next_largest > 0 else np.inf
    if times <= (FAR if largest in USUAL else FARTHEST):
        return ""
    what = f"{count} value{'s' if count > 1 else ''} of {channel} {'are' if count > 1 else 'is'} {largest:.6g}"
    return f"{what}, {times:.2g} times the next largest: where that stands for no reading, {_mend(f'{largest:.17g}', data)}"


def _mend(number: str, data: Measurement) -> str:
    """The option, where the numbers of the file are those of the measurement."""
    as_written = data.provenance.get("format") == "csv" and "f_r in 1/sr, as the table says" in data.provenance.get(
        "notes", ()
    )
    if as_written:
        return f"--read missing={number} leaves such values out."
    return "leave such values out."
