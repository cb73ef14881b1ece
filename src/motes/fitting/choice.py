"""Choosing a model: the ladder of candidates, for measurements and for maps; and the BIC, by which maps compare."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from motes.errors import MotesError
from motes.fitting.result import Trial
from motes.models import parse
from motes.models.expressions import Parsed


class Candidate(NamedTuple):
    """A rung of the ladder that ``model="auto"`` climbs.

    `few` where the few samples of a texel can tell it from the others, `slow` where it takes ten times as long as these.
    """

    text: str
    few: bool = False
    slow: bool = False


#: What ``model="auto"`` compares, the simplest first: diffuse, a highlight, its Fresnel term, facets with tails, a coat, a rise
#: towards grazing, and layers of dust, as printed and with all orders of scattering.
LADDER = (
    Candidate("lambert", few=True),
    Candidate("oren_nayar", few=True),
    Candidate("lambert + torrance_sparrow", few=True),
    Candidate("oren_nayar + torrance_sparrow", few=True),
    Candidate("oren_nayar + torrance_sparrow(fresnel=schlick)"),
    Candidate("eon + ggx(fresnel=schlick)"),
    Candidate("eon + gtr(fresnel=schlick)"),
    Candidate("coated_diffuse + ggx(fresnel=schlick)"),
    Candidate("coated_diffuse + gtr(fresnel=schlick)"),
    Candidate("coated_diffuse + hapke(B_0=0, h=0.1) + ggx(fresnel=schlick)"),
    Candidate("dust_layer(oren_nayar + torrance_sparrow)", few=True),
    Candidate("dust_layer(coated_diffuse + gtr(fresnel=schlick))"),
    Candidate("dust_layer(oren_nayar + torrance_sparrow, scattering=multiple)", slow=True),
    Candidate("dust_layer(coated_diffuse + gtr(fresnel=schlick), scattering=multiple)", slow=True),
)
CANDIDATES = tuple(candidate.text for candidate in LADDER)
#: Those of them that the texels of a map are fitted with.
TEXEL_CANDIDATES = tuple(candidate.text for candidate in LADDER if candidate.few)
# Residuals below this share of the data are rounding, not noise.
NOISE_FLOOR = 1e-6


def is_auto(model: object) -> bool:
    """Whether the model is to be chosen."""
    return isinstance(model, str) and model.strip() == "auto"


def bic(objective: float, samples: int, parameters: float, brightness: float = 0.0) -> float:
    """The Bayesian information criterion n log(mean square) + P log(n), noise of unknown size.

    Parameters
    ----------
    objective
        Half the weighted sum of squares.
    brightness
        The weighted sum of squares of the data: no mean square counts as below `NOISE_FLOOR` of it, since noise-free data
        leave residuals of rounding, whose size says nothing.
    """
    least = max(NOISE_FLOOR**2 * brightness / samples, 1e-300)
    return samples * math.log(max(2 * objective / samples, least)) + parameters * math.log(samples)


def summed(by_part: Sequence[Sequence[Trial]], chosen: tuple[str, tuple[str, ...]] | None = None) -> tuple[Trial, ...]:
    """Trials of several parts of the data as trials of all, for the models that every part could try.

    What was `chosen`, the model and what it has for each channel, is marked; without it the smallest BIC.
    """
    by_model: dict[tuple[str, tuple[str, ...]], list[Trial]] = {}
    for trials in by_part:
        for trial in trials:
            by_model.setdefault((trial.model, trial.per_channel), []).append(trial)
    complete = {name: trials for name, trials in by_model.items() if len(trials) == len(by_part)}
    total = {name: sum(t.bic for t in trials) for name, trials in complete.items()}
    best = min(total, key=lambda name: total[name]) if chosen is None else chosen
    return tuple(
        replace(
            trials[0],
            bic=total[name],
            objective=sum(t.objective for t in trials),
            relative_rms=float(np.mean([t.relative_rms for t in trials])),
            n_samples=sum(t.n_samples for t in trials),
            left_out=float(np.sqrt(np.mean([t.left_out**2 for t in trials]))),
            chosen=name == best,
        )
        for name, trials in complete.items()
    )


@cache
def _once(text: str) -> Parsed:
    return parse(text)


def parsed(text: str) -> Parsed:
    """As `parse`; once alone for each of the `CANDIDATES`, which are our own and stay what they are."""
    return _once(text) if text in CANDIDATES else parse(text)


def check_names(names: Collection[str] | Mapping[str, Any], candidates: Sequence[str] = CANDIDATES) -> None:
    """That each is a parameter of one of the candidates at least.

    Raises
    ------
    MotesError
        Which is not.
    """
    if not names:
        return
    known = {slot.name: None for text in candidates for slot in parsed(text).model.slots()}
    for name in names:
        if name not in known:
            raise MotesError(f"no model that auto tries has a parameter {name!r}", f"They have {', '.join(known)}")
