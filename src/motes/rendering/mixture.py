"""A BRDF at many places at once over Dr.Jit: its lobes as a mixture that is sampled, with the density of the whole.

Mitsuba's ``si.wi`` points to the viewer and its ``wo`` to the light.  The models here are reciprocal, so they are
evaluated with the two as they are.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from motes.arrays import Array, Columns
from motes.directions import Geometry, Vector
from motes.models import Lobe
from motes.rendering.beforehand import Numbers
from motes.rendering.textures import Found

# Where chances are computed: towards grazing those of a dust layer go to those of opaque dust.
SMALLEST_COSINE = 1e-4
_NOTHING = 1e-30  # so that a black surface has chances too


def lift(xp: Any, x: Any) -> Array:
    """A value of Dr.Jit in a namespace of `Found`."""
    return xp.differing(x) if isinstance(xp, Numbers) else x


def known(xp: Any, x: Any, number: Array) -> Array:
    """A number that is the same at every hit, or one for each channel, in such a namespace: `x` is the same as a value of Dr.Jit."""
    return xp.known(number if len(number) > 1 else number[0]) if isinstance(xp, Numbers) else x


def lower(xp: Any, x: Array) -> Any:
    """A value of such a namespace in Dr.Jit."""
    return xp.found(x) if isinstance(xp, Numbers) else x


def columns(xp: Any, w: Any) -> Columns:
    """A direction of Dr.Jit in such a namespace."""
    return Columns(lift(xp, x) for x in (w.x, w.y, w.z))


class Mixture:
    """The parts of a BRDF that a context enables, each with its chance of being sampled.

    Parameters
    ----------
    found
        The model with its values.
    wi
        Local direction (Vector3f) that is given when the other is sampled.
    enabled
        Positions of the parts to keep.
    """

    def __init__(self, found: Found, wi: Any, enabled: Sequence[int]) -> None:
        import drjit as dr

        self.xp, self.model, self.enabled = found.xp, found.model, list(enabled)
        self._fixed = columns(self.xp, wi)
        cosine = self.xp.maximum(lift(self.xp, dr.detach(wi.z)), SMALLEST_COSINE)
        parts = found.averaged.components(self.xp, cosine)
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
        geometry = Geometry(self.xp, Vector(*self._fixed), Vector(*columns(self.xp, wo)))
        if self._whole:
            return lower(self.xp, self.model.formula(self.xp, geometry))
        parts = self.model.components(self.xp, 1.0)
        total: Array = 0.0
        for k in self.enabled:
            total = total + parts[k].formula(self.xp, geometry)
        return lower(self.xp, total)

    def pdf(self, wo: Any) -> Array:
        """The density of `sample` [1/sr]; what it says below the horizon is meaningless."""
        chosen = columns(self.xp, wo)
        total: Array = 0.0
        for lobe, chance, _ in self._lobes:
            total = total + chance * lobe.pdf(self.xp, self._fixed, chosen)
        return lower(self.xp, total)

    def sample(self, which: Array, u: Any) -> tuple[Columns, Array]:
        """A direction, and which of the enabled parts it came from: ``which`` chooses the part, ``u`` the direction."""
        xp, numbers, which = self.xp, Columns(lift(self.xp, x) for x in (u.x, u.y)), lift(self.xp, which)
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
        return Columns(lower(xp, x) for x in wo), lower(xp, part)
