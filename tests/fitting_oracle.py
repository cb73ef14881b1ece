"""What the tests of the fit compare it with: the appendices' formulas typed a second time from the printed page, and
SciPy.

Nothing here comes from `motes`: angles are taken through arccos and arctan2 where the library uses half vectors and
components, derivatives are SciPy's finite differences where the library traces its own, and the minimiser is
`scipy.optimize.least_squares` (trust region reflective) from random points.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from scipy.optimize import least_squares

INFINITY = float("inf")
# The ranges from which random starts are drawn, and the bounds of the search (those that the models document).
STARTS = {
    "K_d": (0.01, 1.2),
    "sigma_d": (0.02, 1.4),
    "K_s": (0.001, 2.0),
    "sigma_s": (0.01, 1.2),
    "w": (0.05, 1.5),
    "g": (-0.8, 0.8),
    "tau": (0.01, 3.0),
}
BOUNDS = {
    "K_d": (0, INFINITY),
    "sigma_d": (0, np.pi / 2),
    "K_s": (0, INFINITY),
    "sigma_s": (0.005, np.pi / 2),
    "w": (0, 10),
    "g": (-0.98, 0.98),
    "tau": (0, 30),
}
PER_CHANNEL = {"K_d", "w"}
# Of more samples than these, random starts are followed on an even part first; so many of its best ends go on with all.
FEW, KEPT = 4000, 2


class Formulas:
    """The appendices at fixed pairs of directions (N, 3); values (N, 1) or (N, C)."""

    def __init__(self, wi: np.ndarray, wo: np.ndarray) -> None:
        self.theta_i, self.theta_r = (np.arccos(np.clip(w[:, 2:3], -1, 1)) for w in (wi, wo))
        azimuth = np.arctan2(wo[:, 1:2], wo[:, 0:1]) - np.arctan2(wi[:, 1:2], wi[:, 0:1])
        vertical = (np.sin(self.theta_i) < 1e-9) | (np.sin(self.theta_r) < 1e-9)
        self.cos_phi = np.where(vertical, 0.0, np.cos(azimuth))
        half = wi + wo
        half = half / np.linalg.norm(half, axis=1, keepdims=True)
        self.cos_h = half[:, 2:3]
        self.theta_h = np.arctan2(np.hypot(half[:, 0:1], half[:, 1:2]), self.cos_h)
        self.cos_d = np.sum(wi * half, axis=1, keepdims=True)
        self.mu_i, self.mu_r = wi[:, 2:3], wo[:, 2:3]
        self.cos_gamma = -np.sum(wi * wo, axis=1, keepdims=True)

    def oren_nayar(self, K_d: Any, sigma_d: Any) -> np.ndarray:
        linear, quadratic = self.oren_nayar_parts(sigma_d)
        return np.maximum(K_d * linear + np.square(K_d) * quadratic, 0)

    def oren_nayar_parts(self, sigma_d: Any) -> tuple[np.ndarray, np.ndarray]:
        """What multiplies K_d in equation (1), and K_d^2 in equation (7)."""
        s2 = sigma_d**2
        a, b = np.maximum(self.theta_r, self.theta_i), np.minimum(self.theta_r, self.theta_i)
        c1 = 1 - 0.5 * s2 / (s2 + 0.33)
        c2 = 0.45 * s2 / (s2 + 0.09) * np.where(self.cos_phi >= 0, np.sin(a), np.sin(a) - (2 * b / np.pi) ** 3)
        c3 = 0.125 * s2 / (s2 + 0.09) * (4 * a * b / np.pi**2) ** 2
        direct = c1 + self.cos_phi * c2 * np.tan(b) + (1 - np.abs(self.cos_phi)) * c3 * np.tan((a + b) / 2)
        return direct / np.pi, 0.17 / np.pi * s2 / (s2 + 0.13) * (1 - self.cos_phi * (2 * b / np.pi) ** 2)

    def torrance_sparrow(self, K_s: Any, sigma_s: Any) -> np.ndarray:
        attenuation = np.minimum(1, 2 * self.cos_h * np.minimum(self.mu_i, self.mu_r) / self.cos_d)
        return K_s * np.exp(-((self.theta_h / sigma_s) ** 2)) * attenuation / (4 * self.mu_i * self.mu_r)

    def dielectric(self, n: Any) -> np.ndarray:
        """Fresnel's equations by angles: F of equation (9) at the facet."""
        i = np.arccos(np.clip(self.cos_d, 0, 1))
        t = np.arcsin(np.sin(i) / n)
        r_s = (np.cos(i) - n * np.cos(t)) / (np.cos(i) + n * np.cos(t))
        r_p = (n * np.cos(i) - np.cos(t)) / (n * np.cos(i) + np.cos(t))
        return 0.5 * (r_s**2 + r_p**2)

    def dust(self, w: Any, g: Any) -> np.ndarray:
        phase = (1 - g**2) / (1 + g**2 - 2 * g * self.cos_gamma) ** 1.5
        return w * phase / (4 * np.pi * (self.mu_i + self.mu_r))

    def covered(self, base: np.ndarray, dust: np.ndarray, tau: Any) -> np.ndarray:
        through = np.exp(-tau * (1 / self.mu_i + 1 / self.mu_r))
        return through * base + (1 - through) * dust


