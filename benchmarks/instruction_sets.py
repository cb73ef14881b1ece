"""The main calls compiled for each level of x86-64 that this processor has, AVX2 and AVX-512, in processes that take turns.

usage: python benchmarks/instruction_sets.py [--effort quick|normal|full] [--json FILE]

With ``--level LEVEL`` it is one of these processes: it prints its seconds as JSON.
"""

from __future__ import annotations

import argparse
import ctypes
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from motes import MotesError
from motes.kernels import engine, machine_code
from results import Effort, Goal, Number, Section, Table, command
from timing import Timing, interleaved

SETS = {"x86-64-v4": "AVX-512", "x86-64-v3": "AVX2"}
LANES = {"x86-64-v4": 16, "x86-64-v3": 8}  # of Dr.Jit
ROWS = {
    "rows32": ("evaluation, float32 (3, N) [M/s]", 1e-6),
    "rows64": ("evaluation, float64 (3, N) [M/s]", 1e-6),
    "gradient": ("gradient by 11 parameters, float32 [M/s]", 1e-6),
    "sample": ("`sample`, a million directions [M/s]", 1e-6),
    "pdf": ("`pdf`, a million directions [M/s]", 1e-6),
    "texels": ("fits of texels, 100 directions x 3 channels [thousands/s]", 1e-3),
    "principled": ("Mitsuba `principled` (LLVM), told the same level [M/s]", 1e-6),
}


def limited(level: str) -> None:
    """Tell Dr.Jit's compiler a level of x86-64, by the function of its core library that Python does not show.

    Raises
    ------
    MotesError
        Where its library has no such function.
    """
    import drjit

    core = next(Path(drjit.__file__).parent.glob("libdrjit-core*"), None)
    try:
        library = ctypes.CDLL(str(core))
        told = library["_Z19jit_llvm_set_targetPKcS0_j"]  # (const char *cpu, const char *features, uint32_t width)
        width = library["_Z21jit_llvm_vector_widthv"]
    except (OSError, AttributeError):
        raise MotesError("this Dr.Jit cannot be told a processor") from None
    told.argtypes, told.restype = [ctypes.c_char_p, ctypes.c_char_p, ctypes.c_uint32], None
    features = [f"+{feature}" for feature in machine_code.features_of(level)]
    told(level.encode(), ",".join(features).encode(), LANES[level])
    if width() != LANES[level]:
        raise MotesError("this Dr.Jit did not take the processor that it was told")


def timed(level: str, effort: Effort) -> dict[str, Any]:
    """Seconds of each call in this process, the first evaluation among them, and what was left out."""
    import rivals
    import roof
    from rivals import SURFACE
    from texel_cases import Case
    from texels import solver

    up = np.array([[0, 0, 1]], np.float32)
    engine.available()  # imports llvmlite, which `starting` measures
    start = time.perf_counter()
    engine.evaluate(SURFACE, up, up)
    first = time.perf_counter() - start
    n, few, texels = effort.pick(20_000, 10_000_000), effort.pick(5_000, 1_000_000), effort.pick(256, 100_000)
    n -= n % roof.LANES
    wi, wo, out = (roof.aligned(3, n) for _ in range(3))
    for k, w in enumerate((wi, wo)):
        w[...] = rivals.directions(n, k + 1)
    doubles = [w.astype(np.float64) for w in (wi, wo, out)]
    pieces = [np.ascontiguousarray(w[:, :few].T) for w in (wi, wo)]
    u = np.random.default_rng(3).random((few, 2), np.float32)
    seed, case, fitter = np.ones((3, n), np.float32), Case.of(texels), solver()
    candidates: dict[str, tuple[Callable[[], Any], float]] = {
        "rows32": (lambda: engine.evaluate(SURFACE, wi.T, wo.T, out=out.T), n),
        "rows64": (lambda: engine.evaluate(SURFACE, doubles[0].T, doubles[1].T, out=doubles[2].T), n),
        "gradient": (lambda: engine.vjp(SURFACE, wi.T, wo.T, seed.T), n),
        "sample": (lambda: engine.sample(SURFACE, pieces[0], u), few),
        "pdf": (lambda: engine.density(SURFACE, *pieces), few),
        "texels": (lambda: fitter.fit(case.noisy, case.starts, own_starts=True), texels),
    }
    skipped = []
    try:
        mi = rivals.mitsuba()
        limited(level)
        si, other = rivals.wavefront(mi, wi, wo)
        candidates["principled"] = (rivals.drjit_call(mi, rivals.bsdfs(mi)["principled"], si, other), n)
    except MotesError as error:
        skipped.append(rivals.skipped("Mitsuba", error))
    timings = interleaved(candidates, effort.pick(1, 3))
    return {"first": first, "timings": {name: asdict(t) for name, t in timings.items()}, "skipped": skipped}


