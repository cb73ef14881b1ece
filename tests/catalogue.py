"""One entry a model: what the tests of properties run on.  Add a model here and every property is tested on it.

An entry's `at_rows` gives the model at the parameters of golden rows and the values expected there, which come from the columns of
the table (see `golden`) and from closed forms that are written here in another way than in `motes.equations`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import quad

import layer_blur
import layer_network
from golden import Rows, published
from motes import directions
from motes.arrays import NUMPY
from motes.directions import Geometry, Vector
from motes.models import (
    BRDF,
    EON,
    GGX,
    GTR,
    Beckmann,
    CoatedDiffuse,
    Conductor,
    Dielectric,
    Dust,
    DustLayer,
    Fresnel,
    Hapke,
    Lambert,
    OrenNayar,
    Retro,
    Schlick,
    Sheen,
    TorranceSparrow,
)
from motes.models.coated_diffuse import diffuse_reflectance
from motes.models.gtr import gtr_grazing_roughness
from motes.models.missing_energy import BECKMANN_MISSING, GGX_MISSING, MissingEnergy

AtRows = Callable[[Rows], tuple[BRDF, NDArray[np.float64]]]


@dataclass(frozen=True)
class Entry:
    """A model and what is known about it.

    Parameters
    ----------
    name
        Of the test.
    model
        Typical parameters, away from kinks (g = 0, the switch in `facet_area` at sigma_s = 0.25), so that derivatives exist.
    at_rows
        Rows to the model there and the expected values (N,).
    reciprocal
        Whether eval(wi, wo) = eval(wo, wi).
    directional
        The directional albedo as a function of cos(theta_i), where known, and from `where` (a smallest cosine).
    spherical
        The spherical albedo, its tolerance, or None.
    at_most
        A bound of the spherical albedo: 1 where energy is conserved, None where K_s is the height of a highlight and no share of energy.
    """

    name: str
    model: BRDF
    at_rows: AtRows
    reciprocal: bool = True
    directional: Callable[[float], NDArray[np.float64]] | None = None
    where: float = 0.0
    spherical: tuple[float, float] | None = None
    at_most: float | None = 1.0

    def __str__(self) -> str:
        return self.name


def reference(model: BRDF, wi: NDArray[np.float64], wo: NDArray[np.float64]) -> NDArray[np.float64]:
    """`BRDF.eval` by the equations over NumPy, whatever the engine does with many directions."""
    with np.errstate(all="ignore"):
        return model.value(NUMPY, Geometry(NUMPY, Vector.of(wi), Vector.of(wo)))


def column(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Parameters (N,) as (N, 1): one channel."""
    return values[:, None]


# ---------------------------------------------------------------- Expected values at golden rows


def rho_d(r: Rows) -> NDArray[np.float64]:
    return np.maximum(r["rho_d"], 0.0)


def dust_brdf(r: Rows) -> NDArray[np.float64]:
    return r["rho_dust"] / (4 * np.pi * r["cos_theta_i"])


