"""A path that a user gave: it exists, or the error says what is there that is called nearly so."""

from __future__ import annotations

import difflib
from pathlib import Path

from motes.errors import MotesError


def exists(path: str) -> bool:
    """Whether a text is the path of something, a broken link too; False for what cannot be a path."""
    given = Path(path)
    try:
        return given.exists() or given.is_symlink()
    except (OSError, ValueError):  # a name too long, a null byte
        return False


def near(path: Path) -> list[str]:
    """Paths in the same folder, or the nearest one that there is, whose names are nearly that of `path`."""
    parent = path.parent
    while not parent.is_dir():
        path, parent = parent, parent.parent
    names = [entry.name for entry in parent.iterdir()]
    return [str(parent / name) for name in difflib.get_close_matches(path.name, names, n=3, cutoff=0.5)]


def existing(path: str) -> Path:
    """`path`, which must exist; the error suggests close names."""
    given = Path(path)
    try:
        if given.exists():
            return given
    except (OSError, ValueError) as error:  # a name too long, a null byte
        raise MotesError(f"{path[:200]!r} is not a path: {error}", "Give the path of a file or folder") from None
    if given.is_symlink():
        raise MotesError(f"{path} is a link to what does not exist, or to itself", "Look at it with ls -l")
    close = near(given)
    parent = given.parent
    while not parent.is_dir():
        parent = parent.parent
    hint = f"Did you mean {' or '.join(close)}?" if close else f"The folder {parent} exists; look there"
    raise MotesError(f"{path} does not exist", hint)
