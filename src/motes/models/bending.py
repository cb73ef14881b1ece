r"""What a layer of dust makes of a highlight below it: light that is bent on its way blurs the highlight.

Over a mirror, dust scatters light about the mirrored direction as a layer of twice the thickness does about the direction of light
itself.  Light scattered once on its way in or out has the exact weight of that, with :math:`s = e^{-\tau/\mu}`,

.. math::  w \, S \, (s_i a_i + s_r a_r), \qquad S = \frac{s_i - s_r}{\mu_i - \mu_r},

where a is the highlight's directional albedo.  Its lobe, the phase function turned by the facets, is near to

.. math::  k = \frac{1}{\pi} \Big(\frac14 + \frac{1}{P N}\Big) \frac{1}{(1 + Q)^2}, \quad P = L + D, \quad N = L \cos\theta_d + D,

with Q the squares of the angles in the plane of incidence and across it, over P and N squared: the widths of the highlight L and of the
phase function D add up, as those of curves with long tails do.  Where the highlight is wider than the phase function a share keeps the
highlight's own shape.  Light that was scattered more often takes the same form, wider, with what is left of the light that arrives.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from motes.arrays import Array
from motes.directions import Geometry
from motes.equations import INV_PI
from motes.models.components import Reflecting
from motes.models.multiple_scattering import Diffused
from motes.models.slants import Slant, inverses

#: Found by comparison with photons, all at once, by ``tools/blur_fit.py``, which also says what each is.
FITTED = {
    "width": 0.923, "bend": 1.356, "narrower": 0.404, "own": 8.009, "own_again": 94.06,
    "bend_again": 1.302, "narrower_again": 0.166, "far": -0.081, "far_2": 0.181,
    "bent": 0.289, "level": -0.272, "level_g": 0.103, "deep": 0.34, "height": 0.914, "height_g": -0.009, "steep": -0.441,
    "horizon": 0.547, "once": 0.322, "once_g": 3.195, "once_g2": -3.088, "twice": 8.794, "twice_g": -7.78, "lost": 3.477, "uneven": 1.015,
}  # fmt: skip
# Thicker layers show nothing of what lies below; in numbers of few bits an infinite one would be too large for its square.
DEEPEST = 100.0
# Below, the phase function counts as even.
LEAST_FORWARD = 1e-3
LEAST = 1e-9


def uniform(count: int) -> list[tuple[float, float]]:
    """Cosines and weights of a mean over uniform light."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    nodes = 0.5 * (nodes + 1)
    return list(zip(nodes.tolist(), (weights * nodes).tolist(), strict=True))


@dataclass(frozen=True, eq=False)
class Below:
    """Of light from a direction, what meets the base straight, diffusely in all, and of that scattered once and bent more often."""

    straight: Array
    arriving: Array
    once: Array
    again: Array

    @property
    def near(self) -> Array:
        """What comes from about the direction of light."""
        return self.straight + self.once + self.again


@dataclass(frozen=True, eq=False)
class Seen:
    """A direction, and what the layer makes of light from there."""

    slant: Slant
    below: Below


