"""In which order to go through shots with little travel: nearest neighbours, then turned stretches (2-opt, Croes 1958)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motes.planning.offers import Offer

Floats = NDArray[np.float64]


def ordered(offer: Offer, shots: list[int]) -> list[int]:
    """The shots in an order of little travel; the way is open, and may begin anywhere."""
    if len(shots) < 3:
        return list(shots)
    at = np.asarray(shots, np.intp)
    distances = offer.travel(at[:, None], at[None, :])
    starts = np.unique(np.linspace(0, len(at) - 1, min(len(at), 6)).astype(int))
    ways = [turned(_nearest(distances, int(start)), distances) for start in starts]
    best = min(ways, key=lambda way: length(way, distances))
    return [int(at[k]) for k in best]


def length(way: list[int], distances: Floats) -> float:
    """The travel along a way."""
    return float(distances[way[:-1], way[1:]].sum())


def travel_of(offer: Offer, shots: list[int]) -> float:
    """The travel through shots in their order."""
    return float(offer.travel(shots[:-1], shots[1:]).sum()) if len(shots) > 1 else 0.0


def _nearest(distances: Floats, start: int) -> list[int]:
    left = np.ones(len(distances), bool)
    way = [start]
    left[start] = False
    while left.any():
        nearest = int(np.argmin(np.where(left, distances[way[-1]], np.inf)))
        way.append(nearest)
        left[nearest] = False
    return way


def turned(way: list[int], distances: Floats, passes: int = 20) -> list[int]:
    """A way with stretches turned round while that shortens it."""
    path = np.asarray(way, np.intp)
    for _ in range(passes):
        better = False
        for i in range(len(path) - 1):
            # Turning path[i : j + 1] for every j > i: the steps into and out of the stretch change; an end of the way has none.
            j = np.arange(i + 1, len(path))
            into = distances[path[i - 1], path[j]] - distances[path[i - 1], path[i]] if i else np.zeros(len(j))
            after = np.append(path[j[1:]], -1)
            out = np.where(after >= 0, distances[path[i], after] - distances[path[j], after], 0.0)
            change = into + out
            best = int(np.argmin(change))
            if change[best] < -1e-9:
                path[i : j[best] + 1] = path[i : j[best] + 1][::-1]
                better = True
        if not better:
            break
    return [int(k) for k in path]
