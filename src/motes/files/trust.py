"""Whether a folder is a place to run code from: nobody but its user (and root, who can do anything) may change what lies there."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterable, Iterator
from pathlib import Path

#: Links followed on the way to a folder, as in the kernel of Linux; more is a circle.
_MOST_LINKS = 40


def distrusted(folder: Path, files: Iterable[Path] = ()) -> str | None:
    """Why others could change what is run from `folder`; None where they cannot.

    Looked at are the folder, every folder and link on the way to it, and `files` in it.  Each must belong to the user of this process or
    to root, and none may be writable by others: a folder on the way may be, where its sticky bit (``/tmp``) keeps others from moving
    what is not theirs.  A group that is the user's alone counts as the user.  Files behind a folder that others cannot enter may
    have any mode, which they get from the umask.  Windows has other means, and is not looked at.

    Raises
    ------
    OSError
        When something cannot be looked at, or there are more than 40 links.
    """
    if os.name != "posix":
        return None
    *way, last = _way(folder)
    for path in way:
        status = os.lstat(path)
        if reason := _owner(path, status):
            return reason
        if not stat.S_ISLNK(status.st_mode) and _others_write(status) and not status.st_mode & stat.S_ISVTX:
            return f"others may write {path}"
    status = os.lstat(last)
    if reason := _owner(last, status):
        return reason
    if _others_write(status):
        return f"others may write {last}"
    entered = status.st_mode & (stat.S_IXGRP | stat.S_IXOTH)
    for path in files:
        status = os.lstat(path)
        if reason := _owner(path, status):
            return reason
        if stat.S_ISLNK(status.st_mode):
            return f"{path} is a link"
        if entered and _others_write(status):
            return f"others may write {path}"
    return None


def _way(folder: Path) -> Iterator[Path]:
    """Every folder and link that is passed from the root to `folder`, which comes last, without links in it."""
    here = Path(folder.anchor or "/")
    yield here
    left = list(reversed((Path.cwd() / folder).parts[1:]))
    links = 0
    while left:
        name = left.pop()
        if name == "..":
            here = here.parent
            continue
        here /= name
        yield here
        if here.is_symlink():
            links += 1
            if links > _MOST_LINKS:
                raise OSError(f"{folder} leads through more than {_MOST_LINKS} links")
            target = Path(os.readlink(here))
            here = Path(target.anchor) if target.is_absolute() else here.parent
            left += reversed(target.parts[1:] if target.is_absolute() else target.parts)
    yield here


def _owner(path: Path, status: os.stat_result) -> str | None:
    return None if status.st_uid in (os.geteuid(), 0) else f"{path} belongs to another user (number {status.st_uid})"


def _others_write(status: os.stat_result) -> bool:
    """Whether somebody besides the user and root may write, by the group's or everybody's bit (an access list shows in the group's)."""
    if status.st_mode & stat.S_IWOTH:
        return True
    return bool(status.st_mode & stat.S_IWGRP) and status.st_gid != 0 and not _own_group(status.st_gid)


def _own_group(group: int) -> bool:
    """Whether a group is the user's alone: the first group of the account, named like it, without another member."""
    import grp
    import pwd

    try:
        account, entry = pwd.getpwuid(os.geteuid()), grp.getgrgid(group)
    except KeyError:
        return False
    return account.pw_gid == group and entry.gr_name == account.pw_name and not {*entry.gr_mem} - {account.pw_name}
