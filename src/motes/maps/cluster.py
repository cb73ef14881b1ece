"""Blocks on the workers of a Dask scheduler: as many in flight as keep the workers busy, never all of them."""

from __future__ import annotations

import logging
import queue
import time
from collections import Counter, deque
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from typing import Any

from motes.errors import MissingExtraError, MotesError
from motes.maps.fitted import FittedMap
from motes.maps.work import UNREADABLE, Outcome, work_on

#: Tasks in flight for each thread of a worker: one that runs, and some on the way; more are submitted when the least is reached.
LEAST_IN_FLIGHT, MOST_IN_FLIGHT = 2, 4
#: A task is one of so many parts of the blocks that are left for each thread, and so many blocks at most: what a task costs besides its blocks, some
#: milliseconds here and on the worker, is paid less often, and towards the end tasks are single blocks, so that workers end together.
PARTS, MOST_TOGETHER = 2, 16
# Seconds: to reach a scheduler; between two looks at who is there; without any worker before the run is given up.
CONNECT, LOOK, PATIENCE = 10.0, 1.0, 120.0
Block = tuple[int, int]

TOO_MANY_DEATHS = "its worker died again and again, perhaps for want of memory"
#: Of the processes that are started here, of one thread each: the kernels' own threads, and those of Zarr's codecs, would share the cores a second time.
ENVIRONMENT = {"NUMBA_NUM_THREADS": "1", "ZARR_THREADING__MAX_WORKERS": "1"}
#: Times that a block is submitted again because its result died with the worker that held it.
AGAIN = 3


def on_cluster(
    fitted: FittedMap, blocks: list[tuple[int, int]], scheduler: str | None, workers: int | None
) -> Generator[Outcome]:
    """Outcomes in the order in which blocks end, from the workers of a scheduler or from processes started here.

    Raises
    ------
    MotesError
        When the scheduler cannot be reached or goes away, or no worker comes; finished blocks are kept.
    """
    with ExitStack() as stack:
        with suppress(ImportError):  # before it is made quiet: it sets up its loggers on import
            import distributed  # noqa: F401
        stack.enter_context(_quiet())
        client = _client(stack, scheduler, workers)
        yield from windowed(client, fitted, blocks, scheduler or "the local cluster")


def windowed(
    client: Any,
    fitted: FittedMap,
    blocks: list[tuple[int, int]],
    where: str,
    work: Callable[[str, str, Sequence[Block]], list[Outcome]] = work_on,
) -> Generator[Outcome]:
    """Outcomes of `work` on all blocks, a few tasks submitted for each thread at a time; `where` is for messages."""
    ended: queue.SimpleQueue[Any] = queue.SimpleQueue()
    running: dict[Any, Sequence[Block]] = {}
    lost: Counter[Block] = Counter()
    waiting = deque(blocks)
    path, run = str(fitted.path.resolve()), f"{time.time_ns()}"
    left, threads, seen, looked = len(blocks), 0, time.monotonic(), -LOOK
    while left:
        now = time.monotonic()
        if now - looked >= LOOK:
            looked, threads = now, _threads(client, where)
            seen = now if threads else seen
            if now - seen > PATIENCE:
                raise MotesError(
                    f"{where} has no worker since {PATIENCE:.0f} s",
                    "Start some: dask worker ADDRESS; finished blocks are kept",
                )
        room = MOST_IN_FLIGHT * threads - len(running)
        if len(running) <= LEAST_IN_FLIGHT * threads and (tasks := _tasks(waiting, lost, room, threads)):
            # Some at a time: a message for each would be most of a scheduler's work.  Keys tell runs apart, for a scheduler
            # remembers results that somebody still holds.
            keys = [f"motes-{run}-{y}-{x}-{lost[y, x]}" for (y, x), *_ in tasks]
            futures = client.map(work, [path] * len(tasks), [run] * len(tasks), tasks, key=keys, pure=False)
            for future, task in zip(futures, tasks, strict=True):
                running[future] = task
                future.add_done_callback(ended.put)
        try:
            future = ended.get(timeout=LOOK)
        except queue.Empty:
            continue
        task = running.pop(future)
        outcomes = _outcomes(future, task, fitted, where)
        if outcomes is None:
            _threads(client, where)  # an error where it is the scheduler that went away
            lost.update(task)
            waiting.extendleft(reversed([block for block in task if lost[block] <= AGAIN]))
            given_up = [block for block in task if lost[block] > AGAIN]
            outcomes = [Outcome(b, UNREADABLE, fitted.blocks.texels(b), TOO_MANY_DEATHS) for b in given_up]
        yield from outcomes
        left -= len(outcomes)


