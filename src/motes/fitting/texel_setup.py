"""What a fit of texels is asked for, checked, and what its vectors hold."""

from __future__ import annotations

import copy
import math
from collections.abc import Collection, Mapping
from functools import cached_property
from typing import Any, NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike

from motes.directions import above
from motes.errors import DataError, MotesError
from motes.fitting import joint
from motes.fitting.columns import STRENGTHS, Columns, in_own_units, unit_between
from motes.fitting.joint import Part
from motes.fitting.losses import LOSSES, Floats, loss_named, robust_named
from motes.fitting.quantities import Quantity, columns_for
from motes.fitting.setup import fitted_of
from motes.kernels.cards import Device
from motes.kernels.cards import device as device_named
from motes.models import BRDF
from motes.parameters import Parameter, Role
from motes.trends import KINDS


class Column(NamedTuple):
    """What a column of a parameter vector holds: a quantity, for a channel or all (None), and with trends which coefficient of its trend.

    `value` says whether it is a value of the parameter (with trends: not a time or a share).
    """

    quantity: str
    channel: int | None
    coefficient: str | None
    parameter: Parameter
    value: bool


class TexelSetup:
    """A model, its data's directions, times and weights, and the layout of parameter vectors; see `motes.fitting.texels.TexelSolver`."""

    def __init__(
        self,
        model: str | BRDF,
        wi: ArrayLike,
        wo: ArrayLike,
        channels: int,
        *,
        hours: ArrayLike | None = None,
        trends: Mapping[str, str] | None = None,
        loss: str = "linear",
        robust: str = "none",
        weights: ArrayLike | None = None,
        fixed: Collection[str] | Mapping[str, Any] = (),
        per_channel: Collection[str] = (),
        device: str | Device | None = None,
    ) -> None:
        self.device = device_named(device) if isinstance(device, str) else device
        self.wi, self.wo = _directions(wi, wo)
        self.channels = channels
        self.loss, self.robust = loss_named(loss), robust_named(robust)
        if channels < 1:
            raise DataError(f"{channels} channels", "A texel has at least one")
        asked = fitted_of(model, channels, fixed, per_channel)
        self.brdf, self.quantities = asked.brdf, asked.quantities
        self.weights = _weights(weights, len(self.wi))
        self.hours, self.parts = _parts(self.quantities, hours, trends)
        #: That of the data, `motes.fitting.columns.unit_of`.
        self.unit = 1.0

    # ------------------------------------------------------------ what is fitted

    @property
    def times(self) -> int | None:
        """The number of times that are fitted together; None without trends."""
        return None if self.hours is None else len(self.hours)

    @cached_property
    def columns(self) -> tuple[Column, ...]:
        """What the columns of the parameter vectors hold."""
        return _columns(self.quantities, self.parts)

    @cached_property
    def facts(self) -> Columns:
        """Bounds and ranges of the columns, in the coordinates that a fit moves in."""
        return joint.columns_for(self.parts, self.unit) if self.parts else columns_for(self.quantities, self.unit)

    @property
    def groups(self) -> list[slice]:
        """The columns of each parameter; of a parameter that changes none."""
        return joint.groups_for(self.parts) if self.parts else [q.where for q in self.quantities]

    @property
    def size(self) -> int:
        """The number of columns, P."""
        return len(self.columns)

    @cached_property
    def bounds(self) -> tuple[Floats, Floats]:
        """Lower and upper bounds (P,) of the parameters."""
        return self.values(self.facts.low[:, 0]), self.values(self.facts.high[:, 0])

    def unit_of_starts(self, starts: Floats) -> float:
        """The unit of the data that fits from `starts` (K, P) are of: what these say of the strengths."""
        free = [k for k, c in enumerate(self.columns) if c.value and c.parameter.fit_bounds[1] == math.inf]
        strengths = [k for k in free if self.columns[k].parameter.role in STRENGTHS]
        if not strengths:
            return 1.0
        diffuse = [k for k in strengths if self.columns[k].parameter.role is Role.DIFFUSE_COLOUR]
        most = float(np.median(starts[:, strengths].max(axis=1)))
        return unit_between(most, float(np.median(starts[:, diffuse or strengths].mean(axis=1))))

    def in_units(self, unit: float) -> Self:
        """The same for data of such a unit."""
        if unit == self.unit:
            return self
        other = copy.copy(self)
        other.unit, other.loss = unit, self.loss.of_unit(unit)
        for name in ("facts", "_kernels", "_recorded", "_compared", "_bands", "linear"):  # what was made for this unit
            other.__dict__.pop(name, None)
        return other

    @cached_property
    def linear(self) -> Self:
        """The same under a loss that is linear in the BRDF, as this one where it is: which valley is nearest, both see alike."""
        if self.loss.is_linear:
            return self
        other = copy.copy(self)
        other.loss = LOSSES["linear"]
        return other

    @property
    def size_of_residuals(self) -> float:
        """What residuals are divided by, so that products of four of them are numbers in single precision."""
        return float(
            self.loss.transform(np.array(self.unit), np.ones(())) / self.loss.transform(np.ones(()), np.ones(()))
        )

    def coordinates(self, x: Floats) -> Floats:
        """What a fit moves in (..., P), a new array: the square of a parameter where the model depends on nothing else."""
        result = np.array(x, np.float64)
        squared = self.facts.squared[:, 0] > 0
        result[..., squared] *= result[..., squared]
        return result

    def within(self, x: Floats) -> Floats:
        """The same, within the bounds of the fit, of points (M, P)."""
        result = self.coordinates(x)
        for column, low, high in zip(result.T, self.facts.low[:, 0], self.facts.high[:, 0], strict=True):
            np.clip(column, low, high, out=column)  # NumPy takes short rows one by one
        return result

    def values(self, points: Floats) -> Floats:
        """The reverse of `coordinates`."""
        return in_own_units(points, self.facts)


