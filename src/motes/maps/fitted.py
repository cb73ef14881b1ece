"""`FittedMap`: parameters at every texel, with errors and status, as a Zarr store that grows block by block."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from motes import outlets
from motes.errors import DataError, FormatError, MotesError
from motes.fitting.texels import TexelFit
from motes.maps import making, zarrs
from motes.maps.blocks import Blocks
from motes.maps.layout import EXTRAS, FLAGS, Variable, stored_variables, variables_of
from motes.maps.plan import Plan
from motes.maps.stack import open_dataset
from motes.material import Material
from motes.models import BRDF, parse
from motes.trends import KINDS, AnyTrend, Tabulated, Trend, evaluate

Floats = NDArray[np.float64]


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
        The maps of parameters, by name; each has a companion ``NAME_stderr``.
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
    def failures(self) -> tuple[tuple[tuple[int, int], str], ...]:
        """Blocks that failed in the last run, and why."""
        listed = self.group["run"].attrs.get("failures") or ()
        return tuple(((int(y), int(x)), str(reason)) for y, x, reason in listed)

    @cached_property
    def brdf(self) -> BRDF:
        """The model, with what was held in place and defaults for the rest."""
        return parse(self.model).model.with_parameters(self.plan.fitting.fixed)

    # ------------------------------------------------------------ reading

    def done(self) -> NDArray[np.bool_]:
        """Which blocks (rows, columns) are finished.

        Their records are single files, which are listed: opening a million of them through Zarr would take minutes."""
        found = np.zeros(self.blocks.counts, bool)
        for row in _numbered(self.path / "run" / "done" / "c"):
            for column in _numbered(self.path / "run" / "done" / "c" / str(row)):
                if row < found.shape[0] and column < found.shape[1]:
                    found[row, column] = True
        return found

    def counts(self) -> dict[str, int]:
        """How many fits ended how; block by block, so that no map needs to fit into memory."""
        totals = np.zeros(256, np.int64)
        status = self.group["status"]
        for block in self.blocks:
            totals += np.bincount(np.asarray(status[self.blocks.slices(block)]).ravel(), minlength=256)
        return {name: int(totals[value]) for name, value in FLAGS.items()}

    def read_map(self, name: str, where: tuple[slice, slice] = (slice(None), slice(None))) -> NDArray[Any]:
        """A map of the store, or the part of it `where`: one of `variables`, its ``_stderr``, ``relative_rms``, ``status``."""
        if name not in self.group:
            raise MotesError(f"{self.path} has no map {name!r}", f"It has {', '.join(self.variables)}")
        try:
            return np.asarray(self.group[name][where])
        except Exception as error:
            raise FormatError(f"{self.path}: {name} cannot be read: {str(error)[:200]}", "Fit the map again") from None

    def values(self, quantity: str, where: tuple[slice, slice] = (slice(None), slice(None))) -> Floats:
        """A parameter at every time, (y, x, T) or (y, x, T, C): from its map, or from its trend."""
        parts = {v.coefficient: v for v in self.variables.values() if v.quantity == quantity}
        if not parts:
            raise MotesError(f"{self.path} has no parameter {quantity!r}", f"It has {', '.join(self.quantities)}")
        if not self.joint:
            return self.read_map(parts[None].name, where).astype(float)
        colour = any(v.per_channel for v in parts.values())
        tail = (1,) if colour else ()
        coefficients: dict[str, Floats] = {}
        for label, v in parts.items():
            c = self.read_map(v.name, where).astype(float)
            coefficients[str(label)] = c[:, :, None, :] if v.per_channel else c.reshape(*c.shape, 1, *tail)
        kind = self.kinds[quantity]
        basis = [b.reshape(-1, *tail) for b in KINDS[kind].basis(self.hours, *self._interval)]
        value, _ = evaluate(kind, basis, coefficients)
        return np.broadcast_to(value, (*next(iter(coefficients.values())).shape[:2], len(self.hours), *value.shape[3:]))

    @property
    def kinds(self) -> dict[str, str]:
        """The kind of trend of each parameter; empty where every time was fitted alone."""
        trends = self.plan.settings.trends
        return {} if trends is None else {q: trends.get(q, "constant") for q in self.quantities}

    def material(self, y: int, x: int) -> Material:
        """The material of one texel, with its parameters over time.

        Raises
        ------
        DataError
            Where the texel was not fitted.
        """
        if not (0 <= y < self.shape[0] and 0 <= x < self.shape[1]):
            raise DataError(f"texel ({y}, {x}) is outside the map of {self.shape[0]} x {self.shape[1]}")
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
        about = {"map": self.name, "texel": [y, x]}
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
            "blocks": int(done.size),
            "blocks_done": int(done.sum()),
            "fits": self.counts(),
            "failures": [{"block": list(block), "reason": reason} for block, reason in self.failures],
            "tried": self.plan.tried if len(self.plan.tried) > 1 else {},
        }

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Write a page that shows the maps; it needs no network."""
        return outlets.report("fitted map", self, path)

    # ------------------------------------------------------------ writing

    def write(self, block: tuple[int, int], fit: TexelFit) -> None:
        """Put a block's fits; the record that it is done comes last, so that what is marked done is whole."""
        where = self.blocks.slices(block)
        size = tuple(s.stop - s.start for s in where) + (() if self.joint else (len(self.hours),))
        for v in self.variables.values():
            for name, source in ((v.name, fit.x), (f"{v.name}_stderr", fit.stderr)):
                part = source[:, list(v.columns)] if v.per_channel else source[:, v.columns[0]]
                self.group[name][where] = part.reshape(*size, *part.shape[1:])
        for name in EXTRAS:
            self.group[name][where] = getattr(fit, name).reshape(size)
        self.group["run/done"][block] = 1

    def record_failures(self, failures: Sequence[tuple[tuple[int, int], str]]) -> None:
        """Keep what failed, for ``motes info``."""
        self.group["run"].attrs["failures"] = [[y, x, reason] for (y, x), reason in failures]

    def clean(self) -> None:
        """Remove what killed writers left."""
        for left in self.path.rglob("*.partial"):
            left.unlink(missing_ok=True)

    # ------------------------------------------------------------ helpers

    @property
    def _interval(self) -> tuple[float, float]:
        return float(self.hours[0]), float(self.hours[-1])

    def _trend(self, quantity: str, where: tuple[slice, slice]) -> Trend:
        coefficients = {
            str(v.coefficient): np.asarray(self.read_map(v.name, where)[0, 0], float)
            for v in self.variables.values()
            if v.quantity == quantity
        }
        (parameter,) = (s.parameter for s in self.brdf.slots() if s.name == quantity)
        return Trend(self.kinds[quantity], coefficients, self._interval, parameter.bounds)


