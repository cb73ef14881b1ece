"""What the commands print: tables, sentences or JSON to standard output, progress and warnings to standard error."""

from __future__ import annotations

import json
import shutil
import sys
import textwrap
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any, TextIO

from rich import table as rich_table
from rich.console import Console, RenderableType

from motes.cli.options import Common

Progress = Callable[[int, int, str], None]
PIPE_WIDTH = 140  # columns when the output is not a terminal: wide enough that no table wraps


def on_terminal(stream: TextIO | None) -> bool:
    """Whether somebody looks at a stream (None where the shell closed it)."""
    return stream is not None and stream.isatty()


def width() -> int:
    """Columns of the terminal, or of a table that goes to a file."""
    return shutil.get_terminal_size().columns if on_terminal(sys.stdout) else PIPE_WIDTH


def clean(text: object) -> str:
    """Text without control characters, which a name out of a file could use to move the cursor or change the title."""
    return "".join(c if c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in str(text))


class Table(rich_table.Table):
    """A table whose texts are `clean`."""

    def add_column(self, header: RenderableType = "", *arguments: Any, **options: Any) -> None:
        super().add_column(_cleaned(header), *arguments, **options)

    def add_row(self, *cells: RenderableType | None, **options: Any) -> None:
        super().add_row(*(None if c is None else _cleaned(c) for c in cells), **options)


def _cleaned(given: RenderableType) -> RenderableType:
    return "\n".join(map(clean, given.split("\n"))) if isinstance(given, str) else given


def print_facts(rows: Sequence[tuple[str, str]]) -> None:
    """Pairs of a label and a text to standard output, the texts aligned, and wrapped to the width of a terminal."""
    indent = max((len(label) for label, _ in rows), default=0) + 2
    room = max(width() - indent, 20) if on_terminal(sys.stdout) else 10**6
    for label, text in rows:
        label = clean(label)
        for paragraph in text.split("\n"):
            for line in textwrap.wrap(clean(paragraph), room) or [""]:
                print(f"{label:<{indent}}{line}".rstrip())
                label = ""


def print_table(table: Table) -> None:
    """A table to standard output, without blanks at the ends of its lines."""
    console = Console(width=width(), markup=False, highlight=False, emoji=False)
    with console.capture() as capture:
        console.print(table)
    print("\n".join(line.rstrip() for line in capture.get().splitlines()))


def print_json(data: Mapping[str, Any]) -> None:
    """One JSON object to standard output; what is no finite number is null, for JSON has no other."""
    from motes.fitting.formatting import finite

    print(json.dumps(finite(data), indent=1, allow_nan=False))


def warn(message: str) -> None:
    """A sentence to standard error."""
    print(f"warning: {clean(message)}", file=sys.stderr)


@contextmanager
def progress(common: Common, label: str) -> Iterator[Progress | None]:
    """A progress bar on standard error while a terminal looks at it, else None."""
    if common.quiet or common.json or not on_terminal(sys.stderr):
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
        task = bar.add_task(clean(label), total=None)

        def step(done: int, total: int, what: str) -> None:
            bar.update(task, completed=done, total=total, description=f"{label}: {clean(what)}")

        yield step


@contextmanager
def texel_progress(common: Common, label: str) -> Iterator[Progress | None]:
    """A progress bar with rate and time left on standard error while a terminal looks at it, else None."""
    if common.quiet or common.json or not on_terminal(sys.stderr):
        yield None
        return
    from rich import progress as bars
    from rich.text import Text

    class Rate(bars.ProgressColumn):
        """Texels a second."""

        def render(self, task: bars.Task) -> Text:
            return Text(f"{task.speed:,.0f} texels/s" if task.speed else "")

    columns = (
        bars.SpinnerColumn(),
        bars.TextColumn("{task.description}", markup=False),
        bars.BarColumn(bar_width=30),
        bars.TaskProgressColumn(),
        Rate(),
        bars.TextColumn("left"),
        bars.TimeRemainingColumn(),
    )
    with bars.Progress(*columns, console=Console(stderr=True), transient=True, speed_estimate_period=60) as bar:
        task = bar.add_task(clean(label), total=None)
        began = False

        def step(done: int, total: int, what: str) -> None:
            nonlocal began
            if total > 1 and not began:  # what an earlier run did is no part of the rate
                began = True
                bar.reset(task, total=total, completed=done, description=f"{label}: {clean(what)}")
                return
            bar.update(task, completed=done, total=total if total > 1 else None, description=f"{label}: {clean(what)}")

        yield step
