"""What the commands print: tables, sentences or JSON to standard output, progress and warnings to standard error."""

from __future__ import annotations

import json
import shutil
import sys
import textwrap
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

from rich.console import Console
from rich.table import Table

from motes._cli.options import Common

Progress = Callable[[int, int, str], None]
PIPE_WIDTH = 140  # columns when the output is not a terminal: wide enough that no table wraps


def print_facts(rows: Sequence[tuple[str, str]]) -> None:
    """Pairs of a label and a text to standard output."""
    print(facts(rows))


def print_table(table: Table) -> None:
    """A table to standard output, without blanks at the ends of its lines."""
    console = Console(width=None if sys.stdout.isatty() else PIPE_WIDTH, markup=False, highlight=False, emoji=False)
    with console.capture() as capture:
        console.print(table)
    print("\n".join(line.rstrip() for line in capture.get().splitlines()))


def clean(text: object) -> str:
    """Text without control characters, which a name out of a file could use to move the cursor or change the title."""
    return "".join(c if c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in str(text))


def facts(rows: Sequence[tuple[str, str]]) -> str:
    """Pairs of a label and a text as lines, the texts aligned, and wrapped to the width of a terminal."""
    label_width = max((len(label) for label, _ in rows), default=0) + 2
    width = shutil.get_terminal_size().columns - label_width if sys.stdout.isatty() else 10**6
    lines = []
    for label, text in rows:
        for paragraph in text.split("\n"):
            for line in textwrap.wrap(clean(paragraph), max(width, 20)) or [""]:
                lines.append(f"{label:<{label_width}}{line}".rstrip())
                label = ""
    return "\n".join(lines)


def print_json(data: Mapping[str, Any]) -> None:
    """One JSON object to standard output."""
    print(json.dumps(data, indent=1, allow_nan=False))


def warn(message: str) -> None:
    """A sentence to standard error."""
    print(f"warning: {clean(message)}", file=sys.stderr)


@contextmanager
def progress(common: Common, label: str) -> Iterator[Progress | None]:
    """A progress bar on standard error while a terminal looks at it, else None."""
    if common.quiet or common.json or not sys.stderr.isatty():
        yield None
        return
    from rich import progress as bars

    columns = (
        bars.SpinnerColumn(),
        bars.TextColumn("{task.description}", markup=False),
        bars.BarColumn(bar_width=30),
        bars.TimeElapsedColumn(),
    )
    with bars.Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(label, total=None)

        def step(done: int, total: int, what: str) -> None:
            bar.update(task, completed=done, total=total, description=f"{label}: {clean(what)}")

        yield step
