"""Measured materials in Mitsuba: RGL files through its own ``measured``, MERL tables through a BSDF of this module."""

from __future__ import annotations

import os
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.errors import DataError, MotesError
from motes.files import reading
from motes.measurements import merl, rgl
from motes.rendering.loading import native

Floats = NDArray[np.float64]


def measured_bsdf(path: str | os.PathLike[str]) -> Any:
    """A BSDF of Mitsuba for a measured material, by what is in the file: RGL (``.bsdf``) or MERL (``.binary``).

    Raises
    ------
    DataError
        For another format.
    FormatError
        When the file is damaged.
    """
    from motes.rendering import load_mitsuba, load_scene

    mi = load_mitsuba()
    file = Path(path)
    if not file.is_file():
        raise DataError(f"{file} does not exist", "Give the path of an RGL (.bsdf) or MERL (.binary) file")
    head = reading.head(file, 4096)
    if rgl.sniff(file, head):
        rgl.read_rgl(file, resolution=4)  # checks what Mitsuba's reader trusts
        if not file.stem.endswith("rgb") and not mi.is_spectral:
            raise MotesError(f"{file.name} is spectral", "Use the file of the same material that ends in _rgb.bsdf")
        return load_scene({"type": "measured", "filename": native(file.resolve())})
    if merl.sniff(file, head):
        return _merl_class(mi.variant())(table(file))
    raise DataError(
        f"{file} is neither an RGL nor a MERL file; other formats do not cover all pairs of directions",
        "motes fit makes a material of it, which motes render shows",
    )


def table(path: Path) -> NDArray[np.float32]:
    """A MERL table as BRDF values (90, 90, 182, 3) over theta_h, theta_d, phi_d, made fit for interpolation.

    Bins below the horizon take the value of the nearest theta_d above it, and phi_d is continued by one bin on both sides (it repeats after pi).
    """
    measurement = merl.read_merl(path)  # checks sizes
    shape = merl.FULL if not any("bins instead of" in n for n in measurement.provenance["notes"]) else None
    if shape is None:
        raise DataError(f"{path} does not have {merl.FULL} bins", "Render a full MERL table")
    planes = reading.binary(path, "<f8", 3 * reading.product(shape), 12, "the table").reshape(3, *shape)
    values = np.moveaxis(planes, 0, -1) * merl.SCALE
    invalid = ~(np.isfinite(values).all(-1) & (values.min(-1) >= 0))
    values = _filled(values, invalid)
    return np.concatenate([values[:, :, -1:], values, values[:, :, :1]], axis=2).astype(np.float32)


def _filled(values: Floats, invalid: NDArray[np.bool_]) -> Floats:
    """Invalid bins take the value at the nearest smaller theta_d that has one; those without, at the next larger one."""
    index = np.where(invalid, -1, np.arange(values.shape[1])[None, :, None])
    before = np.maximum.accumulate(index, axis=1)
    last = values.shape[1]
    after = np.minimum.accumulate(np.where(index < 0, last, index)[:, ::-1], axis=1)[:, ::-1]
    source = np.where(before >= 0, before, after)
    h, _, p = np.indices(source.shape)
    filled: NDArray[np.float64] = values[h, np.minimum(source, last - 1), p]
    filled[source == last] = 0.0  # a theta_h without a single valid bin
    return filled


def highlight_width(values: NDArray[np.float32]) -> float:
    """A GGX roughness that suits a table's highlight, from where it falls to half of its height; for sampling alone."""
    profile = values[:, :20].mean(axis=(1, 2, 3))
    floor = np.median(profile)
    if profile.max() <= 3 * floor:  # hardly a highlight
        return 0.5
    half = int(np.argmax(profile - floor < 0.5 * (profile.max() - floor)))
    theta_h = (max(half, 1) / 90) ** 2 * np.pi / 2
    # GGX falls to half where tan(theta) = alpha sqrt(sqrt(2) - 1).
    return float(np.clip(np.tan(theta_h) / np.sqrt(np.sqrt(2) - 1), 0.02, 0.8))


