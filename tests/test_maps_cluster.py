"""Maps on several processes: the same bits, killed workers, schedulers that go away."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("zarr")
pytest.importorskip("distributed")
pytest.importorskip("cryptography")

import distributed

import maps_support as support
from motes import maps
from motes.errors import MotesError
from motes.maps import cluster
from motes.maps.work import DONE, Outcome

SECONDS = 120
BLOCK = (4, 4)


@pytest.fixture(scope="module")
def paint(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return maps.simulate_map(tmp_path_factory.mktemp("maps") / "paint.zarr", (24, 24), times=2, lights=8, chunk=4).path


@pytest.fixture(scope="module")
def alone(paint: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Fitted by one process."""
    return maps.fit_map(paint, "lambert", out=tmp_path_factory.mktemp("alone") / "a.zarr", block=BLOCK).path


def children(word: str) -> list[int]:
    """Processes below this one whose command line has a word, youngest last."""
    found = []
    for folder in Path("/proc").iterdir():
        if folder.name.isdigit():
            try:
                command = (folder / "cmdline").read_bytes().decode()
                parent = int((folder / "stat").read_text().rpartition(")")[2].split()[1])
            except (OSError, ValueError):
                continue
            if word in command and parent == os.getpid():
                found.append(int(folder.name))
    return sorted(found)


@contextmanager
def dask(*arguments: str, **environment: str) -> Iterator[subprocess.Popen[bytes]]:
    """A process of dask's command line, ended with all its children."""
    command = [sys.executable, "-m", "dask", *arguments]
    process = subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True,
        env={**os.environ, **environment},
    )  # fmt: skip
    try:
        yield process
    finally:
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait(SECONDS)


@contextmanager
def scheduler(folder: Path) -> Iterator[tuple[str, subprocess.Popen[bytes]]]:
    """A scheduler on a free port of this machine: its address and process."""
    import json

    file = folder / "scheduler.json"
    arguments = ("scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard", "--scheduler-file", str(file))
    with dask(*arguments) as process:
        until = time.monotonic() + SECONDS
        while not file.exists() and time.monotonic() < until:
            time.sleep(0.05)
        time.sleep(0.05)
        yield json.loads(file.read_text())["address"], process