MODELS: dict[str, tuple[tuple[str, ...], Callable[..., np.ndarray]]] = {
    "lambert": (
        ("K_d",),
        lambda at, K_d: np.broadcast_to(K_d / np.pi, np.broadcast_shapes(np.shape(K_d), at.mu_i.shape)),
    ),
    "oren_nayar": (("K_d", "sigma_d"), lambda at, K_d, sigma_d: at.oren_nayar(K_d, sigma_d)),
    "oren_nayar + torrance_sparrow": (
        ("K_d", "sigma_d", "K_s", "sigma_s"),
        lambda at, K_d, sigma_d, K_s, sigma_s: at.oren_nayar(K_d, sigma_d) + at.torrance_sparrow(K_s, sigma_s),
    ),
    "dust_layer(oren_nayar)": (
        ("K_d", "sigma_d", "w", "g", "tau"),
        lambda at, K_d, sigma_d, w, g, tau: at.covered(at.oren_nayar(K_d, sigma_d), at.dust(w, g), tau),
    ),
    "dust_layer(oren_nayar + torrance_sparrow)": (
        ("K_d", "sigma_d", "K_s", "sigma_s", "w", "g", "tau"),
        lambda at, K_d, sigma_d, K_s, sigma_s, w, g, tau: at.covered(
            at.oren_nayar(K_d, sigma_d) + at.torrance_sparrow(K_s, sigma_s), at.dust(w, g), tau
        ),
    ),
}
LOSSES: dict[str, Callable[[np.ndarray, np.ndarray], np.ndarray]] = {
    "linear": lambda f, mu: f * mu,
    "plain": lambda f, mu: f + 0 * mu,
    "log": lambda f, mu: np.log(1 + f * mu),
    "cube_root": lambda f, mu: np.cbrt(f * mu),
}


@dataclass
class Oracle:
    """One fit of SciPy's: parameters in the order of `MODELS`, K_d and w with a value for each channel."""

    wi: np.ndarray
    wo: np.ndarray
    values: np.ndarray  # (N, C)
    model: str
    loss: str = "linear"
    weights: np.ndarray | None = None  # (N, C), mean 1
    held: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.at = Formulas(self.wi, self.wo)
        self.names, self.formula = MODELS[self.model]
        self.free = [name for name in self.names if name not in self.held]
        channels = self.values.shape[1]
        self.sizes = [channels if name in PER_CHANNEL else 1 for name in self.free]
        self.target = LOSSES[self.loss](self.values, self.at.mu_i)
        self.root = np.ones_like(self.values) if self.weights is None else np.sqrt(self.weights)

    def residuals(self, x: np.ndarray) -> np.ndarray:
        parts = np.split(x, np.cumsum(self.sizes)[:-1])
        given = dict(zip(self.free, parts, strict=True)) | dict(self.held)
        f = self.formula(self.at, *(given[name] for name in self.names))
        return (self.root * (LOSSES[self.loss](f, self.at.mu_i) - self.target)).ravel()

    def spans(self, table: Mapping[str, tuple[float, float]]) -> tuple[np.ndarray, np.ndarray]:
        low, high = zip(
            *(table[name] for name, n in zip(self.free, self.sizes, strict=True) for _ in range(n)), strict=True
        )
        return np.array(low, float), np.array(high, float)

    def solve(self, x0: np.ndarray, **options: Any) -> Any:
        with np.errstate(all="ignore"):
            return least_squares(
                self.residuals, x0, bounds=self.spans(BOUNDS), method="trf", x_scale="jac", max_nfev=400, **options
            )

    def best(self, starts: int = 20, seed: int = 0, **options: Any) -> Any:
        """The best of `starts` random starts, an OptimizeResult."""
        low, high = self.spans(STARTS)
        rng = np.random.default_rng(seed)
        return best_of(self, [rng.uniform(low, high) for _ in range(starts)], **options)


