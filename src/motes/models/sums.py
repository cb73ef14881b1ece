"""The sum of two BRDFs: what ``a + b`` makes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

from motes.arrays import Array
from motes.directions import Geometry
from motes.errors import ParameterError
from motes.models.base import BRDF, Component


@final
@dataclass(frozen=True, eq=False)
class Sum(BRDF):
    """Light reflected by ``a``, and by ``b`` besides."""

    a: BRDF
    b: BRDF

    def __post_init__(self) -> None:
        for part in (self.a, self.b):
            if not isinstance(part, BRDF):
                raise ParameterError(
                    f"Sum: {part!r} is not a BRDF", "A Fresnel term goes inside: TorranceSparrow(fresnel=...)"
                )
        super().__post_init__()

    @property
    def reciprocal(self) -> bool:  # type: ignore[override]
        return self.a.reciprocal and self.b.reciprocal

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return self.a.formula(xp, geometry) + self.b.formula(xp, geometry)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return self.a.components(xp, cos_theta_i) + self.b.components(xp, cos_theta_i)
