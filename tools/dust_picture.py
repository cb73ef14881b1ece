"""Make the picture of dust for the README: surfaces under layers of dust, by each form of the model, and beside them the Monte Carlo.

usage: python tools/dust_picture.py [--scattering single,multiple] [--photons 256] [PICTURE]      (default: docs/pictures/dust_layers.png)

Spheres under one lamp, lit from 45 degrees: dark and light, matte and glossy, under dust of tau 0 to 3.  The last row of each surface is light followed by
chance (tests/photons.py), a few hundred photons a pixel, which knows nothing of the model: grain is noise, and all else is the truth.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

import photons
from motes import BRDF, Dust, DustLayer, Lambert, OrenNayar, TorranceSparrow
from motes.drawing.sphere import render_sphere

ROOT = Path(__file__).resolve().parents[1]
Floats = NDArray[np.float64]
SIZE = 96
TAU = (0.0, 0.1, 0.3, 1.0, 3.0)
DUST = Dust(w=(0.97, 0.94, 0.88), g=0.6)
#: Each channel of a surface as a base of its own, for the photons, which know one channel.
Channels = tuple[BRDF, BRDF, BRDF]


def matte(colour: tuple[float, float, float]) -> tuple[BRDF, Channels]:
    return OrenNayar(K_d=colour, sigma_d=0.3), tuple(OrenNayar(K_d=k, sigma_d=0.3) for k in colour)  # type: ignore[return-value]


def glossy(colour: tuple[float, float, float]) -> tuple[BRDF, Channels]:
    shine = TorranceSparrow(K_s=0.3, sigma_s=0.15, normalization="facets")
    return Lambert(K_d=colour) + shine, tuple(Lambert(K_d=k) + shine for k in colour)  # type: ignore[return-value]


SURFACES = {
    "dark, matte": matte((0.05, 0.03, 0.03)),
    "light, matte": matte((0.30, 0.55, 0.75)),
    "dark, glossy": glossy((0.03, 0.03, 0.05)),
    "red, glossy": glossy((0.55, 0.05, 0.04)),
}


@dataclass(frozen=True)
class Followed:
    """What `render_sphere` asks of a BRDF, answered by photons."""

    bases: Channels
    tau: float
    photons: int
    channels: int = 3

    def eval(self, wi: Any, wo: Any) -> Floats:
        layers = [
            photons.Layer(base, self.tau, float(w), float(DUST.g)) for base, w in zip(self.bases, DUST.w, strict=True)
        ]
        # Both directions are above the horizon by more than rounding, or nobody sees the light.
        seen = np.minimum(wi[:, 2], wo[:, 2]) > 1e-3
        value = np.zeros((len(wi), 3))
        for c, layer in enumerate(layers):
            value[seen, c] = photons.pairs(layer, wi[seen], wo[seen], self.photons, seed=1 + c)
        return value


def layer(base: BRDF, tau: float, scattering: str) -> BRDF:
    chosen = {} if scattering == "single" else {"scattering": scattering}
    return DustLayer(base, DUST, tau, **chosen)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture", nargs="?", type=Path, default=ROOT / "docs/pictures/dust_layers.png")
    parser.add_argument("--scattering", default="single,multiple", help="the forms of the model, in the order of rows")
    parser.add_argument("--photons", type=int, default=256, help="a pixel and channel")
    chosen = parser.parse_args()
    forms = chosen.scattering.split(",")
    lines = [(surface, form) for surface in SURFACES for form in [*forms, "Monte Carlo"]]
    figure = Figure(figsize=(1.1 * len(TAU) * 2 + 1.7, 1.1 * len(lines) / 2 + 0.4), dpi=110)
    # Two surfaces side by side, so that the picture is no taller than a page.
    widths = [1.0] * len(TAU) + [0.45] + [1.0] * len(TAU)  # the narrow one is for words
    grid = figure.subplots(len(lines) // 2, len(widths), squeeze=False, width_ratios=widths)
    for axes in grid[:, len(TAU)]:
        axes.set_axis_off()
    for k, (surface, form) in enumerate(lines):
        row, half = k % (len(lines) // 2), k // (len(lines) // 2)
        for column, tau in enumerate(TAU):
            axes = grid[row, half * (len(TAU) + 1) + column]
            base, bases = SURFACES[surface]
            brdf: Any = Followed(bases, tau, chosen.photons) if form == "Monte Carlo" else layer(base, tau, form)
            axes.imshow(render_sphere(brdf, SIZE, light="three-quarter", dome=0.0, samples=1))
            axes.set_xticks([])
            axes.set_yticks([])
            axes.set_frame_on(False)
            if row == 0:
                axes.set_title(f"tau = {tau:g}", fontsize=8)
            if column == 0:
                axes.set_ylabel(f"{surface}\n{form}", fontsize=7)
    figure.subplots_adjust(left=0.055, right=0.995, bottom=0.005, top=0.95, wspace=0.04, hspace=0.04)
    figure.savefig(chosen.picture, metadata={"Software": None})
    print(chosen.picture)


if __name__ == "__main__":
    main()
