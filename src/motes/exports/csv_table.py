"""A CSV table: a row a pair of directions and a time, which `motes.read` and everything else reads."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes.channels import GREY, RGB, numbered, spectral_names
from motes.directions import from_spherical
from motes.exports.shaders import plain, source_of_equations
from motes.exports.subject import Subject
from motes.files import replacing
from motes.files.inert import cell
from motes.material import CONVENTIONS

SUFFIX = ".csv"
THETA_I_DEG = tuple(range(0, 90, 15))
THETA_R_DEG = tuple(range(0, 90, 5))
PHI_DEG = tuple(range(0, 181, 15))
_PLAIN = (*RGB, *GREY)  # names of channels that need no word for what is in them


def grid() -> NDArray[np.float64]:
    """theta_i, theta_r, phi_r (N, 3) [degrees] of the rows; phi_i is 0, and isotropy gives the other half of phi_r.

    At normal incidence the azimuth means nothing, and one row is enough.
    """
    rows = [(i, r, phi) for i in THETA_I_DEG for r in THETA_R_DEG for phi in PHI_DEG if phi == 0 or (i > 0 and r > 0)]
    return np.array(rows, np.float64)


def limits(subject: Subject) -> list[str]:
    """What the table cannot say."""
    return ["Steps of 5 to 15 degrees: a highlight narrower than that falls between the rows."]


def write(moments: Sequence[tuple[float | None, Subject]], path: Path) -> list[Path]:
    """Write the table.

    Parameters
    ----------
    moments
        Hours and the material then; the hours are None for a material that does not change.
    """
    from motes.version import __version__

    first = moments[0][1]
    angles = grid()
    wi = from_spherical(np.deg2rad(angles[:, 0]), 0.0)
    wo = from_spherical(np.deg2rad(angles[:, 1]), np.deg2rad(angles[:, 2]))
    timed = moments[0][0] is not None
    notes = [f"{plain(first.title)}; Motes {__version__}", f"f_r: the BRDF in {CONVENTIONS['brdf']}"]
    notes += [
        f"The equations are those of {source_of_equations()}",
        *map(plain, first.notes if len(moments) == 1 else first.origin),
    ]
    with replacing(path) as temporary, open(temporary, "w", encoding="utf-8", newline="\n") as file:
        file.writelines(f"# {cell(note)}\n" for note in notes)
        file.write(",".join(["theta_i_deg", "phi_i_deg", "theta_r_deg", "phi_r_deg", *(["time_h"] if timed else [])]))
        file.write("".join(f",{name}" for name in headings(first)) + "\n")
        for hours, subject in moments:
            values = np.broadcast_to(subject.brdf.eval(wi, wo), (len(wi), len(subject.channels)))
            for (i, r, phi), row in zip(angles, values, strict=True):
                cells = [f"{i:g}", "0", f"{r:g}", f"{phi:g}", *([repr(float(hours or 0))] if timed else [])]
                file.write(",".join([*cells, *map(repr, row.tolist())]) + "\n")
    return [path]


def headings(subject: Subject) -> list[str]:
    """Names of the columns of values: wavelengths where there are any, else the channels, as far as a header can hold them."""
    if subject.wavelengths:
        return list(spectral_names(subject.wavelengths))
    names = [re.sub(r"[^\w .-]", "", plain(name)).strip() for name in subject.channels]
    if len({name.lower() for name in names}) < len(names) or "" in names:
        return list(numbered(len(names)))
    return [name if name in _PLAIN else f"brdf[{name}]" for name in names]
