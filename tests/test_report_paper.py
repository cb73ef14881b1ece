"""Reports on paper: nothing overlaps, nothing is cut, and no page is made without a browser or of a foreign page."""

from __future__ import annotations

import os
import stat
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray

from motes import MotesError, OrenNayar, TorranceSparrow
from motes.cli.main import main
from motes.errors import DataError
from motes.report import paper, write_report
from motes.report.paper import print_page
from report_fits import as_fit, goniometer, measured
from viewer_support import chromium

COLOURED = OrenNayar(K_d=(0.5, 0.3, 0.1), sigma_d=0.3) + TorranceSparrow(K_s=0.4, sigma_s=0.15)
POINT = 72 / 25.4  # a millimetre


class Sheet(NamedTuple):
    """A printed page: its size, its text, the boxes of its runs of text, how high the titles and the axes of panels of ratios stand.

    A box is left, bottom, right and top, in points from the lower left corner.
    """

    width: float
    height: float
    text: str
    boxes: NDArray[np.float64]
    titles: list[float]
    axes: list[float]


def sheets(file: Path) -> list[Sheet]:
    """What is printed, as another program reads it."""
    pdfium = pytest.importorskip("pypdfium2")
    document = pdfium.PdfDocument(file)
    found = []
    for page in document:
        text = page.get_textpage()
        whole = " ".join(text.get_text_range().split())
        boxes = np.array([text.get_rect(k) for k in range(text.count_rects())])
        heights = [[text.get_charbox(k)[1] for k in places(text, words)] for words in ("Ratio against", "[°]")]
        found.append(Sheet(*page.get_size(), whole, boxes, *heights))
        text.close()
        page.close()
    document.close()
    return found


def places(text: Any, words: str) -> Iterator[int]:
    """Where on a page words begin, as indices of characters."""
    search = text.search(words)
    while (match := search.get_next()) is not None:
        yield match[0]


def overlaps(boxes: NDArray[np.float64]) -> int:
    """How many runs of text lie on another one, by more than a tenth of the smaller."""
    a, b = boxes[:, None], boxes[None]
    width, height = (np.minimum(a[..., k + 2], b[..., k + 2]) - np.maximum(a[..., k], b[..., k]) for k in (0, 1))
    area = np.prod(boxes[:, 2:] - boxes[:, :2], axis=1)
    kerned = (np.abs(a[..., 1] - b[..., 1]) < 4) & (
        width < 0.5 * height
    )  # "To": two runs, one over the other by a little
    over = (width > 0) & (height > 0) & ~kerned & (width * height > 0.1 * np.minimum(area[:, None], area))
    return int(np.count_nonzero(np.triu(over, 1)))


def check(file: Path, size: tuple[float, float] = (210, 297)) -> list[Sheet]:
    """What holds of every report on paper."""
    pages = sheets(file)
    for number, sheet in enumerate(pages, 1):
        assert (sheet.width / POINT, sheet.height / POINT) == pytest.approx(size, abs=0.5)
        assert len(sheet.boxes)
        assert overlaps(sheet.boxes) == 0, f"page {number}"
        assert f"{number} / {len(pages)}" in sheet.text
        assert sheet.boxes[:, 0].min() > 14 * POINT
        assert sheet.boxes[:, 2].max() < sheet.width - 14 * POINT
    return pages


@pytest.fixture(scope="module")
def fit() -> Any:
    return as_fit(measured(COLOURED, *goniometer(), provenance={"name": "a glossy card"}), COLOURED)


@pytest.fixture(scope="module", autouse=True)
def there() -> None:
    chromium()
    pytest.importorskip("pypdfium2")


@pytest.mark.slow
def test_a_fit_is_whole_on_paper(fit: Any, tmp_path: Path) -> None:
    pages = check(fit.report(tmp_path / "card.pdf"))
    whole = " ".join(sheet.text for sheet in pages)
    assert len(pages) < 12
    for words in ("a glossy card", "Parameters", "Measured and fitted", "Correlations", "Use the material"):
        assert words in whole
    assert "Save material.json" not in whole  # a link is of no use there
    assert '"format": "motes material"' not in whole
    for sheet in pages[:-1]:  # no page is nearly empty: its last text, the number left out, is below the middle
        assert min(bottom for bottom in sheet.boxes[:, 1] if bottom > 17 * POINT) < 0.5 * sheet.height


@pytest.mark.slow
def test_panels_keep_their_axes(fit: Any, tmp_path: Path) -> None:
    """Below the title of a panel stands the name of its axis, on the same page."""
    pages = check(fit.report(tmp_path / "card.pdf"))
    assert sum(len(sheet.titles) for sheet in pages) == 2
    for sheet in pages:
        for title in sheet.titles:
            assert any(50 < title - axis < 300 for axis in sheet.axes)


