"""Processor time in units of work that the same process did: a limit in it means the same on every machine.

Seconds of the clock pass on a busy machine whether or not a test does anything, and a second of one processor is two of another.
Neighbours still make caches and shared cores slower, by a factor of two or three; limits are ten times what is usual.
"""

from __future__ import annotations

import functools
import time
from collections.abc import Callable

import numpy as np


def _work() -> None:
    """What tests do: a loop in Python, and arithmetic on arrays that fit the cache."""
    total = 0.0
    for k in range(130_000):
        total += k * 0.5
    x = np.linspace(0, 1, 20_000)
    for _ in range(40):
        x = np.sqrt(x * x + 1e-3)


@functools.cache
def unit() -> float:
    """Processor seconds of a unit of work, the least of some: seven thousandths where this was written."""
    return min(spent(_work) for _ in range(7))


def spent(call: Callable[[], object]) -> float:
    """Processor seconds of all threads of this process during a call."""
    before = time.process_time()
    call()
    return time.process_time() - before


def units(call: Callable[[], object]) -> float:
    """What a call costs, in units."""
    return spent(call) / unit()
