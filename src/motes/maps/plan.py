"""What a run over a map does at every block: the settings, the starts, and what tells that two runs are the same."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Collection, Mapping
from dataclasses import asdict, dataclass, replace
from functools import cached_property
from typing import Any, Self, final

import numpy as np
from numpy.typing import NDArray

from motes.directions import HALF_PI, HORIZON
from motes.errors import DataError, MotesError
from motes.fitting.losses import loss_named
from motes.fitting.texels import TexelSolver
from motes.maps.blocks import Blocks
from motes.maps.stack import MapStack, Singles, open_stack
from motes.models import BRDF, describe, parse

SAMPLED_BLOCKS, SAMPLED_TEXELS = 16, 6
#: What ``model="auto"`` compares; those of `motes.fit` that one light and viewer a direction can tell apart.
CANDIDATES = (
    "lambert",
    "oren_nayar",
    "lambert + torrance_sparrow",
    "oren_nayar + torrance_sparrow",
)


@final
@dataclass(frozen=True)
class Settings:
    """What was asked for; a run is resumed only with the same."""

    source: str
    model: str
    loss: str
    trends: dict[str, str] | None
    fixed: dict[str, Any]
    per_channel: list[str]
    weights: str
    max_theta: float | None
    block: list[int]
    data: dict[str, Any]
    motes: str

    @classmethod
    def of(
        cls,
        stack: MapStack,
        model: str | BRDF,
        loss: str,
        trends: Mapping[str, str] | None,
        fixed: Collection[str] | Mapping[str, Any],
        per_channel: Collection[str],
        weights: str,
        max_theta: float | None,
    ) -> Self:
        """The settings with names checked and the identity of the data."""
        from motes.version import __version__

        loss_named(loss)
        if weights not in ("measurement", "uniform"):
            raise MotesError(f"weights {weights!r} is not 'measurement' or 'uniform'")
        if max_theta is not None and not 0 < max_theta <= HALF_PI:
            raise DataError(f"max_theta = {max_theta:.4g} is outside (0, 1.571] rad")
        fixed = (fixed,) if isinstance(fixed, str) else fixed
        per_channel = (per_channel,) if isinstance(per_channel, str) else per_channel
        if isinstance(model, str) and model.strip() == "auto":
            if trends:
                raise MotesError("trends were given without a model", "Name the model whose parameters follow them")
            if fixed and not isinstance(fixed, Mapping):
                raise MotesError("parameters to hold need values where the model is chosen", "Give a mapping")
            known = {name: None for candidate in CANDIDATES for name in parse(candidate).model.parameters}
            for name in (*fixed, *per_channel):
                if name not in known:
                    raise MotesError(
                        f"no model that auto tries has a parameter {name!r}", f"They have {', '.join(known)}"
                    )
            text, held = "auto", dict(fixed) if isinstance(fixed, Mapping) else {}
        elif isinstance(model, (str, BRDF)):
            brdf = model if isinstance(model, BRDF) else parse(model).model
            text = describe(model) if isinstance(model, BRDF) else model
            values = brdf.parameters
            names = list(fixed)
            for name in (*names, *per_channel, *(trends or {})):
                if name not in values:
                    raise MotesError(f"{describe(brdf)} has no parameter {name!r}", f"It has {', '.join(values)}")
            held = dict(fixed) if isinstance(fixed, Mapping) else {name: values[name] for name in names}
        else:
            raise DataError(f"a model of type {type(model).__name__} cannot be fitted", "Give text, or a BRDF")
        if trends is not None and len(stack.hours) < 2:
            raise DataError("trends were asked for, and the map has one time", "Leave them out")
        return cls(
            source=str(stack.path.resolve()),
            model=text,
            loss=loss,
            trends=None if trends is None else dict(trends),
            fixed={name: np.asarray(value, float).tolist() for name, value in held.items()},
            per_channel=sorted(per_channel),
            weights=weights,
            max_theta=max_theta,
            block=list(stack.blocks.block),
            data=_identity(stack),
            motes=__version__,
        )

    def differs(self, other: Mapping[str, Any]) -> str:
        """The first setting in which another run, as it was stored, differs; empty when none does."""
        for name, value in json.loads(json.dumps(asdict(self))).items():
            if name not in ("data", "source") and other.get(name) != value:
                return f"{name} was {json.dumps(other.get(name))} and is {json.dumps(value)}"
        mine, theirs = self.data, other.get("data") or {}
        if {k: v for k, v in mine.items() if k != "samples"} != {k: v for k, v in theirs.items() if k != "samples"}:
            return "the map's shape, directions, times or channels changed"
        # A block that could not be read then, or now, says nothing.
        was, now = theirs.get("samples") or {}, mine["samples"]
        if any(was[k] != now[k] for k in was.keys() & now.keys()):
            return "the measured values changed"
        return ""


@final
@dataclass(frozen=True)
class Plan:
    """Everything that fits a block: workers read it from the output, so that a task is no more than a path and two numbers.

    Parameters
    ----------
    settings
        What was asked for.
    model
        The model that is fitted: the one asked for, or the one chosen.
    starts
        Parameter vectors (K, P) that every texel may start from.
    tried
        Of ``model="auto"``: BIC less the best one's, by model.
    """

    settings: Settings
    model: str
    starts: list[list[float]]
    tried: dict[str, float]

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON values."""
        return {"settings": asdict(self.settings), "model": self.model, "starts": self.starts, "tried": self.tried}

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Self:
        """Back from `to_dict`."""
        return cls(Settings(**data["settings"]), data["model"], data["starts"], dict(data["tried"]))

    @classmethod
    def make(cls, stack: MapStack, settings: Settings, extra: BRDF | None = None) -> Self:
        """Choose the model where it is not given, and find the starts, on texels from all over the map."""
        rows = np.concatenate(list(_samples(stack).values()) or [np.empty((0, *stack.sizes), np.float32)])
        if not len(rows):
            raise DataError(f"none of the chunks tried of {stack.path} can be read", "Write the map again")
        used = directions_used(stack, settings)
        rows = np.ascontiguousarray(rows[:, :, used])
        if settings.trends is None:
            # Each texel at one time, the times in turn.
            rows = rows[np.arange(len(rows)), np.arange(len(rows)) % rows.shape[1]]
        texts: tuple[str, ...] = (settings.model,)
        if settings.model == "auto":
            texts = tuple(t for t in CANDIDATES if set(parse(t).model.parameters) - set(settings.fixed))
            if not texts:
                raise MotesError("every parameter is held, so there is nothing to fit", "Hold fewer parameters")
        found: list[tuple[float, str, NDArray[np.float64]]] = []
        for text in texts:
            one = _for_model(settings, text)
            solver = solver_of(stack, one, text)
            starts = solver.starts(rows)
            score = _bic(solver, rows, starts) if len(texts) > 1 else 0.0
            found.append((score, text, starts))
        score, text, starts = min(found, key=lambda f: f[0])
        if extra is not None and settings.trends is None:
            starts = np.concatenate([starts, _vector(solver_of(stack, settings, text), extra)[None]])
        return cls(settings, text, np.asarray(starts, float).tolist(), {t: s - score for s, t, _ in found})

    @cached_property
    def stack(self) -> MapStack:
        """The map that is fitted, in the plan's blocks."""
        stack = open_stack(self.settings.source)
        return with_block(stack, (self.settings.block[0], self.settings.block[1]))

    @cached_property
    def solver(self) -> TexelSolver:
        """The solver of every block."""
        return solver_of(self.stack, self.fitting, self.model)

    @property
    def fitting(self) -> Settings:
        """The settings that the model has a use for."""
        return _for_model(self.settings, self.model)

    @cached_property
    def used(self) -> NDArray[np.bool_]:
        """Directions (D,) that take part."""
        return directions_used(self.stack, self.settings)


