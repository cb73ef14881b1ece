"""Highlights, of whatever model: one where there is none, and how high they are."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.arrays import NUMPY
from motes.models import BRDF, Reflection, on_base
from motes.models.standard import MEAN_COSINE
from motes.parameters import Parametrised, Role, Slot


def with_highlight(brdf: BRDF, lobe: BRDF) -> tuple[BRDF, bool]:
    """The BRDF, with `lobe` added under any dust when it has no highlight of its own; and whether it was added."""
    if brdf.slots(Role.HIGHLIGHT_STRENGTH, Role.HIGHLIGHT_WIDTH):
        return brdf, False
    return on_base(brdf, lambda base: base + lobe), True


def heights(brdf: BRDF, strength: Slot, width: Any = None) -> NDArray[np.float64]:
    """How high a highlight of strength 1 is, compared to equation (10) with D(0) = 1, where F = 1.

    Some models' strengths are the height of the highlight, some are its energy: then a narrower one is higher.  Phenomena speak of
    heights.

    Parameters
    ----------
    strength
        One of the parameters of `brdf`.
    width
        Of the highlight, in the place of its own.

    Returns
    -------
    array () or (C,)
        1 for a model that does not say what it is as a standard lobe.

    Notes
    -----
    A facet distribution of GGX, or Beckmann's, has D(0) = 1/(pi alpha^2), and reflects the standard lobe's reflectance.
    """
    part: Parametrised = brdf
    for name in strength.path[:-1]:
        part = part.children()[name]
    if not isinstance(part, BRDF):
        return np.ones(())
    changes: dict[str, Any] = {strength.path[-1]: 1.0}
    own = next((p.name for p in part.declared() if p.role is Role.HIGHLIGHT_WIDTH), None)
    if width is not None and own is not None:
        changes[own] = width
    unit = part.with_parameters(changes)
    found = [lobe for lobe in unit.standard_lobes(NUMPY, unit, MEAN_COSINE) if lobe.reflection is Reflection.GLOSSY]
    if not found:
        return np.ones(())
    return np.asarray(found[0].reflectance, np.float64) / (
        np.pi * np.square(np.asarray(found[0].roughness, np.float64))
    )
