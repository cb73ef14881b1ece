"""Cornell ``.brdf`` (Program of Computer Graphics): spectral goniometer measurements of paints.

``#`` comments; the number of wavelengths; the wavelengths in nm; then rows ``theta_i phi_i theta_s phi_s v1 .. vn`` in
radians.  phi_s = +-pi is the specular side.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from motes import directions
from motes.errors import FormatError
from motes.files import reading
from motes.measurements.measurement import Measurement

NAME = "cornell"
SOURCE = "in the layout of the reflectance data of the Cornell University Program of Computer Graphics"
MOST_WAVELENGTHS = 10_000


def sniff(path: Path, head: bytes) -> bool:
    if path.is_dir() or b"\0" in head:
        return False
    lines = [line.partition("#")[0].split() for line in head.decode("utf-8", errors="replace").splitlines()]
    data = [tokens for tokens in lines if tokens]
    return len(data) >= 1 and len(data[0]) == 1 and reading.integer(data[0][0]) is not None


def read_cornell(path: Path) -> Measurement:
    """The measurement, all wavelengths as channels."""
    comments: list[str] = []
    tokens: list[str] = []
    for line in reading.text(path).splitlines():
        data, hash_sign, comment = line.partition("#")
        tokens += data.split()
        if hash_sign and comment.strip() and not tokens:
            comments.append(comment.strip())
    comments = [c for c in comments if not c.lower().startswith(("num wl", "wls"))]
    title = next((c for c in comments if "cornell" not in c.lower()), path.stem)
    n = reading.integer(tokens[0]) if tokens else None
    if n is None or not 1 <= n <= MOST_WAVELENGTHS:
        found = f"{tokens[0][:40]!r}" if tokens else "nothing"
        raise FormatError(
            f"{path} starts with {found}, not the number of wavelengths (1 to {MOST_WAVELENGTHS})", "Check the file"
        )
    reading.require(
        len(tokens) > 1 + n,
        f"{path} is truncated: {n} wavelengths announced, {len(tokens) - 1} numbers follow",
        "Fetch the file again",
    )
    numbers = reading.numbers(tokens[1:], str(path))
    wavelengths, rows = numbers[:n], numbers[n:]
    reading.require(
        bool(np.all(np.isfinite(wavelengths)) and np.all(np.diff(wavelengths) > 0) and wavelengths[0] > 0),
        f"{path}: the {n} wavelengths are not positive and increasing: {wavelengths[:4].tolist()}, ...",
        "They follow their number, in nm",
    )
    reading.require(
        len(rows) % (n + 4) == 0,
        f"{path} is truncated or has ragged rows: {len(rows)} numbers are no multiple of 4 angles + {n} values",
        "Rows are: theta_i phi_i theta_s phi_s v1 .. vn",
    )
    rows = rows.reshape(-1, n + 4)
    angles, values = rows[:, :4], rows[:, 4:]
    bad = ~np.all(np.isfinite(angles) & (np.abs(angles) <= 7), axis=1)
    if bad.any():
        row = int(np.argmax(bad))
        raise FormatError(
            f"{path}, sample {row + 1}: {angles[row].tolist()} are not angles in radians", "Rows start with four angles"
        )
    notes = ["f_r in 1/sr"]
    zeros = int(np.count_nonzero(values == 0))
    if zeros:
        notes.append(
            f"{zeros} of {values.size} values are exactly 0: where the source measured nothing above its noise"
        )
    return Measurement.from_arrays(
        directions.from_spherical(angles[:, 0], angles[:, 1]),
        directions.from_spherical(angles[:, 2], angles[:, 3]),
        values,
        wavelengths=wavelengths,
        provenance={
            "format": NAME,
            "path": str(path),
            "name": title,
            "source": SOURCE,
            "comments": comments,
            "notes": notes,
        },
    )
