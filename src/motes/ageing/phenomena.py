"""Phenomena: what drying, dust and rust do to the parameters of a surface.

A phenomenon names the parameters that move, says how and why, and turns any material into one that follows time::

    dusty = PHENOMENA["dust"](material, hours=(0, 240), tau_end=0.8)

Which parameters move, and along what kind of curve, is what "Time-Varying BRDFs" (TVCG 2007) found in its measurements of drying paint, of drying
surfaces such as wet plaster or wood, and of dust.  The *numbers* of the defaults are chosen, within what is physically plausible, and can all be replaced;
those of rusting are measured.  To carry a fitted course over to another material see `motes.ageing.transfer`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple, final

import numpy as np

from motes.ageing.carrying import Interval, carried, is_map, named, stretched
from motes.ageing.rust import MEAN_K_D, MEAN_R, MEAN_SPECULAR, MEAN_TIMES, highlight_strength
from motes.errors import ParameterError
from motes.material import Material
from motes.models import BRDF, Dust, DustLayer, Lambert, OrenNayar, TorranceSparrow
from motes.trends import AnyTrend, Tabulated, Trend


@final
@dataclass(frozen=True)
class Option:
    """A number of a phenomenon that can be replaced.

    Parameters
    ----------
    default
        None where it follows from the length of time.
    bounds
        Smallest and largest value, both included.
    doc
        Meaning and unit, and where the default comes from.
    per_channel
        True where a value for each channel is accepted.
    """

    default: float | None
    bounds: tuple[float, float]
    doc: str
    per_channel: bool = False

    def checked(self, owner: str, name: str, value: Any) -> Any:
        """`value` as a float or an array (C,), within bounds."""
        try:
            array = np.asarray(value, float)
        except (TypeError, ValueError):
            raise ParameterError(f"{owner}: {name} = {str(value)[:80]!r} is not a number", self.doc) from None
        low, high = self.bounds
        if array.ndim > (1 if self.per_channel else 0) or not array.size:
            raise ParameterError(
                f"{owner}: {name} has the shape {array.shape}",
                "Give one number" + (" or one for each channel" if self.per_channel else ""),
            )
        bad = ~(np.isfinite(array) & (array >= low) & (array <= high))
        if bad.any():
            raise ParameterError(
                f"{owner}: {name} = {array[bad].flat[0]:g} is outside [{low:g}, {high:g}]: {self.doc}",
                f"Choose a value in [{low:g}, {high:g}]",
            )
        return float(array) if array.ndim == 0 else array


class Task(NamedTuple):
    """What a phenomenon works on: the BRDF at the moment `given`, the times, and the options."""

    brdf: BRDF
    interval: Interval
    given: str
    options: Mapping[str, Any]


class Aged(NamedTuple):
    """What a phenomenon makes: the BRDF (perhaps with a part added), the trends of its slots, and what was done."""

    brdf: BRDF
    trends: dict[str, AnyTrend]
    notes: list[str]


@final
@dataclass(frozen=True)
class Phenomenon:
    """A way in which reflectance changes with time.

    Parameters
    ----------
    name
        As at the command line.
    doc
        What happens, and why the parameters move as they do.
    moves
        Parameter -> how it moves; these are what a transfer carries over.
    options
        The numbers that can be replaced.
    given
        The moment at which a material is taken to be what it is, unless said otherwise: ``"start"`` or ``"end"``.
    rules
        Parameter -> how a transfer relates target and source; see `motes.ageing.transfer`.
    build
        The rule itself.
    base
        A surface to show it on; a choice.
    """

    name: str
    doc: str
    moves: Mapping[str, str]
    options: Mapping[str, Option]
    given: str
    rules: Mapping[str, str]
    build: Callable[[Task], Aged] = field(repr=False)
    base: Material = field(repr=False)

    def __call__(
        self, surface: Material | BRDF, *, hours: float | tuple[float, float], given: str | None = None, **options: Any
    ) -> Material:
        """A material that follows time.

        Parameters
        ----------
        surface
            Any material or BRDF.  Trends that it has already stay, but for the parameters that the phenomenon moves.
        hours
            The first and the last time [h]; one number is the last, the first then 0.
        given
            ``"start"`` when `surface` is what it is before, ``"end"`` when it is what comes out.
        options
            By the names of `options`.

        Raises
        ------
        ParameterError
            For an option that is not there or out of range, times that do not go forward, or parameters that vary over the surface.
        """
        given = self.moment(given)
        interval = interval_of(hours)
        unknown = [name for name in options if name not in self.options]
        if unknown:
            raise ParameterError(
                f"{self.name} has no option {unknown[0]!r}", f"It has {', '.join(self.options) or 'none'}"
            )
        values = {
            name: option.checked(self.name, name, options[name]) if options.get(name) is not None else option.default
            for name, option in self.options.items()
        }
        target = as_material(surface)
        brdf = anchored(target, interval, given, self.moves)
        aged = self.build(Task(brdf, interval, given, values))
        chosen = {name: np.asarray(v).tolist() for name, v in values.items() if v is not None}
        return finished(target, aged, interval, {"phenomenon": self.name, "given": given, "options": chosen})

    def moment(self, given: str | None) -> str:
        """`given`, or the phenomenon's own; raises `ParameterError` for another word."""
        given = given or self.given
        if given not in ("start", "end"):
            raise ParameterError(
                f"{self.name}: given = {given!r} is not start or end", "It says when the material is what it is now"
            )
        return given

    def example(self, hours: float | tuple[float, float] = 12.0) -> Material:
        """The phenomenon on its own `base`: for simulations and pictures."""
        return self(self.base, hours=hours)


