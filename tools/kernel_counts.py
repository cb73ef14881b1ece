"""What the engine's kernels for dust take of a processor, by counting their instructions: a bound on what they can cost, beside `benchmarks/dust.py`.

usage: python tools/kernel_counts.py

For one vector of directions in float32 it counts multiplications (with or without an addition), which two of four pipes can do, divisions and roots,
what is written to memory, and all instructions of the loop; quotients are over single scattering for values, over the value for gradients.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import NamedTuple

sys.path.insert(0, str(Path(__file__).parent.parent / "benchmarks"))

import dust
from motes.graph.recording import Kind, recorded
from motes.kernels import gradients, loops, machine_code
from motes.kernels.lowering import lowered

_PRODUCT, _DIVISION = re.compile(r"^v(fn?m\w+|mulp)"), re.compile(r"^v(div|sqrt)p")
_STORED = re.compile(r"^vmov[au]p\w\s+%[zyx]mm\d+, [^%]*\(")


class Counts(NamedTuple):
    """Instructions for one vector of directions."""

    products: float
    divisions: float
    stores: float
    all: float


def counts(source: str) -> Counts:
    """Of the longest stretch without a jump in a module: the program of vectors, for one vector or two at a time."""
    lines = lowered(source).text
    program = lines[lines.index("@stretch(") :]
    step = re.search(r"add nsw i64 %\w+, (\d+)", program)
    assert step is not None
    vectors = int(step[1]) // (machine_code.vector_bytes() // 4)
    blocks = re.split(r"(?m)^(?=\.L\w+:)", machine_code.assembly(lines))
    loop = [line.strip() for line in max(blocks, key=lambda block: block.count("\n")).splitlines()]
    loop = [line for line in loop if line and line[0] not in ".#" and not line.endswith(":")]
    kinds = (_PRODUCT, _DIVISION, _STORED, re.compile(""))
    return Counts(*(sum(bool(kind.search(line)) for line in loop) / vectors for kind in kinds))


def main() -> None:
    """Print the table."""
    print(
        "| base | w | what | products | divisions | stores | all | by products | by all |\n|---|---|---|---|---|---|---|---|---|"
    )
    for base, (_, below) in dust.BASES.items():
        for albedo, (_, w) in dust.ALBEDOS.items():
            found: dict[str, Counts] = {}
            for scattering in ("single", "multiple"):
                trace = recorded(Kind.VALUE, dust.layer(below, w, scattering), 3)
                assert trace is not None
                found[scattering] = counts(loops.evaluation(trace, (), "float32").source)
                found[f"{scattering}, gradient"] = counts(gradients.gradient(trace, (), "float32").source)
            for name, own in found.items():
                less = found[name.partition(",")[0]] if "gradient" in name else found["single"]
                quotients = f"{own.products / less.products:.2f} | {own.all / less.all:.2f}"
                print(f"| {base} | {albedo} | {name} | {' | '.join(f'{n:.0f}' for n in own)} | {quotients} |")


if __name__ == "__main__":
    main()
