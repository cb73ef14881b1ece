"""exp, expm1, log, log1p, asin, sin and cos of generated kernels: the errors that `motes.printing.elementary` states, and the edges of the domain."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from numpy.typing import NDArray

pytest.importorskip("llvmlite")

from motes.kernels import engine
from motes.kernels.loops import functions
from motes.printing import elementary

STATED = {
    "exp": 1.5,
    "expm1": 2.5,
    "log": 1.5,
    "log1p": 1.5,
    "asin_near": 1.0,
    "asin": 3.0,
    "sin": 1.5,
    "cos": 1.5,
}  # units in the last place, as in the table of the module
EXACT = {name: getattr(mp, name.removesuffix("_near")) for name in STATED}
WIDE = {name: getattr(np, {"asin": "arcsin", "asin_near": "arcsin"}.get(name, name)) for name in STATED}
LARGEST_EXP = {"float32": 88.72283, "float64": 709.782712893384}
SMALLEST_POWER = {"float32": -126, "float64": -1022}

scalars = pytest.mark.parametrize("scalar", ["float32", "float64"])
names = pytest.mark.parametrize("name", STATED)


@functools.cache
def compiled(scalar: str) -> dict[str, Callable[[NDArray[Any]], NDArray[Any]]]:
    """The functions over arrays, as kernels use them: inlined in a loop."""
    text = (
        functions(scalar)
        + "\n\n"
        + "\n\n".join(
            f"@kernel\ndef loop_{name}(x, y, count):\n    for n in range(count):\n"
            f'        store(F, y, n, {name}(load(F, x, n, "loop", 1)), "loop", 0, 1)\n'
            for name in STATED
        )
    )
    module = engine.module(text, "elementary functions")

    def over(loop: Callable[..., None]) -> Callable[[NDArray[Any]], NDArray[Any]]:
        def call(x: NDArray[Any]) -> NDArray[Any]:
            x = np.ascontiguousarray(x, scalar)
            y = np.empty_like(x)
            loop(x.ctypes.data, y.ctypes.data, x.size)
            return y

        return call

    return {name: over(getattr(module, f"loop_{name}")) for name in STATED}


def arguments(name: str, scalar: str, n: int) -> NDArray[Any]:
    """Where the function is neither 0 by flushing nor infinite: dense and uniform, and all magnitudes down to the smallest."""
    rng = np.random.default_rng(7)
    tiny = float(np.finfo(scalar).tiny)
    if name in ("exp", "expm1"):
        high = LARGEST_EXP[scalar] - 1e-3
        low = (SMALLEST_POWER[scalar] + 0.51) * np.log(2) if name == "exp" else -high
        parts = [rng.uniform(low, high, n), rng.uniform(-2, 2, n)]
        # The edges of range reduction, where the polynomial is at its ends.
        parts.append((np.arange(-100, 100) + 0.5) * np.log(2) * 0.5)
    elif name == "log1p":
        parts = [rng.uniform(-0.999, 3, n), np.exp(rng.uniform(0, 80, n)), 10.0 ** rng.uniform(-6, -1, n) - 1]
        parts.append(2.0 ** np.arange(-20, 20) * np.sqrt(0.5) - 1)  # where the exponent changes
    elif name == "log":
        parts = [rng.uniform(0, 3, n), np.exp(rng.uniform(-80, 80, n)), 1 + 10.0 ** rng.uniform(-6, -1, n)]
        parts.append(2.0 ** np.arange(-20, 20) * np.sqrt(0.5))  # where the exponent changes
        return np.concatenate([*parts, np.exp(rng.uniform(np.log(tiny), 0, n))]).astype(scalar)
    elif name in ("sin", "cos"):
        parts = [rng.uniform(-6.3, 6.3, n)]
        parts.append(np.arange(-8, 9) * (np.pi / 4))  # zeros, and the edges of range reduction
    else:
        end = 0.7072 if name == "asin_near" else 1.0
        parts = [rng.uniform(-end, end, n), end - 10.0 ** rng.uniform(-7, -1, n), np.array([end, -end])]
    small = np.exp(rng.uniform(np.log(tiny), 0, n)) * 0.7
    parts += [small, -small]
    return np.concatenate(parts).astype(scalar)


def ulps(found: NDArray[Any], exact: NDArray[Any]) -> float:
    """The largest error in units of the last place of the exact result."""
    return float(np.max(np.abs(found - exact) / np.spacing(np.abs(exact).astype(found.dtype)).astype(exact.dtype)))


@scalars
@names
def test_errors_are_as_stated_on_a_dense_grid(scalar: str, name: str) -> None:
    wide = np.float64 if scalar == "float32" else np.longdouble
    if np.finfo(wide).nmant < np.finfo(scalar).nmant + 8:
        pytest.skip(f"{wide.__name__} is no wider than {scalar} here")
    x = arguments(name, scalar, 200_000)
    found, exact = compiled(scalar)[name](x), WIDE[name](x.astype(wide))
    worst = ulps(found, exact)
    assert worst <= STATED[name], f"{worst:.3f} ulp"
    assert worst > 0.4, "a smaller error than that of rounding: the test does not measure"


@scalars
@names
def test_errors_are_as_stated_against_many_digits(scalar: str, name: str) -> None:
    x = arguments(name, scalar, 300)
    found = compiled(scalar)[name](x)
    with mp.workdps(40):
        for argument, value in zip(x, found, strict=True):
            exact = EXACT[name](mp.mpf(float(argument)))
            unit = float(np.spacing(np.asarray(float(abs(exact)), scalar)))
            assert abs(mp.mpf(float(value)) - exact) <= STATED[name] * unit, f"{name}({argument!r}) = {value!r}"


@scalars
@names
def test_nan_and_zero_pass(scalar: str, name: str) -> None:
    function = compiled(scalar)[name]
    assert np.isnan(function(np.array([np.nan]))).all()
    assert function(np.zeros(9))[3] == {"exp": 1.0, "cos": 1.0, "log": -np.inf}.get(name, 0.0)


@scalars
def test_exp_far_out(scalar: str) -> None:
    exp, expm1 = compiled(scalar)["exp"], compiled(scalar)["expm1"]
    largest = LARGEST_EXP[scalar]
    np.testing.assert_array_equal(exp([largest * 1.0001, 1e30, np.inf]), np.inf)
    np.testing.assert_array_equal(expm1([largest * 1.0001, 1e30, np.inf]), np.inf)
    assert np.isfinite(exp([largest * 0.99999])).all()
    np.testing.assert_array_equal(expm1([-200.0, -1e4, -1e30, -np.inf]), -1.0)
    np.testing.assert_array_equal(exp([-1e4, -1e30, -np.inf]), 0.0)
    # What is smaller than 2^-125.5 (2^-1021.5) is flushed to 0: nothing in between comes out wrong.
    edge = SMALLEST_POWER[scalar] * np.log(2)
    x = np.linspace(1.05 * edge, 0.95 * edge, 5000).astype(scalar)
    found, exact = exp(x), np.exp(x.astype(np.float64))
    flushed = x < edge + 0.49 * np.log(2)
    assert (found[flushed] == 0).all()
    assert (found[x > edge + 0.51 * np.log(2)] > 0).all()
    np.testing.assert_allclose(found[found > 0], exact[found > 0], rtol=3 * np.finfo(scalar).eps)


@scalars
def test_log_outside_its_domain_is_nan_and_infinity_stays(scalar: str) -> None:
    log = compiled(scalar)["log"]
    assert np.isnan(log(np.array([-1.0, -1e-30, -np.inf]))).all()
    assert log(np.array([np.inf]))[0] == np.inf
    assert log(np.array([1.0]))[0] == 0.0


@scalars
def test_asin_outside_its_domain_is_nan(scalar: str) -> None:
    x = np.array([1 + 2 * np.finfo(scalar).eps, -1.5, 7.0, np.inf], scalar)
    assert np.isnan(compiled(scalar)["asin"](x)).all()


@scalars
def test_exp_and_expm1_differ_by_one(scalar: str) -> None:
    x = np.linspace(-3, 3, 1001).astype(scalar)
    found = compiled(scalar)["exp"](x) - compiled(scalar)["expm1"](x)
    np.testing.assert_allclose(found, 1.0, atol=40 * np.finfo(scalar).eps)


def test_the_split_of_ln2_is_exact_enough() -> None:
    with mp.workdps(40):
        for precision in (elementary.FLOAT32, elementary.FLOAT64):
            high, low = (np.dtype(precision.name).type(x) for x in precision.ln2)
            k = 2 ** precision.bias.bit_length()
            assert mp.mpf(float(high)) * k == mp.mpf(float(high * high.dtype.type(k))), (
                "k times the first part is exact"
            )
            error = abs(mp.log(2) - mp.mpf(float(high)) - mp.mpf(float(low))) * k
            assert error < 0.1 * np.finfo(precision.name).eps
