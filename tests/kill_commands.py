"""Kill commands at their n-th file operation, for every n, and run them again: what is there in between, and what comes of it.

``python kill_commands.py JOB FOLDER STEP`` prints a JSON line for the undisturbed run, and one for every STEP-th operation and the last few.  Each run is
a child of fork() of its own, which ends at once (``os._exit``) when it is about to open a file for writing, rename, make or remove one
below its folder; this process itself starts no threads.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from kill_everywhere import KILLED, LAST, dies_at
from motes.cli.main import main
from motes.files import leftovers, settle

# What differs from run to run: how long it took, and when it was.
VOLATILE = (
    re.compile(rb'"seconds": [0-9.e-]+'),
    re.compile(rb"\b[0-9]+\.?[0-9]* s\b"),
    re.compile(rb"\b20[0-9]{2}:[01][0-9]:[0-3][0-9] [0-9:]{8}"),  # in OpenEXR
    re.compile(rb"\b20[0-9]{2}-[01][0-9]-[0-3][0-9]T[0-9:.]+"),
)
CSV = "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,R,G,B\n" + "".join(
    f"{i},0,{o},{p},{0.1 + 0.001 * i + 0.0005 * o:.5f},{0.2 + 0.0003 * (i - o):.5f},0.{15 + (i + o + p) % 7}\n"
    for i in (5, 25, 45, 65)
    for o in (10, 30, 50, 70)
    for p in (0, 60, 120, 180)
)


@dataclass(frozen=True)
class Job:
    """A command line that writes into the current folder.

    Parameters
    ----------
    arguments
        What is run and killed; ``{inputs}`` stands for the folder of inputs.
    before
        Command lines that are run first, undisturbed: older results, which it replaces.
    needs
        A package without which it is left out.
    resumes
        Whether what is visible after a kill may be a part of the whole, which the next run goes on with: maps, frames.
    """

    arguments: tuple[str, ...]
    before: tuple[tuple[str, ...], ...] = ()
    needs: str = ""
    resumes: bool = False


FIT = ("fit", "{inputs}/rock.csv", "-m", "lambert", "-o", "out")
JOBS: dict[str, Job] = {
    "fit": Job(FIT),
    "fit over another": Job((*FIT, "--loss", "log"), before=(FIT,)),
    "fit over time": Job(("fit", "{inputs}/plaster", "-m", "lambert", "-o", "out")),
    "fit map": Job(
        ("fit", "{inputs}/map.zarr", "-m", "lambert", "--block", "2", "-o", "out.zarr"), needs="zarr", resumes=True
    ),
    "fit map, pictures": Job(
        ("fit", "{inputs}/map.zarr", "-m", "lambert", "-o", "out.zarr", "--exr", "pictures"),
        before=(("fit", "{inputs}/map.zarr", "-m", "lambert", "-o", "out.zarr", "--no-report"),),
        needs="OpenImageIO",
        resumes=True,  # a page, then pictures; these all or none
    ),
    "simulate": Job(("simulate", "out", "--scans", "2", "--step-deg", "30")),
    "simulate map": Job(("simulate", "out.zarr", "--size", "4", "--scans", "1"), needs="zarr"),
    "stack": Job(("stack", "{inputs}/pictures", "-o", "out.zarr", "--chunk", "2"), needs="OpenImageIO"),
    "dust": Job(("dust", "{inputs}/tetra.ply", "--days", "9", "--rays", "16", "-o", "out.ply"), needs="mitsuba"),
    "render": Job(
        ("render", "{inputs}/paint.json", "--size", "8", "--samples", "1", "-o", "out.png"),
        needs="mitsuba",
        resumes=True,
    ),
    "render film": Job(
        ("render", "{inputs}/dusty.json", "--size", "8", "--samples", "1", "--time", "0:9h:3", "-o", "out.gif"),
        needs="mitsuba",
        resumes=True,
    ),
    "age": Job(("age", "{inputs}/paint.json", "-p", "dust", "--hours", "9", "-o", "out.json")),
    "export": Job(("export", "{inputs}/paint.json", "--to", "materialx", "-o", "out.mtlx")),
    "export over another": Job(
        ("export", "{inputs}/paint.json", "--to", "mitsuba", "-o", "out.xml"),
        before=(("export", "{inputs}/dusty.json", "--to", "mitsuba", "-o", "out.xml"),),
    ),
    "view": Job(("view", "{inputs}/paint.json", "-o", "out.html")),
    "report": Job(("report", "{inputs}/rock.csv", "out.html")),
}


class Run(NamedTuple):
    """How a child ended, how many operations it came to, and what it said."""

    ended: int
    operations: int
    said: Any


def in_child(work: Callable[[], Any], n: int | None = None, below: Path | None = None) -> Run:
    """Run in a child, which dies at its n-th operation below a folder; what it returns comes back as JSON."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(read)
        silent = os.open(os.devnull, os.O_WRONLY)
        os.dup2(silent, 1)
        try:
            counted = dies_at(n, below) if below else [0]
            said = work()
            os.write(write, json.dumps([counted[0], said]).encode())
            os._exit(0)
        except BaseException as error:
            print(repr(error), file=sys.stderr)
            os._exit(1)
    os.close(write)
    with os.fdopen(read) as pipe:
        text = pipe.read()
    ended = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    operations, said = json.loads(text) if text else (0, None)
    return Run(ended, operations, said)


def command(arguments: tuple[str, ...], inputs: Path, own: Path) -> Callable[[], int]:
    def run() -> int:
        os.chdir(own)
        filled = [a.replace("{inputs}", str(inputs)) for a in arguments]
        if filled[0] == "report":  # no command of its own: `motes.fit(...).report(...)`
            import motes

            motes.fit(motes.read(filled[1]), "lambert").report(filled[2])
            return 0
        return main([*filled, "--quiet"])

    return run


