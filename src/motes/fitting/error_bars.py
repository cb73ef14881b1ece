"""What error bars take as independent, why, and intervals from them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any, final

import numpy as np

from motes.errors import DataError
from motes.fitting.alike import FEWEST, count_of_blocks
from motes.fitting.columns import Columns, in_own_units
from motes.fitting.data_passes import in_slices
from motes.fitting.direction_blocks import LEAST_DIRECTIONS, Labels, blocks_of
from motes.fitting.losses import Floats
from motes.fitting.objective import Objective
from motes.fitting.students_t import half_width
from motes.measurements.origin import not_measured

#: What errors may be asked for.
ERRORS = ("auto", "blocks", "independent", "bootstrap", "profile")
#: Intervals, by name: 68 % is one standard deviation of the normal distribution.
LEVELS = {"68": math.erf(math.sqrt(0.5)), "95": 0.95}
# Directions whose residuals are looked at together: their numbers stay in cache.
AT_ONCE = 8192
# Residuals go together where they do by more than so many standard deviations of chance.
BEYOND = 7.0


@final
@dataclass(frozen=True)
class ErrorBars:
    """What the error bars of a fit take as independent, and why.

    Attributes
    ----------
    kind
        ``"blocks"``, ``"independent"``, ``"bootstrap"`` or ``"profile"``.
    blocks
        How many blocks of directions; 0 where each sample counts by itself.
    why
        The reason, as the end of a sentence.
    """

    kind: str
    blocks: int
    why: str

    def __str__(self) -> str:
        words = f"over {self.blocks} blocks of directions" if self.blocks else "over independent samples"
        words = {
            "bootstrap": f"by a bootstrap {words}",
            "profile": f"{words}, intervals by the profile likelihood",
        }.get(self.kind, words)
        return f"{words}: {self.why}"

    def to_dict(self) -> dict[str, Any]:
        """As plain JSON values."""
        return asdict(self)


#: What is said of results that were put together from others.
UNKNOWN = ErrorBars("independent", 0, "nothing else is known")


def chosen(
    asked: str, provenance: Mapping[str, Any], stated: bool, objective: Objective, x: Floats
) -> tuple[ErrorBars, Labels | None]:
    """The kind of errors of a fit and, for blocks, the labels (N,) of its directions.

    Of what was measured, residuals are mostly what the model misses, which neighbours share: blocks, as large as residuals are alike
    (`motes.fitting.alike`).  Samples count as independent where the measurement says so (it is simulated, or states the noise of each
    sample), and where nothing is said of arrays, as long as the residuals do not contradict it.

    Parameters
    ----------
    asked
        One of `ERRORS`.
    provenance
        Of the measurement.
    stated
        Whether the samples have uncertainties that they are weighted by.
    objective, x
        What is minimised, and the solution (P,).

    Raises
    ------
    DataError
        Where blocks are asked for, and there are too few directions.
    """
    if asked == "profile":  # whose scale is that of the errors
        bars, labels = chosen("auto", provenance, stated, objective, x)
        return replace(bars, kind="profile"), labels
    if asked == "independent":
        return ErrorBars("independent", 0, "as asked for"), None
    wi, wo = objective.directions
    labels = blocks_of(wi, wo)
    if int(labels.max()) + 1 < FEWEST:
        few = f"{len(wi)} usable directions are too few for blocks"
        if asked != "auto":
            raise DataError(
                f"{few}, of which there must be {FEWEST} with {LEAST_DIRECTIONS} directions each, at different places",
                "errors='independent' takes samples as independent (--errors independent)",
            )
        return ErrorBars("independent", 0, few), None
    misses = objective.misses(x)
    simulated = bool(not_measured(provenance))
    kind, why = "blocks", ""
    if asked in ("blocks", "bootstrap"):
        kind, why = asked, "as asked for"
    elif provenance.get("format") and not simulated and not stated:
        why = "what a model misses of a material, neighbours share"
    elif together(misses, labels):
        why = "the residuals of neighbours go together"
    if why:
        sized = blocks_of(wi, wo, count_of_blocks(wi, wo, misses))
        labels = sized if int(sized.max()) + 1 >= FEWEST else labels  # of few places, which cannot be cut evenly
        return ErrorBars(kind, int(labels.max()) + 1, why), labels
    who = "simulated" if simulated else "with uncertainties" if stated else "not said to be measured"
    return ErrorBars("independent", 0, f"the data are {who}, and the residuals of neighbours do not go together"), None


def together(misses: Floats, labels: Labels) -> bool:
    """Whether residuals (T, N, C) of one direction, or of one block, have the same sign more often than by chance.

    The sum u of each group is squared, once of the residuals and once of their signs.  Were they independent, any could as well have had
    the other sign: then the sum of u^2 has the mean sum r^2, and a variance that is known, too.  `BEYOND` standard deviations are
    more than a few in ten thousand of independent data reach.
    """
    largest = max(float(misses.max(initial=0.0)), -float(misses.min(initial=0.0)), 1e-300)
    count = int(labels.max(initial=0)) + 1

    def part(rows: slice) -> tuple[Floats, Floats]:
        some, own = misses[:, rows], labels[rows]
        of_directions, of_blocks = np.empty((2, 3)), np.empty((2, 3, count))
        for k, r in enumerate((some / largest, np.nan_to_num(np.sign(some)))):
            squared = np.square(r)
            sums, squares = (np.einsum("tnc->n", power) for power in (r, squared))
            fourths = squares if k else np.einsum("tnc->n", np.square(squared))  # of signs they are the squares
            of_directions[k] = _excess(sums, squares, fourths)
            of_blocks[k] = [np.bincount(own, power, count) for power in (sums, squares, fourths)]
        return of_directions, of_blocks

    parts = in_slices(part, len(labels), AT_ONCE)
    of_directions, of_blocks = (sum(each, start=np.zeros(())) for each in zip(*parts, strict=True))
    for found in (*of_directions, *(_excess(*blocks) for blocks in of_blocks)):
        excess, squares_squared, fourths_ = found
        if excess > BEYOND * math.sqrt(2 * max(0.0, squares_squared - fourths_)) + 1e-12:
            return True
    return False


def _excess(sums: Floats, squares: Floats, fourths: Floats) -> Floats:
    """Of groups with these sums of residuals, of their squares and fourth powers: what squared sums exceed squares by, and two sums that tell
    the variance of that."""
    return np.array([np.sum(sums**2) - np.sum(squares), np.sum(squares**2), np.sum(fourths)])


def intervals(x: Floats, steps: Floats, freedom: Floats, columns: Columns) -> dict[str, Floats]:
    """Intervals (2, P) in the parameters' own units, by the names of `LEVELS`; NaN where there is no error.

    They are symmetric in the coordinate that the fit moves in, and end at the bounds.

    Parameters
    ----------
    x, steps
        The solution and its standard errors (P,), in the coordinates of the fit.
    freedom
        Degrees of freedom (P,).
    """
    low, high = columns.low[:, 0], columns.high[:, 0]
    found = {}
    for name, level in LEVELS.items():
        # Quantiles of as many digits as errors have: those of thousands of channels are a few.
        widths = np.array([half_width(level, float(f"{f:.3g}")) for f in freedom])
        ends = np.clip(x + np.outer([-1.0, 1.0], widths * steps), low, high)
        found[name] = in_own_units(ends, columns)
    return found
