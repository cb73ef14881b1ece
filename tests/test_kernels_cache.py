"""Where kernels are kept: the folder, what happens when it cannot be used, and several processes at once."""

from __future__ import annotations

import logging
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("llvmlite")

from motes.kernels import engine
from motes.models import Lambert

UP = np.array([[0.0, 0.0, 1.0]])
EXPECTED = 0.5 / np.pi


@pytest.fixture
def fresh(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """An empty cache folder, and an engine that remembers nothing."""
    monkeypatch.setattr(engine, "_kernels", {})
    monkeypatch.setenv("MOTES_CACHE", str(tmp_path / "kernels"))
    return tmp_path / "kernels"


def said(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    sentences: list[str] = []
    monkeypatch.setattr(engine, "on_compile", sentences.append)
    return sentences


def evaluated() -> float:
    return float(engine.evaluate(Lambert(0.5), UP, UP).item())


def test_a_kernel_is_compiled_once_and_then_loaded(fresh: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    sentences = said(monkeypatch)
    assert evaluated() == pytest.approx(EXPECTED, rel=1e-15)
    assert sentences == [f"compiling the evaluation of Lambert in float64 once (kept in {fresh})"]
    (kept,) = fresh.iterdir()
    assert kept.name.startswith("motes_")
    when = kept.stat().st_mtime_ns
    monkeypatch.setattr(engine, "_kernels", {})  # as in another process
    assert evaluated() == pytest.approx(EXPECTED, rel=1e-15)
    assert len(sentences) == 1
    assert [path.stat().st_mtime_ns for path in fresh.iterdir()] == [when]


def test_other_values_and_other_shapes_need_no_other_kernel(fresh: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    sentences = said(monkeypatch)
    for model in (Lambert(0.5), Lambert(0.7), Lambert(np.array([0.2]))):
        engine.evaluate(model, UP, UP)
        engine.evaluate(model, np.broadcast_to(UP, (4, 5, 3)), UP)
    assert len(sentences) == 1


@pytest.mark.skipif(sys.platform == "win32", reason="no permission bits")
def test_the_folder_is_for_its_owner_only(fresh: Path) -> None:
    evaluated()
    assert fresh.stat().st_mode & 0o077 == 0


def test_the_folder_follows_the_platform(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("MOTES_CACHE", "XDG_CACHE_HOME", "LOCALAPPDATA"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(Path, "home", lambda: Path("/home/somebody"))
    for platform, expected in {
        "linux": ".cache/motes",
        "darwin": "Library/Caches/motes",
        "win32": "AppData/Local/motes/Cache",
    }.items():
        monkeypatch.setattr(sys, "platform", platform)
        assert engine.cache_folder() == Path("/home/somebody") / expected
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setenv("XDG_CACHE_HOME", "/caches")
    assert engine.cache_folder() == Path("/caches/motes")
    monkeypatch.setenv("MOTES_CACHE", "/mine")
    assert engine.cache_folder() == Path("/mine")


def test_a_folder_that_cannot_be_made_is_done_without(
    fresh: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    sentences = said(monkeypatch)
    fresh.write_text("a file where the folder would be")
    with caplog.at_level(logging.INFO, logger="motes.kernels"):
        assert evaluated() == pytest.approx(EXPECTED, rel=1e-15)
    assert f"the cache folder {fresh} cannot be used" in caplog.text
    assert sentences == [f"compiling the evaluation of Lambert in float64 once (not kept: {fresh} cannot be used)"]
    assert fresh.read_text() == "a file where the folder would be"


def test_broken_contents_are_replaced(fresh: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    sentences = said(monkeypatch)
    evaluated()
    (kept,) = fresh.iterdir()
    whole = kept.read_bytes()
    flipped = bytearray(whole)
    flipped[-100] ^= 1
    for broken in (
        whole[: len(whole) // 2],
        whole[:40],
        b"",
        bytes(flipped),
        b"[]\n" + whole.partition(b"\n")[2],
        re.sub(rb'"kernels": \{.*?\}', b'"kernels": []', whole, count=1),
    ):  # as if a disk had been full, or lost a bit
        kept.write_bytes(broken)
        monkeypatch.setattr(engine, "_kernels", {})
        assert evaluated() == pytest.approx(EXPECTED, rel=1e-15)
        assert kept.read_bytes() == whole
    assert len(sentences) == 7


def test_a_failed_write_leaves_nothing_behind(fresh: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def failing(source: object, target: object) -> None:
        raise OSError("no space left on device")

    monkeypatch.setattr(os, "replace", failing)
    assert evaluated() == pytest.approx(EXPECTED, rel=1e-15)
    assert list(fresh.iterdir()) == []


def test_two_processes_may_compile_the_same_kernel(fresh: Path) -> None:
    program = """
import numpy as np
from motes.kernels import engine
from motes.models import Lambert
up = np.array([[0.0, 0.0, 1.0]])
print(float(engine.evaluate(Lambert(0.5), up, up).item()))
"""
    run = [sys.executable, "-W", "error", "-c", program]
    environment = os.environ | {"MOTES_CACHE": str(fresh)}
    both = [
        subprocess.Popen(run, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment)
        for _ in range(2)
    ]
    for process in both:
        output, complaint = process.communicate(timeout=120)
        assert process.returncode == 0, complaint
        assert float(output) == pytest.approx(EXPECTED, rel=1e-15)
        assert complaint == ""
    assert len(list(fresh.iterdir())) == 1
    assert not [path for path in fresh.rglob("*") if path.suffix == ".tmp"]


def test_importing_motes_does_not_import_llvm() -> None:
    program = "import sys, motes, motes.kernels.engine; print('llvmlite' in sys.modules)"
    output = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout
    assert output.strip() == "False"
