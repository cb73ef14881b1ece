"""Facts about samples, as plain JSON values."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray


def uncertainty_facts(
    values: NDArray[np.float64], mask: NDArray[np.bool_], uncertainties: NDArray[np.float64] | None
) -> dict[str, Any] | None:
    """How many usable samples have an uncertainty, its range [1/sr], and its median relative to the values."""
    if uncertainties is None:
        return None
    known = mask & np.isfinite(uncertainties)
    u, f = uncertainties[known], np.abs(values[known])
    with np.errstate(over="ignore"):  # of values that are next to nothing
        relative = u[f > 0] / f[f > 0]
    return {
        "n_samples": int(known.sum()),
        "range": extent(u),
        "relative_median": plain(np.median(relative)) if relative.size else None,
    }


def extent(values: NDArray[np.float64]) -> list[float] | None:
    """The lowest and the highest value; None of nothing."""
    return [float(values.min()), float(values.max())] if values.size else None


def plain(value: Any) -> Any:
    """The value in types that JSON has; None for numbers that it has not."""
    if isinstance(value, Mapping):
        return {str(k): plain(v) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(v) for v in value]
    if isinstance(value, np.ndarray):
        return plain(value.tolist())
    if isinstance(value, np.generic):
        return plain(value.item())
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value if isinstance(value, (str, int, float, bool)) or value is None else str(value)


def counted(codes: NDArray[np.uint8], names: tuple[str, ...]) -> dict[str, int]:
    """How many samples have each code: 1 is the first name, 0 none."""
    counts = np.bincount(codes.reshape(-1), minlength=len(names) + 1)
    return {name: int(n) for name, n in zip(names, counts[1:], strict=False) if n}
