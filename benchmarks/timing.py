"""Timing several candidates against one another on a machine that does other things too.

The candidates take turns, round after round, in one process; a ratio is taken within each round, and the median of the rounds
counts.  Wall time says what a user gets; processor time, over all threads, depends less on what else runs.
"""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from results import Number

SHORTEST = 20e-3  # seconds: a call that takes less is repeated within a round
# Seconds to look whether a candidate's threads are still at work, and how many looks in a row must find them quiet: those of Dr.Jit wait for more on
# and off, some 17 ms of a processor, after their last task.
LOOK, QUIET, LONGEST = 4e-3, 6, 0.3
AWAKE = 10e-3  # seconds of work before each measurement: a processor that rested takes milliseconds to come back to its speed


@dataclass
class Timing:
    """Seconds of each round of one candidate, divided by its number of items."""

    wall: list[float] = field(default_factory=list)
    cpu: list[float] = field(default_factory=list)

    @property
    def rate(self) -> Number:
        """Items a second."""
        return Number.of(1 / np.array(self.wall))

    @property
    def seconds(self) -> Number:
        """Wall seconds an item."""
        return Number.of(self.wall)

    @property
    def processor(self) -> Number:
        """Processor seconds an item, all threads together."""
        return Number.of(self.cpu)

    @property
    def busy(self) -> Number:
        """Processors at work on average."""
        return Number.of(np.array(self.cpu) / np.array(self.wall))

    def faster_than(self, other: Timing) -> Number:
        """How many times the other's wall time an item is this one's, round by round."""
        return Number.of(np.array(other.wall) / np.array(self.wall))

    def cheaper_than(self, other: Timing) -> Number:
        """The same of processor time."""
        return Number.of(np.array(other.cpu) / np.array(self.cpu))


def settle() -> None:
    """Wait until no other thread of this process is at work: what one candidate leaves behind is not the next one's."""
    end = time.perf_counter() + LONGEST
    quiet = 0
    while quiet < QUIET and time.perf_counter() < end:
        before = time.process_time()
        time.sleep(LOOK)
        quiet = quiet + 1 if time.process_time() - before < 0.2 * LOOK else 0


def awake() -> None:
    """Keep all processors at work for a moment, in NumPy's code, which holds no lock."""
    numbers = np.ones(4096)

    def work() -> None:
        end = time.perf_counter() + AWAKE
        while time.perf_counter() < end:
            np.sqrt(numbers, out=numbers)

    threads = [threading.Thread(target=work) for _ in range((os.cpu_count() or 1) - 1)]
    for thread in threads:
        thread.start()
    work()
    for thread in threads:
        thread.join()


def interleaved(
    candidates: Mapping[str, tuple[Callable[[], Any], float]],
    rounds: int,
    *,
    warm: bool = True,
    in_a_loop: Collection[str] = (),
) -> dict[str, Timing]:
    """Time candidates in turn.

    Parameters
    ----------
    candidates
        By name a call and the number of items that it works on.
    rounds
        How many count.
    warm
        Make an uncounted round first: it compiles, and touches memory.
    in_a_loop
        Names of candidates that are called once more, uncounted, before each round: what counts is a call after one like it.
    """
    repeats = dict.fromkeys(candidates, 1)
    if warm:
        for name, (call, _) in candidates.items():
            call()
            start = time.perf_counter()
            call()
            repeats[name] = max(1, int(np.ceil(SHORTEST / max(time.perf_counter() - start, 1e-7))))
    timings = {name: Timing() for name in candidates}
    for _ in range(rounds):
        for name, (call, items) in candidates.items():
            count = repeats[name]
            if name in in_a_loop:
                call()
            settle()
            awake()
            wall, cpu = time.perf_counter(), time.process_time()
            for _ in range(count):
                call()
            cpu, wall = time.process_time() - cpu, time.perf_counter() - wall
            timings[name].wall.append(wall / (items * count))
            timings[name].cpu.append(max(cpu, 1e-9) / (items * count))
    return timings
