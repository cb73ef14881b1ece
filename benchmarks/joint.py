"""How long a joint fit takes: 12 scans x 4 cameras x 360 directions x 3 channels, and as many separate fits for comparison.

usage: python benchmarks/joint.py [--repeat 3] [--json]

The goal is 10 s on two idle cores, the model given or chosen.  CPU seconds count all threads and do not depend on what else runs.
"""

from __future__ import annotations

import argparse
import json
import os
import time
import warnings
from collections.abc import Callable

import numpy as np

import motes
from motes.ageing import drying_plaster
from motes.ageing.plaster import MODEL
from motes.ageing.rig import Rig
from motes.measurements import Measurement

SCANS, DIRECTIONS, NOISE, HOURS, GOAL = 12, 360, 0.02, 6.0, 10.0


def data() -> Measurement:
    """The drying plaster on the rig of four cameras, with 360 places of the lamp."""
    rig, rng = Rig(), np.random.default_rng(20060730)
    theta = np.radians(np.linspace(78, -78, DIRECTIONS))
    lamp = np.stack([np.sin(theta), np.zeros(DIRECTIONS), np.cos(theta)], axis=-1)
    wi, wo = np.tile(lamp, (len(rig.wo), 1)), np.repeat(rig.wo, DIRECTIONS, axis=0)
    times = np.linspace(0, HOURS, SCANS)
    exact = np.stack([drying_plaster(float(t)).eval(wi, wo) for t in times])
    noisy = exact * (1 + NOISE * rng.standard_normal(exact.shape))
    return Measurement.from_arrays(wi, wo, noisy, times=times, channels=("R", "G", "B"))


def measured(work: Callable[[], object], repeat: int) -> dict[str, float]:
    """Wall and CPU seconds of the fastest of `repeat` calls."""
    runs = []
    for _ in range(repeat):
        wall, cpu = time.perf_counter(), time.process_time()
        work()
        runs.append((time.perf_counter() - wall, time.process_time() - cpu))
    return {"wall_s": min(r[0] for r in runs), "cpu_s": min(r[1] for r in runs)}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    scans = data()
    warnings.simplefilter("ignore")
    motes.fit(scans.at(0), MODEL)  # what is generated and cached on first use
    results = {
        "joint, model given": measured(lambda: motes.fit(scans, MODEL), options.repeat),
        "joint, model chosen": measured(lambda: motes.fit(scans), options.repeat),
        "12 separate fits": measured(lambda: [motes.fit(scans, MODEL, time=t) for t in range(SCANS)], options.repeat),
    }
    base = results["12 separate fits"]["cpu_s"]
    if options.json:
        print(json.dumps({"load": os.getloadavg()[0], "processors": os.cpu_count(), "results": results}))
        return
    print(
        f"{SCANS} scans x {scans.n_directions} directions x 3 channels; load {os.getloadavg()[0]:.1f}, processors {os.cpu_count()}"
    )
    for name, r in results.items():
        print(
            f"{name:22} {r['wall_s']:6.1f} s wall {r['cpu_s']:6.1f} s CPU   {r['cpu_s'] / base:5.2f} of the separate fits' CPU"
        )
    slowest = max(r["wall_s"] for name, r in results.items() if name.startswith("joint"))
    print(f"goal: {GOAL:g} s on two idle cores: {'met' if slowest <= GOAL else 'not met in this run'}")


if __name__ == "__main__":
    main()
