"""Libraries that warn of what is no business of the user's, for a moment, from any thread.

The filters of warnings belong to the whole process: where two threads set them aside at once with `warnings.catch_warnings`, the one that ends last puts
back what the other had set, and the process warns of nothing any more.  So whoever does it in Motes does it here, one after another.
"""

from __future__ import annotations

import os
import threading
import warnings
from collections.abc import Iterator
from contextlib import contextmanager

_lock = threading.RLock()  # a workbook is opened twice at times


@contextmanager
def without_warnings() -> Iterator[None]:
    """Nothing warns in here, in no thread; other threads that ask for the same wait, so keep it short."""
    with _lock, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        yield


def _forked() -> None:
    """In a child of this process: a thread of the parent, which the child has not, may have held the lock."""
    global _lock
    _lock = threading.RLock()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forked)
