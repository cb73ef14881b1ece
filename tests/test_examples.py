"""Every example runs, says something, and takes less than ten seconds of computing, in units of work."""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from effort import unit

EXAMPLES = sorted((Path(__file__).resolve().parents[1] / "examples").glob("*.py"))


def run(example: Path, *arguments: str, folder: Path) -> str:
    """Standard output of an example, run in a folder of its own."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    environment = {**os.environ, "PYTHONWARNINGS": "error::RuntimeWarning", "TMPDIR": str(folder)}
    command = [sys.executable, str(example), *arguments]
    result = subprocess.run(command, capture_output=True, text=True, timeout=300, cwd=folder, env=environment)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert (result.returncode, result.stderr) == (0, "")
    assert after.ru_utime - before.ru_utime < 1000 * unit()
    return result.stdout


def test_examples_are_numbered() -> None:
    assert [example.name[:3] for example in EXAMPLES] == [f"{k:02d}_" for k in range(1, len(EXAMPLES) + 1)]
    assert len(EXAMPLES) >= 3


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_example_runs(example: Path, tmp_path: Path) -> None:
    assert run(example, folder=tmp_path).strip()


def test_plaster_example_writes_where_it_is_told(tmp_path: Path) -> None:
    out = run(EXAMPLES[0], "here", folder=tmp_path)
    assert "converged" in out
    assert sorted(path.name for path in (tmp_path / "here").iterdir()) == ["plaster.json", "report.html", "scans"]


def test_curet_example_fits_real_data(tmp_path: Path, shared: Callable[[str], Path]) -> None:
    out = run(EXAMPLES[2], str(shared("data/curet")), folder=tmp_path)
    assert "sigma_d = 0.384" in out
