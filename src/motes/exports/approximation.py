"""The nearest standard lobes of a model, for programs that take lobes and not formulas: closures, MaterialX nodes, stock BSDFs.

How the parameters are converted, and what is lost:

==================  ==========================================================================================================
model               standard lobe
==================  ==========================================================================================================
`Lambert`           diffuse, albedo K_d
`OrenNayar`         Oren-Nayar diffuse, albedo K_d, roughness sigma_d in radians: these are (1)-(5) without C3, without the side
                    cos(phi_r - phi_i) < 0 and without the inter-reflection (7)
`TorranceSparrow`   GGX of alpha = sigma_s, reflectance K_s A F: GGX has D(0) = 1/(pi alpha^2), so with A = pi sigma_s^2 (1 where
                    D is normalised) the height at the mirror direction and the energy stay; the tails become longer, and the
                    shadowing is Smith's instead of (11).  F follows Schlick's curve from its value at normal incidence.
`Dust`              diffuse, with the dust's spherical albedo: w times 2 (1 - ln 2)/3 where g = 0; darkening towards the normal and
                    the phase function are lost
`DustLayer`         T = exp(-2 d tau), with d = 1.66 the mean of 1/cos over diffuse light (Elsasser 1942); the darkening
                    towards grazing is lost, or holds for the viewer alone
==================  ==========================================================================================================
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from motes.models import BRDF, Conductor, Dielectric, Dust, DustLayer, Lambert, OrenNayar, Schlick, Sum, TorranceSparrow
from motes.parameters import Slot

DIFFUSIVITY = 1.66


@dataclass(frozen=True)
class Lobe:
    """A standard lobe.

    Attributes
    ----------
    specular
        True for GGX, False for diffuse.
    color
        Slot of the reflectance: ``K_d``, ``w``, ``K_s``.
    width
        Slot of the roughness; None for a smooth one.
    scale
        A number that multiplies the reflectance.
    area
        True where pi width^2 multiplies it, too.
    fresnel
        The kind of Fresnel term, ``""`` for none, with its slots.
    layers
        Dust layers from the outside to the lobe: the slot of tau, and True where the lobe is the dust of that layer itself.
    """

    specular: bool
    color: str
    width: str | None = None
    scale: float = 1.0
    area: bool = False
    fresnel: tuple[str, ...] = ("",)
    layers: tuple[tuple[str, bool], ...] = ()


_FRESNEL: dict[Any, str] = {Dielectric: "dielectric", Conductor: "conductor", Schlick: "schlick"}
LOST: dict[Any, str] = {
    Lambert: "",
    OrenNayar: "Oren-Nayar: roughness is sigma_d in radians; C3, the side cos(phi_r - phi_i) < 0 of (1) and the inter-reflection (7) are left out.",
    TorranceSparrow: "Torrance-Sparrow: GGX of alpha = sigma_s whose height and energy agree (K_s pi sigma_s^2, or K_s where D is "
    "normalised); its tails are longer, and the shadowing is Smith's.",
    Dust: "Dust: a diffuse lobe with the dust's spherical albedo for the g of this file; its phase function is left out.",
    DustLayer: "Dust layer: a mean transmittance exp(-3.32 tau) instead of exp(-tau (1/cos_i + 1/cos_r)).",
}


def lobes(model: BRDF) -> list[Lobe]:
    """The standard lobes whose sum is nearest to `model`."""
    slots = {slot.path: slot for slot in model.slots()}
    return _lobes(model, (), slots)


def _lobes(model: Any, path: tuple[str, ...], slots: dict[tuple[str, ...], Slot]) -> list[Lobe]:
    def slot(*names: str) -> str:
        return slots[(*path, *names)].name

    if isinstance(model, Sum):
        return _lobes(model.a, (*path, "a"), slots) + _lobes(model.b, (*path, "b"), slots)
    if isinstance(model, DustLayer):
        inner = [(lobe, False) for lobe in _lobes(model.base, (*path, "base"), slots)]
        inner += [(lobe, True) for lobe in _lobes(model.dust, (*path, "dust"), slots)]
        return [replace(lobe, layers=((slot("tau"), dust), *lobe.layers)) for lobe, dust in inner]
    if isinstance(model, Lambert):
        return [Lobe(False, slot("K_d"))]
    if isinstance(model, OrenNayar):
        return [Lobe(False, slot("K_d"), slot("sigma_d"))]
    if isinstance(model, Dust):
        unit = Dust(w=1.0, g=float(np.ravel(model.g)[0]), form=model.form)
        return [Lobe(False, slot("w"), scale=float(unit.spherical_albedo()[0]))]
    if isinstance(model, TorranceSparrow):
        term = model.fresnel
        kind = "" if term is None else _FRESNEL[type(term)]
        own = tuple(slot("fresnel", p.name) for p in term.declared()) if term is not None else ()
        return [Lobe(True, slot("K_s"), slot("sigma_s"), area=model.normalization == "printed", fresnel=(kind, *own))]
    raise TypeError(f"no standard lobe for {type(model).__name__}")


def losses(model: BRDF) -> list[str]:
    """What the lobes do not say, a sentence a kind of model."""
    found: dict[str, None] = {}

    def visit(part: Any) -> None:
        if LOST.get(type(part)):
            found[LOST[type(part)]] = None
        for child in part.children().values():
            visit(child)

    visit(model)
    return list(found)


def reflectance(model: BRDF, lobe: Lobe) -> tuple[np.ndarray, np.ndarray]:
    """The lobe's reflectance at normal and at grazing incidence as numbers, per channel."""
    values = {slot.name: np.asarray(slot.value, float) for slot in model.slots()}
    color = np.broadcast_to(values[lobe.color] * lobe.scale, (model.channels,)).copy()
    if lobe.area and lobe.width:
        color *= np.pi * float(np.ravel(values[lobe.width])[0]) ** 2
    for tau, dust in lobe.layers:
        through = np.exp(-2 * DIFFUSIVITY * float(np.ravel(values[tau])[0]))
        color *= 1 - through if dust else through
    kind, *own = lobe.fresnel
    if not kind:
        return color, color
    if kind == "schlick":
        return color * values[own[0]], color
    n, k = values[own[0]], values[own[1]] if kind == "conductor" else 0.0
    return color * (((n - 1) ** 2 + k**2) / ((n + 1) ** 2 + k**2)), color


