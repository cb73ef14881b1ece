"""What the tests of maps share: a small simulated map, one with parameters as they are given, and everything in a store as bytes."""

from __future__ import annotations

import shutil
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import zarr

from motes import maps
from motes.maps.beginning import create_fitted
from motes.maps.plan import Plan
from motes.maps.settings import Settings

MODEL = "oren_nayar + torrance_sparrow"
BLOCK = (8, 8)


def contents(store: Path) -> dict[str, bytes]:
    """Every array of a store, and the record of finished blocks."""
    group = zarr.open_group(str(store), mode="r", use_consolidated=False)
    found = {name: np.asarray(a[...]).tobytes() for name, a in group.arrays()}
    if "run" in group:
        found["done"] = np.asarray(group["run/done"][...]).tobytes()
    return found


def copy(store: Path, to: Path) -> Path:
    return Path(shutil.copytree(store, to))


def values_of(store: Path) -> Any:
    """The array of values, to change."""
    return zarr.open_group(str(store), mode="r+", use_consolidated=False)["f_r"]


def damage(store: Path, chunk: str) -> Path:
    """Cut a chunk of the values in half."""
    file = store / "f_r" / "c" / chunk
    data = file.read_bytes()
    file.write_bytes(data[: len(data) // 2])
    return file


def fitted_map(
    store: Path,
    model: str,
    values: Mapping[str, Any],
    *,
    hours: Sequence[float] = (0.0,),
    trends: Mapping[str, str] | None = None,
    channels: Sequence[str] = ("R", "G", "B"),
    per_channel: Sequence[str] = (),
    block: tuple[int, int] = (4, 4),
) -> maps.FittedMap:
    """A fitted map whose parameters are `values`, by the names of its variables: (y, x, T[, C]), with trends (y, x[, C]); nothing is fitted.

    Texels that are NaN in any of them have no fit.
    """
    shape = next(iter(values.values())).shape[:2]
    up = np.array([[0.0, 0.0, 1.0]])
    measured = store.with_name(f"measured-{store.name}")
    stack = maps.create_map(measured, shape, up, up, hours=hours, channels=channels)
    settings = Settings.of(stack, model, trends=trends, per_channel=per_channel)
    plan = Plan(replace(settings, block=list(block)), settings.model, [[]], ())
    fitted = create_fitted(store, plan, restart=False)
    assert set(fitted.variables) == set(values), set(fitted.variables)
    bad = np.zeros(fitted.group["status"].shape, bool)
    for name, value in values.items():
        fitted.group[name][...] = value
        verdict = np.where(np.isfinite(value), 0, 255).astype(np.uint8)
        fitted.group[f"{name}_verdict"][...] = verdict
        bad |= ~np.isfinite(value).reshape(*bad.shape, -1).all(axis=-1)
    fitted.group["status"][...] = np.where(bad, 3, 0)
    fitted.group["run/done"][...] = 1
    return maps.open_map(store)  # type: ignore[return-value]
