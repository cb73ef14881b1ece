"""How long a joint fit over time takes: 12 scans x 4 cameras x 360 directions x 3 channels, and as many separate fits for comparison.

usage: python benchmarks/joint.py [--effort quick|normal|full] [--json FILE]

Processor seconds count all threads and do not depend on what else runs.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable

import numpy as np

import motes
from motes.ageing import drying_plaster
from motes.ageing.plaster import MODEL
from motes.ageing.rig import Rig
from motes.measurements import Measurement
from results import Effort, Goal, Number, Section, Table, command
from timing import interleaved

SCANS, DIRECTIONS, NOISE, HOURS, GOAL = 12, 360, 0.02, 6.0, 10.0
LABELS = {
    "given": "joint, the model given",
    "chosen": "joint, the model chosen too",
    "separate": "separate fits, one a scan",
}


def plaster(scans: int, places: int) -> Measurement:
    """The drying plaster on the rig of four cameras, with so many places of the lamp."""
    rig, rng = Rig(), np.random.default_rng(20060730)
    theta = np.radians(np.linspace(78, -78, places))
    lamp = np.stack([np.sin(theta), np.zeros(places), np.cos(theta)], axis=-1)
    wi, wo = np.tile(lamp, (len(rig.wo), 1)), np.repeat(rig.wo, places, axis=0)
    times = np.linspace(0, HOURS, scans)
    exact = np.stack([drying_plaster(float(t)).eval(wi, wo) for t in times])
    noisy = exact * (1 + NOISE * rng.standard_normal(exact.shape))
    return Measurement.from_arrays(wi, wo, noisy, times=times, channels=("R", "G", "B"))


def joint_fits(effort: Effort) -> Section:
    """Joint and separate fits in turn."""
    count, places = effort.pick(3, SCANS), effort.pick(8, DIRECTIONS)
    scans = plaster(count, places)
    calls: dict[str, tuple[Callable[[], object], float]] = {
        "given": (lambda: motes.fit(scans, MODEL), 1),
        "chosen": (lambda: motes.fit(scans), 1),
        "separate": (lambda: [motes.fit(scans, MODEL, time=t) for t in range(count)], 1),
    }
    rounds = effort.pick(1, 3)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        motes.fit(scans.at(0), MODEL)  # what is generated and kept on first use
        timings = interleaved(calls, rounds, warm=False)
    figures = {
        "scans": Number.of([count]),
        "directions": Number.of([scans.n_directions]),
        "rounds": Number.of([rounds]),
    }
    for name, timing in timings.items():
        figures |= {
            f"{name}_wall": timing.seconds,
            f"{name}_cpu": timing.processor,
            f"{name}_share": timings["separate"].cheaper_than(timing),
        }
    slowest = max(("given", "chosen"), key=lambda name: timings[name].seconds.median)
    rows = [[label, f"{{{name}_wall}}", f"{{{name}_cpu}}", f"{{{name}_share}}"] for name, label in LABELS.items()]
    return Section(
        title="Fits over time",
        made_by="benchmarks/joint.py, joint_fits()",
        intro=(
            "A drying plaster as four cameras see it: {scans:count} scans x {directions:count} pairs of directions x 3 channels, "
            "2 % noise; medians of {rounds:count} rounds."
        ),
        figures=figures,
        tables=[Table(["", "s, wall", "s of processor", "of the separate fits' processor time"], rows)],
        goals=[Goal("the slower joint fit", f"{slowest}_wall", GOAL, at_least=False, unit=" s")],
        reading=[
            "A joint fit with the model chosen as well takes {chosen_share} times the processor time of as many separate fits as there are scans."
        ],
    )


if __name__ == "__main__":
    command(joint_fits, __doc__)
