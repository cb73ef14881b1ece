"""Whether a highlight rises towards grazing as only a Fresnel term does, and the fitted model has none."""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

from motes.arrays import any_last
from motes.directions import half_vectors_within
from motes.fitting.result import Fit
from motes.fitting.time_result import TimeFit
from motes.models import BRDF, describe
from motes.parameters import Place, Role

Floats = NDArray[np.float64]
OUTERMOST = " Most of the squared error lies beyond 80 degrees, where a fit follows nothing else: --max-theta-deg 80 leaves that out."
# Samples whose half vector is as near to the normal are near the mirror direction.
NEAR = np.radians(12)
# Angles of incidence on the facets, in which they are summed (beyond them no measurement can be trusted); those beyond `LAST` are grazing, and fewer samples
# say nothing.
EDGES, LAST, FEWEST = np.radians((0, 30, 45, 60, 70, 80)), np.radians(60), 4
# By how much measured over fitted grows from the steepest angle to the most grazing one.
RISE = 1.5


def without_fresnel(brdf: BRDF) -> bool:
    """Whether there are highlights, all of which could take a Fresnel term and have none."""
    highlights = _highlights(brdf)
    places = [{p.name for p in part.declared_parts() if p.place is Place.FRESNEL} for part in highlights]
    return bool(highlights) and all(
        own and not part.at_place(Place.FRESNEL) for part, own in zip(highlights, places, strict=True)
    )


def missing_fresnel(fit: Fit | TimeFit) -> list[str]:
    """A sentence that names the option, where a model that was asked for by name lacks the term; `auto` has looked at others itself."""
    if len(fit.tried) > 1 or not without_fresnel(fit.brdf):
        return []
    angles, ratio = by_angle(fit)
    if len(ratio) < 3 or angles[-1] < LAST or not (ratio[-1] >= RISE * ratio[0] and ratio[-1] >= 0.95 * ratio.max()):
        return []
    name = describe(type(_highlights(fit.brdf)[0])())
    degrees = np.degrees(angles)
    return [
        f"The highlight rises towards grazing faster than the model: near the mirror direction measured over fitted goes from {ratio[0]:.2g} at "
        f"{degrees[0]:.0f} degrees to {ratio[-1]:.2g} at {degrees[-1]:.0f}. A Fresnel term rises so: {name}(fresnel=schlick) in place of {name}."
        + (OUTERMOST if _share_beyond(fit) > 0.5 else "")
    ]


def by_angle(fit: Fit | TimeFit) -> tuple[Floats, Floats]:
    """Near the mirror direction: mean angles of incidence on the facets (k,), from steep to grazing, and the sum of what was measured over that of the fit."""
    data = fit.measurement
    near = np.flatnonzero(half_vectors_within(NEAR, data.wi, data.wo))
    wi, wo = data.wi[near], data.wo[near]
    theta_d = np.arctan2(np.linalg.norm(wi - wo, axis=1), np.linalg.norm(wi + wo, axis=1))
    fitted = np.broadcast_to(fit.predicted, data.values.shape)
    used, cosines = data.mask[:, near], wi[:, 2]
    measured, modelled = (
        np.einsum("tnc->n", np.where(used, part[:, near], 0.0)) * cosines for part in (data.values, fitted)
    )
    some = any_last(used).any(axis=0)
    angles, ratio = [], []
    for low, high in itertools.pairwise(EDGES):
        rows = some & (theta_d >= low) & (theta_d < high)
        total = float(modelled[rows].sum())
        if np.count_nonzero(rows) >= FEWEST and total > 0:
            angles.append(float(theta_d[rows].mean()))
            ratio.append(float(measured[rows].sum()) / total)
    return np.array(angles), np.array(ratio)


def _share_beyond(fit: Fit | TimeFit) -> float:
    """How much of the squared error lies at directions beyond the last of `EDGES`."""
    data = fit.measurement
    square = np.where(data.mask, ((data.values - fit.predicted) * data.wi[:, 2:3]) ** 2, 0.0).sum(axis=(0, 2))
    beyond = np.minimum(data.wi[:, 2], data.wo[:, 2]) < np.cos(EDGES[-1])
    return float(square[beyond].sum() / max(float(square.sum()), 1e-300))


def _highlights(brdf: BRDF) -> list[BRDF]:
    parts = [part for part in brdf.walk() if isinstance(part, BRDF)]
    return [part for part in parts if any(p.role is Role.HIGHLIGHT_STRENGTH for p in part.declared())]
