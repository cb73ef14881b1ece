"""What a choice among models is worth, in sentences: the verdict on dust, what else does nearly as well, and what moves between the two."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from motes.fitting.judgement import Judgement
from motes.fitting.ladder import Rung

# A candidate that leaves less than this share more of the blocks left out does nearly as well.
NEARLY = 0.1
# A parameter that is another by this share is said to move; so many are listed.
MOVED, MOST_MOVED = 0.1, 3


def about_choice(chosen: Rung, rungs: Sequence[Rung], judgement: Judgement) -> tuple[str, ...]:
    """Sentences on a choice for one scan; none where nothing else comes near and there is no dust."""
    return (*about_dust(judgement), *_rival(chosen, rungs))


def about_dust(judgement: Judgement) -> tuple[str, ...]:
    """The verdict, where it is that there is dust or that the data cannot tell."""
    if judgement.dusty is False or math.isnan(judgement.share):
        return ()
    margin = (
        f"the squared error at directions left out of the fit is {100 * judgement.share:.0f} % of that of the best model without one "
        f"({judgement.errors:.1f} standard errors less)"
    )
    if judgement.dusty:
        return (f"A layer of dust lies on it: with one, {margin}.",)
    return (
        f"The data cannot tell whether dust lies on it: with a layer, {margin}, but its values"
        " are not those of dust, or the difference is not large enough. What was fitted has no layer.",
    )


def _rival(chosen: Rung, rungs: Sequence[Rung]) -> tuple[str, ...]:
    """What does nearly as well, without a layer unless the chosen one has one, and which parameters are other ones in it."""
    own = float(chosen.left_out.sum())
    others = [rung for rung in rungs if rung is not chosen and rung.layered == chosen.layered]
    near = [rung for rung in others if float(rung.left_out.sum()) <= (1 + NEARLY) * own and rung.problem.size > 1]
    if not near or own <= 0:
        return ()
    rival = min(near, key=lambda rung: float(rung.left_out.sum()))
    moved = _moved(chosen, rival)
    shares = [rung.trial().left_out for rung in (rival, chosen)]
    said = f"{rival.text} predicts directions left out nearly as well ({shares[0]:.3g} against {shares[1]:.3g} relative RMS)"
    return (f"{said}: with it {', '.join(moved)}.",) if moved else ()


def _moved(chosen: Rung, rival: Rung) -> list[str]:
    found: list[tuple[float, str]] = []
    theirs = {q.name: q for q in rival.problem.quantities}
    for q in chosen.problem.quantities:
        if q.name in theirs:
            a, b = float(np.mean(chosen.value(q))), float(np.mean(rival.value(theirs[q.name])))
            share = abs(b - a) / max(abs(a), abs(b), 1e-12)
            if share > MOVED:
                found.append((share, f"{q.name} goes from {a:.2g} to {b:.2g}"))
    return [text for _, text in sorted(found, reverse=True)[:MOST_MOVED]]
