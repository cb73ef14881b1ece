"""One state of Motes, timed by what every state has: `before.py` runs this for the first version and for today's, in turn.

usage: python benchmarks/before_rows.py ROOT PART [--quick] [--level LEVEL] [--folder FOLDER]

ROOT is the repository of that state, whose own cases are measured (`texel_cases.py` and `rivals.py` beside it); clocks are those of this folder for all.
It prints JSON: by name the seconds of an item, by the clock and of processor time, or what else the name says.
"""

from __future__ import annotations

import argparse
import inspect
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import numpy as np

import places
import results  # noqa: F401, before the other state's is found
from timing import interleaved

Found = dict[str, list[float]]  # wall and processor seconds
MODEL = "oren_nayar + torrance_sparrow"
SIZES = (300, 10_000, 100_000, 1_000_000)
GROWTH = (5_000, 50_000)
ALONE = "motes_dusty over principled"


def engine() -> Any:
    """The module that evaluates; it has moved since."""
    try:
        from motes.kernels import engine as found
    except ImportError:
        from motes import engine as found  # type: ignore[no-redef]
    return found


def medians(candidates: dict[str, tuple[Callable[[], Any], float]], rounds: int, **options: Any) -> Found:
    """Wall and processor seconds of an item of each, in turn."""
    timings = interleaved(candidates, rounds, **options)
    return {name: [t.seconds.median, t.processor.median] for name, t in timings.items()}


# ---------------------------------------------------------------- parts


def values(quick: bool) -> Found:
    """The dusty RGB surface: many directions, few, and the memory's roof."""
    import roof
    from rivals import SURFACE, directions

    n, few = (20_000, 5_000) if quick else (10_000_000, 1_000_000)
    n -= n % roof.LANES
    wi, wo, out = (roof.aligned(3, n) for _ in range(3))
    for k, w in enumerate((wi, wo)):
        w[...] = directions(n, k + 1)
    doubles = [w.astype(np.float64) for w in (wi, wo, out)]
    pieces = [np.ascontiguousarray(w[:, :few].T) for w in (wi, wo)]
    small = {count: [np.ascontiguousarray(w[:, :count].T) for w in (wi, wo)] for count in (1, 1000)}
    u, seed = np.random.default_rng(3).random((few, 2), np.float32), np.ones((3, n), np.float32)
    call = engine()
    candidates: dict[str, tuple[Callable[[], Any], float]] = {
        "roof": (lambda: roof.stream(wi, wo, out), n),
        "rows32": (lambda: call.evaluate(SURFACE, wi.T, wo.T, out=out.T), n),
        "new": (lambda: call.evaluate(SURFACE, wi.T, wo.T), n),
        "rows64": (lambda: call.evaluate(SURFACE, doubles[0].T, doubles[1].T, out=doubles[2].T), n),
        "gradient": (lambda: call.vjp(SURFACE, wi.T, wo.T, seed.T), n),
        "sample": (lambda: SURFACE.sample(pieces[0], u), few),
        "pdf": (lambda: SURFACE.pdf(*pieces), few),
        "eval_1": (lambda: SURFACE.eval(*small[1]), 1),
        "eval_1000": (lambda: SURFACE.eval(*small[1000]), 1),
    }
    return medians(candidates, 1 if quick else 3, in_a_loop=("new",))


def principled(quick: bool, level: str) -> Found:
    """Mitsuba's `principled`, told a level of x86-64; the same whatever the state of Motes is."""
    import instruction_sets
    import rivals
    import roof

    n = 20_000 if quick else 10_000_000
    wi, wo = (np.ascontiguousarray(rivals.directions(n - n % roof.LANES, k)) for k in (1, 2))
    mi = rivals.mitsuba()
    instruction_sets.limited(level)
    call = rivals.drjit_call(mi, rivals.bsdfs(mi)["principled"], *rivals.wavefront(mi, wi, wo))
    return medians({"principled": (call, wi.shape[1])}, 1 if quick else 3)


def texels(quick: bool) -> Found:
    """Fits of many texels, at one time and under trends."""
    from texel_cases import Case, Series
    from texels import solver

    counts = (128, 256) if quick else GROWTH
    case, fitter, series = Case.of(counts[-1]), solver(), Series.of(64 if quick else 3_000)
    candidates: dict[str, tuple[Callable[[], Any], float]] = {
        f"texels_{name}": (lambda n=n: fitter.fit(case.noisy[:n], case.starts[:n], own_starts=True), n)
        for name, n in zip(("few", "many"), counts, strict=True)
    }
    candidates["trends"] = (
        lambda: series.solver.fit(series.values, series.starts, own_starts=True),
        len(series.starts),
    )
    return medians(candidates, 1 if quick else 3)


