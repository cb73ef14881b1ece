"""CUReT (Dana, van Ginneken, Nayar, Koenderink 1999): 61 real-world surfaces at 205 pairs of directions.

``abrdf.dat`` holds a row a sample, its number and then f_r averaged over R, G and B, with three decimals; ``table.txt``
beside it the directions, ``k theta_v phi_v theta_i phi_i`` in radians, in rows numbered from 1.  Equal azimuths are
backscatter.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from motes import directions
from motes.errors import FormatError
from motes.files import reading
from motes.measurements import policy
from motes.measurements.measurement import Measurement

NAME = "curet"
SOURCE = "in the layout of the CUReT database (Dana, van Ginneken, Nayar, Koenderink, ACM TOG 18(1), 1999)"
VALUES, TABLE = "abrdf.dat", "table.txt"
FULL_ROW = 206  # a sample number and 205 values


def sniff(path: Path, head: bytes) -> bool:
    if path.is_dir():
        return (path / VALUES).is_file()
    tokens = head.lstrip().partition(b"\n")[0].decode("ascii", errors="replace").split()
    if len(tokens) < 2 or not tokens[0].isdigit():
        return False
    try:
        [float(t) for t in tokens]
    except ValueError:
        return False
    return len(tokens) == FULL_ROW or (path.parent / TABLE).is_file()


def samples(path: Path) -> list[str]:
    """The numbers of the samples, as text."""
    return [str(n) for n in _rows(_values_file(path))]


def read_curet(path: Path, *, sample: int | str | None = None) -> Measurement:
    """One sample.

    Parameters
    ----------
    path
        ``abrdf.dat``, or the folder that holds it.
    sample
        The number in the first column; may be left out where there is one row.
    """
    file = _values_file(path)
    rows = _rows(file)
    if sample is None and len(rows) == 1:
        sample = next(iter(rows))
    available = ", ".join(str(n) for n in rows)
    number = reading.integer(str(sample).strip()) if sample is not None else None
    if number not in rows:
        what = f"has {len(rows)} samples" if sample is None else f"has no sample {sample!s:.40}"
        raise FormatError(f"{file} {what}", f"Choose one with --sample: {available}")
    table = _table(file.parent / TABLE)
    values = reading.numbers(rows[number], f"{file}, sample {number}")
    reading.require(
        len(values) == len(table),
        f"{file}, sample {number} has {len(values)} values for the {len(table)} directions of {TABLE}",
        "The row is cut short, or the two files do not belong together",
    )
    theta_v, phi_v, theta_i, phi_i = table.T
    wi, wo = directions.from_spherical(theta_i, phi_i), directions.from_spherical(theta_v, phi_v)
    clipped = policy.clipped(wi, wo, values[None, :, None])
    provenance: dict[str, Any] = {
        "format": NAME,
        "path": str(path),
        "sample": str(number),
        "name": f"CUReT sample {number}",
        "source": SOURCE,
        "notes": [
            "f_r in 1/sr, averaged over red, green and blue, printed with three decimals",
            "Glossy samples can be clipped; averaged over channels, clipping leaves no plateau to know it by",
        ],
    }
    return Measurement.from_arrays(wi, wo, values, provenance=provenance, reasons={policy.CLIPPED: clipped})


def _values_file(path: Path) -> Path:
    """``abrdf.dat``, whichever of the folder and its two files was named."""
    if path.name == TABLE:
        path = path.parent
    return path / VALUES if path.is_dir() else path


def _rows(file: Path) -> dict[int, list[str]]:
    """Sample number -> its values, as text."""
    rows: dict[int, list[str]] = {}
    for number, line in enumerate(reading.text(file).splitlines(), 1):
        tokens = line.split()
        if not tokens:
            continue
        sample = reading.integer(tokens[0])
        reading.require(
            sample is not None and len(tokens) > 1,
            f"{file}, line {number} starts with {line.strip()[:30]!r}, not a sample number and values",
            "Rows are: sample v1 .. v205",
        )
        assert sample is not None
        reading.require(sample not in rows, f"{file}, line {number} repeats sample {sample}", "Each sample has one row")
        rows[sample] = tokens[1:]
    reading.require(bool(rows), f"{file} holds no sample", "Rows are: sample v1 .. v205")
    return rows


def _table(path: Path) -> np.ndarray:
    """theta_v, phi_v, theta_i, phi_i (N, 4), in the order of the values."""
    if not path.is_file():
        raise FormatError(
            f"{path} is missing: it holds the directions of {VALUES}", f"Put CUReT's {TABLE} beside {VALUES}"
        )
    lines = [line.split() for line in reading.text(path).splitlines() if line.strip()]
    for number, tokens in enumerate(lines, 1):
        reading.require(
            len(tokens) == 5,
            f"{path}, row {number} has {len(tokens)} numbers, not 5",
            "Rows are: k theta_v phi_v theta_i phi_i",
        )
    reading.require(bool(lines), f"{path} is empty", "Rows are: k theta_v phi_v theta_i phi_i")
    table = reading.numbers([t for tokens in lines for t in tokens], str(path)).reshape(-1, 5)
    order = np.argsort(table[:, 0], kind="stable")
    reading.require(
        bool(np.array_equal(table[order, 0], np.arange(1, len(table) + 1))),
        f"{path}: the first column is not the numbers 1 to {len(table)}",
        "Rows are: k theta_v phi_v theta_i phi_i, one for each k",
    )
    reading.require(bool(np.all(np.isfinite(table))), f"{path} holds an angle that is not a number", "Check the file")
    return table[order, 1:]
