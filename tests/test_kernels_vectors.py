"""Vector instructions against NumPy: the losses' functions to the digits they state, and lanes brought into rows."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

pytest.importorskip("llvmlite")

from motes.kernels import engine, machine_code, vectors
from motes.kernels.lowering import lowered

LANES = 16
ROWS = '''
LANES = 16

def run(x, y):
    program = """x y
{lines}
"""
    return vectors.rows(LANES, "{letter}", program, x, y)

@kernel
def call(x, y, blocks, size):
    for k in range(blocks):
        run(x + k * size, y + k * size)
'''
TRANSPOSED = """
LANES = 16

def run(source, stride, end, first, target):
    return vectors.transposed(LANES, source, stride, end, first, target)

@kernel
def call(source, stride, end, first, target):
    run(source, stride, end, first, target)
"""
BOXED = """
def boxed({given}):
    return vectors.boxed({pieces}, {given})

def turned(items, count, room, pitch):
    return vectors.turned({pieces}, items, count, room, pitch)

@kernel
def box({given}):
    boxed({given})

@kernel
def turn(items, count, room, pitch):
    turned(items, count, room, pitch)
"""
SUMS = '''
LANES, RUN = 16, 128

def run(columns, row, data, samples, totals):
    program = """columns row data samples totals
x = row data F sample*16
c = splat columns F sample
one = const 1.0
{cut}y = mul x c
big = lt one y
{cut}z = where big y one
sum0 = mul z c
{cut}sum1 = add z x
"""
    return vectors.sums(LANES, RUN, 2, 1, program, columns, row, data, samples, totals)

@kernel
def call(columns, row, data, samples, totals):
    run(columns, row, data, samples, totals)
'''
scalars = pytest.mark.parametrize("scalar", ["float32", "float64"])


def over(op: str, x: NDArray[Any]) -> NDArray[Any]:
    """`op` of all numbers of x, by vectors."""
    letter = "F" if x.dtype == np.float32 else "D"
    lines = f"a = row x {letter} 0\nb = {op} a\nput y {letter} 0 b"
    call = engine.module(ROWS.format(lines=lines, letter=letter), op).call
    padded = np.resize(x, -(-x.size // LANES) * LANES).astype(x.dtype)
    result = np.empty_like(padded)
    call(padded.ctypes.data, result.ctypes.data, len(padded) // LANES, LANES * x.itemsize)
    return result[: x.size]


def ulps(found: NDArray[Any], exact: NDArray[Any]) -> float:
    """The largest error in units of the last place of the exact result."""
    return float(np.max(np.abs(found - exact) / np.spacing(np.abs(exact).astype(found.dtype)).astype(exact.dtype)))


@scalars
def test_log1p_is_good_to_an_ulp_and_a_half(scalar: str) -> None:
    rng = np.random.default_rng(2)
    small = 10.0 ** rng.uniform(-30, -1, 40_000)
    x = np.concatenate([rng.uniform(-0.99, 3, 40_000), 10.0 ** rng.uniform(-1, 30, 40_000), small, -small])
    x = np.concatenate([x, 10.0 ** -rng.uniform(1, 6, 9999) - 1, [0.0, np.sqrt(0.5) - 1, np.sqrt(2) - 1]]).astype(
        scalar
    )
    worst = ulps(over("log1p", x), np.log1p(x.astype(np.float64 if scalar == "float32" else np.longdouble)))
    assert 0.4 < worst < 1.5


@scalars
def test_cbrt_is_good_to_an_ulp(scalar: str) -> None:
    rng = np.random.default_rng(3)
    end = 37.0 if scalar == "float32" else 307.0
    x = np.concatenate(
        [rng.uniform(-2, 2, 40_000), rng.choice([-1.0, 1.0], 80_000) * 10.0 ** rng.uniform(-end, end, 80_000)]
    )
    x = x.astype(scalar)
    worst = ulps(over("cbrt", x), np.cbrt(x.astype(np.float64 if scalar == "float32" else np.longdouble)))
    assert 0.4 < worst < 1


@scalars
@pytest.mark.parametrize("below", [True, False])
def test_powers_of_2_are_as_good_as_they_say(scalar: str, below: bool) -> None:
    rng = np.random.default_rng(5)
    end, wide = (125.0, np.float64) if scalar == "float32" else (1020.0, np.longdouble)
    small = 10.0 ** rng.uniform(-30, 0, 40_000)
    x = np.concatenate([rng.uniform(-end, 0, 40_000), -small, [0.0, -0.5, -1.5]])
    x = (x if below else np.concatenate([x, -x])).astype(scalar)
    suffix = "_below" if below else ""
    found, less = over("exp2" + suffix, x), over("exp2m1" + suffix, x)
    worst = ulps(found, np.exp2(x.astype(wide)))
    assert 0.4 < worst < (3.5 if scalar == "float32" else 1.5)
    worst = ulps(less[x != 0], np.expm1(x[x != 0].astype(wide) * np.log(wide(2))))
    assert 0.4 < worst < (10 if scalar == "float32" else 2.5)


@scalars
def test_the_edges_of_powers_of_2(scalar: str) -> None:
    least = -126.0 if scalar == "float32" else -1022.0
    x = np.array([0.0, least, least - 2, -np.inf, np.nan], scalar)
    expected = np.array([1.0, 2.0**least, 0.0, 0.0, np.nan], scalar)
    for suffix in ("_below", ""):
        np.testing.assert_array_equal(over("exp2" + suffix, x), expected)
        np.testing.assert_array_equal(over("exp2m1" + suffix, x), expected - 1)
    x = np.array([1.0, 10.0, 2 - least, np.inf], scalar)
    np.testing.assert_array_equal(over("exp2", x), np.array([2.0, 1024.0, np.inf, np.inf], scalar))
    np.testing.assert_array_equal(over("exp2m1", x), np.array([1.0, 1023.0, np.inf, np.inf], scalar))


@scalars
def test_the_edges_of_log1p_and_cbrt(scalar: str) -> None:
    x = np.array([0.0, -1.0, -1.5, np.inf, np.nan], scalar)
    with np.errstate(all="ignore"):
        np.testing.assert_array_equal(over("log1p", x), np.log1p(x))
    x = np.array([0.0, np.nan, -8.0, np.finfo(scalar).tiny / 4], scalar)
    np.testing.assert_array_equal(over("cbrt", x), np.array([0.0, np.nan, -2.0, 0.0], scalar))


@pytest.mark.parametrize("last", [15, 6, 0])
def test_lanes_are_brought_into_rows(last: int) -> None:
    call = engine.module(TRANSPOSED, "lanes into rows").call
    given = np.random.default_rng(4).normal(size=(last + 1, 29)).astype(np.float32)
    found = np.zeros((29, LANES), np.float32)
    for first in (0, 8, 16, 21):
        call(given.ctypes.data, given.strides[0], last, first, found.ctypes.data)
    np.testing.assert_array_equal(found, given[np.minimum(np.arange(LANES), last)].T)


@pytest.mark.parametrize(("count", "rows"), [(16, 7), (48, 8), (32, 11)])
def test_rows_are_put_into_places_and_back(count: int, rows: int) -> None:
    given = ", ".join(["count", "at", "items", *(f"row{k}" for k in range(rows))])
    pieces = -(-rows // 8)
    code = engine.module(BOXED.format(given=given, pieces=pieces), "boxes")
    rng = np.random.default_rng(7)
    x, at = rng.random((rows, count), dtype=np.float32), rng.permutation(count + 5)[:count].astype(np.int32)
    items = np.full((count + 5, 8 * pieces), 9.0, np.float32)
    code.box(count, engine.address(at), engine.address(items), *(engine.address(row) for row in x))
    np.testing.assert_array_equal(items[at, :rows], x.T)
    assert not items[at, rows:].any()
    assert (np.delete(items, at, axis=0) == 9).all(), "no other place is written"
    for some in (1, 15, 16, 21):
        found = np.full((8 * pieces, 64), 7.0, np.float32)
        code.turn(engine.address(items), some, engine.address(found), 64)
        np.testing.assert_array_equal(found[:, :some], items[:some].T)
        end = -(-some // 16) * 16
        np.testing.assert_array_equal(found[:, some:end], np.repeat(items[some - 1 : some].T, end - some, axis=1))
        assert (found[:, end:] == 7).all()


def test_vectors_on_the_stack_lie_within_cache_lines() -> None:
    text = lowered(ROWS.format(lines="a = row x F 0\nput y F 0 a", letter="F")).text
    (head,) = (line for line in text.splitlines() if "@run(" in line and line.startswith("define"))
    assert "alignstack(64)" in head


@pytest.mark.parametrize("samples", [5, 16, 150])
def test_sums_in_parts_are_those_of_the_whole(samples: int) -> None:
    rng = np.random.default_rng(2)
    columns, data = (rng.uniform(0.5, 2, shape).astype(np.float32) for shape in (samples, (samples, LANES)))
    found = []
    for cut in ("", "cut\n"):
        totals = np.ones((2, LANES))
        call = engine.module(SUMS.format(cut=cut), "sums").call
        call(columns.ctypes.data, samples, data.ctypes.data, samples, totals.ctypes.data)
        found.append(totals)
    z = np.where(data * columns[:, None] > 1, data * columns[:, None], 1)
    exact = 1 + np.array([(z * columns[:, None]).sum(0, dtype=float), (z + data).sum(0, dtype=float)])
    np.testing.assert_allclose(found[1], exact, rtol=1e-5)
    assert np.array_equal(found[0], found[1])


def test_roots_by_multiplications_are_rounded_as_the_processor_rounds_them(monkeypatch: pytest.MonkeyPatch) -> None:
    wide = machine_code.vector_bytes() == 64
    monkeypatch.setattr(vectors, "long_roots", lambda: wide)
    program = "x y count\na = row x D n\nb = sqrt a\nput y D n b"
    text = lowered(
        f'def roots(x, y, count):\n    program = """\n{program}\n"""\n    return vectors.stretch(32, "D", program, x, y, count)\n\n'
        "@kernel\ndef call(x, y, count):\n    roots(x, y, count)\n"
    )
    assert ("vsqrtpd" in machine_code.assembly(text.text)) is not wide
    rng = np.random.default_rng(5)
    whole = rng.integers(1 << 52, 1 << 53, 200_000).astype(float)
    squares = whole * whole
    x = np.concatenate([
        rng.random(200_000), 10.0 ** rng.uniform(-280, 300, 200_000), np.nextafter(1, 2) ** np.arange(0, 64), 1 - 2.0**-53 * np.arange(1, 65),
        squares, np.nextafter(squares, 0), np.nextafter(squares, np.inf), (whole + 0.5 * 2.0**-52) * whole, [0.0, -0.0, np.inf, np.nan, -1.0, -np.inf],
    ])  # fmt: skip
    x = np.concatenate([x, np.ones(-len(x) % 32)])
    y = np.empty_like(x)
    call = machine_code.loaded([machine_code.compiled(text.text)], text.kernels)["call"]
    call(x.ctypes.data, y.ctypes.data, len(x))
    with np.errstate(invalid="ignore"):
        np.testing.assert_array_equal(y.view(np.int64)[x >= 0], np.sqrt(x).view(np.int64)[x >= 0])
    assert np.isnan(y[~(x >= 0)]).all()
