"""`ParameterMaps`: the parameters of a surface as maps that change with time, each texel a polynomial."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from motes.errors import ParameterError

NAMES = ("Diffuse", "Specular", "Roughness")


@final
@dataclass(frozen=True, eq=False)
class ParameterMaps:
    r"""Maps of diffuse and specular parameters over a surface, polynomials of time in each texel.

    .. math::  f_r = D / \pi + K_s \rho_s, \quad K_s = S / (\pi R^2 (1 - e^{-1/R^2})), \quad \sigma_s = R

    for the maps D = Diffuse, S = Specular, R = Roughness.  The facet distribution is
    :math:`e^{-(\theta_h/\sigma_s)^2}`, as in `motes.TorranceSparrow`, and S its weight after normalisation.

    Parameters
    ----------
    coefficients
        ``Diffuse`` (degree + 1, y, x, 3), ``Specular`` (..., 3) or (..., 1), ``Roughness`` (..., 1) [rad]: the
        coefficients of t^d.
    provenance
        As in `Measurement`.
    times
        The range of t.
    """

    coefficients: Mapping[str, NDArray[np.float32]]
    provenance: Mapping[str, Any]
    times: tuple[float, float] = (0.0, 1.0)

    def __post_init__(self) -> None:
        for array in self.coefficients.values():
            array.setflags(write=False)
        object.__setattr__(self, "coefficients", MappingProxyType(dict(self.coefficients)))

    @property
    def name(self) -> str:
        return str(self.provenance.get("name") or "maps")

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the maps."""
        return tuple(self.coefficients)

    @property
    def shape(self) -> tuple[int, int]:
        """(y, x) of the maps."""
        shape = self.coefficients["Diffuse"].shape
        return int(shape[-3]), int(shape[-2])

    def raw(self, t: float) -> dict[str, NDArray[np.float64]]:
        """The polynomials at a time, as they are: they may dip below 0.  Diffuse (y, x, 3), Specular (y, x[, 3]),
        Roughness (y, x).

        Raises
        ------
        ParameterError
            For t outside the range of the data; a cubic means nothing there.
        """
        low, high = self.times
        if not low <= t <= high:
            raise ParameterError(
                f"t = {t:g} is outside [{low:g}, {high:g}], the time that the maps cover", "Choose a time within"
            )
        result = {}
        for name, coefficients in self.coefficients.items():
            value: NDArray[np.float64] = np.zeros(coefficients.shape[1:])
            for c in coefficients[::-1]:  # Horner
                value *= t
                value += c
            result[name] = value[..., 0] if value.shape[-1] == 1 else value
        return result

    def at(self, t: float) -> dict[str, NDArray[np.float64]]:
        """The parameters at a time: ``K_d`` (y, x, 3), ``K_s`` (y, x[, 3]), ``sigma_s`` (y, x) [rad].

        The polynomials are evaluated and then clamped at 0, as their source prescribes.  Where Roughness is 0 there is
        no lobe to give the Specular to: sigma_s and K_s are both 0 there (`summary` counts these texels).
        """
        raw = {name: np.maximum(value, 0) for name, value in self.raw(t).items()}
        sigma_s, specular = raw["Roughness"], raw["Specular"]
        r2 = np.where(sigma_s > 0, sigma_s, 1.0) ** 2
        with np.errstate(over="ignore", divide="ignore"):
            area = np.pi * r2 * -np.expm1(-1 / r2)
        area = np.where((sigma_s > 0) & (area > 0), area, np.inf)
        K_s = specular / (area if specular.ndim == 2 else area[..., None])
        return {"K_d": raw["Diffuse"], "K_s": K_s, "sigma_s": sigma_s}

    def mean(self, t: float) -> dict[str, float]:
        """Means of the polynomials over the maps (and channels) at a time, before the clamp at 0."""
        return {name: float(value.mean()) for name, value in self.raw(t).items()}

    def summary(self) -> dict[str, Any]:
        """What ``motes info`` prints; plain JSON types."""
        times = np.linspace(*self.times, 6).round(12)
        below = dict.fromkeys(self.names, 0)
        for t in times:
            for name, value in self.raw(float(t)).items():
                below[name] += int(np.count_nonzero(value <= 0 if name == "Roughness" else value < 0))
        return {
            "kind": "parameter maps",
            "name": self.name,
            "shape": list(self.shape),
            "maps": {name: {"degree": len(c) - 1, "channels": c.shape[-1]} for name, c in self.coefficients.items()},
            "times": [float(t) for t in times],
            "mean": {name: [self.mean(float(t))[name] for t in times] for name in self.names},
            "clamped_at_0": below,
            **{k: list(v) if isinstance(v, (list, tuple)) else v for k, v in self.provenance.items()},
        }
