"""Functions with one fault each, as programs have them, and what `motes.certify` must call it.

The right versions are written here a second time, by hand, so that a fault of Motes' own formulas would show.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[Any]
COLOUR = np.array([0.6, 0.4, 0.2])


@dataclass(frozen=True)
class Planted:
    """A fault: the function, how it is certified, the check that must find it and the name that it must give."""

    name: str
    function: Callable[..., Any]
    check: str
    found: str
    options: dict[str, Any] = field(default_factory=dict)

    def __str__(self) -> str:
        return self.name


# ---------------------------------------------------------------- right formulas


def above(wi: Floats, wo: Floats, value: Floats) -> Floats:
    """0 below the horizon; value (N,) or (N, C)."""
    lit = (wi[:, 2] > 1e-6) & (wo[:, 2] > 1e-6)
    return np.where(lit[:, None], value if value.ndim == 2 else value[:, None], 0)


def lambert(wi: Floats, wo: Floats) -> Floats:
    return above(wi, wo, np.broadcast_to(COLOUR / np.pi, (len(wi), 3)))


def half(wi: Floats, wo: Floats) -> Floats:
    h = wi + wo
    return h / np.maximum(np.linalg.norm(h, axis=1, keepdims=True), 1e-12)


def ggx_d(cos_h: Floats, alpha: float) -> Floats:
    return alpha**2 / (np.pi * (cos_h**2 * (alpha**2 - 1) + 1) ** 2)


def smith_lambda(cosine: Floats, alpha: float) -> Floats:
    tan2 = (1 - cosine**2) / np.maximum(cosine, 1e-9) ** 2
    return 0.5 * (np.sqrt(1 + alpha**2 * tan2) - 1)


def ggx(wi: Floats, wo: Floats, alpha: float = 0.3, denominator: float = 4.0, g: Any = None) -> Floats:
    ci, co = np.maximum(wi[:, 2], 1e-9), np.maximum(wo[:, 2], 1e-9)
    masking = 1 / (1 + smith_lambda(ci, alpha) + smith_lambda(co, alpha)) if g is None else g(ci, co)
    return above(wi, wo, ggx_d(half(wi, wo)[:, 2], alpha) * masking / (denominator * ci * co))


def henyey_greenstein(wi: Floats, wo: Floats, g: float) -> Floats:
    """Dust of equation (12) as a BRDF, for w = 0.7: gamma is the deviation, cos(gamma) = -wi . wo."""
    cosine = -np.sum(wi * wo, axis=1)
    phase = (1 - g * g) / (1 + g * g - 2 * g * cosine) ** 1.5
    return above(wi, wo, 0.7 * phase / (4 * np.pi * np.maximum(wi[:, 2] + wo[:, 2], 1e-9)))


def oren_nayar_1994(wi: Floats, wo: Floats, sigma: float = 0.3) -> Floats:
    """The qualitative model, equation (30) of Oren and Nayar 1994."""
    ti, to = np.arccos(np.clip(wi[:, 2], -1, 1)), np.arccos(np.clip(wo[:, 2], -1, 1))
    dphi = np.arctan2(wi[:, 1], wi[:, 0]) - np.arctan2(wo[:, 1], wo[:, 0])
    a, b = 1 - 0.5 * sigma**2 / (sigma**2 + 0.33), 0.45 * sigma**2 / (sigma**2 + 0.09)
    value = a + b * np.maximum(0, np.cos(dphi)) * np.sin(np.maximum(ti, to)) * np.tan(np.minimum(ti, to))
    return above(wi, wo, value[:, None] * COLOUR / np.pi)


# ---------------------------------------------------------------- samplers


def cosine_sample(wi: Floats, u: Floats) -> Floats:
    r, phi = np.sqrt(u[:, 0]), 2 * np.pi * u[:, 1]
    return np.stack([r * np.cos(phi), r * np.sin(phi), np.sqrt(1 - u[:, 0])], 1)


def cosine_pdf(wi: Floats, wo: Floats) -> Floats:
    return np.maximum(wo[:, 2], 0) / np.pi


def facet_sample(wi: Floats, u: Floats, alpha: float = 0.3) -> Floats:
    """Half vectors after D cos(theta_h), mirrored."""
    tan2 = alpha**2 * u[:, 0] / (1 - u[:, 0])
    cos_h, phi = 1 / np.sqrt(1 + tan2), 2 * np.pi * u[:, 1]
    sin_h = np.sqrt(1 - cos_h**2)
    h = np.stack([sin_h * np.cos(phi), sin_h * np.sin(phi), cos_h], 1)
    return 2 * np.sum(wi * h, 1, keepdims=True) * h - wi


def facet_pdf(wi: Floats, wo: Floats, alpha: float = 0.3) -> Floats:
    h = half(wi, wo)
    density = ggx_d(h[:, 2], alpha) * h[:, 2] / (4 * np.maximum(np.sum(wo * h, 1), 1e-9))
    return np.where(wo[:, 2] > 0, density, 0)


def weighted(sample: Callable[..., Floats], pdf: Callable[..., Floats], f: Callable[..., Floats], weight: Any) -> Any:
    """A sampler that returns wo, pdf and a weight of f, cos and pdf."""

    def drawn(wi: Floats, u: Floats) -> tuple[Floats, Floats, Floats]:
        wo = sample(wi, u)
        density, cosine = pdf(wi, wo)[:, None], np.maximum(wo[:, 2:], 0)
        return wo, density[:, 0], np.where(density > 0, weight(f(wi, wo), cosine, np.maximum(density, 1e-12)), 0)

    return drawn


# ---------------------------------------------------------------- faults that physics alone tells


def nan_at_normal(wi: Floats, wo: Floats) -> Floats:
    """cos(phi) by a division that is 0/0 where the viewer or the light is the normal."""
    sines = np.hypot(wi[:, 0], wi[:, 1]) * np.hypot(wo[:, 0], wo[:, 1])
    cos_dphi = (wi[:, 0] * wo[:, 0] + wi[:, 1] * wo[:, 1]) / sines
    return lambert(wi, wo) * (1 + 0.1 * cos_dphi[:, None] * sines[:, None])


def nan_by_arc_cosine(wi: Floats, wo: Floats) -> Floats:
    """An arc cosine of wi . wo, which rounds to above 1 where the two are one."""
    with np.errstate(all="ignore"):
        dot = np.sum(wi * wo, 1) * (1 + 4e-16)
        return above(wi, wo, 0.1 + 0.01 * np.arccos(dot))


def unclamped_polynomial(wi: Floats, wo: Floats) -> Floats:
    """A correction that goes below 0 where both directions are flat."""
    return above(wi, wo, 0.2 - 0.05 * (wi[:, 0] ** 2 + wi[:, 1] ** 2) ** 8 * (wo[:, 0] ** 2 + wo[:, 1] ** 2) ** 8 * 8)


def unclamped_division(wi: Floats, wo: Floats) -> Floats:
    """Facets without masking: nothing balances 1 / (4 cos cos)."""
    with np.errstate(all="ignore"):
        return above(wi, wo, ggx_d(half(wi, wo)[:, 2], 0.5) / (4 * wi[:, 2] * wo[:, 2]))


def infinite_at_mirror(wi: Floats, wo: Floats) -> Floats:
    """A Phong-like lobe by a division that vanishes at the mirror direction."""
    with np.errstate(all="ignore"):
        sine2 = 1 - np.clip(-wi[:, 0] * wo[:, 0] - wi[:, 1] * wo[:, 1] + wi[:, 2] * wo[:, 2], -1, 1)
        return above(wi, wo, 0.001 / np.round(sine2, 15))


def one_way_layer(wi: Floats, wo: Floats) -> Floats:
    """A layer that takes from the light on its way in alone."""
    return lambert(wi, wo) * np.exp(-0.4 / np.maximum(wi[:, 2:], 1e-6))


def one_masking(wi: Floats, wo: Floats) -> Floats:
    """Smith's masking of the viewer, and no shadowing of the light."""
    return ggx(wi, wo, g=lambda ci, co: 1 / (1 + smith_lambda(co, 0.3)))


