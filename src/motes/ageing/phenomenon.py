"""What a phenomenon is: the parameters that move, by their roles, how and why, and a rule that makes trends of them."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple, final

import numpy as np

from motes import channels
from motes.ageing.carrying import Interval, is_map
from motes.errors import ParameterError
from motes.material import Material
from motes.models import BRDF
from motes.parameters import Role
from motes.trends import AnyTrend


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
        except (TypeError, ValueError, OverflowError):
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


@final
@dataclass(frozen=True)
class Choice:
    """A word of a phenomenon that can be replaced.

    Parameters
    ----------
    default
        None where it follows from the surface.
    words
        Those there are.
    doc
        Meaning, and where the default comes from.
    """

    default: str | None
    words: tuple[str, ...]
    doc: str

    def checked(self, owner: str, name: str, value: Any) -> str:
        """`value`, one of the words."""
        if value not in self.words:
            raise ParameterError(
                f"{owner}: {name} = {str(value)[:80]!r} is not one of {', '.join(self.words)}", f"It is the {self.doc}"
            )
        return str(value)


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
        Role of a parameter -> how it moves; these are what a transfer carries over.
    options
        The numbers and words that can be replaced.
    given
        The moment at which a material is taken to be what it is, unless said otherwise: ``"start"`` or ``"end"``.
    rules
        Role -> how a transfer relates target and source; see `motes.ageing.transfer`.
    build
        The rule itself.
    base
        A surface to show it on; a choice.
    """

    name: str
    doc: str
    moves: Mapping[Role, str]
    options: Mapping[str, Option | Choice]
    given: str
    rules: Mapping[Role, str]
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
    names = channels.default_names(n)
    return Material(surface.brdf, surface.name, names, (), surface.trends, surface.about)


def anchored(target: Material, interval: Interval, given: str, moves: Collection[Role]) -> BRDF:
    """The BRDF of the target at the moment at which it is given; raises for parameters that vary over the surface."""
    brdf = target.at(interval[0 if given == "start" else 1])
    for slot in brdf.slots():
        if slot.parameter.role in moves and is_map(slot):
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
