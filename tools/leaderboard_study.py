"""Why the leaderboard's figures are not those of another study: optima missed, other materials, another definition; for docs/results.md."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np
from leaderboard import EARLIER, ENTRIES, LIMIT, SETS, Floats, Read, databases, fits, weighted
from processes import spread

import motes
from motes.fitting.problem import Problem
from motes.fitting.setup import Wishes, prepare

# These three stand for the five: the source's model, the best without a layer, the best of all.
MODELS = ("ON+TS", "EON+GTR, Schlick", "layer over EON+GTR")
# Of more directions an even part; random starts are thinned out on fewer, and so many go on.
MOST, ROUGH, STARTS, KEPT = 3000, 600, 40, 6
DRAWS = 2000
#: A random search counts as better from so much less loss on.
BETTER = 0.005
# By database: how the figure could be meant otherwise.  What the fits weigh by, how far from the normal samples are taken [rad].
DEFINITIONS: dict[str, dict[str, tuple[str, float | None, str]]] = {
    "MERL format": {
        "as on the leaderboard: by solid angle, up to 80°": ("measurement", LIMIT, ""),
        "K_s per channel": ("measurement", LIMIT, ", K_s per channel"),
        "every bin alike": ("uniform", LIMIT, ""),
        "up to 70°": ("measurement", float(np.radians(70)), ""),
        "up to 90°": ("measurement", None, ""),
    },
    "RGL": {
        "as on the leaderboard: by solid angle": ("measurement", None, ""),
        "K_s per channel": ("measurement", None, ", K_s per channel"),
        "every direction of the file's own grid alike": ("uniform", None, ""),
        "up to 85°": ("measurement", float(np.radians(85)), ""),
        "up to 80°": ("measurement", LIMIT, ""),
        "every direction alike, up to 80°": ("uniform", LIMIT, ""),
    },
}


def thinned(data: motes.Measurement) -> motes.Measurement:
    if data.n_directions <= MOST:
        return data
    return data.select(np.sort(np.random.default_rng(1).choice(data.n_directions, MOST, replace=False)))


def losses(data: motes.Measurement, weights: str, limit: float | None, more: str) -> Floats:
    """The loss [%] of each of `MODELS`, defined in some way (3,)."""
    each = None if weights == "measurement" else np.ones(data.n_directions)
    return np.array([100 * weighted(fit, each) for fit in fits(data, [m + more for m in MODELS], limit, weights)])


def searched(fit: motes.Fit, name: str, rng: np.random.Generator) -> float:
    """The loss [%] where the best of fits from random points ends, to the samples of a fit that are not masked."""
    problem = prepare(fit.measurement, ENTRIES[name].model, Wishes("linear", "none", "measurement", (), ())).problem
    part = problem
    if len(problem.wi) > ROUGH:
        part = problem.at_directions(np.sort(rng.choice(len(problem.wi), ROUGH, replace=False)))
    rough = part.solve(random_points(problem, rng), max_iterations=60, reduction=1e-6)
    kept = rough.x[np.argsort(rough.normal.objective, kind="stable")[:KEPT]]
    objective = float(problem.solve(kept, max_iterations=300).normal.objective.min())
    return float(100 * np.sqrt(2 * objective / problem.brightness().sum()))


def random_points(problem: Problem, rng: np.random.Generator) -> Floats:
    """Parameter vectors (B, P): what has an upper bound anywhere within its bounds, widths and depths by their logarithm, strengths without one
    over four decades; channels 30 % apart."""
    x = np.empty((STARTS, problem.size))
    for q in problem.quantities:
        low, high = q.bounds
        if high > 100:
            value = np.exp(rng.uniform(np.log(3e-3), np.log(30), (STARTS, 1)))
        elif low >= 0 and not q.per_channel and rng.random() < 0.5:
            value = np.exp(rng.uniform(np.log(max(low, 1e-3 * high)), np.log(high), (STARTS, 1)))
        else:
            value = rng.uniform(low, high, (STARTS, 1))
        apart = rng.uniform(0.7, 1.3, (STARTS, q.where.stop - q.where.start)) if q.per_channel else 1.0
        x[:, q.where] = np.clip(value * apart, low, high)
    return x


class Studied(NamedTuple):
    """A material: the losses of `MODELS` [%] (3,), where random starts end (3,), and the losses by other definitions."""

    ours: Floats
    best: Floats
    meant: dict[str, Floats]


def studied(database: str, read: Read) -> Studied:
    measurement = thinned(read())
    own = list(fits(measurement, MODELS, LIMIT if database == "MERL format" else None))
    rng = np.random.default_rng(20070101)
    return Studied(
        np.array([100 * weighted(fit) for fit in own]),
        np.array([searched(fit, name, rng) for fit, name in zip(own, MODELS, strict=True)]),
        {title: losses(measurement, *way) for title, way in DEFINITIONS.get(database, {}).items()},
    )


def differences(data: Path, jobs: int) -> list[str]:
    """The part of the page."""
    found: dict[str, list[Floats]] = {}
    gains: dict[str, list[Floats]] = {}
    meant: dict[tuple[str, str], list[Floats]] = {}
    with tempfile.TemporaryDirectory() as place:
        tasks = [(database, read) for database, pairs in databases(data, Path(place)).items() for _, read in pairs]
        for (database, _), one in zip(tasks, spread(studied, tasks, jobs), strict=True):
            found.setdefault(database, []).append(one.ours)
            gains.setdefault(database, []).append(1 - one.best / one.ours)
            for title, row in one.meant.items():
                meant.setdefault((database, title), []).append(row)
            print(database, one, flush=True)
    rng = np.random.default_rng(20070101)
    return [
        "## Beside the earlier study",
        "",
        "The figures in brackets above are of other materials, by other code. What could lie between them and ours, for three of",
        f"the models, at {MOST:,} directions at most of each material (`tools/leaderboard_study.py`).",
        "",
        f"**Optima missed.** Fits from {STARTS} random points, the best {KEPT} of them followed to their end, against ours: in how many",
        f"materials the best ended with more than {100 * BETTER:.1f} % less loss, and by how much at most.",
        "",
        *missed(gains),
        "",
        "**Other materials.** The middle 90 % of the medians of as many materials as the earlier study had, drawn with replacement",
        "from those at hand: how far a median moves from one such set to another. In brackets its own.",
        "",
        *drawn(found, rng),
        "",
        "**Another definition.** Medians over the materials of the leaderboard, each fitted and measured in the same way.",
        "",
        *defined(meant),
        "",
        "Figures of RGL are ruled by what is seen along the surface: how much of the sum of squares that the loss is relative to",
        "lies in the ten directions with most of it, and in those of theta_r beyond 80 and 85 degrees.",
        "",
        *ruled(data),
    ]


def missed(gains: dict[str, list[Floats]]) -> list[str]:
    lines = [f"| database | {' | '.join(MODELS)} |", "|---" * (1 + len(MODELS)) + "|"]
    for database, rows in gains.items():
        table = np.array(rows)
        cells = [
            f"{np.sum(column > BETTER)} of {len(column)}"
            + (f", by {100 * column.max():.1f} %" if column.max() > BETTER else "")
            for column in table.T
        ]
        lines.append(f"| {database} | {' | '.join(cells)} |")
    return lines


def drawn(found: dict[str, list[Floats]], rng: np.random.Generator) -> list[str]:
    lines = [f"| drawn | {' | '.join(MODELS)} |", "|---" * (1 + len(MODELS)) + "|"]
    for k, (database, rows) in enumerate(found.items()):
        table = np.array(rows)
        picks = rng.integers(len(table), size=(DRAWS, SETS[k]))
        low, high = np.percentile([np.median(table[pick], axis=0) for pick in picks], [5, 95], axis=0)
        cells = [f"{low[j]:.1f} to {high[j]:.1f} ({EARLIER[name][k]})" for j, name in enumerate(MODELS)]
        lines.append(f"| {database}, {SETS[k]} of {len(table)} | {' | '.join(cells)} |")
    return lines


def defined(meant: dict[tuple[str, str], list[Floats]]) -> list[str]:
    lines = [f"| database | figure | {' | '.join(MODELS)} |", "|---" * (2 + len(MODELS)) + "|"]
    for database, ways in DEFINITIONS.items():
        for title in ways:
            cells = [f"{x:.1f}" for x in np.median(meant[database, title], axis=0)]
            lines.append(f"| {database} | {title} | {' | '.join(cells)} |")
        column = list(DEFINITIONS).index(database) + 2
        lines.append(f"| {database} | *the earlier study* | {' | '.join(str(EARLIER[m][column]) for m in MODELS)} |")
    return lines


def ruled(data: Path) -> list[str]:
    """Where the squares of the measurements of RGL lie."""
    lines = [
        "| material | ten directions | beyond 80° | beyond 85° | the largest at theta_r |",
        "|---|---|---|---|---|",
    ]
    for path in sorted((data / "rgl").glob("*.bsdf")):
        found = motes.read(path)
        squares = np.asarray(found.weights).reshape(-1) * (found.values[0] ** 2).sum(axis=1) * found.wi[:, 2] ** 2
        shares, seen = squares / squares.sum(), np.degrees(np.arccos(found.wo[:, 2]))
        parts = (np.sort(shares)[-10:].sum(), shares[seen > 80].sum(), shares[seen > 85].sum())
        cells = " | ".join(f"{100 * part:.0f} %" for part in parts)
        lines.append(f"| {path.stem} | {cells} | {seen[np.argmax(shares)]:.2f}° |")
    return lines
