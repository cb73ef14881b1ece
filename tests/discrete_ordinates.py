"""Dust over any base by discrete ordinates: PythonicDISORT, to which a base is the Fourier modes of its BRDF in azimuth."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
import PythonicDISORT
from numpy.typing import NDArray

from motes.directions import from_spherical
from motes.models import BRDF, Lambert

Floats = NDArray[np.float64]
MOMENTS = 2000


class Solution(NamedTuple):
    """Viewers at the solver's own cosines (N,), where nothing is interpolated, and what is known there.

    `brdf` takes azimuths from the light (A,) and gives the BRDF [1/sr] (N, A), which is the same on either side.
    """

    cosines: Floats
    brdf: Callable[[Any], Floats]
    albedo: float


def layer(base: BRDF, tau: float, w: float, g: float, theta_i: float, streams: int = 48) -> Solution:
    """A layer of Henyey-Greenstein dust under light from `theta_i`; w = 1 is taken as 1 - 1e-9."""
    return layers(base, [(tau, w, g)], theta_i, streams)


def layers(base: BRDF, dusts: Sequence[tuple[float, float, float]], theta_i: float, streams: int = 48) -> Solution:
    """Several layers, the topmost first, each of its own tau, w and g."""
    modes: list[Any] = [float(np.asarray(base.K_d))] if isinstance(base, Lambert) else _modes(base, streams)
    tau, w, g = (np.array(values, float) for values in zip(*dusts, strict=True))
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message="Some delta-scaled single-scattering albedos are very close to 1")
        cosines, flux_up, *_, u = PythonicDISORT.pydisort(
            np.cumsum(tau), np.minimum(w, 1 - 1e-9), streams, g[:, None] ** np.arange(MOMENTS), np.cos(theta_i), 1.0, 0.0,
            NLeg=streams, f_arr=g**streams, NT_cor=bool(g.any()), BDRF_Fourier_modes=modes,
        )  # fmt: skip
    up = np.flatnonzero(cosines > 0)

    def brdf(azimuths: Any) -> Floats:
        # Its azimuths are those of flight: 0 goes on as the light went, which is the mirror's side.
        flight = np.pi - np.atleast_1d(azimuths)
        return np.asarray(u(0.0, flight)[up] / np.cos(theta_i)).reshape(len(up), len(flight))

    return Solution(cosines[up], brdf, float(flux_up(0.0) / np.cos(theta_i)))


def _modes(base: BRDF, count: int, nodes: int = 257) -> list[Any]:
    """pi f = sum of rho_m(mu, mu') cos(m phi), phi from the mirror's side, by the trapezium rule."""
    azimuth = np.linspace(0, np.pi, nodes)
    ends = np.where((azimuth == 0) | (azimuth == np.pi), 0.5, 1.0)

    def mode(m: int) -> Callable[[Floats, Floats], Floats]:
        weights = (2 - (m == 0)) * np.cos(m * azimuth) * ends / ends.sum()

        def of(mu: Floats, mu_light: Floats) -> Floats:
            lights = from_spherical(np.arccos(np.atleast_1d(mu_light)), 0.0)[None, :, None]
            viewers = from_spherical(np.arccos(np.atleast_1d(mu))[:, None], np.pi - azimuth)[:, None]
            return np.asarray(np.pi * base.eval(lights, viewers)[..., 0] @ weights)

        return of

    return [mode(m) for m in range(count)]
