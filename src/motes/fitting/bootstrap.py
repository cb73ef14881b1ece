"""The block bootstrap: the fit again and again, to blocks of directions that are drawn with replacement."""

from __future__ import annotations

import numpy as np

from motes.fitting.direction_blocks import Labels
from motes.fitting.losses import Floats
from motes.fitting.objective import Objective
from motes.fitting.result import Progress

#: How often the fit is repeated.
DRAWS = 400
# A relative change of the objective below this moves parameters by far less than their errors.
REDUCTION = 1e-8


def drawn(
    objective: Objective, x: Floats, blocks: Labels, progress: Progress | None = None, draws: int = DRAWS
) -> Floats:
    """Fits (D, P), from the solution `x` (P,) on, in which each block of directions counts as often as it was drawn (Efron, 1979).

    As many blocks are drawn as there are, the same ones each time that this is called.  `blocks` (N,) are the labels of the directions.
    """
    count = int(blocks.max()) + 1
    rng = np.random.default_rng(19790101)
    found = []
    for k in range(draws):
        if progress:
            progress(k, draws, "bootstrap")
        times = rng.multinomial(count, np.full(count, 1 / count))
        solution = objective.counting(times[blocks].astype(float)).solve(x[None], reduction=REDUCTION)
        found.append(solution.x[solution.best()])
    if progress:
        progress(draws, draws, "bootstrap")
    return np.stack(found)
