r"""Dust that gathers on mirrors: the optical thickness of a layer, from the specular reflectance that falls over days.

A layer of dust of optical thickness tau over a mirror leaves, of what the clean mirror reflects into the acceptance of a reflectometer,

.. math::  R / R_0 = \exp(-\tau (1/\cos\theta_i + 1/\cos\theta_r))

which is the first factor of `motes.DustLayer` (Blinn 1982).  So :math:`y = -\ln R / (1/\cos\theta_i + 1/\cos\theta_r)` is tau but for a constant, and each
mirror's readings are followed by

.. math::  y(t) = y_0 + r t - \sum_j G_j [t > t_j] + W(t), \quad \mathrm{var}\,W = q t

growth at a rate r, resets by gains G_j (rain, wind, cleaning), and a random walk W, because dust does not gather steadily: what one windy day brings stays.
Without W the errors of r would be those of the reflectometer, several times too small.  r and G_j are found by generalised least squares, averaged over what
the readings leave open of q; resets are added one at a time while they are worth it (a BIC that also pays for the choice of the moment).

What this tests is the attenuation.  It says nothing of how dust scatters (w, g): a reflectometer sees one direction.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.errors import ParameterError
from motes.soiling.readings import Series
from motes.trends import Trend

Floats = NDArray[np.float64]

INCIDENCE_DEG = 15.0  # of the D&S 15R reflectometer; stated in the parameters of the Port Augusta set
LEAST_GAIN = 3.0  # standard errors, with the likeliest walk
DOUBTFUL_GAIN = 2.0  # standard errors, with what the readings leave open of the walk


@final
@dataclass(frozen=True)
class Reset:
    """A moment at which a mirror got cleaner.

    Parameters
    ----------
    before, after
        Times of the readings on either side [d].
    gain, stderr
        By how much tau fell.
    rained
        Whether rain was recorded in between; None where it is not known.
    """

    before: float
    after: float
    gain: float
    stderr: float
    rained: bool | None = None

    @property
    def days(self) -> float:
        """The middle [d]."""
        return 0.5 * (self.before + self.after)


@final
@dataclass(frozen=True)
class Soiling:
    """What the readings of one mirror say of its dust; tau is counted from the first reading.

    Parameters
    ----------
    series
        The readings.
    rate, rate_stderr
        Growth of tau [1/d].
    resets
        In order of time.
    walk
        q, the variance that a day adds [1/d]; the mean over what the readings leave open.
    slant
        1/cos(theta_i) + 1/cos(theta_r).
    clean_reflectance, clean_stderr
        R_0, what the mirror had at the first reading, free of the error of that reading.
    coefficients, covariance
        Of y_0, r and the gains.
    """

    series: Series
    rate: float
    rate_stderr: float
    resets: tuple[Reset, ...]
    walk: float
    slant: float
    clean_reflectance: float
    clean_stderr: float
    coefficients: Floats
    covariance: Floats

    def tau(self, days: ArrayLike) -> tuple[Floats, Floats]:
        """tau since the first reading at times (...,) [d], and its standard error: the best linear prediction from all readings.

        The band is narrow at a reading, wider between two, and opens beyond the last.
        """
        t = np.atleast_1d(np.asarray(days, float))
        readings, moments = self.series.days, np.array([r.days for r in self.resets])
        X, x = _design(readings, moments), _design(t, moments)
        x[:, 0] = 0  # tau is y - y_0
        y = -np.log(self.series.reflectance) / self.slant
        V = self._noise() + self.walk * np.minimum.outer(readings, readings)
        C = self.walk * np.minimum.outer(np.maximum(t, 0), readings)
        weights = np.linalg.solve(V, C.T).T  # (T, K)
        mean = x @ self.coefficients + weights @ (y - X @ self.coefficients)
        rest = x - weights @ X
        variance = (
            self.walk * np.maximum(t, 0)
            - np.sum(weights * C, axis=1)
            + np.einsum("tk,kl,tl->t", rest, self.covariance, rest)
        )
        shape = np.shape(days)
        return mean.reshape(shape), np.sqrt(np.maximum(variance, 0)).reshape(shape)

    def attenuation(self, days: ArrayLike) -> Floats:
        """R / R_0 at times [d], by `tau`."""
        return np.exp(-self.tau(days)[0] * self.slant)

    def trend(self, days: float | None = None) -> Trend:
        """The growth of tau on a clean mirror over so many days (by default those observed) as a trend, with its covariance.

        For a material: ``Material(DustLayer(base, dust, 0.0), trends={"tau": fit.trend()})``.  Without the resets, and without the random walk.
        """
        last = float(self.series.days[-1]) if days is None else float(days)
        error = np.diag([0.0, (last * self.rate_stderr) ** 2])
        end = max(self.rate, 0.0) * last
        return Trend("linear", {"start": 0.0, "end": end}, (0.0, 24 * last), (0.0, np.inf), error)

    def _noise(self) -> Floats:
        return _noise(self.series, self.slant)


def slant(theta_i: float, theta_r: float | None = None) -> float:
    """1/cos(theta_i) + 1/cos(theta_r) for angles [rad]; by default those of a mirror, equal."""
    angles = np.array([theta_i, theta_i if theta_r is None else theta_r], float)
    if not (np.isfinite(angles).all() and np.all(np.abs(angles) < np.pi / 2)):
        raise ParameterError(
            f"an angle of {np.abs(angles).max():g} rad is at or below the horizon", "Angles are in radians, under 1.571"
        )
    return float(np.sum(1 / np.cos(angles)))


def fit_soiling(series: Series, *, theta_i: float = np.deg2rad(INCIDENCE_DEG), most_resets: int = 4) -> Soiling:
    """Growth, resets and bands of the dust on one mirror; see the module for the model.

    Parameters
    ----------
    series
        Three or more readings.
    theta_i
        Angle of incidence of the reflectometer [rad].
    most_resets
        At most so many, and never more than leave two readings a coefficient.
    """
    depth = slant(theta_i)
    y = -np.log(series.reflectance) / depth
    noise = _noise(series, depth)
    middles = 0.5 * (series.days[1:] + series.days[:-1])
    chosen: list[int] = []
    best = _likeliest(series.days, y, noise, middles[chosen])
    price = np.log(len(y)) + 2 * np.log(len(middles))
    while len(chosen) < min(most_resets, (len(y) - 4) // 2):
        tries = []
        # Only where tau falls: a reset makes a mirror cleaner.
        for k in (k for k in range(len(middles)) if k not in chosen and y[k + 1] < y[k]):
            found = _likeliest(series.days, y, noise, middles[sorted([*chosen, k])])
            gains, errors = found.c[2:], np.sqrt(np.diag(found.covariance)[2:])
            if np.all(gains > LEAST_GAIN * errors):
                tries.append((found.deviance, k, found))
        if not tries:
            break
        deviance, k, found = min(tries, key=lambda item: item[0])
        if deviance + price >= best.deviance:
            break
        chosen, best = sorted([*chosen, k]), found
    best = _averaged(series.days, y, noise, middles[chosen], best)
    # What the likeliest walk calls a reset may be within reach of a stronger walk.
    while chosen and np.any(weak := best.c[2:] < DOUBTFUL_GAIN * np.sqrt(np.diag(best.covariance)[2:])):
        del chosen[int(np.argmin(np.where(weak, best.c[2:], np.inf)))]
        best = _averaged(series.days, y, noise, middles[chosen], _likeliest(series.days, y, noise, middles[chosen]))
    error = np.sqrt(np.diag(best.covariance))
    resets = tuple(
        Reset(
            float(series.days[k]),
            float(series.days[k + 1]),
            float(best.c[2 + n]),
            float(error[2 + n]),
            None if series.rained is None else bool(series.rained[k]),
        )
        for n, k in enumerate(chosen)
    )
    clean = float(np.exp(-depth * best.c[0]))
    return Soiling(
        series,
        float(best.c[1]),
        float(error[1]),
        resets,
        best.walk,
        depth,
        clean,
        float(clean * depth * error[0]),
        best.c,
        best.covariance,
    )


@dataclass(frozen=True)
class _Found:
    c: Floats
    covariance: Floats
    walk: float
    deviance: float


def _noise(series: Series, depth: float) -> Floats:
    return np.diag((series.stderr / (series.reflectance * depth)) ** 2)


def _design(days: Floats, moments: Floats) -> Floats:
    """Columns 1, t and -[t > t_j]."""
    return np.concatenate([np.ones((len(days), 1)), days[:, None], -(days[:, None] > moments).astype(float)], axis=1)


def _likeliest(days: Floats, y: Floats, noise: Floats, moments: Floats) -> _Found:
    """Generalised least squares with the random walk of greatest likelihood, over a grid that is then refined."""
    X, both = _design(days, moments), np.minimum.outer(days, days)
    unit = float(np.var(np.diff(y)) / np.mean(np.diff(days))) or 1e-12
    grid = np.concatenate([[0.0], unit * np.logspace(-5, 1, 25)])
    deviance, c, covariance = _gls(X, y, noise, both, grid)
    k = int(np.argmin(deviance))
    if k > 0:
        grid = grid[k] * np.logspace(-0.25, 0.25, 11)
        deviance, c, covariance = _gls(X, y, noise, both, grid)
        k = int(np.argmin(deviance))
    return _Found(c[k], covariance[k], float(grid[k]), float(deviance[k]))


def _gls(X: Floats, y: Floats, noise: Floats, both: Floats, walks: Floats) -> tuple[Floats, Floats, Floats]:
    """-2 log likelihood, coefficients and covariances for each variance of the walk (Q,)."""
    V = noise + walks[:, None, None] * both
    inverse = np.linalg.inv(V)
    normal = X.T @ inverse @ X
    covariance: Floats = np.asarray(np.linalg.inv(normal), np.float64)
    c = (covariance @ (X.T @ inverse @ y)[..., None])[..., 0]
    residual = y - c @ X.T
    deviance = np.linalg.slogdet(V)[1] + np.einsum("qk,qkl,ql->q", residual, inverse, residual)
    return deviance, c, covariance


def _averaged(days: Floats, y: Floats, noise: Floats, moments: Floats, found: _Found) -> _Found:
    """The fit averaged over all variances of the walk, by their restricted likelihood and evenly in its standard deviation (Gelman 2006).

    With ten readings the likeliest variance is often 0 where the true one is not; errors that take it at its word are half of what they should be.
    """
    X, both = _design(days, moments), np.minimum.outer(days, days)
    steps = np.diff(y - X @ found.c)
    most = 4 * np.sqrt(np.sum(steps**2) / (days[-1] - days[0])) + 1e-9
    walks = (most * (np.arange(160) + 0.5) / 160) ** 2
    deviance, c, covariance = _gls(X, y, noise, both, walks)
    deviance = deviance - np.linalg.slogdet(covariance)[1]
    weights = np.exp(-0.5 * (deviance - deviance.min()))
    weights /= weights.sum()
    mean = weights @ c
    apart = c - mean
    total = np.einsum("q,qkl->kl", weights, covariance) + np.einsum("q,qk,ql->kl", weights, apart, apart)
    return _Found(mean, total, float(weights @ walks), found.deviance)
