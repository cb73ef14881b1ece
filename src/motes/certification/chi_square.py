"""Whether samples follow a density: the chi-square test over the hemisphere, with Sidak's correction for several tests."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from motes.certification.specimen import Floats


def survival(statistic: float, freedom: int) -> float:
    """The chance that chi-square with so many degrees of freedom exceeds `statistic`: Q(freedom/2, statistic/2).

    By the series of the lower incomplete gamma function below its mode and Lentz's continued fraction of the upper one above (DLMF 8.11.4, 8.9.2).

    Examples
    --------
    >>> round(survival(3.841459, 1), 6)
    0.05
    """
    a, x = 0.5 * freedom, 0.5 * statistic
    if x <= 0:
        return 1.0
    scale = math.exp(a * math.log(x) - x - math.lgamma(a)) if x < 1e300 else 0.0
    if x < a + 1:
        term = total = 1 / a
        k = a
        while term > 1e-17 * total:
            k += 1
            term *= x / k
            total += term
        return max(0.0, 1 - scale * total)
    b = x + 1 - a
    c, d = 1e300, 1 / b
    h = d
    for k in range(1, 10_000):
        step = -k * (k - a)
        b += 2
        d = 1 / (step * d + b)
        c = b + step / c
        h *= c * d
        if abs(c * d - 1) < 1e-15:
            break
    return scale * h


def sidak(significance: float, tests: int) -> float:
    """The level at which each of several tests is judged, so that all together fail by chance with `significance` (Sidak 1967)."""
    return -math.expm1(math.log1p(-significance) / tests)


@dataclass(frozen=True)
class Bins:
    """A grid of (cos(theta_r), phi), on which solid angle is uniform, that is fine where the samples of a first draw lie dense."""

    z: Floats
    phi: Floats

    @classmethod
    def of(cls, wo: Floats, n: int = 16, lowest: float = 0.0) -> Bins:
        """From the samples (N, 3) of a first draw; `lowest` is 0 for the hemisphere, -1 for the sphere."""
        wo = wo[wo[:, 2] > lowest]
        tail = np.array([2e-4, 2e-3, 1e-2, 3e-2])  # a rule of few nodes does not see a narrow peak in a wide bin
        inner = np.concatenate([tail, np.linspace(0, 1, n + 1)[1:-1], 1 - tail])
        z, phi = wo[:, 2], np.arctan2(wo[:, 1], wo[:, 0])
        z_edges = np.concatenate(
            [np.quantile(z, inner), np.linspace(lowest, 1, 17 if lowest == 0 else 33)]
        )  # and nowhere coarse
        phi_edges = np.concatenate([np.quantile(phi, inner), np.linspace(-np.pi, np.pi, 25)])
        return cls(np.unique(z_edges), np.unique(phi_edges))

    def count(self, wo: Floats) -> Floats:
        """How many of the samples (N, 3) lie in each bin; those below the lowest of them in none."""
        wo = wo[wo[:, 2] > self.z[0]]
        return np.histogram2d(wo[:, 2], np.arctan2(wo[:, 1], wo[:, 0]), bins=(self.z, self.phi))[0]

    def integrate(self, density: Callable[[Floats], Floats], nodes: int = 8) -> Floats:
        """The integral of a density, of directions (..., 3), over every bin, by a Gauss-Legendre rule in each."""
        x, w = np.polynomial.legendre.leggauss(nodes)
        (z, dz), (phi, dphi) = (
            (0.5 * (e[1:] + e[:-1])[:, None] + 0.5 * np.diff(e)[:, None] * x, 0.5 * np.diff(e)[:, None] * w)
            for e in (self.z, self.phi)
        )
        Z, P = z[:, None, :, None], phi[None, :, None, :]
        r = np.sqrt((1 - Z) * (1 + Z))
        wo = np.stack(np.broadcast_arrays(r * np.cos(P), r * np.sin(P), Z), axis=-1)
        return np.asarray(np.einsum("abij,ai,bj->ab", density(wo), dz, dphi))


def chi_square(observed: Floats, expected: Floats) -> tuple[float, int]:
    """The statistic and its degrees of freedom; the bins that expect least are pooled until they expect 5."""
    order = np.argsort(expected, axis=None)
    observed, expected = observed.ravel()[order], expected.ravel()[order]
    pooled = int(np.searchsorted(np.cumsum(expected), 5.0)) + 1
    first = slice(0, max(pooled, int(np.searchsorted(expected, 5.0))))
    observed = np.concatenate([[observed[first].sum()], observed[first.stop :]])
    expected = np.concatenate([[expected[first].sum()], expected[first.stop :]])
    return float(np.sum((observed - expected) ** 2 / expected)), len(expected) - 1
