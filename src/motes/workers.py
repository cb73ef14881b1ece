"""The threads of this process that share work: NumPy and compiled kernels let go of the interpreter's lock.

``NUMBA_NUM_THREADS`` limits them, a name that other libraries heed, too; otherwise there is one for each processor that the process may use.
"""

from __future__ import annotations

import ctypes
import importlib
import itertools
import os
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from functools import cache
from typing import Generic, TypeVar

T = TypeVar("T")

_pool: ThreadPoolExecutor | None = None
_lock = threading.RLock()
_here = threading.local()
# How many are in `alone`, and how many threads OpenBLAS had before.
_asking, _before = 0, 1


def threads() -> int:
    """How many threads work at once."""
    given = os.environ.get("NUMBA_NUM_THREADS", "")
    if given.isdigit() and int(given) > 0:
        return int(given)
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def spread(tasks: int, work: Callable[[int, T], None], room: Callable[[], T]) -> None:
    """Call ``work(task, memory)`` for each of so many tasks, in turn on all threads; ``room()`` makes a thread's own memory.

    An error in a task ends the work and is raised, once no thread is at work any more.  What a task spreads itself, its own thread does.
    """
    waiting = iter(range(tasks))
    lock = threading.Lock()

    def take() -> int | None:
        with lock:
            return next(waiting, None)

    def drain() -> None:
        outer, _here.at_work = at_work(), True
        try:
            memory = room()
            while (task := take()) is not None:
                work(task, memory)
        finally:
            _here.at_work = outer

    others: list[Future[None]] = []
    if tasks > 1 and threads() > 1 and not at_work():
        pool = _helpers()
        with suppress(
            RuntimeError
        ):  # no more threads can be had (ulimit -v, ulimit -u): those that there are do the work
            for _ in range(min(threads(), tasks) - 1):
                others.append(pool.submit(drain))
    try:
        drain()
    finally:  # interrupted: the others stop after their task, and nobody frees memory that they use
        while take() is not None:
            pass
        for other in others:
            if not other.cancel():  # not begun, behind what is done `Beside` this
                other.result()


class Beside(Generic[T]):
    """What another thread finds out meanwhile, where one is free and it is `worthwhile`; else whoever asks for it does so then."""

    def __init__(self, work: Callable[[], T], worthwhile: bool = True) -> None:
        self._work = work
        self._other: Future[T] | None = None
        if worthwhile and threads() > 1 and not at_work():
            with suppress(RuntimeError):
                self._other = _helpers().submit(self._alone)

    def result(self) -> T:
        """What was found; an error of the work is raised here."""
        if self._other is None or self._other.cancel():
            return self._work()
        return self._other.result()

    def _alone(self) -> T:
        outer, _here.at_work = at_work(), True
        try:
            return self._work()
        finally:
            _here.at_work = outer


@contextmanager
def alone() -> Iterator[None]:
    """Within it OpenBLAS, where that is NumPy's library of linear algebra, has no threads but the one that asks.

    It shares work as small as eigenvalues of some thirty columns among threads of its own, and these wait busily for more: ten times the
    processor time, and more by the clock where other threads want the processors.
    """
    global _asking, _before
    library = _openblas()
    if library is None:
        yield
        return
    number_of, set_number = library
    with _lock:
        if not _asking:
            _before = number_of()
            set_number(1)
        _asking += 1
    try:
        yield
    finally:
        with _lock:
            _asking -= 1
            if not _asking:
                set_number(_before)


@cache
def _openblas() -> tuple[Callable[[], int], Callable[[int], None]] | None:
    """How many threads it may use, and what says so; None where NumPy has another library, or it is not to be found."""
    with suppress(Exception):
        numpy = ctypes.CDLL(importlib.import_module("numpy.linalg._umath_linalg").__file__)
        for before, after in itertools.product(("scipy_", ""), ("64_", "")):
            with suppress(AttributeError):
                return tuple(getattr(numpy, f"{before}openblas_{what}_num_threads{after}") for what in ("get", "set"))
    return None


def at_work() -> bool:
    """Whether this thread is at a task of `spread`."""
    return bool(getattr(_here, "at_work", False))


def _helpers() -> ThreadPoolExecutor:
    global _pool
    with _lock:
        if _pool is None:
            _pool = ThreadPoolExecutor(max(1, threads() - 1), thread_name_prefix="motes")
        return _pool


def _forked() -> None:
    """A child has none of its parent's threads, and a lock may have been held by one of them."""
    global _pool, _lock, _asking
    _pool, _lock, _asking = None, threading.RLock(), 0


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forked)