@pytest.mark.slow
def test_trends_and_many_channels_are_whole_on_paper(tmp_path: Path) -> None:
    from test_report_time_page import fitted

    pages = check(fitted(9).report(tmp_path / "trends.pdf"))
    whole = " ".join(sheet.text for sheet in pages)
    for words in ("Trends", "Coefficients", "time_constant", "The material over time"):
        assert words in whole
    # The table that the screen folds away stands on paper, with each of its nine channels.
    assert "Coefficients of the parameters with 9 channels" in whole


@pytest.mark.slow
def test_the_command_prints_a_folder_and_a_page(fit: Any, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "card fit"
    folder.mkdir()
    write_report(fit, folder / "report.html")
    assert main(["report", str(folder), "--paper", "letter"]) == 0
    assert "report.pdf" in capsys.readouterr().out
    check(folder / "report.pdf", (215.9, 279.4))
    assert main(["report", str(folder / "report.html"), "-o", str(tmp_path / "b.pdf"), "--quiet"]) == 0
    check(tmp_path / "b.pdf")
    assert sorted(file.name for file in folder.iterdir()) == ["report.html", "report.pdf"]
    assert main(["certify", "gold", "-o", str(tmp_path / "gold.pdf"), "--quiet"]) == 0
    check(tmp_path / "gold.pdf")
    assert {file.name for file in tmp_path.iterdir()} == {"card fit", "b.pdf", "gold.pdf", "gold.json"}


@pytest.mark.slow
def test_maps_and_comparisons_are_whole_on_paper(fit: Any, tmp_path: Path) -> None:
    pytest.importorskip("zarr")
    from motes import compare
    from motes.maps import fit_map, simulate_map

    simulate_map(tmp_path / "small.zarr", (6, 5), times=2)
    fit_map(tmp_path / "small.zarr", "lambert", out=tmp_path / "fitted.zarr").report(tmp_path / "fitted.html")
    assert main(["report", str(tmp_path / "fitted.zarr"), "-o", str(tmp_path / "map.pdf"), "--quiet"]) == 0
    assert "How fits ended" in " ".join(sheet.text for sheet in check(tmp_path / "map.pdf"))
    pages = check(compare(fit.measurement, ["lambert", "oren_nayar"]).report(tmp_path / "compared.pdf"))
    assert "Residuals, all on one scale" in " ".join(sheet.text for sheet in pages)


def test_what_cannot_be_printed_is_said(
    fit: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    page = write_report(fit, tmp_path / "report.html")
    foreign = tmp_path / "foreign.html"
    foreign.write_text(
        "<!doctype html><html><head></head><body><script>fetch('http://a.example')</script></body></html>"
    )
    with pytest.raises(DataError, match="no report that Motes wrote"):
        print_page(foreign, tmp_path / "a.pdf")
    assert main(["report", str(tmp_path)]) == 0  # it holds a report.html
    capsys.readouterr()
    assert main(["report", str(page), "-o", str(tmp_path / "a.html")]) == 2
    assert "is no PDF by its name" in capsys.readouterr().err
    (tmp_path / "empty").mkdir()
    assert main(["report", str(tmp_path / "empty")]) == 2
    assert "comparison.html are not there" in capsys.readouterr().err

    monkeypatch.setenv(paper.VARIABLE, str(tmp_path / "none"))
    with pytest.raises(MotesError, match="is no program"):
        print_page(page, tmp_path / "a.pdf")
    monkeypatch.delenv(paper.VARIABLE)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(paper, "PLACES", ())
    with pytest.raises(MotesError, match="needs a browser") as caught:
        print_page(page, tmp_path / "a.pdf")
    assert "print it" in caught.value.hint
    if sys.platform != "win32":
        broken = tmp_path / "broken"
        broken.write_text("#!/bin/sh\necho no display >&2\nexit 3\n")
        broken.chmod(broken.stat().st_mode | stat.S_IXUSR)
        monkeypatch.setenv(paper.VARIABLE, os.fspath(broken))
        with pytest.raises(MotesError, match=r"printed nothing \(exit status 3\): no display"):
            print_page(page, tmp_path / "a.pdf")
    assert not (tmp_path / "a.pdf").exists()


def test_the_page_goes_without_scripts_and_network(fit: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What the browser is handed: a page whose policy allows neither, no profile of the user's, and no host."""
    seen = {}

    def run(command: list[str], **options: Any) -> Any:
        page = next(Path(word.removeprefix("file://")) for word in command if word.startswith("file:"))
        seen["text"], seen["command"] = page.read_text(encoding="utf-8"), command
        Path(next(w for w in command if w.startswith("--print-to-pdf=")).partition("=")[2]).write_bytes(b"%PDF-1.4")

    monkeypatch.setattr(paper.subprocess, "run", run)
    print_page(write_report(fit, tmp_path / "report.html"), tmp_path / "a.pdf")
    assert "default-src 'none'" in seen["text"].replace("&#x27;", "'")
    assert "<script" not in seen["text"]
    assert "--host-resolver-rules=MAP * ~NOTFOUND" in seen["command"]
    assert any(word.startswith("--user-data-dir=") for word in seen["command"])