# ------------------------------------------------------------ shared by phenomena and transfer


def interval_of(hours: float | tuple[float, float]) -> Interval:
    """(first, last) [h]; raises `ParameterError` when they do not go forward."""
    times = np.asarray(hours, float)
    if times.shape not in ((), (2,)):
        raise ParameterError(f"hours has the shape {times.shape}", "Give the last time, or the first and the last")
    first, last = (0.0, float(times)) if times.ndim == 0 else (float(times[0]), float(times[1]))
    if not (np.isfinite([first, last]).all() and last > first):
        raise ParameterError(
            f"the times {first:g} to {last:g} h do not go forward",
            "Give the last time, or the first and a later one, in hours",
        )
    return first, last


def as_material(surface: Material | BRDF) -> Material:
    """A material with names for as many channels as its BRDF has."""
    if isinstance(surface, BRDF):
        surface = Material(surface, name="surface", channels=())
    elif not isinstance(surface, Material):
        raise ParameterError(f"{type(surface).__name__} is not a material", "Give a Material or a BRDF")
    n = surface.brdf.channels
    if len(surface.channels) == n or (n == 1 and surface.channels):
        return surface
    names = {1: ("grey",), 3: ("R", "G", "B")}.get(n) or tuple(str(k + 1) for k in range(n))
    return Material(surface.brdf, surface.name, names, (), surface.trends, surface.about)


def anchored(target: Material, interval: Interval, given: str, moves: Mapping[str, str]) -> BRDF:
    """The BRDF of the target at the moment at which it is given; raises for parameters that vary over the surface."""
    brdf = target.at(interval[0 if given == "start" else 1])
    for slot in brdf.slots():
        if slot.parameter.name in moves and is_map(slot):
            raise ParameterError(
                f"{slot.name} of {target.name} has the shape {np.shape(slot.value)}: it varies over the surface",
                "Age one place at a time: give parameters with no axis but the channels",
            )
    return brdf


def finished(target: Material, aged: Aged, interval: Interval, step: Mapping[str, Any]) -> Material:
    """The material, with the values of the first moment, and in ``about["ageing"]`` one entry more."""
    notes = list(aged.notes)
    kept = {}
    for name, trend in target.trends.items():
        if name in aged.trends:
            notes.append(f"{name} had a trend of its own, which is replaced")
        else:
            kept[name] = trend
    trends = {**kept, **aged.trends}
    bounds = {slot.name: slot.parameter for slot in aged.brdf.slots()}
    first = Material(aged.brdf, trends=trends).at(interval[0])
    slots = {slot.name: slot for slot in first.slots()}
    brdf = aged.brdf.with_parameters({name: slots[name].value for name in trends})
    material = Material(brdf, f"{target.name}, {step['phenomenon']}", target.channels, target.wavelengths, trends)
    notes += _energy(material, aged.brdf, interval)
    entry = {**step, "hours": list(interval), "moved": [name for name in bounds if name in aged.trends], "notes": notes}
    about = {**target.about, "ageing": [*target.about.get("ageing", []), entry]}
    return Material(brdf, material.name, target.channels, target.wavelengths, trends, about)


