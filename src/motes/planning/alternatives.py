r"""Rival models: directions that tell them from the model.

A rival reflects f + d where the model reflects f.  What the model's own parameters cannot mimic of d is what shows: with d as one more column of
the derivatives, a switch from the model to the rival, its information with all parameters free is det(M, d) / det(M).  To maximise it
is T-optimality (Atkinson, Fedorov 1975) for models that are nearly straight over their error bars.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motes.models import describe
from motes.parameters import Role
from motes.planning.believed import within
from motes.planning.information import Noise, Subject

Floats = NDArray[np.float64]
#: A rival's highlight, or dust, is there by this share of the range that real materials span: what is strong shows anyhow.
FAINT = 0.15
_HOW_MUCH = (Role.HIGHLIGHT_STRENGTH, Role.DEPTH)


def usual_rivals(subject: Subject) -> tuple[str, ...]:
    """What a fit with ``model="auto"`` would have to tell from the model: a highlight and dust, where it has none."""
    roles = {slot.parameter.role for slot in subject.brdf.slots()}
    text = describe(subject.brdf)
    found = [] if Role.HIGHLIGHT_STRENGTH in roles else [f"{text} + torrance_sparrow"]
    return (*found, *(() if Role.DEPTH in roles else (f"dust_layer({text})",)))


def with_switch(subject: Subject, values: Floats, rival: Subject, wi: Floats, wo: Floats, noise: Noise) -> Floats:
    """Rows (B, N, P + 1) of the model at materials with values (B, P), with a switch to the rival as the last column.

    What rival and model have in common by name has the model's values in both.
    """
    f, slopes = subject.derivatives(values, wi, wo)
    own = {name: values[:, k] for k, name in enumerate(subject.names)}
    theirs = [
        own[q.name]
        if q.name in own
        else within(q, np.full(len(values), FAINT if q.parameter.role in _HOW_MUCH else 0.5))
        for q in rival.quantities
    ]
    other, _ = rival.derivatives(rival.inside(np.stack(theirs, axis=1)), wi, wo)
    rows = np.concatenate([slopes, (other - f)[..., None]], axis=2)
    return np.asarray(rows / noise.deviation(f, wi[:, 2])[..., None])