def test_two_processes_and_one_killed_give_the_bits_of_one(
    paint: Path, alone: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    killed: list[int] = []
    tasks: list[list[tuple[int, int]]] = []
    submitted, ended, most = 0, 0, 0
    real = distributed.Client.map

    def counted(self: distributed.Client, function: Any, *lists: list[Any], **options: Any) -> Any:
        nonlocal submitted, most
        tasks.extend(lists[2])
        submitted += sum(map(len, lists[2]))
        most = max(most, submitted - ended)
        return real(self, function, *lists, **options)

    monkeypatch.setattr(distributed.Client, "map", counted)

    def progress(done: int, total: int, what: str) -> None:
        nonlocal ended
        ended = done // 16
        if done > total // 4 and not killed:
            # The workers are the youngest of the processes that multiprocessing started.
            killed.append(children("spawn_main")[-1])
            os.kill(killed[0], signal.SIGKILL)

    out = maps.fit_map(paint, "lambert", out=tmp_path / "b.zarr", block=BLOCK, workers=2, progress=progress)
    assert killed
    # Submitted as others end, never all at once, ever fewer together; again only what died with the worker before it was fetched, each alone.
    first, seen = [task for task in tasks if len(task) > 1], Counter(block for task in tasks for block in task)
    assert [len(task) for task in tasks[:4]] == [9, 6, 5, 4]
    assert sum(map(len, first)) < 36 == len(seen)
    again = [block for block, count in seen.items() if count > 1]
    assert len(again) <= sum(sorted(map(len, tasks))[-2 * cluster.MOST_IN_FLIGHT :])
    assert all(sum(block in task for task in first) <= 1 for block in again)
    assert most < 36 + len(again)
    assert out.failures == ()
    assert support.contents(out.path) == support.contents(alone)


@pytest.mark.parametrize("times", [1, 9])
def test_a_result_that_dies_with_its_worker_is_made_again(
    paint: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, times: int
) -> None:
    """A worker may end a block and die before its word is fetched; one that always does is given up, and said."""
    real, seen = cluster._outcomes, 0

    def lost(future: Any, task: list[tuple[int, int]], *rest: Any) -> Any:
        nonlocal seen
        if (1, 1) in task and seen < times:
            assert (len(task) == 1) == (seen > 0)  # alone, so that it takes no other block with it
            seen += 1
            return None
        return real(future, task, *rest)

    monkeypatch.setattr(cluster, "_outcomes", lost)
    out = maps.fit_map(paint, "lambert", out=tmp_path / "b.zarr", block=BLOCK, workers=1)
    if times == 1:
        assert out.failures == ()
        assert out.done().all()
    else:
        assert seen == 1 + cluster.AGAIN
        assert out.failures == (((1, 1), cluster.TOO_MANY_DEATHS),)


class Ended:
    """The future of a task whose worker died where it came to one block."""

    def __init__(self, task: list[tuple[int, int]]) -> None:
        self.task, self.status = task, "error" if (1, 1) in task else "finished"

    def add_done_callback(self, put: Any) -> None:
        put(self)

    def result(self, timeout: float) -> list[Outcome]:
        return [Outcome(block, DONE, 16) for block in self.task]

    def exception(self, timeout: float) -> Exception:
        return distributed.KilledWorker("task", None, 4)


class Deadly:
    """A client of two workers, and the tasks that it was given."""

    status = "running"

    def __init__(self) -> None:
        self.tasks: list[list[tuple[int, int]]] = []

    def nthreads(self) -> dict[str, int]:
        return {"one": 1, "other": 1}

    def map(self, work: Any, paths: Any, runs: Any, tasks: Any, *, key: list[str], pure: bool) -> list[Ended]:
        assert len(set(key)) == len(tasks) <= 2 * cluster.MOST_IN_FLIGHT
        self.tasks += tasks
        return [Ended(task) for task in tasks]


def test_a_block_that_kills_its_workers_takes_no_other_with_it(alone: Path) -> None:
    fitted, client = maps.open_map(alone), Deadly()
    found = list(cluster.windowed(client, fitted, list(fitted.blocks), "here"))
    assert sorted(outcome.block for outcome in found) == sorted(fitted.blocks)
    assert [(o.block, o.reason) for o in found if o.kind != DONE] == [((1, 1), cluster.TOO_MANY_DEATHS)]
    first = next(task for task in client.tasks if (1, 1) in task)
    assert len(first) == 9
    assert all([block] in client.tasks for block in first)
    assert sum(map(len, client.tasks)) == 36 + 9


def test_only_this_run_reaches_the_scheduler_that_it_starts() -> None:
    """Whoever reaches a scheduler runs functions on its workers; its port is open to every user of the machine."""
    from distributed.security import Security

    with ExitStack() as stack:
        stack.enter_context(cluster._quiet())
        client = cluster._client(stack, None, 1)
        assert client.submit(os.getpid).result(SECONDS) != os.getpid()
        address = client.scheduler.address
        (worker,) = client.scheduler_info()["workers"]
        for served in (address, worker):
            _, _, port = served.partition("://127.0.0.1:")
            strangers: list[dict[str, Any]] = [
                {"address": f"tcp://127.0.0.1:{port}"},
                {"address": f"tls://127.0.0.1:{port}", "security": Security.temporary()},
            ]
            for stranger in strangers:
                with pytest.raises(OSError, match=r"(?i)timed out|timeout|tls|handshake|reset|closed"):
                    distributed.Client(**stranger, timeout=2, set_as_default=False)


def test_workers_of_a_scheduler_and_a_scheduler_that_dies(paint: Path, alone: Path, tmp_path: Path) -> None:
    with scheduler(tmp_path) as (address, process):
        worker = ("worker", address, "--host", "127.0.0.1", "--nworkers", "1", "--nthreads", "1", "--no-dashboard")
        with dask(*worker, DASK_DISTRIBUTED__WORKER__MEMORY__TERMINATE="false"):
            out = maps.fit_map(paint, "lambert", out=tmp_path / "b.zarr", block=BLOCK, scheduler=address)
            assert support.contents(out.path) == support.contents(alone)

            def progress(done: int, total: int, what: str) -> None:
                if done > total // 4:
                    os.kill(process.pid, signal.SIGKILL)

            with pytest.raises(MotesError, match="went away"):
                maps.fit_map(
                    paint, "lambert", out=tmp_path / "c.zarr", block=BLOCK, scheduler=address, progress=progress
                )
    done = maps.open_map(tmp_path / "c.zarr").done()
    assert done.size // 4 < done.sum() < done.size
    maps.fit_map(paint, "lambert", out=tmp_path / "c.zarr", block=BLOCK)
    assert support.contents(tmp_path / "c.zarr") == support.contents(alone)


def test_a_scheduler_that_is_not_there(paint: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cluster, "CONNECT", 0.5)
    for address in ("tcp://127.0.0.1:9", "nonsense", "gopher://127.0.0.1:9"):
        with pytest.raises(MotesError, match="no scheduler answers") as caught:
            maps.fit_map(paint, "lambert", out=tmp_path / "b.zarr", block=BLOCK, scheduler=address)
        assert "dask scheduler" in caught.value.hint


def test_a_scheduler_without_workers_is_given_up(paint: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cluster, "PATIENCE", 1.0)
    with scheduler(tmp_path) as (address, _), pytest.raises(MotesError, match="has no worker"):
        maps.fit_map(paint, "lambert", out=tmp_path / "b.zarr", block=BLOCK, scheduler=address)


def test_failures_travel(paint: Path, tmp_path: Path) -> None:
    source = support.copy(paint, tmp_path / "map.zarr")
    support.damage(source, "3/1/0/0/0")
    out = maps.fit_map(source, "lambert", out=tmp_path / "b.zarr", block=BLOCK, workers=1)
    assert [block for block, _ in out.failures] == [(3, 1)]
    assert out.done().sum() == out.done().size - 1


def test_a_script_without_a_main_guard_is_told(paint: Path, tmp_path: Path) -> None:
    script = f"""
from motes import maps
from motes.errors import MotesError
try:
    maps.fit_map({str(paint)!r}, "lambert", out={str(tmp_path / "b.zarr")!r}, workers=1)
except MotesError as error:
    print("told:", error)
"""
    result = subprocess.run([sys.executable, "-"], input=script, capture_output=True, text=True, timeout=SECONDS)
    assert "told: 1 worker processes could not be started" in result.stdout
    assert "__main__" in result.stdout
