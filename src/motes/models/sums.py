"""The sum of two BRDFs: what ``a + b`` makes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

from motes.arrays import Array
from motes.directions import Geometry
from motes.models.base import BRDF, Component


@final
@dataclass(frozen=True, eq=False)
class Sum(BRDF):
    """Light reflected by ``a``, and by ``b`` besides."""

    a: BRDF
    b: BRDF

    @property
    def reciprocal(self) -> bool:  # type: ignore[override]
        return self.a.reciprocal and self.b.reciprocal

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return self.a.formula(xp, geometry) + self.b.formula(xp, geometry)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return self.a.components(xp, cos_theta_i) + self.b.components(xp, cos_theta_i)
