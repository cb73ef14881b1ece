"""Whether every value is a number that a BRDF can have: finite, not negative, 0 below the horizon; and what reflects nothing at all."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motes.certification.certificate import Check, Finding, Outcome
from motes.certification.hemisphere import grazing, special, upper
from motes.certification.specimen import Specimen
from motes.certification.wording import degrees, share

RANDOM, LOW = 6000, 3000
#: Of measured values: negatives no larger than this share of the mean are the noise of an instrument around 0.
NOISE = 0.02

Where = NDArray[np.bool_]


class _Asked:
    """The pairs that were asked, with their values and, for the special ones, their names."""

    def __init__(self, specimen: Specimen) -> None:
        named = special()
        if specimen.pairs is not None:
            self.wi, self.wo = specimen.pairs
            self.names: tuple[str, ...] = ()
        else:
            low = grazing(LOW, 3)
            self.names = tuple(named)
            self.wi = np.concatenate([np.stack([a for a, _ in named.values()]), upper(RANDOM, 1), low[0]])
            self.wo = np.concatenate([np.stack([b for _, b in named.values()]), upper(RANDOM, 2), low[1]])
        self.values = specimen.eval(self.wi, self.wo)

    def place(self, bad: Where) -> tuple[str, str]:
        """Where something happens: a word for the kind of place, and a sentence's part."""
        rows: Where = np.asarray(bad.any(axis=1))
        count, first = int(rows.sum()), int(np.argmax(rows))
        special_ones = [name for name, hit in zip(self.names, rows, strict=False) if hit]
        random = rows[len(self.names) :]
        example = degrees(self.wi[first], self.wo[first])
        if not random.any():
            return "special", f"at {', '.join(special_ones)}"
        steepest = np.minimum(self.wi[:, 2], self.wo[:, 2])[len(self.names) :][random]
        some = f"at {count:,} of {len(rows):,} pairs of directions ({share(count / len(rows))}), as at {example}"
        if np.all(steepest < np.cos(np.radians(70))):
            return "grazing", f"{some}; all of them have a direction beyond 70°"
        return "anywhere", some


def check_values(specimen: Specimen) -> Check:
    """NaN, infinite, negative, above the horizon; anything but 0 below it.

    Measured values may be a little negative, as noise about 0 is.
    """
    asked = _Asked(specimen)
    values = asked.values
    finite = np.isfinite(values)
    findings = [
        finding
        for finding in (
            _not_numbers(asked, np.isnan(values)),
            _infinite(asked, np.isinf(values)),
            _negative(specimen, asked, finite & (values < 0)),
            None if specimen.pairs is not None or specimen.transmits else _below(specimen),
            _nothing(specimen, asked),
        )
        if finding is not None
    ]
    largest = float(np.max(values, where=finite, initial=0.0))
    says = (
        f"{len(values):,} pairs of directions, {len(asked.names)} of them where formulas are at risk: values from "
        f"{np.min(values, where=finite, initial=np.inf):.4g} to {largest:.4g} 1/sr."
    )
    numbers = {
        "pairs": len(values),
        "nan": int(np.isnan(values).sum()),
        "infinite": int(np.isinf(values).sum()),
        "negative": int((finite & (values < 0)).sum()),
    }
    return Check("values", says, tuple(findings), numbers)


def _not_numbers(asked: _Asked, bad: Where) -> Finding | None:
    if not bad.any():
        return None
    kind, where = asked.place(bad)
    if kind == "special" and "normal" in where:
        name, why = (
            "nan-at-normal",
            "Is an azimuth or a half angle divided by a sine that is 0 there, or an arc cosine taken of a cosine that rounds to above 1?",
        )
    elif kind == "special":
        name, why = "nan-at-special", "Is an arc cosine or a root taken of what rounds to above 1 or below 0? Clamp it."
    elif kind == "grazing":
        name, why = "nan-at-grazing", "Does 0/0 happen as a cosine nears 0, or a root of 1 - sin² turn negative?"
    else:
        name, why = "nan", "Is a root or a logarithm taken of something negative?"
    return Finding(name, f"It is not a number (NaN) {where}", why)


def _infinite(asked: _Asked, bad: Where) -> Finding | None:
    if not bad.any():
        return None
    kind, where = asked.place(bad)
    why = (
        "Is it divided by a cosine that is not kept above 0?"
        if kind == "grazing" or "grazing" in where
        else "Is it divided by something that vanishes there, or by a roughness of 0?"
    )
    return Finding("infinite", f"It is infinite {where}", why)


def _negative(specimen: Specimen, asked: _Asked, bad: Where) -> Finding | None:
    if not bad.any():
        return None
    kind, where = asked.place(bad)
    scale = float(np.mean(asked.values, where=np.isfinite(asked.values)))
    worst = -float(np.min(asked.values, where=bad, initial=0.0))
    if specimen.measured and worst <= NOISE * scale:
        return None
    says = f"It is negative, down to {-worst:.3g} 1/sr, {where}"
    if specimen.measured:
        return Finding("negative", says, "Noise, or a colour outside the gamut of its channels?", Outcome.DOUBT)
    if kind == "grazing":
        return Finding(
            "negative-at-grazing",
            says,
            "Is a term that goes below 0 towards grazing left unclamped (as equation (1) of Oren-Nayar)?",
        )
    if bad.all(axis=0).any() or bad.mean() > 0.9:
        return Finding("sign", says, "Is the sign wrong?")
    return Finding("negative", says, "Is a term subtracted that should be clamped at 0?")


def _below(specimen: Specimen) -> Finding | None:
    """Light or viewer below the horizon: nothing comes from there, and nothing goes there."""
    a, b = upper(600, 5), upper(600, 6)
    flip = np.array([1.0, 1.0, -1.0])
    sides = {"the viewer": (a, b * flip), "the light": (a * flip, b)}
    if not specimen.both_sides:
        sides["both"] = (a * flip, b * flip)
    found = {side: specimen.eval(*pair) for side, pair in sides.items()}
    lit = [side for side, values in found.items() if np.any(np.nan_to_num(values, nan=1.0) != 0)]
    if not lit or not np.any(np.nan_to_num(specimen.eval(a, b)) != 0):  # `_nothing` says more
        return None
    says = f"It is not 0 where {' or where '.join(lit)} {'are' if lit == ['both'] else 'is'} below the horizon"
    why = "Is the test of the horizon missing, or is the cosine's absolute value taken? A renderer would let light through."
    outcome = Outcome.FAULT if specimen.strict else Outcome.DOUBT
    return Finding("below-horizon", says, why, outcome)


def _nothing(specimen: Specimen, asked: _Asked) -> Finding | None:
    """A subject that is 0 above the horizon: do its vectors point the other way?"""
    if np.any(np.nan_to_num(asked.values, nan=1.0) != 0):
        return None
    if specimen.pairs is None:
        a, b = upper(600, 5), upper(600, 6)
        turns = {
            "wi": ("light-reversed", (-a, b)),
            "wo": ("viewer-reversed", (a, -b)),
            "wi and wo": ("both-reversed", (-a, -b)),
        }
        for which, (name, pair) in turns.items():
            if np.any(np.nan_to_num(specimen.eval(*pair)) != 0):
                return Finding(
                    name,
                    f"It is 0 wherever both directions are above the horizon, and is not with {which} turned around",
                    f"Does it take {which} as the way that light travels? Here both point away from the surface.",
                )
    return Finding(
        "black",
        "It is 0 everywhere",
        "Is it black, a mirror or glass without roughness, or not given its parameters?",
        Outcome.DOUBT,
    )