def _energy(material: Material, given: BRDF, interval: Interval) -> list[str]:
    """A note where the aged surface reflects more than it receives while the given one does not."""
    wi = np.array([[0.0, 0.0, 1.0], [np.sin(1.0), 0.0, np.cos(1.0)]])
    if any(is_map(slot) for slot in given.slots()) or given.directional_albedo(wi, nodes=(16, 16)).max() > 1:
        return []
    most = max(float(material.at(t).directional_albedo(wi, nodes=(16, 16)).max()) for t in interval)
    return [f"reflects up to {100 * most:.0f} % of the light: more than it receives"] if most > 1.01 else []


def with_highlight(brdf: BRDF, lobe: TorranceSparrow) -> tuple[BRDF, bool]:
    """The BRDF, with `lobe` added under any dust when it has no highlight of its own; and whether it was added."""
    if named(brdf, "K_s"):
        return brdf, False
    if isinstance(brdf, DustLayer):
        return DustLayer(brdf.base + lobe, brdf.dust, brdf.tau), True
    return brdf + lobe, True


# ------------------------------------------------------------ drying


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
_FILM_SIGMA_S = 0.15  # rad; chosen


def _drying_paint(task: Task) -> Aged:
    o, (first, last) = task.options, task.interval
    constant = o["time_constant"] or (last - first) / 4
    brdf, added = with_highlight(task.brdf, TorranceSparrow(K_s=0.0, sigma_s=_FILM_SIGMA_S))
    trends: dict[str, AnyTrend] = {}
    for slot in named(brdf, "K_d"):
        wet, dry = wet_and_dry(slot.value, task.given, o["internal_reflection"])
        trends[slot.name] = _exponential(wet, dry, constant, task.interval, slot.parameter.bounds)
    for slot in named(brdf, "sigma_s"):
        ratio = 1 / o["sigma_s_growth"]
        wet, dry = _wet_dry_by_ratio(slot.value, "end" if added else task.given, ratio, slot.parameter.bounds)
        trends[slot.name] = _exponential(wet, dry, constant, task.interval, slot.parameter.bounds)
    for slot in named(brdf, "K_s"):
        wet, dry = (
            (_FILM_K_S, 0.0)
            if added
            else _wet_dry_by_ratio(slot.value, task.given, 1 / o["K_s_left"], slot.parameter.bounds)
        )
        trends[slot.name] = _exponential(wet, dry, constant, task.interval, slot.parameter.bounds)
    notes = (
        ["the matte surface was given the highlight of the wet film, K_s = 0.3 at first and 0 when dry"]
        if added
        else []
    )
    return Aged(brdf, trends, notes)


def _drying_surface(task: Task) -> Aged:
    o, (first, last) = task.options, task.interval
    middle = first + (last - first) * 0.4 if o["middle"] is None else o["middle"]
    width = o["width"] or (last - first) / 12
    constant = o["film_time_constant"] or (last - first) / 8
    brdf, added = with_highlight(task.brdf, TorranceSparrow(K_s=0.0, sigma_s=_FILM_SIGMA_S))
    trends: dict[str, AnyTrend] = {}
    for slot in named(brdf, "K_d"):
        wet, dry = wet_and_dry(slot.value, task.given, o["internal_reflection"])
        c = {"start": wet, "end": dry, "middle": middle, "width": width}
        trends[slot.name] = Trend("logistic", c, task.interval, slot.parameter.bounds)
    for slot in named(brdf, "K_s"):
        dry = 0.0 if added else slot.value
        wet = dry + o["film_K_s"]
        if task.given == "start" and not added:  # what shines is the film, as far as there is so much
            wet, dry = slot.value, np.maximum(slot.value - o["film_K_s"], 0.0)
        trends[slot.name] = _exponential(wet, dry, constant, task.interval, slot.parameter.bounds)
    notes = (
        [f"the matte surface was given the highlight of the wet film, K_s = {o['film_K_s']:g} at first and 0 when dry"]
        if added
        else []
    )
    return Aged(brdf, trends, notes)


# ------------------------------------------------------------ dust and rust


