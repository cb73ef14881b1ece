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
FRESH = 2000  # the first seed of what nothing was chosen on; those from 1000 were it for an earlier rule
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
    figure = Figure(figsize=(5.2, 4.2), layout="constrained")
    axes = figure.subplots()
    for clean, dusty, label in (
        ("curet", "dusty", "false: CUReT"),
        ("clean", "dusty", "false: simulated"),
        ("fresh clean", "fresh dusty", "fresh ones, that nothing was chosen on"),
    ):
        x, y = ([share_of(by_set[name], t) for t in thresholds] for name in (clean, dusty))
        (curve,) = axes.step(x, y, where="post", label=label)
        at = judgement.DECISIVE
        axes.plot(share_of(by_set[clean], at), share_of(by_set[dusty], at), "o", color=curve.get_color())
    axes.axvline(0.05, color="0.7", lw=0.8)
    axes.axhline(0.95, color="0.7", lw=0.8)
    axes.set(xlim=(-0.01, 0.3), ylim=(0, 1.01), xlabel="clean materials called dusty", ylabel="dusty materials found")
    axes.legend(loc="lower right", fontsize=8)
    figure.savefig(path, dpi=110, metadata={"Software": None})


def line(title: str, rows: list[Row]) -> str:
    counts = [sum(row["dusty"] is verdict for row in rows) for verdict in (True, None, False)]
    share = f"{counts[0] / len(rows):.0%}" if rows else ""
    return f"| {title} | {len(rows)} | {' | '.join(map(str, counts))} | {share} |"


def between(count: int, of: int) -> str:
    """Wilson's 95 % interval of a share, in per cent."""
    z2 = 1.959964**2
    middle, half = (count + z2 / 2) / (of + z2), math.sqrt(z2 * (count * (of - count) / of + z2 / 4)) / (of + z2)
    return f"{100 * max(middle - half, 0):.0f} to {100 * min(middle + half, 1):.0f} %"


def parts(rows: list[Row]) -> Iterator[tuple[str, list[Row]]]:
    """All dusty ones, by what makes them hard."""
    thin = math.sqrt(0.1)
    yield f"all dusty, tau up to {thin:.2g}", [r for r in rows if r["tau"] <= thin]
    yield f"all dusty, tau above {thin:.2g}", [r for r in rows if r["tau"] > thin]
    yield f"all dusty, g up to {FORWARD:g}", [r for r in rows if r["g"] <= FORWARD]
    yield f"all dusty, g above {FORWARD:g}", [r for r in rows if r["g"] > FORWARD]
    for kind, name in enumerate(study.KINDS):
        yield f"all dusty, over {name}", [r for r in rows if r["name"] % len(study.KINDS) == kind]


