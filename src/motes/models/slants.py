"""Directions as a plane layer sees them, in which two that come together share their divisions.

A division costs a processor as much as ten products, in kernels and shaders alike.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce
from operator import mul

from motes.arrays import NUMPY, Array
from motes.directions import Geometry

#: Of v: found by what eight terms err in S, E and t.
BEND = 0.5
STRETCH = 2 * (1 + BEND) ** 0.5


@dataclass(frozen=True, eq=False)
class Slant:
    """A direction to or from a layer.

    Parameters
    ----------
    cosine, inverse
        Of its angle to the vertical, above 0, and 1 over it.
    v
        See `stretched`.
    """

    cosine: Array
    inverse: Array
    v: Array

    @classmethod
    def of(cls, xp: Array, cosine: Array) -> Slant:
        """A direction by its cosine."""
        return cls(cosine, 1 / cosine, stretched(xp, cosine))

    @classmethod
    def at(cls, cosine: float) -> Slant:
        """A direction that is known beforehand, as numbers that go with the arrays of all namespaces."""
        return cls(cosine, 1 / cosine, float(stretched(NUMPY, cosine)))

    @classmethod
    def pair(cls, geometry: Geometry) -> tuple[Slant, Slant]:
        """The directions to the light and to the viewer."""
        cosines = geometry.cos_theta_i, geometry.cos_theta_r
        over = inverses(*(cosine + BEND for cosine in cosines))
        v = (_v(geometry.xp, cosine * inverse) for cosine, inverse in zip(cosines, over, strict=True))
        i, r = map(cls, cosines, inverses(*cosines), v)
        return i, r


def stretched(xp: Array, cos_theta: Array) -> Array:
    """v, 1 at the vertical and -1 at the horizon, near which all functions of the cosine bend as mu log(mu) does."""
    return _v(xp, cos_theta / (cos_theta + BEND))


def _v(xp: Array, ratio: Array) -> Array:
    return STRETCH * xp.sqrt(ratio) - 1


def inverses(*numbers: Array) -> list[Array]:
    """1 over each of a few numbers, of one division; their product has to be a number, too."""
    inverse = 1 / reduce(mul, numbers)
    if len(numbers) == 2:
        a, b = numbers
        return [b * inverse, a * inverse]
    found = []
    for k in reversed(range(1, len(numbers))):
        before = reduce(mul, numbers[:k])
        found.append(before * inverse)
        inverse = inverse * numbers[k]
    return [inverse, *reversed(found)]
