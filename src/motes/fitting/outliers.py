"""The joint fit without scans that do not belong: moved instruments, clouds, the wrong sample."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from motes.fitting.joint import Joint
from motes.fitting.losses import Floats
from motes.fitting.problem import Problem
from motes.fitting.result import Progress
from motes.fitting.scans import ScanFits
from motes.fitting.solver import Solution
from motes.fitting.time_result import Alternative, ScanOutlier
from motes.fitting.trend_choice import first_guess, select, steady_values

# A scan is an outlier when its misfit to the trends (a chi-square over its degrees of freedom) is this many times the median scan's, and over
# this at all; or when its noise is.
OUTLIER_RATIO, OUTLIER_MISFIT, OUTLIER_NOISE = 12.0, 12.0, 4.0
FEWEST_SCANS_TO_JUDGE = 5
SUSPECTS = 3  # scans that are left out in turn when no trend suits all


def joint_fit(
    problem: Problem,
    hours: Floats,
    fits: ScanFits,
    usable: NDArray[np.intp],
    kinds: Mapping[str, str],
    say: Progress,
) -> tuple[Joint, Solution, dict[str, list[Alternative]], tuple[ScanOutlier, ...]]:
    """The joint fit, refitted without scans that do not belong, one at a time."""
    outliers: list[ScanOutlier] = []
    kept = np.arange(len(usable))
    noise = _noise(problem, fits, usable)
    loud = noise > OUTLIER_NOISE * np.median(noise)
    if len(usable) >= FEWEST_SCANS_TO_JUDGE and loud.sum() <= len(usable) // 5:
        for k in np.flatnonzero(loud).tolist():
            ratio = noise[k] / float(np.median(noise))
            outliers.append(
                ScanOutlier(int(usable[k]), float(hours[usable[k]]), f"its noise is {ratio:.1f} times the others'")
            )
        kept = kept[~loud]

    def fitted(kept: NDArray[np.intp]) -> tuple[Joint, Solution, dict[str, list[Alternative]], Floats]:
        """The joint fit of some scans, and how badly it suits each of all."""
        part = fits.select(kept)
        joint, c = first_guess(problem, hours, part, usable[kept], kinds)
        level = float(np.median(_noise(problem, part, usable[kept])) ** 2)
        joint, solution, alternatives = select(
            joint,
            c,
            kinds,
            lambda done, total, what: say(45 + done, 100, what),
            steady_values(problem, part),
        )
        return joint, solution, alternatives, _misfit(replace(joint, scans=usable), solution.x[0], fits, level)

    found = fitted(kept)
    while len(kept) >= FEWEST_SCANS_TO_JUDGE and len(outliers) < max(1, len(usable) // 5):
        misfit = found[3][kept]
        order = np.argsort(-misfit)
        if misfit[order[0]] < OUTLIER_MISFIT:
            break
        # No trend suits all scans.  Is there one that suits all but one?
        best = None
        for k in order[:SUSPECTS]:
            without = np.delete(kept, k)
            trial = fitted(without)
            others = trial[3][without]
            far = trial[3][kept[k]] > max(OUTLIER_RATIO * float(np.median(others)), OUTLIER_MISFIT)
            if far and others.sum() < 0.5 * np.delete(misfit, k).sum() and (best is None or others.sum() < best[0]):
                best = (others.sum(), kept[k], without, trial)
        if best is None:
            break
        _, worst, kept, found = best
        scan = int(usable[worst])
        reason = f"it lies {math.sqrt(found[3][worst]):.0f} standard errors from the trends of the others"
        outliers.append(ScanOutlier(scan, float(hours[scan]), reason))
    return *found[:3], tuple(sorted(outliers, key=lambda o: o.index))


def _noise(problem: Problem, fits: ScanFits, usable: NDArray[np.intp]) -> Floats:
    """Root mean square of the weighted residuals of each scan."""
    samples = np.array([np.count_nonzero(problem.weights[t]) for t in usable])
    return np.asarray(np.sqrt(2 * fits.normal.objective / np.maximum(samples - problem.size, 1)))


def _misfit(joint: Joint, c: Floats, fits: ScanFits, noise: float) -> Floats:
    """How much worse the trends suit each scan than its own fit does: a chi-square over its number of parameters."""
    x, _ = joint.vectors(c)
    scan = joint.problem.normal(x, joint.scans)
    return 2 * np.maximum(scan.objective - fits.normal.objective, 0) / (max(noise, 1e-300) * joint.problem.size)
