"""What plans are worth: on the simulated rig with truths that the planner does not know, and on real data; writes the tables of docs/plan.md.

usage: python tools/plan_study.py [--seeds 50] [--data ../shared/data] [-o docs/plan.md]

What stands between the marks of a part is replaced; parts whose data are missing keep what they have.
"""

# ruff: noqa: E501 (the lines of a page)
from __future__ import annotations

import argparse
import re
import subprocess
import sys
import tempfile
import time
import warnings
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import motes
from motes.files import write_text
from motes.measurements import Measurement, list_samples
from motes.planning.believed import believed
from motes.planning.information import Noise, Subject, information
from motes.planning.offers import Cost, Offer
from motes.planning.rigs import offered
from motes.planning.swapping import even, spread

Floats = NDArray[np.float64]
USUAL = "oren_nayar + torrance_sparrow"
NAMES = ("K_d", "sigma_d", "K_s", "sigma_s")
NOISE = 0.02
#: Readings of a quarter of the time of the grid, those of them that come first, and how often each of the others is repeated.
QUARTER, FIRST, TIMES = 65, 20, 3
#: Of real data: directions that are fitted, random choices, and what a planner takes as the noise who knows that models miss by some percent.
FEW, DRAWS, MISS, FAINT = 20, 5, 0.1, 0.005
CORNELL = ("garnet_red", "krylon_blue", "cayman")
MERL = ("pink-felt", "blue-acrylic", "alum-bronze", "special-walnut-224")


def readings(truth: motes.BRDF, wi: Floats, wo: Floats, rng: np.random.Generator) -> Measurement:
    """What an instrument would read of a truth."""
    f = truth.eval(wi, wo)
    values = f * (1 + NOISE * rng.standard_normal(f.shape))
    return Measurement.from_arrays(wi, wo, values, uncertainties=NOISE * np.abs(values))


def together(a: Measurement, b: Measurement) -> Measurement:
    """Two measurements as one."""
    assert a.uncertainties is not None
    assert b.uncertainties is not None
    return Measurement.from_arrays(
        np.concatenate([a.wi, b.wi]),
        np.concatenate([a.wo, b.wo]),
        np.concatenate([a.values[0], b.values[0]]),
        uncertainties=np.concatenate([a.uncertainties[0], b.uncertainties[0]]),
    )


def errors(data: Measurement, truth: Floats) -> Floats:
    fit = motes.fit(data, USUAL)
    return np.array([float(np.ravel(fit.parameters[name].value)[0]) for name in NAMES]) - truth


def secret(count: int, rng: np.random.Generator) -> Floats:
    """Truths (count, 4), drawn by other rules than the planner's prior."""
    return np.stack(
        [
            rng.uniform(0.05, 0.9, count),
            rng.uniform(0.1, 1.2, count),
            np.exp(rng.uniform(np.log(0.03), np.log(0.8), count)),
            np.exp(rng.uniform(np.log(0.06), np.log(0.5), count)),
        ],
        axis=1,
    )


