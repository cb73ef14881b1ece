"""Commands killed at some of their file operations, and run again; docs/robustness.md has the counts for all of them."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("zarr")  # among the inputs is a map

SCRIPT = Path(__file__).with_name("kill_commands.py")
SOURCES = str(Path(__file__).resolve().parents[1] / "src")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
@pytest.mark.parametrize(("job", "step"), [("fit over another", 13), ("export over another", 7)])
def test_killed_anywhere_nothing_is_half_made(job: str, step: int, tmp_path: Path) -> None:
    """What is there is the old or the new, whole; the same command then makes the same bits and leaves nothing else."""
    environment = {**os.environ, "PYTHONPATH": SOURCES, "NUMBA_NUM_THREADS": "1"}
    command = [sys.executable, SCRIPT, job, tmp_path / "killed", str(step)]
    run = subprocess.run(command, capture_output=True, text=True, timeout=600, env=environment)
    assert run.returncode == 0, run.stderr
    whole, *killed = (json.loads(line) for line in run.stdout.splitlines())
    assert whole["operations"] >= 4
    assert len(killed) >= 4
    assert [one["wrong"] for one in killed] == [""] * len(killed)
    assert whole["before"] != whole["after"]
    assert any(one["after"] == one["before"] for one in killed)  # killed before the decision
    assert any(one["after"] == whole["after"] for one in killed)  # and behind it
