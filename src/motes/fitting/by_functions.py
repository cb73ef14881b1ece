"""A fit's sums over samples by the few functions that a model separates into (`motes.kernels.separated`), instead of by its derivatives.

With f = sum of q_k b_k, the derivatives of a residual are sums of the same b_k: gradient and matrix are made of the products of these with each other and with
the residuals.  Three channels share them all, and functions without parameters meet each other once.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from motes.fitting.channel_layout import ChannelLayout
from motes.fitting.covariance import LEAST_REMAINDER
from motes.fitting.data_passes import in_passes
from motes.fitting.losses import Floats
from motes.fitting.solver import Normal
from motes.kernels.separated import Separated

# Elements of a pass that are worked on at a time: few enough that all of them stay in cache.
CHUNK = 1 << 16


class _Sums(NamedTuple):
    """Over samples, for B vectors: products of the M functions with parameters and the residuals of C channels with the others (B, M + C, F) and
    with themselves (B, M + C, M + C); and what the products of all with those that are clamped have where the clamp acts (B, C, F', F + M + 1), if anywhere."""

    across: Floats
    within: Floats
    clamped: Floats | float

    def with_(self, other: _Sums) -> _Sums:
        return _Sums(self.across + other.across, self.within + other.within, self.clamped + other.clamped)


@dataclass(frozen=True)
class ByFunctions:
    """Data whose residuals are a number for each sample, times f, less another one.

    Attributes
    ----------
    made
        The model.
    fixed, columns
        Functions without parameters (F, N), and what the others need of directions, (N,) each.
    weights
        What f is multiplied by (N,), the same in all channels.
    targets
        The data, multiplied as well (C, N).
    layout
        Of the parameter vector.
    """

    made: Separated
    fixed: Floats
    columns: tuple[Floats, ...]
    weights: Floats
    targets: Floats
    layout: ChannelLayout

    @cached_property
    def weighted(self) -> Floats:
        return self.fixed * self.weights

    @cached_property
    def gram(self) -> Floats:
        return np.asarray(self.weighted @ self.weighted.T)

    def at_directions(self, rows: NDArray[np.intp]) -> Self:
        return replace(
            self,
            fixed=self.fixed.take(rows, axis=1),
            columns=tuple(column.take(rows) for column in self.columns),
            weights=self.weights.take(rows),
            targets=self.targets.take(rows, axis=1),
        )

    def _coefficients(self, parameters: dict[str, Any], batch: int) -> tuple[Floats, Floats]:
        """Of the model (B, C, F + M) and of its derivatives (B, C, F + M, K)."""
        shape = (batch, len(self.targets), self.made.fixed + self.made.mixed)
        found = self.made.coefficients(parameters)
        values, derivatives = np.zeros(shape), np.zeros((*shape, len(self.layout.order)))
        for b, q in self.made.values:
            values[:, :, b] = found[q]
        for k, name in enumerate(self.layout.order):
            for b, q in self.made.derivatives[name]:
                derivatives[:, :, b, k] = found[q]
        return values, derivatives

    def _both(self, parameters: dict[str, Any], rows: slice, values: Floats) -> tuple[Floats, Floats]:
        """Functions with parameters and residuals (B, M + C, n), and what is clamped (B, C, n)."""
        made, weights = self.made, self.weights[rows]
        batch, channels, _ = values.shape
        both = np.empty((batch, made.mixed + channels, len(weights)))
        residual = both[:, made.mixed :]
        for k, b in enumerate(made.functions(tuple(column[rows] for column in self.columns), parameters)):
            np.multiply(b, weights, out=both[:, k])
        fixed = self.weighted[:, rows]
        of_clamp = np.matmul(values[:, :, : made.clamped], fixed[: made.clamped])
        np.subtract(np.maximum(of_clamp, 0.0) if made.clamped else of_clamp, self.targets[:, rows], out=residual)
        if made.clamped < made.fixed:
            residual += np.matmul(values[:, :, made.clamped : made.fixed], fixed[made.clamped :])
        for k in range(made.mixed):
            q = values[:, :, made.fixed + k, None]
            if q.any():  # not a slope
                residual += q * both[:, None, k]
        return both, of_clamp

    def normal(self, parameters: dict[str, Any], batch: int) -> Normal:
        """Objectives and normal equations; `parameters` (B, C) or (B, 1)."""
        made, (_, count) = self.made, self.targets.shape
        values, derivatives = self._coefficients(parameters, batch)

        def part(rows: slice) -> _Sums:
            both, of_clamp = self._both(parameters, rows, values)
            fixed = self.weighted[:, rows]
            across = (both.reshape(-1, both.shape[-1]) @ fixed.T).reshape(*both.shape[:2], len(fixed))
            clamped: Floats | float = 0.0
            if made.clamped and of_clamp.min() < 0:
                clamped = self._where_clamped(both, of_clamp, fixed)
            # A product with a copy: one with itself goes another way in NumPy, which takes three times as long for so few rows.
            return _Sums(across, both @ np.swapaxes(both.copy(), 1, 2), clamped)

        with np.errstate(all="ignore"):
            parts = in_passes(part, count, batch * len(self.targets), CHUNK)
            sums = parts[0]
            for more in parts[1:]:
                sums = sums.with_(more)
            return self._assembled(sums, derivatives)

    def _where_clamped(self, both: Floats, of_clamp: Floats, fixed: Floats) -> Floats:
        made, (batch, channels, _) = self.made, of_clamp.shape
        found = np.zeros((batch, channels, made.clamped, made.fixed + made.mixed + 1))
        acts = of_clamp < 0
        lanes, own = np.nonzero(acts.any(axis=2))
        there = acts[lanes, own][:, None] * fixed[: made.clamped]  # (L, F', n)
        found[lanes, own, :, : made.fixed] = there @ fixed.T
        found[lanes, own, :, made.fixed : -1] = there @ np.swapaxes(both[lanes, : made.mixed], 1, 2)
        found[lanes, own, :, -1] = (there @ both[lanes, made.mixed + own, :, None])[..., 0]
        return found

    def _assembled(self, sums: _Sums, derivatives: Floats) -> Normal:
        made, (batch, channels, functions, _) = self.made, derivatives.shape
        f, m, c = made.fixed, made.mixed, made.clamped
        acts = not isinstance(sums.clamped, float)
        products = np.empty((batch, channels if acts else 1, functions, functions))
        products[..., :f, :f] = self.gram
        products[..., f:, :f] = sums.across[:, None, :m]
        products[..., :f, f:] = np.swapaxes(sums.across[:, None, :m], 2, 3)
        products[..., f:, f:] = sums.within[:, None, :m, :m]
        pushed = np.empty((batch, channels, functions))
        pushed[..., :f], pushed[..., f:] = sums.across[:, m:], sums.within[:, m:, :m]
        if acts:
            gone = np.asarray(sums.clamped)
            products[..., :c, :] -= gone[..., :-1]
            products[..., c:, :c] -= np.swapaxes(gone[..., c:-1], 2, 3)
            pushed[..., :c] -= gone[..., -1]
        objective = 0.5 * np.einsum("bcc->b", sums.within[:, m:, m:])
        along = np.swapaxes(derivatives, 2, 3)
        gradient = (along @ pushed[..., None])[..., 0]
        return Normal(objective, self.layout.vector(gradient), self.layout.matrix(along @ (products @ derivatives)))

    def predicted(self, parameters: dict[str, Any]) -> Floats:
        """The BRDF (C, N)."""
        made, (channels, count) = self.made, self.targets.shape
        values = self._coefficients(parameters, 1)[0][0]

        def part(rows: slice) -> Floats:
            f: Floats = values[:, : made.clamped] @ self.fixed[: made.clamped, rows]
            if made.clamped:
                np.maximum(f, 0.0, out=f)
            if made.clamped < made.fixed:
                f += values[:, made.clamped : made.fixed] @ self.fixed[made.clamped :, rows]
            for k, b in enumerate(made.functions(tuple(column[rows] for column in self.columns), parameters)):
                q = values[:, made.fixed + k, None]
                if q.any():
                    f += q * b
            return f

        with np.errstate(all="ignore"):
            return np.concatenate(in_passes(part, count, channels, CHUNK), axis=-1)

    def spread(self, parameters: dict[str, Any], inverse: Floats) -> Floats:
        """The middle of the sandwich (P, P): see `motes.fitting.problem.Problem.spread`."""
        made, (channels, count) = self.made, self.targets.shape
        values, derivatives = self._coefficients(parameters, 1)
        index = self.layout.index
        own = inverse[index[:, :, None], index[:, None, :]]
        along = np.swapaxes(derivatives[0], 1, 2)
        leverages = derivatives[0] @ own @ along  # (C, F + M, F + M)

        def part(rows: slice) -> Floats:
            both, of_clamp = self._both(parameters, rows, values)
            whole = np.concatenate([self.weighted[:, rows], both[0, : made.mixed]])
            found = np.empty((channels, len(whole), len(whole)))
            for c in range(channels):
                functions = whole
                if made.clamped and of_clamp[0, c].min() < 0:
                    functions = whole.copy()
                    functions[: made.clamped] *= of_clamp[0, c] >= 0
                leverage = np.einsum("kn,kn->n", leverages[c] @ functions, functions)
                scaled = functions * (both[0, made.mixed + c] / np.maximum(1 - leverage, LEAST_REMAINDER))
                found[c] = scaled @ scaled.T
            return found

        with np.errstate(all="ignore"):
            total = np.sum(in_passes(part, count, channels, CHUNK), axis=0)
            return np.asarray(self.layout.matrix((along @ total @ derivatives[0])[None])[0])
