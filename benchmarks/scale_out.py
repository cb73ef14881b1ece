"""The figures of scaling.py on the page: a map fitted by one and by two workers, and what a task costs the scheduler.

usage: python benchmarks/scale_out.py [--effort quick|normal|full] [--json FILE]
"""

from __future__ import annotations

from typing import Any

import numpy as np

import scaling
from results import Effort, Goal, Number, Section, Table, command

GOAL = 0.9


def scale_out(effort: Effort) -> Section:
    """Both measurements of scaling.py."""
    size, times, repeat, tasks = effort.pick((64, 1, 1, 100), (256, 4, 5, 10_000))
    return report(scaling.efficiency(size, times, repeat), scaling.scheduler_load(tasks), repeat)


def report(maps: dict[str, Any], scheduler: dict[str, Any], rounds: int) -> Section:
    """The section from what scaling.py returns."""
    one, two = (np.array(maps["seconds"][n]) for n in scaling.WORKERS)
    figures = {
        "fits": Number.of([maps["fits"]]),
        "blocks": Number.of([maps["blocks"]]),
        "rounds": Number.of([rounds]),
        "efficiency": Number.of(one / (2 * two)),
        "rate_1": Number.of(maps["fits"] / one),
        "rate_2": Number.of(maps["fits"] / two),
        "share_1": Number.of(one / one),
        "share_2": Number.of(one / two),
        "tasks": Number.of([scheduler["tasks"]]),
        "tasks_rate": Number.of([scheduler["tasks_per_second"]]),
        "task_cpu": Number.of([scheduler["scheduler_cpu_ms_per_task"]]),
        "task_memory": Number.of([scheduler["scheduler_memory_mib"]]),
        "million": Number.of([scheduler["estimated_scheduler_cpu_minutes_for_1e6"]]),
        "workers": Number.of([scheduler["workers_kept_busy_with_blocks_of_2_s"]]),
    }
    rows = [[f"{n} worker{'s' * (n > 1)}", f"{{rate_{n}}}", f"{{share_{n}}}"] for n in scaling.WORKERS]
    return Section(
        title="Scaling out",
        made_by="benchmarks/scale_out.py, scale_out()",
        intro=(
            "A simulated map, {fits:count} fits in {blocks:count} blocks, by Dask workers of one thread each, in turn, {rounds:count} rounds; "
            "and {tasks:count} tasks that do nothing, handed out by a scheduler in a process of its own. "
            "All on one machine, which must have two processors free for this to mean anything."
        ),
        figures=figures,
        tables=[
            Table(["", "fits/s", "x one worker"], rows),
            Table(
                ["the scheduler", "tasks/s", "ms of processor a task", "memory [MiB]"],
                [["tasks that do nothing, two workers", "{tasks_rate}", "{task_cpu}", "{task_memory}"]],
            ),
        ],
        goals=[Goal("efficiency from one to two workers", "efficiency", GOAL)],
        reading=[
            "Two workers do {share_2} times the work of one.",
            "From what a task costs it: a million tasks would take {million:bare} minutes of the scheduler's processor, and blocks that take two seconds each "
            "would keep {workers:count} workers busy; estimated, not measured.",
        ],
    )


if __name__ == "__main__":
    command(scale_out, __doc__)
