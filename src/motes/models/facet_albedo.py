r"""The share of light from a direction that mirror-like facets reflect, as formulas fitted to quadrature: ``tools/albedo_fit.py``.

.. math::  E(\mu) = F(\mu_F) \Big[1 - (1 - X)^p \sum_{jk} c_{jk} \alpha^j X^k\Big], \quad X = \frac{\mu}{\mu + s \alpha}

What is missing from 1 are reflections at further facets, which no single reflection counts.  :math:`\mu_F` is the cosine at which
the facets in sight are met: that of the direction, but for grazing ones.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from motes.arrays import Array

# Beyond it the formula for the cosine at the facets ends.
WIDEST = 0.9
#: The alpha of the GGX that is most like a Gaussian highlight under dust, over its width: found with the numbers of `motes.models.bending`.
GAUSSIAN_SPREAD = 0.835


@dataclass(frozen=True)
class FacetAlbedo:
    """The fitted numbers of one distribution of facets.

    Parameters
    ----------
    scale, power
        s and p.
    lost
        c, a row for each power of alpha.
    grazing
        u = a alpha (1 + b alpha) and c in mu_F = (mu + u^2 (1 - mu)/(mu + u)) / (1 + c alpha^2).
    """

    scale: float
    power: int
    lost: tuple[tuple[float, ...], ...]
    grazing: tuple[float, float, float]

    def __call__(self, xp: Array, cos_theta: Array, alpha: Array, fresnel: Callable[[Array, Array], Array]) -> Array:
        """E for ``fresnel(xp, cosine)``."""
        near = self.scale * alpha / (cos_theta + self.scale * alpha)
        far = 1 - near
        total: Array = 0.0
        for k in reversed(range(len(self.lost[0]))):
            total = total * far + _polynomial([row[k] for row in self.lost], alpha)
        lost = near * total if self.power == 1 else near * near * total
        return fresnel(xp, self.met(xp, cos_theta, alpha)) * (1 - lost)

    def met(self, xp: Array, cos_theta: Array, alpha: Array) -> Array:
        """mu_F, the cosine at which the facets in sight are met."""
        a, b, c = self.grazing
        width = xp.minimum(alpha, WIDEST)
        u = a * width * (1 + b * width)
        met = (cos_theta + u * u * (1 - cos_theta) / (cos_theta + u)) / (1 + c * width * width)
        return xp.minimum(met, 1.0)


def _polynomial(coefficients: list[float], x: Array) -> Array:
    total: Array = coefficients[-1]
    for coefficient in reversed(coefficients[:-1]):
        total = total * x + coefficient
    return total


#: Of quadrature within 0.006, at roughnesses up to 1; with a dielectric, towards the horizon, within 0.07.
GGX_ALBEDO = FacetAlbedo(
    1.7,
    2,
    (
        (0.0082, 0.0588, 3.0544, -3.2088),
        (0.0026, 0.6082, -4.3404, 3.1941),
        (0.0301, 4.9388, -1.3631, 25.4492),
        (-0.0074, -0.9775, -6.0797, -1.5368),
    ),
    (1.694, -0.976, -0.214),
)
#: Within 0.024; with a dielectric within 0.03 for alpha up to 0.7.
BECKMANN_ALBEDO = FacetAlbedo(
    2.0,
    2,
    (
        (-0.1019, 1.7174, -3.5095, 1.71),
        (0.6391, -8.9891, 35.0654, -25.1052),
        (-0.9374, 10.5775, -20.9862, -55.6672),
        (0.3606, -0.6809, -24.7471, 132.4208),
    ),
    (1.029, -0.874, -0.546),
)
#: Of facets whose projected area is 1, within 0.022 for sigma_s up to 0.7 and 0.04 for all; with a dielectric within 0.06.
TORRANCE_SPARROW_ALBEDO = FacetAlbedo(
    2.0,
    1,
    (
        (-0.0929, 1.4891, -2.9344, 1.555),
        (0.3722, -5.4322, 10.6289, -5.7677),
        (-0.3484, 4.1921, 11.2069, -26.783),
        (0.082, 0.1445, -14.4916, 32.4303),
    ),
    (0.802, -1.104, -0.868),
)