def written(lobe: Lobe, color: str, pi: str) -> tuple[str, str]:
    """The lobe's reflectance, and its share of that at normal incidence, in the words of C-like shading languages.

    Parameters
    ----------
    color
        The type of a colour, which also converts a number to one.
    pi
        The name of pi.

    Notes
    -----
    `through` declares what it uses of dust layers.
    """
    factors = [f"(1.0 - through_{tau})" if dust else f"through_{tau}" for tau, dust in lobe.layers]
    factors += [repr(lobe.scale)] if lobe.scale != 1 else []
    factors += [f"{pi} * {lobe.width} * {lobe.width}"] if lobe.area else []
    kind, *own = lobe.fresnel
    n, k = (*own, "", "")[:2]
    if kind == "dielectric":
        f0 = f"(({n} - 1.0) * ({n} - 1.0) / (({n} + 1.0) * ({n} + 1.0)))"
    elif kind == "conductor":
        f0 = f"((({n} - 1.0) * ({n} - 1.0) + {k} * {k}) / (({n} + 1.0) * ({n} + 1.0) + {k} * {k}))"
    else:
        f0 = n or "1.0"
    return f"{color}({' * '.join([*factors, lobe.color])})", f"{color}({f0})"


def through(found: list[Lobe]) -> list[str]:
    """Statements that declare the transmittances of the dust layers, from ``wo``."""
    taus = dict.fromkeys(tau for lobe in found for tau, _ in lobe.layers)
    if not taus:
        return []
    return [
        f"// Dust: exact along the view; along the light the mean of 1/cos is {DIFFUSIVITY}.",
        "float cosine = max(wo[2], 0.01);",
        *(f"float through_{tau} = exp(-{tau} * (1.0 / cosine + {DIFFUSIVITY!r}));" for tau in taus),
    ]
