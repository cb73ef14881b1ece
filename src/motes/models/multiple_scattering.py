r"""All orders of scattering in a plane layer of Henyey-Greenstein dust, in a form that every printer can print.

The first order is exact and stands with the dust (`motes.models.dust`).  Here is what the others add, as functions of tau, w and g
fitted to adding and doubling (``tools/dust_fit.py``; docs/dust.md has the errors), in a form that is reciprocal and keeps energy
whatever the fitted numbers are.  With :math:`x(\mu) = 1 - e^{-\tau/\mu}`, :math:`v(\mu) = 2.8 \mu / (\mu + 0.4) - 1`, and the cosines
:math:`\mu` to the vertical:

.. math::
   E(\mu) = x(\mu) \sum_k e_k v^k, \qquad t(\mu) = 1 - x(\mu) + x(\mu) \sum_k t_k v^k

are the share of light that leaves above after two or more scatterings, and the share that arrives below.  The higher orders are

.. math::
   f = \frac{E_i E_r}{\pi \bar E} \; C \; \Big[1 + 2 A \sum_{m > 0} \rho^m \cos m \varphi\Big], \quad
   C = 1 + \sum_{ab} c_{ab} (v_i^a - m_a)(v_r^b - m_b), \quad
   \rho = \frac{\sin\theta_i \sin\theta_r}{A C} (d_0 + d_1 (v_i + v_r) + d_2 v_i v_r)

with the means :math:`m_a` of :math:`v^a` with the weight :math:`E \mu`, so that no correction
changes an albedo; :math:`\varphi` is 0 for light that goes on.  The waves in azimuth fall off like powers, and their sum is
:math:`2 \rho (\cos\varphi - \rho) / (1 - 2 \rho \cos\varphi + \rho^2)`, Poisson's kernel less 1, whose mean is 0.
:math:`e_k, t_k, c, d` come out of a small network of algebraic sigmoids, fed with the two-stream solution (Meador and Weaver 1980).
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from functools import cached_property, lru_cache
from importlib import resources
from typing import Any

import numpy as np

from motes.arrays import Array
from motes.directions import Geometry
from motes.equations import INV_PI

#: The optical thickness that stands for a half space, beyond which nothing changes.
INFINITE = 1e30
#: The range of g that the numbers were fitted in.
LEAST_G, MOST_G = -0.75, 0.9
# Smallest k (the decay of diffuse light with depth): below, a layer that loses nothing.
LEAST_DECAY = 1e-5
# Less light than this leaves after several scatterings where there is no dust, or black dust.
LEAST_ESCAPING = 1e-30
ROOT_3 = math.sqrt(3.0)
#: A of the azimuth: the m-th of its waves is A rho^m, as adding and doubling has it within a few hundredths for g up to 0.85.
ONWARD = 1.15
# Where a fit strays: the narrowest peak in azimuth, and the least of its mean.
MOST_ONWARD, LEAST_AROUND = 0.95, 0.05


@lru_cache(maxsize=1)
def _numbers() -> dict[str, Any]:
    text = resources.files("motes.models").joinpath("data/multiple_scattering.json").read_text("utf-8")
    numbers: dict[str, Any] = json.loads(text)
    return numbers


def stretched(cos_theta: Array) -> Array:
    """v, 1 at the vertical and -1 at the horizon, where all functions of the cosine bend."""
    return 2.8 * cos_theta / (cos_theta + 0.4) - 1


def polynomial(coefficients: list[Array], x: Array) -> Array:
    """The sum of coefficients[k] x^k."""
    total = coefficients[-1]
    for coefficient in reversed(coefficients[:-1]):
        total = total * x + coefficient
    return total


@dataclass(frozen=True, eq=False)
class Diffused:
    """What a layer does beyond scattering light once.

    Parameters
    ----------
    xp
        Namespace of the parameters.
    tau, w, g
        Optical thickness, single-scattering albedo, and mean cosine; they broadcast.
    """

    xp: Array
    tau: Array
    w: Array
    g: Array

    # ------------------------------------------------------------ functions of the cosine

    def hit(self, cos_theta: Array) -> Array:
        """The share x of light that meets a particle on its way through."""
        return -self.xp.expm1(-self.tau / cos_theta)

    def escaping(self, cos_theta: Array) -> Array:
        """The share E of light that leaves above after two or more scatterings."""
        return self.hit(cos_theta) * self.xp.maximum(polynomial(self._fitted[0], stretched(cos_theta)), 0.0)

    def arriving(self, cos_theta: Array) -> Array:
        """The share of light that arrives below diffusely, t less what comes straight through."""
        return self.hit(cos_theta) * self.xp.maximum(polynomial(self._fitted[1], stretched(cos_theta)), 0.0)

    def higher_orders(self, geometry: Geometry) -> Array:
        """The BRDF of two and more scatterings [1/sr]."""
        _, _, (c11, c12, c22), (d0, d1, d2), _ = self._fitted
        first, second = self._means
        i, r = stretched(geometry.cos_theta_i), stretched(geometry.cos_theta_r)
        i1, r1, i2, r2 = i - first, r - first, i * i - second, r * r - second
        around = self.xp.maximum(1 + c11 * i1 * r1 + c12 * (i1 * r2 + i2 * r1) + c22 * i2 * r2, LEAST_AROUND)
        wave = geometry.sin_theta_i * geometry.sin_theta_r * (d0 + d1 * (i + r) + d2 * (i * r)) / (ONWARD * around)
        rho = self.xp.maximum(self.xp.minimum(wave, MOST_ONWARD), -MOST_ONWARD)
        # geometry.cos_dphi is 1 towards the light: light that goes on has -1 there.
        across = -geometry.cos_dphi
        onward = 2 * rho * (across - rho) / (1 + rho * (rho - 2 * across))
        escaping = self.escaping(geometry.cos_theta_i) * self.escaping(geometry.cos_theta_r)
        return escaping * (INV_PI / self.mean_escaping) * around * self.xp.maximum(1 + ONWARD * onward, 0.0)

    # ------------------------------------------------------------ means over uniform light

    @cached_property
    def mean_escaping(self) -> Array:
        """The mean of E over uniform light, above 0: a share of it is shared out."""
        return self.xp.maximum(self._mean(self._fitted[0], 0), LEAST_ESCAPING)

    @cached_property
    def mean_arriving(self) -> Array:
        """The share of uniform light that arrives below, straight or diffusely."""
        straight = 1 - self._moments[0]
        return self.xp.maximum(straight + self._mean(self._fitted[1], 0), 0.0)

    @cached_property
    def mean_returned(self) -> Array:
        """The share of uniform light, from above or from below, that leaves on its own side: 1 less what arrives and what is lost.

        It is between 0 and what meets a particle and is scattered: exactly nothing where the dust is black.
        """
        returned = 1 - self.mean_arriving - (1 - self.w) * self._fitted[4]
        return self.xp.maximum(self.xp.minimum(returned, self.w * self._moments[0]), 0.0)

    @cached_property
    def _means(self) -> tuple[Array, Array]:
        """The means of v and of v^2 with the weight E mu."""
        inverse = 1 / self.mean_escaping
        return self._mean(self._fitted[0], 1) * inverse, self._mean(self._fitted[0], 2) * inverse

    def _mean(self, coefficients: list[Array], power: int) -> Array:
        """2 int x sum_k c_k v^(k + power) mu dmu."""
        total: Array = 0.0
        for k, coefficient in enumerate(coefficients):
            total = total + coefficient * self._moments[k + power]
        return total

    @cached_property
    def _moments(self) -> list[Array]:
        """2 int x v^k mu dmu, by quadrature in the root of mu: a thin layer is met at grazing angles."""
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        nodes, weights = 0.5 * (nodes + 1), 0.5 * weights
        moments: list[Array] = [0.0] * (len(self._fitted[0]) + 2)
        for node, weight in zip(nodes.tolist(), weights.tolist(), strict=True):
            mu = node * node
            part = self.hit(mu) * (4 * weight * node * mu)
            for k in range(len(moments)):
                moments[k] = moments[k] + part
                part = part * stretched(mu)
        return moments

    # ------------------------------------------------------------ what was fitted

    @cached_property
    def _fitted(self) -> tuple[list[Array], list[Array], list[Array], list[Array], Array]:
        """e_k, t_k, c, d, and what is lost of uniform light over 1 - w."""
        xp, numbers, w = self.xp, _numbers(), self.w
        features, through, lost = self._two_streams()
        layer = [
            (feature - mean) * (1 / deviation)
            for feature, mean, deviation in zip(features, numbers["mean"], numbers["deviation"], strict=True)
        ]
        for weights, offsets in zip(numbers["weights"][:-1], numbers["offsets"][:-1], strict=True):
            layer = [_sigmoid(xp, value) for value in _affine(layer, weights, offsets)]
        out = _affine(layer, numbers["weights"][-1], numbers["offsets"][-1])
        n = (len(out) - 7) // 2
        met = w * w * (1 - 1 / (1 + self.tau * (1 - w * self.g)))
        escaping = [met * value for value in out[:n]]
        arriving = [through * value for value in out[n : 2 * n]]
        return escaping, arriving, out[2 * n : 2 * n + 3], out[2 * n + 3 : 2 * n + 6], lost * out[-1]

    def _two_streams(self) -> tuple[list[Array], Array, Array]:
        """What the network is fed with; about what arrives below; and what two streams lose over 1 - w.

        Quadrature two-stream of Meador and Weaver (1980) under uniform light, in tanh(k tau / 2) / k: nothing cancels for w = 1.
        Deep in a layer that absorbs light fades more slowly than two streams say: k = 1 where w = 0.
        """
        xp, tau, w, g = self.xp, self.tau, self.w, self.g
        loss, opacity = 1 - w, 1 - w * g
        similarity = xp.sqrt(xp.maximum(loss / opacity, 1e-10))
        gained, half = _half_tangent(xp, 3 * loss * opacity, tau)
        denominator = 1 / (1 + gained + ROOT_3 * (loss + opacity) * half)
        through = (1 - gained) * denominator
        lost = 2 * half * (3 * opacity * half + ROOT_3) * denominator
        features = [
            similarity,
            w,
            g,
            1 - 1 / (1 + tau),
            1 - 1 / (1 + tau * opacity),
            through,
            1 - through - loss * lost,
            xp.exp(-tau),
        ]
        gained, half = _half_tangent(xp, 3 * loss * opacity / (1 + 2 * loss), tau)
        deep = w * (1 - gained) / (1 + gained + 0.5 * ROOT_3 * opacity * half)
        return features, deep, lost


def _half_tangent(xp: Array, decay_squared: Array, tau: Array) -> tuple[Array, Array]:
    """tanh(k tau / 2) squared, and over k, for k^2."""
    decay = xp.maximum(xp.sqrt(xp.maximum(decay_squared, 1e-10)), LEAST_DECAY)
    faded = xp.expm1(-decay * tau)
    half = -faded / (decay * (2 + faded))
    return decay * half * (decay * half), half


#: Of the quadrature over cosines.
NODES = 12


def _sigmoid(xp: Array, x: Array) -> Array:
    """x / sqrt(1 + x^2)."""
    return x * (1 / xp.sqrt(1 + x * x))


def _affine(values: list[Array], weights: list[list[float]], offsets: list[float]) -> list[Array]:
    """values @ weights + offsets."""
    result = []
    for column, offset in enumerate(offsets):
        total: Array = offset
        for value, row in zip(values, weights, strict=True):
            total = total + value * row[column]
        result.append(total)
    return result