def whole_map(quick: bool) -> Found:
    """A map end to end from its first block on, and its fits alone."""
    from motes import maps
    from motes.maps.work import read_block

    size, times = (16, 2) if quick else (256, 8)
    with places.fresh() as folder:
        source = maps.simulate_map(folder / "map.zarr", (size, size), times=times, lights=12)
        fitted = maps.fit_map(source.path, MODEL, out=folder / "fit.zarr")  # compiles, finds starts
        rows = np.concatenate([_values(read_block(fitted, block)) for block in fitted.blocks])
        solver, starts = fitted.plan.solver, fitted.plan.starts
        found: dict[str, list[list[float]]] = {"map": [], "solver": []}
        for k in range(1 if quick else 3):
            found["map"].append(_from_first_block(source.path, folder / f"map-{k}.zarr") / len(rows))
            began = _now()
            solver.fit(rows, starts)
            found["solver"].append((_now() - began) / len(rows))
        return {name: list(map(float, np.median(taken, axis=0))) for name, taken in found.items()}


def losses(quick: bool) -> Found:
    """Maps under the losses; the first version's `log` and `cube_root` are so slow that few texels must do."""
    from motes import maps

    asked = {"linear": {}, "log": {"loss": "log"}, "cube_root": {"loss": "cube_root"}} | {
        name: {"robust": name} for name in ("soft_l1", "huber", "cauchy")
    }
    compiled = "robust" in inspect.signature(maps.fit_map).parameters
    found: Found = {}
    with places.fresh() as folder:
        large, small = ((16, 16), 1) if quick else ((96, 96), 4), ((6, 6), 1)
        for name, options in asked.items():
            if "robust" in options and not compiled:
                continue
            many = compiled or name == "linear"
            size, times = large if many else small
            source = folder / f"{size[0]}.zarr"
            if not source.exists():
                maps.simulate_map(source, size, times=times, lights=12)
            count = size[0] * size[1] * times
            taken = [
                _from_first_block(source, folder / f"{name}-{k}.zarr", **options) / count
                for k in range(1 if quick else 3)
            ]
            found[f"loss_{name}"] = list(map(float, np.median(taken[1:] or taken, axis=0)))  # the first compiles
    return found