def child(level: str, effort: Effort) -> dict[str, Any]:
    """The same of a process that was told the level, with a cache of its own that is empty."""
    with tempfile.TemporaryDirectory() as folder:
        environment = os.environ | {"MOTES_PROCESSOR": level, "MOTES_CACHE": folder}
        run = [sys.executable, os.path.abspath(__file__), "--level", level, "--effort", effort.name]
        found: dict[str, Any] = json.loads(subprocess.check_output(run, env=environment, text=True).splitlines()[-1])
    return found


def levels() -> list[str]:
    """Those of `SETS` that this processor has."""
    there = machine_code.host_features()
    return [level for level in SETS if there.issuperset(machine_code.features_of(level))]


def instruction_sets(effort: Effort) -> Section:
    """Processes of each level in turn."""
    rounds = effort.pick(1, 3)
    names = levels()
    timings: dict[tuple[str, str], Timing] = {}
    first: dict[str, list[float]] = {level: [] for level in names}
    skipped: list[str] = []
    for _ in range(rounds):
        for level in names:
            found = child(level, effort)
            first[level].append(found["first"])
            skipped += [line for line in found["skipped"] if line not in skipped]
            for name, seconds in found["timings"].items():
                timing = timings.setdefault((level, name), Timing())
                timing.wall += seconds["wall"]
                timing.cpu += seconds["cpu"]
    figures = {"rounds": Number.of([rounds])}
    goals = []
    for level in names:
        label = SETS[level]
        figures[f"{level}_first"] = Number.of(first[level])
        for name, (_, factor) in ROWS.items():
            if (level, name) in timings:
                figures[f"{level}_{name}"] = timings[level, name].rate.times(factor)
                figures[f"{level}_{name}_cpu"] = timings[level, name].processor.times(1e9)
        goals.append(
            Goal(f"float64 (3, N), {label}", f"{level}_rows64", {"AVX2": 120, "AVX-512": 160}[label], unit=" M/s")
        )
        if (level, "principled") in timings:
            figures[f"{level}_over"] = timings[level, "rows32"].faster_than(timings[level, "principled"])
            figures[f"{level}_over_cpu"] = timings[level, "rows32"].cheaper_than(timings[level, "principled"])
            goals.append(Goal(f"float32 (3, N) over `principled`, {label}", f"{level}_over", 1.0, unit=" x"))
    return report(names, figures, goals, skipped)


def report(names: list[str], figures: dict[str, Number], goals: list[Goal], skipped: list[str]) -> Section:
    """The figures, and what they say."""
    rows = [
        [label, *(f"{{{level}_{name}}}" for level in names), *(f"{{{level}_{name}_cpu}}" for level in names)]
        for name, (label, _) in ROWS.items()
        if all(f"{level}_{name}" in figures for level in names)
    ]
    rows.append(
        ["first evaluation, nothing cached [s]", *(f"{{{level}_first}}" for level in names), *("" for _ in names)]
    )
    reading = [
        f"Compiled for `{level}` the engine evaluates {{{level}_over}} times as fast as Mitsuba its `principled` ({{{level}_over_cpu}} by processor time)."
        for level in names
        if f"{level}_over" in figures
    ]
    if not names:
        skipped = ["This processor has neither AVX2 nor AVX-512.", *skipped]
    labels = [SETS[level] for level in names]
    return Section(
        title="Both instruction sets",
        made_by="benchmarks/instruction_sets.py, instruction_sets()",
        intro=(
            "The dusty RGB surface and fits of texels, compiled for AVX-512 (`MOTES_PROCESSOR=x86-64-v4`) and for AVX2 (`x86-64-v3`) on the same "
            "processor, in processes that take turns, {rounds:count} of each with an empty cache; medians of all their rounds. Mitsuba's compiler was told the "
            "same level."
        ),
        figures=figures,
        tables=[Table(["", *labels, *(f"{label}, ns of processor each" for label in labels)], rows)],
        goals=goals,
        reading=reading,
        skipped=skipped,
    )


def main() -> None:
    if "--level" not in sys.argv:
        command(instruction_sets, __doc__)
        return
    parser = argparse.ArgumentParser()
    parser.add_argument("--level", choices=SETS)
    parser.add_argument("--effort")
    given = parser.parse_args()
    print(json.dumps(timed(given.level, Effort(given.effort))))


if __name__ == "__main__":
    main()
