"""Many mirrors: the mean growth of dust at a site and tilt, and what cleaning between campaigns took away."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import final

import numpy as np

from motes.soiling.mirrors import INCIDENCE_DEG, LEAST_GAIN, Soiling, slant
from motes.soiling.readings import Series


@final
@dataclass(frozen=True)
class Growth:
    """Mean growth of tau on the mirrors of one site and tilt.

    Parameters
    ----------
    site, tilt_deg
        Which.
    mirrors
        How many series.
    rate, stderr
        Mean weighted by the series' own errors and the scatter between them [1/d], and its standard error.  Series of one campaign share their weather, of
        which this error does not know: the more mirrors a campaign has, the more it is too small.
    resets
        How many were found.
    """

    site: str
    tilt_deg: float
    mirrors: int
    rate: float
    stderr: float
    resets: int


def growth(fits: Sequence[Soiling]) -> tuple[Growth, ...]:
    """By site and tilt, in order."""
    groups: dict[tuple[str, float], list[Soiling]] = {}
    for fit in fits:
        groups.setdefault((fit.series.site, fit.series.tilt_deg), []).append(fit)
    rows = []
    for (site, tilt), members in sorted(groups.items()):
        rates, errors = np.array([m.rate for m in members]), np.array([m.rate_stderr for m in members])
        # Campaigns differ by their weather: the variance between them is added to each one's own (DerSimonian and Laird 1986).
        weights = 1 / errors**2
        mean = np.sum(weights * rates) / weights.sum()
        if len(members) > 1:
            excess = np.sum(weights * (rates - mean) ** 2) - (len(members) - 1)
            between = max(excess / (weights.sum() - np.sum(weights**2) / weights.sum()), 0.0)
            weights = 1 / (errors**2 + between)
            mean = np.sum(weights * rates) / weights.sum()
        rows.append(
            Growth(
                site,
                tilt,
                len(members),
                float(mean),
                float(1 / np.sqrt(weights.sum())),
                sum(len(m.resets) for m in members),
            )
        )
    return tuple(rows)


def cleanings(
    series: Sequence[Series], *, theta_i: float = np.deg2rad(INCIDENCE_DEG)
) -> tuple[tuple[Series, Series, float, float], ...]:
    """Between two campaigns of one mirror: (before, after, fall of tau, its standard error), where it fell by more than three standard errors."""
    depth, found = slant(theta_i), []
    mirrors: dict[tuple[str, str], list[Series]] = {}
    for one in series:
        mirrors.setdefault((one.site, one.mirror), []).append(one)
    for runs in mirrors.values():
        runs = sorted(runs, key=lambda one: one.start)
        for a, b in pairwise(runs):
            if b.start < a.start + a.days[-1]:
                continue
            gain = float(np.log(b.reflectance[0] / a.reflectance[-1])) / depth
            error = float(np.hypot(a.stderr[-1] / a.reflectance[-1], b.stderr[0] / b.reflectance[0])) / depth
            if gain > LEAST_GAIN * error:
                found.append((a, b, gain, error))
    return tuple(found)
