"""`FittedMap`: parameters at every texel, with errors and status, as a Zarr store that grows block by block."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from motes import outlets
from motes.errors import DataError, FormatError, MotesError
from motes.files import reading
from motes.fitting.formatting import finite
from motes.fitting.texels import TexelFit
from motes.maps import zarrs
from motes.maps.blocks import Blocks
from motes.maps.chunks import Chunks, there
from motes.maps.layout import EXTRAS, FLAGS, VERDICT_FLAGS, Variable, labels, stored, stored_variables, worst
from motes.maps.opening import forward
from motes.maps.plan import Plan
from motes.maps.stack import open_dataset
from motes.material import Material
from motes.models import BRDF, parse
from motes.trends import KINDS, AnyTrend, Tabulated, Trend, evaluate

Floats = NDArray[np.float64]
Codes = NDArray[np.uint8]


@final
@dataclass(frozen=True, eq=False)
class FittedMap:
    """Fitted parameters of a surface, (y, x[, time][, channel]), and how sure they are.

    Parameters
    ----------
    path
        Of the Zarr store.
    plan
        What was fitted, and how.
    variables
        The maps of parameters, by name; each has companions ``NAME_stderr`` and ``NAME_verdict``.
    blocks
        How the texels are divided.
    hours, channels
        As of the measured map.
    group
        The Zarr group.
    """

    path: Path
    plan: Plan
    variables: Mapping[str, Variable]
    blocks: Blocks
    hours: Floats
    channels: tuple[str, ...]
    group: Any = field(repr=False)

    @property
    def name(self) -> str:
        return str(self.group.attrs.get("name") or self.path.stem)

    @property
    def origin(self) -> str:
        """Where the data say that they come from, such as ``"simulated by Motes"``; empty where they do not."""
        return str(self.group.attrs.get("origin") or "")

    @property
    def model(self) -> str:
        """The model as text."""
        return self.plan.model

    @property
    def shape(self) -> tuple[int, int]:
        """(y, x): rows and columns of texels."""
        return self.blocks.shape

    @property
    def joint(self) -> bool:
        """Whether trends over all times were fitted, rather than every time alone."""
        return self.plan.settings.trends is not None

    @property
    def quantities(self) -> tuple[str, ...]:
        """The parameters that were fitted."""
        return tuple(dict.fromkeys(v.quantity for v in self.variables.values()))

    @property
    def version(self) -> int:
        """Of the store; before 2 there are no verdicts."""
        return int(self.group.attrs["version"])

    @property
    def labels(self) -> tuple[str, ...]:
        """The rows and columns of `covariance`: ``K_d[R]``, ``sigma_d``, with trends ``K_s_start``."""
        return labels(self.variables.values(), self.channels)

    @property
    def failures(self) -> tuple[tuple[tuple[int, int], str], ...]:
        """Blocks that failed in the last run, and why."""
        listed = self.group["run"].attrs.get("failures") or ()
        try:
            return tuple(((int(y), int(x)), str(reason)) for y, x, reason in listed)
        except (TypeError, ValueError, OverflowError) as error:
            raise FormatError(
                f"{self.path}: the record of failures is damaged: {error}", "Fit the map again with --restart"
            ) from None

    @cached_property
    def brdf(self) -> BRDF:
        """The model, with what was held in place and defaults for the rest."""
        return parse(self.model).model.with_parameters(self.plan.fitting.fixed)

    # ------------------------------------------------------------ reading

    @property
    def interval(self) -> tuple[float, float]:
        """The first and the last time [h]."""
        return float(self.hours[0]), float(self.hours[-1])

    def holds(self, name: str) -> bool:
        """Whether the store has an array of this name."""
        return zarrs.member(self.group, name, self.path) is not None

    def done(self) -> NDArray[np.bool_]:
        """Which blocks (rows, columns) are finished."""
        return there(self.path / "run" / "done", self.blocks.counts)

    def counts(self) -> dict[str, int]:
        """How many fits ended how; block by block, so that no map needs to fit into memory."""
        totals = np.zeros(256, np.int64)
        for block in self.blocks:
            totals += np.bincount(self.read_map("status", self.blocks.slices(block)).ravel(), minlength=256)
        return {name: int(totals[value]) for name, value in FLAGS.items()}

    def verdict_counts(self) -> dict[str, dict[str, int]]:
        """By map, how many of its values have which verdict; nothing where the store has none."""
        found: dict[str, dict[str, int]] = {}
        for name in self.variables:
            if not self.holds(f"{name}_verdict"):
                continue
            totals = np.zeros(256, np.int64)
            for block in self.blocks:
                codes = self.read_map(f"{name}_verdict", self.blocks.slices(block))
                totals += np.bincount(codes.ravel(), minlength=256)
            found[name] = {word: int(totals[code]) for word, code in VERDICT_FLAGS.items()}
        return found

    def adrift(self) -> int:
        """How many fits stopped at the limit of iterations with a parameter that the data do not determine: they wandered along it."""
        if self.version < zarrs.FITTED_VERSION:
            return 0
        total = 0
        for block in self.blocks:
            where = self.blocks.slices(block)
            stopped = self.read_map("status", where) == FLAGS["max_iterations"]
            unseen = np.zeros(stopped.shape, bool)
            for name, v in self.variables.items():
                lost = self.verdicts(name, where) == VERDICT_FLAGS["unidentifiable"]
                unseen |= lost.any(axis=-1) if v.per_channel else lost
            total += int((stopped & unseen).sum())
        return total

    def verdicts(self, name: str, where: tuple[slice, slice] = (slice(None), slice(None))) -> Codes:
        """What the data say about a parameter: positions in `motes.fitting.covariance.VERDICTS`, 255 where there is no fit.

        Parameters
        ----------
        name
            One of `variables`: (y, x[, T][, C]).  Or with trends one of `quantities`, (y, x): the worst of its coefficients and channels.
        where
            The part of the map.
        """
        if name in self.variables:
            if not self.holds(f"{name}_verdict"):
                raise MotesError(f"{self.path} holds no verdicts: an earlier Motes wrote it", "Fit the map again")
            return np.asarray(self.read_map(f"{name}_verdict", where), np.uint8)
        parts = [self.verdicts(v.name, where) for v in self.variables.values() if v.quantity == name]
        if not parts:
            raise MotesError(f"{self.path} has no parameter {name!r}", f"It has {', '.join(self.quantities)}")
        return worst(np.concatenate([p.reshape(*p.shape[:2], -1) for p in parts], axis=-1))

    def covariance(self, where: tuple[slice, slice] = (slice(None), slice(None))) -> Floats:
        """Covariance matrices (y, x[, T], P, P) of the fits, rows and columns as `labels`; NaN for what has no standard error.

        Raises
        ------
        MotesError
            When they were not kept.
        """
        if not self.holds("covariance"):
            raise MotesError(f"{self.path} holds no covariances", "Fit the map with --covariance")
        packed, size = reading.doubles(self.read_map("covariance", where)), len(self.labels)
        rows, columns = np.tril_indices(size)
        full = np.empty((*packed.shape[:-1], size, size))
        full[..., rows, columns] = full[..., columns, rows] = packed
        return full

    def read_map(self, name: str, where: tuple[slice, slice] = (slice(None), slice(None))) -> NDArray[Any]:
        """A map of the store, or the part of it `where`: one of `variables`, its ``_stderr``, ``relative_rms``, ``status``."""
        found = zarrs.member(self.group, name, self.path)
        grid = self.shape if self.joint else (*self.shape, len(self.hours))
        due = stored(name, self.variables, grid, len(self.channels))
        if found is None or due is None:
            raise MotesError(f"{self.path} has no map {name!r}", f"It has {', '.join(self.variables)}")
        if (found.dtype, found.shape) != due:
            raise FormatError(
                f"{self.path}: {name} is {found.dtype} {found.shape}, not {due[0]} {due[1]}",
                "Fit the map again with --restart",
            )
        return zarrs.read(found, self.path, where)

    def values(self, quantity: str, where: tuple[slice, slice] = (slice(None), slice(None))) -> Floats:
        """A parameter at every time, (y, x, T) or (y, x, T, C): from its map, or from its trend."""
        parts = {v.coefficient: v for v in self.variables.values() if v.quantity == quantity}
        if not parts:
            raise MotesError(f"{self.path} has no parameter {quantity!r}", f"It has {', '.join(self.quantities)}")
        if not self.joint:
            return reading.doubles(self.read_map(parts[None].name, where))
        colour = any(v.per_channel for v in parts.values())
        tail = (1,) if colour else ()
        coefficients: dict[str, Floats] = {}
        for label, v in parts.items():
            c = reading.doubles(self.read_map(v.name, where))
            coefficients[str(label)] = c[:, :, None, :] if v.per_channel else c.reshape(*c.shape, 1, *tail)
        kind = self.kinds[quantity]
        basis = [b.reshape(-1, *tail) for b in KINDS[kind].basis(self.hours, *self.interval)]
        value, _ = evaluate(kind, basis, coefficients)
        return np.broadcast_to(value, (*next(iter(coefficients.values())).shape[:2], len(self.hours), *value.shape[3:]))

    @property
    def kinds(self) -> dict[str, str]:
        """The kind of trend of each parameter; empty where every time was fitted alone."""
        trends = self.plan.fitting.trends
        return {} if trends is None else {q: trends.get(q, "constant") for q in self.quantities}

    def material(self, y: int, x: int) -> Material:
        """The material of one texel, with its parameters over time.

        Raises
        ------
        DataError
            Where the texel was not fitted.
        """
        if not (0 <= y < self.shape[0] and 0 <= x < self.shape[1]):
            raise DataError(
                f"texel ({y}, {x}) is outside the map of {self.shape[0]} x {self.shape[1]}",
                "Rows and columns count from 0",
            )
        where = (slice(y, y + 1), slice(x, x + 1))
        first: dict[str, Any] = {}
        trends: dict[str, AnyTrend] = {}
        for quantity in self.quantities:
            over_time = self.values(quantity, where)[0, 0]
            good = np.isfinite(over_time).reshape(len(over_time), -1).all(axis=1)
            if not good.any():
                raise DataError(f"texel ({y}, {x}) of {self.path} has no {quantity}", "Its status says why")
            first[quantity] = over_time[good][0]
            if self.joint:
                trends[quantity] = self._trend(quantity, where)
            elif good.sum() > 1:
                trends[quantity] = Tabulated(self.hours[good], over_time[good])
        inside = {s.name: np.clip(first[s.name], *s.parameter.fit_bounds) for s in self.brdf.slots() if s.name in first}
        brdf = self.brdf.with_parameters(inside)
        about = {"map": self.name, "texel": [y, x], **({"data": {"source": self.origin}} if self.origin else {})}
        return Material(brdf, f"{self.name} ({y}, {x})", self.channels, trends=trends, about=about)

    def to_xarray(self) -> Any:
        """The store as an `xarray.Dataset`, its values read when they are used."""
        return open_dataset(self.path, self.channels)

    def summary(self) -> dict[str, Any]:
        """What ``motes info`` prints; plain JSON types."""
        done = self.done()
        settings = self.plan.settings
        return {
            "kind": "fitted map",
            "name": self.name,
            "path": str(self.path),
            "model": self.model,
            "shape": list(self.shape),
            "times": self.hours.tolist(),
            "n_times": len(self.hours),
            "channels": list(self.channels),
            "parameters": list(self.quantities),
            "variables": list(self.variables),
            "trends": self.kinds,
            "fixed": self.plan.fitting.fixed,
            "loss": settings.loss,
            "source": settings.source,
            "origin": self.origin,
            "blocks": int(done.size),
            "blocks_done": int(done.sum()),
            "robust": settings.robust,
            "time": settings.time,
            "covariance": self.holds("covariance"),
            "fits": self.counts(),
            "verdicts": self.verdict_counts(),
            "failures": [{"block": list(block), "reason": reason} for block, reason in self.failures],
            "tried": [finite(asdict(trial) | {"status": str(trial.status)}) for trial in self.plan.tried],
        }

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Write a page that shows the maps; it needs no network."""
        return outlets.report("fitted map", self, path)

    # ------------------------------------------------------------ writing

    def write(self, block: tuple[int, int], fit: TexelFit) -> None:
        """Put a block's fits; the record that it is done comes last, so that what is marked done is whole."""
        size = tuple(s.stop - s.start for s in self.blocks.slices(block)) + (() if self.joint else (len(self.hours),))

        def put(name: str, values: NDArray[Any]) -> None:
            self._chunks[name].put(block, values.reshape(*size, *values.shape[1:]))

        for v in self.variables.values():
            columns = list(v.columns) if v.per_channel else v.columns[0]
            put(v.name, fit.x[:, columns])
            put(f"{v.name}_stderr", fit.stderr[:, columns])
            put(f"{v.name}_verdict", fit.verdicts[:, columns])
        for name in EXTRAS:
            put(name, getattr(fit, name))
        if "covariance" in self._chunks and fit.covariance is not None:
            put("covariance", fit.covariance)
        self._chunks["done"].put(block, np.ones((1, 1), np.uint8))

    def record_failures(self, failures: Sequence[tuple[tuple[int, int], str]]) -> None:
        """Keep what failed, for ``motes info``."""
        self.group["run"].attrs["failures"] = [[y, x, reason] for (y, x), reason in failures]

    def clean(self) -> None:
        """Remove what killed writers left."""
        for left in self.path.rglob("*.partial"):
            left.unlink(missing_ok=True)

    # ------------------------------------------------------------ helpers

    @cached_property
    def _chunks(self) -> dict[str, Chunks]:
        """The chunks of every map, and of the record of finished blocks: each block is one."""
        arrays = zarrs.arrays(self.group, self.path) | {"done": self.group["run/done"]}
        return {name: Chunks.of(array, self.path) for name, array in arrays.items()}

    def _trend(self, quantity: str, where: tuple[slice, slice]) -> Trend:
        coefficients = {
            str(v.coefficient): reading.doubles(self.read_map(v.name, where)[0, 0])
            for v in self.variables.values()
            if v.quantity == quantity
        }
        (parameter,) = (s.parameter for s in self.brdf.slots() if s.name == quantity)
        return Trend(self.kinds[quantity], coefficients, self.interval, parameter.bounds)


