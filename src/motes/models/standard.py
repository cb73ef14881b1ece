"""`StandardLobe`: a lobe that other programs have too, by which a model says what comes nearest to it there."""

from __future__ import annotations

from dataclasses import dataclass, replace

from motes.arrays import Array
from motes.models.lobes import Reflection

#: The mean of 1/cos over diffuse light (Elsasser 1942), and the cosine that stands for directions that a program does not tell.
DIFFUSIVITY = 1.66
MEAN_COSINE = 1 / DIFFUSIVITY


@dataclass(frozen=True)
class StandardLobe:
    """Plain data: numbers or symbols, as `motes.models.BRDF.standard_lobes` was given them.

    Parameters
    ----------
    reflection
        DIFFUSE: Oren and Nayar's qualitative model, as OSL and MaterialX have it.  GLOSSY: a mirror of facets with Smith's
        shadowing, GGX, or Beckmann where a program has that.
    reflectance
        The share of light that it reflects (of a glossy one: that its facets reflect at grazing incidence), per channel or for all.
    normal
        The share of `reflectance` that a glossy one has at normal incidence; between, Schlick's curve.
    roughness
        Of a diffuse one the standard deviation of the facets' slope angle [rad], of a glossy one alpha of GGX or
        Beckmann: never a square root or a square of these.
    tint
        A constant colour that multiplies `reflectance`; none where it is empty.
    preserving
        Of a diffuse one: it is EON, the energy-preserving form of that lobe, where a program has it; `roughness` is EON's r then.
    distribution
        Of a glossy one: ``ggx`` or ``beckmann`` where it is exactly that distribution of facets; else empty, and each program takes the nearest.
    index
        Of a glossy one: refractive index n and extinction k where its Fresnel term is exactly theirs, for programs that compute it.
    regained
        Of a diffuse one: it is light that the facets of the glossy ones pass on to each other, which programs leave out that give it back themselves.
    """

    reflection: Reflection
    reflectance: Array
    normal: Array = 1.0
    roughness: Array = 0.0
    tint: tuple[float, ...] = ()
    preserving: bool = False
    distribution: str = ""
    index: tuple[Array, Array] | None = None
    regained: bool = False

    def scaled(self, factor: Array) -> StandardLobe:
        """The lobe seen through something that lets a share of its light pass."""
        return replace(self, reflectance=factor * self.reflectance)
