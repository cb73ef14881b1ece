"""Light between a layer of dust and what lies below it: brought down diffusely, reflected to and fro, and let out again."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from motes.arrays import Array
from motes.directions import Geometry
from motes.equations import INV_PI
from motes.models.components import Reflecting
from motes.models.multiple_scattering import Diffused

# A base that reflects more than it receives, under a layer that gives back nearly all, would multiply light without end.
LEAST_LOSS = 1e-3
# Of the mean albedo of the base over uniform light.
NODES = 6


@dataclass(frozen=True, eq=False)
class Exchange:
    """What a layer adds to what goes straight through it and to what it scatters once.

    Light that was scattered counts as uniform where it meets the base, and light from the base that does not leave straight as
    uniform where it meets the layer.  Over a Lambertian base that is the exact sum over all reflections between the two; with
    a directional albedo a(mu) of another base it is reciprocal and, as far as a is that of the base, loses no light.
    """

    base: Reflecting
    layer: Diffused

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        """The BRDF [1/sr] of it all."""
        layer, i, r = self.layer, geometry.cos_theta_i, geometry.cos_theta_r
        straight_i, straight_r = 1 - layer.hit(i), 1 - layer.hit(r)
        diffuse_i, diffuse_r = layer.arriving(i), layer.arriving(r)
        lit_i, lit_r = straight_i * self.base.reflected(xp, i), straight_r * self.base.reflected(xp, r)
        exchanged = (
            lit_i * diffuse_r
            + lit_r * diffuse_i
            + layer.mean_returned * lit_i * lit_r
            + self.mean_reflected * diffuse_i * diffuse_r
        )
        return layer.higher_orders(geometry) + exchanged * (INV_PI * self._multiplied)

    def importance(self, cos_theta_i: Array) -> Array:
        """About the share of light that it is."""
        layer = self.layer
        below = (1 - layer.hit(cos_theta_i)) * layer.mean_returned + layer.arriving(cos_theta_i)
        return layer.escaping(cos_theta_i) + below * self.mean_reflected * self._multiplied * layer.mean_arriving

    @cached_property
    def mean_reflected(self) -> Array:
        """The share of uniform light that the base reflects."""
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        total: Array = 0.0
        for node, weight in zip((0.5 * (nodes + 1)).tolist(), (0.5 * weights).tolist(), strict=True):
            total = total + self.base.reflected(self.layer.xp, node) * (2 * weight * node)
        return total

    @cached_property
    def _multiplied(self) -> Array:
        """The sum over reflections between the two."""
        return 1 / self.layer.xp.maximum(1 - self.mean_reflected * self.layer.mean_returned, LEAST_LOSS)
