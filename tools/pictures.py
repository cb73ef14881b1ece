"""Make the pictures of the README: a plaster that dries and gathers dust, and the models side by side.

usage: python tools/pictures.py [FOLDER]      (default: docs/pictures)
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

import motes
from motes.ageing.plaster import drying_plaster
from motes.drawing.sphere import render_sphere

SIZE = 320
HOURS = (0.0, 1.0, 2.0, 3.0, 6.0, 24.0)
MODELS = {
    "Lambert": motes.Lambert(K_d=(0.7, 0.55, 0.4)),
    "Oren-Nayar\nsigma_d = 0.6": motes.OrenNayar(K_d=(0.7, 0.55, 0.4), sigma_d=0.6),
    "+ Torrance-Sparrow\nK_s = 0.5, sigma_s = 0.15": motes.OrenNayar(K_d=(0.35, 0.25, 0.2), sigma_d=0.3)
    + motes.TorranceSparrow(K_s=0.5, sigma_s=0.15),
    "Dust\ng = -0.3": motes.Dust(w=(0.95, 0.9, 0.8), g=-0.3),
    "Dust\ng = 0.6": motes.Dust(w=(0.95, 0.9, 0.8), g=0.6),
    "Dust layer\ntau = 0.3": motes.DustLayer(
        motes.OrenNayar(K_d=(0.35, 0.25, 0.2), sigma_d=0.3) + motes.TorranceSparrow(K_s=0.5, sigma_s=0.15),
        motes.Dust(w=(0.95, 0.9, 0.8), g=-0.3),
        tau=0.3,
    ),
}


def strip(path: Path, rows: dict[str, list[motes.BRDF]], titles: list[str]) -> None:
    """A table of spheres: a row for each light, a column for each BRDF."""
    columns = len(titles)
    figure = Figure(figsize=(2 * columns, 2.05 * len(rows) + 0.5), dpi=110)
    grid = figure.subplots(len(rows), columns, squeeze=False)
    for line, (light, brdfs) in zip(grid, rows.items(), strict=True):
        for axes, brdf in zip(line, brdfs, strict=True):
            axes.imshow(render_sphere(brdf, SIZE, light=light))
            axes.set_axis_off()
    for axes, title in zip(grid[0], titles, strict=True):
        axes.set_title(title, fontsize=10)
    figure.subplots_adjust(
        left=0.005, right=0.995, bottom=0.005, top=1 - 0.5 / (2.05 * len(rows) + 0.5), wspace=0.02, hspace=0.02
    )
    figure.savefig(path, metadata={"Software": None})
    print(path)


def main() -> None:
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else "docs/pictures")
    folder.mkdir(parents=True, exist_ok=True)
    plaster = [drying_plaster(h) for h in HOURS]
    titles = [f"{h:g} h" for h in HOURS]
    strip(folder / "plaster.png", {"three-quarter": plaster, "side": plaster}, titles)
    models = list(MODELS.values())
    strip(folder / "models.png", {"three-quarter": models, "back": models}, list(MODELS))


if __name__ == "__main__":
    np.seterr(all="raise", under="ignore")
    main()
