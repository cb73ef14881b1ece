"""Figures of a fit over time: the trend of each parameter with the scans' own values, and how close each scan is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.drawing.colour import Floats
from motes.drawing.markup import Html, join, tag
from motes.drawing.svg import Panel, Scale
from motes.fitting.time_result import TimeFit, TrendFit
from motes.report.figures import Shown, figure, key
from motes.trends import KINDS, Trend

# How far beyond the last scan trends are drawn, as a share of the time observed.
BEYOND = 0.2
CURVE_POINTS = 181
RUNNERS_UP = 3


class Times(NamedTuple):
    """The time axis: the scans' times, those with samples, those left out, and how the axis is called."""

    hours: Floats
    usable: NDArray[np.intp]
    outliers: NDArray[np.intp]
    unit: str

    @classmethod
    def of(cls, fit: TimeFit) -> Times:
        return cls(
            np.asarray(fit.hours, float),
            np.flatnonzero(fit.measurement.mask.any(axis=(1, 2))),
            np.array([o.index for o in fit.outliers], np.intp),
            fit.measurement.time_unit,
        )

    @property
    def first(self) -> float:
        return float(self.hours[0])

    @property
    def last(self) -> float:
        return float(self.hours[-1])

    @property
    def end(self) -> float:
        """Where the drawing ends."""
        return self.last + BEYOND * (self.last - self.first)

    @property
    def label(self) -> str:
        return "scan" if self.unit == "scan" else f"time [{self.unit}]"

    @property
    def kept(self) -> NDArray[np.intp]:
        """Scans that take part in the trends."""
        return np.setdiff1d(self.usable, self.outliers)

    def words(self, time: float) -> str:
        """``2.5 h``, or ``scan 3``."""
        return f"scan {time:.4g}" if self.unit == "scan" else f"{time:.3g} {self.unit}"

    @property
    def scale(self) -> Scale:
        return Scale(self.first - 0.03 * (self.last - self.first), self.end)


def narrowed(t: TrendFit, picks: Sequence[int]) -> TrendFit:
    """The trend of some of the channels; a shared one stays as it is."""
    width = t.scan_values.shape[1]
    if width == 1 or list(picks) == list(range(width)):
        return t
    index = np.asarray(picks, np.intp)
    return replace(
        t,
        trend=_part(t.trend, index),
        alternatives=tuple(replace(a, trend=_part(a.trend, index)) for a in t.alternatives),
        scan_values=t.scan_values[:, index],
        scan_stderr=t.scan_stderr[:, index],
    )


def _part(trend: Trend, index: NDArray[np.intp]) -> Trend:
    coefficients, rows, start = {}, [], 0
    for c in KINDS[trend.kind].coefficients:
        value = trend.coefficients[c.name]
        wide = np.ndim(value) > 0
        coefficients[c.name] = value[index] if wide else value
        rows.append(start + index if wide else np.array([start]))
        start += np.size(value)
    flat = np.concatenate(rows)
    covariance = None if trend.covariance is None else trend.covariance[np.ix_(flat, flat)]
    return Trend(trend.kind, coefficients, trend.interval, trend.bounds, covariance)


# ---------------------------------------------------------------- trends


def trend_figures(fit: TimeFit, times: Times, channels: Sequence[Shown]) -> Html:
    """A panel a parameter, with its kind of trend and the runners-up below."""
    panels = [_trend_panel(t, times, channels, fit.measurement.n_channels) for t in fit.trends.values()]
    several = len(channels) > 1
    entries = [("line", c.color, c.name) for c in channels] if several else []
    if several and any(t.scan_values.shape[1] == 1 for t in fit.trends.values()):
        entries.append(("line", "--ink", "all channels"))
    color = "--muted" if several else channels[0].color
    entries += [
        ("dot", color, "a scan on its own, ± 1 standard error"),
        ("line", color, "trend over all scans"),
        ("bar", color, "68 % and 95 % band"),
        ("dashed", color, "beyond the last scan"),
    ]
    caption = (
        "Dots: each scan fitted alone. Faint dots: scans that do not determine the parameter. Curves: the trends, fitted to all scans together. "
        "The band holds the errors of the coefficients and the kinds of trend that the data do not exclude, so that it opens where the data end; "
        "it does not hold what the model cannot express."
    )
    if len(times.outliers):
        caption += " A scan that was left out is marked ×; where it lies beyond a panel, × stands at the edge."
    hidden = fit.measurement.n_channels - len(channels)
    if hidden:
        caption += f" {hidden} of {fit.measurement.n_channels} channels are not drawn; all are in material.json."
    return figure(panels, caption, key(entries), kind="panels trends")


