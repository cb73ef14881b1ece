"""Rival hypotheses: a reference seen through other conventions, and which of them the subject's values follow.

A hypothesis is a reference with changed parameters (alpha for alpha squared, the sign of g, degrees for radians, a term times pi), asked at
changed directions (swapped, turned), with its channels reversed, times a factor of the cosines and a constant.  The constant is fitted; the one
that leaves least, with the fewest changes, is named.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from motes.certification.hemisphere import turned
from motes.certification.specimen import Floats, Specimen
from motes.certification.variants import SAME, Change, variants

#: The subject's directions as the reference is to be asked at them.
PLACES: tuple[tuple[Change, Callable[[Floats, Floats], tuple[Floats, Floats]]], ...] = (
    (SAME, lambda a, b: (a, b)),
    (Change("swapped", "Are wi and wo swapped?"), lambda a, b: (b, a)),
    (
        Change(
            "azimuth-turned",
            "Is the azimuth of one direction turned by 180°, so that the highlight lies where the light comes from?",
        ),
        lambda a, b: (a, turned(b)),
    ),
    (Change("normal-is-y", "Is y the normal, where here z is?"), lambda a, b: (a[:, [2, 0, 1]], b[:, [2, 0, 1]])),
)

FACTORS: tuple[tuple[Change, Callable[[Floats, Floats], Floats]], ...] = (
    (SAME, lambda ci, co: np.ones_like(ci)),
    (Change("cosine-included", "Does it include the cosine of wo (f cos)?"), lambda ci, co: co),
    (Change("cosine-of-light-included", "Does it include the cosine of wi?"), lambda ci, co: ci),
    (Change("both-cosines-included", "Does it include both cosines?"), lambda ci, co: ci * co),
    (Change("cosine-of-viewer-divided", "Is it divided by the cosine of wo?"), lambda ci, co: 1 / co),
    (Change("cosine-of-light-divided", "Is it divided by the cosine of wi?"), lambda ci, co: 1 / ci),
    (Change("both-cosines-divided", "Is it divided by both cosines once too often?"), lambda ci, co: 1 / (ci * co)),
)

#: Constants that programs differ by.
CONSTANTS: tuple[tuple[float, str, str], ...] = (
    (np.pi, "factor-pi", "f is pi times too large: is it a reflectance factor, or is 1/pi missing?"),
    (1 / np.pi, "factor-1-pi", "f is pi times too small: is 1/pi taken twice?"),
    (4.0, "factor-4", "f is 4 times too large: is the 4 of 4 cos(theta_i) cos(theta_r) missing?"),
    (0.25, "factor-1-4", "f is 4 times too small: is the 4 of 4 cos(theta_i) cos(theta_r) taken twice?"),
    (4 / np.pi, "factor-4-pi-for-4", "f is 4/pi times too large: is pi written for the 4 of Cook-Torrance?"),
    (np.pi / 4, "factor-pi-for-4", "f is pi/4 of what it should be: is 4 written for the pi of Cook and Torrance's first form?"),
    (4 * np.pi, "factor-4-pi", "f is 4 pi times too large: is a brightness or a phase function normalised to 4 pi meant?"),
    (1 / (4 * np.pi), "factor-1-4-pi", "f is 4 pi times too small: is a phase function normalised to 1 meant?"),
    (2.0, "factor-2", "f is twice too large: is a term counted twice, or an integral taken over half of the range?"),
    (0.5, "factor-half", "f is half of what it should be: is an average taken for a sum?"),
    (100.0, "percent", "Are the values percent?"),
    (255.0, "8-bit", "Are the values 8-bit numbers?"),
    (1500.0, "merl-scale", "Is the scale of a MERL table (1/1500) missing?"),
)  # fmt: skip


@dataclass(frozen=True)
class Rival:
    """A hypothesis with what it leaves.

    Attributes
    ----------
    changes
        What differs from the reference; empty for the reference itself.
    scale
        The constant that fits best; 1 for the reference itself.
    residual
        Mean of |subject - prediction| / (|subject| + |prediction|): 0 for the same, 1 for nothing in common.
    """

    changes: tuple[Change, ...]
    scale: float
    residual: float


def rivals(values: Floats, wi: Floats, wo: Floats, reference: Specimen) -> list[Rival]:
    """All hypotheses, the best first: with the fewest changes among those that leave about as little.

    Parameters
    ----------
    values
        What the subject answers (N, C) at directions (N, 3), (N, 3).
    reference
        What it should be; where it has a model, its parameters are varied, too.
    """
    ci, co = wi[:, 2:], wo[:, 2:]
    found = []
    for parametric, seen in variants(reference):
        for place, turn in PLACES:
            if parametric.name and place.name:
                continue
            predicted = seen(*turn(wi, wo))
            if not np.isfinite(predicted).all() or not predicted.any():
                continue
            for order in _orders(values, predicted):
                for factor, of in FACTORS:
                    base = predicted[:, ::-1] if order.name else predicted
                    changes = tuple(c for c in (parametric, place, order, factor) if c.name)
                    if len(changes) > 2:
                        continue
                    found.append(_judged(values, base * of(ci, co), changes))
    if not found:  # a reference that is black
        return [Rival((), 1.0, distance(values, np.zeros_like(values)))]
    found.sort(key=lambda rival: rival.residual)
    enough = 1.3 * found[0].residual + 1e-4
    return sorted(found, key=lambda rival: (rival.residual > enough, _cost(rival), rival.residual))


def _cost(rival: Rival) -> float:
    """How much a hypothesis asks to be believed: its changes, and a constant that is not 1."""
    return len(rival.changes) + (0.0 if rival.scale == 1 else 0.9 if constant(rival.scale) else 1.5)


def distance(values: Floats, predicted: Floats) -> float:
    """Mean of |a - b| / (|a| + |b|), small values counted by the scale of all."""
    floor = 1e-3 * float(np.median(np.abs(values))) + 1e-30
    size = np.abs(values) + np.abs(predicted) + floor
    return float(np.mean(np.abs(values - predicted) / size))


def constant(scale: float) -> tuple[str, str] | None:
    """The name of a constant that programs differ by, and the question."""
    for value, name, asks in CONSTANTS:
        if abs(scale / value - 1) < 5e-3:
            return name, asks
    return None


def _judged(values: Floats, predicted: Floats, changes: tuple[Change, ...]) -> Rival:
    """With the constant that fits best, if that is better than none."""
    values, predicted = np.broadcast_arrays(values, predicted)
    plain = distance(values, predicted)
    good = np.abs(predicted) > 1e-3 * np.median(np.abs(predicted))
    if not good.any():
        return Rival(changes, 1.0, plain)
    scale = float(np.median(values[good] / predicted[good]))
    if not np.isfinite(scale) or scale <= 0 or abs(scale - 1) < 2e-3:
        return Rival(changes, 1.0, plain)
    scaled = distance(values, scale * predicted)
    return Rival(changes, scale, scaled) if scaled < 0.5 * plain else Rival(changes, 1.0, plain)


def _orders(values: Floats, predicted: Floats) -> Iterator[Change]:
    yield SAME
    if predicted.shape[1] == 3 and values.shape[1] == 3:
        yield Change("channels-reversed", "Are the channels in the order B, G, R?")
