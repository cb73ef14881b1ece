"""A map end to end, read from the disk and written to it, beside the solver on the same texels in memory.

usage: python benchmarks/map_fits.py [--effort quick|normal|full] [--json FILE]
"""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import numpy as np

import places
from motes import maps
from motes.maps.fitted import open_fitted
from motes.maps.work import fit_block, read_block
from results import Effort, Goal, Number, Section, Table, command

MODEL = "oren_nayar + torrance_sparrow"
LIGHTS = 12  # two views of every light
GOAL = 0.7
LABELS = {
    "solver": "the solver, on all texels in one call",
    "blocks": "the solver, block by block",
    "read": "reading the blocks, nothing else",
    "write": "writing them, nothing else",
    "map": "`motes.maps.fit_map`, from its first block to its last",
    "start": "`motes.maps.fit_map`, before its first block: settings, starts, the empty store",
}


class Clock:
    """Wall and processor seconds of calls, by name."""

    def __init__(self) -> None:
        self.wall: dict[str, list[float]] = {}
        self.cpu: dict[str, list[float]] = {}

    def add(self, name: str, began: tuple[float, float]) -> None:
        """What has passed since a time."""
        wall, cpu = now()
        self.wall.setdefault(name, []).append(wall - began[0])
        self.cpu.setdefault(name, []).append(cpu - began[1])


def now() -> tuple[float, float]:
    """Wall and processor time [s]."""
    return time.perf_counter(), time.process_time()


def rounds_of(source: Path, folder: Path, rounds: int) -> tuple[Clock, int]:
    """All parts in turn; seconds of each, and the number of fits.  What was written stays: see `places`."""
    fitted = maps.fit_map(source, MODEL, out=folder / "fit.zarr")  # compiles, and finds starts
    stack, plan, blocks = fitted.plan.stack, fitted.plan, list(fitted.blocks)
    clock = Clock()
    for k in range(rounds):
        began = now()
        values: list[Any] = [read_block(fitted, block) for block in blocks]
        clock.add("read", began)
        began = now()
        fits = [fit_block(fitted, block) for block in values]
        clock.add("blocks", began)
        rows = np.concatenate([block.reshape(-1, *stack.sizes[1:]) for block in values])
        del values
        began = now()
        plan.solver.fit(rows, plan.starts)
        clock.add("solver", began)
        count = len(rows)
        del rows
        empty = open_fitted(places.emptied(fitted.path, folder / f"empty-{k}.zarr"), mode="r+")
        began = now()
        for block, fit in zip(blocks, fits, strict=True):
            empty.write(block, fit)
        clock.add("write", began)
        del fits
        first: list[tuple[float, float]] = []

        def progress(done: int, total: int, what: str, first: list[tuple[float, float]] = first) -> None:
            if what == "fitting" and not first:
                first.append(now())

        began = now()
        maps.fit_map(source, MODEL, out=folder / f"map-{k}.zarr", progress=progress)
        clock.add("map", first[0])
        clock.wall.setdefault("start", []).append(first[0][0] - began[0])
        clock.cpu.setdefault("start", []).append(first[0][1] - began[1])
    return clock, count


def map_fits(effort: Effort) -> Section:
    """A map and the solver in turn."""
    size, times, rounds = effort.pick((16, 2, 1), (256, 8, 7))
    with places.fresh() as folder:
        source = maps.simulate_map(folder / "map.zarr", (size, size), times=times, lights=LIGHTS)
        clock, fits = rounds_of(source.path, folder, rounds)
        a_file = places.a_file(folder)
    figures = {
        "size": Number.of([size]),
        "times": Number.of([times]),
        "fits": Number.of([fits]),
        "rounds": Number.of([rounds]),
        "a_file": Number.of([a_file]),
    }
    for name in LABELS:
        wall, cpu = np.array(clock.wall[name]), np.array(clock.cpu[name])
        figures |= {
            f"{name}_rate": Number.of(fits / wall),
            f"{name}_cpu": Number.of(1e6 * cpu / fits),
            f"{name}_busy": Number.of(cpu / wall),
            f"{name}_share": Number.of(np.array(clock.cpu["solver"]) / cpu),
        }
    figures["end"] = figures["map_share"]
    figures["end_wall"] = Number.of(np.array(clock.wall["solver"]) / np.array(clock.wall["map"]))
    rows = [
        [label, f"{{{name}_rate}}", f"{{{name}_cpu}}", f"{{{name}_share}}", f"{{{name}_busy:bare}}"]
        for name, label in LABELS.items()
    ]
    return Section(
        title="Maps end to end",
        made_by="benchmarks/map_fits.py, map_fits()",
        intro=(
            f"A simulated map of {{size:count}} x {{size:count}} texels, {{times:count}} times x {2 * LIGHTS} pairs of directions x 3 channels, "
            f"{{fits:count}} fits of `{MODEL}`: the solver on what is in memory, and `fit_map`, which reads blocks from a Zarr store and "
            "writes the fits to another; {rounds:count} rounds in turn."
        ),
        figures=figures,
        tables=[
            Table(
                ["", "fits/s, wall", "µs of processor a fit", "of the solver's rate, by processor", "processors busy"],
                rows,
            )
        ],
        goals=[Goal("a map, reading and writing included, over the solver, by processor time", "end", GOAL, unit=" x")],
        reading=[
            "Reading and writing included a map goes at {end} times the rate of its fits by processor time, at {end_wall} by wall time.",
            "An empty file takes {a_file:bare} µs of processor time there. Where many files were deleted shortly before, some disks take up to a "
            "millisecond for each, and a block is written to some twenty: here all is written to a folder of its own, and stays until the end.",
        ],
    )


if __name__ == "__main__":
    command(map_fits, __doc__)
