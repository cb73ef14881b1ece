"""Drying: of a coat of paint, and of a porous surface.

Which parameters move, and along what kind of curve, is what "Time-Varying BRDFs" (TVCG 2007) found in its measurements; the numbers of the
defaults are chosen."""

from __future__ import annotations

from typing import Any

import numpy as np

from motes import channels
from motes.ageing.carrying import Interval
from motes.ageing.highlights import heights, with_highlight
from motes.ageing.phenomenon import Aged, Option, Phenomenon, Task
from motes.material import Material
from motes.models import OrenNayar, TorranceSparrow
from motes.parameters import Role, Slot
from motes.trends import AnyTrend, Trend


def wet_and_dry(K_d: Any, given: str, internal_reflection: float) -> tuple[Any, Any]:
    r"""The diffuse reflectance wet and dry, from the one that is given.

    .. math::  K_{wet} = \frac{(1 - p) K_{dry}}{1 - p K_{dry}}

    The film of liquid sends a share p of the light that leaves the surface back onto it, where it meets the pigment once more (Angstrom 1925; see Lekner and
    Dorf, "Why some things are darker when wet", Applied Optics 27(7), 1988).  So wet colours are darker and more saturated, black stays black and white
    white.  K_d above 1, which measurements of unknown scale have, is left as it is.
    """
    p = internal_reflection
    K = np.asarray(K_d, float)
    inside = np.minimum(K, 1.0)
    other = (1 - p) * inside / (1 - p * inside) if given == "end" else inside / (1 - p + p * inside)
    other = np.where(K > 1, K, other)
    other = float(other) if other.ndim == 0 else other
    return (other, K_d) if given == "end" else (K_d, other)


def _wet_dry_by_ratio(value: Any, given: str, wet_over_dry: float, bounds: Interval) -> tuple[Any, Any]:
    dry, wet = (value, value * wet_over_dry) if given == "end" else (value / wet_over_dry, value)
    return np.clip(wet, *bounds), np.clip(dry, *bounds)


def _exponential(start: Any, end: Any, constant: float, interval: Interval, bounds: Interval) -> Trend:
    return Trend("exponential", {"start": start, "end": end, "time_constant": constant}, interval, bounds)


_INTERNAL = Option(
    0.47,
    (0, 0.95),
    "share of the light leaving the pigment that the liquid's surface sends back; about 0.47 for diffuse light in water (n = 1.33); chosen",
)
_FILM_K_S = 0.3  # height of the highlight that a wet film gives a matte surface; chosen
_FILM = TorranceSparrow(K_s=0.0, sigma_s=0.15)  # where there is no highlight yet; its width in rad, chosen


def _drying_paint(task: Task) -> Aged:
    o, (first, last) = task.options, task.interval
    constant = o["time_constant"] or (last - first) / 4
    brdf, added = with_highlight(task.brdf, _FILM)
    given = "end" if added else task.given
    trends: dict[str, AnyTrend] = {}

    def move(slot: Slot, wet: Any, dry: Any) -> None:
        trends[slot.name] = _exponential(wet, dry, constant, task.interval, slot.parameter.bounds)

    for slot in brdf.slots(Role.DIFFUSE_COLOUR):
        move(slot, *wet_and_dry(slot.value, task.given, o["internal_reflection"]))
    widths: dict[str, tuple[Any, Any]] = {}
    for slot in brdf.slots(Role.HIGHLIGHT_WIDTH):
        widths[slot.name] = _wet_dry_by_ratio(slot.value, given, 1 / o["sigma_s_growth"], slot.parameter.bounds)
        move(slot, *widths[slot.name])
    for slot in brdf.slots(Role.HIGHLIGHT_STRENGTH):
        if added:
            move(slot, _FILM_K_S, 0.0)
            continue
        own = brdf.beside(slot, Role.HIGHLIGHT_WIDTH)
        wet, dry = widths[own.name] if own else (None, None)
        # K_s_left is said of heights.
        ratio = heights(brdf, slot, wet) / heights(brdf, slot, dry)
        move(slot, *_wet_dry_by_ratio(slot.value, task.given, 1 / (o["K_s_left"] * ratio), slot.parameter.bounds))
    notes = ["the matte surface was given the highlight of the wet film, K_s = 0.3 at first and 0 when dry"]
    return Aged(brdf, trends, notes if added else [])


