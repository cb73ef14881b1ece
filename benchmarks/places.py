"""Where benchmarks write files, so that what they measure is their own.

ext4 passes over inodes that were deleted within the last minutes, one by one, whenever it makes a file nearby: after some thousand deletions, as
tests and other benchmarks make them, each new file takes up to a millisecond of processor time, where it takes 0.02 otherwise.  Here folders are
spread over the disk, as those at its root are, and nothing in them is deleted before all is measured.
"""

from __future__ import annotations

import array
import os
import shutil
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[1] / "out" / "bench" / "places"
# linux/fs.h: read and set a folder's flags, and the flag (chattr +T) by which what is made in it may lie anywhere.
GET, SET, SPREAD = 0x80086601, 0x40086602, 0x00020000
FILES = 256


@contextmanager
def fresh() -> Iterator[Path]:
    """A new folder, spread where the disk can do it; it is removed at the end."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    _spread(FOLDER)
    with tempfile.TemporaryDirectory(dir=FOLDER) as folder:
        yield Path(folder)


def a_file(folder: Path) -> float:
    """Microseconds of processor time that an empty file takes, the mean of `FILES`; they stay."""
    place = folder / "empty"
    place.mkdir()
    began = time.process_time()
    for k in range(FILES):
        os.close(os.open(place / str(k), os.O_CREAT | os.O_WRONLY))
    return 1e6 * (time.process_time() - began) / FILES


def emptied(store: Path, to: Path) -> Path:
    """A copy of a fitted map's store in which nothing is fitted yet."""
    return Path(shutil.copytree(store, to, ignore=_chunks))


def _chunks(folder: str, names: list[str]) -> set[str]:
    """What such a copy leaves out: the numbers of its maps, but not of its times."""
    return {"c"} & set(names) if Path(folder).name != "time" else set()


def _spread(folder: Path) -> None:
    """Say that folders in this one have nothing to do with each other; nothing where a disk knows no such thing."""
    with suppress(ImportError, OSError):
        import fcntl

        flags = array.array("i", [0])
        opened = os.open(folder, os.O_RDONLY)
        try:
            fcntl.ioctl(opened, GET, flags)
            flags[0] |= SPREAD
            fcntl.ioctl(opened, SET, flags)
        finally:
            os.close(opened)
