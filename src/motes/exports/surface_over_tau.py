"""The surface of another program over the optical thickness of dust: its parameters fitted at some thicknesses, and straight lines between them.

So the dust stays a number of the vertices, or of a texture, and a shader looks up what the surface is there.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.exports.subject import depth_of
from motes.exports.surface_fit import CLEARLY
from motes.fitting.conversion import Conversion, convert
from motes.models import BRDF, Surface

Floats = NDArray[np.float64]

#: Thicknesses that are fitted at first, and at most.
FIRST, MOST = 5, 9
#: A thickness between two others is fitted, too, where the line is so much farther from the material there (cube roots) than they are.
BEND = 0.005
#: The dust's own scale: of a thickness of 1/1.66 diffuse light loses 1 - 1/e.
DIFFUSIVITY = 1.66
Progress = Callable[[int, int, str], None]
S = TypeVar("S", bound=Surface)


@dataclass(frozen=True)
class OverTau:
    """Parameters of a surface over tau.

    Attributes
    ----------
    surface
        One with the parameters that stay as they are.
    tau
        (K,) the thicknesses that were fitted, increasing from 0.
    values
        (K,) or, for colours, (K, 3) of each parameter that the program is told.
    fitted, between
        How far the surface is from the material at these (K,), and halfway between (K - 1,): the relative RMS of cube roots over the hemisphere.
    relative_rms
        The largest relative RMS over the hemisphere, at and between them.
    """

    surface: Surface
    tau: Floats
    values: dict[str, Floats]
    fitted: Floats
    between: Floats
    relative_rms: float

    @property
    def distance(self) -> float:
        """The mean of both distances."""
        return float(np.mean(np.concatenate([self.fitted, self.between])))

    def at(self, tau: ArrayLike) -> dict[str, Floats]:
        """The parameters at thicknesses (N,): (N,), or (N, 3) for colours; those of the last one beyond it."""
        where = np.asarray(tau, np.float64)
        return {
            name: np.interp(where, self.tau, values)
            if values.ndim == 1
            else np.stack([np.interp(where, self.tau, column) for column in values.T], axis=-1)
            for name, values in self.values.items()
        }

    def model(self, tau: float) -> Surface:
        """The surface at one thickness."""
        given = {name: found[0] for name, found in self.at([tau]).items()}
        return self.surface.with_parameters(given)

    def said(self) -> str:
        """Its error, in a sentence."""
        if len(self.tau) == 1:
            return f"Parameters of {self.surface.program} fitted without dust: over the hemisphere {100 * self.relative_rms:.2g} % relative RMS."
        return (
            f"Parameters of {self.surface.program} fitted at {len(self.tau)} thicknesses of the dust up to tau = {self.tau[-1]:.3g}, "
            f"straight lines between: over the hemisphere within {100 * self.relative_rms:.2g} % relative RMS "
            f"({100 * self.fitted.max():.2g} % of cube roots where fitted, {100 * self.between.max():.2g} % halfway)."
        )


def fit_over_tau(
    model: BRDF,
    surface: type[S],
    largest: float,
    *,
    texts: tuple[str, ...] = (),
    made: Callable[[S], S] | None = None,
    clearly: float = CLEARLY,
    progress: Progress | None = None,
) -> OverTau:
    """Fit a surface to a model under dust of any thickness up to the largest.

    Parameters
    ----------
    model
        With a layer of dust on top, of one or three channels.
    surface
        The kind of surface.
    largest
        tau up to which it is used.
    texts
        What of the surface is fitted, the simplest first; its `candidates` when not given.
    made
        What becomes of a fitted surface where a program has less.
    clearly
        A later text is taken where it is nearer than this share of the earlier one's distance.
    progress
        Told the number of fits done, how many there are, and a word.

    Raises
    ------
    ParameterError
        For a model without dust on top.
    DataError
        For other than one or three channels.
    """
    depth = depth_of(model, surface.program)

    def under(tau: float) -> BRDF:
        return model.with_parameters({depth: float(tau)})

    places = [float(tau) for tau in _places(largest)]
    candidates = texts or surface.candidates
    done, total = 0, len(candidates) * len(places)
    known: dict[tuple[str, float], Conversion] = {}

    def fitted(text: str, tau: float) -> Conversion:
        nonlocal done
        if (text, tau) not in known:
            found = convert(under(tau), text, loss="cube_root").brdf
            assert isinstance(found, surface)
            known[text, tau] = Conversion.between(under(tau), made(found) if made else found.canonical())
            done += 1
            if progress is not None:
                progress(done, max(total, done), "fits")
        return known[text, tau]

    def joined(text: str, places: list[float]) -> OverTau:
        """The table of these thicknesses, with how far the lines between them are."""
        over = _joined(surface, places, [fitted(text, tau) for tau in places])
        there = [Conversion.between(under(tau), over.model(tau)) for tau in _middles(places)]
        rms = max([over.relative_rms, *(found.relative_rms for found in there)])
        return replace(over, between=np.array([found.seen for found in there]), relative_rms=rms)

    # One text for all thicknesses, and one whose parameters are near lines: those of different minima lead nowhere between.
    chosen, best = candidates[0], joined(candidates[0], places)
    for text in candidates[1:]:
        other = joined(text, places)
        if other.distance < clearly * best.distance:
            chosen, best = text, other
    while len(places) < MOST:
        excess = best.between - np.maximum(best.fitted[1:], best.fitted[:-1])
        bent = np.flatnonzero(excess > BEND)
        if not bent.size:
            break
        worst = bent[np.argsort(excess[bent])[::-1]][: MOST - len(places)]
        total += len(worst)
        middles = _middles(places)
        places = sorted([*places, *(middles[k] for k in worst)])
        best = joined(chosen, places)
    return best


def _middles(places: list[float]) -> list[float]:
    return [0.5 * (a + b) for a, b in pairwise(places)]


def _places(largest: float) -> Floats:
    """Thicknesses from 0 to the largest, denser where the dust is thin; one that nothing lies at is 0 alone."""
    if largest <= 0:
        return np.zeros(1)
    share = np.linspace(0, 1 - np.exp(-DIFFUSIVITY * min(largest, 4.0)), FIRST)
    found = -np.log1p(-share) / DIFFUSIVITY
    found[-1] = largest
    return np.asarray(found)


def _joined(surface: type[Surface], places: list[float], found: list[Conversion]) -> OverTau:
    """The fits as one table; a parameter that means nothing at a thickness is what it is at the nearest where it does."""
    told = []
    for each in found:
        assert isinstance(each.brdf, Surface)
        told.append(each.brdf.written())
    tau = np.array(places)
    values = {}
    for name in dict.fromkeys(name for each in told for name in each):
        known = [k for k, each in enumerate(told) if name in each]
        nearest = [known[int(np.argmin(np.abs(tau[known] - t)))] for t in tau]
        values[name] = np.array([told[k][name] for k in nearest], np.float64)
    seen = np.array([each.seen for each in found])
    return OverTau(surface(), tau, values, seen, np.zeros(0), max(each.relative_rms for each in found))
