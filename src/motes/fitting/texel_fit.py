"""What comes of fits of many texels."""

from __future__ import annotations

from enum import IntEnum
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.fitting.texel_kernel import Singles
from motes.kernels.memory import empty


class TexelStatus(IntEnum):
    """How a texel's fit ended."""

    CONVERGED = 0
    MAX_ITERATIONS = 1
    NO_DATA = 2
    FAILED = 3


class TexelFit(NamedTuple):
    """Results by texel.

    Attributes
    ----------
    x, stderr
        Parameters and their standard errors (M, P), float32; NaN where there is no fit, or no error (at a bound, or not seen by the data).
    relative_rms
        Of the weighted residuals over that of the data (M,), float32.
    status, iterations
        (M,), uint8; see `TexelStatus`.
    verdicts
        What the data say about each parameter (M, P), uint8: positions in `motes.fitting.covariance.VERDICTS`; `NO_VERDICT` where there is no fit.
    covariance
        Packed lower triangles (M, P(P+1)/2), float32, NaN rows where there is no error; None where it was not asked for.
    """

    x: Singles
    stderr: Singles
    relative_rms: Singles
    status: NDArray[np.uint8]
    iterations: NDArray[np.uint8]
    verdicts: NDArray[np.uint8]
    covariance: Singles | None = None

    @classmethod
    def unfilled(cls, count: int, size: int, covariance: bool) -> TexelFit:
        """Arrays for so many texels, whose values are not set."""
        numbers, codes = [(count, size), (count, size), (count,)], [(count,), (count,), (count, size)]
        x, stderr, rms = (empty(shape, np.float32) for shape in numbers)
        status, iterations, verdicts = (empty(shape, np.uint8) for shape in codes)
        triangle = empty((count, size * (size + 1) // 2), np.float32) if covariance else None
        return cls(x, stderr, rms, status, iterations, verdicts, triangle)

    def fill(self, rows: slice, part: TexelFit) -> None:
        """Take over the results of some texels."""
        for column, found in zip(self, part, strict=True):
            own: Any = column
            if own is not None:
                own[rows] = found


def own_covariance(packed: Singles, stderr: Singles) -> Singles:
    """Of the parameters themselves, with their standard errors; NaN for what has none."""
    size = stderr.shape[1]
    rows, columns = np.tril_indices(size)
    diagonal = packed[:, rows == columns]
    with np.errstate(all="ignore"):
        factor = stderr / np.sqrt(diagonal)
        return (packed * factor[:, rows] * factor[:, columns]).astype(np.float32)