def with_block(stack: MapStack, block: tuple[int, int] | None) -> MapStack:
    """The same map in blocks of so many texels."""
    if block is None:
        return stack
    if min(block) < 1:
        raise DataError(f"blocks of {block[0]} x {block[1]} texels", "Both are at least 1")
    shape = stack.shape
    return replace(stack, blocks=Blocks(shape, (min(block[0], shape[0]), min(block[1], shape[1]))))


def directions_used(stack: MapStack, settings: Settings) -> NDArray[np.bool_]:
    """Directions above the horizon, and within max_theta."""
    lowest = np.minimum(stack.wi[:, 2], stack.wo[:, 2])
    used = lowest > HORIZON
    if settings.max_theta is not None:
        used &= lowest >= np.cos(settings.max_theta)
    if stack.weights is not None and settings.weights == "measurement":
        used &= stack.weights > 0
    if not used.any():
        raise DataError(f"none of the {len(used)} directions is above the horizon and used", "Check wi and wo")
    return used


def solver_of(stack: MapStack, settings: Settings, model: str) -> TexelSolver:
    """The solver for the directions that are used."""
    used = directions_used(stack, settings)
    weights = stack.weights[used] if stack.weights is not None and settings.weights == "measurement" else None
    return TexelSolver(
        model,
        stack.wi[used],
        stack.wo[used],
        len(stack.channels),
        hours=None if settings.trends is None else stack.hours,
        trends=settings.trends,
        loss=settings.loss,
        weights=weights,
        fixed=settings.fixed,
        per_channel=settings.per_channel,
    )


def _samples(stack: MapStack) -> dict[str, Singles]:
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


def _identity(stack: MapStack) -> dict[str, Any]:
    """What tells one map from another without reading all of it."""
    tables = [stack.wi, stack.wo, stack.hours, np.zeros(0) if stack.weights is None else stack.weights]
    return {
        "shape": list(stack.array.shape),
        "dtype": str(stack.array.dtype),
        "channels": list(stack.channels),
        "tables": hashlib.sha256(b"".join(np.ascontiguousarray(t).tobytes() for t in tables)).hexdigest(),
        "samples": {key: hashlib.sha256(v.tobytes()).hexdigest()[:32] for key, v in _samples(stack).items()},
    }


def _for_model(settings: Settings, text: str) -> Settings:
    """The settings without names that a model does not have: a model that was chosen need not have them all."""
    names = parse(text).model.parameters
    fixed = {name: value for name, value in settings.fixed.items() if name in names}
    return replace(settings, fixed=fixed, per_channel=[n for n in settings.per_channel if n in names])


def _bic(solver: TexelSolver, rows: Singles, starts: NDArray[np.float64]) -> float:
    """The sum over texels of n log(residual) + P log(n): smaller is better."""
    fit = solver.fit(rows, starts)
    samples = np.isfinite(rows).reshape(len(rows), -1).sum(axis=1)
    good = np.isfinite(fit.relative_rms) & (samples > solver.size)
    residual = np.maximum(fit.relative_rms[good].astype(float), 1e-6)
    n = samples[good]
    return float(np.sum(2 * n * np.log(residual) + solver.size * np.log(n))) if good.any() else np.inf


def _vector(solver: TexelSolver, brdf: BRDF) -> NDArray[np.float64]:
    """The values of a BRDF as a parameter vector."""
    values = brdf.parameters
    vector = [
        np.broadcast_to(values[c.quantity], (solver.channels,))[c.channel or 0]
        if np.ndim(values[c.quantity])
        else values[c.quantity]
        for c in solver.columns
    ]
    return np.array(vector, float)
