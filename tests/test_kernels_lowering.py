"""The language of generated modules: what it computes, run as Python and compiled."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

pytest.importorskip("llvmlite")

from motes.fitting.printed import driver_text
from motes.kernels import drivers, engine, grouped
from motes.kernels.lowering import lowered
from motes.kernels.machine_code import is_x86

MODULE = """
D, F, I = float64, float32, int32
FEW = 3

def both(a, b):
    return b, a + b

@inline
def half(x):
    return x / D(2.0)

@kernel
def whole(n, out):
    a, b = 1, 2
    found = 0
    for k in range(n):
        if k == 5:
            continue
        if k > 8:
            break
        a, b = b, a
        found += a * k if k < FEW else k // 2 + k % 4
    while a < 40 and not found < 0:
        a, b = both(a, b)
    for k in range(n, 0, 2):
        found += 1000
    for k in range(2, n, 3):
        found += k > 4
    found += min(n, 7) + (13 >> 1) + (1 << 4) + (6 & 3)
    total = 0
    for k in range(n):
        total += half(D(k))
    store(D, out, 0, total, "out", 0, 1)
    store(F, out, 2, F(1 / D(3.0)) if total > D(1.0) or n == 0 else F(-2.5), "out", 0, 1)
    store(I, out, 3, bits_of(F(1.0)), "out", 0, 1)
    return found * 100 + a
"""


def in_python(n: int) -> tuple[int, float, float]:
    """The same by Python itself."""
    written: dict[int, Any] = {}
    names: dict[str, Any] = {
        "float64": float, "float32": np.float32, "int32": int, "inline": lambda f: f, "kernel": lambda f: f,
        "bits_of": lambda x: int(np.float32(x).view(np.int32)),
        "store": lambda kind, address, index, value, *_: written.__setitem__(index, value),
    }  # fmt: skip
    exec(MODULE, names)
    found = names["whole"](n, 0)
    assert written[3] == 0x3F800000
    return found, written[0], written[2]


@pytest.mark.parametrize("n", [0, 1, 4, 7, 12])
def test_statements_do_what_they_do_in_python(n: int) -> None:
    whole: Callable[..., int] = engine.module(MODULE, "the language").whole
    out = np.zeros(2)
    found = whole(n, out.ctypes.data)
    singles = out.view(np.float32)
    assert (found, out[0], singles[2]) == in_python(n)
    assert out.view(np.int32)[3] == 0x3F800000


def test_what_is_not_of_the_language_is_refused() -> None:
    with pytest.raises(TypeError, match="not in the language"):
        lowered("@kernel\ndef f(x):\n    with x:\n        y = 1\n")
    assert lowered(MODULE).kernels == {"whole": (2, True)}


def test_small_numbers_are_0_in_a_function_that_flushes_and_nowhere_else() -> None:
    body = "def {0}(at, n):\n    for k in range(n):\n        store(D, at, k, load(D, at, k, 'a', 1) * D(0.5), 'a', 0, 1)\n    return n\n"
    module = "D = float64\n@kernel\n" + body.format("keeping") + "@kernel\n@flushing\n" + body.format("flushing")
    kernels = engine.module(module, "small numbers")
    least = np.finfo(float).smallest_normal
    for flushes in (False, True):
        out = np.array([4 * least, least, least / 2, np.nan])
        (kernels.flushing if flushes else kernels.keeping)(out.ctypes.data, 4)
        expected = [0, 0] if flushes and is_x86() else [least / 2, least / 4]
        np.testing.assert_array_equal(out, [2 * least, *expected, np.nan])
        assert least / np.float64(2) > 0  # NumPy's own, in the same thread afterwards


def test_drivers_flush() -> None:
    for driver in (drivers.EVALUATE, drivers.GRADIENT, drivers.SAMPLE, grouped._DRIVER, driver_text.FIT):
        name = driver[driver.rindex("def ", 0, driver.rindex("room,")) :].split("(")[0]
        assert f"@kernel\n@flushing\n{name}(" in driver
