"""What the tests of every room share: the data beside the repository, and how hypothesis behaves."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from blender_support import NEEDED, interpreters, named, there
from skips import (
    SHARED,
    pytest_make_collect_report,  # noqa: F401 (a hook)
    pytest_runtest_makereport,  # noqa: F401 (a hook)
    pytest_terminal_summary,  # noqa: F401 (a hook)
)

# A thread for each process: threads of linear algebra wait for one another by spinning, and where two processes share two cores, small systems took
# four times as long.  NumPy reads this when it is first imported, which is later.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

# Examples are the same in every run; a busy machine is no failure.
settings.register_profile(
    "motes", deadline=None, derandomize=True, max_examples=50, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("motes")


#: Bytes of kernels beyond which the folder of `kernels` is emptied: those of past versions of the code are of no use.
ENOUGH = 300_000_000


def pytest_sessionstart(session: pytest.Session) -> None:
    """Kernels of past runs are kept, but not for ever."""
    cache = getattr(session.config, "cache", None)
    if cache is not None and "PYTEST_XDIST_WORKER" not in os.environ:
        folder = cache.mkdir("kernels")
        if sum(path.stat().st_size for path in folder.rglob("*") if path.is_file()) > ENOUGH:
            shutil.rmtree(folder)


@pytest.fixture(scope="session", autouse=True)
def kernels(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """The folder of compiled kernels: one for all processes of a run, kept between runs in pytest's cache folder, never the user's.

    Its files are named by what they were made from, as the user's are.  ``MOTES_CACHE`` in the environment names another;
    ``--cache-clear`` empties it, for a cold start; test_kernels_cache.py begins with an empty one always.
    """
    cache = getattr(request.config, "cache", None)
    if chosen := os.environ.get("MOTES_CACHE"):
        folder = Path(chosen)
    elif cache is not None:
        folder = cache.mkdir("kernels")
    else:  # with -p no:cacheprovider
        base = tmp_path_factory.getbasetemp()
        folder = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "kernels"
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("MOTES_CACHE", str(folder))
        yield folder


@pytest.fixture(scope="session", params=interpreters(), ids=named)
def blender(request: pytest.FixtureRequest) -> str:
    """A Python that has the package bpy: each of those that `MOTES_BPY` names in turn."""
    python: str = request.param
    if not there(python):
        pytest.skip(NEEDED)
    return python


@pytest.fixture(scope="module", autouse=True)
def usual_variant() -> Iterator[None]:
    """Mitsuba's variant is the process's, and Motes keeps one that is set: what a file chose does not outlive it.

    The scalar variant gives the same numbers, so no test would notice, but for a hundred times the time.
    """
    yield
    if sys.modules.get("mitsuba") is not None:
        from motes.rendering import llvm, load_mitsuba

        if llvm.prepared().path is not None:
            load_mitsuba("llvm_ad_rgb")


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
