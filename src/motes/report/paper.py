"""Reports on paper: a page that Motes wrote as PDF, by a browser that is there, without a network.

The style sheet of the reports says how they look on paper; a browser lays them out, since the pages are made for one.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Literal

from motes.drawing.markup import tag
from motes.errors import DataError, MotesError
from motes.files import check_writable, replacing
from motes.report.document import POLICY

Paper = Literal["a4", "letter"]
PAPERS: dict[str, str] = {"a4": "A4", "letter": "letter"}
#: Names the browser to use, for those who have several, or one elsewhere.
VARIABLE = "MOTES_BROWSER"
#: Of one family: others have no way to print without a window.
COMMANDS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "msedge", "microsoft-edge", "brave-browser")  # fmt: skip
PLACES = (
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
    r"C:\Program Files\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Microsoft\Edge\Application\msedge.exe",
)
PATIENCE = 180.0  # seconds
LARGEST = 256 * 2**20  # bytes of a page


def print_page(page: str | os.PathLike[str], path: str | os.PathLike[str], *, paper: Paper = "a4") -> Path:
    """Print a report as PDF.

    Parameters
    ----------
    page
        The path of an HTML page that Motes wrote: of a fit, of trends, a map, a comparison, a certificate.
    path
        The PDF to write, whole or not at all.
    paper
        ``"a4"`` (210 x 297 mm) or ``"letter"`` (8.5 x 11 inches).

    Returns
    -------
    Path

    Raises
    ------
    DataError
        When the page is none of Motes' reports.
    MotesError
        When no browser is found, when it fails, or when the file cannot be written.

    Notes
    -----
    A page's policy lets no script run and nothing be asked of the network, and the browser is told that no host exists.
    """
    if paper not in PAPERS:
        raise MotesError(f"{paper!r} is no size of paper", f"Choose one of {', '.join(PAPERS)}")
    text = _report(Path(page))
    target = Path(path)
    check_writable(target)
    program = browser()
    with tempfile.TemporaryDirectory(prefix="motes-", ignore_cleanup_errors=True) as name:
        folder = Path(name)
        source, printed = folder / "report.html", folder / "report.pdf"
        size = tag("style", f"@page {{ size: {PAPERS[paper]}; }}")
        source.write_text(text.replace("</head>", f"{size}</head>", 1), encoding="utf-8")
        _run(program, source, printed, folder / "profile")
        with replacing(target) as temporary:
            shutil.copyfile(printed, temporary)
    return target


def browser() -> str:
    """The program of a browser that can print without a window; an error says what to install."""
    if named := os.environ.get(VARIABLE):
        if found := shutil.which(named):
            return found
        raise MotesError(f"{VARIABLE} names {named}, which is no program", "Give the path of Chromium, Chrome or Edge")
    for name in COMMANDS:
        if found := shutil.which(name):
            return found
    for place in PLACES:
        if os.path.isfile(place):
            return place
    raise MotesError(
        "a PDF needs a browser to lay the page out, and neither Chromium nor Chrome nor Edge was found",
        f"Install one, name it in {VARIABLE}, or open the page in any browser and print it",
    )


def _report(page: Path) -> str:
    """The text of a page, which must be a report: its policy is why it may be handed to a browser."""
    try:
        size = page.stat().st_size
        text = page.read_text(encoding="utf-8") if size <= LARGEST else ""
    except UnicodeDecodeError:
        text = ""
    except OSError as error:
        raise DataError(f"{page} cannot be read: {error.strerror}", "motes fit writes report.html") from error
    policy = tag("meta", http_equiv="Content-Security-Policy", content=POLICY)
    if policy not in text[:4096] or "</head>" not in text:
        raise DataError(
            f"{page} is no report that Motes wrote",
            "Give a report.html, comparison.html, certificate or page of a map; a viewer's page prints from the browser that shows it",
        )
    return text


def _run(program: str, source: Path, printed: Path, profile: Path) -> None:
    command = [
        program,
        "--headless",
        "--disable-gpu",
        "--disable-extensions",
        "--disable-background-networking",
        "--disable-sync",
        "--disable-component-update",
        "--no-first-run",
        "--no-default-browser-check",
        "--host-resolver-rules=MAP * ~NOTFOUND",
        f"--user-data-dir={profile}",
        "--no-pdf-header-footer",
        f"--print-to-pdf={printed}",
        source.as_uri(),
    ]
    if sys.platform != "win32" and os.geteuid() == 0:
        command.insert(1, "--no-sandbox")  # the sandbox does not start for root; the page runs no script
    try:
        done = subprocess.run(command, capture_output=True, timeout=PATIENCE, stdin=subprocess.DEVNULL)
    except subprocess.TimeoutExpired as error:
        raise MotesError(f"{program} did not print within {PATIENCE:.0f} s", f"Name another browser in {VARIABLE}") from error  # fmt: skip
    except OSError as error:
        raise MotesError(f"{program} cannot be run: {error.strerror}", f"Name another browser in {VARIABLE}") from error
    if not printed.is_file() or printed.read_bytes()[:5] != b"%PDF-":
        said = done.stderr.decode("utf-8", "replace").strip().splitlines()
        why = f": {said[-1][:200]}" if said else ""
        raise MotesError(f"{program} printed nothing (exit status {done.returncode}){why}", f"Name another browser in {VARIABLE}")  # fmt: skip