@dataclass
class Projected:
    """Oren-Nayar and Torrance-Sparrow with a K_d for each of many channels, by variable projection (Golub and Pereyra
    1973): SciPy searches the few shared parameters, and K_d of each channel is the best one given these.

    For losses that are linear in f the sum of squares of a channel is a quartic in its K_d, whose coefficients are sums over
    the samples.  Where the model is cut off at 0 (sigma_d > 0.7) the quartic is not quite it; the residuals always are.
    """

    wi: np.ndarray
    wo: np.ndarray
    values: np.ndarray
    loss: str = "linear"
    dielectric: bool = False

    def __post_init__(self) -> None:
        self.at = Formulas(self.wi, self.wo)
        self.factor = self.at.mu_i if self.loss == "linear" else np.ones_like(self.at.mu_i)
        self.names = ["sigma_d", "K_s", "sigma_s"] + ["n"] * self.dielectric

    def highlight(self, x: np.ndarray) -> np.ndarray:
        f = self.at.torrance_sparrow(x[1], x[2])
        return f * self.at.dielectric(x[3]) if self.dielectric else f

    def K_d(self, x: np.ndarray) -> np.ndarray:
        linear, quadratic = (self.factor * part for part in self.at.oren_nayar_parts(x[0]))
        rest = self.factor * (self.values - self.highlight(x))
        aa, ab, bb = (np.sum(p * q) for p, q in ((linear, linear), (linear, quadratic), (quadratic, quadratic)))
        ra, rb = (np.sum(part * rest, axis=0) for part in (linear, quadratic))
        K = np.maximum(ra / aa, 0)
        for _ in range(20):
            slope = K * (aa + K * (3 * ab + 2 * bb * K)) - ra - 2 * rb * K
            K = np.maximum(K - slope / (aa + 6 * ab * K + 6 * bb * K**2 - 2 * np.minimum(rb, 0)), 0)
        return K

    def residuals(self, x: np.ndarray) -> np.ndarray:
        f = self.at.oren_nayar(self.K_d(x), x[0]) + self.highlight(x)
        return (self.factor * (f - self.values)).ravel()

    def solve(self, x0: np.ndarray) -> Any:
        low, high = np.array([(0, np.pi / 2), (0, INFINITY), (0.005, np.pi / 2), (1.02, 4)])[: len(self.names)].T
        with np.errstate(all="ignore"):
            return least_squares(self.residuals, x0, bounds=(low, high), method="trf", x_scale="jac", max_nfev=100)

    def best(self, starts: int = 20, seed: int = 0) -> Any:
        rng = np.random.default_rng(seed)
        drawn = [
            [rng.uniform(0, 1.2), 10 ** rng.uniform(-2, 3), 10 ** rng.uniform(-2, 0), rng.uniform(1.1, 2.5)]
            for _ in range(starts)
        ]
        return best_of(self, [np.array(x[: len(self.names)]) for x in drawn])


def best_of(oracle: Oracle | Projected, points: list[np.ndarray], **options: Any) -> Any:
    """The best end of searches from all points; of many samples an even part tells which are worth following to the end."""
    step = oracle.values.size // FEW
    if step > 1:
        part = replace(oracle, wi=oracle.wi[::step], wo=oracle.wo[::step], values=oracle.values[::step])
        ends = sorted((part.solve(x, **options) for x in points), key=lambda end: end.cost)
        points = [end.x for end in ends[:KEPT]]
    return min((oracle.solve(x, **options) for x in points), key=lambda end: end.cost)


def scattered(n: int, seed: int = 0, widest: float = 1.35) -> tuple[np.ndarray, np.ndarray]:
    """`n` pairs of directions (n, 3) up to `widest` [rad] from the normal, half of them near the mirror direction."""
    rng = np.random.default_rng([seed, 19])

    def even() -> np.ndarray:
        z, phi = rng.uniform(np.cos(widest), 1, n), rng.uniform(-np.pi, np.pi, n)
        r = np.sqrt(1 - z * z)
        return np.stack([r * np.cos(phi), r * np.sin(phi), z], axis=1)

    wi, wo = even(), even()
    near = wi * [-1, -1, 1] + rng.normal(0, 0.15, (n, 3))
    near[:, 2] = np.abs(near[:, 2])
    near /= np.linalg.norm(near, axis=1, keepdims=True)
    good = (np.arange(n) < n // 2) & (near[:, 2] > np.cos(widest))
    return wi, np.where(good[:, None], near, wo)
