"""The models beside each other on every material at hand, by loss and by colour: for docs/results.md."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Collection, Iterator
from functools import partial
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from processes import spread
from published_fits import dozen, merl_material

import motes
from motes.fitting.front import fit_beside
from motes.fitting.model_table import sphere_difference
from motes.fitting.nested import Found
from motes.measurements import list_samples

Floats = NDArray[np.float64]
Read = Callable[[], motes.Measurement]
CORNELL = {"garnet_red.brdf": "garnet red", "krylon_blue.brdf": "Krylon blue", "cayman.brdf": "Cayman"}
#: How far from the normal samples of the MERL format are taken [rad].
LIMIT = float(np.radians(80))
# Real materials ask for more than the source's models: a Fresnel term, energy that is kept, longer tails.  The simplest first.
RICHER = {
    "ON+TS": "oren_nayar + torrance_sparrow",
    "ON+TS, Schlick": "oren_nayar + torrance_sparrow(fresnel=schlick)",
    "EON+GGX, Schlick": "eon + ggx(fresnel=schlick)",
    "EON+GTR, Schlick": "eon + gtr(fresnel=schlick)",
    "layer over EON+GTR": "dust_layer(eon + gtr(fresnel=schlick))",
}
# An earlier study, by other code, of larger sets, by database: how many materials, and the medians of the loss [%].
SETS = (61, 5, 12, 14)
EARLIER = {
    "ON+TS": (11.9, 52.6, 38.3, 52.8),
    "ON+TS, Schlick": (10.9, 11.9, 28.1, 43.8),
    "EON+GGX, Schlick": (8.8, 9.7, 20.4, 41.5),
    "EON+GTR, Schlick": (8.1, 9.5, 18.4, 40.9),
    "layer over EON+GTR": (5.8, 9.5, 13.0, 36.3),
}


class Entry(NamedTuple):
    """A competitor: a model, and what is fitted for each channel that is shared otherwise."""

    model: str
    per_channel: tuple[str, ...] = ()


ENTRIES = {name: Entry(text) for name, text in RICHER.items()} | {
    f"{name}, K_s per channel": Entry(text, ("K_s",)) for name, text in RICHER.items()
}
SHARED = len(RICHER)


def databases(data: Path, folder: Path) -> dict[str, list[tuple[str, Read]]]:
    """The materials at hand that are neither films nor maps, by database: names, and how they are read."""
    return {
        "CUReT": [
            (f"sample {s}", partial(motes.read, data / "curet", sample=int(s))) for s in list_samples(data / "curet")
        ],
        "Cornell": [(name, partial(motes.read, data / "cornell" / file)) for file, name in CORNELL.items()],
        "MERL format": [(name, partial(merl_material, data, folder, name)) for name in dozen(data)],
        "RGL": [(path.stem, partial(motes.read, path)) for path in sorted((data / "rgl").glob("*.bsdf"))],
    }


def weighted(fit: motes.Fit, weights: Floats | None = None) -> float:
    """The relative RMS that the loss `linear` minimises: of (f - r) cos(theta_i), weighted as the measurement weighs, or by `weights` (N,)."""
    data = fit.measurement
    mask, measured = data.mask[0], data.values[0]
    each = np.asarray(data.weights if weights is None else weights, float)
    squares = np.reshape(each, (len(measured), -1)) * data.wi[:, 2:] ** 2 * mask
    off = np.where(mask, fit.predicted - measured, 0.0)
    return float(np.sqrt(np.sum(squares * off**2) / np.sum(squares * np.where(mask, measured, 0.0) ** 2)))


def fits(
    data: motes.Measurement,
    names: Collection[str],
    limit: float | None,
    weights: str = "measurement",
    loss: str = "linear",
) -> Iterator[motes.Fit]:
    """Fits of entries to a measurement, each started also from where those before it ended, as `motes.compare` does.

    What has one channel is not fitted again for K_s per channel.
    """
    given = {"loss": loss, "robust": "none", "weights": weights, "fixed": (), "max_theta": limit, "scale": 1.0}
    given |= {"time": None, "trends": "auto", "errors": "independent"}
    found: dict[Entry, motes.Fit] = {}
    for name in names:
        entry = ENTRIES[name]
        same = found.get(Entry(entry.model)) if data.n_channels == 1 else None
        if same is None:
            own = given | {"per_channel": entry.per_channel}
            fit = fit_beside(data, entry.model, own, [Found.of(other.brdf) for other in found.values()])
            assert isinstance(fit, motes.Fit)
            same = fit
        found[entry] = same
        yield same


def scored(database: str, read: Read) -> Floats:
    """Loss [%] and colour of the entries on a material (10, 2)."""
    limit = LIMIT if database == "MERL format" else None
    return np.array([(100 * weighted(fit), sphere_difference(fit)) for fit in fits(read(), list(ENTRIES), limit)])


def richer(data: Path, jobs: int) -> list[str]:
    """The part of the page: a leaderboard by loss and one by colour, and a row a material."""
    every: dict[str, dict[str, Floats]] = {}
    with tempfile.TemporaryDirectory() as folder:
        names = [(d, name, read) for d, pairs in databases(data, Path(folder)).items() for name, read in pairs]
        found = spread(scored, [(database, read) for database, _, read in names], jobs)
        for (database, name, _), row in zip(names, found, strict=True):
            every.setdefault(database, {})[name] = row
            print(database, name, row.round(2).tolist(), flush=True)
    coloured = {database: rows for database, rows in every.items() if database != "CUReT"}
    return [
        "## Models beside each other",
        "",
        "**Loss**: relative RMS in percent of (f - r) cos theta_i, weighted as the loss `linear` weighs it: MERL format",
        "(up to 80 degrees, 30,000 of the bins) and RGL by solid angle, the others every sample alike. **Colour**: the mean",
        "Delta E ITP (ITU-R BT.2124, white at 203 cd/m²) of a sphere under a lamp 45 degrees to the side, against the",
        "measurement. Both are of the data that were fitted. TS is Torrance-Sparrow, ON Oren-Nayar; Schlick is a Fresnel term",
        "with f0 fitted; the layer is single scattering over EON+GTR, taken for what it does to a fit, and not as a verdict that",
        "anything is dusty. K_s is the same in all channels, or one for each where the row says so; CUReT is grey, so that both",
        "are the same there. A fit starts also from where those of simpler models ended, as `motes.compare` does. In brackets:",
        f"an earlier study, by other code, of other sets ({', '.join(map(str, SETS[:-1]))} and {SETS[-1]} materials).",
        "",
        *leaderboard("loss [%]", 0, every, EARLIER),
        "",
        *leaderboard("Delta E ITP", 1, every, {}),
        "",
        "A row a material: loss, colour.",
        "",
        *table(list(RICHER), {d: {n: row[:SHARED] for n, row in rows.items()} for d, rows in every.items()}),
        "",
        "With K_s per channel:",
        "",
        *table(list(RICHER), {d: {n: row[SHARED:] for n, row in rows.items()} for d, rows in coloured.items()}),
    ]


def leaderboard(
    what: str, column: int, every: dict[str, dict[str, Floats]], earlier: dict[str, tuple[float, ...]]
) -> list[str]:
    """The entries, best first by the median over all materials: medians by database, and how often each is best of those that share K_s or do not."""
    numbers = {database: np.array(list(rows.values()))[..., column] for database, rows in every.items()}
    together = np.concatenate(list(numbers.values()))
    overall = np.median(together, axis=0)
    own = [np.bincount(np.argmin(part, axis=1), minlength=SHARED) for part in np.split(together, [SHARED], axis=1)]
    best = np.concatenate(own)
    lines = [
        f"| {what}, medians | all {len(together)} | {' | '.join(numbers)} | best of its five in |",
        "|---" * (3 + len(numbers)) + "|",
    ]
    for k in np.argsort(overall, kind="stable"):
        name = list(ENTRIES)[k]
        known = earlier.get(name, ("",) * len(numbers))
        cells = [
            f"{np.median(part[:, k]):.1f}" + (f" ({old})" if old else "")
            for part, old in zip(numbers.values(), known, strict=True)
        ]
        lines.append(f"| {name} | **{overall[k]:.1f}** | {' | '.join(cells)} | {best[k]} |")
    return lines


def table(names: list[str], every: dict[str, dict[str, Floats]]) -> list[str]:
    """Loss and colour: a column a model, a row a material, and a row for the medians of each database."""
    lines = [f"| material | {' | '.join(names)} |", "|---" * (1 + len(names)) + "|"]
    for database, rows in every.items():
        middle = np.median(list(rows.values()), axis=0)
        for title, row in ((f"**{database}, median of {len(rows)}**", middle), *rows.items()):
            lines.append(f"| {title} | {' | '.join(f'{loss:.1f}, {colour:.1f}' for loss, colour in row)} |")
    return lines