def two_lobes_too_bright(wi: Floats, wo: Floats) -> Floats:
    """A white diffuse part, and a Fresnel highlight on top of it."""
    h = half(wi, wo)
    schlick = 0.04 + 0.96 * (1 - np.clip(np.sum(wi * h, 1), 0, 1)) ** 5
    return above(wi, wo, 0.95 / np.pi + ggx(wi, wo, 0.3)[:, 0] * schlick)


def cancelling(wi: Floats, wo: Floats) -> Floats:
    """A narrow highlight whose sine is the root of 1 - cos²."""
    cos_h = half(wi, wo)[:, 2]
    tan2 = (1 - cos_h * cos_h) / (cos_h * cos_h)
    return above(wi, wo, np.exp(-tan2 * wi.dtype.type(1e5)))


def y_up(wi: Floats, wo: Floats) -> Floats:
    """y is the normal."""
    return ggx(wi[:, [2, 0, 1]], wo[:, [2, 0, 1]])


def light_reversed(wi: Floats, wo: Floats) -> Floats:
    """wi is the way of the light, towards the surface."""
    return lambert(-wi, wo)


def dusty_gradient(factor: float) -> Callable[..., Any]:
    """d/d alpha of alpha² / pi, times a factor."""
    return lambda wi, wo, alpha: {"alpha": above(wi, wo, np.full(len(wi), factor * 2 * alpha / np.pi))}


