"""How often intervals hold the truth, and how errors compare with a bootstrap of real measurements; writes docs/uncertainty.md.

    python tools/coverage_study.py [--repeats 200] [--kept FOLDER] [--only PART] [--data ../shared/data] [-o ...]

Surfaces are simulated again and again, each time at other pairs of directions and with other noise, and fitted by
oren_nayar + torrance_sparrow.  Where that is not the model that made them, the truth is the nearest it can come: its fit to 50,000 directions
without noise.  Ways to compute errors are compared on the same fits (`error_ways`).
The page is made by this script alone, with ``--only`` one of its parts; each says by which commit.  Kinds of measurements at hand are taken.
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
from commits import commit_of_sources
from error_ways import OURS, WAYS, Bars, recorded
from numpy.typing import NDArray
from published_fits import dozen, merl_material

import motes
from motes.directions import half_difference
from motes.files import write_text
from motes.fitting.alike import APART, FEWEST, MOST, SIDE
from motes.measurements import Measurement, list_samples

Floats = NDArray[np.float64]
MODEL = "oren_nayar + torrance_sparrow"
SURFACE = motes.OrenNayar(K_d=(0.6, 0.4, 0.25), sigma_d=0.4) + motes.TorranceSparrow(K_s=0.25, sigma_s=0.2)
NOISE = 0.02
#: The correlation length of smooth fields [rad], and their standard deviation.
LENGTH, DEPTH = 0.2, 0.08
#: Directions of a measurement, and of what the nearest that a model can come is taken from: of 6,000 it is off by half the standard deviation
#: of a fit to 205, and all repeats are off to the same side.
COUNT, DENSE = 205, 50_000
REAL = "## Real measurements"
#: Of real measurements with more directions an even part of so many.
FEW = 2000
#: The nearest that the model can come to the surface of a repeat, once it is known.
NEAREST: dict[tuple[str, float, float], Floats] = {}
# What 68 and 95 % are to cover where the model misses something.
LOW, HIGH = (55.0, 88.0), (80.0, 99.0)


def directions(count: int, rng: np.random.Generator, near: float) -> tuple[Floats, Floats]:
    """Pairs of directions within 75 degrees; a share `near` of them about the mirror direction."""
    z, phi = rng.uniform(np.cos(1.3), 1, (2, count)), rng.uniform(0, 2 * np.pi, (2, count))
    wi, wo = np.stack([np.sqrt(1 - z * z) * np.cos(phi), np.sqrt(1 - z * z) * np.sin(phi), z], axis=-1)
    part = slice(0, round(near * count))
    wo[part] = wi[part] * (-1, -1, 1) + rng.normal(0, 0.25, wo[part].shape)
    wo[part, 2] = np.abs(wo[part, 2]) + 1e-3
    return wi, wo / np.linalg.norm(wo, axis=-1, keepdims=True)


@cache
def dense(near: float) -> tuple[Floats, Floats]:
    """Many directions, the same for all surfaces."""
    return directions(DENSE, np.random.default_rng(99), near)


class Field:
    """A smooth random field of mean 0 and deviation 1 with a normal kernel, by random waves (Rahimi and Recht, 2007)."""

    def __init__(self, rng: np.random.Generator, waves: int = 200) -> None:
        self.frequencies, self.phases = rng.normal(0, 1 / LENGTH, (3, waves)), rng.uniform(0, 2 * np.pi, waves)

    def __call__(self, wi: Floats, wo: Floats) -> Floats:
        """Its values (N,)."""
        theta_h, theta_d, phi_d = half_difference(wi, wo)
        at = np.stack([theta_h, theta_d * np.abs(np.cos(phi_d)), theta_d * np.abs(np.sin(phi_d))], axis=-1)
        waves = at @ self.frequencies + self.phases
        return np.asarray(np.sqrt(2 / waves.shape[1]) * np.cos(waves, out=waves).sum(axis=1))


def own(rng: np.random.Generator) -> motes.BRDF:
    return SURFACE


def eon(rng: np.random.Generator) -> motes.BRDF:
    body = motes.EON(rho=tuple(rng.uniform(0.2, 0.8, 3)), r=rng.uniform(0.2, 0.8))
    return body + gtr(rng)


def coated(rng: np.random.Generator) -> motes.BRDF:
    body = motes.CoatedDiffuse(rho=tuple(rng.uniform(0.3, 0.8, 3)), n=rng.uniform(1.3, 1.7))
    return body + gtr(rng)


def gtr(rng: np.random.Generator) -> motes.GTR:
    return motes.GTR(K_s=rng.uniform(0.05, 0.3), alpha=rng.uniform(0.1, 0.35), gamma=rng.uniform(1.2, 3))


def vector(fit: motes.Fit) -> Floats:
    return np.concatenate([np.atleast_1d(p.value) for p in fit.parameters.values()])


class Design(NamedTuple):
    """A material; the share of directions near the mirror's; the deviation of a smooth field that it is multiplied by; how many directions; and whether what
    intervals are to hold lies beneath the field."""

    material: Callable[[np.random.Generator], motes.BRDF]
    near: float = 1 / 3
    smooth: float = 0.0
    count: int = COUNT
    beneath: bool = False

    @property
    def misses(self) -> bool:
        """Whether the model cannot follow the surface, and intervals are to hold the nearest it can come."""
        return not self.beneath and (self.material is not own or self.smooth > 0)

    def simulated(self, repeat: int) -> tuple[Measurement, Floats]:
        """A measurement, and the parameters that its intervals are to hold (P,)."""
        rng = np.random.default_rng([11, repeat])
        brdf = self.material(rng)
        smooth = Field(np.random.default_rng([12, repeat])) if self.smooth else None

        def surface(wi: Floats, wo: Floats) -> Floats:
            values = np.asarray(brdf.eval(wi, wo))
            return values * (1 + self.smooth * smooth(wi, wo)[:, None]) if smooth else values

        truth = np.concatenate([np.atleast_1d(slot.value) for slot in SURFACE.slots()])
        if self.misses:
            name = f"{self.material.__name__}, {repeat}", self.near, self.smooth
            if name not in NEAREST:
                clean = Measurement.from_arrays(*dense(self.near), surface(*dense(self.near)))
                NEAREST[name] = vector(motes.fit(clean, MODEL, errors="independent"))
            truth = NEAREST[name]
        wi, wo = directions(self.count, rng, self.near)
        values = surface(wi, wo)
        return Measurement.from_arrays(wi, wo, values * (1 + NOISE * rng.standard_normal(values.shape))), truth


CASES = {
    "independent noise": Design(own),
    "independent noise, 100 directions": Design(own, count=100),
    "made by CoatedDiffuse + GTR": Design(coated),
    "made by EON + GTR": Design(eon),
    "made by EON + GTR, 600 directions": Design(eon, count=600),
    "made by EON + GTR, few directions near the mirror's": Design(eon, near=0.0),
    "made by a smooth field of 8 %": Design(own, smooth=DEPTH),
    "the same, and what is beneath the field": Design(own, smooth=DEPTH, beneath=True),
}


@dataclass(frozen=True)
class Repeat:
    """A repeat of a case: the truth (P,), whether the default was blocks, whether the intervals of Motes' two kinds of errors hold the truth (2, P), 68 and
    95 %, NaN where there is none or the truth is at a bound, and the bars of all ways."""

    truth: Floats
    default: bool
    blocks: Floats
    independent: Floats
    bars: Bars

    @classmethod
    def of(cls, case: str, number: int) -> Repeat:
        data, truth = CASES[case].simulated(number)
        with recorded() as found:
            first = motes.fit(data, MODEL)
            default = first.errors.kind == "blocks"
            second = motes.fit(data, MODEL, errors="independent" if default else "blocks")
        inside: dict[str, Floats] = {}
        for fit in (first, second):
            rows = []
            for level in ("68", "95"):
                ends = np.concatenate([np.atleast_2d(p.intervals[level]) for p in fit.parameters.values()])
                there = (ends[:, 0] <= truth) & (truth <= ends[:, 1])
                rows.append(np.where(np.isfinite(ends[:, 0]) & (truth > 1e-6), there, np.nan))
            inside[fit.errors.kind] = np.array(rows)
        return cls(truth, default, inside["blocks"], inside["independent"], Bars.of(found[0]))

    @classmethod
    def kept(cls, case: str, number: int, folder: Path | None) -> Repeat:
        """The repeat, out of the folder if it is there: each is a file, so that a run of the same sources can be stopped and go on."""
        if folder is None:
            return cls.of(case, number)
        path = folder / f"{list(CASES).index(case)}-{number}.npz"
        if path.exists():
            with np.load(path) as kept:
                if list(kept["ways"]) == list(WAYS):
                    own = [kept[name] for name in ("truth", "blocks", "independent")]
                    return cls(own[0], bool(kept["default"]), own[1], own[2], Bars(*(kept[n] for n in Bars._fields)))
        made = cls.of(case, number)
        folder.mkdir(parents=True, exist_ok=True)
        own = {"truth": made.truth, "blocks": made.blocks, "independent": made.independent, "default": made.default}
        np.savez(folder / "part.npz", ways=list(WAYS), **own, **made.bars._asdict())  # type: ignore[arg-type]
        (folder / "part.npz").replace(path)
        return made


def held_by_parameter(repeats: list[Repeat], way: str, widened: float = 1.0) -> Floats:
    """How many intervals of 68 and 95 % hold the truth, by parameter (2, P), in percent; NaN where it is at a bound in most repeats."""
    rows = np.array([one.bars.held(way, one.truth, widened) for one in repeats])
    counts = np.isfinite(rows).sum(axis=0)
    return np.where(counts > len(repeats) / 4, 100 * np.nansum(rows, axis=0) / np.maximum(counts, 1), np.nan)


def shares_held(repeats: list[Repeat], way: str, widened: float = 1.0) -> Floats:
    """The shares of intervals of 68 and 95 % that hold the truth (2,), in percent."""
    return np.asarray(np.nanmean(held_by_parameter(repeats, way, widened), axis=1))


def compared(every: dict[str, list[Repeat]]) -> list[str]:
    """A row a way: what its intervals cover in each case; in how many of those with misfit they cover what they should; what they do for the parameter
    that they do least for; and what they cover beneath the field where they are widened or narrowed until they cover the nearest to it well."""
    cases = list(every)
    missing = [case for case in cases if CASES[case].misses]
    alike, beneath = cases[-2:]
    lines = [
        f"| errors | {' | '.join(cases)} | as they should | least of any parameter, 95 % | beneath the field, were it 80 % for the nearest to it |",
        "|---" * (4 + len(cases)) + "|",
    ]
    for way in WAYS:
        shares = {case: shares_held(repeats, way) for case, repeats in every.items()}
        good = sum(LOW[0] <= a <= HIGH[0] and LOW[1] <= b <= HIGH[1] for a, b in (shares[case] for case in missing))
        least = min(float(np.nanmin(held_by_parameter(every[case], way)[1])) for case in missing)
        for widened in np.arange(2.0, 0.2, -0.02):
            if shares_held(every[alike], way, widened)[0] <= HIGH[0]:
                break
        last = shares_held(every[beneath], way, widened)
        cells = " | ".join(f"{a:.0f}, {b:.0f}" for a, b in shares.values())
        name = f"**{way}**: what Motes does" if way == OURS else way
        lines.append(f"| {name} | {cells} | {good} of {len(missing)} | {least:.0f} | {last[0]:.0f}, {last[1]:.0f} |")
        print(lines[-1], flush=True)
    return lines


def coverage(repeats: int, folder: Path | None) -> tuple[list[str], list[str]]:
    """The tables of what Motes' intervals cover, and of other ways to compute them."""
    names = [
        slot.name + (f"[{k + 1}]" if np.size(slot.value) > 1 else "")
        for slot in SURFACE.slots()
        for k in range(np.size(slot.value))
    ]
    lines = [f"| data | errors | default in | all | {' | '.join(names)} |", "|---" * (4 + len(names)) + "|"]
    every: dict[str, list[Repeat]] = {case: [] for case in CASES}
    for number in range(repeats):
        for case, found in every.items():
            found.append(Repeat.kept(case, number, folder))
        NEAREST.clear()
    for case, found in every.items():
        default = sum(one.default for one in found)
        for kind in ("blocks", "independent"):
            rows = np.array([getattr(one, kind) for one in found])
            counts = np.isfinite(rows).sum(axis=0)
            shares = np.where(counts > repeats / 4, 100 * np.nansum(rows, axis=0) / np.maximum(counts, 1), np.nan)
            cells = " | ".join("" if np.isnan(a) else f"{a:.0f}, {b:.0f}" for a, b in zip(*shares, strict=True))
            chosen = 100 * (default if kind == "blocks" else repeats - default) / repeats
            one, two = np.nanmean(shares, axis=1)
            lines.append(f"| {case} | {kind} | {chosen:.0f} % | **{one:.0f}, {two:.0f}** | {cells} |")
            print(lines[-1], flush=True)
    return lines, compared(every)


