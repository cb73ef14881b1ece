"""One block: read, fit, write.  What went wrong comes back as words, so that it can travel between machines."""

from __future__ import annotations

import ctypes
import errno
import sys
from collections.abc import Sequence
from contextlib import suppress
from functools import lru_cache
from typing import NamedTuple

from motes.fitting.texels import TexelFit
from motes.maps.fitted import FittedMap, open_fitted
from motes.maps.stack import Singles

# Dask has the C library give memory back to the system whenever an array is dropped (MALLOC_TRIM_THRESHOLD_=65536), and to clear the pages anew at the next
# block takes as long as its fits.  mallopt's numbers for what is kept at the end of a heap, and for the size from which on an array has pages of its own.
TRIM_THRESHOLD, MMAP_THRESHOLD = -1, -3
KEPT, LARGEST = 256 * 2**20, 32 * 2**20

DONE, UNREADABLE, UNWRITABLE = "done", "unreadable", "unwritable"


class Outcome(NamedTuple):
    """What became of a block: one of `DONE`, `UNREADABLE`, `UNWRITABLE`; the texels it holds, and why it failed."""

    block: tuple[int, int]
    kind: str
    texels: int
    reason: str = ""


def read_block(fitted: FittedMap, block: tuple[int, int]) -> Singles | str:
    """The values (y, x, T, D, C) of a block, or in words why they cannot be read."""
    try:
        return fitted.plan.stack.read_block(block)
    except MemoryError:
        return "its values do not fit into memory"
    except Exception as error:  # a codec raises what it likes
        return " ".join((str(error) or type(error).__name__).split())[:200]


def fit_block(fitted: FittedMap, values: Singles) -> TexelFit:
    """The fits of a block's values (y, x, T, D, C), row by row."""
    plan = fitted.plan
    if not plan.used.all():
        values = values[:, :, :, plan.used]
    size = values.shape[0] * values.shape[1]
    rows = values.reshape(size, *values.shape[2:]) if fitted.joint else values.reshape(-1, *values.shape[3:])
    return plan.solver.fit(rows, plan.starts, covariance=plan.settings.covariance)


def write_block(fitted: FittedMap, block: tuple[int, int], fit: TexelFit) -> Outcome:
    """Put a block's fits into the store; a disk that refuses is an outcome."""
    texels = fitted.blocks.texels(block)
    try:
        fitted.write(block, fit)
    except OSError as error:
        full = error.errno in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
        return Outcome(block, UNWRITABLE, texels, f"{'the disk is full: ' if full else ''}{error.strerror or error}")
    return Outcome(block, DONE, texels)


def work_on(path: str, run: str, blocks: Sequence[tuple[int, int]]) -> list[Outcome]:
    """Blocks of the fitted map at a path, as far as it can be written: what a worker of a cluster calls.  `run` tells runs into one path apart."""
    _settle()
    fitted = _opened(path, run)
    outcomes: list[Outcome] = []
    for block in blocks:
        values = read_block(fitted, block)
        if isinstance(values, str):
            outcomes.append(Outcome(block, UNREADABLE, fitted.blocks.texels(block), values))
            continue
        outcomes.append(write_block(fitted, block, fit_block(fitted, values)))
        if outcomes[-1].kind == UNWRITABLE:
            break
    return outcomes


@lru_cache(maxsize=2)
def _opened(path: str, run: str) -> FittedMap:
    return open_fitted(path, mode="r+")


@lru_cache(maxsize=1)
def _settle() -> None:
    """What a worker does once: it takes as many threads for fits as it was started with, unless it was told otherwise, and keeps its memory."""
    import os

    if "NUMBA_NUM_THREADS" not in os.environ:
        from distributed import get_worker

        os.environ["NUMBA_NUM_THREADS"] = str(get_worker().state.nthreads)
    if sys.platform == "linux":
        with suppress(OSError, AttributeError):  # another C library
            keep = ctypes.CDLL(None).mallopt
            keep(TRIM_THRESHOLD, KEPT), keep(MMAP_THRESHOLD, LARGEST)
