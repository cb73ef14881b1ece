"""Fresnel reflection F of equation (9), evaluated at the facet, cos = wi . wh.  The source sets F = 1."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import final

import numpy as np

from motes import equations
from motes.arrays import Array
from motes.models.naming import register
from motes.parameters import Parametrised, Role, parameter


def diffuse_rule(count: int) -> tuple[tuple[float, float], ...]:
    """Cosines and weights of a mean over uniform light, 2 times an integral of mu: Gauss and Legendre's over mu = x^2, dense at the horizon, where F rises."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    x = 0.5 * (nodes + 1)
    return tuple(zip((x * x).tolist(), (2 * weights * x**3).tolist(), strict=True))


_RULE = diffuse_rule(4)


@dataclass(frozen=True, eq=False)
class Fresnel(Parametrised, ABC):
    """The share of light that a smooth facet reflects."""

    @abstractmethod
    def reflectance(self, xp: Array, cos_theta_d: Array) -> Array:
        """Unpolarised reflectance in [0, 1] at the angle of incidence on the facet."""

    @abstractmethod
    def at_normal(self) -> Array:
        """`reflectance` at normal incidence, by arithmetic alone: what programs take that draw Schlick's curve from it."""

    def mean(self, xp: Array) -> Array:
        """The mean of `reflectance` over uniform light, 2 times the integral of F mu.

        Of dielectrics and of metals (k >= 1) within 0.0005; where light is reflected in whole beyond an angle (n < 1 and k near 0) within 0.21.
        """
        total: Array = 0.0
        for cosine, weight in _RULE:
            total = total + weight * self.reflectance(xp, cosine)
        return total

    def index(self) -> tuple[Array, Array] | None:
        """Refractive index and extinction, where the term is exactly theirs."""
        return None


@register("dielectric")
@final
@dataclass(frozen=True, eq=False)
class Dielectric(Fresnel):
    """Glass, varnish, plastic, water: a real refractive index; exact."""

    n: Array = parameter(
        1.5,
        bounds=(1, 10),
        fit_bounds=(1.02, 4),
        starts=(1.2, 1.5, 2.2),
        symbol="n",
        doc="refractive index relative to the outside",
        per_channel=True,
        shared_in_fit=True,
        role=Role.REFRACTIVE_INDEX,
        advice="Water 1.33, glass and varnish 1.5, diamond 2.4",
    )

    def reflectance(self, xp: Array, cos_theta_d: Array) -> Array:
        return equations.fresnel_dielectric(xp, cos_theta_d, self.n)

    def at_normal(self) -> Array:
        return equations.fresnel_normal(self.n, 0.0)

    def index(self) -> tuple[Array, Array] | None:
        return self.n, 0.0


@register("conductor")
@final
@dataclass(frozen=True, eq=False)
class Conductor(Fresnel):
    """Metals: a complex refractive index n + ik; exact."""

    n: Array = parameter(
        1.0,
        bounds=(0.01, 20),
        fit_bounds=(0.05, 10),
        starts=(0.3, 2.0),
        symbol="n",
        doc="real part of the refractive index",
        per_channel=True,
        shared_in_fit=True,
        role=Role.REFRACTIVE_INDEX,
    )
    k: Array = parameter(
        3.0,
        bounds=(0, 30),
        fit_bounds=(0, 15),
        starts=(1.5, 5.0),
        symbol="k",
        doc="extinction coefficient",
        per_channel=True,
        shared_in_fit=True,
        role=Role.EXTINCTION,
    )

    def reflectance(self, xp: Array, cos_theta_d: Array) -> Array:
        return equations.fresnel_conductor(xp, cos_theta_d, self.n, self.k)

    def at_normal(self) -> Array:
        return equations.fresnel_normal(self.n, self.k)

    def index(self) -> tuple[Array, Array] | None:
        return self.n, self.k


@register("schlick")
@final
@dataclass(frozen=True, eq=False)
class Schlick(Fresnel):
    """Schlick's approximation from the reflectance at normal incidence: one parameter, good for a fit."""

    f0: Array = parameter(
        0.04,
        bounds=(0, 1),
        starts=(0.03, 0.3),
        symbol="f_0",
        doc="reflectance at normal incidence",
        per_channel=True,
        shared_in_fit=True,
        role=Role.NORMAL_REFLECTANCE,
        simpler=1.0,
    )

    def reflectance(self, xp: Array, cos_theta_d: Array) -> Array:
        return equations.fresnel_schlick(xp, cos_theta_d, self.f0)

    def at_normal(self) -> Array:
        return self.f0

    def mean(self, xp: Array) -> Array:
        return (20 * self.f0 + 1) / 21  # exactly
