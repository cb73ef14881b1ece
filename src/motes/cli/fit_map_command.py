"""``motes fit``, ``info`` and ``simulate`` where they are given a Zarr store: maps, texel by texel."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from motes.cli.options import Common

if TYPE_CHECKING:
    from motes.maps import FittedMap, MapStack

Row = tuple[str, str]
Progress = Callable[[int, int, str], None]

SHOWN_FAILURES = 10
# A map with more fits than this share stopped by the limit of iterations has not converged.
MOST_UNCONVERGED = 0.5


def is_map(data: str) -> bool:
    """Whether the argument of a command is a Zarr store; looks at names only."""
    folder = Path(data)
    try:
        return folder.suffix == ".zarr" or any((folder / n).is_file() for n in ("zarr.json", ".zgroup", ".zarray"))
    except (OSError, ValueError):  # no path at all; the command says so
        return False


def only_for_maps(**options: Any) -> None:
    """Refuse options that only a map has."""
    from motes.errors import MotesError

    for name, value in options.items():
        if value is not None:
            raise MotesError(f"--{name} is for maps, and this is not a Zarr store", "Leave it out")


def fit_map(
    data: str,
    *,
    refused: Sequence[str],
    output: str | None,
    report: bool,
    exr: str | None,
    common: Common,
    **options: Any,
) -> int:
    """Fit a map, write the page and the pictures, print what was found; returns the exit status."""
    from motes.cli import console, paths
    from motes.cli.fit_command import NOT_CONVERGED
    from motes.errors import MotesError
    from motes.maps import export_exr, fit_map, open_map
    from motes.maps.stack import open_stack

    if refused:
        raise MotesError(f"{refused[0]} is not offered for maps", "Leave it out")
    paths.existing(data)
    stack = open_stack(data)
    out = Path(output) if output is not None else Path(f"motes-{paths.slug(stack.name)}.zarr")
    if stack.reads_per_chunk > 1.5:
        console.warn(
            f"chunks {stack.array.chunks} do not hold whole texels: each is read about {stack.reads_per_chunk:.0f} times; "
            "chunks of 64 x 64 texels with all times, directions and channels are quickest"
        )
    with progress(common, "texels") as step:
        fitted = fit_map(stack, out=out, progress=step, **options)
    fitted = open_map(out)  # type: ignore[assignment]
    written: list[Row] = [("written", str(out))]
    if report:
        with console.progress(common, "drawing"):
            page = fitted.report(out.with_name(f"{out.name.removesuffix('.zarr')}.html"))
        written.append(("look at", str(page)))
    if exr is not None:
        with console.progress(common, "pictures") as draw:
            pictures = export_exr(fitted, exr, progress=draw)
        written.append(("pictures", f"{exr}/: {len(pictures)} OpenEXR files, coefficients of t^d (STAF layout)"))
    summary = fitted.summary()
    errors = _errors(fitted, stack)
    if common.json:
        console.print_json({**summary, **({"truth": errors} if errors else {}), "files": dict(written)})
    elif not common.quiet:
        _show(fitted, summary, errors, written)
    for (y, x), reason in fitted.failures[:SHOWN_FAILURES]:
        rows, columns = fitted.blocks.slices((y, x))
        where = f"rows {rows.start} to {rows.stop - 1}, columns {columns.start} to {columns.stop - 1}"
        console.warn(f"block ({y}, {x}), {where}, could not be fitted: {reason}")
    if fitted.failures:
        console.warn(
            f"{len(fitted.failures)} of {summary['blocks']} blocks failed; all others are done, and the same command tries "
            "these again"
        )
        return NOT_CONVERGED
    fits = summary["fits"]
    if fits["max_iterations"] > MOST_UNCONVERGED * max(fits["converged"] + fits["max_iterations"], 1):
        console.warn(f"{fits['max_iterations']} fits did not converge; their numbers are not to be trusted")
        return NOT_CONVERGED
    return 0


@contextmanager
def progress(common: Common, label: str) -> Iterator[Progress | None]:
    """A progress bar with rate and time left on standard error while a terminal looks at it, else None."""
    from motes.cli import console

    if common.quiet or common.json or not console.on_terminal(sys.stderr):
        yield None
        return
    from rich import progress as bars
    from rich.console import Console
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
        task = bar.add_task(label, total=None)
        began = False

        def step(done: int, total: int, what: str) -> None:
            nonlocal began
            if total > 1 and not began:  # what an earlier run did is no part of the rate
                began = True
                bar.reset(task, total=total, completed=done, description=f"{label}: {console.clean(what)}")
                return
            bar.update(
                task, completed=done, total=total if total > 1 else None, description=f"{label}: {console.clean(what)}"
            )

        yield step


def info(data: str, common: Common) -> int:
    """What a map holds."""
    from motes.cli import console, paths
    from motes.maps import FittedMap, open_map

    paths.existing(data)
    found = open_map(data)
    summary = found.summary()
    if common.json:
        console.print_json(summary)
    elif not common.quiet:
        if isinstance(found, FittedMap):
            _show(found, summary, {}, [])
        else:
            console.print_facts(stack_rows(summary))
    return 0


def simulate_map(
    folder: str, size: int | None, scans: int, hours: float, noise: float, seed: int, refused: list[str], common: Common
) -> int:
    """Write a simulated map."""
    from motes.cli import console
    from motes.errors import MotesError
    from motes.maps import simulate_map

    if refused:
        raise MotesError(f"{refused[0]} is not offered for maps", "The map is of a painted surface that dries")
    n = 64 if size is None else size
    with progress(common, "texels") as step:
        stack = simulate_map(folder, (n, n), times=scans, hours=hours, noise=noise, seed=seed, progress=step)
    if common.json:
        console.print_json(stack.summary())
    elif not common.quiet:
        rows = [row for row in stack_rows(stack.summary()) if row[0] in ("size", "times")]
        console.print_facts([("written", folder), *rows, ("next", f"motes fit {folder}")])
    return 0


def _errors(fitted: FittedMap, stack: MapStack) -> dict[str, dict[str, float | None]]:
    """Of a simulated map: how far each parameter is from the truth."""
    from motes.maps.comparison import compare

    return compare(fitted, stack) if stack.truth else {}


def stack_rows(s: dict[str, Any]) -> list[Row]:
    times = s["times"]
    span = f", {times[0]:.4g} to {times[-1]:.4g} h" if len(times) > 1 else ""
    n = len(times)
    rows = [
        ("kind", s["kind"]),
        ("name", s["name"]),
        ("source", s["source"]),
        ("size", f"{s['shape'][1]} x {s['shape'][0]} texels, {s['bytes'] / 2**20:,.1f} MiB of {s['dtype']}"),
        ("times", f"{n} time{'' if n == 1 else 's'}{span}"),
        ("directions", f"{s['n_directions']}, one light and one viewer each for all texels"),
        ("channels", ", ".join(s["channels"][:8]) + (", .." if len(s["channels"]) > 8 else "")),
        *((k, f"{s[f'{k}_deg'][0]:.1f} to {s[f'{k}_deg'][1]:.1f} degrees") for k in ("theta_i", "theta_r")),
        ("chunks", f"{' x '.join(map(str, s['chunks']))}; {s['blocks'][0]} x {s['blocks'][1]} blocks"),
        ("truth", ", ".join(s["truth"])),
        ("notes", "\n".join(s["notes"])),
    ]
    return [(label, text) for label, text in rows if text]


def _show(fitted: FittedMap, s: dict[str, Any], errors: dict[str, dict[str, float | None]], written: list[Row]) -> None:
    from rich import box
    from rich.table import Table

    from motes.cli import console
    from motes.maps.comparison import quartiles

    fits = {name: n for name, n in s["fits"].items() if n}
    how = (
        f"{s['n_times']} times together, {', '.join(f'{q} {k}' for q, k in s['trends'].items())}"
        if s["trends"]
        else (f"{s['n_times']} times, each alone" if s["n_times"] > 1 else "one time")
    )
    rows = [
        ("map", f"{s['name']}: {s['shape'][1]} x {s['shape'][0]} texels, {how}"),
        ("model", s["model"] + ("  (chosen on some texels by BIC)" if s["tried"] else "")),
        *([("held", ", ".join(f"{k} = {v}" for k, v in s["fixed"].items()))] if s["fixed"] else []),
    ]
    console.print_facts(rows)
    print()
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    heads = ("map", "lower quarter", "median", "upper quarter", "standard error")
    for k, head in enumerate((*heads, *(("error", "within 2 s.e.") if errors else ()))):
        table.add_column(head, justify="left" if k == 0 else "right")
    for name, (low, middle, high, stderr) in quartiles(fitted).items():
        e = errors.get(name)
        extra = ("", "")
        if e:
            inside = e["within_2_stderr"]
            extra = (f"{e['median_error']:.2g}", "" if inside is None else f"{100 * inside:.1f} %")
        table.add_row(
            console.clean(name),
            f"{low:.4g}",
            f"{middle:.4g}",
            f"{high:.4g}",
            f"{stderr:.2g}",
            *(extra if errors else ()),
        )
    console.print_table(table)
    print()
    counted = ", ".join(f"{n} {name.replace('_', ' ')}" for name, n in fits.items())
    rows = [("fits", counted), ("blocks", f"{s['blocks_done']} of {s['blocks']} done"), *written]
    if errors:
        rows.insert(0, ("truth", "known: the error is the median distance from it"))
    console.print_facts(rows)