def squared(wi: Floats, wo: Floats, alpha: float) -> Floats:
    return above(wi, wo, np.full(len(wi), alpha**2 / np.pi))


WHITE = {"sample": cosine_sample, "pdf": cosine_pdf}
FACETS = {"sample": facet_sample, "pdf": facet_pdf}

PHYSICS = (
    Planted("reflectance factor", lambda wi, wo: np.pi * lambert(wi, wo), "energy", "factor-pi"),
    Planted("MERL table without its scale", lambda wi, wo: 1500 * lambert(wi, wo), "energy", "merl-scale"),
    Planted("f cos", lambda wi, wo: lambert(wi, wo) * wo[:, 2:], "reciprocity", "cosine-included"),
    Planted("f over the cosine of the light", lambda wi, wo: 0.2 * ggx(wi, wo) / np.maximum(wi[:, 2:], 1e-6), "reciprocity", "cosine-of-light-divided"),
    Planted("azimuth at the normal", nan_at_normal, "values", "nan-at-normal"),
    Planted("arc cosine above 1", nan_by_arc_cosine, "values", "nan-at-normal"),
    Planted("negative at grazing", unclamped_polynomial, "values", "negative-at-grazing"),
    Planted("wrong sign", lambda wi, wo: -lambert(wi, wo), "values", "sign"),
    Planted("no masking", unclamped_division, "energy", "unclamped-at-grazing"),
    Planted("division by 0 at the mirror", infinite_at_mirror, "values", "infinite"),
    Planted("layer passed once", one_way_layer, "reciprocity", "one-sided-factor"),
    Planted("masking of the viewer alone", one_masking, "reciprocity", "one-sided-factor"),
    Planted("two lobes added", two_lobes_too_bright, "energy", "too-much-at-grazing"),
    Planted("no horizon", lambda wi, wo: np.full((len(wi), 1), 0.2), "values", "below-horizon"),
    Planted("cancellation", cancelling, "precision", "float32-cancellation"),
    Planted("normal along y", y_up, "conventions", "normal-is-y"),
    Planted("light reversed", light_reversed, "values", "light-reversed"),
    Planted("density of half vectors", ggx, "sampling", "jacobian-of-half-vector", {"sample": facet_sample, "pdf": lambda wi, wo: np.where(wo[:, 2] > 0, ggx_d(half(wi, wo)[:, 2], 0.3) * half(wi, wo)[:, 2], 0)}),
    Planted("density without its 4", ggx, "sampling", "jacobian-without-4", {"sample": facet_sample, "pdf": lambda wi, wo: 4 * facet_pdf(wi, wo)}),
    Planted("D without cos(theta_h)", ggx, "sampling", "cosine-of-half-vector-missing", {"sample": facet_sample, "pdf": lambda wi, wo: facet_pdf(wi, wo) / np.maximum(half(wi, wo)[:, 2], 1e-9)}),
    Planted("uniform density", lambert, "sampling", "cosine-missing-in-pdf", {"sample": cosine_sample, "pdf": lambda wi, wo: (wo[:, 2] > 0) / (2 * np.pi)}),
    Planted("density of projected solid angle", lambert, "sampling", "cosine-too-many-in-pdf", {"sample": cosine_sample, "pdf": lambda wi, wo: np.maximum(wo[:, 2], 0) ** 2 * 1.5 / np.pi}),
    Planted("density of angles", lambert, "sampling", "sine-in-pdf", {"sample": cosine_sample, "pdf": lambda wi, wo: cosine_pdf(wi, wo) * np.hypot(wo[:, 0], wo[:, 1])}),
    Planted("chance of the lobe forgotten", lambert, "sampling", "scale-of-pdf", {"sample": cosine_sample, "pdf": lambda wi, wo: 2 * cosine_pdf(wi, wo)}),
    Planted("samples of another width", ggx, "sampling", "shape-of-pdf", {"sample": lambda wi, u: facet_sample(wi, u, 0.32), "pdf": facet_pdf}),
    Planted("weight without cosine", lambert, "sampling", "weight-without-cosine", {"sample": weighted(cosine_sample, cosine_pdf, lambert, lambda f, c, p: f / p), "pdf": cosine_pdf}),
    Planted("weight not divided", lambert, "sampling", "weight-not-divided", {"sample": weighted(cosine_sample, cosine_pdf, lambert, lambda f, c, p: f * c), "pdf": cosine_pdf}),
    Planted("derivative of half a square", squared, "gradients", "gradient-factor-half", {"gradient": dusty_gradient(0.5), "parameters": {"alpha": 0.3}}),
    Planted("derivative per degree", squared, "gradients", "gradient-per-degree", {"gradient": dusty_gradient(np.pi / 180), "parameters": {"alpha": 0.3}}),
    Planted("derivative with the wrong sign", squared, "gradients", "gradient-sign", {"gradient": dusty_gradient(-1.0), "parameters": {"alpha": 0.3}}),
)  # fmt: skip

