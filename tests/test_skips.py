"""Skips are counted by reason at the end of a run, and fail where everything is to be installed."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import skips

TESTS = """
import pytest
def test_absent(): pytest.importorskip("nonsense_a")
def test_absent_too(): pytest.importorskip("nonsense_a")
def test_machine(): pytest.skip("mounting is not allowed here: EPERM")
@pytest.mark.skipif(True, reason="no GPU")
def test_marked(): pass
@pytest.mark.xfail(strict=True)
def test_expected(): raise AssertionError
def test_passes(): pass
"""


def ran(folder: Path, **environment: str) -> list[str]:
    """What pytest says of these tests, and of a file that is skipped as a whole."""
    (folder / "test_some.py").write_text(TESTS, encoding="utf-8")
    (folder / "test_whole.py").write_text("import pytest\npytest.importorskip('nonsense_b')\n", encoding="utf-8")
    command = [sys.executable, "-m", "pytest", "-p", "skips", "-p", "no:cacheprovider", "--rootdir", folder, "-q"]
    environment = {"PYTHONPATH": str(Path(__file__).parent), "MOTES_REQUIRE_EXTRAS": "0"} | environment
    command += ["--continue-on-collection-errors", folder]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, env=os.environ | environment, cwd=folder)
    return done.stdout.splitlines()


def test_a_run_says_what_it_skipped_and_why(tmp_path: Path) -> None:
    said = ran(tmp_path)
    first = said.index("skipped: 4 tests and 1 file")
    assert said[first + 1 : first + 5] == [
        "  2 tests: could not import 'nonsense_a'",
        "  1 file: could not import 'nonsense_b'",
        "  1 test: mounting is not allowed here",
        "  1 test: no GPU",
    ]
    assert "1 passed, 5 skipped, 1 xfailed" in said[-1]


def test_what_can_be_installed_must_be_where_that_is_asked(tmp_path: Path) -> None:
    said = ran(tmp_path, MOTES_REQUIRE_EXTRAS="1")
    first = said.index("skipped: 1 test")
    assert said[first + 1] == "  1 test: mounting is not allowed here"
    assert "2 failed, 1 passed, 1 skipped, 1 xfailed, 2 errors" in said[-1]
    text = "\n".join(said)
    assert "skipped, and MOTES_REQUIRE_EXTRAS is set: could not import 'nonsense_b'" in text
    assert "skipped, and MOTES_REQUIRE_EXTRAS is set: no GPU" in text


def test_measurements_are_excused_only_where_there_are_none() -> None:
    assert skips.excused("../shared/data/curet/abrdf.dat is missing") != skips.SHARED.exists()
    assert not skips.excused("no WebGPU adapter here (Vulkan, lavapipe): none")
