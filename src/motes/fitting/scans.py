"""Every scan of a time series fitted on its own: where the joint fit starts, and the points of its plots."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from motes.fitting.losses import Floats
from motes.fitting.problem import Problem
from motes.fitting.solver import Normal
from motes.fitting.starts import starting_points
from motes.fitting.uncertainty import at_rest, uncertainty
from motes.fitting.verdicts import Status, Verdict

ROUGH_DIRECTIONS = 300


@dataclass(frozen=True)
class ScanFits:
    """One fit for each of T scans.

    Attributes
    ----------
    x, steps
        Parameter vectors and their standard errors (T, P) in the coordinates of the fit.
    stderr
        Standard errors (T, P) in the parameters' own units.
    verdicts, normal, status
        What the data say of each parameter, the normal equations, and why each fit stopped.
    """

    x: Floats
    steps: Floats
    stderr: Floats
    verdicts: list[list[Verdict]]
    normal: Normal
    status: list[Status]

    def select(self, kept: NDArray[np.intp]) -> ScanFits:
        """Some of the scans, by position."""
        return ScanFits(
            self.x[kept],
            self.steps[kept],
            self.stderr[kept],
            [self.verdicts[k] for k in kept],
            Normal(*(part[kept] for part in self.normal)),
            [self.status[k] for k in kept],
        )


def single(problem: Problem, scan: int) -> Problem:
    """The problem of one of the scans."""
    return replace(problem, values=problem.values[scan], weights=problem.weights[scan])


def _part(problem: Problem) -> Problem:
    """A few hundred directions, drawn evenly: enough to tell valleys apart."""
    count = max(ROUGH_DIRECTIONS, 20 * problem.size)
    if len(problem.wi) <= 2 * count:
        return problem
    rows = np.sort(np.random.default_rng(20060914).choice(len(problem.wi), count, replace=False))
    return problem.at_directions(rows)


def fit_scans(problem: Problem, scans: NDArray[np.intp]) -> ScanFits:
    """Fit the scans of a problem with data (T, N, C), all at once.

    Starts are searched on the first, the middle and the last scan, and every scan tries them all.
    """
    looked_at = sorted({int(scans[0]), int(scans[len(scans) // 2]), int(scans[-1])})
    starts = np.concatenate([starting_points(single(problem, t), None, most=3) for t in looked_at])
    lanes = np.repeat(scans, len(starts))
    part = _part(problem)
    rough = part.solve(np.tile(starts, (len(scans), 1)), sets=lanes, max_iterations=25, reduction=1e-5)
    by_scan = rough.normal.objective.reshape(len(scans), -1).argmin(axis=1)
    best = rough.x.reshape(len(scans), len(starts), -1)[np.arange(len(scans)), by_scan]
    # Neighbours in time are alike: each scan also tries the ends of the scans before and after it.
    tries = np.stack([best, np.roll(best, 1, axis=0), np.roll(best, -1, axis=0)], axis=1).reshape(-1, best.shape[1])
    lanes = np.repeat(scans, 3)
    final = problem.solve(tries, sets=lanes)
    pick = final.normal.objective.reshape(len(scans), 3).argmin(axis=1) + 3 * np.arange(len(scans))
    x = np.stack([at_rest(single(problem, int(t)), row) for t, row in zip(scans, final.x[pick], strict=True)])
    chosen = Normal(*(part[pick] for part in final.normal))
    errors = [uncertainty(single(problem, int(t)), row) for t, row in zip(scans, x, strict=True)]
    return ScanFits(
        x,
        np.stack([e.steps for e in errors]),
        np.stack([e.stderr for e in errors]),
        [e.verdicts for e in errors],
        chosen,
        [final.status[k] for k in pick],
    )
