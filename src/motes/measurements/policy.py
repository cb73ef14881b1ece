"""What Motes does with invalid measurements: it masks them, counts them, says so, and never changes them.

Every reader hands its samples to `Measurement.from_arrays`, which applies these rules once, in this order.  A sample is
counted under the first rule that it breaks, so the counts add up to the number of masked samples.

1. *Reasons of the reader's own* are masked under its words: ``not measured in this scan``; ``negative (invalid bin)``
   (MERL, whose negative values are markers); ``clipped at the ceiling`` (CUReT, TVBRDF, tables; see `clipped`).
   Cost: what a sensor clips is bright, so a highlight whose top is masked is fitted from its flanks.
2. *A direction at or below the horizon* is masked: ``wi`` or ``wo`` has a cosine of at most `directions.HORIZON`, where
   a BRDF is not defined.  Cost: none; 89.99994 degrees is the last angle kept.
3. *NaN and infinite* values are masked.  Cost: none if they are missing at random; a bias if they stand for values that
   were too bright or too dark to be read.  So are values beyond 1e9, which nothing reflects: a fit that starts among those
   of surfaces does not see what its parameters do to such data.
4. *Negative values are data* where noise explains them: a dark surface measured with noise reads below 0 as often as
   noise takes it there, and to leave those samples out would leave the upward noise only (a channel of K_d = 0.005
   under noise of 0.003/sr comes out as 0.009).  The same holds for colours outside the gamut of R, G and B (RGL, MBSDF):
   they are linear values like others.  Masked is only what cannot be a value: a marker such as -1 or -999, and what lies
   further below 0 than the scatter of its channel explains; see `impossible`.  Cost: a single faulty reading a little
   below 0 stays among the data, as one above 0 does; `robust=` makes both count less.
5. *Excluded by the caller*: the ``mask`` given to `from_arrays`, and `Measurement.with_mask`.  Cost: the caller's to
   know; a mask that looks at the values (``values > 0``) biases as described under 4.

Values of exactly 0 are kept: a dark sample is a sample.

A direction whose length is off by more than 0.001 is an error that names its row, for nothing tells which of the
components is wrong; smaller deviations, from printed digits, are normalised away.

A measurement with every sample masked is no error here: it can be looked at.  A fit refuses it.

The values stay as read, also where they are masked: nothing is clamped or filled in.  Nothing is left out either, but
for the parts of the MERL and RGL grids that lie below the horizon by construction (a quarter of a MERL table); they are
counted in ``provenance["dropped"]``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes import directions
from motes.errors import DataError

BELOW_HORIZON = "direction at or below the horizon"
NOT_FINITE = "not a finite number"
ABSURD = "beyond 1e9, which nothing reflects"
MARKER = "negative (a marker: the same number again and again, apart from the others)"
NEGATIVE = "negative beyond what noise explains"
EXCLUDED = "excluded by the caller"
CLIPPED = "clipped at the ceiling"
NOT_MEASURED = "not measured in this scan"

STEEPEST = 0.05  # a cosine, or product of two, that a reading is divided by; smaller ones explain no more noise
NOISE_WIDTHS = 5.0  # standard deviations of noise that a value may lie below 0; beyond them is 1 sample in 3,500,000
LARGEST = 1e9  # [1/sr]; the highlight of a facet roughness of 0.0001 has 1e8, counts of a camera have 1e5
FEWEST = 10  # samples that tell their scatter, or that are not all negative by chance

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
    except (TypeError, ValueError, OverflowError) as error:
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
    uncertainties: NDArray[np.float64] | None = None,
    channels: Sequence[str] = (),
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
    exclude(BELOW_HORIZON, ~directions.above(wi, wo)[None, :, None])
    exclude(NOT_FINITE, ~np.isfinite(values))
    with np.errstate(invalid="ignore"):
        exclude(ABSURD, np.abs(values) > LARGEST)
        negative = values < 0
    if negative.any():
        marker, beyond = impossible(wi, wo, np.where(codes == 0, values, np.nan), uncertainties, channels)
        exclude(MARKER, marker)
        exclude(NEGATIVE, beyond)
    if mask is not None:
        exclude(EXCLUDED, ~mask)
    return codes, tuple(names)


def impossible(
    wi: NDArray[np.float64],
    wo: NDArray[np.float64],
    values: NDArray[np.float64],
    uncertainties: NDArray[np.float64] | None = None,
    channels: Sequence[str] = (),
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Negative samples (T, N, C) that cannot be values: markers, and those beyond what noise explains.

    Parameters
    ----------
    wi, wo
        Unit vectors (N, 3).
    values
        (T, N, C) [1/sr]; NaN where a sample is masked already.
    uncertainties
        (T, N, C), standard deviations [1/sr], NaN where unknown; or None.
    channels
        Their names.

    Notes
    -----
    A *marker* is the lowest value of its time and channel where at least three samples share exactly it, twice as many
    as share any of the next ten levels: noise that is rounded to few digits has its fewest samples at the end.

    *Noise explains* a value down to `NOISE_WIDTHS` times its uncertainty, or times the scatter of its time and channel,
    whichever is more.  The scatter is an upper bound, from the positive samples: noise about 0 of the standard deviation
    s has positive samples of the median 0.6745 s, whose absolute deviation from it has the median 0.40 s; the signal
    makes both larger.  The smaller of the two bounds counts, but no less than the step between rounded values.  An
    instrument divides its reading, whose noise is even, by neither cosine, one of them or both: the largest bound of the
    four counts.  Of R, G and B one may also be as far below 0 as another is above it at the same directions: a saturated
    colour outside the gamut.  A channel of ten samples or more without a positive one is no noise about 0.
    """
    marker, beyond = np.zeros(values.shape, bool), np.zeros(values.shape, bool)
    gamut = np.fmax.reduce(values, axis=2) if tuple(channels) == ("R", "G", "B") else np.zeros(values.shape[:2])
    shapes = [np.maximum(shape, STEEPEST) for shape in (1 + 0 * wi[:, 2], wi[:, 2], wo[:, 2], wi[:, 2] * wo[:, 2])]
    for t in range(values.shape[0]):
        for c in range(values.shape[2]):
            v = values[t, :, c]
            below = v < 0
            if not below.any():
                continue
            levels, counts = np.unique(v[np.isfinite(v)], return_counts=True)
            if counts[0] >= 3 and counts[0] >= 2 * max(counts[1:11], default=1):
                marker[t, :, c] = v == levels[0]
            bright = v > 0
            if not bright.any():  # nothing to measure the noise by; noise about 0 has both signs
                beyond[t, :, c] = below & (int(below.sum()) >= FEWEST)
                continue
            step = float(np.min(np.diff(levels[levels > 0], prepend=0.0)))  # of rounded values
            limit = NOISE_WIDTHS * np.maximum(
                np.max([_scatter((v * shape)[bright]) / shape for shape in shapes], axis=0), step
            )
            if uncertainties is not None:
                limit = np.fmax(limit, NOISE_WIDTHS * uncertainties[t, :, c])
            beyond[t, :, c] = below & (-v > np.fmax(limit, gamut[t]))
    return marker, beyond


