"""Threads and processes: whatever is done from many at once gives the bits that it gives alone, and nothing waits for ever."""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import sys
import threading
import warnings
from pathlib import Path

import pytest

from motes.quiet import without_warnings

pytest.importorskip("zarr")
#: Free-threaded Python has not all of these: what needs them is left out there, and named.
WHOLE = all(importlib.util.find_spec(name) for name in ("OpenImageIO", "OpenEXR", "trimesh", "openpyxl", "mitsuba"))

SCRIPT = Path(__file__).with_name("concurrent_jobs.py")
SOURCES = str(Path(__file__).resolve().parents[1] / "src")


@pytest.mark.parametrize("how", ["threads", "fork", "spawn", "cold"])
def test_the_bits_are_those_of_one_thread(how: str, tmp_path: Path) -> None:
    """Reading every format, fitting, parsing, evaluating; from 8 threads, and from children of a process that has used all of it.

    ``fork`` forks while two threads of the parent are at work; ``cold`` has two processes of 8 threads compile the same kernels into one empty folder.
    """
    if how == "fork" and not sys.platform.startswith("linux"):
        pytest.skip("the platform does not fork with threads")
    environment = {**os.environ, "PYTHONPATH": SOURCES, "NUMBA_NUM_THREADS": "2"}
    if how == "cold":
        environment["MOTES_CACHE"] = str(tmp_path / "kernels")
    run = subprocess.run(
        [sys.executable, SCRIPT, how, tmp_path / "files"],
        capture_output=True,
        text=True,
        errors="replace",
        timeout=900,
        env=environment,
    )
    assert run.returncode == 0, run.stderr[-5000:]
    said = json.loads(run.stdout)
    serial, answers = said["serial"], said["answers"]
    assert all(len(one) == 16 for one in serial.values()), serial  # a digest, and no error
    assert len(answers) == {"threads": 8, "cold": 16}.get(how, 2), run.stderr[-5000:]
    for answer in answers:
        assert answer == serial
    assert said["filters kept"]
    assert run.stderr == "" or not WHOLE  # older packages, which free-threaded Python gets, warn
    if how == "cold":
        kept = [p.name for p in (tmp_path / "kernels").rglob("*") if p.is_file()]
        assert sorted(name[:6] for name in kept) == ["motes_"] * 2  # each compiled, whole, and nothing else left
    else:
        assert sum(name.startswith("read") for name in serial) >= (25 if WHOLE else 20)
    assert not WHOLE or not said["left out"]


def test_filters_of_warnings_are_what_they_were() -> None:
    """Two threads that set them aside, of which the one that began last ends last."""
    before, inside, out = list(warnings.filters), threading.Event(), threading.Event()

    def first() -> None:
        with without_warnings():
            inside.set()
            out.wait(0.3)  # the other one waits until this has put them back

    def second() -> None:
        inside.wait(60)
        with without_warnings():
            out.set()
            threading.Event().wait(0.2)

    threads = [threading.Thread(target=work) for work in (first, second)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(60)
    assert list(warnings.filters) == before
