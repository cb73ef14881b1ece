r"""All orders of scattering in a plane layer of Henyey-Greenstein dust, in a form that every printer can print.

The first order is exact and stands with the dust (`motes.models.dust`).  Here is what the others add, as functions of tau, w and g
fitted to adding and doubling (``tools/dust_fit.py``; docs/dust.md has the errors), in a form that is reciprocal and keeps energy
whatever the fitted numbers are.  With :math:`x(\mu) = 1 - e^{-\tau/\mu}`, :math:`v(\mu) = 2 \sqrt{1.5 \mu / (\mu + 0.5)} - 1`, the
cosines :math:`\mu` to the vertical, and :math:`p_k = v^k` for k up to 6 and :math:`p_7 = 1 - x`, which bends where x does:

.. math::
   S(\mu) = w x(\mu) \sum_k s_k p_k, \qquad E(\mu) = x(\mu) \sum_k e_k p_k, \qquad t(\mu) = 1 - x(\mu) + x(\mu) \sum_k t_k p_k

are the shares of light that leave above after one scattering, and after two or more, and the share that arrives below.  One more
polynomial, n, says what is lost, :math:`(1 - w) x (1 + w L n)`, with L that of two streams.  What these leave unsaid,

.. math:: 1 - S - E - t - (1 - w) x (1 + w L n),

would be nothing if all were exact.  It is added to E and to t, to E in thick layers and to t in thin ones: so white dust loses no
light but for what errs in the albedo S of the exact first order, a function of tau and g alone.  The higher orders are

.. math::
   f = \frac{E_i E_r}{\pi \bar E} \; C \; \Big[1 + 2 A \sum_{m > 0} \rho^m \cos m \varphi\Big], \quad
   C = 1 + \sum_{ab} c_{ab} (v_i^a - m_a)(v_r^b - m_b), \quad
   \rho = \frac{\sin\theta_i \sin\theta_r}{A C} (d_0 + d_1 (v_i + v_r) + d_2 v_i v_r)

with the means :math:`m_a` of :math:`v^a` with the weight :math:`E \mu`, so that no correction
changes an albedo; :math:`\varphi` is 0 for light that goes on.  The waves in azimuth fall off like powers, and their sum is
:math:`2 \rho (\cos\varphi - \rho) / (1 - 2 \rho \cos\varphi + \rho^2)`, Poisson's kernel less 1, whose mean is 0.
:math:`e_k, t_k, n_k, c, d` come out of a small network of algebraic sigmoids, fed with the two-stream solution (Meador and Weaver
1980), and :math:`s_k` of a smaller one, of tau and g.
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
from motes.models.slants import Slant

#: The optical thickness that stands for a half space, beyond which nothing changes.
INFINITE = 1e30
#: The range of g that the numbers were fitted in.
LEAST_G, MOST_G = -0.75, 0.9
# Smallest k (the decay of diffuse light with depth): below, a layer that loses nothing.
LEAST_DECAY = 1e-5
# Less light than this leaves after several scatterings where there is no dust, or black dust.
LEAST_ESCAPING = 1e-30
ROOT_3 = math.sqrt(3.0)
#: Of v in S, E and t; and how many numbers of the network are for E, for t and for n.
POWERS, OWN_TERMS, LOST_TERMS = 7, 6, 4
#: A of the azimuth: the m-th of its waves is A rho^m, as adding and doubling has it within a few hundredths for g up to 0.85.
ONWARD = 1.15
# Where a fit strays: the narrowest peak in azimuth, and the least of its mean.  Up to that peak A is below (1 + rho) / (2 rho), so that
# nothing is negative across from it, nor has to be cut off: that would change an albedo.
MOST_ONWARD, LEAST_AROUND = 0.76, 0.05


@lru_cache(maxsize=1)
def _numbers() -> dict[str, Any]:
    text = resources.files("motes.models").joinpath("data/multiple_scattering.json").read_text("utf-8")
    numbers: dict[str, Any] = json.loads(text)
    return numbers


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

    def straight(self, slant: Slant) -> Array:
        """The share 1 - x of light that meets no particle on its way through."""
        return self.xp.exp(-self.tau * slant.inverse)

    def hit(self, slant: Slant) -> Array:
        """The share x of light that meets a particle on its way through."""
        return -self.xp.expm1(-self.tau * slant.inverse)

    def escaping(self, slant: Slant) -> Array:
        """The share E of light that leaves above after two or more scatterings."""
        return self._share(self._fitted[0], slant)

    def returned_once(self, slant: Slant) -> Array:
        """The share S of light that leaves above after one scattering."""
        return self.w * self._share(self._fitted[2], slant)

    def arriving(self, slant: Slant) -> Array:
        """The share of light that arrives below diffusely, t less what comes straight through."""
        return self._share(self._fitted[1], slant)

    def _share(self, coefficients: list[Array], slant: Slant) -> Array:
        """x times what was fitted."""
        return self.hit(slant) * self._of_hit(coefficients, slant)

    def _of_hit(self, coefficients: list[Array], slant: Slant) -> Array:
        """What was fitted, a polynomial in v and a share of 1 - x, as far as it is above 0."""
        fitted = polynomial(coefficients[:-1], slant.v) + coefficients[-1] * self.straight(slant)
        return self.xp.maximum(fitted, 0.0)

    def higher_orders(self, geometry: Geometry, i: Slant, r: Slant) -> Array:
        """The BRDF of two and more scatterings [1/sr]; `i` and `r` are the slants of the geometry.

        All in terms of A C and of A C rho: so there is one division.
        """
        xp, (root, around, (d0, d1, d2)) = self.xp, self._pairing
        both, product = i.v + r.v, i.v * r.v
        mean = around[0] + both * (around[1] + around[3] * both + around[4] * product)
        mean = xp.maximum(mean + product * (around[2] + around[5] * product), ONWARD * LEAST_AROUND)
        wave = geometry.sin_theta_i * geometry.sin_theta_r * (d0 + d1 * both + d2 * product)
        most = MOST_ONWARD * mean
        wave = xp.maximum(xp.minimum(wave, most), -most)
        # geometry.cos_dphi is 1 towards the light: light that goes on has -1 there.
        across = -geometry.cos_dphi * mean
        onward = wave * (across - wave) / (mean * mean + wave * (wave - 2 * across))
        # All channels share the first of these products.
        hit = self.hit(i) * self.hit(r)
        return hit * (self._of_hit(root, i) * self._of_hit(root, r) * (mean * (1 + (2 * ONWARD) * onward)))

    @cached_property
    def _pairing(self) -> tuple[list[Array], list[Array], list[Array]]:
        """Of `higher_orders`: e_k / sqrt(pi A mean E); A C in powers of v_i + v_r and v_i v_r; and d.

        A C is multiplied out: two slants then have it in six terms, of which channels share all but the coefficients.
        """
        escaping, _, _, (c11, c12, c22), wave = self._fitted
        first, second = self._means
        squares = -(c12 * first + c22 * second)
        around = [
            1 + c11 * (first * first) + c12 * (2 * first * second) + c22 * (second * second),
            -(c11 * first + c12 * second),
            c11 - 2 * squares,
            squares,
            c12,
            c22,
        ]
        root = self.xp.sqrt((INV_PI / ONWARD) / self.mean_escaping)
        return [root * e for e in escaping], [ONWARD * a for a in around], wave

    # ------------------------------------------------------------ means over uniform light

    @cached_property
    def mean_escaping(self) -> Array:
        """The mean of E over uniform light, above 0: a share of it is shared out."""
        return self.xp.maximum(self._mean(self._fitted[0], 0), LEAST_ESCAPING)

    @cached_property
    def mean_arriving(self) -> Array:
        """The share of uniform light that arrives below, straight or diffusely."""
        return self.xp.maximum(self.mean_straight + self._mean(self._fitted[1], 0), 0.0)

    @property
    def mean_straight(self) -> Array:
        """The share of uniform light that meets no particle on its way through."""
        return 1 - self._moments[0][0]

    @cached_property
    def mean_returned(self) -> Array:
        """The share of uniform light, from above or from below, that leaves on its own side, after one scattering or more.

        It is between 0 and what meets a particle and is scattered: exactly nothing where the dust is black.
        """
        returned = self.w * self._mean(self._fitted[2], 0) + self._mean(self._fitted[0], 0)
        return self.xp.maximum(self.xp.minimum(returned, self.w * self._moments[0][0]), 0.0)

    @cached_property
    def _means(self) -> tuple[Array, Array]:
        """The means of v and of v^2 with the weight E mu."""
        inverse = 1 / self.mean_escaping
        return self._mean(self._fitted[0], 1) * inverse, self._mean(self._fitted[0], 2) * inverse

    def _mean(self, coefficients: list[Array], power: int) -> Array:
        """2 int x (sum_k c_k v^k + c (1 - x)) v^power mu dmu."""
        of_hit, of_both = self._moments
        total = coefficients[-1] * of_both[power]
        for k, coefficient in enumerate(coefficients[:-1]):
            total = total + coefficient * of_hit[k + power]
        return total

    @cached_property
    def _moments(self) -> tuple[list[Array], list[Array]]:
        """2 int x v^k mu dmu and 2 int x (1 - x) v^k mu dmu, by quadrature in the root of mu: a thin layer is met at grazing angles."""
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        nodes, weights = 0.5 * (nodes + 1), 0.5 * weights
        of_hit: list[Array] = [0.0] * (POWERS + 2)
        of_both: list[Array] = [0.0] * 3
        for node, weight in zip(nodes.tolist(), weights.tolist(), strict=True):
            slant = Slant.at(node * node)
            part = self.hit(slant) * (4 * weight * node * slant.cosine)
            both = part * self.straight(slant)
            for k in range(len(of_hit)):
                of_hit[k] = of_hit[k] + part
                part = part * slant.v
            for k in range(len(of_both)):
                of_both[k] = of_both[k] + both
                both = both * slant.v
        return of_hit, of_both

    # ------------------------------------------------------------ what was fitted

    @cached_property
    def _fitted(self) -> tuple[list[Array], list[Array], list[Array], list[Array], list[Array]]:
        """e_k, t_k, s_k, c, d."""
        numbers, w = _numbers(), self.w
        features, through, lost = self._two_streams()
        out = _network(self.xp, features, numbers)
        once = _network(self.xp, once_features(self.xp, self.tau, self.g), numbers["once"])
        n = OWN_TERMS
        escaping = [self._met * value for value in out[:n]]
        arriving = [through * value for value in out[n : 2 * n]]
        several = [(1 - w) * lost * value for value in out[2 * n : 2 * n + LOST_TERMS]]
        c, d = out[-6:-3], out[-3:]
        # What is left is nobody's: E has more of it in thick layers, t in thin ones, as it is they that are smooth there.
        up, down = w * self._upward, 1 - self._upward
        for k, first in enumerate(once):
            known = first + several[k] if k < LOST_TERMS else first
            left = w * ((1 if k == 0 else 0) - known)
            if k < n:
                left = left - escaping[k] - arriving[k]
                escaping[k], arriving[k] = escaping[k] + up * left, arriving[k] + down * left
            else:
                escaping.append(up * left)
                arriving.append(down * left)
        return escaping, arriving, once, c, d

    @cached_property
    def _upward(self) -> Array:
        """0 in thin layers and 1 in thick ones."""
        return 1 - 1 / (1 + self.tau * (1 - self.w * self.g))

    @cached_property
    def _met(self) -> Array:
        """What E goes with: nothing of it is left where there is no dust, or black dust."""
        return self.w * self.w * self._upward

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


def once_features(xp: Array, tau: Array, g: Array) -> list[Array]:
    """What the network for the first order is fed with."""
    return [g, xp.exp(-tau), 1 / (1 + tau), 1 / (1 + 8 * tau), 1 / (1 + 64 * tau)]


def _network(xp: Array, features: list[Array], numbers: dict[str, Any]) -> list[Array]:
    """The outputs of a network."""
    layer = [
        (feature - mean) * (1 / deviation)
        for feature, mean, deviation in zip(features, numbers["mean"], numbers["deviation"], strict=True)
    ]
    for weights, offsets in zip(numbers["weights"][:-1], numbers["offsets"][:-1], strict=True):
        layer = [_sigmoid(xp, value) for value in _affine(layer, weights, offsets)]
    return _affine(layer, numbers["weights"][-1], numbers["offsets"][-1])


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