def _scatter(positive: NDArray[np.float64]) -> float:
    """An upper bound of the standard deviation of the noise, from the samples above 0; see `impossible`."""
    middle = float(np.median(positive))
    scatter = middle / 0.6745
    if len(positive) >= FEWEST:
        scatter = min(scatter, float(np.median(np.abs(positive - middle))) / 0.40)
    return scatter


def _differ(v: NDArray[np.float64], top: float, key: NDArray[np.float64]) -> bool:
    """Whether nearly each geometry below the maximum has a value of its own, as numbers that are not rounded have."""
    below = np.isfinite(v) & (v < top)
    return len(np.unique(v[below])) >= max(10.0, 0.95 * len(np.unique(key[below], axis=0)))


def clipped(wi: NDArray[np.float64], wo: NDArray[np.float64], values: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Samples (T, N, C) that sit on a plateau at the maximum of their time and channel: the sensor's ceiling.

    A plateau is called clipping when at least three *different* geometries share exactly the maximum, twice as many as
    share any of the ten next lower values, and the maximum is at least three times the median, or hardly a value below it
    stands twice.  Geometries that isotropy and reciprocity make equal (mirror images, any azimuth at normal incidence, wi
    and wo swapped) count once: a noise-free simulation repeats its values there without any clipping.  The last two
    conditions spare rounded data of matte surfaces, which repeat every value.  A sensor that saturates once or twice is not found.
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
            if np.count_nonzero(v == top) < 3 or not (top >= 3 * np.median(v[usable]) or _differ(v, top, key)):
                continue
            levels = np.unique(v[usable])[-11:]
            counts = [len(np.unique(key[v == level], axis=0)) for level in levels]
            if counts[-1] >= 3 and counts[-1] >= 2 * max(counts[:-1], default=1):
                result[t, :, c] = v == top
    return result
