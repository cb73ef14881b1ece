"""``motes_dusty`` over a nested BSDF of any plugin: a layer of dust, with one scattering or with all orders."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, cast, final

import numpy as np

from motes import equations
from motes.arrays import Array, Columns
from motes.directions import HORIZON, Geometry, Vector
from motes.errors import ParameterError
from motes.models import BRDF, Component, DustLayer
from motes.models.components import Piece, Reflecting
from motes.models.exchange import Exchange
from motes.models.particles import MULTIPLE
from motes.rendering.foreign_highlights import facets, measure
from motes.rendering.mixture import SMALLEST_COSINE, Mixture, columns, known, lift, lower
from motes.rendering.surface_plugin import _describe, _kind, _spectrum
from motes.rendering.textures import Found, Values

# What share of light a nested BSDF is taken to reflect when its chance of being sampled is computed.
_ASSUMED_ALBEDO = 0.5


@final
@dataclass(frozen=True, eq=False)
class _Nested(BRDF):
    """The place of the nested BSDF in the model of the layer, with its highlight as it was measured."""

    highlight: Piece | None = None

    def pieces(self) -> tuple[BRDF | Piece, ...]:
        return (self,) if self.highlight is None else (self, self.highlight)

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return 0.0

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return [Component(self.formula, None, _ASSUMED_ALBEDO)]  # type: ignore[arg-type]


@final
@dataclass(frozen=True, eq=False)
class _Lit(Reflecting):
    """The nested BSDF as light meets it that dust has scattered: diffuse, with the albedo that Mitsuba tells."""

    albedo: Array

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return []

    def reflected(self, xp: Array, cos_theta_i: Array) -> Array:
        return self.albedo


def nested_bsdfs(mi: Any, properties: Any) -> list[Any]:
    """The BSDFs among a plugin's properties."""
    objects = (properties.get(key) for key in properties if properties.type(key) == mi.Properties.Type.Object)
    return [thing for thing in objects if isinstance(thing, mi.BSDF)]