def _trend_panel(t: TrendFit, times: Times, channels: Sequence[Shown], n_channels: int) -> Html:
    shared = t.scan_values.shape[1] == 1
    t = narrowed(t, [c.channel for c in channels])
    colors = ["--ink" if n_channels > 1 else channels[0].color] if shared else [c.color for c in channels]
    observed = np.linspace(times.first, times.last, CURVE_POINTS)
    later = np.linspace(times.last, times.end, max(CURVE_POINTS // 4, 2))
    value, error = t.band(observed)
    ahead, ahead_error = t.band(later)
    y, beyond = _value_scale(t, times, np.concatenate([value - 2 * error, value + 2 * error]), ahead)
    panel = Panel(times.scale, y, t.trend.kind.replace("_", " "), times.label, t.unit)
    panel.band([times.last, times.end], [y.low, y.low], [y.high, y.high], "--muted")
    low, high = t.trend.bounds
    for k, color in enumerate(colors):
        for sigmas in (1.96, 1.0):
            panel.band(
                np.concatenate([observed, later]),
                np.clip(
                    np.concatenate([value[:, k] - sigmas * error[:, k], ahead[:, k] - sigmas * ahead_error[:, k]]),
                    low,
                    high,
                ),
                np.clip(
                    np.concatenate([value[:, k] + sigmas * error[:, k], ahead[:, k] + sigmas * ahead_error[:, k]]),
                    low,
                    high,
                ),
                color,
            )
    for k, color in enumerate(colors):
        panel.line(observed, value[:, k], color)
        panel.line(later, ahead[:, k], color, "dashed")
    known = np.isin(times.usable, times.kept)
    at = times.hours[times.usable]
    # Channels stand side by side where their error bars would lie on one another.
    shift = (np.arange(len(colors)) - (len(colors) - 1) / 2) * 0.008 * (times.end - times.first)
    for k, color in enumerate(colors):
        own, own_error = t.scan_values[:, k], t.scan_stderr[:, k]
        sure = known & np.isfinite(own_error)
        x = at + (shift[k] if np.isfinite(own_error[known]).any() and len(colors) > 1 else 0.0)
        panel.whiskers(x[sure], own[sure] - own_error[sure], own[sure] + own_error[sure], color)
        panel.dots(x[sure], own[sure], color, 5)
        panel.dots(x[known & ~sure], own[known & ~sure], color, 5, "dots faint")
        for i in np.flatnonzero(~known):
            panel.text(float(at[i]), float(np.clip(own[i], y.low, y.high)), "×", kind="cross", shift=(0, 6))
    ends = t.trend(np.array([times.first, times.last])).reshape(2, -1)
    alt = (
        f"{t.name} against time, {t.trend.kind.replace('_', ' ')}: from {_listed(ends[0])} at {times.words(times.first)} "
        f"to {_listed(ends[1])} at {times.words(times.last)}"
    )
    return tag(
        "div", tag("h3", tag("code", t.name), f" {t.doc}"), panel.svg(alt), _kind_words(t, beyond), class_="trend"
    )


def _listed(values: Floats) -> str:
    return ", ".join(f"{v:.3g}" for v in values)


def _value_scale(t: TrendFit, times: Times, core: Floats, ahead: Floats) -> tuple[Scale, int]:
    """A scale that holds the curve and its band, and the dots near it; and how many dots lie beyond.

    A scan that hardly determines the parameter may say anything: its dot must not squeeze the curve flat.
    """
    low, high = (float(f(core)) for f in (np.min, np.max))
    rows = np.isin(times.usable, times.kept)
    points, errors = t.scan_values[rows], t.scan_stderr[rows]
    room = max(high - low, 0.25 * max(abs(low), abs(high)), 1e-9)
    known = points[np.isfinite(errors)]
    if known.size:  # what most scans say must be in sight, also where the trend misses it
        typical = float(np.median(known))
        room = max(room, 1.3 * (typical - high), 1.3 * (low - typical))
    near = (points >= low - room) & (points <= high + room)
    sure = near & np.isfinite(errors)
    reach = np.where(sure, np.minimum(np.nan_to_num(errors), 0.5 * room), 0.0)
    values = np.concatenate(
        [
            core.ravel(),
            points[near] - reach[near],
            points[near] + reach[near],
            np.clip(ahead, low - room, high + room).ravel(),
        ]
    )
    low, high = float(values.min()), float(values.max())
    # A constant with little noise should look constant.
    least = 0.12 * max(abs(low), abs(high))
    if high - low < least:
        middle = 0.5 * (low + high)
        low, high = middle - 0.5 * least, middle + 0.5 * least
    return Scale.around([low, high], zero=0 <= low < 0.4 * high), int(np.count_nonzero(~near))


def _kind_words(t: TrendFit, beyond: int) -> Html:
    """The kind of trend, how far the others are behind, and dots that are out of sight."""
    others = [a for a in t.alternatives if a.kind != t.trend.kind][:RUNNERS_UP]
    behind = ", ".join(f"{a.kind.replace('_', ' ')} {_difference(a.delta_bic)}" for a in others)
    doc = KINDS[t.trend.kind].doc
    return tag(
        "p",
        f"{doc[0].upper()}{doc[1:]}. ",
        f"BIC of the next: {behind}. " if others else None,
        f"{beyond} dot{'s lie' if beyond > 1 else ' lies'} beyond the panel." if beyond else None,
        class_="note",
    )


def _difference(bic: float) -> str:
    return (f"{bic:+,.0f}" if abs(bic) >= 100 else f"{bic:+.1f}").replace("-", "−")


# ---------------------------------------------------------------- how close each scan is


def relative_rms(fit: TimeFit) -> Floats:
    """RMS(f - r)/RMS(r) of each scan (T,), unweighted; NaN for scans without samples."""
    mask = fit.measurement.mask
    measured = np.where(mask, fit.measurement.values, 0.0)
    difference = np.where(mask, fit.predicted - measured, 0.0)
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(np.sqrt((difference**2).sum(axis=(1, 2)) / (measured**2).sum(axis=(1, 2))))


def closeness_figure(fit: TimeFit, times: Times) -> Html:
    """The relative RMS of each scan over time, and the mean ratio of measured to fitted, where a drift of the light would show."""
    share = 100 * relative_rms(fit)
    kept, left_out = times.kept, times.outliers
    panel = Panel(
        times.scale,
        Scale.around(share[kept], zero=True, margin=0.12),
        "Relative RMS of each scan",
        times.label,
        "relative RMS [%]",
    )
    panel.line(times.hours[kept], share[kept], "--ink", "thin")
    panel.dots(times.hours[kept], share[kept], "--ink", 6)
    ratio = _mean_ratio(fit)
    drift = Panel(
        times.scale,
        Scale.ratios(*_ends(ratio[kept])),
        "Measured over fitted, all samples",
        times.label,
        "ratio of sums",
    )
    drift.line([times.first, times.end], [1, 1], "--ink", "guide")
    drift.line(times.hours[kept], ratio[kept], "--ink", "thin")
    drift.dots(times.hours[kept], ratio[kept], "--ink", 6)
    for k in left_out:
        for p, values in ((panel, share), (drift, ratio)):
            p.text(float(times.hours[k]), float(np.clip(values[k], p.y.low, p.y.high)), "×", kind="cross", shift=(0, 6))
    caption = (
        "Left: RMS(f − r)/RMS(r) of each scan against the trends; a scan that stands out is one the trends miss. "
        "Right: the sum of all measured over the sum of all fitted values; a lamp that drifts or flickers between scans moves it away from 1."
    )
    if len(left_out):
        caption += " × marks scans that were left out, at the edge where they lie beyond."
    worst = kept[int(np.nanargmax(share[kept]))] if len(kept) else None
    words = (
        None
        if worst is None
        else tag(
            "p",
            f"Furthest off is {_scan(times, int(worst))}: {share[worst]:.3g} %; the median is {np.nanmedian(share[kept]):.3g} %.",
        )
    )
    return join(
        words,
        figure(
            [
                panel.svg(
                    f"Relative RMS of {len(kept)} scans against time, from {np.nanmin(share[kept]):.3g} to {np.nanmax(share[kept]):.3g} percent"
                ),
                drift.svg("Ratio of measured to fitted reflectance of each scan against time"),
            ],
            caption,
        ),
    )


def _scan(times: Times, index: int) -> str:
    return f"scan {index}" if times.unit == "scan" else f"scan {index} at {times.words(float(times.hours[index]))}"


def _mean_ratio(fit: TimeFit) -> Floats:
    mask = fit.measurement.mask
    with np.errstate(invalid="ignore", divide="ignore"):
        measured, predicted = (np.where(mask, x, 0).sum(axis=(1, 2)) for x in (fit.measurement.values, fit.predicted))
        return np.asarray(measured / predicted)


def _ends(values: Floats) -> tuple[float, float]:
    good = values[np.isfinite(values) & (values > 0)]
    return (float(good.min()), float(good.max())) if good.size else (1.0, 1.0)


__all__ = ["Times", "closeness_figure", "narrowed", "relative_rms", "trend_figures"]
