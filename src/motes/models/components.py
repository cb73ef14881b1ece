"""What a BRDF is made of: components, each with the lobe that samples it and what kind of reflection it is."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

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

    def reflecting(self, xp: Array) -> Callable[[Array], Array]:
        """`reflected` as a function of the cosine alone, for callers with many: what does not depend on it is then computed once."""
        return partial(self.reflected, xp)

    def leans(self) -> bool:
        """Whether what it reflects depends on directions so much that dust above must tell light that it scattered forward from uniform light."""
        return False

    def spread(self) -> Array | None:
        """The width of its highlight, as the roughness alpha of the GGX that is most like it; None for what has no highlight.

        Dust above blurs what has one, by light that it bends.  Of a sum, its terms are asked.
        """
        return None


@dataclass(frozen=True, eq=False)
class Piece(Reflecting):
    """A part of a BRDF as dust above sees it, where that is not a BRDF of its own.

    Parameters
    ----------
    formula
        ``formula(xp, geometry)`` is its value [1/sr].
    albedo
        ``albedo(xp)`` is a function of the cosine: the share of light that it reflects.
    parts
        ``parts(xp, cos_theta_i)`` are its components.
    width
        What `spread` says.
    leaning
        What `leans` says of a piece that is no highlight.
    """

    formula: Callable[[Array, Geometry], Array]
    albedo: Callable[[Array], Callable[[Array], Array]]
    parts: Callable[[Array, Array], list[Component]]
    width: Array | None
    leaning: bool = True

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return self.parts(xp, cos_theta_i)

    def reflected(self, xp: Array, cos_theta_i: Array) -> Array:
        return self.albedo(xp)(cos_theta_i)

    def reflecting(self, xp: Array) -> Callable[[Array], Array]:
        return self.albedo(xp)

    def leans(self) -> bool:
        return self.leaning and self.width is None

    def spread(self) -> Array | None:
        return self.width
