"""Fits to parts of the data that end near a fit to all: the derivatives at one point stand for those nearby.

With them kept, a step asks for values of the model alone, which cost a fifth of values and derivatives.  What is minimised is the same;
only the steps are a little longer or shorter than they would be (the chord method, or simplified Newton iterations).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motes.fitting.losses import Floats
from motes.fitting.problem import Problem
from motes.fitting.solver import Normal


class Chord:
    """The normal equations of a problem with T data sets, with the derivatives at points of their own, `x` (T, P)."""

    def __init__(self, problem: Problem, x: Floats) -> None:
        self._problem = problem
        residual, jacobian = problem.linearised(x, slice(0, len(problem.wi)), np.arange(len(x)))
        self._transposed = np.swapaxes(jacobian, 2, 3)  # (T, C, K, N)
        weighted = jacobian * np.sqrt(problem.robust.slope((residual / problem.scale) ** 2))[..., None]
        self._matrix = problem.layout.matrix(np.swapaxes(weighted, 2, 3) @ weighted)

    def normal(self, x: Floats, sets: NDArray[np.intp]) -> Normal:
        """As `Problem.normal`, where the gradient and the matrix are about those at `x` (B, P)."""
        problem = self._problem
        residual = problem.misfits(x, sets)
        z = (residual / problem.scale) ** 2
        objective = 0.5 * problem.scale**2 * problem.robust.rho(z).sum(axis=(1, 2))
        push = (residual * problem.robust.slope(z))[..., None]
        gradient = problem.layout.vector((self._transposed[sets] @ push)[..., 0])
        return Normal(objective, gradient, self._matrix[sets])