def _columns(quantities: tuple[Quantity, ...], parts: tuple[Part, ...]) -> tuple[Column, ...]:
    """The columns of a texel's vector."""
    columns: list[Column] = []
    for q, part in zip(quantities, parts or [None] * len(quantities), strict=True):
        own: list[int | None] = list(range(q.where.stop - q.where.start)) if q.per_channel else [None]
        if part is None:
            columns += [Column(q.name, c, None, q.parameter, True) for c in own]
            continue
        for k in KINDS[part.kind].coefficients:
            columns += [Column(q.name, c, k.name, q.parameter, not k.bounds) for c in ([None] if k.bounds else own)]
    return tuple(columns)


def _directions(wi: ArrayLike, wo: ArrayLike) -> tuple[Floats, Floats]:
    """Unit vectors (D, 3), all above the horizon."""
    pair = []
    for name, w in (("wi", wi), ("wo", wo)):
        array = np.ascontiguousarray(w, np.float64)
        if array.ndim != 2 or array.shape[1] != 3 or not len(array):
            raise DataError(f"{name} has shape {array.shape}", "Pass directions (D, 3)")
        off = np.abs(np.linalg.norm(array, axis=1) - 1)
        if not (off < 1e-3).all():
            raise DataError(
                f"{name} holds a vector of length {np.linalg.norm(array[np.argmax(off)]):.4g}, not 1", "Normalise it"
            )
        if not above(array).all():
            raise DataError(
                f"{int(np.count_nonzero(~above(array)))} direction(s) of {name} are at or below the horizon",
                "Leave them out",
            )
        pair.append(array / np.linalg.norm(array, axis=1, keepdims=True))
    if len(pair[0]) != len(pair[1]):
        raise DataError(f"{len(pair[0])} directions wi and {len(pair[1])} directions wo", "They come in pairs")
    return pair[0], pair[1]


def _weights(weights: ArrayLike | None, count: int) -> Floats:
    """Of the directions, with mean 1."""
    given = np.ones(count) if weights is None else np.asarray(weights, float)
    if given.shape != (count,) or not np.isfinite(given).all() or (given < 0).any() or not given.any():
        raise DataError(f"weights of shape {given.shape} do not fit", f"Give {count} numbers >= 0, not all 0")
    return np.asarray(given / given.mean())


def _parts(
    quantities: tuple[Quantity, ...], hours: ArrayLike | None, trends: Mapping[str, str] | None
) -> tuple[Floats | None, tuple[Part, ...]]:
    """Times, and the trend of each quantity; nothing for one time."""
    if hours is None:
        if trends:
            raise DataError("trends need the times of the data", "Pass hours=")
        return None, ()
    times = np.asarray(hours, float)
    trends = trends or {}
    if times.ndim != 1 or len(times) < 2 or not (np.diff(times) > 0).all() or not np.isfinite(times).all():
        raise DataError(
            f"hours {np.array2string(times, threshold=6)} do not go forward", "Give two or more rising times"
        )
    names = [q.name for q in quantities]
    for name, kind in trends.items():
        if name not in names:
            raise MotesError(f"no fitted parameter {name!r} to have a trend", f"Those fitted are {', '.join(names)}")
        if kind not in KINDS:
            raise MotesError(f"trend {kind!r} is not one of {', '.join(KINDS)}", "Name one of them")
    interval = (float(times[0]), float(times[-1]))
    if math.isclose(*interval):
        raise DataError("all hours are the same", "Fit without trends")
    return times, tuple(Part(q, trends.get(q.name, "constant"), interval) for q in quantities)
