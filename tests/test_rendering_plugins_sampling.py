"""The plugins' sampling: Mitsuba's chi-square test, white furnaces, two ways to render one picture, and what importance sampling saves."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.stats import chi2, norm

from catalogue import direction
from motes import GGX, Dielectric, Dust, DustLayer, Lambert, OrenNayar, TorranceSparrow
from motes.models import BRDF
from motes.rendering import load_mitsuba, load_scene
from plugin_support import cosine_only, needs_llvm, rgb, sphere_scene

pytestmark = needs_llvm
ANGLES = (0.0, 0.9, 1.4, 1.55)
DIFFUSE = {"type": "diffuse", "reflectance": rgb(0.8, 0.5, 0.2)}
Description = dict[str, Any]

# By name: the plugin, and the same surface in Motes where there is one.
CASES: dict[str, tuple[Description, BRDF | None]] = {
    "oren_nayar": (
        {"type": "motes_oren_nayar", "K_d": rgb(0.8, 0.5, 0.2), "sigma_d": 0.9},
        OrenNayar(K_d=(0.8, 0.5, 0.2), sigma_d=0.9),
    ),
    "torrance_sparrow": (
        {"type": "motes_torrance_sparrow", "K_s": 0.8, "sigma_s": 0.15},
        TorranceSparrow(K_s=0.8, sigma_s=0.15),
    ),
    "wide_highlight": (
        {"type": "motes_torrance_sparrow", "K_s": 0.5, "sigma_s": 0.8, "normalization": "facets"},
        TorranceSparrow(K_s=0.5, sigma_s=0.8, normalization="facets"),
    ),
    "varnish": (
        {
            "type": "motes_torrance_sparrow",
            "K_s": 1.0,
            "sigma_s": 0.3,
            "normalization": "facets",
            "fresnel": "dielectric",
        },
        TorranceSparrow(K_s=1.0, sigma_s=0.3, normalization="facets", fresnel=Dielectric(n=1.5)),
    ),
    "compensated": (
        {"type": "motes_ggx", "K_s": 1.0, "alpha": 0.7, "scattering": "multiple"},
        GGX(1.0, 0.7, scattering="multiple"),
    ),
    "dusty": (
        {
            "type": "motes_dusty",
            "K_d": rgb(0.8, 0.5, 0.2),
            "sigma_s": 0.2,
            "w": rgb(0.9, 0.8, 0.7),
            "g": 0.4,
            "tau": 0.15,
        },
        DustLayer(OrenNayar((0.8, 0.5, 0.2)) + TorranceSparrow(sigma_s=0.2), Dust((0.9, 0.8, 0.7), 0.4), 0.15),
    ),
    "dust_over_diffuse": (
        {"type": "motes_dusty", "base": DIFFUSE, "w": 0.9, "g": -0.6, "tau": 0.4},
        DustLayer(Lambert(K_d=(0.8, 0.5, 0.2)), Dust(w=0.9, g=-0.6), 0.4),
    ),
    "multiple_over_diffuse": (
        {"type": "motes_dusty", "base": DIFFUSE, "w": 0.95, "g": 0.6, "tau": 0.6, "scattering": "multiple"},
        DustLayer(Lambert(K_d=(0.8, 0.5, 0.2)), Dust(w=0.95, g=0.6), 0.6, "multiple"),
    ),
    "multiple_over_principled": (
        {
            "type": "motes_dusty",
            "base": {"type": "principled", "roughness": 0.4},
            "w": 0.95,
            "tau": 0.4,
            "scattering": "multiple",
        },
        None,
    ),
    "dust_over_principled": (
        {"type": "motes_dusty", "base": {"type": "principled", "roughness": 0.4}, "g": 0.7, "tau": 0.1},
        None,
    ),
    "multiple_over_gold": (
        {
            "type": "motes_dusty",
            "base": {"type": "roughconductor", "material": "Au", "alpha": 0.2},
            "w": 0.95,
            "g": 0.7,
            "tau": 0.4,
            "scattering": "multiple",
        },
        None,
    ),
    "dust_over_rough_glass": (
        {"type": "motes_dusty", "base": {"type": "roughdielectric", "alpha": 0.4}, "g": 0.3, "tau": 0.1},
        None,
    ),
    "deep_dust": ({"type": "motes_dusty", "base": DIFFUSE, "w": 1.0, "g": 0.9, "tau": 50.0}, None),
}


@pytest.fixture(autouse=True)
def mi() -> Any:
    return load_mitsuba("llvm_ad_rgb")


# ---------------------------------------------------------------- The chi-square test


def chi_square_test(description: Description, density: Description, theta: float, samples: int = 200_000) -> Any:
    """Mitsuba's own test of the samples of one plugin against the density of another (or its own), ready to run.

    The rule that integrates the density is fine enough for the peaks at grazing; an odd resolution and an even number of
    nodes put the jump at the horizon between two nodes.
    """
    from mitsuba.chi2 import BSDFAdapter, ChiSquareTest, SphericalDomain

    wi = direction(theta, 0.5).tolist()
    sample, _ = BSDFAdapter(description["type"], description, wi=wi)
    _, pdf = BSDFAdapter(density["type"], density, wi=wi)
    res, ires = (201, 24) if theta > 1.5 else (101, 32)
    return ChiSquareTest(SphericalDomain(), sample, pdf, 3, sample_count=samples, res=res, ires=ires, seed=3)


@pytest.mark.parametrize("theta", ANGLES)
@pytest.mark.parametrize("name", CASES)
def test_samples_follow_the_density(name: str, theta: float) -> None:
    """With the significance shared by all cases (Sidak)."""
    description = CASES[name][0]
    test = chi_square_test(description, description, theta)
    assert test.run(0.01, len(CASES) * len(ANGLES), quiet=True), test.messages
    assert float(np.array(test.pdf_sum)[0]) < 1 + 1e-3


def test_from_inside_glass_only_the_glass_is_sampled(mi: Any) -> None:
    """For light that comes from below the surface the samples are those of the base, less what the layer keeps."""
    import drjit as dr

    n, tau = 10_000, 0.1
    description = CASES["dust_over_rough_glass"][0]
    si = dr.zeros(mi.SurfaceInteraction3f, n)
    si.wi = mi.Vector3f(*direction(2.5, 0.5).tolist())
    u = np.random.default_rng(8).random((3, n), np.float32)
    numbers = mi.Float(u[0]), mi.Point2f(u[1:])
    context, base = mi.BSDFContext(), load_scene(description["base"])
    glass, dusty = (bsdf.sample(context, si, *numbers) for bsdf in (base, load_scene(description)))
    np.testing.assert_allclose(np.array(dusty[0].wo), np.array(glass[0].wo), atol=1e-6)
    # Some samples of Mitsuba's rough glass have another density than its pdf says; the layer goes by the pdf.
    pdf = np.array(base.pdf(context, si, glass[0].wo))
    seen = (pdf > 1e-3) & (np.abs(np.array(glass[0].pdf) / np.maximum(pdf, 1e-3) - 1) < 1e-4)
    assert seen.mean() > 0.95
    np.testing.assert_allclose(np.array(dusty[0].pdf)[seen], np.array(glass[0].pdf)[seen], rtol=1e-4)
    z = np.array(glass[0].wo)[2]
    through = np.where(z > 0, np.exp(-tau / np.maximum(z, 1e-6)), 1.0)
    expected = np.array(glass[1]) * through
    assert (z > 0).mean() > 0.3
    np.testing.assert_allclose(np.array(dusty[1])[:, seen], expected[:, seen], rtol=1e-3, atol=1e-5)


def test_the_chi_square_test_sees_a_density_that_is_off() -> None:
    """The test can fail: a highlight 3 % wider than its density, and dust that scatters a little less backward."""
    for name, parameter, value in (("torrance_sparrow", "sigma_s", 0.1545), ("dust_over_diffuse", "g", -0.5)):
        description = CASES[name][0]
        test = chi_square_test(description | {parameter: value}, description, 0.9)
        assert not test.run(0.01, len(CASES) * len(ANGLES), quiet=True)


# ---------------------------------------------------------------- White furnaces


def weights(mi: Any, description: Description, theta: float, n: int = 400_000) -> NDArray[np.float64]:
    """The weights of many samples (n, 3) of light that the viewer at this angle sees."""
    import drjit as dr

    bsdf = load_scene(description)
    rng = np.random.default_rng(11)
    si = dr.zeros(mi.SurfaceInteraction3f, n)
    si.wi = mi.Vector3f(*direction(theta, 0.5).tolist())
    u = rng.random((3, n), np.float32)
    _, weight = bsdf.sample(mi.BSDFContext(), si, mi.Float(u[0]), mi.Point2f(u[1:]))
    return np.array(weight, np.float64).T


@pytest.mark.parametrize("theta", [0.0, 0.9, 1.4])
@pytest.mark.parametrize("name", [name for name, (_, model) in CASES.items() if model is not None])
def test_the_mean_weight_is_the_directional_albedo_of_the_model(mi: Any, name: str, theta: float) -> None:
    """By importance sampling in float32 here, by quadrature in float64 there."""
    description, model = CASES[name]
    assert model is not None
    weight = weights(mi, description, theta)
    standard_error = weight.std(0) / np.sqrt(len(weight))
    expected = model.directional_albedo(direction(theta, 0.5))
    # 1.1e-4 is the largest error of the quadrature at these angles (docs/accuracy.md).
    assert np.all(np.abs(weight.mean(0) - expected) < 4 * standard_error + 1.1e-4)


def test_no_dust_is_the_base_and_white_dust_keeps_less_than_all() -> None:
    """White dust that scatters once returns (1 - ln 2)/2 of light at normal incidence; none of it leaves a white base white."""
    mi = load_mitsuba()
    white = {"type": "diffuse", "reflectance": {"type": "uniform", "value": 1.0}}
    none = weights(mi, {"type": "motes_dusty", "base": white, "tau": 0.0}, 0.9)
    assert abs(none.mean() - 1) < 1e-5
    deep = weights(mi, {"type": "motes_dusty", "base": white, "w": 1.0, "g": 0.0, "tau": 100.0}, 0.0)
    assert abs(deep.mean() - (1 - np.log(2)) / 2) < 4 * deep.std() / np.sqrt(len(deep))


# ---------------------------------------------------------------- Two ways to the same picture

PICTURES = {
    "oren_nayar": CASES["oren_nayar"][0],
    "torrance_sparrow": {"type": "motes_torrance_sparrow", "K_s": 0.8, "sigma_s": 0.4},
    "dusty": CASES["dusty"][0],
    "dust_over_principled": CASES["dust_over_principled"][0],
}
SKY = {"type": "constant", "radiance": {"type": "uniform", "value": 1.0}}
# No sampling of the light: what the BSDF samples is all that there is.
BY_BSDF = {"type": "direct", "emitter_samples": 0, "bsdf_samples": 1, "hide_emitters": True}
BOTH = {"type": "path", "max_depth": 2, "hide_emitters": True}


def pictures(
    mi: Any, bsdf: Description, integrator: Description, seed: int, spp: int = 256, n: int = 24
) -> NDArray[np.float64]:
    """Pictures of one scene with different seeds (n, height, width, 3)."""
    scene = sphere_scene(bsdf, integrator, SKY)
    return np.stack([np.array(mi.render(scene, spp=spp, seed=seed + k), np.float64) for k in range(n)])


@pytest.mark.parametrize("name", PICTURES)
def test_sampling_by_the_plugin_and_by_the_cosine_agree(mi: Any, name: str) -> None:
    """A Z-test in every pixel and channel; also with light sampling, whose weights need the density to be right."""
    own = pictures(mi, PICTURES[name], BY_BSDF, 0)
    for other in (pictures(mi, cosine_only(PICTURES[name]), BY_BSDF, 1000), pictures(mi, PICTURES[name], BOTH, 2000)):
        variance = (own.var(0, ddof=1) + other.var(0, ddof=1)) / len(own)
        seen = variance > 0
        assert seen.mean() > 0.7  # the sphere
        z = (own.mean(0) - other.mean(0))[seen] / np.sqrt(variance[seen])
        threshold = norm.isf(0.5 * (1 - (1 - 0.01) ** (1 / z.size)))
        # 48 pictures: the quotient has the tails of Student's t with about 46 degrees of freedom.
        assert np.abs(z).max() < 1.25 * threshold
        # Their squares add up to chi-square, which a small difference everywhere would raise; t has the variance 46/44.
        pixels = z.reshape(-1, 3)[:, 0] if z.size % 3 == 0 else z
        assert chi2.sf(np.sum(pixels**2) * 44 / 46, pixels.size) > 1e-3
        assert abs(own.mean() / other.mean() - 1) < 2e-3


@pytest.mark.parametrize(("name", "factor"), [("torrance_sparrow", 3.0), ("dusty", 1.0), ("dust_over_principled", 1.0)])
def test_importance_sampling_lowers_the_variance(mi: Any, name: str, factor: float) -> None:
    own = pictures(mi, PICTURES[name], BY_BSDF, 0, n=12)
    cosine = pictures(mi, cosine_only(PICTURES[name]), BY_BSDF, 1000, n=12)
    assert cosine.var(0).mean() > factor * own.var(0).mean()
