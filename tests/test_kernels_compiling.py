"""Modules compiled in parts, by this process and by others: the same objects, and the same results whatever becomes of the others."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("llvmlite")

from motes.fitting.texels import TexelSolver
from motes.kernels import assembly, compiling, machine_code, object_code
from motes.kernels.lowering import Lowered, lowered

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="modules are compiled whole elsewhere")

MODULE = """
D = float64

def shared(x):
    return x * x + 1

@apart
def first(x):
    return shared(x) * 2

@apart
def second(x):
    return first(x) + shared(x + 1)

@kernel
def whole(x):
    return second(x) * 3 + shared(first(x))
"""


@pytest.fixture
def parts(monkeypatch: pytest.MonkeyPatch) -> Lowered:
    """A small module in three parts, for which other processes are started as for a long one."""
    for name, value in (("SHORT", 0), ("PART", 1)):
        monkeypatch.setattr(assembly, name, value)
    for name, value in (("LONG", 0), ("MANY", 0)):
        monkeypatch.setattr(compiling, name, value)
    monkeypatch.setenv("NUMBA_NUM_THREADS", "2")
    found = lowered(MODULE)
    assert len(found.parts) == 3
    return found


def alone(parts: Lowered) -> list[bytes]:
    return [machine_code.compiled(text) for text in parts.parts]


def test_parts_call_each_other(parts: Lowered) -> None:
    def by_python(x: int) -> int:
        def shared(x: int) -> int:
            return x * x + 1

        first = shared(x) * 2
        return (first + shared(x + 1)) * 3 + shared(first)

    whole = machine_code.loaded([machine_code.compiled(parts.text)], parts.kernels)["whole"]
    joined = machine_code.loaded(alone(parts), parts.kernels)["whole"]
    assert [joined(x) for x in range(9)] == [whole(x) for x in range(9)] == [by_python(x) for x in range(9)]


def test_another_process_makes_the_same_objects(parts: Lowered, monkeypatch: pytest.MonkeyPatch) -> None:
    expected, here = alone(parts), list[str]()
    makes = machine_code.compiled

    def late(text: str) -> bytes:  # the first part, until the other process has done all others
        here.append(text)
        with together._changed:
            assert together._changed.wait_for(lambda: len(together._found) == 2, 60)
        return makes(text)

    with compiling.Parts(MODULE) as together:
        monkeypatch.setattr(machine_code, "compiled", late)
        assert together.compiled(parts.parts) == expected
    assert len(here) == 1
    assert together._helpers[0].poll() is not None


@pytest.mark.parametrize(
    "program", ["", "import time; time.sleep(60)", "import os; os.write(1, b'no number')", "raise SystemExit(3)"]
)
def test_parts_that_do_not_come_back_are_compiled_here(
    parts: Lowered, monkeypatch: pytest.MonkeyPatch, program: str
) -> None:
    def started() -> subprocess.Popen[bytes]:
        run = [sys.executable, "-c", program]
        return subprocess.Popen(run, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)

    monkeypatch.setattr(compiling, "_started", started)
    monkeypatch.setattr(compiling, "PATIENCE", 0.5)
    with compiling.Parts(MODULE) as together:
        assert together._helpers
        assert together.compiled(parts.parts) == alone(parts)


def test_no_process_is_started_in_vain(parts: Lowered, monkeypatch: pytest.MonkeyPatch) -> None:
    def refused() -> None:
        raise AssertionError("started")

    monkeypatch.setattr(compiling, "_started", refused)
    monkeypatch.setenv("NUMBA_NUM_THREADS", "1")
    with compiling.Parts(MODULE) as together:  # one processor
        assert together.compiled(parts.parts) == alone(parts)
    monkeypatch.setenv("NUMBA_NUM_THREADS", "2")
    monkeypatch.setattr(compiling, "LONG", len(MODULE) + 1)
    with compiling.Parts(MODULE) as together:  # a short module
        assert together.compiled(parts.parts) == alone(parts)
    monkeypatch.undo()
    monkeypatch.setattr(sys, "executable", "/usr/bin/a-program")
    assert compiling._started() is None
    monkeypatch.setattr(sys, "executable", None)
    assert compiling._started() is None
    monkeypatch.undo()
    monkeypatch.setattr(object_code, "__file__", "in/an/archive.zip/object_code.py")
    assert compiling._started() is None


def test_first_fits_are_those_of_a_filled_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(5)
    theta, phi = rng.uniform(0, 1.2, (2, 24)), rng.uniform(-3, 3, (2, 24))
    wi, wo = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1)
    values = rng.uniform(0.1, 0.3, (40, 24, 3)).astype(np.float32)

    def fitted(folder: str, threads: str) -> list[bytes]:
        monkeypatch.setenv("MOTES_CACHE", str(tmp_path / folder))
        monkeypatch.setenv("NUMBA_NUM_THREADS", threads)
        fit = TexelSolver("oren_nayar", wi, wo, 3).fit(values, [[0.3, 0.3, 0.3, 0.3]])
        return [part.tobytes() for part in (fit.x, fit.stderr, fit.relative_rms, fit.status, fit.verdicts)]

    monkeypatch.setattr(compiling, "LONG", 0)
    monkeypatch.setattr(assembly, "SHORT", 0)
    first = fitted("by two", "2")
    assert fitted("by two", "2") == fitted("by one", "1") == first
    kept = [{path.name: path.read_bytes() for path in (tmp_path / name).iterdir()} for name in ("by two", "by one")]
    assert kept[0] == kept[1]
