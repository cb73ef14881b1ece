"""`Surface`: the surface of another program, with what an export must know of it."""

from __future__ import annotations

from abc import ABC
from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from motes.arrays import Array
from motes.models.base import BRDF

#: A weight below it is written as 0, and what it weighs left at what the program has.
NEGLIGIBLE = 1e-4
Floats = NDArray[np.float64]
Numbers = dict[str, float | tuple[float, ...]]


def number(value: Array) -> float:
    """The one number of a parameter that has no channels."""
    return float(np.ravel(value)[0])


@dataclass(frozen=True, eq=False)
class Surface(BRDF, ABC):
    """A surface with its own parameters, named as in the program."""

    reciprocal: ClassVar[bool] = False
    approximation: ClassVar[str] = "The surface of another program: a diffuse lobe of its spherical albedo."
    #: Whose it is, with the version of what it is written after.
    program: ClassVar[str]
    #: Texts of the model with what is held, the simplest first: each is fitted, and a later one is taken where it is clearly nearer.
    candidates: ClassVar[tuple[str, ...]]
    #: What the program has besides, in a sentence.
    left_out: ClassVar[str]

    @classmethod
    def admissible(cls, values: Mapping[str, Floats]) -> dict[str, Floats]:
        """The same surfaces with parameters that the program has, where a fit may take others; nearly the same where they cannot be.

        Parameters
        ----------
        values
            All parameters by name: numbers (...), and colours (..., C); of one surface or of many.
        """
        return dict(values)

    def canonical(self) -> Self:
        """The same surface as the program can have it: see `admissible`."""
        slots = self.slots()
        own = {s.name: np.atleast_1d(s.value) if s.parameter.per_channel else np.ravel(s.value)[0] for s in slots}
        new = self.admissible(own)
        changed = {s.name: np.reshape(new[s.name], np.shape(s.value)) for s in slots if new[s.name] is not own[s.name]}
        return self.with_parameters(changed) if changed else self

    def written(self) -> Numbers:
        """The parameters as the program takes them: numbers, and colours of three."""
        found: Numbers = {}
        for slot in self.slots():
            values = [float(x) for x in np.ravel(slot.value)]
            if slot.parameter.per_channel:
                found[slot.name] = tuple(values * 3 if len(values) == 1 else values)
            else:
                found[slot.name] = values[0]
        return found