def dusted(brdf: BRDF, w: Any = None, g: Any = None) -> tuple[DustLayer, bool]:
    """The BRDF under a layer of dust with tau = 0, unless it has one on top; and whether it was added."""
    if isinstance(brdf, DustLayer):
        dust = Dust(w=brdf.dust.w if w is None else w, g=brdf.dust.g if g is None else g)
        return DustLayer(brdf.base, dust, brdf.tau), False
    if w is None:
        w = DUST_RGB if brdf.channels == 3 else DUST_GREY
    elif np.ndim(w) and brdf.channels not in (1, len(w)):
        raise ParameterError(
            f"w has {len(w)} channels and the surface {brdf.channels}",
            "Give one number, or one for each channel of the surface",
        )
    return DustLayer(brdf, Dust(w=w, g=0.0 if g is None else g), tau=0.0), True


def tau_slot(brdf: DustLayer) -> str:
    """The name of the optical thickness of the layer on top."""
    return next(slot.name for slot in brdf.slots() if slot.path == ("tau",))


DUST_RGB = (0.78, 0.70, 0.58)  # a light sandy brown; chosen
DUST_GREY = 0.7  # chosen


def _dust(task: Task) -> Aged:
    o = task.options
    layer, added = dusted(task.brdf, o["w"], o["g"])
    growth = o["tau_growth"]
    start = float(layer.tau) if task.given == "start" else max(float(layer.tau) - growth, 0.0)
    slot = tau_slot(layer)
    trends: dict[str, AnyTrend] = {
        slot: Trend("linear", {"start": start, "end": start + growth}, task.interval, (0.0, np.inf))
    }
    done = "a layer of dust was laid over the surface" if added else "the layer of dust that was there grows"
    return Aged(
        layer,
        trends,
        [f"{done}; the base does not change, and its highlight fades by exp(-tau (1/cos_theta_i + 1/cos_theta_r))"],
    )


def _rusting(task: Task) -> Aged:
    share, notes = task.options["extent"], []
    observed = (0.0, 1.0)
    reference = 0 if task.given == "start" else -1
    sources: dict[str, np.ndarray] = {
        "sigma_s": MEAN_R,
        "K_s": highlight_strength(MEAN_SPECULAR, MEAN_R),
        "K_d": MEAN_K_D,
    }
    brdf = task.brdf
    if brdf.channels != 3 and any(np.ndim(s.value) for s in named(brdf, "K_d")):
        notes.append("the colours of the rust were averaged: the surface does not have the channels R, G, B")
    trends: dict[str, AnyTrend] = {}
    for name, values in sources.items():
        values = values[reference] + share * (values - values[reference])
        for slot in named(brdf, name):
            course = values
            if values.ndim == 2 and (brdf.channels != 3 or (np.ndim(slot.value) and len(slot.value) != 3)):
                course = values.mean(-1)
            own = slot.value
            if course.ndim == 1 and np.ndim(own):
                course = np.repeat(course[:, None], len(own), axis=1)
            trend = stretched(Tabulated(MEAN_TIMES, course), task.interval, observed)
            trends[slot.name], rule = carried(trend, course[reference], own, RUST_RULES[name], slot.parameter.bounds)
            notes.append(f"{slot.name} by {rule}")
    missing = [name for name in sources if not named(brdf, name)]
    if missing:
        notes.append(f"the surface has no {', '.join(missing)}: nothing moved there")
    if not trends:
        raise ParameterError("rusting: the surface has neither K_d nor K_s", "Give it a diffuse part or a highlight")
    return Aged(brdf, trends, notes)


RUST_RULES = {"K_d": "difference", "K_s": "ratio", "sigma_s": "difference"}
_DRYING_RULES = {"K_d": "ratio", "K_s": "ratio", "sigma_s": "ratio"}
_PAINT = Material(
    OrenNayar(K_d=(0.62, 0.18, 0.12), sigma_d=0.25) + TorranceSparrow(K_s=0.12, sigma_s=0.28),
    "red paint",
    ("R", "G", "B"),
)
_CLAY = Material(
    OrenNayar(K_d=(0.74, 0.69, 0.61), sigma_d=0.35) + TorranceSparrow(K_s=0.02, sigma_s=0.18), "clay", ("R", "G", "B")
)
_VARNISH = Material(
    OrenNayar(K_d=(0.10, 0.16, 0.34), sigma_d=0.2) + TorranceSparrow(K_s=0.8, sigma_s=0.12),
    "varnished board",
    ("R", "G", "B"),
)
_IRON = Material(
    Lambert(K_d=tuple(MEAN_K_D[0]))
    + TorranceSparrow(K_s=float(highlight_strength(MEAN_SPECULAR, MEAN_R)[0]), sigma_s=float(MEAN_R[0])),
    "cast iron",
    ("R", "G", "B"),
)

