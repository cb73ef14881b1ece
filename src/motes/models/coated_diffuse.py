r"""A diffuse body under a smooth dielectric interface, coupled by Fresnel's equations.

.. math::  f = \frac{\rho}{\pi} \frac{(1 - F(\theta_i)) (1 - F(\theta_r))}{n^2 (1 - \rho F_{in})}, \quad
           F_{in} = 1 - \frac{1 - F_{out}}{n^2}

F_out and F_in are the mean reflectances of the interface for diffuse light from outside and from inside.

Source: L. B. Wolff, "Diffuse-reflectance model for smooth dielectric surfaces", JOSA A 11(11), 1994; J. L. Saunderson, JOSA 32(12), 1942
(light that is reflected inside again and again); F_in by reciprocity, D. B. Judd, J. Res. NBS 29, 1942."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self, final

from motes import equations
from motes.arrays import Array
from motes.directions import Geometry
from motes.models.base import BRDF
from motes.models.components import Component
from motes.models.fresnel import diffuse_rule
from motes.models.lobes import CosineLobe, Reflection
from motes.models.naming import register
from motes.models.standard import StandardLobe
from motes.parameters import Role, parameter

_RULE = diffuse_rule(8)


def transmittance(xp: Array, cos_theta: Array, n: Array) -> Array:
    """1 - F of `motes.equations.fresnel_dielectric`, multiplied out so that it does not cancel towards grazing."""
    q = xp.sqrt((n - 1) * (n + 1) + cos_theta * cos_theta)
    s, p = cos_theta + q, n * n * cos_theta + q
    return 2 * cos_theta * q * (1 / (s * s) + n * n / (p * p))


def diffuse_reflectance(xp: Array, n: Array) -> Array:
    """F_out, the mean of F for diffuse light from outside, 2 times the integral of F mu: within 1e-5 for n up to 4."""
    total: Array = 0.0
    for mu, weight in _RULE:
        total = total + weight * equations.fresnel_dielectric(xp, mu, n)
    return total


@register("coated_diffuse")
@final
@dataclass(frozen=True, eq=False)
class CoatedDiffuse(BRDF):
    """What comes back from below a gloss: paint, varnished wood, plastic, glazed clay. Its highlight is another model: ``+ GGX(...)``.

    Notes
    -----
    Towards grazing the interface lets less light in and out, so the body darkens where a rough diffuse surface brightens.  With n = 1 it is
    `Lambert`.  With rho = 1 and a perfect mirror of the same n on top, all light comes back."""

    words: ClassVar[str] = "Lambert under a dielectric interface"
    approximation: ClassVar[str] = (
        "A body under an interface: a diffuse lobe that reflects as much uniform light; it does not darken towards grazing."
    )

    rho: Array = parameter(
        0.5,
        bounds=(0, 1),
        symbol="\\rho",
        doc="diffuse reflectance of the body, as seen from inside",
        per_channel=True,
        role=Role.DIFFUSE_COLOUR,
        advice="It is an albedo: scale radiances to at most 1, or take lambert, which allows any K_d",
    )
    n: Array = parameter(
        1.5,
        bounds=(1, 4),
        fit_bounds=(1, 3),
        typical=(1.2, 2),
        starts=(1.2, 1.5, 2.0),
        symbol="n",
        doc="refractive index of the body relative to the outside",
        role=Role.REFRACTIVE_INDEX,
        advice="Water 1.33, glass and varnish 1.5, diamond 2.4",
        simpler=1.0,
    )

    def _share(self, xp: Array, rho: Array) -> Array:
        """What the interface makes of the body's reflectance, but for the two transmittances."""
        lets_out = (1 - diffuse_reflectance(xp, self.n)) / (self.n * self.n)
        return rho / (self.n * self.n * (1 - rho * (1 - lets_out)))

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        into = transmittance(xp, geometry.cos_theta_i, self.n)
        out = transmittance(xp, geometry.cos_theta_r, self.n)
        return equations.INV_PI * (into * out) * self._share(xp, self.rho)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        into = transmittance(xp, cos_theta_i, self.n)
        through = (1 - diffuse_reflectance(xp, self.n)) * into
        return [Component(self.formula, CosineLobe(), self._share(xp, self.rho) * through)]

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        through = 1 - diffuse_reflectance(xp, values.n)
        return [StandardLobe(Reflection.DIFFUSE, values._share(xp, values.rho) * (through * through))]