def open_fitted(path: object, mode: str = "r") -> FittedMap:
    """The fitted map in a store that `create_fitted` made.

    Raises
    ------
    FormatError
        When it is not one, or is damaged.
    """
    folder = Path(str(path))
    group = zarrs.open_group(folder, mode)
    if group.attrs.get("format") != zarrs.FITTED:
        raise FormatError(f"{folder} is not a fitted map", "motes fit MAP.zarr writes one")
    if not isinstance(group.attrs.get("version"), int) or group.attrs["version"] > zarrs.FITTED_VERSION:
        raise FormatError(
            f"{folder} is of version {group.attrs.get('version')!r}, newer than {zarrs.FITTED_VERSION}", "Update Motes"
        )
    try:
        plan = Plan.from_dict(group["run"].attrs["plan"])
        hours = forward(zarrs.numbers(group["time"], folder), folder)
        channels = tuple(str(c) for c in group.attrs["channels"])
        shape = group["status"].shape[:2]
        blocks = Blocks(shape, (plan.settings.block[0], plan.settings.block[1]))
        if math.prod(group["run/done"].shape) > zarrs.MOST_BLOCKS or group["run/done"].shape != blocks.counts:
            raise ValueError("the record of finished blocks does not fit the maps")
        variables = stored_variables(plan, len(channels))
        if lost := [name for name in variables if zarrs.member(group, name, folder) is None]:
            raise ValueError(f"it lacks {', '.join(lost)}")
        found = FittedMap(folder, plan, variables, blocks, hours, channels, group)
        if len(hours) < 2 if found.joint else group["status"].shape[2:] != hours.shape:
            raise ValueError(f"its maps do not go with {len(hours)} time{'s' if len(hours) != 1 else ''}")
    except MotesError:
        raise
    except Exception as error:
        raise FormatError(f"{folder} is a damaged fitted map: {error}", "Fit the map again with --restart") from None
    return found
