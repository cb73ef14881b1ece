"""What a run over a map was asked for, checked, and what tells that two runs are the same."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Collection, Mapping
from dataclasses import asdict, dataclass, fields, replace
from typing import Any, Self, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.directions import HALF_PI, HORIZON
from motes.errors import DataError, MotesError
from motes.fitting.choice import TEXEL_CANDIDATES, check_names, is_auto
from motes.fitting.losses import loss_named, robust_named
from motes.fitting.texels import TexelSolver
from motes.maps.blocks import Blocks
from motes.maps.stack import MapStack, Singles
from motes.models import BRDF, describe, parse
from motes.trends import KINDS

SAMPLED_BLOCKS, SAMPLED_TEXELS = 16, 6
#: Solvers that are kept: those of the candidates of ``"auto"``.
MOST_SOLVERS = 5
_solvers: dict[tuple[str, str], TexelSolver] = {}


@final
@dataclass(frozen=True)
class Settings:
    """What was asked for; a run is resumed only with the same.

    `time` is the one time that is fitted of several, from 0; None for all.  `weights` are ``"measurement"``, ``"uniform"``, or numbers (D,).
    What an earlier Motes did not have follows at the end, with the value that it stands for.
    """

    source: str
    model: str
    loss: str
    trends: dict[str, str] | None
    fixed: dict[str, Any]
    per_channel: list[str]
    weights: str | list[float]
    max_theta: float | None
    block: list[int]
    data: dict[str, Any]
    motes: str
    robust: str = "none"
    time: int | None = None
    covariance: bool = False

    @classmethod
    def of(
        cls,
        stack: MapStack,
        model: str | BRDF,
        *,
        loss: str = "linear",
        robust: str = "none",
        trends: Mapping[str, str] | None = None,
        time: int | None = None,
        fixed: Collection[str] | Mapping[str, Any] = (),
        per_channel: Collection[str] = (),
        weights: str | ArrayLike = "measurement",
        max_theta: float | None = None,
        covariance: bool = False,
    ) -> Self:
        """The settings with names checked and the identity of the data; arguments as for `motes.maps.fit_map`."""
        from motes.version import __version__

        loss_named(loss), robust_named(robust)
        if max_theta is not None and not 0 < max_theta <= HALF_PI:
            raise DataError(
                f"max_theta = {max_theta:.4g} is outside (0, 1.571] rad", "Angles are in radians: 80 degrees is 1.396"
            )
        _check_times(stack, time, trends)
        text, held = _checked_model(model, fixed, per_channel, trends or {})
        return cls(
            source=str(stack.path.resolve()),
            model=text,
            loss=loss,
            trends=None if trends is None else dict(trends),
            fixed={name: np.asarray(value, float).tolist() for name, value in held.items()},
            per_channel=sorted(_names(per_channel)),
            weights=_checked_weights(weights, len(stack.wi)),
            max_theta=max_theta,
            block=list(stack.blocks.block),
            data=_identity(stack),
            motes=__version__,
            robust=robust,
            time=time,
            covariance=covariance,
        )

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Self:
        """As they were stored; what an earlier Motes did not have is what it stands for."""
        return cls(**data)

    def differs(self, other: Mapping[str, Any]) -> str:
        """The first setting in which another run, as it was stored, differs; empty when none does."""
        earlier = {f.name: f.default for f in fields(self) if f.name not in other}
        for name, value in json.loads(json.dumps(asdict(self))).items():
            was = other.get(name, earlier.get(name))
            if name not in ("data", "source") and was != value:
                return f"{name} was {json.dumps(was)} and is {json.dumps(value)}"
        mine, theirs = self.data, other.get("data") or {}
        if {k: v for k, v in mine.items() if k != "samples"} != {k: v for k, v in theirs.items() if k != "samples"}:
            return "the map's shape, directions, times or channels changed"
        # A block that could not be read then, or now, says nothing.
        was, now = theirs.get("samples") or {}, mine["samples"]
        if any(was[k] != now[k] for k in was.keys() & now.keys()):
            return "the measured values changed"
        return ""

    def for_model(self, text: str) -> Self:
        """The settings without names that a model does not have: a model that was chosen need not have them all."""
        names = parse(text).model.parameters
        return replace(
            self,
            fixed={name: value for name, value in self.fixed.items() if name in names},
            per_channel=[n for n in self.per_channel if n in names],
            trends=None if self.trends is None else {n: kind for n, kind in self.trends.items() if n in names},
        )


def with_block(stack: MapStack, block: tuple[int, int] | None) -> MapStack:
    """The same map in blocks of so many texels."""
    if block is None:
        return stack
    if min(block) < 1:
        raise DataError(f"blocks of {block[0]} x {block[1]} texels", "Both are at least 1")
    shape = stack.shape
    return replace(stack, blocks=Blocks(shape, (min(block[0], shape[0]), min(block[1], shape[1]))))


def weights_used(stack: MapStack, settings: Settings) -> NDArray[np.float64] | None:
    """Of all directions (D,); None for all alike."""
    if isinstance(settings.weights, list):
        return np.array(settings.weights)
    return stack.weights if settings.weights == "measurement" else None


def directions_used(stack: MapStack, settings: Settings) -> NDArray[np.bool_]:
    """Directions above the horizon, and within max_theta."""
    lowest = np.minimum(stack.wi[:, 2], stack.wo[:, 2])
    used = lowest > HORIZON
    if settings.max_theta is not None:
        used &= lowest >= np.cos(settings.max_theta)
    weights = weights_used(stack, settings)
    if weights is not None:
        used &= weights > 0
    if not used.any():
        raise DataError(f"none of the {len(used)} directions is above the horizon and used", "Check wi and wo")
    return used


def solver_of(stack: MapStack, settings: Settings, model: str) -> TexelSolver:
    """The solver for the directions that are used; the one that was made last where the same is asked for again.

    The texels that starts are found on and those of the map are fitted by one solver then, whose kernels are printed and loaded once.
    """
    used, weights = directions_used(stack, settings), weights_used(stack, settings)
    tables = [stack.wi[used], stack.wo[used], *([] if weights is None else [weights[used]])]
    numbers = b"".join(np.ascontiguousarray(table, np.float64).tobytes() for table in tables)
    hours = None if settings.trends is None else stack.hours.tolist()
    asked = asdict(replace(settings, source="", data={}, model=model))
    key = hashlib.sha256(numbers).hexdigest(), json.dumps([asked, hours, len(stack.channels), weights is None])
    if key not in _solvers:
        while len(_solvers) >= MOST_SOLVERS:
            _solvers.pop(next(iter(_solvers)), None)
        _solvers[key] = _solver(stack, settings, model, used, weights)
    return _solvers[key]


def _solver(
    stack: MapStack,
    settings: Settings,
    model: str,
    used: NDArray[np.bool_],
    weights: NDArray[np.float64] | None,
) -> TexelSolver:
    return TexelSolver(
        model,
        stack.wi[used],
        stack.wo[used],
        len(stack.channels),
        hours=None if settings.trends is None else stack.hours,
        trends=settings.trends,
        loss=settings.loss,
        robust=settings.robust,
        weights=None if weights is None else weights[used],
        fixed=settings.fixed,
        per_channel=settings.per_channel,
    )


def sampled(stack: MapStack) -> dict[str, Singles]:
    """Some texels (m, T, D, C) of blocks from all over the map, by block; those that cannot be read are left out."""
    found: dict[str, Singles] = {}
    for block in stack.blocks.spread(SAMPLED_BLOCKS):
        rows, columns = stack.blocks.slices(block)
        height, width = rows.stop - rows.start, columns.stop - columns.start
        k = np.arange(SAMPLED_TEXELS)
        ys = ((k + 0.5) / SAMPLED_TEXELS * height).astype(int)
        xs = ((k * 0.6180339887 + 0.5) % 1 * width).astype(int)
        try:
            values = stack.read_block(block)
        except Exception:  # said when its turn comes
            continue
        found[f"{block[0]},{block[1]}"] = values[ys, xs]
    return found


def _names(given: Collection[str]) -> Collection[str]:
    """One name is a name, not its letters."""
    return (given,) if isinstance(given, str) else given


def _check_times(stack: MapStack, time: int | None, trends: Mapping[str, str] | None) -> None:
    n = len(stack.hours)
    if time is not None and not 0 <= time < n:
        raise DataError(
            f"time {time} is outside 0..{n - 1}: the map has {n} time(s)", "Choose one with --time, or time= in Python"
        )
    if trends is None:
        return
    if isinstance(trends, str):
        raise DataError(
            f"trends = {trends!r}: the kinds of trends are not chosen for maps",
            "Name them, such as --trend K_s=exponential (trends of Python takes a mapping); a fit of one texel chooses them",
        )
    if time is not None or n < 2:
        raise DataError(
            "trends were asked for, and one time has no trend", "Leave out time" if n > 1 else "The map has one time"
        )
    for name, kind in trends.items():
        if kind not in KINDS:
            raise MotesError(f"trend {name}={kind!r} is not one of {', '.join(KINDS)}", "Name one of them")


def _checked_model(
    model: object,
    fixed: Collection[str] | Mapping[str, Any],
    per_channel: Collection[str],
    trends: Mapping[str, str],
) -> tuple[str, dict[str, Any]]:
    """The model as text, and what is held at which values."""
    fixed, per_channel = fixed if isinstance(fixed, Mapping) else _names(fixed), _names(per_channel)
    if isinstance(model, str) and is_auto(model):
        if fixed and not isinstance(fixed, Mapping):
            raise MotesError(
                f"{', '.join(fixed)} is held without a value, and the model is to be chosen",
                "Give each a value: --fix NAME=VALUE, a mapping in Python",
            )
        check_names((*fixed, *per_channel, *trends), TEXEL_CANDIDATES)
        return "auto", dict(fixed) if isinstance(fixed, Mapping) else {}
    if not isinstance(model, (str, BRDF)):
        raise DataError(f"a model of type {type(model).__name__} cannot be fitted", "Give text, or a BRDF")
    brdf = model if isinstance(model, BRDF) else parse(model).model
    values = brdf.parameters
    for name in (*fixed, *per_channel, *trends):
        if name not in values:
            raise MotesError(f"{describe(brdf)} has no parameter {name!r}", f"It has {', '.join(values)}")
    held = dict(fixed) if isinstance(fixed, Mapping) else {name: values[name] for name in fixed}
    return describe(model) if isinstance(model, BRDF) else model, held


def _checked_weights(weights: str | ArrayLike, count: int) -> str | list[float]:
    if isinstance(weights, str):
        if weights not in ("measurement", "uniform"):
            raise MotesError(
                f"weights {weights!r} is not 'measurement' or 'uniform'",
                "Name one of them, or give a weight for each direction",
            )
        return weights
    given = np.asarray(weights, float)
    if given.shape != (count,) or not np.isfinite(given).all() or (given < 0).any():
        raise DataError(
            f"weights of shape {given.shape} do not fit the map's {count} directions", f"Give {count} numbers >= 0"
        )
    found: list[float] = given.tolist()
    return found


def _identity(stack: MapStack) -> dict[str, Any]:
    """What tells one map from another without reading all of it."""
    tables = [stack.wi, stack.wo, stack.hours, np.zeros(0) if stack.weights is None else stack.weights]
    return {
        "shape": list(stack.array.shape),
        "dtype": str(stack.array.dtype),
        "channels": list(stack.channels),
        "tables": hashlib.sha256(b"".join(np.ascontiguousarray(t).tobytes() for t in tables)).hexdigest(),
        "samples": {key: hashlib.sha256(v.tobytes()).hexdigest()[:32] for key, v in sampled(stack).items()},
    }