def lambert(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    return Lambert(column(r["K_d"])), r["K_d"] / np.pi


def oren_nayar(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    return OrenNayar(column(r["K_d"]), r["sigma_d"]), rho_d(r)


def smooth_oren_nayar(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    return OrenNayar(column(r["K_d"]), 0.0), r["K_d"] / np.pi


def eon(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    return EON(column(r["K_d"]), r["w"]), published.eon(*angles(r), r["K_d"], r["w"])


def torrance_sparrow(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    return TorranceSparrow(column(r["w"]), r["sigma_s"]), r["w"] * r["rho_s"]


def facet_area(sigma_s: float) -> float:
    """The facets' projected area, by SciPy: the integral of D cos(theta_h) over the hemisphere."""
    breaks = [x for x in (sigma_s, 3 * sigma_s, 6 * sigma_s) if x < np.pi / 2]
    value, _ = quad(
        lambda t: 2 * np.pi * np.exp(-((t / sigma_s) ** 2)) * np.cos(t) * np.sin(t),
        0,
        np.pi / 2,
        points=breaks or None,
        epsabs=0,
        epsrel=1e-13,
        limit=200,
    )
    return value


def torrance_sparrow_facets(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    area = np.array([facet_area(s) for s in r["sigma_s"]])
    return TorranceSparrow(column(r["w"]), r["sigma_s"], normalization="facets"), r["w"] * r["rho_s"] / area


def fresnel(cos_theta: NDArray[np.float64], index: NDArray[np.complex128] | complex) -> NDArray[np.float64]:
    """Unpolarised reflectance by Snell's law and Fresnel's amplitudes in complex arithmetic, for any index n + ik."""
    sin_theta = np.sqrt((1 - cos_theta) * (1 + cos_theta))
    cos_t = np.sqrt(1 - (sin_theta / index) ** 2 + 0j)
    r_s = (cos_theta - index * cos_t) / (cos_theta + index * cos_t)
    r_p = (index * cos_theta - cos_t) / (index * cos_theta + cos_t)
    return 0.5 * (np.abs(r_s) ** 2 + np.abs(r_p) ** 2)


def torrance_sparrow_dielectric(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    n = 1.2 + r["w"]
    model = TorranceSparrow(0.7, r["sigma_s"], fresnel=Dielectric(column(n)))
    return model, 0.7 * r["rho_s"] * fresnel(r["cos_theta_d"], n)


def torrance_sparrow_conductor(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    n, k = 0.2 + r["w"], 5 * r["K_d"]
    model = TorranceSparrow(0.7, r["sigma_s"], fresnel=Conductor(column(n), column(k)))
    return model, 0.7 * r["rho_s"] * fresnel(r["cos_theta_d"], n + 1j * k)


def torrance_sparrow_schlick(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    model = TorranceSparrow(0.7, r["sigma_s"], fresnel=Schlick(column(r["w"])))
    return model, 0.7 * r["rho_s"] * (r["w"] + (1 - r["w"]) * (1 - r["cos_theta_d"]) ** 5)


def angles(r: Rows) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    return r["theta_i"], r["theta_r"], r["phi_r"] - r["phi_i"]


def schlick(r: Rows) -> NDArray[np.float64]:
    return r["w"] + (1 - r["w"]) * (1 - r["cos_theta_d"]) ** 5


def ggx(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    alpha = 0.05 + r["sigma_s"]
    return GGX(column(r["w"]), alpha), r["w"] * published.ggx(*angles(r), alpha)


def ggx_schlick(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    alpha = 0.05 + r["sigma_s"]
    return GGX(0.7, alpha, Schlick(column(r["w"]))), 0.7 * schlick(r) * published.ggx(*angles(r), alpha)


def gtr(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    alpha, gamma = 0.05 + r["sigma_s"], 1 + 4 * r["w"]
    masking = gtr_grazing_roughness(NUMPY, alpha, gamma)  # test_models_richer.py says what it must be
    return GTR(column(r["w"]), alpha, gamma), r["w"] * published.gtr(*angles(r), alpha, gamma, masking)


def beckmann(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    alpha = 0.1 + r["sigma_s"]
    model = Beckmann(0.7, alpha, Dielectric(column(1.2 + r["w"])))
    return model, 0.7 * fresnel(r["cos_theta_d"], 1.2 + r["w"]) * published.beckmann(*angles(r), alpha)


def given_back(r: Rows, alpha: NDArray[np.float64], missing: MissingEnergy, term: Fresnel) -> NDArray[np.float64]:
    """Light reflected more than once; test_models_compensation.py says what is missing, and what the mean of F must be."""
    i, o = (missing(NUMPY, r[f"cos_theta_{k}"], alpha) for k in "ir")
    F = term.mean(NUMPY)[:, 0]
    return published.given_back(i, o, missing.mean(NUMPY, alpha), F, missing.staying(NUMPY, alpha))


def ggx_compensated(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    n, k, alpha = 0.2 + r["w"], 5 * r["K_d"], 0.05 + r["sigma_s"]
    term = Conductor(column(n), column(k))
    once = fresnel(r["cos_theta_d"], n + 1j * k) * published.ggx(*angles(r), alpha)
    return GGX(0.7, alpha, term, "multiple"), 0.7 * (once + given_back(r, alpha, GGX_MISSING, term))


def beckmann_compensated(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    alpha, term = 0.1 + r["sigma_s"], Schlick(column(r["w"]))
    once = schlick(r) * published.beckmann(*angles(r), alpha)
    more = given_back(r, alpha, BECKMANN_MISSING, term)
    return Beckmann(0.7, alpha, term, "multiple"), 0.7 * (once + more)


def hapke(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    B_0, h = r["K_d"], 0.01 + r["sigma_s"]
    return Hapke(column(r["w"]), r["g"], B_0, h), published.hapke(*angles(r), r["w"], r["g"], B_0, h)


def coated_diffuse(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    n = 1.2 + r["w"]
    mean = diffuse_reflectance(NUMPY, n)  # test_models_richer.py says what it must be
    return CoatedDiffuse(column(r["K_d"]), n), published.coated_diffuse(*angles(r), r["K_d"], n, mean)


def retro(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    alpha = 0.05 + r["sigma_s"]
    theta_i, theta_r, phi = angles(r)
    return Retro(column(r["w"]), alpha), r["w"] * published.ggx(theta_i, theta_r, phi + np.pi, alpha)


def sheen(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    a = np.clip(0.22 + r["sigma_s"], 0.22, 1.0)
    return Sheen(column(r["K_d"]), a), r["K_d"] * published.sheen(*angles(r), a)


def dust(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    return Dust(column(r["w"]), r["g"]), dust_brdf(r)


def dust_brightness(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    return Dust(column(r["w"]), r["g"], form="brightness"), r["rho_dust"]


def rough_and_shiny(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    return oren_nayar(r)[0] + torrance_sparrow(r)[0], rho_d(r) + r["w"] * r["rho_s"]


def dust_layer(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    base, value = rough_and_shiny(r)
    tau = r["sigma_s"]
    share = np.exp(-tau / r["cos_theta_i"] - tau / r["cos_theta_r"])
    return DustLayer(base, Dust(column(r["w"]), r["g"]), tau), share * value + (1 - share) * dust_brdf(r)


def physical(r: Rows) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """w and g of real particles."""
    return np.minimum(r["w"], 1.0), np.clip(r["g"], -0.75, 0.9)


def dust_multiple(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    w, g = physical(r)
    once = w * phase(r, g) / (4 * np.pi * (r["cos_theta_i"] + r["cos_theta_r"]))
    more = layer_network.brdf(*angles(r), np.full_like(w, 1e30), w, g, 0 * w)
    return Dust(column(w), g, scattering="multiple"), once + more


def dust_layer_multiple(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    w, g = physical(r)
    tau, base = r["sigma_s"], np.minimum(r["K_d"], 0.9)
    share = np.exp(-tau / r["cos_theta_i"] - tau / r["cos_theta_r"])
    once = (1 - share) * w * phase(r, g) / (4 * np.pi * (r["cos_theta_i"] + r["cos_theta_r"]))
    model = DustLayer(Lambert(column(base)), Dust(column(w), g), tau, scattering="multiple")
    return model, once + layer_network.brdf(*angles(r), tau, w, g, base)


def dust_layer_over_a_highlight(r: Rows) -> tuple[BRDF, NDArray[np.float64]]:
    w, g = physical(r)
    tau, body, alpha = r["sigma_s"], np.minimum(r["K_d"], 0.9), 0.05 + 0.5 * r["w"] / (1 + r["w"])
    share = np.exp(-tau / r["cos_theta_i"] - tau / r["cos_theta_r"])
    base = body / np.pi + 0.5 * published.ggx(*angles(r), alpha)
    once = (1 - share) * w * phase(r, g) / (4 * np.pi * (r["cos_theta_i"] + r["cos_theta_r"]))
    more = layer_blur.added(*angles(r), tau, w, g, body, 0 * tau + 0.5, alpha)
    model = DustLayer(Lambert(column(body)) + GGX(0.5, alpha), Dust(column(w), g), tau, scattering="multiple")
    return model, share * base + once + more


def phase(r: Rows, g: NDArray[np.float64]) -> NDArray[np.float64]:
    """Henyey and Greenstein's phase function by vectors."""
    i, o = (directions.from_spherical(r[f"theta_{k}"], r[f"phi_{k}"]) for k in "ir")
    return (1 - g * g) / (1 + g * g + 2 * g * np.einsum("nk,nk->n", i, o)) ** 1.5


# ---------------------------------------------------------------- Known integrals


def isotropic_dust(cos_theta_i: float) -> NDArray[np.float64]:
    """Integral of cos_r / (4 pi (cos_i + cos_r)) over the hemisphere: (1 - mu ln(1 + 1/mu)) / 2."""
    return np.array([0.5 * (1 - cos_theta_i * np.log1p(1 / cos_theta_i))])


def facets_at_normal_incidence(sigma_s: float) -> float:
    """At normal incidence theta_r = 2 theta_h, and the albedo is the mean of G over facets, G = min(1, 2 cos(2 theta_h))."""

    def integrand(t: float) -> float:
        return 2 * np.pi * np.exp(-((t / sigma_s) ** 2)) * np.cos(t) * np.sin(t) * min(1.0, 2 * np.cos(2 * t))

    value, _ = quad(
        integrand, 0, np.pi / 4, points=[min(3 * sigma_s, 0.7), np.pi / 6], epsabs=0, epsrel=1e-12, limit=200
    )
    return value / facet_area(sigma_s)


def dense_albedo(model: BRDF, wi: NDArray[np.float64], n: int = 60) -> NDArray[np.float64]:
    """The directional albedo by Gauss-Legendre rules over theta_r and phi, in pieces about the mirror direction."""
    x, w = np.polynomial.legendre.leggauss(n)
    theta_i, phi_i = np.arccos(wi[2]), np.arctan2(wi[1], wi[0])

    def rule(*ends: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        pieces = [(a, b) for a, b in pairwise(ends) if b > a]
        nodes = [0.5 * (a + b) + 0.5 * (b - a) * x for a, b in pieces]
        return np.concatenate(nodes), np.concatenate([0.5 * (b - a) * w for a, b in pieces])

    theta, theta_weight = rule(0, max(theta_i - 0.2, 0), theta_i, min(theta_i + 0.2, np.pi / 2), np.pi / 2)
    phi, phi_weight = rule(0, 0.3, np.pi / 2, np.pi - 0.3, np.pi)
    theta, phi = np.meshgrid(theta, phi_i + phi, indexing="ij")
    wo = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1)
    weight = 2 * theta_weight[:, None] * phi_weight * np.sin(theta) * np.cos(theta)
    return np.einsum("ijc,ij->c", reference(model, wi, wo), weight)


WAVELENGTHS = np.linspace(400, 700, 31)
SPECTRUM = 0.3 + 0.2 * np.sin(WAVELENGTHS / 50)
PLASTER = OrenNayar(K_d=(0.8, 0.7, 0.6), sigma_d=0.4)
COAT = TorranceSparrow(K_s=0.3, sigma_s=0.15)

ENTRIES = (
    Entry("lambert", Lambert(K_d=(0.8, 0.5, 0.2)), lambert, directional=lambda mu: np.array([0.8, 0.5, 0.2])),
    Entry("oren_nayar", PLASTER, oren_nayar),
    # Spherical albedo 1.0002 and 0.80: the inter-reflection of (7) gives back a little more than (1) loses.
    Entry("oren_nayar_nearly_smooth", OrenNayar(1.0, 0.1), smooth_oren_nayar, spherical=(1.0002, 5e-5), at_most=1.0003),
    Entry("oren_nayar_rough", OrenNayar(1.0, 1.0), oren_nayar, spherical=(0.80, 5e-3)),
    # A white one returns all light: its albedo is 1 to the quadrature's 2e-5.
    Entry(
        "eon",
        EON(rho=(0.9, 0.5, 0.2), r=0.8),
        eon,
        directional=lambda mu: published.eon_albedo(np.arccos(mu), np.array([0.9, 0.5, 0.2]), 0.8),
        at_most=1.0 + 2e-5,
    ),
    Entry("torrance_sparrow", COAT, torrance_sparrow, at_most=None),
    Entry(
        "torrance_sparrow_facets_narrow",
        TorranceSparrow(1.0, 0.03, normalization="facets"),
        torrance_sparrow_facets,
        directional=lambda mu: np.array([facets_at_normal_incidence(0.03)]),
        where=1.0,
    ),
    Entry(
        "torrance_sparrow_facets_wide",
        TorranceSparrow((1.0, 0.5), 0.6, normalization="facets"),
        torrance_sparrow_facets,
        directional=lambda mu: facets_at_normal_incidence(0.6) * np.array([1.0, 0.5]),
        where=1.0,
    ),
    Entry(
        "torrance_sparrow_dielectric",
        TorranceSparrow(1.0, 0.1, "facets", Dielectric((1.33, 1.5, 1.9))),
        torrance_sparrow_dielectric,
    ),
    Entry(
        "torrance_sparrow_conductor",
        TorranceSparrow(0.9, 0.2, "facets", Conductor((0.14, 0.37, 1.4), (4.0, 2.4, 1.9))),
        torrance_sparrow_conductor,
    ),
    Entry("torrance_sparrow_schlick", TorranceSparrow(1.0, 0.3, "facets", Schlick(0.05)), torrance_sparrow_schlick),
    Entry("ggx", GGX((1.0, 0.5), 0.25), ggx),
    Entry("ggx_schlick", GGX(1.0, 0.6, Schlick((0.05, 0.5, 0.9))), ggx_schlick),
    Entry(
        "ggx_compensated",
        GGX(1.0, 0.6, Conductor((0.14, 0.37, 1.4), (4.0, 2.4, 1.9)), "multiple"),
        ggx_compensated,
    ),
    Entry("gtr", GTR((1.0, 0.5), 0.15, 1.4), gtr),
    Entry("beckmann", Beckmann(1.0, 0.4, Dielectric(1.5)), beckmann),
    Entry(
        "beckmann_compensated",
        Beckmann((1.0, 0.9, 0.5), 0.7, Schlick((0.4, 0.8, 0.9)), "multiple"),
        beckmann_compensated,
    ),
    Entry("coated_diffuse", CoatedDiffuse((0.9, 0.4), 1.5), coated_diffuse),
    Entry("hapke", Hapke((0.9, 0.5), -0.3, 0.6, 0.1), hapke, at_most=None),
    Entry("retro", Retro((1.0, 0.5), 0.25), retro),
    Entry("sheen", Sheen((1.0, 0.5), 0.4), sheen),
    Entry(
        "dust_isotropic", Dust(1.0, 0.0), dust, directional=isotropic_dust, spherical=(2 * (1 - np.log(2)) / 3, 1e-6)
    ),
    Entry("dust_forward", Dust((0.7, 0.6, 0.5), 0.6), dust),
    Entry("dust_backward", Dust((0.7, 0.6, 0.5), -0.4), dust),
    Entry(
        "dust_brightness",
        Dust(1.0, 0.0, "brightness"),
        dust_brightness,
        reciprocal=False,
        directional=lambda mu: 4 * np.pi * mu * isotropic_dust(mu),
        at_most=None,
    ),
    Entry("rough_and_shiny", PLASTER + COAT, rough_and_shiny, at_most=None),
    Entry(
        "spectral",
        OrenNayar(SPECTRUM, 0.2) + TorranceSparrow(0.1 + 0.5 * SPECTRUM, 0.05),
        rough_and_shiny,
        at_most=None,
    ),
    Entry("dust_layer", DustLayer(PLASTER + COAT, Dust((0.7, 0.6, 0.5), 0.3), tau=0.2), dust_layer, at_most=None),
    Entry("dust_multiple", Dust((0.95, 0.8, 0.5), 0.4, scattering="multiple"), dust_multiple, at_most=1.0002),
    Entry(
        "dust_layer_multiple",
        DustLayer(PLASTER, Dust((0.95, 0.8, 0.5), 0.5), tau=0.6, scattering="multiple"),
        dust_layer_multiple,
    ),
    Entry(
        "dust_layer_over_a_highlight",
        DustLayer(OrenNayar((0.6, 0.5, 0.4), 0.4) + GGX(0.2, 0.2), Dust((0.95, 0.8, 0.5), 0.7), 0.4, "multiple"),
        dust_layer_over_a_highlight,
        at_most=None,
    ),
    Entry(
        "dust_on_plaster_and_varnish",  # every name twice or more
        DustLayer(
            Lambert((0.1, 0.2)) + (PLASTER.with_parameters({"K_d": 0.4}) + COAT) + Lambert(0.05),
            Dust(0.5, -0.2),
            tau=0.7,
        )
        + TorranceSparrow(0.2, 0.08, fresnel=Dielectric(1.4)),
        dust_layer,
        at_most=None,
    ),
)


def parts(model: BRDF) -> list[object]:
    """The objects in the tree of a model."""
    return [model, *(part for child in model.children().values() for part in parts(child))]  # type: ignore[arg-type]


# ---------------------------------------------------------------- Directions


def direction(theta: float, phi: float = 0.0) -> NDArray[np.float64]:
    return np.array([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)])


def upper_directions(n: int, seed: int) -> NDArray[np.float64]:
    """Uniform over the upper hemisphere, (n, 3)."""
    rng = np.random.default_rng(seed)
    z, phi = rng.uniform(0, 1, n), rng.uniform(-np.pi, np.pi, n)
    r = np.sqrt((1 - z) * (1 + z))
    return np.stack([r * np.cos(phi), r * np.sin(phi), z], axis=-1)


# Pairs where formulas are at risk: normal, mirror, retro-reflection, grazing, opposite, at and below the horizon.
SPECIAL = {
    "normal": (direction(0.0), direction(0.0)),
    "normal and oblique": (direction(0.0), direction(0.9, 0.4)),
    "nearly normal": (direction(1e-9), direction(1e-9, 1.0)),
    "mirror": (direction(0.7, 0.3), direction(0.7, 0.3 + np.pi)),
    "retro": (direction(0.7, 0.3), direction(0.7, 0.3)),
    "grazing mirror": (direction(1.5707, 0.3), direction(1.5707, 0.3 + np.pi)),
    "grazing retro": (direction(1.5707, 0.3), direction(1.5707, 0.3)),
    "one at the horizon": (np.array([1.0, 0.0, 0.0]), direction(0.3)),
    "opposite at the horizon": (np.array([1.0, 0.0, 0.0]), np.array([-1.0, 0.0, 0.0])),
    "just above the horizon": (np.array([1.0, 0.0, 1e-15]), np.array([0.0, 1.0, 1e-15])),
    "cos(dphi) = 0": (direction(0.6), direction(0.8, np.pi / 2)),
    "light below": (direction(2.0), direction(0.5)),
    "viewer below": (direction(0.5), direction(2.0)),
    "both below": (direction(2.0), direction(2.0, 1.0)),
    "opposite": (direction(0.5, 0.2), -direction(0.5, 0.2)),
    "straight down": (-direction(0.0), -direction(0.0)),
}
SPECIAL_WI = np.stack([wi for wi, _ in SPECIAL.values()])
SPECIAL_WO = np.stack([wo for _, wo in SPECIAL.values()])


@contextmanager
def jax_in_float64() -> Iterator[None]:
    """JAX computes in float32 unless told otherwise; the switch has moved between versions."""
    jax = pytest.importorskip("jax")
    with jax.enable_x64(True) if hasattr(jax, "enable_x64") else jax.experimental.enable_x64():
        yield