@dataclass(frozen=True, eq=False)
class Bending:
    """The parts of the light in a layer that know where they came from."""

    layer: Diffused

    def below(self, *slants: Slant) -> list[Below]:
        """The shares of light from a few directions, of one division."""
        f, layer = FITTED, self.layer
        wide = [slant.cosine + f["horizon"] for slant in slants]
        less, several = self._several
        first = [h * (h + less) + several for h in wide]
        low = [slant.cosine + 0.3 for slant in slants]
        deeper = f["deep"] * (layer.w * self.depth)
        second = [m + deeper for m in low]
        over = inverses(*first, *second)
        found = []
        for k, slant in enumerate(slants):
            arriving = layer.arriving(slant)
            once = arriving * (wide[k] * wide[k] * over[k])
            level, tilt = self._level
            share = (level + tilt * slant.cosine) * low[k] * over[len(slants) + k]
            again = (arriving - once) * layer.xp.minimum(share, 1.0)
            found.append(Below(layer.straight(slant), arriving, once, again))
        return found

    @cached_property
    def _several(self) -> tuple[Array, Array]:
        """Of light that arrives diffusely, 1 over the share scattered once is 1 + a/h + b/h^2 for the cosine and a constant, h."""
        f, g, met = FITTED, self.forward, self.layer.w * self.depth
        return met * (f["once"] + g * (f["once_g"] + g * f["once_g2"])), met * met * (f["twice"] + f["twice_g"] * g)

    @cached_property
    def _level(self) -> tuple[Array, Array]:
        """Of the rest, how much is bent: a line in the cosine."""
        f, g = FITTED, self.forward
        share, tilt = 1 - f["bent"] * g * g, f["level"] + f["level_g"] * (g - 0.7)
        return share * (1 - 0.7 * tilt), share * tilt

    def scattered_once(self, i: Slant, r: Slant) -> Array:
        """w S: (1 - exp(-x))/x for the difference x of the depths is within 7 % a ratio that holds at both ends."""
        xp, depth, layer = self.layer.xp, self.depth, self.layer
        x = depth * (i.inverse - r.inverse)
        x = xp.maximum(x, -x)
        mean = (1 + x * (1 / 6)) / (1 + x * (2 / 3 + x * (1 / 6)))
        straighter = xp.maximum(layer.straight(i), layer.straight(r))
        return layer.w * depth * (i.inverse * r.inverse * straighter * mean)

    @cached_property
    def depth(self) -> Array:
        return self.layer.xp.minimum(self.layer.tau, DEEPEST)

    @cached_property
    def forward(self) -> Array:
        """g, as far as it is forward."""
        return self.layer.xp.maximum(self.layer.g, LEAST_FORWARD)

    @cached_property
    def backward(self) -> Array:
        """Phase functions that scatter backward: how much less goes on, 1 for all others."""
        g = self.layer.xp.minimum(self.layer.g, 0.0)
        return (1 + g) / ((1 - g) * (1 - g))

    @cached_property
    def widths(self) -> tuple[Array, Array]:
        """Of light scattered once and more often: (1 - g)/sqrt(g) is where a Henyey-Greenstein function has fallen to a third."""
        xp, g = self.layer.xp, self.forward
        root = xp.sqrt(g)
        several = xp.maximum(g * root, 0.01)
        return (1 - g) / root, (1 - several) / xp.sqrt(several)

    @cached_property
    def kept(self) -> tuple[Array, Array]:
        """The share of the bent light that the form has: the rest is in the phase function's long tail, and counts as diffuse."""
        f, g, xp = FITTED, self.forward, self.layer.xp
        narrow, narrow_2 = 1 - g, 1 - g * xp.sqrt(g)
        once = self.backward / (1 + narrow * (f["far"] + f["far_2"] * narrow))
        again = self.backward * (f["height"] + f["height_g"] * g) / (1 + narrow_2 * (f["far"] + f["far_2"] * narrow_2))
        return once, again


