"""Whether `retro` and `sheen` would be taken by `auto`: candidates with them beside the clean ones, judged by directions left out.

usage: python tools/more_terms.py [--data ../shared/data]

On the clean CUReT samples, and on every fifth of the materials in MERL's format besides those of cloth.  Prints a line for each measurement
on which one of them predicts better than the best clean candidate by a standard error and has the smaller BIC, and counts.  Two minutes.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import numpy as np

import motes
from motes.fitting.choice import CANDIDATES, parsed
from motes.fitting.climbing import climb
from motes.fitting.judgement import Contender, clearly_better, simplest, standard_errors
from motes.fitting.setup import Wishes
from motes.measurements import Measurement, list_samples
from motes.models.composition import layer_of

ROOT = Path(__file__).resolve().parents[1]
WISHES = Wishes("linear", "none", "measurement", (), ())
CLEAN = tuple(text for text in CANDIDATES if layer_of(parsed(text).model) is None)
MORE = tuple(
    f"{body} + {term} + ggx(fresnel=schlick)" for body in ("eon", "coated_diffuse") for term in ("retro", "sheen")
)
CLOTH = ("fabric", "felt")


def measurements(data: Path, folder: Path) -> Iterator[tuple[str, str, Measurement]]:
    """The collection, the name and the data of each."""
    for sample in sorted(list_samples(data / "curet"), key=int):
        yield "CUReT", str(sample), motes.read(data / "curet", sample=int(sample))
    with np.load(data / "merl-nbrdf" / "nets.npz") as nets:
        names = sorted(nets.files)
    chosen = sorted({*names[::5], *(name for name in names if any(kind in name for kind in CLOTH))})
    writer = data.parent / "tools" / "write_merl.py"
    for name in chosen:
        subprocess.run([sys.executable, writer, folder, name], check=True, capture_output=True)
        yield "MERL format", name, motes.read(folder / f"{name}.binary")
        (folder / f"{name}.binary").unlink()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=Path, default=ROOT.parent / "shared" / "data")
    given = parser.parse_args()
    seen, better, taken = Counter[str](), Counter[tuple[str, str]](), Counter[tuple[str, str]]()
    with tempfile.TemporaryDirectory() as folder:
        for collection, name, data in measurements(given.data, Path(folder)):
            seen[collection] += 1
            contenders = [Contender.of([rung]) for rung in climb(data, WISHES, models=(*CLEAN, *MORE))]
            best = min((one for one in contenders if one.text in CLEAN), key=lambda one: one.loss)
            chosen = simplest(contenders).text
            taken[collection, chosen] += chosen in MORE
            for one in contenders:
                if one.text in MORE and clearly_better(one, best):
                    better[collection, one.text] += 1
                    share, errors = one.loss / best.loss, standard_errors(one, best)
                    print(f"{collection} {name}: {one.text} leaves {share:.2f} of {best.text}, {errors:.1f} errors")
    for collection, count in seen.items():
        for text in MORE:
            print(
                f"{collection}, {count}: {text} better on {better[collection, text]}, taken on {taken[collection, text]}"
            )


if __name__ == "__main__":
    main()
