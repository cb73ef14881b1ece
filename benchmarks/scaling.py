"""How the fit of a map scales over worker processes, and what a task costs the scheduler.

usage: python benchmarks/scaling.py [--size 512] [--times 8] [--repeat 4] [--tasks 10000] [--json]

Efficiency: a map is fitted by 1 and by 2 workers of one thread in turn, and the ratio is the median time of one over twice the median time of two; kernels
are compiled and loaded before.  Two processes that share the blocks without a scheduler show what the machine itself allows.  Scheduler: a scheduler in a
process of its own hands out tasks that do nothing; its processor time and memory are those the kernel counts.  Both on loopback.  The machine must be idle
and have two cores free.
"""

from __future__ import annotations

import argparse
import itertools
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import places
from motes import maps
from motes.maps import cluster
from motes.maps.fitted import open_fitted
from motes.maps.work import DONE, Outcome, work_on

MODEL = "oren_nayar + torrance_sparrow"
WORKERS = (1, 2)
KINDS = ("workers", "processes")
FIRST = 4  # blocks for each of them, before those that count: kernels are loaded


def nothing(path: str, run: str, blocks: Sequence[tuple[int, int]]) -> list[Outcome]:
    """A task that does nothing."""
    return [Outcome(block, DONE, 0) for block in blocks]


def seconds(client: Any, fitted: maps.FittedMap, blocks: list[tuple[int, int]], work: Any = cluster.work_on) -> float:
    """How long the blocks take on a client's workers."""
    began = time.perf_counter()
    outcomes = list(cluster.windowed(client, fitted, blocks, "the benchmark", work))
    took = time.perf_counter() - began
    assert len(outcomes) == len(blocks)
    assert all(outcome.kind == DONE for outcome in outcomes), outcomes
    return took


def alone(path: str, run: str, blocks: list[tuple[int, int]]) -> None:
    """Blocks in a process that no scheduler tells what to do."""
    assert all(outcome.kind == DONE for outcome in work_on(path, run, blocks))


def told(environment: dict[str, str]) -> None:
    """What a new process learns first."""
    os.environ.update(environment)


def started(stack: ExitStack) -> ProcessPoolExecutor:
    """A process of one thread, as a worker's."""
    pool = ProcessPoolExecutor(1, get_context("spawn"), told, (cluster.ENVIRONMENT,))
    stack.callback(pool.shutdown)
    return pool


def of_processes(pools: list[ProcessPoolExecutor], fitted: maps.FittedMap, blocks: list[tuple[int, int]]) -> float:
    """How long processes take that share the blocks from the first."""
    path, run, count = str(fitted.path), f"{time.time_ns()}", len(pools)
    began = time.perf_counter()
    for done in [pool.submit(alone, path, run, blocks[k::count]) for k, pool in enumerate(pools)]:
        done.result()
    return time.perf_counter() - began


def efficiency(size: int, times: int, repeat: int) -> dict[str, Any]:
    """Times with one and with two workers, and with one and with two processes alone, in turn; each fills a store of its own."""
    with places.fresh() as folder:
        source = maps.simulate_map(folder / "map.zarr", (size, size), times=times, chunk=64)
        fitted = maps.fit_map(source, MODEL, out=folder / "fit.zarr")  # compiles, finds starts
        reference = fitted.read_map("K_d").tobytes()
        blocks = list(fitted.blocks)
        taken: dict[str, dict[int, list[float]]] = {kind: {n: [] for n in WORKERS} for kind in KINDS}
        for k in range(repeat):
            for n, kind in itertools.product(WORKERS, KINDS):
                first, out = (
                    open_fitted(places.emptied(fitted.path, folder / f"{what}-{kind}-{n}-{k}.zarr"), mode="r+")
                    for what in ("first", "all")
                )
                with ExitStack() as alive:  # no other worker or process beside them
                    if kind == "workers":
                        client = cluster._client(alive, None, n)
                        seconds(client, first, blocks[: FIRST * n])
                        took = seconds(client, out, blocks)
                    else:
                        pools = [started(alive) for _ in range(n)]
                        of_processes(pools, first, blocks[: FIRST * n])
                        took = of_processes(pools, out, blocks)
                assert out.read_map("K_d").tobytes() == reference
                taken[kind][n].append(took)
        fits = size * size * times
        middle = {kind: {n: statistics.median(taken[kind][n]) for n in WORKERS} for kind in KINDS}
        return {
            "fits": fits,
            "blocks": len(blocks),
            "seconds": taken,
            "fits_per_second": {kind: {n: fits / middle[kind][n] for n in WORKERS} for kind in KINDS},
            "efficiency": {kind: middle[kind][1] / (2 * middle[kind][2]) for kind in KINDS},
        }


