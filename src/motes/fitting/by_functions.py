"""A fit's sums over samples by the few functions that a model separates into (`motes.kernels.separated`), instead of by its derivatives.

With f = sum of q_k b_k, the derivatives of a residual are sums of the same b_k: gradient and matrix are made of the products of these with each other and with
the residuals.  Three channels share them all, and functions without parameters meet each other once.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from motes.fitting.channel_layout import ChannelLayout
from motes.fitting.covariance import LEAST_REMAINDER
from motes.fitting.data_passes import in_passes
from motes.fitting.losses import Floats
from motes.fitting.solver import Normal
from motes.kernels.separated import Separated

# Elements of a pass that are worked on at a time: few enough that all of them stay in cache.
CHUNK = 1 << 16


class _Sums(NamedTuple):
    """Over samples, for B vectors: products of the K functions and the residuals of C channels with these residuals and with the M functions that hold
    parameters (B, K + C, M + C); and what the products of functions that are clamped with all functions and with a residual have where the clamp acts
    (B, C, F', K + 1), if anywhere."""

    moving: Floats
    clamped: Floats | float

    def with_(self, other: _Sums) -> _Sums:
        return _Sums(self.moving + other.moving, self.clamped + other.clamped)


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
        """Products of the functions without parameters (F, F)."""
        return np.asarray(self.weighted @ self.weighted.T)

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

    def _rows(self, parameters: dict[str, Any], rows: slice, values: Floats) -> tuple[Floats, Floats | None]:
        """All functions and residuals (B, K + C, n), and what is clamped (B, C, n) where any of it is below 0."""
        made, weights = self.made, self.weights[rows]
        batch, channels, functions = values.shape
        whole = np.empty((batch, functions + channels, len(weights)))
        fixed = self.weighted[:, rows]
        whole[:, : made.fixed] = fixed
        for k, b in enumerate(made.functions(tuple(column[rows] for column in self.columns), parameters), made.fixed):
            np.multiply(b, weights, out=whole[:, k])
        residual = np.subtract(values @ whole[:, :functions], self.targets[:, rows], out=whole[:, functions:])
        if made.clamped:
            of_clamp = values[:, :, : made.clamped] @ fixed[: made.clamped]
            if np.minimum.reduce(of_clamp, axis=None) < 0:
                residual -= np.minimum(of_clamp, 0.0)
                return whole, of_clamp
        return whole, None

    def normal(self, parameters: dict[str, Any], batch: int) -> Normal:
        """Objectives and normal equations; `parameters` (B, C) or (B, 1)."""
        channels, count = self.targets.shape
        values, derivatives = self._coefficients(parameters, batch)

        def part(rows: slice) -> _Sums:
            whole, of_clamp = self._rows(parameters, rows, values)
            clamped = 0.0 if of_clamp is None else self._where_clamped(whole, of_clamp)
            moving = whole[:, self.made.fixed :]
            if (
                not self.made.fixed
            ):  # an array times itself goes another way in NumPy, which takes three times as long for so few rows
                moving = moving.copy()
            return _Sums(whole @ np.swapaxes(moving, 1, 2), clamped)

        with np.errstate(all="ignore"):
            parts = in_passes(part, count, batch * channels, CHUNK)
            sums = parts[0]
            for more in parts[1:]:
                sums = sums.with_(more)
            return self._assembled(sums, derivatives)

    def _where_clamped(self, whole: Floats, of_clamp: Floats) -> Floats:
        (batch, channels, _), clamped = of_clamp.shape, self.made.clamped
        functions = whole.shape[1] - channels
        found = np.zeros((batch, channels, clamped, functions + 1))
        acts = of_clamp < 0
        lanes, own = np.nonzero(acts.any(axis=2))
        there = acts[lanes, own][:, None] * whole[0, :clamped]  # (L, F', n)
        found[lanes, own, :, :-1] = there @ np.swapaxes(whole[lanes, :functions], 1, 2)
        found[lanes, own, :, -1] = (there @ whole[lanes, functions + own, :, None])[..., 0]
        return found

    def _assembled(self, sums: _Sums, derivatives: Floats) -> Normal:
        _, channels, functions, _ = derivatives.shape
        moving, f, held = sums.moving, self.made.fixed, functions - self.made.fixed
        products = np.empty(
            (len(moving), 1, functions, functions + channels)
        )  # of functions with functions and residuals
        products[:, 0, :f, :f] = self.gram
        products[:, 0, f:, :f] = np.swapaxes(moving[:, :f, :held], 1, 2)
        products[:, 0, :, f:] = moving[:, :functions]
        own, at = np.arange(channels), np.arange(functions, functions + channels)
        if not isinstance(sums.clamped, float):
            gone, c = np.asarray(sums.clamped), self.made.clamped
            products = np.repeat(products, channels, axis=1)
            products[..., :c, :functions] -= gone[..., :-1]
            products[..., c:, :c] -= np.swapaxes(gone[..., c:-1], 2, 3)
            products[:, own, :c, at] -= np.moveaxis(gone[..., -1], 1, 0)
        along = np.swapaxes(derivatives, 2, 3) @ products  # (B, C, P', K + C)
        matrix = along[..., :functions] @ derivatives
        gradient = along[..., functions] if channels == 1 else np.moveaxis(along[:, own, :, at], 0, 1)
        objective = 0.5 * np.add.reduce(moving[:, functions:, held:].diagonal(0, 1, 2), axis=1)
        return Normal(objective, self.layout.vector(gradient), self.layout.matrix(matrix))

    def predicted(self, parameters: dict[str, Any]) -> Floats:
        """The BRDF (C, N)."""
        made, (channels, count) = self.made, self.targets.shape
        values = self._coefficients(parameters, 1)[0][0]

        whole = np.empty((channels, count))

        def part(rows: slice) -> None:
            f: Floats = values[:, : made.clamped] @ self.fixed[: made.clamped, rows]
            if made.clamped:
                np.maximum(f, 0.0, out=f)
            if made.clamped < made.fixed:
                f += values[:, made.clamped : made.fixed] @ self.fixed[made.clamped :, rows]
            for k, b in enumerate(made.functions(tuple(column[rows] for column in self.columns), parameters)):
                q = values[:, made.fixed + k, None]
                if q.any():
                    f += q * b
            whole[:, rows] = f

        with np.errstate(all="ignore"):
            in_passes(part, count, channels, CHUNK)
        return whole

    def spread(self, parameters: dict[str, Any], inverse: Floats) -> Floats:
        """The middle of the sandwich (P, P): see `motes.fitting.problem.Problem.spread`."""
        made, (channels, count) = self.made, self.targets.shape
        values, derivatives = self._coefficients(parameters, 1)
        index = self.layout.index
        own = inverse[index[:, :, None], index[:, None, :]]
        along = np.swapaxes(derivatives[0], 1, 2)
        leverages = derivatives[0] @ own @ along  # (C, F + M, F + M)

        def part(rows: slice) -> Floats:
            (whole,), of_clamp = self._rows(parameters, rows, values)
            among = len(whole) - channels
            found = np.empty((channels, among, among))
            for c in range(channels):
                functions = whole[:among]
                if of_clamp is not None:
                    functions = functions.copy()
                    functions[: made.clamped] *= of_clamp[0, c] >= 0
                along = leverages[c] @ functions
                along *= functions
                misses = whole[among + c] / np.maximum(1 - np.add.reduce(along, axis=0), LEAST_REMAINDER)
                found[c] = (functions * np.square(misses)) @ functions.T
            return found

        with np.errstate(all="ignore"):
            total = np.sum(in_passes(part, count, channels, CHUNK), axis=0)
            return np.asarray(self.layout.matrix((along @ total @ derivatives[0])[None])[0])
