"""What a benchmark hands on: figures of one run by name, and texts, tables and goals that speak of them.

No text holds a measured figure: it names one in braces, and `Section.filled` puts it in.  ``{rate}`` becomes the median with the
quartiles of the rounds, ``{rate:bare}`` the median alone, ``{texels:count}`` a whole number.
"""

from __future__ import annotations

import argparse
import json
import string
import sys
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

EFFORTS = ("quick", "normal", "full")


@dataclass(frozen=True)
class Number:
    """A measured figure: the median of its rounds and their quartiles; all three alike where there was one round."""

    median: float
    low: float
    high: float

    @classmethod
    def of(cls, values: Sequence[float] | np.ndarray) -> Number:
        """Median and quartiles of the values of several rounds."""
        low, median, high = np.percentile(np.asarray(values, float), [25, 50, 75])
        return cls(float(median), float(low), float(high))

    def times(self, factor: float) -> Number:
        """The same in another unit."""
        return Number(self.median * factor, self.low * factor, self.high * factor)

    def rate(self, workers: float = 1) -> Number:
        """Items a second of so many workers, from seconds an item."""
        return Number(workers / self.median, workers / self.high, workers / self.low)

    def __format__(self, spec: str) -> str:
        if spec == "count":
            return f"{self.median:,.0f}"
        low, median, high = (digits(x) for x in (self.low, self.median, self.high))
        return median if spec == "bare" or low == high else f"{median} ({low}–{high})"


def digits(x: float) -> str:
    """Three significant digits, thousands apart."""
    if not np.isfinite(x):
        return "none"
    if x == 0:
        return "0"
    if 1e-4 <= abs(x) < 1e7:
        places = 2 - int(np.floor(np.log10(abs(x))))
        return f"{round(x, places):,.{max(0, places)}f}"
    return f"{x:.2e}"


@dataclass(frozen=True)
class Goal:
    """What a figure should reach; `unit` follows both."""

    what: str
    figure: str
    bound: float
    at_least: bool = True
    unit: str = ""

    def met(self, figures: dict[str, Number]) -> bool:
        """Whether the median reaches it."""
        value = figures[self.figure].median
        return value >= self.bound if self.at_least else value <= self.bound


@dataclass(frozen=True)
class Table:
    """Rows of templates under headings."""

    columns: list[str]
    rows: list[list[str]] = field(default_factory=list)
    title: str = ""


@dataclass(frozen=True)
class Section:
    """The results of one benchmark.

    Parameters
    ----------
    title, made_by
        The heading; the script and function.
    intro
        What was measured and how.
    figures
        By name.
    tables, goals, reading
        Templates that name figures: ``{name}`` or ``{name:bare}``.
    skipped
        What was left out here, and why.
    curves
        For plots: by title the points (x, y), of a unit each.
    """

    title: str
    made_by: str
    intro: str
    figures: dict[str, Number]
    tables: list[Table] = field(default_factory=list)
    goals: list[Goal] = field(default_factory=list)
    reading: list[str] = field(default_factory=list)
    skipped: list[str] = field(default_factory=list)
    curves: dict[str, list[list[float]]] = field(default_factory=dict)

    def filled(self, template: str) -> str:
        """A template with its figures."""
        return string.Formatter().vformat(template, (), self.figures)

    def write(self, path: Path) -> None:
        """Store as JSON."""
        path.write_text(json.dumps(asdict(self), indent=1), encoding="utf-8")

    @classmethod
    def read(cls, path: Path) -> Section:
        """Back from `write`."""
        data = json.loads(path.read_text(encoding="utf-8"))
        data["figures"] = {name: Number(**value) for name, value in data["figures"].items()}
        data["tables"] = [Table(**table) for table in data["tables"]]
        data["goals"] = [Goal(**goal) for goal in data["goals"]]
        return cls(**data)


@dataclass(frozen=True)
class Effort:
    """How much to do: ``quick`` shows that everything runs, ``normal`` is for the page, ``full`` takes the largest sizes too."""

    name: str = "normal"

    def pick(self, quick: Any, normal: Any, full: Any = None) -> Any:
        """The size for this effort."""
        return {"quick": quick, "normal": normal, "full": normal if full is None else full}[self.name]


def goal_lines(section: Section) -> list[str]:
    """Each goal of a section beside what was measured."""
    lines = []
    for goal in section.goals:
        sign, verdict = "≥" if goal.at_least else "≤", "met" if goal.met(section.figures) else "missed"
        value = format(section.figures[goal.figure])
        lines.append(f"{goal.what}: goal {sign} {goal.bound:,.10g}{goal.unit}, measured {value}{goal.unit}: {verdict}")
    return lines


def command(benchmark: Callable[[Effort], Section], description: str | None) -> None:
    """The command line of a benchmark: run it, print its tables, and write it where ``--json`` says."""
    parser = argparse.ArgumentParser(description=(description or "").split("\n", 1)[0])
    parser.add_argument("--effort", choices=EFFORTS, default="normal")
    parser.add_argument("--json", type=Path, help="write the results here")
    given = parser.parse_args()
    section = benchmark(Effort(given.effort))
    if given.json:
        section.write(given.json)
    for table in section.tables:
        rows = [table.columns, *([section.filled(cell) for cell in row] for row in table.rows)]
        widths = [max(len(row[k]) for row in rows) for k in range(len(table.columns))]
        for row in rows:
            print("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip())
        print()
    for line in [*goal_lines(section), *map(section.filled, section.reading), *section.skipped]:
        print(line)
    sys.stdout.flush()
