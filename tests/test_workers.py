"""Threads that share work: all tasks are done, once; a task that spreads work itself does it alone, instead of waiting for threads that wait for it."""

from __future__ import annotations

import os
import subprocess
import sys
import threading

import pytest

from motes import workers


def test_tasks_that_spread_work_themselves_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NUMBA_NUM_THREADS", "3")
    done: list[tuple[int, int]] = []
    inner: dict[int, set[int]] = {}

    def outer(task: int, _: None) -> None:
        def each(k: int, _: None) -> None:
            inner.setdefault(task, set()).add(threading.get_ident())
            done.append((task, k))

        assert workers.at_work()
        workers.spread(5, each, lambda: None)
        assert workers.at_work()

    whole = threading.Thread(target=lambda: workers.spread(7, outer, lambda: None), daemon=True)
    whole.start()
    whole.join(30)
    assert not whole.is_alive()
    assert sorted(done) == [(task, k) for task in range(7) for k in range(5)]
    assert all(len(threads) == 1 for threads in inner.values())
    assert not workers.at_work()


def test_after_an_error_threads_share_work_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NUMBA_NUM_THREADS", "2")

    def fails(task: int, _: None) -> None:
        raise ValueError("no")

    with pytest.raises(ValueError, match="no"):
        workers.spread(3, fails, lambda: None)
    assert not workers.at_work()
    both = threading.Barrier(2, timeout=30)  # passed by two threads at once, or never
    workers.spread(2, lambda task, _: both.wait() and None, lambda: None)


def test_what_is_found_out_beside_is_done_once_and_never_waits_for_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    for threads in ("1", "2"):
        monkeypatch.setenv("NUMBA_NUM_THREADS", threads)
        done: list[str] = []

        def said(what: str, done: list[str] = done) -> str:
            workers.spread(3, lambda task, _: None, lambda: None)
            done.append(what)
            return what

        first, second, third = (
            workers.Beside(lambda what=what: said(what), what != "idle") for what in ("a", "b", "idle")
        )
        workers.spread(5, lambda task, _: None, lambda: None)  # shares its tasks with threads that are busy
        assert [third.result(), second.result(), first.result()] == ["idle", "b", "a"]
        assert sorted(done) == ["a", "b", "idle"]


def test_an_error_beside_is_raised_where_the_result_is_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NUMBA_NUM_THREADS", "2")

    def fails() -> int:
        raise ValueError("no")

    failed = workers.Beside(fails)
    with pytest.raises(ValueError, match="no"):
        failed.result()


def test_alone_the_library_of_linear_algebra_wakes_no_thread() -> None:
    """In a process of its own, where no thread of another test is at work."""
    code = """
import time
import numpy as np
from motes import workers
matrices = np.random.default_rng(2).standard_normal((8, 48, 48))
matrices += np.swapaxes(matrices, 1, 2)
number_of = (workers._openblas() or (lambda: 1,))[0]
number, before = number_of(), time.process_time() - time.thread_time()
with workers.alone(), workers.alone():
    assert number_of() == 1
    for _ in range(5):
        np.linalg.eigh(matrices)
    time.sleep(0.1)  # in which a thread that was woken waits for more, busily
others = time.process_time() - time.thread_time() - before
assert others < 0.02, others
assert number_of() == number
"""
    environment = {name: value for name, value in os.environ.items() if name != "OPENBLAS_NUM_THREADS"}
    subprocess.run([sys.executable, "-c", code], check=True, env=environment)


def test_alone_ends_for_all_when_the_last_one_does() -> None:
    number_of = (workers._openblas() or (lambda: 1,))[0]
    number = number_of()
    with workers.alone():
        with workers.alone():
            pass
        assert number_of() == 1
    assert number_of() == number
