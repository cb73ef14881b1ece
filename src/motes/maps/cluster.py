"""Blocks on the workers of a Dask scheduler: as many in flight as keep the workers busy, never a list of all."""

from __future__ import annotations

import itertools
import logging
import queue
import time
from collections import Counter
from collections.abc import Callable, Generator, Iterator
from contextlib import ExitStack, contextmanager, suppress
from typing import Any

from motes.errors import MissingExtraError, MotesError
from motes.maps.fitted import FittedMap
from motes.maps.work import UNREADABLE, Outcome, work_on

#: Blocks in flight for each thread of a worker: one that runs, and some on the way; more are submitted when the least is reached.
LEAST_IN_FLIGHT, MOST_IN_FLIGHT = 2, 4
# Seconds: to reach a scheduler; between two looks at who is there; without any worker before the run is given up.
CONNECT, LOOK, PATIENCE = 10.0, 1.0, 120.0
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
    work: Callable[[str, str, tuple[int, int]], Outcome] = work_on,
) -> Generator[Outcome]:
    """Outcomes of `work` on every block, a few submitted for each thread at a time; `where` is for messages."""
    ended: queue.SimpleQueue[Any] = queue.SimpleQueue()
    running: dict[Any, tuple[int, int]] = {}
    lost: Counter[tuple[int, int]] = Counter()
    waiting = iter(blocks)
    path, run = str(fitted.path.resolve()), f"{time.time_ns()}"
    left, window, enough, seen, looked = len(blocks), 0, 0, time.monotonic(), -LOOK
    while left:
        now = time.monotonic()
        if now - looked >= LOOK:
            looked, threads = now, _threads(client, where)
            window, enough = MOST_IN_FLIGHT * threads, LEAST_IN_FLIGHT * threads
            seen = now if threads else seen
            if now - seen > PATIENCE:
                raise MotesError(
                    f"{where} has no worker since {PATIENCE:.0f} s",
                    "Start some: dask worker ADDRESS; finished blocks are kept",
                )
        if len(running) <= enough and (more := list(itertools.islice(waiting, window - len(running)))):
            # Some at a time: a message for each would be most of a scheduler's work.  Keys tell runs apart, for a scheduler
            # remembers results that somebody still holds.
            keys = [f"motes-{run}-{y}-{x}-{lost[y, x]}" for y, x in more]
            futures = client.map(work, [path] * len(more), [run] * len(more), more, key=keys, pure=False)
            for future, block in zip(futures, more, strict=True):
                running[future] = block
                future.add_done_callback(ended.put)
        try:
            future = ended.get(timeout=LOOK)
        except queue.Empty:
            continue
        block = running.pop(future)
        outcome = _outcome(future, block, fitted, where)
        if outcome is None:
            _threads(client, where)  # an error where it is the scheduler that went away
            lost[block] += 1
            if lost[block] <= AGAIN:
                waiting = itertools.chain([block], waiting)
                continue
            outcome = Outcome(block, UNREADABLE, fitted.blocks.texels(block), TOO_MANY_DEATHS)
        yield outcome
        left -= 1


def _outcome(future: Any, block: tuple[int, int], fitted: FittedMap, where: str) -> Outcome | None:
    """What became of a block; None where its result was lost, with the worker that held it or with the scheduler."""
    from distributed import KilledWorker

    if future.status == "finished":
        try:
            result: Outcome = future.result(timeout=CONNECT)
            return result
        except Exception:  # the worker died between its last word and ours
            return None
    if future.status == "error":
        error = future.exception(timeout=CONNECT)
        if isinstance(error, KilledWorker):
            return Outcome(block, UNREADABLE, fitted.blocks.texels(block), TOO_MANY_DEATHS)
        if isinstance(error, MotesError):
            raise error
        raise MotesError(
            f"block {block} failed on a worker of {where}: {type(error).__name__}: {str(error)[:200]}",
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
