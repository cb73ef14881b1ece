"""Climbing the ladder of candidates: each is fitted from where those before it ended, and then predicts what it has not seen.

Neither alone would do.  A search from many points for each candidate takes too long; the objective alone always prefers the largest
model, since real residuals are not independent.  So every candidate leaves out blocks of neighbouring directions in turn, is fitted to
the others from its own optimum, and is judged by how it predicts what it left out.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from motes.fitting.choice import NOISE_FLOOR, bic
from motes.fitting.chord import Chord
from motes.fitting.direction_blocks import Labels
from motes.fitting.losses import ROBUST, Floats
from motes.fitting.metrics import deviation, relative_rms
from motes.fitting.nested import Found, carried, nearer
from motes.fitting.problem import Problem
from motes.fitting.quantities import Quantity
from motes.fitting.result import Trial
from motes.fitting.setup import check_enough
from motes.fitting.solver import minimize
from motes.fitting.starts import starting_points
from motes.fitting.uncertainty import at_rest, unseen
from motes.fitting.verdicts import Status
from motes.models import BRDF
from motes.models.composition import layer_of

#: In how many turns the blocks of directions are left out.
FOLDS = 8
# A grid of so many points to start from is taken whole; of a larger one only what is new against the candidates before.
LANES = 24
# How many candidates before lend their ends as starts, and how many starts go on after a few rough steps; a third of them where the data
# are so few that what each costs does not show.
LENDERS, KEPT = 4, 2
ROUGH_STEPS, ROUGH_REDUCTION, STEPS, REDUCTION = 4, 1e-3, 25, 1e-4
# Fits to parts take so many steps with the derivatives of where they are, and then again.
FOLD_ROUNDS, FOLD_STEPS, FOLD_REDUCTION = 2, 3, 1e-4
# Starts are thinned out on a part of so many samples; those of a slow candidate on every second direction at least, and so many go on.
ROUGH_SAMPLES = 1500
SLOW_STEP, SLOW_KEPT = 2, 5


@dataclass(frozen=True)
class Rung:
    """A candidate, fitted.

    Attributes
    ----------
    problem, x
        What was minimised, and where (P,).
    left_out
        What half of a sum of squares each block of directions adds (G,) when it is predicted by a fit to others; the objective's
        own share where nothing was left out.
    per_channel
        What was fitted for each channel that is shared otherwise.
    """

    text: str
    brdf: BRDF
    problem: Problem
    x: Floats
    objective: float
    status: Status
    left_out: Floats
    per_channel: tuple[str, ...] = ()

    @property
    def layered(self) -> bool:
        """Whether it is a layer over something."""
        return layer_of(self.brdf) is not None

    @property
    def found(self) -> Found:
        return Found(self.problem.quantities, self.x)

    @property
    def bic(self) -> float:
        bright = float(self.problem.brightness().sum())
        return bic(self.objective, self.problem.samples, self.problem.size, bright)

    def value(self, quantity: Quantity) -> Floats:
        """The values of one of its quantities."""
        return quantity.value(self.x[quantity.where])

    def trial(self) -> Trial:
        problem = self.problem
        bright = float(problem.brightness().sum())
        used = problem.weights > 0
        return Trial(
            model=self.text,
            n_parameters=problem.size,
            bic=self.bic,
            relative_rms=relative_rms(problem.predicted(self.x)[used], problem.values[used]),
            objective=self.objective,
            status=self.status,
            chosen=False,
            n_samples=problem.samples,
            left_out=math.sqrt(2 * float(self.left_out.sum()) / max(bright, 1e-300)),
            per_channel=self.per_channel,
        )


def rung_of(
    text: str,
    brdf: BRDF,
    problem: Problem,
    below: Sequence[Rung],
    blocks: Labels,
    per_channel: tuple[str, ...] = (),
    near: Rung | None = None,
    slow: bool = False,
) -> Rung:
    """A candidate, fitted to a problem from what `below` found, and to parts of it.

    Parameters
    ----------
    blocks
        Which block each of the problem's pairs of directions is in (N,).
    near
        The same candidate, fitted to data that are much like these: a search for where to start is spared.
    slow
        Whether its values take so long that fewer starts are looked at, and less closely.

    Raises
    ------
    DataError
        Where the samples are too few for its parameters, those that are left in included.
    """
    folds = _folds(problem, blocks)
    fewest = min([problem.samples, *(int(np.count_nonzero(weights)) for weights in folds)])
    check_enough(fewest, problem.size, brdf)
    if near is None:
        lanes = _lanes(problem, below, layer_of(brdf) is not None)
    else:
        lanes = np.unique(np.stack([carried(problem, rung.found) for rung in (near, *_lenders(below))]), axis=0)
    x, objective, status = _fitted(problem, lanes, slow)
    simpler = nearer(problem, [rung.found for rung in below if rung.objective < objective], objective)
    if simpler is not None:
        x, objective, status = _fitted(problem, simpler[None], slow)
    return Rung(text, brdf, problem, x, objective, status, _left_out(problem, x, blocks, folds), per_channel)


def under_robust(problem: Problem, robust: str, rungs: Sequence[Rung]) -> Problem:
    """The problem under a robust function whose scale is that of the closest of plain fits: one scale for all candidates."""
    if robust == "none":
        return problem
    scales = [deviation(rung.problem.residuals(rung.x)[rung.problem.weights > 0], problem.unit) for rung in rungs]
    return problem.with_scale(ROBUST[robust], float(min(scales, default=1.0)))


# ---------------------------------------------------------------- starts


def _lanes(problem: Problem, below: Sequence[Rung], layered: bool) -> Floats:
    """Where the fit starts (B, P): on the whole grid where that is small; else where others ended, and on the grid of what is new."""
    whole = math.prod(len(q.parameter.starts) or 1 for q in problem.quantities)
    if not below or whole <= LANES:
        return starting_points(problem, None, most=KEPT)
    names = {q.name for q in problem.quantities}
    lenders = _lenders(below)
    lanes = [carried(problem, rung.found) for rung in lenders]
    # A layer is laid on what lies below it, in several thicknesses.
    parents = [rung for rung in below if not (layered and rung.layered)] or list(below)
    parent = max(parents, key=lambda rung: (len(names & {q.name for q in rung.problem.quantities}), -rung.objective))
    known = {q.name for q in parent.problem.quantities}
    new = [q for q in problem.quantities if q.name not in known and q.parameter.starts]
    axes = [q.parameter.starts for q in new]
    while math.prod(len(a) for a in axes) > LANES:
        longest = max(range(len(axes)), key=lambda k: len(axes[k]))
        axes[longest] = axes[longest][::2]
    # What lies below may look otherwise under the layer: a layer over the same tells, where there is one.
    alike = [rung for rung in lenders if layered and rung.layered][:1]
    for base, point in itertools.product((parent, *alike), itertools.product(*axes)):
        lane = carried(problem, base.found)
        for q, value in zip(new, point, strict=True):
            lane[q.where] = q.coordinate(np.array(value))
        lanes.append(lane)
    return np.unique(np.stack(lanes), axis=0)


def _lenders(below: Sequence[Rung]) -> list[Rung]:
    """The candidates before whose ends are worth starting from."""
    return sorted(below, key=lambda rung: rung.objective)[:LENDERS]


# ---------------------------------------------------------------- fits


def _fitted(problem: Problem, lanes: Floats, slow: bool = False) -> tuple[Floats, float, Status]:
    """The best end of fits that start at each of the lanes, thinned out by a few rough steps."""
    step = max(1, len(problem.wi) * problem.channels // ROUGH_SAMPLES)
    kept = KEPT if step > 1 else SLOW_KEPT if slow else max(KEPT, len(lanes) // 3)
    if slow and len(problem.wi) > SLOW_STEP * problem.size:
        step = max(step, SLOW_STEP)
    if len(lanes) > kept:
        part = problem if step == 1 else problem.at_directions(np.arange(0, len(problem.wi), step))
        rough = part.solve(lanes, max_iterations=ROUGH_STEPS, reduction=ROUGH_REDUCTION)
        lanes = rough.x[np.argsort(rough.normal.objective, kind="stable")[:kept]]
    ends = problem.solve(lanes, max_iterations=STEPS, reduction=REDUCTION)
    best = ends.best()
    return at_rest(problem, ends.best_point(problem.normal)), float(ends.normal.objective[best]), ends.status[best]


def _folds(problem: Problem, blocks: Labels) -> list[Floats]:
    """Weights (N, C) of each turn, 0 for the blocks that it leaves out; none where there is one block alone."""
    turns = min(FOLDS, int(blocks.max()) + 1)
    return [problem.weights * (blocks % turns != k)[:, None] for k in range(turns)] if turns > 1 else []


def _left_out(problem: Problem, x: Floats, blocks: Labels, folds: list[Floats]) -> Floats:
    """What each block adds to the objective (G,), predicted by fits that did not see it, which start at `x`.

    What the whole does not see, as the width of a highlight of no strength, its parts do not fit: a few steps along their rounding or along
    one bright sample would lead anywhere.
    """
    count, turns = int(blocks.max()) + 1, len(folds)
    at = np.repeat(x[None], max(turns, 1), axis=0)
    if turns:
        held = unseen(problem, x)
        parts = problem.weighing(np.stack(folds))
        for _ in range(FOLD_ROUNDS):
            at = minimize(
                Chord(parts, at).normal,
                at,
                *parts.bounds,
                held=held,
                sets=np.arange(turns),
                brightness=parts.brightness(),
                unit=parts.columns.unit[:, 0],
                max_iterations=FOLD_STEPS,
                reduction=FOLD_REDUCTION,
                algebra=parts.algebra,
            ).x
    z = (problem.misfits(at) / problem.scale) ** 2
    own = problem.robust.rho(z).sum(axis=1)[blocks % len(at), np.arange(len(blocks))]
    added = 0.5 * problem.scale**2 * own
    # Residuals that are rounding say nothing, as for the BIC.
    floor = 0.5 * NOISE_FLOOR**2 * float(problem.brightness().sum()) / count
    return np.asarray(np.bincount(blocks, added, count) + floor)
