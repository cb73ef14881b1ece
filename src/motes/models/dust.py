r"""Blinn's top-lit dust, equations (12)-(13), and a layer of it over another surface.

.. math::  f = \frac{w \Phi(\gamma, g)}{4 \pi (\cos\theta_i + \cos\theta_r)}

That is light scattered once, exactly.  With ``scattering="multiple"`` come all further scatterings
(`motes.models.multiple_scattering`), and in a layer the light that they bring to the base and back.

Source: J. F. Blinn, "Light reflection functions for simulation of clouds and dusty surfaces", SIGGRAPH 1982, and
appendix C of "Time-Varying BRDFs"."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import ClassVar, Self, final

import numpy as np

from motes import equations
from motes.arrays import Array
from motes.directions import Geometry
from motes.errors import ParameterError
from motes.models.base import BRDF
from motes.models.bending import Highlight
from motes.models.components import Component, Piece
from motes.models.exchange import Exchange
from motes.models.ggx import VisibleGGXLobe
from motes.models.lobes import TWO_PI, CosineLobe, PhaseLobe, Reflection
from motes.models.multiple_scattering import INFINITE, Diffused
from motes.models.naming import register
from motes.models.particles import MULTIPLE, SCATTERING, SINGLE, check_physical, physical
from motes.models.slants import Slant
from motes.models.standard import DIFFUSIVITY, MEAN_COSINE, StandardLobe
from motes.parameters import Parameter, Place, Role, option, parameter, part


@register("dust")
@final
@dataclass(frozen=True, eq=False)
class Dust(BRDF):
    """An opaque bed of small particles that scatter once.

    Parameters
    ----------
    w, g
        Single-scattering albedo, and mean cosine of the deviation angle.
    scattering
        ``"single"``: as in the source, scattered once.  ``"multiple"``: all orders of scattering, with w <= 1 and g within
        -0.75 and 0.9.
    form
        ``"brdf"``: reciprocal, in 1/sr, what renders.  ``"brightness"``: equation (12) as printed, for comparing with
        published parameters; it equals the BRDF times 4 pi cos(theta_i) and is not reciprocal.

    Notes
    -----
    The deviation angle gamma is 0 when light goes straight on, so cos(gamma) = -(wi . wo), and g > 0 is forward
    scattering.  Single scattering loses energy: white isotropic dust (w = 1, g = 0) returns (1 - ln 2)/2 = 15 % of
    light at normal incidence and 2 (1 - ln 2)/3 = 20 % of uniform light."""

    words: ClassVar[str] = "dust"
    approximation: ClassVar[str] = (
        "Dust: a diffuse lobe with the dust's spherical albedo for the g of this file; its phase function is left out."
    )

    w: Array = parameter(
        0.6,
        bounds=(0, float("inf")),
        # Thin dust shows w tau alone: without an end to w a fit runs away along their product.
        fit_bounds=(0, 10),
        typical=(0, 1),
        symbol="w",
        doc="single-scattering albedo of the dust",
        per_channel=True,
        role=Role.SINGLE_SCATTERING_ALBEDO,
    )
    g: Array = parameter(
        0.0,
        bounds=(-1, 1),
        open=True,
        fit_bounds=(-0.98, 0.98),
        typical=(-0.8, 0.8),
        starts=(-0.5, 0.0, 0.5),
        symbol="g",
        doc="mean cosine of the deviation angle",
        advice="g > 0 scatters forward, g < 0 backward, 0 evenly",
        role=Role.ASYMMETRY,
    )
    form: str = option("brdf", words=("brdf", "brightness"), doc="what equation (12) is turned into")
    scattering: str = option("single", words=SCATTERING, doc="how often light is scattered")

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.scattering == MULTIPLE:
            check_physical("Dust", self.w, self.g)
            if self.form != "brdf":
                raise ParameterError(
                    f"Dust: form = {self.form!r} is equation (12) as printed, which knows one scattering",
                    "Use form='brdf' with scattering='multiple'",
                )

    def _walk(self, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Parameter, Array]]:
        return physical(super()._walk(path), self.scattering)

    @property
    def reciprocal(self) -> bool:  # type: ignore[override]
        return self.form == "brdf"

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        once = self.scattered_once(xp, geometry)
        return (
            once if self.scattering == SINGLE else once + self._deep(xp).higher_orders(geometry, *Slant.pair(geometry))
        )

    def scattered_once(self, xp: Array, geometry: Geometry) -> Array:
        """The BRDF [1/sr] of light scattered once by a bed without an end."""
        Phi = equations.Phi(xp, geometry.sin2_half_gamma, geometry.cos2_half_gamma, self.g)
        equation = equations.dust_brdf if self.form == "brdf" else equations.rho_dust
        return equation(xp, Phi, geometry.cos_theta_i, geometry.cos_theta_r, self.w)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        scale = 0.15 if self.form == "brdf" else 1.9 * cos_theta_i
        once = Component(self.scattered_once, PhaseLobe(self.g), self.w * scale)
        if self.scattering == SINGLE:
            return [once]
        deep = self._deep(xp)
        share = deep.escaping(Slant.of(xp, cos_theta_i))
        more = Component(lambda _, seen: deep.higher_orders(seen, *Slant.pair(seen)), CosineLobe(), share)
        return [once, more]

    def reflected(self, xp: Array, cos_theta_i: Array) -> Array:
        return self.reflecting(xp)(cos_theta_i)

    def reflecting(self, xp: Array) -> Callable[[Array], Array]:
        deep = self._deep(xp)

        def reflected(cos_theta_i: Array) -> Array:
            slant = Slant.of(xp, cos_theta_i)
            once = deep.returned_once(slant)
            if self.scattering == SINGLE:
                return once if self.form == "brdf" else once * (2 * TWO_PI * cos_theta_i)
            return once + deep.escaping(slant)

        return reflected

    def leans(self) -> bool:
        return True

    def _deep(self, xp: Array) -> Diffused:
        return Diffused(xp, INFINITE, self.w, self.g)

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        if self.scattering == MULTIPLE:
            once = float(Dust(w=1.0, g=float(np.ravel(self.g)[0])).spherical_albedo()[0])
            found = [values.w * once, values._deep(xp).mean_escaping]
            return [StandardLobe(Reflection.DIFFUSE, share) for share in found]
        # The albedo goes with w: 2 (1 - ln 2)/3 of it where g = 0.
        unit = Dust(w=1.0, g=float(np.ravel(self.g)[0]), form=self.form)
        return [StandardLobe(Reflection.DIFFUSE, values.w * float(unit.spherical_albedo()[0]))]


@register("dust_layer")
@final
@dataclass(frozen=True, eq=False)
class DustLayer(BRDF):
    """A layer of dust of optical thickness ``tau`` over a base (Blinn 1982).

    f = T f_base + (1 - T) f_dust with T = exp(-tau (1/cos(theta_i) + 1/cos(theta_r))): at tau = 0 the base, as tau
    grows the dust.

    Parameters
    ----------
    base, dust, tau
        What lies below, what the layer is made of, and its optical thickness.
    scattering
        ``"single"``: the line above, as in the source.  ``"multiple"``: all orders of scattering in the layer, and between it and
        the base; w <= 1, and an infinite tau is the half space.  What goes straight through keeps the lobe of the base, what the dust
        bends on its way blurs the base's highlights, and all other scattered light counts as diffuse.
    """

    words: ClassVar[str] = "a layer of dust"
    approximation: ClassVar[str] = (
        "Dust layer: a mean transmittance exp(-3.32 tau) instead of exp(-tau (1/cos_i + 1/cos_r))."
    )

    base: BRDF = part(BRDF, place=Place.BASE)
    dust: Dust = part(Dust, place=Place.COVER, default=Dust())
    tau: Array = parameter(
        0.2,
        bounds=(0, float("inf")),
        fit_bounds=(0, 30),
        typical=(0, 2),
        starts=(0.05, 0.3, 1.0),
        symbol="\\tau",
        doc="optical thickness of the layer",
        role=Role.DEPTH,
        simpler=0.0,
    )
    scattering: str = option("single", words=SCATTERING, doc="how often light is scattered in the layer")

    def __post_init__(self) -> None:
        if self.scattering == MULTIPLE and isinstance(self.tau, float) and self.tau == float("inf"):
            object.__setattr__(self, "tau", INFINITE)
        super().__post_init__()
        if self.dust.form != "brdf":
            raise ParameterError(f"DustLayer: dust.form = {self.dust.form!r} is not a BRDF", "Use Dust(form='brdf')")
        if self.dust.scattering != SINGLE:
            raise ParameterError(
                f"DustLayer: dust.scattering = {self.dust.scattering!r} is that of a bed without an end",
                f"Say it of the layer: DustLayer(base, dust, tau, scattering={self.dust.scattering!r})",
            )
        if self.scattering == MULTIPLE:
            check_physical("DustLayer", self.dust.w, self.dust.g)

    def _walk(self, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Parameter, Array]]:
        own = (*path, "dust")
        for found in super()._walk(path):
            yield from physical([found], self.scattering) if found[0][: len(own)] == own else [found]

    @property
    def reciprocal(self) -> bool:  # type: ignore[override]
        return self.base.reciprocal

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return self._over(xp, geometry, self.base.formula(xp, geometry))

    def _over(self, xp: Array, geometry: Geometry, straight: Array) -> Array:
        """The BRDF [1/sr] with `straight` for what the base shows of light that goes straight through."""
        once = self._layered(xp, geometry, straight, self.dust.scattered_once(xp, geometry))
        if self.scattering == SINGLE:
            return once
        exchange = self.exchange(xp)
        total = once + exchange.formula(xp, geometry)
        for term, highlight in self._below(exchange):
            if term.leans():
                total = total + exchange.forward(geometry) * term.formula(xp, geometry)
            if highlight is not None:
                total = total + exchange.sharp(highlight, geometry) * term.formula(xp, geometry)
                total = total + exchange.blurred(highlight, geometry)
        return total

    def _layered(self, xp: Array, geometry: Geometry, base: Array, dust: Array) -> Array:
        """A base seen through the layer, and dust in it."""
        if self.scattering == MULTIPLE:
            return self.exchange(xp).layered(base, dust, geometry)
        depth = equations.slant_depth(xp, geometry.cos_theta_i, geometry.cos_theta_r, self.tau)
        return equations.dust_layer(xp, base, dust, depth)

    def _told_apart(self) -> list[BRDF | Piece]:
        """What lies below, piece by piece."""
        return [piece for term in self.base.terms() for piece in term.pieces()]

    def _below(self, exchange: Exchange) -> list[tuple[BRDF | Piece, Highlight | None]]:
        """What lies below, piece by piece, with what becomes of those that are highlights under several scatterings."""
        highlights = iter(exchange.highlights if self.scattering == MULTIPLE else ())
        return [(term, None if term.spread() is None else next(highlights, None)) for term in self._told_apart()]

    def exchange(self, xp: Array) -> Exchange:
        """What the layer adds where light is scattered several times, and its numbers."""

        def make() -> Exchange:
            return Exchange(tuple(self._told_apart()), Diffused(xp, self.tau, self.dust.w, self.dust.g))

        keep = getattr(xp, "keep", None)  # of namespaces whose numbers are known (`motes.rendering.beforehand`)
        return make() if keep is None else keep(self, make)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return self._components(xp, cos_theta_i, True)

    def _components(self, xp: Array, cos_theta_i: Array, sharp: bool) -> list[Component]:
        """The components, with or without what goes straight through to a highlight and back."""
        through = self._through(xp, cos_theta_i)
        exchange, found = self.exchange(xp), []
        for term, highlight in self._below(exchange):
            straight = sharp or term.spread() is None
            for piece in term.components(xp, cos_theta_i):
                formula, share = (self._seen(piece, 0.0), through) if straight else (_nothing, 0.0)
                if highlight is not None:
                    formula = _with_bent(formula, piece, partial(exchange.sharp, highlight))
                    share = share + highlight.own[0] * (1 - through)
                elif self.scattering == MULTIPLE and term.leans():
                    formula = _with_bent(formula, piece, exchange.forward)
                found.append(Component(formula, piece.lobe, piece.importance * share))
        for piece in self.dust.components(xp, cos_theta_i):
            found.append(Component(self._seen(piece, 1.0), piece.lobe, piece.importance * (1 - through)))
        if self.scattering == MULTIPLE:
            # What dust scatters is diffuse, as everywhere here, though it is sampled about the mirror direction.
            for highlight in exchange.highlights:
                lobe, share = VisibleGGXLobe(highlight.roughness), exchange.bent(highlight, cos_theta_i)
                found.append(Component(_blurred(exchange, highlight), lobe, share, Reflection.DIFFUSE))
            found.append(Component(exchange.formula, CosineLobe(), exchange.importance(cos_theta_i)))
        return found

    def _through(self, xp: Array, cos_theta_i: Array) -> Array:
        """The chance of going straight through twice, as if light left at 45 degrees."""
        return xp.exp(-equations.slant_depth(xp, cos_theta_i, 0.7, self.tau))

    def leans(self) -> bool:
        return True

    def pieces(self) -> tuple[BRDF | Piece, ...]:
        """The highlights below as far as the layer shows them sharp, and all the rest."""
        told = self._told_apart()
        highlights = [self._piece(term) for term in told if term.spread() is not None]
        if not highlights:
            return (self,)

        def formula(xp: Array, geometry: Geometry) -> Array:
            straight: Array = 0.0
            for term in told:
                straight = straight if term.spread() is not None else straight + term.formula(xp, geometry)
            return self._over(xp, geometry, straight)

        def albedo(xp: Array) -> Callable[[Array], Array]:
            whole, sharp = self.reflecting(xp), [piece.albedo(xp) for piece in highlights]
            return lambda cosine: xp.maximum(whole(cosine) - sum(of(cosine) for of in sharp), 0.0)

        rest = Piece(formula, albedo, lambda xp, cosine: self._components(xp, cosine, False), None)
        return (rest, *highlights)

    def _piece(self, highlight: BRDF | Piece) -> Piece:
        """A highlight below, as far as the layer shows it sharp."""

        def albedo(xp: Array) -> Callable[[Array], Array]:
            layer, below = self.exchange(xp).layer, highlight.reflecting(xp)

            def of(cosine: Array) -> Array:
                straight = layer.straight(Slant.of(xp, cosine))
                return straight * straight * below(cosine)

            return of

        def parts(xp: Array, cosine: Array) -> list[Component]:
            through = self._through(xp, cosine)
            return [
                Component(self._seen(part, 0.0), part.lobe, part.importance * through)
                for part in highlight.components(xp, cosine)
            ]

        def formula(xp: Array, geometry: Geometry) -> Array:
            return self._layered(xp, geometry, highlight.formula(xp, geometry), 0.0)

        return Piece(formula, albedo, parts, highlight.spread())

    def reflected(self, xp: Array, cos_theta_i: Array) -> Array:
        return self.reflecting(xp)(cos_theta_i)

    def reflecting(self, xp: Array) -> Callable[[Array], Array]:
        exchange = self.exchange(xp)
        return exchange.reflected if self.scattering == MULTIPLE else exchange.reflected_once

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        # Along the light, whose direction nobody tells, the mean of 1/cos; the darkening towards grazing holds for the viewer at most.
        through = xp.exp(-values.tau * (1 / cos_view + DIFFUSIVITY))
        base = self.base.standard_lobes(xp, values.base, cos_view)
        dust = self.dust.standard_lobes(xp, values.dust, cos_view)
        found = [lobe.scaled(through) for lobe in base] + [lobe.scaled(1 - through) for lobe in dust]
        if self.scattering == MULTIPLE:
            exchange = values.exchange(xp)
            shares = [exchange.bent(highlight, MEAN_COSINE) for highlight in exchange.highlights]
            shares.append(exchange.importance(MEAN_COSINE))
            found += [StandardLobe(Reflection.DIFFUSE, share) for share in shares]
        return found

    def in_words(self) -> str:
        base = self.base.in_words()
        return f"({base}) under {self.dust.in_words()}" if " + " in base else f"{base} under {self.dust.in_words()}"

    def _seen(self, part: Component, own: float) -> Callable[[Array, Geometry], Array]:
        """The formula of a part of the base seen through the layer (own = 0), or of the dust in the layer (own = 1)."""

        def formula(xp: Array, geometry: Geometry) -> Array:
            value = part.formula(xp, geometry)
            return self._layered(xp, geometry, (1 - own) * value, own * value)

        return formula


def _nothing(xp: Array, geometry: Geometry) -> Array:
    return 0.0


def _with_bent(
    seen: Callable[[Array, Geometry], Array], part: Component, weight: Callable[[Geometry], Array]
) -> Callable[[Array, Geometry], Array]:
    """The formula of a part of the base, with what bent light adds in the same shape."""
    return lambda xp, geometry: seen(xp, geometry) + weight(geometry) * part.formula(xp, geometry)


def _blurred(exchange: Exchange, highlight: Highlight) -> Callable[[Array, Geometry], Array]:
    return lambda _, geometry: exchange.blurred(highlight, geometry)
