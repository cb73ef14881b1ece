"""The angle bases of WINDOW (Klems): patches of the hemisphere, rings of equal polar angles cut into equal azimuths.

A patch j of n in a ring is centred on the azimuth 2 pi j/n.  In the coordinates of the files an incident direction is
named by where its light goes: the mirror reflection of the incident patch (theta, phi) is the outgoing patch
(theta, phi), so the vector to the light has the azimuth phi + pi (Radiance's ``bsdf_m.c`` does the same).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from motes import directions

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class AngleBasis:
    """Patches of the hemisphere.

    Parameters
    ----------
    name
        Such as ``"LBNL/Klems Full"``.
    edges
        Polar angles [deg] between the rings, one more than there are rings, from 0 to 90.
    counts
        Patches of each ring.
    """

    name: str
    edges: tuple[float, ...]
    counts: tuple[int, ...]

    @property
    def size(self) -> int:
        return sum(self.counts)

    @cached_property
    def ring(self) -> NDArray[np.intp]:
        """The ring (n,) of each patch."""
        return np.repeat(np.arange(len(self.counts)), self.counts)

    @cached_property
    def theta(self) -> Array:
        """The polar angle (n,) [rad] in the middle of each patch; 0 for a cap about the normal."""
        edges = np.deg2rad(self.edges)
        middle = (edges[1:] + edges[:-1]) / 2
        if self.counts[0] == 1 and edges[0] == 0:
            middle[0] = 0.0
        return middle[self.ring]

    @cached_property
    def phi(self) -> Array:
        """The azimuth (n,) [rad] in the middle of each patch."""
        return np.concatenate([np.arange(n) * (2 * np.pi / n) for n in self.counts])

    @cached_property
    def solid_angle(self) -> Array:
        """(n,) [sr]."""
        rings = -np.diff(np.cos(np.deg2rad(self.edges))) * 2 * np.pi / np.array(self.counts)
        return np.asarray(rings[self.ring])

    @cached_property
    def projected_solid_angle(self) -> Array:
        """(n,) [sr], the solid angle with the cosine: what Klems calls lambda."""
        rings = -np.diff(np.cos(np.deg2rad(self.edges)) ** 2) * np.pi / np.array(self.counts)
        return np.asarray(rings[self.ring])

    def centres(self) -> Array:
        """Outgoing directions (n, 3) in the middle of the patches."""
        return directions.from_spherical(self.theta, self.phi)

    def points(self, per_axis: int) -> Array:
        """Directions (n, per_axis^2, 3) spread over each patch, each standing for the same projected solid angle."""
        fraction = (np.arange(per_axis) + 0.5) / per_axis
        cos2 = np.cos(np.deg2rad(self.edges)) ** 2
        squared = (cos2[:-1, None] + fraction * np.diff(cos2)[:, None])[self.ring]  # (n, per_axis)
        width = (2 * np.pi / np.array(self.counts))[self.ring, None]
        azimuth = self.phi[:, None] + (fraction - 0.5) * width
        cos, sin = np.sqrt(squared)[:, :, None], np.sqrt(1 - squared)[:, :, None]
        x, y = sin * np.cos(azimuth)[:, None, :], sin * np.sin(azimuth)[:, None, :]
        return np.stack([x, y, np.broadcast_to(cos, x.shape)], axis=-1).reshape(self.size, per_axis**2, 3)


KLEMS = {
    basis.name.lower(): basis
    for basis in (
        AngleBasis("LBNL/Klems Full", (0, 5, 15, 25, 35, 45, 55, 65, 75, 90), (1, 8, 16, 20, 24, 24, 24, 16, 12)),
        AngleBasis("LBNL/Klems Half", (0, 6.5, 19.5, 32.5, 45.5, 58.5, 71.5, 90), (1, 8, 12, 16, 20, 12, 8)),
        AngleBasis("LBNL/Klems Quarter", (0, 9, 27, 45, 63, 90), (1, 8, 12, 12, 8)),
    )
}


def towards_light(outgoing: Array) -> Array:
    """Vectors to the light for incident patches whose outgoing directions are given (..., 3): turned by pi about z."""
    return np.asarray(outgoing * np.array([-1.0, -1.0, 1.0]))
