"""Simulation-based calibration: whether error bars are right at every width at once; writes docs/calibration.md and its figures.

    python tools/calibration_study.py [--repeats 200] [--minutes 10] [--only map] [--kept out/calibration] [-o docs/calibration.md]

What is computed is kept, a fit a line, and the next run goes on from there, so that the study can be made in parts; the page shows all that is kept.
Remove the folder after a change of fits: what is in it is of the fits that made it.

After Talts et al. (2018), whose method is for posteriors: a truth is drawn, data are made of it, and the rank of the truth in what is stated is kept.  A
fit states an estimate, an error and (for static fits) two intervals, which fix a Student's t; the rank is then the probability integral transform of the
truth's t statistic.  Where errors are right these are uniform, so that intervals of every level hold the truth as often as they say.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import time
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

os.environ.setdefault("NUMBA_NUM_THREADS", "1")

import numpy as np
from calibration_page import BINS, COLOURS, NAMES, SIZE, SURE, Ranks, coverage_panel, rank_panel, row
from coverage_study import MODEL, NOISE, directions, eon, gtr
from numpy.typing import NDArray
from scipy import optimize, stats

import motes
from motes.drawing.figure import figure
from motes.files import write_text
from motes.fitting import Verdict
from motes.fitting.error_bars import LEVELS
from motes.fitting.result import FittedParameter
from motes.fitting.texels import TexelSolver
from motes.measurements import Measurement

Floats = NDArray[np.float64]
#: In a part of a map: texels cost a thousandth of a static fit.
TEXELS = 200
#: What the nearest that a model can come is taken from, in static fits and maps.
DENSE = 6000
ROOT = Path(__file__).resolve().parents[1]
HOURS = np.linspace(0.0, 6.0, 6)
TRENDS = {"K_d": "exponential", "K_s": "linear"}


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


def static(make: Maker, errors: str, k: int) -> dict[str, Floats]:
    """Ranks of the k-th `motes.fit` of one scan, three channels."""
    rng = np.random.default_rng([24, k])
    brdf, truth = nearest(make, k)
    wi, wo = directions(205, rng, 1 / 3)
    fit = motes.fit(Measurement.from_arrays(wi, wo, noisy(brdf.eval(wi, wo), rng)), MODEL, errors=errors)
    # One channel of those that share directions, noise and three parameters: ranks are to be independent.
    return {n: from_intervals(truth[n], p, n == "sigma_d")[:1] for n, p in fit.parameters.items()}


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


def over_time(make: Maker, k: int) -> dict[str, Floats]:
    """Ranks of the k-th `motes.fit` of six scans, one channel, the kinds of trends given: of the value at a time of its own."""
    rng = np.random.default_rng([29, k])
    surface = changing(make, rng)
    wi, wo = directions(100, rng, 1 / 3)
    at = float(rng.uniform(0, HOURS[-1]))
    fit = motes.fit(Measurement.from_arrays(wi, wo, noisy(surface(wi, wo), rng), times=HOURS), MODEL, trends=TRENDS)
    dense = directions(1000, np.random.default_rng(99), 1 / 3)
    clean = motes.fit(
        Measurement.from_arrays(*dense, surface(*dense), times=HOURS), MODEL, trends=TRENDS, errors="independent"
    )
    found = {}
    for name, trend in fit.trends.items():
        value, stderr = trend.band(at)
        known = trend.verdict not in (Verdict.UNIDENTIFIABLE, Verdict.AT_LOWER, Verdict.AT_UPPER)
        truth = clean.trends[name].trend(at)
        found[name] = np.ravel(from_error(truth, value, np.where(known & (stderr > 0), stderr, np.nan)))[:1]
    return found


def texels(make: Maker, count: int, k: int) -> dict[str, Floats]:
    """Ranks of the k-th `TEXELS` of a map: every texel is another surface, seen from the same directions, one channel."""
    rng = np.random.default_rng([31, count, k])
    wi, wo = directions(count, rng, 1 / 3)
    dense = directions(1000, np.random.default_rng(99), 1 / 3)
    surfaces = [make(rng) for _ in range(TEXELS)]
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
    return {c.quantity: from_error(truth[:, j], fit.x[:, j], fit.stderr[:, j]) for j, c in enumerate(solver.columns)}


def dull(rng: np.random.Generator) -> motes.BRDF:
    """As `eon`, of one channel."""
    return motes.EON(rho=(0.5,), r=rng.uniform(0.2, 0.8)) + gtr(rng)


class Case(NamedTuple):
    """Which fits, of what: ranks of the k-th part, and how many parts there are for each repeat that is asked for."""

    kind: str
    data: str
    errors: str
    part: Callable[[int], dict[str, Floats]]
    share: float = 1.0

    @property
    def file(self) -> str:
        words = "-".join(re.sub(r"\W+", "-", w.lower()).strip("-") for w in (self.kind, self.data, self.errors))
        return f"{words}.jsonl"


KINDS = ("static", "time", "map")
CASES = (
    Case("static", "the model fitted", "independent", lambda k: static(seed_model, "independent", k)),
    Case("static", "the model fitted", "blocks", lambda k: static(seed_model, "blocks", k)),
    Case("static", "EON + GTR", "independent", lambda k: static(eon, "independent", k)),
    Case("static", "EON + GTR", "blocks", lambda k: static(eon, "blocks", k)),
    Case("time", "the model fitted", "auto", lambda k: over_time(seed_model, k), 0.75),
    Case("time", "EON + GTR", "auto", lambda k: over_time(dull, k), 0.75),
    Case("map", "the model fitted, 80 directions", "independent", lambda k: texels(seed_model, 80, k), 1 / 20),
    Case("map", "the model fitted, 24 directions", "independent", lambda k: texels(seed_model, 24, k), 1 / 20),
    Case("map", "EON + GTR, 80 directions", "independent", lambda k: texels(eon, 80, k), 1 / 20),
)


# ------------------------------------------------------------ in parts


def kept(file: Path) -> list[dict[str, Floats]]:
    """The parts that earlier runs kept; one that a run did not end is none."""
    found = []
    for line in file.read_text(encoding="utf-8").splitlines() if file.exists() else ():
        try:
            part = json.loads(line)
        except ValueError:
            break
        found.append({name: np.array([np.nan if r is None else r for r in ranks]) for name, ranks in part.items()})
    return found


def went_on(case: Case, repeats: int, folder: Path, until: float) -> list[dict[str, Floats]]:
    """All parts that are kept, after more were made until there are enough, or the clock says so."""
    parts = kept(folder / case.file)
    folder.mkdir(parents=True, exist_ok=True)
    text = "".join(_line(part) for part in parts)
    for k in range(len(parts), max(1, round(case.share * repeats))):
        if time.monotonic() > until:
            break
        parts.append(case.part(k))
        text += _line(parts[-1])
        write_text(folder / case.file, text)
    return parts


def _line(part: dict[str, Floats]) -> str:
    plain = {n: [None if np.isnan(r) else float(f"{r:.7g}") for r in ranks] for n, ranks in part.items()}
    return json.dumps(plain) + "\n"


def together(case: Case, parts: Sequence[dict[str, Floats]]) -> Ranks:
    """The parts of a case as one."""
    return Ranks(case.kind, case.data, case.errors, {n: np.concatenate([part[n] for part in parts]) for n in NAMES})


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repeats", type=int, default=200, help="of static fits; times and maps go with it")
    parser.add_argument("--minutes", type=float, default=np.inf, help="after which no further part is begun")
    parser.add_argument(
        "--kept", type=Path, default=ROOT / "out" / "calibration", help="the folder of what is computed"
    )
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "docs" / "calibration.md")
    parser.add_argument("--only", choices=KINDS, action="append", help="go on with these fits alone")
    options = parser.parse_args()
    until = time.monotonic() + 60 * options.minutes
    found = []
    for case in CASES:
        more = options.repeats if case.kind in (options.only or KINDS) else 0
        began = time.process_time()
        parts = went_on(case, more, options.kept, until) if more else kept(options.kept / case.file)
        print(f"{case.file}: {len(parts)} parts, {time.process_time() - began:.0f} s", flush=True)
        if parts and (ranks := together(case, parts)).known:
            found.append(ranks)
            print(row(ranks), flush=True)
    if len(found) < len(CASES):
        raise SystemExit(f"{len(CASES) - len(found)} of {len(CASES)} kinds of fits have too few: no page is written")
    pictures = options.output.parent / "pictures"
    write_text(pictures / "calibration-ranks.svg", figure([rank_panel(r) for r in found], size=SIZE, legend=COLOURS))
    write_text(
        pictures / "calibration-coverage.svg", figure([coverage_panel(r) for r in found], size=SIZE, legend=COLOURS)
    )
    write_text(options.output, page([row(r) for r in found]))


def page(lines: list[str]) -> str:
    """The page: the rows of the table, and what they say."""
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
        f"1,000 to {DENSE:,} directions without noise (those of so few are themselves somewhat off, which makes the rows of EON + GTR worse; [uncertainty.md](uncertainty.md) takes more). Noise is {100 * NOISE:.0f} %, directions are drawn anew for each static fit and each fit over time (205 and 100 of them), and are the same for all texels",
        "of a map. Fits over time have six scans of a body that brightens and a highlight that fades, and are asked at a time of their own.",
        "",
        "| fits | data made by | errors | repeats | with an error | held by 50, 68, 95, 99 % | K_d | sigma_d | K_s | sigma_s |",
        "|---|---|---|---|---|---|---|---|---|---|",
        *lines,
        "",
        "Where the model is right, static fits, fits over time and maps hold what they say at every width within a few percent; blocks err by some percent either way, and with 24 directions a map's normal distribution",
        "has tails that are a little too thin. Where it is wrong, errors over independent samples hold the nearest truth half as often as they say, in static fits and in maps, which have no others. Errors over",
        "blocks come near: in static fits they hold it some percent less often than they say, most for the highlight; in fits over time, whose scans share their directions and so their misfit, a tenth to a sixth less.",
        "",
        "The last four columns: by how many percent the level that is most wrong is off, + for too wide; which level that is, where chance does not explain it (1 %). What has no error sits at a bound, or",
        "is not seen by the data.",
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
