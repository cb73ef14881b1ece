"""Ways to convert every texel of a map: what each costs and how far it is from single fits; writes the table in docs/exports.md.

    python tools/texture_ways.py
    python tools/texture_ways.py picture     # docs/pictures/texture_patch.svg instead

The map has 64 x 64 texels of a surface that dries, its parameters 3 % noisy as fitted ones are.  Interpolation takes texels that were fitted by the batched
solver as nodes, and draws a plane through the parameters of the sixteen that are nearest.
"""

from __future__ import annotations

import shutil
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

from motes import maps
from motes.exports import texel_surface
from motes.exports.texel_surface import COUNTED, ELSEWHERE, fit_texels, for_directions
from motes.exports.texture_export import export_textures
from motes.fitting.conversion import Conversion, convert, pairs, seen
from motes.maps.simulated import drying_surface
from motes.models import GltfSurface, OpenPBR, OrenNayar, Surface, TorranceSparrow

PAGE = Path(__file__).parent.parent / "docs" / "exports.md"
BEGIN, END = "<!-- ways of conversion: tools/texture_ways.py -->", "<!-- /ways of conversion -->"
SIDE, HOURS, NOISE = 64, 1.5, 0.03
NODES, NEIGHBOURS, RIDGE = (64, 256, 1024), 16, 1e-3
ALONE = 24
MODEL = OrenNayar() + TorranceSparrow()


def cloud() -> dict[str, np.ndarray]:
    """The parameters of the map, texels row by row."""
    y, x = np.meshgrid(*2 * [np.linspace(0, 1, SIDE)], indexing="ij")
    rng = np.random.default_rng(1)
    true = drying_surface(y, x, np.array(HOURS))
    noisy = {name: np.maximum(v * (1 + NOISE * rng.standard_normal(v.shape)), 0.01) for name, v in true.items()}
    return {name: v.reshape(SIDE * SIDE, *v.shape[2:]) for name, v in noisy.items()}


def interpolated(points: np.ndarray, nodes: np.ndarray, found: np.ndarray) -> np.ndarray:
    """Parameters (M, S) at points (M, P): planes through those (N, S) of the nearest nodes (N, P)."""
    distance = np.linalg.norm(points[:, None] - nodes[None], axis=-1)
    nearest = np.argpartition(distance, NEIGHBOURS, axis=1)[:, :NEIGHBOURS]
    off = nodes[nearest] - points[:, None]
    weight = 1 / (np.take_along_axis(distance, nearest, 1) + 1e-3)
    columns = np.concatenate([np.ones((*off.shape[:2], 1)), off], axis=-1)
    normal = np.einsum("mkp,mk,mkq->mpq", columns, weight, columns) + RIDGE * np.eye(columns.shape[-1])
    right = np.einsum("mkp,mk,mks->mps", columns, weight, found[nearest])
    return np.linalg.solve(normal, right)[:, 0]


def ways(kind: type[Surface]) -> list[str]:
    """Rows of the table for one kind of surface."""
    values, text = cloud(), kind.candidates[0]
    count = SIDE * SIDE
    began: list[float] = []
    clock = time.process_time
    batched = fit_texels(MODEL, values, kind, (text,), lambda *_: began.append(clock()))
    each = (began[-1] - began[0]) / (count - texel_surface.TOGETHER)
    chosen = np.random.default_rng(5).choice(count, ALONE, replace=False)
    singles = []
    start = clock()
    for k in chosen:
        exact = MODEL.with_parameters({name: v[k] for name, v in values.items()})
        singles.append((exact, convert(exact, text, loss="cube_root").brdf))
    alone = (clock() - start) / ALONE
    best = np.array([Conversion.between(exact, found.canonical()).seen for exact, found in singles])

    def added(of: dict[str, np.ndarray]) -> np.ndarray:
        own = [kind().with_parameters({name: v[k] for name, v in of.items()}) for k in chosen]
        return np.array([Conversion.between(e, m).seen for (e, _), m in zip(singles, own, strict=True)]) - best

    rows = [
        row(kind, "single fits", alone, 0 * best, best),
        row(kind, "the batched solver", each, added(batched.values), best),
    ]
    points = np.column_stack(list(values.values()))
    points = (points - points.mean(axis=0)) / points.std(axis=0)
    names = [name for name, v in batched.values.items() if np.ptp(v) > 0]
    sizes = [batched.values[name].reshape(count, -1).shape[1] for name in names]
    table = np.concatenate([batched.values[name].reshape(count, -1) for name in names], axis=1)
    others = np.setdiff1d(np.arange(count), chosen)
    for nodes in NODES:
        which = np.random.default_rng(6).choice(others, nodes, replace=False)
        start = clock()
        found = np.concatenate(
            [interpolated(points[k : k + 512], points[which], table[which]) for k in range(0, count, 512)]
        )
        cost = (clock() - start) / count
        between = dict(batched.values)
        for name, part in zip(names, np.split(found, np.cumsum(sizes)[:-1], axis=1), strict=True):
            low, high = next(s.parameter.bounds for s in kind().slots() if s.name == name)
            between[name] = np.clip(part.reshape(batched.values[name].shape), low, high)
        rows.append(row(kind, f"planes between {nodes:,} nodes", cost, added(between), best))
    wi, wo, weights = pairs(*(e for e, _ in singles[:6]), lights=COUNTED[0], viewers=COUNTED[1], shift=ELSEWHERE)
    wanted = MODEL.with_parameters(for_directions(MODEL, values, chosen)).eval(wi, wo)
    counted = seen(batched.model(chosen).eval(wi, wo), wanted, wi, wo, weights)
    exact = added(batched.values) + best
    shares = counted / exact
    print(
        f"{kind.words}: what is counted for all texels is {shares.min():.2f} to {shares.max():.2f} of it",
        file=sys.stderr,
    )
    return rows


def row(kind: type[Surface], words: str, seconds: float, more: Any, best: np.ndarray) -> str:
    """One row."""
    rise = 100 * more / best
    return f"| {kind.words} | {words} | {float(f'{1e3 * seconds:.2g}'):g} ms | {np.median(rise):.1f} % | {np.max(rise):.0f} % |"


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
        "| surface | way | processor time a texel | farther than single fits, median | worst |",
        "|---|---|---|---|---|",
    ]
    lines = [*head, *(line for kind in (OpenPBR, GltfSurface) for line in ways(kind))]
    page = PAGE.read_text(encoding="utf-8")
    before, after = page.partition(BEGIN)[0], page.partition(END)[2]
    PAGE.write_text("\n".join([before + BEGIN, *lines, END]) + after, encoding="utf-8")


if __name__ == "__main__":
    picture() if sys.argv[1:] == ["picture"] else table()
