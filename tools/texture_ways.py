"""Ways to convert every texel of a map: what each costs and how far it is from single fits; writes the table in docs/exports.md.

    python tools/texture_ways.py
    python tools/texture_ways.py picture     # docs/pictures/texture_patch.svg instead

The map has 64 x 64 texels of a surface that dries, its parameters 3 % noisy as fitted ones are.
"""

from __future__ import annotations

import shutil
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motes import maps
from motes.exports import texel_surface
from motes.exports.texel_surface import fit_texels
from motes.exports.texture_export import export_textures
from motes.fitting.conversion import Conversion, convert
from motes.maps.simulated import drying_surface
from motes.models import GltfSurface, OpenPBR, OrenNayar, Surface, TorranceSparrow

PAGE = Path(__file__).parent.parent / "docs" / "exports.md"
BEGIN, END = "<!-- ways of conversion: tools/texture_ways.py -->", "<!-- /ways of conversion -->"
SIDE, HOURS, NOISE = 64, 1.5, 0.03
ALONE = 24
ALL = SIDE * SIDE
MODEL = OrenNayar() + TorranceSparrow()
#: What a way is: nodes, directions of their fits, and how much farther than its neighbours a texel must be to be fitted, too.
WAYS: dict[str, tuple[int, tuple[int, int], float]] = {
    "solver, hundreds of directions": (ALL, texel_surface.FITTED, np.inf),
    "solver, thousands of directions": (ALL, texel_surface.DENSE, np.inf),
    "planes between 64 fits": (64, texel_surface.DENSE, np.inf),
    "planes between 1,024 fits": (1024, texel_surface.DENSE, np.inf),
    "planes, and fits where they are far: what is exported": (
        texel_surface.NODES,
        texel_surface.DENSE,
        texel_surface.FARTHER,
    ),
}


def cloud() -> dict[str, np.ndarray]:
    """The parameters of the map, texels row by row."""
    y, x = np.meshgrid(*2 * [np.linspace(0, 1, SIDE)], indexing="ij")
    rng = np.random.default_rng(1)
    true = drying_surface(y, x, np.array(HOURS))
    noisy = {name: np.maximum(v * (1 + NOISE * rng.standard_normal(v.shape)), 0.01) for name, v in true.items()}
    return {name: v.reshape(SIDE * SIDE, *v.shape[2:]) for name, v in noisy.items()}


def ways(kind: type[Surface]) -> list[str]:
    """Rows of the table for one kind of surface."""
    values, text, clock = cloud(), kind.candidates[0], time.process_time
    chosen = np.random.default_rng(5).choice(ALL, ALONE, replace=False)
    exact = [MODEL.with_parameters({name: v[k] for name, v in values.items()}) for k in chosen]
    start = clock()
    found = [convert(each, text, loss="cube_root").brdf.canonical() for each in exact]
    alone = (clock() - start) / ALONE
    best = np.array([Conversion.between(e, m).seen for e, m in zip(exact, found, strict=True)])
    rows = [row(kind, "single fits", alone, 0 * best)]
    for words, (nodes, dense, farther) in WAYS.items():
        spent = {"solve": 0.0, "between": 0.0}
        with pytest.MonkeyPatch.context() as patched:
            for name, value in (("NODES", nodes), ("DENSE", dense), ("FARTHER", farther)):
                patched.setattr(texel_surface, name, value)
            for name in spent:
                patched.setattr(texel_surface._Work, name, timed(getattr(texel_surface._Work, name), name, spent))
            made = fit_texels(MODEL, values, kind, (text,))
        others = [kind().with_parameters({name: v[k] for name, v in made.values.items()}) for k in chosen]
        off = np.array([Conversion.between(e, m).seen for e, m in zip(exact, others, strict=True)])
        cost = spent["solve"] / ALL if nodes == ALL else spent["between"] / (ALL - nodes)
        rows.append(row(kind, f"{words} ({made.fits:,} fits)" if farther < np.inf else words, cost, off / best - 1))
        share = made.seen[chosen] / off
        print(
            f"{kind.words}: {words}: counted errors are {share.min():.2f} to {share.max():.2f} of it", file=sys.stderr
        )
    return rows


def timed(method: Any, name: str, spent: dict[str, float]) -> Any:
    """A method that adds its processor time to what was spent under its name."""

    def called(*arguments: Any) -> Any:
        start = time.process_time()
        try:
            return method(*arguments)
        finally:
            spent[name] += time.process_time() - start

    return called


def row(kind: type[Surface], words: str, seconds: float, more: Any) -> str:
    """One row."""
    told = float(f"{1e3 * seconds:.2g}")
    return f"| {kind.words} | {words} | {told:g} ms | {100 * np.median(more):.1f} % | {100 * np.max(more):.0f} % |"


def picture() -> None:
    """A simulated map, fitted and exported, as its own picture shows it."""
    with tempfile.TemporaryDirectory() as folder:
        stack = maps.simulate_map(Path(folder) / "paint.zarr", (SIDE, SIDE), times=2, hours=4, lights=16)
        fitted = maps.fit_map(stack.path, "oren_nayar + torrance_sparrow", out=Path(folder) / "fitted.zarr")
        export_textures(fitted, "openpbr", Path(folder) / "set", hours=4)
        shutil.copy(Path(folder) / "set" / "paint_fit.svg", PAGE.parent / "pictures" / "texture_patch.svg")


def table() -> None:
    """The ways side by side, into the page."""
    head = [
        "| surface | way | processor time a texel, errors counted | farther than single fits, median | worst |",
        "|---|---|---|---|---|",
    ]
    lines = [*head, *(line for kind in (OpenPBR, GltfSurface) for line in ways(kind))]
    page = PAGE.read_text(encoding="utf-8")
    before, after = page.partition(BEGIN)[0], page.partition(END)[2]
    PAGE.write_text("\n".join([before + BEGIN, *lines, END]) + after, encoding="utf-8")


if __name__ == "__main__":
    picture() if sys.argv[1:] == ["picture"] else table()
