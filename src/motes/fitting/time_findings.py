"""What the data of several times do not show, in sentences."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from motes.directions import above
from motes.fitting.metrics import rms
from motes.fitting.time_result import ScanOutlier, TrendFit
from motes.fitting.verdicts import Verdict
from motes.material import Material
from motes.measurements import Measurement
from motes.models import Lambert, layer_of
from motes.parameters import Role

HIDDEN = 0.01  # share of the light below which what lies under the dust is not seen


def findings(
    results: dict[str, TrendFit],
    outliers: tuple[ScanOutlier, ...],
    scans: int,
    data: Measurement,
    material: Material,
) -> tuple[str, ...]:
    """Sentences on what the data do not show; what can't be known by them is marked in `results`."""
    found = []
    missing = data.n_times - scans
    if missing:
        found.append(f"{missing} of {data.n_times} scans {'has' if missing == 1 else 'have'} no usable sample.")
    for outlier in outliers:
        found.append(f"Scan {outlier.index} at {outlier.hours:.3g} h was left out: {outlier.reason}.")
    if scans - len(outliers) < 4:
        found.append(
            f"With {scans - len(outliers)} scans the shape of a trend is a guess: they tell only whether it changes."
        )

    def mark(names: list[str]) -> None:
        for name in names:
            results[name] = replace(results[name], verdict=Verdict.UNIDENTIFIABLE)

    hours = np.asarray(data.times, float)
    brdf, told = material.brdf, set()
    layer = layer_of(brdf)
    if layer is not None and _share_below(material, data) < HIDDEN:
        told = {s.name for s in (*layer.below, layer.depth) if s.name in results}
        mark(sorted(told))
        found.append(
            f"The dust hides the surface at all times, or the surface is black: it adds less than {100 * HIDDEN:g} % of the light, and the data do not "
            f"determine {', '.join(n for n in results if n in told)}."
        )
    for strength in brdf.slots(Role.HIGHLIGHT_STRENGTH):
        name, own = strength.name, brdf.beside(strength, Role.HIGHLIGHT_WIDTH)
        if name not in results or name in told or own is None:
            continue
        value, error = results[name].band(hours)
        width = own.name
        if (value <= 3 * error).all() or results[name].verdict == Verdict.AT_LOWER:
            told.add(width)
            if width in results:
                mark([width])
            found.append(
                f"No highlight is seen: {name} is 0 within its errors at all times, and its width {width} means nothing."
            )
    for name, t in results.items():
        if t.verdict == Verdict.UNIDENTIFIABLE and name not in told:
            found.append(f"The data do not determine {name} ({t.doc}).")
    return tuple(found)


def _share_below(material: Material, data: Measurement) -> float:
    """The largest share, over the scans, of the light that comes from below the dust (root mean squares over the directions)."""
    up = above(data.wi, data.wo)
    wi, wo = data.wi[up], data.wo[up]
    largest = 0.0
    for hour in data.times:
        layer = layer_of(material.at(float(hour)))
        assert layer is not None
        whole = layer.whole.eval(wi, wo)
        below = whole - layer.over(Lambert(K_d=0.0)).eval(wi, wo)  # over black nothing but the layer itself is seen
        largest = max(largest, rms(below) / max(rms(whole), 1e-300))
    return largest
