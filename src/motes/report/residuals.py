"""Where a fit and its data differ: measured against fitted, ratios by angle, maps over the hemisphere."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from motes.drawing.colour import Floats, diverging, hex_color, sequential
from motes.drawing.markup import Html, join, tag
from motes.drawing.svg import Panel, Scale
from motes.report.figures import DEGREES, Shown, color_bar, figure, key
from motes.report.slices import MOST_DOTS, Group, Samples, binned, incidence_groups

# Enough samples for every cell of the maps over the hemisphere.
MOST_CELLS = 200_000


def agreement_figure(samples: Samples, channels: Sequence[Shown]) -> Html:
    """Measured against fitted on logarithmic axes; their ratio against both polar angles."""
    some = samples.thinned()
    index = [c.channel for c in channels]
    scale = Scale.around(*_cut(some.measured[:, index], some.fitted[:, index]), log=True)
    scatter = Panel(scale, scale, "Measured against fitted", "fitted f [1/sr]", "measured f [1/sr]")
    dense = len(some) * len(index) > MOST_DOTS
    if dense:
        scatter.picture(_density(some, index, scale), (scale.low, scale.high), (scale.low, scale.high))
    scatter.line([scale.low, scale.high], [scale.low, scale.high], "--ink", "guide")
    if not dense:
        for c in channels:
            scatter.dots(
                some.fitted[:, c.channel], some.measured[:, c.channel], c.color, 3.5 if len(some) < 500 else 2.4
            )
    ratio = some.ratio[:, index]
    finite = ratio[np.isfinite(ratio)]
    low, high = np.percentile(finite, (3, 97)) if finite.size else (0.5, 2.0)
    ratio_scale = Scale.ratios(max(float(low), 0.04), min(float(high), 25))
    panels = [scatter.svg("Measured against fitted BRDF, logarithmic axes, with the line of equality")]
    for theta, label, words in ((some.theta_i, "θᵢ [°]", "incidence"), (some.theta_r, "θᵣ [°]", "reflection")):
        panel = Panel(
            Scale(0, 90, ticks=DEGREES), ratio_scale, f"Ratio against angle of {words}", label, "measured / fitted"
        )
        panel.line([0, 90], [1, 1], "--ink", "guide")
        for k, c in enumerate(channels):
            middle, quantiles = binned(np.degrees(theta), ratio[:, k], np.linspace(0, 90, 13))
            filled = np.isfinite(quantiles[1])
            panel.band(middle[filled], quantiles[0, filled], quantiles[2, filled], c.color)
            panel.line(middle[filled], quantiles[1, filled], c.color)
            panel.dots(middle[filled], quantiles[1, filled], c.color, 4.5)
        panels.append(
            panel.svg(f"Median ratio of measured to fitted BRDF against angle of {words}, with the middle 68 %")
        )
    thinned = (
        f" Drawn from {len(some):,} of {len(samples):,} directions, chosen evenly at random (seed 0)."
        if len(some) < len(samples)
        else ""
    )
    gaps = int(np.isfinite(some.measured[:, index]).sum() - finite.size)
    missing = (
        f" {gaps:,} values that are 0 or less, measured or fitted, have no place on a logarithmic axis." if gaps else ""
    )
    caption = (
        "On the line of equality the fit is exact. "
        + ("Brighter cells hold more samples. " if dense else "")
        + "Ratios: median and middle 68 % in steps of 7.5°; above 1 the surface is brighter than the fit."
        + thinned
        + missing
    )
    entries = [("line", c.color, c.name if len(channels) > 1 else "median") for c in channels]
    return figure(
        panels, caption, key([*entries, ("bar", channels[0].color if len(channels) == 1 else "--muted", "middle 68 %")])
    )


def _cut(*arrays: Floats) -> list[Floats]:
    """Values without the far lower tail, which would take most of a logarithmic axis."""
    everything = np.concatenate([a.ravel() for a in arrays])
    positive = everything[np.isfinite(everything) & (everything > 0)]
    if not positive.size:
        return [everything]
    low, high = np.percentile(positive, 1), positive.max()
    return [np.array([max(low, high * 1e-6), high])]


def _density(samples: Samples, index: Sequence[int], scale: Scale) -> NDArray[np.uint8]:
    """Counts of (fitted, measured) on a grid, coloured by their logarithm; empty cells are transparent."""
    n = 110
    x, y = scale(samples.fitted[:, index]).ravel(), scale(samples.measured[:, index]).ravel()
    inside = (x >= 0) & (x < 1) & (y >= 0) & (y < 1)
    cells = (n - 1 - (y[inside] * n).astype(int)) * n + (x[inside] * n).astype(int)
    counts = np.bincount(cells, minlength=n * n).reshape(n, n)
    shade = np.log1p(counts) / max(np.log1p(counts.max()), 1e-9)
    return np.concatenate([sequential(shade), np.where(counts > 0, 255, 0).astype(np.uint8)[..., None]], -1)


def _drawn(samples: Samples) -> Samples:
    """Those that a figure shows: few enough, with a measured and a fitted value."""
    samples = samples.thinned(MOST_CELLS)
    return samples.take(np.flatnonzero(np.isfinite(samples.measured + samples.fitted).any(1)))


def _difference(samples: Samples) -> Floats:
    """Fitted less measured (N,), the mean over channels, as a share of RMS(measured)."""
    usable = np.isfinite(samples.measured) & np.isfinite(samples.fitted)
    rms = float(np.sqrt(np.mean(samples.measured[usable] ** 2))) or 1.0
    mean = np.nansum(np.where(usable, samples.fitted - samples.measured, 0), axis=1) / np.maximum(usable.sum(1), 1)
    return np.asarray(mean / rms)


def _end(value: Floats) -> float:
    """The end of a scale that holds nearly all values."""
    return float(f"{np.percentile(np.abs(value), 98) or 1.0:.1g}")


def shared_end(several: Sequence[Samples]) -> float | None:
    """The end of one scale of differences for several fits beside each other: of the worst, but no more than five times that of the best, which would
    be blank."""
    ends = [_end(_difference(drawn)) for samples in several if len(drawn := _drawn(samples))]
    return min(max(ends), 5 * min(ends)) if ends else None


def residual_figure(samples: Samples, end: float | None = None) -> Html:
    """Where over the hemisphere the fit is too bright (red) or too dark (blue), one disc for each angle of incidence.

    Differences as a share of RMS(measured), up to `end` where that is given; where the measurement spans decades, in which case the highlight takes that
    scale for itself, ratios too.
    """
    samples = _drawn(samples)
    if not len(samples):
        return tag(
            "p", "No sample has both a measured and a fitted value: there is no residual to draw.", class_="note"
        )
    usable = np.isfinite(samples.measured) & np.isfinite(samples.fitted)
    positive = samples.measured[usable & (samples.measured > 0)]
    difference = _difference(samples)
    maps = [_discs(samples, difference, "difference", end or _end(difference))]
    if positive.size and np.percentile(positive, 99) > 30 * np.median(positive):
        low, high = np.percentile(positive, 0.5), positive.max()
        sums = [
            np.nansum(np.clip(a, low, high), 1) for a in (samples.fitted, samples.measured)
        ]  # a floor, so that noise at 0 makes no infinities
        ratio = np.asarray(np.log2(sums[0] / np.maximum(sums[1], low)))
        maps.append(_discs(samples, ratio, "ratio", _end(ratio)))
    one_sided = _one_sided(samples)
    caption = (
        "The hemisphere of viewing directions seen from above; the distance from the middle is θᵣ (circles at 30°, 60°, 90°), the light comes from the left "
        "(triangle), the mirror direction is the cross (for a range of θᵢ both stand at its median). Blue: the fit is too dark; red: too bright. "
        + ("Channels are averaged. " if samples.measured.shape[1] > 1 else "")
        + ("The data hold one side of the plane of incidence, mirrored here. " if one_sided else "")
        + " ".join(words for _, _, words in maps)
    )
    return tag("figure", *(join(bar, panels) for bar, panels, _ in maps), tag("figcaption", caption))


def _discs(samples: Samples, value: Floats, kind: str, limit: float) -> tuple[Html, Html, str]:
    """The colour scale, the discs, and what the caption has to add."""
    if kind == "difference":
        ends, words = (
            (f"−{100 * limit:g} %", f"+{100 * limit:g} %"),
            "fitted − measured, as a share of RMS(measured); white is 0:",
        )
    else:
        limit = min(max(limit, 0.5), 5.0)
        ends, words = (f"1/{2**limit:.2g}", f"{2**limit:.2g}"), "fitted / measured, logarithmic; white is 1:"
    groups = incidence_groups(samples.theta_i)
    if kind == "ratio" and len(groups) > 4:
        groups = [groups[k] for k in np.linspace(0, len(groups) - 1, 4).round().astype(int)]
    panels = [
        _disc(group, samples.take(group.which), value[group.which] / limit, _one_sided(samples)) for group in groups
    ]
    beyond = float(np.mean(np.abs(value) > limit))
    name = "difference" if kind == "difference" else "ratio"
    more = f"{100 * beyond:.1f} % of the samples lie beyond the scale of the {name}." if beyond >= 5e-4 else ""
    return color_bar(*ends, diverging(np.linspace(-1, 1, 11)), words), tag("div", *panels, class_="panels discs"), more


def _one_sided(samples: Samples) -> bool:
    side = np.sin(samples.dphi)
    return len(samples) > 1 and bool(np.all(side >= -1e-6) or np.all(side <= 1e-6))


def _disc(group: Group, samples: Samples, value: Floats, one_sided: bool) -> Html:
    edge = 97.0
    scale = Scale(-edge, edge)
    size = 260
    panel = Panel(
        scale,
        Scale(-edge, edge + 14),
        group.title,
        width=size,
        height=round(size * (2 * edge + 14) / (2 * edge)),
        axes=False,
    )
    circle = np.linspace(0, 2 * np.pi, 91)
    r = np.degrees(samples.theta_r)
    x, y = -r * np.cos(samples.dphi), r * np.sin(samples.dphi)  # the light (dphi = 0) on the left
    if one_sided:
        x, y, value = np.r_[x, x], np.r_[y, -y], np.r_[value, value]
    panel.line(90 * np.cos(circle), 90 * np.sin(circle), "--disc", "fill")
    for radius in (30, 60, 90):
        panel.line(radius * np.cos(circle), radius * np.sin(circle), "--muted", "guide")
    if len(value) > 1500:
        panel.picture(_averaged(x, y, value), (-90, 90), (-90, 90))
    else:
        step = np.clip(np.round(value * 8), -8, 8).astype(int)
        diameter = float(np.clip(150 / np.sqrt(max(len(value), 1)), 5, 13))
        for s in np.unique(step):
            which = step == s
            panel.dots(x[which], y[which], hex_color(diverging(s / 8)), diameter)
    mirror = np.degrees(group.theta_i)
    panel.line([mirror - 4, mirror + 4], [-4, 4], "--ink", "ring")
    panel.line([mirror - 4, mirror + 4], [4, -4], "--ink", "ring")
    panel.line([-mirror - 4, -mirror + 3, -mirror - 4, -mirror - 4], [-4, 0, 4, -4], "--ink", "ring")
    return panel.svg(f"Residuals over the hemisphere, {group.title}")


def _averaged(x: Floats, y: Floats, value: Floats) -> NDArray[np.uint8]:
    n = 56
    column, row = ((x + 90) / 180 * n).astype(int).clip(0, n - 1), ((90 - y) / 180 * n).astype(int).clip(0, n - 1)
    cell = row * n + column
    counts = np.bincount(cell, minlength=n * n).reshape(n, n)
    mean = np.bincount(cell, value, minlength=n * n).reshape(n, n) / np.maximum(counts, 1)
    return np.concatenate([diverging(mean), np.where(counts > 0, 255, 0).astype(np.uint8)[..., None]], -1)
