"""What a map costs under each loss and each robust function, beside the linear loss.

usage: python benchmarks/map_losses.py [--effort quick|normal|full] [--json FILE]
"""

from __future__ import annotations

from functools import partial
from typing import Any

import places
from motes import maps
from motes.fitting.losses import LOSSES, ROBUST
from motes.maps.work import fit_block, read_block
from results import Effort, Goal, Number, Section, Table, command
from timing import interleaved

MODEL = "oren_nayar + torrance_sparrow"
LIGHTS = 12  # two views of every light
GOAL = 4.0
PLAIN = {"loss": "linear", "robust": "none"}
#: One of the two is other than as a rule.
ASKED = [
    PLAIN,
    *(PLAIN | {"loss": x} for x in LOSSES if x != "linear"),
    *(PLAIN | {"robust": x} for x in ROBUST if x != "none"),
]


def named(asked: dict[str, str]) -> str:
    """The loss or the robust function."""
    return asked["robust"] if asked["robust"] != "none" else asked["loss"]


def map_losses(effort: Effort) -> Section:
    """The fits of a map under all of them in turn."""
    size, times, rounds, all_asked = effort.pick((16, 2, 1, ASKED[::3]), (96, 4, 5, ASKED))
    with places.fresh() as folder:
        source = maps.simulate_map(folder / "map.zarr", (size, size), times=times, lights=LIGHTS)
        candidates: dict[str, tuple[Any, float]] = {}
        fits = size * size * times
        for asked in all_asked:
            fitted = maps.fit_map(source, MODEL, out=folder / f"{named(asked)}.zarr", **asked)
            values: list[Any] = [read_block(fitted, block) for block in fitted.blocks]
            candidates[named(asked)] = (partial(whole, fitted, values), fits)
        timings = interleaved(candidates, rounds, warm=False)
    figures = {"fits": Number.of([fits]), "rounds": Number.of([rounds])}
    for name, timing in timings.items():
        figures |= {f"{name}_cpu": timing.processor.times(1e6), f"{name}_ratio": timings["linear"].cheaper_than(timing)}
    slowest = max(timings, key=lambda name: figures[f"{name}_ratio"].median)
    kinds = {asked["loss"]: "loss" for asked in ASKED} | dict.fromkeys(ROBUST, "robust function")
    return Section(
        title="Losses and robust functions of maps",
        made_by="benchmarks/map_losses.py, map_losses()",
        intro=(
            f"The fits of a simulated map, {2 * LIGHTS} pairs of directions x 3 channels, `{MODEL}`, {{fits:count}} of them a round, {{rounds:count}} "
            "rounds in turn, from starts that were found for each: what `motes fit MAP.zarr --loss` and `--robust` take besides reading and writing. "
            "Noise is normal: outliers make robust fits go on longer."
        ),
        figures=figures,
        tables=[
            Table(
                ["", "µs of processor a fit", "x `linear`"],
                [[f"{kinds[name]} `{name}`", f"{{{name}_cpu}}", f"{{{name}_ratio}}"] for name in timings],
            )
        ],
        goals=[
            Goal(
                "the dearest loss or robust function of a map over `linear`",
                f"{slowest}_ratio",
                GOAL,
                at_least=False,
                unit=" x",
            )
        ],
        reading=[f"The dearest is `{slowest}`, {{{slowest}_ratio}} times `linear`."],
    )


def whole(fitted: maps.FittedMap, values: list[Any]) -> None:
    """The fits of all blocks."""
    for block in values:
        fit_block(fitted, block)


if __name__ == "__main__":
    command(map_losses, __doc__)
