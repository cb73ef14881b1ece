"""What a BRDF is made of: components, each with the lobe that samples it and what kind of reflection it is."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass

from motes.arrays import Array
from motes.directions import Geometry
from motes.models.lobes import Lobe, Reflection
from motes.parameters import Parametrised


@dataclass(frozen=True)
class Component:
    """A part of a BRDF with the lobe that samples it.

    Parameters
    ----------
    formula
        ``formula(xp, geometry)`` is the part's value [1/sr].
    lobe
        Chooses its directions.
    importance
        About the share of light that it reflects, a number or an array that broadcasts against directions.
    kind
        What kind of reflection it is; that of its lobe where nothing is said.
    """

    formula: Callable[[Array, Geometry], Array]
    lobe: Lobe
    importance: Array
    kind: Reflection | None = None

    @property
    def reflection(self) -> Reflection:
        """What kind of reflection it is."""
        return self.lobe.reflection if self.kind is None else self.kind


@dataclass(frozen=True, eq=False)
class Reflecting(Parametrised, ABC):
    """What has components."""

    @abstractmethod
    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        """The parts that are sampled and integrated each in its own way; their formulas add up to the BRDF's."""

    def reflected(self, xp: Array, cos_theta_i: Array) -> Array:
        """The share of light from a direction that is reflected, as far as a formula tells: the sum of what the components say.

        `BRDF.directional_albedo` integrates; this is for formulas that need the albedo of what lies below.
        """
        total: Array = 0.0
        for component in self.components(xp, cos_theta_i):
            total = total + component.importance
        return total

    def spread(self) -> Array | None:
        """The width of its highlight, as the roughness alpha of the GGX that is most like it; None for what has no highlight.

        Dust above blurs what has one, by light that it bends.  Of a sum, its terms are asked.
        """
        return None
