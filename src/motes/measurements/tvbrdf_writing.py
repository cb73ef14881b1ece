"""Writing in the layout of the TVBRDF database, which `motes.measurements.tvbrdf` describes and reads."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from motes.errors import DataError, MotesError
from motes.files import together
from motes.measurements.tvbrdf import DATA, INFO


def write_tvbrdf(
    folder: str | Path,
    *,
    name: str,
    process: str,
    times_seconds: Sequence[float],
    scans: Sequence[Sequence[tuple[ArrayLike, ArrayLike, ArrayLike]]],
    exposures: Sequence[float] = (0.2, 4.0, 32.0),
    irradiance: float = 1.0,
    source: str = "",
) -> Path:
    """Write a sample folder in the layout of the TVBRDF database; it appears whole or not at all.

    Parameters
    ----------
    folder
        The sample folder, for example ``sample01``; it must not exist, or be empty.
    name, process
        What was measured, and what happens to it: ``"plaster"``, ``"drying"``.
    times_seconds
        (T,) [s], strictly increasing.
    scans
        ``scans[t][v] = (L, V, radiance)`` of camera v: directions to the light and to the viewer (M, 3), radiance (M,
        3) in R, G, B.
    exposures
        Of the pictures that the radiance was made from.
    irradiance
        E at normal incidence, which `read_tvbrdf` divides by.
    source
        Where the numbers come from, such as ``"simulated by Motes"``; what begins with "simulated" is said to be so
        wherever the data go.

    Returns
    -------
    Path
        The folder.

    Raises
    ------
    DataError
        For shapes that do not fit.
    MotesError
        When the folder is not empty or cannot be written.
    """
    folder = Path(folder)
    times = np.asarray(times_seconds, np.float64).reshape(-1)
    if len(scans) == 0 or len(times) != len(scans) or not np.all(np.isfinite(times)) or np.any(np.diff(times) <= 0):
        raise DataError(
            f"{len(times)} times for {len(scans)} scans, or times that do not increase",
            "Give one time [s] a scan, in order",
        )
    if not (np.isfinite(irradiance) and irradiance > 0):
        raise DataError(
            f"irradiance = {irradiance:g} is not positive and finite", "It is that of a surface facing the light"
        )
    texts = {}
    first = "Exposure " + " ".join(f"{e:f}" for e in exposures)
    for t, cameras in enumerate(scans, 1):
        for v, parts in enumerate(cameras, 1):
            L, V, radiance = (np.asarray(p, np.float64) for p in parts)
            if not L.shape == V.shape == radiance.shape or L.ndim != 2 or L.shape[1] != 3:
                raise DataError(
                    f"scan {t}, camera {v}: L, V and radiance have shapes {L.shape}, {V.shape}, {radiance.shape}",
                    "All are (M, 3)",
                )
            rows = np.concatenate([radiance[:, ::-1], L, V], axis=1)
            triple = "F %.9g %.9g %.9g\nL %.9f %.9f %.9f\nV %.9f %.9f %.9f"
            texts[f"scan{t:02d}_brdf_camera{v}_allexposures.txt"] = (
                "\n".join([first, *(triple % tuple(r) for r in rows)]) + "\n"
            )
    info = [
        f"Sample Name: {_one_line(name)} ({_one_line(process)})",
        "Exposures: " + " ".join(f"{e:f}" for e in exposures),
        f"Number of scans: {len(scans)}",
        f"Irradiance: {irradiance:.9g}",
        *([f"Source: {_one_line(source)}"] if source else []),
        "Time stamps (s):",
        *(f"scan {t:02d}: {time:.9g} s" for t, time in enumerate(times, 1)),
    ]
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise MotesError(
            f"{folder} exists and is not an empty folder", "Choose another, or remove it; nothing is overwritten"
        )
    with together(folder.parent, "Choose a folder that is writable and has room") as staging:
        new = staging / folder.name
        try:
            (new / DATA).mkdir(parents=True)
            (new / INFO).write_text("\n".join(info) + "\n", encoding="utf-8")
            for file, text in texts.items():
                (new / DATA / file).write_text(text, encoding="ascii")
        except OSError as error:
            raise MotesError(
                f"{folder} cannot be written: {error.strerror or error}",
                "Choose a folder that is writable and has room",
            ) from error
    return folder


def _one_line(text: str) -> str:
    return " ".join(str(text).replace(":", " ").split())
