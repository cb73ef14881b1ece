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
    ways = _Ways(offer)
    for power in POWERS:
        criterion = begin()
        way = _filled(criterion, ways, seconds, close, [], power)
        found.append((criterion.value(), way))
    low, high, largest = 0, max(len(way) for _, way in found) + 1, list[int]()
    while high - low > 1:  # the largest count that takes no longer
        middle = (low + high) // 2
        way = ordered(offer, chosen(begin(), middle, close))
        low, high, largest = (middle, high, way) if time_of(offer, way) <= seconds else (low, middle, largest)
    criterion = begin()
    for shot in largest:
        criterion.take(shot)
    way = _filled(criterion, ways, seconds, close, largest, POWERS[0])
    found.append((criterion.value(), way))
    return max(found, key=lambda one: one[0])[1]


def time_of(offer: Offer, way: list[int]) -> float:
    """Seconds that shots take in their order, readings and moves."""
    return travel_of(offer, way) + offer.cost.reading * len(way)


class _Ways:
    """How far it is from shots to all others, each row (U,) computed when it is first asked for."""

    def __init__(self, offer: Offer) -> None:
        self.offer, self._rows = offer, dict[int, Floats]()

    def rows(self, way: list[int]) -> Floats:
        """From each shot of a way (K, U)."""
        for shot in way:
            if shot not in self._rows:
                self._rows[shot] = np.asarray(self.offer.travel(np.asarray([shot]), np.arange(self.offer.shots)))
        return np.stack([self._rows[shot] for shot in way])

    def detours(self, way: list[int]) -> tuple[Floats, NDArray[np.intp]]:
        """How much longer (U,) a way becomes through each shot, and the place in it where that is least; at an end it is the distance to that."""
        shots = np.arange(self.offer.shots)
        if not way:
            return np.zeros(len(shots)), np.zeros(len(shots), np.intp)
        to = self.rows(way)
        steps = to[np.arange(len(way) - 1), way[1:]]
        longer = np.concatenate([to[:1], to[:-1] + to[1:] - steps[:, None], to[-1:]])
        places = longer.argmin(axis=0)
        return longer[places, shots], places


def _filled(
    criterion: Criterion,
    ways: _Ways,
    seconds: float,
    close: NDArray[np.bool_] | None,
    way: list[int],
    power: float,
) -> list[int]:
    """A way with shots put in, each at its best place, while there is time; when there is none, a better order may give some."""
    offer = ways.offer
    way, spent, settled = list(way), time_of(offer, way), True
    while True:
        cost, places = ways.detours(way)
        rate = criterion.gains() / np.maximum(cost + offer.cost.reading, 1e-9) ** power
        rate[cost + offer.cost.reading > seconds - spent] = -np.inf
        rate[way] = -np.inf
        if way and close is not None:
            rate[close[way].any(axis=0)] = -np.inf
        best = int(np.argmax(rate))
        if rate[best] > -np.inf:
            criterion.take(best)
            way.insert(int(places[best]), best)
            spent, settled = time_of(offer, way), False
        elif settled:
            return way
        else:
            shorter = ordered(offer, way)
            way = min((way, shorter), key=lambda one: time_of(offer, one))
            spent, settled = time_of(offer, way), True
