"""What is believed of a material before it is measured: a handful of materials that a plan is to be good for (`Prior`)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import final

import numpy as np
from numpy.typing import NDArray

from motes.errors import DataError, MotesError
from motes.fitting.conversion import convert
from motes.fitting.quantities import Quantity
from motes.fitting.result import Fit
from motes.graph.tracing import structure
from motes.material import Material
from motes.models import BRDF, describe
from motes.planning.information import Subject
from motes.presets import PRESETS, named

Floats = NDArray[np.float64]
#: How many materials stand for a range.
MATERIALS = 16
#: Around one material others are drawn whose parameters differ by this share.
AROUND = 0.25
# A range whose ends differ by this factor is spread by factors, not by steps.
WIDE = 10.0
# Ends of a range are left out by this share: a material without a highlight tells nothing of its width.
MARGIN = 0.08
#: Words that name a prior.
TYPICAL, CATALOGUE = "typical", "catalogue"


@final
@dataclass(frozen=True, eq=False)
class Prior:
    """The materials that a plan is to be good for.

    Parameters
    ----------
    words
        What they are.
    values
        Of the parameters of the model (B, P), in their own units.
    findings
        What was left out, in sentences.
    """

    words: str
    values: Floats
    findings: tuple[str, ...] = ()


def _even(count: int, dimensions: int) -> Floats:
    """Points (count, d) spread over the unit cube: Roberts' sequence, the root of x^(d + 1) = x + 1."""
    root = 2.0
    for _ in range(60):
        root = (1 + root) ** (1 / (dimensions + 1))
    steps = root ** -np.arange(1.0, dimensions + 1)
    return np.asarray((0.5 + np.arange(1, count + 1)[:, None] * steps) % 1.0)


def within(quantity: Quantity, share: Floats) -> Floats:
    """Values at shares of the range that real materials span, in factors where the range is wide."""
    low, high = quantity.parameter.typical
    share = MARGIN + (1 - 2 * MARGIN) * share
    if low > 0 and high / low >= WIDE:
        return np.asarray(np.exp(math.log(low) + share * math.log(high / low)))
    return np.asarray(low + share * (high - low))


def typical(subject: Subject, count: int = MATERIALS) -> Prior:
    """Materials spread over the ranges that the parameters declare as those of real materials."""
    shares = _even(count, subject.size)
    values = np.stack([within(q, shares[:, k]) for k, q in enumerate(subject.quantities)], axis=1)
    return Prior(f"{count} materials spread over what real materials span", subject.inside(values))


def _values(subject: Subject, brdf: BRDF) -> Floats:
    """The parameters of the model (C, P) for each channel of a BRDF, which is converted where it is another model."""
    if structure(brdf) != structure(subject.brdf):
        brdf = convert(brdf, describe(subject.brdf)).brdf
    given = brdf.parameters
    columns = [np.broadcast_to(np.atleast_1d(np.asarray(given[n], float)), brdf.channels) for n in subject.names]
    return np.stack(columns, axis=1)


def of_materials(subject: Subject, materials: Iterable[tuple[str, Material]], lenient: bool = False) -> Prior:
    """Materials that somebody has; each channel is one of them.

    Parameters
    ----------
    lenient
        Whether those that the model cannot stand for are left out; else that is an error.
    """
    found: list[Floats] = []
    names: list[str] = []
    left: list[str] = []
    for name, material in materials:
        try:
            found.append(_values(subject, material.at(0.0)))
            names.append(name)
        except MotesError:
            if not lenient:
                raise
            left.append(name)
    if not found:
        raise DataError("no material is left to plan for", "Name materials that reflect, or leave --prior out")
    values = subject.inside(np.concatenate(found))
    _, first = np.unique(np.round(values / np.maximum(np.abs(values).max(axis=0), 1e-12), 3), axis=0, return_index=True)
    values = values[np.sort(first)]
    words = f"{len(values)} of {len(names)} materials' channels" if len(names) > 1 else names[0]
    if len(values) < 4:  # one point of view, and nobody is that sure of it
        draws = 1 + AROUND * (2 * _even(MATERIALS, subject.size) - 1)
        around = np.concatenate([values, np.repeat(values, -(-MATERIALS // len(values)), axis=0)[:MATERIALS] * draws])
        values, words = subject.inside(around), f"{words}, and {MATERIALS} within {100 * AROUND:.0f} % of it"
    said = (f"The prior leaves out {', '.join(left)}, which the model cannot stand for",) if left else ()
    return Prior(words, values, said)


def of_fit(subject: Subject, fit: Fit, seed: int = 1) -> Prior:
    """What a fit leaves open: materials drawn from its error bars, and over the whole range where it determines nothing."""
    rng = np.random.default_rng(seed)
    channels = fit.measurement.channels
    each = max(2, -(-MATERIALS // len(channels)))
    found = []
    for c in range(len(channels)):
        draws = np.empty((each, subject.size))
        for k, q in enumerate(subject.quantities):
            parameter = fit.parameters[q.name]
            value = float(np.broadcast_to(parameter.value, len(channels))[c])
            error = float(np.broadcast_to(parameter.stderr, len(channels))[c])
            normal = rng.standard_normal(each)
            normal[0] = 0.0  # the fit itself is among them
            draws[:, k] = value + error * normal if math.isfinite(error) else within(q, _even(each, 3)[:, (k + c) % 3])
        found.append(draws)
    values = subject.inside(np.concatenate(found))
    return Prior(f"{len(values)} materials within the error bars of a fit to what is measured", values)


def believed(subject: Subject, prior: object) -> Prior:
    """The prior that a user names: `TYPICAL`, `CATALOGUE` (the presets), materials, or what names them."""
    if isinstance(prior, Prior):
        return prior
    if prior == TYPICAL:
        return typical(subject)
    if prior == CATALOGUE:
        return of_materials(subject, ((name, preset.material()) for name, preset in PRESETS.items()), lenient=True)
    given: Sequence[object] = prior if isinstance(prior, (list, tuple)) else (prior,)
    materials = []
    for one in given:
        if isinstance(one, Material):
            materials.append((one.name, one))
        elif isinstance(one, BRDF):
            materials.append((describe(one), Material(one)))
        elif isinstance(one, str):
            materials.append((one, named(one)))
        else:
            raise DataError(
                f"a {type(one).__name__} is no material to plan for",
                "Give a Material, a BRDF, 'typical', 'catalogue', or the name of a material",
            )
    return of_materials(subject, materials)