def thinned(data: Measurement, most: int = FEW) -> Measurement:
    """An even part of the directions, since a fit is repeated hundreds of times."""
    if data.n_directions <= most:
        return data
    return data.select(np.sort(np.random.default_rng(1).choice(data.n_directions, most, replace=False)))


def real(folder: Path) -> Iterator[tuple[str, list[Measurement]]]:
    """The measurements at hand, by kind."""
    samples = list_samples(folder / "curet") if (folder / "curet").exists() else []
    if samples:
        yield f"CUReT, {len(samples)} samples", [motes.read(folder / "curet", sample=int(s)) for s in samples]
    files = sorted((folder / "rgl").glob("*_rgb.bsdf"))
    if files:
        yield f"RGL, {len(files)} materials", [thinned(motes.read(path, resolution=12)) for path in files]
    names = dozen(folder)
    if names:
        with tempfile.TemporaryDirectory() as place:
            found = [thinned(merl_material(folder, Path(place), name)) for name in names]
        yield f"MERL format, {len(found)} materials", found


def ratios(folder: Path) -> list[str]:
    names = ("K_d", "sigma_d", "K_s", "sigma_s")
    lines = [f"| data | errors | {' | '.join(names)} |", "|---" * (2 + len(names)) + "|"]
    for what, measurements in real(folder):
        found: dict[str, dict[str, list[float]]] = {e: {n: [] for n in names} for e in ("independent", "blocks")}
        for data in measurements:
            boot = motes.fit(data, MODEL, errors="bootstrap")
            for errors, columns in found.items():
                fit = motes.fit(data, MODEL, errors=errors)
                for name, column in columns.items():
                    share = np.atleast_1d(boot.parameters[name].stderr) / np.atleast_1d(fit.parameters[name].stderr)
                    column.append(float(np.median(share)))
        for errors, columns in found.items():
            lines.append(f"| {what} | {errors} | {' | '.join(_median(columns[n]) for n in names)} |")
            print(lines[-1], flush=True)
    return lines


