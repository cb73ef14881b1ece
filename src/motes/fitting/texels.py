"""Fits of one model to very many texels that were measured at the same directions: the batched solver of the engine.

Every texel is a fit of its own, as `motes.fit` would make it; with trends, all its times together are.  The kernel is generated from the model and from
the steps of a fit (`motes.fitting.printed`) and compiled once.  Only fits with very many coefficients run through the solver of `motes.fit`, some
thousand times slower.
"""

from __future__ import annotations

import threading
from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes import workers
from motes.errors import DataError, MotesError
from motes.fitting.columns import unit_of
from motes.fitting.losses import ROBUST, Floats, Robust
from motes.fitting.metrics import deviation
from motes.fitting.printed.driver import NO_VERDICT
from motes.fitting.printed.module import MOST_COEFFICIENTS
from motes.fitting.printed.rows import LANES
from motes.fitting.second_look import REFIT_ITERATIONS, REFIT_REDUCTION, Rows, Solved, look_again
from motes.fitting.texel_fit import TexelFit, TexelStatus, own_covariance
from motes.fitting.texel_forms import Forms
from motes.fitting.texel_kernel import Kernel, Raw, Recorded, Singles
from motes.fitting.texel_setup import Column, TexelSetup
from motes.fitting.texels_nearest import Nearest, bands
from motes.fitting.texels_slow import fit_slowly
from motes.fitting.texels_starts import representative_starts
from motes.kernels import engine

# The plain fit before a robust one is drawn by what is far off: its errors are large, and a small share of them shows in the median.
FIRST_REDUCTION = 1e-12
# Outliers draw a plain fit away: where it ended so many standard errors from a robust one, that is tried from there as well.
APART = 1.0
# Texels that go through all of a fit together: their states and errors stay in the cache.  Fewer where threads would have none.
MOST_TOGETHER, LEAST_TOGETHER = 16384, 2048

NOT_FINITE = "starts hold a value that is not finite", "Give parameter vectors within the bounds"

# Outliers pull a fit into another valley.  A texel whose residuals are more than this share of its data, and whose fourth moment is so many times the
# square of the second (3 for noise of one size, up to 12 for noise that goes with the value), is tried from all starts.
MISFIT, TAILS = 0.05, 12.0