@dataclass(frozen=True, eq=False)
class Highlight:
    """A term of the base that is a highlight, as the layer shows it.

    Parameters
    ----------
    term, spread
        The term, and the width of its lobe as the roughness alpha of GGX.
    """

    term: Reflecting
    spread: Array
    bending: Bending

    def blurred(self, geometry: Geometry, i: Seen, r: Seen) -> Array:
        """The BRDF [1/sr] of bent light that has lost the shape of the highlight."""
        xp, f, bending = self.bending.layer.xp, FITTED, self.bending
        a_i, a_r = self._reflected(i), self._reflected(r)
        (own, own_2), (kept, kept_2) = self.own, bending.kept
        once = bending.scattered_once(i.slant, r.slant) * (i.below.straight * a_i + r.below.straight * a_r)
        # 1/mu of the mirrored direction, the mean of both. It is bounded where one of them grazes and the lobe reaches far above it.
        both = i.slant.cosine + r.slant.cosine
        inverse = xp.minimum(i.slant.inverse + r.slant.inverse, (4 * f["uneven"]) / both)
        level = (1 + f["steep"] * (i.slant.cosine * r.slant.cosine - 0.5)) * (0.25 * inverse)
        again = self._again(i, r) * (level * (a_i + a_r))
        near, far = self._lobes(geometry)
        return (1 - own) * kept * (once * near) + (1 - own_2) * kept_2 * (again * far)

    def sharp(self, i: Seen, r: Seen) -> Array:
        """The weight of the highlight's own shape in bent light."""
        own, own_2 = self.own
        once = self.bending.scattered_once(i.slant, r.slant) * (i.below.straight + r.below.straight)
        return own * (once * (0.5 * (i.slant.cosine + r.slant.cosine))) + own_2 * self._again(i, r)

    def diffuse(self, i: Seen, r: Seen) -> Array:
        """pi times the BRDF of light that this highlight reflects once and dust makes diffuse on its way in, or out, or both."""
        bending = self.bending
        lit_i, lit_r = (seen.below.near * self._reflected(seen) for seen in (i, r))
        rest_i, rest_r = self.rest(i.below), self.rest(r.below)
        # Of a wide lobe more is met on its way out than of its middle.
        wide = 0.5 * FITTED["lost"] * (self.spread * self.spread) * bending.layer.w * bending.depth
        more = [
            seen.below.straight * seen.below.straight * self._reflected(seen) * seen.slant.inverse for seen in (i, r)
        ]
        spread_out = (lit_i + lit_r) * self._inverse_rest + self.mean_reflected
        return spread_out * (rest_i * rest_r) + wide * (more[0] + more[1])

    def lit(self, seen: Seen) -> Array:
        """What this highlight sends up of light from a direction, after one reflection."""
        return seen.below.near * self._reflected(seen) + self.mean_reflected * self.rest(seen.below)

    def first(self, seen: Seen) -> Array:
        """The share of light from a direction that leaves above after one reflection here, along the mirrored direction or from all around."""
        below, layer = seen.below, self.bending.layer
        near = below.near * self._reflected(seen) * (below.straight + below.arriving)
        return near + self.mean_reflected * self.rest(below) * layer.mean_arriving

    def _reflected(self, seen: Seen) -> Array:
        """The share of light from a direction that the facets reflect."""
        return self.term.reflected(self.bending.layer.xp, seen.slant.cosine)

    def rest(self, below: Below) -> Array:
        """What arrives diffusely and counts as uniform."""
        (own, own_2), (kept, kept_2) = self.own, self.bending.kept
        near = below.once * (own + (1 - own) * kept) + below.again * (own_2 + (1 - own_2) * kept_2)
        return self.bending.layer.xp.maximum(below.arriving - near, 0.0)

    @cached_property
    def own(self) -> tuple[Array, Array]:
        """The share of bent light that has the highlight's own shape, where that is wider than the phase function."""
        widths, squared = self.bending.widths, self.spread * self.spread
        once, again = FITTED["own"] * (widths[0] * widths[0]), FITTED["own_again"] * (widths[1] * widths[1])
        return squared / (squared + once), squared / (squared + again)

    @cached_property
    def roughness(self) -> Array:
        """The alpha of a GGX that samples what is blurred."""
        xp = self.bending.layer.xp
        width = self._width + 0.5 * (self._bends[0] + self._bends[1])
        return width / xp.sqrt(width * width + 4)

    @cached_property
    def mean_reflected(self) -> Array:
        return mean_reflected(self.term.reflecting(self.bending.layer.xp))

    @cached_property
    def _inverse_rest(self) -> Array:
        """1 over the mean of `rest` over uniform light."""
        total: Array = 0.0
        for node, weight in uniform(3):
            (below,) = self.bending.below(Slant.at(node))
            total = total + self.rest(below) * weight
        return 1 / self.bending.layer.xp.maximum(total, LEAST)

    def _again(self, i: Seen, r: Seen) -> Array:
        """The weight of what was bent more than once: again on one way, or on both."""
        of_i, of_r = i.below, r.below
        bent_i, bent_r = of_i.once + of_i.again, of_r.once + of_r.again
        return of_i.straight * of_r.again + of_i.again * of_r.straight + bent_i * bent_r

    @property
    def _width(self) -> Array:
        return (2 * FITTED["width"]) * self.spread

    @cached_property
    def _bends(self) -> tuple[Array, Array]:
        """The width that bending adds."""
        f, widths = FITTED, self.bending.widths
        once, again = f["bend"] * widths[0], f["bend_again"] * widths[1]
        return once / (1 + f["narrower"] * self.spread), again / (1 + f["narrower_again"] * self.spread)

    def _lobes(self, geometry: Geometry) -> tuple[Array, Array]:
        """k for light bent once and more often; both angles are computed from squares of sums, so that nothing cancels about the mirrored direction.

        Numerators and denominators are multiplied out: two lobes then have one division.
        """
        width, cosine = self._width, geometry.cos_theta_d
        tilt = 4 * (geometry.sin_theta_h * geometry.sin_theta_h)
        rise = geometry.cos_theta_i - geometry.cos_theta_r
        squared = cosine * cosine
        even = tilt * squared + rise * rise
        turned = squared * (tilt - even)
        parts = []
        for bend in self._bends:
            along, across = width + bend, width * cosine + bend
            inverse, area = 1 / along, across * across
            scale = area * (1 + cosine)
            height = (0.25 * across + inverse) * (area * across) * ((1 + cosine) * (1 + cosine))
            fall = scale * (1 + (inverse * inverse) * even) + (width * inverse * inverse) * ((along + across) * turned)
            parts.append((fall, height))
        (near, near_height), (far, far_height) = parts
        near_inverse, far_inverse = inverses(near * near, far * far)
        return INV_PI * near_height * near_inverse, INV_PI * far_height * far_inverse


def mean_reflected(reflected: Callable[[Array], Array]) -> Array:
    """The share of uniform light that is reflected, where `reflected` says which share of light from a cosine is."""
    total: Array = 0.0
    for node, weight in uniform(6):
        total = total + reflected(node) * weight
    return total
