"""Memory for results, taken again once nobody holds the results that it had.

A system hands out new memory a page at a time, each when it is first written to, and each filled with zeros before: for an array that a
kernel fills at some gigabytes a second that takes as long as half of its work.  Programs evaluate again and again, and drop what they got before.
"""

from __future__ import annotations

import os
import sys
import threading
from math import prod
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

#: Bytes that are kept at most; 0 keeps none.
POOL = 1 << 28
#: Smaller arrays are left to the allocator, which keeps them itself.
LEAST = 1 << 20

Block = NDArray[np.uint8]
_blocks: list[Block] = []  # the one used last at the end
_lock = threading.RLock()
# What the interpreter counts for a block that nobody holds but the list: every view of a block, and of a view, holds the block.
_PROBE = [np.empty(0, np.uint8)]
_ALONE = sys.getrefcount(_PROBE[0])
# Without the interpreter's lock a count may be late.
_COUNTS = sys.implementation.name == "cpython" and getattr(sys, "_is_gil_enabled", lambda: True)()


def empty(shape: tuple[int, ...], scalar: DTypeLike) -> NDArray[Any]:
    """An array in C order whose values are not set, as that of `numpy.empty`."""
    kind = np.dtype(scalar)
    size = prod(shape) * kind.itemsize
    if not (_COUNTS and LEAST <= size <= POOL):
        return np.empty(shape, kind)
    with _lock:
        found = _taken(size)
        return found[:size].view(kind).reshape(shape)


def _taken(size: int) -> Block:
    """A block of at least so many bytes that nobody holds, a new one if need be; it is the last of the list."""
    for k in range(len(_blocks)):
        if size <= len(_blocks[k]) <= size + size // 4 and sys.getrefcount(_blocks[k]) == _ALONE:
            _blocks.append(_blocks.pop(k))
            return _blocks[-1]
    _blocks.append(np.empty(size, np.uint8))
    kept = sum(map(len, _blocks))
    while kept > POOL:  # let go of: whoever holds it still does
        kept -= len(_blocks.pop(0))
    return _blocks[-1]


def _forked() -> None:
    """In a child of this process: a thread of the parent, which the child has not, may have held the lock."""
    global _lock
    _lock = threading.RLock()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forked)
