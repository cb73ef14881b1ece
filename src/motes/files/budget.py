"""How much memory a file may ask for: at most 20 times its own size or 64 MiB, whichever is more, unless somebody asks for more.

Compressed formats let a file of some kilobytes claim gigabytes.  Every reader of one works out what its arrays will take from headers, which cost nothing,
and calls `check` before it decodes anything.
"""

from __future__ import annotations

import os
from pathlib import Path

from motes.errors import FormatError, MotesError

FACTOR, LEAST = 20, 64 * 2**20
# No machine has as many bytes.
ABSURD = 2**60
#: The environment variable by which more is asked for, in MiB.
VARIABLE = "MOTES_LARGEST_MIB"


def allowed(size: int) -> int:
    """Bytes of memory that a file of `size` bytes may take.

    Raises
    ------
    MotesError
        When the environment variable is set to something that is not a number of MiB.
    """
    asked = os.environ.get(VARIABLE, "").strip()
    if asked and not (asked.isascii() and asked.isdigit() and 0 < len(asked) < 10):
        raise MotesError(f"{VARIABLE} = {asked[:40]!r} is not a number of MiB", f"Set {VARIABLE}=4096 for 4 GiB")
    return max(FACTOR * size, LEAST, int(asked or 0) * 2**20)


def check(path: Path, needed: int, what: str, size: int | None = None) -> None:
    """Refuse what would take more than a file may.

    Parameters
    ----------
    path
        The file.
    needed
        Bytes of memory.
    what
        What takes them, for the sentence: ``"4096 x 4096 pixels of 64 channels"``.
    size
        Bytes of the file where they are known already.

    Raises
    ------
    FormatError
        With the sizes, and how to ask for more.
    """
    length = path.stat().st_size if size is None else size
    if needed > allowed(length):
        raise FormatError(
            f"{path} has {length:,} bytes, and {what} would take {mebibytes(needed)} of memory, more than {allowed(length) / 2**20:,.0f}",
            advice(needed),
        )


def mebibytes(size: int) -> str:
    """A size for a sentence; headers may claim what no float holds."""
    return f"{size / 2**20:,.0f} MiB" if size < ABSURD else f"more than {ABSURD / 2**20:.0e} MiB"


def advice(needed: int) -> str:
    """How to ask for `needed` bytes, where anybody could have them."""
    if needed >= ABSURD:
        return "It is damaged; fetch or write it again"
    return f"Where the file is meant to be so, set {VARIABLE}={-(-needed // 2**20)} in the environment"
