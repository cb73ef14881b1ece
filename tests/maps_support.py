"""What the tests of maps share: a small simulated map, and everything in a store as bytes."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import numpy as np
import zarr

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
