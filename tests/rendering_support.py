"""What the tests of pictures share: the command line in a folder of its own."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from motes.cli import main

Run = Callable[..., tuple[int, str, str]]


@pytest.fixture
def motes(capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """``motes("dust", path)``: exit status, standard output and standard error, in an empty folder."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("MOTES_DEBUG", raising=False)

    def run(*arguments: object) -> tuple[int, str, str]:
        status = main([str(a) for a in arguments])
        captured = capsys.readouterr()
        return status, captured.out, captured.err

    return run


def message(err: str) -> tuple[str, str]:
    """The sentence and the hint of an error, which must be all there is."""
    lines = err.splitlines()
    assert len(lines) == 2, err
    assert lines[0].startswith("error: ")
    assert lines[1].startswith("hint: ")
    return lines[0], lines[1]
