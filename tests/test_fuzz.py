"""The tool that damages files: every reader stands a moment of it, and it sees what it is there to see."""

from __future__ import annotations

import base64
import importlib
import json
import mmap
import struct
import subprocess
import sys
import time
import zlib
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from viewer_support import node

pytest.importorskip("zarr")
pytest.importorskip("OpenImageIO")
pytest.importorskip("trimesh")
pytest.importorskip("openpyxl")
pytest.importorskip("mitsuba")
if not sys.platform.startswith("linux"):
    pytest.skip("limits of memory as Linux has them", allow_module_level=True)

TOOLS = Path(__file__).parents[1] / "tools"
COUNT = 50  # inputs for each format


@pytest.fixture(scope="module")
def fuzz() -> Iterator[ModuleType]:
    sys.path.insert(0, str(TOOLS))
    try:
        yield importlib.import_module("fuzz")
    finally:
        sys.path.remove(str(TOOLS))


def test_everything_stands_a_moment_of_it(fuzz: ModuleType, tmp_path: Path) -> None:
    """The tool itself, in a process that has no threads yet: those of a library do not outlive a fork."""
    names = fuzz.everything()
    assert {*fuzz.READERS, *fuzz.OTHERS, "csv in a spreadsheet"} == set(names) - set(fuzz.fuzz_viewer.PARSERS)
    page, examples = tmp_path / "page.md", tmp_path / "examples.json"
    options = [
        "--count",
        str(COUNT),
        "--minutes",
        "60",
        "--seed",
        "20",
        "--output",
        str(page),
        "--examples",
        str(examples),
    ]
    run = subprocess.run(
        [sys.executable, str(TOOLS / "fuzz.py"), *options],
        capture_output=True,
        text=True,
        errors="replace",
        timeout=400,
    )
    assert run.returncode == 0, (
        run.stdout[-3000:],
        examples.read_text()[:3000] if examples.exists() else run.stderr[-3000:],
    )
    text = page.read_text(encoding="utf-8")
    assert "Nothing failed." in text
    assert f"**{COUNT * len(names):,} inputs, 0 failures**" in text
    rows = [[cell.strip(" `") for cell in line.split("|")[1:6]] for line in text.splitlines() if line.startswith("| `")]
    assert [row[0] for row in rows] == names
    assert all(row[1] == str(COUNT) and row[4] == "0" for row in rows)
    assert sum(int(row[2]) for row in rows) > 4 * COUNT  # read
    assert sum(int(row[3]) for row in rows) > 4 * COUNT  # refused


def test_the_viewers_parsers_are_among_it(fuzz: ModuleType) -> None:
    node()
    assert len(fuzz.fuzz_viewer.PARSERS) == 5
    assert set(fuzz.fuzz_viewer.PARSERS) <= set(fuzz.everything())


def hungry() -> None:
    np.ones(2**27)


def hard_at_work() -> None:
    while True:
        pass


def asleep() -> None:
    time.sleep(60)


@pytest.mark.parametrize(
    ("bad", "seen"),
    [
        (lambda: [][1], "IndexError: list index out of range"),
        (lambda: sys.exit(3), "the process ended with 3"),
        (hungry, "memory"),
        (hard_at_work, "longer than 0.1 s"),
        (asleep, "nothing heard for 3 s"),
    ],
)
def test_what_fails_is_seen(
    fuzz: ModuleType, monkeypatch: pytest.MonkeyPatch, bad: Callable[[], object], seen: str
) -> None:
    """A reader that is broken on purpose, for what differs much from the specimen: it goes on with the next input."""
    whole = bytes(1000)

    def reader(path: Path, name: str, turn: int) -> str:
        if abs(len(path.read_bytes()) - len(whole)) > 100:
            bad()
        return "read"

    monkeypatch.setitem(fuzz.OTHERS, "mesh", reader)
    monkeypatch.setattr(fuzz.fuzz_specimens, "specimens", lambda: {"mesh": lambda: [({"a": whole}, "a")]})
    monkeypatch.setattr(fuzz, "SECONDS", 0.1)
    monkeypatch.setattr(fuzz, "SILENCE", 3)
    count = 3 if bad is asleep else 12
    ((_, outcome),) = fuzz.run(["mesh"], count, 30, 3, 1)
    assert seen in outcome.failures
    assert outcome.inputs >= count
    name, _, content = outcome.examples[seen].partition(": ")
    assert name.endswith("a")
    assert abs(len(bytes.fromhex(content)) - len(whole)) > 100


PARSER = """
import { createInterface } from 'node:readline';
const held = [];
let count = 0;
for await (const line of createInterface({ input: process.stdin })) {
  const message = JSON.parse(line);
  if (!Array.isArray(message)) console.log('"ready"');
  else for (const _ of message) {
    let told = 'read';
    count += 1;
    if (count > 4) BAD;
    console.log(JSON.stringify([told, 1]));
  }
}
"""


