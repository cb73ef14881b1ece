"""What a design will reveal: the standard error of each parameter, in the words of the fits."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.fitting import covariance as steps
from motes.fitting.algebra import ARRAYS
from motes.fitting.verdicts import Verdict
from motes.planning.information import Noise, Subject, information

Floats = NDArray[np.float64]


class Revealed(NamedTuple):
    """What directions reveal of each material and parameter (B, P): standard errors, infinite where there is none, and verdicts."""

    stderr: Floats
    codes: NDArray[np.intp]


@dataclass(frozen=True)
class Expectation:
    """What is expected of one parameter, over the materials of the prior.

    Attributes
    ----------
    stderr
        The median of its standard error, infinite where most materials leave it undetermined.
    to_even, to_all
        The median of its error over that of the even choice of as many shots, and over that of all shots together; NaN where neither has one.
    verdicts
        For each verdict the number of materials.
    """

    name: str
    unit: str
    stderr: float
    to_even: float
    to_all: float
    verdicts: dict[Verdict, int]

    @property
    def verdict(self) -> Verdict:
        """The verdict of most materials."""
        return max(self.verdicts, key=lambda verdict: self.verdicts[verdict])

    @property
    def unseen(self) -> int:
        """For how many materials the parameter stays undetermined."""
        return self.verdicts.get(Verdict.UNIDENTIFIABLE, 0)


def revealed(
    subject: Subject, values: Floats, wi: Floats, wo: Floats, noise: Noise, exposure: Floats | None = None
) -> Revealed:
    """The standard errors that readings of some directions give, without any prior; see `motes.fitting.covariance`.

    `exposure` (N,) divides the variance of each reading.
    """
    f, slopes = subject.derivatives(values, wi, wo)
    share = (np.ones(len(wi)) if exposure is None else np.sqrt(exposure)) / noise.deviation(f, wi[:, 2])
    matrix = np.moveaxis(information(slopes * share[..., None]) / np.outer(subject.spans, subject.spans), 0, 2)
    brightness = np.square(f * share).sum(axis=1)
    x, columns = subject.coordinates(values).T, subject.columns
    with np.errstate(all="ignore"):
        stand = steps.standing(ARRAYS, x, matrix, columns, brightness)
        inverse = steps.inverted(ARRAYS, matrix, stand.free)
        blurred = inverse.blurred
        if blurred.any():  # the others as if what is only seen in sums were known
            inverse = steps.inverted(ARRAYS, matrix, stand.free * (1 - blurred))
            blurred = np.maximum(blurred, inverse.blurred)
        step = np.sqrt(np.maximum(ARRAYS.diagonal(inverse.matrix), 0.0))
        known = stand.free * (1 - blurred)
        stderr = np.where(known > 0, steps.own_error(ARRAYS, x, step, columns.squared), np.nan)
        verdicts = np.where(known > 0, steps.IDENTIFIED, steps.UNIDENTIFIABLE)
        verdicts = np.where(stand.at_low > 0, steps.AT_LOWER, np.where(stand.at_high > 0, steps.AT_UPPER, verdicts))
        codes = steps.judged(ARRAYS, values.T, stderr, columns, verdicts)
    return Revealed(np.where(np.isfinite(stderr), stderr, np.inf).T, np.round(codes.T).astype(np.intp))


def ratio(a: Floats, b: Floats) -> Floats:
    """a over b (B, P); NaN where both are infinite."""
    with np.errstate(all="ignore"):
        return np.asarray(np.where(np.isfinite(a) | np.isfinite(b), a / b, np.nan))


def middle(values: Floats) -> float:
    """The median of what is no NaN; NaN where nothing is."""
    kept = np.sort(values[~np.isnan(values)])
    # Of an even number the lower of the two: the mean with an infinite one would say nothing.
    return float(kept[(len(kept) - 1) // 2]) if len(kept) else float("nan")


def expectations(subject: Subject, planned: Revealed, even: Revealed, everything: Revealed) -> tuple[Expectation, ...]:
    """What is expected of each parameter."""
    to_even, to_all = ratio(planned.stderr, even.stderr), ratio(planned.stderr, everything.stderr)
    return tuple(
        Expectation(
            q.name,
            q.parameter.unit,
            middle(planned.stderr[:, k]),
            middle(to_even[:, k]),
            middle(to_all[:, k]),
            {steps.VERDICTS[c]: n for c, n in Counter(planned.codes[:, k].tolist()).most_common()},
        )
        for k, q in enumerate(subject.quantities)
    )


def overall(a: Revealed, b: Revealed) -> float:
    """How many times larger the errors of `a` are: the median over materials of the geometric mean over parameters that both know."""
    found = []
    for mine, other in zip(a.stderr, b.stderr, strict=True):
        both = np.isfinite(mine) & np.isfinite(other) & (other > 0)
        if both.any():
            found.append(np.exp(np.mean(np.log(mine[both] / other[both]))))
    return middle(np.array(found)) if found else float("nan")


def stays_unseen(expected: Sequence[Expectation], materials: int) -> list[str]:
    """Sentences on what the design does not determine."""
    said = []
    for one in expected:
        weak = one.verdicts.get(Verdict.WEAK, 0)
        if one.unseen:
            said.append(f"{one.name} stays {Verdict.UNIDENTIFIABLE} for {one.unseen} of {materials} materials")
        elif 2 * weak >= materials:
            said.append(f"{one.name} stays {Verdict.WEAK} for {weak} of {materials} materials")
    return said
