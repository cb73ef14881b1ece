"""What is built from a commit: the same bytes wherever and whenever, and everything that the package needs."""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
import time
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
EPOCH = "1700000000"


def tracked() -> list[str]:
    """The files of the repository as git lists them."""
    if shutil.which("git") is None or not (ROOT / ".git").exists():
        pytest.skip("not a clone of the repository")
    done = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True, timeout=60)
    return [name for name in done.stdout.split("\0") if name and (ROOT / name).is_file()]


def build(folder: Path, when: float, mask: int) -> dict[str, bytes]:
    """Copy what a wheel and a source archive are made of, and build both; name -> bytes."""
    folder.mkdir()
    for name in tracked():
        if name.startswith(("src/", "tools/")) or "/" not in name:
            to = folder / name
            to.parent.mkdir(parents=True, exist_ok=True)
            to.write_bytes((ROOT / name).read_bytes())
            os.utime(to, (when, when))
            to.chmod(0o666 & ~mask)
    environment = os.environ | {"SOURCE_DATE_EPOCH": EPOCH, "TZ": "UTC" if mask == 0o22 else "Asia/Tokyo"}
    command = [sys.executable, "-m", "build", "--no-isolation", "--outdir", str(folder / "dist"), str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=300)
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    return {path.name: path.read_bytes() for path in sorted((folder / "dist").iterdir())}


def test_archives_are_the_same_bytes_from_the_same_files(tmp_path: Path) -> None:
    pytest.importorskip("build")
    pytest.importorskip("hatchling")
    first = build(tmp_path / "a", time.time() - 1e7, 0o22)
    second = build(tmp_path / "a folder elsewhere", time.time(), 0o77)
    assert len(first) == 2
    assert {n: hashlib.sha256(d).hexdigest() for n, d in first.items()} == {
        n: hashlib.sha256(d).hexdigest() for n, d in second.items()
    }
    (wheel,) = (name for name in first if name.endswith(".whl"))
    (tmp_path / wheel).write_bytes(first[wheel])
    with zipfile.ZipFile(tmp_path / wheel) as archive:
        held = {name for name in archive.namelist() if name.startswith("motes/")}
        assert {entry.date_time for entry in archive.infolist()} == {(2023, 11, 14, 22, 13, 20)}
    assert held == {name.removeprefix("src/") for name in tracked() if name.startswith("src/motes/")}


def test_make_dist_takes_its_time_from_the_commit() -> None:
    text = (ROOT / "Makefile").read_text(encoding="utf-8")
    assert "SOURCE_DATE_EPOCH=$$(git log -1 --format=%ct) $(BIN)/python -m build" in text
