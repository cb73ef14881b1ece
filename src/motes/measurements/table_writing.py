"""A measurement as a table that `motes.read` reads back: its samples, uncertainties and weights."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from motes import directions
from motes.errors import DataError
from motes.files import replacing
from motes.measurements.measurement import Measurement


def write_table(data: Measurement, path: str | os.PathLike[str]) -> Path:
    """Write a measurement as CSV: a row for each pair of directions and time, angles in degrees, f_r in 1/sr.

    Samples that are masked become empty cells.  A common uncertainty is a number, not a column: it stands in a comment, with
    the option that gives it back.

    Parameters
    ----------
    data
        The measurement.
    path
        The file; what it held is replaced.

    Raises
    ------
    DataError
        Where some usable samples have an uncertainty and others none: a table has one for each value.
    """
    target = Path(path)
    known = data.uncertainties
    if known is not None and not np.isfinite(known[data.mask]).all():
        raise DataError(
            f"{int(np.isnan(known[data.mask]).sum())} of {int(data.mask.sum())} usable samples have no uncertainty",
            "Mask them first, or leave uncertainties out",
        )
    names = (
        [f"{w:.9g} nm" for w in data.wavelengths]
        if data.wavelengths is not None
        else [f"brdf[{c}]" for c in data.channels]
    )
    of = [name.removeprefix("brdf[").removesuffix("]") for name in names]
    timed = data.n_times > 1
    weighted = bool(np.ptp(data.weights) > 0)
    header = ["theta_i_deg", "phi_i_deg", "theta_r_deg", "phi_r_deg"]
    header += ["scan" if data.time_unit == "scan" else "time_h"] if timed else []
    header += ["weight"] if weighted else []
    header += names + ([f"uncertainty[{name}]" for name in of] if known is not None else [])
    angles = np.degrees(
        np.stack([data.theta_i, directions.phi(data.wi), data.theta_r, directions.phi(data.wo)], axis=1)
    )
    with replacing(target) as temporary, open(temporary, "w", encoding="utf-8", newline="\n") as file:
        file.write(f"# {' '.join(data.name.split())}; f_r in 1/sr, without the cosine\n")
        if data.common_uncertainty is not None:
            file.write(
                f"# all samples share an uncertainty of their scale: --read common_uncertainty={data.common_uncertainty:g}\n"
            )
        file.write(",".join(header) + "\n")
        for t, time in enumerate(data.times):
            for n in np.flatnonzero(data.mask[t].any(axis=1)):
                usable = data.mask[t, n]
                cells = [
                    *angles[n].tolist(),
                    *([float(time)] if timed else []),
                    *([float(data.weights[n])] if weighted else []),
                ]
                row = [repr(x) for x in cells] + _cells(data.values[t, n], usable)
                file.write(",".join(row + (_cells(known[t, n], usable) if known is not None else [])) + "\n")
    return target


def _cells(
    values: np.ndarray[tuple[int, ...], np.dtype[np.float64]], usable: np.ndarray[tuple[int, ...], np.dtype[np.bool_]]
) -> list[str]:
    return [repr(float(v)) if u else "" for v, u in zip(values, usable, strict=True)]
