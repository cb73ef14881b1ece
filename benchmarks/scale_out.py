"""The figures of scaling.py on the page: a map fitted by one and by two workers, and what a task costs the scheduler.

usage: python benchmarks/scale_out.py [--effort quick|normal|full] [--json FILE]
"""

from __future__ import annotations

from typing import Any

import numpy as np

import scaling
from results import Effort, Goal, Number, Section, Table, command

GOAL = 0.9
LABELS = {"workers": "{n} worker{s}", "processes": "{n} process{s} alone"}
COLUMNS = ("rate", "share", "efficiency")


def scale_out(effort: Effort) -> Section:
    """Both measurements of scaling.py."""
    size, times, repeat, tasks = effort.pick((64, 1, 1, 100), (512, 8, 4, 10_000))
    return report(scaling.efficiency(size, times, repeat), scaling.scheduler_load(tasks), repeat)


def report(maps: dict[str, Any], scheduler: dict[str, Any], rounds: int) -> Section:
    """The section from what scaling.py returns."""
    seconds = {(kind, n): np.array(maps["seconds"][kind][n]) for kind in scaling.KINDS for n in scaling.WORKERS}
    figures: dict[str, Number] = {}
    for (kind, n), took in seconds.items():
        figures |= {
            f"{kind}_rate_{n}": Number.of(maps["fits"] / took),
            f"{kind}_share_{n}": Number.of(seconds[kind, 1] / took),
            f"{kind}_efficiency_{n}": Number.of(seconds[kind, 1] / (n * took)),
        }
    figures |= {
        "fits": Number.of([maps["fits"]]),
        "blocks": Number.of([maps["blocks"]]),
        "rounds": Number.of([rounds]),
        "tasks": Number.of([scheduler["tasks"]]),
        "tasks_rate": Number.of([scheduler["tasks_per_second"]]),
        "task_cpu": Number.of([scheduler["scheduler_cpu_ms_per_task"]]),
        "task_memory": Number.of([scheduler["scheduler_memory_mib"]]),
        "million": Number.of([scheduler["estimated_scheduler_cpu_minutes_for_1e6"]]),
        "workers": Number.of([scheduler["workers_kept_busy_with_blocks_of_2_s"]]),
    }
    rows = [
        [
            LABELS[kind].format(n=n, s="es" if kind == "processes" and n > 1 else "s" if n > 1 else ""),
            *(f"{{{kind}_{what}_{n}}}" for what in COLUMNS),
        ]
        for kind in scaling.KINDS
        for n in scaling.WORKERS
    ]
    return Section(
        title="Scaling out",
        made_by="benchmarks/scale_out.py, scale_out()",
        intro=(
            "A simulated map, {fits:count} fits in {blocks:count} blocks, read from a disk and written to it: by Dask workers of one thread each, as "
            "`motes fit --workers` starts them, and by as many processes of one thread that share the blocks from the first, with no scheduler and nothing "
            "to send: what the machine itself allows. In turn, {rounds:count} rounds, each into a store of its own; kernels are loaded before. The scheduler "
            "of the workers is in the process that measures, a further user of the two processors. "
            "And {tasks:count} tasks that do nothing, handed out by a scheduler in a process of its own. "
            "All on one machine, which must have two processors free for this to mean anything."
        ),
        figures=figures,
        tables=[
            Table(["", "fits/s", "x one of them", "efficiency"], rows),
            Table(
                ["the scheduler", "tasks/s", "ms of processor a task", "memory [MiB]"],
                [["tasks that do nothing, two workers", "{tasks_rate}", "{task_cpu}", "{task_memory}"]],
            ),
        ],
        goals=[Goal("efficiency from one to two workers", "workers_efficiency_2", GOAL)],
        reading=[
            "Two workers do {workers_share_2} times the work of one, two processes alone {processes_share_2} times.",
            "From what a task costs it: a million tasks would take {million:bare} minutes of the scheduler's processor, and blocks that take two seconds each "
            "would keep {workers:count} workers busy; estimated, not measured.",
        ],
    )


if __name__ == "__main__":
    command(scale_out, __doc__)