def page(rows: list[Row], image: str) -> str:
    by_set = {name: [row for row in rows if row["set"] == name] for name in SETS}
    dusty = by_set["dusty"] + by_set["fresh dusty"]
    lost = [r for r in dusty if r["dusty"] is not True]
    other = sum(r["score"] is None and r["share"] < judgement.DECISIVE for r in lost)
    near = sum(r["score"] is not None for r in lost)
    called = ", ".join(f"{row['name']}" for row in by_set["curet"] if row["dusty"])
    fresh = [
        (sum(r["dusty"] is True for r in by_set[name]), len(by_set[name])) for name in ("fresh clean", "fresh dusty")
    ]
    (false, clean), (found, laid) = fresh
    return "\n".join(
        [
            "# Verdicts on dust",
            "",
            'Written by `tools/dust_verdict.py`: how often `fit.dusty` of `model="auto"` is right, at the 205 directions of CUReT. [fitting.md](fitting.md#choosing-a-model) says how it is found.',
            "",
            "Simulated materials are of models that `auto` does not try (Burley's, Minnaert's, Ashikhmin and Shirley's bodies, Hapke's powder with an opposition surge, Beckmann's facets, two highlights at",
            "once; one kind in eight has a body that it does try, the coated one), of one channel with 2 % of noise. The clean ones are besides off by a smooth field of 2 to 10 %, for what no formula has.",
            f"Dust is laid on by the photon Monte Carlo: tau from {study.DEPTHS[0]:g} to {study.DEPTHS[1]:g} (evenly in its logarithm), w from {study.ALBEDOS[0]:g} to {study.ALBEDOS[1]:g}, g from {study.MEAN_COSINES[0]:g} to {study.MEAN_COSINES[1]:g}.",
            "",
            "| materials | how many | True | None | False | called dusty |",
            "|---|---|---|---|---|---|",
            *(line(title, by_set[name]) for name, title in SETS.items()),
            *(line(title, part) for title, part in parts(dusty) if part),
            "",
            f"CUReT samples called dusty: {called or 'none'}. The goals are 5 % at most of the clean ones, and 95 % at least of the dusty ones.",
            "",
            f"**What to believe.** Threshold and candidates were chosen on these CUReT samples and on the first {len(by_set['clean'])} simulated ones of each sort. The fresh ones were drawn by other seeds, from the same kinds of bases, and",
            f"judged once, after everything was chosen: {false} of {clean} clean ones are called dusty (95 % interval {between(false, clean)}), and {found} of {laid} dusty ones found ({between(found, laid)}).",
            f"That is the honest figure{'' if found >= 0.95 * laid else ', and it misses the goal'}; what the chosen-on sets show beyond it is the choice's own luck.",
            "",
            f"![Found against falsely called, as the threshold moves]({image})",
            "",
            f"The curves move the share of the squared error, {judgement.DECISIVE:g} at the dots, below which a layer is called dust. They end where a layer's values are not those of dust, it does not follow the data, or predicts",
            "better by less than a standard error, whatever the threshold.",
            "",
            f"Of the {len(lost)} missed, {near} have a share above the threshold, and {other} one below it with values that are not those of dust (a dark, thin layer over a base that it does not fit) or with a gain that is one block's.",
            f"Over the other {len(lost) - near - other} no layer predicts much better: there a coat with a powder beside it, the rise towards grazing that clean CUReT asks for, does as well as dust. Without that candidate a sixth of the clean CUReT samples would be called dusty.",
            "",
            "**A shadow is no dust.** Layers that nearly all light goes straight through, and that take some away, follow highlights with flanks that no clean candidate has. What tells them from dust is how bright a heap of their grains",
            "would be: by van de Hulst's similarity relation as bright as one of grains that scatter evenly, of albedo w (1 - g) / (1 - w g). Of all dusts whose optics are known ([real_dusts.md](real_dusts.md)) that is least for soot, 0.150, and",
            f"coarse desert dust, 0.165, in the mean of 450, 550 and 650 nm; the threshold, {judgement.DARKEST:g}, stands just above that of soot. On the sets that things were chosen on nothing changes for thresholds from 0.05 to 0.18. Sixteen surfaces under coarse",
            "desert dust (w = 0.66, g = 0.9) are found all by this rule and by the one before (w of 0.25 or more, whatever g), 14 with a threshold of 0.16, 9 with 0.18. The rule before called 5 of 60 fresh clean ones of seeds from 1000 dusty and, of those",
            "from 2000, 2 of 60; seeds from 1000 are not fresh for the new rule, since they led to it.",
            "",
            "**Tried and left out**, by figures on the sets that things were chosen on. These, and those of coarse desert dust above, were measured once, by code that was not kept:",
            "",
            "- layers with all orders of scattering tried where the one that scatters once looks hopeless: of the two missed there, that alone had kept one from being tried; it ends at the dust's w and g, and predicts as well as the powder (share 0.97);",
            "- a powder beside a body counts only where there is a body (a coat of n above 1.2, rho above 0.02): one dusty surface more is found, one clean one more is called dusty;",
            "- clean candidates that return more light than they receive do not count: of the 68 powders that are best there none does, at 0, 45, 70 and 80 degrees;",
            "- layers that hide what lies below (tau above 2) are no evidence of dust on something: one of the two clean ones called dusty goes, but nothing would then be said of surfaces under heavy dust, which the sets do not have;",
            "- a second GGX lobe over EON or a coat finds no more and calls no fewer; Torrance and Sparrow's highlight on a coat is the best clean candidate for none of CUReT.",
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
