"""Where each exported file was seen working: ``MOTES_BPY=PYTHON[:PYTHON] python tools/artefacts.py [three mitsuba ...]`` draws spheres in the programs that
are there (all, or those named), writes their pictures beside the formula's into docs/pictures, and their rows into the table of docs/programs.md.

Rows of programs that did not run stay.  Some minutes for all on two cores, most of them for the fits of surfaces.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from artefacts_drawn import MATERIAL, PROGRAMS, ROOT, Drawn

from motes.rendering.films import write_picture
from motes.rendering.panels import sheet
from motes.rendering.tonemap import picture

PAGE = ROOT / "docs" / "programs.md"
PICTURES = ROOT / "docs" / "pictures"
BEGIN, END = "<!-- drawn: tools/artefacts.py -->", "<!-- /drawn -->"
HEAD = ["artefact", "program", "what a user does", "median", "nine in ten", "energy", "picture"]
#: By what stands before the colon of a row's name.
STEPS = {
    "three": "`--to three -o paint.js`; in a page `createMaterial(THREE)` of it ([more](exports.md#three-js))",
    "materialx": "`--to materialx -o paint.mtlx`; open it in MaterialXView, choose `paint` or `paint_lobes`",
    "mitsuba": '`--to mitsuba -o paint.xml`; `<include>` it, `<ref id="paint"/>` or `paint_stock`',
    "rgl": "`--to rgl -o paint.bsdf`; a BSDF `measured` with that file",
    "osl": "`--to osl -o paint.osl`; a *Script* node, *Render > Open Shading Language* on the CPU",
    "blender": "`--to blender -o paint.py`; *File > Import > Motes Material*, or run the script",
    "extension": "`make blender`, install the zip, *Object > Motes Dust* ([more](blender.md))",
    "openpbr": "`--to openpbr -o paint.mtlx`; open it in what reads MaterialX",
    "standard_surface": "`--to standard_surface -o paint.mtlx`; the same",
    "openpbr as USD": "`--to openpbr -o paint.usda`; open it in usdview, or *File > Import > USD*",
    "gltf": "`--to gltf -o paint.gltf`; load it",
}
#: Differences are shown so many times as large.
GAIN = 5


def pictured(made: Drawn) -> str:
    """Write the program's sphere, the formula's and their difference; returns the file's name."""
    name = f"artefact_{re.sub('[^a-z0-9]+', '_', made.key.lower())}.png"
    panels = [made.picture, made.exact, GAIN * np.abs(made.picture - made.exact)]
    exposure = float(np.log2(0.8 / np.quantile(made.exact[made.compared], 0.98)))
    bytes_ = [picture(panel[::-1], exposure=exposure) for panel in panels]
    write_picture(PICTURES / name, sheet([bytes_], columns=["program", "formula", f"{GAIN} x difference"]))
    return name


def percent(share: float) -> str:
    """Two digits of it."""
    return f"{100 * share:.2g} %" if share >= 0.0001 else f"{100 * share:.1g} %"


def row(made: Drawn) -> str:
    """The line of the table."""
    middle, most, energy = made.errors()
    cells = [made.key, made.program, "", percent(middle), percent(most), f"{energy:.3f}"]
    line = f"| {' | '.join(cells)} | [seen](pictures/{pictured(made)}) |"
    print(line, flush=True)
    return line


def key_of(line: str) -> str:
    """What a row is about."""
    return line.split("|")[1].strip()


def main() -> None:
    new: dict[str, str] = {}
    for name in sys.argv[1:] or PROGRAMS:
        with TemporaryDirectory() as folder:
            for made in PROGRAMS[name](Path(folder)):
                new[made.key] = row(made)
    text = PAGE.read_text(encoding="utf-8")  # now: it may have changed in the meantime
    before, _, rest = text.partition(BEGIN)
    table, _, after = rest.partition(END)
    rows = {key_of(line): line for line in table.strip().splitlines()[2:]} | new
    order = list(STEPS)
    lines = sorted(rows.values(), key=lambda line: (order.index(key_of(line).partition(":")[0]), key_of(line)))
    for k, line in enumerate(lines):  # what a user does is said once for each export
        cells, kind = line.split("|"), key_of(line).partition(":")[0]
        cells[3] = " the same " if k and key_of(lines[k - 1]).partition(":")[0] == kind else f" {STEPS[kind]} "
        lines[k] = "|".join(cells)
    head = [f"| {' | '.join(HEAD)} |", "|---" * len(HEAD) + "|"]
    PAGE.write_text("\n".join([f"{before}{BEGIN}", *head, *lines, f"{END}{after}"]), encoding="utf-8")


if __name__ == "__main__":
    assert MATERIAL.name == "paint"  # which the steps say
    main()