def _tasks(waiting: deque[Block], lost: Counter[Block], most: int, threads: int) -> list[Sequence[Block]]:
    """The next tasks, taken from what waits; a block that was lost is one of its own, so that it takes no other with it."""
    tasks: list[Sequence[Block]] = []
    while waiting and len(tasks) < most:
        size = 1 if lost[waiting[0]] else max(1, min(MOST_TOGETHER, len(waiting) // (PARTS * threads)))
        tasks.append([waiting.popleft() for _ in range(size)])
    return tasks


def _outcomes(future: Any, task: Sequence[Block], fitted: FittedMap, where: str) -> list[Outcome] | None:
    """What became of the blocks of a task; None where that was lost, with the worker that held it or with the scheduler."""
    from distributed import KilledWorker

    if future.status == "finished":
        try:
            result: list[Outcome] = future.result(timeout=CONNECT)
            return result
        except Exception:  # the worker died between its last word and ours
            return None
    if future.status == "error":
        error = future.exception(timeout=CONNECT)
        if isinstance(error, KilledWorker) and len(task) == 1:
            return [Outcome(task[0], UNREADABLE, fitted.blocks.texels(task[0]), TOO_MANY_DEATHS)]
        if isinstance(error, KilledWorker):  # by one of them
            return None
        if isinstance(error, MotesError):
            raise error
        first, *others = task
        raise MotesError(
            f"block {first}{f' or one of {len(others)} after it' if others else ''} failed on a worker of {where}: "
            f"{type(error).__name__}: {str(error)[:200]}",
            "Workers need the same Motes, the same packages and the same paths as this machine",
        )
    return None


def _threads(client: Any, where: str) -> int:
    """Threads of all workers; an error where the scheduler does not answer."""
    try:
        if client.status != "running":
            raise OSError(client.status)
        return sum(client.nthreads().values())
    except Exception:
        raise _gone(where) from None


def _gone(where: str) -> MotesError:
    return MotesError(
        f"the scheduler at {where} went away", "Finished blocks are kept; the same command goes on where it stopped"
    )


def _client(stack: ExitStack, scheduler: str | None, workers: int | None) -> Any:
    try:
        from distributed import Client, LocalCluster
    except ImportError:
        raise MissingExtraError("distributed", "scale", "Work on several processes or machines") from None
    if scheduler is not None:
        try:
            client = Client(scheduler, timeout=CONNECT, set_as_default=False)
        except Exception as error:
            raise MotesError(
                f"no scheduler answers at {scheduler[:200]}: {str(error)[:200] or type(error).__name__}",
                "Start one: dask scheduler --host 127.0.0.1 --port 8786; its address is tcp://127.0.0.1:8786",
            ) from None
        return _entered(stack, client)
    from distributed.security import Security

    try:
        # A key of this run alone, in memory: without it anybody on this machine could send functions to the port.
        security = Security.temporary()
    except ImportError:
        raise MissingExtraError("cryptography", "scale", "Work on several processes") from None
    try:
        cluster = LocalCluster(
            n_workers=workers,
            threads_per_worker=1,
            processes=True,
            host="127.0.0.1",
            security=security,
            dashboard_address="127.0.0.1:0",  # any free port; a taken one would be a warning
            silence_logs=logging.CRITICAL,
            env=ENVIRONMENT,
        )
    except Exception as error:
        raise MotesError(
            f"{workers} worker processes could not be started: {str(error)[:200] or type(error).__name__}",
            'A script that starts processes needs: if __name__ == "__main__":',
        ) from error
    stack.callback(_closed, cluster)
    return _entered(stack, Client(cluster, timeout=CONNECT, set_as_default=False))


def _entered(stack: ExitStack, client: Any) -> Any:
    stack.callback(_closed, client)
    return client


def _closed(thing: Any) -> None:
    """Close a client or cluster that may be gone already."""
    with suppress(Exception):
        thing.close(timeout=5)


@contextmanager
def _quiet() -> Iterator[None]:
    """Keep the library's own account of lost connections from the terminal: the error that follows says it in a sentence."""
    loggers = [
        logging.getLogger(name)
        for name in ("distributed", "distributed.client", "distributed.core", "tornado.application")
    ]
    levels = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL + 1)
    try:
        yield
    finally:
        for logger, level in zip(loggers, levels, strict=True):
            logger.setLevel(level)
