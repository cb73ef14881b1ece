"""Stores that appear whole or not at all, and that one process at a time works on."""

from __future__ import annotations

import os
import secrets
import shutil
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from motes.errors import MotesError
from motes.maps import zarrs

LOCK = "lock"
# Seconds after which a hidden folder that nobody holds a lock on was left by a process that was killed: one that is younger may be about to take
# its lock.  Where a disk has no locks, the second.
YOUNG, STALE = 5.0, 24 * 3600.0


@contextmanager
def whole(path: object, *, instead: bool = False, hint: str = zarrs.PLACE) -> Iterator[Path]:
    """A path beside `path` at which to make a store, which is renamed to `path` when the block ends well.

    When the block fails, everything made here is gone again.  A process that is killed leaves a hidden folder behind, which the
    next store that is made in the same place removes.

    Parameters
    ----------
    path
        Of the store.
    instead
        Take the place of what is there.
    hint
        What to do when the disk refuses.

    Raises
    ------
    MotesError
        When something is there already, or the disk refuses.
    """
    given = Path(str(path))
    target = given.resolve() if given.is_symlink() else given
    if not instead:
        _check_free(given, f"{given} exists and is not empty", "Choose another name, or remove it")
    made: list[Path] = []
    # Named before it is made: an interrupt between the two leaves nothing.
    folder = target.parent / f".motes-{secrets.token_hex(8)}.making"
    try:
        missing = target.parent
        while not missing.exists():
            made.append(missing)
            missing = missing.parent
        target.parent.mkdir(parents=True, exist_ok=True)
        _remove_left(target.parent)
        folder.mkdir()
        with at_work(folder, given):
            store = folder / target.name
            yield store
            zarrs.consolidate(store)
            if not instead:
                _check_free(target, f"{given} was made by another process meanwhile", "Run the same command again")
            _move(store, target, folder / "replaced")
    except BaseException as error:
        shutil.rmtree(folder, ignore_errors=True)
        for empty in made:
            with suppress(OSError):
                empty.rmdir()
        refusal = error.refusal if isinstance(error, zarrs.Unwritable) else error
        if isinstance(refusal, OSError):  # said of the path that was asked for
            raise zarrs.Unwritable(given, refusal, hint) from refusal
        raise
    shutil.rmtree(folder, ignore_errors=True)


@contextmanager
def at_work(folder: Path, store: object) -> Iterator[None]:
    """Hold the lock in a folder; where a disk has no locks, or cannot be written, hold nothing.

    Raises
    ------
    MotesError
        When another process holds it.
    """
    lock = _lock(folder)
    try:
        lock.acquire(timeout=0)
    except TimeoutError:
        raise MotesError(
            f"another process is at work on {store}", "Wait until it has ended, or choose another name with -o"
        ) from None
    except (OSError, NotImplementedError):
        yield
        return
    try:
        yield
    finally:
        with suppress(OSError):
            lock.release()


def new_group(path: Path) -> Any:
    """A new, empty Zarr group of version 3."""
    return zarrs.zarr().create_group(str(path), zarr_format=3)


def _lock(folder: Path) -> Any:
    try:
        from filelock import FileLock
    except ImportError:
        raise zarrs.missing("filelock") from None
    return FileLock(str(folder / LOCK))


def _check_free(path: Path, *words: str) -> None:
    if path.exists() and (not path.is_dir() or any(path.iterdir())):
        raise MotesError(*words)


def _move(made: Path, target: Path, aside: Path) -> None:
    """Rename `made` to `target`, which is nothing, an empty folder, or what goes `aside`."""
    if target.is_dir() and not any(target.iterdir()):
        target.rmdir()
    replaced = target.exists()
    if replaced:
        os.rename(target, aside)
    try:
        os.rename(made, target)
    except OSError:
        if replaced:
            os.rename(aside, target)
        raise


def _remove_left(parent: Path) -> None:
    """Remove what killed processes left: what no process holds the lock of."""
    for left in parent.glob(".motes-*.making"):
        with suppress(OSError):
            age = time.time() - left.stat().st_mtime
            if age < YOUNG:
                continue
            lock = _lock(left)
            try:
                lock.acquire(timeout=0)
            except TimeoutError:
                continue
            except NotImplementedError:
                if age > STALE:
                    shutil.rmtree(left, ignore_errors=True)
                continue
            shutil.rmtree(left, ignore_errors=True)
            lock.release()