def single(quick: bool) -> Found:
    """`motes.fit` to measurements that it has not seen before."""
    import warnings

    import motes
    from fits import simulated

    found: Found = {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for n in SIZES[: 1 if quick else None]:
            motes.fit(simulated(n // 3, 3), MODEL)
            taken = []
            for data in [simulated(n // 3, 3) for _ in range(1 if quick else 3 if n > SIZES[-2] else 7)]:
                began = _now()
                motes.fit(data, MODEL)
                taken.append(_now() - began)
            found[f"fit_{n}"] = list(map(float, np.median(taken, axis=0)))
    return found


def first_use(quick: bool) -> Found:
    """Whole processes with an empty cache: one evaluation, one small map."""
    from motes import maps

    evaluation = (
        "import numpy as np\nfrom rivals import SURFACE\ntry:\n from motes.kernels import engine\n"
        "except ImportError:\n from motes import engine\n"
        "up = np.array([[0, 0, 1]], np.float32)\nengine.evaluate(SURFACE, up, up)"
    )
    fit = f"import sys\nfrom motes.maps import fit_map\nfit_map(sys.argv[1], {MODEL!r}, out=sys.argv[2])"
    found: Found = {}
    with places.fresh() as folder:
        source = maps.simulate_map(folder / "map.zarr", (16, 16), times=2, lights=12)
        for name, code in (("first_value", evaluation), ("first_map", fit)):
            taken = []
            for k in range(1 if quick else 3):
                with tempfile.TemporaryDirectory() as cache:
                    environment = _environment() | {"MOTES_CACHE": cache}
                    environment.pop("PYTHONDONTWRITEBYTECODE", None)  # users have compiled modules
                    run = [sys.executable, "-c", code, str(source.path), str(folder / f"{name}-{k}.zarr")]
                    times, wall = os.times(), time.perf_counter()
                    subprocess.run(run, env=environment, check=True, capture_output=True)
                    wall, after = time.perf_counter() - wall, os.times()
                    used = sum(after[2:4]) - sum(times[2:4])
                    taken.append([wall, used])
            found[name] = list(map(float, np.median(taken, axis=0)))
    return found


def workers(quick: bool) -> Found:
    """A map by one Dask worker of one thread and by two, kernels loaded; each fills a store of its own."""
    from motes import maps
    from motes.maps import cluster
    from motes.maps.fitted import open_fitted

    size, times, chunk = (32, 1, 16) if quick else (512, 4, 64)
    found: Found = {}
    with places.fresh() as folder:
        source = maps.simulate_map(folder / "map.zarr", (size, size), times=times, chunk=chunk)
        fitted = maps.fit_map(source.path, MODEL, out=folder / "fit.zarr")
        blocks = list(fitted.blocks)
        for n in (1, 2):
            with ExitStack() as alive:
                client = cluster._client(alive, None, n)
                taken = []
                for k in range(2 if quick else 3):
                    store = open_fitted(places.emptied(fitted.path, folder / f"{n}-{k}.zarr"), mode="r+")
                    began = _now()
                    ended = list(cluster.windowed(client, store, blocks, "the benchmark"))
                    taken.append((_now() - began) / (size * size * times))
                    assert len(ended) == len(blocks)
                found[f"workers_{n}"] = list(map(float, np.median(taken[1:], axis=0)))
    return found


def render(quick: bool) -> Found:
    """What dust costs over another BSDF in Mitsuba, as the state's own `render.py` says: quotients to the BSDF alone, by the clock and by processor time."""
    script = Path(sys.path[0]) / "render.py"
    options = ["--only", "speed", "--rounds", "1" if quick else "7"]
    text = subprocess.run(
        [sys.executable, str(script), *options], capture_output=True, text=True, check=True, env=_environment()
    ).stdout
    row = re.search(rf"^\| {re.escape(ALONE)} \|[^|]*\|([^|]*)\|([^|]*)\|$", text, re.MULTILINE)
    return {"render": [float(row[1]), float(row[2])] if row else [float("nan")] * 2}


def pages(folder: Path) -> dict[str, str]:
    """Pages of the viewer that the state writes; `before.py` opens them in a browser."""
    from motes import Dust, DustLayer, OrenNayar, TorranceSparrow, view

    rock = OrenNayar((0.8, 0.55, 0.35), 0.4) + TorranceSparrow(0.3, 0.15)
    models = {"rock": rock, "single": DustLayer(rock, Dust((0.9, 0.8, 0.7), 0.3), 0.2)}
    return {name: str(view(model).save(folder / f"{name}.html")) for name, model in models.items()}


# ---------------------------------------------------------------- helpers


def _environment() -> dict[str, str]:
    """The state's modules for a child."""
    return os.environ | {"PYTHONPATH": os.pathsep.join(sys.path[:2])}


def _now() -> np.ndarray:
    """Wall and processor seconds."""
    return np.array([time.perf_counter(), time.process_time()])


def _values(block: Any) -> np.ndarray:
    """Rows of texels of what a state's `read_block` returns."""
    values = np.asarray(block)
    return values.reshape(-1, *values.shape[-2:])


def _from_first_block(source: Any, out: Path, **options: Any) -> np.ndarray:
    """Seconds of a map's fit after settings and starts."""
    from motes import maps

    first: list[np.ndarray] = []

    def progress(done: int, total: int, what: str) -> None:
        if what == "fitting" and not first:
            first.append(_now())

    maps.fit_map(source, MODEL, out=out, progress=progress, **options)
    return np.asarray(_now() - first[0])


PARTS: dict[str, Callable[[bool], Any]] = {
    "values": values,
    "texels": texels,
    "whole_map": whole_map,
    "losses": losses,
    "single": single,
    "first_use": first_use,
    "workers": workers,
    "render": render,
}


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=Path)
    parser.add_argument("part", choices=[*PARTS, "principled", "pages"])
    parser.add_argument("--level", default="")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--folder", type=Path, help="where pages are written")
    given = parser.parse_args()
    sys.path[:0] = [str(given.root / "benchmarks"), str(given.root / "src")]
    if given.part == "principled":
        print(json.dumps(principled(given.quick, given.level)))
    elif given.part == "pages":
        print(json.dumps(pages(given.folder)))
    else:
        print(json.dumps(PARTS[given.part](given.quick)))


if __name__ == "__main__":
    main()
