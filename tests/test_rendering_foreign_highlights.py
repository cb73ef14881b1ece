"""Dust over BSDFs of Mitsuba: their highlights, measured from samples, and blurred as photons and volume paths say."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import photons
from motes.directions import from_spherical
from motes.models import GGX
from motes.rendering import load_mitsuba, load_scene
from motes.rendering.foreign_highlights import LEAST_ROUGHNESS, Measured, basis, measure
from plugin_support import needs_llvm, rgb, slab

pytestmark = needs_llvm
Floats = NDArray[np.float64]
AROUND = np.radians([-10.0, -5.0, 0.0, 5.0, 10.0])
GOLD = {"type": "roughconductor", "material": "Au", "alpha": 0.1}


def metal(alpha: float, reflected: float = 0.5) -> dict[str, Any]:
    """Facets of GGX that reflect a share of the light."""
    return {
        "type": "roughconductor",
        "distribution": "ggx",
        "material": "none",
        "alpha": alpha,
        "specular_reflectance": rgb(reflected, reflected, reflected),
    }


def dusty(base: dict[str, Any], tau: float, w: float, g: float) -> Any:
    return load_scene({"type": "motes_dusty", "tau": tau, "w": w, "g": g, "scattering": "multiple", "base": base})


def seen(mi: Any, bsdf: Any, wi: Floats, wo: Floats) -> Floats:
    """The BRDF [1/sr] (N, 3) from `wi` (3,) or (N, 3) to `wo` (N, 3)."""
    import drjit as dr

    si = dr.zeros(mi.SurfaceInteraction3f, len(wo))
    si.wi = mi.Vector3f(np.broadcast_to(wi, wo.shape).T.astype(np.float32))
    return np.array(bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(wo.T.astype(np.float32)))).T / wo[:, 2:]


def sampled(mi: Any, bsdf: Any, cosine: float) -> float:
    """The directional albedo, from the weights of samples."""
    import drjit as dr

    count, random = 2**17, np.random.default_rng(1)
    si = dr.zeros(mi.SurfaceInteraction3f, count)
    si.wi = mi.Vector3f(float(np.sqrt(1 - cosine**2)), 0.0, cosine)
    first, u, v = (mi.Float(x.astype(np.float32)) for x in random.random((3, count)))
    weight = np.array(bsdf.sample(mi.BSDFContext(), si, first, mi.Point2f(u, v))[1])
    assert weight.std() < 2 * weight.mean()  # what is sampled is about what is reflected
    return float(weight.mean())


def shares(found: Measured | None, cosine: float) -> Floats:
    assert found is not None
    return np.asarray(np.stack(basis(1 - np.array(cosine)), -1) @ found.shares)


@pytest.mark.parametrize("variant", ["llvm_ad_rgb", "scalar_rgb", "llvm_ad_spectral"])
def test_highlights_are_measured(variant: str) -> None:
    mi = load_mitsuba(variant)
    found = measure(mi, load_scene(metal(0.2)))
    for cosine in (0.5, 1.0):  # towards grazing Mitsuba's masking is another
        wi = np.array([np.sqrt(1 - cosine**2), 0.0, cosine])
        np.testing.assert_allclose(shares(found, cosine), GGX(0.5, 0.2).directional_albedo(wi)[0], atol=0.01)
    assert found is not None
    assert abs(found.alpha - 0.2) < 0.02
    assert (found.diffuse == 0).all()
    mirror = measure(mi, load_scene({"type": "conductor", "material": "none"}))
    assert mirror is not None
    assert mirror.alpha == LEAST_ROUGHNESS
    np.testing.assert_allclose(shares(mirror, 0.4), 1.0, atol=0.01)
    plastic = measure(mi, load_scene({"type": "plastic", "int_ior": 1.5}))
    np.testing.assert_allclose(shares(plastic, 1.0), 0.04, atol=0.01)  # ((n - 1) / (n + 1))^2
    assert measure(mi, load_scene({"type": "diffuse"})) is None


def test_colours_are_measured_and_a_change_of_the_base_is_seen() -> None:
    mi = load_mitsuba("llvm_ad_rgb")
    red, _, blue = shares(measure(mi, load_scene(GOLD)), 1.0)
    assert red > 0.9
    assert blue < 0.4
    bsdf = dusty(metal(0.1), 0.5, 0.9, 0.6)
    wi, wo = from_spherical(0.4, 0.0), from_spherical(0.4 + AROUND, np.pi)
    before, parameters = seen(mi, bsdf, wi, wo), mi.traverse(bsdf)
    parameters["base.alpha.value"] = 0.3
    parameters.update()
    np.testing.assert_allclose(seen(mi, bsdf, wi, wo), seen(mi, dusty(metal(0.3), 0.5, 0.9, 0.6), wi, wo), rtol=1e-5)
    assert (np.abs(seen(mi, bsdf, wi, wo) / before - 1) > 0.1).any()


@pytest.mark.parametrize(
    ("alpha", "tau", "g"), [(0.1, 0.5, 0.6), (0.1, 1.0, 0.85), (0.3, 0.5, 0.85), (0.3, 0.5, 0.0), (0.05, 0.1, 0.6)]
)
@pytest.mark.parametrize("degrees", [25.0, 55.0])
def test_a_foreign_highlight_is_blurred_as_photons_say(alpha: float, tau: float, g: float, degrees: float) -> None:
    """Within 13 %: that of a dimmed highlight alone is up to 77 % too dark here."""
    mi, theta = load_mitsuba("llvm_ad_rgb"), np.radians(degrees)
    wi = from_spherical(theta, 0.0)
    wo = np.concatenate([from_spherical(theta + AROUND, np.pi), from_spherical(theta, np.pi + AROUND[:2])])
    truth = photons.brdf(photons.Layer(GGX(0.5, alpha), tau, 0.9, g), wi, wo, 2**13, swap=False)
    ours = seen(mi, dusty(metal(alpha), tau, 0.9, g), wi, wo)[:, 0]
    assert (np.abs(ours - truth.value) < 0.13 * truth.value + 3 * truth.error).all()


@pytest.mark.parametrize(
    "base",
    [
        GOLD,
        {"type": "roughplastic", "alpha": 0.15, "diffuse_reflectance": rgb(0.4, 0.2, 0.1)},
        {"type": "principled", "roughness": 0.4, "metallic": 0.5, "base_color": rgb(0.7, 0.4, 0.2)},
    ],
    ids=lambda base: base["type"],
)
def test_other_highlights_are_as_volume_paths_say(base: dict[str, Any]) -> None:
    """Mitsuba's `volpath` in a slab over the very BSDF, each channel within 8 %, where single scattering is 15 to 40 % too dark."""
    mi, (tau, w, g) = load_mitsuba("llvm_ad_rgb"), (0.3, 0.9, 0.6)
    theta = 0.6
    wi, wo = from_spherical(theta, 0.0), from_spherical(theta + np.array([-0.2, 0.2]), np.pi)
    dust = {"type": "homogeneous", "sigma_t": tau, "albedo": rgb(w, w, w), "phase": {"type": "hg", "g": g}}
    ours = seen(mi, dusty(base, tau, w, g), wi, wo)
    for viewer, value in zip(wo, ours, strict=True):
        pixels = slab(base, dust, wi, viewer, 128)
        error = pixels.std(axis=0, ddof=1) / 16
        assert (error < 0.015 * pixels.mean(0)).all()
        assert (np.abs(value - pixels.mean(0)) < 0.08 * pixels.mean(0) + 3 * error).all()


def test_blurred_highlights_are_reciprocal_and_white_dust_over_a_white_mirror_makes_no_light() -> None:
    mi = load_mitsuba("llvm_ad_rgb")
    random = np.random.default_rng(1)
    wi, wo = (from_spherical(1.3 * np.sqrt(u), 6.28 * v) for u, v in (random.random((2, 500)), random.random((2, 500))))
    bsdf = dusty(GOLD, 0.5, 0.9, 0.7)
    np.testing.assert_allclose(seen(mi, bsdf, wi, wo), seen(mi, bsdf, wo, wi), rtol=5e-4)
    mirror = dusty({"type": "conductor", "material": "none"}, 0.5, 1.0, 0.6)
    assert abs(sampled(mi, mirror, 0.9) - 1) < 0.06
    assert abs(sampled(mi, dusty(metal(0.1, 1.0), 0.5, 1.0, 0.6), 0.9) - 1) < 0.06
