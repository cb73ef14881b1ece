"""STAF maps (Gu et al. 2006, refitted by Meister et al.): a folder of coefficients of polynomials in time.

``<Diffuse|Specular|Roughness>-d.exr`` holds the coefficient of t^d, t in [0, 1].
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError
from motes.files import reading
from motes.images import exr as _exr
from motes.measurements.parameter_maps import NAMES, ParameterMaps

NAME = "staf"
SOURCE = (
    "a folder in the layout of the STAF data (Gu et al. 2006, as polynomials by Meister et al.); "
    "its files do not say whose it is, nor whether it was measured"
)
WIDE = 0.6  # rad; highlights of the STAF data are narrower, the roughness of a texture set mostly is not
ANY_FILE = re.compile(r"(.+)-(\d)\.exr", re.IGNORECASE)
FILE = re.compile(rf"({'|'.join(NAMES)})-(\d)\.exr", re.IGNORECASE)


def sniff(path: Path, head: bytes) -> bool:
    if path.is_dir():
        return bool(_coefficients(path))
    return head.startswith(_exr.MAGIC) and FILE.fullmatch(path.name) is not None


def read_staf(path: Path) -> ParameterMaps:
    """The maps of a folder.

    Raises
    ------
    FormatError
        Where a coefficient is missing or the maps have different sizes.
    """
    if not path.is_dir():
        raise FormatError(f"{path} is one file of a set of maps", f"Give the folder: {path.parent}")
    files = _coefficients(path)
    for name in NAMES:
        degrees = sorted(d for n, d in files if n == name)
        reading.require(
            bool(degrees) and degrees == list(range(len(degrees))),
            f"{path} holds {name} for the powers {degrees} of t; they must run from 0 without a gap",
            f"Each map needs {name}-0.exr, {name}-1.exr, ...",
        )
    first: tuple[int, ...] | None = None
    maps: dict[str, list[NDArray[np.float32]]] = {name: [] for name in NAMES}
    for (name, _), file in sorted(files.items()):
        picture = _exr.rgb(file, "reading STAF maps")
        first = first or picture.shape
        reading.require(
            picture.shape == first,
            f"{file} is {picture.shape[:2]} and the maps before it {first[:2]}",
            "All have one size",
        )
        reading.require(
            bool(np.all(np.isfinite(picture))), f"{file} holds values that are not finite", "Fetch the file again"
        )
        maps[name].append(picture)
    coefficients = {name: np.stack(maps[name]) for name in NAMES}
    for name in ("Specular", "Roughness"):
        c = coefficients[name]
        if np.array_equal(c[..., 0], c[..., 1]) and np.array_equal(c[..., 0], c[..., 2]):
            coefficients[name] = np.ascontiguousarray(c[..., :1])
    reading.require(
        coefficients["Roughness"].shape[-1] == 1, f"{path}: Roughness has colours", "One sigma_s serves all channels"
    )
    others = _others(path)
    wide = float(np.mean(coefficients["Roughness"].sum(axis=0)))  # at t = 1; at t = 0 it is the first coefficient
    doubtful = [f.name for f in others if f.name.lower().startswith(("height-", "normal-"))] or max(
        wide, float(np.mean(coefficients["Roughness"][0]))
    ) > WIDE
    notes = []
    if others:
        names = ", ".join(f.name for f in others[:12]) + (" and more" if len(others) > 12 else "")
        notes.append(f"not read, for the model has no place for it: {names}")
    if doubtful:
        notes.append(
            f"the maps look like those of a texture set: a Roughness (mean {float(np.mean(coefficients['Roughness'][0])):.3g} at t = 0) between 0 and 1 of a "
            "program for textures is no width in radians, and its Specular no weight of a highlight; then K_s and sigma_s mean nothing"
        )
    return ParameterMaps(
        coefficients,
        provenance={
            "format": NAME,
            "path": str(path),
            "name": path.resolve().name,
            "source": SOURCE,
            "notes": [
                *notes,
                "t = 0 to 1 is the time of the whole experiment; the polynomials are evaluated, then clamped at 0",
                "read as f_r = Diffuse/pi + K_s rho_s, K_s = Specular/(pi R^2 (1 - exp(-1/R^2))), sigma_s = R, "
                "the Roughness in radians; whether the source divides Diffuse by pi is not confirmed",
                "where Roughness is 0 or below, sigma_s and K_s are 0: no highlight",
            ],
        },
    )


def _coefficients(folder: Path) -> dict[tuple[str, int], Path]:
    """(name of the map, power of t) -> file."""
    found = {}
    for file in folder.iterdir():
        match = FILE.fullmatch(file.name)
        if match and file.is_file():
            found[match[1].capitalize(), int(match[2])] = file
    return found


def _others(folder: Path) -> list[Path]:
    """Files of the same kind of name that stand for something else, such as Height-0.exr."""
    return sorted(
        f for f in folder.iterdir() if ANY_FILE.fullmatch(f.name) and not FILE.fullmatch(f.name) and f.is_file()
    )
