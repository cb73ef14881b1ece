"""What a process that was killed leaves behind, told from what another one is at work on: the latter holds a lock."""

from __future__ import annotations

import os
import shutil
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]

# Seconds: what is younger may be about to take its lock; what is older than the second is left, where a disk has no locks.
YOUNG, STALE = 5.0, 24 * 3600.0


@contextmanager
def held(path: Path) -> Iterator[None]:
    """Hold the lock of a file or folder, whatever it is renamed to, where its disk has locks; a process that ends lets go of it."""
    try:
        handle = (
            -1 if fcntl is None else os.open(path, os.O_RDONLY)
        )  # where there is no lock, what is open may not be renamed either
    except OSError:  # a umask that takes reading away
        handle = -1
    if handle < 0:
        yield
        return
    try:
        with suppress(OSError):
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield
    finally:
        os.close(handle)


def abandoned(path: Path, young: float | None = None) -> bool:
    """Whether nobody is at work on a file or folder that is at least so old (`YOUNG`); False where it cannot be told."""
    try:
        age = time.time() - path.stat().st_mtime
        if age < (YOUNG if young is None else young):
            return False
        if fcntl is None:
            return age > STALE
        handle = os.open(path, os.O_RDONLY)
    except OSError:
        return False
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:
        return age > STALE
    finally:
        os.close(handle)
    return True


def remove(paths: Iterable[Path]) -> None:
    """Remove those files and folders that are `abandoned`."""
    for path in paths:
        if abandoned(path):
            with suppress(OSError):
                shutil.rmtree(path) if path.is_dir() else path.unlink()
