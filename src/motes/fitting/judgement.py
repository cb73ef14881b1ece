"""Which candidate is taken, and whether what it shows is dust: by what blocks of directions that were left out say.

The one-standard-error rule (Breiman, Friedman, Olshen, Stone 1984): the simplest candidate whose prediction is worse than the best
one's by no more than a standard error, over the blocks, of the difference between the two; or whose BIC is smaller.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from motes.fitting.ladder import Rung
from motes.fitting.losses import Floats
from motes.models.composition import layer_of
from motes.models.dust import DustLayer
from motes.models.particles import MULTIPLE
from motes.parameters import Role

#: With fewer blocks nothing is known of how well candidates predict.
FEWEST_BLOCKS = 6
# Dust is called dust where it leaves less than this share of what the best clean candidate leaves of the blocks left out, ...
DECISIVE = 0.7
# ... and where it leaves more than this, it is as good as not there.
IDLE = 0.9
# ... and follows the data itself, within this relative RMS of what was left out.
FOLLOWS = 0.12
# Layers that can be dust: the optical thickness, the albedo of a grain, the mean cosine (what is known of real dust is above 0).
THINNEST, WHITEST, MOST_BACKWARD = 0.06, 1.02, -0.3
#: The least reduced albedo of dust: a heap of grains with less is darker than one of soot, and a layer of them is a shadow.
DARKEST = 0.15


@dataclass(frozen=True)
class Contender:
    """A candidate on one or several scans.

    Attributes
    ----------
    left_out
        What each block of each scan adds (G,); see `motes.fitting.ladder.Rung`.
    brightness
        The weighted sum of squares of the data.
    layers
        Of each scan the mean values of the layer's own parameters by role; empty for a candidate without a layer.
    whole
        Whether it is a layer with all orders of scattering: of one that scatters once little is to be learned.
    """

    text: str
    per_channel: tuple[str, ...]
    left_out: Floats
    brightness: float
    bic: float
    layers: tuple[dict[Role, float], ...] = ()
    whole: bool = False

    @classmethod
    def of(cls, scans: Sequence[Rung]) -> Contender:
        """The same candidate, fitted to each scan."""
        layers = [found for rung in scans if (found := _layer_values(rung))]
        left_out = np.concatenate([rung.left_out for rung in scans])
        bright = sum(float(rung.problem.brightness().sum()) for rung in scans)
        bic = sum(rung.bic for rung in scans)
        first = scans[0].brdf
        whole = isinstance(first, DustLayer) and first.scattering == MULTIPLE
        return cls(scans[0].text, scans[0].per_channel, left_out, bright, bic, tuple(layers), whole)

    def of_rungs(self, rungs: Sequence[Rung]) -> Rung:
        """The rung of one scan that this is."""
        return next(rung for rung in rungs if (rung.text, rung.per_channel) == (self.text, self.per_channel))

    @property
    def loss(self) -> float:
        return float(self.left_out.sum())

    @property
    def follows(self) -> bool:
        """Whether it is so close to what was left out that its layer means something."""
        return 2 * self.loss <= FOLLOWS**2 * self.brightness

    @property
    def thin(self) -> bool:
        """Whether its layer, if it has any, is too thin on all scans to be told from none."""
        return all(layer.get(Role.DEPTH, 0.0) < THINNEST for layer in self.layers)

    @property
    def could_be_dust(self) -> bool:
        """Whether the layer of one of the scans, the thickest, has values that dust has."""
        if not self.layers or self.thin:
            return False
        thickest = max(self.layers, key=lambda layer: layer.get(Role.DEPTH, 0.0))
        w, g = thickest.get(Role.SINGLE_SCATTERING_ALBEDO, 0.5), thickest.get(Role.ASYMMETRY, 0.0)
        return reduced_albedo(w, g) >= DARKEST and w <= WHITEST and g >= MOST_BACKWARD


class Judgement(NamedTuple):
    """What was decided.

    Attributes
    ----------
    chosen
        The candidate that is taken.
    dusty
        True, False, or None where the data cannot tell.
    share
        What the best layer leaves, over what the best clean candidate leaves; NaN where nothing was compared.
    errors
        By how many standard errors it leaves less.
    counts
        Whether it could be dust, follows the data and predicts better by more than a standard error, so that the share decides.
    """

    chosen: Contender
    dusty: bool | None
    share: float
    errors: float
    counts: bool = False


def reduced_albedo(w: float, g: float) -> float:
    """The single-scattering albedo of grains that scatter evenly and make as bright a heap as those of albedo `w` and mean cosine `g`.

    Light that goes straight on is as good as not scattered: w (1 - g) / (1 - w g), the similarity relation of van de Hulst, Multiple Light
    Scattering, 1980, section 14.1.
    """
    return w * (1 - g) / (1 - w * g) if w * g < 1 else math.inf


def standard_errors(better: Contender, worse: Contender) -> float:
    """By how many standard errors `better` predicts better, over the blocks; 0 where both predict alike."""
    gain = worse.left_out - better.left_out
    total = float(gain.sum())
    if total == 0:
        return 0.0
    error = float(np.std(gain, ddof=1)) * math.sqrt(len(gain)) if len(gain) > 1 else math.inf
    return total / max(error, 1e-300)


def simplest(contenders: Sequence[Contender]) -> Contender:
    """The first that the best is not `clearly_better` than; they come in the order of the ladder.

    Where too few blocks could be left out, the one with the smallest BIC.
    """
    if len(contenders[0].left_out) < FEWEST_BLOCKS:
        return min(contenders, key=lambda one: one.bic)
    best = min(contenders, key=lambda one: one.loss)
    return next(one for one in contenders if not clearly_better(best, one))


def clearly_better(better: Contender, worse: Contender) -> bool:
    """Whether `better` predicts better by more than a standard error, and has the smaller BIC as well.

    Where a model fits, a larger one predicts better by chance now and then, which the BIC knows; where none does, the BIC always takes
    the largest, which the blocks left out know.
    """
    return standard_errors(better, worse) > 1.0 and better.bic < worse.bic


def judged(contenders: Sequence[Contender]) -> Judgement:
    """The candidate that is taken, and the verdict on dust.

    A layer is taken where it is dust, and nowhere else: elsewhere it is one more broad lobe that falls off towards grazing angles,
    which clean models of a few more parameters have as well.  Layers that scatter light once are evidence only where none with all
    orders of scattering was compared: with w free they follow many a clean material, too.
    """
    clean, layers = [c for c in contenders if not c.layers], [c for c in contenders if c.layers]
    if clean and len(clean[0].left_out) < FEWEST_BLOCKS:
        return Judgement(simplest(clean), None, math.nan, math.nan)
    if not clean or not layers:
        return Judgement(simplest(contenders), None, math.nan, math.nan)
    dust = [c for c in layers if c.could_be_dust]
    evidence = [c for c in dust if c.whole or not any(layer.whole for layer in layers)]
    best_clean = min(clean, key=lambda one: one.loss)
    best_layer = min(evidence or dust or layers, key=lambda one: one.loss)
    share, errors = best_layer.loss / best_clean.loss, standard_errors(best_layer, best_clean)
    counts = bool(evidence) and best_layer.follows and errors > 1.0
    if counts and share < DECISIVE:
        return Judgement(simplest(dust), True, share, errors, counts)
    told = share > (DECISIVE if best_layer.thin else IDLE) or errors <= 1.0
    return Judgement(simplest(clean), False if told else None, share, errors, counts)


def _layer_values(rung: Rung) -> dict[Role, float]:
    layer = layer_of(rung.brdf)
    if layer is None:
        return {}
    own = {slot.name: slot.parameter.role for slot in layer.own}
    found = {q.name: float(np.mean(rung.value(q))) for q in rung.problem.quantities}
    held = {slot.name: float(np.mean(np.asarray(slot.value, float))) for slot in layer.own}
    return {role: (held | found)[name] for name, role in own.items() if role is not None}
