"""Damage files of every format, many times, read them, and write docs/fuzzing.md.

    python tools/fuzz.py --minutes 1                                  # what make fuzz MINUTES=1 does
    python tools/fuzz.py --count 100000 --kept out/fuzzing.json --output docs/fuzzing.md  # goes on where it was left

Small valid specimens (`fuzz_specimens.py`) are damaged (`fuzz_damage.py`) and read as users read them (`fuzz_readers.py`), each format in a process of
its own whose address space may grow by 96 MiB over what it had: what a file may take (`motes.files.budget`) and half as much for what is made of it.
The viewer's parsers run under Node (`viewer/fuzz.mjs`, `fuzz_viewer.py`).  What counts as a failure: an exception that is no `MotesError`, an error
without a hint, memory refused by the system or more than a file may take, an input that takes ten seconds of computing or from which nothing is heard
for a minute, the end of the process; the next process goes on after it.
"""

from __future__ import annotations

import argparse
import ctypes
import json
import logging
import multiprocessing
import os
import resource
import shutil
import signal
import sys
import tempfile
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from multiprocessing.connection import Connection, wait
from pathlib import Path

import fuzz_damage
import fuzz_specimens  # first of what needs the folders that it finds
import fuzz_viewer
import numpy as np
from fuzz_page import GOOD, Outcome, keep, kept, page
from fuzz_readers import OTHERS, measurement

import measurement_files as files
from motes.errors import MotesError
from motes.files import budget
from motes.measurements import READERS

GROWTH = 96 * 2**20
SECONDS = 10.0  # of computing
SILENCE = 60.0  # seconds
EACH = 200  # inputs after which the memory that a process has is looked at again
MOST_DEATHS = 20
EVERY = 20.0  # seconds after which what was done is kept
M_ARENA_MAX = -8  # of malloc.h
SHARED_MEMORY = "/dev/shm" if Path("/dev/shm").is_dir() else None


class Slow(Exception):
    """An input that takes too long."""


