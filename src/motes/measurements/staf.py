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
SOURCE = "Gu et al., Time-varying Surface Appearance, ACM TOG 25(3), 2006, refitted as polynomials by Meister et al."
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
    return ParameterMaps(
        coefficients,
        provenance={
            "format": NAME,
            "path": str(path),
            "name": path.resolve().name,
            "source": SOURCE,
            "notes": [
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