def scheduler_load(tasks: int) -> dict[str, Any]:
    """Processor time and memory of a scheduler that hands out tasks that do nothing."""
    ticks = os.sysconf("SC_CLK_TCK")

    def used(pid: int) -> tuple[float, float]:
        fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / ticks, int(fields[21]) * os.sysconf("SC_PAGE_SIZE") / 2**20

    with tempfile.TemporaryDirectory() as folder, ExitStack() as stack:
        source = maps.simulate_map(Path(folder) / "map.zarr", (8, 8), times=1, lights=4)
        fitted = maps.fit_map(source, "lambert", out=Path(folder) / "fit.zarr")
        file = Path(folder) / "scheduler.json"
        # Scheduler and workers import the task from here.
        environment = {**os.environ, "PYTHONPATH": str(Path(__file__).resolve().parent)}
        quiet: dict[str, Any] = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "env": environment}
        common = ["--host", "127.0.0.1", "--no-dashboard", "--scheduler-file", str(file)]
        dask = [sys.executable, "-m", "dask"]
        scheduler = subprocess.Popen([*dask, "scheduler", "--port", "0", *common], **quiet)
        stack.callback(scheduler.wait)
        stack.callback(scheduler.terminate)
        while not file.exists():
            time.sleep(0.1)
        time.sleep(0.2)
        address = json.loads(file.read_text())["address"]
        workers = subprocess.Popen([*dask, "worker", *common, "--nworkers", "2", "--nthreads", "1"], **quiet)
        stack.callback(workers.wait)
        stack.callback(workers.terminate)
        client = cluster._client(stack, address, None)
        client.wait_for_workers(2, timeout=60)
        import scaling  # by this name the workers find the task

        together, cluster.MOST_TOGETHER = cluster.MOST_TOGETHER, 1  # a task for each block
        stack.callback(setattr, cluster, "MOST_TOGETHER", together)
        seconds(client, fitted, [(0, k) for k in range(100)], scaling.nothing)
        before, memory_before = used(scheduler.pid)
        took = seconds(client, fitted, [(1, k) for k in range(tasks)], scaling.nothing)
        after, memory = used(scheduler.pid)
    cpu = (after - before) / tasks
    return {
        "tasks": tasks,
        "seconds": took,
        "tasks_per_second": tasks / took,
        "scheduler_cpu_ms_per_task": 1000 * cpu,
        "scheduler_memory_mib": memory,
        "scheduler_memory_growth_mib": memory - memory_before,
        "estimated_scheduler_cpu_minutes_for_1e6": 1e6 * cpu / 60,
        "workers_kept_busy_with_blocks_of_2_s": 2 / cpu,
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--times", type=int, default=8)
    parser.add_argument("--repeat", type=int, default=4)
    parser.add_argument("--tasks", type=int, default=10_000)
    parser.add_argument("--json", action="store_true")
    a = parser.parse_args()
    result = {"map": efficiency(a.size, a.times, a.repeat), "scheduler": scheduler_load(a.tasks)}
    if a.json:
        print(json.dumps(result, indent=1))
        return
    m, s = result["map"], result["scheduler"]
    print(f"{m['fits']:,} fits in {m['blocks']} blocks, workers of one thread, medians of {a.repeat}")
    for kind in KINDS:
        for n in WORKERS:
            print(f"  {n} {kind}: {m['fits_per_second'][kind][n]:10,.0f} fits/s")
        print(f"  efficiency from 1 to 2: {m['efficiency'][kind]:.2f}")
    print(f"{s['tasks']:,} tasks that do nothing, 2 workers: {s['tasks_per_second']:,.0f} tasks/s")
    print(
        f"  scheduler: {s['scheduler_cpu_ms_per_task']:.2f} ms of processor a task, {s['scheduler_memory_mib']:.0f} MiB"
    )
    print(
        f"  10^6 tasks (estimated): {s['estimated_scheduler_cpu_minutes_for_1e6']:.0f} min of the scheduler's processor"
    )
    print(f"  workers that blocks of 2 s keep busy (estimated): {s['workers_kept_busy_with_blocks_of_2_s']:,.0f}")


if __name__ == "__main__":
    main()
