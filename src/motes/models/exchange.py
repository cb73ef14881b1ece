"""Light between a layer of dust and what lies below it: brought down diffusely, reflected to and fro, and let out again."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

from motes.arrays import Array
from motes.directions import Geometry
from motes.equations import INV_PI
from motes.models.bending import Bending, Highlight, Seen, mean_reflected
from motes.models.components import Reflecting
from motes.models.multiple_scattering import Diffused
from motes.models.slants import Slant

# A base that reflects more than it receives, under a layer that gives back nearly all, would multiply light without end.
LEAST_LOSS = 1e-3


@dataclass(frozen=True, eq=False)
class Leant:
    """What a term that leans sends up of light from a direction and of light from about there, what is uniform to it, and its mean albedo."""

    lit: Array
    rest: Array
    mean: Array

    @property
    def up(self) -> Array:
        """What it sends up of both."""
        return self.lit + self.mean * self.rest


@dataclass(frozen=True, eq=False)
class Exchange:
    """What a layer adds to what goes straight through it and to what it scatters once.

    To terms of the base without a highlight, light that was scattered is uniform where it meets them, and light from them that does not
    leave straight is uniform where it meets the layer.  Over a Lambertian base that is the exact sum over all reflections between the
    two; with a directional albedo a(mu) of another base it is reciprocal and, as far as a is that of the base, loses no light.  A
    highlight sees a part of that light from about where it came from (`motes.models.bending`), and is blurred.  To terms that lean, as other dust
    does, the forward peak of the phase function, a share g^2 of what arrives diffusely, is as light that was not scattered.
    """

    terms: tuple[Reflecting, ...]
    layer: Diffused

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        """The BRDF [1/sr] of all that has lost its direction, by scattering or by the diffuse terms."""
        layer, (i, r) = self.layer, Slant.pair(geometry)
        diffuse_i, diffuse_r = layer.arriving(i), layer.arriving(r)
        lit_i, lit_r = (layer.straight(slant) * self._reflected(slant.cosine) for slant in (i, r))
        up_i, up_r = lit_i + self._mean * diffuse_i, lit_r + self._mean * diffuse_r
        once = (
            lit_i * diffuse_r + diffuse_i * up_r
        )  # symmetrical: the second has both that is lit straight at r and at neither
        for leaning in self._leaning:
            lean_i, lean_r = (self._leant(leaning, slant) for slant in (i, r))
            once = once + (
                lean_i.lit * lean_r.rest + lean_r.lit * lean_i.rest + lean_i.mean * (lean_i.rest * lean_r.rest)
            )
            up_i, up_r = up_i + lean_i.up, up_r + lean_r.up
        if self.highlights:
            seen_i, seen_r = self._pair(geometry)
            for highlight in self.highlights:
                once = once + highlight.diffuse(seen_i, seen_r)
                up_i, up_r = up_i + highlight.lit(seen_i), up_r + highlight.lit(seen_r)
        exchanged = once + layer.mean_returned * self._multiplied * (up_i * up_r)
        return layer.higher_orders(geometry, i, r) + exchanged * INV_PI

    def layered(self, base: Array, dust: Array, geometry: Geometry) -> Array:
        """`motes.equations.dust_layer` of the exponentials that stand here already: a base and a bed of dust without an end, as seen."""
        layer, (i, r) = self.layer, Slant.pair(geometry)
        hit_i, hit_r = layer.hit(i), layer.hit(r)
        return layer.straight(i) * layer.straight(r) * base + (hit_i + hit_r - hit_i * hit_r) * dust

    def blurred(self, highlight: Highlight, geometry: Geometry) -> Array:
        """The BRDF [1/sr] of bent light about a highlight, but for what has the highlight's own shape."""
        return highlight.blurred(geometry, *self._pair(geometry))

    def sharp(self, highlight: Highlight, geometry: Geometry) -> Array:
        """The weight of the own shape of a highlight in bent light."""
        return highlight.sharp(*self._pair(geometry))

    def forward(self, geometry: Geometry) -> Array:
        """The weight of a leaning term in light that was scattered forward, on its way in, or out, or both."""
        near, straight = [], []
        for slant in Slant.pair(geometry):
            straight.append(self.layer.straight(slant))
            near.append(straight[-1] + self._peak * self.layer.arriving(slant))
        return near[0] * near[1] - straight[0] * straight[1]

    @cached_property
    def _peak(self) -> Array:
        g = self.layer.g
        return g * self.layer.xp.maximum(g, 0.0)

    def _leant(self, leaning: tuple[Callable[[Array], Array], Array], slant: Slant) -> Leant:
        layer, (reflected, mean) = self.layer, leaning
        diffuse = layer.arriving(slant)
        bent = self._peak * diffuse
        return Leant((layer.straight(slant) + bent) * reflected(slant.cosine), diffuse - bent, mean)

    def _pair(self, geometry: Geometry) -> tuple[Seen, Seen]:
        slants = Slant.pair(geometry)
        i, r = map(Seen, slants, self._bending.below(*slants))
        return i, r

    def reflected(self, cos_theta_i: Array) -> Array:
        """The share of light from a direction that dust and base send up in all.

        What a term without a highlight sends up once leaves as uniform light does; what a highlight sends up, as light from the mirrored direction.
        """
        layer, slant = self.layer, Slant.of(self.layer.xp, cos_theta_i)
        straight, diffuse = layer.straight(slant), layer.arriving(slant)
        up = straight * self._reflected(cos_theta_i) + self._mean * diffuse
        for leaning in self._leaning:
            up = up + self._leant(leaning, slant).up
        left = up * layer.mean_arriving
        if self.highlights:
            (below,) = self._bending.below(slant)
            seen = Seen(slant, below)
            for highlight in self.highlights:
                up = up + highlight.lit(seen)
                left = left + highlight.first(seen)
        again = layer.mean_returned * self._multiplied * (up * (self.mean_reflected * layer.mean_arriving))
        return layer.returned_once(slant) + layer.escaping(slant) + left + again

    def reflected_once(self, cos_theta_i: Array) -> Array:
        """The same where nothing is scattered twice, and what is scattered does not meet the base."""
        layer, slant = self.layer, Slant.of(self.layer.xp, cos_theta_i)
        straight, even = layer.straight(slant), self._reflected(cos_theta_i)
        for reflected, _ in self._leaning:
            even = even + reflected(cos_theta_i)
        left = even * layer.mean_straight
        for highlight in self.highlights:
            left = left + straight * highlight.term.reflected(layer.xp, cos_theta_i)
        return layer.returned_once(slant) + straight * left

    def importance(self, cos_theta_i: Array) -> Array:
        """About the share of light that `formula` is."""
        layer, slant = self.layer, Slant.of(self.layer.xp, cos_theta_i)
        below = layer.straight(slant) * layer.mean_returned + layer.arriving(slant)
        share = below * self.mean_reflected * self._multiplied * layer.mean_arriving
        for highlight in self.highlights:
            share = layer.xp.maximum(share - self.bent(highlight, cos_theta_i), 0.0)
        return layer.escaping(slant) + share

    def bent(self, highlight: Highlight, cos_theta_i: Array) -> Array:
        """About the share of light that is bent about a highlight."""
        (below,) = self._bending.below(Slant.of(self.layer.xp, cos_theta_i))
        near = below.near * below.near - below.straight * below.straight
        return near * highlight.term.reflected(self.layer.xp, cos_theta_i)

    @cached_property
    def highlights(self) -> tuple[Highlight, ...]:
        """The terms of the base that are highlights."""
        found = ((term, term.spread()) for term in self.terms)
        return tuple(Highlight(term, spread, self._bending) for term, spread in found if spread is not None)

    @cached_property
    def mean_reflected(self) -> Array:
        """The share of uniform light that the base reflects."""
        total = self._mean
        for _, mean in self._leaning:
            total = total + mean
        for highlight in self.highlights:
            total = total + highlight.mean_reflected
        return total

    @cached_property
    def _bending(self) -> Bending:
        return Bending(self.layer)

    @cached_property
    def _diffuse(self) -> tuple[Reflecting, ...]:
        return tuple(term for term in self.terms if term.spread() is None and not term.leans())

    @cached_property
    def _leaning(self) -> list[tuple[Callable[[Array], Array], Array]]:
        """Of each term that leans the albedo, as a function of the cosine, and its mean."""
        albedos = [term.reflecting(self.layer.xp) for term in self.terms if term.leans()]
        return [(albedo, mean_reflected(albedo)) for albedo in albedos]

    def _reflected(self, cos_theta: Array) -> Array:
        total: Array = 0.0
        for term in self._diffuse:
            total = total + term.reflected(self.layer.xp, cos_theta)
        return total

    @cached_property
    def _mean(self) -> Array:
        """The share of uniform light that the diffuse terms reflect."""
        total: Array = 0.0
        for term in self._diffuse:
            total = total + mean_reflected(term.reflecting(self.layer.xp))
        return total

    @cached_property
    def _multiplied(self) -> Array:
        """The sum over reflections between the two."""
        return 1 / self.layer.xp.maximum(1 - self.mean_reflected * self.layer.mean_returned, LEAST_LOSS)