@cache
def _merl_class(variant: str) -> Any:
    """The plugin's class for a variant: Mitsuba's base classes differ from one to the next."""
    import drjit as dr

    from motes.rendering import load_mitsuba

    mi = load_mitsuba()
    xp = SimpleNamespace(asin=dr.asin, minimum=dr.minimum, where=dr.select)

    class MerlTable(mi.BSDF):  # type: ignore[name-defined]
        """A MERL table, interpolated in (theta_h, theta_d, phi_d); sampled by half a cosine, half a GGX lobe."""

        def __init__(self, values: NDArray[np.float32]) -> None:
            super().__init__(mi.Properties())
            self.m_components = [mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.FrontSide]
            self.m_flags = self.m_components[0]
            self.texture = mi.Texture3f(
                mi.TensorXf(np.ascontiguousarray(values)), wrap_mode=dr.WrapMode.Clamp, use_accel=False
            )
            self.distribution = mi.MicrofacetDistribution(mi.MicrofacetType.GGX, highlight_width(values), True)

        def value(self, wi: Any, wo: Any) -> Any:
            """The BRDF [1/sr]."""
            h = dr.normalize(wi + wo)
            sin_h = dr.safe_sqrt(h.x * h.x + h.y * h.y)
            inverse = dr.select(sin_h > 1e-7, dr.rcp(sin_h), 0)
            cos_phi, sin_phi = dr.select(sin_h > 1e-7, h.x * inverse, 1), h.y * inverse
            # wi turned by -phi_h about z and by -theta_h about y: the difference vector.
            x, y = cos_phi * wi.x + sin_phi * wi.y, cos_phi * wi.y - sin_phi * wi.x
            d = mi.Vector3f(h.z * x - sin_h * wi.z, y, sin_h * x + h.z * wi.z)
            theta_h = directions.polar_angle(xp, dr.maximum(h.z, 0), sin_h)
            theta_d = directions.polar_angle(xp, dr.maximum(d.z, 0), dr.safe_sqrt(d.x * d.x + d.y * d.y))
            phi_d = dr.atan2(d.y, d.x)
            phi_d = dr.select(phi_d < 0, phi_d + dr.pi, phi_d)
            scale = 2 / dr.pi
            # Texture coordinates run over the bins' edges; a value belongs to the middle of its bin.
            at = mi.Point3f((phi_d / dr.pi * 180 + 1) / 182, theta_d * scale, dr.sqrt(theta_h * scale))
            return mi.Color3f(self.texture.eval(at))

        def _spectrum(self, rgb: Any) -> Any:
            if mi.is_monochromatic:
                return mi.Color1f(mi.luminance(rgb))
            return rgb

        def sample(self, ctx: Any, si: Any, sample1: Any, sample2: Any, active: Any = True) -> Any:
            diffuse = mi.warp.square_to_cosine_hemisphere(sample2)
            m, _ = self.distribution.sample(si.wi, sample2)
            bs = mi.BSDFSample3f()
            bs.wo = dr.select(sample1 < 0.5, diffuse, mi.reflect(si.wi, m))
            bs.eta = 1.0
            bs.sampled_type = mi.UInt32(+mi.BSDFFlags.GlossyReflection)
            bs.sampled_component = mi.UInt32(0)
            value, bs.pdf = self.eval_pdf(ctx, si, bs.wo, active)
            good = active & (bs.pdf > 0)
            return bs, dr.select(good, value / dr.select(good, bs.pdf, 1), 0)

        def eval(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            above = active & (mi.Frame3f.cos_theta(si.wi) > 0) & (mi.Frame3f.cos_theta(wo) > 0)
            return dr.select(above, self._spectrum(self.value(wo, si.wi)) * mi.Frame3f.cos_theta(wo), 0)

        def pdf(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            cos_i, cos_o = mi.Frame3f.cos_theta(si.wi), mi.Frame3f.cos_theta(wo)
            h = dr.normalize(si.wi + wo)
            glossy = self.distribution.pdf(si.wi, h) / (4 * dr.maximum(dr.dot(wo, h), 1e-6))
            both = 0.5 * (mi.warp.square_to_cosine_hemisphere_pdf(wo) + glossy)
            return dr.select(active & (cos_i > 0) & (cos_o > 0), both, 0)

        def eval_pdf(self, ctx: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return self.eval(ctx, si, wo, active), self.pdf(ctx, si, wo, active)

        def to_string(self) -> str:
            return "MerlTable[]"

    return MerlTable
