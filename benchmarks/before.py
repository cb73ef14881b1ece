"""The first version of Motes and today's in one run, in turn, under both instruction sets: writes docs/before.md.

usage: python benchmarks/before.py [--rounds 2] [--folder out/before] [--page-only] [-o docs/before.md]

The first version comes out of the repository's history; Numba, which compiled it, must be installed (``pip install numba``).  Every measurement is a
process of its own, that of one version right after that of the other, and the next round begins with the other one.  What was found stays in the folder as
JSON; ``--page-only`` writes the page from it again.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from math import log
from pathlib import Path
from typing import Any

import instruction_sets
import machine
from before_rows import GROWTH, PARTS
from motes import MotesError
from motes.files import write_text
from motes.kernels import machine_code
from page import section_lines, table_lines, wrapped
from results import Number, Section, Table
from run import Meter

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
FIRST = "8b2a6d6"  # the commit
STATES = ("first", "today")
AS_IT_IS, AVX2 = "x86-64-v4", "x86-64-v3"
# Compiled code decides in these; the others are measured as the processor is.
COMPILED = ("values", "texels", "whole_map", "losses", "first_use")
Seconds = Mapping[str, list[float]]  # of one version in one round: by the clock and of processor time


@dataclass(frozen=True)
class Row:
    """A line of the tables: how its figure comes out of seconds, and the goal that was set for it."""

    label: str
    figure: Callable[[Seconds], float]
    goal: str = ""
    name: str = ""  # whose seconds are compared; a quotient has none

    def of(self, seconds: Seconds) -> float | None:
        """The figure, or None where something that it needs was not measured."""
        try:
            return self.figure(seconds)
        except KeyError:
            return None


def rate(label: str, name: str, factor: float, goal: str = "") -> Row:
    """Items a second by the clock."""
    return Row(label, lambda s: factor / s[name][0], goal, name)


def duration(label: str, name: str, factor: float, goal: str = "") -> Row:
    """Seconds by the clock in another unit."""
    return Row(label, lambda s: factor * s[name][0], goal, name)


def quotient(label: str, over: str, under: str, goal: str = "", clock: int = 0) -> Row:
    """One's seconds over another's, by the clock or of processor time."""
    return Row(label, lambda s: s[over][clock] / s[under][clock], goal)


def exponent(seconds: Seconds) -> float:
    """Of the growth of processor time with the number of texels."""
    few, many = (seconds[f"texels_{name}"][1] for name in ("few", "many"))
    return 1 + log(many / few) / log(GROWTH[1] / GROWTH[0])


ROWS = [
    rate("fits of texels, 6 parameters, 100 directions x 3 channels [M/s]", "texels_many", 1e-6, "2"),
    rate("the same, 12 times together under trends [thousands/s]", "trends", 1e-3, "243"),
    rate("`fit_map`, reading and writing included [thousands/s]", "map", 1e-3),
    quotient("`fit_map` over its fits alone, by processor time", "solver", "map", "≥ 0.7", clock=1),
    *(
        duration(f"a map's fit under `{name}`, reading and writing included [µs]", f"loss_{name}", 1e6)
        for name in ("linear", "log", "cube_root", "soft_l1", "huber", "cauchy")
    ),
    *(
        quotient(
            f"`{name}` over `linear`, reading and writing included, by processor time",
            f"loss_{name}",
            "loss_linear",
            "≤ 4",
            clock=1,
        )
        for name in ("log", "cube_root", "soft_l1", "huber", "cauchy")
    ),
    Row(f"exponent of growth, {GROWTH[0]:,} to {GROWTH[1]:,} texels", exponent, "≤ 1.02"),
    rate("`model.sample` [M/s]", "sample", 1e-6, "60"),
    rate("`model.pdf` [M/s]", "pdf", 1e-6, "200"),
    duration("`model.eval` of one direction [µs]", "eval_1", 1e6, "≤ 50"),
    duration("`model.eval` of 1,000 directions [µs]", "eval_1000", 1e6, "≤ 100"),
    rate("evaluation, float32 (3, N), 10 million directions [M/s]", "rows32", 1e-6),
    quotient("the same over stores past the caches", "roof", "rows32", "≥ 0.45"),
    quotient("the same over Mitsuba's `principled`", "principled", "rows32", "≥ 1"),
    quotient("the same into a new array, over one used before", "rows32", "new", "≥ 0.9"),
    rate("evaluation, float64 (3, N) [M/s]", "rows64", 1e-6, "160 (AVX-512), 120 (AVX2)"),
    rate("gradient by 11 parameters, float32 [M/s]", "gradient", 1e-6),
    duration("the first evaluation, nothing cached, a whole process [s]", "first_value", 1),
    duration("the first fit of a map, the model given, nothing cached, a whole process [s]", "first_map", 1, "≤ 1.5"),
    duration("`motes.fit`, 300 values [ms]", "fit_300", 1e3, "≤ 8"),
    *(
        duration(f"`motes.fit`, {n:,} values [ms]", f"fit_{n}", 1e3, "5 x as fast")
        for n in (10_000, 100_000, 1_000_000)
    ),
    Row("efficiency from one to two Dask workers", lambda s: s["workers_1"][0] / (2 * s["workers_2"][0]), "≥ 0.9"),
    Row("Mitsuba: dust over `principled`, x `principled` alone", lambda s: s["render"][0], "≤ 1.15"),
    *(
        Row(f"viewer, {what}: {label}", lambda s, key=f"{name}_{key}": s[key][0], goal)  # type: ignore[misc]
        for name, what in (("rock", "diffuse with a highlight"), ("single", "under dust"))
        for key, label, goal in (
            ("first", "first picture [s]", "≤ 0.5"),
            ("frames", "frames a second while it turns, 30 at most", "20"),
            ("finished", "finished at 1440 x 900 [s]", "≤ 30"),
        )
    ),
]


# ---------------------------------------------------------------- measuring


def first_version(folder: Path) -> Path:
    """The first version's files.

    Raises
    ------
    MotesError
        Where the history or Numba is missing.
    """
    if find_spec("numba") is None:
        raise MotesError("the first version needs Numba", "Install it: pip install numba")
    root = folder / FIRST
    if not root.exists():
        packed = subprocess.run(["git", "-C", str(ROOT), "archive", FIRST], capture_output=True, check=False)
        if packed.returncode != 0:
            raise MotesError(f"the history does not hold commit {FIRST}", "Fetch it: git fetch --unshallow")
        with tempfile.TemporaryDirectory(dir=folder) as unpacked:  # there whole or not at all
            subprocess.run(["tar", "-x", "-C", unpacked], input=packed.stdout, check=True)
            Path(unpacked).rename(root)
            Path(unpacked).mkdir()  # which is removed
    return root


def environment(state: str, level: str, folder: Path) -> dict[str, str]:
    """For a process of a version: a cache of its own, and the instruction set where it is not the processor's own."""
    cache = folder / f"cache-{state}-{level}"
    given = os.environ | {"MOTES_CACHE": str(cache)}
    if level == AVX2:
        features = ",".join(f"+{name}" for name in machine_code.features_of(AVX2))
        given |= {"MOTES_PROCESSOR": AVX2, "NUMBA_CPU_NAME": AVX2, "NUMBA_CPU_FEATURES": features}
    return given