def make_inputs(inputs: Path) -> None:
    """What the commands read, made by undisturbed children."""
    inputs.mkdir()
    (inputs / "rock.csv").write_text(CSV)
    (inputs / "tetra.ply").write_text(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"
    )
    (inputs / "pictures").mkdir()

    def pictures() -> None:
        import numpy as np

        from image_files import png_bytes

        for k in range(2):
            (inputs / "pictures" / f"{k}.png").write_bytes(png_bytes(np.full((2, 3, 1), 90 + k, np.uint8), [0]))
        (inputs / "pictures/lights.csv").write_text("file,theta_i_deg,phi_i_deg\n0.png,10,0\n1.png,30,0\n")

    assert in_child(pictures).ended == 0
    for arguments in (
        ("fit", "{inputs}/rock.csv", "-m", "oren_nayar", "--no-report", "-o", "fitted"),
        ("age", "fitted", "-p", "dust", "--hours", "9", "-o", "dusty.json"),
        ("simulate", "plaster", "--scans", "3", "--step-deg", "20"),
        ("simulate", "map.zarr", "--size", "4", "--scans", "1"),
    ):
        done = in_child(command(arguments, inputs, inputs))
        assert done.said == 0, arguments
    os.rename(inputs / "fitted/material.json", inputs / "paint.json")


def visible(own: Path) -> dict[str, str]:
    """The files that a user sees, as digests without what differs from run to run; a store as what it holds."""
    found: dict[str, str] = {}
    for path in sorted(own.rglob("*")):
        relative = path.relative_to(own)
        inside = next((p for p in (path, *path.parents) if p.suffix == ".zarr"), None)
        if any(part.startswith(".") for part in relative.parts) or (path.is_dir() and path != inside):
            continue
        if inside is None:
            data = path.read_bytes()
            for pattern in VOLATILE:
                data = pattern.sub(b"", data)
            found[str(relative)] = hashlib.sha256(data).hexdigest()[:16]
        elif path == inside:
            import maps_support
            from motes import maps

            maps.open_map(path)  # or it is broken
            held = maps_support.contents(path)
            found[str(relative)] = hashlib.sha256(repr(sorted(held.items())).encode()).hexdigest()[:16]
    return found


def state(own: Path) -> Callable[[], dict[str, str]]:
    """What is there for whoever comes next, a reader or a writer."""

    def look() -> dict[str, str]:
        for folder in {own, own / "out", own / "pictures"}:
            settle(folder)
        return visible(own)

    return look


def killed(job: Job, inputs: Path, own: Path, n: int | None) -> dict[str, Any]:
    """Run a job in a fresh folder, kill it at its n-th operation, run it again; what was seen."""
    own.mkdir()
    for earlier in job.before:
        assert in_child(command(earlier, inputs, own)).said == 0, earlier
    before = in_child(state(own)).said
    run = in_child(command(job.arguments, inputs, own), n, own)
    after = in_child(state(own))
    again = in_child(command(job.arguments, inputs, own)) if n is not None and not refuses(job, after.said) else run
    last = in_child(state(own))
    hidden = sorted(p.name for p in own.rglob(".*")) if n is not None else []
    return {
        "n": n,
        "ended": run.ended,
        "operations": run.operations,
        "before": before,
        "after": after.said,
        "again": again.said,
        "last": last.said,
        "hidden": hidden,
    }


def refuses(job: Job, there: dict[str, str] | None) -> bool:
    """Whether a command overwrites nothing, and what it makes is there already."""
    return job.arguments[0] in ("simulate", "stack") and bool(there)


def wrong(job: Job, whole: dict[str, Any], one: dict[str, Any]) -> str:
    """What is wrong with a killed run, compared with the undisturbed one; empty when nothing is."""
    if one["ended"] != KILLED:
        return f"it ended with {one['ended']}"
    if one["after"] is None or one["last"] is None:
        return "what it left cannot be read"
    if not job.resumes and one["after"] not in (one["before"], whole["after"]):
        return f"half-made: {sorted(one['after'])}"
    if job.resumes and not set(one["after"]) <= set(whole["after"]) | {n for n in one["after"] if ".frames-" in n}:
        return f"half-made: {sorted(one['after'])}"
    if one["again"] not in (0, None) or one["last"] != whole["after"]:
        return f"not the same after another run: {one['again']}, {sorted(one['last'])}"
    if one["hidden"] and one["again"] == 0 and not refuses(job, one["after"]):
        return f"left behind: {one['hidden']}"
    return ""


def tried(name: str, folder: Path, step: int) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    """The undisturbed run of a job, and the killed ones."""
    job, inputs = JOBS[name], folder / "inputs"
    leftovers.YOUNG = 0.0  # what was killed a moment ago counts as left
    from motes.maps import making

    making.YOUNG = 0.0
    folder.mkdir(exist_ok=True)
    if not inputs.exists():
        make_inputs(inputs)
    folder.mkdir(exist_ok=True)
    own = folder / re.sub(r"\W+", "-", name)
    own.mkdir()
    whole = killed(job, inputs, own / "whole", None)
    assert (whole["ended"], whole["again"]) == (0, 0), whole
    count = whole["operations"]
    runs = [
        killed(job, inputs, own / f"{n}", n)
        for n in sorted({*range(0, count, step), *range(max(count - LAST, 0), count)})
    ]
    for one in runs:
        one["wrong"] = wrong(job, whole, one)
    return whole, runs


if __name__ == "__main__":
    undisturbed, every = tried(sys.argv[1], Path(sys.argv[2]).resolve(), int(sys.argv[3]))
    for line in (undisturbed, *every):
        print(json.dumps(line), flush=True)