def create_fitted(path: Path, plan: Plan, restart: bool) -> FittedMap:
    """A new, empty store for the results of a plan; with `restart` in place of another."""
    stack, solver = plan.stack, plan.solver
    replaced = path.exists() and restart and zarrs.is_store(path) and _is_ours(path)
    variables = variables_of(solver.columns, plan.settings.trends is not None)
    times = () if plan.settings.trends is not None else ("time",)
    grid = {"y": stack.shape[0], "x": stack.shape[1], "time": len(stack.hours), "channel": len(stack.channels)}

    def empty(group: Any, name: str, dims: tuple[str, ...], **options: Any) -> None:
        shape = tuple(grid[d] for d in dims)
        zarrs.add(group, name, dims=dims, shape=shape, chunks=(*stack.blocks.block, *shape[2:]), **options)

    with making.whole(path, instead=replaced) as store:
        group = making.new_group(store)
        for v in variables:
            dims = ("y", "x", *times, *(("channel",) if v.per_channel else ()))
            unit = v.unit or "1"
            empty(group, v.name, dims, attributes={"units": unit, "long_name": v.doc})
            about = {"units": unit, "long_name": f"standard error of {v.name}; NaN at a bound or not determined"}
            empty(group, f"{v.name}_stderr", dims, attributes=about)
        for name, (dtype, fill, about) in EXTRAS.items():
            empty(group, name, ("y", "x", *times), dtype=dtype, fill=fill, attributes=about)
        zarrs.add(group, "time", stack.hours, dims=("time",), attributes={"units": "h"})
        run = group.create_group("run")
        zarrs.add(
            run, "done", dims=("block_y", "block_x"), shape=stack.blocks.counts, chunks=(1, 1), dtype="u1", fill=0,
            compressed=False,
        )  # fmt: skip
        run.attrs["plan"] = plan.to_dict()
        group.attrs.update(
            {
                "format": zarrs.FITTED,
                "version": zarrs.VERSION,
                "name": stack.name,
                "model": plan.model,
                "fixed": plan.fitting.fixed,
                "loss": plan.settings.loss,
                "trends": {} if plan.settings.trends is None else plan.settings.trends,
                "channels": list(stack.channels),
                "conventions": zarrs.CONVENTIONS,
                "source": plan.settings.source,
            }
        )
    return open_fitted(path, mode="r+")


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
    if not isinstance(group.attrs.get("version"), int) or group.attrs["version"] > zarrs.VERSION:
        raise FormatError(
            f"{folder} is of version {group.attrs.get('version')!r}, newer than {zarrs.VERSION}", "Update Motes"
        )
    try:
        plan = Plan.from_dict(group["run"].attrs["plan"])
        hours = zarrs.numbers(group["time"], folder)
        channels = tuple(str(c) for c in group.attrs["channels"])
        shape = group["status"].shape[:2]
        blocks = Blocks(shape, (plan.settings.block[0], plan.settings.block[1]))
        if math.prod(group["run/done"].shape) > zarrs.MOST_BLOCKS or group["run/done"].shape != blocks.counts:
            raise ValueError("the record of finished blocks does not fit the maps")
        variables = {name: v for name, v in stored_variables(plan, len(channels)).items() if name in group}
    except MotesError:
        raise
    except Exception as error:
        raise FormatError(f"{folder} is a damaged fitted map: {error}", "Fit the map again with --restart") from None
    return FittedMap(folder, plan, variables, blocks, hours, channels, group)


def _numbered(folder: Path) -> list[int]:
    """The names in a folder that are numbers; none where there is no folder."""
    try:
        return [int(name) for name in os.listdir(folder) if name.isdecimal()]
    except FileNotFoundError:
        return []


def _is_ours(path: Path) -> bool:
    return bool(zarrs.open_group(path).attrs.get("format") == zarrs.FITTED)
