"""Run every benchmark, each in a process of its own, and write docs/benchmarks.md.

usage: python benchmarks/run.py [--effort quick|normal|full] [--only NAME ...] [-o docs/benchmarks.md]

``--quick`` is for tests: sizes that mean nothing, and a page in out/bench.  Results stay in out/bench as JSON; ``--page-only`` writes the page from them
again.  The exit code is 1 where a benchmark failed.
"""

from __future__ import annotations

import argparse
import os
import resource
import subprocess
import sys
import time
from pathlib import Path

import machine
from motes.files import write_text
from page import Part, Printed, Run, draw, page
from results import EFFORTS, Section

HERE = Path(__file__).resolve().parent
OUT = HERE.parent / "out" / "bench"
SCRIPTS = (
    "evaluate",
    "instruction_sets",
    "dust",
    "sampling",
    "texels",
    "map_fits",
    "map_losses",
    "growth",
    "fits",
    "joint",
    "starting",
    "memory",
    "scale_out",
    "gpu",
    "viewer",
)
# Scripts that print Markdown, with what to ask of them by effort; where they are missing, they are left out.
PRINTING: dict[str, tuple[str, dict[str, list[str]]]] = {
    "render": ("Rendering", {"quick": ["--only", "furnace"], "normal": ["--only", "speed", "--rounds", "7"]}),
}
LIMIT = {"quick": 300, "normal": 900, "full": 3600}  # seconds of one script


class Meter:
    """Seconds, and the share of the processors that others took, while a child ran."""

    def __init__(self) -> None:
        self.start, self.own, self.all = time.perf_counter(), self._own(), self._all()

    def others(self) -> tuple[float, float | None]:
        """Seconds so far, and the share; None where the system does not say."""
        seconds = time.perf_counter() - self.start
        busy = self._all()
        if busy is None or self.all is None:
            return seconds, None
        taken = (busy - self.all) - (self._own() - self.own)
        return seconds, max(0.0, taken / (seconds * (os.cpu_count() or 1)))

    @staticmethod
    def _own() -> float:
        kinds = (resource.RUSAGE_CHILDREN, resource.RUSAGE_SELF)
        return sum(u.ru_utime + u.ru_stime for u in map(resource.getrusage, kinds))

    @staticmethod
    def _all() -> float | None:
        try:
            first = Path("/proc/stat").read_text(encoding="ascii").splitlines()[0].split()
        except OSError:
            return None
        user, nice, system, _, _, irq, soft, steal = map(int, first[1:9])
        return (user + nice + system + irq + soft + steal) / os.sysconf("SC_CLK_TCK")


def child(name: str, arguments: list[str], limit: float) -> tuple[Part, str]:
    """Run a script; how it went, and what it printed."""
    meter = Meter()
    failed, printed = "", ""
    try:
        done = subprocess.run(
            [sys.executable, str(HERE / f"{name}.py"), *arguments],
            capture_output=True,
            text=True,
            timeout=limit,
            check=False,
        )
        printed = done.stdout
        if done.returncode != 0:
            lines = done.stderr.strip().splitlines() or [f"exit code {done.returncode}"]
            failed = f"failed: {lines[-1][:200]}"
    except subprocess.TimeoutExpired:
        failed = f"failed: not done after {limit:.0f} s"
    seconds, others = meter.others()
    return Part(name, seconds, others, failed), printed


def measured(effort: str, names: list[str], folder: Path) -> Run:
    """Run the scripts; their sections are JSON files in the folder afterwards."""
    run = Run(effort, machine.description())
    for name in names:
        print(f"{name} ... ", end="", flush=True)
        if name in PRINTING:
            title, ask = PRINTING[name]
            asked = ask.get(effort, ask["normal"])
            part, text = child(name, asked, LIMIT[effort])
            if not part.failed:
                fenced = text if "\n|" in text else f"```\n{text.strip()}\n```"
                run.printed.append(Printed(title, " ".join(["python", f"benchmarks/{name}.py", *asked]), fenced))
        else:
            target = folder / f"{name}.json"
            target.unlink(missing_ok=True)
            part, _ = child(name, ["--effort", effort, "--json", str(target)], LIMIT[effort])
        run.parts.append(part)
        print(f"{part.seconds:.0f} s {part.failed}", flush=True)
    run.write(folder / "run.json")
    return run


def written(run: Run, folder: Path, output: Path) -> None:
    """Write the page and its pictures from the results in a folder."""
    stored = [folder / f"{part.name}.json" for part in run.parts if not part.failed and part.name not in PRINTING]
    sections = [Section.read(path) for path in stored]
    pictures = draw(sections, output.parent / "pictures")
    write_text(output, page(run, sections, pictures))


def main() -> int:
    there = [name for name in (*SCRIPTS, *PRINTING) if (HERE / f"{name}.py").exists()]
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("--effort", choices=EFFORTS, default="normal")
    for effort in ("quick", "full"):
        parser.add_argument(f"--{effort}", dest="effort", action="store_const", const=effort)
    parser.add_argument("--only", nargs="+", choices=there, default=there, metavar="NAME", help=", ".join(there))
    parser.add_argument("--folder", type=Path, default=OUT, help="where results are kept")
    parser.add_argument("--page-only", action="store_true", help="write the page from the results that are there")
    parser.add_argument("-o", "--output", type=Path)
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    whole = given.effort != "quick" and given.only == there
    output = given.output or (HERE.parent / "docs" / "benchmarks.md" if whole else given.folder / "benchmarks.md")
    if given.page_only:
        run = Run.read(given.folder / "run.json")
    else:
        run = measured(given.effort, given.only, given.folder)
    written(run, given.folder, output)
    print(output)
    return int(any(part.failed for part in run.parts))


if __name__ == "__main__":
    sys.exit(main())