def layer_class(mi: Any) -> type:
    """The class of ``motes_dusty`` with a nested BSDF, for the variant of Mitsuba that is set."""
    import drjit as dr

    flags = mi.BSDFFlags

    class DustyLayer(mi.BSDF):
        """T f_base + (1 - T) f_dust on the front side; light that crosses the layer once, into glass, keeps its share.

        With ``scattering="multiple"`` all orders are added, and light between the dust and the nested BSDF.  Its highlight is measured and
        blurred (`motes.rendering.foreign_highlights`); to all else of it that light is diffuse.
        """

        def __init__(self, properties: Any, scattering: str) -> None:
            # Whatever can be refused comes first: once it is made, Dr.Jit calls this object in every render of the process.
            name, nested = properties.plugin_name(), nested_bsdfs(mi, properties)
            if len(nested) != 1:
                raise ParameterError(f"{name} has {len(nested)} nested BSDFs", "It lies over one, or over none")
            base = nested[0]
            if base.flags() & flags.Null:
                raise ParameterError(
                    f"{name}: the nested BSDF lets light through unbent", "Put motes_dusty inside the mask"
                )
            values = Values(mi, name, DustLayer(_Nested(), scattering=scattering))
            values.read_parameters(properties, ("scattering",))
            mi.BSDF.__init__(self, properties)
            self.base, self.values = base, values
            self._measure()
            count = self.base.component_count()
            self.dust_flag = flags.DiffuseReflection | flags.FrontSide | flags.SpatiallyVarying
            self.m_components = [*(self.base.flags(k) for k in range(count)), self.dust_flag]
            self.m_flags = self.base.flags() | self.dust_flag
            self.has_delta = bool(self.base.flags() & flags.Delta)

        def _measure(self) -> None:
            """Look for a highlight of the nested BSDF."""
            scattering = cast(DustLayer, self.values.template).scattering
            self.measured = measure(mi, self.base) if scattering == MULTIPLE else None
            if self.measured is not None:
                mean = facets(self.measured.shares.mean(1).tolist(), self.measured.alpha)
                self.values.template = DustLayer(_Nested(mean), scattering=scattering)
            self.values.look()

        def _layer(self, si: Any, active: Any) -> _Layer:
            found, measured = self.values.models(si, active), self.measured
            below: list[Reflecting] = []
            if cast(DustLayer, found.model).scattering == MULTIPLE:
                told = mi.unpolarized_spectrum(self.base.eval_diffuse_reflectance(si, active))
                if measured is not None:
                    told = told * self._channels(measured.diffuse)
                    shares = [known(found.xp, self._channels(share), share) for share in measured.shares]
                    below.append(facets(shares, measured.alpha))
                below.append(_Lit(lift(found.xp, dr.clip(told, 0.0, 1.0))))
            return _Layer(found, si.wi, below)

        def _channels(self, values: Array) -> Any:
            """A number, or a number for each of red, green and blue, as Mitsuba has it."""
            return float(values[0]) if len(values) == 1 else mi.Color3f(*values.tolist())

        def _enabled(self, context: Any) -> tuple[bool, bool]:
            """Whether the context asks for the base, and for the dust."""
            dust = len(self.m_components) - 1
            base = any(context.is_enabled(flags(_kind(self.m_components[k])), k) for k in range(dust))
            return base, context.is_enabled(flags.DiffuseReflection, dust)

        def _value_and_pdf(
            self, layer: _Layer, context: Any, si: Any, wo: Any, active: Any, chance: Any
        ) -> tuple[Any, Any]:
            """Times the cosine; Dirac peaks of the base left out."""
            base, dust = self._enabled(context)
            value, pdf = mi.Spectrum(0.0), mi.Float(0.0)
            if base:
                value, pdf = self.base.eval_pdf(context, si, wo, active)
                pdf = pdf * chance
            own: Any = _spectrum(mi, dr.zeros(mi.UnpolarizedSpectrum if mi.is_polarized else mi.Spectrum))
            if dust:
                above = active & (si.wi.z > HORIZON) & (wo.z > HORIZON)
                own = _spectrum(mi, dr.select(above, layer.dust(wo) * wo.z, 0.0))
                again = (
                    _spectrum(mi, dr.select(above, layer.scattered_again(wo) * wo.z, 0.0)) if layer.multiple else 0.0
                )
                pdf = pdf + dr.select(above, (1 - chance) * layer.pdf(wo), 0.0)
            total = layer.through(value, own, wo)
            return (total + again if dust and layer.multiple else total), pdf

        def _chance(self, layer: _Layer, context: Any, si: Any) -> Any:
            """That the base is sampled: always from behind."""
            base, dust = self._enabled(context)
            if not (base and dust):
                return mi.Float(1.0 if base else 0.0)
            return dr.select(si.wi.z > HORIZON, layer.chance, 1.0)

        @np.errstate(all="ignore")
        def sample(self, context: Any, si: Any, sample1: Any, sample2: Any, active: Any = True) -> tuple[Any, Any]:
            base, dust = self._enabled(context)
            if not (base or dust):
                return dr.zeros(mi.BSDFSample3f), mi.Spectrum(0.0)
            layer = self._layer(si, active)
            chance = self._chance(layer, context, si)
            of_base = sample1 < chance
            bs, weight = dr.zeros(mi.BSDFSample3f), mi.Spectrum(0.0)
            if base:
                scaled = dr.minimum(sample1 / dr.maximum(chance, 1e-30), 1 - 1e-7)
                bs, weight = self.base.sample(context, si, scaled, sample2, active & of_base)
            peak = of_base & mi.has_flag(bs.sampled_type, flags.Delta) if self.has_delta else False
            if dust:
                rest = (sample1 - chance) / dr.maximum(1 - chance, 1e-30)  # as random as the whole, where it is used
                bs.wo = dr.select(of_base, bs.wo, mi.Vector3f(*layer.sample(rest, sample2)))
                bs.eta = dr.select(of_base, bs.eta, 1.0)
                bs.sampled_type = dr.select(of_base, bs.sampled_type, mi.UInt32(+flags.DiffuseReflection))
                bs.sampled_component = dr.select(of_base, bs.sampled_component, mi.UInt32(len(self.m_components) - 1))
            alive = active & (dr.select(of_base, bs.pdf, 1.0) > 0)
            value, pdf = self._value_and_pdf(layer, context, si, bs.wo, alive, chance)
            pdf = dr.select(alive & (pdf > 0), pdf, 0.0)
            result = dr.select(pdf > 0, value / dr.maximum(pdf, 1e-30), 0.0)
            if self.has_delta:
                nothing = dr.zeros(mi.Spectrum)
                through = layer.through(weight, nothing, bs.wo)
                result = dr.select(peak & alive, through / dr.maximum(chance, 1e-30), result)
                pdf = dr.select(peak & alive, bs.pdf * chance, pdf)
            bs.pdf = pdf
            return bs, result

        @np.errstate(all="ignore")
        def eval_pdf(self, context: Any, si: Any, wo: Any, active: Any = True) -> tuple[Any, Any]:
            layer = self._layer(si, active)
            value, pdf = self._value_and_pdf(layer, context, si, wo, active, self._chance(layer, context, si))
            return dr.select(active, value, 0.0), dr.select(active, pdf, 0.0)

        def eval(self, context: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return self.eval_pdf(context, si, wo, active)[0]

        def pdf(self, context: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return self.eval_pdf(context, si, wo, active)[1]

        def traverse(self, callback: Any) -> None:
            callback.put("base", self.base, mi.ParamFlags.Differentiable)
            for name, texture in self.values.textures():
                callback.put(name, texture, mi.ParamFlags.Differentiable)

        def parameters_changed(self, keys: list[str]) -> None:
            self._measure()

        def to_string(self) -> str:
            return f"{_describe(self.values)[:-2]},\n  base = {self.base!s}\n]"

    return DustyLayer


class _Layer:
    """The dust where rays meet the surface: how much it lets through, what it scatters, and where it is sampled."""

    def __init__(self, found: Found, wi: Any, below: Sequence[Reflecting]) -> None:
        import drjit as dr

        self.xp, self.model, self.wi = found.xp, cast(DustLayer, found.model), wi  # the template of this plugin
        self.multiple, self._below = self.model.scattering == MULTIPLE, tuple(below)
        base, *dust = found.averaged.components(
            self.xp, self.xp.maximum(lift(self.xp, dr.detach(wi.z)), SMALLEST_COSINE)
        )
        scattered: Array = 0.0
        for part in dust:
            scattered = scattered + part.importance
        self.chance = lower(self.xp, base.importance / (base.importance + scattered))
        self._sampler = Mixture(found, wi, range(1, 1 + len(dust)))

    def _geometry(self, wo: Any) -> Geometry:
        return Geometry(self.xp, Vector(*columns(self.xp, self.wi)), Vector(*columns(self.xp, wo)))

    def dust(self, wo: Any) -> Any:
        """The BRDF of the dust alone [1/sr]."""
        return lower(self.xp, self.model.dust.formula(self.xp, self._geometry(wo)))

    def scattered_again(self, wo: Any) -> Any:
        """The BRDF of light scattered more than once, and of light between the dust and the nested BSDF [1/sr]."""
        xp, geometry = self.xp, self._geometry(wo)
        exchange = Exchange(self._below, self.model.exchange(xp).layer)
        total = exchange.formula(xp, geometry)
        for highlight in exchange.highlights:
            total = total + exchange.blurred(highlight, geometry)
            total = total + exchange.sharp(highlight, geometry) * cast(Piece, highlight.term).formula(xp, geometry)
        return lower(xp, total)

    def through(self, below: Any, dust: Any, wo: Any) -> Any:
        """What is seen of `below` and of `dust` without an end; a direction below the surface does not cross the layer."""
        xp, geometry = self.xp, self._geometry(wo)
        side: Callable[[Array, Array], Array] = lambda z, cosine: xp.where(lift(xp, z) > 0, cosine, float("inf"))  # noqa: E731
        cos_i, cos_r = side(self.wi.z, geometry.cos_theta_i), side(wo.z, geometry.cos_theta_r)
        depth = equations.slant_depth(xp, cos_i, cos_r, self.model.tau)
        return lower(xp, equations.dust_layer(xp, lift(xp, below), lift(xp, dust), depth))

    def pdf(self, wo: Any) -> Array:
        """The density of `sample` [1/sr]."""
        return self._sampler.pdf(wo)

    def sample(self, which: Array, u: Any) -> Columns:
        """A direction in which the dust scatters."""
        return self._sampler.sample(which, u)[0]
