"""The forms of a fit in turn: each texel by the quickest that serves it."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.fitting.losses import Floats
from motes.fitting.texel_kernel import MAX_ITERATIONS, Kernel, Raw, Singles


class Forms:
    """A kernel of the form ``"series"``, and one of another form for the texels that it does not serve.

    These are texels that miss a sample, those that end where the series do, and those whose fit the exact pass at its end says to have ended elsewhere than
    at the minimum.  Which kernel a texel goes through depends on nothing but the texel.  Objectives of the two kernels are rounded differently, by 1e-7 of
    the data's square: what compares objectives asks `one_for` which kernel serves all that is to be compared.
    """

    def __init__(self, quick: Kernel, other: Kernel) -> None:
        assert quick.domain is not None
        self.quick, self.other = quick, other
        self.form = quick.form
        self.domain = quick.domain

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
        """As `Kernel.fit`; what is `held` is alike for all texels."""
        how: dict[str, Any] = {
            "held": held, "covariance": covariance, "limit": limit, "reduction": reduction, "close": close
        }  # fmt: skip
        columns, low, high = self.domain[:3]
        within = points
        if not self.domain.inside(points).all():
            if held is not None and held[columns].any():
                return self.other.fit(data, points, **how)
            within = points.copy()
            within[:, columns] = np.clip(points[:, columns], low, high)
        raw = self.quick.fit(data, within, **how)
        rows = np.flatnonzero(self._left(raw))
        if len(rows):
            raw.replace(rows, self.other.fit(data[rows], points[rows], **how))
        return raw

    def _left(self, raw: Raw) -> NDArray[np.bool_]:
        """The texels that the quick form does not serve."""
        left: NDArray[np.bool_] = (raw.state("partial") > 0) | (raw.state("adrift") > 0)
        return left | self.domain.stopped(raw.points)

    def one_for(self, points: Floats) -> Forms | Kernel:
        """What serves fits that hold the parameter of the series at all of these points (K, P) by one kernel."""
        return self if self.domain.inside(points, 2e-6).all() else self.other
