"""What the tests of the Mitsuba plugins share."""

from __future__ import annotations

from typing import Any

import pytest

from motes.rendering import llvm, load_mitsuba, load_scene

llvm.prepared()  # before Dr.Jit loads
pytest.importorskip("mitsuba")
needs_llvm = pytest.mark.skipif(llvm.prepared().path is None, reason="no LLVM that Dr.Jit can use")


def rgb(*color: float) -> dict[str, Any]:
    return {"type": "rgb", "value": list(color)}


def cosine_only(bsdf: dict[str, Any]) -> dict[str, Any]:
    """The same BSDF, sampled in proportion to the cosine: a plugin of the tests alone."""
    mi = load_mitsuba()
    import drjit as dr

    class CosineOnly(mi.BSDF):  # type: ignore[misc, name-defined]
        def __init__(self, properties: Any) -> None:
            mi.BSDF.__init__(self, properties)
            self.inner = properties.get("inner")
            self.m_components = [mi.BSDFFlags.DiffuseReflection | mi.BSDFFlags.FrontSide]
            self.m_flags = self.m_components[0]

        def sample(self, context: Any, si: Any, sample1: Any, sample2: Any, active: Any = True) -> tuple[Any, Any]:
            bs = dr.zeros(mi.BSDFSample3f)
            bs.wo = mi.warp.square_to_cosine_hemisphere(sample2)
            bs.pdf = mi.warp.square_to_cosine_hemisphere_pdf(bs.wo)
            bs.eta, bs.sampled_type = 1.0, +mi.BSDFFlags.DiffuseReflection
            value = self.inner.eval(context, si, bs.wo, active)
            return bs, dr.select(active & (bs.pdf > 0) & (si.wi.z > 0), value / bs.pdf, 0.0)

        def eval_pdf(self, context: Any, si: Any, wo: Any, active: Any = True) -> tuple[Any, Any]:
            pdf = mi.warp.square_to_cosine_hemisphere_pdf(wo)
            return self.inner.eval(context, si, wo, active), dr.select(active & (si.wi.z > 0) & (wo.z > 0), pdf, 0.0)

        def eval(self, context: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return self.eval_pdf(context, si, wo, active)[0]

        def pdf(self, context: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return self.eval_pdf(context, si, wo, active)[1]

        def to_string(self) -> str:
            return "CosineOnly[]"

    mi.register_bsdf("cosine_only", CosineOnly)
    return {"type": "cosine_only", "inner": bsdf}


def sphere_scene(bsdf: dict[str, Any], integrator: dict[str, Any], light: dict[str, Any], size: int = 24) -> Any:
    """A sphere that fills the picture, under one light."""
    mi = load_mitsuba()
    view = mi.ScalarTransform4f().look_at(origin=[0, 0, 5], target=[0, 0, 0], up=[0, 1, 0])
    film = {"type": "hdrfilm", "width": size, "height": size, "rfilter": {"type": "box"}, "pixel_format": "rgb"}
    return load_scene(
        {
            "type": "scene",
            "integrator": integrator,
            "sensor": {
                "type": "perspective",
                "fov": 23,
                "to_world": view,
                "film": film,
                "sampler": {"type": "independent"},
            },
            "light": light,
            "sphere": {"type": "sphere", "bsdf": bsdf},
        }
    )
