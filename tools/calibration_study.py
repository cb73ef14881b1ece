"""Simulation-based calibration: whether error bars are right at every width at once; writes docs/calibration.md and its figures.

    python tools/calibration_study.py [--repeats 200] [--only map] [-o docs/calibration.md]

After Talts et al. (2018), whose method is for posteriors: a truth is drawn, data are made of it, and the rank of the truth in what is stated is kept.  A
fit states an estimate, an error and (for static fits) two intervals, which fix a Student's t; the rank is then the probability integral transform of the
truth's t statistic.  Where errors are right these are uniform, so that intervals of every level hold the truth as often as they say.
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Callable, Collection, Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

os.environ.setdefault("NUMBA_NUM_THREADS", "1")

import numpy as np
from coverage_study import DENSE, MODEL, NOISE, directions, eon, gtr
from numpy.typing import NDArray
from scipy import optimize, stats

import motes
from motes.drawing.figure import figure
from motes.drawing.markup import Html
from motes.drawing.svg import Panel, Scale
from motes.files import write_text
from motes.fitting import Verdict
from motes.fitting.error_bars import LEVELS
from motes.fitting.result import FittedParameter
from motes.fitting.texels import TexelSolver
from motes.measurements import Measurement

Floats = NDArray[np.float64]
ROOT = Path(__file__).resolve().parents[1]
NAMES = ("K_d", "sigma_d", "K_s", "sigma_s")
COLOURS = dict(zip(NAMES, ("#2563a8", "#b4531f", "#2f7d4f", "#7a3fa0"), strict=True))
BINS = 20
#: The chance that all bins of a right histogram, or its whole curve, lie within the bands that are drawn.
SURE = 0.99
HOURS = np.linspace(0.0, 6.0, 6)
TRENDS = {"K_d": "exponential", "K_s": "linear"}


class Drawn(NamedTuple):
    """Ranks in [0, 1] by parameter, NaN where the fit states no error."""

    ranks: dict[str, Floats]

    @property
    def stated(self) -> float:
        """The share of parameters with an error."""
        return float(np.mean([np.isfinite(r).mean() for r in self.ranks.values()]))

    @property
    def known(self) -> dict[str, Floats]:
        """Without those that have none."""
        return {name: r[np.isfinite(r)] for name, r in self.ranks.items() if np.isfinite(r).sum() >= 50}


# ------------------------------------------------------------ ranks


def from_error(truth: Floats, value: Floats, stderr: Floats) -> Floats:
    """The rank of truths in normal distributions about values; NaN where there is no error."""
    with np.errstate(all="ignore"):
        return np.asarray(stats.norm.cdf((truth - value) / stderr))


def freedom_of(ratio: float) -> float:
    """Degrees of freedom of the Student's t whose intervals of 95 and 68 % have this ratio; infinity for the normal distribution's."""
    small, large = LEVELS["68"], LEVELS["95"]

    def excess(inverse: float) -> float:
        t = stats.t(1 / inverse)
        return float(t.ppf(0.5 + large / 2) / t.ppf(0.5 + small / 2)) - ratio

    return np.inf if excess(1e-6) >= 0 else 1 / optimize.brentq(excess, 1e-6, 1.0) if excess(1.0) > 0 else 1.0


def from_intervals(truth: Floats, fitted: FittedParameter, squared: bool) -> Floats:
    """The rank of truths (C,) in the distribution that the intervals of a fitted parameter state.

    They are symmetric in the coordinate of the fit (the square of a slope's deviation), apart from where a bound cuts them off; their upper ends then say how wide they are.
    """
    power = 2 if squared else 1
    ends = {level: np.atleast_2d(fitted.intervals[level]) ** power for level in LEVELS}
    values = np.atleast_1d(fitted.value).astype(float) ** power
    ranks = np.full(len(values), np.nan)
    for c, at in enumerate(values):
        small, large = (ends[level][c, 1] - at for level in LEVELS)
        if np.isfinite(small) and small > 0:
            freedom = freedom_of(float(large / small))
            scale = small / stats.t.ppf(0.5 + LEVELS["68"] / 2, freedom)
            ranks[c] = stats.t.cdf((np.atleast_1d(truth)[c] ** power - at) / scale, freedom)
    return ranks


# ------------------------------------------------------------ what is fitted


def seed_model(rng: np.random.Generator) -> motes.BRDF:
    """A material of the model that is fitted, another each time."""
    body = motes.OrenNayar(K_d=tuple(rng.uniform(0.2, 0.8, 3)), sigma_d=rng.uniform(0.2, 0.7))
    return body + motes.TorranceSparrow(K_s=rng.uniform(0.1, 0.4), sigma_s=rng.uniform(0.1, 0.3))


Maker = Callable[[np.random.Generator], motes.BRDF]


def noisy(values: Floats, rng: np.random.Generator) -> Floats:
    return values * (1 + NOISE * rng.standard_normal(values.shape))


@cache
def nearest(make: Maker, k: int) -> tuple[motes.BRDF, dict[str, Floats]]:
    """The k-th material, and the parameters (C,) that fits of `MODEL` come to when they see all of it without noise."""
    brdf = make(np.random.default_rng([23, k]))
    if make is seed_model:
        return brdf, {slot.name: np.atleast_1d(slot.value).astype(float) for slot in brdf.slots()}
    dense = directions(DENSE, np.random.default_rng(99), 1 / 3)
    fit = motes.fit(Measurement.from_arrays(*dense, brdf.eval(*dense)), MODEL, errors="independent")
    return brdf, {name: np.atleast_1d(p.value).astype(float) for name, p in fit.parameters.items()}


def gathered(rows: Iterator[dict[str, Floats]]) -> Drawn:
    kept: dict[str, list[Floats]] = {name: [] for name in NAMES}
    for row in rows:
        for name in NAMES:
            kept[name].append(row[name])
    return Drawn({name: np.concatenate(parts) for name, parts in kept.items()})


def static(make: Maker, errors: str, count: int, repeats: int) -> Drawn:
    """`motes.fit` of one scan, three channels."""

    def rows() -> Iterator[dict[str, Floats]]:
        for k in range(repeats):
            rng = np.random.default_rng([24, k])
            brdf, truth = nearest(make, k)
            wi, wo = directions(count, rng, 1 / 3)
            fit = motes.fit(Measurement.from_arrays(wi, wo, noisy(brdf.eval(wi, wo), rng)), MODEL, errors=errors)
            yield {
                # One channel of those that share directions, noise and three parameters: ranks are to be independent.
                name: from_intervals(truth[name], p, name == "sigma_d")[:1]
                for name, p in fit.parameters.items()
            }

    return gathered(rows())


def changing(make: Maker, rng: np.random.Generator) -> Callable[[Floats, Floats], Floats]:
    """The BRDF (T, N, 1) of a surface that brightens and loses its highlight."""
    first = make(rng)
    colour = "K_d" if make is seed_model else "rho"
    start, gain, pace = rng.uniform(0.2, 0.5), rng.uniform(0.1, 0.4), rng.uniform(1.0, 3.0)
    shine, loss = rng.uniform(0.2, 0.4), rng.uniform(0.01, 0.03)

    def values(wi: Floats, wo: Floats) -> Floats:
        scans = []
        for hours in HOURS:
            at = {colour: (start + gain * (1 - np.exp(-hours / pace)),), "K_s": shine - loss * hours}
            scans.append(first.with_parameters(at).eval(wi, wo))
        return np.stack(scans)

    return values


def over_time(make: Maker, repeats: int) -> Drawn:
    """`motes.fit` of six scans, one channel, the kinds of trends given; ranks of the value at a time of its own."""

    def rows() -> Iterator[dict[str, Floats]]:
        for k in range(repeats):
            rng = np.random.default_rng([29, k])
            surface = changing(make, rng)
            wi, wo = directions(100, rng, 1 / 3)
            at = float(rng.uniform(0, HOURS[-1]))
            fit = motes.fit(
                Measurement.from_arrays(wi, wo, noisy(surface(wi, wo), rng), times=HOURS), MODEL, trends=TRENDS
            )
            dense = directions(1000, np.random.default_rng(99), 1 / 3)
            clean = motes.fit(Measurement.from_arrays(*dense, surface(*dense), times=HOURS), MODEL, trends=TRENDS)
            row = {}
            for name, trend in fit.trends.items():
                value, stderr = trend.band(at)
                known = trend.verdict not in (Verdict.UNIDENTIFIABLE, Verdict.AT_LOWER, Verdict.AT_UPPER)
                truth = clean.trends[name].trend(at)
                row[name] = np.ravel(from_error(truth, value, np.where(known & (stderr > 0), stderr, np.nan)))[:1]
            yield row

    return gathered(rows())


def texels(make: Maker, count: int, repeats: int) -> Drawn:
    """Fits of a map: every texel is another surface, seen from the same directions, one channel."""
    rng = np.random.default_rng([31, count])
    wi, wo = directions(count, rng, 1 / 3)
    dense = directions(1000, np.random.default_rng(99), 1 / 3)
    surfaces = [make(rng) for _ in range(repeats)]
    solver = TexelSolver(MODEL, wi, wo, channels=1)
    clean = TexelSolver(MODEL, *dense, channels=1)
    first = [s.eval(wi, wo)[:, :1] for s in surfaces]
    seen = np.stack([noisy(f, rng) for f in first])
    if make is seed_model:
        values = [{s.name: np.ravel(s.value)[:1] for s in surface.slots()} for surface in surfaces]
        truth = np.array([[float(v[c.quantity][0]) for c in solver.columns] for v in values])
    else:
        far = np.stack([s.eval(*dense)[:, :1] for s in surfaces]).astype(np.float32)
        truth = np.asarray(clean.fit(far, clean.starts(far[:60])).x, float)
    fit = solver.fit(seen, solver.starts(seen[:60]))
    return Drawn(
        {c.quantity: from_error(truth[:, k], fit.x[:, k], fit.stderr[:, k]) for k, c in enumerate(solver.columns)}
    )


class Case(NamedTuple):
    """Which fits, of what, and how ranks are made."""

    kind: str
    data: str
    errors: str
    draw: Callable[[int], Drawn]


KINDS = ("static", "time", "map")
#: Texels cost a thousandth of a static fit.
MANY, FEW = 10, 0.375
CASES = (
    Case("static", "the model fitted", "independent", lambda n: static(seed_model, "independent", 205, n)),
    Case("static", "the model fitted", "blocks", lambda n: static(seed_model, "blocks", 205, n)),
    Case("static", "EON + GTR", "independent", lambda n: static(eon, "independent", 205, n)),
    Case("static", "EON + GTR", "blocks", lambda n: static(eon, "blocks", 205, n)),
    Case("time", "the model fitted", "auto", lambda n: over_time(seed_model, round(FEW * n))),
    Case("time", "EON + GTR", "auto", lambda n: over_time(dull, round(FEW * n))),
    Case("map", "the model fitted, 80 directions", "independent", lambda n: texels(seed_model, 80, MANY * n)),
    Case("map", "the model fitted, 24 directions", "independent", lambda n: texels(seed_model, 24, MANY * n)),
    Case("map", "EON + GTR, 80 directions", "independent", lambda n: texels(eon, 80, MANY * n)),
)


def dull(rng: np.random.Generator) -> motes.BRDF:
    """As `eon`, of one channel."""
    return motes.EON(rho=(0.5,), r=rng.uniform(0.2, 0.8)) + gtr(rng)


# ------------------------------------------------------------ what is shown


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


def rank_panel(case: Case, drawn: Drawn) -> Html:
    """Histograms over uniform ones, 1 where right, a line for each parameter."""
    most = 3.0
    panel = Panel(
        Scale(0, 1), Scale(0, most), f"{case.kind}: {case.data}, {case.errors}", "rank of the truth", "share over right"
    )
    edges = np.linspace(0, 1, BINS + 1)
    low, high = histogram_band(min((len(r) for r in drawn.known.values()), default=100))
    panel.band(edges, np.full(BINS + 1, low), np.full(BINS + 1, high))
    for name, ranks in drawn.known.items():
        counts, _ = np.histogram(ranks, edges)
        height = np.minimum(np.repeat(counts * BINS / len(ranks), 2), most)
        panel.line(np.repeat(edges, 2)[1:-1], height, COLOURS[name])
    return panel.svg(f"Rank histograms of {case.kind} fits, {case.data}, errors {case.errors}")


def coverage_panel(case: Case, drawn: Drawn) -> Html:
    """How often intervals of every level hold the truth."""
    levels = np.linspace(0, 1, 101)
    panel = Panel(Scale(0, 1), Scale(0, 1), f"{case.kind}: {case.data}, {case.errors}", "stated", "held")
    reach = distance_band(min((len(r) for r in drawn.known.values()), default=100))
    panel.band(levels, np.clip(levels - reach, 0, 1), np.clip(levels + reach, 0, 1))
    panel.line([0, 1], [0, 1], kind="guide")
    for name, ranks in drawn.known.items():
        panel.line(levels, covered(ranks, levels), COLOURS[name])
    return panel.svg(f"Coverage at all levels of {case.kind} fits, {case.data}, errors {case.errors}")


def row(case: Case, drawn: Drawn) -> str:
    """A line of the table: how often 50, 68, 95 and 99 % hold, pooled; and each parameter's worst level."""
    ranks = np.concatenate(list(drawn.known.values()))
    levels = np.array([0.5, LEVELS["68"], 0.95, 0.99])
    held = covered(ranks, levels)
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
    count = len(next(iter(drawn.ranks.values())))
    cells = [case.kind, case.data, case.errors, f"{count:,}", f"{100 * drawn.stated:.0f} %"]
    return "| " + " | ".join([*cells, ", ".join(f"{100 * h:.0f}" for h in held), *worst]) + " |"


def study(repeats: int, kinds: Collection[str] = KINDS) -> tuple[list[str], list[Html], list[Html]]:
    """The lines of the table, and the panels of both figures."""
    lines, ranks, coverage = [], [], []
    for case in (c for c in CASES if c.kind in kinds):
        drawn = case.draw(repeats)
        lines.append(row(case, drawn))
        print(lines[-1], flush=True)
        ranks.append(rank_panel(case, drawn))
        coverage.append(coverage_panel(case, drawn))
    return lines, ranks, coverage


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repeats", type=int, default=200, help="of static fits; times and maps go with it")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "docs" / "calibration.md")
    parser.add_argument(
        "--only", choices=KINDS, action="append", help="these fits alone; the others' rows and panels are left out"
    )
    options = parser.parse_args()
    lines, ranks, coverage = study(options.repeats, options.only or KINDS)
    pictures = options.output.parent / "pictures"
    write_text(pictures / "calibration-ranks.svg", figure(ranks, legend=COLOURS))
    write_text(pictures / "calibration-coverage.svg", figure(coverage, legend=COLOURS))
    write_text(options.output, page(lines, options.only or KINDS))


def page(lines: list[str], drawn: Collection[str]) -> str:
    """The page: the rows of the table, and the kinds of fits that the figures show."""
    text = [
        "# Error bars at every width",
        "",
        "Written by `python tools/calibration_study.py`, with its figures. [uncertainty.md](uncertainty.md) asks about two widths and real measurements; here are all widths at once.",
        "",
        "In simulation-based calibration (Talts, Betancourt, Simpson, Vehtari, Gelman 2018) a truth is drawn, data are made of it, and the rank of the truth in the stated",
        "distribution is kept: ranks are uniform where that distribution is right. Fits here are frequentist and state no posterior. So the rank is the probability integral transform of",
        "the truth's t statistic: for static fits in the Student's t that the intervals of 68 and 95 % fix, in the coordinate in which they are symmetric; for fits over time and maps, which state errors, in",
        "the normal distribution about the estimate. What follows is coverage at all levels, over truths of a wide prior; it is not a statement about one truth given its data.",
        "",
        "Truths: K_d from 0.2 to 0.8, sigma_d from 0.2 to 0.7, K_s from 0.1 to 0.4, sigma_s from 0.1 to 0.3, or materials of EON + GTR, where the truth is what the model comes to that sees",
        f"1,000 to {DENSE:,} directions without noise. Noise is {100 * NOISE:.0f} %, directions are drawn anew for each static fit and each fit over time (205 and 100 of them), and are the same for all texels",
        "of a map. Fits over time have six scans of a body that brightens and a highlight that fades, and are asked at a time of their own.",
        "",
        "| fits | data made by | errors | repeats | with an error | held by 50, 68, 95, 99 % | K_d | sigma_d | K_s | sigma_s |",
        "|---|---|---|---|---|---|---|---|---|---|",
        *lines,
        "",
        "Where the model is right, static fits, fits over time and maps hold what they say at every width within a few percent; HC3 and blocks err on the wide side, and with 24 directions a map's normal distribution",
        "has tails that are a little too thin. Where it is wrong, errors over independent samples hold the nearest truth half as often as they say, in static fits and in maps, which have no others; errors over",
        "blocks hold it as often at 95 and 99 %, and more often than they say at smaller levels.",
        "",
        "The rows of blocks were measured with leverages by CR3; CR2, whose errors are narrower, has taken its place since.",
        "",
        "The last four columns: by how many percent the level that is most wrong is off, + for too wide; which level that is, where chance does not explain it (1 %). What has no error sits at a bound, or",
        "is not seen by the data.",
        "",
        f"The figures are of: {', '.join(drawn)}. Kinds of fits can be studied one at a time (`--only`); a figure has those of its run.",
        "",
        "![Rank histograms](pictures/calibration-ranks.svg)",
        "",
        f"*Ranks in {BINS} bins over what is right: ∪ says errors are too small, ∩ too large, a slope that estimates are off to one side. All bins of a right one lie in the band in {100 * SURE:.0f} % of cases.*",
        "",
        "![Coverage at all levels](pictures/calibration-coverage.svg)",
        "",
        "*How often central intervals hold the truth, for every level. Below the line: too narrow.*",
    ]  # fmt: skip
    return "\n".join(text) + "\n"


if __name__ == "__main__":
    main()
