"""Judge the verdicts of `auto` on dust, and write docs/verdicts.md with its picture.

usage: python tools/dust_verdict.py [--count 60] [--data ../shared/data] [--kept FILE] [-o docs/verdicts.md]

Five sets, all at the directions of CUReT: its clean samples, materials simulated without dust and with misfit, materials under dust by
the photon Monte Carlo (tools/study_materials.py), and as many again of both kinds that nothing was chosen on.  Five minutes of one core
for 60 of each; what was judged is kept in FILE, a line each, and not judged again.  Needs the development extras.
"""

from __future__ import annotations

import argparse
import json
import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import study_materials as study
from matplotlib.figure import Figure

import motes
from motes.files import write_text
from motes.fitting import judgement
from motes.fitting.climbing import climb
from motes.fitting.setup import Wishes
from motes.measurements import Measurement, list_samples

ROOT = Path(__file__).resolve().parents[1]
WISHES = Wishes("linear", "none", "measurement", (), ())
SETS = {
    "curet": "CUReT, clean",
    "clean": "simulated, clean, with misfit",
    "dusty": "simulated, dusty",
    "fresh clean": "fresh: simulated, clean, with misfit",
    "fresh dusty": "fresh: simulated, dusty",
}
FRESH = 1000  # the first seed of what nothing was chosen on
FORWARD = 0.75  # a mean cosine beyond which light goes nearly straight on
Row = dict[str, Any]


def judged(data: Measurement) -> Row:
    """The verdict on a measurement, and what it rests on."""
    contenders = [judgement.Contender.of([rung]) for rung in climb(data, WISHES)]
    found = judgement.judged(contenders)
    return {
        "dusty": found.dusty,
        "score": found.share if found.counts else None,
        "share": found.share,
        "model": found.chosen.text,
    }


def tasks(data: Path, count: int) -> Iterator[tuple[str, Row, Callable[[], Measurement]]]:
    """The set, what is known of the material, and how it is made."""
    samples = sorted(list_samples(data / "curet"), key=int)
    first = motes.read(data / "curet", sample=int(samples[0]))
    for sample in samples:
        yield "curet", {"name": sample}, lambda sample=sample: motes.read(data / "curet", sample=int(sample))
    for start, fresh in ((0, ""), (FRESH, "fresh ")):
        for k in range(start, start + count):
            yield f"{fresh}clean", {"name": k}, lambda k=k: study.clean(k, first.wi, first.wo)
        for k in range(start, start + count):
            tau, w, g = study.layer(k)
            about = {"name": k, "tau": tau, "w": w, "g": g}
            yield f"{fresh}dusty", about, lambda k=k: study.dusty(k, first.wi, first.wo)


def measured(data: Path, count: int, kept: Path | None) -> list[Row]:
    rows = [json.loads(line) for line in kept.read_text().splitlines()] if kept and kept.exists() else []
    known = {(row["set"], str(row["name"])) for row in rows}
    for name, about, make in tasks(data, count):
        if (name, str(about["name"])) in known:
            continue
        rows.append({"set": name, **about, **judged(make())})
        print(rows[-1], flush=True)
        if kept:
            with kept.open("a") as file:
                file.write(json.dumps(rows[-1]) + "\n")
    return rows


def share_of(rows: list[Row], decisive: float) -> float:
    """How many would be called dusty with another threshold."""
    return float(np.mean([row["score"] is not None and row["score"] < decisive for row in rows]))


def picture(by_set: dict[str, list[Row]], path: Path) -> None:
    """Found against falsely called, as the threshold moves."""
    thresholds = np.linspace(0, 1, 201)
    gentle = [row for row in by_set["dusty"] if row["g"] <= FORWARD]
    figure = Figure(figsize=(5.2, 4.2), layout="constrained")
    axes = figure.subplots()
    for name, label in (("curet", "false: CUReT"), ("clean", "false: simulated")):
        for rows, style, more in ((by_set["dusty"], "-", ""), (gentle, "--", f", g up to {FORWARD:g}")):
            x, y = ([share_of(r, t) for t in thresholds] for r in (by_set[name], rows))
            (line,) = axes.step(x, y, style, where="post", label=label + more, color="C0" if name == "curet" else "C1")
            at = judgement.DECISIVE
            axes.plot(share_of(by_set[name], at), share_of(rows, at), "o", color=line.get_color())
    axes.axvline(0.05, color="0.7", lw=0.8)
    axes.axhline(0.95, color="0.7", lw=0.8)
    axes.set(xlim=(-0.01, 0.3), ylim=(0, 1.01), xlabel="clean materials called dusty", ylabel="dusty materials found")
    axes.legend(loc="lower right", fontsize=8)
    figure.savefig(path, dpi=110, metadata={"Software": None})


