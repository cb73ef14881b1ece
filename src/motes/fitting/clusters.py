"""The sandwich over blocks of directions: its middle, and how many degrees of freedom stand behind each error.

Where a model does not fit, residuals are alike at neighbouring directions and in all channels, so scores are summed over blocks before they
are squared (Liang and Zeger, Biometrika 73, 1986).  What a block did to the fit itself is made up for so that the variance is right on average
where samples are independent after all: CR2 of Bell and McCaffrey (Survey Methodology 28, 2002).  Their CR3, the jackknife that leaves out a block at
a time, errs on the wide side (`docs/uncertainty.md` has both).  Blocks are few, and fewer still bear on a parameter that only some of them
see, so intervals take quantiles of Student's t with Satterthwaite's degrees of freedom, from the same paper.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from motes import workers
from motes.fitting.covariance import LEAST_REMAINDER
from motes.fitting.direction_blocks import Labels
from motes.fitting.losses import Floats
from motes.fitting.objective import Objective
from motes.fitting.problem import CHUNK, Problem

# Of more parameters than these a block's part of the curvature is a matrix too large for what it tells.
MOST_TAKEN_OUT = 64


class Middle(NamedTuple):
    """The middle of a sandwich (P, P), and degrees of freedom for each parameter (P,)."""

    matrix: Floats
    freedom: Floats


def middle_over(objective: Objective, x: Floats, inverse: Floats, blocks: Labels) -> Middle:
    """The middle of the sandwich at `x` (P,), with the `inverse` (P, P) of the curvature among what is free, 0 elsewhere.

    `blocks` (N,) are the labels of the objective's directions, from 0.
    """
    if len(x) <= MOST_TAKEN_OUT:
        scores, shares = _by_block(objective, x, blocks)
        # In units of the parameters, so that no eigenvalue is lost beside one of another unit.
        unit = objective.columns.unit[:, 0]
        square = np.outer(unit, unit)
        found = evened(scores * unit, shares * square, inverse / square)
        return found._replace(matrix=found.matrix / square)
    parts = _parts(objective, blocks)
    scores = np.stack([part.normal(x[None]).gradient[0] for part in parts])
    # Copies: a view of its diagonal would keep each (P, P) alive, 37 MB a block for 2,151 bands.
    return plain(scores, np.stack([np.diag(part.curvature(x)).copy() for part in parts]))


def _parts(objective: Objective, blocks: Labels) -> list[Objective]:
    return [objective.at_directions(np.flatnonzero(blocks == k)) for k in range(int(blocks.max()) + 1)]


def _by_block(objective: Objective, x: Floats, blocks: Labels) -> tuple[Floats, Floats]:
    """Gradients (G, P) and curvatures (G, P, P) of the blocks."""
    if not isinstance(objective, Problem) or objective.values.size > CHUNK:
        parts = _parts(objective, blocks)
        gradients = [part.normal(x[None]).gradient[0] for part in parts]
        return np.stack(gradients), np.stack([part.curvature(x) for part in parts])
    # One pass for all of them, whose directions lie side by side: a pass for each takes as long as one over thousands of directions.
    order = np.argsort(blocks, kind="stable")
    firsts = np.searchsorted(blocks[order], np.arange(int(blocks.max()) + 1))
    residual, jacobian = (part[0] for part in objective.linearised(x[None], slice(0, len(blocks)), None))
    z = (residual / objective.scale) ** 2
    pushed = (residual * objective.robust.slope(z))[:, None]  # (C, 1, N)
    along = np.swapaxes(jacobian, 1, 2)  # (C, K, N)
    bent = (objective.robust.bend(z)[:, None] * along).take(order, axis=-1)
    scores = np.add.reduceat((along * pushed).take(order, axis=-1), firsts, axis=-1)
    along, ends = along.take(order, axis=-1), (*firsts[1:], len(order))
    shares = [along[..., a:b] @ np.swapaxes(bent[..., a:b], 1, 2) for a, b in zip(firsts, ends, strict=True)]
    return objective.layout.vector(np.moveaxis(scores, -1, 0)), objective.layout.matrix(np.stack(shares))


def evened(scores: Floats, shares: Floats, inverse: Floats, power: float = 0.5) -> Middle:
    """From scores (G, P) and parts of the curvature (G, P, P) of G blocks: their leverages made up for.

    With L the inverse, a block of score s and part M counts as (1 - M L)^-power s: a half is CR2; one is CR3 without its factor, and L times that by
    how much the fit moves without the block.  In the coordinates in which L is 1, M has eigenvalues h, the leverages; no block is taken to
    leave less than `LEAST_REMAINDER` of its residuals.
    """
    with workers.alone():
        values, vectors = np.linalg.eigh(0.5 * (inverse + inverse.T))
        root = vectors * np.sqrt(np.maximum(values, 0.0))  # L = root root'
        leverage, turn = np.linalg.eigh(root.T @ shares @ root)  # (G, P), (G, P, P)
    leverage = np.clip(leverage, 0.0, 1.0 - LEAST_REMAINDER)
    gain = (1.0 - leverage) ** -power
    # (1 - M L)^-power s = s + M root turn (gain - 1) / h turn' root' s, also for parameters that L holds.
    more = np.where(leverage > 1e-9, (gain - 1.0) / np.maximum(leverage, 1e-9), power)
    along = np.einsum("gpq,gp->gq", turn, scores @ root) * more
    full = scores + np.einsum("gpq,gq->gp", shares, np.einsum("gpq,gq->gp", turn, along) @ root.T)
    # Of independent noise of one size, the sum over blocks is a quadratic form with this matrix (G, G) for each parameter: its trace
    # squared over the trace of its square is the freedom of the chi-square that has its mean and variance.
    to = np.einsum("gqk,pq->gkp", turn, root)  # (G, K, P): L^1/2 e_p, turned
    own = np.einsum("gkp,gk->gp", to**2, leverage * gain**2)
    shift = np.einsum("gqk,gkp->gqp", turn, to * (leverage * gain)[..., None])
    freedom = np.ones(len(inverse))
    for p in range(len(inverse)):
        form = np.diag(own[:, p]) - shift[:, :, p] @ shift[:, :, p].T
        freedom[p] = _freedom(float(np.trace(form)) ** 2, float(np.sum(form**2)))
    return Middle(np.asarray(full.T @ full), freedom)


def plain(scores: Floats, seen: Floats) -> Middle:
    """From scores (G, P) and what each block sees of each parameter (G, P): without leverages, but times G / (G - 1)."""
    count = len(scores)
    freedom = [_freedom(float(column.sum()) ** 2, float((column**2).sum())) - 1.0 for column in seen.T]
    return Middle(np.asarray(count / (count - 1) * scores.T @ scores), np.maximum(freedom, 1.0))


def _freedom(square_of_sum: float, sum_of_squares: float) -> float:
    return max(1.0, square_of_sum / sum_of_squares) if sum_of_squares > 0 else 1.0
