"""A model that has a simpler one within it starts from where that one ended, too, so that it never ends farther from the data.

EON + GTR has EON + GGX within it (gamma = 2), a Fresnel term by Schlick its absence (f0 = 1), a layer what lies below it (tau = 0): each
parameter says at which value its model is a simpler one (`Parameter.simpler`).  Nobody keeps a list of which model is within which: what a
fit found of one is put into the terms of another, and where that is nearer to the data than the other's own fit, it is fitted from there.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple, Self

import numpy as np

from motes.fitting.losses import Floats
from motes.fitting.problem import Problem
from motes.fitting.quantities import Quantity
from motes.models import BRDF, parse


class Found(NamedTuple):
    """What a fit found: its quantities and the parameter vector (P,), in the coordinates that it moved in."""

    quantities: Sequence[Quantity]
    x: Floats

    @classmethod
    def of(cls, brdf: BRDF) -> Self:
        """What a fitted model has, whether it was fitted or held."""
        quantities: list[Quantity] = []
        x: list[float] = []
        for slot in brdf.slots():
            value = np.atleast_1d(np.asarray(slot.value, float))
            quantities.append(Quantity(slot.name, slot.parameter, len(value) > 1, slice(len(x), len(x) + len(value))))
            x += quantities[-1].coordinate(value).tolist()
        return cls(quantities, np.array(x))


def simplest_first(models: Iterable[str]) -> list[str]:
    """Models as text by how many parameters they have, in the order given where they have as many."""
    return sorted(models, key=lambda text: len(parse(text).model.slots()))


def carried(problem: Problem, found: Found, simpler: bool = False) -> Floats:
    """A parameter vector (P,) with what another fit found of the parameters of each role.

    The others stand at their defaults, or with `simpler` where the model is a simpler one, as far as it is anywhere.
    """
    x = np.empty(problem.size)
    for q in problem.quantities:
        p = q.parameter
        named = [s for s in found.quantities if s.name == q.name]
        named = named or [s for s in found.quantities if s.parameter.role is p.role and p.role is not None]
        if not named:
            x[q.where] = problem.columns.rest[q.where, 0]
            if simpler and p.simpler is not None:
                x[q.where] = q.coordinate(np.array(p.simpler))
            continue
        value = named[0].value(found.x[named[0].where])
        if len(value) not in (1, q.where.stop - q.where.start):
            value = np.array([value.mean()])
        x[q.where] = q.coordinate(np.clip(value, *p.fit_bounds))
    return x


def nearer(problem: Problem, others: Iterable[Found], objective: float) -> Floats | None:
    """The nearest to the data of what others found, as a parameter vector (P,); None where none is below the `objective`."""
    points = [carried(problem, found, simpler=True) for found in others]
    if not points:
        return None
    apart = np.concatenate([problem.misfits(x[None]) for x in points]) / problem.scale
    objectives = 0.5 * problem.scale**2 * problem.robust.rho(apart**2).sum(axis=(1, 2))
    best = int(np.argmin(objectives))
    return points[best] if objectives[best] < objective else None
