"""Results of several files, which appear together or not at all.

They are written into a hidden folder beside, which is renamed once all are whole: from then on the decision has fallen, and whoever comes next
moves what a killed process did not (`settle`).
"""

from __future__ import annotations

import os
import secrets
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from motes.errors import MotesError
from motes.files import leftovers

PARTIAL, DECIDED, REPLACED = ".partial", ".decided", ".motes-replaced-"


@contextmanager
def together(folder: Path, hint: str = "Choose another folder with -o") -> Iterator[Path]:
    """A hidden folder in which to write files and folders; they move into `folder` together when the block ends well.

    `folder` is made and tried on entry, before any work is done for it.  When the block fails, everything made here is gone
    again, and what `folder` held before is untouched.  What a killed process leaves behind, the next one removes, or moves
    where the decision had fallen.

    Raises
    ------
    MotesError
        When the folder cannot be made or written, or holds a folder by the name of a file.
    """
    made: list[Path] = []
    # Named before it is made: an interrupt between the two leaves nothing.
    staging = folder / f".motes-{secrets.token_hex(8)}{PARTIAL}"
    try:
        try:
            missing = folder
            while not missing.exists() and missing != missing.parent:
                made.append(missing)
                missing = missing.parent
            folder.mkdir(parents=True, exist_ok=True)
            leftovers.remove(folder.glob(f".motes-*{PARTIAL}"))
            staging.mkdir(mode=0o700)
        except (OSError, ValueError) as error:
            raise _unwritable(folder, error, hint) from error
        with leftovers.held(staging):
            yield staging
            settle(folder)
            try:
                _check(staging, folder, hint)
                decided = staging.with_suffix(DECIDED)
                os.rename(staging, decided)
                _move(decided, folder)
            except OSError as error:
                raise _unwritable(folder, error, hint) from error
    except BaseException:
        shutil.rmtree(staging, ignore_errors=True)
        for empty in made:
            try:
                empty.rmdir()
            except OSError:
                break
        raise


def settle(folder: Path) -> None:
    """Move what a process that was killed had decided to; nothing where the folder cannot be read or written."""
    with suppress(OSError):
        for decided in sorted(folder.glob(f".motes-*{DECIDED}")):
            if leftovers.abandoned(decided, young=0.0):  # it held its lock before it had this name
                _move(decided, folder)


def _check(staging: Path, folder: Path, hint: str) -> None:
    """Refuse before anything has moved what could not move."""
    for file in staging.iterdir():
        target = folder / file.name
        if os.path.lexists(target) and target.is_dir() != file.is_dir():
            kind = "a folder" if target.is_dir() else "a file"
            raise MotesError(f"{target} is {kind}, and results would take its place", f"Rename it. {hint}")


def _move(decided: Path, folder: Path) -> None:
    for file in sorted(decided.iterdir()):
        if file.name.startswith(REPLACED):
            continue
        target = folder / file.name
        if file.is_dir() and target.is_dir():  # a folder takes the place of an empty one only
            os.rename(target, decided / f"{REPLACED}{secrets.token_hex(4)}")
        os.replace(file, target)
    shutil.rmtree(decided)


def _unwritable(folder: Path, error: Exception, hint: str) -> MotesError:
    return MotesError(f"results cannot be written to {folder}: {getattr(error, 'strerror', None) or error}", hint)