# ---------------------------------------------------------------- faults that a reference tells

GGX = "ggx(K_s=1, alpha=0.3)"
TWO = "lambert(K_d=(0.6, 0.4, 0.2)) + ggx(K_s=0.2, alpha=0.3)"
DUST = "dust(w=0.7, g=0.4)"
BRIGHTNESS = "dust(w=0.7, g=0.4, form=brightness)"


def against(model: str) -> dict[str, Any]:
    return {"as_model": model}


CONVENTIONS = (
    Planted("alpha squared", lambda wi, wo: ggx(wi, wo, 0.09), "conventions", "alpha-squared", against(GGX)),
    Planted("alpha for its square", lambda wi, wo: ggx(wi, wo, np.sqrt(0.3)), "conventions", "alpha-root", against(GGX)),
    Planted("pi for 4", lambda wi, wo: ggx(wi, wo, denominator=np.pi), "conventions", "factor-4-pi-for-4", against(GGX)),
    Planted("no 4", lambda wi, wo: ggx(wi, wo, denominator=1.0), "conventions", "factor-4", against(GGX)),
    Planted("D not normalised", lambda wi, wo: np.pi * 0.09 * ggx(wi, wo), "conventions", "scale", against(GGX)),
    Planted("sign of g", lambda wi, wo: henyey_greenstein(wi, wo, -0.4), "conventions", "sign-of-g", against(DUST)),
    Planted("phase function normalised to 1", lambda wi, wo: henyey_greenstein(wi, wo, 0.4) / (4 * np.pi), "conventions", "factor-1-4-pi", against(DUST)),
    Planted("swapped vectors", lambda wi, wo: 4 * np.pi * np.maximum(wo[:, 2:], 0) * henyey_greenstein(wi, wo, 0.4), "conventions", "swapped", against(BRIGHTNESS)),
    Planted("BGR", lambda wi, wo: lambert(wi, wo)[:, ::-1], "conventions", "channels-reversed", against("lambert(K_d=(0.6, 0.4, 0.2))")),
    Planted("BGR, and pi", lambda wi, wo: np.pi * lambert(wi, wo)[:, ::-1], "conventions", "channels-reversed", against("lambert(K_d=(0.6, 0.4, 0.2))")),
    Planted("1/pi of the diffuse term missing", lambda wi, wo: np.pi * lambert(wi, wo) + 0.2 * ggx(wi, wo), "conventions", "term-times-pi", against(TWO)),
    Planted("highlight missing", lambert, "conventions", "term-missing", against(TWO)),
    Planted("azimuth turned", lambda wi, wo: ggx(wi, wo * np.array([-1, -1, 1])), "conventions", "azimuth-turned", against(GGX)),
    Planted("sRGB colours", lambda wi, wo: lambert(wi, wo) * (1.055 * COLOUR ** (1 / 2.4) - 0.055) / COLOUR, "conventions", "srgb-encoded", against("lambert(K_d=(0.6, 0.4, 0.2))")),
    Planted("cosine, by a reference", lambda wi, wo: ggx(wi, wo) * np.maximum(wo[:, 2:], 0), "conventions", "cosine-included", against(GGX)),
    Planted("Fresnel forgotten", lambda wi, wo: 0.8 * ggx(wi, wo), "conventions", "fresnel-missing", against("ggx(K_s=0.8, alpha=0.3, fresnel=schlick(f0=0.05))")),
    Planted("degrees", lambda wi, wo: oren_nayar_full(wi, wo, 0.3 * np.pi / 180), "conventions", "radians-taken-for-degrees", against("oren_nayar(K_d=0.5, sigma_d=0.3)")),
)  # fmt: skip


def oren_nayar_full(wi: Floats, wo: Floats, sigma: float) -> Floats:
    """So smooth that the model of 1994 is Lambert's."""
    assert sigma < 0.01
    return above(wi, wo, np.full(len(wi), 0.5 / np.pi))
