"""`TabulatedMaps`: the parameters of a surface as maps at measured times, read from their files when they are asked for."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from motes.errors import ParameterError

Array = NDArray[np.float64]
SHOWN = 6  # times of a summary


@final
@dataclass(frozen=True, eq=False)
class TabulatedMaps:
    r"""Maps of K_d, K_s and sigma_s at some times; linear between them.

    .. math::  f_r = K_d / \pi + K_s \rho_s

    with the facet distribution :math:`e^{-(\theta_h/\sigma_s)^2}`, as in `motes.TorranceSparrow`.

    Parameters
    ----------
    hours
        Times (T,) of the maps, increasing [h].
    load
        ``load(k)``: the maps of time k, ``K_d`` (y, x, 3), ``K_s`` (y, x, 3) or (y, x), ``sigma_s`` (y, x) [rad].
    shape
        (y, x).
    provenance
        As in `Measurement`.
    time_unit
        ``"h"``, or ``"scan"`` where only the order is known.
    """

    hours: Array
    load: Callable[[int], Mapping[str, Array]]
    shape: tuple[int, int]
    provenance: Mapping[str, Any]
    time_unit: str = "h"

    @property
    def name(self) -> str:
        return str(self.provenance.get("name") or "maps")

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the maps."""
        return ("K_d", "K_s", "sigma_s")

    @property
    def times(self) -> tuple[float, float]:
        """The first and the last time."""
        return float(self.hours[0]), float(self.hours[-1])

    def at(self, t: float) -> dict[str, Array]:
        """The parameters at a time.

        Raises
        ------
        ParameterError
            For a time outside of the measured ones.
        """
        low, high = self.times
        if not low <= t <= high:
            raise ParameterError(
                f"t = {t:g} {self.time_unit} is outside [{low:g}, {high:g}], the time that the maps cover",
                "Choose a time within",
            )
        k = int(np.clip(np.searchsorted(self.hours, t, side="right") - 1, 0, max(len(self.hours) - 2, 0)))
        first = dict(self.load(k))
        if len(self.hours) == 1 or t == self.hours[k]:
            return first
        fraction = (t - self.hours[k]) / (self.hours[k + 1] - self.hours[k])
        if fraction == 1:
            return dict(self.load(k + 1))
        second = self.load(k + 1)
        return {name: (1 - fraction) * value + fraction * second[name] for name, value in first.items()}

    def mean(self, t: float) -> dict[str, float]:
        """Means over the maps (and channels) at a time."""
        return {name: float(value.mean()) for name, value in self.at(t).items()}

    def summary(self) -> dict[str, Any]:
        """What ``motes info`` prints; plain JSON types."""
        shown = self.hours[np.unique(np.linspace(0, len(self.hours) - 1, SHOWN).round().astype(int))]
        means = [self.mean(float(t)) for t in shown]
        return {
            "kind": "parameter maps",
            "name": self.name,
            "shape": list(self.shape),
            "n_times": len(self.hours),
            "time_unit": self.time_unit,
            "times": [float(t) for t in shown],
            "mean": {name: [m[name] for m in means] for name in self.names},
            **{k: list(v) if isinstance(v, (list, tuple)) else v for k, v in self.provenance.items()},
        }