def _median(values: list[float]) -> str:
    known = [value for value in values if np.isfinite(value)]
    return f"{np.median(known):.2f}" if known else ""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repeats", type=int, default=200)
    parser.add_argument("--kept", type=Path, help="where repeats are kept, and those of an earlier run taken from")
    parser.add_argument("--only", choices=("simulated", "real"), help="the other part stays as the page has it")
    parser.add_argument("--data", type=Path, default=Path(__file__).resolve().parents[2] / "shared" / "data")
    parser.add_argument(
        "-o", "--output", type=Path, default=Path(__file__).resolve().parents[1] / "docs" / "uncertainty.md"
    )
    options = parser.parse_args()
    before = options.output.read_text() if options.only else ""
    simulated = before.partition(REAL)[0] if options.only == "real" else study(options.repeats, options.kept)
    real = before.partition(REAL)[2] if options.only == "simulated" else ratios_in_words(options.data)
    write_text(options.output, f"{simulated.rstrip()}\n\n{REAL}\n\n{real.strip()}\n")


def ratios_in_words(data: Path) -> str:
    return "\n".join(
        [
            "The error by the block bootstrap (400 draws) over that by the formula, medians over materials: near 1 where the formula says what happens",
            f"when other blocks are measured. `{MODEL}`; of more than {FEW:,} directions an even part. Blank: at a bound.",
            "",
            *ratios(data),
            "",
            f"*By commit {commit_of_sources()}.*",
        ]
    )


