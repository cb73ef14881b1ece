"""Writing files so that nothing half-written is ever seen: beside, then renamed into place."""

from __future__ import annotations

import json
import os
import re
import secrets
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from pathlib import Path
from typing import Any

from motes.errors import MotesError
from motes.files import leftovers

_STAGING = re.compile(r"\.motes-[0-9a-f]{16}\.partial")
_OURS = re.compile(r"\..+\.[0-9a-f]{8}\.partial", re.DOTALL)


#: Device and number of files that a command reads: nothing is written over them, but under the very name that was asked for.
READ: ContextVar[frozenset[tuple[int, int]]] = ContextVar("read", default=frozenset())


def identity(path: str | os.PathLike[str]) -> tuple[int, int] | None:
    """Device and number of a file; None where there is none."""
    try:
        found = os.stat(path)
    except (OSError, ValueError):
        return None
    return found.st_dev, found.st_ino


@contextmanager
def replacing(path: str | os.PathLike[str]) -> Iterator[Path]:
    """A temporary path beside `path`, renamed onto it when the block ends well, removed when it does not.

    What a killed process leaves, the next one that writes to the folder removes.

    Raises
    ------
    MotesError
        When the folder cannot be made or written, or the disk is full; when it is a file that the command reads.
    """
    target = Path(path)
    if READ.get() and identity(_shown(target)) in READ.get():
        raise MotesError(f"{_shown(target)} is read here, and would be written over", "Give another name with -o")
    temporary: Path | None = None
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        _remove_left(target.parent)
        name = target.with_name(f".{target.name}.{secrets.token_hex(4)}.partial")
        # Results have the mode that the umask gives them, as the system applies it: to read it is to set it, for all threads.
        os.close(os.open(name, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666))
        temporary = name
        with leftovers.held(temporary):
            yield temporary
            os.replace(temporary, target)
        temporary = None
    except OSError as error:
        reason = error.strerror or str(error)
        raise MotesError(
            f"{_shown(target)} cannot be written: {reason}",
            "Choose a folder that exists, is writable and has room, with -o",
        ) from error
    finally:
        if temporary is not None:
            temporary.unlink(missing_ok=True)


def _shown(target: Path) -> Path:
    """The path that was asked for: of a file that is to appear `together` with others."""
    return target.parent.parent / target.name if _STAGING.fullmatch(target.parent.name) else target


def check_writable(path: str | os.PathLike[str]) -> None:
    """Raise what `replacing` would where a file cannot be written, before the work; what is there stays as it is."""
    with suppress(_Tried), replacing(path):
        raise _Tried


class _Tried(Exception):
    """Ends a block whose file is not to be replaced."""


_cleaned: set[str] = set()


def _remove_left(folder: Path) -> None:
    """Remove what killed processes left in a folder; a process looks at each folder once, for folders of frames are long."""
    name = os.path.abspath(folder)
    if name not in _cleaned:
        _cleaned.add(name)
        leftovers.remove(file for file in folder.glob(".*.partial") if _OURS.fullmatch(file.name) and file.is_file())


def write_text(path: str | os.PathLike[str], text: str) -> Path:
    """Write `text` as UTF-8 to `path`, whole or not at all."""
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8")
    return Path(path)


def write_json(path: str | os.PathLike[str], plain: Any) -> Path:
    """Write plain JSON values, NaN not among them, whole or not at all."""
    return write_text(path, json.dumps(plain, indent=1, allow_nan=False) + "\n")
