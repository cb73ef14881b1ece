"""What is paid before any work is done: starting, the first call, one direction.

usage: python benchmarks/starting.py [--effort quick|normal|full] [--json FILE]
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import rivals
from motes.kernels import engine
from results import Effort, Goal, Number, Section, Table, command
from rivals import SURFACE
from timing import Timing, interleaved

COMMANDS = {
    "python": ["-c", "pass"],
    "numpy": ["-c", "import numpy"],
    "motes": ["-c", "import motes"],
    "help": ["-m", "motes.cli.main", "--help"],
    "llvmlite": ["-c", "import llvmlite.binding"],
}
LABELS = {
    "python": "Python alone",
    "numpy": "`import numpy`",
    "motes": "`import motes`",
    "help": "`motes --help`",
    "llvmlite": "`import llvmlite.binding`, which the first compiled call needs",
}
FIRST_CALL = """
import time
import llvmlite.binding
import numpy as np
from motes.kernels import engine
from rivals import SURFACE  # beside this file
up = np.array([[0, 0, 1]], np.float32)
start = time.perf_counter()
engine.evaluate(SURFACE, up, up)
print(time.perf_counter() - start)
"""
COUNTS = (1, 100, 1_000, 10_000)
CALLS = {
    "eval": "`model.eval`",
    "eval64": "`model.eval`, float64",
    "engine": "`engine.evaluate`",
    "vjp": "`engine.vjp`",
    "numpy": "the equations over NumPy, nothing around them",
}


def starts(rounds: int, warm: bool) -> dict[str, Timing]:
    """Seconds of processes that start, do one thing and end."""
    command_line = Path(sys.executable).with_name("motes")
    found: dict[str, tuple[Callable[[], Any], float]] = {}
    for name, arguments in COMMANDS.items():
        run = [sys.executable, *arguments]
        if name == "help" and command_line.exists():
            run = [str(command_line), "--help"]
        found[name] = (lambda run=run: subprocess.run(run, check=True, capture_output=True), 1)
    return interleaved(found, rounds, warm=warm)


def first_calls(rounds: int) -> tuple[Number, Number]:
    """Seconds of the first evaluation with an empty cache folder, and of the first one of the next process."""
    here = os.path.dirname(os.path.abspath(__file__))
    cold, warm = [], []
    for _ in range(rounds):
        with tempfile.TemporaryDirectory() as folder:
            environment = os.environ | {"MOTES_CACHE": folder, "PYTHONPATH": here}
            run = [sys.executable, "-c", FIRST_CALL]
            for seconds in (cold, warm):
                seconds.append(float(subprocess.check_output(run, env=environment, text=True)))
    return Number.of(cold), Number.of(warm)


def calls(effort: Effort) -> dict[str, Timing]:
    """Seconds of one call at few directions, by ``NAME_N``."""
    candidates: dict[str, tuple[Callable[[], Any], float]] = {}
    for n in COUNTS:
        wi, wo = (np.ascontiguousarray(rivals.directions(n, seed).T) for seed in (1, 2))
        seed = np.ones((n, 3), np.float32)
        doubles = [w.astype(np.float64) for w in (wi, wo)]
        candidates |= {
            f"eval_{n}": (lambda wi=wi, wo=wo: SURFACE.eval(wi, wo), 1),
            f"eval64_{n}": (lambda doubles=doubles: SURFACE.eval(*doubles), 1),
            f"engine_{n}": (lambda wi=wi, wo=wo: engine.evaluate(SURFACE, wi, wo), 1),
            f"vjp_{n}": (lambda wi=wi, wo=wo, seed=seed: engine.vjp(SURFACE, wi, wo, seed), 1),
            f"numpy_{n}": (lambda wi=wi, wo=wo: rivals.plain_numpy(wi, wo), 1),
        }
    return interleaved(candidates, effort.pick(3, 15))


def starting(effort: Effort) -> Section:
    """Processes, first calls, and calls at few directions."""
    rounds = effort.pick(1, 7)
    processes, small = starts(rounds, effort.name != "quick"), calls(effort)
    cold, warm = first_calls(effort.pick(1, 3))
    figures = {"rounds": Number.of([rounds]), "cold": cold, "warm": warm}
    for name, timing in processes.items():
        figures[f"start_{name}"] = timing.seconds
        figures[f"start_{name}_ratio"] = processes["python"].faster_than(timing)
    extra = np.array(processes["motes"].wall) - np.array(processes["python"].wall)
    figures["import_motes"] = Number.of(extra)
    for name, timing in small.items():
        count = name.rsplit("_", 1)[1]
        figures[name] = timing.seconds.times(1e6)
        figures[f"{name}_over_numpy"] = small[f"numpy_{count}"].faster_than(timing)
    return Section(
        title="Starting, and small calls",
        made_by="benchmarks/starting.py, starting(), first_calls() and calls()",
        intro="Whole processes from start to end, {rounds:count} rounds in turn; then one call of the dusty RGB surface at few directions.",
        figures=figures,
        tables=[
            Table(
                ["", "s", "x Python alone"],
                [[label, f"{{start_{name}}}", f"{{start_{name}_ratio}}"] for name, label in LABELS.items()],
            ),
            Table(
                ["one call at N directions [µs]", *(f"N = {n:,}" for n in COUNTS), "x the equations, N = 1"],
                [
                    [label, *(f"{{{name}_{n}}}" for n in COUNTS), f"{{{name}_1_over_numpy}}"]
                    for name, label in CALLS.items()
                ],
            ),
        ],
        goals=[
            Goal("`model.eval` at one direction", "eval_1", 50, at_least=False, unit=" µs"),
            Goal("`model.eval` at 1,000 directions", "eval_1000", 100, at_least=False, unit=" µs"),
        ],
        reading=[
            "`import motes` adds {import_motes} s to Python's own start.",
            "The first compiled evaluation takes {cold} s where nothing is cached, {warm} s in the next process.",
            "At one direction `model.eval` costs {eval_1:bare} µs, {eval_1_over_numpy:bare} times the bare equations, "
            "and a call of the engine {engine_1:bare} µs.",
        ],
    )


if __name__ == "__main__":
    command(starting, __doc__)
