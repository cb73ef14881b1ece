"""Small networks of algebraic sigmoids x / sqrt(1 + x^2), fitted by the method of Levenberg and Marquardt to what is linear in their outputs."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
CHUNK = 64  # layers of which the Jacobian is in memory


def _sigmoid(x: Floats) -> tuple[Floats, Floats]:
    """The value, and its derivative."""
    inverse = 1 / np.sqrt(1 + x * x)
    return x * inverse, inverse**3


@dataclass
class Network:
    """A network of inputs that are about 1.

    Parameters
    ----------
    mean, deviation
        Of the features.
    layers
        Weights (inputs, outputs) and offsets of each.
    """

    mean: Floats
    deviation: Floats
    layers: list[tuple[Floats, Floats]]

    @staticmethod
    def random(features: Floats, hidden: list[int], middle: Floats, spread: Floats, seed: int) -> Network:
        """One to start from, whose outputs are about as they are to be."""
        rng = np.random.default_rng(seed)
        sizes = [features.shape[1], *hidden, len(middle)]
        layers = [(rng.standard_normal((a, b)) / np.sqrt(a), 0.3 * rng.standard_normal(b)) for a, b in pairwise(sizes)]
        weights, offsets = layers[-1]
        layers[-1] = weights * spread, middle + 0 * offsets
        return Network(features.mean(axis=0), features.std(axis=0), layers)

    @staticmethod
    def read(numbers: dict[str, Any], basis: Floats) -> Network:
        """The network of a file, with outputs that `basis` takes from what the file has (outputs, outputs)."""
        layers = [(np.array(w), np.array(o)) for w, o in zip(numbers["weights"], numbers["offsets"], strict=True)]
        layers[-1] = layers[-1][0] @ basis, layers[-1][1] @ basis
        return Network(np.array(numbers["mean"]), np.array(numbers["deviation"]), layers)

    def numbers(self, basis: Floats) -> dict[str, Any]:
        """What a file has, with outputs that `basis` makes of those of the network."""
        short = np.vectorize(lambda x: float(f"{x:.7g}"))
        weights, offsets = self.layers[-1]
        layers = [*self.layers[:-1], (weights @ basis, offsets @ basis)]
        return {
            "mean": short(self.mean).tolist(),
            "deviation": short(self.deviation).tolist(),
            "weights": [short(weights).tolist() for weights, _ in layers],
            "offsets": [short(offsets).tolist() for _, offsets in layers],
        }

    def outputs(self, features: Floats) -> Floats:
        """Of each row of features."""
        return self._passed(features)[0]

    def fit(self, features: Floats, matrices: Floats, goals: Floats, steps: int, power: float) -> None:
        """Lower the sum over rows of |matrix @ outputs - goal|^(2 + power), by squares with weights that follow.

        Parameters
        ----------
        features, matrices, goals
            (n, inputs), (n, residuals, outputs) and (n, residuals).
        steps
            How many are taken at most.
        power
            Below 0 for what is typical, above 0 for what is worst.
        """

        def residuals() -> Floats:
            return np.einsum("nro,no->nr", matrices, self.outputs(features)) - goals

        damping, now = 1e-3, residuals()
        for step in range(steps):
            squares = (now**2).sum(axis=1)
            weights = (squares + 1e-12 + 1e-3 * squares.mean()) ** (power / 2)
            weights /= weights.mean()
            cost, held = float(weights @ squares), self.layers
            gradient, curvature = self._normal(features, np.sqrt(weights), matrices, now)
            diagonal = np.diag(curvature) + 1e-9 * np.trace(curvature) / len(gradient)
            for _ in range(8):
                self._move(held, np.linalg.solve(curvature + np.diag(damping * diagonal), -gradient))
                then = residuals()
                if float(weights @ (then**2).sum(axis=1)) < cost:
                    break
                damping *= 4
            else:
                self.layers = held
                return
            damping, now = max(damping / 5, 1e-9), then
            if step % 10 == 9:
                print(f"{step + 1} steps: {np.sqrt((now**2).sum(axis=1).mean()):.3g}", flush=True)

    def _passed(self, features: Floats) -> tuple[Floats, list[Floats], list[Floats]]:
        """The outputs; what goes into each layer; and the derivatives of the sigmoids before it, but for the first."""
        values = [(features - self.mean) / self.deviation]
        slopes = []
        for weights, offsets in self.layers[:-1]:
            value, slope = _sigmoid(values[-1] @ weights + offsets)
            values.append(value)
            slopes.append(slope)
        weights, offsets = self.layers[-1]
        return values[-1] @ weights + offsets, values, slopes

    def _normal(self, features: Floats, scale: Floats, matrices: Floats, residuals: Floats) -> tuple[Floats, Floats]:
        """The gradient and the curvature of half the weighted squares."""
        _, values, slopes = self._passed(features)
        size = sum(weights.size + offsets.size for weights, offsets in self.layers)
        gradient, curvature = np.zeros(size), np.zeros((size, size))
        for at in range(0, len(features), CHUNK):
            rows = slice(at, at + CHUNK)
            back = matrices[rows] * scale[rows, None, None]
            count, columns = back.shape[0] * back.shape[1], []
            for k in reversed(range(len(self.layers))):
                columns.append(back.reshape(count, -1))
                columns.append((values[k][rows, None, :, None] * back[:, :, None, :]).reshape(count, -1))
                if k:
                    back = np.einsum("nro,ko->nrk", back, self.layers[k][0]) * slopes[k - 1][rows, None, :]
            jacobian = np.concatenate(columns[::-1], axis=1)
            gradient += jacobian.T @ (residuals[rows] * scale[rows, None]).ravel()
            half = jacobian.astype(np.float32)  # the curvature steers only
            curvature += half.T @ half
        return gradient, curvature

    def _move(self, layers: list[tuple[Floats, Floats]], step: Floats) -> None:
        at, moved = 0, []
        for weights, offsets in layers:
            own = step[at : at + weights.size].reshape(weights.shape)
            at += weights.size
            moved.append((weights + own, offsets + step[at : at + offsets.size]))
            at += offsets.size
        self.layers = moved
