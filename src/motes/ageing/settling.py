"""Dust settles: a layer over any surface, whose optical thickness grows."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from motes import channels
from motes.ageing.phenomenon import Aged, Choice, Option, Phenomenon, Task
from motes.errors import ParameterError
from motes.material import Material
from motes.models import BRDF, Dust, DustLayer, Layer, OrenNayar, TorranceSparrow, layer_of
from motes.models.particles import MULTIPLE, SCATTERING
from motes.parameters import Role
from motes.trends import AnyTrend, Trend

DUST_RGB = (0.78, 0.70, 0.58)  # a light sandy brown; chosen
DUST_GREY = 0.7  # chosen
#: The options that are the dust's own, and the parameters that they are.
OWN = {"w": Role.SINGLE_SCATTERING_ALBEDO, "g": Role.ASYMMETRY}


def dusted(brdf: BRDF, w: Any = None, g: Any = None, scattering: str | None = None) -> tuple[Layer, bool]:
    """The BRDF under a layer of dust with tau = 0, unless it has one on top; and whether it was added."""
    layer = layer_of(brdf)
    if layer is not None:
        changed = layer.with_values({OWN[name]: value for name, value in (("w", w), ("g", g)) if value is not None})
        if scattering is not None and "scattering" in changed.options():
            changed = replace(changed, scattering=scattering)  # type: ignore[call-arg]
        return _layer(changed), False
    if w is None:
        w = DUST_RGB if brdf.channels == 3 else DUST_GREY
    elif np.ndim(w) and brdf.channels not in (1, len(w)):
        raise ParameterError(
            f"w has {len(w)} channels and the surface {brdf.channels}",
            "Give one number, or one for each channel of the surface",
        )
    dust = Dust(w=w, g=0.0 if g is None else g)
    return _layer(DustLayer(brdf, dust, tau=0.0, scattering=scattering or MULTIPLE)), True


def _layer(brdf: BRDF) -> Layer:
    layer = layer_of(brdf)
    assert layer is not None
    return layer


def _dust(task: Task) -> Aged:
    o = task.options
    layer, added = dusted(task.brdf, o["w"], o["g"], o["scattering"])
    growth, tau = o["tau_growth"], float(layer.depth.value)
    start = tau if task.given == "start" else max(tau - growth, 0.0)
    trends: dict[str, AnyTrend] = {
        layer.depth.name: Trend("linear", {"start": start, "end": start + growth}, task.interval, (0.0, np.inf))
    }
    done = "a layer of dust was laid over the surface" if added else "the layer of dust that was there grows"
    return Aged(
        layer.whole,
        trends,
        [
            f"{done}; the base does not change, and its highlight fades by exp(-tau (1/cos_theta_i + 1/cos_theta_r))",
            *scattered(layer),
        ],
    )


def scattered(layer: Layer) -> list[str]:
    """What the layer does with light, as files and terminals say it."""
    said = {
        "multiple": "light is scattered in the dust as often as it is (multiple scattering)",
        "single": "light is scattered in the dust once, as Blinn has it, which is too dark but for thin or black dust (docs/dust.md)",
    }
    word = layer.whole.options().get("scattering")
    return [said[word]] if word in said else []


_VARNISH = Material(
    OrenNayar(K_d=(0.10, 0.16, 0.34), sigma_d=0.2) + TorranceSparrow(K_s=0.8, sigma_s=0.12),
    "varnished board",
    channels.RGB,
)

DUST = Phenomenon(
    "dust",
    "Dust settles at a steady rate.  The surface below does not change: what changes is what is seen of it.  Light crosses the layer on its way in and "
    "out, so the base, highlight and all, is seen through exp(-tau (1/cos_theta_i + 1/cos_theta_r)), and the dust adds the light that it scatters.  "
    "'Time-Varying BRDFs', on dust: the highlight falls off and the diffuse part moves towards the dust's colour; both follow here from one trend, "
    "that of tau, and are not prescribed.",
    {
        Role.DEPTH: "grows in proportion to time",
        Role.SINGLE_SCATTERING_ALBEDO: "stays: the dust's own",
        Role.ASYMMETRY: "stays: the dust's own",
    },
    {
        "tau_growth": Option(
            0.5,
            (0, 100),
            "optical thickness gathered over the given time; 0.5 leaves 37 % of a highlight seen from above; chosen",
        ),
        "w": Option(
            None,
            (0, 1),
            "single-scattering albedo of the dust; by default that of the layer there is, else (0.78, 0.70, 0.58), or 0.7; chosen",
            True,
        ),
        "g": Option(
            None,
            (-0.999, 0.999),
            "mean cosine of the deviation angle; by default that of the layer that is there, else 0",
        ),
        "scattering": Choice(
            None,
            SCATTERING,
            "way that light goes in the dust, once as in the source or as often as it does; by default that of the layer there is, else multiple",
        ),
    },
    "start",
    {Role.DEPTH: "absolute", Role.SINGLE_SCATTERING_ALBEDO: "absolute", Role.ASYMMETRY: "absolute"},
    _dust,
    _VARNISH,
)