def _drying_surface(task: Task) -> Aged:
    o, (first, last) = task.options, task.interval
    middle = first + (last - first) * 0.4 if o["middle"] is None else o["middle"]
    width = o["width"] or (last - first) / 12
    constant = o["film_time_constant"] or (last - first) / 8
    brdf, added = with_highlight(task.brdf, _FILM)
    trends: dict[str, AnyTrend] = {}
    for slot in brdf.slots(Role.DIFFUSE_COLOUR):
        wet, dry = wet_and_dry(slot.value, task.given, o["internal_reflection"])
        c = {"start": wet, "end": dry, "middle": middle, "width": width}
        trends[slot.name] = Trend("logistic", c, task.interval, slot.parameter.bounds)
    for slot in brdf.slots(Role.HIGHLIGHT_STRENGTH):
        film = o["film_K_s"] / heights(brdf, slot)
        dry = 0.0 if added else slot.value
        wet = dry + film
        if task.given == "start" and not added:  # what shines is the film, as far as there is so much
            wet, dry = slot.value, np.maximum(slot.value - film, 0.0)
        trends[slot.name] = _exponential(wet, dry, constant, task.interval, slot.parameter.bounds)
    notes = [
        f"the matte surface was given the highlight of the wet film, K_s = {o['film_K_s']:g} at first and 0 when dry"
    ]
    return Aged(brdf, trends, notes if added else [])


_RULES = {Role.DIFFUSE_COLOUR: "ratio", Role.HIGHLIGHT_STRENGTH: "ratio", Role.HIGHLIGHT_WIDTH: "ratio"}
_PAINT = Material(
    OrenNayar(K_d=(0.62, 0.18, 0.12), sigma_d=0.25) + TorranceSparrow(K_s=0.12, sigma_s=0.28), "red paint", channels.RGB
)
_CLAY = Material(
    OrenNayar(K_d=(0.74, 0.69, 0.61), sigma_d=0.35) + TorranceSparrow(K_s=0.02, sigma_s=0.18), "clay", channels.RGB
)

DRYING_PAINT = Phenomenon(
    "drying_paint",
    "A coat of paint dries.  While it is wet its surface is level and its pigment lies in liquid: a tall, narrow highlight over a dark, saturated "
    "colour.  As the solvent leaves, the surface follows the pigment grains, so that the highlight falls and spreads, and light leaves the pigment "
    "more easily, so that the colour gets lighter.  'Time-Varying BRDFs', on drying paint: K_s decays exponentially while sigma_s grows, and the "
    "diffuse colour moves along a line between the wet and the dry one.",
    {
        Role.HIGHLIGHT_STRENGTH: "decays exponentially from wet to dry: the surface loses its level film",
        Role.HIGHLIGHT_WIDTH: "grows with the same time constant: facets follow the pigment grains",
        Role.DIFFUSE_COLOUR: "moves with the same time constant along the straight line from the wet to the dry colour",
    },
    {
        "time_constant": Option(
            None,
            (1e-9, 1e9),
            "time [h] in which the rest of the way falls to 37 %; a quarter of the given time by default",
        ),
        "K_s_left": Option(0.3, (0.01, 1), "K_s dry over K_s wet; chosen"),
        "sigma_s_growth": Option(
            1.8,
            (1, 20),
            "sigma_s dry over wet; 1.8 with K_s_left = 0.3 keeps about the energy of the highlight; chosen",
        ),
        "internal_reflection": _INTERNAL,
    },
    "end",
    _RULES,
    _drying_paint,
    _PAINT,
)

DRYING_SURFACE = Phenomenon(
    "drying_surface",
    "A porous surface (plaster, wood, cloth, stone) dries.  At first water fills the pores and stands on the surface: dark and shiny.  The film goes "
    "first, and with it the highlight; the colour stays dark until the front of the water passes through the layer that light sees, then climbs to "
    "its dry value and stays.  'Time-Varying BRDFs', on drying surfaces: K_d goes from wet to dry along an S-shaped curve, the highlight fades, and "
    "sigma_d, which the solid surface determines, stays.",
    {
        Role.DIFFUSE_COLOUR: "goes from wet to dry along a logistic curve, the same in all channels: a straight line in colour space",
        Role.HIGHLIGHT_STRENGTH: "decays exponentially to that of the dry surface: the film of water goes first",
    },
    {
        "middle": Option(None, (-1e9, 1e9), "time [h] of half the way of K_d; 40 % of the given time by default"),
        "width": Option(
            None,
            (1e-9, 1e9),
            "a quarter of the time [h] that K_d takes from 12 % to 88 %; a twelfth of the given time by default",
        ),
        "film_K_s": Option(_FILM_K_S, (0, 100), "K_s that the film of water adds; chosen"),
        "film_time_constant": Option(
            None,
            (1e-9, 1e9),
            "time [h] in which the film's highlight falls to 37 %; an eighth of the given time by default",
        ),
        "internal_reflection": _INTERNAL,
    },
    "end",
    _RULES,
    _drying_surface,
    _CLAY,
)