class TexelSolver(TexelSetup):
    """Fits a model to texels that share directions (and times).

    Parameters
    ----------
    model
        Text (see `motes.models.parse`) or a BRDF.
    wi, wo
        Directions (D, 3), above the horizon.
    channels
        Number of channels.
    hours, trends
        Times (T,) and the kind of trend of each parameter by name (`motes.trends.KINDS`; what is not named is constant); None where every texel has one time.
    loss, robust
        As for `motes.fit`; see `motes.fitting.losses`.
    weights
        Of the directions (D,); None for all alike.
    fixed, per_channel
        As for `motes.fit`.
    device
        None for the compiled engine of the processor, ``"cuda"`` for a graphics card (`motes.kernels.cards`), which gives the same within rounding.

    Raises
    ------
    DataError, ParameterError
        For directions that are not above the horizon, shapes that do not fit, unknown names.
    """

    @cached_property
    def _kernels(self) -> dict[tuple[str, str], Kernel | Forms]:
        return {}

    @cached_property
    def _making(self) -> threading.RLock:
        return threading.RLock()

    _compared: tuple[Floats, Nearest] | None = None

    @cached_property
    def _recorded(self) -> Recorded:
        return Recorded.of(self)

    # ------------------------------------------------------------ fits

    def fit(
        self, values: ArrayLike, starts: ArrayLike, *, own_starts: bool = False, covariance: bool = False
    ) -> TexelFit:
        """Fit every texel.

        Parameters
        ----------
        values
            Measured BRDF [1/sr] (M, D, C), with trends (M, T, D, C), float32; what is NaN or infinite is left out.
        starts
            Parameter vectors (K, P): each texel starts from the one of them that suits it best.  With `own_starts` (M, P): each texel its own.
        covariance
            Whether covariances are wanted.

        Returns
        -------
        TexelFit
            Bit for bit the same for a texel whatever else is in the call, and for any number of threads.
        """
        data = self._checked(values)
        points = np.atleast_2d(np.asarray(starts, float))
        if points.ndim != 2 or points.shape[1] != self.size or (own_starts and len(points) != len(data)):
            expected = f"({len(data) if own_starts else 'K'}, {self.size})"
            raise DataError(f"starts of shape {np.shape(starts)} do not fit", f"Give an array of shape {expected}")
        # Many starts are looked at where they are used.
        if not own_starts and not np.isfinite(points).all():
            raise DataError(*NOT_FINITE)
        if self.unit == 1 and not own_starts and (unit := self.unit_of_starts(points)) != 1:
            return self.in_units(unit).fit(data, points, covariance=covariance)
        if not own_starts:
            points = self._within(points)
        if not self.compiled:
            if self.robust.name != "none" or covariance:
                what = f"robust={self.robust.name}" if self.robust.name != "none" else "covariance"
                why = f"these fits have {self.size} coefficients a texel, and it takes {MOST_COEFFICIENTS} at most"
                raise MotesError(
                    f"{what} needs a compiled kernel: {why if engine.available() else 'LLVM cannot be used here'}",
                    "Hold parameters, choose simpler trends, or leave it out",
                )
            return self.finished(fit_slowly(self, data, self._within(points) if own_starts else points, own_starts))
        if not own_starts and len(points) > 1 and not self.parts:
            self._nearest(points)
        pieces = list(_pieces(len(data), self.times or 1))
        whole = TexelFit.unfilled(len(data), self.size, covariance)

        def work(k: int, _: None) -> None:
            rows = pieces[k]
            start = self._within(points[rows]) if own_starts else points
            whole.fill(rows, self._fitted(data[rows], start, own_starts, covariance))

        if len(pieces) == 1:  # whose kernels share it among threads
            work(0, None)
        else:
            workers.spread(len(pieces), work, lambda: None)
        return whole

    def _within(self, points: Floats) -> Floats:
        """Starts in the coordinates of the fit, within its bounds."""
        if not np.isfinite(points).all():
            raise DataError(*NOT_FINITE)
        return self.within(points)

    def _fitted(self, data: Singles, points: Floats, own_starts: bool, covariance: bool) -> TexelFit:
        """The fits of some texels from points in the coordinates of the fit."""
        noise = None
        robust = self.robust.name != "none"
        raw, directly = self._least_squares(
            data, points, own_starts, covariance and not robust, FIRST_REDUCTION if robust else None
        )
        if robust:
            raw, noise = self._robustly(data, raw, covariance)
            directly = np.ones(len(data), bool)
        self._look_again(data, raw, noise, directly)
        return self.finished(raw)

    @property
    def compiled(self) -> bool:
        """Whether a kernel serves this fit."""
        return self.size <= MOST_COEFFICIENTS and engine.available()

    def _least_squares(
        self, data: Singles, points: Floats, own_starts: bool, covariance: bool, reduction: float | None
    ) -> tuple[Raw, NDArray[np.bool_]]:
        """Without a robust function; and which texels were fitted by the direct form: all of them when a `reduction` is asked for."""
        kernel = self.kernel("cheapest" if reduction is None else "direct")
        chosen = points if own_starts else self._best_start(kernel, data, points)
        raw = kernel.fit(data, chosen, covariance=covariance, reduction=reduction)
        if not own_starts and len(points) > 1:
            self._tried_elsewhere(kernel, data, points, raw, outliers=reduction is None)
        # The model clamps a sample of these at 0, or some have a sample in some channels only: moments do not know of either.
        directly = (raw.state("clamped") > 0) | (raw.state("partial") > 0)
        rows = np.flatnonzero(directly)
        if len(rows):
            near = np.where(np.isfinite(raw.points[rows]), raw.points[rows], chosen[rows])
            part = data[rows]
            again = self.kernel("direct").fit(part, near, covariance=covariance, reduction=reduction)
            if not own_starts and len(points) > 1:
                self._tried_elsewhere(self.kernel("direct"), part, points, again, outliers=reduction is None)
            raw.replace(rows, again)
        return raw, directly

    def _robustly(self, data: Singles, plain: Raw, covariance: bool) -> tuple[Raw, Floats]:
        """As `motes.fit` does it: the noise is taken from a plain fit, the mild function comes first; and the noise of each texel (M,)."""
        mild, robust = self._kernel("direct", ROBUST["soft_l1"]), self._kernel("direct", self.robust)
        start = np.where(np.isfinite(plain.points), plain.points, self.facts.low[:, 0])
        noise = deviation(mild.residuals(data, start))
        first = mild.fit(data, start, noise=noise, close=False)
        best = robust.fit(data, first.points, noise=noise, covariance=covariance)
        far = np.flatnonzero(best.apart(self.values(start), APART) & (robust is not mild))
        if len(far):
            other = robust.fit(data[far], start[far], noise=noise[far], covariance=covariance)
            better = np.flatnonzero(other.state("objective") < best.state("objective")[far] * (1 - 1e-9))
            best.replace(far[better], other.rows(better))
        return best, noise

    def _checked(self, values: ArrayLike) -> Singles:
        data = np.ascontiguousarray(values, np.float32)
        times = () if self.hours is None else (len(self.hours),)
        shape = (*times, len(self.wi), self.channels)
        if data.ndim != len(shape) + 1 or data.shape[1:] != shape:
            raise DataError(
                f"values of shape {data.shape} do not fit the directions, times and channels",
                f"Expected (M, {', '.join(map(str, shape))})",
            )
        return data

    def _best_start(self, kernel: Kernel | Forms, data: Singles, starts: Floats) -> Floats:
        """For every texel the start from which the parameters that are not `_curved` alone get closest to the data."""
        if len(starts) == 1:
            return np.repeat(starts, len(data), axis=0)
        if self.parts:  # `Nearest` knows one time
            return self._best_tried(kernel, data, starts)
        best, missing = self._nearest(starts).points(data)
        if missing.any():
            best[missing] = self._best_tried(kernel, data[missing], starts)
        return best

    def _nearest(self, starts: Floats) -> Nearest:
        compared = self._compared
        if compared is None or not np.array_equal(compared[0], starts):
            compared = self._compared = starts.copy(), Nearest(self.linear, starts, self._curved())
        return compared[1]

    def _best_tried(self, kernel: Kernel | Forms, data: Singles, starts: Floats) -> Floats:
        """The same by a few iterations from every start."""
        if isinstance(kernel, Forms):
            kernel = kernel.one_for(starts)
        best = np.empty((len(data), self.size))
        least = np.full(len(data), np.inf)
        for start in starts:
            tried = kernel.fit(
                data, np.repeat(start[None], len(data), axis=0), held=self._curved(), limit=3, close=False
            )
            objective = np.nan_to_num(tried.state("objective"), nan=np.inf)
            better = objective < least
            least[better] = objective[better]
            best[better] = np.where(np.isfinite(tried.points[better]), tried.points[better], start)
        best[~np.isfinite(least)] = starts[0]
        return best

    def _tried_elsewhere(
        self, kernel: Kernel | Forms, data: Singles, starts: Floats, raw: Raw, *, outliers: bool
    ) -> None:
        """Fit texels that ended at a bound of a curved column, or with `outliers`, again: from all starts, with `outliers` from the best of `bands` too.

        A highlight of the least width allowed is mostly a false minimum: a spike at one sample.
        """
        low, high = self.facts.low[:, 0], self.facts.high[:, 0]
        with np.errstate(invalid="ignore"):
            margin = 1e-6 * (1 + np.abs(raw.points))
            stuck = (raw.points <= low + margin) | (raw.points >= high - margin)
        doubtful = (stuck & self._curved()).any(axis=1)
        far = _with_outliers(raw) if outliers else np.zeros(len(data), bool)
        rows, far = np.flatnonzero(doubtful | far), np.flatnonzero(far)
        if not len(rows):
            return
        covariance = raw.covariances.shape[1] > 0

        def tried(rows: Rows, part: Singles, points: Floats) -> None:
            again = kernel.fit(part, points, covariance=covariance)
            better = np.flatnonzero(again.state("squares") < raw.state("squares")[rows] * (1 - 1e-6))
            raw.replace(rows[better], again.rows(better))

        part = data[rows]
        for start in starts:
            tried(rows, part, np.repeat(start[None], len(rows), axis=0))
        if len(far) and not self.parts:
            part = data[far]
            for band in self._bands:
                points, missing = band.points(part)
                points[missing] = starts[0]
                tried(far, part, points)

    @cached_property
    def _bands(self) -> tuple[Nearest, ...]:
        """Where texels with outliers are tried besides; the starts of a map are those of texels without, and few."""
        held = self._curved()
        return tuple(Nearest(self.linear, points, held) for points in bands(self, held))

    def _curved(self) -> NDArray[np.bool_]:
        """The columns along which an objective has several valleys: those that `_best_start` holds."""
        return np.array([bool(c.parameter.starts) or not c.value for c in self.columns])

    def _look_again(self, data: Singles, raw: Raw, noise: Floats | None, directly: NDArray[np.bool_]) -> None:
        """Verdicts that need another fit, with a parameter held elsewhere: see `motes.fitting.second_look`."""
        asked = raw.state("asks") > 0
        for direct in (False, True):
            rows = np.flatnonzero(asked & (directly == direct))
            if len(rows):
                part = raw.rows(rows)
                self._judge_again(data[rows], part, None if noise is None else noise[rows], direct)
                raw.codes[rows] = part.codes

    def _judge_again(self, data: Singles, raw: Raw, noise: Floats | None, direct: bool) -> None:
        """The same of texels that were fitted by the direct form, or not."""
        kernel = self._kernel("direct" if direct else "moments", self.robust)
        objective = raw.state("objective")
        if not direct and kernel is not self.kernel("cheapest", self.robust):
            objective = kernel.fit(data, raw.points, limit=0, close=False).state("objective")
        solved = Solved(
            x=raw.points,
            value=raw.values.astype(float),
            stderr=raw.errors.astype(float),
            objective=objective,
            noise=raw.state("noise"),
            brightness=raw.state("brightness"),
            verdicts=raw.codes,
        )
        how: dict[str, Any] = {"limit": REFIT_ITERATIONS, "reduction": REFIT_REDUCTION, "close": False}

        def refit(points: Floats, held: NDArray[np.bool_], fits: Rows) -> Floats:
            units = None if noise is None else noise[fits]
            return kernel.fit(data[fits], points, noise=units, held=held, **how).state("objective")

        def diagonal(points: Floats, fits: Rows) -> Floats:
            return kernel.diagonal(data[fits], points, None if noise is None else noise[fits])

        with np.errstate(invalid="ignore"):
            look_again(solved, self.facts, self.groups, refit, diagonal)

    def finished(self, raw: Raw) -> TexelFit:
        """What callers want of what a kernel found."""
        samples, brightness = raw.state("samples"), raw.state("brightness")
        status = np.where(raw.state("running") > 0, TexelStatus.MAX_ITERATIONS, TexelStatus.CONVERGED).astype(np.uint8)
        status[np.isnan(raw.values[:, 0])] = TexelStatus.FAILED
        status[(samples <= self.size) | (brightness == 0)] = TexelStatus.NO_DATA
        with np.errstate(all="ignore"):
            rms = np.sqrt(raw.state("squares") / brightness).astype(np.float32)
        rms[np.isnan(raw.values[:, 0])] = np.nan
        iterations = np.minimum(raw.state("iterations"), 255).astype(np.uint8)
        whole = own_covariance(raw.covariances, raw.errors) if raw.covariances.shape[1] else None
        return TexelFit(raw.values, raw.errors, rms, status, iterations, raw.codes, whole)

    def kernel(self, form: str, robust: Robust = ROBUST["none"]) -> Kernel | Forms:
        """The compiled fit in a form of the normal equations: ``"direct"``, ``"moments"`` (or direct where that is cheaper), or the ``"cheapest"``."""
        with self._making:
            if (form, robust.name) not in self._kernels:
                self._kernels[form, robust.name] = self._made(form, robust)
            return self._kernels[form, robust.name]

    def _made(self, form: str, robust: Robust) -> Kernel | Forms:
        quick = self._recorded.equations_of_whole(self, robust) if form == "cheapest" else None
        if quick is not None:
            return Forms(Kernel(self, self._recorded, quick, robust), self._kernel("moments", robust))
        return Kernel(self, self._recorded, self._recorded.equations(self, form, robust), robust)

    def _kernel(self, form: str, robust: Robust) -> Kernel:
        """One that serves all texels."""
        kernel = self.kernel(form, robust)
        assert isinstance(kernel, Kernel)
        return kernel

    def starts(self, values: ArrayLike) -> Floats:
        """Where fits of texels like these start well: up to six parameter vectors (K, P), from full searches on each of a few texels.

        Parameters
        ----------
        values
            As for `fit`, of some texels (a few dozen) from all over a map.
        """
        data = self._checked(values)
        solver = self.in_units(unit_of(data, np.isfinite(data)))
        return representative_starts(solver, data, lambda rows, starts: solver.fit(data[rows], starts).x)


def _pieces(count: int, times: int) -> Iterator[slice]:
    """All texels in pieces, ever smaller ones towards the end: threads then end together."""
    first, least = 0, max(LANES, LEAST_TOGETHER // times)
    while first < max(1, count):
        step = min(MOST_TOGETHER, max(least, (count - first) // (2 * workers.threads())))
        last = min(count, first + -(-step // LANES) * LANES)
        yield slice(first, last)
        first = max(last, 1)


def _with_outliers(raw: Raw) -> NDArray[np.bool_]:
    """Which texels have residuals that are large, and some of them much larger than the others (M,)."""
    squares = raw.state("squares")
    with np.errstate(invalid="ignore"):
        heavy = raw.state("fourth") * raw.state("samples") > TAILS * squares * squares
        return np.asarray(heavy & (squares > MISFIT * MISFIT * raw.state("brightness")))


__all__ = ["NO_VERDICT", "Column", "Raw", "TexelFit", "TexelSolver", "TexelStatus"]
