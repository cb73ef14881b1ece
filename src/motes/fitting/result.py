"""`Fit`: what a fit returns: the material, error bars, residuals, and the reasons."""

from __future__ import annotations

import os
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Any, final

import numpy as np
from numpy.typing import NDArray

from motes import outlets
from motes.arrays import Array
from motes.material import Material
from motes.models import BRDF

if TYPE_CHECKING:
    from motes.measurements import Measurement


class Status(StrEnum):
    """Why a fit stopped."""

    CONVERGED = "converged: no step makes the residuals smaller"
    SMALL_STEP = "converged: the parameters no longer move"
    IDLE = "converged: the residuals hardly shrink any more"
    PERFECT = "converged: the residuals are zero to rounding"
    NO_PROGRESS = "stopped: the damping grew without finding a better point"
    MAX_ITERATIONS = "stopped: the iterations ran out before it converged"

    @property
    def ok(self) -> bool:
        """True when it converged."""
        return self.value.startswith("converged")


class Verdict(StrEnum):
    """What the data say about a parameter."""

    IDENTIFIED = "identified"
    WEAK = "weakly identified: its error is large, or values far away fit as well"
    UNIDENTIFIABLE = "unidentifiable: the data do not determine it"
    AT_LOWER = "at its lower bound"
    AT_UPPER = "at its upper bound"
    FIXED = "fixed"


@final
@dataclass(frozen=True)
class FittedParameter:
    """One parameter after a fit.

    ``value``, ``stderr`` and ``verdicts`` have an entry for each channel where the parameter was fitted per channel:
    arrays (C,) and a tuple of C; else a float, a float and a tuple of one.  ``stderr`` is one standard error (68 %),
    NaN where the data do not determine the parameter, where it sits at a bound, or where it was fixed."""

    name: str
    value: Array
    stderr: Array
    verdicts: tuple[Verdict, ...]
    symbol: str
    unit: str
    doc: str
    bounds: tuple[float, float]

    @property
    def verdict(self) -> Verdict:
        """The worst verdict over the channels."""
        order = list(Verdict)
        if Verdict.FIXED in self.verdicts:
            return Verdict.FIXED
        for verdict in (Verdict.UNIDENTIFIABLE, Verdict.AT_UPPER, Verdict.AT_LOWER, Verdict.WEAK):
            if verdict in self.verdicts:
                return verdict
        return order[0]


@final
@dataclass(frozen=True)
class Trial:
    """A model that was tried, as ``model="auto"`` compares them; the smallest ``bic`` is chosen.

    ``n_samples`` is smaller than the data's where large data were compared on an even part of them.
    """

    model: str
    n_parameters: int
    bic: float
    relative_rms: float
    objective: float
    status: Status
    chosen: bool
    n_samples: int


@final
@dataclass(frozen=True)
class Fit:
    """The result of `motes.fit`.

    Parameters
    ----------
    material
        The fitted material; ``fit.material.brdf`` is the BRDF.
    parameters
        By name, in the order of the model.
    labels, correlations, covariance
        Names of the free quantities (``K_d[R]``, ``sigma_d``, ...), their correlation and covariance matrices (P, P); NaN
        rows where undetermined.
    metrics
        ``relative_rms`` = RMS(f - r)/RMS(r), unweighted, over unmasked samples; ``rms_plain``, ``rms_linear``,
        ``rms_log``, ``rms_cube_root``: root mean squares of the residuals of each loss; ``objective`` (half the
        weighted sum of squares that was minimised), ``bic``, ``n_samples``, ``n_parameters``.
    status
        Why it stopped.
    tried
        The models compared.
    measurement
        The data, one time.
    predicted
        The fitted BRDF at the measured directions (N, C) [1/sr].
    loss, robust
        What was minimised.
    model_text
        The model as text.
    fixed
        Names of the parameters that were held.
    iterations, n_starts, seconds
        The effort.
    """

    material: Material
    parameters: dict[str, FittedParameter]
    labels: tuple[str, ...]
    correlations: NDArray[np.float64]
    covariance: NDArray[np.float64]
    metrics: dict[str, float]
    status: Status
    tried: tuple[Trial, ...]
    measurement: Measurement
    predicted: NDArray[np.float64]
    loss: str
    robust: str
    model_text: str
    iterations: int
    n_starts: int
    seconds: float

    @property
    def brdf(self) -> BRDF:
        """The fitted BRDF."""
        return self.material.brdf

    @property
    def residuals(self) -> NDArray[np.float64]:
        """Fitted less measured (N, C) [1/sr]; NaN where masked."""
        difference = self.predicted - self.measurement.values[0]
        return np.where(self.measurement.mask[0], difference, np.nan)

    def to_dict(self) -> dict[str, Any]:
        """Everything but the arrays over directions, as plain JSON values (NaN becomes None)."""
        from motes.fitting.tables import fit_to_dict

        return fit_to_dict(self)

    def table(self) -> list[dict[str, str]]:
        """The parameters as rows of text: name, channel, value, stderr, unit, verdict; digits follow the error."""
        from motes.fitting.tables import parameter_rows

        return parameter_rows(self)

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Write ``material.json``, ``fit.json`` and ``parameters.csv`` into `folder`; returns it."""
        from motes.fitting.tables import save_fit

        return save_fit(self, folder)

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Write a self-contained HTML report; returns its path."""
        return outlets.report("fit", self, path)
