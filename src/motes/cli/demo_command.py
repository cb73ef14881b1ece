"""``motes demo``: the main job on an embedded default."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

from cyclopts import Parameter

from motes.cli.options import Common, MaybeWhole, Reading

SEED = 2007


def demo(
    *,
    output: Annotated[str, Parameter(name=["--output", "-o"])] = "motes-demo",
    time: MaybeWhole = None,
    common: Common = Common(),  # noqa: B008 (an immutable value)
) -> int:
    """Simulate a dusty drying plaster, fit it over time, and write a report; nothing is downloaded.

    The twelve scans go to OUTPUT/plaster in the format of the TVBRDF database, the results of the fit to OUTPUT. The
    tables show the truth beside what was found. In its dust light is scattered once, as in the paper whose models these are, so that
    fits by them can find the truth. Exit status as of motes fit.

    Parameters
    ----------
    output
        The folder of the results.
    time
        Fit one of the twelve scans alone, from 0; -1 is the last.
    """
    from motes.cli import console
    from motes.cli.fitting_measurements import fit_and_write, load_measurement

    folder = Path(output)
    plaster = folder / "plaster"
    _simulate(plaster, common)
    measurement = load_measurement(str(plaster), Reading(), common)
    if not (common.quiet or common.json):
        console.print_facts(
            [
                (
                    "simulated",
                    f"{plaster}/: {measurement.n_times} scans of a drying plaster, 2 % noise; light is scattered in its dust once",
                )
            ]
        )
    truth = true_trends(float(measurement.times[-1])) if time is None else _at(measurement.times, time)
    return fit_and_write(measurement, time, folder, True, {}, common, truth)


def simulated_plaster(folder: Path, progress: Callable[[int, int, str], None] | None = None) -> Path:
    """The twelve scans of the demonstration, written to a folder; the same in each version."""
    from motes.ageing import drying_plaster, simulate

    return simulate(folder, drying_plaster, seed=SEED, name="dusty plaster", process="drying", progress=progress)


def true_trends(last: float) -> dict[str, Any]:
    """What is true of the plaster: for each parameter the kind of trend, its coefficients, the values at both ends."""
    import numpy as np

    from motes.ageing import plaster

    return {
        name: {
            "kind": trend.kind,
            "coefficients": {key: np.asarray(value).tolist() for key, value in trend.coefficients.items()},
            "first": trend(0.0).tolist(),
            "last": trend(last).tolist(),
        }
        for name, trend in plaster.trends(last).items()
    }


def _at(times: Any, index: int) -> dict[str, Any]:
    """The true parameters at one of the times."""
    import numpy as np

    from motes.ageing import drying_plaster

    hours = float(times[index % len(times)])
    return {name: np.asarray(value).tolist() for name, value in drying_plaster(hours).parameters.items()}


def _simulate(plaster: Path, common: Common) -> None:
    """Write the scans, in place of those of an earlier demonstration."""
    from motes.cli import console
    from motes.errors import MotesError
    from motes.files import together
    from motes.measurements.tvbrdf import DATA, INFO

    if plaster.is_dir():
        others = [file.name for file in plaster.iterdir() if file.name not in (DATA, INFO)]
        if others:
            raise MotesError(
                f"{plaster} holds {others[0]}, which motes demo did not write", "Choose another folder with -o"
            )
    with together(plaster.parent) as staging, console.progress(common, "simulating") as step:
        simulated_plaster(staging / plaster.name, step)
