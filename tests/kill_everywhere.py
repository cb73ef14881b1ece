"""Kill a process at its n-th file operation, for every n: a child of fork() ends at once when it is about to open for writing, rename, make or remove.

``python kill_everywhere.py JOB FOLDER STEP`` runs a job of `JOBS` in one fresh folder below FOLDER for every STEP-th n and the last few, and prints a
JSON line for each: what was there afterwards, and what another run of the same made of it.  The first line is of a run that was not killed.  A process of its
own: it forks before anything has started threads that matter.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import maps_support as support
from motes import maps
from motes.errors import MotesError
from motes.maps import making
from motes.maps.beginning import create_fitted
from motes.maps.plan import Plan

MODEL = "lambert"
# What the interpreter tells of before it does it; "open" counts when it is for writing.
OPERATIONS = {"os.mkdir", "os.rename", "os.remove", "os.rmdir", "os.link", "os.truncate"}
KILLED = 137
LAST = 4  # operations, before the end of which all are tried: among them is the renaming
FITS = ("create", "restart")
WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT


def dies_at(n: int | None, below: Path) -> list[int]:
    """End this process before its n-th operation on what is below a folder, or in the current one; a list of one, the number of operations so far."""
    count = [0]

    def hook(event: str, arguments: tuple[Any, ...]) -> None:
        if event not in OPERATIONS and not (event == "open" and int(arguments[2] or 0) & WRITING):
            return
        name = arguments[0]
        if not isinstance(name, (str, os.PathLike)) or not os.path.abspath(name).startswith(str(below)):
            return
        if count[0] == n:
            os._exit(KILLED)
        count[0] += 1

    sys.addaudithook(hook)
    return count


def simulate(folder: Path) -> None:
    maps.simulate_map(folder / "out.zarr", (4, 4), times=1, lights=2, chunk=4)


def stack(folder: Path) -> None:
    maps.import_images(PICTURES, folder / "out.zarr", chunk=2)


def create(folder: Path) -> None:
    """What `fit_map` does first; its plan is made beforehand, for a child of fork() has no threads of kernels."""
    create_fitted(folder / "out.zarr", PLANS[0], restart=False)


def restart(folder: Path) -> None:
    create_fitted(folder / "out.zarr", PLANS[0], restart=True)


PLANS: list[Plan] = []
PICTURES = Path(os.environ.get("PICTURES", ""))
JOBS: dict[str, Callable[[Path], None]] = {"simulate": simulate, "stack": stack, "create": create, "restart": restart}


def state(folder: Path) -> str:
    """What is there: nothing, or a whole store in hex digits of what it holds."""
    path = folder / "out.zarr"
    if not path.exists():
        return "nothing"
    try:
        found = maps.open_map(path)
        held = support.contents(path)
        return "whole " + str(hash((type(found).__name__, *sorted(held.items()))))
    except MotesError as error:
        return f"broken: {error}"


def main(job: str, folder: Path, step: int) -> None:
    making.YOUNG = 0.0  # what was killed a moment ago counts as left
    if job in FITS:
        source = maps.simulate_map(folder / "source.zarr", (4, 4), times=1, lights=2, chunk=4)
        PLANS.append(maps.fit_map(source, MODEL, out=folder / "fitted.zarr").plan)
    count = killed(job, folder / "all", None)
    for n in sorted({*range(0, count, step), *range(count - LAST, count)}):
        killed(job, folder / f"{n}", n)


def killed(job: str, own: Path, n: int | None) -> int:
    """Run a job in a fresh folder, kill it at its n-th operation, run it again, print a line; the number of operations."""
    own.mkdir()
    if job == "restart":
        support.copy(own.parent / "fitted.zarr", own / "out.zarr")
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        counted = dies_at(n, own)
        try:
            JOBS[job](own)
            os.write(write, str(counted[0]).encode())
            os._exit(0)
        except BaseException:
            os._exit(1)
    os.close(write)
    ended = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    with os.fdopen(read) as pipe:
        operations = int(pipe.read() or 0)
    after, again = state(own), ""
    try:
        if job in FITS:
            maps.fit_map(own.parent / "source.zarr", MODEL, out=own / "out.zarr", restart=job == "restart")
        elif after == "nothing":
            JOBS[job](own)
        again = state(own)
    except MotesError as error:
        again = f"refused: {error}"
    left = sorted(p.name for p in own.iterdir())
    print(json.dumps({"n": n, "ended": ended, "after": after, "again": again, "left": left}), flush=True)
    return operations


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]), int(sys.argv[3]))
