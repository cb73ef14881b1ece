"""What `calibration_study.py` found, as a page: rank histograms, coverage at all levels, and a row of a table for each kind of fits."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from motes.drawing.markup import Html
from motes.drawing.svg import Panel, Scale
from motes.fitting.error_bars import LEVELS

Floats = NDArray[np.float64]
NAMES = ("K_d", "sigma_d", "K_s", "sigma_s")
COLOURS = dict(zip(NAMES, ("#2563a8", "#b4531f", "#2f7d4f", "#7a3fa0"), strict=True))
BINS = 20
#: The chance that all bins of a right histogram, or its whole curve, lie within the bands that are drawn.
SURE = 0.99
#: A panel's width and height, which hold the longest title.
SIZE = (340, 250)


class Ranks(NamedTuple):
    """Ranks in [0, 1] by parameter, NaN where the fit states no error; and which fits they are of."""

    kind: str
    data: str
    errors: str
    by_name: dict[str, Floats]

    @property
    def title(self) -> str:
        """In as few words as fit above a panel."""
        return f"{self.kind}: {self.data}" + (f", {self.errors}" if self.kind == "static" else "")

    @property
    def words(self) -> str:
        return f"{self.kind} fits, {self.data}, errors {self.errors}"

    @property
    def stated(self) -> float:
        """The share of parameters with an error."""
        return float(np.mean([np.isfinite(r).mean() for r in self.by_name.values()]))

    @property
    def known(self) -> dict[str, Floats]:
        """Without those that have none."""
        return {name: r[np.isfinite(r)] for name, r in self.by_name.items() if np.isfinite(r).sum() >= 50}


def histogram_band(count: int) -> tuple[float, float]:
    """Shares of a bin, over 1 / `BINS`, between which all bins of uniform ranks lie with chance `SURE` (binomial, Sidak)."""
    tail = (1 - SURE ** (1 / BINS)) / 2
    low, high = stats.binom.ppf([tail, 1 - tail], count, 1 / BINS)
    return float(low * BINS / count), float(high * BINS / count)


def distance_band(count: int) -> float:
    """The largest distance of a right empirical distribution from the diagonal, with chance `SURE` (Kolmogorov)."""
    return float(stats.kstwobign.ppf(SURE) / np.sqrt(count))


def covered(ranks: Floats, levels: Floats) -> Floats:
    """How often central intervals of each level hold the truth."""
    return np.mean(np.abs(2 * ranks[:, None] - 1) <= levels, axis=0)


def rank_panel(drawn: Ranks) -> Html:
    """Histograms over uniform ones, 1 where right, a line for each parameter."""
    most = 3.0
    panel = Panel(Scale(0, 1), Scale(0, most), drawn.title, "rank of the truth", "share over right", *SIZE)
    edges = np.linspace(0, 1, BINS + 1)
    low, high = histogram_band(min((len(r) for r in drawn.known.values()), default=100))
    panel.band(edges, np.full(BINS + 1, low), np.full(BINS + 1, high))
    for name, ranks in drawn.known.items():
        counts, _ = np.histogram(ranks, edges)
        height = np.minimum(np.repeat(counts * BINS / len(ranks), 2), most)
        panel.line(np.repeat(edges, 2)[1:-1], height, COLOURS[name])
    return panel.svg(f"Rank histograms of {drawn.words}")


def coverage_panel(drawn: Ranks) -> Html:
    """How often intervals of every level hold the truth."""
    levels = np.linspace(0, 1, 101)
    panel = Panel(Scale(0, 1), Scale(0, 1), drawn.title, "stated", "held", *SIZE)
    reach = distance_band(min((len(r) for r in drawn.known.values()), default=100))
    panel.band(levels, np.clip(levels - reach, 0, 1), np.clip(levels + reach, 0, 1))
    panel.line([0, 1], [0, 1], kind="guide")
    for name, ranks in drawn.known.items():
        panel.line(levels, covered(ranks, levels), COLOURS[name])
    return panel.svg(f"Coverage at all levels of {drawn.words}")


def row(drawn: Ranks) -> str:
    """A line of the table: how often 50, 68, 95 and 99 % hold, pooled; and each parameter's worst level."""
    pooled = np.concatenate(list(drawn.known.values()))
    levels = np.array([0.5, LEVELS["68"], 0.95, 0.99])
    held = covered(pooled, levels)
    every = np.linspace(0, 1, 201)
    worst = []
    for name in NAMES:
        if name in drawn.known:
            own = drawn.known[name]
            off = covered(own, every) - every
            at = int(np.argmax(np.abs(off)))
            right = abs(off[at]) <= distance_band(len(own))
            worst.append(f"{100 * off[at]:+.0f}".replace("-", "−") + ("" if right else f" at {100 * every[at]:.0f}"))
        else:
            worst.append("")
    count = len(next(iter(drawn.by_name.values())))
    cells = [drawn.kind, drawn.data, drawn.errors, f"{count:,}", f"{100 * drawn.stated:.0f} %"]
    return "| " + " | ".join([*cells, ", ".join(f"{100 * h:.0f}" for h in held), *worst]) + " |"
