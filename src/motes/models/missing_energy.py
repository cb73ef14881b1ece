r"""The share of light from a direction that mirror-like facets of F = 1 do not reflect at once, as formulas fitted to quadrature.

.. math::  M(\mu) = B(X) \, Q(2 \alpha - 1, 2 X - 1)^2, \quad \langle M \rangle = 2 \int_0^1 M \mu \, d\mu = \alpha^2 P(2 r - 1)

For long tails :math:`X = \mu / (\mu + s \alpha)`, :math:`B = (1 - X)^2 X \ln(1 + 1/X)`, :math:`r = \sqrt[4]\alpha`; for Gaussian slopes
:math:`X = \mu / \sqrt{\mu^2 + s^2 \alpha^2}`, :math:`B = (1 - X)^2 X`, :math:`r = \sqrt\alpha`.  M is a square, so never negative, and it goes to 0 at the
horizon and with the roughness, as what it stands for.  Of light that is reflected twice a share q meets a third facet, of that as much a fourth, and so
on: fewer than at first, for such light comes from above its facets.  ``tools/missing_fit.py`` prints the numbers and their errors; `motes.models.facet_albedo`
has the share that is reflected at once, with a Fresnel term.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import final

from motes.arrays import Array
from motes.models.multiple_scattering import polynomial


@dataclass(frozen=True)
class MissingEnergy(ABC):
    """The fitted numbers of one distribution of facets.

    Parameters
    ----------
    scale
        s.
    shape
        The coefficients of Q, a row for each power of alpha.
    average
        Those of P.
    stays
        Those of q, for powers of alpha.
    """

    scale: float
    shape: tuple[tuple[float, ...], ...]
    average: tuple[float, ...]
    stays: tuple[float, ...]

    @abstractmethod
    def frame(self, xp: Array, cos_theta: Array, alpha: Array) -> tuple[Array, Array]:
        """X and B."""

    @abstractmethod
    def pace(self, xp: Array, alpha: Array) -> Array:
        """r."""

    def __call__(self, xp: Array, cos_theta: Array, alpha: Array) -> Array:
        """M for cosines above 0."""
        X, B = self.frame(xp, cos_theta, alpha)
        rough = 2 * alpha - 1
        columns = [polynomial(list(column), rough) for column in zip(*self.shape, strict=True)]
        Q = polynomial(columns, 2 * X - 1)
        return B * (Q * Q)

    def staying(self, xp: Array, alpha: Array) -> Array:
        """q, the share of light reflected twice or more that does not leave then."""
        return polynomial(list(self.stays), alpha)

    def mean(self, xp: Array, alpha: Array) -> Array:
        """The mean of M over uniform light."""
        return alpha * alpha * polynomial(list(self.average), 2 * self.pace(xp, alpha) - 1)


@final
@dataclass(frozen=True)
class LongTails(MissingEnergy):
    """Of slopes whose tails fall off as a power: nothing but a power of alpha is reflected at once less, however narrow the facets."""

    def frame(self, xp: Array, cos_theta: Array, alpha: Array) -> tuple[Array, Array]:
        spread = self.scale * alpha
        inverse = 1 / (cos_theta + spread)
        X, rest = cos_theta * inverse, spread * inverse
        return X, rest * rest * X * xp.log1p((cos_theta + spread) / cos_theta)

    def pace(self, xp: Array, alpha: Array) -> Array:
        return xp.sqrt(xp.sqrt(alpha))


@final
@dataclass(frozen=True)
class GaussianTails(MissingEnergy):
    """Of Gaussian slopes."""

    def frame(self, xp: Array, cos_theta: Array, alpha: Array) -> tuple[Array, Array]:
        spread = self.scale * alpha
        length = xp.sqrt(cos_theta * cos_theta + spread * spread)
        X = cos_theta / length
        rest = spread * spread / (length * (length + cos_theta))  # 1 - X
        return X, rest * rest * X

    def pace(self, xp: Array, alpha: Array) -> Array:
        return xp.sqrt(alpha)


#: Of quadrature within 0.0008; what it gives back, with its mean, within 0.001; q within 0.012.
GGX_MISSING = LongTails(
    scale=2.0,
    shape=(
        (1.5059, 0.9679, 0.3409, 0.3377, 0.3935, 0.1887),
        (1.075, 1.4769, 0.9773, -1.4728, -2.9008, -1.4679),
        (0.0667, 0.0681, -0.7981, -2.3931, -2.331, -0.7179),
        (-0.2592, -0.3527, 0.1511, 1.5097, 2.1269, 0.972),
        (0.0371, 0.1028, 0.9281, 1.9765, 1.4284, 0.2278),
    ),
    average=(3.2679, -4.04233, 2.14877, -1.65077, 1.73811, -1.88252, 1.39481, -0.38289),
    stays=(0.0217, 0.377, 0.0127),
)
#: Within 0.003; with its mean within 0.004; q within 0.009.
BECKMANN_MISSING = GaussianTails(
    scale=3.0,
    shape=(
        (0.8745, -0.8771, -3.5251, -5.2683, -2.7432),
        (0.4814, -1.16, -6.9099, -10.187, -4.7739),
        (1.1281, 2.4812, 1.7793, 1.021, 0.8806),
        (1.4765, 6.4063, 14.0649, 14.9241, 5.6078),
        (0.1819, 2.7777, 10.2751, 13.3547, 5.6893),
        (-0.4911, -0.612, 1.7494, 4.725, 3.1664),
    ),
    average=(0.47445, -0.09409, -0.17786, 0.21384, 0.29802, -0.48034, -0.15051, 0.2532),
    stays=(0.0553, -0.049, 0.1053),
)
