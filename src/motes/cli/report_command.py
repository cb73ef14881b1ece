"""``motes report``: a report on paper."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

from cyclopts import Parameter

from motes.cli.options import Common

#: The reports that commands write into a folder, and those beside a map.
IN_FOLDER = ("report.html", "comparison.html")


def report(
    subject: str,
    /,
    *,
    output: Annotated[str | None, Parameter(name=["--output", "-o"])] = None,
    paper: Literal["a4", "letter"] = "a4",
    common: Common = Common(),  # noqa: B008 (an immutable value)
) -> int:
    """Print a report as PDF, by the browser that is there (Chromium, Chrome, Edge); nothing is asked of the network.

    Parameters
    ----------
    subject
        A folder of motes fit, a map that was fitted, or a page: report.html, comparison.html, a certificate.
    output
        The PDF; beside the page, by its name, when not given.
    paper
        The size of the paper.
    """
    from motes.cli import console
    from motes.errors import MotesError
    from motes.report.paper import print_page

    page = _page(subject)
    target = Path(output) if output is not None else page.with_suffix(".pdf")
    if target.suffix.lower() != ".pdf":
        raise MotesError(f"{target} is no PDF by its name", "Write -o NAME.pdf")
    with console.progress(common, "printing"):
        written = print_page(page, target, paper=paper)
    size = written.stat().st_size
    if common.json:
        console.print_json({"page": str(page), "file": str(written), "bytes": size})
    elif not common.quiet:
        console.print_facts([("page", str(page)), ("written", f"{written} ({size / 1e6:.2f} MB)")])
    return 0


def _page(subject: str) -> Path:
    """The page that a user means."""
    from motes.cli.paths import is_map
    from motes.errors import DataError
    from motes.files.finding import existing

    path = existing(subject)
    if path.is_file():
        return path
    if is_map(subject):
        candidates = [path.with_name(f"{path.name.removesuffix('.zarr')}.html")]
        hint = "motes fit writes it beside the map"
    else:
        candidates = [path / name for name in IN_FOLDER]
        hint = "motes fit writes report.html unless --no-report is given"
    for candidate in candidates:
        if candidate.is_file():
            return candidate
    raise DataError(f"{' and '.join(map(str, candidates))} {'is' if len(candidates) == 1 else 'are'} not there", hint)
