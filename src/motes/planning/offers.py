"""`Offer`: the directions that an instrument can measure, which of them go together, and what it costs to go from one to the next."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Self, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.directions import above
from motes.errors import DataError

Floats = NDArray[np.float64]
Indices = NDArray[np.intp]
#: More directions than this are refused: an answer would no longer come at once.
MOST_DIRECTIONS = 20_000


@dataclass(frozen=True)
class Cost:
    """What a measurement takes.

    Parameters
    ----------
    reading
        Of one shot [s].
    light, view
        Of moving the lamp, or the detector, by a degree [s].
    at_once
        True where both move at the same time, False where one waits for the other.
    known
        False where nobody gave these numbers, so that only degrees can be told.
    """

    reading: float = 0.0
    light: float = 1.0
    view: float = 1.0
    at_once: bool = False
    known: bool = False


@final
@dataclass(frozen=True, eq=False)
class Offer:
    """The directions that an instrument can measure.

    Parameters
    ----------
    name
        Of the instrument, for people.
    wi, wo
        To the lamp and to the detector (N, 3), unit, above the horizon.
    shot
        For each direction the number of the shot (N,) that it is recorded in, from 0 and without gaps: directions of one shot are
        measured together.
    apart_deg
        Two shots of a plan differ in the lamp's or in the detector's direction by at least this [degrees].
    cost
        See `Cost`.
    """

    name: str
    wi: Floats
    wo: Floats
    shot: Indices
    apart_deg: float = 0.0
    cost: Cost = Cost()

    @classmethod
    def of(
        cls,
        name: str,
        wi: ArrayLike,
        wo: ArrayLike,
        *,
        shot: ArrayLike | None = None,
        apart_deg: float = 0.0,
        cost: Cost | None = None,
    ) -> Self:
        """An offer of the directions above the horizon; raises `DataError` where there is none, or far too many."""
        i, o = np.atleast_2d(np.asarray(wi, float)), np.atleast_2d(np.asarray(wo, float))
        if i.shape != o.shape or i.shape[1:] != (3,):
            raise DataError(
                f"directions of shapes {i.shape} and {o.shape} are no pairs", "Give wi and wo as arrays (N, 3)"
            )
        if i.size and not (np.abs(np.linalg.norm(np.stack([i, o]), axis=-1) - 1) < 1e-3).all():
            raise DataError("a direction is no unit vector", "Divide each by its length")
        seen = above(i, o)
        if not seen.any():
            raise DataError(
                f"{name} sees nothing: of its {len(i)} directions none has lamp and detector above the surface",
                "Check its angles, which count from the normal, and its blocked zones",
            )
        if int(seen.sum()) > MOST_DIRECTIONS:
            raise DataError(
                f"{name} has {int(seen.sum()):,} directions, more than {MOST_DIRECTIONS:,}",
                "Take larger steps between its angles",
            )
        labels = np.arange(len(i)) if shot is None else np.asarray(shot, np.intp)
        _, dense = np.unique(labels[seen], return_inverse=True)
        return cls(name, i[seen], o[seen], dense.astype(np.intp), apart_deg, cost or Cost())

    @property
    def shots(self) -> int:
        """How many shots there are to choose from."""
        return int(self.shot.max()) + 1

    @cached_property
    def members(self) -> Indices:
        """The directions of each shot (U, m), the last places filled with -1."""
        counts = np.bincount(self.shot, minlength=self.shots)
        table = np.full((self.shots, int(counts.max())), -1, np.intp)
        order = np.argsort(self.shot, kind="stable")
        place = np.arange(len(order)) - np.repeat(np.cumsum(counts) - counts, counts)
        table[self.shot[order], place] = order
        return table

    def directions_of(self, shots: ArrayLike) -> Indices:
        """The directions of some shots, in their order."""
        rows = self.members[np.asarray(shots, np.intp)].ravel()
        return rows[rows >= 0]

    def without(self, taken: NDArray[np.bool_]) -> Self:
        """The offer without some of the shots (U,)."""
        if taken.all():
            raise DataError(
                f"no free direction is left: all {self.shots} shots of {self.name} are measured already",
                "Give a rig with more directions, or allow repeats",
            )
        keep = ~taken[self.shot]
        _, dense = np.unique(self.shot[keep], return_inverse=True)
        return replace(self, wi=self.wi[keep], wo=self.wo[keep], shot=dense.astype(np.intp))

    def angles_between(self, a: ArrayLike, b: ArrayLike) -> tuple[Floats, Floats]:
        """Degrees that the lamp and the detector move from shots `a` to shots `b`, which broadcast; shots of several detectors have
        these fixed."""
        a, b = np.asarray(a, np.intp), np.asarray(b, np.intp)
        light = _degrees(self.wi[self.members[a, 0]], self.wi[self.members[b, 0]])
        if self.members.shape[1] > 1:
            return light, np.zeros_like(light)
        return light, _degrees(self.wo[self.members[a, 0]], self.wo[self.members[b, 0]])

    def travel(self, a: ArrayLike, b: ArrayLike) -> Floats:
        """What it costs to move from shots `a` to shots `b`, which broadcast: seconds, or degrees where costs are not known."""
        light, view = self.angles_between(a, b)
        light, view = light * self.cost.light, view * self.cost.view
        return np.asarray(np.maximum(light, view) if self.cost.at_once else light + view)

    def near(self, wi: Floats, wo: Floats, within_deg: float = 0.5) -> NDArray[np.bool_]:
        """For each shot (U,) whether all its directions are among some pairs (M, 3), to within so many degrees."""
        cosine = np.cos(np.radians(within_deg))
        found = np.empty(len(self.wi), bool)
        for rows in np.array_split(np.arange(len(self.wi)), max(1, len(self.wi) * len(wi) // 4_000_000)):
            found[rows] = ((self.wi[rows] @ wi.T >= cosine) & (self.wo[rows] @ wo.T >= cosine)).any(axis=1)
        taken = np.ones(self.shots, bool)
        np.logical_and.at(taken, self.shot, found)
        return taken

    def conflicts(self) -> NDArray[np.bool_] | None:
        """Which shots (U, U) are too close to be taken together; None where nothing is said of that."""
        if self.apart_deg <= 0:
            return None
        cosine = np.cos(np.radians(self.apart_deg)) + 1e-12
        first = self.members[:, 0]
        close = self.wi[first] @ self.wi[first].T > cosine
        if self.members.shape[1] == 1:
            close &= self.wo[first] @ self.wo[first].T > cosine
        np.fill_diagonal(close, False)
        return np.asarray(close)


def _degrees(a: Floats, b: Floats) -> Floats:
    # The half chord is exact where the arc cosine loses half of its digits: at small angles.
    return np.asarray(np.degrees(2 * np.arcsin(np.clip(0.5 * np.linalg.norm(a - b, axis=-1), 0, 1))))
