"""Numbers as text for people, and as plain values for machines."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray


def finite(x: Any) -> Any:
    """As plain JSON values: arrays become lists, and NaN, which JSON does not have, becomes None."""
    if isinstance(x, float):
        return x if math.isfinite(x) else None
    if isinstance(x, np.ndarray):
        return finite(x.tolist())
    if isinstance(x, np.generic):
        return finite(x.item())
    if isinstance(x, (list, tuple)):
        return [finite(v) for v in x]
    if isinstance(x, dict):
        return {str(k): finite(v) for k, v in x.items()}
    return x


def with_error(value: float, stderr: float) -> tuple[str, str]:
    """Value and standard error as text, the error to two digits and the value to the same place."""
    if not math.isfinite(stderr) or stderr <= 0:
        return f"{value:.4g}", ""
    places = max(0, 1 - math.floor(math.log10(stderr)))
    if places > 8 or abs(value) >= 1e6:
        return f"{value:.6g}", f"{stderr:.2g}"
    return f"{value:.{places}f}", f"{stderr:.{places}f}"


# Of more parameters than these, JSON holds the strongest correlations and not all: 2,151 channels have two million.
MOST_CORRELATED, STRONGEST = 100, 1000


def correlations_as_json(labels: Sequence[str], matrix: NDArray[np.float64]) -> dict[str, Any]:
    """The matrix (P, P) of a few parameters; of many None, and the strongest pairs as ``[label, label, correlation]``."""
    if len(labels) <= MOST_CORRELATED:
        return {"correlations": finite(matrix)}
    i, j = np.triu_indices(len(labels), 1)
    strength = np.nan_to_num(np.abs(matrix[i, j]))
    order = np.argsort(-strength, kind="stable")[:STRONGEST]
    pairs = [[labels[i[k]], labels[j[k]], round(float(matrix[i[k], j[k]]), 6)] for k in order if strength[k] > 0]
    return {"correlations": None, "strongest_correlations": pairs}
