"""What tools/fuzz.py counts, and the page that it writes."""

from __future__ import annotations

import json
import platform
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from motes.files import budget, write_json

GOOD = ("read", "refused")


@dataclass
class Outcome:
    """Of one format: how many inputs ended how; the most that one took, of computing [s] and of memory [bytes]; the first input of each failure."""

    counts: Counter[str] = field(default_factory=Counter)
    slowest: float = 0.0
    most: int = 0
    share: float = 0.0  # the most memory over what an input of its size may take
    largest: int = 0  # bytes of an input
    examples: dict[str, str] = field(default_factory=dict)

    @property
    def inputs(self) -> int:
        return sum(self.counts.values())

    @property
    def failures(self) -> dict[str, int]:
        return {what: n for what, n in sorted(self.counts.items()) if what not in GOOD}

    def add(self, what: str, seconds: float, memory: int, size: int, example: Callable[[], str]) -> None:
        """Count one input."""
        self.counts[what] += 1
        self.slowest, self.most = max(self.slowest, seconds), max(self.most, memory)
        self.share, self.largest = max(self.share, memory / budget.allowed(size)), max(self.largest, size)
        if what not in GOOD and what not in self.examples:
            self.examples[what] = example()

    def merge(self, other: Outcome) -> None:
        self.counts.update(other.counts)
        self.slowest, self.most = max(self.slowest, other.slowest), max(self.most, other.most)
        self.share, self.largest = max(self.share, other.share), max(self.largest, other.largest)
        self.examples = {**other.examples, **self.examples}


def keep(path: Path, results: dict[str, Outcome], seed: int) -> None:
    """Write what came out for each format."""
    path.parent.mkdir(parents=True, exist_ok=True)
    write_json(path, {"seed": seed, "formats": {name: vars(o) for name, o in results.items()}})


def kept(path: Path, seed: int) -> dict[str, Outcome]:
    """The formats that a file holds of this seed."""
    if not path.exists() or (content := json.loads(path.read_text()))["seed"] != seed:
        return {}
    return {name: Outcome(**{**o, "counts": Counter(o["counts"])}) for name, o in content["formats"].items()}


def page(results: dict[str, Outcome], seed: int, minutes: float | None, seconds: float, growth: int) -> str:
    """docs/fuzzing.md; `minutes` is None where formats were done one after another, between other work."""
    total = sum(o.inputs for o in results.values())
    failed = sum(sum(o.failures.values()) for o in results.values())
    took = "" if minutes is None else f" in {minutes:.0f} minutes"
    lines = [
        "# Damaged files",
        "",
        "Everything that Motes reads is given damaged files: bytes of small valid specimens flipped, cut, doubled, inserted, or replaced by huge counts,",
        "NaN, brackets and entities; and by structure, frames kept whole: words of texts, members of JSON, chunks of PNG and GLB, fields of binary headers,",
        "members of archives. An input must be read or refused with a sentence and a next step, within",
        f"{seconds:g} seconds of computing and {growth // 2**20} MiB of memory more than the process had. Anything else is a failure.",
        "",
        "`make fuzz MINUTES=5` makes this page in five minutes (`tools/fuzz.py --help` says more); the test suite runs some seconds of the same.",
        "",
        f"**{total:,} inputs, {failed:,} failures**{took} on {time.strftime('%Y-%m-%d')}, seed {seed}; Python {platform.python_version()}, "
        f"NumPy {np.__version__}.",
        "",
        "| format | inputs | read | refused | failed | slowest [s] | most memory [MiB] | of what it may take [%] | largest input [KiB] |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for name, o in results.items():
        numbers = (o.inputs, o.counts["read"], o.counts["refused"], sum(o.failures.values()))
        counts = " | ".join(f"{n:,}" for n in numbers)
        memory = f"{o.most / 2**20:.1f} | {100 * o.share:.1f}"
        lines.append(f"| `{name}` | {counts} | {o.slowest:.2f} | {memory} | {o.largest / 1024:.1f} |")
    lines += [
        "",
        "What stands for what: `picture` is OpenEXR, PNG, TIFF and JPEG; `mesh` is PLY, OBJ, STL (binary and text) and glTF; `model` is the text",
        "after `--model`; `folder of a fit` is what `motes fit` writes, as `motes view` reads it; the maps are Zarr stores; `dust` is the options of",
        "`motes dust` with a mesh and a mask. The viewer's own parsers, of links, tables, materials, meshes and models, run under Node. TIFF and OpenEXR",
        "hold no checksums, so that flipped pixels are read.",
        "",
        "The slowest input is counted in time of computing. Memory is what the process held at most while it read one input, beyond what it held before;",
        f"it may take {budget.FACTOR} times its size or {budget.LEAST // 2**20} MiB, whichever is more. Of the viewer's parsers it is what Node has grown by",
        "since it began, garbage and all.",
        "",
    ]
    if failed:
        lines += ["What failed:", ""]
        lines += [f"- `{name}`: {what} ({n:,})" for name, o in results.items() for what, n in o.failures.items()]
    else:
        lines += ["Nothing failed."]
    return "\n".join(lines) + "\n"