def child(root: Path, part: str, environment: dict[str, str], *options: str) -> dict[str, Any]:
    """What a process of a version prints; nothing where it fails, which is said."""
    run = [sys.executable, str(HERE / "before_rows.py"), str(root), part, *options]
    done = subprocess.run(run, env=environment, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(f"  {part} of {root.name} failed: {(done.stderr.strip().splitlines() or ['?'])[-1][:200]}", flush=True)
        return {}
    return dict(json.loads(done.stdout.splitlines()[-1]))


def viewed(root: Path, environment: dict[str, str], number: int) -> dict[str, list[float]]:
    """Figures of a version's pages in a browser; the finished picture in the first round alone, as it is the same work each time."""
    import viewer

    found: dict[str, list[float]] = {}
    with tempfile.TemporaryDirectory() as folder, viewer.driver() as playwright:
        for name, page in child(root, "pages", environment, "--folder", folder).items():
            with viewer.browser(playwright) as running:
                first, frames = viewer.moving(running, Path(page), viewer.SQUARE, 4.0, viewer.SETTLED)
                found |= {f"{name}_first": [first], f"{name}_frames": [frames]}
                if number == 0:
                    found[f"{name}_finished"] = [viewer.finished(running, Path(page), viewer.PAGE)]
    return found


def measured(folder: Path, rounds: int, quick: bool = False) -> Iterator[dict[str, Any]]:
    """Both versions in turn; after each part all that was found so far, by round, instruction set and version."""
    roots = {"first": first_version(folder), "today": ROOT}
    options = ["--quick"] * quick
    levels = instruction_sets.levels() or [AS_IT_IS]
    where = machine.description() | {"Numba": machine.version("numba")}
    meter, found = Meter(), []
    for number in range(rounds):
        order = STATES if number % 2 == 0 else STATES[::-1]
        seen: dict[tuple[str, str], dict[str, Any]] = {(level, state): {} for level in levels for state in STATES}
        found += [{"level": level, "state": state, "seconds": s} for (level, state), s in seen.items()]
        for level, part in asked(levels, quick):
            began = time.perf_counter()
            if part == "principled":
                other = child(ROOT, part, environment("today", level, folder), "--level", level, *options)
                for state in STATES:
                    seen[level, state] |= other
            else:
                for state in order:
                    own = environment(state, level, folder)
                    if part == "viewer":
                        seen[level, state] |= viewed(roots[state], own, number)
                    else:
                        seen[level, state] |= child(roots[state], part, own, *options)
            print(f"round {number + 1}, {level}, {part}: {time.perf_counter() - began:.0f} s", flush=True)
            seconds, others = meter.others()
            done = {"rounds": number + 1, "machine": where, "seconds": seconds, "others": others, "levels": levels}
            yield done | {"found": found}


def asked(levels: Sequence[str], quick: bool) -> list[tuple[str, str]]:
    """Instruction sets and parts of a round."""
    parts = ["principled", *PARTS, *(["viewer"] if not quick else [])]
    return [
        (level, part)
        for level in levels
        for part in parts
        if level == levels[0] or part in COMPILED or part == "principled"
    ]


# ---------------------------------------------------------------- the page


def section(data: Mapping[str, Any], level: str) -> Section:
    """The table of one instruction set: figures of both versions, and their quotients round by round."""
    by = {
        state: [f["seconds"] for f in data["found"] if (f["level"], f["state"]) == (level, state)] for state in STATES
    }
    figures: dict[str, Number] = {}
    rows = []
    for k, row in enumerate(ROWS):
        cells = {}
        for state in STATES:
            known = [x for x in map(row.of, by[state]) if x is not None]
            if known:
                figures[f"{state}_{k}"] = Number.of(known)
                cells[state] = f"{{{state}_{k}}}"
        if "today" not in cells:
            continue
        compared = [""] * 2
        if row.name and "first" in cells:
            for clock in (0, 1):
                pairs = zip(by["first"], by["today"], strict=True)
                both = [(a[row.name], b[row.name]) for a, b in pairs if row.name in a and row.name in b]
                figures[f"x{clock}_{k}"] = Number.of([a[clock] / b[clock] for a, b in both])
                compared[clock] = f"{{x{clock}_{k}}}"
        rows.append([row.label, cells.get("first", "not there"), cells["today"], *compared, row.goal])
    name = instruction_sets.SETS.get(level, level)
    return Section(
        title=name,
        made_by="benchmarks/before.py",
        intro=(
            "Both versions as this processor's instructions let them be."
            if level == data["levels"][0]
            else f"Both versions told to compile for {name} alone, on the same processor; what no compiled code decides is in the table before."
        ),
        figures=figures,
        tables=[Table(["", "first version", "today", "x as fast", "x by processor time", "goal"], rows)],
    )


def page(data: Mapping[str, Any]) -> str:
    """The page as Markdown."""
    taken = "an unknown share" if data["others"] is None else f"{100 * data['others']:.1f} %"
    words = wrapped(
        "How fast was the first version, and how fast is Motes today? Written by `benchmarks/before.py` (`make before`) from one run of "
        f"{data['rounds']} rounds in which both versions took turns on one machine; edit nothing here. The first version is commit `{FIRST}`, whose kernels "
        "Numba compiled. Every measurement is a process of its own. Figures are medians over the rounds with their quartiles in brackets; *x as fast* "
        "compares the two round by round by the clock, *x by processor time* the time of all threads together. Other work took "
        f"{taken} of the processors in the {data['seconds'] / 60:.0f} minutes, browsers that show the viewer included. Goals are those that were "
        "set after the first version had been measured. What "
        "each figure is about, with other programs beside it, is in the [benchmarks](benchmarks.md); which ways were tried is in "
        "[where the time goes](speed.md).",
    )
    more = wrapped(
        "A fit of today does more than one of the first version: its error bars allow for a model that is not quite true, and it says which parameters "
        "the data do not tell. What is odd about data of one time is looked for when somebody reads it, as the command line does, and is not in these times.",
    )
    rows = [[k, v] for k, v in data["machine"].items() if v]
    lines = ["# Before and after", "", *words, "", *more, "", "## The machine", "", *table_lines(["", ""], rows), ""]
    for level in data["levels"]:
        lines += section_lines(section(data, level))
    return "\n".join(lines)


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("--rounds", type=int, default=2)
    parser.add_argument("--folder", type=Path, default=ROOT / "out" / "before", help="where results are kept")
    parser.add_argument("--page-only", action="store_true", help="write the page from the results that are there")
    parser.add_argument("--quick", action="store_true", help="sizes that mean nothing, for tests")
    parser.add_argument("-o", "--output", type=Path)
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    kept = given.folder / "found.json"
    if not given.page_only:
        for data in measured(given.folder, given.rounds, given.quick):
            kept.write_text(json.dumps(data, indent=1), encoding="utf-8")
    output = given.output or (given.folder / "before.md" if given.quick else ROOT / "docs" / "before.md")
    write_text(output, page(json.loads(kept.read_text(encoding="utf-8"))))
    print(output)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except MotesError as error:
        sys.exit(str(error))