def simulated(seeds: int, materials: int = 8) -> list[str]:
    """Root mean squares of the errors of fits, over those of the whole grid."""
    offer = offered("tvbrdf")
    rng = np.random.default_rng(2026)
    truths = secret(materials, rng)
    first = motes.plan(USUAL, offer, count=FIRST, check=0)
    flat = motes.plan(USUAL, offer, count=QUARTER, check=0, rivals="none", repeats=True)
    chosen = even(offer, QUARTER)
    ways = ("two steps", "one step", "even", "random")
    rows, ratios, seconds = [], [], []
    for number, values in enumerate(truths):
        truth = motes.OrenNayar(values[0], values[1]) + motes.TorranceSparrow(values[2], values[3])
        found: dict[str, list[Floats]] = {way: [] for way in ("grid", *ways)}
        for _ in range(seeds):
            found["grid"].append(errors(readings(truth, offer.wi, offer.wo, rng), values))
            found["even"].append(errors(readings(truth, offer.wi[chosen], offer.wo[chosen], rng), values))
            draw = rng.permutation(offer.shots)[:QUARTER]
            found["random"].append(errors(readings(truth, offer.wi[draw], offer.wo[draw], rng), values))
            found["one step"].append(errors(readings(truth, flat.wi, flat.wo, rng), values))
            data = readings(truth, first.wi, first.wo, rng)
            began = time.perf_counter()
            further = motes.plan(
                USUAL,
                offer,
                count=(QUARTER - FIRST) // TIMES,
                measured=data,
                check=0,
                rivals="none",
                repeats=True,
            )
            seconds.append(time.perf_counter() - began)
            more = readings(truth, np.repeat(further.wi, TIMES, axis=0), np.repeat(further.wo, TIMES, axis=0), rng)
            found["two steps"].append(errors(together(data, more), values))
        rms = {way: np.sqrt(np.mean(np.square(e), axis=0)) for way, e in found.items()}
        ratios.append([rms[way] / rms["grid"] for way in ways])
        means = [float(np.exp(np.mean(np.log(r)))) for r in ratios[-1]]
        cells = " | ".join(f"{x:.2f}" for x in means)
        rows.append(f"| {', '.join(f'{v:.2f}' for v in values)} | {cells} |")
        print(f"material {number + 1}: {dict(zip(ways, np.round(means, 2), strict=True))}", flush=True)
    table = np.array(ratios)  # (materials, ways, parameters)
    middle = np.median(np.exp(np.log(table).mean(axis=2)), axis=0)
    each = [
        f"| {name} | {' | '.join(f'{x:.2f}' for x in np.median(table[:, :, k], axis=0))} |"
        for k, name in enumerate(NAMES)
    ]
    return [
        f"{materials} materials whose parameters the planner is not told, {seeds} seeds, {100 * NOISE:.0f} % noise: root mean square errors of fits to {QUARTER} readings, over those of fits to the",
        f"{offer.shots} directions of the grid, each read once; the geometric mean over the four parameters. *Two steps*: {FIRST} directions planned for all that real materials span, then",
        f"{(QUARTER - FIRST) // TIMES} planned from their fit, each read {TIMES} times. *One step*: {QUARTER} readings planned for all materials at once. *Even*, *random*: as many directions of the grid.",
        f"A second step was planned, its first fit included, in {np.median(seconds):.2f} s (median; two cores, busy with other things).",
        "",
        f"| K_d, sigma_d, K_s, sigma_s | {' | '.join(ways)} |",
        f"|---|{'---|' * len(ways)}",
        f"| **median of {materials}** | {' | '.join(f'**{x:.2f}**' for x in middle)} |",
        *rows,
        "",
        f"| median for | {' | '.join(ways)} |",
        f"|---|{'---|' * len(ways)}",
        *each,
    ]


def stated(data: Measurement) -> Measurement:
    """The usable directions of a measurement, with uncertainties that say by how much models miss."""
    data = data.select(data.mask[0].all(axis=1))
    return data.with_uncertainties(np.hypot(MISS * np.abs(data.values), FAINT / data.wi[None, :, 2:3]))


def left_out(data: Measurement, rows: Sequence[int], model: str) -> tuple[float, float]:
    """What a fit to some directions says of the others: the relative RMS of f cos(theta_i), and the median of |f - r| / r."""
    fit = motes.fit(data.select(np.asarray(rows)), model)
    others = np.setdiff1d(np.arange(data.n_directions), rows)
    cosine = data.wi[others, 2:3]
    f = np.asarray(fit.material.brdf.eval(data.wi[others], data.wo[others]))
    r = data.values[0][others]
    bright = r > 0
    root = np.sqrt(np.sum(((f - r) * cosine) ** 2) / np.sum((r * cosine) ** 2))
    return float(root), float(np.median(np.abs(f - r)[bright] / r[bright]))


