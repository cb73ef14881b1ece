"""Whether what a fit found can be: sentences for people, after the fit.

Nothing here changes a number.  Each finding says what was seen and, where there is one, the option that would mend it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.arrays import any_last
from motes.directions import from_spherical, theta
from motes.fitting.grazing import missing_fresnel
from motes.fitting.result import Fit
from motes.fitting.time_result import TimeFit
from motes.fitting.verdicts import Verdict
from motes.measurements.table import NAME as TABLE
from motes.models import BRDF
from motes.parameters import Role

Floats = NDArray[np.float64]

POOR = 0.3  # relative RMS: beyond it a model misses much of a measurement
FEW, MOST, FEWEST = 0.1, 0.8, 20  # a tenth of the directions with most of the squared residuals, of as many at least
SURE = 2.0  # standard errors that a parameter must lie beyond its range
BRIGHT = 1.02  # directional albedo; the quadrature is good to a thousandth
# A coarse quadrature, good to a few hundredths, settles the matter where it finds less than this share of that.
ROUGH, CLEARLY = (8, 8), 0.8
BACKWARD = -0.3  # mean cosine of dust; what is known of real dust is above 0
STEEP = math.radians(10)  # from the normal: cameras and lamps within see no roughness
MANY_CHANNELS = 64  # beyond them the albedo is not integrated
SCATTER = (0.3, 3.0)  # reduced chi-square that uncertainties and residuals agree within


def implausible_fit(fit: Fit | TimeFit) -> tuple[str, ...]:
    """What is odd about a fit, the most important first; empty when nothing is."""
    found: list[str] = []
    for check in (_poor, _untold_scale, _beyond, _albedo, _backward, _unseen_roughness, missing_fresnel, _chi_square):
        found += check(fit)
    return tuple(found)


def _poor(fit: Fit | TimeFit) -> list[str]:
    share, chi = fit.metrics.get("relative_rms", math.nan), fit.metrics.get("reduced_chi_square", math.inf)
    if not share > POOR or chi < SCATTER[1]:
        return []
    other = "" if len(fit.tried) > 1 else " --model auto tries others."
    size = f"{share:.0%}" if share < 100 else f"{share:.0e} times the values"
    few = _few_carry_it(fit)
    if few and fit.robust != "none":
        return [f"{few} (relative RMS {size}); {fit.robust} lets them count less. The report shows where they are."]
    outliers = (
        f" {few}: the report shows where. If they are mistakes of the measurement, --robust cauchy lets them count less."
        if few
        else ""
    )
    return [
        f"The model misses much of the measurement: relative RMS {size}. Its parameters and their errors describe the model and not the "
        f"surface.{other}{outliers}"
    ]


def _few_carry_it(fit: Fit | TimeFit) -> str:
    """Where most of the misfit lies at a few directions, which may be mistakes of the measurement."""
    if not isinstance(fit, Fit):
        return ""
    squares = np.sort(np.nansum(fit.residuals**2, axis=1))[::-1]
    measured = int(fit.measurement.mask[0].any(axis=1).sum())
    few = math.ceil(FEW * measured)
    share = float(squares[:few].sum() / max(squares.sum(), 1e-300))
    return (
        f"{few} of {measured} directions make {share:.0%} of the squared residuals"
        if measured >= FEWEST and share >= MOST
        else ""
    )


def _untold_scale(fit: Fit | TimeFit) -> list[str]:
    """A scale that was to be fitted, and that nothing in the data tells."""
    scale = fit.parameters.get("scale") if isinstance(fit, Fit) else None
    if scale is None or scale.verdict is not Verdict.UNIDENTIFIABLE:
        return []
    names = [slot.name for slot in fit.brdf.slots(Role.DIFFUSE_COLOUR, Role.HIGHLIGHT_STRENGTH)]
    return [
        f"The data do not tell their scale, so {' and '.join(names) or 'brightness'} {'are' if len(names) > 1 else 'is'} known up to a factor only. "
        "Where it is known, write it: --scale 3 divides the data by 3."
    ]


def _values(fit: Fit | TimeFit, role: Role) -> Iterator[tuple[str, Floats, Floats]]:
    """Name, values and errors (T, W) of the fitted parameters of a role."""
    for slot in fit.brdf.slots(role):
        if isinstance(fit, Fit):
            p = fit.parameters.get(slot.name)
            if p is not None and p.verdict is not Verdict.FIXED:
                yield slot.name, np.atleast_2d(np.asarray(p.value, float)), np.atleast_2d(np.asarray(p.stderr, float))
        elif slot.name in fit.trends:
            value, error = fit.trends[slot.name].band(fit.hours)
            yield slot.name, value, np.broadcast_to(error, value.shape)


def _beyond(fit: Fit | TimeFit) -> list[str]:
    """Colours and albedos above 1."""
    found = []
    for role, what in (
        (Role.DIFFUSE_COLOUR, "a surface that returns more than it receives"),
        (Role.SINGLE_SCATTERING_ALBEDO, "particles that scatter more than they receive"),
    ):
        for name, value, error in _values(fit, role):
            excess = value - SURE * np.nan_to_num(error, nan=0.0)
            if not np.nanmax(excess, initial=-1) > 1:
                continue
            t, c = (int(k) for k in np.unravel_index(np.nanargmax(excess), value.shape))
            channels = fit.material.channels
            label = f"{name}[{channels[c]}]" if value.shape[1] == len(channels) > 1 else name
            rough = [slot.name for slot in fit.brdf.slots(Role.DIFFUSE_ROUGHNESS)]
            biased = (
                f" If their scale is wrong, so is {rough[0]}, for light between facets goes with the square of {name}: --scale fit finds it."
                if rough and role is Role.DIFFUSE_COLOUR
                else ""
            )
            found.append(
                f"{label} = {value[t, c]:.3g} is above 1: {what}. Look at the scale and the units of the data, or at another model.{biased}"
            )
    return found


def _albedo(fit: Fit | TimeFit) -> list[str]:
    """More light out than in, the highlight included."""
    if len(fit.material.channels) > MANY_CHANNELS:
        return []
    hours = (0.0,) if isinstance(fit, Fit) else (float(fit.hours[0]), float(fit.hours[-1]))
    degrees = (5.0, 30.0, 60.0)
    wi = from_spherical(np.radians(degrees), 0.0)
    worst, at = 0.0, 0.0
    for hour in hours:
        brdf = fit.material.brdf if isinstance(fit, Fit) else fit.material.at(hour)
        assert isinstance(brdf, BRDF)
        albedo = np.asarray(brdf.directional_albedo(wi, nodes=ROUGH), float).max(axis=-1)
        if np.isfinite(albedo).all() and albedo.max() < CLEARLY * BRIGHT:
            continue
        albedo = np.asarray(brdf.directional_albedo(wi, nodes=(24, 32)), float).max(axis=-1)
        if np.isfinite(albedo).all() and albedo.max() > worst:
            worst, at = float(albedo.max()), degrees[int(np.argmax(albedo))]
    if worst <= BRIGHT:
        return []
    return [
        f"More light out than in: the fitted material returns {worst:.3g} times the light that comes from {at:.0f} degrees. "
        "Look at the scale and the units of the data."
    ]


def _backward(fit: Fit | TimeFit) -> list[str]:
    """A layer that scatters back to the lamp; powders with an opposition surge do, and are no layer."""
    if fit.brdf.slots(Role.SURGE_STRENGTH) and not fit.brdf.slots(Role.DEPTH):
        return []
    for name, value, error in _values(fit, Role.ASYMMETRY):
        lowest = float(np.nanmin(value + SURE * np.nan_to_num(error, nan=0.0)))
        if lowest < BACKWARD:
            table = fit.measurement.provenance.get("format") == TABLE
            turn = " --read azimuth=mirror reads a table whose azimuths count from the side of the mirror direction."
            return [
                f"{name} = {np.nanmin(value):.2g}: a layer that scatters back to the lamp is rare; a highlight on the wrong side looks like one, and so "
                f"does what a model lacks.{turn if table else ''}"
            ]
    return []


def _unseen_roughness(fit: Fit | TimeFit) -> list[str]:
    """A camera, or a lamp, that stays where the roughness of the diffuse part does nothing but darken."""
    data = fit.measurement
    used: Any = any_last(data.mask).any(axis=0)
    if not used.any():
        return []
    used = slice(None) if used.all() else used  # no copies of large data
    for name, _, _ in _values(fit, Role.DIFFUSE_ROUGHNESS):
        for what, w in (("viewer", data.wo[used]), ("light", data.wi[used])):
            farthest = float(theta(w[np.argmin(w[:, 2])]))
            if farthest < STEEP:
                return [
                    f"The {what} is within {math.degrees(farthest):.2g} degrees of the normal in all samples, where {name} does little but scale "
                    f"the diffuse colour: these data hardly tell the two apart. --fix {name}=0.3 holds one of them."
                ]
            alone = isinstance(fit, Fit) and fit.parameters[name].verdict is not Verdict.IDENTIFIED
            if alone and len(w) > 5 and np.ptp(w, axis=0).max() < 1e-3:
                return [
                    f"All samples have the same {what}, at {math.degrees(float(theta(w[0]))):.2g} degrees: one scan tells little of {name}. "
                    f"Measure with another {what} as well, or hold it: --fix {name}=0.3"
                ]
    return []


def _chi_square(fit: Fit | TimeFit) -> list[str]:
    chi = fit.metrics.get("reduced_chi_square", math.nan)
    if chi > SCATTER[1]:
        return [
            f"The residuals are {math.sqrt(chi):.2g} times the uncertainties of the data (reduced chi-square {chi:.3g}): the model does not "
            "follow the measurement within them, or they are too small."
        ]
    if chi < SCATTER[0]:
        return [
            f"The residuals are {math.sqrt(chi):.2g} times the uncertainties of the data (reduced chi-square {chi:.3g}): the uncertainties "
            "are larger than the scatter, as those of a common scale would be (--read common_uncertainty=0.02)."
        ]
    return []
