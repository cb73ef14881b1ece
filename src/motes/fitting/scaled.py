"""Data in units that nobody knows: the factor between them and a BRDF, fitted or held.

K_d and K_s carry a factor of the data, but light between facets (equation (7)) goes with the square of K_d: data that are three times too
bright make sigma_d wrong, too.  Where the factor is known it divides the data beforehand (`Measurement.rescaled`).  Where it is
not, it is one more parameter of the fit, ``scale``, and K_d stays at 1 or below: no facet returns more than it receives.  The
data of a result are in its units, and so is its material, which knows of no factor.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import ClassVar, final

import numpy as np

from motes.arrays import Array
from motes.directions import Geometry
from motes.errors import DataError
from motes.fitting.losses import Floats
from motes.fitting.quantities import Quantity
from motes.fitting.result import Fit, FittedParameter
from motes.fitting.verdicts import Verdict
from motes.measurements import Measurement
from motes.models import BRDF
from motes.models.components import Component
from motes.models.standard import StandardLobe
from motes.parameters import Place, Role, parameter, part

#: Of the parameter, and what to write for it.
NAME, FREE = "scale", "fit"
# What the mean of data is brought to before their scale is fitted: a surface of middle brightness.
MIDDLE = 0.5
# Scans of a series whose scale is fitted.
SCANS = 3


@final
@dataclass(frozen=True, eq=False)
class Scaled(BRDF):
    """What an instrument of unknown units reads of a base: ``scale`` times its BRDF.  No material: a fit's result has the base."""

    approximation: ClassVar[str] = ""

    base: BRDF = part(BRDF, place=Place.BASE)
    scale: Array = parameter(
        1.0,
        bounds=(0, float("inf")),
        typical=(0.2, 5),
        starts=(0.5, 1.0, 2.5),
        symbol="s",
        doc="the data, divided by the BRDF",
    )

    @property
    def reciprocal(self) -> bool:  # type: ignore[override]
        return self.base.reciprocal

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return self.scale * self.base.formula(xp, geometry)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return self.base.components(xp, cos_theta_i)

    def standard_lobes(self, xp: Array, values: Scaled, cos_view: Array) -> list[StandardLobe]:
        return [lobe.scaled(values.scale) for lobe in self.base.standard_lobes(xp, values.base, cos_view)]

    def in_words(self) -> str:
        return self.base.in_words()


def physical(q: Quantity) -> Quantity:
    """A quantity of a model whose data have a scale of their own: what facets reflect is 1 at most."""
    low, high = q.parameter.fit_bounds
    if q.parameter.role is not Role.DIFFUSE_COLOUR:
        return q
    return q._replace(parameter=replace(q.parameter, fit_bounds=(low, min(high, 1.0))))


def known(data: Measurement, scale: float) -> Measurement:
    """The data over a scale that is known."""
    if not (np.isfinite(scale) and 1e-9 <= scale <= 1e9):
        raise DataError(f"scale = {scale:g} is outside [1e-9, 1e9]", "It is what the data are divided by: 1 for a BRDF")
    return data.rescaled(float(scale))


def middling(data: Measurement) -> Measurement:
    """The data, roughly brought to a BRDF's size, where a fit of the scale begins."""
    used = data.values[data.mask]
    mean = float(used.mean()) if used.size else 0.0
    if not mean > 0:
        raise DataError(
            f"the mean of the {used.size} usable samples is {mean:.3g}, which tells no scale", "Look at motes info DATA"
        )
    return data.rescaled(np.pi * mean / MIDDLE)


def in_units(
    found: FittedParameter, covariance: Floats, data: Measurement
) -> tuple[FittedParameter, Floats, Measurement]:
    """A fitted scale, the covariance matrix whose last row is its own, and the data: in units of the file, and over the scale."""
    before = float(data.provenance[NAME])
    factor = np.ones(len(covariance))
    factor[-1] = before
    ends = {level: both * before for level, both in found.intervals.items()}
    whole = replace(found, value=found.value * before, stderr=found.stderr * before, intervals=ends)
    stderr = float(found.stderr) if np.isfinite(found.stderr) else None
    return whole, covariance * np.outer(factor, factor), data.rescaled(float(found.value), stderr)


def of_scans(data: Measurement, fitted: Callable[[Measurement], Fit]) -> Measurement:
    """A series over the scale that some of its scans tell alone, all of them together; its error is one that all samples share.

    Raises
    ------
    DataError
        When none of them tells it.
    """
    usable = np.flatnonzero(data.mask.any(axis=(1, 2)))
    looked_at = (
        {int(usable[k]) for k in np.linspace(0, len(usable) - 1, SCANS).round().astype(int)} if len(usable) else ()
    )
    refusal: DataError | None = None
    inverses: list[float] = []
    errors: list[float] = []
    for t in sorted(looked_at):
        try:
            found = fitted(data.at(t)).parameters[NAME]
        except DataError as error:
            refusal = error
            continue
        if found.verdict in (Verdict.IDENTIFIED, Verdict.WEAK) and np.isfinite(found.stderr):
            # Light between facets is (scale K_d)^2 / scale: the data are linear in the inverse, so that is what averages.
            inverses.append(1 / float(found.value))
            errors.append(float(found.stderr) / float(found.value) ** 2)
    if not inverses:
        raise refusal or DataError(
            "no scan tells the scale of the data: nothing of the model changes its shape with how bright it is",
            "Write it: --scale 3 divides the data by 3",
        )
    weights = np.array(errors) ** -2.0
    inverse = float(np.average(inverses, weights=weights))
    # Scans that disagree by more than their errors say how sure it is.
    spread = np.sqrt(np.average((np.array(inverses) - inverse) ** 2, weights=weights) / max(len(inverses) - 1, 1))
    before = float(data.provenance.get(NAME, 1.0))  # fits say the scale of the file
    scale = 1 / inverse / before
    stderr = max(float(weights.sum() ** -0.5), float(spread)) / inverse**2 / before
    common = min(float(np.hypot(stderr / scale, data.common_uncertainty or 0.0)), 0.99)
    return data.rescaled(scale, stderr).with_uncertainties(common=common)
