"""Which shots to take within a time: each is worth what it tells per second that it costs, the way to it included."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from motes.planning.criteria import Criterion
from motes.planning.offers import Offer
from motes.planning.swapping import chosen
from motes.planning.travelling import ordered, travel_of

Floats = NDArray[np.float64]
#: Of the cost that a gain is divided by.
POWERS = (1.0, 0.5, 0.0)


def within(begin: Callable[[], Criterion], offer: Offer, seconds: float, close: NDArray[np.bool_] | None) -> list[int]:
    """The best shots that were found for so many seconds, in the order to go through them.

    Plans are made from several beginnings, and the best of them is taken: by what a shot tells, per second of its reading and of the shortest
    detour to it, or per root of that, or whatever it costs; and the largest plan by count that takes no longer, with what still fits.

    Parameters
    ----------
    begin
        Gives the criterion with nothing taken.
    """
    found: list[tuple[float, list[int]]] = []
    for power in POWERS:
        criterion = begin()
        found.append((0.0, _filled(criterion, offer, seconds, close, [], power)))
        found[-1] = (criterion.value(), found[-1][1])
    low, high, largest = 0, max(len(way) for _, way in found) + 1, list[int]()
    while high - low > 1:  # the largest count that takes no longer
        middle = (low + high) // 2
        way = ordered(offer, chosen(begin(), middle, close))
        low, high, largest = (middle, high, way) if time_of(offer, way) <= seconds else (low, middle, largest)
    criterion = begin()
    for shot in largest:
        criterion.take(shot)
    way = _filled(criterion, offer, seconds, close, largest, POWERS[0])
    found.append((criterion.value(), way))
    return max(found, key=lambda one: one[0])[1]


def time_of(offer: Offer, way: list[int]) -> float:
    """Seconds that shots take in their order, readings and moves."""
    return travel_of(offer, way) + offer.cost.reading * len(way)


def _filled(
    criterion: Criterion,
    offer: Offer,
    seconds: float,
    close: NDArray[np.bool_] | None,
    way: list[int],
    power: float,
) -> list[int]:
    """A way with shots put in while there is time."""
    way = list(way)
    while True:
        cost = _detours(offer, way) + offer.cost.reading
        rate = criterion.gains() / np.maximum(cost, 1e-9) ** power
        rate[cost > seconds - time_of(offer, way)] = -np.inf
        rate[way] = -np.inf
        if way and close is not None:
            rate[close[way].any(axis=0)] = -np.inf
        best = int(np.argmax(rate))
        if rate[best] == -np.inf:
            return way
        criterion.take(best)
        way = ordered(offer, [*way, best])


def _detours(offer: Offer, way: list[int]) -> Floats:
    """How much longer (U,) the way becomes through each shot, at its best place; at an end it is the distance to that."""
    if not way:
        return np.zeros(offer.shots)
    all_shots = np.arange(offer.shots)
    to = offer.travel(np.asarray(way)[:, None], all_shots[None, :])
    found = np.minimum(to[0], to[-1])
    if len(way) > 1:
        steps = offer.travel(way[:-1], way[1:])[:, None]
        found = np.minimum(found, (to[:-1] + to[1:] - steps).min(axis=0))
    return np.asarray(found)
