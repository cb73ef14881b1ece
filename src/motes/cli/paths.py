"""Paths that users give: what is not there, and where results go."""

from __future__ import annotations

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


def material_of(text: str) -> Material:
    """The material that a user names: a file, a folder of motes fit, a preset or a model's text (see `motes.presets.named`)."""
    from motes.presets import named

    return named(text)


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
