"""The plugins that are a model of Motes as it stands: ``motes_oren_nayar`` and its like, and ``motes_material``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from motes.directions import HORIZON
from motes.errors import ParameterError
from motes.material import load
from motes.models import BRDF, Reflection, describe
from motes.rendering.mixture import Mixture
from motes.rendering.textures import Values


def surface_class(mi: Any) -> type:
    """The class of the model plugins for the variant of Mitsuba that is set."""
    import drjit as dr

    class Surface(mi.BSDF):
        """A BRDF of Motes whose parameters are textures."""

        def __init__(
            self, properties: Any, template: BRDF, wavelengths: tuple[float, ...] = (), others: tuple[str, ...] = ()
        ) -> None:
            # Whatever can be refused comes first: once it is made, Dr.Jit calls this object in every render of the process.
            values = Values(mi, properties.plugin_name(), template, wavelengths)
            values.read_parameters(properties, others)
            mi.BSDF.__init__(self, properties)
            self.values = values
            parts = template.components(np, 1.0)
            flags = mi.BSDFFlags
            front = flags.FrontSide | flags.SpatiallyVarying
            kinds = {Reflection.DIFFUSE: flags.DiffuseReflection, Reflection.GLOSSY: flags.GlossyReflection}
            self.m_components = [kinds[part.reflection] | front for part in parts]
            self.m_flags = 0
            for flag in self.m_components:
                self.m_flags |= flag
            self.kinds = [mi.BSDFFlags(_kind(flag)) for flag in self.m_components]

        def _mixture(self, context: Any, si: Any, active: Any) -> Mixture | None:
            """The parts that the context asks for, or None."""
            enabled = [k for k, kind in enumerate(self.kinds) if context.is_enabled(kind, k)]
            return Mixture(self.values.models(si, active), si.wi, enabled) if enabled else None

        @np.errstate(all="ignore")
        def sample(self, context: Any, si: Any, sample1: Any, sample2: Any, active: Any = True) -> tuple[Any, Any]:
            bs = dr.zeros(mi.BSDFSample3f)
            mixture = self._mixture(context, si, active)
            if mixture is None:
                return bs, mi.Spectrum(0.0)
            wo, part = mixture.sample(sample1, sample2)
            wo = mi.Vector3f(*wo)
            active = active & (si.wi.z > HORIZON) & (wo.z > HORIZON)
            pdf = dr.select(active, mixture.pdf(wo), 0.0)
            bs.wo, bs.pdf, bs.eta = wo, pdf, 1.0
            kinds = [int(self.kinds[k]) for k in mixture.enabled]
            bs.sampled_type = mi.UInt32(_chosen(dr, part, kinds))
            bs.sampled_component = mi.UInt32(_chosen(dr, part, mixture.enabled))
            weight = mixture.value(wo) * (wo.z / dr.maximum(pdf, 1e-30))
            return bs, _spectrum(mi, dr.select(active & (pdf > 0), weight, 0.0))

        @np.errstate(all="ignore")
        def eval_pdf(self, context: Any, si: Any, wo: Any, active: Any = True) -> tuple[Any, Any]:
            mixture = self._mixture(context, si, active)
            if mixture is None:
                return mi.Spectrum(0.0), mi.Float(0.0)
            active = active & (si.wi.z > HORIZON) & (wo.z > HORIZON)
            value = dr.select(active, mixture.value(wo) * wo.z, 0.0)
            return _spectrum(mi, value), dr.select(active, mixture.pdf(wo), 0.0)

        def eval(self, context: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return self.eval_pdf(context, si, wo, active)[0]

        def pdf(self, context: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return self.eval_pdf(context, si, wo, active)[1]

        def traverse(self, callback: Any) -> None:
            for name, texture in self.values.textures():
                callback.put(name, texture, mi.ParamFlags.Differentiable)

        def parameters_changed(self, keys: list[str]) -> None:
            self.values.look()

        def to_string(self) -> str:
            return _describe(self.values)

    return Surface


def material_class(mi: Any, surface: type) -> type:
    """The class of ``motes_material``: a file, and a time that can be changed."""

    class AgeingSurface(surface):
        """A material of a JSON file at a time [h]."""

        def __init__(self, properties: Any) -> None:
            owner = properties.plugin_name()
            file = _resolved(mi, properties, owner)
            material = load(file)
            hours = properties.get("time", 0.0)
            if isinstance(hours, bool) or not isinstance(hours, (int, float)):
                raise ParameterError(f"{owner}: time = {str(hours)[:80]!r} is not a number of hours", "Give a number")
            brdf = material.at(hours)
            if not brdf.reciprocal:
                raise ParameterError(
                    f"{file} is not reciprocal, so it is no BRDF: {describe(brdf)}", "Save dust with form='brdf'"
                )
            super().__init__(properties, brdf, material.wavelengths, ("filename", "time"))
            self.file, self.material = file, material
            # A constant texture, so that mitsuba.traverse can change it in every variant.
            self.time = mi.load_dict({"type": "uniform", "value": hours})

        def traverse(self, callback: Any) -> None:
            super().traverse(callback)
            callback.put("time", self.time, mi.ParamFlags.NonDifferentiable)

        def parameters_changed(self, keys: list[str]) -> None:
            super().parameters_changed(keys)
            if any(key.split(".")[0] == "time" for key in keys):
                hours = mi.traverse(self.time)["value"]
                self.values.renew(self.material.at(float(np.asarray(hours).ravel()[0])))

        def to_string(self) -> str:
            return f"{self.file.name} {_describe(self.values)}"

    return AgeingSurface


def _resolved(mi: Any, properties: Any, owner: str) -> Path:
    """The file that the scene names, beside the scene or where Mitsuba looks."""
    if "filename" not in properties:
        raise ParameterError(f"{owner} has no filename", "Give the path of a material that motes fit wrote")
    return Path(str(mi.file_resolver().resolve(str(properties.get("filename")))))


def _kind(flags: Any) -> int:
    """The type of a component without its attributes (front side, spatially varying)."""
    return int(flags) & 0x1FF


def _chosen(dr: Any, part: Any, options: list[int]) -> Any:
    """``options[part]`` for every lane."""
    result: Any = options[0]
    for k, option in enumerate(options[1:], 1):
        if option != options[0] or k > 1:
            result = dr.select(part == k, option, result)
    return result


def _spectrum(mi: Any, value: Any) -> Any:
    """With all channels, and depolarised in polarised variants."""
    value = mi.UnpolarizedSpectrum(value)
    return mi.mueller.depolarizer(value) if mi.is_polarized else value


def _describe(values: Values) -> str:
    lines = [f"  {name} = {str(texture).replace(chr(10), chr(10) + '  ')}" for name, texture in values.textures()]
    return f"{values.owner}[\n" + ",\n".join(lines) + "\n]"
