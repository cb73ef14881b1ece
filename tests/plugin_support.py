"""What the tests of the Mitsuba plugins share."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

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


def slab(base: dict[str, Any], dust: dict[str, Any], wi: Any, wo: Any, samples: int) -> NDArray[np.float64]:
    """What 16 x 16 pixels (256, 3) see from `wo` of a BSDF that lies amid a slab of a medium, lit from `wi`, by Mitsuba's `volpath`: the BRDF [1/sr]."""
    mi = load_mitsuba()
    to = mi.ScalarTransform4f
    wide = to().scale([1e4, 1e4, 1.0])
    scene = {
        "type": "scene",
        "integrator": {"type": "volpath", "max_depth": -1, "rr_depth": 64, "hide_emitters": True},
        "base": {"type": "rectangle", "to_world": wide, "bsdf": base},
        # From z = -1 to 1; the opaque base lies in its middle.
        "slab": {"type": "cube", "to_world": wide, "bsdf": {"type": "null"}, "interior": dust},
        "light": {"type": "directional", "direction": [float(-x) for x in wi], "irradiance": rgb(1.0, 1.0, 1.0)},
        "sensor": {
            "type": "orthographic",
            "to_world": to().look_at(origin=[float(20 * x) for x in wo], target=[0.0, 0.0, 0.0], up=[0.0, 0.0, 1.0]),
            "film": {"type": "hdrfilm", "width": 16, "height": 16, "rfilter": {"type": "box"}, "pixel_format": "rgb"},
            "sampler": {"type": "independent", "sample_count": samples},
        },
    }
    return np.asarray(mi.render(load_scene(scene), seed=1), np.float64).reshape(-1, 3) / float(wi[2])
