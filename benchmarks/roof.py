"""The memory's roof over an evaluation: as many bytes read and written, next to no arithmetic.

Stores past the caches (non-temporal) spare the memory the reading of lines that are wholly overwritten.  They need whole, aligned vectors,
which LLVM's own vectoriser does not make out of single stores, so the kernel is written in vectors.
"""

from __future__ import annotations

from typing import Any

import numba
import numpy as np
from llvmlite import ir
from numba.core import types
from numba.extending import intrinsic
from numpy.typing import NDArray

from motes import workers
from motes.kernels import engine

LANES = 8  # float32 in a vector of 32 bytes; narrower machines take it in parts
CHUNK = 65_536
BYTES = 36  # of an evaluation in float32: two directions in, three channels out


def aligned(rows: int, n: int) -> NDArray[np.float32]:
    """An array (rows, n) whose rows all begin at a multiple of a vector's size; n must be one too."""
    memory = np.zeros(rows * n + 4 * LANES, np.float32)
    first = (-memory.ctypes.data // memory.itemsize) % (4 * LANES)
    return memory[first : first + rows * n].reshape(rows, n)


@intrinsic
def _stream(typing: Any, a: Any, b: Any, out: Any, offset: Any) -> Any:
    """Load a vector at each of the addresses `a` and `b`, and store their sum at `out`, past the caches; `offset` in bytes."""

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        vector = ir.VectorType(ir.FloatType(), LANES).as_pointer()
        x, y, target = (builder.inttoptr(builder.add(base, args[3]), vector) for base in args[:3])
        total = builder.fadd(builder.load(x, align=4), builder.load(y, align=4))
        store = builder.store(total, target, align=4 * LANES)
        store.set_metadata("nontemporal", builder.module.add_metadata([ir.Constant(ir.IntType(32), 1)]))
        return context.get_dummy_value()

    return types.none(*[types.int64] * 4), generate


@numba.njit("void(int64, int64, int64, int64, int64, int64)", nogil=True)
def _rows(a, b, out, stride, first, last):  # type: ignore[no-untyped-def]
    for row in range(3):
        for k in range(first, last, LANES):
            _stream(a, b, out, 4 * (row * stride + k))


def stream(a: NDArray[np.float32], b: NDArray[np.float32], out: NDArray[np.float32]) -> None:
    """Read two arrays (3, n) and write a third, on all cores: the traffic of n evaluations."""
    n = out.shape[1]
    if n % LANES or out.ctypes.data % (4 * LANES) or not all(x.flags.c_contiguous for x in (a, b, out)):
        raise ValueError(f"rows of {n} are not whole vectors, or not aligned")
    places = [engine.address(x) for x in (a, b, out)]

    def work(chunk: int, room: Any) -> None:
        _rows(*places, n, chunk * CHUNK, min(n, (chunk + 1) * CHUNK))

    workers.spread(-(-n // CHUNK), work, lambda: np.empty(0))


def instructions() -> list[str]:
    """The machine's instructions that store past the caches."""
    (assembly,) = _rows.inspect_asm().values()
    return sorted(
        {line.split()[0] for line in assembly.splitlines() if line.strip().startswith(("vmovnt", "movnt", "stnp"))}
    )