def line(title: str, rows: list[Row]) -> str:
    counts = [sum(row["dusty"] is verdict for row in rows) for verdict in (True, None, False)]
    share = f"{counts[0] / len(rows):.0%}" if rows else ""
    return f"| {title} | {len(rows)} | {' | '.join(map(str, counts))} | {share} |"


def page(rows: list[Row], image: str) -> str:
    by_set = {name: [row for row in rows if row["set"] == name] for name in SETS}
    dusty = by_set["dusty"]
    thin = math.sqrt(0.1)
    parts = [
        (f"dusty, g up to {FORWARD:g}", [r for r in dusty if r["g"] <= FORWARD]),
        (f"dusty, g above {FORWARD:g}", [r for r in dusty if r["g"] > FORWARD]),
        (
            f"dusty, g up to {FORWARD:g}, tau up to {thin:.2g}",
            [r for r in dusty if r["g"] <= FORWARD and r["tau"] <= thin],
        ),
        (
            f"dusty, g up to {FORWARD:g}, tau above {thin:.2g}",
            [r for r in dusty if r["g"] <= FORWARD and r["tau"] > thin],
        ),
    ]
    lost = [r for r in dusty if r["dusty"] is not True]
    coated = sum(r["name"] % study.KINDS == study.COATED for r in lost)
    missed = (
        f"{coated} of {len(lost)} are over a coated body with a strong highlight, one kind of base in {study.KINDS}"
    )
    called = ", ".join(f"{row['name']}" for row in by_set["curet"] if row["dusty"])
    return "\n".join(
        [
            "# Verdicts on dust",
            "",
            'Written by `tools/dust_verdict.py`: how often `fit.dusty` of `model="auto"` is right, at the 205 directions of CUReT. [fitting.md](fitting.md#choosing-a-model) says how it is found.',
            "",
            "Simulated materials are of models that `auto` does not try (Burley's, Minnaert's, Ashikhmin and Shirley's bodies, Hapke's powder, Beckmann's facets, two highlights at once), of",
            "one channel with 2 % of noise. The clean ones are besides off by a smooth field of 2 to 10 %, for what no formula has. Dust is laid on by the photon Monte Carlo: tau from",
            f"{study.DEPTHS[0]:g} to {study.DEPTHS[1]:g} (evenly in its logarithm), w from {study.ALBEDOS[0]:g} to {study.ALBEDOS[1]:g}, g from {study.MEAN_COSINES[0]:g} to {study.MEAN_COSINES[1]:g}.",
            "",
            "| materials | how many | True | None | False | called dusty |",
            "|---|---|---|---|---|---|",
            *(line(title, by_set[name]) for name, title in SETS.items()),
            *(line(title, part) for title, part in parts),
            "",
            f"CUReT samples called dusty: {called or 'none'}. The goals are 5 % at most of the clean ones, and 95 % at least of the dusty ones.",
            "The threshold was chosen on these CUReT samples and on an earlier draw of the simulated ones: other samples have to judge it.",
            "",
            f"![Found against falsely called, as the threshold moves]({image})",
            "",
            f"The curves move the share of the squared error, {judgement.DECISIVE:g} at the dots, below which a layer is called dust.",
            "",
            f"Of those missed, {missed}. A layer is only tried over two kinds of bases, and what it does to a highlight, a blur, no candidate has.",
            "",
        ]
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--data", type=Path, default=ROOT.parent / "shared" / "data")
    parser.add_argument("--kept", type=Path)
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "docs" / "verdicts.md")
    given = parser.parse_args()
    rows = measured(given.data, given.count, given.kept)
    image = given.output.parent / "pictures" / "dust_verdict.png"
    picture({name: [row for row in rows if row["set"] == name] for name in SETS}, image)
    write_text(given.output, page(rows, f"pictures/{image.name}"))
    print(given.output)


if __name__ == "__main__":
    main()