@pytest.mark.parametrize(
    ("bad", "seen"),
    [
        ("told = 'TypeError: x is not a function'", "TypeError: x is not a function"),
        ("process.exit(4)", "Node ended"),
        ("for (;;) held[0] = 1", "nothing heard for 1.2 s"),
        ("held.push(Buffer.alloc(3e8, 1))", "memory"),
    ],
)
def test_what_fails_in_the_viewer_is_seen(
    fuzz: ModuleType, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, bad: str, seen: str
) -> None:
    """A parser that is broken on purpose, from the fifth input of a process on."""
    path = node()
    (tmp_path / "fuzz.mjs").write_text(PARSER.replace("BAD", bad))
    monkeypatch.setattr(fuzz.fuzz_viewer, "VIEWER", tmp_path)
    monkeypatch.setattr(fuzz.fuzz_viewer, "node", lambda: path)
    monkeypatch.setattr(fuzz.fuzz_viewer, "SECONDS", 0.2)
    monkeypatch.setattr(fuzz.fuzz_viewer, "BATCH", 2)
    ((_, outcome),) = fuzz.run(["viewer: link"], 4, 30, 1, 1)
    assert outcome.failures[seen] >= 1
    assert outcome.counts["read"] >= 1
    assert outcome.examples[seen]


def test_memory_is_counted(fuzz: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    """What an input takes, and not what was taken before."""

    def reader(path: Path, name: str, turn: int) -> str:
        if path.stat().st_size > 1000:
            # 32 MiB of the system's: the allocator may have as much left over from the tests before.
            np.frombuffer(mmap.mmap(-1, 2**25), np.uint8)[:] = 1
        return "read"

    monkeypatch.setitem(fuzz.OTHERS, "mesh", reader)
    for size, least, most in ((10, 0, 2), (2000, 31, 36)):
        monkeypatch.setattr(
            fuzz.fuzz_specimens, "specimens", lambda size=size: {"mesh": lambda: [({"a": bytes(size)}, "a")]}
        )
        ((_, outcome),) = fuzz.run(["mesh"], 3, 30, 1, 1)
        assert least <= outcome.most / 2**20 <= most


def test_damage_keeps_frames(fuzz: ModuleType) -> None:
    """Half of the damaged PNG have checksums that are right, half of the JSON is JSON."""
    rng = np.random.default_rng(1)
    body = b"IHDR" + bytes(13)
    png = b"\x89PNG\r\n\x1a\n" + struct.pack(">I", 13) + body + struct.pack(">I", zlib.crc32(body))
    made = [fuzz.fuzz_damage.damaged(png, rng) for _ in range(200)]
    whole = [m for m in made if len(m) == len(png) and m[8:12] == png[8:12] and m[12:29] != body]
    right = [m for m in whole if struct.pack(">I", zlib.crc32(m[12:29])) == m[29:]]
    assert 0 < len(right) < len(whole)

    def is_json(data: bytes) -> bool:
        try:
            json.loads(data)
        except ValueError:
            return False
        return True

    text = json.dumps({"a": [1, {"b": 2}], "c": "d"}).encode()
    made = [fuzz.fuzz_damage.damaged(text, rng) for _ in range(200)]
    assert 90 < sum(is_json(m) and m != text for m in made) < 200


def test_links_and_scenes_are_damaged_inside(fuzz: ModuleType) -> None:
    """Half of the damaged links hold JSON, and of the damaged glTF two chunks whose lengths are right."""
    rng = np.random.default_rng(2)
    link = fuzz.fuzz_specimens.links()[0][0]["a"]
    states = []
    for _ in range(200):
        made = fuzz.fuzz_damage.damaged(link, rng)
        with suppress(ValueError):
            states.append(json.loads(base64.urlsafe_b64decode(made.removeprefix(b"#motes=") + b"==")))
    assert len(states) > 90
    glb = next(files[name] for files, name in fuzz.fuzz_specimens.solids() if name.endswith(".glb"))
    right = 0
    for _ in range(200):
        made = fuzz.fuzz_damage.damaged(glb, rng)
        lengths = [struct.unpack_from("<I", made, at)[0] for at in (8, 12) if at + 4 <= len(made)]
        right += (
            made != glb and len(lengths) == 2 and lengths[0] == len(made) and made[20 + lengths[1] :][4:8] == b"BIN\0"
        )
    assert right > 80


def test_a_format_goes_on_where_it_was_left(
    fuzz: ModuleType, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A sitting adds to what the one before did, with other inputs; `--anew` begins again."""
    seen = tmp_path / "seen"

    def reader(path: Path, name: str, turn: int) -> str:
        with seen.open("ab") as file:
            file.write(path.read_bytes().hex().encode() + b"\n")
        return "read"

    monkeypatch.setitem(fuzz.OTHERS, "mesh", reader)
    specimen = np.random.default_rng(4).bytes(500)
    monkeypatch.setattr(fuzz.fuzz_specimens, "specimens", lambda: {"mesh": lambda: [({"a": specimen}, "a")]})
    monkeypatch.setattr(fuzz, "everything", lambda: ["mesh"])
    kept = tmp_path / "kept.json"

    def sitting(count: int, *more: str) -> int:
        options = ["--count", str(count), "--kept", str(kept), "--seed", "5", "--formats", "mesh", *more]
        monkeypatch.setattr(sys, "argv", ["fuzz.py", *options])
        assert fuzz.main() == 0
        return sum(json.loads(kept.read_text())["formats"]["mesh"]["counts"].values())

    assert sitting(8) == 8
    assert sitting(20) == 20
    read = seen.read_text().splitlines()
    assert len(read) == 22  # the specimen itself, once a sitting
    assert len(set(read)) == 21
    assert sitting(6) == 20  # nothing is left to do
    assert sitting(6, "--anew", "mesh") == 6
    assert "**6 inputs, 0 failures**" in capsys.readouterr().out
