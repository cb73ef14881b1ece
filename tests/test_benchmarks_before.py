"""The page that compares the first version with today's: figures, quotients round by round, and what a process of either finds."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("llvmlite")
pytest.importorskip("scipy")

ROOT = Path(__file__).resolve().parents[1]
BENCHMARKS = ROOT / "benchmarks"


@pytest.fixture(scope="module")
def before() -> Iterator[Any]:
    """The script, which imports others of its folder."""
    sys.path.insert(0, str(BENCHMARKS))
    import before

    yield before
    sys.path.remove(str(BENCHMARKS))


def data(before: Any) -> dict[str, Any]:
    """Two rounds of a made-up run: the first version takes twice and four times the time, and had no robust functions."""
    today = {
        "texels_few": [1.2e-6, 1.1e-6],
        "texels_many": [0.5e-6, 1e-6],
        "loss_linear": [1e-6, 1e-6],
        "loss_cauchy": [3e-6, 5e-6],
        "rows32": [2e-9, 4e-9],
        "roof": [1e-9, 2e-9],
        "workers_1": [3e-6, 0.0],
        "workers_2": [2e-6, 0.0],
    }
    slower = [{k: [f * w, 2 * f * c] for k, (w, c) in today.items() if k != "loss_cauchy"} for f in (2.0, 4.0)]
    found = [
        {"level": before.AS_IT_IS, "state": state, "seconds": seconds}
        for pair in zip(slower, (today, today), strict=True)
        for state, seconds in zip(before.STATES, pair, strict=True)
    ]
    return {
        "rounds": 2,
        "machine": {"Processor": "made up"},
        "seconds": 60.0,
        "others": 0.01,
        "levels": [before.AS_IT_IS],
        "found": found,
    }


def cells(page: str, label: str) -> list[str]:
    """A row of the page."""
    (row,) = [line for line in page.splitlines() if line.startswith(f"| {label}")]
    return [cell.strip() for cell in row.strip("|").split("|")][1:]


def test_figures_and_quotients_of_rounds(before: Any) -> None:
    page = before.page(data(before))
    first, today, clock, processor, goal = cells(page, "fits of texels")
    assert first.startswith("0.750 (")  # 1 / 1 µs and 1 / 2 µs
    assert (today, goal) == ("2.00", "2")
    assert clock.startswith("3.00 (")
    assert processor.startswith("6.00 (")
    assert cells(page, "`cauchy` over")[:2] == ["not there", "5.00"]
    assert cells(page, "the same over stores")[1] == "0.500"
    assert cells(page, "efficiency from one to two")[1] == "0.750"
    assert "`model.pdf`" not in page  # nothing was measured, and nothing is said
    assert float(cells(page, "exponent of growth")[1]) == pytest.approx(0.959, abs=5e-4)


def test_a_process_finds_what_the_rows_ask_for(before: Any) -> None:
    """Names of one part's seconds; they are those of either version."""
    run = [sys.executable, str(BENCHMARKS / "before_rows.py"), str(ROOT), "values", "--quick"]
    found = json.loads(subprocess.check_output(run, text=True, env=os.environ))
    asked = {row.name for row in before.ROWS if row.name}
    assert {"rows32", "rows64", "gradient", "sample", "pdf", "eval_1", "eval_1000"} <= set(found) & asked
    assert all(len(seconds) == 2 and min(seconds) > 0 for seconds in found.values())


def test_a_history_without_the_first_version_is_said(before: Any, tmp_path: Path, monkeypatch: Any) -> None:
    pytest.importorskip("numba")
    monkeypatch.setattr(before, "FIRST", "0" * 40)
    with pytest.raises(before.MotesError, match="history does not hold commit 0000"):
        before.first_version(tmp_path)