def rows_of(design: motes.Design, offer: Offer) -> list[int]:
    """Where the directions of a plan are in an offer."""
    pairs = np.concatenate([design.wi, design.wo], axis=1)
    return [int(np.argmin(np.abs(np.concatenate([offer.wi, offer.wo], axis=1) - p).sum(axis=1))) for p in pairs]


PARTS = ("real", "simulated", "minutes")
#: Of an arm [s per degree], and of measurements.
PACES, MINUTES = (0.5, 0.1), (1, 2)
WAYS = ("two steps", "one step", "spread", "even", "random")
MODELS = (USUAL,)


def compared(data: Measurement, model: str, rng: np.random.Generator) -> Floats:
    """The two errors (W, 2) of each of `WAYS` on one material."""
    data = stated(data)
    offer = offered(data)

    def planned(count: int, beside: list[int]) -> list[int]:
        known = data.select(np.asarray(beside)) if beside else None
        design = motes.plan(model, offer, count=count, goal="curve", measured=known, noise=MISS, floor=FAINT)
        return [*beside, *rows_of(design, offer)]

    draws = [left_out(data, rng.permutation(offer.shots)[:FEW].tolist(), model) for _ in range(DRAWS)]
    return np.array(
        [
            left_out(data, planned(FEW - FEW // 2, planned(FEW // 2, [])), model),
            left_out(data, planned(FEW, []), model),
            left_out(data, spread(offer, FEW, [], None), model),
            left_out(data, even(offer, FEW), model),
            tuple(np.median(draws, axis=0)),
        ]
    )


def thinned(data: Measurement, count: int = 1000) -> Measurement:
    """Directions of a large table, drawn by their solid angle, within 80 degrees."""
    near = np.minimum(data.wi[:, 2], data.wo[:, 2]) > np.cos(np.radians(80))
    chance = np.where(near & data.mask[0].all(axis=1), data.weights, 0.0)
    some = np.random.default_rng(1).choice(len(chance), count, replace=False, p=chance / chance.sum())
    return Measurement.from_arrays(data.wi[some], data.wo[some], data.values[0][some], channels=data.channels)


def real(folder: Path) -> list[str]:
    sources: dict[str, list[tuple[str, Callable[[], Measurement]]]] = {}
    if (folder / "curet").exists():
        samples = list(list_samples(folder / "curet"))[::2]
        sources["CUReT"] = [(str(s), lambda s=s: motes.read(folder / "curet", sample=s)) for s in samples]
    if (folder / "cornell").exists():
        sources["Cornell"] = [(n, lambda n=n: thinned(motes.read(folder / "cornell" / f"{n}.brdf"))) for n in CORNELL]
    writer = folder.parent / "tools" / "write_merl.py"
    lines = []
    with tempfile.TemporaryDirectory() as made:
        if writer.exists() and (folder / "merl-nbrdf").exists():
            subprocess.run([sys.executable, str(writer), made, *MERL], check=True, capture_output=True)
            sources["MERL format"] = [(n, lambda n=n: thinned(motes.read(Path(made) / f"{n}.binary"))) for n in MERL]
        for name, materials in sources.items():
            loaded = [read() for _, read in materials]
            for model in MODELS:
                rng = np.random.default_rng(7)
                found = np.array([compared(data, model, rng) for data in loaded])
                middle = " | ".join(f"{100 * a:.0f}, {100 * b:.0f}" for a, b in np.nanmedian(found, axis=0))
                others = np.minimum(found[:, 3, 0], found[:, 4, 0])
                better = [int((found[:, k, 0] < others).sum()) for k in range(2)]
                lines.append(f"| {name} ({len(found)}) | `{model}` | {middle} | {better[0]}, {better[1]} |")
                print(lines[-1], flush=True)
    return [
        f"Fits to {FEW} directions of real data, and what they say of all the others: the relative RMS of f cos(theta_i), which the highlight makes, and the median of the relative",
        'difference, which the rest makes [%]; medians over materials. *One step*: `goal="curve"`, planned for all that real materials span. *Two steps*: half of them so, the other half',
        "from the fit to these. *Spread*: as far from one another as can be in half and difference angle (what `check` does). *Even*: in the order of the file. *Random*: the",
        f"median of {DRAWS} draws. Fits and plans take readings as uncertain by {100 * MISS:.0f} % and {FAINT:g} in f cos(theta_i), since models miss by that. Cornell and MERL's format: 1,000 directions",
        "drawn by solid angle, up to 80°; in MERL's format they are neural reconstructions. Last column: for how many materials two steps, and one, have a smaller RMS than even and random.",
        "",
        f"| data (materials) | model | {' | '.join(WAYS)} | better |",
        f"|---|---|{'---|' * len(WAYS)}---|",
        *lines,
    ]


def gained(one: motes.Design, other: motes.Design) -> float:
    """The information of a design over that of another; see `in_minutes`."""
    subject = Subject.of(USUAL)
    values = believed(subject, "typical").values
    logs = [
        np.linalg.slogdet(information(subject.rows(values, d.wi, d.wo, Noise(NOISE, 1e-4))))[1] for d in (one, other)
    ]
    return float(np.exp(np.mean(logs[0] - logs[1]) / subject.size))


def in_minutes() -> list[str]:
    """Errors of plans by time and by count that take as long, on the rig of the paper with an arm of known pace."""
    rows = []
    for pace in PACES:
        offer = replace(offered("tvbrdf"), cost=Cost(reading=1.0, light=pace, view=0.0, known=True))
        for minutes in MINUTES:
            timed = motes.plan(USUAL, offer, minutes=minutes, check=0)
            low, high = 4, timed.shots + 1
            other = motes.plan(USUAL, offer, count=low, check=0)
            while high - low > 1:  # the largest count that takes no longer
                middle = motes.plan(USUAL, offer, count=(low + high) // 2, check=0)
                if middle.seconds <= 60 * minutes:
                    low, other = (low + high) // 2, middle
                else:
                    high = (low + high) // 2
            fits = other.seconds <= 60 * minutes
            cells = [f"{other.shots}", f"{other.to_all:.2f}"] if fits else ["4 take longer", ""]
            more = f"{gained(timed, other):.2f}" if fits else ""
            rows.append(
                f"| {pace:g} | {minutes:g} | {timed.shots} | {timed.to_all:.2f} | {' | '.join(cells)} | {more} |"
            )
            print(rows[-1], flush=True)
    return [
        "The rig of the paper, a second a reading, cameras that stand still; errors over those of all its 260 directions. *By count*: the largest count whose plan, gone through in",
        "its best order, takes no longer. *Information*: by time over by count, the P-th root of the determinant of the matrix of P parameters, the geometric mean over 16 materials: what was asked for. Errors are",
        "the geometric mean of the parameters' own, which need not follow it.",
        "",
        "| arm [s per degree] | minutes | readings by time | errors | readings by count | errors | information |",
        "|---|---|---|---|---|---|---|",
        *rows,
    ]


def placed(text: str, part: str, lines: Sequence[str]) -> str:
    """The page with what stands between the marks of a part replaced."""
    begin, end = f"<!-- {part} -->", f"<!-- /{part} -->"
    return re.sub(f"{begin}.*?{end}", lambda _: "\n".join([begin, *lines, end]), text, flags=re.DOTALL)


def main() -> None:
    root = Path(__file__).resolve().parents[1]
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=50)
    parser.add_argument("--data", type=Path, default=root.parent / "shared" / "data")
    parser.add_argument("--part", choices=(*PARTS, "all"), default="all")
    parser.add_argument("-o", "--output", type=Path, default=root / "docs" / "plan.md")
    given = parser.parse_args()
    warnings.simplefilter("ignore")
    makers = {"simulated": lambda: simulated(given.seeds), "real": lambda: real(given.data), "minutes": in_minutes}
    for part in PARTS if given.part == "all" else (given.part,):
        if part != "real" or given.data.exists():
            lines = makers[part]()
            write_text(given.output, placed(given.output.read_text(encoding="utf-8"), part, lines))


if __name__ == "__main__":
    main()