def study(repeats: int, kept: Path | None) -> str:
    table, ways = coverage(repeats, kept)
    page = [
        "# How far error bars are to be believed",
        "",
        "Written by `python tools/coverage_study.py`; what is computed is in [fitting.md](fitting.md#standard-errors).",
        "",
        "## Coverage",
        "",
        f"How often intervals of 68 and 95 % hold the truth, in percent of {repeats} repeats, each with directions and noise (2 %) of its own: {COUNT}",
        f"directions, three channels, fitted by `{MODEL}`. Where another surface made the data (a material drawn at random each time, or a smooth field on",
        f"one), the truth is the nearest that the model can come: its fit to {DENSE:,} directions without noise. A truth at a bound does not count. Nothing is",
        "said of the arrays, so that the residuals decide what the default is: how often it was is in the third column.",
        "",
        *table,
        "",
        "Where the noise is independent both ways hold. Where the model misses something, intervals over independent samples hold the nearest that it can",
        "come half as often as they say, those over blocks about as often: somewhat more often where much was measured, somewhat less often for the highlight",
        "of few directions. Were the directions the same in every repeat, only the noise would differ: errors that hold for what the model misses would then",
        "cover always.",
        "",
        "The last design asks of the same data for something else: the parameters by which the surface was made, before a field that is another in each",
        "repeat went over it. No direction tells of them apart from the field, and what the fit takes up of it is gone from the residuals. So these intervals",
        "are too narrow for them.",
        "",
        "## Ways to compute them",
        "",
        f"{repeats} repeats of the same designs, from the same fits; such shares are good to about {spread(repeats)}. To aim at: {LOW[0]:.0f}",
        f"to {HIGH[0]:.0f} % and {LOW[1]:.0f} to {HIGH[1]:.0f} % in the five designs with misfit. The last column: what is covered beneath the field by",
        f"intervals that are widened or narrowed until they cover the nearest to it in {HIGH[0]:.0f} %. CR2 and CR3 make up for what a block did to the fit",
        "itself (Bell and McCaffrey 2002), each with its degrees of freedom; few large blocks are also how Bester, Conley and Hansen (2011) go about it.",
        f"Residuals are alike up to the distance at which their correlation sinks below {APART}; there are {FEWEST} to {MOST} blocks of so many times that.",
        "Waves are principal components of a correlation over directions, as Müller and Watson (2022) have them: as many as make the interval shortest, and",
        "wide enough where pairs correlate by 0.03 on average. The Gaussian process is what the model misses in proportion to the BRDF, fitted by restricted",
        "maximum likelihood, so that the long waves that the fit took up count (Kennedy and O'Hagan 2001).",
        "",
        *ways,
        "",
        "Where it is asked what comes nearest to the surface, what the model misses is the same in every repeat, and only directions are drawn anew: each",
        "direction then counts nearly by itself, but for highlights that few directions see. Few blocks, which are wide, cover too often, and the more so",
        f"the more directions there are. Blocks {SIDE:g} times as long as residuals are alike are many where the noise is independent or what the model",
        "misses changes quickly, and few where it is broad. Those as long as residuals are alike cover less of the field's surface and so what they should",
        "in every design, but too little of others: of a Lambert body under a highlight with a tail, which `tests/test_fitting_uncertainty.py` fits again",
        "and again, they say less than 0.7 of the scatter of K_d. Waves come near, but for the highlight they do too little and for the body too much, as",
        "the least of any parameter shows; and they take eigenvectors of a matrix of all directions.",
        "",
        "Only the Gaussian process covers what is beneath the field, as that is what it takes for granted. Of all other surfaces it says many times the error",
        "that there is. No width is right for both: the last column is about the same for all ways, since from one set of data the field beneath which",
        "parameters are asked for cannot be told from a surface to which the nearest is asked for. Those who know that what a model misses varies from sample",
        "to sample, and want errors for that, should measure several samples: their scatter is that error.",
        "",
        f"*By commit {commit_of_sources()}.*",
    ]
    return "\n".join(page)


def spread(repeats: int) -> int:
    """How far the mean over some six parameters, which go together, is off by chance [%]: one standard deviation or a little more."""
    return round(45 / repeats**0.5)


if __name__ == "__main__":
    main()
