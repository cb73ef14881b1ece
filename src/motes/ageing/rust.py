r"""Rusting iron: time-varying materials out of maps of polynomials (STAF), of one texel or of the mean of all.

.. math::  f = D/\pi + K_s \rho_s, \quad \sigma_s = R, \quad K_s = S / (\pi R^2 (1 - e^{-1/R^2}))

for the maps D, S, R (Diffuse, Specular, Roughness); see `motes.measurements.parameter_maps`.
D and R are cubics and stay cubics; K_s, a quotient, is tabulated.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import comb
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from motes.channels import RGB
from motes.errors import ParameterError
from motes.material import Material
from motes.measurements.parameter_maps import ParameterMaps
from motes.models import Lambert, TorranceSparrow
from motes.trends import AnyTrend, Floats, Tabulated, Trend

SMALLEST_SIGMA_S = 0.001  # rad; what TorranceSparrow accepts
# Of the tabulated K_s.  Halfway between two steps the mean of tvBTF45 is within 0.2 % of the quotient; 0, 0.2, ... 1 are on steps.
STEPS = 201

#: Means over the STAF maps tvBTF45 (Gu et al. 2006, refitted by Meister et al.) at t = 0, 0.2, ... 1 of the experiment, rounded: Roughness [rad],
#: Specular, and Diffuse in R, G, B, before any clamp.
MEAN_TIMES = np.array([0.0, 0.2, 0.4, 0.6, 0.8, 1.0])
MEAN_R = np.array([0.065, 0.140, 0.180, 0.203, 0.227, 0.272])
MEAN_SPECULAR = np.array([0.202, 0.078, 0.026, 0.016, 0.019, 0.006])
MEAN_K_D = np.array(
    [
        [0.074, 0.082, 0.081],
        [0.116, 0.091, 0.071],
        [0.109, 0.073, 0.053],
        [0.081, 0.048, 0.037],
        [0.058, 0.036, 0.032],
        [0.070, 0.054, 0.046],
    ]
)


def highlight_strength(specular: Any, sigma_s: Any) -> NDArray[np.float64]:
    """K_s = S / (pi R^2 (1 - exp(-1/R^2))) for S = max(specular, 0); 0 where R is not positive."""
    R, S = np.asarray(sigma_s, float), np.maximum(np.asarray(specular, float), 0)
    squared = np.where(R > 0, np.maximum(R, SMALLEST_SIGMA_S), 1.0) ** 2
    return np.where(R > 0, S / (np.pi * squared * -np.expm1(-1 / squared)), 0.0)


@final
@dataclass(frozen=True)
class Masked:
    """Texels that have a highlight throughout.

    Parameters
    ----------
    valid
        (y, x): Roughness > 0 at all of `times`.
    times
        Where it was looked at.
    counts
        Texels with Roughness <= 0 at each of the times.
    """

    valid: NDArray[np.bool_]
    times: Floats
    counts: tuple[int, ...]


def masked(maps: ParameterMaps, times: int = 6) -> Masked:
    """Which texels of the maps have a positive Roughness at so many evenly spaced times."""
    at = np.linspace(*maps.times, times)
    below = [maps.raw(float(t))["Roughness"] <= 0 for t in at]
    return Masked(~np.any(below, axis=0), at, tuple(int(b.sum()) for b in below))


def control_values(coefficients: Any) -> NDArray[np.float64]:
    """The Bernstein control values (d + 1, ...) on [0, 1] of the polynomial sum_k coefficients[k] t^k."""
    powers = np.asarray(coefficients, float)
    degree = len(powers) - 1
    return np.stack([sum(comb(k, j) / comb(degree, j) * powers[j] for j in range(k + 1)) for k in range(degree + 1)])


def rusting_material(
    maps: ParameterMaps,
    texel: tuple[int, int] | None = None,
    *,
    hours: tuple[float, float] | None = None,
    name: str | None = None,
) -> Material:
    """The time-varying material of the mean of the maps, or of one texel.

    The mean is that of the *polynomials* (the material of the mean Diffuse, Specular and Roughness), because the mean of K_s itself is ruled by the few
    texels whose Roughness is nearly 0.  Those texels are counted in ``about`` (see `masked`).

    Parameters
    ----------
    maps
        As `motes.read` gives them; cubics in time.
    texel
        (row, column), or None for the mean.
    hours
        The times of the first and the last moment [h].  The data do not say how long the experiment took, so by default its own unit is kept: 0 to 1.
    name
        Of the material.

    Raises
    ------
    ParameterError
        For a texel outside the maps, maps that are not cubic, or a Roughness that is nowhere positive.
    """
    height, width = maps.shape
    if any(len(c) != 4 for c in maps.coefficients.values()):
        raise ParameterError("the maps are not cubics in time", "STAF maps have the coefficients of t^0 to t^3")
    if maps.times != (0.0, 1.0):
        raise ParameterError(f"the maps cover the times {maps.times}, not 0 to 1", "STAF maps cover 0 to 1")
    if texel is not None and not (0 <= texel[0] < height and 0 <= texel[1] < width):
        raise ParameterError(
            f"texel {tuple(texel)} is outside the maps of {height} x {width}", "Give (row, column), counted from 0"
        )
    first, last = hours if hours is not None else maps.times
    powers = {
        key: np.asarray(c, np.float64).mean((1, 2))
        if texel is None
        else np.asarray(c[:, texel[0], texel[1]], np.float64)
        for key, c in maps.coefficients.items()
    }
    t = np.linspace(0, 1, STEPS)
    vandermonde = t[:, None] ** np.arange(4)
    R, S = vandermonde @ powers["Roughness"], vandermonde @ powers["Specular"]
    if not (R > 0).any():
        raise ParameterError(
            "the Roughness is nowhere positive: no highlight to follow",
            "Choose another texel; motes.ageing.rust.masked says which",
        )
    K_s = highlight_strength(S, R)
    K_s = K_s[:, 0] if K_s.shape[-1] == 1 else K_s
    c_R, c_D = control_values(powers["Roughness"])[:, 0], control_values(powers["Diffuse"])
    interval = (float(first), float(last))
    trends: dict[str, AnyTrend] = {
        "K_d": Trend("cubic", {f"c{k}": c_D[k] for k in range(4)}, interval, (0.0, np.inf)),
        "K_s": Tabulated(interval[0] + t * (interval[1] - interval[0]), K_s),
        "sigma_s": Trend("cubic", {f"c{k}": float(c_R[k]) for k in range(4)}, interval, (SMALLEST_SIGMA_S, np.pi / 2)),
    }
    brdf = Lambert(K_d=np.maximum(c_D[0], 0)) + TorranceSparrow(
        K_s=K_s[0], sigma_s=float(np.clip(c_R[0], SMALLEST_SIGMA_S, np.pi / 2))
    )
    about: dict[str, Any] = {
        "source": str(maps.provenance.get("source", "")),
        "texel": "mean" if texel is None else list(texel),
    }
    if texel is None:
        seen = masked(maps)
        about |= {
            "texels": height * width,
            "texels_without_roughness": {f"{a:g}": n for a, n in zip(seen.times, seen.counts, strict=True)},
        }
    else:
        about["steps_without_roughness"] = int((R <= 0).sum())
    label = name or (f"{maps.name}, mean" if texel is None else f"{maps.name}, texel {texel[0]}, {texel[1]}")
    return Material(brdf, label, RGB, (), trends, about)
