"""The same surface on a GPU, where there is one: PyTorch's tensors, its compiler, and Dr.Jit's CUDA backend; the engine on the CPU beside them.

usage: python benchmarks/gpu.py [--effort quick|normal|full] [--json FILE]
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

import machine
import rivals
from evaluate import check
from motes import MotesError
from motes.kernels import engine
from results import Effort, Number, Section, Table, command
from rivals import SURFACE
from timing import interleaved

LABELS = {
    "engine": "Motes' engine, CPU, float32 (3, N)",
    "eager": "`model.eval` on PyTorch tensors, GPU",
    "torch": "PyTorch, traced, `torch.compile`, GPU",
    "motes_dusty": "the surface as Motes' Mitsuba plugin, GPU",
    "roughplastic": "Mitsuba `roughplastic`, GPU",
    "principled": "Mitsuba `principled`, GPU",
}
Candidates = dict[str, tuple[Callable[[], Any], float]]


def candidates(n: int, device: str, variant: str, compile_torch: bool, skipped: list[str]) -> Candidates:
    """Evaluations on a device of PyTorch and by a variant of Mitsuba; what does not work is named in `skipped`."""
    rows = tuple(rivals.directions(n, seed) for seed in (1, 2))
    out = np.empty((3, n), np.float32)
    found: Candidates = {"engine": (lambda: engine.evaluate(SURFACE, rows[0].T, rows[1].T, out=out.T), n)}
    found["engine"][0]()
    try:
        found["eager"] = (eager(rows, device, out), n)
    except MotesError as error:
        skipped.append(rivals.skipped("PyTorch", error))
    try:
        if not compile_torch:
            raise MotesError("not compiled in a quick run")
        call, result = rivals.torch_compiled(*rows, device)
        check("torch.compile", result(), out)
        found["torch"] = (call, n)
    except MotesError as error:
        skipped.append(rivals.skipped("torch.compile", error))
    try:
        mi = rivals.mitsuba(variant)
        si, wo = rivals.wavefront(mi, *rows)
        for name, bsdf in rivals.bsdfs(mi).items():
            drjit_call = rivals.drjit_call(mi, bsdf, si, wo)
            if name == "motes_dusty":
                check(name, np.array(drjit_call()), out * rows[1][2])
            found[name] = (drjit_call, n)
    except MotesError as error:
        skipped.append(rivals.skipped(f"Mitsuba, {variant}", error))
    return found


def eager(rows: tuple[rivals.Rows, rivals.Rows], device: str, expected: rivals.Rows) -> Callable[[], None]:
    """`model.eval` on tensors."""
    try:
        import torch
    except ImportError:
        raise MotesError("PyTorch is not installed", "pip install torch") from None
    wi, wo = (torch.from_numpy(np.ascontiguousarray(w.T)).to(device) for w in rows)

    def call() -> Any:
        with torch.no_grad():
            value = SURFACE.eval(wi, wo)
        if device == "cuda":
            torch.cuda.synchronize()
        return value

    check("model.eval on tensors", call().cpu().numpy().T, expected)
    return call


def gpu(effort: Effort) -> Section:
    """All of it in turn, or the line that says that there is no GPU."""
    name = machine.gpu_name()
    title, made_by = "GPU", "benchmarks/gpu.py, gpu()"
    if name is None:
        reason = (
            "GPU: PyTorch sees no CUDA device here, so `model.eval` on its tensors, `torch.compile`, Dr.Jit's `cuda_ad_rgb` and our own kernels for cards "
            "([engine.md](engine.md#on-a-graphics-card)) were not run."
        )
        return Section(title, made_by, "The same evaluation on a GPU.", {}, skipped=[reason])
    return compared(effort, name, "cuda", rivals.GPU_VARIANT)


def compared(effort: Effort, name: str, device: str, variant: str) -> Section:
    """The section for a device."""
    n, rounds = effort.pick(20_000, 10_000_000), effort.pick(2, 9)
    skipped: list[str] = []
    timings = interleaved(candidates(n, device, variant, effort.name != "quick", skipped), rounds)
    figures = {"directions": Number.of([n / 1e6]), "rounds": Number.of([rounds])}
    for key, timing in timings.items():
        figures |= {f"{key}_rate": timing.rate.times(1e-6), f"{key}_share": timing.faster_than(timings["engine"])}
    fastest = min(timings, key=lambda key: timings[key].seconds.median)
    return Section(
        title="GPU",
        made_by="benchmarks/gpu.py, gpu()",
        intro=f"The same evaluation on {name}, inputs and results in its memory: {{directions:bare}} million directions, {{rounds:count}} rounds in turn.",
        figures=figures,
        tables=[
            Table(
                ["", "M/s, wall", "x the engine on the CPU"],
                [[label, f"{{{key}_rate}}", f"{{{key}_share}}"] for key, label in LABELS.items() if key in timings],
            )
        ],
        reading=[f"The fastest is {LABELS[fastest]}: {{{fastest}_share}} times the engine on this machine's CPU."],
        skipped=skipped,
    )


if __name__ == "__main__":
    command(gpu, __doc__)
