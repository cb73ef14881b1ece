"""The empty store that a run over a map fills."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from motes.fitting.texels import NO_VERDICT
from motes.maps import making, zarrs
from motes.maps.fitted import FittedMap, open_fitted
from motes.maps.layout import EXTRAS, covariance_attributes, labels, variables_of, verdict_attributes
from motes.maps.plan import Plan


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
            empty(group, f"{v.name}_verdict", dims, dtype="u1", fill=NO_VERDICT, attributes=verdict_attributes(v))
        for name, (dtype, fill, about) in EXTRAS.items():
            empty(group, name, ("y", "x", *times), dtype=dtype, fill=fill, attributes=about)
        if plan.settings.covariance:
            names = labels(variables, stack.channels)
            grid["pair"] = len(names) * (len(names) + 1) // 2
            empty(group, "covariance", ("y", "x", *times, "pair"), attributes=covariance_attributes(names))
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
                "version": zarrs.FITTED_VERSION,
                "name": stack.name,
                "model": plan.model,
                "fixed": plan.fitting.fixed,
                "loss": plan.settings.loss,
                "robust": plan.settings.robust,
                "trends": plan.fitting.trends or {},
                "channels": list(stack.channels),
                "conventions": zarrs.CONVENTIONS,
                "source": plan.settings.source,
                "origin": str(stack.attributes.get("source", "")),
            }
        )
    return open_fitted(path, mode="r+")


def _is_ours(path: Path) -> bool:
    return bool(zarrs.open_group(path).attrs.get("format") == zarrs.FITTED)
