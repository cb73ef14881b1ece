"""The same equations over every namespace, on the same numbers: NumPy, PyTorch, JAX, Dr.Jit and the tracer's graph."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose
from numpy.typing import NDArray

import golden
from catalogue import jax_in_float64
from golden import Rows
from golden.equations import EQUATIONS, Equation
from motes.arrays import NUMPY, namespace
from motes.graph import tracing

Column = NDArray[np.float64]


def over_torch(equation: Equation, rows: Rows) -> Column:
    torch = pytest.importorskip("torch")
    xp = namespace(torch.zeros(1))
    assert xp.name == "torch"
    return equation.evaluate(xp, rows, torch.as_tensor).numpy()


def over_jax(equation: Equation, rows: Rows) -> Column:
    with jax_in_float64():
        import jax.numpy as jnp

        xp = namespace(jnp.zeros(1))
        assert xp.name == "jax"
        return np.asarray(equation.evaluate(xp, rows, jnp.asarray))


def over_drjit(equation: Equation, rows: Rows) -> Column:
    """Four numbers at a time: arrays of fixed size need no compiler.  (asin of Dr.Jit 1.5 fails on scalar.ArrayXf64.)"""
    Array4f64 = pytest.importorskip("drjit.scalar").Array4f64
    xp = namespace(Array4f64(0))
    assert xp.name == "drjit"
    n = len(rows["theta_i"])
    blocks = [np.arange(k, k + 4) % n for k in range(0, n, 4)]
    values = [
        equation.evaluate(xp, {name: column[block] for name, column in rows.items()}, Array4f64) for block in blocks
    ]
    return np.concatenate([np.array(v) for v in values])[:n]


def over_python_numbers(equation: Equation, rows: Rows) -> Column:
    """Dr.Jit's functions on plain numbers, as in Mitsuba's scalar variants."""
    xp = namespace(pytest.importorskip("drjit.scalar").Array4f64(0))
    n = len(rows["theta_i"])
    one_by_one = ({name: float(column[k]) for name, column in rows.items() if column.ndim == 1} for k in range(n))
    return np.array([equation.evaluate(xp, row) for row in one_by_one])


def over_a_graph(equation: Equation, rows: Rows) -> Column:
    """Record the equation on symbols, then run the record."""
    graph = tracing.Graph()
    leaves = {name: graph.leaf(name) for name in equation.arguments}
    assert namespace(*leaves.values()) is graph
    output = equation.evaluate(graph, leaves)
    return tracing.evaluate(NUMPY, [output], {leaf: rows[name] for name, leaf in leaves.items()})[0]


NAMESPACES: dict[str, Callable[[Equation, Rows], Any]] = {
    "torch": over_torch,
    "jax": over_jax,
    "drjit": over_drjit,
    "python numbers": over_python_numbers,
    "graph": over_a_graph,
}


@pytest.fixture(scope="module")
def rows() -> Rows:
    return golden.appendices()


@pytest.mark.parametrize("name", EQUATIONS)
@pytest.mark.parametrize("library", NAMESPACES)
def test_the_same_numbers(rows: Rows, library: str, name: str) -> None:
    equation = EQUATIONS[name]
    # exp may differ by an ulp between libraries, and JAX and Dr.Jit flush what is below 2.3e-308.
    assert_allclose(NAMESPACES[library](equation, rows), equation.evaluate(NUMPY, rows), rtol=2e-15, atol=1e-307)


def test_a_graph_recalls_the_author_s_order_exactly(rows: Rows) -> None:
    for equation in EQUATIONS.values():
        assert np.array_equal(over_a_graph(equation, rows), equation.evaluate(NUMPY, rows))


LLVM = sorted((Path(sys.prefix) / "lib").glob("libLLVM.so.*"))  # of the wheel karellen-llvm-core

COMPILED = """
import numpy as np, golden
from drjit.llvm import Float64
from golden.equations import EQUATIONS
from motes.arrays import NUMPY, namespace
rows = golden.appendices()
for equation in EQUATIONS.values():
    value = np.array(equation.evaluate(namespace(Float64(0)), rows, Float64))
    np.testing.assert_allclose(value, equation.evaluate(NUMPY, rows), rtol=2e-15, atol=1e-307)
print("the same", len(EQUATIONS))
"""


@pytest.mark.skipif(not LLVM, reason="the wheel karellen-llvm-core is not installed")
def test_the_same_numbers_compiled_by_drjit() -> None:
    """In a process of its own, for the library must be chosen before Dr.Jit loads, and some versions end the interpreter."""
    pytest.importorskip("drjit")
    environment = os.environ | {"DRJIT_LIBLLVM_PATH": str(LLVM[-1]), "PYTHONPATH": str(Path(__file__).parent)}
    done = subprocess.run(
        [sys.executable, "-c", COMPILED], env=environment, capture_output=True, text=True, timeout=300, check=False
    )
    assert done.stdout.split() == ["the", "same", str(len(EQUATIONS))], done.stderr[-2000:]
