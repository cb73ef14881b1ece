"""Memory of results: taken again when nobody holds it, and never before."""

from __future__ import annotations

import threading
from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from catalogue import upper_directions
from motes.kernels import engine, memory
from motes.models import Lambert

LARGE = (400_000, 3)  # 9.6 MB
Floats = NDArray[np.float64]


@pytest.fixture(autouse=True)
def empty_pool(monkeypatch: pytest.MonkeyPatch) -> None:
    if not memory._COUNTS:
        pytest.skip("this interpreter does not count who holds an array")
    monkeypatch.setattr(memory, "_blocks", [])


def place(x: NDArray[np.float64]) -> int:
    return int(x.__array_interface__["data"][0])


def test_memory_is_taken_again_once_nobody_holds_it() -> None:
    first = memory.empty(LARGE, np.float64)
    at = place(first)
    assert first.shape == LARGE
    assert first.dtype == np.float64
    assert first.flags.c_contiguous
    assert first.flags.writeable
    second = memory.empty(LARGE, np.float64)
    assert place(second) != at, "the first is still there"
    del first
    third = memory.empty((800_000, 3), np.float32)
    assert place(third) == at, "of another type and shape, but as many bytes"


@pytest.mark.parametrize(
    "kept",
    [
        lambda x: x[5:7],
        lambda x: x.T,
        lambda x: x.reshape(-1)[::2],
        lambda x: x.view(np.uint8),
        lambda x: memoryview(x),
        lambda x: x.base,
        lambda x: np.broadcast_to(x[0], (9, 3)),
        lambda x: iter(x),
    ],
)
def test_whatever_shows_it_holds_it(kept: Callable[[Floats], object]) -> None:
    first = memory.empty(LARGE, np.float64)
    at = place(first)
    holder = kept(first)
    del first
    other = memory.empty(LARGE, np.float64)
    assert place(other) != at
    del holder
    assert place(memory.empty(LARGE, np.float64)) == at


def test_no_more_is_kept_than_allowed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(memory, "POOL", 3 << 20)
    held = [memory.empty((1 << 20,), np.uint8) for _ in range(6)]
    assert sum(map(len, memory._blocks)) <= 3 << 20
    for k, x in enumerate(held):
        x[:] = k
    assert [int(x.min()) for x in held] == [int(x.max()) for x in held] == list(range(6))
    count = len(memory._blocks)
    memory.empty((1000,), np.float64)  # small
    memory.empty((1 << 20,), np.float64)  # more than all
    assert len(memory._blocks) == count
    monkeypatch.setattr(memory, "POOL", 0)
    assert memory.empty(LARGE, np.float64).base is None


def test_results_that_are_held_stay_as_they_are() -> None:
    pytest.importorskip("llvmlite")
    wi, wo = upper_directions(150_000, 1), upper_directions(150_000, 2)
    models = [Lambert((k / 10, k / 20, k / 30)) for k in range(1, 5)]
    results = [engine.evaluate(model, wi, wo) for model in models]
    kept = [f.copy() for f in results]
    places = [place(f) for f in results]
    for model in models:
        engine.evaluate(model, wo, wi)
    for f, expected in zip(results, kept, strict=True):
        np.testing.assert_array_equal(f, expected)
    del results, f
    assert place(engine.evaluate(models[0], wi, wo)) in places


def test_threads_never_share_a_block() -> None:
    wrong: list[int] = []

    def work(number: int) -> None:
        for _ in range(30):
            x = memory.empty((1 << 17,), np.float64)
            x[:] = number
            y = memory.empty((1 << 17,), np.float64)
            y[:] = -number
            if not ((x == number).all() and (y == -number).all()):
                wrong.append(number)

    threads = [threading.Thread(target=work, args=(k,)) for k in range(1, 7)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong
