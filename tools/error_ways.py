"""Ways to compute errors where residuals go together, from one and the same fit: for docs/uncertainty.md.

A fit is recorded once (`recorded`): its scores and parts of its curvature at each direction.  All ways are then sums over these, since the fit is what costs.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

import motes.fitting.uncertainty
from motes.fitting.alike import SIDE, count_of_blocks
from motes.fitting.clusters import Middle, evened, middle_over
from motes.fitting.direction_blocks import Labels, blocks_of, coordinates
from motes.fitting.error_bars import LEVELS
from motes.fitting.problem import Problem
from motes.fitting.students_t import half_width

Floats = NDArray[np.float64]


class Recorded(NamedTuple):
    """A fit at its solution `x` (P,), with the inverse of its curvature (P, P) and, at each direction, scores (N, P) and parts of the curvature (N, P, P)."""

    problem: Problem
    x: Floats
    inverse: Floats
    scores: Floats
    shares: Floats


def full(problem: Problem, slopes: Floats) -> Floats:
    """Derivatives (C, N, P) by all parameters, from those by what acts on each channel (C, N, K)."""
    found = np.zeros((*slopes.shape[:2], problem.size))
    for channel, places in enumerate(problem.layout.index):
        found[channel][:, places] = slopes[channel]
    return found


@contextmanager
def recorded() -> Iterator[list[Recorded]]:
    """Within it, what `motes.fit` takes errors over blocks of, in their order."""
    found: list[Recorded] = []

    def recorder(problem: Problem, x: Floats, inverse: Floats, blocks: Labels) -> Middle:
        residuals, slopes = (part[0] for part in problem.linearised(x[None], slice(0, len(problem.wi)), None))
        derivatives = full(problem, slopes)
        scores = np.einsum("cnp,cn->np", derivatives, residuals)
        shares = np.einsum("cnp,cnq->npq", derivatives, derivatives)
        found.append(Recorded(problem, x, inverse, scores, shares))
        return middle_over(problem, x, inverse, blocks)

    home = motes.fitting.uncertainty
    home.middle_over = recorder  # type: ignore[assignment]
    try:
        yield found
    finally:
        home.middle_over = middle_over


def over_blocks(count: int | None, power: float, side: float = SIDE) -> Callable[[Recorded], Middle]:
    """CR0, CR2 or CR3 (`power` 0, 1/2, 1) over so many blocks, or over as many as have a side of so many distances over which residuals are alike."""

    def way(fit: Recorded) -> Middle:
        wi, wo = fit.problem.wi, fit.problem.wo
        labels = blocks_of(wi, wo, count or count_of_blocks(wi, wo, fit.problem.misses(fit.x), side))
        sums = [np.zeros((int(labels.max()) + 1, *part.shape[1:])) for part in (fit.scores, fit.shares)]
        for total, part in zip(sums, (fit.scores, fit.shares), strict=True):
            np.add.at(total, labels, part)
        found = evened(sums[0], sums[1], fit.inverse, power)
        return Middle(found.matrix * ((len(sums[0]) - 1) / len(sums[0]) if power == 1 else 1.0), found.freedom)

    return way


def by_direction(fit: Recorded) -> Middle:
    """CR2 over directions: only the channels of each go together."""
    return evened(fit.scores, fit.shares, fit.inverse)


def over_distance(length: float) -> Callable[[Recorded], Middle]:
    """Conley's (1999): products of scores at two directions, weighted by a normal kernel of so many radians, and made right on average
    for independent noise; with degrees of freedom of the same kind as those of blocks."""

    def way(fit: Recorded) -> Middle:
        kernel = np.exp(-0.5 * (distances(coordinates(fit.problem.wi, fit.problem.wo)) / length) ** 2)
        count = len(fit.x)
        scale, freedom = np.ones(count), np.ones(count)
        for p in range(count):
            toward = fit.shares @ fit.inverse[:, p]  # (N, P)
            own = toward @ fit.inverse[:, p]
            through = toward @ fit.inverse
            inner = toward.T @ kernel @ through
            trace = own.sum() - np.trace(inner)
            cross = kernel @ (own[:, None] * (kernel @ through))
            square = own @ (kernel**2) @ own - 2 * np.sum(toward * cross) + np.trace(inner @ inner)
            if trace > 0:
                scale[p], freedom[p] = np.sqrt(own.sum() / trace), max(1.0, trace**2 / square)
        matrix = fit.inverse @ (fit.scores.T @ kernel @ fit.scores) @ fit.inverse * np.outer(scale, scale)
        curvature = np.linalg.pinv(fit.inverse)
        return Middle(curvature @ matrix @ curvature, freedom)

    return way


def as_a_field(fit: Recorded) -> Middle:
    """What the model misses as a stationary Gaussian process, another in every repeat and in proportion to the BRDF (Kennedy and O'Hagan, 2001): its
    length, height and the noise beside it by restricted maximum likelihood, which counts the waves that the fit took up."""
    problem = fit.problem
    residuals, slopes = (part[0] for part in problem.linearised(fit.x[None], slice(0, len(problem.wi)), None))
    height = np.maximum(np.abs(problem.predicted(fit.x).T) * problem.wi[:, 2], 1e-12)  # of the linear loss (C, N)
    apart = distances(coordinates(problem.wi, problem.wo))
    some = np.sort(np.random.default_rng(0).permutation(len(apart))[:MOST_LIKELY])
    missed = (residuals / height).mean(axis=0)[some]
    # One column for each channel's own parameters, which are alike but for a factor in the mean of channels.
    columns = np.swapaxes((slopes / height[..., None])[:, some], 0, 1).reshape(len(some), -1)
    left, singular, _ = np.linalg.svd(columns / np.maximum(np.linalg.norm(columns, axis=0), 1e-300))
    contrasts = left[:, np.count_nonzero(singular > 1e-3 * singular[0]) :]
    seen = contrasts.T @ missed
    found = []
    for length in LENGTHS:
        correlation = np.exp(-0.5 * (apart[np.ix_(some, some)] / length) ** 2)
        values, vectors = np.linalg.eigh(contrasts.T @ correlation @ contrasts)
        for noise in NOISES:
            spread = np.maximum(values, 0.0) + noise
            variance = float(np.mean((vectors.T @ seen) ** 2 / spread))
            found.append((len(seen) * np.log(variance) + np.log(spread).sum(), length, noise, variance))
    _, length, noise, variance = min(found)
    moved = full(problem, slopes * height[..., None]).sum(axis=0)
    covariance = np.exp(-0.5 * (apart / length) ** 2) @ moved + noise * moved
    return Middle(variance * moved.T @ covariance, np.full(len(fit.x), 1e6))


def over_waves(fit: Recorded) -> Middle:
    """Spatial correlation principal components (Müller and Watson, Econometrica 90, 2022): the variance by the longest waves of what each direction does
    to a parameter, as many as make the interval of 95 % shortest, and wide enough where pairs correlate by `LARGEST` on average."""
    apart = distances(coordinates(fit.problem.wi, fit.problem.wo))
    pairs = apart[np.triu_indices(len(apart), 1)]
    low, high = 1e-3, 10.0
    for _ in range(40):
        length = np.sqrt(low * high)
        low, high = (length, high) if np.exp(-pairs / length).mean() < LARGEST else (low, length)
    correlation = np.exp(-apart / length)
    centred = correlation - correlation.mean(axis=0)
    centred -= centred.mean(axis=1)[:, None]
    waves = np.linalg.eigh(centred)[1][:, ::-1][:, :MOST_WAVES] * np.sqrt(len(apart))
    toward = np.column_stack([np.ones(len(apart)), waves])
    own = np.linalg.cholesky(toward.T @ correlation @ toward)
    draws = np.abs(np.random.default_rng(0).standard_normal((4000, len(own))) @ own.T)
    best = np.inf, 1, 0.0
    for count in range(2, MOST_WAVES + 1):
        size = np.sqrt(np.mean(draws[:, 1 : count + 1] ** 2, axis=1))
        critical = max(float(np.quantile(draws[:, 0] / size, 0.95)), half_width(0.95, count))
        best = min(best, (critical * half_expected(count), count, critical))
    _, count, critical = best
    moved = fit.scores @ fit.inverse  # (N, P)
    squares = np.mean((waves[:, :count].T @ moved) ** 2, axis=0) * (critical / half_width(0.95, count)) ** 2
    curvature = np.linalg.pinv(fit.inverse)
    return Middle(curvature @ np.diag(squares) @ curvature, np.full(len(fit.x), float(count)))


def half_expected(count: int) -> float:
    """The mean of a standard error by so many independent squares, of which the true one is 1."""
    return math.sqrt(2 / count) * math.exp(math.lgamma(0.5 * (count + 1)) - math.lgamma(0.5 * count))


def distances(at: Floats) -> Floats:
    return np.sqrt(np.sum((at[:, None] - at[None]) ** 2, axis=-1))


#: Lengths [rad] and shares of noise that a Gaussian process is looked for among, at the most at so many directions.
LENGTHS, NOISES, MOST_LIKELY = (0.1, 0.2, 0.4, 0.8), np.geomspace(1e-3, 3, 7), 205
#: The largest mean correlation of pairs that intervals by waves are to hold for, and the most waves.
LARGEST, MOST_WAVES = 0.03, 20
#: The way that Motes goes, and all of them.
OURS = f"blocks {SIDE:g} times as long as residuals are alike, CR2"
WAYS: dict[str, Callable[[Recorded], Middle]] = {
    **{f"{count} blocks, CR2": over_blocks(count, 0.5) for count in (8, 12, 16, 20, 24, 48)},
    "24 blocks, CR3: the jackknife": over_blocks(24, 1.0),
    "8 blocks, CR3": over_blocks(8, 1.0),
    "24 blocks, nothing made up for (CR0)": over_blocks(24, 0.0),
    "blocks as long as residuals are alike, CR2": over_blocks(None, 0.5, 1.0),
    OURS: over_blocks(None, 0.5),
    "blocks twice as long as residuals are alike, CR2": over_blocks(None, 0.5, 2.0),
    "kernel of 0.2 rad (Conley)": over_distance(0.2),
    "kernel of 0.4 rad (Conley)": over_distance(0.4),
    "each direction by itself, CR2": by_direction,
    "waves (Müller and Watson)": over_waves,
    "a Gaussian process, by REML": as_a_field,
}


class Bars(NamedTuple):
    """What is kept of a fit: the solution and its bounds (P,), what has an error, and by each of `WAYS` errors and degrees of freedom (W, P)."""

    x: Floats
    low: Floats
    high: Floats
    squared: Floats
    known: NDArray[np.bool_]
    errors: Floats
    freedom: Floats

    @classmethod
    def of(cls, fit: Recorded) -> Bars:
        middles = [way(fit) for way in WAYS.values()]
        squares = [np.diag(fit.inverse @ middle.matrix @ fit.inverse) for middle in middles]
        columns = fit.problem.columns
        return cls(
            fit.x,
            columns.low[:, 0],
            columns.high[:, 0],
            columns.squared[:, 0],
            np.diag(fit.inverse) > 0,
            np.sqrt(np.maximum(squares, 0.0)),
            np.stack([middle.freedom for middle in middles]),
        )

    def held(self, way: str, truth: Floats, widened: float = 1.0) -> Floats:
        """Whether the intervals of a way hold the truth (P,), which is in the parameters' own units: (2, P), NaN where there is none or the truth is 0."""
        row = list(WAYS).index(way)
        counts = self.known & (truth > 1e-6)
        found = []
        for level in LEVELS.values():
            widths = np.array([half_width(level, float(f"{f:.3g}")) for f in self.freedom[row]])
            ends = np.clip(self.x + np.outer([-1, 1], widened * widths * self.errors[row]), self.low, self.high)
            low, high = np.where(self.squared > 0, np.sqrt(np.maximum(ends, 0.0)), ends)
            found.append(np.where(counts, (low <= truth) & (truth <= high), np.nan))
        return np.array(found)
