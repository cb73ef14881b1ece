"""``motes_map``: a fitted map as a BSDF whose parameters are pictures over the texture coordinates, at a time that can be changed.

Between texels it is light that may be filtered, never parameters: a BRDF is no linear function of its widths, and a point between a mirror and a
matte texel shows some of both, not a satin that is nowhere on the sample.  ``nearest`` gives every point the parameters of the texel that it lies in, which is
what was fitted; ``bilinear`` evaluates the BRDFs of the four texels around it, each with its own parameters, and adds them with bilinear weights.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from motes.directions import HORIZON
from motes.errors import DataError, MotesError, ParameterError
from motes.models import describe
from motes.rendering.lookup import FILTERS, GAPS, one_of
from motes.rendering.surface_plugin import _describe, _resolved, _spectrum

if TYPE_CHECKING:
    from motes.rendering.map_textures import Pictures

OTHERS = ("filename", "time", "filter", "gaps", "strict", "to_uv")
#: What texels without a fit look like where they are marked: a diffuse colour that no sample is likely to have.
MARK = (0.9, 0.0, 0.9)


def map_class(mi: Any, surface: type) -> type:
    """The class of ``motes_map`` for the variant of Mitsuba that is set."""
    import drjit as dr

    class MapSurface(surface):
        """The fits of a Zarr store, at a time [h]."""

        def __init__(self, properties: Any) -> None:
            from motes.rendering.map_textures import pictures

            owner = properties.plugin_name()
            self.fitted = _opened(mi, properties, owner)
            self.filter = one_of(owner, "filter", properties.get("filter", FILTERS[0]), FILTERS)
            self.marks = one_of(owner, "gaps", properties.get("gaps", GAPS[0]), GAPS) == "mark"
            self.strict = _truth(properties, owner, "strict")
            hours = properties.get("time", float(self.fitted.hours[0]))
            if isinstance(hours, bool) or not isinstance(hours, (int, float)):
                raise ParameterError(f"{owner}: time = {str(hours)[:80]!r} is not a number of hours", "Give a number")
            self.pictures = pictures
            found = pictures(self.fitted, hours, self.strict)
            self.own = [name for name in found.values if name not in properties]
            for name in self.own:
                properties[name] = self._bitmap(found.values[name])
            super().__init__(properties, _template(self.fitted), (), OTHERS)
            self.to_uv = _transform(properties, owner)
            # A constant texture, so that mitsuba.traverse can change it in every variant.
            self.time = mi.load_dict({"type": "uniform", "value": float(hours)})
            self.mask = self._bitmap(_mask(found)) if self.marks and found.gaps.any() else None

        def _bitmap(self, values: Any) -> Any:
            bitmap = {"bitmap": mi.Bitmap(values), "raw": True, "filter_type": "nearest", "wrap_mode": "mirror"}
            return mi.load_dict({"type": "bitmap", **bitmap})

        # ------------------------------------------------------------ where

        def _corners(self, si: Any) -> list[tuple[Any, Any]]:
            """The texels that a point shows: the share of each, and the interaction with texture coordinates in its middle."""
            rows, columns = self.fitted.shape
            u, v = (a * si.uv.x + b * si.uv.y + c for a, b, c in self.to_uv)
            place = mi.Point2f(u * columns, v * rows)
            if self.filter == "nearest":
                return [(None, self._at(si, dr.floor(place)))]
            first = dr.floor(place - 0.5)
            share = place - 0.5 - first
            found = []
            for down in (0, 1):
                for right in (0, 1):
                    weight = (share.x if right else 1 - share.x) * (share.y if down else 1 - share.y)
                    found.append((weight, self._at(si, first + mi.Point2f(right, down))))
            return found

        def _at(self, si: Any, texel: Any) -> Any:
            rows, columns = self.fitted.shape
            there = mi.SurfaceInteraction3f(si)
            there.uv = mi.Point2f((texel.x + 0.5) / columns, (texel.y + 0.5) / rows)
            return there

        def _marked(self, si: Any, active: Any) -> Any:
            assert self.mask is not None
            return self.mask.eval_1(si, active) > 0.5

        # ------------------------------------------------------------ light

        @np.errstate(all="ignore")
        def eval_pdf(self, context: Any, si: Any, wo: Any, active: Any = True) -> tuple[Any, Any]:
            value, pdf = None, None
            for share, there in self._corners(si):
                one, density = self._texel_eval_pdf(context, there, wo, active)
                if share is None:
                    return one, density
                value = share * one if value is None else value + share * one
                pdf = share * density if pdf is None else pdf + share * density
            return value, pdf

        def _texel_eval_pdf(self, context: Any, si: Any, wo: Any, active: Any) -> tuple[Any, Any]:
            value, pdf = super().eval_pdf(context, si, wo, active)
            if self.mask is None:
                return value, pdf
            above = active & (si.wi.z > HORIZON) & (wo.z > HORIZON)
            marked, cosine = self._marked(si, active), dr.select(above, wo.z * dr.inv_pi, 0.0)
            flat = _spectrum(mi, mi.UnpolarizedSpectrum(mi.Color3f(*MARK)) * cosine)
            return dr.select(marked, flat, value), dr.select(marked, cosine, pdf)

        @np.errstate(all="ignore")
        def sample(self, context: Any, si: Any, sample1: Any, sample2: Any, active: Any = True) -> tuple[Any, Any]:
            corners = self._corners(si)
            share, there = corners[0]
            if share is None:
                if self.mask is None:
                    found: tuple[Any, Any] = super().sample(context, there, sample1, sample2, active)
                    return found
            else:  # one of the four texels by its share, with what is left of the random number
                begin, end, number = mi.Float(0.0), share, sample1 / dr.maximum(share, 1e-30)
                for following, other in corners[1:]:
                    begin, end = end, end + following
                    later = sample1 >= begin
                    there.uv = dr.select(later, other.uv, there.uv)
                    number = dr.select(later, (sample1 - begin) / dr.maximum(following, 1e-30), number)
                sample1 = dr.clip(number, 0.0, 1 - 1e-7)
            bs, _ = super().sample(context, there, sample1, sample2, active)
            if self.mask is not None:
                marked = self._marked(there, active)
                bs.wo = dr.select(marked, mi.warp.square_to_cosine_hemisphere(sample2), bs.wo)
                bs.pdf = dr.select(marked, mi.warp.square_to_cosine_hemisphere_pdf(bs.wo), bs.pdf)
            alive = active & (bs.pdf > 0)
            value, pdf = self.eval_pdf(context, si, bs.wo, alive)
            bs.pdf = dr.select(alive, pdf, 0.0)
            return bs, dr.select(alive & (pdf > 0), value / dr.maximum(pdf, 1e-30), 0.0)

        # ------------------------------------------------------------ Mitsuba's ways

        def traverse(self, callback: Any) -> None:
            super().traverse(callback)
            callback.put("time", self.time, mi.ParamFlags.NonDifferentiable)

        def parameters_changed(self, keys: list[str]) -> None:
            if any(key.split(".")[0] == "time" for key in keys):
                hours = float(np.asarray(mi.traverse(self.time)["value"]).ravel()[0])
                found = self.pictures(self.fitted, hours, self.strict)
                for value in self.values.values.values():
                    if value.slot.name in self.own:
                        _put(mi, value.texture, found.values[value.slot.name])
                self.mask = self._bitmap(_mask(found)) if self.marks and found.gaps.any() else None
            super().parameters_changed(keys)

        def to_string(self) -> str:
            return f"{self.fitted.path.name} {_describe(self.values)}"

    return MapSurface


def _opened(mi: Any, properties: Any, owner: str) -> Any:
    """The fitted map that the scene names."""
    from motes.maps import FittedMap, open_map

    folder = _resolved(mi, properties, owner)
    if not mi.is_rgb:
        raise ParameterError(
            f"{owner} shows red, green and blue, and the variant is {mi.variant()}", "Set llvm_ad_rgb, or scalar_rgb"
        )
    fitted = open_map(folder)
    if not isinstance(fitted, FittedMap):
        raise DataError(f"{folder} holds measured reflectance at every texel", f"motes fit {folder} fits every texel")
    if not fitted.brdf.reciprocal:
        raise ParameterError(
            f"{folder} is not reciprocal, so it is no BRDF: {describe(fitted.brdf)}", "Fit dust of the form brdf"
        )
    return fitted


def _template(fitted: Any) -> Any:
    """The model, what was held in place with its channels as red, green and blue."""
    from motes.rendering.map_textures import channel_order

    order = channel_order(fitted)
    if order in ([0], [0, 1, 2]):
        return fitted.brdf
    held = {slot.name: np.asarray(slot.value) for slot in fitted.brdf.slots()}
    return fitted.brdf.with_parameters({name: v[order] for name, v in held.items() if v.ndim and v.size == 3})


def _mask(found: Pictures) -> Any:
    return found.gaps[:, :, None].astype(np.float32)


def _put(mi: Any, texture: Any, values: Any) -> None:
    parameters = mi.traverse(texture)
    parameters["data"] = mi.TensorXf(values)
    parameters.update()


def _transform(properties: Any, owner: str) -> list[list[float]]:
    """What is done to texture coordinates, two rows of three numbers: of a transformation in space that of x and y, shifts among it."""
    given = properties.get("to_uv", None)
    matrix = np.eye(3) if given is None else np.array(getattr(given, "matrix", np.nan), np.float64)
    if matrix.shape == (4, 4):
        matrix = matrix[np.ix_([0, 1, 3], [0, 1, 3])]
    if matrix.shape != (3, 3) or not np.isfinite(matrix).all():
        raise ParameterError(f"{owner}: to_uv = {str(given)[:80]} is not a transformation", "Give scale and translate")
    rows: list[list[float]] = matrix[:2].tolist()
    return rows


def _truth(properties: Any, owner: str, name: str) -> bool:
    word = properties.get(name, False)
    if not isinstance(word, bool):
        raise MotesError(f"{owner}: {name} = {str(word)[:80]!r} is neither true nor false", "Give one of them")
    return word
