r"""What a reading tells: derivatives of a model by its parameters, over the noise of the reading.

A reading r of a reflectance f with standard deviation s adds :math:`J^T J / s^2` to the information matrix of the parameters, J the row of
derivatives of f; its inverse bounds the covariance of every unbiased fit (Cramer, Rao), which the fits of Motes reach when data state
their noise.  Parameters are in the coordinates that a fit moves in (the square of a roughness whose sign means nothing), over
the range that real materials span, so that no unit counts for more than another.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import final

import numpy as np
from numpy.typing import NDArray

from motes.errors import MotesError
from motes.fitting.columns import Columns
from motes.fitting.quantities import Quantity, columns_for
from motes.fitting.setup import fitted_of
from motes.kernels.numpy import FitFunction, residual_function
from motes.models import BRDF, describe

Floats = NDArray[np.float64]


@final
@dataclass(frozen=True)
class Noise:
    """The noise of a reading.

    Parameters
    ----------
    relative
        One standard deviation over the value.
    floor
        One standard deviation of what does not go with the value, in f cos(theta_i) [1/sr]: of the detector.
    """

    relative: float = 0.02
    floor: float = 1e-4

    def __post_init__(self) -> None:
        if not 0 < self.relative <= 1:
            raise MotesError(f"the noise is {self.relative:g}, outside (0, 1]", "0.02 is 2 % of each reading")
        if not 0 < self.floor < 1:
            raise MotesError(
                f"the floor of the noise is {self.floor:g}, outside (0, 1)", "0.0001 is a hundredth of a grey of 3 %"
            )

    def deviation(self, f: Floats, cos_theta_i: Floats) -> Floats:
        """One standard deviation of readings of reflectances `f`."""
        return np.hypot(self.relative * f, self.floor / np.maximum(cos_theta_i, 1e-3))


@final
@dataclass(frozen=True, eq=False)
class Subject:
    """A model whose parameters are to be found, in one channel: what is fitted of it, and the rest with its values.

    Several channels say the same of what they share, and each of its own parameters; each channel of a material is a material here.
    """

    brdf: BRDF
    quantities: tuple[Quantity, ...]

    @classmethod
    def of(cls, model: str | BRDF, fixed: tuple[str, ...] = ()) -> Subject:
        """From a model's text, in which values that are given are held, or a BRDF.

        Raises
        ------
        MotesError
            For a model that is unknown, or has no free parameter.
        """
        try:
            brdf, quantities, _ = fitted_of(model, 1, fixed, ())
        except MotesError as error:
            if "nothing to fit" in error.message:
                text = describe(model) if isinstance(model, BRDF) else model
                raise MotesError(
                    f"{text} has no free parameter, so that no direction tells anything of it",
                    "Leave out the values in brackets of those that are to be found",
                ) from None
            raise
        return cls(brdf, quantities)

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(q.name for q in self.quantities)

    @property
    def size(self) -> int:
        return len(self.quantities)

    @cached_property
    def columns(self) -> Columns:
        return columns_for(self.quantities)

    @cached_property
    def spans(self) -> Floats:
        """The width (P,) of the range that real materials span, in the coordinates of a fit."""
        return np.asarray(self.columns.span[:, 0], float)

    @cached_property
    def _function(self) -> FitFunction:
        squared = [q.name for q in self.quantities if q.parameter.squared]
        return residual_function(self.brdf, list(self.names), horizon=False, squared=squared)

    def coordinates(self, values: Floats) -> Floats:
        """Values (B, P) of the parameters in the coordinates of a fit."""
        return np.stack([q.coordinate(values[:, k]) for k, q in enumerate(self.quantities)], axis=1)

    def inside(self, values: Floats) -> Floats:
        """Values (B, P) moved into the bounds of a fit."""
        low, high = (np.array([q.parameter.fit_bounds[k] for q in self.quantities]) for k in (0, 1))
        return np.clip(values, low, high)

    def derivatives(self, values: Floats, wi: Floats, wo: Floats) -> tuple[Floats, Floats]:
        """Reflectances (B, N) of materials with values (B, P), and their derivatives (B, N, P) by the coordinates over their spans."""
        x = self.coordinates(values)
        given = {q.name: x[:, k, None, None] for k, q in enumerate(self.quantities)}
        held = {s.name: float(np.mean(np.asarray(s.value, float))) for s in self.brdf.slots() if s.name not in given}
        f, slopes = self._function.values_and_jacobian(self._function.geometry(wi, wo), {**given, **held})
        shape = (len(x), len(wi), 1)
        rows = np.concatenate([np.broadcast_to(slopes[name], shape) for name in self.names], axis=2) * self.spans
        return np.broadcast_to(f, shape)[..., 0], np.nan_to_num(rows, posinf=0.0, neginf=0.0)

    def rows(self, values: Floats, wi: Floats, wo: Floats, noise: Noise) -> Floats:
        """Rows (B, N, P) whose outer products are the information of each reading."""
        f, slopes = self.derivatives(values, wi, wo)
        return np.asarray(slopes / noise.deviation(f, wi[:, 2])[..., None])


def information(rows: Floats) -> Floats:
    """The information matrices (B, P, P) of rows (B, N, P)."""
    return np.asarray(np.swapaxes(rows, 1, 2) @ rows)
