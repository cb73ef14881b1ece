"""Evaluation of the whole dusty RGB surface and its gradient, against the memory's roof, NumPy, PyTorch and Mitsuba.

usage: python benchmarks/evaluate.py [--effort quick|normal|full] [--json FILE]
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np

import machine
import rivals
import roof
from motes import MotesError
from motes.kernels import engine
from results import Effort, Goal, Number, Section, Table, command
from rivals import PARAMETERS, SURFACE, Rows, directions
from timing import Timing, interleaved

# Bytes that the largest candidate needs for one direction: NumPy's intermediate results, and all arrays of the others.
BYTES_EACH = 700
TOLERANCE = 2e-4  # of the largest value: float32 with other functions
MAIN = "rows32"
LABELS = {
    "stream": "memory: the same bytes by stores past the caches",
    "copies": "memory: `numpy.copyto` of as many bytes, all cores",
    MAIN: "**Motes float32, (3, N)**",
    "rows32_new": "Motes float32, (3, N), new array out, after other work",
    "rows32_loop": "Motes float32, (3, N), new array out, in a loop",
    "pieces32": "Motes float32, (N, 3)",
    "rows64": "Motes float64, (3, N)",
    "pieces64": "Motes float64, (N, 3)",
    "expanded": "`model.eval`, float64, as many pairs in arrays (N, N, 3)",
    "outer": "`model.eval`, float64, (N, 1, 3) with (1, N, 3)",
    "gradient": f"Motes float32, gradient by {PARAMETERS} parameters",
    "numpy": "NumPy float32, the equations as they stand",
    "blocks": "NumPy float32, traced, in blocks, one core",
    "blocks_all": "NumPy float32, traced, in blocks, all cores",
    "torch": "PyTorch float32, traced, `torch.compile`",
    "roughplastic": "Mitsuba `roughplastic` (LLVM)",
    "principled": "Mitsuba `principled` (LLVM)",
    "motes_dusty": "the surface as Motes' Mitsuba plugin (LLVM)",
}
Candidates = dict[str, tuple[Callable[[], Any], float]]


@dataclass
class Arrays:
    """Directions and room for results in every layout and precision; rows are aligned for `roof.stream`."""

    rows: tuple[Rows, Rows]
    pieces: tuple[Rows, Rows]
    doubles: tuple[Rows, Rows]
    out_rows: Rows
    out_pieces: Rows
    out_doubles: Rows

    @classmethod
    def of(cls, n: int) -> Arrays:
        """For n directions."""
        rows = (roof.aligned(3, n), roof.aligned(3, n))
        for k, w in enumerate(rows):
            w[...] = directions(n, k + 1)
        return cls(
            rows,
            tuple(np.ascontiguousarray(w.T) for w in rows),  # type: ignore[arg-type]
            tuple(w.astype(np.float64) for w in rows),  # type: ignore[arg-type]
            roof.aligned(3, n),
            np.zeros((n, 3), np.float32),
            np.zeros((3, n)),
        )


def own_candidates(arrays: Arrays, pool: ThreadPoolExecutor) -> Candidates:
    """What needs nothing but Motes and NumPy."""
    n = arrays.out_rows.shape[1]
    (a, b), out = arrays.rows, arrays.out_rows
    double_pieces = [np.ascontiguousarray(w.T) for w in arrays.doubles]
    out_double_pieces = np.zeros((n, 3))
    seed = np.ones((3, n), np.float32)
    source = np.ones(n * roof.BYTES // 8, np.float32)  # as many bytes read as written
    target = np.zeros_like(source)
    side = int(np.sqrt(n))
    lights, views = (np.ascontiguousarray(w[:side]) for w in double_pieces)
    across, along = lights[:, None], views[None]
    pairs = [np.ascontiguousarray(np.broadcast_to(w, (side, side, 3))) for w in (across, along)]
    edges = np.linspace(0, len(source), rivals.cores() + 1).astype(int).tolist()

    def copies() -> None:
        parts = [slice(p, q) for p, q in itertools.pairwise(edges)]
        for future in [pool.submit(np.copyto, target[part], source[part]) for part in parts]:
            future.result()

    def blocks(call: Callable[..., None], *more: Any) -> Callable[[], None]:
        return lambda: call(a, b, out, rivals.BLOCKS[1], *more)

    calls: dict[str, Callable[[], Any]] = {
        "stream": lambda: roof.stream(a, b, out),
        "copies": copies,
        MAIN: lambda: engine.evaluate(SURFACE, a.T, b.T, out=out.T),
        "rows32_new": lambda: engine.evaluate(SURFACE, a.T, b.T),
        "rows32_loop": lambda: engine.evaluate(SURFACE, a.T, b.T),
        "pieces32": lambda: engine.evaluate(SURFACE, *arrays.pieces, out=arrays.out_pieces),
        "rows64": lambda: engine.evaluate(SURFACE, *(w.T for w in arrays.doubles), out=arrays.out_doubles.T),
        "pieces64": lambda: engine.evaluate(SURFACE, *double_pieces, out=out_double_pieces),
        "expanded": lambda: SURFACE.eval(*pairs),
        "outer": lambda: SURFACE.eval(across, along),
        "gradient": lambda: engine.vjp(SURFACE, a.T, b.T, seed.T),
        "numpy": lambda: rivals.plain_numpy(*arrays.pieces),
        "blocks": blocks(rivals.numpy_blocks),
        "blocks_all": blocks(rivals.numpy_blocks_on_all_cores, pool),
    }
    return {name: (call, side * side if name in ("expanded", "outer") else n) for name, call in calls.items()}


def check(name: str, found: Rows, expected: Rows) -> None:
    """Stop where a candidate computes something else: its time would mean nothing."""
    worst = float(np.abs(found - expected).max() / np.abs(expected).max())
    if not worst < TOLERANCE:
        raise ArithmeticError(f"{name} is off by {worst:.2g} of the largest value")


def foreign_candidates(arrays: Arrays, expected: Rows, compile_torch: bool, skipped: list[str]) -> Candidates:
    """PyTorch and Mitsuba, where they work; what does not is named in `skipped`."""
    n = arrays.out_rows.shape[1]
    found: Candidates = {}
    try:
        if not compile_torch:
            raise MotesError("not compiled in a quick run")
        call, result = rivals.torch_compiled(*arrays.rows)
        check("PyTorch", result(), expected)
        found["torch"] = (call, n)
    except MotesError as error:
        skipped.append(rivals.skipped("PyTorch", error))
    try:
        mi = rivals.mitsuba()
        si, wo = rivals.wavefront(mi, *arrays.rows)
        for name, bsdf in rivals.bsdfs(mi).items():
            drjit_call = rivals.drjit_call(mi, bsdf, si, wo)
            if name == "motes_dusty":
                check(name, np.array(drjit_call()), expected * arrays.rows[1][2])
            found[name] = (drjit_call, n)
    except MotesError as error:
        skipped.append(rivals.skipped("Mitsuba", error))
    return found


def evaluation(effort: Effort) -> Section:
    """All candidates in turn, in one process."""
    n = effort.pick(20_000, 10_000_000)
    while n * BYTES_EACH > machine.memory_available() and n > 1_000_000:
        n //= 2
    n -= n % roof.LANES
    arrays = Arrays.of(n)
    skipped: list[str] = []
    with ThreadPoolExecutor(rivals.cores()) as pool:
        candidates = own_candidates(arrays, pool)
        expected = engine.evaluate(SURFACE, *(w.T for w in arrays.rows)).T.copy()
        for name in ("numpy", "blocks", "blocks_all"):
            value = candidates[name][0]()
            check(name, arrays.out_rows if value is None else value.T, expected)
        candidates |= foreign_candidates(arrays, expected, effort.name != "quick", skipped)
        timings = interleaved(candidates, effort.pick(3, 7), in_a_loop={"rows32_loop"})
    return report(n, timings, skipped, effort.pick(3, 7))


def report(n: int, timings: dict[str, Timing], skipped: list[str], rounds: int) -> Section:
    """The figures, and what they say."""
    main = timings[MAIN]
    top = min(("stream", "copies"), key=lambda name: timings[name].seconds.median)
    figures = {"directions": Number.of([n / 1e6]), "rounds": Number.of([rounds])}
    for name, timing in timings.items():
        figures[f"{name}_rate"] = timing.rate.times(1e-6)
        figures[f"{name}_share"] = timing.faster_than(main)
        figures[f"{name}_cpu"] = timing.processor.times(1e9)
        figures[f"{name}_busy"] = timing.busy
    figures["of_roof"] = main.faster_than(timings[top])
    figures["of_roof_cpu"] = main.cheaper_than(timings[top])
    figures["roof_bandwidth"] = timings[top].rate.times(roof.BYTES * 1e-9)
    figures["over_numpy"] = main.faster_than(timings["numpy"])
    figures["over_numpy_cpu"] = main.cheaper_than(timings["numpy"])
    figures["over_blocks"] = main.faster_than(timings["blocks_all"])
    figures["gradient_cost"] = timings[MAIN].faster_than(timings["gradient"])
    figures["outer_cost"] = timings["expanded"].faster_than(timings["outer"])
    figures["gradient_cost_cpu"] = timings[MAIN].cheaper_than(timings["gradient"])
    for name in ("torch", "roughplastic", "principled", "motes_dusty"):
        if name in timings:
            figures[f"over_{name}"] = main.faster_than(timings[name])
            figures[f"over_{name}_cpu"] = main.cheaper_than(timings[name])
    what = "float32 (3, N)"
    goals = [
        Goal(f"{what} over `roughplastic`", "over_roughplastic", 1.0, unit=" x"),
        Goal(f"{what} over `principled`", "over_principled", 1.0, unit=" x"),
        Goal(f"{what} over the memory's roof at {roof.BYTES} bytes an evaluation", "of_roof", 0.45, unit=" x"),
        Goal(f"{what} over NumPy as it stands", "over_numpy", 50, unit=" x"),
        Goal(f"float32 (N, 3) over {what}", "pieces32_share", 0.5, unit=" x"),
        Goal("a new array out, in a loop, over memory used before", "rows32_loop_share", 0.9, unit=" x"),
        Goal("float64 (3, N)", "rows64_rate", 160 if "AVX-512" in machine.vectors() else 120, unit=" M/s"),
        Goal("an outer product, in evaluations of its pairs expanded", "outer_cost", 1.3, at_least=False, unit=" x"),
        Goal(f"gradient by {PARAMETERS} parameters, in evaluations", "gradient_cost", 2, at_least=False, unit=" x"),
    ]
    rows = [
        [label, f"{{{name}_rate}}", f"{{{name}_share}}", f"{{{name}_cpu}}", f"{{{name}_busy:bare}}"]
        for name, label in LABELS.items()
        if name in timings
    ]
    return Section(
        title="Evaluation",
        made_by="benchmarks/evaluate.py, evaluation()",
        intro=(
            "The dusty RGB surface, equations 1 to 13 with "
            f"{PARAMETERS} parameters, at {{directions:bare}} million pairs of directions, arrays in and out; medians of {{rounds:count}} rounds. "
            "Candidates write into memory that they have used before, but where it says otherwise. Mitsuba's BSDFs multiply by the cosine too, and find their "
            "directions in Dr.Jit's own arrays. Every candidate but Mitsuba's two own BSDFs, which are other models, was checked to compute the same values."
        ),
        figures=figures,
        tables=[Table(["", "M/s, wall", "x Motes float32 (3, N)", "ns of processor", "processors busy"], rows)],
        goals=[goal for goal in goals if goal.figure in figures],
        reading=reading(timings, figures, top),
        skipped=skipped,
    )


def reading(timings: dict[str, Timing], figures: dict[str, Number], top: str) -> list[str]:
    """What the figures say."""
    lines = [
        f"The memory's roof is {'stores past the caches' if top == 'stream' else 'plain copying, faster here than stores past the caches'}: "
        "{roof_bandwidth} GB/s. Motes reaches {of_roof} times that rate in float32 ({of_roof_cpu} by processor time), so "
        + (
            "arithmetic bounds it, not memory."
            if figures["of_roof"].median < 0.7
            else "it is about as fast as memory allows."
        )
    ]
    if "roughplastic" in timings:
        lines.append(
            "The engine evaluates the surface with dust {over_roughplastic} times as fast as Mitsuba its `roughplastic` ({over_roughplastic_cpu} by "
            "processor time), and {over_principled} times as fast as its `principled`; Motes' plugin, through Dr.Jit, is {motes_dusty_share} times as fast "
            "as the engine."
        )
    lines.append(
        "Over NumPy the engine gains {over_numpy} by wall time with all cores, {over_numpy_cpu} by processor time alone; over traced NumPy in blocks on "
        "all cores, the best that NumPy does, {over_blocks}."
    )
    if "torch" in timings:
        lines.append("Over PyTorch's compiler, handed the same traced formula, it is {over_torch} by wall time.")
    lines.append(
        "An outer product, whose rows are computed where they lie, costs {outer_cost} of its pairs written out."
    )
    lines.append(
        "A gradient by all parameters costs {gradient_cost} evaluations ({gradient_cost_cpu} by processor time)."
    )
    return lines


if __name__ == "__main__":
    command(evaluation, __doc__)
