"""Paths that users give: what is not there, and where results go."""

from __future__ import annotations

import difflib
import os
import re
import secrets
import shutil
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING

from motes.errors import MotesError

if TYPE_CHECKING:
    from motes.material import Material

LONGEST_NAME = 60
STALE = 24 * 3600.0  # seconds


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
    parent = given.parent
    while not parent.is_dir():
        given, parent = parent, parent.parent
    names = [entry.name for entry in parent.iterdir()]
    close = difflib.get_close_matches(given.name, names, n=3, cutoff=0.5)
    hint = (
        f"Did you mean {' or '.join(str(parent / name) for name in close)}?"
        if close
        else f"The folder {parent} exists; look there"
    )
    raise MotesError(f"{path} does not exist", hint)


def material_at(path: Path) -> Path | None:
    """The file of the material at a path, where it holds one: a JSON file, or the folder that ``motes fit`` wrote.

    A JSON file of measured data (BiRD) is none.
    """
    from motes.files import reading
    from motes.measurements import bird

    file = path / "material.json" if path.is_dir() else path
    if file.suffix.lower() != ".json" or not file.is_file():
        return None
    try:
        return None if bird.sniff(file, reading.head(file)) else file
    except OSError:  # whoever opens it says why not
        return file


def material_of(path: str) -> Material:
    """The material at a path that a user gave; measured data are an error that names the right command."""
    from motes.errors import DataError
    from motes.material import load

    given = existing(path)
    file = material_at(given)
    if file is None and given.is_dir():
        raise DataError(f"{path} holds no material.json", f"motes fit {path} makes one from measured data")
    return load(file or given)


def slug(name: str) -> str:
    """A name as part of a file name: letters, digits, dot, dash and underscore."""
    return re.sub(r"[^\w.-]+", "-", name, flags=re.ASCII).strip("-.")[:LONGEST_NAME] or "material"


@contextmanager
def results(folder: Path) -> Iterator[Path]:
    """A folder in which to write results; they move into `folder` together when the block ends well.

    `folder` is made and tried on entry, before any work is done for it.  When the block fails, everything made here is
    gone again, and what `folder` held before is untouched.  A process that is killed leaves its hidden folder behind, which
    a run on another day removes.

    Raises
    ------
    MotesError
        When the folder cannot be made or written.
    """
    made: list[Path] = []
    # Named before it is made: an interrupt between the two leaves nothing.
    staging = folder / f".motes-{secrets.token_hex(8)}.partial"
    try:
        try:
            missing = folder
            while not missing.exists() and missing != missing.parent:
                made.append(missing)
                missing = missing.parent
            folder.mkdir(parents=True, exist_ok=True)
            _remove_stale(folder)
            staging.mkdir(mode=0o700)
        except (OSError, ValueError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            raise MotesError(
                f"results cannot be written to {folder}: {reason}", "Choose another folder with -o"
            ) from error
        yield staging
        for file in sorted(staging.iterdir()):
            os.replace(file, folder / file.name)
    except BaseException:
        shutil.rmtree(staging, ignore_errors=True)
        _remove_empty(made)
        raise
    staging.rmdir()


def _remove_stale(folder: Path) -> None:
    """Remove what killed processes left; another one may be at work on a folder of today."""
    for left in folder.glob(".motes-*.partial"):
        with suppress(OSError):
            if time.time() - left.stat().st_mtime > STALE:
                shutil.rmtree(left, ignore_errors=True)


def _remove_empty(folders: list[Path]) -> None:
    for folder in folders:
        try:
            folder.rmdir()
        except OSError:
            return


def is_map(data: str) -> bool:
    """Whether the argument of a command is a Zarr store; looks at names only."""
    folder = Path(data)
    try:
        return folder.suffix == ".zarr" or any((folder / n).is_file() for n in ("zarr.json", ".zgroup", ".zarray"))
    except (OSError, ValueError):  # no path at all; the command says so
        return False
