"""The memory's roof over an evaluation: as many bytes read and written, next to no arithmetic.

Stores past the caches (non-temporal) spare the memory the reading of lines that are wholly overwritten.  They need whole, aligned vectors,
which LLVM's own vectoriser does not make out of single stores, so the kernel is written in vectors.
"""

from __future__ import annotations

import functools
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes import workers
from motes.kernels import engine, machine_code
from motes.kernels.assembly import FLOAT, WORD, Assembly, Builder, Value, number, vector

LANES = 8  # float32 in a vector of 32 bytes; narrower machines take it in parts
CHUNK = 65_536
BYTES = 36  # of an evaluation in float32: two directions in, three channels out


def aligned(rows: int, n: int) -> NDArray[np.float32]:
    """An array (rows, n) whose rows all begin at a multiple of a vector's size; n must be one too."""
    memory = np.zeros(rows * n + 4 * LANES, np.float32)
    first = (-memory.ctypes.data // memory.itemsize) % (4 * LANES)
    return memory[first : first + rows * n].reshape(rows, n)


def _text() -> str:
    """LLVM's text of a function that loads vectors at two addresses and stores their sums at a third, past the caches; three rows of them."""
    module = Assembly()
    builder = Builder(module)
    a, b, out, stride, first, last = given = [Value(WORD, f"%a{k}") for k in range(6)]
    past_caches = f", !nontemporal {module.metadata('!{i32 1}')}"
    with builder.loop(number(WORD, 0), number(WORD, 3), 1) as row, builder.loop(first, last, LANES) as k:
        item = builder.binary("add", builder.binary("mul", row, stride), k)
        offset = builder.binary("mul", item, number(WORD, 4))
        x, y, target = (builder.pointer(builder.binary("add", place, offset)) for place in (a, b, out))
        kind = vector(LANES, FLOAT)
        total = builder.binary("fadd", builder.load(kind, x, 4), builder.load(kind, y, 4))
        builder.store(total, target, 4 * LANES, past_caches)
    builder.lines.append("ret void")
    module.functions.append(builder.function("rows", "void", given, "nounwind"))
    return module.text()


@functools.cache
def _rows() -> machine_code.Kernel:
    return machine_code.loaded([machine_code.compiled(_text())], {"rows": (6, False)})["rows"]


def stream(a: NDArray[np.float32], b: NDArray[np.float32], out: NDArray[np.float32]) -> None:
    """Read two arrays (3, n) and write a third, on all cores: the traffic of n evaluations."""
    n = out.shape[1]
    if n % LANES or out.ctypes.data % (4 * LANES) or not all(x.flags.c_contiguous for x in (a, b, out)):
        raise ValueError(f"rows of {n} are not whole vectors, or not aligned")
    places, rows = [engine.address(x) for x in (a, b, out)], _rows()

    def work(chunk: int, room: Any) -> None:
        rows(*places, n, chunk * CHUNK, min(n, (chunk + 1) * CHUNK))

    workers.spread(-(-n // CHUNK), work, lambda: np.empty(0))


def instructions() -> list[str]:
    """The machine's instructions that store past the caches."""
    assembly = machine_code.assembly(_text())
    return sorted(
        {line.split()[0] for line in assembly.splitlines() if line.strip().startswith(("vmovnt", "movnt", "stnp"))}
    )
