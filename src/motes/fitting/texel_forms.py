"""The forms of a fit in turn: each texel by the quickest that serves it."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.fitting.losses import Floats
from motes.fitting.printed.series import FLOOR
from motes.fitting.texel_kernel import MAX_ITERATIONS, Kernel, Raw, Singles


class Forms:
    """A kernel of the form ``"series"``, and one of another form for the texels that it does not serve.

    These are texels that miss a sample, those that end where the series do, and those whose fit the exact pass at its end says to have ended elsewhere than
    at the minimum.  Which kernel a texel goes through depends on nothing but the texel.
    """

    def __init__(self, quick: Kernel, other: Kernel) -> None:
        self.quick, self.other = quick, other
        self.form = quick.form

    def fit(
        self,
        data: Singles,
        points: Floats,
        *,
        held: NDArray[np.bool_] | None = None,
        covariance: bool = False,
        limit: int = MAX_ITERATIONS,
        reduction: float | None = None,
        close: bool = True,
        noise: Floats | None = None,
    ) -> Raw:
        """As `Kernel.fit`."""
        quick = self.quick
        within = np.clip(points, quick.low, quick.high)
        fixed = np.zeros(quick.size, bool) if held is None else held
        served = ~((within != points) & fixed).any(axis=1)
        how: dict[str, Any] = {"covariance": covariance, "limit": limit, "reduction": reduction, "close": close}

        def fitted(kernel: Kernel, at: Floats, rows: NDArray[np.intp]) -> Raw:
            if len(rows) == len(data):
                return kernel.fit(data, at, held=held, **how)
            own = held if held is None or held.ndim == 1 else held[rows]
            return kernel.fit(data[rows], at[rows], held=own, **how)

        rows = np.flatnonzero(served)
        if not len(rows):
            return self.other.fit(data, points, held=held, **how)
        raw = fitted(quick, within, rows)
        raw.state("objective")[:] -= 0.5 * FLOOR * raw.state("brightness")
        if len(rows) < len(data):
            some, raw = raw, Raw.at(points, raw.covariances.shape[1])
            raw.replace(rows, some)
        rows = np.flatnonzero(~served | self._left(raw))
        if len(rows):
            raw.replace(rows, fitted(self.other, points, rows))
        return raw

    def _left(self, raw: Raw) -> NDArray[np.bool_]:
        """The texels that the quick form does not serve."""
        quick = self.quick
        with np.errstate(invalid="ignore"):
            margin = 1e-6 * (1 + np.abs(raw.points))
            at_low = (raw.points <= quick.low + margin) & quick.narrowed_low
            at_high = (raw.points >= quick.high - margin) & quick.narrowed_high
        return np.asarray((at_low | at_high).any(axis=1) | (raw.state("partial") > 0) | (raw.state("adrift") > 0), bool)

    def diagonal(self, data: Singles, points: Floats, noise: Floats | None) -> Floats:
        """As `Kernel.diagonal`."""
        return self.other.diagonal(data, points, noise)
