"""`motes.fit`: the way into fits of measurements."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from motes.directions import HALF_PI
from motes.errors import DataError, MotesError
from motes.fitting import scaled
from motes.fitting.error_bars import ERRORS
from motes.fitting.losses import loss_named, robust_named
from motes.fitting.nested import Found
from motes.fitting.origin_of_fit import origin_of
from motes.fitting.over_time import fit_over_time
from motes.fitting.result import Fit, Progress
from motes.fitting.setup import Wishes, uncertainties_of
from motes.fitting.static import fit_scan
from motes.fitting.time_result import TimeFit
from motes.measurements import Measurement
from motes.models import BRDF


def fit(
    data: Measurement,
    model: str | BRDF = "auto",
    *,
    loss: str = "linear",
    robust: str = "none",
    weights: str | ArrayLike = "measurement",
    fixed: Collection[str] | Mapping[str, Any] = (),
    per_channel: Collection[str] = (),
    max_theta: float | None = None,
    scale: float | str = 1.0,
    time: int | None = None,
    trends: str | Mapping[str, str] = "auto",
    errors: str = "auto",
    progress: Progress | None = None,
) -> Fit | TimeFit:
    """Fit a model to measured reflectance by bounded least squares.

    A measurement with one time gives a `Fit`.  One with several gives a `TimeFit`: every scan is fitted, and trends of the
    parameters over all scans together; ``time=`` picks one scan instead.

    Parameters
    ----------
    data
        The measurement; masked samples are left out.
    model
        Text such as ``"oren_nayar + torrance_sparrow"`` (values given in it are held, see `motes.models.parse`), a BRDF
        (the fit also starts from its values), or ``"auto"``: the simplest of the candidates that
        predicts directions left out of its fit as well as any; see `motes.fitting.judgement`.
    loss
        ``"linear"``, ``"plain"``, ``"log"`` or ``"cube_root"``; see `motes.fitting.losses`.
    robust
        ``"none"``, ``"soft_l1"``, ``"huber"`` or ``"cauchy"``: how far-off samples count less.  The noise is taken from
        the median residual of a plain fit.
    weights
        ``"measurement"`` for what comes with the data: inverse variances where they have uncertainties, else solid angles
        where the format has them; ``"uniform"``, or an array (N,) or (N, C).
    fixed
        Parameters to hold: names (at the model's values), or a mapping of names to values.
    per_channel
        Parameters to fit for each channel that are shared otherwise: ``["K_s"]`` for a coloured highlight (metals).
    max_theta
        Leave out samples with theta_i or theta_r beyond this [rad]; goniometers are least sure there (Ngan et al. 2005
        stopped at 80 degrees).
    scale
        What the data are divided by before all else: 1 where they are a BRDF in 1/sr.  ``"fit"`` where nobody knows: it is a parameter of the
        fit then, ``scale``, and K_d stays at 1 or below.  Of several times it is fitted to three scans, and its error is one that
        all samples share.
    time
        Which of the measurement's times to fit alone; None for all of them, with trends.
    trends
        For several times: ``"auto"`` chooses the kind of trend of each parameter by BIC; a mapping of names to kinds
        (`motes.trends.KINDS`) settles those.
    errors
        What error bars take as independent: ``"blocks"`` of directions, as residuals of a model that does not fit ask for;
        ``"independent"`` samples; or ``"auto"``: blocks, unless the measurement is simulated, has uncertainties, or is arrays
        that nothing is said of, and its residuals do not contradict that.  Or by another way: ``"bootstrap"``, the fit again to
        blocks that are drawn with replacement (errors and percentiles); ``"profile"``, intervals by the profile likelihood,
        which follow valleys that bend (one time only).  ``fit.errors`` says what it was, and why.
    progress
        Called with (done, total, what).

    Returns
    -------
    Fit, or TimeFit for several times

    Raises
    ------
    DataError
        When fewer samples are left than parameters, the data have no such time, or do not tell a scale that is to be fitted.
    ParameterError
        When the model or a name in it is not known.
    """
    given = {
        "loss": loss,
        "robust": robust,
        "weights": weights,
        "fixed": fixed,
        "per_channel": per_channel,
        "max_theta": max_theta,
        "scale": scale,
        "time": time,
        "trends": trends,
        "errors": errors,
    }
    return fit_beside(data, model, given, (), progress)


def fit_beside(
    data: Measurement,
    model: str | BRDF,
    given: Mapping[str, Any],
    below: Sequence[Found],
    progress: Progress | None = None,
) -> Fit | TimeFit:
    """`fit` with its arguments by name, and what fits of other models to the same samples of one time found; see `motes.fitting.nested`."""
    loss, robust, weights, fixed, per_channel = (
        given[name] for name in ("loss", "robust", "weights", "fixed", "per_channel")
    )
    max_theta, scale, time, trends, errors = (
        given[name] for name in ("max_theta", "scale", "time", "trends", "errors")
    )
    if not isinstance(data, Measurement):
        raise DataError(
            f"a {type(data).__name__} cannot be fitted: it is not a Measurement",
            "motes.read(path) or Measurement.from_arrays makes one",
        )
    if time is not None and not 0 <= time < data.n_times:
        raise DataError(
            f"time {time} is outside 0..{data.n_times - 1}: the measurement has {data.n_times} time(s)",
            "Choose one with --time, or time= in Python",
        )
    origin = origin_of(data, {"model": model, **given})
    if time is not None and data.n_times > 1:
        data = data.at(time)
    if max_theta is not None:
        if not 0 < max_theta <= HALF_PI:
            raise DataError(
                f"max_theta = {max_theta:.4g} is outside (0, 1.571] rad",
                f"{max_theta:.4g} degrees is {math.radians(max_theta):.3f} rad",
            )
        within = np.minimum(data.wi[:, 2], data.wo[:, 2]) >= math.cos(max_theta)
        data = data.with_mask(within[None, :, None], f"theta beyond {math.degrees(max_theta):.3g} degrees")
    loss_named(loss), robust_named(robust)
    if isinstance(scale, str) and scale != scaled.FREE:
        raise DataError(f"scale {scale!r} is not 'fit' or a number", "Give what the data are divided by, or 'fit'")
    if not isinstance(scale, str) and scale != 1.0:
        data = scaled.known(data, scale)
    uncertainties = uncertainties_of(data, weights)
    if uncertainties is not None and not np.isfinite(uncertainties).all():
        data = data.with_mask(np.isfinite(uncertainties), "uncertainty unknown")
    # One name is a name, not its letters.
    fixed = (fixed,) if isinstance(fixed, str) else fixed
    per_channel = (per_channel,) if isinstance(per_channel, str) else per_channel
    if not isinstance(errors, str) or errors not in ERRORS:
        raise MotesError(f"errors {errors!r} is not one of {', '.join(ERRORS)}", "Leave it out for 'auto'")
    wishes = Wishes(loss, robust, weights, fixed, per_channel, errors=errors)
    result = _fitted(data, model, wishes, trends, scale == scaled.FREE, below, progress)
    return replace(result, origin=origin)


def _fitted(
    data: Measurement,
    model: str | BRDF,
    wishes: Wishes,
    trends: str | Mapping[str, str],
    free_scale: bool,
    below: Sequence[Found],
    progress: Progress | None,
) -> Fit | TimeFit:
    if free_scale:
        free = replace(wishes, free_scale=True)
        data = scaled.middling(data)
        if data.n_times == 1:
            return fit_scan(data, model, free, progress)
        data = scaled.of_scans(data, lambda scan: fit_scan(scan, model, replace(free, errors="auto")))
    if data.n_times > 1:
        return fit_over_time(data, model, wishes, trends, progress)
    return fit_scan(data, model, wishes, progress, below)
