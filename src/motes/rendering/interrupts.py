"""Ctrl-C while Mitsuba runs.

An exception that comes up inside a plugin would turn into another one on its way through C++.  Mitsuba has a handler of its own while it renders, which says
so, stops early and passes the signal on: what it returns then is not finished, and must not be kept.
"""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


@contextmanager
def interrupt_after(mi: Any) -> Iterator[None]:
    """Hold an interrupt back until the block is done, then raise it; a second one is not held back.

    Outside the main thread, or where the program has a handler of its own, nothing is held back.  What Mitsuba (the module `mi`) logs below an error is
    dropped meanwhile: it writes to standard output.
    """
    level = mi.log_level()
    mi.set_log_level(mi.LogLevel.Error)
    try:
        with _held_back():
            yield
    finally:
        mi.set_log_level(level)


@contextmanager
def _held_back() -> Iterator[None]:
    usual = signal.default_int_handler
    if threading.current_thread() is not threading.main_thread() or signal.getsignal(signal.SIGINT) is not usual:
        yield
        return
    pressed = False

    def note(number: int, frame: object) -> None:
        nonlocal pressed
        pressed = True
        signal.signal(signal.SIGINT, usual)

    signal.signal(signal.SIGINT, note)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, usual)
        if pressed:
            raise KeyboardInterrupt
