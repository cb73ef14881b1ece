"""The viewer's parsers under Node (viewer/fuzz.mjs), given damaged files by tools/fuzz.py."""

from __future__ import annotations

import base64
import json
import os
import select
import shutil
import subprocess
import time
from collections.abc import Callable
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import fuzz_damage
import fuzz_specimens
import numpy as np
from fuzz_page import Outcome

from motes.files import budget
from motes.viewer.shader_library import library
from motes.viewer.shipped_shapes import shapes

VIEWER = Path(__file__).resolve().parent.parent / "viewer"
SECONDS = 10.0
GROWTH = 256 * 2**20
FLAGS = ("--max-old-space-size=128", "--max-semi-space-size=4")
BATCH = 100

#: Name on the page -> name in viewer/fuzz.mjs, and the specimens.
PARSERS: dict[str, tuple[str, Callable[[], fuzz_specimens.Specimens]]] = {
    "viewer: link": ("link", fuzz_specimens.links),
    "viewer: material": ("material", lambda: fuzz_specimens.materials()[:2]),  # a page takes one or three channels
    "viewer: table": ("table", lambda: fuzz_specimens.specimens()["csv"]()),
    "viewer: mesh": ("mesh", lambda: [s for s in fuzz_specimens.solids() if s[1].endswith((".obj", ".ply", ".glb"))]),
    "viewer: model": ("model", fuzz_specimens.models),
}


def node() -> str | None:
    """Node, where it and the viewer's packages are installed."""
    return shutil.which("node") if (VIEWER / "node_modules" / "three").is_dir() else None


class Parser:
    """A process of Node that reads what it is sent."""

    def __init__(self) -> None:
        found = node()
        assert found is not None
        self.process = subprocess.Popen(
            [found, *FLAGS, "fuzz.mjs"], cwd=VIEWER, stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0
        )
        self.rest = b""
        own = json.loads(fuzz_specimens.materials()[0][0]["a"])
        self.send({"library": library(), "own": own, "dust": shapes()["dust_by_inclination"]})
        self.answer(600.0)  # it is ready

    def send(self, message: Any) -> None:
        assert self.process.stdin is not None
        data = memoryview(json.dumps(message).encode() + b"\n")
        while data:
            data = data[self.process.stdin.write(data) :]

    def answer(self, patience: float) -> Any:
        """The next line that it says; raises TimeoutError, and EOFError at its end."""
        assert self.process.stdout is not None
        end = time.monotonic() + patience
        while b"\n" not in self.rest:
            if not select.select([self.process.stdout], [], [], max(end - time.monotonic(), 0))[0]:
                raise TimeoutError
            if not (piece := os.read(self.process.stdout.fileno(), 2**16)):
                raise EOFError
            self.rest += piece
        line, _, self.rest = self.rest.partition(b"\n")
        return json.loads(line)

    def memory(self, field: str) -> int:
        for line in Path(f"/proc/{self.process.pid}/status").read_text().splitlines():
            if line.startswith(field):
                return 1024 * int(line.split()[1])
        return 0

    def end(self) -> None:
        self.process.kill()
        self.process.communicate()


def work(name: str, count: int, seconds: float, seed: int, scratch: str, pipe: Connection) -> None:
    """As `fuzz.work`; Node is started again when it does not answer."""
    kind, make = PARSERS[name]
    rng, outcome, specimens = np.random.default_rng(seed), Outcome(), make()
    parser = Parser()
    whole = [(target, specimen[target]) for specimen, target in specimens]
    parser.send([[kind, target, base64.b64encode(data).decode()] for target, data in whole])
    for target, _ in whole:
        if (told := parser.answer(60.0)[0]) != "read":
            raise AssertionError(f"{name}: the specimen {target} was not read: {told}")
    pipe.send(outcome)
    end, first = time.monotonic() + seconds, parser.memory("VmHWM")
    while outcome.inputs < count and time.monotonic() < end:
        batch = []
        for turn in range(outcome.inputs, min(outcome.inputs + BATCH, count)):
            target, data = whole[turn % len(whole)]
            batch.append((target, fuzz_damage.damaged(data, rng)))
        parser.send([[kind, target, base64.b64encode(data).decode()] for target, data in batch])
        for target, data in batch:
            example = lambda target=target, data=data: f"{target}: {data[:4000].hex()}"  # noqa: E731
            try:
                told, milliseconds = parser.answer(6 * SECONDS)
            except (TimeoutError, EOFError) as error:
                slow = isinstance(error, TimeoutError)
                outcome.add(f"nothing heard for {6 * SECONDS:g} s" if slow else "Node ended", 0, 0, len(data), example)
                parser.end()
                parser = Parser()
                break
            if milliseconds > 1e3 * SECONDS:
                told = f"longer than {SECONDS:g} s"
            outcome.add(told, milliseconds / 1e3, 0, len(data), example)
        else:
            grown = parser.memory("VmHWM") - first
            outcome.most = max(outcome.most, grown)
            outcome.share = max(outcome.share, grown / budget.LEAST)
            if grown > GROWTH:
                outcome.add("memory", 0, grown, 0, lambda: "one of a batch")
                parser.end()
                parser = Parser()
        pipe.send(outcome)
    parser.end()
    pipe.send(outcome)
