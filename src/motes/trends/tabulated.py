"""`Tabulated`: values at measured times with straight lines between them; and either sort of trend back from a file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, final

import numpy as np
from numpy.typing import ArrayLike

from motes.errors import DataError, ParameterError
from motes.trends.kinds import Floats
from motes.trends.trend import Trend


@final
@dataclass(frozen=True)
class Tabulated:
    """Values at given times, straight lines between them, held before the first and after the last.

    Parameters
    ----------
    hours
        Increasing times (T,) [h].
    values
        (T,) or (T, C).
    """

    hours: Floats
    values: Floats
    kind: str = field(default="tabulated", init=False)

    def __post_init__(self) -> None:
        hours, values = np.asarray(self.hours, float), np.asarray(self.values, float)
        forward = hours.ndim == 1 and len(hours) > 0 and np.isfinite(hours).all() and np.all(np.diff(hours) > 0)
        if not forward or values.ndim not in (1, 2) or values.size == 0 or len(values) != len(hours):
            raise DataError(
                f"a tabulated trend wants increasing times and as many values: {hours.shape} and {values.shape}",
                "Give values (T,) or (T, C) for times (T,) in hours",
            )
        if not np.isfinite(values).all():
            raise DataError("a value of a tabulated trend is not finite", "Leave out the times without one")
        object.__setattr__(self, "hours", hours)
        object.__setattr__(self, "values", values)

    @property
    def interval(self) -> tuple[float, float]:
        """The first and the last time [h]."""
        return float(self.hours[0]), float(self.hours[-1])

    def __call__(self, hours: ArrayLike) -> Floats:
        """The value at times [h] of any shape (...): (...) or (..., C)."""
        t = np.asarray(hours, float)
        if self.values.ndim == 1:
            value: Floats = np.interp(t, self.hours, self.values)
            return value
        return np.stack([np.interp(t, self.hours, column) for column in self.values.T], axis=-1)

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON values."""
        return {"kind": "tabulated", "hours": self.hours.tolist(), "values": self.values.tolist()}


AnyTrend = Trend | Tabulated


def trend_from_dict(data: Mapping[str, Any]) -> AnyTrend:
    """Back from ``to_dict`` of either; raises `ParameterError` when something is missing or damaged."""
    if data.get("kind") == "tabulated":
        try:
            hours, values = np.asarray(data["hours"], float), np.asarray(data["values"], float)
        except (KeyError, TypeError, ValueError, OverflowError) as error:
            raise ParameterError(
                f"a tabulated trend is incomplete or damaged: {error}", "Write the material again with motes fit"
            ) from None
        return Tabulated(hours, values)
    return Trend.from_dict(data)
