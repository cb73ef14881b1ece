"""Which sources made a page."""

from __future__ import annotations

import subprocess
from functools import partial
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def commit_of_sources() -> str:
    """The last commit that changed `src`, with a word where it has been changed since."""
    run = partial(subprocess.run, cwd=ROOT, check=True, capture_output=True, text=True)
    commit = run(["git", "log", "-1", "--format=%h", "--", "src"]).stdout.strip()
    return commit + (", changed" if run(["git", "status", "--porcelain", "src"]).stdout.strip() else "")
