"""Fits of very many texels at once, against SciPy and `motes.fit` one at a time, in the same run.

usage: python benchmarks/texels.py [--effort quick|normal|full] [--json FILE]

The case: 6 parameters (K_d in three channels, sigma_d, K_s, sigma_s) under held dust, 100 directions x 3 channels, every texel starting within 30 % of
its truth, without noise and with 2 %; and with trends, 12 times of each texel together.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

import machine
import motes
from motes.fitting.texels import Raw, TexelFit, TexelSolver
from motes.kernels.numpy import residual_function
from results import Effort, Goal, Number, Section, Table, command
from rivals import SURFACE, cores
from texel_cases import CHANNELS, DIRECTIONS, FITTED, HELD, WI, WO, Case, Floats, Series
from timing import interleaved

GOAL, STRETCH, TRENDS = 2_000_000, 4_000_000, 243_000
LABELS = {
    "clean": "`TexelSolver`, without noise",
    "noisy": "`TexelSolver`, 2 % noise",
    "direct": "`TexelSolver`, 2 % noise, every residual summed (the form `direct`)",
    "joint": "`TexelSolver`, 2 % noise, 12 times together under trends",
    "scipy": "SciPy `least_squares`, our values and Jacobian",
    "scipy_plain": "SciPy `least_squares`, our values, its own differences",
    "fit": "`motes.fit`, one at a time (searches for starts)",
}


def solver() -> TexelSolver:
    """The batched solver of the case."""
    return TexelSolver(SURFACE, WI, WO, CHANNELS, fixed=HELD)


def directly(fitter: TexelSolver, values: NDArray[Any], starts: Floats) -> TexelFit:
    """Fit by the kernel that sums residuals themselves, which `fit` takes for texels that a clamp of the model touches."""
    raw: Raw = fitter.kernel("direct").fit(values, fitter.coordinates(np.clip(starts, *fitter.bounds)))
    return fitter.finished(raw)


def scipy_fits(case: Case, values: NDArray[Any], jacobian: bool) -> Floats:
    """SciPy on one texel after the other: residuals weighted as ours, what depends on directions computed once."""
    function = residual_function(SURFACE, FITTED, horizon=False)
    geometry = function.geometry(WI, WO)
    held = {slot.name: np.asarray(slot.value, float) for slot in SURFACE.slots() if slot.name not in FITTED}
    cosine = WI[:, 2:3]
    low, high = solver().bounds

    def named(x: Floats) -> dict[str, Any]:
        return held | {"K_d": x[:3], "sigma_d": x[3], "K_s": x[4], "sigma_s": x[5]}

    def slopes(x: Floats) -> Floats:
        _, by = function.values_and_jacobian(geometry, named(x))
        full = np.zeros((DIRECTIONS, CHANNELS, len(x)))
        for c in range(CHANNELS):
            full[:, c, c] = np.broadcast_to(by["K_d"], (DIRECTIONS, CHANNELS))[:, c]
        for k, name in enumerate(FITTED[1:], CHANNELS):
            full[:, :, k] = by[name]
        return (full * cosine[:, :, None]).reshape(-1, len(x))

    found = []
    for measured, start in zip(values, case.starts, strict=False):

        def residuals(x: Floats, measured: NDArray[Any] = measured) -> Floats:
            return ((function.values(geometry, named(x)) - measured) * cosine).ravel()

        best = least_squares(
            residuals,
            np.clip(start, low + 1e-9, high - 1e-9),
            jac=slopes if jacobian else "2-point",
            bounds=(low, high),
            x_scale=0.3,
        )
        found.append(best.x)
    return np.array(found)


def single_fits(values: NDArray[Any]) -> None:
    """`motes.fit` on one texel after the other."""
    for measured in values:
        motes.fit(motes.Measurement.from_arrays(WI, WO, measured.astype(float)), SURFACE, fixed=HELD)


# ---------------------------------------------------------------- the benchmark


def texel_fits(effort: Effort) -> Section:
    """All candidates in turn: rates, and how the fits ended."""
    count = effort.pick(512, 200_000)
    while count * DIRECTIONS * CHANNELS * 4 * 4 > machine.memory_available():
        count //= 2
    few, single, series_count = effort.pick(2, 40), effort.pick(1, 10), effort.pick(64, 10_000)
    case, fitter, series = Case.of(count), solver(), Series.of(series_count)
    results: dict[str, Any] = {}
    candidates: dict[str, tuple[Callable[[], Any], float]] = {}

    def add(name: str, call: Callable[[], Any], items: int) -> None:
        def kept() -> None:
            results[name] = call()

        candidates[name] = (kept, items)

    add("clean", lambda: fitter.fit(case.clean, case.starts, own_starts=True), count)
    add("noisy", lambda: fitter.fit(case.noisy, case.starts, own_starts=True), count)
    add("direct", lambda: directly(fitter, case.noisy[: count // 4], case.starts[: count // 4]), count // 4)
    add("joint", lambda: series.solver.fit(series.values, series.starts, own_starts=True), series_count)
    add("scipy", lambda: scipy_fits(case, case.noisy[:few], True), few)
    add("scipy_plain", lambda: scipy_fits(case, case.noisy[: few // 2], False), few // 2)
    add("fit", lambda: single_fits(case.noisy[:single]), single)
    rounds = effort.pick(2, 7)
    timings = interleaved(candidates, rounds)
    figures = {
        "texels": Number.of([count]),
        "rounds": Number.of([rounds]),
        "series": Number.of([series_count]),
        "near_clean": case.near_truth(results["clean"].x),
    }
    for name, timing in timings.items():
        figures |= {
            f"{name}_rate": timing.rate,
            f"{name}_over_scipy": timing.faster_than(timings["scipy"]),
            f"{name}_over_direct": timing.faster_than(timings["direct"]),
            f"{name}_cpu": timing.processor.times(1e6),
            f"{name}_busy": timing.busy,
        }
    figures["free_rate"] = timings["noisy"].processor.rate(cores())
    figures["noisy_over_scipy_cpu"] = timings["noisy"].cheaper_than(timings["scipy"])
    for name in ("clean", "noisy", "direct", "joint"):
        figures[f"{name}_iterations"] = Number.of([results[name].iterations.mean()])
        figures[f"{name}_converged"] = Number.of([100 * np.mean(results[name].status == 0)])
    ours, theirs = results["noisy"].x[:few], results["scipy"]
    spread = np.abs(ours - theirs) / np.maximum(results["noisy"].stderr[:few], 1e-9)
    figures["from_scipy"] = Number.of([np.nanmax(spread)])
    rows = [
        [
            label, f"{{{name}_rate}}", f"{{{name}_over_scipy}}", f"{{{name}_over_direct}}", f"{{{name}_cpu}}", f"{{{name}_busy:bare}}",
            f"{{{name}_iterations:bare}}" if f"{name}_iterations" in figures else "",
            f"{{{name}_converged:bare}}" if f"{name}_converged" in figures else "",
        ]
        for name, label in LABELS.items()
    ]  # fmt: skip
    return Section(
        title="Fits of many texels",
        made_by="benchmarks/texels.py, texel_fits()",
        intro=(
            "Six parameters (K_d in three channels, sigma_d, K_s, sigma_s) under held dust; 100 directions x 3 channels; every texel starts within "
            "30 % of its own truth. {texels:count} texels a round ({series:count} under trends, a quarter of them for the form `direct`), fewer "
            "for what takes one at a time; medians of {rounds:count} rounds. Rates include checks, statuses, residuals and standard errors."
        ),
        figures=figures,
        tables=[
            Table(
                [
                    "",
                    "texels/s",
                    "x SciPy",
                    "x `direct`",
                    "µs of processor",
                    "processors busy",
                    "mean iterations",
                    "converged [%]",
                ],
                rows,
            )
        ],
        goals=[
            Goal("texels a second, 2 % noise", "noisy_rate", GOAL),
            Goal("the same, stretch", "noisy_rate", STRETCH),
            Goal("texels a second, without noise", "clean_rate", GOAL),
            Goal("texels a second, 12 times together", "joint_rate", TRENDS),
            Goal("within 1 % of the truth without noise", "near_clean", 100, unit=" %"),
        ],
        reading=reading(figures),
    )


def reading(figures: dict[str, Number]) -> list[str]:
    """What the figures say."""
    rate = figures["noisy_rate"].median
    verdict = (
        "misses the goal in this run"
        if rate < GOAL
        else "reaches the goal"
        if rate < STRETCH
        else "reaches the stretch goal"
    )
    lines = [
        f"The batched solver {verdict}: with noise it fits {{noisy_rate}} texels a second in {{noisy_iterations:bare}} iterations on average, "
        "{noisy_over_scipy} times a SciPy loop that has our Jacobian ({noisy_over_scipy_cpu} by processor time).",
        "Sums over residuals brought down to moments of the data, the form that `fit` takes, make it {noisy_over_direct} times as fast as summing "
        "every residual in every iteration.",
        "Of the texels that SciPy was given too, the one that ended farthest from SciPy's optimum is {from_scipy:bare} standard errors from it. Without noise "
        "{near_clean:bare} % of all texels end within 1 % of the truth.",
        "`motes.fit` on a single texel searches for starts and says what the data cannot see; it is meant for single materials. It makes {fit_over_scipy} "
        "fits in the time of one SciPy start.",
    ]
    if figures["noisy_busy"].median < 0.8 * cores():
        lines.append(
            "Only {noisy_busy:bare} processors worked on average; {noisy_cpu:bare} µs of processor a texel would be "
            "{free_rate:bare} texels a second on all of this machine's processors."
        )
    return lines


if __name__ == "__main__":
    command(texel_fits, __doc__)
