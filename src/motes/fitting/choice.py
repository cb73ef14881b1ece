"""Choosing a model: the candidates, the criterion, and the comparison, for one measurement, for scans and for maps."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any, Protocol, TypeVar

import numpy as np

from motes.errors import DataError, MotesError
from motes.fitting.result import Trial
from motes.models import parse

#: What ``model="auto"`` compares.
CANDIDATES = (
    "lambert",
    "oren_nayar",
    "lambert + torrance_sparrow",
    "oren_nayar + torrance_sparrow",
    "dust_layer(oren_nayar + torrance_sparrow)",
)
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


class Attempt(Protocol):
    """A candidate, fitted."""

    @property
    def bic(self) -> float: ...

    def trial(self) -> Trial: ...


A = TypeVar("A", bound=Attempt)


def best_of(candidates: Iterable[Any], attempt: Callable[[Any], A]) -> tuple[A, tuple[Trial, ...]]:
    """The attempt with the smallest BIC, and all trials; candidates with too many parameters for the data are passed over.

    Raises
    ------
    DataError
        Of the first candidate, when the data suffice for none.
    """
    best: A | None = None
    trials: list[Trial] = []
    too_few: DataError | None = None
    for candidate in candidates:
        try:
            found = attempt(candidate)
        except DataError as error:
            too_few = too_few or error
            continue
        trials.append(found.trial())
        if best is None or found.bic < best.bic:
            best = found  # the others are let go: their arrays are as large as the data
    if best is None:
        assert too_few is not None
        raise too_few
    return best, tuple(replace(trial, chosen=trial.bic == best.bic) for trial in trials)


def summed(by_part: Sequence[Sequence[Trial]]) -> tuple[Trial, ...]:
    """Trials of several parts of the data as trials of all, for the models that every part could try; the best is marked."""
    by_model: dict[str, list[Trial]] = {}
    for trials in by_part:
        for trial in trials:
            by_model.setdefault(trial.model, []).append(trial)
    complete = {name: trials for name, trials in by_model.items() if len(trials) == len(by_part)}
    total = {name: sum(t.bic for t in trials) for name, trials in complete.items()}
    best = min(total, key=lambda name: total[name])
    return tuple(
        replace(
            trials[0],
            bic=total[name],
            objective=sum(t.objective for t in trials),
            relative_rms=float(np.mean([t.relative_rms for t in trials])),
            n_samples=sum(t.n_samples for t in trials),
            chosen=name == best,
        )
        for name, trials in complete.items()
    )


def check_names(names: Collection[str] | Mapping[str, Any]) -> None:
    """That each is a parameter of one of the candidates at least.

    Raises
    ------
    MotesError
        Which is not.
    """
    known = {slot.name: None for text in CANDIDATES for slot in parse(text).model.slots()}
    for name in names:
        if name not in known:
            raise MotesError(f"no model that auto tries has a parameter {name!r}", f"They have {', '.join(known)}")
