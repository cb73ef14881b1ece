"""Order statistics by a look at a few numbers first: those of a sort, whatever order or repeats the numbers have; and products of long vectors."""

from __future__ import annotations

import math
import os
import subprocess
import sys

import numpy as np
import pytest
from numpy.typing import NDArray

from motes.arrays import dot, median, sorted_part

rng = np.random.default_rng(4)
NUMBERS = {
    "few": rng.normal(size=7),
    "many": rng.normal(size=50_001),
    "even": rng.exponential(size=20_000),
    "sorted": np.sort(rng.normal(size=30_000)),
    "periodic": np.tile(np.arange(24.0), 2000),  # what is drawn says nothing of the rest
    "alike": np.ones(10_000),
    "places": np.round(rng.normal(size=40_000), 1),
}


@pytest.mark.parametrize("numbers", NUMBERS.values(), ids=NUMBERS.keys())
def test_parts_and_medians_are_those_of_sorted_numbers(numbers: NDArray[np.float64]) -> None:
    whole = np.sort(numbers)
    count = len(numbers)
    for first in (0, 1, count // 5, count // 2, count - 3):
        last = min(count - 1, first + 64)
        np.testing.assert_array_equal(np.sort(sorted_part(numbers, first, last)), whole[first : last + 1])
    assert median(numbers) == np.median(numbers)


def test_products_of_long_vectors_wake_no_other_thread():
    """In a process of its own, where no thread of another test is at work."""
    code = """
import time
import numpy as np
from motes.arrays import dot
a, b = np.random.default_rng(3).standard_normal((2, 50_000, 3))
before = time.process_time() - time.thread_time()
for _ in range(20):
    dot(a, b)
time.sleep(0.1)  # in which a thread that was woken waits for more, busily
others = time.process_time() - time.thread_time() - before
assert others < 0.02, others
"""
    environment = {name: value for name, value in os.environ.items() if name != "OPENBLAS_NUM_THREADS"}
    subprocess.run([sys.executable, "-c", code], check=True, env=environment)
    a, b = np.random.default_rng(3).standard_normal((2, 50_000, 3))
    assert dot(a, b) == pytest.approx(math.fsum((a * b).ravel()), rel=1e-12)
    assert dot(a[:0], b[:0]) == 0.0
