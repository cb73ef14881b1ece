"""What the tests of every room share: the data beside the repository, and how hypothesis behaves."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

SHARED = Path(__file__).resolve().parents[2] / "shared"

# Examples are the same in every run; a busy machine is no failure.
settings.register_profile(
    "motes", deadline=None, derandomize=True, max_examples=50, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("motes")


@pytest.fixture(scope="session")
def shared() -> Callable[[str], Path]:
    """``shared("data/curet/abrdf.dat")``: a path in ../shared; the test is skipped, by name, where it is missing."""

    def find(name: str) -> Path:
        path = SHARED / name
        if not path.exists():
            pytest.skip(f"../shared/{name} is missing")
        return path

    return find


@pytest.fixture(scope="session")
def shared_file(shared: Callable[[str], Path]) -> Callable[[str], Path]:
    """``shared_file("curet/abrdf.dat")``: the same, for the measurements in ../shared/data."""
    return lambda name: shared(f"data/{name}")


@pytest.fixture
def motes(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Callable[..., tuple[int, str, str]]:
    """``motes("fit", path)``: exit status, standard output and standard error, in an empty folder."""
    from motes.cli.main import main

    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("MOTES_DEBUG", raising=False)

    def run(*arguments: object) -> tuple[int, str, str]:
        status = main([str(a) for a in arguments])
        captured = capsys.readouterr()
        return status, captured.out, captured.err

    return run
