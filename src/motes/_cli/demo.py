"""``motes demo``: the main job on an embedded default."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from motes._cli.options import Common, Reading, Whole

SEED = 2007


def demo(
    *,
    output: Annotated[str, Parameter(name=["--output", "-o"])] = "motes-demo",
    time: Whole = 0,
    common: Common = Common(),  # noqa: B008 (an immutable value)
) -> int:
    """Simulate a dusty drying plaster, fit it, and write a report; nothing is downloaded.

    The scans go to OUTPUT/plaster in the format of the TVBRDF database, the results of the fit to OUTPUT. The table
    shows the true values beside the fitted ones. Exit status as of motes fit.

    Parameters
    ----------
    output
        The folder of the results.
    time
        Which of the twelve scans to fit, from 0; -1 is the last.
    """
    import numpy as np

    from motes._cli import console
    from motes._cli.fit import fit_and_write, load_measurement
    from motes.ageing import drying_plaster

    folder = Path(output)
    plaster = folder / "plaster"
    _simulate(plaster, common)
    measurement = load_measurement(str(plaster), Reading(), common)
    hours = float(measurement.times[time % measurement.n_times])
    truth = {name: np.asarray(value).tolist() for name, value in drying_plaster(hours).parameters.items()}
    if not (common.quiet or common.json):
        console.print_facts([("simulated", f"{plaster}/: {measurement.n_times} scans of a drying plaster, 2 % noise")])
    return fit_and_write(measurement, time, folder, True, {}, common, truth)


def _simulate(plaster: Path, common: Common) -> None:
    """Write the scans, in place of those of an earlier demonstration."""
    from motes._cli import console, paths
    from motes.ageing import drying_plaster, simulate
    from motes.errors import MotesError
    from motes.measurements.tvbrdf import DATA, INFO

    if plaster.is_dir():
        others = [file.name for file in plaster.iterdir() if file.name not in (DATA, INFO)]
        if others:
            raise MotesError(
                f"{plaster} holds {others[0]}, which motes demo did not write", "Choose another folder with -o"
            )
    with paths.results(plaster.parent) as staging:
        with console.progress(common, "simulating") as step:
            simulate(
                staging / plaster.name, drying_plaster, seed=SEED, name="dusty plaster", process="drying", progress=step
            )
        if plaster.is_dir():
            shutil.rmtree(plaster)