PHENOMENA: dict[str, Phenomenon] = {
    p.name: p
    for p in (
        Phenomenon(
            "drying_paint",
            "A coat of paint dries.  While it is wet its surface is level and its pigment lies in liquid: a tall, narrow highlight over a dark, saturated "
            "colour.  As the solvent leaves, the surface follows the pigment grains, so that the highlight falls and spreads, and light leaves the pigment "
            "more easily, so that the colour gets lighter.  'Time-Varying BRDFs', on drying paint: K_s decays exponentially while sigma_s grows, and the "
            "diffuse colour moves along a line between the wet and the dry one.",
            {
                "K_s": "decays exponentially from wet to dry: the surface loses its level film",
                "sigma_s": "grows with the same time constant: facets follow the pigment grains",
                "K_d": "moves with the same time constant along the straight line from the wet to the dry colour",
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
            _DRYING_RULES,
            _drying_paint,
            _PAINT,
        ),
        Phenomenon(
            "drying_surface",
            "A porous surface (plaster, wood, cloth, stone) dries.  At first water fills the pores and stands on the surface: dark and shiny.  The film goes "
            "first, and with it the highlight; the colour stays dark until the front of the water passes through the layer that light sees, then climbs to "
            "its dry value and stays.  'Time-Varying BRDFs', on drying surfaces: K_d goes from wet to dry along an S-shaped curve, the highlight fades, and "
            "sigma_d, which the solid surface determines, stays.",
            {
                "K_d": "goes from wet to dry along a logistic curve, the same in all channels: a straight line in colour space",
                "K_s": "decays exponentially to that of the dry surface: the film of water goes first",
            },
            {
                "middle": Option(
                    None, (-1e9, 1e9), "time [h] of half the way of K_d; 40 % of the given time by default"
                ),
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
            _DRYING_RULES,
            _drying_surface,
            _CLAY,
        ),
        Phenomenon(
            "dust",
            "Dust settles at a steady rate.  The surface below does not change: what changes is what is seen of it.  Light crosses the layer on its way in and "
            "out, so the base, highlight and all, is seen through exp(-tau (1/cos_theta_i + 1/cos_theta_r)), and the dust adds its own single scattering.  "
            "'Time-Varying BRDFs', on dust: the highlight falls off and the diffuse part moves towards the dust's colour; both follow here from one trend, "
            "that of tau, and are not prescribed.",
            {"tau": "grows in proportion to time", "w": "stays: the dust's own", "g": "stays: the dust's own"},
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
            },
            "start",
            {"tau": "absolute", "w": "absolute", "g": "absolute"},
            _dust,
            _VARNISH,
        ),
        Phenomenon(
            "rusting",
            "Iron rusts.  Oxide grows in grains on the polished metal: facets tilt (sigma_s grows), less metal is left to mirror light (K_s falls), and the "
            "diffuse colour turns orange, then dark.  The courses are the means over the STAF maps of rusting cast iron (tvBTF45; Gu et al., 'Time-varying "
            "Surface Appearance', 2006) at six times; another surface gets their differences (K_d, sigma_s) and ratios (K_s).",
            {
                "sigma_s": "grows: tabulated, measured",
                "K_s": "falls: tabulated, measured",
                "K_d": "brightens towards orange and darkens again: tabulated, measured",
            },
            {"extent": Option(1.0, (0, 1), "share of the measured change; 1 is all of it")},
            "start",
            RUST_RULES,
            _rusting,
            _IRON,
        ),
    )
}


def phenomenon(name: str | Phenomenon) -> Phenomenon:
    """The phenomenon of a name; raises `ParameterError` with the names there are."""
    if isinstance(name, Phenomenon):
        return name
    if name not in PHENOMENA:
        raise ParameterError(f"{str(name)[:80]!r} is not a phenomenon", f"Choose one of {', '.join(PHENOMENA)}")
    return PHENOMENA[name]
