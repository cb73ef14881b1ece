r"""Lambert's diffuse surface, the limit sigma_d = 0 of Oren-Nayar.

.. math::  f = K_d / \pi
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

from motes import equations
from motes.arrays import Array
from motes.directions import Geometry
from motes.models.base import BRDF, Component
from motes.models.lobes import CosineLobe
from motes.parameters import parameter


@final
@dataclass(frozen=True, eq=False)
class Lambert(BRDF):
    """A matte surface that looks equally bright from everywhere; its directional albedo is ``K_d``."""

    K_d: Array = parameter(
        0.5, bounds=(0, float("inf")), typical=(0, 1), symbol="K_d", doc="diffuse reflectance", per_channel=True
    )

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return self.K_d * equations.INV_PI

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return [Component(self.formula, CosineLobe(), self.K_d)]
