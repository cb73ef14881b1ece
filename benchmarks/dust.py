"""What multiple scattering in a layer of dust costs: evaluation, texels that differ, and gradients, beside single scattering.

usage: python benchmarks/dust.py [--effort quick|normal|full] [--json FILE]
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

import rivals
from motes import BRDF, Dust, DustLayer, Lambert, OrenNayar, TorranceSparrow
from motes.kernels import engine
from results import Effort, Goal, Number, Section, Table, command
from timing import Timing, interleaved

COLOR, WHITE = (0.8, 0.7, 0.6), (0.9, 0.8, 0.7)
BASES: dict[str, tuple[str, BRDF]] = {
    "diffuse": ("a diffuse base", OrenNayar(COLOR, 0.4)),
    "glossy": ("a base with a highlight", OrenNayar(COLOR, 0.4) + TorranceSparrow(0.3, 0.15)),
}
ALBEDOS: dict[str, tuple[str, Any]] = {"one": ("one w", 0.9), "three": ("a w for each channel", WHITE)}
DIRECTIONS = 128  # that each texel is seen in, where it is seen in several
TOLERANCE = 2e-4  # of the largest value: float32
Calls = dict[str, tuple[Callable[[], Any], float]]


def layer(base: BRDF, w: Any, scattering: str, tau: Any = 0.2, g: Any = 0.3) -> DustLayer:
    return DustLayer(base, Dust(w=w, g=g), tau=tau, scattering=scattering)


def check(model: BRDF, wi: rivals.Rows, wo: rivals.Rows, count: int = 200) -> None:
    """Stop where the engine computes something else than the equations: its time would mean nothing."""
    found = engine.evaluate(model, wi, wo)[..., :count, :]
    expected = model.eval(wi.astype(float)[..., :count, :], wo.astype(float)[..., :count, :])
    worst = float(np.abs(found - expected).max() / np.abs(expected).max())
    if not worst < TOLERANCE:
        raise ArithmeticError(f"{model} is off by {worst:.2g} of the largest value")


def candidates(effort: Effort) -> Calls:
    """By name ``BASE_WHAT_SCATTERING`` a call and the number of its evaluations."""
    n = effort.pick(2_000, 400_000)
    wi, wo = (rivals.directions(n, seed).T for seed in (1, 2))
    out, seed = np.empty((3, n), np.float32).T, np.ones((3, n), np.float32).T
    texels = np.random.default_rng(3).uniform(0.05, 2, n).astype(np.float32)
    smooth = (1.025 + 0.975 * np.sin(np.linspace(0, 40, n))).astype(np.float32)
    few = max(2, n // DIRECTIONS)
    seen_wi, seen_wo = (np.ascontiguousarray(w[:DIRECTIONS]) for w in (wi, wo))
    many = np.empty((few, DIRECTIONS, 3), np.float32)
    bases = effort.pick({"diffuse": ("", Lambert(0.5))}, BASES)
    albedos = effort.pick({"one": ALBEDOS["one"]}, ALBEDOS)
    calls: Calls = {}
    for base_name, (_, base) in bases.items():
        for scattering in ("single", "multiple"):
            for w_name, (_, w) in albedos.items():
                model = layer(base, w, scattering)
                check(model, wi, wo)
                target = out[:, : model.channels]
                run = lambda m=model, t=target: engine.evaluate(m, wi, wo, out=t)  # noqa: E731
                slope = lambda m=model, s=seed[:, : model.channels]: engine.vjp(m, wi, wo, s)  # noqa: E731
                calls[f"{base_name}_{w_name}_{scattering}"] = run, n
                calls[f"{base_name}_{w_name}_gradient_{scattering}"] = slope, n
            varied = layer(base, ALBEDOS["one"][1], scattering, tau=texels)
            alike = layer(base, ALBEDOS["one"][1], scattering, tau=smooth)
            seen = layer(base, ALBEDOS["one"][1], scattering, tau=texels[:few, None])
            check(varied.with_parameters({"tau": texels[:200]}), wi[:200], wo[:200])
            check(alike.with_parameters({"tau": smooth[:200]}), wi[:200], wo[:200])
            check(seen, seen_wi, seen_wo)
            target, whole = out[:, : varied.channels], many[..., : varied.channels]
            calls[f"{base_name}_texels_{scattering}"] = lambda m=varied, t=target: engine.evaluate(m, wi, wo, out=t), n
            calls[f"{base_name}_smooth_{scattering}"] = lambda m=alike, t=target: engine.evaluate(m, wi, wo, out=t), n
            calls[f"{base_name}_seen_{scattering}"] = (
                lambda m=seen, t=whole: engine.evaluate(m, seen_wi, seen_wo, out=t),
                few * DIRECTIONS,
            )
    return calls


def dust_cost(effort: Effort) -> Section:
    """All calls in turn, in one process."""
    rounds = effort.pick(3, 9)
    calls = candidates(effort)
    return report(interleaved(calls, rounds), rounds)


def report(timings: dict[str, Timing], rounds: int) -> Section:
    """Quotients of processor time, round by round, and nanoseconds."""
    figures = {"rounds": Number.of([rounds])}
    rows, goals = [], []
    for base, (words, _) in BASES.items():
        kinds = {name: f"{base}_{name}" for name in ALBEDOS}
        for name, stem in kinds.items():
            if f"{stem}_single" not in timings:
                continue
            _add(figures, timings, f"{stem}_single", f"{stem}_multiple", stem)
            _add(figures, timings, f"{stem}_multiple", f"{stem}_gradient_multiple", f"{stem}_gradient")
            what = f"{words}, {ALBEDOS[name][0]}"
            rows.append([what, f"{{{stem}_ns}}", f"{{{stem}}}"])
            rows.append([f"{what}: gradient, in evaluations", f"{{{stem}_gradient_ns}}", f"{{{stem}_gradient}}"])
            goals.append(Goal(f"{what}, over single scattering", stem, 2, at_least=False, unit=" x"))
            goals.append(Goal(f"{what}: gradient, in evaluations", f"{stem}_gradient", 2, at_least=False, unit=" x"))
        for kind, seen in (
            ("texels", "one direction each"),
            ("smooth", "one direction each, neighbours alike"),
            ("seen", f"{DIRECTIONS} directions each"),
        ):
            stem = f"{base}_{kind}"
            if f"{stem}_single" not in timings:
                continue
            _add(figures, timings, f"{stem}_single", f"{stem}_multiple", stem)
            what = f"{words}, texels of other tau, {seen}"
            rows.append([what, f"{{{stem}_ns}}", f"{{{stem}}}"])
            goals.append(Goal(f"{what}, over single scattering", stem, 4, at_least=False, unit=" x"))
    return Section(
        title="Dust with all orders of scattering",
        made_by="benchmarks/dust.py, dust_cost()",
        intro=(
            "A layer of dust with multiple scattering in float32, beside the same layer with single scattering; processor time, medians of "
            "{rounds:count} rounds in turn. Every surface was checked against the equations in float64."
        ),
        figures=figures,
        tables=[Table(["", "ns of processor", "x single scattering"], rows)],
        goals=goals,
        reading=[
            "Where tau, w and g hold for all directions what depends on them alone is computed once; where texels differ in tau and each is seen in one "
            "direction, for groups of about the same tau (docs/engine.md), which is checked against the equations by tests/test_kernels_grouped.py."
        ],
    )


def _add(figures: dict[str, Number], timings: dict[str, Timing], less: str, more: str, name: str) -> None:
    """The quotient of two calls, and the nanoseconds of the second."""
    figures[name] = timings[less].cheaper_than(timings[more])
    figures[f"{name}_ns"] = timings[more].processor.times(1e9)


if __name__ == "__main__":
    command(dust_cost, __doc__)
