"""What ``motes fit`` does with a Zarr store: a fit at every texel."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from motes.cli.options import Common, Reading, time_of
from motes.cli.statuses import DONE, NOT_CONVERGED
from motes.errors import MotesError

if TYPE_CHECKING:
    from motes.maps import FittedMap, MapStack

Row = tuple[str, str]

SHOWN_FAILURES = 10
# A map with more fits than this share stopped by the limit of iterations has not converged.
MOST_UNCONVERGED = 0.5
# Where a map says what --read says of other formats.
_SAID_BY_A_MAP = {
    "times": "Write them into the store's array time, with the attribute units; --time chooses one of them",
    "format": "Leave it out; a folder whose name ends in .zarr, or that holds zarr.json, is a map",
}


def fit_map(
    data: str,
    *,
    reading: Reading,
    time: int | None,
    trends: dict[str, str] | None,
    output: str | None,
    report: bool,
    exr: str | None,
    common: Common,
    **options: Any,
) -> int:
    """Fit a map, write the page and the pictures, print what was found; returns the exit status."""
    from motes.cli import console, paths
    from motes.cli.printed_maps import show_fitted
    from motes.files.finding import existing
    from motes.maps import export_exr, fit_map
    from motes.maps.fitted import open_fitted
    from motes.maps.stack import open_stack

    _check_reading(reading)
    existing(data)
    stack = open_stack(data)
    options |= {"time": time_of(time, len(stack.hours), trends or {}), "trends": trends}
    out = Path(output) if output is not None else Path(f"motes-{paths.slug(stack.name)}.zarr")
    if stack.reads_per_chunk > 1.5:
        console.warn(
            f"chunks {stack.array.chunks} do not hold whole texels: each is read about {stack.reads_per_chunk:.0f} times; "
            "chunks of 64 x 64 texels with all times, directions and channels are quickest"
        )
    with console.texel_progress(common, "texels") as step:
        fit_map(stack, out=out, progress=step, **options)
    fitted = open_fitted(out)
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
        show_fitted(fitted, summary, errors, written)
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
    # What wandered along a parameter that the data do not determine is said by its verdict.
    short = fits["max_iterations"] - fitted.adrift()
    if short > MOST_UNCONVERGED * max(fits["converged"] + fits["max_iterations"], 1):
        console.warn(f"{short} fits did not converge; their numbers are not to be trusted")
        return NOT_CONVERGED
    return DONE


def _check_reading(reading: Reading) -> None:
    """Refuse what says how files are read: a map says all of it itself."""
    if reading.sample is not None:
        raise MotesError(
            f"--sample {reading.sample} chooses one sample of a file that holds several, and a map is one sample",
            "Leave it out to fit every texel; --time chooses one time",
        )
    if reading.read:
        name = reading.read[0].partition("=")[0].strip()
        hint = _SAID_BY_A_MAP.get(name, "Leave it out; what a map holds is in docs/maps.md")
        raise MotesError(
            f"--read {reading.read[0]} says how a reader takes a file, and a map in a Zarr store says it itself", hint
        )


def _errors(fitted: FittedMap, stack: MapStack) -> dict[str, dict[str, float | None]]:
    """Of a simulated map: how far each parameter is from the truth."""
    from motes.maps.comparison import compare

    return compare(fitted, stack) if stack.truth else {}
