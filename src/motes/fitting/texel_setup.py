"""What a fit of texels is asked for, checked, and what its vectors hold."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from motes.errors import DataError, MotesError
from motes.fitting.columns import Columns, columns_of
from motes.fitting.joint import Part
from motes.fitting.losses import Floats, loss_named, robust_named
from motes.fitting.problem import Quantity, layout
from motes.models import BRDF, describe, parse
from motes.parameters import Parameter
from motes.trends import KINDS


class Column(NamedTuple):
    """What a column of a parameter vector holds: a quantity, for a channel or all (None), and with trends which coefficient of its trend.

    `value` says whether it is a value of the parameter (with trends: not a time or a share), `squared` whether fits move in its square.
    """

    quantity: str
    channel: int | None
    coefficient: str | None
    parameter: Parameter
    value: bool
    squared: bool


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
    ) -> None:
        self.wi, self.wo = _directions(wi, wo)
        self.channels = channels
        self.loss, self.robust = loss_named(loss), robust_named(robust)
        self.brdf, self.quantities = _fitted(model, channels, fixed, per_channel)
        self.weights = _weights(weights, len(self.wi))
        self.hours, self.parts = _parts(self.quantities, hours, trends)

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
        return _facts(self.columns, self.quantities, self.parts)

    @property
    def size(self) -> int:
        """The number of columns, P."""
        return len(self.columns)

    @cached_property
    def bounds(self) -> tuple[Floats, Floats]:
        """Lower and upper bounds (P,) of the parameters."""
        return self.values(self.facts.low[:, 0]), self.values(self.facts.high[:, 0])

    def coordinates(self, x: Floats) -> Floats:
        """What a fit moves in (..., P), a new array: the square of a parameter where the model depends on nothing else."""
        result = np.array(x, np.float64)
        squared = self.facts.squared[:, 0] > 0
        result[..., squared] *= result[..., squared]
        return result

    def values(self, points: Floats) -> Floats:
        """The reverse of `coordinates`."""
        return np.where(self.facts.squared[:, 0] > 0, np.sqrt(np.maximum(points, 0)), points)


def _columns(quantities: tuple[Quantity, ...], parts: tuple[Part, ...]) -> tuple[Column, ...]:
    """The columns of a texel's vector."""
    columns: list[Column] = []
    for q, part in zip(quantities, parts or [None] * len(quantities), strict=True):
        own: list[int | None] = list(range(q.where.stop - q.where.start)) if q.per_channel else [None]
        if part is None:
            columns += [Column(q.name, c, None, q.parameter, True, q.parameter.squared) for c in own]
            continue
        for k in KINDS[part.kind].coefficients:
            columns += [
                Column(q.name, c, k.name, q.parameter, not k.bounds, part.squared)
                for c in ([None] if k.bounds else own)
            ]
    return tuple(columns)


def _facts(columns: tuple[Column, ...], quantities: tuple[Quantity, ...], parts: tuple[Part, ...]) -> Columns:
    """Bounds and ranges of a texel's columns, in the coordinates of a fit."""
    if parts:
        pairs = [part.bounds() for part in parts]
        low, high = np.concatenate([p[0] for p in pairs]), np.concatenate([p[1] for p in pairs])
    else:
        spans = [q.bounds for q in quantities for _ in range(q.where.stop - q.where.start)]
        low, high = np.array([s[0] for s in spans], float), np.array([s[1] for s in spans], float)
    declared = [c.parameter if c.value else None for c in columns]
    return columns_of(declared, low, high, squared=[c.squared for c in columns])


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
        if not (array[:, 2] > 0).all():
            raise DataError(
                f"{int(np.count_nonzero(array[:, 2] <= 0))} direction(s) of {name} are at or below the horizon",
                "Leave them out",
            )
        pair.append(array / np.linalg.norm(array, axis=1, keepdims=True))
    if len(pair[0]) != len(pair[1]):
        raise DataError(f"{len(pair[0])} directions wi and {len(pair[1])} directions wo", "They come in pairs")
    return pair[0], pair[1]


def _fitted(
    model: str | BRDF, channels: int, fixed: Collection[str] | Mapping[str, Any], per_channel: Collection[str]
) -> tuple[BRDF, tuple[Quantity, ...]]:
    """The model, and what is fitted of it."""
    brdf, held = (model, frozenset[str]()) if isinstance(model, BRDF) else parse(model)
    names = [slot.name for slot in brdf.slots()]
    for name in (*fixed, *per_channel):
        if name not in names:
            raise MotesError(f"{describe(brdf)} has no parameter {name!r}", f"It has {', '.join(names)}")
    if isinstance(fixed, Mapping):
        brdf = brdf.with_parameters(dict(fixed))
    quantities = layout(brdf, channels, held | frozenset(fixed), frozenset(per_channel))
    if not quantities:
        raise MotesError(
            f"every parameter of {describe(brdf)} is held, so there is nothing to fit", "Hold fewer parameters"
        )
    if channels < 1:
        raise DataError(f"{channels} channels", "A texel has at least one")
    return brdf, quantities


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
            raise MotesError(f"trend {kind!r} is not one of {', '.join(KINDS)}")
    interval = (float(times[0]), float(times[-1]))
    if math.isclose(*interval):
        raise DataError("all hours are the same", "Fit without trends")
    return times, tuple(Part(q, trends.get(q.name, "constant"), interval) for q in quantities)
