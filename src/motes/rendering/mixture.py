"""A BRDF at many places at once over Dr.Jit: its lobes as a mixture that is sampled, with the density of the whole.

Mitsuba's ``si.wi`` points to the viewer and its ``wo`` to the light.  The models here are reciprocal, so they are
evaluated with the two as they are.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from motes import arrays
from motes.arrays import Array, Columns
from motes.directions import Geometry, Vector
from motes.models import BRDF, Lobe

# Where chances are computed: towards grazing those of a dust layer go to those of opaque dust.
SMALLEST_COSINE = 1e-4
_NOTHING = 1e-30  # so that a black surface has chances too


class Mixture:
    """The parts of a BRDF that a context enables, each with its chance of being sampled.

    Parameters
    ----------
    model, averaged
        With Dr.Jit values: per channel, and means over the channels without gradients.
    wi
        Local direction (Vector3f) that is given when the other is sampled.
    enabled
        Positions of the parts to keep.
    """

    def __init__(self, model: BRDF, averaged: BRDF, wi: Any, enabled: Sequence[int]) -> None:
        import drjit as dr

        self.xp = arrays.namespace(wi)
        self.model, self.wi, self.enabled = model, wi, list(enabled)
        self._fixed = Columns((wi.x, wi.y, wi.z))
        cosine = self.xp.maximum(dr.detach(wi.z), SMALLEST_COSINE)
        parts = averaged.components(self.xp, cosine)
        self._whole = len(self.enabled) == len(parts)
        total: Array = 0.0
        for k in self.enabled:
            total = total + (parts[k].importance + _NOTHING)
        # Lobes with their chances, and which part each belongs to.
        self._lobes: list[tuple[Lobe, Array, int]] = []
        for position, k in enumerate(self.enabled):
            chance = (parts[k].importance + _NOTHING) / total if len(self.enabled) > 1 else 1.0
            for lobe, share in parts[k].lobe.shared(self.xp, cosine):
                self._lobes.append((lobe, chance * share, position))

    def value(self, wo: Any) -> Array:
        """The BRDF [1/sr] of the enabled parts; what it says below the horizon is meaningless."""
        geometry = Geometry(self.xp, Vector(self.wi.x, self.wi.y, self.wi.z), Vector(wo.x, wo.y, wo.z))
        if self._whole:
            return self.model.formula(self.xp, geometry)
        parts = self.model.components(self.xp, 1.0)
        total: Array = 0.0
        for k in self.enabled:
            total = total + parts[k].formula(self.xp, geometry)
        return total

    def pdf(self, wo: Any) -> Array:
        """The density of `sample` [1/sr]; what it says below the horizon is meaningless."""
        chosen = Columns((wo.x, wo.y, wo.z))
        total: Array = 0.0
        for lobe, chance, _ in self._lobes:
            total = total + chance * lobe.pdf(self.xp, self._fixed, chosen)
        return total

    def sample(self, which: Array, u: Any) -> tuple[Columns, Array]:
        """A direction, and which of the enabled parts it came from: ``which`` chooses the part, ``u`` the direction."""
        xp, numbers = self.xp, Columns((u.x, u.y))
        start: Array = 0.0
        wo, part = None, 0
        for lobe, chance, position in self._lobes:
            candidate = lobe.sample(xp, self._fixed, numbers)
            if wo is None:
                wo = candidate
            else:
                later = which >= start
                wo = Columns(xp.where(later, new, old) for new, old in zip(candidate, wo, strict=True))
                part = xp.where(later, position, part)
            start = start + chance
        assert wo is not None
        return wo, part
