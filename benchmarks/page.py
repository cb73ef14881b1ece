"""The page of results, written from sections and nothing else: every figure on it comes out of `Section.figures` or `Run`."""

from __future__ import annotations

import json
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path

from results import Number, Section, digits

TITLE = "# Benchmarks"
WIDTH = 158


@dataclass
class Part:
    """How a benchmark's process went."""

    name: str
    seconds: float
    others: float | None
    failed: str = ""


@dataclass
class Printed:
    """What another script of this folder printed, as Markdown."""

    title: str
    command: str
    text: str


@dataclass
class Run:
    """A run of all benchmarks: where, how, and what was printed rather than handed on."""

    effort: str
    machine: dict[str, str]
    parts: list[Part] = field(default_factory=list)
    printed: list[Printed] = field(default_factory=list)

    def write(self, path: Path) -> None:
        """Store as JSON."""
        path.write_text(json.dumps(asdict(self), indent=1), encoding="utf-8")

    @classmethod
    def read(cls, path: Path) -> Run:
        """Back from `write`."""
        data = json.loads(path.read_text(encoding="utf-8"))
        parts, printed = ([kind(**x) for x in data.pop(name)] for kind, name in ((Part, "parts"), (Printed, "printed")))
        return cls(**data, parts=parts, printed=printed)


def page(run: Run, sections: Sequence[Section], pictures: Mapping[str, str]) -> str:
    """The page as Markdown; `pictures` are paths by the title of the section that they belong to."""
    lines = [
        TITLE,
        "",
        f"Written by `benchmarks/run.py` (`make bench`), effort `{run.effort}`; edit nothing here. Every ratio is taken within one process, the candidates",
        "in turn, round after round; figures are medians of the rounds with their quartiles in brackets. Wall time says what a user gets on this machine at",
        "that moment; *of processor* is the time of all threads together, which depends less on what else runs. An *x* is how many times as fast.",
        "",
        *_machine(run),
        *_goals(sections),
    ]
    for section in sections:
        lines += section_lines(section, pictures.get(section.title))
    for printed in run.printed:
        lines += [f"## {printed.title}", "", printed.text.strip(), "", f"Made by `{printed.command}`.", ""]
    return "\n".join(lines)


def _machine(run: Run) -> list[str]:
    lines = ["## The machine", "", *table_lines(["", ""], [[k, v] for k, v in run.machine.items()]), ""]
    rows = [
        [
            part.name,
            digits(part.seconds),
            "unknown" if part.others is None else digits(100 * part.others),
            part.failed or "done",
        ]
        for part in run.parts
    ]
    return [
        *lines,
        "How the run went, and how much of the processors other work took meanwhile (wall times mean little where that is much):",
        "",
        *table_lines(["part", "seconds", "others [%]", ""], rows),
        "",
    ]


def _goals(sections: Sequence[Section]) -> list[str]:
    rows = []
    for section in sections:
        for goal in section.goals:
            sign = "≥" if goal.at_least else "≤"
            rows.append(
                [
                    goal.what,
                    f"{sign} {goal.bound:,.10g}{goal.unit}",
                    f"{section.figures[goal.figure]}{goal.unit}",
                    "met" if goal.met(section.figures) else "**missed**",
                    section.title,
                ]
            )
    return ["## Goals", "", *table_lines(["", "goal", "measured", "", "section"], rows), ""] if rows else []


def section_lines(section: Section, picture: str | None = None) -> list[str]:
    """Lines of a section, its figures filled in."""
    lines = [f"## {section.title}", "", *wrapped(section.filled(section.intro)), ""]
    for table in section.tables:
        if table.title:
            lines += [f"**{table.title}**", ""]
        lines += [*table_lines(table.columns, [[section.filled(cell) for cell in row] for row in table.rows]), ""]
    if picture:
        lines += [f"![{section.title}]({picture})", ""]
    if section.reading:
        lines += ["What this says:", "", *wrapped(*map(section.filled, section.reading), bullet="- "), ""]
    if section.skipped:
        lines += ["Skipped:", "", *wrapped(*section.skipped, bullet="- "), ""]
    return [*lines, f"Made by `{section.made_by}`.", ""]


def wrapped(*paragraphs: str, bullet: str = "") -> list[str]:
    """Lines of paragraphs, each begun by a bullet."""
    options = {"break_long_words": False, "break_on_hyphens": False, "subsequent_indent": " " * len(bullet)}
    return [line for text in paragraphs for line in textwrap.wrap(bullet + text, WIDTH, **options)]


def table_lines(columns: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Lines of a table."""

    def line(cells: Sequence[str]) -> str:
        return f"| {' | '.join(cell.replace('|', '/') for cell in cells)} |"

    return [line(columns), "|" + "---|" * len(columns), *map(line, rows)]


# ---------------------------------------------------------------- pictures


def draw(sections: Sequence[Section], folder: Path) -> dict[str, str]:
    """Write the plots of sections that have curves or rates; their names by section."""
    found = {}
    for section in sections:
        if section.curves:
            found[section.title] = _curves(section, folder / "benchmarks-growth.svg")
        elif section.title == "Evaluation":
            found[section.title] = _bars(section, folder / "benchmarks-evaluation.svg")
    return found


def _curves(section: Section, path: Path) -> str:
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9, 3.6), layout="constrained")
    for axes, (title, points) in zip(
        figure.subplots(1, len(section.curves), squeeze=False)[0], section.curves.items(), strict=True
    ):
        n, seconds = zip(*points, strict=True)
        axes.loglog(n, seconds, "o-", color="#1f6f8b", label="measured, wall")
        axes.loglog(n, [seconds[-1] * x / n[-1] for x in n], "--", color="#888888", label="in proportion to N")
        axes.set(title=title, xlabel="N", ylabel="seconds")
        axes.legend(frameon=False)
        axes.grid(alpha=0.3)
    return _saved(figure, path)


def _bars(section: Section, path: Path) -> str:
    """Rates of the evaluation's table, in its order."""
    from matplotlib.figure import Figure

    rates: list[tuple[str, Number]] = []
    for label, cell, *_ in section.tables[0].rows:
        rates.append((label.replace("*", "").replace("`", ""), section.figures[cell.strip("{}")]))
    figure = Figure(figsize=(9, 0.32 * len(rates) + 0.9), layout="constrained")
    axes = figure.subplots()
    places = range(len(rates))
    middle = [rate.median for _, rate in rates]
    spread = [[rate.median - rate.low for _, rate in rates], [rate.high - rate.median for _, rate in rates]]
    colors = ["#1f6f8b" if label.startswith("Motes") else "#b0b0b0" for label, _ in rates]
    axes.barh(places, middle, xerr=spread, color=colors, ecolor="#444444", log=True)
    axes.set_yticks(places, [label for label, _ in rates])
    axes.invert_yaxis()
    axes.set_xlabel("million evaluations a second, wall")
    axes.grid(axis="x", alpha=0.3)
    return _saved(figure, path)


def _saved(figure: object, path: Path) -> str:
    import matplotlib

    path.parent.mkdir(parents=True, exist_ok=True)
    with matplotlib.rc_context({"svg.hashsalt": "motes", "svg.fonttype": "none"}):
        figure.savefig(path, metadata={"Date": None})  # type: ignore[attr-defined]
    return f"{path.parent.name}/{path.name}"
