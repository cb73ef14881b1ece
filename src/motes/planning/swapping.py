"""Which shots to take: one after the other, then exchanged while that helps (Fedorov 1972); and what is kept to check the model."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motes.directions import half_difference
from motes.planning.criteria import Criterion
from motes.planning.offers import Offer

Floats = NDArray[np.float64]
# Passes of exchanges that raise a criterion (of logarithms) by less than this, a share of errors, are not worth their time; nor are many
# where the shots are: with many, what is taken first is nearly as good.
LEAST_GAIN = 1e-4
MOST_EXCHANGES = 120


def chosen(criterion: Criterion, count: int, close: NDArray[np.bool_] | None, *, repeats: bool = False) -> list[int]:
    """The best `count` shots that were found.

    The criterion is left with them taken.  There may be fewer where all others are too `close` (U, U) to those taken.

    Parameters
    ----------
    criterion
        With nothing taken.
    close
        Shots that may not be taken together, or None.
    repeats
        Whether a shot may be taken more than once.
    """
    taken: list[int] = []
    for _ in range(count):
        best = _best(criterion, taken, close, repeats)
        if best is None:
            break
        criterion.take(best)
        taken.append(best)
    for _ in range(max(1, MOST_EXCHANGES // count)):
        before = criterion.value()
        for place in range(len(taken)):
            old = taken[place]
            criterion.give_back(old)
            others = taken[:place] + taken[place + 1 :]
            new = _best(criterion, others, close, repeats)
            taken[place] = old if new is None else new
            criterion.take(taken[place])
        if criterion.value() - before < LEAST_GAIN:
            break
    return taken


def _best(criterion: Criterion, taken: list[int], close: NDArray[np.bool_] | None, repeats: bool) -> int | None:
    gains = criterion.gains()
    if taken and not repeats:
        gains[taken] = -np.inf
    if taken and close is not None:
        gains[close[taken].any(axis=0)] = -np.inf
    best = int(np.argmax(gains))
    return best if gains[best] > -np.inf else None


def places(wi: Floats, wo: Floats) -> Floats:
    """Where pairs of directions (N, 3) stand (N, 3) among what an isotropic reciprocal surface tells apart.

    Rusinkiewicz's angles: the half angle by its root, as highlights crowd at 0; the difference angle; and its azimuth, folded by reciprocity
    and mirror symmetry, which means less the smaller the difference angle is.
    """
    theta_h, theta_d, phi_d = half_difference(wi, wo)
    folded = np.abs(phi_d) % np.pi
    folded = np.minimum(folded, np.pi - folded)
    right = np.pi / 2
    return np.stack([np.sqrt(theta_h / right), theta_d / right, folded / right * np.sin(theta_d)], axis=-1)


def spread(
    offer: Offer, count: int, taken: list[int], close: NDArray[np.bool_] | None, beside: Floats | None = None
) -> list[int]:
    """Further shots, each as far as can be from all before it (maximin) in the space of `places`: what a wrong model would be caught at.

    Parameters
    ----------
    taken
        Shots that are taken already.
    beside
        Places (M, 3) of directions that are measured already.
    """
    where = places(offer.wi, offer.wo)
    distance = np.full(len(where), np.inf)

    def nearer(points: Floats) -> None:
        for point in points:
            np.minimum(distance, np.linalg.norm(where - point, axis=1), out=distance)

    if beside is not None:
        nearer(beside)
    nearer(where[offer.directions_of(taken)])
    found: list[int] = []
    for _ in range(count):
        of_shots = np.full(offer.shots, np.inf)
        np.minimum.at(of_shots, offer.shot, distance)
        if not np.isfinite(of_shots).any():  # nothing taken yet: begin in the middle
            of_shots = -np.bincount(offer.shot, np.linalg.norm(where - np.median(where, axis=0), axis=1))
        every = [*taken, *found]
        of_shots[every] = -np.inf
        if every and close is not None:
            of_shots[close[every].any(axis=0)] = -np.inf
        best = int(np.argmax(of_shots))
        if of_shots[best] == -np.inf:
            break
        found.append(best)
        nearer(where[offer.directions_of([best])])
    return found


def even(offer: Offer, count: int) -> list[int]:
    """Evenly spaced shots in the order in which the instrument has them: what people measure who do not plan."""
    return sorted({int(k) for k in np.round(np.linspace(0, offer.shots - 1, min(count, offer.shots)))})


def exposures(criterion: Criterion, taken: list[int], least: float = 0.25, steps: int = 60) -> Floats:
    """Relative exposures of the shots taken, with mean 1: what the criterion gains most by at equal time in all.

    The multiplicative rule (Silvey, Titterington, Torsney 1978), in a step of its root for traces; none is below `least`, since shots that
    check the model must be seen, too.
    """
    weights = np.ones(len(taken))
    for _ in range(steps):
        slopes = np.sum([term.slopes(taken, weights) for term in criterion.terms], axis=0)
        weights = weights * np.sqrt(np.maximum(slopes, 0.0))
        weights = np.maximum(weights / max(weights.mean(), 1e-300), least)
    return np.asarray(weights / weights.mean())
