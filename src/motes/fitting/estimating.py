"""The error bars of a solution by the way that is asked for: sandwich, block bootstrap or profile likelihood."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from motes.fitting.bootstrap import drawn
from motes.fitting.columns import in_own_units
from motes.fitting.error_bars import LEVELS, ErrorBars, chosen, intervals
from motes.fitting.losses import Floats
from motes.fitting.objective import Objective
from motes.fitting.profile import profiled
from motes.fitting.result import Progress
from motes.fitting.uncertainty import Uncertainty, uncertainty


class Estimate(NamedTuple):
    """What errors are of, the errors, and intervals (2, P) in the parameters' own units by the names of `LEVELS`."""

    bars: ErrorBars
    uncertainty: Uncertainty
    intervals: dict[str, Floats]


def estimated(
    objective: Objective,
    x: Floats,
    asked: str,
    provenance: Mapping[str, Any],
    stated: bool,
    progress: Progress | None = None,
) -> Estimate:
    """Error bars of the solution `x` (P,); `asked`, `provenance` and `stated` as for `motes.fitting.error_bars.chosen`.

    Verdicts are those of the sandwich in all cases.  A bootstrap gives errors, covariance and percentiles; a profile gives intervals
    alone, scaled to the errors of the sandwich.
    """
    bars, blocks = chosen(asked, provenance, stated, objective, x)
    columns = objective.columns
    found = uncertainty(objective, x, blocks)
    if bars.kind == "bootstrap":
        assert blocks is not None
        draws = in_own_units(drawn(objective, x, blocks, progress), columns)
        known = np.isfinite(found.stderr)
        # As many blocks are drawn as there are, so that the spread is too small by one of them (Efron and Tibshirani, 1993, section 11.5).
        covariance = np.atleast_2d(np.cov(draws.T)) * bars.blocks / (bars.blocks - 1)
        covariance[~known], covariance[:, ~known] = np.nan, np.nan
        stderr = np.sqrt(np.diag(covariance))
        ends = {
            name: np.percentile(draws, [50 - 50 * level, 50 + 50 * level], axis=0) for name, level in LEVELS.items()
        }
        return Estimate(bars, found._replace(stderr=stderr, covariance=covariance), ends)
    if bars.kind == "profile":
        between = profiled(objective, x, found.steps, found.freedom, LEVELS, progress)
        return Estimate(bars, found, {name: in_own_units(both, columns) for name, both in between.items()})
    return Estimate(bars, found, intervals(x, found.steps, found.freedom, columns))
