r"""Lambert's diffuse surface, the limit sigma_d = 0 of Oren-Nayar.

.. math::  f = K_d / \pi
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self, final

from motes import equations
from motes.arrays import Array
from motes.directions import Geometry
from motes.models.base import BRDF
from motes.models.components import Component
from motes.models.lobes import CosineLobe, Reflection
from motes.models.naming import register
from motes.models.standard import StandardLobe
from motes.parameters import Role, parameter


@register("lambert")
@final
@dataclass(frozen=True, eq=False)
class Lambert(BRDF):
    """A matte surface that looks equally bright from everywhere; its directional albedo is ``K_d``."""

    words: ClassVar[str] = "Lambert"
    approximation: ClassVar[str] = ""

    K_d: Array = parameter(
        0.5,
        bounds=(0, float("inf")),
        typical=(0, 1),
        symbol="K_d",
        doc="diffuse reflectance",
        per_channel=True,
        role=Role.DIFFUSE_COLOUR,
    )

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return self.K_d * equations.INV_PI

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return [Component(self.formula, CosineLobe(), self.K_d)]

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        return [StandardLobe(Reflection.DIFFUSE, values.K_d)]