@contextmanager
def limited() -> Iterator[None]:
    """Raise `Slow` after so many seconds of computing, whatever else the machine does."""

    def ring(*_: object) -> None:
        raise Slow

    signal.signal(signal.SIGPROF, ring)
    signal.setitimer(signal.ITIMER_PROF, SECONDS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


def attempt(path: Path, name: str, turn: int) -> str:
    """What became of one input: "read", "refused", or what went wrong."""
    try:
        with limited():
            return OTHERS.get(name, measurement)(path, name, turn)
    except MotesError as error:
        if "more memory than there is" in error.message:
            return "memory"
        return "refused" if error.message and error.hint else f"no hint: {error.message[:80]}"
    except Slow:
        return f"longer than {SECONDS:g} s"
    except MemoryError:
        return "memory"
    except Exception as error:
        return f"{type(error).__name__}: {str(error)[:80]}"


def space() -> int:
    """Bytes of address space that this process has."""
    return int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()


def one_arena() -> None:
    """Have the C library keep all memory in one place: otherwise it reserves 64 MiB of address space for each new thread."""
    with suppress(AttributeError, OSError):  # another C library
        ctypes.CDLL(None).mallopt(M_ARENA_MAX, 1)


def most_held(record: int) -> int:
    """The most memory [bytes] that this process held since the call before; `record` is /proc/self/clear_refs, open."""
    most = 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    os.write(record, b"5")
    return most


def work(name: str, count: int, seconds: float, seed: int, scratch: str, pipe: Connection) -> None:
    """Damage, read, count; in a process of its own."""
    one_arena()
    warnings.simplefilter("error")
    logging.disable()  # of libraries: what is raised is what counts
    rng, outcome = np.random.default_rng(seed), Outcome()
    specimens = fuzz_specimens.specimens()[name]()
    folders = [Path(scratch) / str(k) for k in range(len(specimens))]
    for (specimen, target), folder in zip(
        specimens, folders, strict=True
    ):  # everything is loaded before the limit is set
        files.write_all(folder, specimen)
        if (first := attempt(folder / target, name, 1)) != "read":
            raise AssertionError(f"{name}: a specimen was not read: {first}")
    pipe.send(outcome)  # the specimens are well
    record = os.open("/proc/self/clear_refs", os.O_WRONLY)
    end, heard = time.monotonic() + seconds, time.monotonic()
    hard = resource.getrlimit(resource.RLIMIT_AS)[1]
    for turn in range(count):
        if turn % EACH == 0:
            resource.setrlimit(resource.RLIMIT_AS, (space() + GROWTH, hard))
        now = time.monotonic()
        if now > end:
            break
        if now > heard + 1:
            pipe.send(outcome)
            heard = now
        k = turn % len(specimens)
        (specimen, target), folder = specimens[k], folders[k]
        victim = sorted(specimen)[int(rng.integers(len(specimen)))]
        changed = fuzz_damage.damaged(specimen[victim], rng)
        (folder / victim).write_bytes(changed)
        most_held(record)
        before, start = most_held(record), time.process_time()
        what = attempt(folder / target, name, turn)
        took, most = time.process_time() - start, most_held(record) - before
        if what in GOOD and most > budget.allowed(len(changed)):
            what = "more memory than it may take"
        outcome.add(
            what, took, most, len(changed), lambda victim=victim, changed=changed: f"{victim}: {changed[:4000].hex()}"
        )
        (folder / victim).write_bytes(specimen[victim])
    resource.setrlimit(resource.RLIMIT_AS, (hard, hard))
    pipe.send(outcome)


class Running:
    """A format, and the process that is at work on it now."""

    def __init__(self, name: str, count: int, seconds: float, seed: int, folder: str, before: Outcome) -> None:
        self.name, self.count, self.folder = name, count, folder
        self.seed = seed + before.inputs  # not the inputs of the sitting before again
        self.end = time.monotonic() + seconds
        self.before, self.now = before, Outcome()
        self.deaths = 0
        self.told = time.monotonic()
        self.well = False
        self.start()

    def start(self) -> None:
        self.scratch = tempfile.mkdtemp(dir=self.folder)
        self.pipe, theirs = multiprocessing.Pipe(duplex=False)
        work_on = fuzz_viewer.work if self.name in fuzz_viewer.PARSERS else work
        left = (self.count - self.before.inputs, self.end - time.monotonic(), self.seed + self.deaths)
        context = multiprocessing.get_context("fork")
        self.process = context.Process(target=work_on, args=(self.name, *left, self.scratch, theirs), daemon=True)
        self.process.start()
        theirs.close()
        self.heard = time.monotonic()

    def hear(self) -> bool:
        """Take what the process says; False when all is said."""
        try:
            self.now = self.pipe.recv()
            self.heard, self.well = time.monotonic(), True
            return True
        except EOFError:
            return self.ended(f"the process ended with {self.code()}" if self.code() else None)

    def so_far(self) -> Outcome:
        """What was counted, with what the process counts now."""
        together = Outcome()
        together.merge(self.before)
        together.merge(self.now)
        return together

    def code(self) -> int | None:
        self.process.join()
        return self.process.exitcode

    def ended(self, how: str | None) -> bool:
        """Count what the process did; True when another goes on."""
        self.before.merge(self.now)
        self.now = Outcome()
        if how is not None:
            self.before.add(how, 0.0, 0, 0, self.last)
            self.deaths += 1
        shutil.rmtree(self.scratch, ignore_errors=True)
        again = how is not None and self.well and self.deaths < MOST_DEATHS
        if again and self.before.inputs < self.count and time.monotonic() < self.end:
            self.start()
            return True
        return False

    def silent(self) -> bool:
        # A beginning may take longer on a busy machine.
        return time.monotonic() > self.heard + SILENCE * (1 if self.well else 10)

    def end_silent(self) -> bool:
        self.process.kill()
        self.process.join()
        return self.ended(f"nothing heard for {SILENCE:g} s")

    def last(self) -> str:
        """The files as they lie there: the one that was damaged last is among them."""
        found = [f for f in Path(self.scratch).rglob("*") if f.is_file()]
        newest = max(found, key=lambda f: f.stat().st_mtime_ns, default=None)
        return "" if newest is None else f"{newest.relative_to(self.scratch)}: {newest.read_bytes()[:4000].hex()}"


def run(
    names: list[str],
    count: int,
    seconds: float,
    seed: int,
    processes: int,
    before: dict[str, Outcome] | None = None,
    keep_so_far: Callable[[str, Outcome], None] | None = None,
) -> Iterator[tuple[str, Outcome]]:
    """Every format in a process of its own, some at a time; as they end.  Those that were begun `before` go on."""
    with tempfile.TemporaryDirectory(dir=SHARED_MEMORY) as folder:
        waiting = list(names)
        running: list[Running] = []
        while waiting or running:
            while waiting and len(running) < processes:
                name = waiting.pop(0)
                begun = (before or {}).get(name) or Outcome()
                running.append(Running(name, count, seconds, seed, folder, begun))
            ready = wait([each.pipe for each in running], timeout=1)
            for each in list(running):
                alive = True
                if each.pipe in ready:
                    alive = each.hear()
                    if alive and keep_so_far and time.monotonic() > each.told + EVERY:
                        each.told = time.monotonic()
                        keep_so_far(each.name, each.so_far())
                elif each.silent():
                    alive = each.end_silent()
                if not alive:
                    running.remove(each)
                    yield each.name, each.before


def everything() -> list[str]:
    """All formats; those of the viewer where Node is."""
    names = list(fuzz_specimens.specimens())
    assert {*READERS, *OTHERS, "csv in a spreadsheet"} == set(names)
    return names + (list(fuzz_viewer.PARSERS) if fuzz_viewer.node() else [])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=1_000_000, help="inputs for each format")
    parser.add_argument("--minutes", type=float, default=600, help="at most, for all formats together")
    parser.add_argument("--formats", nargs="*", default=None, help="some of them; all by default")
    parser.add_argument("--processes", type=int, default=2, help="formats at a time")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument(
        "--kept",
        type=Path,
        default=None,
        help="a JSON file of what was done: formats that were begun go on from there",
    )
    parser.add_argument("--output", type=Path, default=None, help="such as docs/fuzzing.md; printed only by default")
    parser.add_argument("--anew", nargs="*", default=[], help="formats to be begun again, whatever is kept of them")
    parser.add_argument("--examples", type=Path, default=None, help="a JSON file for the first input of each failure")
    given = parser.parse_args()
    names = everything()
    asked = names if given.formats is None else given.formats
    if unknown := set(asked) - set(names):
        parser.error(f"no formats: {', '.join(sorted(unknown))}; there are {', '.join(names)}")
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # and tidy up
    start = time.monotonic()
    results = kept(given.kept, given.seed) if given.kept else {}
    for name in given.anew:
        results.pop(name, None)
    left = [name for name in asked if name not in results or results[name].inputs < given.count]
    seconds = 60 * given.minutes * given.processes / max(len(left), 1)

    def kept_so_far(name: str, outcome: Outcome) -> None:
        results[name] = outcome
        if given.kept:
            keep(given.kept, results, given.seed)

    for name, outcome in run(left, given.count, seconds, given.seed, given.processes, dict(results), kept_so_far):
        print(name, dict(outcome.counts), f"{outcome.slowest:.2f} s, {outcome.most / 2**20:.0f} MiB", flush=True)
        kept_so_far(name, outcome)
        if given.examples:
            given.examples.write_text(json.dumps({k: o.examples for k, o in results.items() if o.examples}, indent=1))
    minutes = None if given.kept else (time.monotonic() - start) / 60
    made = page({name: results[name] for name in asked}, given.seed, minutes, SECONDS, GROWTH)
    if given.output:
        given.output.write_text(made, encoding="utf-8")
    else:
        print(made)
    return int(any(o.failures for o in results.values()))


if __name__ == "__main__":
    sys.exit(main())
