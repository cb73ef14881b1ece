"""Materials as the formats of lighting hold them: one visible response, or CIE X, Y and Z."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from motes.drawing.colour import SRGB_TO_XYZ, channels_to_srgb
from motes.errors import DataError
from motes.exports.subject import Subject

Array = NDArray[np.float64]


def limits(subject: Subject) -> list[str]:
    """What became of the colours."""
    if subject.brdf.channels == 1:
        return []
    return ["The colours became CIE XYZ under equal-energy light, from linear sRGB."]


def matrix_of(subject: Subject) -> Array | None:
    """The matrix (C, 3) that makes X, Y and Z of the channels; None for one channel, which stays as it is.

    Raises
    ------
    DataError
        When the channels are neither one nor three nor a spectrum of the visible.
    """
    n, nm = subject.brdf.channels, subject.wavelengths
    if n == 1:
        return None
    if n != 3 and not (nm and min(nm) <= 480 and max(nm) >= 620):
        raise DataError(
            f"{subject.name} has {n} channels that are neither RGB nor a spectrum of the visible, and the format holds the "
            "visible or X, Y and Z",
            "csv and bird take any number of channels",
        )
    return np.asarray(channels_to_srgb(subject.channels, nm or None).matrix @ SRGB_TO_XYZ.T, np.float64)


def evaluator(subject: Subject) -> tuple[tuple[str, ...], Callable[[Array, Array], Array]]:
    """The names Y, or X, Y, Z, and the function that gives them (n, names) at directions [1/sr].

    Raises
    ------
    DataError
        See `matrix_of`.
    """
    matrix = matrix_of(subject)
    if matrix is None:
        return ("Y",), lambda wi, wo: np.asarray(subject.brdf.eval(wi, wo), np.float64)

    def xyz(wi: Array, wo: Array) -> Array:
        values: Array = np.maximum(np.asarray(subject.brdf.eval(wi, wo), np.float64) @ matrix, 0.0)
        return values

    return ("X", "Y", "Z"), xyz
