"""What Motes does with invalid measurements: it masks them, counts them, says so, and never changes them.

Every reader hands its samples to `Measurement.from_arrays`, which applies these rules once, in this order.  A sample is
counted under the first rule that it breaks, so the counts add up to the number of masked samples.

1. *Reasons of the reader's own* are masked under its words: ``not measured in this scan``; ``negative (out of gamut)``
   (RGL, MBSDF); ``negative (invalid bin)`` (MERL); ``clipped at the ceiling`` (CUReT, TVBRDF, CSV; see `clipped`).
2. *A direction at or below the horizon* is masked: ``wi`` or ``wo`` has cos(theta) <= 0, where a BRDF is not defined.
3. *NaN and infinite* values are masked.
4. *Negative* values are masked: no surface reflects less than nothing; it is noise, a bad calibration or a marker.
5. *Excluded by the caller*: the ``mask`` given to `from_arrays`, and `Measurement.with_mask`.

Values of exactly 0 are kept: a dark sample is a sample.

A direction whose length is off by more than 0.001 is an error that names its row, for nothing tells which of the
components is wrong; smaller deviations, from printed digits, are normalised away.

A measurement with every sample masked is no error here: it can be looked at.  A fit refuses it.

The values stay as read, also where they are masked: nothing is clamped or filled in.  Nothing is left out either, but
for the parts of the MERL and RGL grids that lie below the horizon by construction (a quarter of a MERL table); they are
counted in ``provenance["dropped"]``.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.errors import DataError

BELOW_HORIZON = "direction at or below the horizon"
NOT_FINITE = "not a finite number"
NEGATIVE = "negative"
EXCLUDED = "excluded by the caller"
CLIPPED = "clipped at the ceiling"
NOT_MEASURED = "not measured in this scan"

NORM_TOLERANCE = (
    1e-3  # three decimals survive in any sensible text file; a larger deviation is another quantity or a typing error
)


def unit_directions(w: ArrayLike, label: str) -> NDArray[np.float64]:
    """Directions (N, 3) as float64 unit vectors.

    Raises
    ------
    DataError
        Naming the first row whose length differs from 1 by more than 0.001, or is not a number.
    """
    try:
        w = np.array(w, np.float64)
    except (TypeError, ValueError) as error:
        raise DataError(
            f"{label} is not an array of numbers: {error}", "Give unit vectors as an array of shape (N, 3)"
        ) from None
    if w.ndim != 2 or w.shape[1] != 3 or len(w) == 0:
        raise DataError(f"{label} has shape {w.shape}, not (N, 3) with at least one row", "Give one unit vector a row")
    with np.errstate(over="ignore", invalid="ignore"):
        norm = np.sqrt(np.einsum("ni,ni->n", w, w))
        bad = ~(np.abs(norm - 1) <= NORM_TOLERANCE)
    if bad.any():
        row = int(np.argmax(bad))
        vector = ", ".join(f"{x:.6g}" for x in w[row])
        raise DataError(
            f"{label} in row {row} is ({vector}), of length {norm[row]:.6g} instead of 1 "
            f"({int(bad.sum())} of {len(w)} rows are off)",
            f"Directions are unit vectors away from the surface; a deviation up to {NORM_TOLERANCE} is normalised away",
        )
    w /= norm[:, None]
    return w


def judge(
    wi: NDArray[np.float64],
    wo: NDArray[np.float64],
    values: NDArray[np.float64],
    mask: NDArray[np.bool_] | None,
    reasons: Mapping[str, ArrayLike] | None,
) -> tuple[NDArray[np.uint8], tuple[str, ...]]:
    """Why each sample (T, N, C) is masked: 0 where it is usable, else 1 + the reason's place in the names returned."""
    codes = np.zeros(values.shape, np.uint8)
    names: list[str] = []

    def exclude(name: str, where: ArrayLike) -> None:
        where = np.broadcast_to(np.asarray(where, bool), values.shape)
        names.append(name)
        if where.any():
            codes[where & (codes == 0)] = len(names)

    for name, where in (reasons or {}).items():
        exclude(name, where)
    exclude(BELOW_HORIZON, ((wi[:, 2] <= 0) | (wo[:, 2] <= 0))[None, :, None])
    exclude(NOT_FINITE, ~np.isfinite(values))
    exclude(NEGATIVE, values < 0)
    if mask is not None:
        exclude(EXCLUDED, ~mask)
    return codes, tuple(names)


def clipped(wi: NDArray[np.float64], wo: NDArray[np.float64], values: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Samples (T, N, C) that sit on a plateau at the maximum of their time and channel: the sensor's ceiling.

    A plateau is called clipping when at least three *different* geometries share exactly the maximum, twice as many as
    share any of the ten next lower values, and the maximum is at least three times the median.  Geometries that
    isotropy and reciprocity make equal (mirror images, any azimuth at normal incidence, wi and wo swapped) count once:
    a noise-free simulation repeats its values there without any clipping.  The last two conditions spare rounded data
    of matte surfaces, which repeat every value.  A sensor that saturates once or twice is not found.
    """
    # one number a geometry, so that the repeats of one can be told from a plateau
    cosines = np.sort(np.stack([wi[:, 2], wo[:, 2]]), axis=0)
    key = np.round(np.stack([*cosines, np.einsum("ni,ni->n", wi, wo)], axis=1), 5)
    result = np.zeros(values.shape, bool)
    for t in range(values.shape[0]):
        for c in range(values.shape[2]):
            v = values[t, :, c]
            usable = np.isfinite(v) & (v > 0)
            if usable.sum() < 10:
                continue
            top = v[usable].max()
            if np.count_nonzero(v == top) < 3 or top < 3 * np.median(v[usable]):
                continue
            levels = np.unique(v[usable])[-11:]
            counts = [len(np.unique(key[v == level], axis=0)) for level in levels]
            if counts[-1] >= 3 and counts[-1] >= 2 * max(counts[:-1], default=1):
                result[t, :, c] = v == top
    return result
